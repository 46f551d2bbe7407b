"""Running mutants, side by side: to record what catches each, and to try again what is recorded."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from concurrent.futures import Executor, ProcessPoolExecutor
from contextlib import nullcontext
from dataclasses import dataclass, field, replace
from functools import partial
from multiprocessing import get_context
from os import cpu_count
from pathlib import Path

from properties.claims.catalogue import CLAIMS
from properties.claims.claim import Claim
from properties.evidence.export import Recorder
from properties.evidence.mutants.argued import ARGUED, OPEN, UNNOTICED
from properties.evidence.mutants.contracts import (
    PREMISES,
    kill_of_obligation,
    kills_of_contract,
    of_contracts,
    of_obligations,
    wrong_one,
)
from properties.evidence.mutants.engine import crashing_tests, failed_tests, of_engine
from properties.evidence.mutants.invariants import of_invariants
from properties.evidence.mutants.mutant import Mutant
from properties.evidence.mutants.record import Kills, Record
from properties.evidence.mutants.rules import of_rules
from properties.evidence.mutants.trial import (
    Kill,
    count_crash,
    crash_of,
    errata,
    explored,
    functions_called,
    interface,
    kills_by_proofs,
    kills_by_rows,
    kills_by_runs,
    miscounted,
    name_of,
    no_change,
    of_requests,
    programs,
    replayed,
    rows_broken,
    unrefuted,
    witness_of,
)
from properties.evidence.showing import Texts

BANK = "count: counts/invariants-judge"
GROUPS: dict[str, Callable[[], dict[str, Mutant]]] = {
    "rules": of_rules,
    "contracts": of_contracts,
    "obligations": of_obligations,
    "invariants": of_invariants,
    "engine": of_engine,
}
WRONG = ("rules", "contracts")
"""The groups of which obligations are to notice each."""


@dataclass(frozen=True)
class Known:
    """What is known before mutants are tried: the functions and the premises of each obligation, and witnesses."""

    calls: Mapping[str, frozenset[str]]
    premises: Mapping[str, tuple[str, ...]]
    witnesses: Mapping[str, Texts]
    kills: Kills = field(default_factory=dict)


def pool() -> ProcessPoolExecutor:
    """A process for each core."""
    return ProcessPoolExecutor(cpu_count(), mp_context=get_context("forkserver"))


def evidence_of(claim: Claim) -> tuple[str, ...]:
    """What a claim rests on, of what mutants are tried on."""
    if claim not in of_requests():
        return ()
    obligations = [name_of(claim, one) for one in claim.obligations if one.shape is None]
    return (*obligations, *(f"count: {one.id}" for one in claim.counts))


def resting() -> dict[str, tuple[str, ...]]:
    """What each claim rests on."""
    return {claim.id: evidence_of(claim) for claim in CLAIMS}


def kills_of(known: Known, group: str, name: str) -> tuple[Kill, ...]:
    """All that catches a mutant of the rules or of the contracts; of any other, the first thing that does."""
    mutant = GROUPS[group]()[name]
    if group == "contracts":
        return kills_of_contract(mutant, known.kills, known.calls, known.premises)
    if group == "obligations":
        found = kill_of_obligation(mutant, known.kills, known.calls, known.premises)
        return () if found is None else (found,)
    with mutant.in_place():
        if group == "invariants":
            return tuple(Kill(BANK, (wrong,)) for wrong in miscounted(BANK))
        if group == "engine":
            return tuple(Kill("test", (test,)) for test in failed_tests())
        proofs = tuple(kills_by_proofs(mutant, known.calls))
        return proofs or tuple(kills_by_runs(known.witnesses)) or tuple(kills_by_rows())


def again(premises: Mapping[str, tuple[str, ...]], group: str, name: str, kill: Kill) -> tuple[str, ...] | None:
    """What fails of the evidence of a kill, at its values, with its mutants in place; None if it crashes."""
    beside = wrong_one(kill.on).in_place() if kill.on else nullcontext()
    with beside, GROUPS[group]()[name].in_place():
        if kill.broken == (PREMISES,):
            return kill.broken if interface(kill.by) != premises[kill.by] else ()
        if kill.by == "test":
            return failed_tests(*kill.broken)
        if kill.by.startswith("count: "):
            return miscounted(kill.by)
        if kill.by.startswith("witness: "):
            return unrefuted(kill.by, kill.values)
        return rows_broken() if kill.by.startswith("rows: ") else replayed(kill.by, kill.values)


def complaints(premises: Mapping[str, tuple[str, ...]], group: str, name: str, kills: Iterable[Kill]) -> list[str]:
    """The recorded kills of a mutant that are none any more, or of which something else is said."""
    found = []
    for kill in kills:
        now = again(premises, group, name, kill)
        for lost in (promise for promise in kill.broken if promise not in (now or ())):
            found.append(f"{kill.by}: {lost}: no longer catches {name}")
        if now is not None and not found and set(now) != set(kill.broken):
            found.append(f"{kill.by}: says of {name} that {', '.join(now)}; recorded is {', '.join(kill.broken)}")
    return found


def facts_of(name: str) -> tuple[str, frozenset[str], tuple[str, ...]]:
    """The functions that an obligation runs, and its premises."""
    return name, functions_called(name), interface(name)


def learnt(executor: Executor) -> Known:
    """What is to be known before mutants are tried."""
    found = list(executor.map(facts_of, programs()))
    calls, premises = {name: calls for name, calls, _ in found}, {name: said for name, _, said in found}
    return Known(calls, premises, dict(zip(errata(), executor.map(witness_of, errata()), strict=True)))


def set_aside(known: Known, group: str, name: str) -> str | None:
    """Why a mutant that nothing catches is none: it is proved to change nothing, it crashes, or it is argued."""
    mutant = GROUPS[group]()[name]
    if name in ARGUED:
        return f"argued: {ARGUED[name]}"
    if name in OPEN:
        return UNNOTICED
    if group == "invariants":
        return count_crash(mutant, BANK)
    if group == "engine":
        return crashing_tests(mutant)
    return no_change(mutant, known.calls) or crash_of(mutant, known.calls)


def record_all(progress: Callable[[str, tuple[Kill, ...]], None]) -> Record:
    """Find what catches each mutant."""
    with pool() as executor:
        known = learnt(executor)
        record = Record(resting(), dict(known.premises))
        for group, mutants in GROUPS.items():
            found = record.kills.setdefault(group, {})
            tasks = executor.map(partial(kills_of, known, group), mutants(), chunksize=2)
            for name, kills in zip(mutants(), tasks, strict=True):
                found[name] = kills
                progress(name, kills)
            left = [name for name, kills in found.items() if not kills]
            reasons = zip(left, executor.map(partial(set_aside, known, group), left), strict=True)
            record.equal.update({name: reason for name, reason in reasons if reason})
            known = replace(known, kills={**known.kills, **found}) if group in WRONG else known
    return record


def tried_again(record: Record) -> Iterator[tuple[str, list[str]]]:
    """Each recorded mutant that there is, with what is wrong of its record."""
    tasks = [(group, name, kills) for group, table in record.kills.items() for name, kills in table.items()]
    there = [task for task in tasks if task[1] in GROUPS[task[0]]()]
    with pool() as executor:
        found = executor.map(partial(complaints, record.premises), *zip(*there, strict=True), chunksize=4)
        yield from ((name, wrong) for (_, name, _), wrong in zip(there, found, strict=True))


def lost(record: Record) -> Iterator[str]:
    """All that is wrong of a record: what is not recorded, what is no more, what is no longer so, and who survives."""
    for group, mutants in GROUPS.items():
        recorded = record.kills.get(group, {})
        yield from (f"{name}: a mutant that is not recorded" for name in mutants() if name not in recorded)
        yield from (f"{name}: recorded, but there is no such mutant" for name in recorded if name not in mutants())
    for claim, evidence in resting().items():
        if record.claims.get(claim) != evidence:
            yield f"{claim}: rests on {', '.join(evidence)}; recorded is {', '.join(record.claims.get(claim, ()))}"
    yield from (f"{claim}: recorded, but there is no such claim" for claim in record.claims if claim not in resting())
    with pool() as executor:
        for name, said in zip(programs(), executor.map(interface, programs()), strict=True):
            if said != record.premises.get(name):
                yield f"{name}: assumes {', '.join(said)}; recorded is {', '.join(record.premises.get(name, ()))}"
    for _, wrong in tried_again(record):
        yield from wrong
    yield from (f"{name}: SURVIVES" for name in record.survivors())


def exported(record: Record, directory: Path) -> dict[str, str]:
    """For each mutant of the rules that an obligation catches, a file with the first that does; all are sat."""
    kills = [(name, next(iter(kills))) for name, kills in record.kills.get("rules", {}).items() if kills]
    tasks = [
        (f"mutant-{place:03}", name, kill.by) for place, (name, kill) in enumerate(kills, 1) if kill.by in programs()
    ]
    with pool() as executor:
        list(executor.map(partial(write_broken, directory), *zip(*tasks, strict=True), chunksize=4))
    return {f"{stem}.smt2": "sat" for stem, _, _ in tasks}


def write_broken(directory: Path, stem: str, name: str, obligation: str) -> None:
    """Write what an obligation explores up to the counterexample with a mutant in place."""
    with of_rules()[name].in_place():
        Recorder(directory, stem, only_broken=True)(explored(obligation))
