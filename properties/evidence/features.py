"""What is left of the trouble without a feature: all that is promised, judged on each small shape, the smallest first.

One exploration judges all promises that no smaller shape has broken; a promise that is broken has its witness, and the
shape is explored again for the others.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction
from functools import partial
from typing import Any

from properties.claims.features import MOST_BODIES, MOST_EDGES, Promise, promises_of
from properties.engine.explore import explore
from properties.evidence.deeds import do
from properties.evidence.hunt import MOVER, RIGHT, start_in_order
from properties.given import Given
from properties.worlds.points import scene_of_points
from properties.worlds.scenes import Shape, scene, shapes
from reference.world import World
from spec.body import Level
from spec.features import PLANE_ORDER, WIDTH
from spec.profiles import Profile


@dataclass
class Left:
    """What is left without some features: for each promise that is broken the smallest shape and values."""

    witnesses: dict[str, tuple[Shape, dict[str, Fraction | bool]]] = field(default_factory=dict)
    shapes: int = 0
    paths: int = 0
    open: list[str] = field(default_factory=list)


def shapes_of(riders: bool) -> list[Shape]:
    """All small shapes on which nobody stands on another, or all on which somebody does."""
    found = shapes(MOST_BODIES, MOST_EDGES, guided=False)
    return [one for one in found if one.has_riders == riders]


def scene_under(profile: Profile, given: Given, shape: Shape) -> tuple[Level[Any], Any]:
    """Any level of a shape, with such bodies as a profile has, and any distance asked."""
    return scene_of_points(given, shape) if WIDTH in profile.without else scene(given, shape, guided=False)


def judge(profile: Profile, shape: Shape, promises: dict[str, Promise], given: Given) -> None:
    """Ask the first body of any scene of a shape to move right by any distance, and make promises of it."""
    level, asked = scene_under(profile, given, shape)
    world = World(level)
    start_in_order(given, world)
    deed, record = do(profile, world, MOVER, RIGHT, asked, asked * 0)
    fired = frozenset(rule for body, rule in record.fired if body == MOVER)
    for name, promise in promises.items():
        given.ensure(name, promise(deed, fired))


def left_of(profile: Profile, riders: bool) -> Left:
    """Go through all small shapes; what is promised and not in the witnesses holds on all of them."""
    left, promises = Left(), promises_of(profile)
    for shape in shapes_of(riders):
        left.shapes += 1
        layered = {PLANE_ORDER.id} if shape.platform is not None else set()
        while True:
            asked = {name: one for name, one in promises.items() if name not in left.witnesses.keys() | layered}
            outcome = explore(partial(judge, profile, shape, asked))
            found = outcome.counterexample
            if found is None:
                left.paths += outcome.paths
                left.open += outcome.open
                break
            left.witnesses.update(dict.fromkeys(found.broken, (shape, found.values)))
    return left
