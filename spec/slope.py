"""The slope under a body: the mean of that of all ground between its borders (6.3.2; A33, A34).

It is what the body's own borders say, from one to the other, for each unit of its width along the graph. So it is exact
wherever edges have rational directions; on one edge it is the direction of the edge; it changes nowhere at once; and a
body of evenly spread mass is pulled just so, for the slope is how fast the mean height of its ground changes.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Protocol

from spec.graph import Edge
from spec.number import N
from spec.rules.velocity import Slope


class Grounds(Protocol[N]):
    """What a world says of the ground under its bodies."""

    def support(self, body: int, /) -> int | None:
        """The body on whose top a body is, or None on the ground."""

    def edges_under(self, body: int, /) -> tuple[Edge[N], Edge[N]]:
        """The static edges of the left and the right border of a body."""

    def extent(self, body: int, /) -> tuple[N, N]:
        """How far it is across and up from the left border of a body to the right one."""

    def width(self, body: int, /) -> N:
        """Distance along the graph between the borders."""


def slope_under(world: Grounds[N], body: int) -> Slope[N]:
    """The slope of the ground under a body; a top has the slope of the ground under what carries it."""
    lowest, support = body, world.support(body)
    while support is not None:
        lowest, support = support, world.support(support)
    left, right = world.edges_under(lowest)
    width, (across, up) = world.width(lowest), world.extent(lowest)
    on_one = left is right and bool(width <= left.length)
    slope = Slope(left.run, left.rise) if on_one else Slope(across / width, up / width)
    return slope if lowest != body else replace(slope, friction=friction_under(left, right))


def friction_under(left: Edge[N], right: Edge[N]) -> N | None:
    """The coefficient of friction of the ground under both borders: the mean of both edges that have one."""
    own = [edge.friction for edge in (left, right) if edge.friction is not None]
    if not own:
        return None
    return own[0] if len(own) == 1 else (own[0] + own[1]) / 2
