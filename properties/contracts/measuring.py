"""A bank of small worlds of storeys, with what is to be measured in them: at, and just beyond, the boundaries.

Most of what a world of storeys says is noticed when steps are run on random ones. Some of it no random world comes
upon: a ring that a body nearly fills, a wall that begins where a body does, one above its support by two storeys.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from properties.contracts.judging_steps import HALF, at, line, ring
from reference.storeys import StoreyWorld
from spec.graph import Direction
from spec.profiles import SteppedProfile

LEFT, RIGHT = Direction.LEFT, Direction.RIGHT
World = StoreyWorld[Fraction]


@dataclass(frozen=True)
class Measure:
    """What is measured in a world, and what it is to be."""

    name: str
    world: World
    measured: Callable[[World], Any]
    expected: Any

    def is_right(self) -> bool:
        """Whether it is so."""
        return bool(self.measured(self.world) == self.expected)


def ground(world: World) -> list[tuple[Any, Any]]:
    """The ground of the storey above the lowest, from where to where."""
    return [(piece.left, piece.right) for piece in world.terrain.ground(1)]


def around(world: World) -> list[tuple[int, int]]:
    """The neighbours."""
    return list(world.neighbours())


def to_loss(world: World) -> tuple[Any, Any]:
    """How far the last body can move to the left and to the right until its support no longer holds it."""
    last = len(world.places) - 1
    return world.to_loss(last, LEFT), world.to_loss(last, RIGHT)


def holds(world: World) -> bool:
    """Whether the support of the last body holds it."""
    return bool(world.holds(len(world.places) - 1))


def offset(world: World) -> Any:
    """How far the first body is to the right of the second."""
    return world.offset(0, 1)


def tops(world: World) -> list[int]:
    """The tops that would hold the last body, from left to right."""
    return list(world.tops(len(world.places) - 1))


HIGH = [(4, 10)]
A, B = at(0, 2), at(3, 5)
LONE = at(2, 4)


BANK: tuple[Measure, ...] = (
    Measure("ground beside a wall across the seam", ring(solid=[[(0, 6)], [(19, 21)]]), ground, [(1, 6)]),
    Measure("ground over the seam, beside a wall", ring(solid=[[(15, 22)], [(1, 2)]]), ground, [(15, 21)]),
    Measure("ground with a wall on it", line(solid=[HIGH, [(6, 7)]]), ground, [(4, 6), (7, 10)]),
    Measure("ground under a wall from its beginning", line(solid=[HIGH, [(4, 6)]]), ground, [(6, 10)]),
    Measure("ground under a wall to its end", line(solid=[HIGH, [(8, 10)]]), ground, [(4, 8)]),
    Measure("alone on a ring", ring(LONE), around, []),
    Measure("alone on a line", line(LONE), around, []),
    Measure("two on a line", line(A, B), around, [(0, 1)]),
    Measure("two on a ring", ring(A, B), around, [(0, 1), (1, 0)]),
    Measure("two with a wall between", line(A, at(6, 8), solid=[[(3, 5)]]), around, []),
    Measure("two with a wall between on a ring", ring(A, at(6, 8), solid=[[(3, 5)]]), around, [(1, 0)]),
    Measure("a wall that begins where the next does", line(A, at(6, 8), solid=[[(6, 7)]]), around, [(0, 1)]),
    Measure("one to itself, once round", ring(LONE), lambda world: world.gap(0, 0), 18),
    Measure("a wall ahead", line(LONE, solid=[HIGH]), lambda world: world.to_wall(0, RIGHT), 0),
    Measure("a wall that begins with it", line(at(4, 6), solid=[HIGH]), lambda world: world.to_wall(0, RIGHT), 14),
    Measure("the end on the left", line(LONE), lambda world: world.to_wall(0, LEFT), 2),
    Measure("a wall across the seam", ring(LONE, solid=[[(15, 17)]]), lambda world: world.to_wall(0, LEFT), 5),
    Measure("no wall on a ring", ring(LONE), lambda world: world.to_wall(0, LEFT), None),
    Measure("one on another", line(at(4, 6), at(5, 7, 1, on=0)), to_loss, (4, 2)),
    Measure("one on another of a ring", ring(at(4, 6), at(5, 7, 1, on=0)), to_loss, (4, 2)),
    Measure("one that just leaves another on a ring", ring(at(0, 9), at(0, 9, 1, on=0)), to_loss, (10, 10)),
    Measure("one that cannot leave another on a ring", ring(at(0, 9 + HALF), at(0, 9, 1, on=0)), to_loss, (None, None)),
    Measure("one on the floor", line(LONE), to_loss, (None, None)),
    Measure("one on ground", line(at(5, 7, 1), solid=[HIGH]), to_loss, (3, 5)),
    Measure("one on ground of a ring", ring(at(5, 7, 1), solid=[HIGH]), to_loss, (3, 5)),
    Measure("one over a gap that it does not fit into", line(at(2, 4, 1), solid=[[(0, 5), (6, 9)]]), to_loss, (4, 7)),
    Measure("one on ground all round", ring(at(2, 4, 1), solid=[[(0, 19)]]), to_loss, (None, None)),
    Measure("one held by another", line(A, at(2, 4, 1, on=0)), holds, True),
    Measure("one a margin beside another", line(A, at(3, 5, 1, on=0)), holds, False),
    Measure("one two storeys above another", line(A, at(0, 2, 2, on=0)), holds, False),
    Measure("one on the storey of another", line(at(0, 2, 1), at(1, 3, 1, on=0)), holds, False),
    Measure("one on the floor holds", line(LONE), holds, True),
    Measure("one over the edge of ground", line(at(9, 11, 1), solid=[HIGH]), holds, True),
    Measure("one beside ground", line(at(10, 12, 1), solid=[HIGH]), holds, False),
    Measure("opposite each other on a ring", ring(at(10, 12), at(0, 2)), offset, 10),
    Measure("opposite each other on a ring, the other first", ring(at(0, 2), at(10, 12)), offset, -10),
    Measure("tops on a line", line(B, A, at(1, 4, 1)), tops, [1, 0]),
    Measure("a top a margin from both ends", ring(at(2, 4), at(12, 19), at(0, 11, 1)), tops, [0]),
    Measure("a top ahead", ring(at(2, 4), at(11 + HALF, 19), at(0, 11, 1)), tops, [0, 1]),
    Measure("a top behind", ring(at(2, 4), at(12, 19 + HALF), at(0, 11, 1)), tops, [1, 0]),
    Measure("a top at both ends", ring(at(2, 4), at(11 + HALF, 19 + HALF), at(0, 11, 1)), tops, [1, 0, 1]),
    Measure("nearer across the seam", ring(at(11, 13), at(0, 2)), offset, -9),
)


def storeys_are_measured(profile: SteppedProfile) -> int:
    """What is measured in each world of the bank is what is to be measured."""
    for one in BANK:
        assert one.is_right(), f"{one.name}: {one.measured(one.world)}"
    return len(BANK)
