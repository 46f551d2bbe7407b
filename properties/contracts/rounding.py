"""What roundings do to a request: the contracts of its parts, kept to within a number of roundings.

The rules and the reference world run as they are on numbers of which every sum is rounded, by any error up to a
rounding (`properties/engine/rounded.py`). The state before is known exactly, as it is to whoever judges a log; bodies
may be nearer to each other in it than the margin. What comes of it is held against what the contracts say of that state
in exact numbers. A rounding is the unit of all numbers.
"""

from __future__ import annotations

from collections.abc import Generator
from dataclasses import dataclass, field, replace
from typing import Any

from properties.contracts.contract import REAR, SEGMENT_EXACT, Ahead, Stretch, assume_required, promise
from properties.contracts.request import any_round, seen_by, stand_in
from properties.contracts.strings import GAPS_FIT, border_and_neighbour, level_of, place, world_with
from properties.engine.rounded import Machine, Rounded
from properties.given import Given
from reference.world import Facing, World
from spec.body import EdgePosition, Level
from spec.conditions import EDGES_LONG, IN_ORDER
from spec.graph import Direction
from spec.invariants import equal
from spec.number import greater
from spec.profiles import Profile
from spec.rules.leave import Placement
from spec.rules.push import Way
from spec.rules.request import request
from spec.rules.walk import Motion, walk
from spec.transform import mirror, with_numbers

OF_A_SEGMENT, OF_A_SEGMENT_ON_A_RING, OF_A_WALK = 12, 14, 2
"""How many roundings off a segment is at most, and a walk of one border."""

OF_A_MARGIN, OF_WHAT_IS_NEARER = 5, 2
"""How many roundings nearer than the margin a push on one edge leads, and to a body that was nearer than it before."""

OVER = 3
"""How many roundings a border may go further than was asked; what a request says is rounded once more."""

GOES = "it goes by what it says, and no further than was asked, nearly"
WIDER = "the bodies of a ring are wider than roundings"
LITTLE = 16


@dataclass
class Neighbour:
    """The body ahead, by what its own request does: it moves as far as it can but for `off`, says so but for `astray`.

    When it has been asked, it has `pushed` on by so much, and `says` that it has.
    """

    machine: Machine
    able: Any
    off: Any
    astray: Any
    pushed: Any
    says: Any = 0

    def answers(self, given: Given, asked: Rounded) -> Rounded:
        """What it says that it has moved."""
        says, besides = given.number("distance granted"), given.number("what it has moved besides")
        given.assume(besides <= self.astray * 2, "it has moved by what it says, nearly")
        self.pushed = says + besides - self.astray
        given.assume(says <= asked.held + OVER + 1, "it says no more than was asked, nearly")
        given.assume(self.pushed <= self.able + self.off, "it moves no further than it can, nearly")
        far = (says >= asked.held) | (self.pushed >= self.able - self.off)
        given.assume(far, "it moves by what was asked, or as far as it can, nearly")
        self.says = answer = Rounded(self.machine, says)
        return answer


@dataclass(frozen=True)
class Scene:
    """A body and the one ahead on a string of any length: as it is, and as a machine holds it."""

    machine: Machine
    exact: Facing[Any]
    view: Facing[Any]

    @property
    def reach(self) -> Any:
        """How far it is to the end of the edge."""
        return self.exact.reach(self.exact.front(0))

    def moved(self, after: Motion[Any, EdgePosition[Any]]) -> Any:
        """How far a border has come that began at the front: a motion that goes on is at the end of its edge."""
        start = self.view.front(0).location
        return self.reach if after.going else (after.at.location.held - start.held) * self.view.direction


def any_scene(given: Given, direction: Direction, closed: bool, last: bool) -> Scene:
    """Any body with any other ahead, on edges as long as the margin."""
    machine, free = Machine(given), given.number("free space of the ring")
    level = border_and_neighbour(given, closed, last)
    take_a_margin(given, level)
    for edge in level.graph.edges if closed else level.graph.edges[1:]:
        given.assume(edge.length >= level.margin, EDGES_LONG.id)
    scene = scene_of(machine, level, free, direction)
    if closed:
        exact = scene.exact
        gap, length = exact.gap(exact.front(0), 1), exact.world.rows[0].length
        given.assume((gap <= free) & (gap >= 0), GAPS_FIT)
        given.assume(free + LITTLE <= length, WIDER)
    return scene


def scene_of(machine: Machine, level: Level[Any], free: Any, direction: Direction) -> Scene:
    """What a body sees in a level, or in its mirror image if it goes to the left; of a ring so much is free."""
    exact = world_with(level if direction is Direction.RIGHT else mirror(level), free).facing(direction)
    return Scene(machine, exact, held_by(machine, exact.world, free).facing(direction))


def take_a_margin(given: Given, level: Level[Any]) -> None:
    """Assume that the margin is positive: no proof needs it, but with edges of no length they take twice as long."""
    given.assume(level.margin > 0, "the margin is positive")


def held_by(machine: Machine, exact: World[Any], free: Any) -> World[Any]:
    """A world as a machine holds it: it lays out the edges itself; the order of the bodies is known."""
    level = with_numbers(exact.level, lambda number: Rounded(machine, number), lambda slope: slope)
    world = World(replace(level, bodies=()))
    world.bodies, (row,) = list(level.bodies), world.rows
    row.order, row.place = exact.rows[0].order, exact.rows[0].place
    row.free = Rounded(machine, free) if row.closed else None
    return world


def segment_is_nearly_exact(profile: Profile, given: Given, closed: bool, direction: Direction, last: bool) -> None:
    """With edges as long as the margin, a segment does what it does in exact numbers, but for some roundings.

    A body nearer than the margin counts as if it were the margin away: nothing is free towards it.
    """
    scene = any_scene(given, direction, closed, last)
    spare, before = given.natural("bodies that may still be asked"), any_motion(given, scene)
    ahead, other = ahead_of(given, scene, spare)
    after = ran(profile, given, scene, before, spare, other)
    moved, most = scene.moved(after), OF_A_SEGMENT_ON_A_RING if closed else OF_A_SEGMENT
    stretch = Stretch(
        asked=before.rest.held,
        moved=moved,
        ahead=ahead,
        pushed=other.pushed,
        going=after.going,
        reach=scene.reach,
        capacity=ahead.capacity(),
        left=ahead.after(moved, other.pushed).capacity(),
        tolerance=other.off + other.astray + most,
    )
    promise(given, SEGMENT_EXACT, stretch, SEGMENT_EXACT.ensures)
    goes_by_what_it_says(given, before, after, moved)


def any_motion(given: Given, scene: Scene) -> Motion[Any, EdgePosition[Any]]:
    """A motion from the front of the body, anywhere in its course."""
    return Motion(scene.view.front(0), rest=Rounded(scene.machine, given.number("distance left")))


def ahead_of(given: Given, scene: Scene, spare: Any) -> tuple[Ahead, Neighbour]:
    """What lies ahead of the body, and the one ahead."""
    view, other = scene.exact, any_neighbour(given, scene.machine)
    gap, wall = greater(view.gap(view.front(0), 1), view.margin), view.world.to_wall(0, view.direction)
    return Ahead(view.margin, gap, wall, other.able, spare), other


def any_neighbour(given: Given, machine: Machine) -> Neighbour:
    """Any body ahead; what that is off, and says, is off by any amount."""
    able = given.number("capacity of the neighbour")
    off, astray = given.number("what the neighbour is off"), given.number("what it says is off")
    return Neighbour(machine, able, off, astray, pushed=able * 0)


def ran(
    profile: Profile, given: Given, scene: Scene, before: Motion[Any, Any], spare: Any, other: Neighbour
) -> Motion[Any, EdgePosition[Any]]:
    """The motion after a segment, by the rules of a profile; it asks once at most."""
    running = profile.rules.segment(seen_by(given, profile.rules), scene.view, 0, before, spare)
    try:
        running.send(other.answers(given, next(running).distance))
    except StopIteration as end:
        after: Motion[Any, Any] = end.value
        return after
    raise AssertionError("it asks once at most")


def goes_by_what_it_says(given: Given, before: Motion[Any, Any], after: Motion[Any, Any], moved: Any) -> None:
    """Promise that what is left is less by what has been moved, and is 0 or more, nearly."""
    given.ensure(GOES, equal(before.rest.held - moved, after.rest.held, OF_A_WALK) & (after.rest.held > -OVER))


def walk_is_nearly_exact(
    profile: Profile, given: Given, closed: bool, direction: Direction, last: bool, within: int = OF_A_WALK
) -> None:
    """A walk on an open way, of a rear border or of a front with nobody ahead, leaves nothing out but for roundings."""
    scene = any_scene(given, direction, closed, last)
    before = any_motion(given, scene)
    wall = scene.exact.world.to_wall(0, direction)
    stretch = Stretch(
        asked=before.rest.held, moved=before.rest.held, ahead=Ahead(scene.exact.margin, None, wall, None, 0)
    )
    assume_required(given, REAR, stretch)
    after = walk(seen_by(given, profile.rules).walk, scene.view, before, Way(before.rest, blocked=False))
    moved = scene.moved(after)
    promise(
        given, REAR, replace(stretch, moved=moved, going=after.going, reach=scene.reach, tolerance=within), REAR.ensures
    )
    goes_by_what_it_says(given, before, after, moved)


def push_keeps_the_margin_nearly(
    profile: Profile, given: Given, direction: Direction, apart: int = OF_A_MARGIN, nearer: int = OF_WHAT_IS_NEARER
) -> None:
    """On one edge, whoever pushes comes no nearer to the next body than the margin, or than it was, but for roundings.

    The body ahead goes as far as it says, by a sum of its own.
    """
    machine, margin, length = Machine(given), given.number("margin"), given.number("length of the edge")
    near, far = place(given, "the front", 0, length), place(given, "the body ahead", 0, length)
    given.assume(far.location >= near.location, IN_ORDER.id)
    ends = EdgePosition(0, length * 0), EdgePosition(0, length)
    level = level_of([length], False, margin, (ends[0], near), (far, ends[1]))
    scene = scene_of(machine, level, length, direction)
    gap, facing = scene.exact.gap(scene.exact.front(0), 1), scene.view.rear(1)
    spare, before = given.natural("bodies that may still be asked"), any_motion(given, scene)
    other = any_neighbour(given, machine)
    after = ran(profile, given, scene, before, spare, other)
    gone = (scene.view.along(facing, other.says).location.held - facing.location.held) * direction
    left = gap + gone - scene.moved(after)
    kept = (left >= margin - apart) | (left >= gap - nearer)
    given.ensure("the margin is kept, nearly, or it comes no nearer", kept)


@dataclass
class Bare:
    """A view of a body of which only its borders are seen."""

    placed: list[tuple[Any, Any]] = field(default_factory=list)

    def front(self, body: int) -> str:
        """Its front."""
        return "front"

    def rear(self, body: int) -> str:
        """Its rear."""
        return "rear"

    def place(self, body: int, front: Any, rear: Any) -> None:
        """Note where it is put."""
        self.placed.append((front, rear))


def request_says_nearly_what_it_does(profile: Profile, given: Given, within: int = OF_A_WALK) -> None:
    """What a request says, and what it tows its rear by, is what its segments moved the front by, but for what each of
    them is off, and one rounding more.

    Segments go by what they say (`goes_by_what_it_says`); a walk that nothing stops leaves nothing.
    """
    machine, view, went, tows = Machine(given), Bare(), [given.number("margin") * 0], []
    asked = Rounded(machine, given.number("distance asked"))

    def segments(rules: Any, seen: Any, body: int, motion: Motion[Any, str], spare: Any) -> Generator[Any, Any, Any]:
        yield from ()
        number = len(went)
        going, moved = any_round(given, number)
        rest = Rounded(machine, given.number(f"left after segment {number}") - OVER)
        given.assume(equal(motion.rest.held - moved, rest.held, OF_A_WALK), GOES)
        went.append(went[-1] + moved)
        return Motion("ahead", rest, going)

    def towed(tow: Any) -> str:
        tows.append(tow.moved)
        return "towed"

    def stays(leaving: Any) -> Any:
        return leaving

    parts = {"segment": segments, "follow": stand_in("follow", towed), "leave": stand_in("leave", stays)}
    rules: Any = replace(profile.rules, **parts, depart=lambda *facts: Placement(*facts[3:]))  # type: ignore[arg-type]
    try:
        next(request(rules, view, 0, asked, 0))  # type: ignore[arg-type]
    except StopIteration as end:
        said = end.value
    else:
        raise AssertionError("none but its segments ask")
    off = within * (len(went) - 1) + 1
    given.ensure("it says what it does, nearly", equal(said.held, went[-1], off))
    given.ensure("it tows its rear once", len(tows) == 1)
    for tow in tows:
        given.ensure("it tows its rear by what it says", said is tow)
    given.ensure("it places its borders where they went, once", view.placed == [("ahead", "towed")])
    given.ensure("it says no more than was asked, nearly", said.held <= asked.held + OVER + 1)
