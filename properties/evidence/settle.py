"""Settling claims: run what is to show them, side by side, and give each the verdict that the run showed."""

from __future__ import annotations

import os
import signal
import time
from collections.abc import Callable, Iterable, Mapping
from concurrent.futures import Executor, Future, ProcessPoolExecutor, as_completed
from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from multiprocessing import get_context
from pathlib import Path

from properties.claims.catalogue import CLAIMS
from properties.claims.claim import Claim, Obligation, Verdict
from properties.contracts.request import judged
from properties.evidence.ledger import conditions, ledger, proofs_of
from properties.evidence.showing import Job, Showing, looks, texts
from properties.evidence.store import Result, Store
from properties.results import Ledger
from reference.formats.files import FormatError
from reference.simulator import Endless
from spec.conditions import IN_ORDER, MARGINS_KEPT
from spec.rule import GuardError

SOLVER_SEEDS = (1, 2, 3)
VACUOUS = "vacuous: no values satisfy the premises of a path on which a promise is judged"


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
    ledger: Ledger
    jobs: tuple[Job, ...]

    @property
    def as_expected(self) -> bool:
        """Whether the verdict is the one the claim states."""
        return self.verdict is self.claim.expected


def prove(claim_id: str, obligation_id: str) -> Showing:
    """Prove one obligation of a claim, by exploring its program."""
    from properties.engine.explore import explore

    claim = by_id(claim_id)
    obligation = obligation_of(claim, obligation_id)
    started = time.perf_counter()
    outcome = explore(partial(judged, obligation.program, claim.profile))
    failures = {}
    if outcome.counterexample is not None:
        failures = dict.fromkeys(outcome.counterexample.broken, shown(outcome.counterexample.values))
    open_ = outcome.open if outcome.proved or failures or outcome.open else [VACUOUS]
    return Showing(
        "z3",
        time.perf_counter() - started,
        outcome.paths,
        failures,
        (*open_, *undeclared(obligation, outcome.used)),
        frozenset(outcome.rules),
        promises=outcome.promises,
        exhaustive=outcome.exhaustive,
        used=tuple(sorted(outcome.used)),
        unused=tuple(sorted(outcome.assumed - outcome.used)),
        witness=None if outcome.witness is None else texts(outcome.witness),
        looks=frozenset().union(*map(looks, outcome.sequences)),
        resources=(outcome.resources,),
    )


def undeclared(obligation: Obligation, used: Iterable[str]) -> list[str]:
    """What the proof of an obligation used that the obligation does not declare; kept margins are in order."""
    declared = {*obligation.needs, *((IN_ORDER.id,) if MARGINS_KEPT.id in obligation.needs else ())}
    return [f"{obligation.id} uses {name}, which it does not declare" for name in sorted(conditions(used) - declared)]


def spread(claim_id: str, obligation_id: str) -> Showing:
    """Prove one obligation of a claim with several seeds of the solver, which must agree; note what each cost."""
    from properties.engine.explore import explore

    claim = by_id(claim_id)
    program = partial(judged, obligation_of(claim, obligation_id).program, claim.profile)
    started = time.perf_counter()
    runs = [explore(program, seed) for seed in SOLVER_SEEDS]
    agree = len({(run.proved, run.paths) for run in runs}) == 1
    open_ = () if agree else (f"{obligation_id}: it depends on the seed of the solver",)
    work = tuple(run.resources for run in runs)
    return Showing("z3", time.perf_counter() - started, runs[0].paths, open=open_, resources=work)


def shown(values: Mapping[str, Fraction | bool]) -> str:
    """Values as a line of text."""
    return ", ".join(f"{name} = {value}" for name, value in values.items())


def refute(claim_id: str) -> Showing:
    """Search for a witness against a claim."""
    from properties.evidence.witness import refute as search
    from spec.profiles import OF_REQUESTS

    claim = by_id(claim_id)
    assert claim.erratum is not None
    started = time.perf_counter()
    outcome = search(OF_REQUESTS[claim.profile.name], claim.erratum)
    seconds = time.perf_counter() - started
    found = outcome.counterexample
    if found is None:
        return Showing("z3", seconds, outcome.paths, open=tuple(outcome.open))
    failures = dict.fromkeys(found.broken, shown(found.values))
    return Showing("z3", seconds, outcome.paths, failures, values=texts(found.values))


def chase(claim_id: str, seed: int) -> Showing:
    """Hunt for a witness against the promise of a claim; the seed orders shapes of the same size."""
    from properties.evidence.hunt import go
    from spec.profiles import Profile

    claim = by_id(claim_id)
    assert claim.hunt is not None
    assert isinstance(claim.profile, Profile)
    started = time.perf_counter()
    quarry = go(claim.hunt, claim.profile, seed)
    seconds = time.perf_counter() - started
    if quarry.shape is None:
        return Showing("z3", seconds, quarry.paths, open=tuple(quarry.open))
    failures = {claim.hunt.id: shown(quarry.values)}
    return Showing("z3", seconds, quarry.paths, failures, values=texts(quarry.values), shape=quarry.shape)


def sample(kind: str, profile_name: str, floats: bool) -> Showing:
    """Test every invariant on random worlds of a kind."""
    from properties.evidence.sample import ROWS, campaign
    from properties.evidence.sample_steps import STOREYS
    from spec.profiles import PROFILES

    started = time.perf_counter()
    (sampling,) = (one for one in (ROWS, STOREYS) if one.name == kind)
    result = campaign(PROFILES[profile_name], floats, sampling=sampling)
    failures = {name: str(trial) for name, trial in result.failures.items()}
    open_ = tuple(f"too few trials: {name}" for name in result.tame)
    shares = {name: (result.shares[name] / result.cases, floor) for name, floor in sampling.floors.items()}
    return Showing(
        "hypothesis",
        time.perf_counter() - started,
        result.cases,
        failures,
        open_,
        shares=shares,
        looks=frozenset(result.looks),
        evaluations=dict(sorted(result.evaluations.items())),
    )


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


def obligation_of(claim: Claim, obligation_id: str) -> Obligation:
    """The obligation of a claim with an ID."""
    return next(obligation for obligation in claim.obligations if obligation.id == obligation_id)


Jobs = dict[Job, Callable[[], Showing]]


def jobs_of(claim: Claim, seed: int = 0) -> Jobs:
    """What is to be run for a claim; the same job may serve several claims."""
    jobs: Jobs = {}
    for obligation in claim.obligations:
        jobs["prove", claim.profile.name, obligation.id] = partial(prove, claim.id, obligation.id)
    if claim.sampled is not None:
        for floats in (False, True):
            job = partial(sample, claim.sampled, claim.profile.name, floats)
            jobs["sample", claim.profile.name, str(floats)] = job
    for item in claim.counts:
        jobs["count", claim.profile.name, item.id] = partial(count, claim.id, item.id)
    if claim.erratum is not None:
        jobs["refute", claim.id] = partial(refute, claim.id)
    if claim.hunt is not None:
        jobs["hunt", claim.id, f"seed {seed}"] = partial(chase, claim.id, seed)
    return jobs


def spreads_of(claim: Claim) -> Jobs:
    """What is to be run to see how much the work of a claim's proofs depends on the seed of the solver."""
    return {("spread", *job[1:]): partial(spread, claim.id, job[2]) for job in proofs_of(claim)}


def all_jobs(claims: Iterable[Claim], seed: int = 0, spreads: bool = False) -> Jobs:
    """What is to be run for some claims, each job once."""
    jobs: Jobs = {}
    for claim in claims:
        jobs.update(jobs_of(claim, seed))
        jobs.update(spreads_of(claim) if spreads else {})
    return jobs


def run(
    jobs: Mapping[Job, Callable[[], Result]],
    executor: Executor,
    store: Store[Result],
    progress: Callable[[int, int], None],
) -> dict[Job, Result]:
    """Run all jobs but those whose current result is stored; each stores its own, so a run that stops loses no other.

    `progress` is told how many are done and how many there are.
    """
    showings = store.current(jobs)
    progress(len(showings), len(jobs))
    first = sorted(jobs.keys() - showings.keys(), key=lambda job: (job[0] != "sample", job))
    running: dict[Future[Result], Job] = {executor.submit(store.run, job, jobs[job]): job for job in first}
    for future in as_completed(running):
        showings[running[future]] = future.result()
        progress(len(showings), len(jobs))
    return {job: showings[job] for job in jobs}


def processes() -> ProcessPoolExecutor:
    """A pool with a process for each core; an interrupt ends them without a word."""
    context, to_default = get_context("forkserver"), (signal.SIGINT, signal.SIG_DFL)
    return ProcessPoolExecutor(os.cpu_count(), context, initializer=signal.signal, initargs=to_default)


def settle(claim: Claim, showings: dict[Job, Showing], witnesses: Path, seed: int = 0) -> Settled:
    """Give a claim the verdict that its evidence showed."""
    jobs = tuple(jobs_of(claim, seed))
    mine = [showings[job] for job in (*jobs, *(job for job in spreads_of(claim) if job in showings))]
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
        cases=sum(showings[job].cases for job in jobs),
        engine=", ".join(sorted({showing.engine for showing in mine})),
        seconds=sum(showing.seconds for showing in mine),
        witness=witness,
        reasons=reasons,
        ledger=ledger(claim, showings),
        jobs=jobs,
    )


def bodies_shown(claim: Claim) -> int | None:
    """Up to how many bodies a bounded claim is shown: the most on each kind of string, and of these the fewest."""
    most: dict[str, int] = {} if claim.hunt is None else {"scene": claim.hunt.most_bodies}
    for obligation in claim.obligations:
        if obligation.shape is not None and obligation.bodies is not None:
            most[obligation.shape] = max(obligation.bodies, most.get(obligation.shape, 0))
    if goes_through_all(claim):
        most["all"] = min(item.bodies for item in claim.counts if item.bodies is not None)
    return min(most.values(), default=None)


def goes_through_all(claim: Claim) -> bool:
    """Whether all that shows a claim are counts that go through all worlds up to a number of bodies."""
    return claim.sampled is None and bool(claim.counts) and all(item.bodies is not None for item in claim.counts)


def unlisted(claim: Claim) -> tuple[str, ...]:
    """What the proofs of a claim assume that the claim does not list; kept margins are in order."""
    listed = {*claim.premises, *((IN_ORDER.id,) if MARGINS_KEPT.id in claim.premises else ())}
    needed = {condition for obligation in claim.obligations for condition in obligation.needs}
    return tuple(f"its proof assumes {condition}, which it does not list" for condition in sorted(needed - listed))


def concerns(claim: Claim, failure: str) -> bool:
    """Whether what failed on a random row is about a claim: its property, a contract of its proofs, or the rules."""
    return failure.partition(": ")[0] in (claim.about, "rules/one-applies", *claim.contracts)


def verdict_of(claim: Claim, showings: list[Showing]) -> tuple[Verdict, tuple[str, ...]]:
    """The verdict of a claim, and the reasons for it if it is none of the good ones."""
    failures = [
        f"{name}: {shows}"
        for showing in showings
        for name, shows in showing.failures.items()
        if showing.engine != "hypothesis" or concerns(claim, name)
    ]
    if failures:
        return Verdict.REFUTED, tuple(failures)
    unknown = (*unlisted(claim), *(reason for showing in showings for reason in showing.open))
    if unknown or (claim.erratum is not None):
        return Verdict.UNKNOWN, unknown or ("no witness was found",)
    if not claim.obligations and claim.hunt is None:
        return (Verdict.BOUNDED if goes_through_all(claim) else Verdict.TESTED), ()
    bounded = claim.hunt is not None or any(obligation.shape is not None for obligation in claim.obligations)
    return (Verdict.BOUNDED if bounded else Verdict.PROVED), ()


def first_failure() -> str | None:
    """Run the evidence of all claims, one after another, up to the first failure; what failed, or None."""
    jobs: Jobs = {}
    for claim in CLAIMS:
        if claim.erratum is None and claim.hunt is None:
            jobs.update(jobs_of(claim))
    order = {"count": 0, "prove": 1, "sample": 2}
    for job in sorted(jobs, key=lambda job: order[job[0]]):
        for failure in jobs[job]().failures:
            return f"{job[2]}: {failure}" if job[0] == "prove" else f"{job[0]}: {failure}"
    return None
