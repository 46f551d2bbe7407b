"""Requests on the reference world, as the invariants see them."""

from __future__ import annotations

from typing import Any

from reference.simulator import Record, move
from reference.world import World
from spec.graph import Direction
from spec.invariants import Deed
from spec.profiles import Profile

MOST_RULES = 20_000


def do(
    profile: Profile, world: World[Any], body: int, direction: Direction, asked: Any, tolerance: Any
) -> tuple[Deed[Any], Record]:
    """Make a request of a copy of a world; return what came of it, and the rules that fired."""
    after = world.copy()
    moved, record = move(profile, after, body, direction, asked, MOST_RULES)
    limit = profile.push_limit(len(world.bodies))
    deed = Deed(world, after, body, direction, asked, moved, record.depth, limit, len(record.fired), tolerance)
    return deed, record
