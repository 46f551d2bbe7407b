"""Property testing of steps: every invariant and comparison on random storeys."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from properties.closed_form import by_batch
from properties.evidence.comparisons import COMPARISONS, IN_FLOATS_TOO, in_closed_form, in_reach
from properties.evidence.courses import drive
from properties.evidence.sample import FLOAT_TOLERANCE, ONE_RULE, Campaign, Sampling
from properties.strategies.storeys import Outing, outings
from properties.worlds.changes import floating, in_floats
from reference.simulator import Endless
from reference.stepping import MOST_CHOSEN, Chosen, Noted
from spec.profiles import SteppedProfile
from spec.rule import GuardError
from spec.stepped import OF_ONE_STEP, STEP_INSTANTS, Course, key_of

FLOORS = {
    "one falls": 0.1,
    "one lands on the ground": 0.1,
    "one jumps": 0.05,
    "one is carried": 0.1,
    "one is pushed": 0.15,
    "one is squeezed": 0.05,
    "one is at a wall": 0.15,
    "a row in contact": 0.3,
    "a ring closed by a row": 0.002,
    "on a ring": 0.2,
    "two drives or more": 0.3,
    "opposite drives": 0.2,
    "a rider that is driven": 0.15,
    "one key": 0.1,
    "one that may not push": 0.2,
    "a closed form": 0.08,
    "a closed form of a batch": 0.15,
    "one is out of reach": 0.1,
}


def failing(profile: SteppedProfile, outing: Outing, floats: bool, seen: Campaign) -> list[str]:
    """The properties of a step that fail on an outing; most comparisons are in exact numbers only."""
    record = Chosen(MOST_CHOSEN)
    rules = profile.rules.through(lambda family: Noted(family, record))
    try:
        course = course_of(rules, outing, floats)
        fired = {rule for _, rule in record.fired}
        seen.shares.update({*fired, *features(outing, course, fired)})
        broken = [invariant.id for invariant in OF_ONE_STEP if not invariant.holds(course)]
        compared = IN_FLOATS_TOO if floats else (*COMPARISONS, *IN_FLOATS_TOO)
        return broken + [one.id for one in compared if not one.holds(profile.rules, outing, course)]
    except GuardError:
        return [ONE_RULE]
    except Endless:
        return [STEP_INSTANTS.id]


def course_of(rules: Any, outing: Outing, floats: bool) -> Course[Any]:
    """What comes of an outing."""
    if floats:
        drives = floating(outing.drives_by_body)
        return drive(rules, in_floats(outing.world()), drives, float(outing.duration), FLOAT_TOLERANCE)
    return drive(rules, outing.world(), outing.drives_by_body, outing.duration, Fraction(0))


FEATURES_OF_RULES = {
    "settle/fall": "one falls",
    "settle/ground": "one lands on the ground",
    "settle/jump": "one jumps",
    "row/pushed": "one is pushed",
    "row/squeezed": "one is squeezed",
    "row/ring": "a ring closed by a row",
    "way/wall": "one is at a wall",
}


def features(outing: Outing, course: Course[Any], fired: set[str]) -> Iterator[str]:
    """What of interest there is in an outing, in its course and in the rules that fired."""
    yield from (feature for rule, feature in FEATURES_OF_RULES.items() if rule in fired)
    speeds = [drive.speed for drive in outing.drives if drive.speed]
    found = {
        "one is carried": any(is_carried(course)),
        "a row in contact": any(one.contacts for one in course.stretches),
        "on a ring": outing.terrain.circumference is not None,
        "two drives or more": len(set(speeds)) > 1,
        "opposite drives": bool(speeds) and min(speeds) < 0 < max(speeds),
        "a rider that is driven": any(
            place.support is not None and drive.speed for place, drive in zip(outing.places, outing.drives, strict=True)
        ),
        "one key": key_of(outing.drives_by_body) is not None,
        "one that may not push": not all(place.pushes for place in outing.places),
        "a closed form": in_closed_form(outing, course),
        "a closed form of a batch": by_batch(outing.world(), outing.drives_by_body, outing.duration) is not None,
        "one is out of reach": len(in_reach(outing, course)) < len(outing.places),
    }
    yield from (name for name, there in found.items() if there)


def is_carried(course: Course[Any]) -> Iterator[bool]:
    """Whether a body moves with its support, for each body and stretch."""
    for one in course.lasting:
        for body, velocity in one.velocities.items():
            yield one.before.support(body) is not None and velocity != 0 and velocity == one.carried(body)


STOREYS = Sampling("storeys", outings, FLOORS, failing)
