"""A bank of invented deeds, right and wrong ones: what the invariants must say of each.

The deeds are at, and just beyond, the boundaries of the invariants, in exact numbers. No rule is run: the world after a
request is made up. So an invariant that lets something wrong pass, or blames what is right, is told by the deed.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from properties.worlds.rows import located, string_graph
from properties.worlds.scenes import Platform, Shape, profile_of_heights
from reference.world import World
from spec.body import Body, EdgePosition, Level
from spec.graph import Direction, Graph, Vertex, polyline
from spec.invariants import OF_ONE_REQUEST, Deed, Invariant
from spec.plane import IN_PLANE, SUPPORTS_END
from spec.profiles import Profile

ONE, HALF, TEN = Fraction(1), Fraction(1, 2), Fraction(10)
LEFT, RIGHT = Direction.LEFT, Direction.RIGHT
Places = tuple[tuple[Any, Any], ...]


@dataclass(frozen=True)
class Invented:
    """A deed that was made up, and the invariants that it breaks, without `invariant/`."""

    name: str
    deed: Deed[Any]
    breaks: str = ""
    judges: tuple[Invariant, ...] = OF_ONE_REQUEST


def row(places: Places, closed: bool = False) -> World[Fraction]:
    """Bodies from .. to on two edges of 10, on a line or a ring; the margin is 1."""
    lengths = [TEN, TEN]
    held = [
        Body(chr(65 + i), located(lengths, Fraction(left), closed), located(lengths, Fraction(right), closed), ONE, ONE)
        for i, (left, right) in enumerate(places)
    ]
    return World(Level(string_graph(lengths, 2 * TEN if closed else None), ONE, ONE, tuple(held)))


def deed(
    before: Places, after: Places, asked: Any, moved: Any = None, towards: Direction = RIGHT, closed: bool = False
) -> Deed[Fraction]:
    """A request of the first body, or to the left of the last one: of one body in its chain, by one rule."""
    mover = 0 if towards is RIGHT else len(before) - 1
    went = Fraction(asked if moved is None else moved)
    start, end = row(before, closed), row(after, closed)
    return Deed(start, end, mover, towards, Fraction(asked), went, 1, len(before), 1, Fraction(0))


def mirrored(one: Invented) -> Invented:
    """The mirror image of a deed on a line, of which the same holds."""
    start, end = (row(turned(world)) for world in (one.deed.before, one.deed.after))
    last = len(start.bodies) - 1
    image = replace(one.deed, before=start, after=end, body=last - one.deed.body, direction=one.deed.direction.opposite)
    return Invented(f"{one.name}, mirrored", image, one.breaks)


def turned(world: Any) -> Places:
    """The places of the bodies of a line, from the other end."""
    ends = [(2 * TEN - world.coordinate(one.right), 2 * TEN - world.coordinate(one.left)) for one in world.bodies]
    return tuple(reversed(ends))


A, B, C = (2, 4), (8, 10), (14, 16)
FULL, TURNED = ((0, 9), (10, 19)), ((1, 10), (11, 20))
STEP = deed((A, B), ((3, 5), B), 1)
PUSH = deed((A, B), ((6, 8), (9, 11)), 4)
ALONE = deed((A,), ((3, 5),), 1)

ON_A_LINE: tuple[Invented, ...] = (
    Invented("a step", STEP),
    Invented("a step that is not asked for", deed((A, B), (A, B), 0)),
    Invented("up to the margin", deed((A, B), ((5, 7), B), 3)),
    Invented("half a margin too far", deed((A, B), ((5 + HALF, 7 + HALF), B), 3 + HALF), "no-overlap"),
    Invented("up to the other", deed((A, B), ((6, 8), B), 4), "no-overlap"),
    Invented("into the other", deed((A, B), ((6 + HALF, 8 + HALF), B), 4 + HALF), "no-overlap order"),
    Invented("less than asked, for no reason", deed((A, B), ((3, 5), B), 2, 1), "as-far-as-possible"),
    Invented("more than asked", deed((A, B), ((3, 5), B), HALF, 1), "at-most-asked as-far-as-possible"),
    Invented("more than it says", deed((A, B), ((3, 5), B), 1, HALF), "at-most-asked as-far-as-possible"),
    Invented("less than it says", deed((A, B), ((2 + HALF, 4 + HALF), B), 1), "at-most-asked"),
    Invented("back", deed((A, B), ((1, 3), B), 1), "at-most-asked direction"),
    Invented("back, and says so", deed((A, B), ((1, 3), B), 1, -1), "direction as-far-as-possible"),
    Invented("nothing, but says it went back", deed((A,), (A,), 0, -1), "at-most-asked direction as-far-as-possible"),
    Invented(
        "nothing, but says it went back by a half",
        deed((A,), (A,), 0, -HALF),
        "at-most-asked direction as-far-as-possible",
    ),
    Invented("wider", deed((A, B), ((2, 5), B), 1), "rigid-width"),
    Invented("narrower", deed((A, B), ((4, 5), B), 1), "rigid-width"),
    Invented("another one is wider", deed((A, B), ((3, 5), (7, 10)), 1), "rigid-width"),
    Invented("pushed in contact", PUSH),
    Invented("pushed without contact", deed((A, B), ((5 + HALF, 7 + HALF), (9, 11)), 3 + HALF), "bystanders"),
    Invented("pushed back", deed((A, B), ((3, 5), (7, 9)), 1), "direction bystanders"),
    Invented("pushed too near", deed((A, B), ((6 + HALF, 8 + HALF), (9, 11)), 4 + HALF), "no-overlap bystanders"),
    Invented("the next but one moves", deed((A, B, C), ((3, 5), B, (15, 17)), 1), "bystanders"),
    Invented("three in contact", deed((A, B, C), ((10, 12), (13, 15), (16, 18)), 8)),
    Invented("the one behind moves", replace(deed((A, B), ((3, 5), (9, 11)), 1), body=1), "bystanders"),
    Invented("up to the wall", deed((A,), ((18, 20),), 20, 16)),
    Invented("not quite up to the wall", deed((A,), ((17, 19),), 20, 15), "as-far-as-possible"),
    Invented(
        "not quite up to the wall, by a half",
        deed((A,), ((17 + HALF, 19 + HALF),), 20, 15 + HALF),
        "as-far-as-possible",
    ),
    Invented("a row up to the wall", deed((A, B), ((15, 17), (18, 20)), 20, 13)),
    Invented("a row not up to the wall", deed((A, B), ((14, 16), (17, 19)), 20, 12), "as-far-as-possible"),
    Invented(
        "a row up to the wall, with a hole", deed((A, B), ((14, 16), (18, 20)), 20, 12), "bystanders as-far-as-possible"
    ),
    Invented("contact at the limit", replace(deed((A, B), ((5, 7), B), 5, 3), limit=1)),
    Invented("contact, not at the limit", replace(deed((A, B), ((5, 7), B), 5, 3), limit=2), "as-far-as-possible"),
    Invented("no contact at the limit", replace(deed((A, B), ((4, 6), B), 5, 2), limit=1), "as-far-as-possible"),
    Invented(
        "no contact at the limit, by a half",
        replace(deed((A, B), ((4 + HALF, 6 + HALF), B), 5, 2 + HALF), limit=1),
        "as-far-as-possible",
    ),
    Invented("two of three at the limit", replace(deed((A, B, C), ((8, 10), (11, 13), C), 9, 6), limit=2)),
    Invented("a chain of all", replace(STEP, depth=2)),
    Invented("a chain with one twice", replace(STEP, depth=3, limit=5), "termination"),
    Invented("a chain beyond the limit", replace(STEP, depth=2, limit=1), "termination"),
    Invented("as many rules as may fire", replace(STEP, fired=72)),
    Invented("one rule too many", replace(STEP, fired=73), "rule-count"),
    Invented("as many rules as may fire of one body", replace(ALONE, fired=24)),
    Invented("one rule too many of one body", replace(ALONE, fired=25), "rule-count"),
    Invented("from the wall", deed(((0, 2),), ((18, 20),), 18)),
)


def off_the_graph(left: EdgePosition[Fraction], right: EdgePosition[Fraction]) -> Deed[Fraction]:
    """A body that is put anywhere."""
    world = row((A,))
    level = replace(world.level, bodies=(Body("A", left, right, ONE, ONE),))
    return replace(ALONE, before=World(level), after=World(level), asked=ONE * 0, moved=ONE * 0)


OFF: tuple[Invented, ...] = (
    Invented("from end to end of an edge", off_the_graph(EdgePosition(0, ONE * 0), EdgePosition(0, TEN))),
    Invented("left of its edge", off_the_graph(EdgePosition(0, HALF * -1), EdgePosition(0, ONE)), "on-graph"),
    Invented("beyond its edge", off_the_graph(EdgePosition(0, ONE), EdgePosition(0, TEN + HALF)), "on-graph"),
)


def tolerant(one: Invented, by: Any, breaks: str) -> Invented:
    """The same, with a tolerance."""
    return Invented(f"{one.name}, within {by}", replace(one.deed, tolerance=Fraction(by)), breaks)


NEARLY = Invented(
    "a circle with half a margin of room",
    deed(((0, 9), (10, 18 + HALF)), ((1, 10), (11, 19 + HALF)), 1, closed=True),
)

RING: tuple[Invented, ...] = (
    Invented("round to itself", deed(((0, 8), (10, 18)), ((2, 10), (11, 19)), 5, 2, closed=True)),
    Invented(
        "not round to itself", deed(((0, 8), (10, 18)), ((1, 9), (10, 18)), 5, 1, closed=True), "as-far-as-possible"
    ),
    Invented("a full circle", deed(FULL, FULL, 5, 0, closed=True)),
    Invented("a full circle that says it moved", deed(FULL, FULL, 5, 1, closed=True), "at-most-asked full-circle"),
    Invented("a full circle that turns", deed(FULL, TURNED, 1, closed=True), "full-circle"),
    Invented("a circle that is not full", deed(((0, 9), (10, 18)), ((1, 10), (11, 19)), 1, closed=True)),
    Invented("a full circle that turns unsaid", deed(FULL, TURNED, 1, 0, closed=True), "at-most-asked full-circle"),
    Invented("a circle with room before the next", deed(((0, 8), (10, 19)), ((1, 9), (10, 19)), 1, closed=True)),
    Invented("a row in contact on a line", deed(((2, 4), (5, 7)), ((3, 5), (6, 8)), 1)),
    tolerant(NEARLY, "1/4", ""),
    tolerant(NEARLY, "1/2", "full-circle"),
    Invented("alone on a ring", deed((A,), ((3, 5),), 1, closed=True)),
    Invented("alone on a ring, and stops", deed((A,), ((3, 5),), 2, 1, closed=True), "as-far-as-possible"),
)


WITHIN: dict[str, tuple[str, str]] = {
    "half a margin too far": ("no-overlap", ""),
    "into the other": ("no-overlap order", "no-overlap"),
    "more than asked": ("at-most-asked as-far-as-possible", ""),
    "more than it says": ("at-most-asked as-far-as-possible", ""),
    "nothing, but says it went back by a half": ("at-most-asked direction as-far-as-possible", ""),
    "left of its edge": ("on-graph", ""),
    "beyond its edge": ("on-graph", ""),
    "not quite up to the wall, by a half": ("as-far-as-possible", ""),
    "no contact at the limit, by a half": ("as-far-as-possible", ""),
}
"""Deeds that are off by a half: what they break within a quarter, and within a half."""

TOLERANT: tuple[Invented, ...] = tuple(
    tolerant(one, by, breaks)
    for one in (*ON_A_LINE, *OFF)
    for by, breaks in zip(("1/4", "1/2"), WITHIN.get(one.name, ()), strict=False)
)


Standing = tuple[int, Any, Any]
"""The edge on which a body stands, and its borders there."""

STAIRS = profile_of_heights(Shape((ONE, ONE * 0), ()), [TEN, TEN])


def ground(*points: tuple[int, int]) -> Graph[Fraction]:
    """A string of edges from point to point."""
    return polyline([Vertex(Fraction(x), Fraction(y)) for x, y in points])


HILL, SLOPE = ground((0, 0), (8, 0), (12, 3), (18, 3)), ground((0, 3), (6, 3), (10, 0), (18, 0))
CLIFF = ground((0, 0), (4, 3), (4, -2), (14, -2))
UP = "never-raised height-kept"
UPPER, LOWER, ON_A = 0, 1, len(STAIRS.edges)


def scene(graph: Graph[Any], *standings: Standing, height: Any = ONE) -> World[Any]:
    """Bodies on the edges of a graph; `height` is that of the second."""
    heights = [ONE, Fraction(height), ONE]
    held = [
        Body(chr(65 + i), EdgePosition(edge, Fraction(left)), EdgePosition(edge, Fraction(right)), ONE, heights[i])
        for i, (edge, left, right) in enumerate(standings)
    ]
    return World(Level(graph, ONE, ONE, tuple(held)))


def seen(name: str, world: World[Any], breaks: str = "", before: Any = None, asked: Any = 0, by: Any = 0) -> Invented:
    """What the invariants in the plane say of a world after a request of the first body to the right."""
    start = world if before is None else before
    made = Deed(start, world, 0, RIGHT, Fraction(asked), Fraction(asked), 1, 1, 1, Fraction(by))
    return Invented(name, made, breaks, IN_PLANE)


def platform(thickness: Any) -> World[Any]:
    """A body of height 1 under a platform, the top of which is at 5/4."""
    above = Platform(Fraction(5, 4), Fraction(thickness))
    graph = profile_of_heights(Shape((ONE * 0,) * 3, (), above), [TEN, TEN, TEN])
    return scene(graph, (1, 4, 6))


def ring_of(gap: Any) -> World[Any]:
    """Two bodies on a ring, with a gap across its seam."""
    return row(((0, 8), (10, 20 - Fraction(gap))), closed=True)


def beside(place: Any) -> World[Any]:
    """A body that overhangs the stairs by 1, and a taller one below, from a place on."""
    return scene(STAIRS, (UPPER, 9, 11), (LOWER, place, 3), height="3/2")


def stepped(name: str, rear: Any, breaks: str = "", by: Any = 0) -> Invented:
    """A step of 1 on level ground that is asked of a body with its rear border at 1."""
    return seen(name, scene(STAIRS, (UPPER, rear, 4)), breaks, scene(STAIRS, (UPPER, 1, 3)), 1, by)


def climbed(name: str, breaks: str = "", by: Any = 0) -> Invented:
    """A way of 15 up the hill, which is 3 high."""
    return seen(name, scene(HILL, (2, 1, 3)), breaks, scene(HILL, (0, 1, 3)), 15, by)


INTO = scene(STAIRS, (LOWER, -HALF, 2))
TOWER = ((ON_A, 0, 2), (ON_A + 1, 0, 2))
CARRIED = (len(HILL.edges), 0, 2)

PLANE: tuple[Invented, ...] = (
    seen("above the other", scene(STAIRS, (UPPER, 9, 11), (LOWER, 0, 3))),
    seen("above the other, which is taller", beside(HALF), "plane-apart plane-margin"),
    seen("into the other, within a quarter", beside(HALF), "plane-apart plane-margin", by="1/4"),
    seen("into the other, within a half", beside(HALF), "plane-margin", by="1/2"),
    seen("beside the other", beside(1), "plane-margin"),
    seen("almost a margin from the other", beside("3/2"), "plane-margin"),
    seen("almost a margin, within a quarter", beside("3/2"), "plane-margin", by="1/4"),
    seen("almost a margin, within a half", beside("3/2"), by="1/2"),
    seen("a margin from the other", beside(2)),
    seen("into the wall", INTO, "terrain"),
    seen("into the wall, within a quarter", INTO, "terrain", by="1/4"),
    seen("into the wall, within a half", INTO, by="1/2"),
    seen("at the wall", scene(STAIRS, (LOWER, 0, 2))),
    seen("under a platform", platform("1/4")),
    seen("under a platform that is too low", platform("1/2"), "terrain"),
    seen("at the foot of a slope", scene(SLOPE, (2, 0, 2))),
    seen("below the top of a slope", scene(CLIFF, (2, 0, 2))),
    seen("a margin across the seam", ring_of(1)),
    seen("less than a margin across the seam", ring_of(HALF), "plane-margin"),
    seen("over the seam", row(((3, 8), (10, 21)), closed=True)),
    seen("over the seam, onto the other", row(((0, 8), (10, 21)), closed=True), "plane-apart plane-margin"),
    seen("over the seam, onto one behind", row(((10, 21), (0, 8)), closed=True), "plane-apart plane-margin"),
    climbed("uphill", "never-raised height-kept"),
    climbed("uphill, within 2", "never-raised height-kept", by=2),
    climbed("uphill, within 3", by=3),
    seen("fallen", scene(STAIRS, (LOWER, 0, 2)), "", scene(STAIRS, (UPPER, 8, 10)), 2),
    seen("risen", scene(STAIRS, (UPPER, 8, 10)), "never-raised horizontal", scene(STAIRS, (LOWER, 0, 2)), 2),
    seen("downhill", scene(HILL, (0, 1, 3)), "height-kept horizontal", scene(HILL, (2, 1, 3)), 15),
    seen("carried down", scene(STAIRS, (LOWER, 0, 2), *TOWER), "", scene(STAIRS, (UPPER, 8, 10), *TOWER), 2),
    seen("carried uphill", scene(HILL, (2, 1, 3), CARRIED), UP, scene(HILL, (0, 1, 3), CARRIED), 15),
    stepped("a step in the plane", 2),
    stepped("too far in the plane", "5/2", "horizontal"),
    stepped("too far, within a quarter", "5/2", "horizontal", by="1/4"),
    stepped("too far, within a half", "5/2", by="1/2"),
    stepped("back in the plane", HALF, "horizontal"),
    stepped("back, within a quarter", HALF, "horizontal", by="1/4"),
    stepped("back, within a half", HALF, by="1/2"),
)


@dataclass(frozen=True)
class Chain:
    """What stands on what: a body for each place, and what it stands on."""

    below: tuple[int | None, ...]

    def handles(self) -> range:
        """All bodies."""
        return range(len(self.below))

    def support(self, body: int) -> int | None:
        """What a body stands on."""
        return self.below[body]


def chained(name: str, breaks: str, *below: int | None) -> Invented:
    """Whether the supports of bodies end on the ground."""
    world: Any = Chain(below)
    return Invented(name, replace(STEP, before=world, after=world), breaks, (SUPPORTS_END,))


CHAINS: tuple[Invented, ...] = (
    chained("one on another, on the ground", "", 1, None),
    chained("a tower", "", 1, 2, 3, None),
    chained("each on the other", "supports-end", 1, 0),
    chained("three in a circle, and one beside", "supports-end", None, 2, 3, 1),
)


def bank() -> tuple[Invented, ...]:
    """All deeds."""
    return (*ON_A_LINE, *map(mirrored, ON_A_LINE), *OFF, *RING, *TOLERANT, *PLANE, *CHAINS)


def broken(one: Invented) -> set[str]:
    """The invariants that a deed breaks, of those that are to judge it."""
    return {judge.id.removeprefix("invariant/") for judge in one.judges if not judge.holds(one.deed)}


def invariants_judge(profile: Profile) -> int:
    """Each invariant says of each deed of the bank what is to be said of it."""
    deeds = bank()
    for one in deeds:
        wrong = ", ".join(sorted(broken(one) ^ set(one.breaks.split())))
        assert not wrong, f"{one.name}: {wrong}"
    return len(deeds)
