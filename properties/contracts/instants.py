"""What is shown of when the motion of a step changes: of any member of a row that does not close, of two in contact, of
a body and its support.

That a step comes to its end follows from it by argument: docs/proofs.md.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

from properties.contracts.stretches import any_way
from properties.contracts.sweeps import BEYOND, any_taking_part, reaching, rest
from properties.given import Given
from properties.worlds.storeys import Setting, any_world
from spec.graph import Direction
from spec.invariants import every
from spec.plane import negated
from spec.rules.row import Meeting, Member, RowRules, cut_back
from spec.rules.step import StepRules, lasting, losses
from spec.stepped import is_held
from spec.storeys import AtWall, Contact, Mark, seat_of

RAISED = "it wishes no less to go ahead than before, and what comes to it urges it no less to"
AGAIN = "no more comes again than reached it before"
OPENS = "it opens"


@dataclass(frozen=True)
class Coming:
    """What comes to a member of a row: speeds that reach it from behind and from ahead, its own wish counted; what is
    passed on to it from behind when it is known who is squeezed; and how fast what is ahead lets it go.
    """

    reached: Any
    back: Any
    again: Any
    lets_go: Any


def any_coming(given: Given, wish: Any, name: str) -> Coming:
    """Anything that comes to one that wishes to go ahead at a speed, or back if that is less than 0."""
    reached, back, again, lets_go = (
        given.number(f"{what}, {name}") for what in ("what reaches it", "from ahead", "again", "speed ahead")
    )
    given.assume((again <= reached) & (wish <= reached) & (wish * -1 <= back), AGAIN)
    return Coming(reached, back, again, lets_go)


def going(rules: RowRules, member: Member[Any], coming: Coming, ahead: Direction) -> tuple[Any, Any]:
    """The speed ahead of a member by the rules, and what it passes on, when it is known who is squeezed."""
    right, left = (coming.reached, coming.back) if ahead is Direction.RIGHT else (coming.back, coming.reached)
    meeting = Meeting(member, right, left, closed=False)
    part = rules.meet.choose(meeting).effect(meeting)
    speed, passed = reaching(rules, coming.again, [part], ahead)
    found, _ = cut_back(rules, [part, rest(BEYOND, coming.lets_go, ahead)], [speed, coming.lets_go], ahead)
    return found, passed


def any_raised(given: Given, ahead: Direction) -> tuple[Member[Any], Member[Any]]:
    """Any member of a row, and the same with a wish that is raised."""
    member = any_taking_part(given, 0, ahead)
    member = replace(member, wish=member.wish - given.number("how far it wishes back") * ahead)
    return member, replace(member, wish=member.wish + given.number("by how much its wish is raised") * ahead)


def faster_wishes_pass_on_no_less(rules: StepRules, given: Given, ahead: Direction) -> None:
    """If a member wishes no less to go ahead, and no less is passed on to it, no less reaches it and goes on."""
    passed, more = given.number("passed on"), given.number("how much more")
    member, raised = any_raised(given, ahead)
    reached, on = reaching(rules.row, passed, [member], ahead)
    reached_now, on_now = reaching(rules.row, passed + more, [raised], ahead)
    given.ensure("no less reaches it", reached <= reached_now)
    given.ensure("no less goes on", on <= on_now)


def faster_wishes_slow_nobody(rules: StepRules, given: Given, ahead: Direction) -> None:
    """If a member wishes no less to go ahead, and what comes to it urges it no less to, it goes ahead no slower, and
    passes no less on.
    """
    member, raised = any_raised(given, ahead)
    before, after = any_coming(given, member.wish * ahead, "before"), any_coming(given, raised.wish * ahead, "after")
    given.assume(every([before.reached <= after.reached, before.again <= after.again]), RAISED)
    given.assume(every([before.back >= after.back, before.lets_go <= after.lets_go]), RAISED)
    then, now = going(rules.row, member, before, ahead), going(rules.row, raised, after, ahead)
    given.ensure("it goes no slower", then[0] <= now[0])
    given.ensure("it passes no less on", then[1] <= now[1])


@dataclass(frozen=True)
class Beside:
    """What is beside a few of a row on one side: what it passes on to them, the same again when it is known who is
    squeezed, and how fast it lets them go; None if nobody is in contact there.
    """

    passed: Any
    again: Any
    lets_go: Any | None


@dataclass(frozen=True)
class Few:
    """What a few in contact make of what is beside them: their velocities, and what they pass on, and again."""

    velocities: list[Any]
    passed: dict[Direction, Any]
    again: dict[Direction, Any]


def few(rules: RowRules, row: list[Member[Any]], beside: dict[Direction, Beside]) -> Few:
    """A few in contact, by the rules; `beside` is by the direction in which one looks at it from them."""
    reached, passed, again, speeds = {}, {}, {}, {}
    for way in Direction:
        *reached[way], passed[way] = reaching(rules, beside[way.opposite].passed, row[::way], way)
    meetings = zip(row, reached[Direction.RIGHT], reached[Direction.LEFT][::-1], strict=True)
    parts = [met(rules, Meeting(member, right, left, closed=False)) for member, right, left in meetings]
    for way in Direction:
        *again_reached, again[way] = reaching(rules, beside[way.opposite].again, parts[::way], way)
        ahead = beside[way].lets_go
        beyond = [] if ahead is None else [rest(BEYOND, ahead, way)]
        all_speeds = again_reached if ahead is None else [*again_reached, ahead]
        speeds[way] = cut_back(rules, [*parts[::way], *beyond], all_speeds, way)[: len(row)][::way]
    velocities = [right - left for right, left in zip(speeds[Direction.RIGHT], speeds[Direction.LEFT], strict=True)]
    return Few(velocities, passed, again)


def met(rules: RowRules, meeting: Meeting[Any]) -> Member[Any]:
    """A member as it takes part."""
    return rules.meet.choose(meeting).effect(meeting)  # type: ignore[no-any-return]


def any_beside(given: Given, side: Direction) -> Beside:
    """Anything beside a few."""
    passed, again, lets_go = (
        given.number(f"{what}, on the {side.name.lower()}") for what in ("passed on", "passed on again", "speed")
    )
    given.assume(again <= passed, AGAIN)
    return Beside(passed, again, lets_go)


def any_outer(given: Given, body: int, outside: Direction) -> Member[Any]:
    """Any of two in contact; no wall is between them."""
    wish = given.number(f"wish of {body} to the right") - given.number(f"wish of {body} to the left")
    walls = frozenset({outside}) if given.flag(f"a wall is beside {body}") else frozenset()
    return Member(body, wish, given.flag(f"{body} may push"), walls)


def contacts_that_open_do_nothing(rules: StepRules, given: Given) -> None:
    """Two in contact of which the one on the right is faster go as they would without that contact, and to the rest of
    their row they pass on the same, or at first as well something as nothing.
    """
    left, right = any_outer(given, 0, Direction.LEFT), any_outer(given, 1, Direction.RIGHT)
    beside = {side: any_beside(given, side) for side in Direction}
    nobody = Beside(left.wish * 0, left.wish * 0, None)
    both = few(rules.row, [left, right], beside)
    given.assume(both.velocities[0] < both.velocities[1], OPENS)
    for body, member, side in ((0, left, Direction.LEFT), (1, right, Direction.RIGHT)):
        alone = few(rules.row, [member], {side: beside[side], side.opposite: nobody})
        given.ensure("it goes as it would alone", alone.velocities[0] == both.velocities[body])
        given.ensure("it passes on the same again", alone.again[side] == both.again[side])
        given.ensure("and something if it would alone", (alone.passed[side] > 0) == (both.passed[side] > 0))


def walls_that_are_left_do_nothing(rules: StepRules, given: Given, ahead: Direction) -> None:
    """One that goes away from a wall goes as it would without it."""
    member = any_outer(given, 0, ahead.opposite)
    beside = {ahead: Beside(member.wish * 0, member.wish * 0, None), ahead.opposite: any_beside(given, ahead.opposite)}
    with_it = few(rules.row, [replace(member, walls=member.walls | {ahead})], beside).velocities[0]
    given.assume(with_it * ahead < 0, OPENS)
    without_it = few(rules.row, [replace(member, walls=member.walls - {ahead})], beside).velocities[0]
    given.ensure("it goes as it would without", with_it == without_it)


def what_stands_stays_recorded(rules: StepRules, given: Given) -> None:
    """A contact of two that go as fast, and a wall at which one stands, are still recorded when time has passed."""
    ways = {body: any_way(given, body) for body in (0, 1)}
    contact, wall = Contact(0, 1), AtWall(1, 0, Direction.RIGHT)
    marks: set[Mark] = {contact, wall}
    kept = lasting(ways, marks)
    given.ensure("the contact is kept", contact in kept or negated(ways[0] == ways[1]))
    given.ensure("the wall is kept", wall in kept or negated(ways[1] == 0))
    given.ensure("but not if it opens", contact not in kept or ways[0] >= ways[1])


def who_keeps_up_keeps_its_support(rules: StepRules, given: Given, setting: Setting) -> None:
    """A body that goes as its support does comes no nearer to losing it, however far both go."""
    world = any_world(given, setting)
    below, body = 0, 1
    way = any_way(given, below)
    lost = [one.mark for one in losses(world, {below: way, body: way})]
    given.ensure("it does not come nearer to its loss", seat_of(world, body) not in lost)
    for one in (below, body):
        world.advance(one, way)
    given.ensure("it is held", every([is_held(world, body, way * 0)]))


def what_is_lost_stays_lost(rules: StepRules, given: Given, setting: Setting) -> None:
    """A body that has gone as far relative to its support as that holds it is held no longer, however much further."""
    world, body = any_world(given, setting), 1
    further = given.number("how much further")
    for ahead in Direction:
        gone, room = world.copy(), world.to_loss(body, ahead)
        assert room is not None, "on a line every top ends"
        gone.advance(body, (room + further) * ahead)
        given.ensure("it is not held", negated(every([is_held(gone, body, room * 0)])))
