"""Small scenes in whole numbers, the smallest first: fewest bodies, then edges, then steps, then the least numbers.

They are an enumeration, of each kind as far as its ranges go. The margin is 1, bodies are 1 high and 2 wide if nothing
else is said, ground is level but for a few slopes, and falls are one body high.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache
from itertools import product
from typing import Any

from properties.worlds.rows import located, string_graph
from properties.worlds.scenes import Shape, Stand, profile_of_heights, stands
from reference.world import LevelError, World, world_of
from spec.body import Body, EdgePosition, Level
from spec.conditions import ONE_STRING, PLANE_START
from spec.graph import Direction, EdgeType, ExplicitEdge, Graph, Vertex, explicit, polyline
from spec.guidelines import GUIDELINES
from spec.transform import with_numbers

Step = tuple[str, int] | Direction
"""A request of a body for a signed distance, or a tick with a key held."""

MARGIN, RIGHT, LEFT = 1, Direction.RIGHT, Direction.LEFT
Place = tuple[Stand, int, int]
"""What a body stands on, where its left border is there, and how wide it is."""


@dataclass(frozen=True)
class Scene:
    """A level and what is asked in it.

    Attributes:
        guided: its ground is level, it keeps all guidelines, and starts in order.
        plain: it is one string without ledges, and nobody rides.
    """

    level: Level[Any]
    steps: tuple[Step, ...]
    guided: bool
    plain: bool

    @property
    def judged(self) -> bool:
        """Whether invariants are judged in it: it keeps the guidelines, and has one step, at most half round a ring."""
        return self.guided and len(self.steps) == 1 and not self.goes_far_round

    @property
    def goes_far_round(self) -> bool:
        """Whether more is asked than half of a ring."""
        circumference, step = self.level.graph.circumference, self.steps[0]
        return circumference is not None and isinstance(step, tuple) and bool(2 * step[1] > circumference)

    @property
    def size(self) -> tuple[Any, ...]:
        """Bodies, ground edges, steps, then the sum of all numbers."""
        graph, bodies = self.level.graph, self.level.bodies
        grounds = [edge for edge in graph.edges if edge.type is EdgeType.GROUND]
        numbers = [*(edge.length for edge in grounds), *(1 for v in graph.vertices if v.y != 0)]
        numbers += [number for body in bodies for number in (abs(body.left.location), body.right.location, body.speed)]
        numbers += [abs(step[1]) for step in self.steps if isinstance(step, tuple)]
        return len(bodies), len(grounds), len(self.steps), sum(numbers)


def whole(graph: Graph[Any]) -> Graph[Any]:
    """A graph in whole numbers, which are quicker than fractions and as exact."""
    return with_numbers(Level(graph, Fraction(1), Fraction(1), ()), int, int).graph


def stepped_level(heights: Sequence[int], lengths: Sequence[int], places: Sequence[Place]) -> Level[Any] | None:
    """Ground edges at heights, with bodies on them and on each other; None if they cannot be so."""
    shape = Shape(tuple(Fraction(height) for height in heights), tuple(stand for stand, _, _ in places))
    graph = whole(profile_of_heights(shape, list(lengths)))
    grounds = [i for i, edge in enumerate(graph.edges) if edge.type is EdgeType.GROUND]
    bodies = []
    for i, (stand, left, width) in enumerate(places):
        edge = len(graph.edges) + stand.top if stand.top is not None else grounds[stand.edge or 0]
        right = along(graph, edge, left + width)
        bodies.append(Body(chr(65 + i), EdgePosition(edge, left), right, 0, 1))
    return valid(Level(graph, MARGIN, 1, tuple(bodies)))


def along(graph: Graph[Any], edge: int, location: int) -> EdgePosition[Any]:
    """A place on an edge, or on a ground edge after it."""
    while edge < len(graph.edges) and location > graph.edges[edge].length:
        following = graph.look_up(graph.edges[edge].right, RIGHT, EdgeType.GROUND)
        if not following:
            break
        edge, location = following[0], location - graph.edges[edge].length
    return EdgePosition(edge, location)


def valid(level: Level[Any]) -> Level[Any] | None:
    """The level, if bodies may start so, on their strings and in the plane."""
    try:
        world = world_of(level)
    except LevelError:
        return None
    return level if PLANE_START.holds(world, MARGIN) else None


def asked(level: Level[Any] | None, steps: Sequence[Step]) -> Iterator[Scene]:
    """The scenes of one step."""
    if level is not None:
        still = scene_in(level, ())
        yield from (replace(still, steps=(one,)) for one in steps)


def scene_in(level: Level[Any], steps: tuple[Step, ...]) -> Scene:
    """The scene of these steps in a level."""
    world = World(level)
    flat = all(edge.rise == 0 for edge in level.graph.edges if edge.type is EdgeType.GROUND)
    guided = flat and all(guideline.kept(world) for guideline in GUIDELINES)
    ridden = any(world.support(body) is not None for body in world.handles())
    return Scene(level, steps, guided, plain=bool(ONE_STRING.holds(world, MARGIN)) and not ridden)


def requests(*distances: int) -> list[Step]:
    """Requests of the first body."""
    return [("A", distance) for distance in distances]


def lefts(stand: Stand, lengths: Sequence[int], width: int) -> range:
    """Where a body's left border may be: on ground its edge, on a top from 1 before it."""
    return range(-1, width) if stand.top is not None else range(lengths[stand.edge or 0])


def stepped(
    heights: Sequence[Sequence[int]],
    lengths: Callable[[int], Iterator[Sequence[int]]],
    widths: Sequence[int],
    steps: Sequence[Step],
) -> Iterator[Scene]:
    """All scenes on ground of some heights and lengths, with bodies of these widths wherever they can be."""
    for high in heights:
        for long in lengths(len(high)):
            for chosen in stands(len(widths), len(high)):
                spans = [lefts(stand, long, widths[stand.top or 0]) for stand in chosen]
                for at in product(*spans):
                    yield from asked(stepped_level(high, long, list(zip(chosen, at, widths, strict=True))), steps)


def all_of(*choices: int) -> Callable[[int], Iterator[Sequence[int]]]:
    """Every edge with every one of these lengths."""
    return lambda edges: product(choices, repeat=edges)


def middle(outer: int, *choices: int) -> Callable[[int], Iterator[Sequence[int]]]:
    """The outer edges of one length, those between of each of these."""
    return lambda edges: ((outer, *inner, outer) for inner in product(choices, repeat=edges - 2))


ONE_EDGE, TWO_EDGES = ((0,),), ((0, 0), (0, 1), (1, 0))
THREE_EDGES = ((0, 0, 0), (0, 0, 1), (0, 1, 0), (1, 0, 0), (1, 0, 1), (1, 1, 0), (0, 1, 1))


def alone() -> Iterator[Scene]:
    """One body on up to three edges."""
    yield from stepped((*ONE_EDGE, *TWO_EDGES), all_of(1, 2, 3), (2,), requests(1, 2, 3, 4, 5))
    yield from stepped(THREE_EDGES, all_of(1, 3), (2,), requests(3, 4, 7))


def pairs() -> Iterator[Scene]:
    """Two bodies on up to three edges, the first of which is asked."""
    yield from stepped(ONE_EDGE, all_of(6), (2, 2), requests(1, 2, 4))
    yield from stepped(TWO_EDGES[:1], all_of(3, 4), (2, 2), requests(2, 4))
    yield from stepped(TWO_EDGES[1:], all_of(3, 5), (2, 2), requests(2, 4, 6))
    yield from stepped(((1, 0, 1), (0, 1, 0)), middle(3, 2, 4), (2, 2), requests(2, 5))


def pairs_of_widths() -> Iterator[Scene]:
    """Two bodies, one of which is wider."""
    for widths in ((2, 4), (4, 2)):
        yield from stepped((*ONE_EDGE, *TWO_EDGES), all_of(5), widths, requests(3, 6))


def wide_pairs() -> Iterator[Scene]:
    """Two bodies, both 3 wide, so that a jump can be longer than a move beyond the ledge."""
    yield from stepped(((1, 0),), all_of(4, 5), (3, 3), requests(5))


def overhanging() -> Iterator[Scene]:
    """A body that is wider than the top it stands on, and overhangs both of its corners."""
    places = [(Stand(top=1), -2, 5), (Stand(edge=0), 3, 2)]
    yield from asked(stepped_level((0,), (8,), places), requests(1, 2))


def triples() -> Iterator[Scene]:
    """Three bodies on up to two edges."""
    yield from stepped(ONE_EDGE, all_of(5), (2, 2, 2), requests(2))
    yield from stepped(((0, 1), (1, 0)), all_of(4), (2, 2, 2), requests(4))


def twice() -> Iterator[Scene]:
    """Two bodies, and two requests one after the other."""
    for first in stepped(TWO_EDGES[1:], all_of(3, 5), (2, 2), requests(4)):
        for second, then in ((("A", 4), ("A", 2)), (("B", 2), ("A", 4)), (("A", 4), ("B", 2))):
            yield replace(first, steps=(second, then))


def rings() -> Iterator[Scene]:
    """One to three bodies on a ring of one or two edges."""
    for lengths in ([7], [8], [9], [4, 4], [5, 4], [1, 8]):
        graph = string_graph(lengths, sum(lengths))
        for bodies in (1, 2, 3):
            for at in product(range(sum(lengths)), repeat=bodies - 1):
                held = tuple(body_at(i, left, lengths) for i, left in enumerate((0, *at)))
                yield from asked(valid(Level(graph, MARGIN, 1, held)), requests(1, 2, 3, 4, 6))


def body_at(index: int, left: int, lengths: list[int], speed: int = 0) -> Body[Any]:
    """A body on a ring."""
    return Body(chr(65 + index), located(lengths, left, True), located(lengths, left + 2, True), speed, 1)


def ticks() -> Iterator[Scene]:
    """One tick, or two, of two bodies of which one or both are characters."""
    for high, long in (((0,), (7,)), ((0,), (9,)), ((0, 1), (3, 3)), ((1, 0), (5, 3))):
        for scene in stepped([high], lambda _, long=long: iter([long]), (2, 2), requests(0)):  # type: ignore[misc]
            for speeds in ((1, 0), (2, 0), (1, 1), (1, 2), (1, 3)):
                bodies = tuple(replace(b, speed=v) for b, v in zip(scene.level.bodies, speeds, strict=True))
                for steps in ((RIGHT,), (RIGHT, RIGHT)):
                    yield replace(scene, level=replace(scene.level, bodies=bodies), steps=steps)


def wide_margins() -> Iterator[Scene]:
    """Two bodies with a margin of 3, on two edges, or with an edge between them that is shorter than that."""
    for lengths in ([5, 7], [5, 1, 6]):
        graph = whole(string_graph(lengths, None))
        for left in (7, 8):
            held = (body_along(graph, "A", 0, 4), body_along(graph, "B", left, 4))
            yield from asked(valid(Level(graph, 3, 1, held)), requests(1, 2))


def body_along(graph: Graph[Any], name: str, left: int, width: int, speed: int = 0) -> Body[Any]:
    """A body on the string of the first edge, so far from its beginning."""
    return Body(name, along(graph, 0, left), along(graph, 0, left + width), speed, 1)


def slopes() -> Iterator[Scene]:
    """A body on slopes of 3, 4 and 5, alone or with another on top."""
    for points in (
        [(0, 0), (4, 3)],
        [(0, 0), (3, 4)],
        [(0, 0), (4, 3), (8, 0)],
        [(0, 0), (5, 0), (8, 4)],
        [(0, 0), (4, 3), (8, 0), (8, -1), (12, -1)],
        [(0, 0), (4, 3), (4, 2), (8, 2)],
    ):
        graph = polyline([Vertex(Fraction(x), Fraction(y)) for x, y in points])
        top = len(graph.edges)
        for left in (0, 1, 3):
            ground = body_along(graph, "A", left, 4)
            rider: Body[Any] = replace(ground, name="B", left=EdgePosition(top, 1), right=EdgePosition(top, 3))
            for held in ((ground,), (ground, rider)):
                level = with_numbers(Level(graph, MARGIN, 1, held), Fraction, Fraction)
                yield from asked(valid(level), requests(1, 2, 6, 8))


def buttons() -> Iterator[Scene]:
    """A character across three edges, and a button on each of them."""
    graph = whole(string_graph([2, 1, 3], None))
    for edge in range(3):
        level = Level(graph, MARGIN, 1, (body_along(graph, "A", 1, 3, speed=1),), (along(graph, edge, 0),))
        yield from asked(valid(level), [RIGHT])


def odd_graphs() -> Iterator[Scene]:
    """Two ground edges that leave one vertex to the right; an edge whose left end is on the right."""
    for ends, points in (
        ([(0, 1), (0, 2)], [(0, 0), (4, 0), (4, 3)]),
        ([(0, 1)], [(4, 0), (0, 0)]),
    ):
        vertices = [Vertex(Fraction(x), Fraction(y)) for x, y in points]
        graph = explicit([ExplicitEdge(left, right) for left, right in ends], vertices)
        level = with_numbers(Level(graph, MARGIN, 1, (body_along(graph, "A", 0, 2),)), Fraction, Fraction)
        yield Scene(level, (("A", 1),), guided=False, plain=False)


@cache
def scenes() -> tuple[Scene, ...]:
    """All scenes, the smallest first."""
    on_level = (alone, pairs, pairs_of_widths, wide_pairs, overhanging, triples, twice, rings, ticks)
    kinds = (*on_level, wide_margins, slopes, buttons, odd_graphs)
    return tuple(sorted((scene for kind in kinds for scene in kind()), key=lambda scene: scene.size))
