"""Within each family of a step, exactly one rule applies to whatever facts it is asked about."""

from __future__ import annotations

from typing import Any

from properties.contracts.families import promise_one
from properties.contracts.steps import any_member
from properties.given import Given
from spec.rules.row import Meeting, Relay, Turn, Way
from spec.rules.settle import Footing, Top
from spec.rules.step import StepRules
from spec.rules.wish import Urge
from spec.storeys import Drive


def velocity(given: Given, name: str) -> Any:
    """Any signed velocity."""
    return given.number(f"{name} to the right") - given.number(f"{name} to the left")


def wish_has_one(rules: StepRules, given: Given) -> None:
    """Any drive, on anything."""
    driven = Drive(velocity(given, "drive"), given.flag("relative to the support"))
    promise_one(given, rules.wish, Urge(0, driven, velocity(given, "velocity of the support")))


def forward_has_one(rules: StepRules, given: Given) -> None:
    """Any own speed, any speed passed on."""
    promise_one(given, rules.forward, Turn(0, given.number("own speed"), given.number("speed passed on")))


def relay_has_one(rules: StepRules, given: Given) -> None:
    """Any speed."""
    promise_one(given, rules.relay, Relay(0, given.number("speed"), given.flag("the body may push")))


def meet_has_one(rules: StepRules, given: Given) -> None:
    """Any speeds from both sides, in a row that closes on itself or not."""
    right, left = given.number("speed from the left"), given.number("speed from the right")
    promise_one(given, rules.meet, Meeting(any_member(given, 0), right, left, given.flag("the row closes on itself")))


def way_has_one(rules: StepRules, given: Given) -> None:
    """Any speed, any wall, any speed ahead."""
    ahead = given.number("speed ahead") if given.flag("a body is ahead") else None
    promise_one(given, rules.way, Way(0, given.number("speed"), given.flag("a wall is ahead"), ahead))


def settle_has_one(rules: StepRules, given: Given) -> None:
    """Any support, any ground, one top, several or none, any motion."""
    holds, ground = given.flag("its support holds"), given.flag("it is over ground")
    tops = [Top(1, velocity(given, "overlap"))] if given.flag("a top holds it") else []
    tops += [Top(2, velocity(given, "other overlap"))] if given.flag("another top holds it") else []
    promise_one(given, rules.settle, Footing(0, holds, ground, tops, velocity(given, "motion")))
