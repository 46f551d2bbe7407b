"""Scenes as documents, and what readings make of them as plain data; and both played again."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from typing import Any

import msgspec

from properties.alternatives.compare import FAILS, broken_by, outcome
from properties.alternatives.scenes import Scene, Step, scene_in
from properties.evidence.witness import guidelines_of
from reference.formats.level import level_of, level_record
from reference.formats.numbers import exact
from reference.formats.scenario import RequestRecord, ScenarioRecord, StepRecord, TickRecord
from reference.world import LevelError
from spec.body import EdgePosition
from spec.graph import Direction
from spec.transform import with_numbers


def document(scene: Scene, name: str) -> ScenarioRecord:
    """A scene as a scenario under the thesis."""
    level = with_numbers(scene.level, Fraction, Fraction)
    try:
        note = f"A small scene on which readings are told apart. {guidelines_of(level)}"
    except LevelError:
        note = "A small scene that the thesis refuses."
    steps = [step_record(step) for step in scene.steps]
    return ScenarioRecord("graphbody/scenario@1", name, level=level_record(level, name), steps=steps, note=note)


def step_record(step: Step) -> StepRecord:
    """A step as it stands in a file."""
    if isinstance(step, Direction):
        return StepRecord(tick=TickRecord("right" if step is Direction.RIGHT else "left"))
    return StepRecord(request=RequestRecord(step[0], str(step[1])))


def scene_of(scenario: Mapping[str, Any]) -> Scene:
    """The scene of a document, in fractions."""
    record = msgspec.convert(scenario, ScenarioRecord)
    assert not isinstance(record.level, str)
    level = level_of(record.level)
    steps = tuple(step_of(step) for step in record.steps)
    try:
        return scene_in(level, steps)
    except LevelError:
        return Scene(level, steps, guided=False, plain=False)


def step_of(step: StepRecord) -> Any:
    """A step of a document."""
    if step.request is not None:
        return step.request.body, exact(step.request.distance, "$")
    assert step.tick is not None
    return Direction[step.tick.key.upper()]


def answer(scene: Scene, reading: str | None) -> dict[str, Any]:
    """Where all bodies end under a reading: borders, support and place in the plane; or why there is no answer."""
    ended, played = outcome(scene, reading)
    if played is None:
        return {str(ended[0]): str(ended[1])}
    world = played.game.world
    names = [body.name for body in world.bodies]

    def text(at: EdgePosition[Any]) -> str:
        edge = str(at.edge) if at.edge < world.statics else f"top of {names[at.edge - world.statics]}"
        return f"{edge}:{Fraction(at.location)}"

    found: dict[str, Any] = {}
    for body, held, (left, right) in zip(world.handles(), world.bodies, (one[0] for one in ended[:-1]), strict=True):
        support = world.support(body)
        found[held.name] = {
            "from": text(held.left),
            "to": text(held.right),
            "plane": [[str(Fraction(number)) for number in point] for point in (left, right)],
            "on": "ground" if support is None else names[support],
        }
    return {"bodies": found, "pressed": list(ended[-1])}


def replayed(reading: str | None, found: Mapping[str, Any], shown: Mapping[str, Any]) -> Iterator[str]:
    """What of a finding does not come again when its scenes are played; `shown` has them by their numbers."""
    name, differs = reading or "thesis", found["differs"]
    if differs is not None:
        scene = scene_of(shown[str(differs["scene"])]["scenario"])
        if (answer(scene, None), answer(scene, reading)) != (differs["thesis"], differs["other"]):
            yield f"{name}: scene {differs['scene']} ends otherwise than was found"
        if differs["thesis"] == differs["other"]:
            yield f"{name}: scene {differs['scene']} ends alike under both readings"
    for invariant, number in found["broken"].items():
        if invariant not in broken_in(scene_of(shown[str(number)]["scenario"]), reading):
            yield f"{name}: scene {number} keeps {invariant}, which was found broken"


def broken_in(scene: Scene, reading: str | None) -> set[str]:
    """What a reading breaks in a scene."""
    ended, played = outcome(scene, reading)
    return {FAILS} if ended[0] == FAILS else set(broken_by(scene, played))
