"""Storeys: what the rules of a step may ask of a world of upright bodies of one height.

All ground is level, at multiples of the bodies' height. A body stands on a storey, from its left border over its
width, and has one support: the ground of its storey, or the top of a body one storey below.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Generic, Protocol

from spec.graph import Direction
from spec.number import N, Truth, zero_like


@dataclass(frozen=True)
class Drive(Generic[N]):
    """How a body moves of its own for the length of a step: a signed speed, positive to the right.

    It is meant in the plane (a character that walks), or relative to the body's support (everything else).
    """

    speed: N
    relative: bool = True


@dataclass(frozen=True)
class Contact:
    """Two neighbours of which the left one has come as near to the right one as the margin allows, or the reverse."""

    left: int
    right: int

    @property
    def body(self) -> int:
        """The left one."""
        return self.left


@dataclass(frozen=True)
class AtWall:
    """A body that has come to a wall of a storey in a direction."""

    body: int
    storey: int
    direction: Direction


@dataclass(frozen=True)
class Seat:
    """A body on a storey, and the support that it has there; None is the ground."""

    body: int
    storey: int
    support: int | None


Mark = Contact | AtWall | Seat
"""What is recorded when its event comes; a seat when it is lost."""


@dataclass(frozen=True)
class Interval(Generic[N]):
    """What lies between two places; on a ring the right one may be beyond once round."""

    left: N
    right: N


class Storeys(Protocol[N]):
    """A world of storeys. Bodies are named by their handles, places in the level's list.

    Laws: advancing a body by `x` to the right lessens its gap and its way to a wall on that side by `x`; what it has to
    go until it loses a support lessens by what it moves relative to that support; nothing else changes.
    """

    @property
    def margin(self) -> N:
        """The collision margin, greater than 0 (6.2.1, R24)."""

    def storeys(self) -> Sequence[int]:
        """The storeys on which bodies stand, the lowest first."""

    def row(self, storey: int, /) -> Sequence[int]:
        """The bodies on a storey from left to right; on a ring, once round."""

    def storey(self, body: int, /) -> int:
        """The storey of a body; 0 is the lowest."""

    def support(self, body: int, /) -> int | None:
        """The body on whose top a body stands, or None on the ground."""

    def pushes(self, body: int, /) -> bool:
        """Whether the body may push others (1.1, A39)."""

    def neighbours(self) -> Iterable[tuple[int, int]]:
        """Each body with the next one on its right, if they are two, on one storey, and no wall is between them."""

    def gap(self, left: int, right: int, /) -> N:
        """Distance from the right border of a body to the left border of its right neighbour."""

    def to_wall(self, body: int, direction: Direction, /) -> N | None:
        """Distance from a body's border to the nearest wall on that side, or None if there is none."""

    def to_loss(self, body: int, direction: Direction, /) -> N | None:
        """How far a body can move relative to its support until that no longer holds it, or None: for ever."""

    def holds(self, body: int, /) -> Truth:
        """Whether a body's support holds it (`reading/holds`)."""

    def grounded(self, body: int, /) -> Truth:
        """Whether a body is over the ground of its storey."""

    def tops(self, body: int, /) -> Sequence[int]:
        """The bodies one storey below whose tops would hold a body, from left to right; one that would hold it on both
        its sides, round a ring, is there twice.
        """

    def overlap(self, body: int, below: int, /) -> N:
        """How much of a body is over another; less than 0 beside it."""

    def advance(self, body: int, distance: N, /) -> None:
        """Move a body by a signed distance."""

    def stand(self, body: int, support: int | None, /) -> None:
        """Give a body another support on its storey."""

    def drop(self, body: int, /) -> None:
        """Let a body down by a storey; its support there is yet to be found."""


class Survey(Storeys[N], Protocol[N]):
    """What invariants may ask besides: where all that is solid is, in coordinates."""

    @property
    def circumference(self) -> N | None:
        """Once round a ring, or None on a line."""

    @property
    def ends(self) -> Interval[N] | None:
        """What lies between the walls at both ends of a line, or None on a ring."""

    def solid(self, storey: int, /) -> Sequence[Interval[N]]:
        """The terrain of a storey."""

    def span(self, body: int, /) -> Interval[N]:
        """Where a body is, from border to border; on a ring its left border is counted once round."""


def seat_of(world: Storeys[N], body: int) -> Seat:
    """Where a body stands."""
    return Seat(body, world.storey(body), world.support(body))


def once_round(place: N, circumference: N) -> N:
    """The same place on a ring, from 0 to less than once round; in few steps, however far it is."""
    if place < zero_like(place):
        back = rest_of(place * -1, circumference)
        return circumference - back if back > zero_like(back) else back
    return rest_of(place, circumference)


def rest_of(place: N, circumference: N) -> N:
    """What is left of a number when as many whole rounds as it has are taken away."""
    while place >= circumference:
        rounds = circumference
        while rounds * 2 <= place:
            rounds = rounds * 2
        place = place - rounds
    return place


def short_way(distance: N, circumference: N | None) -> N:
    """A distance; on a ring the short way round."""
    if circumference is None:
        return distance
    distance = once_round(distance, circumference)
    return distance - circumference if distance * 2 > circumference else distance
