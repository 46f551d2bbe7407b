"""Four bodies about a slot: the world of the scenario `repaired-bounces` after its first step.

It is made once, by the rules as they are, and remembered whatever is changed afterwards.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

from reference.formats.level import valid_level
from reference.formats.scenario import read_scenario
from reference.play import LIBRARY
from reference.stepping import StepGame, of_step
from reference.storeys import StoreyWorld
from spec.profiles import REPAIRED
from spec.storeys import Drive


@dataclass(frozen=True)
class Start:
    """A world, who drives whom in it, and for how long."""

    world: StoreyWorld[Any]
    drives: Mapping[int, Drive[Any]]
    duration: Any


@cache
def start() -> Start:
    """The scenario after its first step, and its second step."""
    scenario, record = read_scenario(LIBRARY / "scenarios" / "repaired-bounces.json")
    level = valid_level(record, "$.level")
    game, (before, after) = StepGame(REPAIRED, level), scenario.steps
    game.step(*of_step(level, before))
    return Start(game.storeys, *of_step(level, after))
