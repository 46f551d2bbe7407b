"""Row: the velocities of bodies in contact, found from their wishes.

A row is a longest chain of neighbours in contact on one storey. Wishes are passed on forwards, in either direction by
one text; whoever gets both is squeezed; then speeds are cut back from the front to what is ahead.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Generic

from spec.graph import Direction
from spec.number import N, Truth, greater, zero_like
from spec.rule import AnyFamily, Chooser, Family, Rule


@dataclass(frozen=True)
class Member(Generic[N]):
    """A body in a row: the velocity that it wishes, whether it may push, and on which sides a wall is in contact."""

    body: int
    wish: N
    pushes: bool
    walls: frozenset[Direction]


@dataclass(frozen=True)
class Turn(Generic[N]):
    """A body's own speed in a direction, at least 0, and the speed that the one behind it passes on."""

    body: int
    own: N
    passed: N


def as_fast_itself(turn: Turn[N]) -> Truth:
    """It is as fast as what is passed on, or faster."""
    return turn.own >= turn.passed


def pushed_faster(turn: Turn[N]) -> Truth:
    """What is passed on is faster."""
    return turn.own < turn.passed


def its_own(turn: Turn[N]) -> N:
    """Its own speed."""
    return turn.own


def what_is_passed(turn: Turn[N]) -> N:
    """The speed passed on."""
    return turn.passed


FORWARD: AnyFamily = Family(
    "forward",
    (
        Rule(
            id="row/own",
            sentence="A body that is as fast as what pushes it, or that nothing pushes, has its own speed.",
            source="6.2.1c; R20, A3",
            guard=(as_fast_itself,),
            effect=its_own,
        ),
        Rule(
            id="row/pushed",
            sentence="A body in contact takes over a greater speed from the one behind it.",
            source="4.2, 6.2.1c; R6, R20",
            guard=(pushed_faster,),
            effect=what_is_passed,
        ),
    ),
)


@dataclass(frozen=True)
class Relay(Generic[N]):
    """The speed that a body has in a direction, and whether it may push."""

    body: int
    speed: N
    pushes: bool


def may_push(relay: Relay[N]) -> Truth:
    """The body may push others."""
    return relay.pushes


def may_not_push(relay: Relay[N]) -> Truth:
    """The body may not push others, or is squeezed."""
    return not relay.pushes


def the_same(relay: Relay[N]) -> N:
    """The same speed."""
    return relay.speed


def no_speed(relay: Relay[N]) -> N:
    """Nothing."""
    return zero_like(relay.speed)


PASS: AnyFamily = Family(
    "pass",
    (
        Rule(
            id="row/passes-on",
            sentence="A body passes its speed on to the next one in contact ahead, however many follow.",
            source="4.2, 6.2.1c; R6, R20",
            guard=(may_push,),
            effect=the_same,
        ),
        Rule(
            id="row/passes-nothing",
            sentence="A body that may not push, or that is squeezed, passes nothing on.",
            source="1.1; A39",
            guard=(may_not_push,),
            effect=no_speed,
        ),
    ),
)


@dataclass(frozen=True)
class Meeting(Generic[N]):
    """What reaches a member of a row from the left (`right`, a speed to the right) and from the right, and whether
    the row closes on itself round a ring.
    """

    member: Member[N]
    right: N
    left: N
    closed: bool

    @property
    def body(self) -> int:
        """The member."""
        return self.member.body


def not_closed(meeting: Meeting[N]) -> Truth:
    """The row does not close on itself."""
    return not meeting.closed


def closes_on_itself(meeting: Meeting[N]) -> Truth:
    """The row goes round a ring and closes on itself."""
    return meeting.closed


def from_both_sides(meeting: Meeting[N]) -> Truth:
    """Speeds meet in it."""
    zero = zero_like(meeting.right)
    return (meeting.right > zero) & (meeting.left > zero)  # type: ignore[no-any-return]


def from_one_side(meeting: Meeting[N]) -> Truth:
    """At most one speed reaches it."""
    zero = zero_like(meeting.right)
    return (meeting.right <= zero) | (meeting.left <= zero)  # type: ignore[no-any-return]


def takes_part(meeting: Meeting[N]) -> Member[N]:
    """It moves as it may."""
    return meeting.member


def stands_still(meeting: Meeting[N]) -> Member[N]:
    """It wishes nothing and passes nothing on, and is held on both sides as if walls were there."""
    return replace(meeting.member, wish=zero_like(meeting.right), pushes=False, walls=frozenset(Direction))


MEET: AnyFamily = Family(
    "meet",
    (
        Rule(
            id="row/one-way",
            sentence="A body that speeds reach from one side at most takes part in the motion of its row.",
            source="6.2.1c; R20",
            guard=(not_closed, from_one_side),
            effect=takes_part,
        ),
        Rule(
            id="row/squeezed",
            sentence="A body that speeds reach from both sides is squeezed: it stands still, whatever the speeds, as "
            "between two walls, and passes nothing on.",
            source="6.2.1c; R20, A2",
            guard=(not_closed, from_both_sides),
            effect=stands_still,
        ),
        Rule(
            id="row/ring",
            sentence="A row of two bodies or more that closes on itself stands still.",
            source="4.2; R31, A7",
            guard=(closes_on_itself,),
            effect=stands_still,
        ),
    ),
)


@dataclass(frozen=True)
class Way(Generic[N]):
    """A speed in a direction, whether a wall is in contact there, and the speed of the body in contact ahead.

    The speed ahead is at least 0; None if there is no body in contact.
    """

    body: int
    speed: N
    wall: bool
    ahead: N | None


def no_wall(way: Way[N]) -> Truth:
    """No wall is in contact."""
    return not way.wall


def wall_ahead(way: Way[N]) -> Truth:
    """A wall is in contact."""
    return way.wall


def nobody_slower(way: Way[N]) -> Truth:
    """No body in contact ahead is slower."""
    return True if way.ahead is None else way.speed <= way.ahead


def slower_ahead(way: Way[N]) -> Truth:
    """A slower body is in contact ahead."""
    return False if way.ahead is None else way.speed > way.ahead


def full_speed(way: Way[N]) -> N:
    """The speed."""
    return way.speed


def standstill(way: Way[N]) -> N:
    """No speed."""
    return zero_like(way.speed)


def speed_ahead(way: Way[N]) -> N:
    """The speed of what is ahead."""
    assert way.ahead is not None
    return way.ahead


WAY: AnyFamily = Family(
    "way",
    (
        Rule(
            id="way/open",
            sentence="A body whose way no wall and no slower body shuts moves at its speed.",
            source="6.2.1a; R18",
            guard=(no_wall, nobody_slower),
            effect=full_speed,
        ),
        Rule(
            id="way/wall",
            sentence="A body does not move on at a wall.",
            source="6.2.1b; R19",
            guard=(wall_ahead,),
            effect=standstill,
        ),
        Rule(
            id="way/slower",
            sentence="A body moves no faster than the body in contact ahead of it.",
            source="6.2.1c; R20, R24",
            guard=(no_wall, slower_ahead),
            effect=speed_ahead,
        ),
    ),
)


@dataclass(frozen=True)
class RowRules:
    """The families that decide the velocities of a row."""

    forward: Chooser
    relay: Chooser
    meet: Chooser
    way: Chooser


def forwards(rules: RowRules, row: Sequence[Member[N]], direction: Direction) -> list[N]:
    """The speed in a direction that reaches each member; the row is given from behind to the front."""
    speeds, passed = [], zero_like(row[0].wish)
    for member in row:
        turn = Turn(member.body, greater(member.wish * direction, zero_like(passed)), passed)
        relay = Relay(member.body, rules.forward.choose(turn).effect(turn), member.pushes)
        speeds.append(relay.speed)
        passed = rules.relay.choose(relay).effect(relay)
    return speeds


def both_ways(rules: RowRules, row: Sequence[Member[N]]) -> list[tuple[N, N]]:
    """What reaches each member from the left and from the right."""
    right = forwards(rules, row, Direction.RIGHT)
    left = forwards(rules, row[::-1], Direction.LEFT)[::-1]
    return list(zip(right, left, strict=True))


def cut_back(rules: RowRules, row: Sequence[Member[N]], speeds: Sequence[N], direction: Direction) -> list[N]:
    """The speed of each member when its way is looked at, from the front backwards; as given, from behind."""
    found: list[N] = []
    for member, speed in zip(row[::-1], speeds[::-1], strict=True):
        way = Way(member.body, speed, direction in member.walls, found[-1] if found else None)
        found.append(rules.way.choose(way).effect(way))
    return found[::-1]


def velocities(rules: RowRules, row: Sequence[Member[N]], closed: bool) -> list[N]:
    """The velocities of the members of a row, given and returned from left to right."""
    meetings = [
        Meeting(member, right, left, closed) for member, (right, left) in zip(row, both_ways(rules, row), strict=True)
    ]
    parts = [rules.meet.choose(meeting).effect(meeting) for meeting in meetings]
    speeds = both_ways(rules, parts)
    right = cut_back(rules, parts, [speed for speed, _ in speeds], Direction.RIGHT)
    left = cut_back(rules, parts[::-1], [speed for _, speed in speeds[::-1]], Direction.LEFT)[::-1]
    return [to_right - to_left for to_right, to_left in zip(right, left, strict=True)]
