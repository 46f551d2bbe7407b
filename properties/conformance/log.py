"""Logs: what each line of a trace says, as states and requests with exact numbers, and how nearly they are known."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from reference.formats.level import numbers_of
from reference.formats.numbers import exact, readable
from reference.formats.trace import HeaderRecord, LineRecord
from reference.physics import with_motions
from reference.recording import Recording
from reference.rounding import Precision, largest, tolerance
from reference.simulator import Fulfilled, Game
from reference.world import LevelError, World
from spec.body import Body, Level
from spec.graph import Direction
from spec.profiles import Profile
from spec.rules.velocity import Motion

ZERO = Fraction(0)
ON_GRID = {"exact": 2**53, "float64": 2**53, "float32": 2**24}

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


def requests_of(
    before: World[Fraction], profile: Profile, line: LineRecord, nearly: Fraction = ZERO
) -> tuple[Request, ...]:
    """The requests of a line, in the order in which they are made.

    Those of bodies with a velocity of their own are the ones that the rules make of the velocities before it.
    """
    handles = {body.name: handle for handle, body in enumerate(before.bodies)}
    if line.request is not None:
        distance = exact(line.request.distance, "$.request.distance")
        return ((handles[line.request.body], way(distance), abs(distance)),)
    assert line.tick is not None
    direction = line.tick.direction
    if any(body.motion is not None for body in before.bodies):
        turns, _ = rolled(before, profile, line, nearly)
        return tuple((handles[one.body], way(one.asked), abs(one.asked)) for one in turns)
    if direction is None:
        return ()
    bodies = [before.bodies[handles[name]] for name in profile.tick_order(list(handles))]
    return tuple((handles[body.name], direction, body.speed * before.level.tick) for body in bodies if body.speed)


def way(distance: Fraction) -> Direction:
    """The direction of a signed distance."""
    return Direction.LEFT if distance < 0 else Direction.RIGHT


Turns = tuple[list[Fulfilled[Fraction]], World[Fraction]]
"""The turns of all bodies in a tick, and the world after them."""


def rolled(before: World[Fraction], profile: Profile, line: LineRecord, nearly: Fraction) -> Turns:
    """What the rules make of a tick in exact numbers.

    A velocity that is known nearly may be less than the minimum or not; then it is what the line says it is.
    """
    assert line.tick is not None

    def turns(by: Fraction) -> Turns:
        assert line.tick is not None
        game = Game(profile, with_motions(before.level, minima_moved(before.bodies, by)))
        return game.tick(line.tick.direction), game.world

    found = turns(ZERO)
    if as_told(found[1], line, nearly):
        return found
    return next(
        (other for other in map(turns, (nearly, -nearly) if nearly else ()) if as_told(other[1], line, nearly)), found
    )


def minima_moved(bodies: Sequence[Body[Fraction]], by: Fraction) -> dict[int, Motion[Fraction]]:
    """The motions of bodies, with other minima."""
    return {
        handle: replace(body.motion, material=replace(body.motion.material, slowest=body.motion.material.slowest + by))
        for handle, body in enumerate(bodies)
        if body.motion is not None and body.motion.material is not None
    }


def as_told(world: World[Fraction], line: LineRecord, nearly: Fraction) -> bool:
    """Whether bodies have the velocities that a line says they have."""
    told = {place.name: place.velocity for place in line.bodies}
    return all(
        abs(body.motion.velocity - exact(told[body.name] or 0, "$")) <= nearly
        for body in world.bodies
        if body.motion is not None
    )


def tolerance_of(header: HeaderRecord, level: Level[Fraction], asked: tuple[Request, ...], walks: int = 1) -> Fraction:
    """How far a step of a log may be off, in which borders walk so often; 0 on a grid."""
    return tolerance(precision(header), level, *(distance for _, _, distance in asked), walks=walks)


def precision(header: HeaderRecord) -> Precision:
    """In what numbers a log is known; on a grid they are exact."""
    return "exact" if header.grid is not None else header.numbers


@dataclass(frozen=True)
class Grid:
    """What numbers on a grid are multiples of, and below what they must be for floats to hold them and their sums."""

    unit: Fraction
    most: Fraction

    def __contains__(self, number: Fraction) -> bool:
        """Whether a number is on the grid."""
        return (number / self.unit).denominator == 1 and abs(number) < self.most

    def __str__(self) -> str:
        """What is expected of a number, in words."""
        return f"a multiple of {self.unit}, below {self.most}"


def grid_of(log: Recording) -> Grid | None:
    """The grid of a log, if it has one. No edge may slope: points on it would not be on the grid.

    Raises:
        LevelError: if it is none, or with the place of the first number that is not on it.
    """
    if log.header.grid is None:
        return None
    unit, level = exact(log.header.grid, "$.grid"), log.level
    if unit <= 0 or not is_power_of_two(unit.numerator) or not is_power_of_two(unit.denominator):
        raise LevelError("$.grid", f'expected a power of two, such as "1/64", got {log.header.grid}')
    for i, edge in enumerate(level.graph.edges):
        if edge.run != 0 and edge.rise != 0:
            raise LevelError(f"$.level.edges[{i}]", "on a grid expected an edge that is level or vertical")
    grid = Grid(unit, unit * ON_GRID[log.header.numbers])
    for place, numbers in (*numbers_of(level), ("$", (largest(level),))):
        for number in numbers:
            if number not in grid:
                raise LevelError("$.level" + place[1:], f"expected {grid}, got {readable(number)}")
    return grid


def is_power_of_two(number: int) -> bool:
    """Whether a number above 0 is a power of two."""
    return number & (number - 1) == 0
