"""What a run says of every statement, in the order of the page."""

from __future__ import annotations

from evaluation import pushing, sliding
from evaluation.finding import Finding, Tables

OF_ALL = (
    sliding.gravity_slope,
    sliding.gravity_of_10,
    sliding.flat_friction,
    sliding.static_friction,
    sliding.normal_force,
    sliding.start_speed,
    pushing.linear_time,
    pushing.spikes,
    pushing.boxes_in_scene,
    pushing.into_wall,
    pushing.constant_speed,
)


def findings(tables: Tables) -> list[Finding]:
    """What is found of every statement."""
    return [finding(tables) for finding in OF_ALL]
