"""The levels that the theorem table speaks of: shapes within the guidelines and beyond, all their sizes arbitrary.

A shape is one ground after another from left to right, each as much higher or lower than the last as its step says,
and where each body stands. The first body moves to the right, and it, or what carries it, stands on the leftmost
ground or on a platform: a motion to the right meets nothing that lies to the left of it. Mirror images need no
shapes of their own (`claim/mirror`). Bodies may overhang ledges and tops at the start.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import product
from typing import Any

from properties.given import Given
from properties.worlds.scenes import Stand, ends_on_ground
from spec.body import Body, EdgePosition, Level
from spec.graph import Direction, Edge, EdgeType, Graph, Vertex
from spec.invariants import every
from spec.number import Truth

ZERO, HALF, ONE, TWO = Fraction(0), Fraction(1, 2), Fraction(1), Fraction(2)
LEVEL = (ONE, ZERO)
SLANT = Fraction(5, 12)
RISING, SINKING = (Fraction(4, 5), Fraction(3, 5)), (Fraction(4, 5), Fraction(-3, 5))
MOVER, RIGHT = 0, Direction.RIGHT


@dataclass(frozen=True)
class Shape:
    """The shape of a level; see the module.

    Attributes:
        steps: by how much each ground but the first is higher than the last; 0 joins the two.
        stands: where the bodies stand: on a ground, a platform after all grounds, or another body.
        slant: how far each fall edge runs outward for each body height.
        tilt: the direction of the last ground, if it is not level.
        platform: the thickness of a floor one body height above the second of three grounds, if there is one.
        sizes: whether widths are one and grounds no shorter (G1, G4); else they are arbitrary.
    """

    steps: tuple[Fraction, ...]
    stands: tuple[Stand, ...]
    slant: Fraction = ZERO
    tilt: tuple[Fraction, Fraction] | None = None
    platform: Fraction | None = None
    sizes: bool = False

    @property
    def size(self) -> tuple[int, int, int]:
        """Fewest bodies first, then fewest edges, then fewest bodies on others."""
        edges = len(self.steps) + 1 + (self.platform is not None)
        return len(self.stands), edges, sum(stand.top is not None for stand in self.stands)


def ground(left: int, right: int, length: Any, along: tuple[Fraction, Fraction], thickness: Any = None) -> Edge[Any]:
    """A ground edge in a direction."""
    return Edge(left, right, EdgeType.GROUND, length, *along, thickness=thickness)


def fall(left: int, right: int, step: Fraction, slant: Fraction = ZERO) -> Edge[Any]:
    """A fall edge between two vertices, which runs outward by its slant."""
    stretch = Fraction(13, 12) if slant else ONE
    rise = (ONE if step > 0 else -ONE) / stretch
    return Edge(left, right, EdgeType.FALL, abs(step) * stretch, slant / stretch, rise)


def terrain_of(shape: Shape, lengths: list[Any]) -> Graph[Any]:
    """The grounds of a shape, joined or with fall edges between them, and its platform."""
    vertices = [Vertex(lengths[0] * 0, ZERO)]
    grounds: list[Edge[Any]] = []
    falls: list[Edge[Any]] = []
    for place, length in enumerate(lengths):
        step = shape.steps[place - 1] if place else ZERO
        if step:
            last = vertices[-1]
            vertices.append(Vertex(last.x + abs(step) * shape.slant, last.y + step))
            falls.append(fall(len(vertices) - 2, len(vertices) - 1, step, shape.slant))
        along = shape.tilt if shape.tilt and place == len(lengths) - 1 else LEVEL
        start = vertices[-1]
        up = length * along[1] if along[1] else ZERO
        vertices.append(Vertex(start.x + length * along[0], start.y + up))
        grounds.append(ground(len(vertices) - 2, len(vertices) - 1, length, along))
    if shape.platform is not None:
        left, right, top = grounds[1].left, grounds[1].right, len(vertices)
        vertices += [Vertex(vertices[foot].x, vertices[foot].y + ONE) for foot in (left, right)]
        grounds.append(ground(top, top + 1, lengths[1], LEVEL, shape.platform))
        falls += [fall(left, top, ONE), fall(top + 1, right, -ONE)]
    return Graph(tuple(vertices), (*grounds, *falls))


def any_level(given: Given, shape: Shape) -> tuple[Level[Any], Any]:
    """Any level of a shape, and any distance asked."""
    margin = given.number("margin")
    lengths = [given.number(f"length of ground {place}") for place in range(len(shape.steps) + 1)]
    names = [chr(65 + place) for place in range(len(shape.stands))]
    widths = [given.number("width" if shape.sizes else f"width of {name}") for name in names]
    shortest = widths[0] if shape.sizes else margin
    given.assume(every([margin > 0, *(width > margin for width in widths), *(one >= shortest for one in lengths)]))
    graph = terrain_of(shape, lengths)
    bodies = [
        body_at(given, graph, name, width, place_of(graph, stand, widths))
        for name, width, stand in zip(names, widths, shape.stands, strict=True)
    ]
    return Level(graph, margin, ONE, tuple(bodies)), given.number("distance asked")


def place_of(graph: Graph[Any], stand: Stand, widths: list[Any]) -> tuple[int, Any]:
    """The edge on which a body stands, and its length."""
    if stand.top is not None:
        return len(graph.edges) + stand.top, widths[stand.top]
    edge = stand.edge or 0
    return edge, graph.edges[edge].length


def body_at(given: Given, graph: Graph[Any], name: str, width: Any, place: tuple[int, Any]) -> Body[Any]:
    """A body whose left border is anywhere on an edge, or beyond its left end where that is a ledge or a corner."""
    edge, length = place
    left, overhangs = given.number(f"left of {name}"), is_ledge(graph, edge, Direction.LEFT)
    if overhangs:
        left = left - width
    right, fits = right_border(graph, edge, left + width)
    given.assume(every([left < length, left + width > 0, fits]))
    return Body(name, EdgePosition(edge, left), right, ZERO, height=ONE)


def is_ledge(graph: Graph[Any], edge: int, direction: Direction) -> bool:
    """Whether a fall edge leads down at an end of an edge, or the edge is a top."""
    if edge >= len(graph.edges):
        return True
    falls = graph.look_up(graph.edges[edge].towards(direction), direction, EdgeType.FALL)
    joined = graph.look_up(graph.edges[edge].towards(direction), direction, EdgeType.GROUND)
    return not joined and any(graph.edges[fall].rise * direction < 0 for fall in falls)


def right_border(graph: Graph[Any], edge: int, location: Any) -> tuple[EdgePosition[Any], Truth]:
    """A right border at a location, on its edge, on the next, or beyond a ledge or a corner; and whether it fits."""
    if is_ledge(graph, edge, Direction.RIGHT):
        return EdgePosition(edge, location), True
    length = graph.edges[edge].length
    following = graph.look_up(graph.edges[edge].right, Direction.RIGHT, EdgeType.GROUND)
    if not following or location <= length:
        return EdgePosition(edge, location), location <= length
    fits = is_ledge(graph, following[0], Direction.RIGHT) or location - length <= graph.edges[following[0]].length
    return EdgePosition(following[0], location - length), fits


def stands(bodies: int, grounds: int, starts: tuple[int, ...]) -> Iterator[tuple[Stand, ...]]:
    """All ways for bodies to stand of which the first, or what carries it, is on one of the grounds to start from."""
    places = [Stand(edge=edge) for edge in range(grounds)]
    tops = [Stand(top=top) for top in range(bodies)]
    for chosen in product(*[[*places, *tops] for _ in range(bodies)]):
        if all(ends_on_ground(chosen, body) for body in range(bodies)) and carried_by(chosen).edge in starts:
            yield chosen


def carried_by(chosen: tuple[Stand, ...]) -> Stand:
    """Where the mover, or what carries it, stands on the ground."""
    stand = chosen[MOVER]
    while stand.top is not None:
        stand = chosen[stand.top]
    return stand


def outlines(steps: tuple[Fraction, ...], edges: int) -> Iterator[tuple[Fraction, ...]]:
    """All sequences of steps of up to so many grounds."""
    for count in range(edges):
        yield from product(steps, repeat=count)


def in_guidelines(bodies: int, edges: int) -> list[Shape]:
    """Steps of one body height, one layer, level ground: G2, G3 and G5 are kept."""
    return [shape for steps in outlines((ZERO, ONE, -ONE), edges) for shape in on(steps, bodies)]


def on(steps: tuple[Fraction, ...], bodies: int, sizes: bool = False) -> list[Shape]:
    """All ways for up to so many bodies to stand on grounds with such steps between them."""
    counts = range(1, bodies + 1)
    return [Shape(steps, chosen, sizes=sizes) for count in counts for chosen in stands(count, len(steps) + 1, (0,))]


def of_three(outlined: Sequence[tuple[Fraction, ...]]) -> list[Shape]:
    """Three bodies of one width on long grounds (G1, G4); the two that do not move are told apart by nothing."""
    found: dict[tuple[Fraction, ...], set[frozenset[tuple[Stand, ...]]]] = {}
    shapes = []
    for steps in outlined:
        for chosen in stands(3, len(steps) + 1, (0,)):
            alike = frozenset((chosen, exchanged(chosen)))
            if alike not in found.setdefault(steps, set()):
                found[steps].add(alike)
                shapes.append(Shape(steps, chosen, sizes=True))
    return shapes


def exchanged(chosen: tuple[Stand, ...]) -> tuple[Stand, ...]:
    """The same stands of three bodies, the last two of which have changed names."""
    names = {None: None, 0: 0, 1: 2, 2: 1}
    first, second, third = (Stand(edge=stand.edge, top=names[stand.top]) for stand in chosen)
    return first, third, second


def with_other_falls(bodies: int) -> list[Shape]:
    """Fall edges that are higher or lower than a body, or slant: G2 is broken."""
    odd = [(-TWO,), (-HALF,), (TWO,), (HALF,), (-ONE, TWO), (-ONE, HALF), (-TWO, TWO)]
    slanted = [(-ONE,), (ONE,), (-ONE, ONE)]
    leaning = [replace(shape, slant=SLANT) for steps in slanted for shape in on(steps, bodies)]
    return [*(shape for steps in odd for shape in on(steps, bodies)), *leaning]


def with_tilted_landings(bodies: int) -> list[Shape]:
    """A fall edge ends in a slope: G3 is broken."""
    return [replace(shape, tilt=tilt) for tilt in (RISING, SINKING) for shape in on((-ONE,), bodies)]


def with_platforms(bodies: int) -> list[Shape]:
    """A floor one body height above another: G5 is broken."""
    return [
        Shape((ZERO, ZERO), chosen, platform=thickness)
        for count, thickness in ((1, ONE / 4), *((count, ZERO) for count in range(1, bodies + 1)))
        for chosen in stands(count, 4, (0, 3))
    ]
