"""What is shown of any member of a row that does not close, and of a body and its support, for the argument that steps
come to their end: docs/proofs.md.
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
from spec.rules.step import StepRules, losses
from spec.stepped import is_held
from spec.storeys import seat_of

RAISED = "it wishes no less to go ahead than before, and what comes to it urges it no less to"
AGAIN = "no more comes again than reached it before"


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
    given.assume((again <= reached) & (wish <= reached), AGAIN)
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
