"""What is shown of steps in which one body is driven, or some are one way, and all may push: of any body in a row, with
whoever is behind it and ahead of it, in an arbitrary stretch of a step on a line.

As in `stretches`, the time is its own unit: a velocity is the way that a body goes. All is counted in the direction of
the drive, `ahead`. How far a body may go at most, its *limit*, is the least of its way to the wall and of the room to
the one ahead with the limit of that one; how far it has *wished* is how far its drive or its support has led.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from properties.closed_form import along_row
from properties.contracts.stretches import APART, FIRST, SOUND
from properties.contracts.sweeps import BEYOND, NO_WALL, reaching, rest
from properties.given import Given
from properties.worlds.storeys import Member as Placed, Setting, any_places, any_world
from spec.conditions import STOREYS_START
from spec.graph import Direction
from spec.invariants import every
from spec.number import Truth, lesser
from spec.plane import negated
from spec.rules.row import Meeting, Member, RowRules, cut_back
from spec.rules.step import StepRules
from spec.rules.wish import Urge
from spec.storeys import Drive

ONE_WAY = "all ways are 0 or that of the drive"
LIMITS = "nobody is beyond its limit"
REACHED = "who is reached goes on, unless it is at its limit"
RECURSION = "so far, it is as far as the closed form says"
STILL_BEHIND = "if the one behind has gone and stands, it is still"
STILL_BELOW = "if its wish has led somewhere and leads no further, nobody ahead wishes to go"

STANDS = Drive(Fraction(0))
TWO_ON_TWO = Setting("two on two", (*(Placed(0, STANDS) for _ in range(2)), *(Placed(1, STANDS, 0) for _ in range(2))))


@dataclass(frozen=True)
class Along:
    """A body on its way: how far it has gone, how far it may go, what reaches it, and its way in this stretch."""

    far: Any
    limit: Any
    reached: Any
    way: Any

    @property
    def has_stopped(self) -> Truth:
        """Whether it has gone, and stands."""
        return every([self.far > 0, self.way <= 0])

    def is_still(self, nobody_wishes: Truth) -> Truth:
        """Whether it stands, and is at its limit or nobody ahead wishes to go."""
        return every([self.way <= 0, (self.far >= self.limit) | nobody_wishes])


def implies(premise: Truth, conclusion: Truth) -> Truth:
    """Whether one holds if the other does, without deciding them."""
    return negated(premise) | conclusion  # type: ignore[no-any-return]


def is_least(value: Any, one: Any, other: Any) -> Truth:
    """Whether a number is the lesser of two."""
    return (value <= one) & (value <= other) & ((value >= one) | (value >= other))  # type: ignore[no-any-return]


def as_closed_form(far: Any, limit: Any, wished: Any, pushed: Any) -> Truth:
    """Whether a body is as far as the closed form says, given how far it may go, has wished to, and has been pushed."""
    most = (far >= wished) & (far >= pushed)
    return (far <= limit) & ((far >= limit) | most) & ((far <= wished) | (far <= pushed))  # type: ignore[no-any-return]


def way_of_drive(given: Given) -> Any:
    """The way of the drive in a stretch."""
    return given.number("way of the drive")


def none_or(given: Given, way: Any, name: str) -> Any:
    """No way, or that of the drive."""
    found = given.number(name)
    given.assume((found == 0) | (found == way), ONE_WAY)
    return found


def any_along(given: Given, way: Any, limit: Any, name: str) -> Along:
    """Any body that goes on if it is reached and not at its limit."""
    far, reached, its_way = (
        given.number(f"how far is {name}"),
        none_or(given, way, f"what reaches {name}"),
        none_or(given, way, f"way of {name}"),
    )
    given.assume(implies((reached > 0) & (far < limit), its_way > 0), REACHED)
    return Along(far, limit, reached, its_way)


@dataclass(frozen=True)
class Place:
    """A body between the one behind it and the one ahead, at the beginning of a stretch.

    Nobody behind, or ahead, is as somebody who has stood there since the step began, too far away to count.

    Attributes:
        before, behind: the rooms that there were at the beginning of the step, beyond the margin.
        wall: the way to the wall at the beginning of the step.
        wished: how far it has wished to go.
        wish: the way that it wishes now.
        ahead_wishes: the greatest way that anybody ahead of it in its row wishes now.
    """

    follower: Along
    leader: Along
    behind: Any
    before: Any
    far: Any
    limit: Any
    wall: Any
    wished: Any
    wish: Any
    ahead_wishes: Any


def any_place(given: Given, way: Any) -> Place:
    """Any body in a row whose follower, leader and limit are as they are to be."""
    behind, before, wall = (given.number(name) for name in ("room behind", "room ahead", "way to the wall"))
    leader = any_along(given, way, given.number("limit of the one ahead"), "the one ahead")
    limit, back_limit = given.number("limit"), given.number("limit of the one behind")
    given.assume(is_least(limit, wall, before + leader.limit), LIMITS)
    wall_behind = given.number("way of the one behind to the wall")
    given.assume(wall_behind >= behind + wall, NO_WALL)
    given.assume(is_least(back_limit, wall_behind, behind + limit), LIMITS)
    follower = any_along(given, way, back_limit, "the one behind")
    far = given.number("how far")
    given.assume(follower.far - far <= behind, APART)
    wish, others = none_or(given, way, "wish"), none_or(given, way, "wish of others ahead")
    return Place(follower, leader, behind, before, far, limit, wall, given.number("wished"), wish, others)


def assume_so_far(given: Given, one: Place) -> None:
    """What holds of a body at the beginning of a stretch."""
    given.assume(as_closed_form(one.far, one.limit, one.wished, one.follower.far - one.behind), RECURSION)
    nobody_wishes = (one.wish <= 0) & (one.ahead_wishes <= 0)
    given.assume(implies(one.follower.has_stopped, one.follower.is_still(nobody_wishes)), STILL_BEHIND)
    given.assume(implies((one.wished > 0) & (one.wish <= 0), one.ahead_wishes <= 0), STILL_BELOW)


def way_by_rules(rules: RowRules, given: Given, one: Place, ahead: Direction) -> Along:
    """How a body goes by the rules: what reaches it, and its way."""
    touched = given.flag("the contact with the one behind is recorded")
    touches = given.flag("the contact with the one ahead is recorded")
    at_wall = given.flag("it is recorded to be at the wall")
    given.assume(not touched or one.follower.far - one.behind == one.far, SOUND)
    given.assume(not touches or one.far - one.before >= one.leader.far, SOUND)
    given.assume(not at_wall or one.far == one.wall, SOUND)
    member = Member(0, one.wish * ahead, pushes=True, walls=frozenset({ahead}) if at_wall else frozenset())
    part = taking_part(rules, given, member, one.follower.reached if touched else one.wish * 0, ahead)
    reached, passed = reaching(rules, one.follower.reached if touched else one.wish * 0, [part], ahead)
    given.assume(not touches or implies(passed > 0, one.leader.reached > 0), REACHED)
    row, speeds = [part], [reached]
    if touches:
        row, speeds = [part, rest(BEYOND, one.leader.way, ahead)], [reached, one.leader.way]
    return Along(one.far, one.limit, reached, cut_back(rules, row, speeds, ahead)[0])


def taking_part(rules: RowRules, given: Given, member: Member[Any], passed: Any, ahead: Direction) -> Member[Any]:
    """A member as it takes part; nothing comes to it from ahead, and nothing goes on from it backwards."""
    reached, _ = reaching(rules, passed, [member], ahead)
    back, on = reaching(rules, passed * 0, [member], ahead.opposite)
    given.ensure("nobody goes back", back <= 0)
    given.ensure("nothing is passed on backwards", on <= 0)
    right, left = (reached, back) if ahead is Direction.RIGHT else (back, reached)
    meeting = Meeting(member, right, left, closed=False)
    return rules.meet.choose(meeting).effect(meeting)  # type: ignore[no-any-return]


def bodies_go_as_far_as_they_may(rules: StepRules, given: Given, ahead: Direction) -> None:
    """Any body goes on exactly if it is reached and is not at its limit. If it was as far as the closed form says, then
    it is when the stretch ends.

    A body is *still* if it stands, and is at its limit or nobody ahead wishes to go. Who has gone and stands is still,
    and the next one of who is still. So ahead of one that has gone and stands, all of its row stand.
    """
    way = way_of_drive(given)
    one = any_place(given, way)
    assume_so_far(given, one)
    goes = way_by_rules(rules.row, given, one, ahead)
    given.assume(one.leader.far + one.leader.way <= one.leader.limit, LIMITS)
    given.assume(one.follower.way - goes.way <= one.far + one.behind - one.follower.far, FIRST)
    given.assume(goes.way - one.leader.way <= one.leader.far + one.before - one.far, FIRST)
    given.assume(goes.way <= one.wall - one.far, FIRST)
    given.ensure("all ways are 0 or that of the drive", (goes.way == 0) | (goes.way == way))
    reached = (goes.reached > 0) & (one.far < one.limit)
    given.ensure("it goes if it is reached and is not at its limit", implies(reached, goes.way > 0))
    given.ensure("else it stands", implies(negated(reached), goes.way <= 0))
    pushed = one.follower.far + one.follower.way - one.behind
    after = as_closed_form(one.far + goes.way, one.limit, one.wished + one.wish, pushed)
    given.ensure("it is as far as the closed form says", after)
    still = goes.is_still(one.ahead_wishes <= 0)
    given.ensure("who has gone and stands is still", implies(goes.has_stopped, still))
    ahead_of_follower = (one.wish <= 0) & (one.ahead_wishes <= 0)
    given.ensure("ahead of one that is still, it is still", implies(one.follower.is_still(ahead_of_follower), still))


def wishes_go_one_way(rules: StepRules, given: Given) -> None:
    """Who is driven in the plane, or on what stands, wishes its drive. Anybody else wishes what its support does, or
    nothing if that is meant in the plane. Where one is driven, its support stands, since nobody below wishes to go.
    """
    way, driven, relative = way_of_drive(given), given.flag("it is driven"), given.flag("relative to the support")
    carried = way * 0 if driven and relative else none_or(given, way, "way of its support")
    urge = Urge(0, Drive(way if driven else way * 0, relative), carried)
    wish = rules.wish.choose(urge).effect(urge)
    given.ensure(
        "it wishes its drive, or what its support does", wish == (way if driven else carried if relative else 0)
    )


def supports_are_in_order(rules: StepRules, given: Given, setting: Setting) -> None:
    """Of two bodies on a storey that stand on two others, the one on the right does not stand on the one on the left of
    the other's support.
    """
    world: Any = any_places(given, setting)
    for body in (2, 3):
        world.stand(body, 1 if given.flag(f"{body} stands on the one on the right") else 0)
    given.assume(STOREYS_START.holds(world, world.margin), STOREYS_START.id)
    given.ensure("they are in order", world.support(2) <= world.support(3))


def no_wall_is_between(rules: StepRules, given: Given, setting: Setting) -> None:
    """Of two neighbours, the one ahead is nearer to the wall ahead of both by the gap, and by what it takes itself."""
    world: Any = any_world(given, setting)
    for left, right in world.neighbours():
        for one, other, ahead in ((left, right, Direction.RIGHT), (right, left, Direction.LEFT)):
            far, near = world.to_wall(one, ahead), world.to_wall(other, ahead)
            given.ensure("no wall is between them", far >= world.gap(left, right) + world.places[other].width + near)


def sums_are_the_closed_form(rules: StepRules, given: Given) -> None:
    """Of three in a row, what cumulative operations say of the one in the middle is what the closed form says of it.

    The first stands for all that is pushed on from behind, the last for all that walls ahead allow. Where nobody has
    wished to go, nobody has gone: so it is when a step begins.
    """
    wishes, walls = ([given.number(f"{name} {body}") for body in range(3)] for name in ("wish of", "wall of"))
    rooms = [given.number(f"room ahead of {body}") for body in range(2)]
    for one in range(2):
        given.assume(walls[one] >= rooms[one] + walls[one + 1], NO_WALL)
    limit = lesser(walls[1], rooms[1] + walls[2])
    for ahead in Direction:
        found = along_row(wishes, rooms, walls, ahead)
        given.ensure("they agree", as_closed_form(found[1], limit, wishes[1], found[0] - rooms[0]))
        given.ensure("on the last too", as_closed_form(found[2], walls[2], wishes[2], found[1] - rooms[1]))
        nobody = every(wish <= 0 for wish in wishes)
        given.ensure("at first nobody has gone", implies(nobody, every(far == 0 for far in found)))
