"""What is shown of any member, and of any two in contact, in a row of any length that does not close: the rest of the
row is what it passes on to them, and how fast it lets them go.

`ahead` is the direction of a sweep. Speeds are passed on twice: when it is known who is squeezed, those are held as
between two walls. What is passed on then is no more than before, from body to body.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from properties.given import Given
from spec.graph import Direction
from spec.number import greater
from spec.rules.row import Meeting, Member, RowRules, cut_back, forwards
from spec.rules.step import StepRules

BEHIND, BEYOND = -1, 2
NO_WALL = "no wall is between two in contact"
AGAIN = "what is passed on again is no more than before"


def rest(body: int, speed: Any, ahead: Direction) -> Member[Any]:
    """The rest of a row: it passes a speed on, or lets others go at it."""
    return Member(body, speed * ahead, pushes=True, walls=frozenset())


def reaching(rules: RowRules, passed: Any, row: Sequence[Member[Any]], ahead: Direction) -> list[Any]:
    """The speeds that reach members when one is passed on to the first; and what the last passes on."""
    return forwards(rules, [rest(BEHIND, passed, ahead), *row, rest(BEYOND, passed * 0, ahead)], ahead)[1:]


@dataclass(frozen=True)
class Part:
    """A member as it takes part, and in each direction: the speed that reaches it and what it passes on, and both again
    when it is known who is squeezed.
    """

    member: Member[Any]
    part: Member[Any]
    reached: dict[Direction, Any]
    passed: dict[Direction, Any]
    again: dict[Direction, Any]
    passed_again: dict[Direction, Any]

    @property
    def squeezed(self) -> bool:
        """Whether speeds reach it from both sides."""
        return all(bool(speed > 0) for speed in self.reached.values())


def any_part(rules: RowRules, given: Given) -> Part:
    """Any member of any row that does not close."""
    wish = given.number("wish to the right") - given.number("wish to the left")
    member = Member(0, wish, given.flag("it may push"), walls=frozenset())
    reached, passed, again, passed_again, behind = {}, {}, {}, {}, {}
    for way in Direction:
        behind[way] = given.number(f"passed on to the {way.name.lower()}")
        reached[way], passed[way] = reaching(rules, behind[way], [member], way)
    meeting = Meeting(member, reached[Direction.RIGHT], reached[Direction.LEFT], closed=False)
    part = rules.meet.choose(meeting).effect(meeting)
    for way in Direction:
        less = given.number(f"passed on again to the {way.name.lower()}")
        given.assume(less <= behind[way], AGAIN)
        again[way], passed_again[way] = reaching(rules, less, [part], way)
    return Part(member, part, reached, passed, again, passed_again)


def speeds_meet_once(rules: StepRules, given: Given) -> None:
    """Whoever is squeezed is held as between two walls, and passes nothing on. To anybody else no more comes again, so
    from one side at most, or goes on from it.
    """
    one = any_part(rules.row, given)
    for way in Direction:
        given.ensure("no more is passed on again", one.passed_again[way] <= one.passed[way])
        if one.squeezed:
            given.ensure("it is held", way in one.part.walls)
            given.ensure("it passes nothing on", one.passed_again[way] <= 0)
        else:
            given.ensure("no more reaches it again", one.again[way] <= one.reached[way])
            given.ensure("its own wish does", one.again[way] >= one.member.wish * way)


def any_taking_part(given: Given, body: int, ahead: Direction) -> Member[Any]:
    """Any member as it takes part; one that wishes to go back has no speed of its own."""
    walls = frozenset({ahead}) if given.flag(f"a wall is ahead of {body}") else frozenset()
    return Member(body, given.number(f"own speed of {body}") * ahead, given.flag(f"{body} may push"), walls)


def motion_has_causes(rules: StepRules, given: Given, ahead: Direction) -> None:
    """Of two in contact: a speed reaches the one ahead exactly if it wishes one, or one reaches the one behind, which
    may push. If it moves, and does not wish so much, the one behind may push and is as fast. If the one behind is
    slower than what reaches it, it is at a wall, or the one ahead is no faster, and, if pushed, is slower too.

    Two in contact have no wall between them, but for one that is held, squeezed, as between two walls.
    """
    behind, body = parts = [any_taking_part(given, one, ahead) for one in (0, 1)]
    given.assume(not (behind.pushes and behind.walls), NO_WALL)
    passed, beyond = given.number("passed on to the first"), given.number("speed of what is beyond the second")
    *reached, _ = reaching(rules.row, passed, parts, ahead)
    *left, _ = cut_back(rules.row, [*parts, rest(BEYOND, beyond, ahead)], [*reached, beyond], ahead)
    wish, pushed = body.wish * ahead, behind.pushes and bool(reached[0] > 0)
    given.ensure("who is urged is reached", (reached[1] > 0) == (True if pushed else wish > 0))
    if left[1] > wish:
        given.ensure("the one behind may push", behind.pushes)
        given.ensure("it is as fast", left[0] >= left[1])
    if left[0] < reached[0] and not behind.walls:
        given.ensure("the one ahead is no faster", left[1] <= left[0])
        given.ensure("the one ahead is slower than what reaches it", not behind.pushes or left[1] < reached[1])


def nobody_is_faster_than_all_wish(rules: StepRules, given: Given, ahead: Direction) -> None:
    """Where nobody wishes to go back, or faster than at a speed, nobody is reached by more, or goes back."""
    most, passed, member = given.number("speed of walkers"), given.number("passed on"), any_taking_part(given, 0, ahead)
    given.assume((member.wish * ahead <= most) & (passed <= most), "nobody wishes to be faster, or to go back")
    reached, on = reaching(rules.row, passed, [member], ahead)
    given.ensure("nobody is faster", reached <= greater(most, passed))
    given.ensure("nor passes more on", on <= most)
    for speed in reaching(rules.row, passed * 0, [member], ahead.opposite):
        given.ensure("nobody goes back", speed <= 0)
