"""Conditions: the premises of claims, each a predicate of a world at its start and of the distance asked."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from spec.invariants import every
from spec.number import N, Truth, zero_like
from spec.world import State


@dataclass(frozen=True)
class Condition:
    """A premise: its sentence, its source, and the predicate that decides it."""

    id: str
    sentence: str
    source: str
    holds: Callable[[State[Any], Any], Truth]

    kind = "condition"


def in_order(start: State[N], asked: N) -> Truth:
    """No right border is beyond the left border of its right neighbour."""
    return every(start.clear(*pair) >= zero_like(start.margin) for pair in start.neighbours())


def margins_kept(start: State[N], asked: N) -> Truth:
    """Neighbours are at least the margin apart."""
    return every(start.clear(*pair) >= start.margin for pair in start.neighbours())


def edges_long(start: State[N], asked: N) -> Truth:
    """No edge is shorter than the margin."""
    return every(length >= start.margin for length in start.edge_lengths())


def fits_into_the_ring(start: State[N], asked: N) -> Truth:
    """On a ring, the distance is at most the room that two bodies or more leave between them beyond the margins."""
    if not start.closed or len(start.bodies_in_order()) < 2:
        return True
    room = zero_like(asked)
    for pair in start.neighbours():
        room = room + start.clear(*pair) - start.margin
    return asked <= room


def at_most_once_round(start: State[N], asked: N) -> Truth:
    """On a ring, the distance is at most its circumference."""
    round_ = zero_like(asked)
    for length in start.edge_lengths():
        round_ = round_ + length
    return not start.closed or asked <= round_


IN_ORDER = Condition("condition/in-order", "At the start no two bodies overlap.", "6.2.1; A10", in_order)
MARGINS_KEPT = Condition(
    "condition/margins-kept",
    "At the start, neighbours are at least the collision margin apart.",
    "6.2.1; R24, A10",
    margins_kept,
)
EDGES_LONG = Condition(
    "condition/edges-long",
    "No ground edge is shorter than the collision margin: else a body could be nearer than the margin and out of "
    "sight, beyond the next edge.",
    "6.2.1; A12",
    edges_long,
)
FREE_SPACE = Condition(
    "condition/free-space",
    "On a ring of two bodies or more, the distance asked does not exceed the free space.",
    "4.2; A7",
    fits_into_the_ring,
)
ONCE_ROUND = Condition(
    "condition/once-round",
    "On a ring, no request asks for more than once round: a body alone on it would go round and round.",
    "4.2; A7",
    at_most_once_round,
)

CONDITIONS: tuple[Condition, ...] = (IN_ORDER, MARGINS_KEPT, EDGES_LONG, FREE_SPACE, ONCE_ROUND)
