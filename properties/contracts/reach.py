"""How fast anybody may be in a step, which tells whom the step can reach: what is shown of any body, and of any member
of a row of any length. `ahead` is a direction.
"""

from __future__ import annotations

from typing import Any

from properties.contracts.steps import any_member
from properties.contracts.sweeps import BEYOND, reaching, rest
from properties.given import Given
from spec.graph import Direction
from spec.rules.row import cut_back
from spec.rules.step import StepRules
from spec.rules.wish import Urge
from spec.storeys import Drive


def any_velocity(given: Given, name: str, most: Any) -> Any:
    """Any velocity that is no faster than a speed."""
    velocity = given.number(f"{name} to the right") - given.number(f"{name} to the left")
    given.assume((velocity <= most) & (velocity * -1 <= most), f"no {name} is faster")
    return velocity


def wishes_add_one_drive(rules: StepRules, given: Given) -> None:
    """Any body wishes no more than its drive and its support's speed, added up, to either side."""
    own, below = given.number("speed of the drive"), given.number("speed of the support")
    drive = Drive(any_velocity(given, "drive", own), given.flag("relative to the support"))
    urge = Urge(0, drive, any_velocity(given, "support", below))
    wish = rules.wish.choose(urge).effect(urge)
    given.ensure("it wishes no more", (wish <= own + below) & (wish * -1 <= own + below))


def rows_add_no_speed(rules: StepRules, given: Given, ahead: Direction) -> None:
    """Any member of a row is no faster than all in it wish to be, nor passes more on, whatever is ahead of it.

    One that stands squeezed is a member too: it wishes nothing.
    """
    most, member = given.number("greatest wish"), any_member(given, 0)
    passed, beyond = given.number("passed on to it"), given.number("speed of what is ahead")
    given.assume((member.wish * ahead <= most) & (passed <= most), "nobody wishes to be faster, or passes more on")
    reached, on = reaching(rules.row, passed, [member], ahead)
    left, _ = cut_back(rules.row, [member, rest(BEYOND, beyond, ahead)], [reached, beyond], ahead)
    given.ensure("it passes no more on", on <= most)
    given.ensure("it is no faster", left <= most)
