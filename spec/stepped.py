"""Invariants of a step: what holds while all bodies move at once on storeys. They know worlds, not rules.

A step is a sequence of stretches. In each of them nobody changes its velocity; at its end bodies may find another
support. Where bodies are is looked at in coordinates, not by what a world says of gaps.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations
from typing import Any, Generic

from spec.graph import Direction
from spec.invariants import Relation, equal, every
from spec.number import N, Truth, greater, zero_like
from spec.plane import negated
from spec.storeys import Drive, Interval, Survey, short_way

FEW = 3
"""The bound on instants that holds where it was tried speaks of so many bodies at most: of four there is none."""


@dataclass(frozen=True)
class Stretch(Generic[N]):
    """A while in which all velocities stay: the world at its beginning, and at its end when all have settled.

    Attributes:
        lasted: how long it was, 0 or more.
        velocities: of all bodies, positive to the right.
        drives: those of the step.
        tolerance: 0 on exact numbers; how far a float world may be off.
    """

    before: Survey[N]
    after: Survey[N]
    lasted: N
    velocities: Mapping[int, N]
    drives: Mapping[int, Drive[N]]
    tolerance: N

    def carried(self, body: int) -> N:
        """The velocity of a body's support; the ground stands still."""
        support = self.before.support(body)
        return zero_like(self.tolerance) if support is None else self.velocities[support]

    def wish(self, body: int) -> N:
        """The velocity that a body would have if nothing were in its way."""
        drive = self.drives[body]
        return drive.speed + self.carried(body) if drive.relative else drive.speed

    @cached_property
    def contacts(self) -> dict[tuple[int, Direction], int]:
        """Who is ahead of a body, in contact with it, in a direction."""
        world = self.before
        pairs = [pair for pair in world.neighbours() if world.gap(*pair) <= world.margin + self.tolerance]
        return {(left, Direction.RIGHT): right for left, right in pairs} | {
            (right, Direction.LEFT): left for left, right in pairs
        }

    def at_wall(self, body: int, direction: Direction) -> bool:
        """Whether a wall stops a body in a direction."""
        room = self.before.to_wall(body, direction)
        return room is not None and bool(room <= self.tolerance)


@dataclass(frozen=True)
class Course(Generic[N]):
    """One step and what came of it: its stretches, one after another."""

    stretches: tuple[Stretch[N], ...]

    @property
    def before(self) -> Survey[N]:
        """The world at the beginning of the step."""
        return self.stretches[0].before

    @property
    def after(self) -> Survey[N]:
        """The world at its end."""
        return self.stretches[-1].after

    @property
    def led(self) -> N:
        """How far all drives lead, together."""
        first = self.stretches[0]
        far = zero_like(first.tolerance)
        for one in self.stretches:
            for drive in one.drives.values():
                for direction in Direction:
                    far = far + greater(drive.speed * direction, zero_like(drive.speed)) * one.lasted
        return far

    @property
    def lasting(self) -> list[Stretch[N]]:
        """The stretches in which time passes; in floats, more than a rest that is left by rounding."""
        return [one for one in self.stretches if one.lasted > one.tolerance]


@dataclass(frozen=True)
class StepInvariant:
    """A property of every step: its sentence, its source, and the predicate that decides it."""

    id: str
    sentence: str
    source: str
    holds: Callable[[Course[Any]], Truth]

    kind = "invariant"


def some(truths: Iterable[Truth]) -> Truth:
    """Whether one of them holds, without deciding one after another."""
    result: Any = False
    for truth in truths:
        result = result | truth
    return result  # type: ignore[no-any-return]


def bodies_of(world: Survey[Any]) -> list[int]:
    """All bodies."""
    return [body for storey in world.storeys() for body in world.row(storey)]


def images(world: Survey[N], span: Interval[N]) -> list[Interval[N]]:
    """What is there and, on a ring, its images once round to either side."""
    round_ = world.circumference
    shifts = [zero_like(span.left)] if round_ is None else [round_ * -1, zero_like(span.left), round_]
    return [Interval(span.left + by, span.right + by) for by in shifts]


def apart(one: Interval[N], other: Interval[N], distance: N) -> Truth:
    """Whether two are at least a distance apart."""
    return (one.right + distance <= other.left) | (other.right + distance <= one.left)  # type: ignore[no-any-return]


def meet(one: Interval[N], other: Interval[N], distance: N) -> Truth:
    """Whether two overlap, or are less than a distance apart."""
    return (one.right + distance > other.left) & (other.right + distance > one.left)  # type: ignore[no-any-return]


def between(wall: Interval[N], one: Interval[N], other: Interval[N], tolerance: N) -> Truth:
    """Whether a wall is between two."""
    one_left = (one.right <= wall.left + tolerance) & (wall.right <= other.left + tolerance)
    other_left = (other.right <= wall.left + tolerance) & (wall.right <= one.left + tolerance)
    return one_left | other_left  # type: ignore[no-any-return]


def pairs_on_storeys(world: Survey[N]) -> Iterator[tuple[int, Interval[N], Interval[N]]]:
    """Each two bodies on one storey, with the storey; on a ring the second one also as its images."""
    for storey in world.storeys():
        for one, other in combinations(world.row(storey), 2):
            for image in images(world, world.span(other)):
                yield storey, world.span(one), image


def margins_kept(world: Survey[N], tolerance: N) -> Truth:
    """Bodies on one storey are the margin apart, or terrain is between them."""
    walls = {
        storey: [image for solid in world.solid(storey) for image in images(world, solid)] for storey in world.storeys()
    }
    return every(
        apart(one, other, world.margin - tolerance)
        | some(between(wall, one, other, tolerance) for wall in walls[storey])
        for storey, one, other in pairs_on_storeys(world)
    )


def outside_terrain(world: Survey[N], tolerance: N) -> Truth:
    """No body is in terrain, or beyond the ends of a line."""
    truths, ends = [], world.ends
    for body in bodies_of(world):
        span = world.span(body)
        for solid in world.solid(world.storey(body)):
            truths += [apart(span, image, zero_like(tolerance) - tolerance) for image in images(world, solid)]
        if ends is not None:
            truths.append((span.left >= ends.left - tolerance) & (span.right <= ends.right + tolerance))
    return every(truths)


def all_held(world: Survey[N], tolerance: N) -> Truth:
    """Every body is held by the support that it names."""
    return every(is_held(world, body, tolerance) for body in bodies_of(world))


def is_held(world: Survey[N], body: int, tolerance: N) -> Truth:
    """Whether a body is over the ground of its storey if it names that, else beside or over the body that it names."""
    storey, support, span = world.storey(body), world.support(body), world.span(body)
    if support is not None:
        near = some(meet(span, image, world.margin + tolerance) for image in images(world, world.span(support)))
        return near if world.storey(support) == storey - 1 else False
    if not storey:
        return True
    return some(meet(span, ground, tolerance) for ground in grounds(world, storey))


def keeps_margin(course: Course[N]) -> Truth:
    """At all times."""
    return every(margins_kept(one.after, one.tolerance) for one in course.stretches)


def enters_no_terrain(course: Course[N]) -> Truth:
    """At the end of each stretch, and on the way there."""
    return every(
        outside_terrain(one.after, one.tolerance) & every(sweeps_clear(one, body) for body in bodies_of(one.before))
        for one in course.stretches
    )


def sweeps_clear(stretch: Stretch[N], body: int) -> Truth:
    """Whether a body does not come through terrain on its way."""
    world, span, zero = stretch.before, stretch.before.span(body), zero_like(stretch.tolerance)
    by = stretch.velocities[body] * stretch.lasted
    solids = [image for solid in world.solid(world.storey(body)) for image in images(world, solid)]
    return every(not_passed(span, solid, by, zero, stretch.tolerance) for solid in solids)


def not_passed(one: Interval[N], other: Interval[N], by: N, other_by: N, tolerance: N) -> Truth:
    """Whether one, moving by a distance, does not come past another on its right that moves as well, or the reverse."""
    nearer = by - other_by
    on_right = (other.left < one.right - tolerance) | (nearer <= other.left - one.right + tolerance)
    on_left = (one.left < other.right - tolerance) | (nearer + tolerance >= other.right - one.left)
    return on_right & on_left  # type: ignore[no-any-return]


def supported(course: Course[N]) -> Truth:
    """At all times."""
    return every(all_held(one.after, one.tolerance) for one in course.stretches)


def order_kept(course: Course[N]) -> Truth:
    """No two bodies on a storey pass each other."""
    return every(nobody_passes(one) for one in course.stretches)


def nobody_passes(stretch: Stretch[N]) -> Truth:
    """Whether no two bodies on a storey pass each other in a stretch."""
    world, by = stretch.before, {b: speed * stretch.lasted for b, speed in stretch.velocities.items()}
    return every(
        not_passed(world.span(one), image, by[one], by[other], stretch.tolerance)
        for storey in world.storeys()
        for one, other in combinations(world.row(storey), 2)
        for image in images(world, world.span(other))
    )


def moves_as_told(course: Course[N]) -> Truth:
    """In each stretch, every border moves by the velocity times the time."""
    return every(moved_by_velocity(one, body) for one in course.stretches for body in bodies_of(one.before))


def moved_by_velocity(stretch: Stretch[N], body: int) -> Truth:
    """Whether both borders of a body have moved by its velocity times the time; on a ring, up to whole rounds."""
    start, end = stretch.before.span(body), stretch.after.span(body)
    by = stretch.velocities[body] * stretch.lasted
    return every(
        equal(short_way(now - then - by, stretch.after.circumference), zero_like(by), stretch.tolerance)
        for then, now in ((start.left, end.left), (start.right, end.right))
    )


def nobody_raised(course: Course[N]) -> Truth:
    """No body ends a stretch on a higher storey."""
    return every(one.after.storey(body) <= one.before.storey(body) for one in course.stretches for body in one.drives)


def bystanders_stay(course: Course[N]) -> Truth:
    """Whoever moves is moved by itself, by its support, or from behind."""
    return every(has_cause(one, body) for one in course.lasting for body in one.drives)


def has_cause(stretch: Stretch[N], body: int) -> bool:
    """Whether a body that moves wishes it, or one behind it that is in contact and may push is as fast."""
    velocity = stretch.velocities[body]
    for direction in Direction:
        speed = velocity * direction - stretch.tolerance
        if speed > zero_like(speed) and stretch.wish(body) * direction < speed:
            behind = stretch.contacts.get((body, direction.opposite))
            if behind is None or not stretch.before.pushes(behind):
                return False
            if stretch.velocities[behind] * direction < speed:
                return False
    return True


def progress_made(course: Course[N]) -> Truth:
    """Whoever is slower than it wishes is blocked."""
    return every(
        is_as_fast(one, body, direction) or is_blocked(one, body, direction)
        for one in course.lasting
        for body in one.drives
        for direction in Direction
    )


def is_as_fast(stretch: Stretch[N], body: int, direction: Direction) -> bool:
    """Whether a body moves in a direction as fast as it wishes, if it wishes to."""
    wish = stretch.wish(body) * direction
    return bool(wish <= zero_like(wish)) or bool(stretch.velocities[body] * direction >= wish - stretch.tolerance)


def is_blocked(stretch: Stretch[N], body: int, direction: Direction) -> bool:
    """Whether a row, each as slow as the one behind, reaches from a body to what may block it, or round to itself."""
    for _ in stretch.drives:
        ahead = stretch.contacts.get((body, direction))
        if stretch.at_wall(body, direction) or is_squeezed(stretch, body):
            return True
        if ahead is None or (stretch.velocities[ahead] - stretch.velocities[body]) * direction > stretch.tolerance:
            return False
        if not stretch.before.pushes(body):
            return True
        body = ahead
    return True


def is_squeezed(stretch: Stretch[N], body: int) -> bool:
    """Whether a body is urged from both sides."""
    return all(is_urged(stretch, body, direction) for direction in Direction)


def is_urged(stretch: Stretch[N], body: int, direction: Direction) -> bool:
    """Whether a body wishes to move in a direction, or one behind it from which contacts pass that on."""
    for _ in stretch.drives:
        wish = stretch.wish(body) * direction
        if wish > zero_like(wish):
            return True
        behind = stretch.contacts.get((body, direction.opposite))
        if behind is None or not stretch.before.pushes(behind):
            return False
        body = behind
    return False


def walk_together(course: Course[N]) -> Truth:
    """Under one key, of characters of one speed, each that is not blocked moves at it; nobody moves faster, or back."""
    return every(one_speed(one) for one in course.lasting if key_of(one.drives) is not None)


def key_of(drives: Mapping[int, Drive[N]]) -> N | None:
    """The velocity of all characters that walk, if there are some, it is one, and all else is at rest; else None."""
    walking = [drive.speed for drive in drives.values() if not drive.relative]
    at_rest = all(drive.speed == zero_like(drive.speed) for drive in drives.values() if drive.relative)
    return walking[0] if walking and at_rest and all(speed == walking[0] for speed in walking) else None


def one_speed(stretch: Stretch[N]) -> Truth:
    """Whether all that walk go at one speed or are blocked, and nobody else is faster or goes the other way."""
    key = key_of(stretch.drives)
    assert key is not None
    direction = Direction.RIGHT if key >= zero_like(key) else Direction.LEFT
    return every(
        zero_like(key) <= stretch.velocities[body] * direction <= key * direction
        and (drive.relative or stretch.velocities[body] == key or is_blocked(stretch, body, direction))
        for body, drive in stretch.drives.items()
    )


def squeezed_stand(course: Course[N]) -> Truth:
    """Whoever is urged from both sides stands."""
    return every(stands(one, body) for one in course.lasting for body in one.drives if is_squeezed(one, body))


def stands(stretch: Stretch[N], body: int) -> Truth:
    """Whether a body stands still."""
    return equal(stretch.velocities[body], zero_like(stretch.tolerance), stretch.tolerance)


def instants_bounded(course: Course[N]) -> Truth:
    """The instants at which something comes keep the bound, if bodies are few.

    Let n be the number of bodies, and p that of pieces of terrain. Something comes when a body meets, leaves or passes
    over one of p + 1 pieces and ends or of n bodies; the bound says that, all together, each body does that no more
    than once for each of these, and on a ring once more for each round that the bodies' drives lead round it. That a
    body and its support may part more than once makes this a bound that holds where it was tried, not one with a proof.
    Of four bodies it is false, and so is any.
    """
    world = course.before
    bodies = bodies_of(world)
    if len(bodies) > FEW:
        return True
    pieces = sum(len(world.solid(storey)) for storey in range(max(map(world.storey, bodies)) + 1))
    most, instants = (len(bodies) + 1) * (len(bodies) + pieces + 1), len(course.stretches)
    if world.circumference is None:
        return instants <= most
    return world.circumference * instants <= (world.circumference + course.led) * most + course.stretches[0].tolerance


def instants_of_one_bounded(course: Course[N]) -> Truth:
    """If one is driven and all may push, the instants at which something comes keep a bound that has an argument.

    Let n be the number of bodies, f that of the storeys that all of them could fall, p that of pieces of terrain. At
    no more than f instants one falls. Between two of these, no more than n times somebody comes to stand in a row that
    ends at a wall, and stands until one falls; nobody else stops meanwhile, so between two of those, no more than n
    times somebody begins to move. While nobody begins or stops, each leaves each body and each piece of ground once; on
    a ring once more for each round that the drive leads round it.
    """
    world = course.before
    bodies = bodies_of(world)
    driven = [drive for drive in course.stretches[0].drives.values() if drive.speed != zero_like(drive.speed)]
    if len(driven) != 1 or not all(world.pushes(body) for body in bodies):
        return True
    n, f = len(bodies), sum(map(world.storey, bodies))
    p = sum(len(world.solid(storey)) for storey in range(max(map(world.storey, bodies)) + 1))
    most, instants = (f + 1) * (n + 1) * (n + 1) * (n * (n + p) + 1), len(course.stretches)
    if world.circumference is None:
        return instants <= most
    return world.circumference * instants <= (world.circumference + course.led) * most + course.stretches[0].tolerance


def seats_found(course: Course[N]) -> Truth:
    """Whoever has changed its seat has found the right one."""
    return every(
        seat_found(one, body)
        for one in course.stretches
        for body in one.drives
        if (one.before.storey(body), one.before.support(body)) != (one.after.storey(body), one.after.support(body))
    )


def seat_found(stretch: Stretch[N], body: int) -> Truth:
    """Whether what a body has left no longer holds it, nothing would have held it above where it stands now, and no
    ground or better top does there.

    Looked at is what stayed on its storey: others may have come down to theirs when the body had found its own.
    """
    world, support, left = stretch.after, stretch.after.support(body), stretch.before.support(body)
    storey = world.storey(body)
    passed = range(storey + 1, stretch.before.storey(body) + 1)
    truths = [negated(over(stretch, body, image)) for above in passed for image in grounds(world, above)]
    truths += [negated(by_top(stretch, body, image)) for above in passed for _, image in tops(stretch, above)]
    if left is not None and world.storey(left) == stretch.before.storey(left):
        truths += [negated(by_top(stretch, body, image)) for image in images(world, world.span(left))]
    if support is not None:
        truths += [negated(over(stretch, body, image)) for image in grounds(world, storey)]
        truths += [
            negated(by_top(stretch, body, image)) | no_better(stretch, body, support, other, image)
            for other, image in tops(stretch, storey)
        ]
    return every(truths)


def grounds(world: Survey[N], storey: int) -> list[Interval[N]]:
    """The ground of a storey above the floor, with its images round a ring: what is solid below, and open above."""
    pieces = [image for solid in world.solid(storey - 1) for image in images(world, solid)]
    for wall in (image for solid in world.solid(storey) for image in images(world, solid)):
        pieces = [rest for piece in pieces for rest in beside_wall(piece, wall)]
    return pieces


def beside_wall(piece: Interval[N], wall: Interval[N]) -> list[Interval[N]]:
    """What of an interval is on the left and on the right of a wall."""
    if wall.right <= piece.left or wall.left >= piece.right:
        return [piece]
    left = [Interval(piece.left, wall.left)] if wall.left > piece.left else []
    return [*left, Interval(wall.right, piece.right)] if wall.right < piece.right else left


def tops(stretch: Stretch[N], storey: int) -> list[tuple[int, Interval[N]]]:
    """The bodies one storey below that have stayed there, with their images round a ring."""
    world = stretch.after
    stayed = [b for b in stretch.drives if stretch.before.storey(b) == world.storey(b) == storey - 1]
    return [(body, image) for body in stayed for image in images(world, world.span(body))]


def over(stretch: Stretch[N], body: int, ground: Interval[N]) -> Truth:
    """Whether ground would hold a body, by more than the tolerance."""
    return meet(stretch.after.span(body), ground, zero_like(stretch.tolerance) - stretch.tolerance)


def by_top(stretch: Stretch[N], body: int, top: Interval[N]) -> Truth:
    """Whether a top would hold a body, by more than the tolerance."""
    return meet(stretch.after.span(body), top, stretch.after.margin - stretch.tolerance)


def no_better(stretch: Stretch[N], body: int, support: int, other: int, image: Interval[N]) -> Truth:
    """Whether another top is no further to the front than what a body stands on, or is not more under it."""
    world, tolerance = stretch.after, stretch.tolerance
    motion = stretch.velocities[body] - stretch.carried(body)
    span, near, mine = world.span(body), world.margin + tolerance, images(world, world.span(support))
    if motion > tolerance:
        return some(meet(span, one, near) & (image.left <= one.left + tolerance) for one in mine)
    if motion + tolerance < zero_like(motion):
        return some(meet(span, one, near) & (image.left + tolerance >= one.left) for one in mine)
    return world.overlap(body, other) <= world.overlap(body, support) + tolerance


def of_step(name: str, sentence: str, source: str, holds: Callable[[Course[Any]], Truth]) -> StepInvariant:
    """An invariant of a step."""
    return StepInvariant(f"invariant/step-{name}", sentence, source, holds)


STEP_MARGIN = of_step(
    "margin",
    "At every instant, bodies on one storey are at least the collision margin apart, or terrain is between them.",
    "6.2.1; R24, U9",
    keeps_margin,
)
STEP_TERRAIN = of_step(
    "terrain",
    "No step brings a body into terrain, through terrain, or beyond the ends of a line.",
    "6.2.2; R19, U2, U4, U11",
    enters_no_terrain,
)
STEP_SUPPORT = of_step(
    "support",
    "At every instant, each body is held by the support that it names: the ground of its storey, or a body one storey "
    "below.",
    "4.4, 6.1.2; R12, A14",
    supported,
)
STEP_ORDER = of_step("order", "While two bodies are on one storey, they do not pass each other.", "4.2; R5", order_kept)
STEP_MOTION = of_step(
    "motion",
    "Between two instants, both borders of a body move by its velocity times the time.",
    "6.2.1; R8, R17",
    moves_as_told,
)
STEP_NOT_RAISED = of_step("not-raised", "No step raises a body.", "abstract, 6.2.1; R25, R32", nobody_raised)
STEP_BYSTANDERS = of_step(
    "bystanders",
    "A body moves only if it is driven, if its support moves, or if one in contact behind it may push and is as fast.",
    "4.2; R6, R20",
    bystanders_stay,
)
STEP_PROGRESS = of_step(
    "progress",
    "A body is slower than its drive and its support would have it only in a row in contact that ends at a wall, at a "
    "body that may not push the next one, or at a squeezed body, or that closes on itself round a ring.",
    "6.2.1; R18, R19, R20, R31",
    progress_made,
)
STEP_SQUEEZED = of_step(
    "squeezed", "A body that is urged from both sides stands still.", "6.2.1c; R20, A2", squeezed_stand
)
STEP_ONE_KEY = of_step(
    "one-key",
    "Of characters that walk at one speed under one key, each that is not blocked moves at it, in contact and one on "
    "top of the other too; nobody moves faster, or the other way.",
    "1.1; R1, A53",
    walk_together,
)
STEP_INSTANTS = of_step(
    "instants",
    "A step of up to three bodies has no more instants at which something comes than its bodies and one, times its "
    "bodies, its pieces of terrain and one, times the rounds of a ring that its drives lead and one.",
    "6.2.1; R17",
    instants_bounded,
)
STEP_INSTANTS_OF_ONE = of_step(
    "instants-of-one",
    "Where one of n bodies is driven and all may push, a step has no more than (f + 1)(n + 1)(n + 1)(n(n + p) + 1) "
    "instants at which something comes, f being the storeys that all bodies together stand above the floor, and p the "
    "pieces of terrain; on a ring, that times the rounds that the drive leads and one.",
    "6.2.1; R17",
    instants_of_one_bounded,
)

STEP_SEAT = of_step(
    "seat",
    "A body leaves a support only when that no longer holds it. Then it stands on the ground of its storey if it is "
    "over it; else on the top that is front-most in its motion relative to what it lost, or without such motion on one "
    "that it is over most; and it falls only where nothing holds it.",
    "6.2.1d, 6.2.1e; R21, R22, R25, A23",
    seats_found,
)

OF_ONE_STEP: tuple[StepInvariant, ...] = (
    STEP_MARGIN,
    STEP_TERRAIN,
    STEP_SUPPORT,
    STEP_SEAT,
    STEP_ORDER,
    STEP_MOTION,
    STEP_NOT_RAISED,
    STEP_BYSTANDERS,
    STEP_PROGRESS,
    STEP_SQUEEZED,
    STEP_ONE_KEY,
    STEP_INSTANTS,
    STEP_INSTANTS_OF_ONE,
)

STEP_SPLIT = Relation(
    "invariant/step-split", "Two steps, one after the other, do what one step of both their lengths does.", "2.2; R4"
)
STEP_MIRROR = Relation(
    "invariant/step-mirror", "The mirror image of a step does the mirror image of what the step does.", "6.1.1; A58"
)
STEP_BODY_ORDER = Relation(
    "invariant/step-body-order",
    "A step does the same whatever the order in which bodies are listed, unless one that looks for a top without "
    "having moved on the one it lost is over two of them equally.",
    "2.2; R5, A52",
)
STEP_RIDERS = Relation(
    "invariant/step-riders",
    "A rider never holds its support back: without the bodies above a storey, those on it and below move as they do "
    "with them, until one of those above comes down.",
    "4.4; A27",
)
STEP_FURTHEST = Relation(
    "invariant/step-furthest",
    "Where one body is driven, all may push, nobody changes its support, and no terrain is between the supports of "
    "bodies that have none between them, each goes as far as it wishes or is pushed, and as far as walls allow: on a "
    "line the least of what the walls ahead allow and the greater of its own wish and what the body behind it goes "
    "beyond the room between them.",
    "6.2.1c; R20",
)
STEP_ONE_WAY = Relation(
    "invariant/step-one-way",
    "Where all that are driven on a line are driven one way at one speed, in the plane or on what stands, all may push "
    "and nobody changes its support, each goes as far as the least of what the walls ahead allow and the greater of "
    "its own wish and what the body behind it goes beyond the room between them; unless a wall stops what carries one "
    "of a row, and another of that row is driven, or carried by another row.",
    "1.1, 6.2.1c; R1, R20",
)
STEP_OUT_OF_REACH = Relation(
    "invariant/step-out-of-reach",
    "Bodies that a step cannot reach do not matter: they stay as they are, and without them the others move at the "
    "same instants, with the same velocities, to the same places.",
    "7.1.1; R20, E5",
)

STEP_RELATIONS: tuple[Relation, ...] = (
    STEP_SPLIT,
    STEP_MIRROR,
    STEP_BODY_ORDER,
    STEP_RIDERS,
    STEP_FURTHEST,
    STEP_ONE_WAY,
    STEP_OUT_OF_REACH,
)
