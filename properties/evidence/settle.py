"""Settling claims: run what is to show them, side by side, and give each the verdict that the run showed."""

from __future__ import annotations

import os
import signal
import time
from collections.abc import Callable, Iterable
from concurrent.futures import Executor, Future, ProcessPoolExecutor, as_completed
from dataclasses import dataclass, field
from fractions import Fraction
from functools import partial
from multiprocessing import get_context
from pathlib import Path

from properties.claims.catalogue import CLAIMS
from properties.claims.claim import Claim, Verdict
from properties.contracts.request import judged
from properties.worlds.scenes import Shape
from reference.formats.files import FormatError
from reference.simulator import Endless
from spec.conditions import IN_ORDER, MARGINS_KEPT
from spec.rule import GuardError


@dataclass(frozen=True)
class Showing:
    """What one piece of evidence showed.

    Attributes:
        failures: what failed, each with what shows it; empty if everything held.
        open: what could not be decided.
        cases: paths of a proof, examples of a test, worlds of a count.
        shares: of random trials, the share that has a feature of interest, and its floor.
    """

    engine: str
    seconds: float
    cases: int
    failures: dict[str, str] = field(default_factory=dict)
    open: tuple[str, ...] = ()
    rules: frozenset[str] = frozenset()
    values: dict[str, Fraction | bool] | None = None
    shares: dict[str, tuple[float, float]] = field(default_factory=dict)
    shape: Shape | None = None


@dataclass(frozen=True)
class Settled:
    """A claim and its verdict."""

    claim: Claim
    verdict: Verdict
    bodies: int | None
    cases: int
    engine: str
    seconds: float
    witness: Path | None
    reasons: tuple[str, ...]

    @property
    def as_expected(self) -> bool:
        """Whether the verdict is the one the claim states."""
        return self.verdict is self.claim.expected


def prove(claim_id: str, obligation_id: str) -> Showing:
    """Prove one obligation of a claim, by exploring its program."""
    from properties.engine.explore import explore

    claim = by_id(claim_id)
    obligation = next(o for o in claim.obligations if o.id == obligation_id)
    started = time.perf_counter()
    outcome = explore(partial(judged, obligation.program, claim.profile))
    failures = {}
    if outcome.counterexample is not None:
        failures = dict.fromkeys(outcome.counterexample.broken, shown(outcome.counterexample.values))
    open_ = outcome.open if outcome.proved or failures or outcome.open else ["no path is feasible"]
    seconds = time.perf_counter() - started
    return Showing("z3", seconds, outcome.paths, failures, tuple(open_), frozenset(outcome.rules))


def shown(values: dict[str, Fraction | bool]) -> str:
    """Values as a line of text."""
    return ", ".join(f"{name} = {value}" for name, value in values.items())


def refute(claim_id: str) -> Showing:
    """Search for a witness against a claim."""
    from properties.evidence.witness import refute as search

    claim = by_id(claim_id)
    assert claim.erratum is not None
    started = time.perf_counter()
    outcome = search(claim.profile, claim.erratum)
    seconds = time.perf_counter() - started
    found = outcome.counterexample
    if found is None:
        return Showing("z3", seconds, outcome.paths, open=tuple(outcome.open))
    failures = dict.fromkeys(found.broken, shown(found.values))
    return Showing("z3", seconds, outcome.paths, failures, values=found.values)


def chase(claim_id: str, seed: int) -> Showing:
    """Hunt for a witness against the promise of a claim; the seed orders shapes of the same size."""
    from properties.evidence.hunt import go

    claim = by_id(claim_id)
    assert claim.hunt is not None
    started = time.perf_counter()
    quarry = go(claim.hunt, claim.profile, seed)
    seconds = time.perf_counter() - started
    if quarry.shape is None:
        return Showing("z3", seconds, quarry.paths, open=tuple(quarry.open))
    failures = {claim.hunt.id: shown(quarry.values)}
    return Showing("z3", seconds, quarry.paths, failures, values=quarry.values, shape=quarry.shape)


def sample(profile_name: str, floats: bool) -> Showing:
    """Test every invariant on random rows."""
    from properties.evidence.sample import FLOORS, campaign
    from spec.profiles import PROFILES

    started = time.perf_counter()
    result = campaign(PROFILES[profile_name], floats)
    failures = {name: str(trial) for name, trial in result.failures.items()}
    open_ = tuple(f"too few trials: {name}" for name in result.tame)
    shares = {name: (result.shares[name] / result.cases, floor) for name, floor in FLOORS.items()}
    return Showing("hypothesis", time.perf_counter() - started, result.cases, failures, open_, shares=shares)


def count(claim_id: str, count_id: str) -> Showing:
    """Count work."""
    claim = by_id(claim_id)
    program = next(c.program for c in claim.counts if c.id == count_id)
    started = time.perf_counter()
    try:
        cases, failures = program(claim.profile), {}
    except (AssertionError, GuardError, Endless, FormatError) as error:
        cases, failures = 0, {claim.about: str(error)}
    return Showing("counting", time.perf_counter() - started, cases, failures)


def by_id(claim_id: str) -> Claim:
    """The claim with an ID."""
    return next(claim for claim in CLAIMS if claim.id == claim_id)


Job = tuple[str, ...]


def jobs_of(claim: Claim, seed: int = 0) -> dict[Job, Callable[[], Showing]]:
    """What is to be run for a claim; the same job may serve several claims."""
    jobs: dict[Job, Callable[[], Showing]] = {}
    for obligation in claim.obligations:
        jobs["prove", claim.profile.name, obligation.id] = partial(prove, claim.id, obligation.id)
    if claim.sampled:
        for floats in (False, True):
            jobs["sample", claim.profile.name, str(floats)] = partial(sample, claim.profile.name, floats)
    for item in claim.counts:
        jobs["count", claim.profile.name, item.id] = partial(count, claim.id, item.id)
    if claim.erratum is not None:
        jobs["refute", claim.id] = partial(refute, claim.id)
    if claim.hunt is not None:
        jobs["hunt", claim.id] = partial(chase, claim.id, seed)
    return jobs


def run(
    claims: Iterable[Claim],
    executor: Executor,
    progress: Callable[[int, int], None],
    seed: int = 0,
    export: Path | None = None,
) -> dict[Job, Showing]:
    """Run all jobs of some claims, each once; `progress` is told how many are done and how many there are.

    With `export`, the jobs that explore write what they explored to that directory.
    """
    jobs: dict[Job, Callable[[], Showing]] = {}
    for claim in claims:
        jobs.update(jobs_of(claim, seed))
    if export is not None:
        from properties.evidence.export import exported

        jobs = exported(export, jobs)
    first = sorted(jobs, key=lambda job: job[0] != "sample")
    running: dict[Future[Showing], Job] = {executor.submit(jobs[job]): job for job in first}
    showings: dict[Job, Showing] = {}
    for done, future in enumerate(as_completed(running), start=1):
        showings[running[future]] = future.result()
        progress(done, len(running))
    return showings


def processes() -> ProcessPoolExecutor:
    """A pool with a process for each core; an interrupt ends them without a word."""
    context, to_default = get_context("forkserver"), (signal.SIGINT, signal.SIG_DFL)
    return ProcessPoolExecutor(os.cpu_count(), context, initializer=signal.signal, initargs=to_default)


def settle(claim: Claim, showings: dict[Job, Showing], witnesses: Path) -> Settled:
    """Give a claim the verdict that its evidence showed."""
    mine = [showings[job] for job in jobs_of(claim)]
    verdict, reasons = verdict_of(claim, mine)
    witness = None
    for showing in mine:
        if showing.values is not None:
            from properties.evidence.witness import write_witness

            witness = write_witness(claim, showing.values, showing.shape, witnesses)
    return Settled(
        claim,
        verdict,
        bodies=bodies_shown(claim) if verdict is Verdict.BOUNDED else None,
        cases=sum(showing.cases for showing in mine),
        engine=", ".join(sorted({showing.engine for showing in mine})),
        seconds=sum(showing.seconds for showing in mine),
        witness=witness,
        reasons=reasons,
    )


def bodies_shown(claim: Claim) -> int | None:
    """Up to how many bodies a bounded claim is shown: the most on each kind of string, and of these the fewest."""
    most: dict[str, int] = {} if claim.hunt is None else {"scene": claim.hunt.most_bodies}
    for obligation in claim.obligations:
        if obligation.shape is not None and obligation.bodies is not None:
            most[obligation.shape] = max(obligation.bodies, most.get(obligation.shape, 0))
    return min(most.values(), default=None)


def unlisted(claim: Claim) -> tuple[str, ...]:
    """What the proofs of a claim assume that the claim does not list; kept margins are in order."""
    listed = {*claim.premises, *((IN_ORDER.id,) if MARGINS_KEPT.id in claim.premises else ())}
    needed = {condition for obligation in claim.obligations for condition in obligation.needs}
    return tuple(f"its proof assumes {condition}, which it does not list" for condition in sorted(needed - listed))


def verdict_of(claim: Claim, showings: list[Showing]) -> tuple[Verdict, tuple[str, ...]]:
    """The verdict of a claim, and the reasons for it if it is none of the good ones."""
    failures = [
        f"{name}: {shows}"
        for showing in showings
        for name, shows in showing.failures.items()
        if showing.engine != "hypothesis" or name in (claim.about, "rules/one-applies")
    ]
    if failures:
        return Verdict.REFUTED, tuple(failures)
    unknown = (*unlisted(claim), *(reason for showing in showings for reason in showing.open))
    if unknown or (claim.erratum is not None):
        return Verdict.UNKNOWN, unknown or ("no witness was found",)
    if not claim.obligations and claim.hunt is None:
        return Verdict.TESTED, ()
    bounded = claim.hunt is not None or any(obligation.shape is not None for obligation in claim.obligations)
    return (Verdict.BOUNDED if bounded else Verdict.PROVED), ()


def first_failure() -> str | None:
    """Run the evidence of all claims, one after another, up to the first failure; what failed, or None."""
    jobs: dict[Job, Callable[[], Showing]] = {}
    for claim in CLAIMS:
        if claim.erratum is None and claim.hunt is None:
            jobs.update(jobs_of(claim))
    order = {"count": 0, "prove": 1, "sample": 2}
    for job in sorted(jobs, key=lambda job: order[job[0]]):
        for failure in jobs[job]().failures:
            return f"{job[2]}: {failure}" if job[0] == "prove" else f"{job[0]}: {failure}"
    return None
