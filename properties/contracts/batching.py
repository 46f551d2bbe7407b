"""A bank of small worlds of storeys that a batch steps at once: each is to be where events lead, and to have a closed
form where it is to have one. They are at, and just beyond, the boundaries of where there is one.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cache
from itertools import groupby
from typing import Any

import numpy as np

from properties.contracts.judging_steps import HALF, Wide, at, line, rides, ring, terrain, walks
from properties.evidence.courses import drive
from reference.batch import MANY_ROWS, Batch, drives_of, storey_of
from reference.storeys import Place, StoreyWorld, Terrain
from spec.profiles import SteppedProfile
from spec.storeys import Drive, Interval

FORTH_AND_BACK = (1, 1, -1, -1)
"""Whether all are driven so in a step, or backwards."""


@dataclass(frozen=True)
class Batched:
    """A world, the drives of those that are driven, how long a step takes, and whether the first has a closed form."""

    name: str
    world: StoreyWorld[Fraction]
    driven: Mapping[int, Drive[Fraction]]
    duration: Any
    closed: bool = field(default=True, kw_only=True)

    def drives(self, sign: int) -> dict[int, Drive[Fraction]]:
        """The drives of all, or those backwards."""
        own = [self.driven.get(body, rides()) for body in range(len(self.world.places))]
        return {body: Drive(one.speed * sign, one.relative) for body, one in enumerate(own)}


ROW = at(1, 3), at(5, 7), at(12, 14)


def wide(*places: Place[Fraction], solid: Iterable[Iterable[Wide]] = ()) -> StoreyWorld[Fraction]:
    """Bodies on a line of length 50."""
    return StoreyWorld(Terrain(terrain(solid), Interval(Fraction(0), Fraction(50))), Fraction(1), places)


CARRIED = at(4, 12), at(5, 7, 1, on=0)
LEDGE = [[(0, 5)]]
SPECK = Fraction(1, 100)
"""How much nearer roundings may have led a body."""
SUPPORTS = at(10, 18), at(22, 30), at(11, 17, 1, on=0), at(21, 29, 1, on=1), at(13, 19, 2, on=2), at(20, 26, 2, on=3)
OVER_A_WALL = wide(*SUPPORTS, solid=[[], [(19, 20)]])
BETWEEN = wide(at(0, 6), at(20, 26), at(1, 5, 1, on=0), at(19, 23, 1, on=1), solid=[[(14, 15)]])
PUSHED_FIRST = line(at(0, 4), at(8, 10), at(1, 3, 1, on=0), at(5, 13, 1, on=1))
NARROW = at(0, 6), at(5, 7, 1, on=0)
BANK: tuple[Batched, ...] = (
    Batched("one pushes two to a wall", line(*ROW), {0: walks(2)}, 3),
    Batched("to the left", line(*ROW), {2: walks(-2)}, 3),
    Batched("the middle one walks", line(*ROW), {1: walks(1)}, 3),
    Batched("two walk alike", line(*ROW), {0: walks(1), 1: walks(1)}, 6),
    Batched("the one ahead walks", line(*ROW), {0: walks(1), 2: walks(1)}, 2),
    Batched("two at two speeds", line(*ROW), {0: walks(1), 1: walks(2)}, 1, closed=False),
    Batched("towards each other", line(*ROW), {0: walks(1), 2: walks(-1)}, 1, closed=False),
    Batched("all stand", line(*ROW), {}, 1),
    Batched("a wall between rows", line(at(0, 2), at(4, 6), at(11, 13), solid=[[(9, 10)]]), {0: walks(1)}, 3),
    Batched("both rows walk", line(at(0, 2), at(4, 6), at(11, 13), solid=[[(9, 10)]]), {0: walks(1), 2: walks(1)}, 3),
    Batched("a wall on each side", line(at(5, 7), solid=[[(0, 2), (3, 4), (9, 10), (12, 13)]]), {0: walks(1)}, 3),
    Batched("at a wall", line(at(4, 6), at(7, 9), solid=[[(3, 4), (10, 11)]]), {0: walks(1)}, 1),
    Batched("a speck too near", line(at(1, 3), at(4 - SPECK, 6 - SPECK)), {0: walks(1)}, 2),
    Batched("a speck too far", line(at(1, 3), at(18 + SPECK, 20 + SPECK)), {1: walks(1)}, 1),
    Batched("one that may not push", line(at(1, 3, pushes=False), at(5, 7)), {0: walks(1)}, 3, closed=False),
    Batched("on a ring", ring(at(1, 3), at(5, 7)), {0: walks(1)}, 3, closed=False),
    Batched("carried", line(*CARRIED), {0: walks(1)}, 3),
    Batched("carried by who is pushed", line(at(0, 2), *(at(4, 8), at(5, 7, 1, on=1))), {0: walks(1)}, 3),
    Batched("walks on another", line(*CARRIED), {1: walks(1)}, 15 * HALF),
    Batched("walks off another", line(*CARRIED), {1: walks(1)}, 8, closed=False),
    Batched("walks off to the left", line(*CARRIED), {1: walks(-1)}, 4, closed=False),
    Batched("walks to the left", line(*CARRIED), {1: walks(-1)}, 7 * HALF),
    Batched("driven on who walks", line(*CARRIED), {0: walks(1), 1: rides(1)}, 1, closed=False),
    Batched("walks in the plane as its support does", line(*CARRIED), {0: walks(1), 1: walks(1)}, 5),
    Batched("driven on who stands", line(*CARRIED), {1: rides(1)}, 3),
    Batched("carried to a wall", line(at(12, 16), at(13, 15, 1, on=0)), {0: walks(1)}, 6),
    Batched("left behind in the plane", line(*CARRIED), {0: walks(1), 1: Drive(Fraction(0), relative=False)}, 2),
    Batched("keeps who stands in the plane", line(*CARRIED), {0: walks(-1), 1: walks(0)}, 8),
    Batched("just keeps who stands", line(at(10, 14), at(11, 13, 1, on=0)), {0: walks(-1), 1: walks(0)}, 7 * HALF),
    Batched("loses who stands", line(at(10, 14), at(11, 13, 1, on=0)), {0: walks(-1), 1: walks(0)}, 4, closed=False),
    Batched("stopped above", line(*CARRIED, solid=[[], [(9, 10)]]), {0: walks(1)}, 3),
    Batched("stopped above for long", line(*CARRIED, solid=[[], [(9, 10)]]), {0: walks(1)}, 7, closed=False),
    Batched("carried just to a wall", line(*NARROW, solid=[[], [(9, 10)]]), {0: walks(1)}, 2),
    Batched("stopped on a short one", line(*NARROW, solid=[[], [(9, 10)]]), {0: walks(1)}, 3, closed=False),
    Batched("two supports, and a wall between their riders", OVER_A_WALL, {0: walks(1)}, 5, closed=False),
    Batched("two supports, and nobody at a wall yet", OVER_A_WALL, {0: walks(1)}, HALF),
    Batched("two supports, and no wall", wide(*SUPPORTS), {0: walks(1)}, 5),
    Batched("two supports, one above is driven too", OVER_A_WALL, {0: walks(1), 5: walks(1)}, 5, closed=False),
    Batched("two supports, with a wall between them", BETWEEN, {0: walks(1), 1: walks(1)}, 2),
    Batched("pushed on its support before that is", PUSHED_FIRST, {0: walks(1), 3: walks(0)}, 7, closed=False),
    Batched("over a ledge", line(at(2, 4, 1), solid=LEDGE), {0: walks(1)}, 5 * HALF),
    Batched("off a ledge", line(at(2, 4, 1), solid=LEDGE), {0: walks(1)}, 3, closed=False),
    Batched("off a ledge to the left", line(at(8, 10, 1), solid=[[(7, 12)]]), {0: walks(-1)}, 3, closed=False),
    Batched("over a ledge to the left", line(at(8, 10, 1), solid=[[(7, 12)]]), {0: walks(-1)}, 5 * HALF),
    Batched("over a hole", line(at(3, 5, 1), solid=[[(0, 5), (6, 9)]]), {0: walks(1)}, 5),
    Batched("into a hole", line(at(3, 5, 1), solid=[[(0, 5), (7, 9)]]), {0: walks(1)}, 5, closed=False),
    Batched("two above, one pushes", line(at(0, 9), at(1, 3, 1, on=0), at(5, 7, 1, on=0)), {1: walks(1)}, 3),
    Batched("two on two", line(at(0, 4), at(6, 10), at(1, 3, 1, on=0), at(5, 7, 1, on=1)), {0: walks(1)}, 2),
    Batched("three storeys", line(at(0, 8), at(1, 7, 1, on=0), at(2, 5, 2, on=1)), {0: walks(1)}, 4),
    Batched("a long row", line(*(at(3 * i, 3 * i + 1) for i in range(6))), {0: walks(1)}, 5),
)
NEARLY: tuple[Batched, ...] = (
    Batched("may come off to the right", line(*CARRIED), {1: walks(1)}, 15 * HALF, closed=False),
    Batched("comes not so near", line(*CARRIED), {1: walks(1)}, 29 * HALF / 2),
    Batched("may come off to the left", line(*CARRIED), {1: walks(-1)}, 7 * HALF, closed=False),
    Batched("comes not so near on the left", line(*CARRIED), {1: walks(-1)}, 13 * HALF / 2),
)
"""What goes by events if it comes nearer than a half to losing its support."""


@cache
def courses(profile: SteppedProfile) -> dict[str, list[Any]]:
    """Where events lead the bodies of each world, step by step."""
    found = {}
    for one in (*BANK, *NEARLY):
        world: Any = one.world
        steps = list[Any]()
        for sign in FORTH_AND_BACK:
            world = drive(profile.rules, world, one.drives(sign), Fraction(one.duration), Fraction(0)).after
            steps.append(world.places)
        found[one.name] = steps
    return found


def batches_are_where_events_lead(profile: SteppedProfile) -> int:
    """All worlds of the bank, stepped at once, are where events lead each; and so are very many of one of them."""
    together = ((BANK, 0), ((BANK[0],) * (1 + MANY_ROWS), 0), (NEARLY, HALF))
    return sum(steps_are_right(profile, *levels) for levels in together)


def steps_are_right(profile: SteppedProfile, levels: Sequence[Batched], slack: Any) -> int:
    """Whether a batch of some worlds is where events lead each after each step."""
    batch = Batch([one.world for one in levels], profile.rules, slack)
    for step, sign in enumerate(FORTH_AND_BACK):
        batch.drive(drives_of([one.drives(sign) for one in levels]))
        batch.step(np.array([Fraction(one.duration) for one in levels]))
        for level, one in enumerate(levels):
            assert batch.world(level).places == courses(profile)[one.name][step], f"{one.name}: wrong at step {step}"
            assert step or bool(batch.fits[level]) is one.closed, f"{one.name}: it is {batch.fits[level]} that it fits"
    return len(levels) * len(FORTH_AND_BACK)


LENGTHS = (1,), (4,), (3, 3), (4, 4, 2, 1, 1), (5, 2, 2)
"""How long the rows of a storey are, in the order of a batch."""


def rows_are_laid_out(profile: SteppedProfile) -> int:
    """The bodies of a storey are found by their places in rows, and each finds the one behind it."""
    for lengths in LENGTHS:
        bodies = [(at, row) for at in range(lengths[0]) for row, length in enumerate(lengths) if length > at]
        for start in (0, 7):
            found = storey_of(start, np.array([at for at, _ in bodies]), np.array([], int))
            assert found.bodies == slice(start, start + len(bodies)), f"rows of {lengths}: {found.bodies}"
            assert found.first == len(lengths), f"rows of {lengths}: {found.first} are first"
            behind = [bodies.index((at - 1, row)) for at, row in bodies if at]
            assert found.behind.tolist() == behind, f"rows of {lengths}: behind are {found.behind}"
            assert found.runs == runs_of(bodies), f"rows of {lengths}: {found.runs}"
    return 2 * len(LENGTHS)


def runs_of(bodies: Sequence[tuple[int, int]]) -> tuple[tuple[slice, int], ...]:
    """The places that as many rows have, one place after another: where their bodies are, and how many rows that is."""
    many = [sum(at == place for at, _ in bodies) for place, _ in bodies]
    found, start = [], 0
    for rows, those in groupby(many):
        end = start + len(list(those))
        found.append((slice(start, end), rows))
        start = end
    return tuple(found)
