"""What is shown of the closed form of a batch: on whole steps of small worlds, run from beginning to end."""

from __future__ import annotations

from typing import Any

from properties.closed_form import by_batch, kept_by_batch
from properties.contracts.steps import seen_by
from properties.evidence.comparisons import seat
from properties.evidence.courses import drive
from properties.given import Given
from properties.worlds.storeys import Setting, any_duration, any_world
from spec.invariants import every
from spec.profiles import SteppedProfile


def batches_end_where_events_lead(profile: SteppedProfile, given: Given, setting: Setting) -> None:
    """Any step of a setting that has a closed form leaves all on what they were on, as far on as that says."""
    world = any_world(given, setting)
    duration = any_duration(given, setting, world)
    far = by_batch(world, setting.drives, duration)
    if far is None:
        return
    after: Any = drive(seen_by(given, profile), world, setting.drives, duration, duration * 0).after
    given.ensure(
        "they are so far on", every(after.span(body).left == world.span(body).left + far[body] for body in far)
    )
    given.ensure("they are on what they were on", all(seat(after, body) == seat(world, body) for body in far))


def speeds_are_kept_for_any_part(profile: SteppedProfile, given: Given, setting: Setting) -> None:
    """Where all keep their speeds for a time, as a batch says, a step of any part of it moves each at its speed, and
    leaves all on what they were on.
    """
    world = any_world(given, setting)
    duration = any_duration(given, setting, world)
    speeds = kept_by_batch(world, setting.drives, duration)
    if speeds is None:
        return
    part = given.number("part")
    given.assume(part <= duration, "the part is one of the time")
    after: Any = drive(seen_by(given, profile), world, setting.drives, part, part * 0).after
    given.ensure(
        "they are so far on",
        every(after.span(body).left == world.span(body).left + part * speeds[body] for body in speeds),
    )
    given.ensure("they are on what they were on", all(seat(after, body) == seat(world, body) for body in speeds))
