"""Designs of a graphbody: which of its positions are stored, and which one leads a motion (4.3; E9, A46).

A design moves bodies by the rules of a request, along the segments that its leading position goes. What that costs, in
collided moves M_C, uncollided moves M and look-ups L, is counted by who holds the bodies.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Mapping
from dataclasses import dataclass
from enum import IntEnum
from typing import Any, Protocol, TypeVar

from spec.graph import Direction
from spec.number import N
from spec.rules.request import Ask, Rules
from spec.rules.walk import Motion
from spec.world import B, P


class Part(IntEnum):
    """A position of a body."""

    LEFT = -1
    CENTRE = 0
    RIGHT = 1


BORDERS = (Part.LEFT, Part.RIGHT)


def the_front(direction: Direction) -> Part:
    """The border on the side of the motion."""
    return Part(direction)


def the_centre(direction: Direction) -> Part:
    """The centre, wherever the motion goes."""
    return Part.CENTRE


@dataclass(frozen=True)
class Design:
    """A design: the positions that it stores of each body, and the one that moves collided; the others follow.

    A body that is led by its centre collides as though all others, and all walls, were wider by half its own width. It
    leaves a ledge when its centre is beyond it; one that is led by its borders, when both are.
    """

    id: str
    sentence: str
    source: str
    stored: tuple[Part, ...]
    leader: Callable[[Direction], Part]

    kind = "design"

    @property
    def name(self) -> str:
        """Its name, as in 2ep."""
        return self.id.removeprefix("design/")

    def followers(self, direction: Direction) -> tuple[Part, ...]:
        """The positions that follow the leader."""
        return tuple(part for part in self.stored if part is not self.leader(direction))

    def stands_on(self, direction: Direction) -> tuple[Part, ...]:
        """The positions that are all beyond a ledge when a body has left it."""
        return (Part.CENTRE,) if self.leader(direction) is Part.CENTRE else BORDERS


ONE = Design(
    "design/1ep",
    "A body is its centre, an edge position, and its width; its borders are half its width away.",
    "4.3.1; R8, E9",
    (Part.CENTRE,),
    the_centre,
)
ONE_CACHED = Design(
    "design/1ep-cached",
    "A body is its centre and its width; where its borders are is stored whenever it has moved.",
    "4.3.2; E9",
    (Part.CENTRE, *BORDERS),
    the_centre,
)
TWO = Design(
    "design/2ep",
    "A body is its two borders, which are edge positions: the one in front moves first, the other follows.",
    "4.3.1; R8, E9",
    BORDERS,
    the_front,
)
THREE = Design(
    "design/3ep",
    "A body is its two borders and its centre: the border in front moves first, the others follow.",
    "4.3.1; E9, A46, O12",
    (*BORDERS, Part.CENTRE),
    the_front,
)
DESIGNS: tuple[Design, ...] = (ONE, ONE_CACHED, TWO, THREE)


B_contra = TypeVar("B_contra", contravariant=True)


class Held(Protocol[N, B_contra, P]):
    """A world whose bodies a design holds, seen in the direction of a motion."""

    @property
    def direction(self) -> Direction:
        """Where the motion goes."""

    def at(self, body: B_contra, part: Part, /) -> P:
        """A position that is stored (a look-up, L)."""

    def leading(self, body: B_contra, /) -> Any:
        """As much of a `View` as a segment needs, as the leader of a body sees it in a collided move (M_C)."""

    def freely(self, at: P, distance: N, towards: Direction, /) -> P:
        """Where an uncollided move from a position ends (M)."""

    def half(self, body: B_contra, /) -> N:
        """Half the width of a body."""

    def put(self, body: B_contra, places: Mapping[Part, P], /) -> None:
        """Store the positions to which the motion has taken a body."""


def request(
    design: Design, rules: Rules, held: Held[N, B, P], body: B, distance: N, spare: int
) -> Generator[Ask[N, B], N, N]:
    """Move `body` by up to `distance >= 0`: its leader collided, what follows uncollided by as much (4.3.2)."""
    leader = design.leader(held.direction)
    view, motion = held.leading(body), Motion(held.at(body, leader), rest=distance)
    while motion.going:
        motion = yield from rules.segment(rules, view, body, motion, spare)
    moved = distance - motion.rest
    starts = {part: held.at(body, part) for part in design.followers(held.direction)}
    followed = {part: held.freely(start, moved, held.direction) for part, start in starts.items()}
    held.put(body, {leader: motion.at, **followed})
    return moved


def border(design: Design, held: Held[N, B, P], body: B, side: Part) -> P:
    """Where a border of a body is: looked up if it is stored, else half a width away from the centre (4.3.2)."""
    if side in design.stored:
        return held.at(body, side)
    return held.freely(held.at(body, Part.CENTRE), held.half(body), Direction(side))
