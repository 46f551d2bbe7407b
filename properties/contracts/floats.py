"""Rows in floats that show how far roundings can lead, each beside the same row in exact numbers."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from properties.worlds.rows import string_graph
from reference.rounding import ROUNDINGS, UNIT_ROUNDOFF, largest, tolerance
from reference.simulator import move
from reference.world import World
from spec.body import Body, EdgePosition, Level
from spec.graph import Direction
from spec.profiles import Profile
from spec.transform import in_floats

LENGTHS = (40, 80)
ROUND_DOWN = Fraction(49, 100)
"""What of a last binary place is rounded down."""


def on_one_edge(length: Fraction, margin: Fraction, width: Fraction, lefts: list[Fraction]) -> Level[Fraction]:
    """Bodies on one level edge."""
    held = [
        Body(str(i), EdgePosition(0, x), EdgePosition(0, x + width), Fraction(0), width) for i, x in enumerate(lefts)
    ]
    return Level(string_graph([length], None), margin, Fraction(1), tuple(held))


def unlucky_row(bodies: int) -> tuple[Level[Fraction], Fraction]:
    """A row, and a distance, such that each body asks the next for a little too much, by what is rounded.

    The room before each body ends in a part of a place that the distance does not have.
    """
    distance, width, gap = Fraction(1023), Fraction(1, 8), Fraction(1, 8)
    room = Fraction(float(Fraction(1, 16) + ROUND_DOWN / 2**43))
    lefts = [(width + gap) * i for i in range(bodies)]
    return on_one_edge(lefts[-1] + distance + 1, gap - room, width, lefts), distance


def off_by(profile: Profile, level: Level[Fraction], distance: Fraction) -> tuple[Fraction, int]:
    """How far off the bodies are in float64 after a request of the first one, and how often a border has walked."""
    exact, floats = World(level), World(in_floats(level))
    _, record = move(profile, exact, 0, Direction.RIGHT, distance)
    move(profile, floats, 0, Direction.RIGHT, float(distance))
    pairs = zip(exact.bodies, floats.bodies, strict=True)
    return max(abs(one.left.location - Fraction(two.left.location)) for one, two in pairs), record.walks


def long_rows_need_more(profile: Profile) -> int:
    """A row that is long enough is off by more than any number of roundings, and by less than its walks allow."""
    last = Fraction(0)
    for bodies in LENGTHS:
        level, distance = unlucky_row(bodies)
        off, walked = off_by(profile, level, distance)
        rounding = UNIT_ROUNDOFF["float64"] * max(largest(level), distance)
        assert off > max(ROUNDINGS * rounding, last), f"{bodies} bodies: off by {float(off / rounding):.1f} roundings"
        assert off <= tolerance("float64", level, distance, walks=walked), f"{bodies} bodies: off by {float(off)}"
        last = off * 3 / 2
    return len(LENGTHS)


def losses_add_up(profile: Profile) -> int:
    """A box that is pushed a little, again and again, ends nearer than the margin by more than one request is off.

    Each request moves the box by a little less than the one who pushes it, whose place has finer last places.
    """
    part, margin = Fraction(1, 2**54), Fraction(9, 16)
    level = on_one_edge(Fraction(2), margin, Fraction(7, 16), [Fraction(0), Fraction(1)])
    world: World[Any] = World(in_floats(level))
    requests, once = 0, tolerance("float64", level, walks=4)
    gap = margin
    while gap >= margin - once:
        _, record = move(profile, world, 0, Direction.RIGHT, float(5 * part))
        assert record.walks == 4, "not a request of two bodies on one edge"
        last, gap = gap, exact_gap(world)
        assert last - once <= gap < last, f"request {requests}: from {last} to {gap}"
        requests += 1
    return requests


def exact_gap(world: World[Any]) -> Fraction:
    """The gap between two bodies on one edge, without rounding it."""
    return Fraction(world.bodies[1].left.location) - Fraction(world.bodies[0].right.location)
