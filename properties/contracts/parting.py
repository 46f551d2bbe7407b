"""What is shown of a row whose bodies part: as soon as they have, velocities are what they were, though nothing is
passed on between them any more. Of any two in contact that part, of any member beyond, of any that leaves a wall.

`ahead` is the direction away from where the row parts; `back` is the other. Two rows are compared: the whole one, and
what is ahead of the place by itself. The rest of a row is what it passes on, and how fast it lets others go. Speeds are
passed on twice, the second time when it is known who is squeezed.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from properties.contracts.steps import any_member
from properties.contracts.stretches import any_way
from properties.contracts.sweeps import AGAIN, BEYOND, reaching, rest
from properties.given import Given
from spec.graph import Direction
from spec.rules.row import Meeting, Member, RowRules, cut_back
from spec.rules.step import StepRules

PART = "they part"
LEAVES = "it leaves the wall"
LINKED = "what is newly passed on meets nothing"


@dataclass(frozen=True)
class Rest:
    """What the rest of a row does to some members: what it passes on to them, first and again, ahead and back, and the
    speed of what is in contact before and behind them, or None if nothing is.
    """

    ahead: Any
    ahead_again: Any
    back: Any
    back_again: Any
    before: Any
    behind: Any


@dataclass(frozen=True)
class Found:
    """What members of a row do: what they pass on to the rest, first and again, ahead and back; and the speeds of each
    ahead and back, from behind.
    """

    ahead: Any
    ahead_again: Any
    back: Any
    back_again: Any
    speeds: list[tuple[Any, Any]]

    def velocity(self, member: int) -> Any:
        """The velocity of a member, positive ahead."""
        return self.speeds[member][0] - self.speeds[member][1]


def found(rules: RowRules, row: Sequence[Member[Any]], others: Rest, ahead: Direction) -> Found:
    """What some members do, given from behind."""
    *reached, on = reaching(rules, others.ahead, row, ahead)
    *reached_back, back = reaching(rules, others.back, row[::-1], ahead.opposite)
    each = zip(row, reached, reached_back[::-1], strict=True)
    parts = [part(rules, member, {ahead: speed, ahead.opposite: speed_back}) for member, speed, speed_back in each]
    *again, on_again = reaching(rules, others.ahead_again, parts, ahead)
    *again_back, back_again = reaching(rules, others.back_again, parts[::-1], ahead.opposite)
    left = cut(rules, parts, again, others.before, ahead)
    left_back = cut(rules, parts[::-1], again_back, others.behind, ahead.opposite)[::-1]
    return Found(on, on_again, back, back_again, list(zip(left, left_back, strict=True)))


def part(rules: RowRules, member: Member[Any], to: Mapping[Direction, Any]) -> Member[Any]:
    """A member as it takes part, when speeds reach it in each direction; the row does not close."""
    meeting = Meeting(member, to[Direction.RIGHT], to[Direction.LEFT], closed=False)
    taken: Member[Any] = rules.meet.choose(meeting).effect(meeting)
    return taken


def cut(rules: RowRules, row: list[Member[Any]], speeds: list[Any], beyond: Any | None, way: Direction) -> list[Any]:
    """The speeds when ways have been looked at, where something or nothing is in contact beyond."""
    if beyond is None:
        return cut_back(rules, row, speeds, way)
    return cut_back(rules, [*row, rest(BEYOND, beyond, way)], [*speeds, beyond], way)[:-1]


def any_rest(given: Given) -> Rest:
    """Any rest of a row on both sides."""
    ahead, again = given.number("passed on ahead"), given.number("passed on ahead again")
    back, back_again = given.number("passed on back"), given.number("passed on back again")
    given.assume((again <= ahead) & (back_again <= back), AGAIN)
    return Rest(ahead, again, back, back_again, given.number("speed of what is before"), given.number("speed behind"))


def ensure_equal(given: Given, name: str, whole: Any, apart: Any) -> None:
    """Promise that a speed is the same in the whole row and apart."""
    given.ensure(name, whole == apart)


def ensure_alike(given: Given, whole: Found, apart: Found) -> None:
    """Promise that the last member of a whole row is as fast, and passes on as much, as by itself."""
    ensure_equal(given, "it is as fast ahead", whole.speeds[-1][0], apart.speeds[0][0])
    ensure_equal(given, "it is as fast back", whole.speeds[-1][1], apart.speeds[0][1])
    ensure_equal(given, "it passes on the same again", whole.ahead_again, apart.ahead_again)


def ensure_linked(given: Given, whole: Found, apart: Found, back: Any) -> None:
    """Promise that no less is passed on in the whole row, and that if something is that else was not, nothing comes
    back to meet it, and its last member does not go back.
    """
    given.ensure("no less is passed on", whole.ahead >= apart.ahead)
    if whole.ahead > 0 and apart.ahead <= 0:
        given.ensure("nothing comes back to meet it", back <= 0)
        given.ensure("nor does who passes it on", apart.speeds[-1][1] <= 0)


def any_beside(given: Given, body: int, side: Direction, pushes: bool) -> Member[Any]:
    """Any member of a row with no wall on one side; on the other side there may be one."""
    walls = frozenset({side} if given.flag(f"a wall is beside {body}") else ())
    return Member(body, any_way(given, body), pushes, walls)


def who_part_are_as_fast(rules: StepRules, given: Given, ahead: Direction, pushing: Collection[int]) -> None:
    """Of any two in contact that part, of whom some may push, the one ahead is as fast without the one behind."""
    sides = (ahead.opposite, ahead)
    row = [any_beside(given, body, side, body in pushing) for body, side in enumerate(sides)]
    others = any_rest(given)
    whole = found(rules.row, row, others, ahead)
    given.assume(whole.velocity(0) < whole.velocity(1), PART)
    nothing = others.ahead * 0
    apart = found(rules.row, row[1:], replace(others, ahead=nothing, ahead_again=nothing, behind=None), ahead)
    ensure_alike(given, whole, apart)
    ensure_linked(given, whole, apart, others.back)


def who_is_beyond_is_as_fast(rules: StepRules, given: Given, ahead: Direction) -> None:
    """Any member further ahead is as fast, and passes on the same again in both directions, though less may be passed
    on to it at first.
    """
    member, others, less = any_member(given, 0), any_rest(given), given.number("passed on ahead without those behind")
    given.assume(less <= others.ahead, LINKED)
    given.assume(others.ahead_again <= less, AGAIN)
    whole, apart = (found(rules.row, [member], one, ahead) for one in (others, replace(others, ahead=less)))
    if less <= 0 < others.ahead:
        given.assume((whole.back <= 0) & (others.behind <= 0), LINKED)
    ensure_alike(given, whole, apart)
    ensure_equal(given, "it passes back the same again", whole.back_again, apart.back_again)
    ensure_linked(given, whole, apart, others.back)


def who_leaves_a_wall_is_as_fast(rules: StepRules, given: Given, ahead: Direction) -> None:
    """Any member that moves away from a wall is as fast without it."""
    member, others = any_beside(given, 0, ahead.opposite, given.flag("it may push")), any_rest(given)
    whole = found(rules.row, [replace(member, walls=member.walls | {ahead})], others, ahead)
    given.assume(whole.velocity(0) < 0, LEAVES)
    apart = found(rules.row, [member], others, ahead)
    ensure_alike(given, whole, apart)
    ensure_equal(given, "it passes back the same again", whole.back_again, apart.back_again)
