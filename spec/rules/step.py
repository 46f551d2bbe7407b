"""Step: bodies are driven for a time. From event to event they move with the velocities of their rows.

A tick is a step in which every character is driven; a request of the thesis is one in which one body is driven at unit
speed for as long as the distance asked.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import reduce
from typing import Generic

from spec.graph import Direction
from spec.number import N, lesser, zero_like
from spec.rule import Chooser
from spec.rules.event import Nearing
from spec.rules.row import Member, RowRules, velocities
from spec.rules.settle import Change, motion_of, settle
from spec.rules.wish import Urge
from spec.storeys import AtWall, Contact, Drive, Mark, Seat, Storeys, seat_of


@dataclass(frozen=True)
class StepRules:
    """The families that a step chooses its rules from, handed along so that a proof, a mutant or a record of what
    fired can stand in for any of them.
    """

    wish: Chooser
    forward: Chooser
    relay: Chooser
    meet: Chooser
    way: Chooser
    contact: Chooser
    wall: Chooser
    loss: Chooser
    settle: Chooser

    def through(self, wrap: Callable[[Chooser], Chooser]) -> StepRules:
        """The same rules, each family wrapped."""
        return StepRules(**{name: wrap(getattr(self, name)) for name in STEP_FAMILIES})

    @property
    def row(self) -> RowRules:
        """Those that decide the velocities of a row."""
        return RowRules(self.forward, self.relay, self.meet, self.way)


STEP_FAMILIES = ("wish", "forward", "relay", "meet", "way", "contact", "wall", "loss", "settle")


@dataclass(frozen=True)
class Event(Generic[N]):
    """Something that comes in a while, by a rule."""

    rule: str
    mark: Mark
    after: N


@dataclass(frozen=True)
class Moment(Generic[N]):
    """An instant of a step: how much time is left, how the bodies moved up to it, what came, and who settled how."""

    left: N
    moved: N
    velocities: Mapping[int, N]
    events: tuple[Event[N], ...]
    changes: tuple[Change, ...]


def rows(world: Storeys[N], storey: int, marks: set[Mark]) -> Iterator[tuple[Sequence[int], bool]]:
    """The rows in contact of a storey, from left to right, and whether each closes on itself round a ring."""
    order = list(world.row(storey))
    ends = [i for i, body in enumerate(order) if Contact(body, order[(i + 1) % len(order)]) not in marks]
    if not ends:
        yield order, True
        return
    first = (ends[-1] + 1) % len(order)
    around, row = [*order[first:], *order[:first]], []
    for i, body in enumerate(around):
        row.append(body)
        if Contact(body, around[(i + 1) % len(around)]) not in marks:
            yield row, False
            row = []


def velocities_of(
    rules: StepRules, world: Storeys[N], drives: Mapping[int, Drive[N]], marks: set[Mark]
) -> dict[int, N]:
    """The velocities of all bodies, storey by storey upwards: what carries has its velocity before what it carries."""
    found: dict[int, N] = {}
    for storey in world.storeys():
        for row, closed in rows(world, storey, marks):
            members = [member_of(rules, world, body, drives[body], found, marks) for body in row]
            found.update(zip(row, velocities(rules.row, members, closed), strict=True))
    return found


def member_of(
    rules: StepRules, world: Storeys[N], body: int, drive: Drive[N], found: Mapping[int, N], marks: set[Mark]
) -> Member[N]:
    """A body as a member of its row, with its wish."""
    support = world.support(body)
    urge = Urge(body, drive, zero_like(drive.speed) if support is None else found[support])
    walls = frozenset(direction for direction in Direction if AtWall(body, world.storey(body), direction) in marks)
    return Member(body, rules.wish.choose(urge).effect(urge), world.pushes(body), walls)


def to_come(rules: StepRules, world: Storeys[N], speeds: Mapping[int, N]) -> Iterator[Event[N]]:
    """The events that come if all go on as they move."""
    for nearing, family in (
        *((one, rules.contact) for one in contacts(world, speeds)),
        *((one, rules.wall) for one in walls(world, speeds)),
        *((one, rules.loss) for one in losses(world, speeds)),
    ):
        rule = family.choose(nearing)
        yield Event(rule.id, nearing.mark, rule.effect(nearing))


def contacts(world: Storeys[N], speeds: Mapping[int, N]) -> Iterator[Nearing[N]]:
    """Each pair of neighbours that comes nearer."""
    for left, right in world.neighbours():
        closing = speeds[left] - speeds[right]
        if closing > zero_like(closing):
            yield Nearing(Contact(left, right), world.gap(left, right) - world.margin, closing)


def walls(world: Storeys[N], speeds: Mapping[int, N]) -> Iterator[Nearing[N]]:
    """Each body that moves towards a wall."""
    for body, speed, direction in moving(speeds):
        room = world.to_wall(body, direction)
        if room is not None:
            yield Nearing(AtWall(body, world.storey(body), direction), room, speed)


def losses(world: Storeys[N], speeds: Mapping[int, N]) -> Iterator[Nearing[N]]:
    """Each body that moves relative to a support that does not hold it for ever."""
    for body, speed, direction in moving({body: motion_of(world, speeds, body) for body in speeds}):
        room = world.to_loss(body, direction)
        if room is not None:
            yield Nearing(seat_of(world, body), room, speed)


def moving(speeds: Mapping[int, N]) -> Iterator[tuple[int, N, Direction]]:
    """Each body that moves, its speed and its direction."""
    for body, velocity in speeds.items():
        for direction in Direction:
            if velocity * direction > zero_like(velocity):
                yield body, velocity * direction, direction


@dataclass(frozen=True)
class Instant(Generic[N]):
    """The next instant of a step: in how long it is, what comes then, and whether it is the last."""

    after: N
    events: tuple[Event[N], ...]
    last: bool


def next_instant(coming: Sequence[Event[N]], left: N) -> Instant[N]:
    """The first instant at which something comes; the end of the step if nothing comes before."""
    sooner = [event.after for event in coming if event.after < left]
    after = reduce(lesser, sooner, left)
    return Instant(after, tuple(event for event in coming if event.after <= after), not sooner)


def touching(world: Storeys[N]) -> set[Mark]:
    """What is in contact, and who is at a wall, as the distances say."""
    zero = zero_like(world.margin)
    marks: set[Mark] = {Contact(*pair) for pair in world.neighbours() if world.gap(*pair) <= world.margin}
    for storey in world.storeys():
        for body in world.row(storey):
            for direction in Direction:
                room = world.to_wall(body, direction)
                if room is not None and room <= zero:
                    marks.add(AtWall(body, storey, direction))
    return marks


def unheld(world: Storeys[N]) -> set[Seat]:
    """The seats that do not hold, as the distances say."""
    return {seat_of(world, body) for storey in world.storeys() for body in world.row(storey) if not world.holds(body)}


def lasting(speeds: Mapping[int, N], marks: set[Mark]) -> set[Mark]:
    """What is left of what was recorded, after a while of moving so.

    A pair has parted when the right one was faster; a body has left a wall when it moved away from it; what was lost
    is far enough now not to be taken for a support again.
    """

    def lasts(mark: Mark) -> bool:
        if isinstance(mark, Contact):
            return bool(speeds[mark.left] >= speeds[mark.right])
        if isinstance(mark, AtWall):
            return bool(speeds[mark.body] * mark.direction >= zero_like(speeds[mark.body]))
        return False

    return {mark for mark in marks if lasts(mark)}


def go_on(world: Storeys[N], speeds: Mapping[int, N], time: N, marks: set[Mark]) -> set[Mark]:
    """Let all bodies move for a time; return what is left of what was recorded."""
    if time <= zero_like(time):
        return marks
    for body, speed in speeds.items():
        world.advance(body, speed * time)
    return lasting(speeds, marks)


def present(world: Storeys[N], marks: set[Mark]) -> set[Mark]:
    """What is left of what was recorded when bodies have changed their storeys: contacts of those still neighbours."""
    pairs = set(world.neighbours())

    return {mark for mark in marks if not isinstance(mark, Contact) or (mark.left, mark.right) in pairs}


def settled(world: Storeys[N], marks: set[Mark]) -> set[Mark]:
    """What is recorded when bodies have settled: what is left of what was, and what touches, as at the beginning."""
    return present(world, marks) | touching(world)


def step(
    rules: StepRules, world: Storeys[N], drives: Mapping[int, Drive[N]], duration: N
) -> Generator[Moment[N], None, None]:
    """Drive the bodies of a world for a time `>= 0`; `drives` has all of them. Yields the instants at which something
    comes, and the last one.
    """
    still = {body: zero_like(duration) for body in drives}
    changes = tuple(settle(rules.settle, world, still, unheld(world)))
    if changes:
        yield Moment(duration, zero_like(duration), still, (), changes)
    marks, left = touching(world), duration
    while True:
        speeds = velocities_of(rules, world, drives, marks)
        instant = next_instant(list(to_come(rules, world, speeds)), left)
        marks = go_on(world, speeds, instant.after, marks) | {event.mark for event in instant.events}
        lost = {mark for mark in marks if isinstance(mark, Seat)}
        changes = tuple(settle(rules.settle, world, speeds, lost))
        marks = settled(world, marks) if changes else marks
        left = left - instant.after
        yield Moment(left, instant.after, speeds, instant.events, changes)
        if instant.last:
            return
