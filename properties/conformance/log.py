"""Logs: what each line of a trace says, as states and requests with exact numbers, and how nearly they are known."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction

from reference.formats.level import numbers_of
from reference.formats.numbers import exact
from reference.formats.trace import HeaderRecord, LineRecord
from reference.recording import Recording
from reference.world import LevelError, World
from spec.body import Level
from spec.graph import Direction
from spec.number import greater
from spec.profiles import Profile

ROUNDINGS = 16
UNIT_ROUNDOFF = {"exact": Fraction(0), "float64": Fraction(1, 2**53), "float32": Fraction(1, 2**24)}
ON_GRID = {"exact": 2**53, "float64": 2**53, "float32": 2**24}


Numbers = tuple[str, tuple[Fraction, ...]]
"""Numbers, and the place in a document where they are."""

Request = tuple[int, Direction, Fraction]
"""A body, a direction, and a distance of at least 0."""


@dataclass(frozen=True)
class Step:
    """One line of a log: its number in the file, the state before it, what was asked, and what it says came of it."""

    number: int
    before: World[Fraction]
    asked: tuple[Request, ...]
    line: LineRecord
    after: World[Fraction]


def requests_of(level: Level[Fraction], profile: Profile, line: LineRecord) -> tuple[Request, ...]:
    """The requests of a line, in the order in which they are made."""
    handles = {body.name: handle for handle, body in enumerate(level.bodies)}
    if line.request is not None:
        distance = exact(line.request.distance, "$.request.distance")
        direction = Direction.LEFT if distance < 0 else Direction.RIGHT
        return ((handles[line.request.body], direction, abs(distance)),)
    assert line.tick is not None
    direction = Direction[line.tick.key.upper()]
    bodies = [level.bodies[handles[name]] for name in profile.tick_order(list(handles))]
    one_tick = [(handles[body.name], direction, body.speed * level.tick) for body in bodies if body.speed]
    return tuple(one_tick * line.tick.times)


def tolerance_of(header: HeaderRecord, level: Level[Fraction], asked: tuple[Request, ...]) -> Fraction:
    """How far a step of a log may be off: so many roundings of the largest number in sight; 0 on a grid."""
    if header.grid is not None:
        return Fraction(0)
    size = max([largest(level), *(distance for _, _, distance in asked)])
    return UNIT_ROUNDOFF[header.numbers] * ROUNDINGS * size


def largest(level: Level[Fraction]) -> Fraction:
    """The largest coordinate in a level, in the plane or along all its edges laid end to end."""
    size = sum((edge.length for edge in level.graph.edges), Fraction(0))
    for vertex in level.graph.vertices:
        size = greater(size, greater(abs(vertex.x), abs(vertex.y)))
    return size


def check_grid(grid: Fraction, most: Fraction, numbers: Iterator[Numbers]) -> None:
    """Refuse numbers that are not on a grid, or too large for floats to hold them and their sums exactly.

    Raises:
        LevelError: with the place of the first.
    """
    for place, here in numbers:
        for number in here:
            if (number / grid).denominator != 1 or abs(number) >= most:
                raise LevelError(place, f"expected a multiple of the grid {grid}, below {most}, got {number}")


def grid_of(log: Recording) -> tuple[Fraction, Fraction] | None:
    """The grid of a log, if it has one, and what numbers on it must be below.

    No edge may slope: points on it would not be on the grid.

    Raises:
        LevelError: with the place of the first number that is not on it.
    """
    if log.header.grid is None:
        return None
    grid, level = exact(log.header.grid, "$.grid"), log.level
    if grid <= 0:
        raise LevelError("$.grid", f"expected a number greater than 0, got {grid}")
    for i, edge in enumerate(level.graph.edges):
        if edge.run != 0 and edge.rise != 0:
            raise LevelError(f"$.level.edges[{i}]", "on a grid expected an edge that is level or vertical")
    most = grid * ON_GRID[log.header.numbers]
    check_grid(grid, most, (("$.level" + place[1:], here) for place, here in numbers_of(level)))
    check_grid(grid, most, iter([("$.level", (largest(level),))]))
    return grid, most


def numbers_of_step(asked: tuple[Request, ...], after: World[Fraction]) -> Iterator[Numbers]:
    """The numbers that a line adds to those of the level, with their places."""
    yield "$.request.distance", tuple(distance for _, _, distance in asked)
    for i, body in enumerate(after.bodies):
        yield f"$.bodies[{i}]", (body.left.location, body.right.location)
