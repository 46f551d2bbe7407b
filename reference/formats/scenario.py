"""Scenario files: a level and what is asked of its bodies, step by step."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

from msgspec import Meta

from reference.formats.files import MOST_ITEMS, FormatError, Many, Name, Record, read, says
from reference.formats.level import BodyRecord, LevelRecord
from reference.formats.numbers import Number
from spec.graph import Direction
from spec.profiles import PROFILES

Times = Annotated[int, Meta(ge=1, le=MOST_ITEMS)]
ProfileName = Annotated[str, Meta(extra_json_schema={"enum": list(PROFILES)})]
FileName = Annotated[str, Meta(min_length=1, max_length=255)]


class RequestRecord(Record, frozen=True):
    """A request: a body is to move by a distance."""

    body: Annotated[Name, says("who is to move")]
    distance: Annotated[Number, says("how far, along the graph, in units of length; negative to the left")]


class TickRecord(Record, frozen=True):
    """Ticks with one key held, or none: in each, every character in turn is asked to move by its speed times the tick.

    So is each body with a velocity of its own, by that.
    """

    key: Annotated[Literal["left", "right", "none"], says("the key that is held")]
    times: Annotated[Times, says("for how many ticks; 1 in a trace, where each tick is a step of its own")] = 1

    @property
    def direction(self) -> Direction | None:
        """The direction of the key."""
        return None if self.key == "none" else Direction[self.key.upper()]


class DriveRecord(Record, frozen=True):
    """Bodies are driven for a time, all at once; only under `repaired`."""

    speeds: Annotated[
        dict[Name, Number],
        says(
            "who is driven how fast, in units of length per second, negative to the left: characters in the plane, "
            "boxes relative to what they stand on"
        ),
    ]
    time: Annotated[Number, says("for how long, in seconds, at least 0")]


class RemoveRecord(Record, frozen=True):
    """A body is taken out of the level; only under `repaired`. Those that stood on it settle at once."""

    body: Annotated[Name, says("whom")]


Asked = RequestRecord | TickRecord | DriveRecord | BodyRecord | RemoveRecord


class StepRecord(Record, frozen=True):
    """One step of a scenario. One of `request`, `tick`, `drive`, `add` and `remove` is given."""

    request: Annotated[RequestRecord | None, says("a body is to move by a distance")] = None
    tick: Annotated[TickRecord | None, says("a key is held")] = None
    drive: Annotated[DriveRecord | None, says("bodies are driven for a time; only under `repaired`")] = None
    add: Annotated[
        BodyRecord | None,
        says("a body is put into the level, where it is clear of all else, and settles; only under `repaired`"),
    ] = None
    remove: Annotated[RemoveRecord | None, says("a body is taken out of the level; only under `repaired`")] = None

    @property
    def comings(self) -> tuple[str | None, str | None]:
        """The name of the body that comes, and of the one that goes."""
        return None if self.add is None else self.add.name, None if self.remove is None else self.remove.body

    @property
    def asked(self) -> list[Asked]:
        """What is given: one thing, in a step as it must be."""
        return [one for one in (self.request, self.tick, self.drive, self.add, self.remove) if one is not None]


class ScenarioRecord(Record, frozen=True):
    """A scenario: a level and what is asked of its bodies, step by step."""

    format: Annotated[Literal["graphbody/scenario@1"], says("what the file is, and the version of its format")]
    name: Annotated[Name, says("the name of the scenario")]
    level: Annotated[FileName | LevelRecord, says("the level, or the name of a level file, from this file's folder on")]
    steps: Annotated[Many[StepRecord], says("what is asked, in turn; at most 100000 requests, ticks and drives")]
    profile: Annotated[ProfileName, says("the profile whose rules hold")] = "thesis"
    solved: Annotated[bool | None, says("whether the steps reach the level's goal; if left out, nothing is said")] = (
        None
    )
    note: Annotated[str, says("what the scenario is there for; nothing depends on it")] = ""


def check_step(asked: StepRecord, where: str) -> None:
    """Refuse a step that is not one thing that can be asked; `where` names the file and the place.

    Raises:
        FormatError: if it is several or none.
    """
    if len(asked.asked) != 1:
        raise FormatError(f"{where}: expected one of `request`, `tick`, `drive`, `add` and `remove`")


def read_scenario(path: Path) -> tuple[ScenarioRecord, LevelRecord]:
    """A scenario and its level, which is in the file or in one beside it.

    Raises:
        FormatError: if either cannot be read.
    """
    scenario = read(path, ScenarioRecord)
    asked = 0
    for i, step in enumerate(scenario.steps):
        check_step(step, f"{path}: $.steps[{i}]")
        asked += 1 if step.tick is None else step.tick.times
        if asked > MOST_ITEMS:
            raise FormatError(f"{path}: $.steps[{i}]: expected at most {MOST_ITEMS} requests, ticks and drives in all")
    if isinstance(scenario.level, LevelRecord):
        return scenario, scenario.level
    return scenario, read(path.parent / scenario.level, LevelRecord)
