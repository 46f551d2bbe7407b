"""Small levels with ledges: their shape is given, all their horizontal sizes are arbitrary.

A shape is a list of heights, one for each level ground edge from left to right, joined by vertical fall edges, and
maybe a platform over the second edge; and for each body where it stands: on an edge or on the top of another body.
Heights are in body heights. The first body is asked to move to the right.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise, product
from typing import Any

from properties.given import Given
from spec.body import Body, EdgePosition, Level
from spec.graph import Direction, Edge, EdgeType, Graph, Vertex

ONE = Fraction(1)
HEIGHTS = (Fraction(0), ONE, ONE + ONE)


@dataclass(frozen=True)
class Stand:
    """Where a body stands: on a ground edge (by its place from the left), or on the top of an earlier body.

    On ground it may overhang the ledge on one side.
    """

    edge: int | None = None
    top: int | None = None
    overhang: Direction | None = None


@dataclass(frozen=True)
class Platform:
    """A floating platform over the second of three ground edges of height 0."""

    height: Fraction
    thickness: Fraction


@dataclass(frozen=True)
class Shape:
    """The shape of a scene; see the module. Edges are no shorter than the margin, unless they may be `short`."""

    heights: tuple[Fraction, ...]
    stands: tuple[Stand, ...]
    platform: Platform | None = None
    short: bool = False

    @property
    def size(self) -> tuple[int, int, int]:
        """Fewest bodies first, then fewest edges."""
        return (
            len(self.stands),
            len(self.heights) + (self.platform is not None),
            sum(s.top is not None for s in self.stands),
        )

    @property
    def has_riders(self) -> bool:
        """Whether a body stands on another."""
        return any(stand.top is not None for stand in self.stands)


def fall_edge(upper: int, lower: int, falls_right: bool, height: Fraction) -> Edge[Any]:
    """A vertical fall edge between two vertices."""
    left, right = (upper, lower) if falls_right else (lower, upper)
    return Edge(left, right, EdgeType.FALL, height, run=0, rise=-1 if falls_right else 1)


def ground_edge(left: int, right: int, length: Any, thickness: Fraction | None = None) -> Edge[Any]:
    """A level ground edge."""
    return Edge(left, right, EdgeType.GROUND, length, run=1, rise=0, thickness=thickness)


def profile_of_heights(shape: Shape, lengths: list[Any]) -> Graph[Any]:
    """Level ground at the heights of a shape, joined by vertical fall edges, with its platform."""
    vertices: list[Vertex[Any]] = []
    grounds: list[Edge[Any]] = []
    falls: list[Edge[Any]] = []
    along = lengths[0] * 0
    for place, (height, length) in enumerate(zip(shape.heights, lengths, strict=True)):
        before = shape.heights[place - 1] if place else None
        if before is None or before != height:
            vertices.append(Vertex(along, height))
        if before is not None and before != height:
            falls_right = before > height
            upper, lower = (
                (len(vertices) - 2, len(vertices) - 1) if falls_right else (len(vertices) - 1, len(vertices) - 2)
            )
            falls.append(fall_edge(upper, lower, falls_right, abs(before - height)))
        along = along + length
        vertices.append(Vertex(along, height))
        grounds.append(ground_edge(len(vertices) - 2, len(vertices) - 1, length))
    if shape.platform is not None:
        left, right, top = grounds[1].left, grounds[1].right, len(vertices)
        for foot in (left, right):
            vertices.append(Vertex(vertices[foot].x, vertices[foot].y + shape.platform.height))
        grounds.append(ground_edge(top, top + 1, lengths[1], shape.platform.thickness))
        falls.append(fall_edge(top, left, False, shape.platform.height))
        falls.append(fall_edge(top + 1, right, True, shape.platform.height))
    return Graph(tuple(vertices), (*grounds, *falls))


def scene(given: Given, shape: Shape, guided: bool) -> tuple[Level[Any], Any]:
    """Any level of a shape, and any distance asked. `guided`: one width, and no ground shorter than it (G1, G4)."""
    margin = given.number("margin")
    given.assume(margin > 0)
    lengths = [given.number(f"length of ground {place}") for place in range(len(shape.heights))]
    widths = [
        given.number("width") if guided else given.number(f"width of {chr(65 + i)}") for i in range(len(shape.stands))
    ]
    for width in widths:
        given.assume(width > margin)
    for length in lengths:
        given.assume(length > 0 if shape.short else length >= (widths[0] if guided else margin))
    graph = profile_of_heights(shape, lengths)
    ground = [i for i, edge in enumerate(graph.edges) if edge.type is EdgeType.GROUND]
    bodies = []
    for place, (stand, width) in enumerate(zip(shape.stands, widths, strict=True)):
        name, left = chr(65 + place), given.number(f"left of {chr(65 + place)}")
        edge = len(graph.edges) + stand.top if stand.top is not None else ground[stand.edge or 0]
        length = widths[stand.top] if stand.top is not None else graph.edges[edge].length
        if stand.overhang is Direction.LEFT:
            left = left * -1
            given.assume((left < 0) & (left + width > 0))
        if stand.top is not None or stand.overhang is Direction.RIGHT:
            given.assume(left < length)
            right = EdgePosition(edge, left + width)
            if stand.overhang is not None:
                given.assume(right.location > length)
        else:
            right = right_border(given, graph, edge, left + width)
            given.assume(left < length)
        bodies.append(Body(name, EdgePosition(edge, left), right, Fraction(0), height=ONE))
    asked = given.number("distance asked")
    return Level(graph, margin, ONE, tuple(bodies)), asked


def right_border(given: Given, graph: Graph[Any], edge: int, location: Any) -> EdgePosition[Any]:
    """A right border at a location from the beginning of an edge: on it or, where ground follows, on the next."""
    length = graph.edges[edge].length
    following = graph.look_up(graph.edges[edge].right, Direction.RIGHT, EdgeType.GROUND)
    if location <= length or not following:
        given.assume(location <= length)
        return EdgePosition(edge, location)
    given.assume(location - length <= graph.edges[following[0]].length)
    return EdgePosition(following[0], location - length)


def stands(bodies: int, edges: int) -> Iterator[tuple[Stand, ...]]:
    """All ways for bodies to stand on edges and on each other."""
    places = [Stand(edge=edge) for edge in range(edges)]
    for chosen in product(
        *[[*places, *(Stand(top=top) for top in range(bodies) if top != body)] for body in range(bodies)]
    ):
        if all(ends_on_ground(chosen, body) for body in range(bodies)):
            yield chosen


def ends_on_ground(chosen: tuple[Stand, ...], body: int) -> bool:
    """Whether a body stands, through others, on an edge."""
    for _ in chosen:
        top = chosen[body].top
        if top is None:
            return True
        body = top
    return False


def shapes(most_bodies: int, most_edges: int, guided: bool) -> list[Shape]:
    """All shapes up to a size, the smallest first. `guided`: steps of one body height, one layer (G2, G3, G5)."""
    found = []
    levels = (Fraction(0), ONE) if guided else HEIGHTS
    for edges in range(1, most_edges + 1):
        for heights in product(levels, repeat=edges):
            if min(heights) == 0 and all(a != b for a, b in pairwise(heights)):
                for bodies in range(1, most_bodies + 1):
                    found += [Shape(heights, chosen) for chosen in stands(bodies, edges)]
    if not guided:
        for height, thickness in product((Fraction(1, 2), ONE), (Fraction(0), Fraction(1, 4))):
            for bodies in range(1, most_bodies + 1):
                platform = Platform(height, thickness)
                found += [Shape((Fraction(0),) * 3, chosen, platform) for chosen in stands(bodies, 4)]
    return sorted(found, key=lambda shape: shape.size)
