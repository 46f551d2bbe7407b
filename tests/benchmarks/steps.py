"""The scenes of the bench of steps: rows and stacks that are pushed, and rows beside many who stand by.

All bodies are boxes one unit wide, on a floor that is never left. The first is driven to the right, tick by tick.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

import numpy as np

from properties.strategies.storeys import MOST_BODIES, MOST_STOREYS, outing
from properties.worlds.changes import Drives, floating, in_floats
from reference.batch import Batch, drives_of
from reference.scene import Scene
from reference.stepping import run_in_reach
from reference.storeys import Place, StoreyWorld, Terrain
from spec.profiles import REPAIRED
from spec.storeys import Drive, Interval

TICK, SPEED, MARGIN, APART = Fraction(1, 50), Fraction(1), Fraction(1, 8), 10
DRIVEN = {0: Drive(SPEED, relative=False)}
FAR = 30_000
IN_BATCH = 50_000
"""How many bodies there are in a batch, in as many levels of the same scene."""
SLACK = 2.0**-20
"""Who comes as near as that to losing its support goes by events."""


@dataclass(frozen=True)
class Pushed:
    """A row in contact, or a stack, of which the first body pushes or carries all others.

    Attributes:
        standing_by: how many others there are, a unit from each other, and far from those.
    """

    kind: str
    bodies: int
    standing_by: int = 0

    @property
    def ticks(self) -> int:
        """How many ticks are timed together: four seconds, or one of many bodies."""
        return 200 if self.bodies <= 100 else 50

    @property
    def few_ticks(self) -> int:
        """How many ticks of them from event to event."""
        return max(4, 200 // self.bodies)

    def world(self) -> StoreyWorld[Fraction]:
        """The bodies on their storeys."""
        one, apart = Fraction(1), 1 + MARGIN
        row = [Place(0, place * apart, one, None) for place in range(self.bodies)]
        stack = [Place(storey, one, one, storey - 1 if storey else None) for storey in range(self.bodies)]
        by = [Place(0, self.beyond + 2 * place, one, None) for place in range(self.standing_by)]
        ends = Interval(Fraction(-FAR), Fraction(FAR))
        return StoreyWorld(Terrain((), ends), MARGIN, [*(row if self.kind == "row" else stack), *by])

    @property
    def beyond(self) -> Fraction:
        """Where those begin who stand by."""
        return self.bodies * (1 + MARGIN) + APART


@dataclass(frozen=True)
class Prepared:
    """A program that is to be timed.

    Attributes:
        ticks: how many steps it runs of each of its levels.
        counted: what it has counted.
        come: how far the last of the pushed bodies has come, in all.
    """

    program: Callable[[], Any]
    ticks: int
    counted: Callable[[], dict[str, float]]
    come: Callable[[], float]
    levels: int = 1

    @property
    def steps(self) -> int:
        """How many steps it runs in all."""
        return self.ticks * self.levels


def by_events(scene: Pushed, floats: bool) -> Prepared:
    """The rules, from event to event."""
    world: StoreyWorld[Any] = in_floats(scene.world()) if floats else scene.world()
    drives: Drives = floating(DRIVEN) if floats else DRIVEN
    held, tick, chosen, last = Scene(world), type(world.margin)(TICK), list[int](), scene.bodies - 1
    start = world.places[last].left

    def program() -> None:
        for _ in range(scene.few_ticks):
            chosen.append(run_in_reach(REPAIRED.rules, held, drives, tick)[1].chosen)

    return Prepared(
        program, scene.few_ticks, lambda: {"choices": chosen[0]}, lambda: float(world.places[last].left - start)
    )


def at_once(scene: Pushed, bodies: int, anew: bool = False) -> Prepared:
    """The closed form, of as many levels as have so many bodies, or of one.

    If `anew`, speeds change in each tick, so that all is looked at in each.
    """
    world, all_drives = in_floats(scene.world()), floating(DRIVEN)
    count = len(world.places)
    drives = dict.fromkeys(range(count), Drive(0.0)) | all_drives
    levels = max(1, bodies // count)
    return of_batch([world] * levels, [drives] * levels, scene.ticks, scene.bodies, (1.5, 0.5) if anew else ())


def of_batch(
    worlds: Sequence[StoreyWorld[float]],
    drives: Sequence[Drives],
    ticks: int,
    pushed: int,
    changes: Sequence[float] = (),
) -> Prepared:
    """A batch of levels, driven for some ticks; the first so many bodies of the first level are pushed.

    Speeds are so many times as great, in turn from tick to tick.
    """
    batch, shares = Batch(worlds, REPAIRED.rules, SLACK), list[float]()
    durations, last = np.full(len(worlds), float(TICK)), pushed - 1
    start, given = float(batch.left[last]), drives_of(drives)
    in_turn = [replace(given, speed=given.speed * change) for change in changes]
    batch.drive(given)

    def program() -> None:
        for tick in range(ticks):
            if in_turn:
                batch.drive(in_turn[tick % len(in_turn)])
            batch.step(durations)
        shares.append(float(np.mean(batch.fits)))

    return Prepared(
        program,
        ticks,
        lambda: {"share": sum(shares) / len(shares)},
        lambda: float(batch.left[last]) - start,
        len(worlds),
    )


def of_random_levels(levels: int) -> Prepared:
    """A batch of random lines with pits and riders, in which any number of bodies are driven, to both sides."""
    made = [outing(number, 1 + number % MOST_BODIES, number % (MOST_STOREYS + 1)) for number in range(2 * levels)]
    lines = [one for one in made if one.places and one.terrain.circumference is None][:levels]
    worlds = [in_floats(one.world()) for one in lines]
    return of_batch(worlds, [floating(one.drives_by_body) for one in lines], 4, 1)
