"""The physics of a tick: the velocities that bodies get before they move, and those that are left to them afterwards.

Velocities change in ticks only. A request or a drive moves whom it names, and the velocities of others stay.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from reference.world import World
from spec.body import Level
from spec.number import N, zero_like
from spec.rules.settle import motion_of
from spec.rules.velocity import Motion, VelocityRules, magnitude, meet, simulate_tick
from spec.slope import slope_under
from spec.storeys import Storeys


def set_off(rules: VelocityRules, world: World[N], body: int, motion: Motion[N]) -> Motion[N]:
    """The motion with which a body sets off in a tick, on the ground that it is on."""
    return simulate_tick(rules, motion, slope_under(world, body), world.level.tick)


def left_to(
    rules: VelocityRules, storeys: Storeys[N], body: int, motion: Motion[N], speeds: Mapping[int, N]
) -> Motion[N]:
    """The motion that is left to a body when all have moved at once; `speeds` are those in the plane, in the end."""
    actual, zero = motion_of(storeys, speeds, body), zero_like(motion.velocity)
    forwards = actual * -1 if motion.velocity < zero else actual
    return meet(rules, motion, bool(forwards >= magnitude(motion.velocity)), actual)


def with_motions(level: Level[N], motions: Mapping[int, Motion[N]]) -> Level[N]:
    """The same level, with other motions of some of its bodies."""
    bodies = (replace(held, motion=motions.get(body, held.motion)) for body, held in enumerate(level.bodies))
    return replace(level, bodies=tuple(bodies))
