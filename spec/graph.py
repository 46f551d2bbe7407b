"""The navigation graph: vertices, edges, and the look-up of what follows an edge (1.2, 6.1.3)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from enum import Enum, IntEnum
from fractions import Fraction
from math import isqrt
from typing import Generic

from spec.number import N


class Direction(IntEnum):
    """The two directions of graph space (6.1.1). Left to right is the order of a level's vertices (A58)."""

    LEFT = -1
    RIGHT = 1

    @property
    def opposite(self) -> Direction:
        """The other direction."""
        return Direction(-self)


class EdgeType(Enum):
    """Bodies move on ground edges and fall down fall edges (1.2, R2)."""

    GROUND = "ground"
    FALL = "fall"


@dataclass(frozen=True)
class Vertex(Generic[N]):
    """A point of the level's plane, unrolled where the level is a cylinder; y points up."""

    x: N
    y: N


@dataclass(frozen=True)
class Edge(Generic[N]):
    """An edge from its left to its right vertex (indices), with its length along the graph.

    `run` and `rise` are how far it goes to the right and up for each unit of its length. Under a ground edge the
    terrain is solid, down to `thickness` below it, or without end where that is None. `friction` is the coefficient of
    the ground, or None if it has none of its own (6.3.4; O9).
    """

    left: int
    right: int
    type: EdgeType
    length: N
    run: N
    rise: N
    thickness: N | None = None
    friction: N | None = None

    def towards(self, direction: Direction) -> int:
        """The vertex at the edge's end in a direction."""
        return self.right if direction is Direction.RIGHT else self.left


EdgeKey = tuple[int, Direction, EdgeType]


@dataclass(frozen=True)
class Graph(Generic[N]):
    """Vertices and edges; `circumference` is that of the cylinder on which the level lies, or None."""

    vertices: tuple[Vertex[N], ...]
    edges: tuple[Edge[N], ...]
    circumference: N | None = None
    table: dict[EdgeKey, list[int]] = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        """Make the dictionary of edges at start-up (6.1.3, R14)."""
        table: dict[EdgeKey, list[int]] = {}
        for index, edge in enumerate(self.edges):
            table.setdefault((edge.left, Direction.RIGHT, edge.type), []).append(index)
            table.setdefault((edge.right, Direction.LEFT, edge.type), []).append(index)
        object.__setattr__(self, "table", table)

    def look_up(self, vertex: int, direction: Direction, edge_type: EdgeType) -> Sequence[int]:
        """The edges of a type that leave a vertex in a direction, as a list (6.1.3, R14)."""
        return self.table.get((vertex, direction, edge_type), ())


class IrrationalLength(ValueError):
    """An edge whose length is not a rational number, so that nothing on it can be computed exactly."""

    def __init__(self, edge: int) -> None:
        """Remember the edge's place in the list of edges."""
        super().__init__(f"edge {edge} has an irrational length; choose vertices with a rational distance")
        self.edge = edge


class NoLength(ValueError):
    """An edge between two vertices at the same place."""

    def __init__(self, edge: int) -> None:
        """Remember the edge's place in the list of edges."""
        super().__init__(f"edge {edge} has no length")
        self.edge = edge


def rational_root(square: Fraction) -> Fraction | None:
    """The root of a rational number, or None where it is irrational."""
    above, below = isqrt(square.numerator), isqrt(square.denominator)
    root = Fraction(above, below)
    return root if root * root == square else None


def extent(left: Vertex[N], right: Vertex[N], shift: N) -> tuple[N, N]:
    """How far it is across and up from one vertex to another, which is moved to the right by `shift`."""
    return right.x + shift - left.x, right.y - left.y


@dataclass(frozen=True)
class ExplicitEdge:
    """An edge as a level names it: its ends, its type (by steepness if None), thickness and friction."""

    left: int
    right: int
    type: EdgeType | None = None
    thickness: Fraction | None = None
    friction: Fraction | None = None


def edge_between(
    vertices: Sequence[Vertex[Fraction]], named: ExplicitEdge, shift: Fraction, index: int
) -> Edge[Fraction]:
    """An edge between two vertices, the right one moved by `shift` (once round the cylinder, or 0).

    If no type is named, it is ground if its steepness is at most 60 degrees, else a fall edge (6.1.3; R30, A42).

    Raises:
        IrrationalLength: if the distance is irrational.
        NoLength: if it is 0.
    """
    across, up = extent(vertices[named.left], vertices[named.right], shift)
    length = rational_root(across * across + up * up)
    if length is None:
        raise IrrationalLength(index)
    if length == 0:
        raise NoLength(index)
    steep = up * up > 3 * across * across
    edge_type = named.type or (EdgeType.FALL if steep else EdgeType.GROUND)
    run, rise = across / length, up / length
    return Edge(named.left, named.right, edge_type, length, run, rise, named.thickness, named.friction)


def polyline(vertices: Sequence[Vertex[Fraction]], circumference: Fraction | None = None) -> Graph[Fraction]:
    """Connect a list of vertices from left to right, and round the cylinder if there is one (6.1.3; R30).

    Raises:
        IrrationalLength: if two consecutive vertices have an irrational distance.
    """
    ends = [ExplicitEdge(i, i + 1) for i in range(len(vertices) - 1)]
    if circumference is not None:
        ends.append(ExplicitEdge(len(vertices) - 1, 0))
    return explicit(ends, vertices, circumference)


def explicit(
    named: Sequence[ExplicitEdge], vertices: Sequence[Vertex[Fraction]], circumference: Fraction | None = None
) -> Graph[Fraction]:
    """The graph of named edges: with platforms, gaps and layers as one likes (6.1.3; R30, U8).

    On a cylinder, an edge whose right vertex is further to the left than its left one goes round.

    Raises:
        IrrationalLength: if the ends of an edge have an irrational distance.
        NoLength: if they are at the same place.
    """
    edges = []
    for index, edge in enumerate(named):
        goes_round = circumference is not None and (
            vertices[edge.right].x < vertices[edge.left].x or edge.right == edge.left
        )
        shift = circumference if goes_round and circumference is not None else Fraction(0)
        edges.append(edge_between(vertices, edge, shift, index))
    return Graph(tuple(vertices), tuple(edges), circumference)
