"""How often borders may walk along edges at a request, on any machine: what the tolerance of a request grows with.

In exact numbers it is known how often they do. A machine may walk more often, where a border ends just before a vertex,
or two bodies come in contact just when a border passes one: then a request is made in two, and so are all requests
that come of it. So each body is counted as if it were in contact with the one behind it from the beginning, and as if
each border passed every vertex that it comes near.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Callable, Iterator
from fractions import Fraction
from typing import Any

from properties.conformance.log import Request
from reference.rounding import PART
from reference.world import Row, World
from spec.body import EdgePosition
from spec.graph import Direction
from spec.number import greater, zero_like

Cut = Callable[[list[Fraction], Fraction], int]


def most_walks(world: World[Fraction], request: Request, limit: int) -> int:
    """How often borders may walk along edges at a request of a chain of at most `limit` bodies, on one string.

    A request is a walk of the front border for each edge, and one of the rear border for each edge. The next body is
    asked for each walk of the front border.
    """
    nearness, requests, found = world.margin / PART, 1, 0
    _, direction, _ = request
    for body, way in reached(world, request, limit, nearness):
        front, rear = (
            vertices_met(world, world.bodies[body].border(side), direction, way, nearness)
            for side in (direction, direction.opposite)
        )
        found += requests + front + requests + rear
        requests += front
    return found


def reached(world: World[Fraction], request: Request, limit: int, nearness: Fraction) -> Iterator[tuple[int, Fraction]]:
    """The bodies that a request reaches, or nearly, and how far each may go at most."""
    first, direction, way = request
    body: int | None = first
    for _ in range(limit):
        if body is None or way < -nearness:
            return
        yield body, way
        behind, body = body, world.beside(body, direction)
        if body is None or body == first:
            return
        pair = (behind, body) if direction is Direction.RIGHT else (body, behind)
        way -= greater(world.clear(*pair) - world.margin, zero_like(way))


def vertices_met(
    world: World[Fraction], at: EdgePosition[Any], direction: Direction, way: Fraction, nearness: Fraction
) -> int:
    """How many vertices between two edges a border comes near on its way."""
    row, start = world.row_of_edge[at.edge], world.coordinate(at)
    low, high = sorted((start - nearness * direction, start + (way + nearness) * direction))
    return vertices_up_to(row, high, bisect_right) - vertices_up_to(row, low, bisect_left)


def vertices_up_to(row: Row[Fraction], along: Fraction, cut: Cut) -> int:
    """How many vertices between two edges there are up to a place along a string, and round a ring again and again."""
    begins = [row.offsets[edge] for edge in row.edges]
    if not row.closed:
        return cut(begins[1:], along)
    rounds, rest = divmod(along, row.length)
    return int(rounds) * len(begins) + cut(begins, rest)
