"""A window on a string of edges: one border in motion, its edge, the next edge, and the body ahead.

Everything else is summed up in a few numbers: how far away the wall is, if there is one, and how far the
neighbour could be moved (its capacity). So what is proved of a window is proved of any row.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from properties.given import HAS_LENGTH, Given
from spec.conditions import IN_ORDER
from spec.rules.request import Ask
from spec.world import Beyond, Jump

ME, NEIGHBOUR = "me", "neighbour"


@dataclass(frozen=True)
class Spot:
    """A border's position: how far it has come, its edge (0 or 1 from the start), and how far that reaches."""

    travelled: Any
    edge: int
    length: Any
    reach: Any


@dataclass
class Window:
    """The view of one motion (`spec.world.View`), with what the neighbour has granted so far."""

    margin: Any
    start: Spot
    next_length: Any | None
    neighbour: bool
    gap_before: Any
    granted: Any
    may_push: bool
    resting: Spot | None = None
    back: Spot | None = None
    ledge: bool = False
    body_width: Any = 0
    below: Spot | None = None
    jump_edges: tuple[Jump[Any, Spot], ...] = ()
    asks: list[Ask[Any, str]] = field(default_factory=list)
    placed: list[tuple[str, Spot, Spot]] = field(default_factory=list)

    def front(self, body: str) -> Spot:
        """Where the front border is at rest, if the window shows it: a border under way is elsewhere."""
        assert self.resting is not None
        return self.resting

    def rear(self, body: str) -> Spot:
        """Where the rear border is, if the window shows it."""
        assert self.back is not None
        return self.back

    def reach(self, at: Spot) -> Any:
        """Distance to the end of the edge."""
        return at.reach

    def along(self, at: Spot, distance: Any) -> Spot:
        """Further on, on the same edge."""
        return Spot(at.travelled + distance, at.edge, at.length, at.reach - distance)

    def end(self, at: Spot) -> Spot:
        """The end of the edge."""
        return self.along(at, at.reach)

    def beyond(self, at: Spot) -> Beyond[Spot]:
        """The beginning of the next edge, which is all of the string ahead that this window shows, or its end."""
        if self.next_length is None:
            return Beyond(None, self.ledge)
        return Beyond(Spot(at.travelled + at.reach, at.edge + 1, self.next_length, self.next_length), ledge=False)

    def ahead(self, body: str, front: Spot) -> str | None:
        """The neighbour, if it is on this edge or the next."""
        if not self.neighbour:
            return None
        in_sight = self.next_length is None or self.gap(front, NEIGHBOUR) <= front.reach + self.next_length
        return NEIGHBOUR if in_sight else None

    def gap(self, front: Spot, other: str) -> Any:
        """Distance to the neighbour, which has moved by what it granted."""
        return self.gap_before + self.granted - front.travelled

    def pushes(self, body: str) -> bool:
        """Whether the body may push."""
        return self.may_push

    def width(self, body: str) -> Any:
        """The body's width."""
        return self.body_width

    def foot(self, at: Spot) -> Spot | None:
        """Where the fall edge at the ledge leads; a window shows the one where it starts."""
        return self.below if at is self.start else None

    def jumps(self, body: str, at: Spot) -> Sequence[Jump[Any, Spot]]:
        """The jump edges at the ledge; a window shows those where it starts."""
        return self.jump_edges if at is self.start else ()

    def across(self, start: Spot, end: Spot) -> Any:
        """How far the rear border is beyond the end of a jump edge, or the ledge: fall edges are vertical."""
        beyond = self.reach(end) * -1
        return beyond - sum(jump.across for jump in self.jump_edges if jump.target is start)

    def place(self, body: str, front: Spot, rear: Spot) -> None:
        """Note where the borders were put."""
        self.placed.append((body, front, rear))


def spot(given: Given, name: str) -> Spot:
    """Any place on any edge."""
    reach, behind = (
        given.number(f"{name}: distance to the end of the edge"),
        given.number(f"{name}: distance behind it"),
    )
    return Spot(reach * 0, 0, reach + behind, reach)


def lonely_window(given: Given, ledges: bool) -> Window:
    """Any window with nobody ahead; see `window`."""
    margin, start = given.number("margin"), spot(given, "front")
    given.assume(start.length > 0, HAS_LENGTH)
    next_length, ledge = None, False
    if given.flag("an edge follows"):
        next_length = given.number("length of the next edge")
    elif ledges and given.flag("the edge ends at a ledge"):
        ledge = True
        if given.flag("the border is in overhang"):
            start = Spot(start.travelled, 0, start.length, start.reach * 0 - given.number("overhang"))
    return Window(margin, start, next_length, False, margin * 0, margin * 0, may_push=True, ledge=ledge)


def window(given: Given, ledges: bool = False) -> Window:
    """Any window with neighbours in order; what else a contract requires of it, is for an obligation to assume.

    `ledges`: the string may end at a ledge, and the border may be in overhang there.
    """
    seen = lonely_window(given, ledges)
    if not given.flag("a body is ahead"):
        return seen
    gap = given.number("gap", IN_ORDER.id)
    if seen.next_length is None and not seen.ledge:
        given.assume(gap <= seen.start.reach, "no body stands beyond the wall")
    return replace(seen, neighbour=True, gap_before=gap, may_push=given.flag("the body may push"))


@dataclass(frozen=True)
class Capacity:
    """How far anything could move at most: the neighbour, and up to the wall (None: there is no wall)."""

    neighbour: Any
    wall: Any | None


def capacity(given: Given, seen: Window) -> Capacity:
    """Any capacities that a window can have: a wall, if there is one, is where its string ends, or further ahead."""
    neighbour = given.number("capacity of the neighbour")
    if seen.next_length is None:
        wall: Any | None = seen.start.reach
    elif given.flag("there is a wall"):
        wall = given.number("distance to the wall")
        given.assume(seen.start.reach <= wall, "no wall stands on the edge")
    else:
        wall = None
    return Capacity(neighbour, wall)
