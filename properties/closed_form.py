"""Closed forms of a request and of a step, in numpy: other formulations, to hold the rules against.

That of a step is the one by which `reference.batch` steps. Of a request: with `rooms` the clear distances along the
chain beyond the margin, and `end` the distance from its last body to the wall or to what counts as one, the mover goes
as far as all of that, and the body after the j-th room goes what that exceeds the rooms before it.
"""

from __future__ import annotations

from collections.abc import Mapping
from itertools import pairwise
from typing import Any

import numpy as np

from reference.batch import Batch, drives_of
from reference.storeys import StoreyWorld
from reference.world import World
from spec.graph import Direction
from spec.profiles import REPAIRED
from spec.storeys import Drive


def displacements(world: World[Any], body: int, direction: Direction, asked: Any, limit: int) -> dict[int, Any]:
    """How far each body of the chain moves at a request, by cumulative sums over the world."""
    chain = [body]
    while len(chain) < limit and (ahead := world.beside(chain[-1], direction)) not in (None, body):
        assert ahead is not None
        chain.append(ahead)
    beyond = world.beside(chain[-1], direction)
    pairs = [*pairwise(chain)] + ([] if beyond is None else [(chain[-1], beyond)])
    gaps = [world.clear(*(pair if direction is Direction.RIGHT else pair[::-1])) for pair in pairs]
    rooms = np.array([gap - world.margin for gap in gaps], dtype=object)
    used = np.concatenate([[asked * 0], np.cumsum(rooms)])
    wall = world.to_wall(chain[-1], direction) if beyond is None else asked * 0
    most = asked if wall is None else min(asked, used[-1] + wall)
    return {held: max(most * 0, most - before) for held, before in zip(chain, used, strict=False)}


def furthest(world: StoreyWorld[Any], drives: Mapping[int, Drive[Any]], duration: Any) -> dict[int, Any] | None:
    """How far each body goes in a step, positive to the right; None if that has no closed form."""
    batch = Batch([world], REPAIRED.rules)
    far, fits = batch.furthest(drives_of([drives]), np.array([duration]))
    return dict(zip(batch.layout.order.tolist(), far, strict=True)) if fits[0] else None
