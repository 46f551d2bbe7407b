"""What is shown of a step in another view of it, whatever else is in the world: seen from behind, with bodies listed in
another order, and without those above a storey.

Each function that a step is made of does the same in the other view. Those that ask the world are looked at in windows:
a few bodies and pieces of terrain, anywhere, with any ways. Those that do not are looked at with any facts.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from itertools import combinations, product
from typing import Any

from properties.contracts.steps import any_member
from properties.contracts.stretches import APART, KNOWN_SPEEDS, UNIT, any_lost, any_way, nearings, ways_round
from properties.contracts.sweeps import BEYOND, reaching, rest
from properties.evidence.comparisons import alike
from properties.given import Given
from properties.worlds.changes import chosen, mirrored
from properties.worlds.storeys import Setting, any_places, any_world
from reference.storeys import StoreyWorld
from spec.conditions import WALLS_THICK
from spec.graph import Direction
from spec.invariants import every
from spec.rule import AnyRule, Chooser
from spec.rules.event import Nearing
from spec.rules.row import Meeting, Member, cut_back, velocities
from spec.rules.settle import Footing, Found, Top, settle
from spec.rules.step import StepRules, go_on, lasting, rows, touching, unheld, velocities_of
from spec.rules.wish import Urge
from spec.stepped import margins_kept, outside_terrain
from spec.storeys import AtWall, Contact, Drive, Mark, Seat

Ways = Mapping[int, Any]
Rows = list[tuple[tuple[int, ...], bool]]
UNTIED = "no two tops are as much under a body that has not moved"


@dataclass(frozen=True)
class View:
    """Another view of a world: the bodies that are in it, in the order in which it lists them, and whether it is seen
    from behind.
    """

    bodies: tuple[int, ...]
    turned: bool = False

    @property
    def reorders(self) -> bool:
        """Whether bodies are listed in another order."""
        return self.bodies != tuple(sorted(self.bodies))

    def of_world(self, world: StoreyWorld[Any]) -> StoreyWorld[Any]:
        """The world in this view."""
        held = chosen(world, self.bodies)
        return mirrored(held) if self.turned else held

    def of_body(self, body: int | None) -> int | None:
        """The name of a body; the ground, which is None, has none."""
        return None if body is None else self.bodies.index(body)

    def of_direction(self, direction: Direction) -> Direction:
        """A direction in this view."""
        return direction.opposite if self.turned else direction

    def of_way(self, way: Any) -> Any:
        """A signed way, or a velocity, in this view."""
        return way * -1 if self.turned else way

    def of_ways(self, ways: Ways) -> dict[int, Any]:
        """The ways of those in this view."""
        return {name: self.of_way(ways[body]) for name, body in enumerate(self.bodies)}

    def of_drive(self, drive: Drive[Any]) -> Drive[Any]:
        """A drive in this view."""
        return replace(drive, speed=self.of_way(drive.speed))

    def of_mark(self, mark: Mark) -> Mark:
        """What is recorded, in this view."""
        body = self.bodies.index(mark.body)
        if isinstance(mark, Contact):
            right = self.bodies.index(mark.right)
            return Contact(right, body) if self.turned else Contact(body, right)
        if isinstance(mark, AtWall):
            return AtWall(body, mark.storey, self.of_direction(mark.direction))
        return Seat(body, mark.storey, self.of_body(mark.support))

    def of_marks(self, marks: set[Mark]) -> set[Mark]:
        """What is recorded of those in this view; what is next to them, or under them, is in it too."""
        return {self.of_mark(mark) for mark in marks if mark.body in self.bodies}

    def of_rows(self, found: Rows) -> Rows:
        """Rows of those in this view, in order; each from left to right, or of one that closes, who is in it."""
        seen = [(tuple(map(self.bodies.index, row)), closed) for row, closed in found if set(row) <= set(self.bodies)]
        way = -1 if self.turned else 1
        return sorted((tuple(sorted(row)) if closed else row[::way], closed) for row, closed in seen)

    def of_member(self, member: Member[Any]) -> Member[Any]:
        """A member of a row in this view."""
        walls = frozenset(map(self.of_direction, member.walls))
        return replace(member, body=self.bodies.index(member.body), wish=self.of_way(member.wish), walls=walls)

    def of_found(self, found: Found | None) -> Found | None:
        """What a body has found, in this view; who keeps its support looks for none."""
        return replace(found, support=self.of_body(found.support)) if found else None


def from_behind(bodies: int) -> View:
    """So many bodies, seen from behind."""
    return View(tuple(range(bodies)), turned=True)


def renamed(bodies: int) -> View:
    """So many bodies, listed the other way round; of three or more this is one order of several."""
    return View(tuple(range(bodies))[::-1])


@dataclass(frozen=True)
class Untied:
    """The family that settles, where nothing is tied."""

    family: Chooser
    given: Given

    def choose(self, facts: Any) -> AnyRule:
        """Return the rule that applies."""
        for one, other in combinations(facts.tops, 2):
            if one.body != other.body:
                self.given.assume((one.overlap != other.overlap) | (facts.motion != facts.motion * 0), UNTIED)
        return self.family.choose(facts)


def rows_of(world: StoreyWorld[Any], marks: set[Mark]) -> Rows:
    """The rows of all storeys in order; each from left to right, or of one that closes, who is in it."""
    found = [one for storey in world.storeys() for one in rows(world, storey, marks)]
    return sorted((tuple(sorted(row) if closed else row), closed) for row, closed in found)


def ensure_same(given: Given, name: str, one: Mapping[Any, Any], other: Mapping[Any, Any]) -> None:
    """Promise that two mappings have the same keys, and the same numbers."""
    given.ensure(name, one.keys() == other.keys())
    given.ensure(name, every(number == other.get(key, number) for key, number in one.items()))


def ensure_nearing_alike(given: Given, here: Iterable[Nearing[Any]], there: Iterable[Nearing[Any]]) -> None:
    """Promise that the same comes nearer, as near and as fast."""
    here, there = list(here), list(there)
    for number in ("room", "speed"):
        each = ({one.mark: getattr(one, number) for one in found} for found in (here, there))
        ensure_same(given, f"the same comes nearer: {number}", *each)


def worlds_look_alike(rules: StepRules, given: Given, setting: Setting, view: View) -> None:
    """In another view of any world the same is recorded, in the same rows, the same seats hold, and with any velocities
    the same comes nearer, as near and as fast.
    """
    world, ways = any_world(given, setting), {body: any_way(given, body) for body in setting.drives}
    other, marks = view.of_world(world), touching(world)
    given.ensure("the same is recorded", touching(other) == view.of_marks(marks))
    given.ensure("the same rows", rows_of(other, view.of_marks(marks)) == view.of_rows(rows_of(world, marks)))
    given.ensure("the same seats hold", unheld(other) == view.of_marks(set(unheld(world))))
    here = [replace(one, mark=view.of_mark(one.mark)) for one in nearings(world, ways) if one.body in view.bodies]
    ensure_nearing_alike(given, here, nearings(other, view.of_ways(ways)))


def ways_look_alike(rules: StepRules, given: Given, setting: Setting, view: View) -> None:
    """When bodies have gone any way, in another view they are at the same place."""
    world = any_world(given, setting)
    ways = ways_round(given, world, setting.drives)
    other = view.of_world(world)
    for held, by in ((world, ways), (other, view.of_ways(ways))):
        go_on(held, by, UNIT, set())
    given.ensure("all have gone the same way", alike(view.of_world(world), other))


def records_look_alike(rules: StepRules, given: Given, view: View) -> None:
    """After any ways, the same is left of what is recorded."""
    ways: Ways = {body: any_way(given, body) for body in view.bodies}
    marks: set[Mark] = {Contact(0, 1), *(AtWall(0, 0, direction) for direction in Direction), Seat(0, 0, None)}
    left, there = lasting(ways, marks), lasting(view.of_ways(ways), view.of_marks(marks))
    given.ensure("the same is left", there == view.of_marks(left))


def tops_are_listed_alike(rules: StepRules, given: Given, setting: Setting, view: View) -> None:
    """In another view of any world, the same tops would hold the first body, in the order in which they are seen."""
    world: Any = any_places(given, setting)
    zero = world.margin * 0
    given.assume(every([margins_kept(world, zero), outside_terrain(world, zero)]), APART)
    listed = [view.of_body(top) for top in world.tops(0)]
    seen = view.of_world(world).tops(view.bodies.index(0))
    given.ensure("the same tops are listed", seen == listed[:: -1 if view.turned else 1])


def settling_looks_alike(rules: StepRules, given: Given, setting: Setting, view: View) -> None:
    """In another view of any world, whoever has lost its support finds the same one."""
    world: Any = any_places(given, setting)
    zero = world.margin * 0
    given.assume(every([margins_kept(world, zero), outside_terrain(world, zero)]), APART)
    if view.turned:
        given.assume(WALLS_THICK.holds(world, zero), WALLS_THICK.id)
    lost = any_lost(given, world, zero)
    ways, other = {body: any_way(given, body) for body in setting.drives}, view.of_world(world)
    family = Untied(rules.settle, given) if view.reorders else rules.settle
    there = {mark for mark in view.of_marks(set(lost)) if isinstance(mark, Seat)}
    for held, by, seats in ((world, ways, lost), (other, view.of_ways(ways), there)):
        list(settle(family, held, by, seats))
    given.ensure("all settle alike", alike(view.of_world(world), other))


def velocities_look_alike(rules: StepRules, given: Given, setting: Setting, view: View) -> None:
    """In another view of any world, whatever drives whom, and whoever is at a wall, velocities are the same."""
    world, drives = any_world(given, setting), {}
    marks: set[Mark] = set()
    for body in setting.drives:
        drives[body] = Drive(any_way(given, body), given.flag(f"{body} is driven relative to its support"))
        if given.flag(f"{body} is at a wall on the right"):
            marks.add(AtWall(body, world.storey(body), Direction.RIGHT))
    there = {name: view.of_drive(drives[body]) for name, body in enumerate(view.bodies)}
    here = velocities_of(rules, world, drives, marks)
    seen = velocities_of(rules, view.of_world(world), there, view.of_marks(marks))
    ensure_same(given, "all are as fast", view.of_ways(here), seen)


def rows_look_alike(rules: StepRules, given: Given, view: View) -> None:
    """Any two that wish anything and may push: in another view they are as fast."""
    row = [Member(body, any_way(given, body), pushes=True, walls=frozenset()) for body in (0, 1)]
    step = -1 if view.turned else 1
    there = velocities(rules.row, [view.of_member(member) for member in row][::step], closed=False)
    here = velocities(rules.row, row, closed=False)
    given.ensure("both are as fast", every(view.of_way(a) == b for a, b in zip(here, there[::step], strict=True)))


def members_look_alike(rules: StepRules, given: Given, view: View) -> None:
    """Any member of any row in another view: the same reaches it and goes on from it, what is ahead lets it go as fast,
    and it takes part alike.
    """
    member, beyond, closed = any_member(given, 0), given.number("speed ahead"), given.flag("the row closes on itself")
    speeds = {way: given.number(f"speed to the {way.name.lower()}") for way in Direction}
    other, seen = view.of_member(member), {view.of_direction(way): speed for way, speed in speeds.items()}
    for ahead, speed in speeds.items():
        each = (member, ahead), (other, view.of_direction(ahead))
        here, there = (reaching(rules.row, speed, [one], way) for one, way in each)
        given.ensure("the same reaches it, and goes on", every(a == b for a, b in zip(here, there, strict=True)))
        here, there = (cut_back(rules.row, [one, rest(BEYOND, beyond, way)], [speed, beyond], way) for one, way in each)
        given.ensure("it goes as fast", here[0] == there[0])
    meetings = [
        Meeting(one, by[Direction.RIGHT], by[Direction.LEFT], closed) for one, by in ((member, speeds), (other, seen))
    ]
    part, twin = (rules.meet.choose(meeting).effect(meeting) for meeting in meetings)
    wished = view.of_member(part)
    given.ensure("it takes part alike", wished.wish == twin.wish)
    given.ensure("it is held alike", (wished.pushes, wished.walls) == (twin.pushes, twin.walls))


def facts_look_alike(rules: StepRules, given: Given, view: View) -> None:
    """Any wish, and any time until something comes, are the same in another view."""
    drive, carried = Drive(any_way(given, 0), given.flag("relative to the support")), any_way(given, 1)
    body, other = view.bodies[0], 0
    urge, twin = Urge(body, drive, carried), Urge(other, view.of_drive(drive), view.of_way(carried))
    wish, seen = (rules.wish.choose(one).effect(one) for one in (urge, twin))
    given.ensure("it wishes the same", view.of_way(wish) == seen)
    room = given.number("room")
    marks: dict[str, Mark] = {
        "contact": Contact(0, 1),
        "wall": AtWall(body, 0, Direction.RIGHT),
        "loss": Seat(body, 0, None),
    }
    for (name, mark), speed in product(marks.items(), KNOWN_SPEEDS):
        nears = Nearing(mark, room, speed), Nearing(view.of_mark(mark), room, speed)
        here, there = (getattr(rules, name).choose(one).effect(one) for one in nears)
        given.ensure(f"{name}: it comes at the same time", here == there)


def tops_look_alike(rules: StepRules, given: Given, view: View) -> None:
    """Any body over any three tops takes the same one in another view, if it takes one."""
    motion, tops = any_way(given, 0), [Top(body, given.number(f"over {body}")) for body in (1, 2, 3)]
    family = Untied(rules.settle, given) if view.reorders else rules.settle
    lost = given.flag("its support is lost")
    footing = Footing(0, holds=not lost, ground=given.flag("over ground"), tops=tops, motion=motion)
    seen = [replace(top, body=view.bodies.index(top.body)) for top in tops]
    there = replace(
        footing, body=view.bodies.index(0), tops=seen[:: -1 if view.turned else 1], motion=view.of_way(motion)
    )
    found, twin = (family.choose(one).effect(one) for one in (footing, there))
    given.ensure("it stands on the same", [twin] == [view.of_found(found)])
