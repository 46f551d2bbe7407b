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
from spec.rules.walk import FOLLOW, WALK
from spec.rules.wish import WISH


@dataclass(frozen=True)
class Profile:
    """The rules of movement under one set of readings."""

    name: str
    rules: Rules
    push_limit: Callable[[int], int]
    tick_order: Callable[[Sequence[str]], Sequence[str]]


THESIS = Profile(
    name="thesis",
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
)

OVERSHOOT = replace(THESIS, name="thesis/overshoot", rules=replace(THESIS.rules, landing=LANDING_OVERSHOOT.choice))


@dataclass(frozen=True)
class SteppedProfile:
    """Rules of movement in which all bodies move at once, from event to event."""

    name: str
    rules: StepRules


REPAIRED = SteppedProfile(
    name="repaired",
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
)

AnyProfile = Profile | SteppedProfile

OF_REQUESTS: dict[str, Profile] = {profile.name: profile for profile in (THESIS, OVERSHOOT)}
PROFILES: dict[str, AnyProfile] = {**OF_REQUESTS, REPAIRED.name: REPAIRED}
