"""Whole rows of a fixed number of bodies, on a string of a fixed number of edges, all sizes arbitrary.

They run on the reference world itself.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from properties.given import HAS_LENGTH, HAS_WIDTH, Given
from spec.body import Body, EdgePosition, Level
from spec.conditions import EDGES_LONG, MARGINS_KEPT
from spec.graph import Edge, EdgeType, Graph, Vertex


def string_graph(lengths: list[Any], circumference: Any | None) -> Graph[Any]:
    """Ground edges end to end, on a line or round a ring."""
    ends = len(lengths) if circumference is not None else len(lengths) + 1
    edges = tuple(Edge(i, (i + 1) % ends, EdgeType.GROUND, length, run=1, rise=0) for i, length in enumerate(lengths))
    zero, along = lengths[0] * 0, [lengths[0] * 0]
    for length in lengths[: ends - 1]:
        along.append(along[-1] + length)
    return Graph(tuple(Vertex(x, zero) for x in along), edges, circumference)


def located(lengths: list[Any], along: Any, closed: bool) -> EdgePosition[Any]:
    """The edge position at a distance along the string; a vertex is named by the edge before it."""
    for edge, length in enumerate(lengths):
        if along <= length:
            return EdgePosition(edge, along)
        along = along - length
    if closed:
        return located(lengths, along, closed=False)
    return EdgePosition(len(lengths) - 1, lengths[-1] + along)


def any_level(
    given: Given, bodies: int, edges: int, closed: bool, edges_long: bool = True, speed: int = 0
) -> Level[Any]:
    """Any valid start of `bodies` bodies on a string of `edges` edges."""
    margin = given.number("margin")
    given.assume(margin > 0, "the margin is positive")
    lengths = [given.number(f"length of edge {edge}") for edge in range(edges)]
    for length in lengths:
        if edges_long:
            given.assume(length >= margin, EDGES_LONG.id)
        else:
            given.assume(length > 0, HAS_LENGTH)
    total = sum(lengths[1:], lengths[0])
    along, held = given.number("left of A") if bodies else margin, []
    first = along
    if closed:
        given.assume(first < total, "places on a ring are counted once round")
    for index in range(bodies):
        width = given.number(f"width of {chr(65 + index)}")
        given.assume(width > 0, HAS_WIDTH)
        held.append((along, along + width))
        along = along + width + margin
        if index < bodies - 1:
            along = along + given.number(f"room after {chr(65 + index)}", MARGINS_KEPT.id)
    if closed and bodies > 1:
        given.assume(along <= first + total, MARGINS_KEPT.id)
    else:
        given.assume(along - margin <= (first + total if closed else total), "the row is on its string")
    placed = tuple(
        Body(
            chr(65 + i), located(lengths, left, closed), located(lengths, right, closed), Fraction(speed), height=margin
        )
        for i, (left, right) in enumerate(held)
    )
    tick = given.number("tick")
    given.assume(tick > 0, "the tick is positive")
    return Level(string_graph(lengths, total if closed else None), margin, tick, placed)
