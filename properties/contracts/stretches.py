"""What is shown of any step, whatever else is in the world: of two neighbours, of a body and terrain, of a body and its
support.

Between two instants velocities stay. The time between them is the unit of time, so that a velocity is the way that a
body goes. Ways are any, but for two things: nobody in contact comes nearer, or goes on at a wall
(`contacts_do_not_close`), and nothing comes before the end (`no_event_is_passed_over`).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from itertools import chain, groupby, product
from typing import Any, cast

from properties.given import Given
from properties.worlds.storeys import Setting, any_places, any_world
from reference.storeys import StoreyWorld
from spec.graph import Direction
from spec.invariants import every
from spec.number import greater
from spec.plane import negated
from spec.rules.event import Nearing
from spec.rules.settle import settle
from spec.rules.step import Event, StepRules, contacts, go_on, losses, next_instant, touching, walls
from spec.stepped import (
    STEP_MARGIN,
    STEP_MOTION,
    STEP_NOT_RAISED,
    STEP_ORDER,
    STEP_SEAT,
    STEP_SUPPORT,
    STEP_TERRAIN,
    Course,
    Stretch,
    images,
    is_held,
    margins_kept,
    meet,
    outside_terrain,
    some,
)
from spec.storeys import AtWall, Contact, Mark, Seat, seat_of

UNIT = Fraction(1)
FIRST = "nothing comes before the end of the stretch"
SOUND = "what is recorded is so"
CLOSED = "nobody in contact comes nearer, or goes on at a wall"
ONCE = "whole rounds change no place"
APART = "the margin is kept, and nobody is in terrain"
KNOWN_SPEEDS = (Fraction(1), Fraction(2), Fraction(2, 3))

Ways = Mapping[int, Any]


@dataclass(frozen=True)
class Passed:
    """A stretch that has passed, before anybody has settled: the world then, what was and what is recorded, and what
    came at its end.
    """

    before: StoreyWorld[Any]
    world: StoreyWorld[Any]
    ways: Ways
    recorded: set[Mark]
    marks: set[Mark]
    come: set[Mark]

    def stretch(self) -> Stretch[Any]:
        """It, as the invariants see it."""
        drives: Any = dict.fromkeys(self.ways)
        return Stretch(self.before, self.world, UNIT, self.ways, drives, UNIT * 0)


def any_way(given: Given, body: int) -> Any:
    """Any signed way of a body."""
    return given.number(f"way of {body} to the right") - given.number(f"way of {body} to the left")


def ways_round(given: Given, world: StoreyWorld[Any], bodies: Iterable[int]) -> dict[int, Any]:
    """Any ways of some bodies; on a ring nobody goes round more than once."""
    return {body: at_most_round(given, world, any_way(given, body)) for body in bodies}


def at_most_round(given: Given, world: StoreyWorld[Any], way: Any) -> Any:
    """A way that goes no more than once round a ring: else no proof would come to its end."""
    round_ = world.circumference
    if round_ is not None:
        given.assume((way <= round_) & (way * -1 <= round_), ONCE)
    return way


def any_marks(given: Given, world: StoreyWorld[Any]) -> set[Mark]:
    """Any of the contacts and walls that a world has, recorded."""
    marks = any_contacts(given, world)
    for body, direction in at_sides(world):
        room = world.to_wall(body, direction)
        if room is not None and given.flag(f"{body} is recorded to be at a wall on the {direction.name.lower()}"):
            given.assume(room == 0, SOUND)
            marks.add(AtWall(body, world.storey(body), direction))
    return marks


def any_contacts(given: Given, world: StoreyWorld[Any]) -> set[Mark]:
    """Any of the contacts that a world has, recorded."""
    marks: set[Mark] = set()
    for left, right in world.neighbours():
        if given.flag(f"the contact of {left} with {right} is recorded"):
            given.assume(world.gap(left, right) <= world.margin, SOUND)
            marks.add(Contact(left, right))
    return marks


def at_sides(world: StoreyWorld[Any]) -> Iterator[tuple[int, Direction]]:
    """Each body, on each side."""
    return ((body, direction) for body in range(len(world.places)) for direction in Direction)


def shuts(mark: Mark, ways: Ways) -> Any:
    """Whether nobody goes against what is recorded."""
    if isinstance(mark, Contact):
        return ways[mark.left] <= ways[mark.right]
    assert isinstance(mark, AtWall)
    return ways[mark.body] * mark.direction <= 0


def nearings(world: StoreyWorld[Any], ways: Ways) -> Iterator[Nearing[Any]]:
    """All that comes nearer."""
    return chain(contacts(world, ways), walls(world, ways), losses(world, ways))


def passed(given: Given, setting: Setting) -> Passed:
    """Any stretch in any world of a setting."""
    before = any_world(given, setting)
    ways = ways_round(given, before, setting.drives)
    recorded, come = any_marks(given, before), set()
    given.assume(every(shuts(mark, ways) for mark in recorded), CLOSED)
    for one in nearings(before, ways):
        given.assume(one.speed <= greater(one.room, one.room * 0), FIRST)
        if one.speed >= one.room:
            come.add(one.mark)
    world = before.copy()
    return Passed(before, world, ways, recorded, go_on(world, ways, UNIT, recorded), come)


def stretches_keep_apart(rules: StepRules, given: Given, setting: Setting) -> None:
    """Neighbours keep the margin and their order, nobody comes into or through terrain, and what is recorded is so;
    whoever has not lost its support just then is held by it.
    """
    after = passed(given, setting)
    course = Course((after.stretch(),))
    for invariant in (STEP_MARGIN, STEP_ORDER, STEP_TERRAIN, STEP_MOTION):
        given.ensure(invariant.id, every([invariant.holds(course)]))
    for mark in after.marks | after.come:
        given.ensure("what is recorded is so", every([is_so(after.world, mark)]))
    for body in after.ways:
        if seat_of(after.world, body) not in after.come:
            given.ensure("its support holds it", every([is_held(after.world, body, UNIT * 0)]))


def is_so(world: StoreyWorld[Any], mark: Mark) -> Any:
    """Whether a contact is one, a body at a wall is there, and a lost support holds no longer."""
    if isinstance(mark, Contact):
        return world.gap(mark.left, mark.right) == world.margin
    if isinstance(mark, AtWall):
        return world.to_wall(mark.body, mark.direction) == 0
    return negated(every([is_held(world, mark.body, UNIT * 0)]))


def any_lost(given: Given, world: StoreyWorld[Any], zero: Any) -> set[Seat]:
    """The seats of any of the bodies of a world, which hold no longer; those of all others do."""
    lost = set()
    for body in range(len(world.places)):
        holds = every([is_held(world, body, zero)])
        if given.flag(f"{body} has lost its support"):
            lost.add(seat_of(world, body))
            holds = negated(holds)
        given.assume(holds, SOUND)
    return lost


def settling_keeps_apart(rules: StepRules, given: Given, setting: Setting) -> None:
    """When some have lost their supports, all find one that holds them, the right one; nobody comes up, into terrain,
    or nearer to another than the margin.
    """
    before = any_places(given, setting)
    zero = before.margin * 0
    given.assume(every([margins_kept(before, zero), outside_terrain(before, zero)]), APART)
    lost = any_lost(given, before, zero)
    ways = {body: any_way(given, body) for body in setting.drives}
    world = before.copy()
    for body, changes in groupby(settle(rules.settle, world, ways, lost), lambda change: change.seat.body):
        storeys = [change.seat.storey for change in changes]
        fell = storeys[:-1] == [before.storey(body) - number for number in range(1, len(storeys))]
        given.ensure("it comes down, and then stands", fell)
    course = Course((Stretch(before, world, zero, ways, cast(Any, ways), zero),))
    for invariant in (STEP_MARGIN, STEP_TERRAIN, STEP_SUPPORT, STEP_SEAT, STEP_NOT_RAISED):
        given.ensure(invariant.id, every([invariant.holds(course)]))


def tops_are_in_order(rules: StepRules, given: Given, setting: Setting) -> None:
    """Of those below that would hold the first body, also on its other side round a ring, the first one and the last
    one that a world tells of are so.
    """
    world: Any = any_places(given, setting)
    zero = world.margin * 0
    given.assume(every([margins_kept(world, zero), outside_terrain(world, zero)]), APART)
    holding = [one for other in world.row(0) for one in held_at(world, 0, other)]
    tops = world.tops(0)
    given.ensure("it tells of some if there are some", bool(tops) == bool(holding))
    for top, way in zip([*tops[:1], *tops[-1:]], (1, -1), strict=False):
        mine = held_at(world, 0, top)
        given.ensure("nobody is further", every(some(x * way <= y * way for x in mine) for y in holding))


def held_at(world: StoreyWorld[Any], body: int, below: int) -> list[Any]:
    """Where the images of a body begin that hold another."""
    span, found = world.span(body), images(world, world.span(below))
    return [image.left for image in found if meet(span, image, world.margin)]


def what_touches_is_recorded(rules: StepRules, given: Given, setting: Setting) -> None:
    """What a step records at its beginning is so, and all that is so is recorded."""
    world = any_world(given, setting)
    found = touching(world)
    for mark in found:
        given.ensure("what is recorded is so", every([is_so(world, mark)]))
    for left, right in world.neighbours():
        if world.gap(left, right) <= world.margin:
            given.ensure("what is so is recorded", Contact(left, right) in found)
    for body, direction in at_sides(world):
        room = world.to_wall(body, direction)
        if room is not None and room <= 0:
            given.ensure("who is at a wall is recorded", AtWall(body, world.storey(body), direction) in found)


def no_event_is_passed_over(rules: StepRules, given: Given) -> None:
    """The next instant is the first of all that come, at the latest the end; what comes then is what comes at it."""
    left = given.number("time left")
    coming = [Event("", Seat(body, 0, None), given.number(f"time until {body} comes")) for body in range(3)]
    some = [event for event in coming if given.flag(f"{event.mark.body} comes")]
    instant = next_instant(some, left)
    given.ensure("it is not after the end", instant.after <= left)
    given.ensure("it is the end if it is the last", instant.after == left if instant.last else True)
    given.ensure("it is the last if nothing comes before", instant.last == every(left <= one.after for one in some))
    for event in some:
        given.ensure("nothing comes before", instant.after <= event.after)
        given.ensure("what comes then comes", (event in instant.events) == (event.after <= instant.after))


def room_is_used_up_in_time(rules: StepRules, given: Given) -> None:
    """What comes nearer is there when its speed, for the time that its rule says, has used up the room."""
    room = given.number("room") - given.number("what is lacking")
    nearing: dict[str, Mark] = {
        "contact": Contact(0, 1),
        "wall": AtWall(0, 0, Direction.RIGHT),
        "loss": Seat(0, 0, None),
    }
    for (name, mark), speed in product(nearing.items(), KNOWN_SPEEDS):
        facts = Nearing(mark, room, speed)
        time = getattr(rules, name).choose(facts).effect(facts)
        given.ensure(f"{name}: the way to it is the room", time * speed == greater(room, room * 0))
