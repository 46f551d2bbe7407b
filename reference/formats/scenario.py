"""Scenario files: a level and what is asked of its bodies, step by step."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

from msgspec import Meta

from reference.formats.files import MOST_ITEMS, FormatError, Many, Name, Record, read
from reference.formats.level import LevelRecord
from reference.formats.numbers import Number

Times = Annotated[int, Meta(ge=1, le=MOST_ITEMS)]


class RequestRecord(Record, frozen=True):
    """A request: a body is to move by a distance, negative to the left."""

    body: Name
    distance: Number


class TickRecord(Record, frozen=True):
    """Ticks with one key held: in each, every character is asked to move by its speed times the tick."""

    key: Literal["left", "right"]
    times: Times = 1


class StepRecord(Record, frozen=True):
    """One step of a scenario: either a request or ticks."""

    request: RequestRecord | None = None
    tick: TickRecord | None = None


class ScenarioRecord(Record, frozen=True):
    """A scenario: a level, in the file or beside it, a profile and steps; `solved`: whether they reach its goal."""

    format: Literal["graphbody/scenario@1"]
    name: Name
    level: str | LevelRecord
    steps: Many[StepRecord]
    profile: str = "thesis"
    solved: bool | None = None
    note: str = ""


def check_step(asked: StepRecord, where: str) -> None:
    """Refuse a step that is not either a request or ticks; `where` names the file and the place.

    Raises:
        FormatError: if it is both or neither.
    """
    if (asked.request is None) == (asked.tick is None):
        raise FormatError(f"{where}: expected either `request` or `tick`")


def read_scenario(path: Path) -> tuple[ScenarioRecord, LevelRecord]:
    """A scenario and its level, which is in the file or in one beside it.

    Raises:
        FormatError: if either cannot be read.
    """
    scenario = read(path, ScenarioRecord)
    for i, step in enumerate(scenario.steps):
        check_step(step, f"{path}: $.steps[{i}]")
    if isinstance(scenario.level, LevelRecord):
        return scenario, scenario.level
    return scenario, read(path.parent / scenario.level, LevelRecord)
