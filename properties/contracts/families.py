"""Within each family, exactly one rule applies to whatever facts it is asked about."""

from __future__ import annotations

from typing import Any

from properties.contracts.request import ONE_RULE, any_motion
from properties.given import Given
from properties.worlds.window import window
from spec.rule import Chooser, GuardError
from spec.rules.clearance import Sight
from spec.rules.push import Answer, Want, Way
from spec.rules.request import Rules
from spec.rules.walk import Motion, Step


def promise_one(given: Given, family: Chooser, facts: Any) -> None:
    """Promise that a family has exactly one rule for some facts."""
    try:
        given.saw(family.choose(facts).id)
        one = True
    except GuardError:
        one = False
    given.ensure(ONE_RULE, one)


def clearance_has_one(rules: Rules, given: Given) -> None:
    """Any stride, any gap, any margin."""
    seen = given.flag("a body is seen")
    gap = given.number("gap") if seen else given.number("margin") * 0
    promise_one(given, rules.clearance, Sight(given.number("stride"), seen, gap, given.number("margin")))


def push_has_one(rules: Rules, given: Given) -> None:
    """Any stride, any room, any number of spare requests."""
    promise_one(
        given,
        rules.push,
        Want(given.number("stride"), given.number("room"), given.natural("spare"), given.flag("the body may push")),
    )


def contact_has_one(rules: Rules, given: Given) -> None:
    """Any stride, any room, anything granted."""
    promise_one(given, rules.contact, Answer(given.number("stride"), given.number("room"), given.number("granted")))


def fit_has_one(rules: Rules, given: Given) -> None:
    """Any width left to place."""
    promise_one(given, rules.fit, Motion(None, rest=given.number("width left")))


def walk_has_one(rules: Rules, given: Given) -> None:
    """Any motion on any edge, blocked or not."""
    seen = window(given, ledges=True)
    reach = given.number("distance to the end") - given.number("distance beyond the end")
    way = Way(given.number("way"), blocked=given.flag("blocked"))
    motion = any_motion(given, seen.start)
    promise_one(given, rules.walk, Step(seen, motion, way, reach, seen.beyond(seen.start)))
