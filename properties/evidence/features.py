"""What goes wrong without a feature: small witnesses, found on small shapes, the smallest first, and played again."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from typing import Any

from properties.claims.features import MOST_BODIES, MOST_EDGES, Promise, promises_of
from properties.engine.explore import explore
from properties.evidence.deeds import do
from properties.evidence.hunt import MOVER, RIGHT, start_in_order
from properties.given import Exact, Given
from properties.worlds.points import scene_of_points
from properties.worlds.scenes import Shape, scene, shapes
from reference.formats.level import LevelRecord, level_record, valid_level
from reference.formats.numbers import exact, number_text
from reference.formats.scenario import RequestRecord, ScenarioRecord, StepRecord
from reference.play import stance_of
from reference.world import World
from spec.body import Level
from spec.features import PLANE_ORDER, WIDTH
from spec.profiles import WITHOUT, Profile


@dataclass(frozen=True)
class Witness:
    """Values of a shape that break a promise."""

    shape: Shape
    values: dict[str, Fraction | bool]


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
        if name != PLANE_ORDER.id or shape.platform is None:
            given.ensure(name, promise(deed, fired))


def witnesses(profile: Profile, riders: bool, names: Iterable[str]) -> dict[str, Witness]:
    """For each of some promises of a profile the values that break it on the smallest shape on which any do.

    A promise for which there are none on any small shape is left out.
    """
    promises, found = promises_of(profile), {}
    asked = {name: promises[name] for name in names}
    for shape in shapes_of(riders):
        while asked and (broken := explore(partial(judge, profile, shape, asked)).counterexample) is not None:
            found.update(dict.fromkeys(broken.broken, Witness(shape, broken.values)))
            asked = {name: one for name, one in asked.items() if name not in found}
    return found


def record_of(profile: Profile, witness: Witness, name: str) -> ScenarioRecord:
    """A witness as a scenario."""
    level, asked = scene_under(profile, Exact(witness.values), witness.shape)
    request = RequestRecord(level.bodies[MOVER].name, number_text(asked))
    return ScenarioRecord(
        format="graphbody/scenario@1",
        name=name,
        level=level_record(level, name),
        profile=profile.name,
        steps=[StepRecord(request=request)],
    )


def broken_in(scenario: ScenarioRecord) -> list[str]:
    """The IDs of what the request of a scenario breaks under its profile, in exact numbers."""
    profile = WITHOUT[scenario.profile]
    (step,) = scenario.steps
    assert isinstance(scenario.level, LevelRecord)
    assert step.request is not None
    world = World(valid_level(scenario.level, "$.level", stance=stance_of(profile)))
    asked = exact(step.request.distance, "$.steps[0].request.distance")
    deed, record = do(profile, world, MOVER, RIGHT, asked, asked * 0)
    fired = frozenset(rule for body, rule in record.fired if body == MOVER)
    return [name for name, promise in promises_of(profile).items() if not promise(deed, fired)]
