"""Closed forms of a request and of a step, in numpy: other formulations, to hold the rules against.

Of a request: with `rooms` the clear distances along the chain beyond the margin, and `end` the distance from its last
body to the wall or to what counts as one, the mover goes as far as all of that, and the body after the j-th room goes
what that exceeds the rooms before it.
"""

from __future__ import annotations

from collections.abc import Mapping
from itertools import pairwise
from typing import Any

import numpy as np

from reference.batch import Batch, along_rows, drives_of, storey_of
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


def furthest(world: StoreyWorld[Any], drives: Mapping[int, Drive[Any]], duration: Any) -> dict[int, Any]:
    """How far each body moves in a step on a line in which one is driven, all may push and nobody changes its support.

    The supports of each row are to be in one row (`supports_in_one_row`). Displacements are signed, positive to the
    right. They are found storey by storey upwards, and row by row.
    """
    (driven,) = [body for body, drive in drives.items() if drive.speed]
    sign = 1 if drives[driven].speed > 0 else -1
    direction = Direction.RIGHT if sign > 0 else Direction.LEFT
    found: dict[int, Any] = {}
    for storey in world.storeys():
        for row in free_rows(world, storey)[::sign]:
            bodies = row[::sign]
            wishes = [wish(world, body, drives[body], duration, found) * sign for body in bodies]
            pairs = pairwise(bodies) if sign > 0 else (pair[::-1] for pair in pairwise(bodies))
            rooms = [world.gap(*pair) - world.margin for pair in pairs]
            walls = [world.to_wall(body, direction) for body in bodies]
            found.update(
                (b, far * sign) for b, far in zip(bodies, along_row(wishes, rooms, walls, direction), strict=True)
            )
    return found


def free_rows(world: StoreyWorld[Any], storey: int) -> list[list[int]]:
    """The bodies of a storey of a line from left to right, cut where terrain is between them."""
    pairs = set(world.neighbours())
    found: list[list[int]] = []
    for body in world.row(storey):
        if found and (found[-1][-1], body) in pairs:
            found[-1].append(body)
        else:
            found.append([body])
    return found


def supports_in_one_row(world: StoreyWorld[Any]) -> bool:
    """Whether, where no terrain is between bodies, none is between the bodies that they stand on.

    Else one that is pushed stops when a wall stops the support of who pushes it, and goes on when its own support does.
    """
    rows = [set(row) for storey in world.storeys() for row in free_rows(world, storey)]
    return all(sum(1 for below in rows if any(world.support(body) in below for body in row)) <= 1 for row in rows)


def wish(world: StoreyWorld[Any], body: int, drive: Drive[Any], duration: Any, found: Mapping[int, Any]) -> Any:
    """How far a body goes if nothing is in its way: by its drive, and by what carries it."""
    support = world.support(body)
    return drive.speed * duration + (found[support] if drive.relative and support is not None else 0)


def along_row(wishes: list[Any], rooms: list[Any], walls: list[Any], direction: Direction) -> Any:
    """How far each of a row goes in a direction, by the text of a batch that has this row only; all from behind."""
    row = storey_of(0, np.arange(len(wishes)), np.zeros(0, int))
    starts = np.cumsum(np.array([wishes[0] * 0, *rooms], object))
    from_left = (np.array(one, object)[::direction] for one in (wishes, starts, walls))
    return along_rows(row, direction, *from_left)[0][::direction]


def by_batch(world: StoreyWorld[Any], drives: Mapping[int, Drive[Any]], duration: Any) -> dict[int, Any] | None:
    """How far each body moves in a step if a batch has a closed form of that, positive to the right; else None."""
    batch = batch_of(world, drives)
    far, fits = batch.furthest(batch.layout, batch.left, np.array([duration]))
    return dict(zip(batch.layout.order.tolist(), far, strict=True)) if fits[0] else None


def kept_by_batch(world: StoreyWorld[Any], drives: Mapping[int, Drive[Any]], duration: Any) -> dict[int, Any] | None:
    """The speed of each body if a batch says by its closed form that all keep theirs for a time; else None."""
    batch, durations = batch_of(world, drives), np.array([duration])
    far, fits = batch.furthest(batch.layout, batch.left, durations)
    if not fits[0]:
        return None
    speeds, straight = batch.straight(batch.layout, far, durations)
    return dict(zip(batch.layout.order.tolist(), speeds, strict=True)) if straight[0] else None


def batch_of(world: StoreyWorld[Any], drives: Mapping[int, Drive[Any]]) -> Batch:
    """A batch of one level, whose bodies are driven so."""
    batch = Batch([world], REPAIRED.rules)
    batch.drive(drives_of([drives]))
    return batch
