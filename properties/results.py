"""The format of results: what a run of the check showed, claim by claim."""

from __future__ import annotations

from typing import Annotated, Literal

from properties.claims.claim import Verdict
from reference.formats.files import Record, says


class ClaimResult(Record, frozen=True):
    """What was shown of one claim; docs and `graphbody explain ID` say what it claims."""

    id: Annotated[str, says("the claim's ID")]
    family: Annotated[str, says("what the claim belongs to, in one word")]
    profile: Annotated[str, says("the profile under whose rules it is claimed")]
    premises: Annotated[list[str], says("the IDs of the conditions that it assumes")]
    expected: Annotated[Verdict, says("the verdict that the claim states")]
    verdict: Annotated[Verdict, says("the verdict that the run gave")]
    bodies: Annotated[int | None, says("up to how many bodies, if it is bounded, else null")]
    cases: Annotated[int, says("how many cases were gone through")]
    engine: Annotated[str, says("what showed it")]
    seconds: Annotated[float, says("how long it took, in seconds, shared evidence counted each time")]
    witness: Annotated[str | None, says("the scenario that refutes it, from the folder of the run on, or null")]


class Results(Record, frozen=True):
    """The results of a run: `build/results.json` and `build/results-long.json`."""

    format: Annotated[Literal["graphbody/results@1"], says("what the file is, and the version of its format")]
    environment: Annotated[dict[str, str], says("what the run depended on: versions, the system, the seed")]
    claims: Annotated[list[ClaimResult], says("the claims, in the catalogue's order")]
