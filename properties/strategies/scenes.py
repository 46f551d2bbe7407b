"""Random levels with ledges, pits and stacks."""

from __future__ import annotations

from fractions import Fraction

from hypothesis import assume, strategies as st

from properties.strategies.rows import multiples
from reference.world import LevelError, world_of
from spec.body import Body, EdgePosition, Level
from spec.conditions import PLANE_START
from spec.graph import EdgeType, Graph, Vertex, polyline

ONE = Fraction(1)
GRID = 8


@st.composite
def grounds(draw: st.DrawFn) -> Graph[Fraction]:
    """Level ground at heights from 0 to 2 body heights, joined by vertical fall edges, or some of it by ground."""
    vertices, along, height = [], Fraction(0), draw(st.integers(0, 2))
    for step in draw(st.lists(st.sampled_from((1, 2, 1, 2, 0)), min_size=2, max_size=5)):
        height = (height + step) % 3
        vertices.append(Vertex(along, Fraction(height)))
        along += ONE / 2 + draw(multiples(GRID, 3))
        vertices.append(Vertex(along, Fraction(height)))
    kept = [v for i, v in enumerate(vertices) if i == 0 or v != vertices[i - 1]]
    return polyline(kept)


@st.composite
def bodies_on(draw: st.DrawFn, graph: Graph[Fraction], margin: Fraction) -> list[Body[Fraction]]:
    """One to five bodies, on the ground from left to right with room between them, or on tops."""
    edges = [i for i, edge in enumerate(graph.edges) if edge.type is EdgeType.GROUND]
    found: list[Body[Fraction]] = []
    used: dict[int, Fraction] = {}
    for number in range(draw(st.integers(2, 5))):
        width = draw(st.sampled_from((ONE, ONE, ONE / 2, 2 * ONE)))
        on_top = bool(found) and draw(st.integers(0, 3)) == 0
        edge = len(graph.edges) + draw(st.integers(0, len(found) - 1)) if on_top else draw(st.sampled_from(edges))
        left = used.get(edge, Fraction(0)) + draw(st.sampled_from((Fraction(0), ONE / 4, ONE)))
        length = graph.edges[edge].length if not on_top else widths(found, edge - len(graph.edges))
        if left + width > length and not (on_top and left < length):
            continue
        used[edge] = left + width + margin
        speed = Fraction(draw(st.sampled_from((0, 25))))
        name = chr(65 + number)
        found.append(Body(name, EdgePosition(edge, left), EdgePosition(edge, left + width), speed, ONE))
    assume(found)
    return found


def widths(found: list[Body[Fraction]], body: int) -> Fraction:
    """The width of a body that stands on one edge."""
    return found[body].right.location - found[body].left.location


@st.composite
def levels_with_ledges(draw: st.DrawFn) -> Level[Fraction]:
    """A valid level whose bodies are apart and outside terrain, in the graph and in the plane."""
    graph, margin = draw(grounds()), Fraction(draw(st.sampled_from((1, 2, 4))), GRID)
    level = Level(graph, margin, Fraction(1, 50), tuple(draw(bodies_on(graph, margin))))
    try:
        world = world_of(level)
    except LevelError:
        assume(False)
    assume(PLANE_START.holds(world, Fraction(0)))
    return level
