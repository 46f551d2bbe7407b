"""Playing scenarios: from a file, step by step, in exact numbers or in floats."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Any, Generic

from reference.formats import (
    FormatError,
    LevelRecord,
    ScenarioRecord,
    StepRecord,
    exact,
    in_floats,
    level_of,
    read_scenario,
)
from reference.simulator import Event, Game
from reference.world import LevelError, world_of
from spec.body import Body
from spec.graph import Direction
from spec.number import N
from spec.profiles import PROFILES

LIBRARY = Path(__file__).parent
LARGEST_FLOAT = Fraction(sys.float_info.max)


@dataclass(frozen=True)
class Played(Generic[N]):
    """One step of a scenario: its record, the requests it consisted of, and all bodies after it."""

    step: StepRecord
    events: list[Event[N]]
    bodies: tuple[Body[N], ...]


def library() -> list[Path]:
    """The scenarios that come with the project, by name."""
    return sorted((LIBRARY / "scenarios").glob("*.json"))


def set_up(scenario: ScenarioRecord, level: LevelRecord, floats: bool) -> Game[Any]:
    """The game of a scenario at its start.

    Raises:
        LevelError: if the level, the profile or a step's body is not as it must be.
    """
    if scenario.profile not in PROFILES:
        raise LevelError("$.profile", f"expected one of {', '.join(PROFILES)}, got {scenario.profile!r}")
    held = level_of(level)
    world_of(held)
    names = {body.name for body in held.bodies}
    for i, step in enumerate(scenario.steps):
        if step.request is not None:
            check_distance(exact(step.request.distance, f"$.steps[{i}].request.distance"), i, floats)
            if step.request.body not in names:
                raise LevelError(f"$.steps[{i}].request.body", f"no body is named {step.request.body!r}")
    try:
        return Game(PROFILES[scenario.profile], in_floats(held) if floats else held)
    except OverflowError:
        raise LevelError("$.level", "expected numbers that fit into a float") from None


def check_distance(distance: Fraction, step: int, floats: bool) -> None:
    """Refuse a distance that is too large to be computed with."""
    if floats and abs(distance) > LARGEST_FLOAT:
        raise LevelError(f"$.steps[{step}].request.distance", "expected a number that fits into a float")


def steps(game: Game[Any], scenario: ScenarioRecord, floats: bool) -> Iterator[Played[Any]]:
    """Play the steps one after another."""
    for step in scenario.steps:
        events: list[Event[Any]] = []
        if step.request is not None:
            distance = exact(step.request.distance, "$")
            events.append(game.request(step.request.body, float(distance) if floats else distance))
        if step.tick is not None:
            for _ in range(step.tick.times):
                events.extend(game.tick(Direction[step.tick.key.upper()]))
        yield Played(step, events, tuple(game.world.bodies))


def play(path: Path, floats: bool = False) -> tuple[ScenarioRecord, Game[Any], Iterator[Played[Any]]]:
    """A scenario file, its game, and its steps as they are played.

    Raises:
        FormatError: one line that names the file and the place, if anything in it is not as it must be.
    """
    scenario, level = read_scenario(path)
    try:
        game = set_up(scenario, level, floats)
    except LevelError as error:
        raise FormatError(f"{path}: {error}") from None
    return scenario, game, steps(game, scenario, floats)
