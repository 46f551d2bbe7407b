"""Changes of a level that ought to change nothing: its mirror image, a moved picture, a split edge, other numbers."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from typing import Any

from spec.body import Body, EdgePosition, Level
from spec.graph import Graph, Vertex, polyline
from spec.number import N, zero_like
from spec.rules.velocity import Material, Motion


def with_borders(body: Body[N], change: Callable[[EdgePosition[N]], EdgePosition[N]]) -> Body[N]:
    """The body with both its borders changed."""
    return replace(body, left=change(body.left), right=change(body.right))


def vertex_count(graph: Graph[N]) -> int:
    """How many vertices the edges join."""
    return 1 + max(max(edge.left, edge.right) for edge in graph.edges)


def mirror(level: Level[N]) -> Level[N]:
    """The level seen from behind: left is right, and vertices and edges are counted from the other end."""
    graph = level.graph
    last = len(graph.edges) - 1
    names = vertex_count(graph) - 1
    vertices = tuple(Vertex(zero_like(v.x) - v.x, v.y) for v in reversed(graph.vertices))
    edges = tuple(
        replace(e, left=names - e.right, right=names - e.left, rise=e.rise * -1) for e in reversed(graph.edges)
    )

    def seen_from_behind(at: EdgePosition[N]) -> EdgePosition[N]:
        return EdgePosition(last - at.edge, graph.edges[at.edge].length - at.location)

    def turned(body: Body[N]) -> Body[N]:
        motion = None if body.motion is None else turned_round(body.motion)
        return replace(body, left=seen_from_behind(body.right), right=seen_from_behind(body.left), motion=motion)

    return replace(
        level,
        graph=Graph(vertices, edges, graph.circumference),
        bodies=tuple(turned(body) for body in level.bodies),
    )


def turned_round(motion: Motion[N]) -> Motion[N]:
    """The motion with left for right."""
    return replace(motion, velocity=motion.velocity * -1, force=motion.force * -1)


def shifted(vertex: Vertex[N], by: Vertex[N]) -> Vertex[N]:
    """A vertex moved by a vector."""
    return Vertex(vertex.x + by.x, vertex.y + by.y)


def moved(level: Level[Fraction], by: Vertex[Fraction]) -> Level[Fraction]:
    """The level moved by a vector in its plane, its edges made anew from its vertices."""
    vertices = [shifted(vertex, by) for vertex in level.graph.vertices]
    return replace(level, graph=polyline(vertices, level.graph.circumference))


def split(level: Level[N], edge: int, at: N, vertex: Vertex[N]) -> Level[N]:
    """The level with one edge split in two, `at` from its left end, by a new `vertex`.

    The new vertex and the new (right) edge come last in their lists.
    """
    old, middle = level.graph.edges[edge], vertex_count(level.graph)
    left = replace(old, right=middle, length=at)
    right = replace(old, left=middle, length=old.length - at)
    edges = list(level.graph.edges)
    edges[edge] = left

    def renamed(border: EdgePosition[N]) -> EdgePosition[N]:
        if border.edge != edge or border.location <= at:
            return border
        return EdgePosition(len(edges), border.location - at)

    graph = Graph((*level.graph.vertices, vertex), (*edges, right), level.graph.circumference)
    return replace(level, graph=graph, bodies=tuple(with_borders(body, renamed) for body in level.bodies))


def body_with_numbers(body: Body[Any], number: Callable[[Any], Any]) -> Body[Any]:
    """The body in other numbers."""
    moved = with_borders(body, lambda at: replace(at, location=number(at.location)))
    motion = None if body.motion is None else motion_with_numbers(body.motion, number)
    return replace(moved, speed=number(body.speed), height=number(body.height), motion=motion)


def motion_with_numbers(motion: Motion[Any], number: Callable[[Any], Any]) -> Motion[Any]:
    """The motion in other numbers."""
    own = motion.material
    material = None
    if own is not None:
        material = Material(
            friction=number(own.friction),
            drag=number(own.drag),
            damping=number(own.damping),
            slowest=number(own.slowest),
            fastest=None if own.fastest is None else number(own.fastest),
            mass=number(own.mass),
        )
    return Motion(number(motion.velocity), material, number(motion.gravity), number(motion.force))


def with_numbers(level: Level[Any], number: Callable[[Any], Any], slope: Callable[[Any], Any]) -> Level[Any]:
    """The level in other numbers; `slope` is for the run and rise of edges, which are constants of the graph."""

    def same_place(at: EdgePosition[Any]) -> EdgePosition[Any]:
        return replace(at, location=number(at.location))

    def maybe(value: Any) -> Any:
        return None if value is None else number(value)

    graph = level.graph
    edges = [
        replace(
            e,
            length=number(e.length),
            run=slope(e.run),
            rise=slope(e.rise),
            thickness=maybe(e.thickness),
            friction=maybe(e.friction),
        )
        for e in graph.edges
    ]
    vertices = [Vertex(number(v.x), number(v.y)) for v in graph.vertices]
    bodies = [body_with_numbers(body, number) for body in level.bodies]
    return Level(
        Graph(tuple(vertices), tuple(edges), maybe(graph.circumference)),
        number(level.margin),
        number(level.tick),
        tuple(bodies),
        tuple(same_place(at) for at in level.buttons),
    )


def in_floats(level: Level[Fraction]) -> Level[float]:
    """The level in binary floating point, as a game would hold it."""
    return with_numbers(level, float, float)
