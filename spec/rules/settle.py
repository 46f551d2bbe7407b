"""Settle: what a body stands on when its support no longer holds it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence, Set
from dataclasses import dataclass
from typing import Generic

from spec.number import N, Truth, zero_like
from spec.rule import AnyFamily, Chooser, Family, Rule
from spec.storeys import Seat, Storeys, seat_of


@dataclass(frozen=True)
class Top(Generic[N]):
    """The top of a body that would hold another, and how much of that is over it."""

    body: int
    overlap: N


@dataclass(frozen=True)
class Footing(Generic[N]):
    """A body that looks for its support.

    Attributes:
        holds: whether the support that it has still holds it.
        ground: whether it is over the ground of its storey.
        tops: those that would hold it, from left to right.
        motion: its velocity relative to the support that it lost, before it did.
    """

    body: int
    holds: bool
    ground: bool
    tops: Sequence[Top[N]]
    motion: N


@dataclass(frozen=True)
class Found:
    """Whether a body has found a support, and the body on whose top it stands then, or None for the ground."""

    stands: bool
    support: int | None


def support_holds(footing: Footing[N]) -> Truth:
    """Its support holds it."""
    return footing.holds


def support_is_lost(footing: Footing[N]) -> Truth:
    """Its support no longer holds it."""
    return not footing.holds


def over_ground(footing: Footing[N]) -> Truth:
    """It is over the ground of its storey."""
    return footing.ground


def over_no_ground(footing: Footing[N]) -> Truth:
    """It is not over the ground of its storey."""
    return not footing.ground


def some_top_holds(footing: Footing[N]) -> Truth:
    """The top of another body would hold it."""
    return bool(footing.tops)


def no_top_holds(footing: Footing[N]) -> Truth:
    """No top would hold it."""
    return not footing.tops


def keeps_it(footing: Footing[N]) -> None:
    """It has the support that it had."""


def the_ground(footing: Footing[N]) -> Found:
    """It stands on the ground."""
    return Found(stands=True, support=None)


def front_most(footing: Footing[N]) -> Found:
    """It stands on the top that is front-most in its motion; without motion, on what is most under it."""
    zero = zero_like(footing.motion)
    if footing.motion > zero:
        return Found(stands=True, support=footing.tops[-1].body)
    if footing.motion < zero:
        return Found(stands=True, support=footing.tops[0].body)
    best = footing.tops[0]
    for top in footing.tops[1:]:
        if top.overlap > best.overlap or (top.overlap >= best.overlap and top.body < best.body):
            best = top
    return Found(stands=True, support=best.body)


def a_storey_lower(footing: Footing[N]) -> Found:
    """It comes down by a storey."""
    return Found(stands=False, support=None)


SETTLE: AnyFamily = Family(
    "settle",
    (
        Rule(
            id="settle/stay",
            sentence="A body keeps its support as long as that holds it.",
            source="4.4; R21, A14",
            guard=(support_holds,),
            effect=keeps_it,
        ),
        Rule(
            id="settle/ground",
            sentence="A body that has lost its support stands on the ground of its storey if it is over it.",
            source="6.1.3; R15, A54",
            guard=(support_is_lost, over_ground),
            effect=the_ground,
            event="ground",
        ),
        Rule(
            id="settle/jump",
            sentence="Where there is no ground, it stands on a top that would hold it: on the last one in the "
            "direction of its motion relative to the support it lost; without such motion on the top that it is over "
            "most, if it is over none on the nearest, and of equals on the first in the level's order.",
            source="6.2.1e; R22, R25, A21, A23",
            guard=(support_is_lost, over_no_ground, some_top_holds),
            effect=front_most,
            event="jump",
        ),
        Rule(
            id="settle/fall",
            sentence="Where nothing holds it, it falls by a storey, and looks again.",
            source="6.2.1d; R21, R32",
            guard=(support_is_lost, over_no_ground, no_top_holds),
            effect=a_storey_lower,
            event="fall",
        ),
    ),
)


@dataclass(frozen=True)
class Change:
    """What a body has come to stand on, by which rule."""

    rule: str
    seat: Seat


def settle(rules: Chooser, world: Storeys[N], speeds: Mapping[int, N], lost: Set[Seat]) -> Iterator[Change]:
    """Give every body a support that holds it, the lowest storey first, so that a rider looks after what carries it.

    `speeds` are the velocities up to now; `lost` are the seats that no longer hold.
    """
    for body in [body for storey in world.storeys() for body in world.row(storey)]:
        yield from settle_one(rules, world, body, motion_of(world, speeds, body), lost)


def settle_one(rules: Chooser, world: Storeys[N], body: int, motion: N, lost: Set[Seat]) -> Iterator[Change]:
    """Let one body down until something holds it."""
    holds = seat_of(world, body) not in lost and on_its_storey(world, body)
    while True:
        footing = footing_of(world, body, holds, motion, lost)
        rule = rules.choose(footing)
        found: Found | None = rule.effect(footing)
        if found is None:
            return
        if found.stands:
            world.stand(body, found.support)
        else:
            world.drop(body)
        yield Change(rule.id, seat_of(world, body))
        if found.stands:
            return
        holds = False


def on_its_storey(world: Storeys[N], body: int) -> bool:
    """Whether the support of a body is still one storey below it."""
    support = world.support(body)
    return support is None or world.storey(support) == world.storey(body) - 1


def motion_of(world: Storeys[N], speeds: Mapping[int, N], body: int) -> N:
    """The velocity of a body relative to its support."""
    support = world.support(body)
    return speeds[body] if support is None else speeds[body] - speeds[support]


def footing_of(world: Storeys[N], body: int, holds: bool, motion: N, lost: Set[Seat]) -> Footing[N]:
    """What a body may stand on; nothing is looked at that is not asked for."""
    if holds:
        return Footing(body, holds=True, ground=False, tops=(), motion=motion)
    storey = world.storey(body)
    ground = Seat(body, storey, None) not in lost and bool(world.grounded(body))
    tops = [top for top in ([] if ground else world.tops(body)) if Seat(body, storey, top) not in lost]
    return Footing(body, False, ground, [Top(top, world.overlap(body, top)) for top in tops], motion)
