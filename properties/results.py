"""The format of results: what a run of the check showed, claim by claim."""

from __future__ import annotations

from typing import Annotated, Literal

from properties.claims.claim import Verdict
from reference.formats.files import Record, says


class Ledger(Record, frozen=True):
    """What the verdict on a claim rests on; of its proofs, if it has any."""

    used: Annotated[list[str], says("the IDs of the conditions that a proof used")]
    unused: Annotated[list[str], says("the IDs of the conditions that proofs assume, and none used")]
    unstated: Annotated[list[str], says("the IDs of its premises that no proof states: all worlds it draws are so")]
    rules: Annotated[list[str], says("the IDs of the rules that fired on the paths of the proofs")]
    paths: Annotated[int, says("how many paths are feasible")]
    promises: Annotated[int, says("how many promises were judged on them")]
    exhaustive: Annotated[bool, says("whether the paths of each proof were found to cover all values")]
    looks: Annotated[int, says("how many sequences of rules, from a clearance to the walk after it, the paths have")]
    tried: Annotated[int | None, says("how many of these the random rows went through, or null if it has none")]
    monitors: Annotated[
        dict[str, int],
        says("how often the monitors of random rows evaluated each contract that the proofs rest on, by its ID"),
    ]
    resources: Annotated[int, says("the work of the solver, as it counts it; it varies a little from run to run")]
    spread: Annotated[
        float | None, says("the most by which the work on a proof differs between seeds, as a share, or null")
    ]
    mutants: Annotated[
        int | None, says("how many mutants its evidence catches, by docs/mutants, or null if none are tried")
    ]
    by_construction: Annotated[bool, says("whether what it alone rests on catches none, and counts for nothing")]


class Evidence(Record, frozen=True):
    """What one piece of evidence showed; claims share it."""

    job: Annotated[str, says("what was run: the kind, then what it is about")]
    engine: Annotated[str, says("what showed it")]
    cases: Annotated[int, says("how many cases were gone through")]
    promises: Annotated[int, says("how many promises were judged")]
    exhaustive: Annotated[bool, says("whether the paths of a proof were found to cover all values")]
    used: Annotated[list[str], says("the premises that a proof used: of a condition its ID, of others what they say")]
    unused: Annotated[list[str], says("the premises that it did not need")]
    rules: Annotated[list[str], says("the IDs of the rules that fired")]
    premises_hold: Annotated[
        dict[str, str | bool] | None,
        says("for a proof: exact values that satisfy all premises where a promise is judged"),
    ]
    monitors: Annotated[dict[str, int], says("for random rows: how often each contract was evaluated, by its ID")]
    resources: Annotated[list[int], says("the work of the solver, as it counts it, for each seed that was run")]


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
    ledger: Annotated[Ledger, says("what the verdict rests on")]
    evidence: Annotated[list[str], says("what was run for it: the `job` of each piece of evidence")]


class Results(Record, frozen=True):
    """The results of a run: `build/results.json` and `build/results-long.json`."""

    format: Annotated[Literal["graphbody/results@1"], says("what the file is, and the version of its format")]
    sources: Annotated[str, says("the hash of the sources that it is about; for any others it is stale")]
    environment: Annotated[dict[str, str], says("what the run depended on: versions, the system, the seed")]
    claims: Annotated[list[ClaimResult], says("the claims, in the catalogue's order")]
    evidence: Annotated[list[Evidence], says("what was run, each piece once")]
