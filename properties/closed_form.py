"""The closed form of a request on one world, in numpy: another formulation, to hold the rules against.

With `rooms` the clear distances along the chain beyond the margin, and `end` the distance from its last body to
the wall or to what counts as one, the mover goes as far as all of that, and the body after the j-th room goes
what that exceeds the rooms before it.
"""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np

from reference.world import World
from spec.graph import Direction


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
