"""What is shown of steps: of whole ones on small worlds of storeys, run without contracts from beginning to end; and of
any two neighbours in a row, however long it is.
"""

from __future__ import annotations

from typing import Any

from properties.contracts.request import Seen
from properties.evidence.comparisons import after, alike
from properties.evidence.courses import drive
from properties.given import Given
from properties.worlds.changes import backwards, mirrored
from properties.worlds.storeys import Setting, any_duration, any_world
from spec.graph import Direction
from spec.invariants import every
from spec.number import greater
from spec.profiles import SteppedProfile
from spec.rules.row import Meeting, Member, Relay, Turn, cut_back
from spec.rules.settle import Footing, Top
from spec.rules.step import StepRules
from spec.rules.wish import Urge
from spec.stepped import OF_ONE_STEP, STEP_MIRROR, STEP_SPLIT
from spec.storeys import Drive

MOST_IN_A_STEP = 10_000
NAMED = ("drive", "velocity of the support")


def seen_by(given: Given, profile: SteppedProfile) -> StepRules:
    """The rules of a profile, seen."""
    return profile.rules.through(lambda family: Seen(family, given, MOST_IN_A_STEP))


def steps_keep_the_invariants(profile: SteppedProfile, given: Given, setting: Setting) -> None:
    """Any step of a setting keeps every invariant of one step."""
    world = any_world(given, setting)
    duration = any_duration(given, setting, world)
    course = drive(seen_by(given, profile), world, setting.drives, duration, duration * 0)
    for invariant in OF_ONE_STEP:
        given.ensure(invariant.id, every([invariant.holds(course)]))


def steps_have_mirror_images(profile: SteppedProfile, given: Given, setting: Setting) -> None:
    """The mirror image of any step of a setting does the mirror image."""
    world = any_world(given, setting)
    duration, rules = any_duration(given, setting, world), seen_by(given, profile)
    image = after(rules, mirrored(world), backwards(setting.drives), duration)
    given.ensure(STEP_MIRROR.id, alike(after(rules, world, setting.drives, duration), mirrored(image)))


def steps_may_be_split(profile: SteppedProfile, given: Given, setting: Setting) -> None:
    """Any step of a setting, split anywhere, does what it does at once."""
    world = any_world(given, setting)
    duration, rules, part = any_duration(given, setting, world), seen_by(given, profile), given.number("part")
    given.assume(part <= duration, "the part is one of the step")
    halves = after(rules, world, setting.drives, part, duration - part)
    given.ensure(STEP_SPLIT.id, alike(after(rules, world, setting.drives, duration), halves))


def any_member(given: Given, body: int) -> Member[Any]:
    """Any member of a row."""
    walls = frozenset(way for way in Direction if given.flag(f"a wall on the {way.name.lower()} of {body}"))
    wish = given.number(f"wish of {body} to the right") - given.number(f"wish of {body} to the left")
    return Member(body, wish, given.flag(f"{body} may push"), walls)


def any_speeds(given: Given, body: int) -> tuple[Any, Any]:
    """Any speeds to the right and to the left that reach a body."""
    return given.number(f"speed to the right of {body}"), given.number(f"speed to the left of {body}")


def cut(rules: StepRules, row: list[Member[Any]], speeds: list[tuple[Any, Any]]) -> list[tuple[Any, Any]]:
    """The speeds to the right and to the left that are left of given ones when ways have been looked at."""
    right = cut_back(rules.row, row, [speed for speed, _ in speeds], Direction.RIGHT)
    left = cut_back(rules.row, row[::-1], [speed for _, speed in speeds[::-1]], Direction.LEFT)[::-1]
    return list(zip(right, left, strict=True))


def contacts_do_not_close(rules: StepRules, given: Given) -> None:
    """Of any two in contact, with any speeds, the one behind is not faster, and nobody moves on at a wall.

    What is ahead of the front one in either direction shows in its speed, which is any.
    """
    row, speeds = [any_member(given, body) for body in (0, 1)], [any_speeds(given, body) for body in (0, 1)]
    found = cut(rules, row, speeds)
    (right, left), (other_right, other_left) = found
    given.ensure("they do not come nearer", right - left <= other_right - other_left)
    for member, own, most in zip(row, found, speeds, strict=True):
        for way, speed, bound in zip((Direction.RIGHT, Direction.LEFT), own, most, strict=True):
            given.ensure("no speed is negative", speed >= 0)
            given.ensure("no way makes faster", speed <= bound)
            given.ensure("nobody moves on at a wall", speed <= 0 if way in member.walls else True)


def squeezed_bodies_stand(rules: StepRules, given: Given) -> None:
    """Any body that speeds reach from both sides, or that is in a closed row, stands, whatever is passed on to it."""
    member, (right, left), closed = any_member(given, 0), any_speeds(given, 0), given.flag("the row closes on itself")
    meeting = Meeting(member, right, left, closed)
    part = rules.meet.choose(meeting).effect(meeting)
    (speeds,) = cut(rules, [part], [any_speeds(given, 1)])
    if closed or (right > 0 and left > 0):
        for speed in speeds:
            given.ensure("it stands", speed <= 0)
        given.ensure("it passes nothing on", not part.pushes)
    else:
        given.ensure("else it is as it was", part is member)


def tops_are_chosen(rules: StepRules, given: Given) -> None:
    """Any body over two tops and over no ground: the last one in the direction of its motion; without motion the one
    that it is over most, and of equals the first in the level's order.
    """
    motion = given.number("motion to the right") - given.number("motion to the left")
    names = (1, 2) if given.flag("the one on the left is the first") else (2, 1)
    left, right = (Top(name, given.number("over") - given.number(f"beside {name}")) for name in names)
    footing = Footing(0, holds=False, ground=False, tops=(left, right), motion=motion)
    found = rules.settle.choose(footing).effect(footing)
    given.ensure("it stands on one of them", found.stands and found.support in names)
    chosen, other = (left, right) if found.support == left.body else (right, left)
    if motion > 0:
        given.ensure("it is the last one in its motion", chosen is right)
    elif motion < 0:
        given.ensure("it is the last one in its motion", chosen is left)
    else:
        no_more = chosen.overlap >= other.overlap if chosen.body < other.body else chosen.overlap > other.overlap
        given.ensure("it is over no other more, or as much if that is first", no_more)


def speeds_are_wished(rules: StepRules, given: Given) -> None:
    """What reaches any body is the greater of its own speed and what is passed on; it passes on that or nothing."""
    own, passed = given.number("own speed"), given.number("speed passed on")
    turn = Turn(0, own, passed)
    speed = rules.forward.choose(turn).effect(turn)
    given.ensure("it has the greater", speed == greater(own, passed))
    relay = Relay(0, speed, given.flag("it may push"))
    given.ensure(
        "it passes that on, or nothing", rules.relay.choose(relay).effect(relay) == (speed if relay.pushes else 0)
    )


def wishes_are_of_drives(rules: StepRules, given: Given) -> None:
    """Any body wishes its drive; with what its support does, if the drive is relative to that."""
    speed, carried = (given.number(f"{name} to the right") - given.number(f"{name} to the left") for name in NAMED)
    driven = Drive(speed, given.flag("relative to the support"))
    urge = Urge(0, driven, carried)
    wish = rules.wish.choose(urge).effect(urge)
    given.ensure("it wishes so", wish == (speed + carried if driven.relative else speed))
