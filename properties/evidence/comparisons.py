"""Steps compared: one and two, a world and its mirror image, with and without riders, the rules and the closed form,
all bodies and those in reach.

All but the last in exact numbers: in floats a body may as well be held as not held where a support just ends.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from properties.closed_form import by_batch, furthest, supports_in_one_row
from properties.evidence.courses import Ties, drive
from properties.strategies.storeys import Outing
from properties.worlds.changes import Drives, backwards, chosen, mirrored
from reference.scene import Reach, Scene
from reference.storeys import StoreyWorld
from spec.invariants import every
from spec.number import Truth
from spec.rules.step import StepRules
from spec.stepped import (
    STEP_BODY_ORDER,
    STEP_FURTHEST,
    STEP_MIRROR,
    STEP_ONE_WAY,
    STEP_OUT_OF_REACH,
    STEP_RIDERS,
    STEP_SPLIT,
    Course,
)
from spec.storeys import Survey, short_way

ZERO = Fraction(0)


@dataclass(frozen=True)
class Comparison:
    """A property of an outing and of what came of it."""

    id: str
    holds: Callable[[StepRules, Outing, Course[Any]], Truth]


def after(rules: StepRules, world: StoreyWorld[Any], drives: Drives, *durations: Any) -> Any:
    """The world after steps, one after another."""
    held: Any = world
    for duration in durations:
        held = drive(rules, held, drives, duration, duration * 0).after
    return held


def alike(one: Any, other: Any, names: Sequence[int] | None = None) -> Truth:
    """Whether bodies are at the same places, on the same supports; `names` are those of the other's bodies in one."""
    held = range(len(other.places)) if names is None else names
    return every(
        (short_way(one.span(body).left - other.span(twin).left, one.circumference) == 0)
        if seat(one, body) == (other.storey(twin), None if other.support(twin) is None else held[other.support(twin)])
        else False
        for twin, body in enumerate(held)
    )


def seat(world: Any, body: int) -> tuple[int, int | None]:
    """The storey of a body, and what it stands on."""
    return world.storey(body), world.support(body)


def split_alike(rules: StepRules, outing: Outing, course: Course[Any]) -> Truth:
    """A step in two parts does what it does at once."""
    world, rest = outing.world(), outing.duration - outing.part
    return alike(course.after, after(rules, world, outing.drives_by_body, outing.part, rest))


def mirror_alike(rules: StepRules, outing: Outing, course: Course[Any]) -> Truth:
    """The mirror image does the mirror image."""
    image, drives = mirrored(outing.world()), backwards(outing.drives_by_body)
    return alike(course.after, mirrored(after(rules, image, drives, outing.duration)))


def order_alike(rules: StepRules, outing: Outing, course: Course[Any]) -> Truth:
    """Bodies in another order do the same, or there is a tie."""
    ties = Ties()
    world, drives = chosen(outing.world(), outing.order), chosen_drives(outing.drives_by_body, outing.order)
    other = after(rules.through(ties.watch), world, drives, outing.duration)
    return True if ties.any else alike(course.after, other, outing.order)


def chosen_drives(drives: Drives, bodies: tuple[int, ...]) -> Drives:
    """The drives of some bodies, in another order."""
    return {name: drives[body] for name, body in enumerate(bodies)}


def riders_do_not_count(rules: StepRules, outing: Outing, course: Course[Any]) -> bool:
    """Without all above a storey, the others move the same up to the instant at which one comes down to them."""
    start = outing.world()
    for storey in start.storeys()[:-1]:
        below = tuple(body for body in outing.drives_by_body if start.storey(body) <= storey)
        alone, meanwhile = until_one_comes_down(course, storey)
        other = after(rules, chosen(start, below), chosen_drives(outing.drives_by_body, below), alone)
        if not all(
            not short_way(meanwhile.span(b).left - other.span(i).left, start.circumference) for i, b in enumerate(below)
        ):
            return False
    return True


def until_one_comes_down(course: Course[Any], storey: int) -> tuple[Any, Any]:
    """How long the bodies above a storey stay above it, and the world then."""
    above = [body for body in course.stretches[0].drives if course.before.storey(body) > storey]
    time = ZERO
    for one in course.stretches:
        time += one.lasted
        if any(one.after.storey(body) <= storey for body in above):
            return time, one.after
    return time, course.after


def in_closed_form(outing: Outing, course: Course[Any]) -> bool:
    """Whether there is a closed form: one drive, on a line, all may push, nobody changes its support, and no terrain is
    between the supports of a row.
    """
    driven = sum(1 for drive in outing.drives if drive.speed)
    plain = driven == 1 and outing.terrain.circumference is None and all(place.pushes for place in outing.places)
    if not plain or not supports_in_one_row(outing.world()):
        return False
    return all(
        one.after.support(body) == place.support and one.after.storey(body) == place.storey
        for one in course.stretches
        for body, place in enumerate(outing.places)
    )


def furthest_alike(rules: StepRules, outing: Outing, course: Course[Any]) -> bool:
    """Each body is where the closed form has it, if there is one."""
    if not in_closed_form(outing, course):
        return True
    far = furthest(outing.world(), outing.drives_by_body, outing.duration)
    return all(course.after.span(body).left - place.left == far[body] for body, place in enumerate(outing.places))


def one_way_alike(rules: StepRules, outing: Outing, course: Course[Any]) -> bool:
    """Each body is where a batch has it by its closed form, on what it stood on, if there is one."""
    far = by_batch(outing.world(), outing.drives_by_body, outing.duration)
    return far is None or all(
        course.after.span(body).left == place.left + far[body] and seat(one.after, body) == seat(one.before, body)
        for one in course.stretches
        for body, place in enumerate(outing.places)
    )


def in_reach(outing: Outing, course: Course[Any]) -> Collection[int]:
    """The bodies that a step can reach."""
    world, drives = surveyed(course.before), course.stretches[0].drives
    driven = {body: drive for body, drive in drives.items() if drive.speed or not drive.relative}
    return Reach(Scene(world), driven, type(world.margin)(outing.duration)).ways


def surveyed(world: Survey[Any]) -> StoreyWorld[Any]:
    """A world that an invariant surveys, as the reference has it."""
    assert isinstance(world, StoreyWorld)
    return world


def rest_does_not_count(rules: StepRules, outing: Outing, course: Course[Any]) -> bool:
    """With those in reach only, all is the same at each instant, to the bit, and the rest stand still."""
    bodies, world, first = in_reach(outing, course), surveyed(course.before), course.stretches[0]
    drives = {body: first.drives[body] for body in bodies}
    alone = drive(rules, world.part(bodies), drives, type(world.margin)(outing.duration), first.tolerance)
    still = dict.fromkeys(first.drives, world.margin * 0)
    return len(course.stretches) == len(alone.stretches) and all(
        one.lasted == other.lasted
        and one.velocities == {**still, **other.velocities}
        and surveyed(one.after).places == surveyed(other.after).places
        for one, other in zip(course.stretches, alone.stretches, strict=True)
    )


COMPARISONS = (
    Comparison(STEP_SPLIT.id, split_alike),
    Comparison(STEP_MIRROR.id, mirror_alike),
    Comparison(STEP_BODY_ORDER.id, order_alike),
    Comparison(STEP_RIDERS.id, riders_do_not_count),
    Comparison(STEP_FURTHEST.id, furthest_alike),
    Comparison(STEP_ONE_WAY.id, one_way_alike),
)
IN_FLOATS_TOO = (Comparison(STEP_OUT_OF_REACH.id, rest_does_not_count),)
