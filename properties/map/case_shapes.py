"""The shapes in which the map looks for cases: in groups, each of which is gone through to its end."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from itertools import product

from properties.worlds.scenes import ONE, Platform, Shape, Stand, shapes
from spec.graph import Direction

TWO, HALF = Fraction(2), Fraction(1, 2)


def steps() -> list[Shape]:
    """Up to two bodies on up to three grounds of heights 0 to 2, with steps of one or two body heights."""
    return [shape for shape in shapes(2, 3, guided=False) if shape.platform is None]


def platforms() -> list[Shape]:
    """Up to two bodies with a platform over level ground, half a body or a whole one above it, a quarter thick."""
    return [shape for shape in shapes(2, 3, guided=False) if shape.platform is not None and shape.platform.thickness]


def crowds() -> list[Shape]:
    """Three bodies on up to two grounds, with a step of one body height; the second and the third are exchangeable."""
    found = [shape for shape in shapes(3, 2, guided=True) if len(shape.stands) == 3]
    return [shape for shape in found if order_of(shape.stands) <= order_of(exchanged(shape.stands))]


def exchanged(stands: tuple[Stand, ...]) -> tuple[Stand, ...]:
    """Where three bodies stand if the second and the third take each other's place."""
    other = {None: None, 0: 0, 1: 2, 2: 1}
    first, second, third = (replace(stand, top=other[stand.top]) for stand in stands)
    return first, third, second


def order_of(stands: tuple[Stand, ...]) -> list[tuple[int, ...]]:
    """What tells apart where bodies stand, so that it can be put in order."""
    return [(-1 if stand.edge is None else stand.edge, -1 if stand.top is None else stand.top) for stand in stands]


def overhangs() -> list[Shape]:
    """Two bodies, one of them in overhang, on up to three grounds with steps of one body height."""
    found = []
    for shape in shapes(2, 3, guided=True):
        for place, stand in enumerate(shape.stands):
            for direction in Direction:
                if len(shape.stands) == 2 and stand.edge is not None and is_ledge(shape, stand.edge, direction):
                    over = replace(stand, overhang=direction)
                    found.append(replace(shape, stands=(*shape.stands[:place], over, *shape.stands[place + 1 :])))
    return found


def is_ledge(shape: Shape, edge: int, direction: Direction) -> bool:
    """Whether a ground edge ends at a ledge on one side."""
    beyond = edge + direction
    return 0 <= beyond < len(shape.heights) and shape.heights[beyond] < shape.heights[edge]


def storeys() -> list[Shape]:
    """A few shapes with more than one difficulty: a platform beside a ledge or on a body, and three heights."""
    on, under = Stand(edge=0), Stand(edge=1)
    sharp = Shape((ONE * 0,) * 3, (Stand(top=1), on), Platform(ONE, ONE * 0))
    beside = [
        Shape((top, ONE * 0), (on, Stand(edge=other)), Platform(height, thickness))
        for top, other, height, thickness in product((ONE, TWO), (1, 2), (ONE + HALF, TWO), (HALF / 2,))
    ]
    return [*beside, sharp, Shape((TWO, ONE * 0, ONE), (on, under, Stand(edge=2)))]


def short_edges() -> list[Shape]:
    """Two bodies on three edges of level ground, which may be shorter than the margin."""
    return [Shape((ONE * 0,) * 3, (Stand(edge=0), Stand(edge=2)), short=True)]
