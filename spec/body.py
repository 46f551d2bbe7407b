"""Bodies: two edge positions each, their left and their right border (4.3.1, 2EP); and levels of them."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Generic

from spec.graph import Direction, Graph
from spec.number import N
from spec.rules.velocity import Motion


@dataclass(frozen=True)
class EdgePosition(Generic[N]):
    """An edge (its index) and a location on it, measured from the edge's left vertex (4.3.1; R7).

    At a vertex that two edges share, a border has two names and keeps that of the edge it came along (A57).
    """

    edge: int
    location: N


@dataclass(frozen=True)
class Body(Generic[N]):
    """A graphbody: a character if its speed is not 0, else a box.

    Speed is distance per second. A body of which `pushes` is False pushes nobody (1.1, A39). A body with a `motion`
    moves of its own in each tick: static, with the velocity that is set, or dynamic (6.3.1; R26).
    """

    name: str
    left: EdgePosition[N]
    right: EdgePosition[N]
    speed: N
    height: N
    pushes: bool = True
    motion: Motion[N] | None = None

    def border(self, direction: Direction) -> EdgePosition[N]:
        """The border on one side."""
        return self.right if direction is Direction.RIGHT else self.left


@dataclass(frozen=True)
class Level(Generic[N]):
    """A graph, the collision margin, the length of a tick in seconds, bodies in the level's order, and buttons.

    The static edges are numbered as in the graph; the top of body N is the edge after them with number N (R9, R11).
    The goal of a level is that a character stands on each button (1.1).
    """

    graph: Graph[N]
    margin: N
    tick: N
    bodies: tuple[Body[N], ...]
    buttons: tuple[EdgePosition[N], ...] = ()

    @cached_property
    def handles(self) -> dict[str, int]:
        """The places of bodies in the level's order, by their names."""
        return {body.name: handle for handle, body in enumerate(self.bodies)}

    @cached_property
    def movers(self) -> tuple[Body[N], ...]:
        """The characters, and the bodies with a velocity of their own."""
        return tuple(body for body in self.bodies if body.speed or body.motion is not None)
