"""Profiles: one choice per reading and one family per kind of decision. The only place of assembly."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

from spec.features import FALLS, FEATURES, WIDE, Feature, Widths
from spec.readings import LANDING, LANDING_OVERSHOOT, PUSH_LIMIT, TICK_ORDER
from spec.rules.clearance import CLEARANCE
from spec.rules.event import CONTACT as CONTACT_EVENT, LOSS, WALL
from spec.rules.leave import FIT, LEAVE
from spec.rules.push import CONTACT, PUSH
from spec.rules.request import Rules, depart, segment
from spec.rules.row import FORWARD, MEET, PASS, WAY
from spec.rules.settle import SETTLE
from spec.rules.step import StepRules
from spec.rules.velocity import (
    AFTER,
    AFTER_PRINTED,
    BODY,
    COEFFICIENT,
    COEFFICIENT_PRINTED,
    DRAG,
    DRAG_PRINTED,
    FASTEST,
    FRICTION,
    NORMAL,
    NORMAL_PRINTED,
    PULL,
    SLOWEST,
    SLOWEST_PRINTED,
    VelocityRules,
)
from spec.rules.walk import FOLLOW, WALK
from spec.rules.wish import WISH

PRINTED = VelocityRules(
    body=BODY,
    pull=PULL,
    normal=NORMAL_PRINTED,
    coefficient=COEFFICIENT_PRINTED,
    friction=FRICTION,
    drag=DRAG_PRINTED,
    fastest=FASTEST,
    slowest=SLOWEST_PRINTED,
    after=AFTER_PRINTED,
)

MENDED = VelocityRules(
    body=BODY,
    pull=PULL,
    normal=NORMAL,
    coefficient=COEFFICIENT,
    friction=FRICTION,
    drag=DRAG,
    fastest=FASTEST,
    slowest=SLOWEST,
    after=AFTER,
)


@dataclass(frozen=True)
class Named:
    """What any profile is called, says and comes from."""

    name: str
    sentence: str
    source: str

    kind = "profile"

    @property
    def id(self) -> str:
        """Its name as an ID."""
        return f"profile/{self.name}"

    @property
    def not_asked(self) -> frozenset[str]:
        """The IDs of invariants and unsupported cases that mean nothing under it."""
        return frozenset()


@dataclass(frozen=True)
class Profile(Named):
    """The rules of movement under one set of readings. A request moves one body, and what it pushes.

    `without` are the features that it does not have, and `widths` those that bodies may have.
    """

    rules: Rules
    push_limit: Callable[[int], int]
    tick_order: Callable[[Sequence[str]], Sequence[str]]
    velocity: VelocityRules
    without: tuple[Feature, ...] = ()
    widths: Widths = WIDE

    @property
    def not_asked(self) -> frozenset[str]:
        """The IDs of invariants and unsupported cases that mean nothing under it."""
        return frozenset[str]().union(*(feature.not_asked for feature in self.without))


THESIS = Profile(
    name="thesis",
    sentence="The rules as printed: one request after another, each of one body and what it pushes, on strings of "
    "edges.",
    source="4.2, 6.2.1; R5",
    rules=Rules(
        clearance=CLEARANCE,
        push=PUSH,
        contact=CONTACT,
        walk=WALK,
        follow=FOLLOW,
        leave=LEAVE,
        fit=FIT,
        landing=LANDING.choice,
        segment=segment,
        depart=depart,
    ),
    push_limit=PUSH_LIMIT.choice,
    tick_order=TICK_ORDER.choice,
    velocity=PRINTED,
)

OVERSHOOT = replace(
    THESIS,
    name="thesis/overshoot",
    sentence="The rules as printed, but for the landing: a body that falls or jumps keeps its horizontal position.",
    source="6.2.1d, 6.2.1e; A15, A19",
    rules=replace(THESIS.rules, landing=LANDING_OVERSHOOT.choice),
)

MENDED_VELOCITY = replace(
    THESIS,
    name="thesis/mended-velocity",
    sentence="The rules as printed, but for velocities, which are those of `repaired`: for slopes, of which storeys "
    "have none.",
    source="6.3.1, 6.3.2; P1, P2, P10",
    velocity=MENDED,
)


def without(profile: Profile, *features: Feature) -> Profile:
    """A profile that does without some features, in the order of `FEATURES` (8.0.1; E8)."""
    rules, widths = profile.rules, profile.widths
    for feature in features:
        rules, widths = feature.off(rules), feature.widths or widths
    return replace(
        profile,
        name="/".join([profile.name, *(f"no-{feature.name}" for feature in features)]),
        sentence=f"The profile {profile.name} without {' and '.join(feature.name for feature in features)}.",
        source="8.0.1; E8, E15, O13",
        rules=rules,
        widths=widths,
        without=features,
    )


WITHOUT_ONE_OR_TWO: tuple[Profile, ...] = tuple(
    without(THESIS, *features) for many in (1, 2) for features in combinations(FEATURES, many)
)
OVERSHOOT_WITHOUT: tuple[Profile, ...] = tuple(
    without(OVERSHOOT, *one.without) for one in WITHOUT_ONE_OR_TWO if FALLS not in one.without
)
"""Without falls there is no landing."""


@dataclass(frozen=True)
class SteppedProfile(Named):
    """Rules of movement in which all bodies move at once, from event to event."""

    rules: StepRules
    velocity: VelocityRules


REPAIRED = SteppedProfile(
    name="repaired",
    sentence="The rules to implement: bodies on storeys are driven all at once for a time, push in rows, ride, fall "
    "and land, and move with constant velocities from event to event.",
    source="1.1, 6.2.1, 8; R1, R3",
    rules=StepRules(
        wish=WISH,
        forward=FORWARD,
        relay=PASS,
        meet=MEET,
        way=WAY,
        contact=CONTACT_EVENT,
        wall=WALL,
        loss=LOSS,
        settle=SETTLE,
    ),
    velocity=MENDED,
)

AnyProfile = Profile | SteppedProfile

OF_REQUESTS: dict[str, Profile] = {profile.name: profile for profile in (THESIS, OVERSHOOT, MENDED_VELOCITY)}
WITHOUT: dict[str, Profile] = {profile.name: profile for profile in (*WITHOUT_ONE_OR_TWO, *OVERSHOOT_WITHOUT)}
PROFILES: dict[str, AnyProfile] = {**OF_REQUESTS, REPAIRED.name: REPAIRED, **WITHOUT}
