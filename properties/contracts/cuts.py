"""What is shown of a step that is cut in two at any time up to its next instant, whatever else is in the world.

The time up to the cut is the unit of time, so that a velocity is the way that a body goes in it. The second step begins
as the first would have gone on: the same is recorded, the same comes, earlier by that time, and all are as fast
(`properties/contracts/parting.py`).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from itertools import product
from typing import Any

from properties.contracts.images import ensure_nearing_alike
from properties.contracts.stretches import (
    CLOSED,
    FIRST,
    KNOWN_SPEEDS,
    UNIT,
    any_way,
    at_most_round,
    nearings,
    shuts,
    ways_round,
)
from properties.evidence.comparisons import alike
from properties.given import Given
from properties.worlds.storeys import Setting, any_world
from reference.storeys import StoreyWorld
from spec.graph import Direction
from spec.invariants import every
from spec.number import greater
from spec.rules.event import Nearing
from spec.rules.settle import settle
from spec.rules.step import Event, StepRules, go_on, lasting, next_instant, touching, unheld
from spec.storeys import AtWall, Contact, Mark, Seat

Ways = Mapping[int, Any]
BEFORE = "nothing comes before the cut"


def any_ways(given: Given, setting: Setting, world: StoreyWorld[Any]) -> Ways:
    """Any ways of all up to a time at which nothing has come yet, when what touches is recorded."""
    ways = ways_round(given, world, setting.drives)
    given.assume(every(shuts(mark, ways) for mark in touching(world)), CLOSED)
    for one in nearings(world, ways):
        given.assume(one.speed <= greater(one.room, one.room * 0), FIRST)
    return ways


def what_comes_is_nearer(rules: StepRules, given: Given, setting: Setting) -> None:
    """At the cut the same comes nearer as before, but for what has come: as fast, and its room is less by the way. If
    what touches was recorded, and nothing else, so it is there.
    """
    world = any_world(given, setting)
    ways, marks = any_ways(given, setting, world), touching(world)
    before = list(nearings(world, ways))
    come = {one.mark for one in before if one.speed >= one.room}
    left = go_on(world, ways, UNIT, marks) | {mark for mark in come if not isinstance(mark, Seat)}
    given.ensure("what is recorded is what touches", left == touching(world))
    to_come = [replace(one, room=one.room - one.speed) for one in before if one.mark not in come]
    ensure_nearing_alike(given, to_come, (one for one in nearings(world, ways) if one.mark not in come))


def who_is_held_has_room(rules: StepRules, given: Given, setting: Setting) -> None:
    """Nobody that is held loses its support at once; and at the beginning of a step nobody that is held settles."""
    world = any_world(given, setting)
    for body, direction in product(setting.drives, Direction):
        room = world.to_loss(body, direction)
        given.ensure("it does not lose it at once", True if room is None else room > 0)
    still = dict.fromkeys(setting.drives, UNIT * 0)
    given.ensure("nobody settles", not list(settle(rules.settle, world, still, unheld(world))))


def two_ways_are_one(rules: StepRules, given: Given, setting: Setting) -> None:
    """Any way, and then another one in the same direction, lead where both do at once."""
    world = any_world(given, setting)
    direction = Direction.LEFT if given.flag("to the left") else Direction.RIGHT
    way, more = given.number("way"), given.number("way from there")
    both, other = at_most_round(given, world, way + more), world.copy()
    for held, by in ((world, way), (world, more), (other, both)):
        go_on(held, {0: by * direction}, UNIT, set())
    given.ensure("it is at the same place", alike(world, other))


def records_last(rules: StepRules, given: Given) -> None:
    """What is left of what is recorded after a while is left of it after another one with the same velocities, or if
    all stand still.
    """
    ways = {body: any_way(given, body) for body in (0, 1)}
    left = lasting(ways, {Contact(0, 1), *(AtWall(0, 0, direction) for direction in Direction)})
    for held in (ways, dict.fromkeys(ways, UNIT * 0)):
        given.ensure("the same is left", [lasting(held, left)] == [left])


def time_goes_by(rules: StepRules, given: Given) -> None:
    """What comes nearer comes, after a time in which it has not come, in what is left of the time."""
    passed, left = given.number("time passed"), given.number("room left")
    nearing: dict[str, Mark] = {
        "contact": Contact(0, 1),
        "wall": AtWall(0, 0, Direction.RIGHT),
        "loss": Seat(0, 0, None),
    }
    for (name, mark), speed in product(nearing.items(), KNOWN_SPEEDS):
        facts = Nearing(mark, left + passed * speed, speed)
        before, after = (getattr(rules, name).choose(one).effect(one) for one in (facts, replace(facts, room=left)))
        given.ensure(f"{name}: it comes in what is left of the time", after == before - passed)


def instants_are_the_same(rules: StepRules, given: Given) -> None:
    """The next instant of a step that is cut before it is that of the second of both; at a cut nothing else comes."""
    left, cut = given.number("time left"), given.number("time up to the cut")
    coming = [Event("", Seat(body, 0, None), given.number(f"time until {body} comes")) for body in range(3)]
    some = [event for event in coming if given.flag(f"{event.mark.body} comes")]
    whole = next_instant(some, left)
    given.assume(cut <= whole.after, BEFORE)
    first = next_instant(some, cut)
    given.ensure("the first step ends at the cut", first.after == cut)
    given.ensure("it ends there", first.last)
    if cut >= whole.after:
        given.ensure("what comes at the cut comes there", marks(first.events) == marks(whole.events))
        return
    given.ensure("nothing comes before the cut", not first.events)
    second = next_instant([replace(event, after=event.after - cut) for event in some], left - cut)
    given.ensure("the next instant is the same", second.after == whole.after - cut)
    given.ensure("it is the last or not", second.last == whole.last)
    given.ensure("the same comes at it", marks(second.events) == marks(whole.events))


def marks(events: tuple[Event[Any], ...]) -> set[Mark]:
    """What comes."""
    return {event.mark for event in events}
