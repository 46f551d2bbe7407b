"""How far off a computation in floats may be: a number of roundings of the largest number in sight.

What is rounded is rounded again: each body of a row that is pushed hands on a distance, and each edge on the way takes
its part of it. So the number of roundings grows with the work of a step (docs/proofs.md, "Rounding").
"""

from __future__ import annotations

from fractions import Fraction
from typing import Literal

from spec.body import Level
from spec.number import greater

Precision = Literal["exact", "float64", "float32"]

ROUNDINGS, PART = 16, 8
UNIT_ROUNDOFF: dict[Precision, Fraction] = {
    "exact": Fraction(0),
    "float64": Fraction(1, 2**53),
    "float32": Fraction(1, 2**24),
}


def tolerance(numbers: Precision, level: Level[Fraction], *distances: Fraction, walks: int = 1) -> Fraction:
    """How far off one step on a level may be, in which distances are asked, and borders walk along an edge so often.

    Under `repaired` it is as often as makes up for what spreads. It is never more than a part of the margin.
    """
    return min(level.margin / PART, rounding(numbers, level, *distances) * ROUNDINGS * walks)


def rounding(numbers: Precision, level: Level[Fraction], *distances: Fraction) -> Fraction:
    """The largest error of one sum on a level, in which distances are asked."""
    return UNIT_ROUNDOFF[numbers] * max([largest(level), *distances])


def largest(level: Level[Fraction]) -> Fraction:
    """The largest coordinate in a level, in the plane or along all its edges laid end to end."""
    size = sum((edge.length for edge in level.graph.edges), Fraction(0))
    for vertex in level.graph.vertices:
        size = greater(size, greater(abs(vertex.x), abs(vertex.y)))
    return size
