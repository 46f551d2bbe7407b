"""Small worlds of storeys: who stands where, and what drives it, is given; all sizes and places are arbitrary.

Drives are known numbers, so that times and places stay sums of what is arbitrary.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from typing import Any

from properties.given import HAS_LENGTH, HAS_WIDTH, Given
from reference.storeys import Place, StoreyWorld, Terrain
from spec.conditions import STOREYS_START
from spec.storeys import Drive, Interval


@dataclass(frozen=True)
class Member:
    """A body of a setting: its storey, the body that it stands on or None, its drive, whether it may push."""

    storey: int
    drive: Drive[Fraction]
    support: int | None = None
    pushes: bool = True


@dataclass(frozen=True)
class Setting:
    """The shape of a world and of a step.

    Attributes:
        members: the bodies; those of a storey are named from left to right.
        solids: for each storey, into how many pieces its terrain falls.
    """

    name: str
    members: tuple[Member, ...]
    solids: tuple[int, ...] = ()
    ring: bool = False

    @property
    def drives(self) -> dict[int, Drive[Fraction]]:
        """What drives each body."""
        return {body: member.drive for body, member in enumerate(self.members)}


def any_terrain(given: Given, setting: Setting, length: Any) -> Terrain[Any]:
    """Any terrain of so many pieces; at the start of a line there may be some at once."""
    storeys = []
    for storey, pieces in enumerate(setting.solids):
        found, along = [], length * 0
        for piece in range(pieces):
            left = along + given.number(f"room before piece {piece} of storey {storey}")
            size = given.number(f"length of piece {piece} of storey {storey}")
            given.assume(size > 0, HAS_LENGTH)
            if piece:
                given.assume(left > along, "pieces of terrain are apart")
            along = left + size
            found.append(Interval(left, along))
        given.assume(along <= length, "terrain is in the level")
        storeys.append(tuple(found))
    return Terrain(
        tuple(storeys), None if setting.ring else Interval(length * 0, length), length if setting.ring else None
    )


def any_world(given: Given, setting: Setting) -> StoreyWorld[Any]:
    """Any valid world of a setting."""
    world: Any = any_places(given, setting)
    given.assume(STOREYS_START.holds(world, world.margin), STOREYS_START.id)
    return world  # type: ignore[no-any-return]


def any_places(given: Given, setting: Setting) -> StoreyWorld[Any]:
    """Any world of a setting, also one in which bodies are in terrain or in each other, and nothing holds them."""
    margin, length = given.number("margin"), given.number("length")
    given.assume(margin > 0, "the margin is positive")
    terrain, places = any_terrain(given, setting, length), []
    for body, member in enumerate(setting.members):
        left, width = given.number(f"left of {body}"), given.number(f"width of {body}")
        given.assume(width > margin, HAS_WIDTH)
        if setting.ring:
            given.assume((left < length) & (width + margin <= length), "places on a ring are counted once round")
        places.append(Place(member.storey, left, width, member.support, member.pushes))
    for storey in {member.storey for member in setting.members}:
        for one, other in pairwise(place for place in places if place.storey == storey):
            given.assume(one.left < other.left, "bodies are named from left to right")
    return StoreyWorld(terrain, margin, places)


def any_duration(given: Given, setting: Setting, world: StoreyWorld[Any]) -> Any:
    """Any length of a step; on a ring nobody goes round more than once."""
    duration = given.number("duration")
    if world.circumference is not None:
        fastest = sum(abs(drive.speed) for drive in setting.drives.values())
        given.assume(duration * fastest <= world.circumference, "nobody goes round more than once")
    return duration
