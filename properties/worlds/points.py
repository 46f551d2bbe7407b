"""Small levels of bodies without width: their shapes are those of the other scenes, all else is arbitrary."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from properties.given import Given
from properties.worlds.scenes import ONE, Shape, profile_of_heights
from spec.body import Body, EdgePosition, Level
from spec.graph import EdgeType


def scene_of_points(given: Given, shape: Shape) -> tuple[Level[Any], Any]:
    """Any level of a shape in which both borders of each body are at one place, and any distance asked.

    Nobody stands on another: the top of a point is none.
    """
    margin = given.number("margin")
    given.assume(margin > 0)
    lengths = [given.number(f"length of ground {place}") for place in range(len(shape.heights))]
    for length in lengths:
        given.assume(length >= margin)
    graph = profile_of_heights(shape, lengths)
    ground = [i for i, edge in enumerate(graph.edges) if edge.type is EdgeType.GROUND]
    bodies = []
    for place, stand in enumerate(shape.stands):
        name = chr(65 + place)
        edge, at = ground[stand.edge or 0], given.number(f"place of {name}")
        given.assume(at <= graph.edges[edge].length)
        bodies.append(Body(name, EdgePosition(edge, at), EdgePosition(edge, at), Fraction(0), height=ONE))
    asked = given.number("distance asked")
    return Level(graph, margin, ONE, tuple(bodies)), asked
