"""The ledger of a claim: what its proofs rest on, how much of them the tests reach, what the solver spent."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache

from properties.claims.claim import Claim
from properties.evidence.mutants.record import Record, by_construction, number_caught, read_record
from properties.evidence.showing import Job, Look, Showing
from properties.results import Evidence, Ledger
from spec.conditions import CONDITIONS

MOST_SPREAD = 0.2


def proofs_of(claim: Claim) -> list[Job]:
    """The jobs that prove the obligations of a claim."""
    return [("prove", claim.profile.name, obligation.id) for obligation in claim.obligations]


def spread_of(job: Job, showings: dict[Job, Showing]) -> Showing | None:
    """What the runs of a proof with other seeds showed, if there were any."""
    return showings.get(("spread", *job[1:]))


def feasible_looks(claim: Claim, showings: dict[Job, Showing]) -> frozenset[Look]:
    """The looks on the feasible paths of the proofs of a claim."""
    return frozenset().union(*(showings[job].looks for job in proofs_of(claim)))


def tried_looks(claim: Claim, showings: dict[Job, Showing]) -> frozenset[Look]:
    """The looks that random rows took, under the profile of a claim."""
    tried = [one.looks for job, one in showings.items() if job[:2] == ("sample", claim.profile.name)]
    return frozenset().union(*tried)


def evaluations(claim: Claim, showings: dict[Job, Showing]) -> dict[str, int]:
    """How often the monitors of random rows evaluated each contract on which the proofs of a claim rest."""
    rows = [one for job, one in showings.items() if job[:2] == ("sample", claim.profile.name)]
    return {contract: sum(one.evaluations.get(contract, 0) for one in rows) for contract in claim.contracts}


def conditions(names: Iterable[str]) -> set[str]:
    """Those of the premises that are conditions of a claim; the others are laws of the world."""
    return {condition.id for condition in CONDITIONS} & set(names)


@cache
def mutants_recorded() -> Record:
    """What the mutants have shown, as it is written down."""
    return read_record()


def ledger(claim: Claim, showings: dict[Job, Showing]) -> Ledger:
    """The ledger of a claim, from what its evidence showed."""
    proofs = [showings[job] for job in proofs_of(claim)]
    used = conditions(name for one in proofs for name in one.used)
    stated = conditions(name for one in proofs for name in (*one.used, *one.unused))
    feasible = feasible_looks(claim, showings)
    again = [one for job in proofs_of(claim) if (one := spread_of(job, showings)) is not None]
    return Ledger(
        used=sorted(used),
        unused=sorted(stated - used),
        unstated=[name for name in claim.premises if name not in stated] if proofs else list(claim.premises),
        rules=sorted(frozenset().union(*(one.rules for one in proofs))),
        paths=sum(one.cases for one in proofs),
        promises=sum(one.promises for one in proofs),
        exhaustive=bool(proofs) and all(one.exhaustive for one in proofs),
        looks=len(feasible),
        tried=len(feasible & tried_looks(claim, showings)) if claim.sampled else None,
        monitors=evaluations(claim, showings) if claim.sampled else {},
        resources=sum(one.resources[0] for one in proofs if one.resources),
        spread=max((round(one.spread or 0, 3) for one in again), default=None),
        mutants=number_caught(mutants_recorded(), claim.id),
        by_construction=claim.id.removeprefix("claim/") in by_construction(mutants_recorded()),
    )


def evidence(job: Job, showings: dict[Job, Showing]) -> Evidence:
    """A piece of evidence as it stands in results.json."""
    showing, again = showings[job], spread_of(job, showings) if job[0] == "prove" else None
    return Evidence(
        job=" ".join(job),
        engine=showing.engine,
        cases=showing.cases,
        promises=showing.promises,
        exhaustive=showing.exhaustive,
        used=list(showing.used),
        unused=list(showing.unused),
        rules=sorted(showing.rules),
        premises_hold=showing.witness,
        monitors=showing.evaluations,
        resources=list(showing.resources if again is None else again.resources),
    )
