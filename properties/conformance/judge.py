"""The judge: whether a step of a log is one that the rules allow, from the log's own state before it.

So errors do not add up. Where numbers are known nearly and a step is near a boundary of a guard, every outcome that
the rules have there is allowed, and the judge says so; so it is where bodies of a string begin at the same place, for
then a log does not tell which comes first. Everywhere else there is one outcome.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from enum import Enum
from fractions import Fraction
from typing import Any

from properties.conformance.log import Request
from properties.conformance.ways import Ways
from properties.engine.ties import TooManyWays, value_of
from reference.formats.level import position_record
from reference.formats.numbers import readable
from reference.simulator import MOST_FIRED, Record, move
from reference.world import World
from spec.body import Body, EdgePosition, Level
from spec.profiles import Profile

LITTLE = Fraction(1, 10**6)


class Finding(Enum):
    """What the judge found of a step."""

    AGREES = "agrees"
    ONE_OF_SEVERAL = "agrees with one of several outcomes"
    AMBIGUOUS = "ambiguous"
    DIVERGES = "diverges"


@dataclass(frozen=True)
class Difference:
    """What a log says and what the rules do: of a body, or of the whole level where `body` is empty.

    `apart` is how far that is, where it is a distance on one edge.
    """

    body: str
    field: str
    expected: str
    seen: str
    apart: Fraction = Fraction(0)

    def __str__(self) -> str:
        """The difference in words."""
        of = f"{self.body} {self.field}" if self.body else self.field
        off = f" (off by {float(self.apart):.2g})" if 0 < self.apart < LITTLE else ""
        return f"{of}: expected {self.expected}, seen {self.seen}{off}"


@dataclass(frozen=True)
class Expected:
    """The exact outcome of a step: the world, and of each request what it moved and the rules that fired."""

    world: World[Fraction]
    moved: tuple[Fraction, ...]
    records: tuple[Record, ...]


@dataclass(frozen=True)
class Judgement:
    """What was found of a step, what was expected, and how the log differs from that."""

    finding: Finding
    expected: Expected
    differences: tuple[Difference, ...]


def expect(profile: Profile, before: World[Fraction], asked: Sequence[Request], most: int = MOST_FIRED) -> Expected:
    """Do what was asked, by the rules of a profile, in exact numbers.

    Raises:
        Endless: if more than `most` rules fire in a request.
    """
    world, moved, records = before.copy(), [], []
    for body, direction, distance in asked:
        went, record = move(profile, world, body, direction, distance, most)
        moved.append(went * direction)
        records.append(record)
    return Expected(world, tuple(moved), tuple(records))


def judge(
    profile: Profile, before: World[Fraction], asked: Sequence[Request], seen: World[Fraction], tolerance: Fraction
) -> Judgement:
    """Judge where the bodies are after a step."""
    expected = expect(profile, before, asked)
    differences = tuple(displaced(expected.world.bodies, seen, tolerance))
    if not differences:
        return Judgement(Finding.AGREES, expected, ())
    finding, moved = among_all_ways(profile, before, asked, seen, tolerance)
    return Judgement(finding, replace(expected, moved=moved or expected.moved), differences)


def among_all_ways(
    profile: Profile, before: World[Fraction], asked: Sequence[Request], seen: World[Fraction], tolerance: Fraction
) -> tuple[Finding, tuple[Fraction, ...]]:
    """Whether the bodies are where they may be if ties are broken in another way, of numbers and of places in a row.

    And how far the requests have moved their bodies then.
    """
    ways = Ways(profile, tolerance)
    try:
        reached = ways.one_after_another(before.level, asked)
    except TooManyWays:
        return Finding.AMBIGUOUS, ()
    allowed = [moved for world, moved in reached if not any(displaced(world.bodies, seen, tolerance))]
    return (Finding.ONE_OF_SEVERAL, allowed[0]) if allowed else (Finding.DIVERGES, ())


def displaced(bodies: Sequence[Body[Any]], seen: World[Fraction], tolerance: Fraction) -> Iterator[Difference]:
    """The bodies that are seen elsewhere than they are expected to be."""
    for expected, held in zip(bodies, seen.bodies, strict=True):
        for side in ("left", "right"):
            one, two = exactly(getattr(expected, side)), getattr(held, side)
            if not same_place(seen, one, two, tolerance):
                apart = abs(one.location - two.location) if one.edge == two.edge else Fraction(0)
                texts = position_text(seen.level, one), position_text(seen.level, two)
                yield Difference(held.name, side, *texts, apart)


def exactly(at: EdgePosition[Any]) -> EdgePosition[Fraction]:
    """A position with its exact value."""
    return EdgePosition(at.edge, value_of(at.location))


def same_place(
    world: World[Fraction], one: EdgePosition[Fraction], two: EdgePosition[Fraction], tolerance: Fraction
) -> bool:
    """Whether two positions are the same place on the same string; a vertex has two names (A57)."""
    if one.edge == two.edge and abs(one.location - two.location) <= tolerance:
        return True
    row = world.row_of_edge[one.edge]
    if row is not world.row_of_edge[two.edge] or not all(on_edge(world, at, tolerance) for at in (one, two)):
        return False
    apart = abs(world.coordinate(one) - world.coordinate(two))
    return apart <= tolerance or (row.closed and row.length - apart <= tolerance)


def on_edge(world: World[Fraction], at: EdgePosition[Fraction], tolerance: Fraction) -> bool:
    """Whether a position is between the ends of its edge."""
    return -tolerance <= at.location <= world.length_of(at.edge) + tolerance


def position_text(level: Level[Any], at: EdgePosition[Any]) -> str:
    """A position in words."""
    record = position_record(at, level)
    return f"{readable(at.location)} on " + (f"edge {record.edge}" if record.top is None else f"top of {record.top}")
