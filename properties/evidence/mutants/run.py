"""Running mutants, side by side: to record what catches each, and to try again what is recorded.

A record is made group by group. What is found of a mutant is stored at once, so that a run that stops loses nothing;
and what was recorded before is taken over as long as it still holds, so that only what is new is looked for.
"""

from __future__ import annotations

import signal
from collections.abc import Callable, Iterable, Iterator, Mapping
from concurrent.futures import Executor, ProcessPoolExecutor, as_completed
from contextlib import nullcontext
from dataclasses import dataclass
from functools import lru_cache, partial
from hashlib import sha256
from multiprocessing import get_context
from os import cpu_count
from pathlib import Path
from typing import Any

from properties.claims.catalogue import CLAIMS
from properties.claims.claim import Claim
from properties.evidence.export import Recorder
from properties.evidence.files import MUTANTS
from properties.evidence.mutants import outings
from properties.evidence.mutants.argued import ARGUED, CHANGES_NO_ANSWER
from properties.evidence.mutants.contracts import (
    PREMISES,
    kill_of_obligation,
    kills_of_contract,
    of_contracts,
    of_obligations,
    wrong_ones,
)
from properties.evidence.mutants.engine import crashing_tests, failed_tests, of_engine
from properties.evidence.mutants.equal import EQUAL, proved_equal
from properties.evidence.mutants.invariants import of_invariants
from properties.evidence.mutants.mutant import Mutant
from properties.evidence.mutants.outings import STEPPED
from properties.evidence.mutants.record import Kills, Record
from properties.evidence.mutants.rules import of_displays, of_rules, of_steps, of_velocities
from properties.evidence.mutants.stepped import (
    BANK_OF_STEPS,
    STEP,
    crash_of_judge,
    judged_otherwise,
    kill_of_judge,
    of_judges,
)
from properties.evidence.mutants.texts import COUNTS, ON_STRINGS, of_texts
from properties.evidence.mutants.trial import (
    CRASHING,
    FEW,
    MANY,
    SOME,
    Facts,
    Kill,
    count_crash,
    counted,
    crash_of,
    errata,
    explored,
    facts_of,
    interface,
    is_tried,
    kills_by_counts,
    kills_by_proofs,
    kills_by_rows,
    kills_by_witnesses,
    miscounted,
    name_of,
    no_change,
    programs,
    replayed,
    rows_broken,
    unrefuted,
    witness_of,
)
from properties.evidence.mutants.worlds import (
    MEASURE,
    MEASURED,
    kill_by_measures,
    measured_otherwise,
    of_worlds,
)
from properties.evidence.sample_steps import STOREYS
from properties.evidence.showing import Job, Texts
from properties.evidence.sources import sources
from properties.evidence.store import Store
from properties.worlds import slot
from spec.profiles import THESIS

BANK = "count: counts/invariants-judge"
GROUPS: dict[str, Callable[[], dict[str, Mutant]]] = {
    "rules": of_rules,
    "steps": of_steps,
    "velocity": of_velocities,
    "display": of_displays,
    "worlds": of_worlds,
    "texts": of_texts,
    "contracts": of_contracts,
    "obligations": of_obligations,
    "invariants": of_invariants,
    "stepped": of_judges,
    "engine": of_engine,
}
WRONG = ("rules", "steps", "velocity", "display", "worlds", "texts", "contracts")
"""The groups of which obligations are to notice each."""
NOTICING = ("obligations", "contracts")
"""The groups of what is to notice them: what one says of a wrong one is another thing than the true one says."""
OF_RULES = ("rules", "steps", "velocity", "display")
"""The groups of which all obligations that catch one are recorded."""
OF_A_FAMILY = {"velocity", "display"}
"""The groups that are caught by what the claims of one family rest on, which has the name of the group."""


@dataclass(frozen=True)
class Known:
    """What is known before the mutants of a group are tried.

    Attributes:
        facts: of each obligation.
        witnesses: values that refute claims.
        kills: of the groups in `WRONG`, as far as they have been tried.
        recorded: what was recorded before.
    """

    facts: Mapping[str, Facts]
    witnesses: Mapping[str, Texts]
    kills: Kills
    recorded: Record

    @property
    def calls(self) -> dict[str, frozenset[str]]:
        """The functions that each obligation runs, from the one of the fewest paths on."""
        return {name: self.facts[name].calls for name in sorted(self.facts, key=lambda name: self.facts[name].paths)}

    @property
    def few(self) -> dict[str, frozenset[str]]:
        """The same of those that have few paths."""
        return {name: called for name, called in self.calls.items() if self.facts[name].paths <= FEW}

    @property
    def tried(self) -> dict[str, frozenset[str]]:
        """The same of those on which all wrong rules are tried: of very many, only those that have some paths."""
        many = {name for name in self.facts if name.startswith(MANY) and self.facts[name].paths > SOME}
        return {name: called for name, called in self.calls.items() if name not in many}

    def tried_on(self, group: str) -> dict[str, frozenset[str]]:
        """The same of those on which the wrong ones of a group are tried."""
        if group in OF_RULES:
            return self.tried
        few = self.few
        on_strings = ON_STRINGS if group == "texts" else ()
        return {name: called for name, called in self.calls.items() if name in few or name.startswith(on_strings)}

    @property
    def premises(self) -> dict[str, tuple[str, ...]]:
        """What each obligation assumes."""
        return {name: facts.premises for name, facts in self.facts.items()}


@dataclass(frozen=True)
class Found:
    """What catches a mutant; and if nothing does, why it counts as none, if something says so."""

    kills: tuple[Kill, ...]
    aside: str | None = None


HELD: list[Known] = []
"""What a process of a pool knows: it is told when it begins."""


def pool(*known: Known) -> ProcessPoolExecutor:
    """A process for each core, each told what is known."""
    return ProcessPoolExecutor(cpu_count(), mp_context=get_context("forkserver"), initializer=begin, initargs=known)


def begin(*known: Known) -> None:
    """Begin a process of a pool: an interrupt ends it without a word; what true rules have made is remembered."""
    slot.start()
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    HELD.extend(known)


def evidence_of(claim: Claim) -> tuple[str, ...]:
    """What a claim rests on, of what mutants are tried on."""
    obligations = [name_of(claim, one) for one in claim.obligations if is_tried(one)]
    tested = [f"{STEPPED}{claim.about}"] if claim.sampled == STOREYS.name else []
    return (*obligations, *(f"count: {one.id}" for one in counted(claim)), *tested)


def resting() -> dict[str, tuple[str, ...]]:
    """What each claim rests on."""
    return {claim.id: evidence_of(claim) for claim in CLAIMS}


def kills_of(known: Known, group: str, name: str) -> tuple[Kill, ...]:
    """All that catches a mutant of the rules or of the contracts; of any other, the first thing that does."""
    mutant = GROUPS[group]()[name]
    outings.made()
    if group == "contracts":
        return kills_of_contract(mutant, known.kills, known.calls, known.premises)
    if group == "obligations":
        return one_or_none(kill_of_obligation(mutant, known.kills, known.calls, known.premises))
    if group == "stepped":
        return one_or_none(kill_of_judge(mutant))
    with mutant.in_place():
        if group == "invariants":
            return tuple(Kill(BANK, (wrong,)) for wrong in miscounted(BANK))
        if group == "engine":
            return tuple(Kill("test", (test,)) for test in failed_tests())
        if group == "worlds":
            first = one_or_none(kill_by_measures()) or tuple(outings.kills_by_storeys(first=True))
            return (*first, *kills_by_proofs(mutant, known.tried_on(group)))
        if group == "texts":
            counted_wrong = (Kill(one, wrong) for one in COUNTS if (wrong := miscounted(one)))
            return tuple(kills_by_proofs(mutant, known.tried_on(group))) or one_or_none(next(counted_wrong, None))
        if group in OF_A_FAMILY:
            return tuple(kills_by_proofs(mutant, known.tried)) or tuple(kills_by_counts(of_family(group)))
        proofs = tuple(kills_by_proofs(mutant, known.tried))
        if group == "steps":
            return (*proofs, *outings.kills_by_storeys())
        return proofs or tuple(kills_by_runs(known.witnesses)) or tuple(kills_by_rows())


def of_family(family: str) -> Iterator[Claim]:
    """The claims of a family."""
    return (claim for claim in CLAIMS if claim.family == family)


def one_or_none(kill: Kill | None) -> tuple[Kill, ...]:
    """The kill, if there is one."""
    return () if kill is None else (kill,)


def kills_by_runs(witnesses: Mapping[str, Texts]) -> Iterator[Kill]:
    """The counts that fail on a mutant in place, and the witnesses that are none any more."""
    yield from kills_by_counts(one for one in CLAIMS if one.profile == THESIS and one.family not in OF_A_FAMILY)
    yield from kills_by_witnesses(witnesses)


def taken_over(known: Known, group: str, name: str) -> Found | None:
    """What was recorded of a mutant, if all that caught it still does, or if it only crashed; and what new obligations
    catch.
    """
    kills, aside = known.recorded.kills.get(group, {}).get(name, ()), known.recorded.equal.get(name, "")
    if aside.startswith(CRASHING):
        found = tuple(kills_by_new_proofs(known, group, name))
        return Found(found, None if found else aside)
    if kills and not complaints(known.premises, group, name, kills):
        return Found((*kills, *kills_by_new_proofs(known, group, name)))
    return None


def kills_by_new_proofs(known: Known, group: str, name: str) -> Iterator[Kill]:
    """The obligations that catch a mutant of the rules, of those that the record does not know yet."""
    calls = {one: called for one, called in known.tried_on(group).items() if one not in known.recorded.premises}
    if group in (*OF_RULES, "worlds", "texts"):
        mutant = GROUPS[group]()[name]
        with mutant.in_place():
            yield from kills_by_proofs(mutant, calls)


def found_of(group: str, name: str) -> Found:
    """What catches a mutant, or why it counts as none."""
    (known,) = HELD
    before = taken_over(known, group, name)
    if before is not None:
        return before
    kills = kills_of(known, group, name)
    return Found(kills, None if kills else set_aside(known, group, name))


def again(premises: Mapping[str, tuple[str, ...]], group: str, name: str, kill: Kill) -> tuple[str, ...] | None:
    """What fails of the evidence of a kill, at its values, with its mutants in place; None if it crashes."""
    if kill.by.startswith(STEPPED):
        broken = broken_in(group, name, kill.on, outings.number_of(kill))
        return None if broken is None else tuple(one for one in broken if kill.by == f"{STEPPED}{one}")
    beside = wrong_ones()[kill.on].in_place() if kill.on else nullcontext()
    with beside, GROUPS[group]()[name].in_place():
        if kill.broken == (PREMISES,):
            return kill.broken if kill.by in premises and interface(kill.by) != premises[kill.by] else ()
        if kill.by == BANK_OF_STEPS:
            return judged_otherwise(str(kill.values[STEP]))
        if kill.by == MEASURED:
            return measured_otherwise(str(kill.values[MEASURE]))
        if kill.by == "test":
            return failed_tests(*kill.broken)
        if kill.by.startswith("count: "):
            return miscounted(kill.by)
        if kill.by.startswith("witness: "):
            return unrefuted(kill.by, kill.values)
        return rows_broken() if kill.by.startswith("rows: ") else replayed(kill.by, kill.values)


@lru_cache(maxsize=16)
def broken_in(group: str, name: str, on: str, number: int) -> tuple[str, ...] | None:
    """The properties that fail in a world with a mutant in place, and one beside it, if one is named."""
    outings.outing_of(number)
    beside = wrong_ones()[on].in_place() if on else nullcontext()
    with beside, GROUPS[group]()[name].in_place():
        return outings.broken_in(number)


def complaints(premises: Mapping[str, tuple[str, ...]], group: str, name: str, kills: Iterable[Kill]) -> list[str]:
    """The recorded kills of a mutant that are none any more, or of which something else is said."""
    found = []
    for kill in kills:
        if kill.on and kill.on not in wrong_ones():
            found.append(f"{kill.by}: catches {name} on {kill.on}, which is no mutant any more")
            continue
        now = again(premises, group, name, kill)
        for lost in (promise for promise in kill.broken if promise not in (now or ())):
            found.append(f"{kill.by}: {lost}: no longer catches {name}")
        if now is not None and not found and set(now) != set(kill.broken):
            found.append(f"{kill.by}: says of {name} that {', '.join(now)}; recorded is {', '.join(kill.broken)}")
        if group in NOTICING and kill.on and now == said_without(kill):
            found.append(f"{kill.by}: says the same of {kill.on} without {name}")
    return found


def said_without(kill: Kill) -> tuple[str, ...] | None:
    """What the true obligation says at the values of a kill of the wrong one that is in place; None if it crashes."""
    with wrong_ones()[kill.on].in_place():
        return replayed(kill.by, kill.values)


def set_aside(known: Known, group: str, name: str) -> str | None:
    """Why a mutant that nothing catches is none: it changes no answer, is proved to change nothing, or crashes."""
    mutant = GROUPS[group]()[name]
    if name in EQUAL:
        return proved_equal(name, mutant)
    if name in ARGUED:
        return f"{CHANGES_NO_ANSWER}: {ARGUED[name]}"
    if group == "invariants":
        return count_crash(mutant, BANK)
    if group == "stepped":
        return crash_of_judge(mutant)
    if group == "engine":
        return crashing_tests(mutant)
    if group in ("steps", "worlds"):
        with mutant.in_place():
            crash = outings.crash_in_storeys()
        crashes = f"{CRASHING}: {crash}" if crash else crash_of(mutant, known.calls)
        return no_change(mutant, known.calls) or crashes
    if group == "texts":
        calls, counts = known.tried_on(group), (count_crash(mutant, one) for one in COUNTS)
        return no_change(mutant, calls) or crash_of(mutant, calls) or next(filter(None, counts), None)
    return no_change(mutant, known.calls) or crash_of(mutant, known.calls)


Progress = Callable[[str, int, int], None]
Work = dict[Job, Callable[[], Any]]


def all_of(executor: Executor, store: Store[Any], what: str, work: Work, progress: Progress) -> list[Any]:
    """The results of some jobs in their order; what is stored is taken from there, and what is found is stored."""
    results = store.current(work)
    running = {executor.submit(store.run, job, work[job]): job for job in work if job not in results}
    progress(what, len(results), len(work))
    try:
        for future in as_completed(running):
            results[running[future]] = future.result()
            progress(what, len(results), len(work))
    except KeyboardInterrupt:
        executor.shutdown(wait=False, cancel_futures=True)
        raise
    return [results[job] for job in work]


def job_of(group: str, name: str) -> Job:
    """The job of a mutant; its name is too long for that of a file."""
    return "mutant", group, sha256(name.encode()).hexdigest()[:16]


def record_all(before: Record, progress: Progress) -> Record:
    """Find what catches each mutant; what was recorded before is taken over as long as it holds."""
    now = sources()
    with pool() as executor:
        asked: Work = {("facts", name): partial(facts_of, name) for name in programs()}
        facts = all_of(executor, Store(MUTANTS, now, Facts), "facts", asked, progress)
        refuted: Work = {("witness", name): partial(witness_of, name) for name in errata()}
        witnesses = all_of(executor, Store(MUTANTS, now, Texts), "witnesses", refuted, progress)
    known = Known(dict(zip(programs(), facts, strict=True)), dict(zip(errata(), witnesses, strict=True)), {}, before)
    record = Record(resting(), known.premises)
    for group, mutants in GROUPS.items():
        with pool(known) as executor:
            work: Work = {job_of(group, name): partial(found_of, group, name) for name in mutants()}
            found = all_of(executor, Store(MUTANTS, now, Found), group, work, progress)
        tried = dict(zip(mutants(), found, strict=True))
        record.kills[group] = {name: one.kills for name, one in tried.items()}
        record.equal.update({name: one.aside for name, one in tried.items() if one.aside})
        if group in WRONG:
            known.kills.update(record.kills[group])
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
    everything = {name: mutant for mutants in GROUPS.values() for name, mutant in mutants().items()}
    for name in EQUAL:
        if name not in everything or proved_equal(name, everything[name]) is None:
            yield f"{name}: expected a mutant that is proved to be the same"
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
