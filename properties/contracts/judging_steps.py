"""A bank of invented steps, right and wrong ones: what the invariants of steps must say of each.

The steps are at, and just beyond, the boundaries of the invariants, in exact numbers. No rule is run: how bodies move,
and what they stand on then, is made up. So a step tells of an invariant that lets something wrong pass, or blames what
is right.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from reference.storeys import Place, StoreyWorld, Terrain
from spec.profiles import SteppedProfile
from spec.stepped import OF_ONE_STEP, Course, Stretch
from spec.storeys import Drive, Interval

ONE, HALF, TWENTY = Fraction(1), Fraction(1, 2), Fraction(20)
Wide = tuple[Any, Any]
"""From where to where."""


@dataclass(frozen=True)
class Invented:
    """A step that was made up, and the invariants that it breaks, without `invariant/step-`."""

    name: str
    course: Course[Any]
    breaks: str = ""


def at(left: Any, right: Any, storey: int = 0, on: int | None = None, pushes: bool = True) -> Place[Fraction]:
    """A body from .. to on a storey, on the ground or on another."""
    return Place(storey, Fraction(left), Fraction(right) - Fraction(left), on, pushes)


def line(*places: Place[Fraction], solid: Iterable[Iterable[Wide]] = ()) -> StoreyWorld[Fraction]:
    """Bodies on a line of length 20; the margin is 1. `solid` is the terrain of each storey."""
    return StoreyWorld(Terrain(terrain(solid), Interval(ONE * 0, TWENTY)), ONE, places)


def ring(*places: Place[Fraction], solid: Iterable[Iterable[Wide]] = ()) -> StoreyWorld[Fraction]:
    """The same on a ring of circumference 20."""
    return StoreyWorld(Terrain(terrain(solid), None, TWENTY), ONE, places)


def terrain(solid: Iterable[Iterable[Wide]]) -> tuple[tuple[Interval[Fraction], ...], ...]:
    """The terrain of each storey."""
    return tuple(tuple(Interval(Fraction(left), Fraction(right)) for left, right in one) for one in solid)


def walks(speed: Any) -> Drive[Fraction]:
    """The drive of a character that walks."""
    return Drive(Fraction(speed), relative=False)


def rides(speed: Any = 0) -> Drive[Fraction]:
    """A drive relative to the support; of a box it is 0."""
    return Drive(Fraction(speed))


def stretch(
    world: StoreyWorld[Fraction],
    speeds: Sequence[Any],
    drives: Sequence[Drive[Fraction]] = (),
    lasted: Any = 1,
    seats: Mapping[int, tuple[int, int | None]] | None = None,
) -> Stretch[Fraction]:
    """A stretch in which bodies move at speeds; who is named in `seats` is then on that storey, on that support.

    If no drives are given, all walk as fast as they move.
    """
    went = [Fraction(speed) for speed in speeds]
    moved = world.copy()
    for body, speed in enumerate(went):
        moved.advance(body, speed * Fraction(lasted))
    for body, (storey, support) in (seats or {}).items():
        moved.places[body] = replace(moved.places[body], storey=storey, support=support)
    after = StoreyWorld(moved.terrain, moved.margin, moved.places)
    return Stretch(
        world, after, Fraction(lasted), dict(enumerate(went)), dict(enumerate(drives or map(walks, went))), ONE * 0
    )


def made(name: str, breaks: str, *stretches: Stretch[Fraction]) -> Invented:
    """A step of some stretches."""
    return Invented(name, Course(stretches), breaks)


def still(name: str, breaks: str, world: StoreyWorld[Fraction]) -> Invented:
    """A step of no length."""
    return made(name, breaks, resting(world))


def resting(world: StoreyWorld[Fraction], lasted: Any = 0) -> Stretch[Fraction]:
    """A stretch in which nobody moves, or is driven."""
    return stretch(world, [0] * len(world.places), [rides()] * len(world.places), lasted)


A, B = at(0, 2), at(3, 5)
HIGH = ((4, 10),)
"""Terrain of the lowest storey: the ground of the one above."""

PLACES: tuple[Invented, ...] = (
    still("a margin apart", "", line(A, B)),
    still("less than a margin apart", "margin", line(A, at(2 + HALF, 5))),
    still("less than a margin apart, beside a wall", "margin", line(A, at(2 + HALF, 5), solid=[[(6, 7)]])),
    still("less than a margin apart, with a wall between", "", line(A, at(2 + HALF, 5), solid=[[(2, 2 + HALF)]])),
    still("with the first of two walls between", "", line(A, at(2 + HALF, 5), solid=[[(2, 2 + HALF), (6, 7)]])),
    still("with the second of two walls between", "", line(at(4, 6), at(6 + HALF, 8), solid=[[(0, 1), (6, 6 + HALF)]])),
    still("overlapping", "margin", line(A, at(1, 3))),
    still("a margin apart across the seam", "", ring(A, at(17, 19))),
    still("less than a margin apart across the seam", "margin", ring(A, at(17 + HALF, 19 + HALF))),
    still("over the seam, and far away", "", ring(at(19, 21), at(10, 12))),
    still("over the seam, a margin from one behind it", "", ring(at(19, 21), at(2, 4))),
    still("over the seam, onto one behind it", "margin", ring(at(19, 21), at(HALF, 3))),
    still("with a wall between across the seam", "", ring(A, at(17 + HALF, 19 + HALF), solid=[[(19 + HALF, 20)]])),
    still(
        "with a wall over the seam between", "", ring(at(HALF, 2), at(17, 19 + HALF), solid=[[(19 + HALF, 20 + HALF)]])
    ),
    still("at a wall", "", line(at(2, 4), solid=[[(4, 6)]])),
    still("in a wall", "terrain", line(at(2, 4), solid=[[(3, 6)]])),
    still("in a wall across the seam", "terrain", ring(at(19, 21), solid=[[(HALF, 6)]])),
    still("at a wall across the seam", "", ring(at(18, 20), solid=[[(0, 6)]])),
    still("at the left end", "", line(at(0, 2))),
    still("beyond the left end", "terrain", line(at(-HALF, 2))),
    still("at the right end", "", line(at(18, 20))),
    still("beyond the right end", "terrain", line(at(18, 20 + HALF))),
    still("on the ground of a storey", "", line(at(3, 5, 1), solid=[HIGH])),
    still("over no ground, at its edge", "support", line(at(2, 4, 1), solid=[HIGH])),
    still("over no ground, at its other edge", "support", line(at(10, 12, 1), solid=[HIGH])),
    still("on the ground of the storey above", "", line(at(3, 5, 2), solid=[[(0, 1)], HIGH])),
    still("over the ground of another storey", "support", line(at(3, 5, 2), solid=[HIGH, ()])),
    still("over ground across the seam", "", ring(at(19, 21, 1), solid=[[(0, 6)]])),
    still("left of a wall on the ground", "", line(at(4, 6, 1), solid=[HIGH, [(7, 8)]])),
    still("right of a wall on the ground", "", line(at(8, 10, 1), solid=[HIGH, [(7, 8)]])),
    still("before ground, at a wall", "support", line(at(2, 4, 1), solid=[HIGH, [(0, 2)]])),
    still("behind ground, at a wall", "support", line(at(10, 12, 1), solid=[HIGH, [(12, 14)]])),
    still("in a wall that begins with its ground", "terrain support", line(at(3, 5, 1), solid=[HIGH, HIGH])),
    still("in a wall that ends with its ground", "terrain support", line(at(9, 11, 1), solid=[HIGH, HIGH])),
    still("on another", "", line(A, at(0, 2, 1, on=0))),
    still("less than a margin beside another", "", line(A, at(2 + HALF, 5, 1, on=0))),
    still("less than a margin beside another, on its left", "", line(at(4, 6), at(HALF, 3 + HALF, 1, on=0))),
    still("a margin beside another", "support", line(A, at(3, 5, 1, on=0))),
    still("a margin beside another, on its left", "support", line(at(4, 6), at(1, 3, 1, on=0))),
    still("on another across the seam", "", ring(at(19, 21), at(0, 2, 1, on=0))),
    still("on another across the seam, from before it", "", ring(at(0, 2), at(19, 21, 1, on=0))),
    still("two storeys above its support", "support", line(A, at(0, 2, 2, on=0), solid=[(), ()])),
    still("on the storey of its support", "support", line(A, at(2 + HALF, 5, on=0), solid=[[(2, 2 + HALF)]])),
    still("below its support", "support", line(at(0, 2, 1), at(0, 2, on=0), solid=[[(19, 20)]])),
)

WALL = ((8, 10),)


def displaced(one: Stretch[Fraction], left: Any, wider: Any = 0) -> Stretch[Fraction]:
    """The same, but the first body ends elsewhere, or wider."""
    world: Any = one.after
    place, *others = world.places
    elsewhere = replace(place, left=place.left + Fraction(left), width=place.width + Fraction(wider))
    return replace(one, after=StoreyWorld(world.terrain, ONE, [elsewhere, *others]))


MOVES: tuple[Invented, ...] = (
    made("a walk", "", stretch(line(A), [3])),
    made("a walk in half the time", "", stretch(line(A), [3], lasted=HALF)),
    made("a walk to the left", "", stretch(line(at(10, 12)), [-3])),
    made("further than it says", "motion", displaced(stretch(line(A), [3]), HALF)),
    made("less far than it says", "motion", displaced(stretch(line(A), [3]), -HALF)),
    made("wider than before", "motion", displaced(stretch(line(A), [3]), 0, wider=HALF)),
    made("wider to the left than before", "motion", displaced(stretch(line(A), [3]), -HALF, wider=HALF)),
    made("over the seam", "", stretch(ring(at(17, 19)), [3])),
    made("over the seam, further than it says", "motion", displaced(stretch(ring(at(17, 19)), [3]), HALF)),
    made("back over the seam", "", stretch(ring(A), [-3])),
    made("up to another", "margin", stretch(line(A, at(6, 8)), [4, 0])),
    made("up to the margin of another", "", stretch(line(A, at(6, 8)), [3, 0])),
    made("through another", "order", stretch(line(A, at(6, 8)), [10, 0])),
    made("through another, to the left", "order", stretch(line(at(6, 8), at(12, 14)), [0, -10])),
    made("from touching, through another", "order", stretch(line(A, at(2, 4)), [5, 0])),
    made("from touching, through another, to the left", "order", stretch(line(at(8, 10), at(10, 12)), [0, -5])),
    made("into another", "margin order", stretch(line(A, at(6, 8)), [5, 0])),
    made("both alike", "", stretch(line(A, B), [9, 9])),
    made("both alike, to the left", "", stretch(line(at(10, 12), at(13, 15)), [-9, -9])),
    made("the one ahead away", "", stretch(line(A, B), [0, 9])),
    made("the one behind away", "", stretch(line(at(10, 12), at(13, 15)), [-9, 0])),
    made("the one behind away from one at the start", "", stretch(line(at(12, 14), at(15, 17)), [-12, 0])),
    made("towards each other, through each other", "order", stretch(line(A, at(10, 12)), [10, -10])),
    made("towards each other, up to each other", "margin", stretch(line(A, at(10, 12)), [4, -4])),
    made("through another across the seam", "order", stretch(ring(at(16, 18), A), [9, 0])),
    made("up to a margin across the seam", "", stretch(ring(at(14, 16), A), [3, 0])),
    made("round behind another", "", stretch(ring(at(2, 4), at(10, 12)), [0, 6])),
    made("up to a wall", "", stretch(line(at(2, 4), solid=[WALL]), [4])),
    made("up to a wall, to the left", "", stretch(line(at(14, 16), solid=[WALL]), [-4])),
    made("into a wall", "terrain", stretch(line(at(2, 4), solid=[WALL]), [5])),
    made("through a wall", "terrain", stretch(line(at(2, 4), solid=[WALL]), [9])),
    made("through a wall, to the left", "terrain", stretch(line(at(14, 16), solid=[WALL]), [-9])),
    made("from touching, through a wall", "terrain", stretch(line(at(6, 8), solid=[WALL]), [6])),
    made("from touching, through a wall, to the left", "terrain", stretch(line(at(10, 12), solid=[WALL]), [-6])),
    made("through a wall across the seam", "terrain", stretch(ring(at(15, 17), solid=[[(1, 2)]]), [6])),
    made("away from a wall", "", stretch(line(at(10, 12), solid=[WALL]), [6])),
    made("away from a wall, to the left", "", stretch(line(at(6, 8), solid=[WALL]), [-6])),
    made("another stays on another storey", "", stretch(line(A, at(6, 8, 1, on=2), at(6, 8)), [3, 0, 0])),
    made("raised", "not-raised support", stretch(line(at(0, 2)), [0], seats={0: (1, None)})),
)


NO_PUSH = at(0, 2, pushes=False)
BOX = rides()
MIDDLE = (at(6, 8), at(9, 11))
"""Two in contact, far from both ends."""
THREE = (at(6, 8), at(9, 11), at(12, 14))
FULL = (at(0, 4), at(5, 9), at(10, 19))
"""Three that fill a ring."""


def moved(name: str, breaks: str, places: Sequence[Place[Any]], speeds: Sequence[Any], *drives: Drive[Any]) -> Invented:
    """A step of bodies on a line without terrain."""
    return made(name, breaks, stretch(line(*places), speeds, drives))


def turned(
    name: str, breaks: str, places: Sequence[Place[Any]], speeds: Sequence[Any], *drives: Drive[Any]
) -> Invented:
    """A step of bodies on a ring without terrain."""
    return made(name, breaks, stretch(ring(*places), speeds, drives))


CAUSES: tuple[Invented, ...] = (
    moved("nobody is driven", "", MIDDLE, [0, 0], BOX, BOX),
    moved("pushed", "", MIDDLE, [1, 1], walks(1), BOX),
    moved("pushed to the left", "", MIDDLE, [-1, -1], BOX, walks(-1)),
    moved("pushed faster than it walks", "", MIDDLE, [2, 2], walks(2), walks(1)),
    moved("pushed, but not in contact", "bystanders", (A, at(9, 11)), [1, 1], walks(1), BOX),
    moved("pushed by nobody", "bystanders", (A,), [1], BOX),
    moved("pushed to the left by nobody", "bystanders", (at(9, 11),), [-1], BOX),
    moved("pushed from ahead", "bystanders", MIDDLE, [1, 1], BOX, walks(1)),
    moved("pushed by one that may not push", "bystanders", (NO_PUSH, B), [1, 1], walks(1), BOX),
    moved("pushed faster than what pushes", "bystanders one-key", MIDDLE, [1, 2], walks(1), BOX),
    moved("pushed by one that itself is not", "bystanders", THREE, [1, 1, 1], BOX, BOX, BOX),
    moved("faster than it walks", "bystanders one-key", (A,), [2], walks(1)),
    moved("slower than it walks", "progress one-key", (at(9, 11),), [1], walks(2)),
    moved("slower than it walks to the left", "progress one-key", (at(9, 11),), [-1], walks(-2)),
    moved("it does not walk", "progress one-key", (at(9, 11),), [0], walks(2)),
    moved("walks the other way", "bystanders progress one-key", (at(9, 11),), [-1], walks(2)),
    moved("stopped by the end", "", (at(18, 20),), [0], walks(1)),
    moved("stopped by the left end", "", (A,), [0], walks(-1)),
    moved("stopped by the other end", "progress one-key", (A,), [0], walks(1)),
    moved("stopped before the end", "progress one-key", (at(17, 19),), [0], walks(1)),
    moved("a row stopped by the end", "", (at(15, 17), at(18, 20)), [0, 0], walks(1), BOX),
    moved("a row stopped before the end", "progress one-key", (at(14, 16), at(17, 19)), [0, 0], walks(1), BOX),
    moved(
        "not in contact with what the end stops", "progress one-key", (at(14, 16), at(18, 20)), [0, 0], walks(1), BOX
    ),
    moved("one that may not push is stopped by the next", "", (NO_PUSH, B), [0, 0], walks(1), BOX),
    moved("one that may not push walks behind the next", "", (NO_PUSH, B), [1, 1], walks(2), walks(1)),
    moved("one that may not push falls behind the next", "progress", (NO_PUSH, B), [1, 2], walks(3), walks(2)),
    moved("one that may push falls behind the next", "progress", MIDDLE, [1, 2], walks(3), walks(2)),
    moved("one that may push does not", "progress one-key", MIDDLE, [0, 0], walks(1), BOX),
    moved(
        "not pushed past one that may not push",
        "",
        (A, at(3, 5, pushes=False), at(6, 8)),
        [0, 0, 0],
        walks(1),
        BOX,
        BOX,
    ),
    moved("both stand opposite each other", "", MIDDLE, [0, 0], walks(1), walks(-1)),
    moved("both stand opposite each other, the faster too", "", MIDDLE, [0, 0], walks(2), walks(-1)),
    moved("urged from both sides, and moves", "squeezed", MIDDLE, [1, 1], walks(2), walks(-1)),
    moved("one between two stands", "", THREE, [0, 0, 0], walks(1), BOX, walks(-1)),
    moved("one between two is squeezed out", "squeezed", THREE, [1, 1, 1], walks(1), BOX, walks(-1)),
    moved("one that may not push is urged from both sides", "", (NO_PUSH, B), [0, 0], walks(1), walks(-1)),
    moved("the one before it is not", "margin", (NO_PUSH, B), [0, -HALF], walks(1), walks(-1)),
    moved("a rider goes along", "", (A, at(0, 2, 1, on=0)), [1, 1], walks(1), BOX),
    moved("a rider slides on", "", (A, at(0, 2, 1, on=0)), [1, 2], walks(1), rides(1)),
    moved("a rider stays behind", "progress", (A, at(0, 2, 1, on=0)), [1, 0], walks(1), BOX),
    moved("a rider goes along twice as fast", "bystanders one-key", (A, at(0, 2, 1, on=0)), [1, 2], walks(1), BOX),
    moved("a rider walks in the plane", "", (A, at(0, 2, 1, on=0)), [1, 0], walks(1), walks(0)),
    turned("all of a full ring stand", "", FULL, [0, 0, 0], walks(1), BOX, BOX),
    turned("all of a full ring are driven, and stand", "", FULL, [0, 0, 0], walks(1), walks(1), walks(1)),
    turned("all of a full ring walk", "", FULL, [-1, -1, -1], walks(-1), walks(-1), walks(-1)),
    turned("pushed across the seam", "", (at(17, 19), at(0, 2)), [1, 1], walks(1), BOX),
    turned("pushed across the seam by nobody", "bystanders", (at(17, 18), at(0, 2)), [1, 1], walks(1), BOX),
    made("what lasts no time has no cause", "", stretch(line(A), [1], [BOX], lasted=0)),
    made("stopped by a wall", "", stretch(line(at(6, 8), solid=[WALL]), [0], [walks(1)])),
    made("stopped before a wall", "progress one-key", stretch(line(at(5, 7), solid=[WALL]), [0], [walks(1)])),
    made("stopped by a wall on a ring", "", stretch(ring(at(6, 8), solid=[WALL]), [0], [walks(1)])),
)

KEYS: tuple[Invented, ...] = (
    moved("under one key", "", (A, at(9, 11)), [1, 1], walks(1), walks(1)),
    moved("under one key, to the left", "", (at(5, 7), at(9, 11)), [-1, -1], walks(-1), walks(-1)),
    moved("under one key, one is at the end", "", (at(9, 11), at(18, 20)), [1, 0], walks(1), walks(1)),
    moved("under one key, one lags behind", "progress one-key", (A, at(9, 11)), [HALF, 1], walks(1), walks(1)),
    moved("under one key, one is ahead", "bystanders one-key", (A, at(9, 11)), [1, 2], walks(1), walks(1)),
    moved("under one key, one goes back", "bystanders progress one-key", (A, at(9, 11)), [1, -1], walks(1), walks(1)),
    moved("under one key, a box goes back", "bystanders one-key", (A, at(9, 11)), [1, -1], walks(1), BOX),
    moved("under one key, a box is faster", "bystanders one-key", (A, at(9, 11)), [1, 2], walks(1), BOX),
    moved("under one key, a box is slower", "bystanders", (A, at(9, 11)), [1, HALF], walks(1), BOX),
    moved(
        "under one key to the left, a box goes back",
        "bystanders one-key",
        (at(6, 8), at(12, 14)),
        [-1, 1],
        walks(-1),
        BOX,
    ),
    moved("under the key of nothing", "", (A, at(9, 11)), [0, 0], walks(0), BOX),
    moved("under the key of nothing, a box moves", "bystanders one-key", (A, at(9, 11)), [0, 1], walks(0), BOX),
    moved("two speeds", "", (A, at(9, 11)), [1, 2], walks(1), walks(2)),
    moved("two speeds, the greater first", "", (A, at(9, 11)), [2, 1], walks(2), walks(1)),
    moved(
        "a rider that slides on walks faster",
        "",
        (A, at(9, 11), at(9, 11, 1, on=1)),
        [1, 0, 2],
        walks(1),
        BOX,
        rides(2),
    ),
    moved("one that slides back is under no key", "", (A, at(9, 11)), [1, -2], walks(1), rides(-2)),
    moved("boxes that slide are under no key", "", (A, at(9, 11)), [1, 2], rides(1), rides(2)),
    moved("nobody walks", "bystanders", (A, at(9, 11)), [1, -1], BOX, BOX),
)


def repeated(name: str, breaks: str, times: int, one: Stretch[Fraction]) -> Invented:
    """A step of so many stretches that are alike."""
    return made(name, breaks, *[one] * times)


INSTANTS: tuple[Invented, ...] = (
    repeated("as many instants as one body has", "", 4, resting(line(A))),
    repeated("an instant too many of one body", "instants", 5, resting(line(A))),
    repeated("as many instants as two bodies have", "", 9, resting(line(A, B))),
    repeated("an instant too many of two bodies", "instants", 10, resting(line(A, B))),
    repeated("as many instants as two pieces of terrain have", "", 8, resting(line(A, solid=[[(3, 4), (6, 7)]]))),
    repeated("an instant too many of two pieces", "instants", 9, resting(line(A, solid=[[(3, 4), (6, 7)]]))),
    repeated("an instant too many below a piece", "instants", 5, resting(line(A, solid=[(), [(3, 4)]]))),
    repeated("as many instants as a piece below has", "", 6, resting(line(at(4, 6, 1), solid=[HIGH]))),
    repeated("an instant too many above a piece", "instants", 7, resting(line(at(4, 6, 1), solid=[HIGH]))),
    repeated("as many instants as a ring has", "", 4, resting(ring(A), lasted=1)),
    repeated("an instant too many on a ring", "instants", 5, resting(ring(A), lasted=1)),
    repeated("as many instants as two rounds have", "", 8, stretch(ring(A), [HALF * 5])),
    repeated("an instant too many in two rounds", "instants", 9, stretch(ring(A), [Fraction(20, 9)])),
    repeated("as many instants as two rounds to the left have", "", 8, stretch(ring(A), [HALF * -5])),
    repeated("an instant too many in rounds of no time", "instants", 5, stretch(ring(A), [HALF * 5], lasted=0)),
    repeated("as many instants as three bodies have", "", 16, resting(line(A, B, at(6, 8)))),
    repeated("an instant too many of three bodies", "instants", 17, resting(line(A, B, at(6, 8)))),
)


def of_one(name: str, breaks: str, times: int, world: StoreyWorld[Fraction], driven: int = 1) -> Invented:
    """A step of so many stretches without time in a world of which so many are driven."""
    bodies = len(world.places)
    drives = [rides(1)] * driven + [rides()] * (bodies - driven)
    return repeated(name, breaks, times, stretch(world, [0] * bodies, drives, 0))


PIECES, BOTH = [[(3, 4), (6, 7)]], "instants instants-of-one"
OF_ONE: tuple[Invented, ...] = (
    of_one("as many instants as one driven body has", "instants", 8, line(A)),
    of_one("an instant too many of one driven body", BOTH, 9, line(A)),
    of_one("as many instants as two with one drive have", "instants", 45, line(A, B)),
    of_one("an instant too many of two with one drive", BOTH, 46, line(A, B)),
    of_one("as many instants as one drive with two pieces has", "instants", 16, line(A, solid=PIECES)),
    of_one("an instant too many with two pieces", BOTH, 17, line(A, solid=PIECES)),
    of_one("an instant too many of one driven below a piece", BOTH, 9, line(A, solid=[(), [(3, 4)]])),
    of_one("as many instants as one driven above a piece has", "instants", 24, line(at(4, 6, 1), solid=[HIGH])),
    of_one("an instant too many of one driven above a piece", BOTH, 25, line(at(4, 6, 1), solid=[HIGH])),
    of_one("more instants of two driven", "instants", 46, line(A, B), driven=2),
    of_one("more instants where one may not push", "instants", 46, line(A, at(3, 5, pushes=False))),
    of_one("more instants of four bodies", "", 26, line(A, B, at(6, 8), at(9, 11)), driven=4),
    repeated("as many instants as one driven round a ring has", "instants", 10, stretch(ring(A), [HALF])),
    repeated("an instant too many of one driven round a ring", BOTH, 11, stretch(ring(A), [HALF])),
)


def left(
    name: str, breaks: str, world: StoreyWorld[Any], speeds: Sequence[Any], **seats: tuple[int, int | None]
) -> Invented:
    """A step in which bodies, walking, find other seats; `a` is the first body, and so on."""
    found = {"abc".index(body): seat for body, seat in seats.items()}
    return made(name, breaks, stretch(world, speeds, seats=found))


EDGE = at(8, 10, 1)
"""A body at the edge of the ground of a storey, and beyond it after a way of 2."""
TALL = ((), HIGH)
LOST, STAYS = at(8, 10), at(16, 18)

RIDING = (at(8, 10, 2, on=1), EDGE)
OFF = (2, 2, 0, 0)
CARRIED = line(at(8, 14, 2, on=1), EDGE, at(13, 14 + HALF), at(15 + HALF, 18), solid=[HIGH])
EQUALLY = line(at(8, 14, 2, on=1), EDGE, at(13, 13 + HALF), at(15 + HALF, 18), solid=[HIGH])
SEAM = ring(at(17, 19, 1), at(17, 19 + HALF), at(HALF, 3), solid=[[(15, 16)]])
BACK = ring(at(1, 3, 1), at(HALF, 3), at(17, 19 + HALF), solid=[[(4, 5)]])
AMONG = line(
    at(8, 10, 3),
    at(11, 12, 1, on=2),
    at(11 + HALF, 14),
    at(12 + HALF, 14, 3),
    solid=[(), (), [*HIGH, (12 + HALF, 14)]],
)
RISEN = line(at(8, 10, 3), at(10, 11, 1), at(12 + HALF, 14), solid=[[(10, 11), (12 + HALF, 14)], (), HIGH])

SEATS: tuple[Invented, ...] = (
    left("fallen", "", line(EDGE, solid=[HIGH]), [2], a=(0, None)),
    left("fallen from over the ground", "terrain seat", line(EDGE, solid=[HIGH]), [1], a=(0, None)),
    left("fallen beside another", "", line(EDGE, at(13, 15), solid=[HIGH]), [2, 0], a=(0, None)),
    left("fallen past another", "margin seat", line(EDGE, at(12 + HALF, 15), solid=[HIGH]), [2, 0], a=(0, None)),
    left("jumped", "", line(EDGE, at(12 + HALF, 15), solid=[HIGH]), [2, 0], a=(1, 1)),
    left("jumped from over the ground", "seat", line(EDGE, at(11 + HALF, 15), solid=[HIGH]), [1, 0], a=(1, 1)),
    left("fallen by two storeys", "", line(at(8, 10, 2), solid=TALL), [2], a=(0, None)),
    left("fallen by one of two storeys", "", line(at(8, 10, 2), solid=[[(11, 13)], HIGH]), [2], a=(1, None)),
    left("fallen past ground", "terrain seat", line(at(8, 10, 2), solid=[[(11, 13)], HIGH]), [2], a=(0, None)),
    left("jumped down", "", line(at(8, 10, 2), at(11, 13), solid=TALL), [2, 0], a=(1, 1)),
    left("fallen past a top", "margin seat", line(at(8, 10, 2), at(12 + HALF, 15), solid=TALL), [2, 0], a=(0, None)),
    left(
        "jumped where there is ground",
        "seat",
        line(at(5, 7, 2), at(10 + HALF, 13), solid=[HIGH, [(2, 7)]]),
        [3, 0],
        a=(1, 1),
    ),
    left(
        "landed where there is a top",
        "",
        line(at(5, 7, 2), at(10 + HALF, 13), solid=[HIGH, [(2, 7)]]),
        [3, 0],
        a=(1, None),
    ),
    left(
        "fallen beside one on its storey",
        "",
        line(EDGE, at(12 + HALF, 15, 1), solid=[[*HIGH, (12, 15)]]),
        [2, 0],
        a=(0, None),
    ),
    left("left what holds it", "seat", line(LOST, at(8, 10, 1, on=0), at(11 + HALF, 14)), [0, 1, 0], b=(1, 2)),
    left("left what holds it no longer", "", line(LOST, at(8, 10, 1, on=0), at(11 + HALF, 14)), [0, 3, 0], b=(1, 2)),
    left("left what has fallen", "", line(EDGE, at(8, 10, 2, on=0), solid=[HIGH]), [2, 2], a=(0, None), b=(1, 0)),
    left(
        "left what has risen",
        "not-raised margin support",
        line(LOST, at(9, 11, 1, on=0), solid=[[]]),
        [0, 0],
        a=(1, None),
        b=(1, None),
    ),
    left("the front-most", "", line(EDGE, at(11, 13), at(14, 16), solid=[HIGH]), [5, 0, 0], a=(1, 2)),
    left("not the front-most", "seat", line(EDGE, at(11, 13), at(14, 16), solid=[HIGH]), [5, 0, 0], a=(1, 1)),
    left(
        "the front-most, to the left",
        "",
        line(at(12, 14, 1), at(8, 10), at(5, 7), solid=[[(12, 16)]]),
        [-5, 0, 0],
        a=(1, 2),
    ),
    left(
        "not the front-most, to the left",
        "seat",
        line(at(12, 14, 1), at(8, 10), at(5, 7), solid=[[(12, 16)]]),
        [-5, 0, 0],
        a=(1, 1),
    ),
    left(
        "another is further ahead, and does not hold",
        "",
        line(EDGE, at(11, 13), STAYS, solid=[HIGH]),
        [2, 0, 0],
        a=(1, 1),
    ),
    left("most under it", "", CARRIED, OFF, a=(1, 2), b=(0, None)),
    left("less under it", "seat", CARRIED, OFF, a=(1, 3), b=(0, None)),
    left("on what has come down with it", "", CARRIED, OFF, a=(1, 1), b=(0, None)),
    left("as much under it", "", EQUALLY, OFF, a=(1, 2), b=(0, None)),
    left("as much under it, the other", "", EQUALLY, OFF, a=(1, 3), b=(0, None)),
    left(
        "overtaking, the front-most",
        "",
        line(*RIDING, at(14, 18), at(19, 20), solid=[HIGH]),
        [9, 6, 0, 0],
        a=(1, 3),
        b=(1, 2),
    ),
    left(
        "overtaking, not the front-most",
        "seat",
        line(*RIDING, at(14, 18), at(19, 20), solid=[HIGH]),
        [9, 6, 0, 0],
        a=(1, 2),
        b=(1, 2),
    ),
    left(
        "left behind, the front-most",
        "",
        line(*RIDING, at(12, 14), at(15, 20), solid=[HIGH]),
        [6, 9, 0, 0],
        a=(1, 2),
        b=(1, 3),
    ),
    left(
        "left behind, not the front-most",
        "seat",
        line(*RIDING, at(12, 14), at(15, 20), solid=[HIGH]),
        [6, 9, 0, 0],
        a=(1, 3),
        b=(1, 3),
    ),
    left("the front-most across the seam", "", SEAM, [2, 0, 0], a=(1, 2)),
    left("not the front-most across the seam", "seat", SEAM, [2, 0, 0], a=(1, 1)),
    left("the front-most across the seam, to the left", "", BACK, [-2, 0, 0], a=(1, 2)),
    left("not the front-most across the seam, to the left", "seat", BACK, [-2, 0, 0], a=(1, 1)),
    left("others are below and above", "", AMONG, [2, 0, 0, 0], a=(2, 1)),
    left("another has come up", "not-raised", RISEN, [2, 0, 0], a=(2, 1), c=(1, None)),
)


def bank() -> tuple[Invented, ...]:
    """All steps."""
    return (*PLACES, *MOVES, *CAUSES, *KEYS, *INSTANTS, *OF_ONE, *SEATS)


def misjudged(one: Invented) -> tuple[str, ...]:
    """The invariants that say something else of a step than is to be said."""
    course = Course(tuple(replace(stretch) for stretch in one.course.stretches))
    broken = {judge.id.removeprefix("invariant/step-") for judge in OF_ONE_STEP if not judge.holds(course)}
    return tuple(sorted(broken ^ set(one.breaks.split())))


def step_invariants_judge(profile: SteppedProfile) -> int:
    """Each invariant of steps says of each step of the bank what is to be said of it."""
    steps = bank()
    for one in steps:
        wrong = ", ".join(misjudged(one))
        assert not wrong, f"{one.name}: {wrong}"
    assert len({one.name for one in steps}) == len(steps), "expected that each step has its own name"
    return len(steps)
