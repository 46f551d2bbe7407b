"""What roundings do to a step in which all bodies move at once: between one instant and the next, in any world.

The rules and the world of storeys run as they are on numbers of which every sum is rounded
(`properties/engine/rounded.py`); velocities are known, so that a time times a velocity is a sum. What is known of the
state before is exact. A rounding is the unit of all numbers.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any

from properties.conformance.spread import OF_A_MEETING, OF_A_ROOM, OF_A_STRETCH, who_meets
from properties.contracts.request import Seen
from properties.contracts.rounding import LITTLE
from properties.contracts.stretches import nearings
from properties.engine.rounded import Machine, Rounded, held
from properties.given import Given
from properties.worlds.storeys import Setting, any_world
from reference.storeys import StoreyWorld, Terrain
from spec.invariants import equal
from spec.number import greater
from spec.profiles import SteppedProfile
from spec.rules.step import go_on
from spec.storeys import AtWall, Contact, Interval, Seat

FAMILIES: Mapping[type, str] = {Contact: "contact", AtWall: "wall", Seat: "loss"}
Speeds = Mapping[int, Fraction]


def held_by(machine: Machine, world: StoreyWorld[Any]) -> StoreyWorld[Any]:
    """A world as a machine holds it; the order of its bodies is known."""

    def number(value: Any) -> Rounded:
        return Rounded(machine, value)

    def interval(one: Interval[Any]) -> Interval[Any]:
        return Interval(number(one.left), number(one.right))

    ground, other = world.terrain, world.copy()
    solid = tuple(tuple(interval(one) for one in storey) for storey in ground.solid)
    other.terrain = Terrain(solid, None if ground.ends is None else interval(ground.ends), None)
    other.margin = number(world.margin)
    other.places = [replace(one, left=number(one.left), width=number(one.width)) for one in world.places]
    return other


def events_are_nearly_exact(
    profile: SteppedProfile, given: Given, setting: Setting, speeds: Speeds, meeting: int = OF_A_MEETING
) -> None:
    """What comes nearer is there in the time that its rule says, but for some roundings, and everybody has gone on as
    far as it goes in that time.
    """
    exact = any_world(given, setting)
    stands_well(given, exact)
    machine, rooms = Machine(given), {one.mark: one.room for one in nearings(exact, speeds)}
    for one in nearings(held_by(machine, exact), speeds):
        given.assume(one.mark in rooms, "it comes nearer in exact numbers too")
        room, name = rooms[one.mark], type(one.mark).__name__
        room = greater(room, room * 0)
        family = Seen(getattr(profile.rules, FAMILIES[type(one.mark)]), given)
        time = family.choose(one).effect(one)
        given.ensure(f"{name}: the room makes the time", equal(held(time) * one.speed, room, OF_A_ROOM))
        gone = gone_in(machine, exact, speeds, time)
        for body, speed in speeds.items():
            given.ensure(f"{name}: {body} goes on", equal(gone[body], held(time) * speed, OF_A_STRETCH))
        first, second = who_meets(one.mark)
        used = gone[first] - (0 if second is None else gone[second])
        away = speeds[first] < (0 if second is None else speeds[second])
        given.ensure(f"{name}: the room is used up", equal(used * (-1 if away else 1), room, meeting))


def stands_well(given: Given, world: StoreyWorld[Any]) -> None:
    """Assume that whoever is over ground is so by more than what is rounded."""
    for place in world.places:
        for ground in world.terrain.ground(place.storey) if place.storey else ():
            over = (ground.left + LITTLE <= place.right) & (place.left + LITTLE <= ground.right)
            given.assume(over, "a body is over its ground by more than roundings")


def gone_in(machine: Machine, exact: StoreyWorld[Any], speeds: Speeds, time: Any) -> dict[int, Any]:
    """How far each body has gone in a time."""
    world = held_by(machine, exact)
    go_on(world, speeds, time, set())
    return {body: held(world.places[body].left) - exact.places[body].left for body in speeds}
