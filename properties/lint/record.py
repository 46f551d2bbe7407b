"""The format of a lint: what was found in one level."""

from __future__ import annotations

from typing import Annotated, Literal

from reference.formats.files import Record, says
from reference.formats.scenario import ScenarioRecord


class WrongRecord(Record, frozen=True):
    """Requests of this level after which something is broken that held before."""

    broken: Annotated[list[str], says("the IDs of the invariants that are broken and of the unsupported cases")]
    scenario: Annotated[ScenarioRecord, says("the level with these requests")]
    replay: Annotated[str, says("the command that plays them")]


class FindingRecord(Record, frozen=True, kw_only=True):
    """A place of the level where a guideline, a condition or a model is not kept."""

    place: Annotated[str, says("the place in the file")]
    what: Annotated[str, says("what is at that place, in words")]
    statement: Annotated[str, says("the ID of what is not kept")]
    sentence: Annotated[str, says("what that says")]
    seen: Annotated[str, says("what is there instead, with its numbers")]
    mend: Annotated[str, says("what would mend it")]
    wrong: Annotated[WrongRecord | None, says("requests that go wrong at that place, if any were found")] = None


class LintRecord(Record, frozen=True, kw_only=True):
    """What was found in a level: nothing, if there are no findings and nothing goes wrong."""

    format: Annotated[Literal["graphbody/lint@1"], says("what the document is, and the version of its format")]
    file: Annotated[str, says("the file of the level or the scenario")]
    profile: Annotated[str, says("the profile whose rules hold")]
    findings: Annotated[list[FindingRecord], says("where something is not kept")]
    wrong: Annotated[list[WrongRecord], says("requests by which something else goes wrong than at the findings")]
    requests: Annotated[int, says("how many requests were tried")]
    all_tried: Annotated[bool, says("whether all requests that were to be tried were; else the budget was spent")]
    storeys: Annotated[
        str | None,
        says("the place, and what is in the way there, if the level is none of storeys, for `repaired`"),
    ] = None
