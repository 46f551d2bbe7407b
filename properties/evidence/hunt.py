"""The hunt for witnesses: small scenes, the smallest shapes first, all sizes arbitrary; the solver finds the numbers.

Nothing is written down beforehand but what is hunted. A hunt that has been through all its shapes and found nothing
has shown its promise for them: that is a bounded proof.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction
from functools import partial
from random import Random
from typing import Any

from properties.claims.claim import Hunt
from properties.contracts.request import judged
from properties.engine.explore import Outcome, explore
from properties.evidence.deeds import do
from properties.given import Given
from properties.worlds.points import scene_of_points
from properties.worlds.scenes import Shape, scene, shapes
from reference.world import World
from spec.body import Level
from spec.conditions import PLANE_START
from spec.graph import Direction
from spec.profiles import Profile

MOVER, RIGHT = 0, Direction.RIGHT


@dataclass
class Quarry:
    """What a hunt brought home: the shape and the values of a witness, if any, and the paths it went."""

    paths: int = 0
    shape: Shape | None = None
    values: dict[str, Fraction | bool] = field(default_factory=dict)
    open: list[str] = field(default_factory=list)


def start_in_order(given: Given, world: World[Any]) -> None:
    """Assume a start that keeps the margins, on every string and in the plane, and is outside all terrain."""
    given.assume(PLANE_START.holds(world, world.margin), PLANE_START.id)


def scene_of(hunt: Hunt, given: Given, shape: Shape) -> tuple[Level[Any], Any]:
    """Any scene of a hunt that has a shape, and any distance asked."""
    return scene_of_points(given, shape) if hunt.points else scene(given, shape, hunt.guided)


def promise_of(hunt: Hunt, shape: Shape, profile: Profile, given: Given) -> None:
    """Ask the first body of any scene of a shape to move right by any distance, and make the promise of a hunt."""
    level, asked = scene_of(hunt, given, shape)
    world = World(level)
    start_in_order(given, world)
    for condition in hunt.premises:
        given.assume(condition.holds(world, asked), condition.id)
    deed, record = do(profile, world, MOVER, RIGHT, asked, asked * 0)
    fired = frozenset(rule for body, rule in record.fired if body == MOVER)
    for rule in fired:
        given.saw(rule)
    given.ensure(hunt.id, hunt.promise(deed, fired))


def in_order(hunt: Hunt, seed: int) -> list[Shape]:
    """The shapes of a hunt, the smallest first and equals in any order."""
    order = shapes(hunt.most_bodies, hunt.most_edges, hunt.guided)
    Random(seed).shuffle(order)
    found = [one for one in sorted(order, key=lambda one: one.size) if len(one.stands) >= hunt.least_bodies]
    return [one for one in found if (hunt.riders and not hunt.points) or not one.has_riders]


def go(hunt: Hunt, profile: Profile, seed: int = 0) -> Quarry:
    """Go through the shapes of a hunt until a witness is found."""
    quarry = Quarry()
    for shape in in_order(hunt, seed):
        outcome: Outcome = explore(partial(judged, partial(promise_of, hunt, shape), profile))
        quarry.paths += outcome.paths
        quarry.open += outcome.open
        if outcome.counterexample is not None:
            quarry.shape, quarry.values = shape, outcome.counterexample.values
            break
    return quarry
