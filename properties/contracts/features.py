"""What is immediate without a feature: nobody leaves, nobody is in the way, nothing obstructs a point."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from properties.contracts.leaving import any_jump
from properties.contracts.request import any_motion, seen_by
from properties.given import Given
from properties.worlds.window import ME, lonely_window, spot, window
from spec.plane import negated
from spec.rules.clearance import Sight
from spec.rules.push import Want, Way
from spec.rules.request import Rules, depart
from spec.rules.walk import Step


def ledges_are_walls(rules: Rules, given: Given) -> None:
    """On an open way a border does not go beyond the end of its edge."""
    seen = window(given, ledges=True)
    reach = given.number("distance to the end")
    motion = any_motion(given, seen.start)
    step: Any = Step(seen, motion, Way(motion.rest, blocked=False), reach, seen.beyond(seen.start))
    rule = seen_by(given, rules).walk.choose(step)
    moved = motion.rest - rule.effect(step).rest
    given.ensure("it does not move beyond the end", moved <= reach)


def nobody_is_in_the_way(rules: Rules, given: Given) -> None:
    """Whatever is ahead, the whole stride is free, and nobody is asked to make room."""
    stride, gap, margin = given.number("stride"), given.number("gap"), given.number("margin")
    sight = Sight(stride, given.flag("a body is seen"), gap, margin)
    room = seen_by(given, rules).clearance.choose(sight).effect(sight)
    want = Want(stride, room, given.natural("spare"), given.flag("the body may push"))
    asked = seen_by(given, rules).push.choose(want).effect(want)
    given.ensure("the whole stride is free", room == stride)
    given.ensure("nobody is asked", asked is None)


def points_are_not_obstructed(rules: Rules, given: Given) -> None:
    """No jump edge is as short as a point is wide, so that a point falls wherever a fall edge begins."""
    jump = any_jump(given, "jump")
    jump = replace(jump, across=jump.across - given.number("jump: back"))
    foot = spot(given, "foot")
    seen = replace(lonely_window(given, ledges=True), body_width=jump.across * 0, jump_edges=(jump,), below=foot)
    given.assume(seen.start.reach < 0, "the body is beyond the ledge")
    leaving = depart(seen_by(given, rules), seen, ME, seen.start, seen.start, given.number("distance moved"))
    rule = seen_by(given, rules).leave.choose(leaving)
    placed = rule.effect(leaving)
    given.ensure("it falls", rule.id == "leave/fall")
    given.ensure("both its borders land at one place", placed.front.travelled == placed.rear.travelled)
    given.ensure("on its edge", negated(placed.front.reach < 0))
