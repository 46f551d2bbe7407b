"""Clearance: how far a border may move before it is as near to another body as the margin allows.

Step 1 of table 4.1, "calculate distance": the bodies on the current and on the next ground edge are looked
at, before each move along one edge.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Generic

from spec.number import N, Truth, zero_like
from spec.rule import AnyFamily, Family, Rule


@dataclass(frozen=True)
class Sight(Generic[N]):
    """What a border sees ahead: whether a body is `seen`, and how far it is (`gap`, 0 where none is seen).

    `stride` is how far the border is to go on this edge.
    """

    stride: N
    seen: bool
    gap: N
    margin: N


def nobody_in_sight(sight: Sight[N]) -> Truth:
    """No other body is on this edge or the next."""
    return not sight.seen


def somebody_in_sight(sight: Sight[N]) -> Truth:
    """Another body is on this edge or the next."""
    return sight.seen


def outside_margin(sight: Sight[N]) -> Truth:
    """The other body is at least the margin away."""
    return sight.gap >= sight.margin


def within_margin(sight: Sight[N]) -> Truth:
    """The other body is nearer than the margin."""
    return sight.gap < sight.margin


def whole_stride(sight: Sight[N]) -> N:
    """Nothing limits the stride."""
    return sight.stride


def up_to_margin(sight: Sight[N]) -> N:
    """The gap, less the margin."""
    return sight.gap - sight.margin


def no_room(sight: Sight[N]) -> N:
    """No room at all."""
    return zero_like(sight.stride)


CLEARANCE: AnyFamily = Family(
    "clearance",
    (
        Rule(
            id="clearance/nobody",
            sentence="Where no body is on the current or the next ground edge, the whole stride is free.",
            source="6.2.1; R34, A12",
            guard=(nobody_in_sight,),
            effect=whole_stride,
        ),
        Rule(
            id="clearance/margin",
            sentence="Towards the nearest body in sight, the gap less the collision margin is free.",
            source="4.2, 6.2.1; R5, R24",
            guard=(somebody_in_sight, outside_margin),
            effect=up_to_margin,
        ),
        Rule(
            id="clearance/too-near",
            sentence="Towards a body that is nearer than the margin, nothing is free.",
            source="6.2.1; R24, A10",
            guard=(somebody_in_sight, within_margin),
            effect=no_room,
        ),
    ),
)
