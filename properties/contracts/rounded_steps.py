"""What roundings do to a step in which all bodies move at once: from one instant to the next one, in any world, at any
velocities, when everything is off already.

Two courses are compared, in which the same comes, in the same order: one in exact numbers, and that of a machine. An
instant comes late in the second one, or early; that counts as late by less than 0. So a body is *off* at an instant by
how far it is from where it is in the first one, but for the way that it goes in the time by which the instant is late.
The rules and the world of storeys run as they are, on numbers of which every sum is rounded, and on velocities and
times that are known by their ways (`properties/engine/rounded.py`, `timed.py`). A rounding is the unit of all numbers.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

from properties.conformance.spread import roundings_of, who_meets
from properties.contracts.request import Seen
from properties.contracts.rounding import LITTLE, WIDER
from properties.engine.rounded import Machine, Rounded
from properties.engine.timed import Speed, Time, Ways
from properties.given import Given
from properties.worlds.changes import in_numbers
from properties.worlds.storeys import Setting, any_places
from reference.storeys import StoreyWorld
from spec.graph import Direction
from spec.invariants import equal, every
from spec.number import Truth
from spec.profiles import SteppedProfile
from spec.rules.event import Nearing
from spec.rules.step import Event, contacts, go_on, losses, next_instant, walls
from spec.stepped import some
from spec.storeys import AtWall, Contact, Mark, Seat

FAMILIES: Mapping[type, str] = {Contact: "contact", AtWall: "wall", Seat: "loss"}
COMING: Mapping[type, Callable[..., Iterator[Nearing[Any]]]] = {Contact: contacts, AtWall: walls, Seat: losses}


@dataclass(frozen=True)
class Courses:
    """A world at an instant in exact numbers, and as a machine has it then, in which each body is so far away; how far
    it is off, at most, and how far its velocity may lead astray until the next instant.
    """

    exact: StoreyWorld[Any]
    nearly: StoreyWorld[Any]
    speeds: Mapping[int, Speed]
    away: Mapping[int, Any]
    off: Mapping[int, Any]
    astray: Mapping[int, Any]

    @property
    def velocities(self) -> dict[int, Any]:
        """How fast each body goes."""
        return {body: speed.held for body, speed in self.speeds.items()}

    def apart(self, world: StoreyWorld[Any], body: int, way: Any) -> Any:
        """How far a body of the machine's world is from where it is in exact numbers when it has gone a way."""
        return world.places[body].left.held - self.exact.places[body].left - way

    def same(self, one: Any, two: Any, within: Any) -> Truth:
        """Whether two ways are nearly the same; whole rounds change no place."""
        return some(equal(one + by, two, within) for by in self.rounds)

    @property
    def rounds(self) -> list[Any]:
        """No round, and on a ring as many as two courses may be apart, either way."""
        round_ = self.exact.circumference
        return [self.exact.margin * 0] if round_ is None else [round_ * rounds for rounds in range(-3, 4)]


def any_courses(given: Given, setting: Setting) -> Courses:
    """Any two courses at any instant: they are off by any amounts."""
    machine, exact = Machine(given), any_places(given, setting)
    bodies = range(len(setting.members))
    off = {body: given.number(f"how far {body} is off at most") for body in bodies}
    astray = {body: given.number(f"how far the velocity of {body} leads astray at most") for body in bodies}
    speeds = {body: any_speed(given, machine, body, astray[body]) for body in bodies}
    away, nearly = {}, in_numbers(exact, partial(Rounded, machine))
    for body, place in enumerate(exact.places):
        besides = signed(given, f"how far {body} is off")
        given.assume(equal(besides, besides * 0, off[body]), "it is off by that at most")
        away[body] = besides + speeds[body].ways.late
        left = once_round(given, place.left + away[body], body, exact.circumference)
        nearly.places[body] = replace(nearly.places[body], left=Rounded(machine, left))
    return Courses(exact, nearly, speeds, away, off, astray)


def once_round(given: Given, place: Any, body: int, round_: Any) -> Any:
    """A place, on a ring less than once round."""
    if round_ is None:
        return place
    found = given.number(f"where the machine has {body}")
    given.assume(some(found == place + round_ * rounds for rounds in (-1, 0, 1)), "it may have come round")
    given.assume(found < round_, "places on a ring are counted once round")
    return found


def any_speed(given: Given, machine: Machine, body: int, most: Any) -> Speed:
    """Any velocity of a body; it leads astray by so much at most."""
    ways = Ways(
        due=signed(given, f"way of {body}"),
        late=signed(given, f"late way of {body}"),
        gone=signed(given, f"way of {body} in the machine's time"),
        astray=signed(given, f"how far {body} goes astray"),
    )
    given.assume(equal(ways.astray, most * 0, most), "it leads astray by that at most")
    return Speed(machine=machine, held=signed(given, f"velocity of {body}"), ways=ways)


def signed(given: Given, name: str) -> Any:
    """Any number, also one below 0."""
    return given.number(f"{name}, to the right") - given.number(f"{name}, to the left")


def errors_spread_so(
    profile: SteppedProfile, given: Given, setting: Setting, kind: type[Mark], way: Direction | None = None
) -> None:
    """What comes is early or late by no more than what its two bodies are off, and some roundings, or than the instant
    before; nobody is off by more than before, and some roundings; and where there is room enough, that is used up.
    """
    courses, roundings = one_way(given, any_courses(given, setting), way), roundings_of(setting.ring)
    looks_alike(given, courses)
    comes_round_alike(given, courses)
    one, room = what_comes(given, courses, kind)
    time = Seen(getattr(profile.rules, FAMILIES[kind]), given).choose(one).effect(one)
    goes_on_in_time(given, courses, one, time)
    after = courses.nearly.copy()
    go_on(after, courses.speeds, time, set())
    bodies = [body for body in who_meets(one.mark) if body is not None]
    own = roundings.room + sum(courses.off[body] + courses.astray[body] for body in bodies)
    late, earlier = one.speed.ways.late_after, one.speed.ways.late
    as_before = some(equal(late, late * 0, most) for most in (own, earlier, earlier * -1))
    given.ensure("it is late by what is off, or as the instant before", as_before)
    short = (room < own + earlier) | (room < own - earlier)
    used = toward(one.mark, {body: courses.apart(after, body, late * 0) for body in courses.speeds})
    used_up = courses.same(used * way_of(one.mark, courses), room, roundings.meeting)
    given.ensure("with room enough, it is late by what is off", short | equal(late, late * 0, own))
    given.ensure("with room enough, the room is used up", short | used_up)
    for body, speed in courses.speeds.items():
        off = courses.apart(after, body, speed.ways.due) - speed.ways.late_after
        most = courses.off[body] + courses.astray[body] + roundings.stretch
        given.ensure(f"{body} is off by some roundings more", courses.same(off, off * 0, most))


def one_way(given: Given, courses: Courses, way: Direction | None) -> Courses:
    """The courses in which whoever is on another goes one way on it: half of what is proved comes to its end by itself,
    and the other half is that of the other way.
    """
    for body, place in enumerate(courses.exact.places):
        if way is not None and place.support is not None:
            passing = courses.velocities[body] - courses.velocities[place.support]
            given.assume(passing * way > 0, "it goes this way on its support")
    return courses


def what_comes(given: Given, courses: Courses, kind: type[Mark]) -> tuple[Nearing[Any], Any]:
    """Something that comes at the end of the while, as the machine sees it, and the room to it in exact numbers."""
    rooms = {one.mark: one.room for one in COMING[kind](courses.exact, courses.velocities)}
    coming = [one for one in COMING[kind](courses.nearly, courses.speeds) if one.mark in rooms]
    first = next(iter(coming), None)
    one = next((other for other in coming[1:] if given.flag(f"{other.mark} comes first")), first)
    given.assume(one is not None, "something comes nearer, in both")
    assert one is not None
    room, due = rooms[one.mark], one.speed.ways.due
    given.assume((due >= room) & (due >= 0) & ((due <= room) | (due <= 0)), "it comes at the end of the while")
    return one, room


def goes_on_in_time(given: Given, courses: Courses, one: Nearing[Any], time: Time) -> None:
    """Assume that in any time what comes nearer does so, and in none nobody goes anywhere."""
    given.assume(one.speed.ways.gone - one.speed.ways.astray >= 0, "what comes nearer does so in any time")
    if time.held <= 0:
        for speed in courses.speeds.values():
            given.assume((speed.ways.gone == 0) & (speed.ways.astray == 0), "in no time nobody goes anywhere")


def first_comes_nearly_first(profile: SteppedProfile, given: Given) -> None:
    """What a machine takes for the next instant, the end of the step too, comes in exact numbers before all else, but
    for what that and the other may be late.
    """
    names = ("the first", "the second", "the end")
    before = signed(given, "how late the instant before was")
    exact = {name: given.number(f"time until {name}") for name in names}
    most = {name: given.number(f"how late {name} is at most") for name in names}
    late = {name: signed(given, f"how late {name} is") for name in names}
    given.assume(every(equal(late[name], before * 0, most[name]) for name in names), "it is late by that at most")
    nearly = {name: exact[name] + late[name] - before for name in names}
    coming = [Event("", Seat(body, 0, None), nearly[name]) for body, name in enumerate(names[:2])]
    instant = next_instant(coming, nearly["the end"])
    for name in [names[event.mark.body] for event in instant.events] + ["the end"] * instant.last:
        for other in names:
            given.ensure(f"{name} is not after {other}, nearly", exact[name] <= exact[other] + most[name] + most[other])


def toward(mark: Mark, ways: Mapping[int, Any]) -> Any:
    """How far the first body of what comes goes to the right, as the second one sees it."""
    first, second = who_meets(mark)
    return ways[first] if second is None else ways[first] - ways[second]


def way_of(mark: Mark, courses: Courses) -> int:
    """To which side the first body goes, as the second one sees it."""
    return 1 if toward(mark, courses.velocities) > 0 else -1


def looks_alike(given: Given, courses: Courses) -> None:
    """Assume that the same terrain is ahead of a body, and that who is over ground is so by more than what is off."""
    for body, place in enumerate(courses.exact.places):
        away = courses.away[body]
        for ground in courses.exact.terrain.ground(place.storey) if place.storey else ():
            over = some(
                before(ground.left + by, place.right, away) & before(place.left, ground.right + by, away)
                for by in courses.rounds
            )
            given.assume(over, "a body is over its ground by more than it is off")
        for wall in courses.exact.terrain.on(place.storey) if courses.exact.ends is not None else ():
            beside = before(place.left, wall.left, away) | before(wall.left, place.left, away)
            given.assume(beside, "it is not where a wall begins")


def comes_round_alike(given: Given, courses: Courses) -> None:
    """Assume that on a ring two bodies are seen the same way round, and that nobody goes round more than once."""
    exact, away, round_ = courses.exact, courses.away, courses.exact.circumference
    if round_ is None:
        return
    for left, right in exact.neighbours():
        apart = exact.gap(left, right) + exact.places[left].width
        # The ways from each to the other make once round together: if both are more than 0, neither is more than that.
        given.assume(apart + away[right] - away[left] > 0, WIDER)
    for body, place in enumerate(exact.places):
        for wall in exact.terrain.on(place.storey):
            for sign in (1, -1):
                along = exact.round((wall.left - place.left) * sign) - away[body] * sign
                given.assume((along > 0) & (along <= round_), WIDER)
        if place.support is not None:
            moved = exact.offset(body, place.support) + away[body] - away[place.support]
            between = moved * 2 + place.width - exact.places[place.support].width
            given.assume(equal(between, round_ * 0, round_ - LITTLE), WIDER)
    for speed in courses.speeds.values():
        given.assume(equal(speed.ways.gone, round_ * 0, round_ - LITTLE), "nobody goes round more than once")


def before(one: Any, two: Any, off: Any) -> Any:
    """Whether one place is before another by more than what is off, and some roundings."""
    return (one + off + LITTLE <= two) & (one - off + LITTLE <= two)
