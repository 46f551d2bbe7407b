"""Changes of a world of storeys that ought to change nothing, or nothing below: its mirror image, bodies in another
order, bodies taken away, other numbers.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

from reference.storeys import Place, StoreyWorld, Terrain
from spec.storeys import Drive, Interval, once_round

Drives = dict[int, Drive[Any]]


def mirrored(world: StoreyWorld[Any]) -> StoreyWorld[Any]:
    """The world seen from behind."""
    old, ends, round_ = world.terrain, world.terrain.ends, world.terrain.circumference

    def turned(left: Any, size: Any) -> Any:
        away = (left + size) * -1
        return away if round_ is None else once_round(away, round_)

    def image(one: Interval[Any]) -> Interval[Any]:
        left = turned(one.left, one.right - one.left)
        return Interval(left, left + one.right - one.left)

    solid = tuple(tuple(sorted(map(image, storey), key=lambda one: one.left)) for storey in old.solid)
    places = [replace(place, left=turned(place.left, place.width)) for place in world.places]
    return StoreyWorld(Terrain(solid, None if ends is None else image(ends), round_), world.margin, places)


def backwards(drives: Drives) -> Drives:
    """The drives seen from behind."""
    return {body: replace(drive, speed=drive.speed * -1) for body, drive in drives.items()}


def chosen(world: StoreyWorld[Any], bodies: Sequence[int]) -> StoreyWorld[Any]:
    """The world with some of its bodies, in another order; with a body goes what it stands on."""
    names = {body: name for name, body in enumerate(bodies)}

    def renamed(place: Place[Any]) -> Place[Any]:
        return replace(place, support=None if place.support is None else names[place.support])

    return StoreyWorld(world.terrain, world.margin, [renamed(world.places[body]) for body in bodies])


def in_numbers(world: StoreyWorld[Any], number: Callable[[Any], Any]) -> StoreyWorld[Any]:
    """The world with each number made another."""

    def interval(one: Interval[Any]) -> Interval[Any]:
        return Interval(number(one.left), number(one.right))

    old, ends, round_ = world.terrain, world.terrain.ends, world.terrain.circumference
    solid = tuple(tuple(map(interval, storey)) for storey in old.solid)
    terrain = Terrain(solid, None if ends is None else interval(ends), None if round_ is None else number(round_))
    places = [replace(place, left=number(place.left), width=number(place.width)) for place in world.places]
    return StoreyWorld(terrain, number(world.margin), places)


def in_floats(world: StoreyWorld[Any]) -> StoreyWorld[float]:
    """The world in binary floating point."""
    return in_numbers(world, float)


def floating(drives: Drives) -> dict[int, Drive[float]]:
    """The drives in binary floating point."""
    return {body: Drive(float(drive.speed), drive.relative) for body, drive in drives.items()}
