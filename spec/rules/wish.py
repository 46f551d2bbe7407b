"""Wish: the velocity that a body would have if nothing were in its way."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Generic

from spec.number import N, Truth
from spec.rule import AnyFamily, Family, Rule
from spec.storeys import Drive


@dataclass(frozen=True)
class Urge(Generic[N]):
    """A body's drive, and the velocity of its support, which is 0 on the ground."""

    body: int
    drive: Drive[N]
    carried: N


def in_the_plane(urge: Urge[N]) -> Truth:
    """The drive is meant in the plane."""
    return not urge.drive.relative


def relative_to_support(urge: Urge[N]) -> Truth:
    """The drive is meant relative to the support."""
    return urge.drive.relative


def own_speed(urge: Urge[N]) -> N:
    """The drive, whatever the support does."""
    return urge.drive.speed


def carried_along(urge: Urge[N]) -> N:
    """The drive, and the velocity of the support."""
    return urge.drive.speed + urge.carried


WISH: AnyFamily = Family(
    "wish",
    (
        Rule(
            id="wish/plane",
            sentence="A character that walks wishes its own velocity in the plane, whatever its support does.",
            source="1.1, 4.4; R1, A52",
            guard=(in_the_plane,),
            effect=own_speed,
        ),
        Rule(
            id="wish/carried",
            sentence="Any other body wishes the velocity of its support, and its own drive relative to it; the ground "
            "stands still.",
            source="4.4; A27, A52",
            guard=(relative_to_support,),
            effect=carried_along,
        ),
    ),
)
