"""Profiles: one choice per reading and one family per kind of decision. The only place of assembly."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

from spec.readings import LANDING, LANDING_OVERSHOOT, PUSH_LIMIT, TICK_ORDER
from spec.rules.clearance import CLEARANCE
from spec.rules.event import CONTACT as CONTACT_EVENT, LOSS, WALL
from spec.rules.leave import FIT, LEAVE
from spec.rules.push import CONTACT, PUSH
from spec.rules.request import Rules, segment
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
class Profile:
    """The rules of movement under one set of readings. A request moves one body, and what it pushes."""

    name: str
    sentence: str
    source: str
    rules: Rules
    push_limit: Callable[[int], int]
    tick_order: Callable[[Sequence[str]], Sequence[str]]
    velocity: VelocityRules

    kind = "profile"

    @property
    def id(self) -> str:
        """Its name as an ID."""
        return f"profile/{self.name}"


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


@dataclass(frozen=True)
class SteppedProfile:
    """Rules of movement in which all bodies move at once, from event to event."""

    name: str
    sentence: str
    source: str
    rules: StepRules
    velocity: VelocityRules

    kind = "profile"

    @property
    def id(self) -> str:
        """Its name as an ID."""
        return f"profile/{self.name}"


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
PROFILES: dict[str, AnyProfile] = {**OF_REQUESTS, REPAIRED.name: REPAIRED}
