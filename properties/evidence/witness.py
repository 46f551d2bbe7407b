"""Witnesses: counterexamples of refuted claims as scenarios, in exact numbers, that the simulator replays."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from pathlib import Path
from typing import Any

from properties.claims.claim import Claim, Erratum
from properties.contracts.errata import Stage
from properties.engine.explore import Outcome, explore
from properties.evidence.files import file_name
from properties.evidence.hunt import scene_of
from properties.given import Exact, Given
from properties.worlds.scenes import Shape
from reference.formats.files import write
from reference.formats.level import level_record
from reference.formats.numbers import number_text
from reference.formats.scenario import RequestRecord, ScenarioRecord, StepRecord, TickRecord
from reference.world import World
from spec.body import Level
from spec.guidelines import kept_by
from spec.profiles import Profile


def refute(profile: Profile, erratum: Erratum) -> Outcome:
    """Search for values that break a promise, in all worlds of its shape."""

    def program(given: Given) -> None:
        erratum(profile, given, Stage())

    return explore(program)


def scenario(claim: Claim, values: Mapping[str, Fraction | bool | str], shape: Shape | None) -> ScenarioRecord:
    """The scenario in which values break the promise of a claim; `shape` is that of a hunted scene."""
    stage = Stage()
    if claim.erratum is not None:
        claim.erratum(claim.profile, Exact(values), stage)
    elif claim.hunt is not None and shape is not None:
        stage.level, asked = scene_of(claim.hunt, Exact(values), shape)
        stage.steps.append((stage.level.bodies[0].name, asked))
    assert stage.level is not None
    name = file_name(claim.id)
    return ScenarioRecord(
        format="graphbody/scenario@1",
        name=name,
        note=f"A witness against: {claim.sentence} {guidelines_of(stage.level)}",
        level=level_record(stage.level, name),
        profile=claim.profile.name,
        steps=[step_record(step) for step in stage.steps],
    )


def guidelines_of(level: Level[Fraction]) -> str:
    """Which guidelines a level keeps, in a sentence."""
    kept = [name.removeprefix("guideline/") for name in kept_by(World(level))]
    return f"The level keeps the guidelines {', '.join(kept)}." if kept else "The level keeps no guideline."


def step_record(step: tuple[str, Any] | None) -> StepRecord:
    """A step of a stage as it stands in a file."""
    if step is None:
        return StepRecord(tick=TickRecord(key="right"))
    return StepRecord(request=RequestRecord(step[0], number_text(step[1])))


def write_witness(
    claim: Claim, values: Mapping[str, Fraction | bool | str], shape: Shape | None, directory: Path
) -> Path:
    """Write the witness of a claim; return its path."""
    path = directory / f"{file_name(claim.id)}.json"
    write(path, scenario(claim, values, shape))
    return path
