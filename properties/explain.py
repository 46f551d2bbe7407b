"""Explanations: everything the project knows about one ID, as lines of text."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from difflib import get_close_matches
from functools import cache, singledispatch
from importlib import import_module
from inspect import getdoc
from os.path import relpath
from pathlib import Path
from pkgutil import iter_modules
from typing import Any

from properties import contracts
from properties.claims.catalogue import CLAIMS
from properties.claims.claim import Claim
from properties.evidence.files import RESULTS, RESULTS_LONG, WITNESSES, file_name
from properties.evidence.sources import sources
from properties.results import Results
from reference.formats.files import FormatError, read
from reference.play import LIBRARY, library, play
from reference.simulator import Fulfilled
from spec.alternatives import ALTERNATIVES, Alternative
from spec.case import Case
from spec.differences import DIFFERENCES, Difference
from spec.errata import Erratum
from spec.evaluated import Evaluated
from spec.models import Model
from spec.profiles import Profile, SteppedProfile
from spec.readings import Reading
from spec.registry import Statement, statements, text_of
from spec.rule import Rule
from spec.unsupported import ChangeCase, LevelCase


class UnknownID(KeyError):
    """No statement has this ID; the message says which are like it."""

    def __init__(self, name: str, known: list[str]) -> None:
        """Suggest what may have been meant."""
        like = get_close_matches(name, known, n=3, cutoff=0.5)
        hint = f"; did you mean {' or '.join(like)}?" if like else "; `graphbody list` shows all IDs"
        super().__init__(f"no statement has the ID {name!r}{hint}")


def everything() -> dict[str, Statement]:
    """Every statement and every claim by ID."""
    table: dict[str, Statement] = dict(statements())
    for claim in CLAIMS:
        table[claim.id] = claim
    return table


@dataclass(frozen=True)
class ToProve:
    """An obligation, by its name: what it says is said where it is written."""

    id: str
    sentence: str
    source: str

    kind = "obligation"


def find(name: str) -> Statement:
    """The statement with an ID, or the obligation of a name; a claim's `claim/` may be left out.

    Raises:
        UnknownID: if there is none.
    """
    table = everything()
    for candidate in (name, f"claim/{name}"):
        if candidate in table:
            return table[candidate]
    obligations = {obligation.id for claim in CLAIMS for obligation in claim.obligations}
    if name in obligations:
        return to_prove(name)
    raise UnknownID(name, [*table, *obligations])


def to_prove(name: str) -> ToProve:
    """The obligation of a name, which is that of the function that states it, and of the setting."""
    function = name.partition(" (")[0].partition("/")[2].replace("-", "_")
    modules = [import_module(f"{contracts.__name__}.{one.name}") for one in iter_modules(contracts.__path__)]
    (module,) = (one for one in modules if getattr(vars(one).get(function), "__module__", None) == one.__name__)
    text = " ".join((getdoc(vars(module)[function]) or "").split())
    return ToProve(name, text, f"{module.__name__.replace('.', '/')}.py, {function}")


def of_row(row: str) -> list[Statement]:
    """The statements whose source is a row of the register, as in R22 or A15.

    Raises:
        UnknownID: if there is none.
    """
    found = [one for one in everything().values() if re.search(rf"\b{re.escape(row)}\b", one.source)]
    if not found:
        raise UnknownID(row, list(everything()))
    return found


@dataclass(frozen=True)
class Fact:
    """Something about a statement: what kind of thing, and the thing itself; `code` if that is a command."""

    label: str
    text: str
    code: bool = False


@dataclass(frozen=True)
class Firing:
    """A request in a scenario in which a rule fires: the file, the number of the step, and what came of the request."""

    path: Path
    step: int
    body: str
    move: Fulfilled[Any]

    @property
    def rank(self) -> tuple[bool, int]:
        """Figures of the thesis come first, then the shorter ones."""
        return not self.path.stem.startswith("figure"), len(self.move.fired)


def explain(statement: Statement) -> Iterator[str]:
    """All about a statement, as lines of text."""
    yield f"{statement.id}  ({statement.kind})"
    yield f"  {statement.sentence}"
    if isinstance(statement, Claim):
        yield from (f"  last run: {line}" for line in last_run(statement))
    for fact in facts(statement):
        yield f"  {fact.label}: {fact.text}"


def last_run(claim: Claim) -> Iterator[str]:
    """What the last run of the check showed of a claim; a run about other sources is stale and shows nothing."""
    path = RESULTS_LONG if claim.long else RESULTS
    if not path.exists():
        return
    try:
        run = read(path, Results)
    except FormatError as error:
        yield str(error)
        return
    if run.sources != sources():
        yield f"stale: {path} is about other sources; run it again"
        return
    yield from (f"{result.verdict}, by {result.engine}" for result in run.claims if result.id == claim.id)


def facts(statement: Statement) -> Iterator[Fact]:
    """All about a statement but what it says."""
    yield Fact("source", statement.source)
    yield from of_kind(statement)
    yield from claims_about(statement)


@singledispatch
def of_kind(statement: Any) -> Iterator[Fact]:
    """What there is to say of one kind of statement: of most, nothing."""
    yield from ()


@of_kind.register
def of_profile(statement: Profile) -> Iterator[Fact]:
    """Its models, rules and readings."""
    yield from (Fact(one.kind, f"{one.id}: {one.sentence}") for one in text_of(statement))


@of_kind.register
def of_stepped_profile(statement: SteppedProfile) -> Iterator[Fact]:
    """Its models, rules and readings, and what differs from the thesis."""
    yield from (Fact(one.kind, f"{one.id}: {one.sentence}") for one in text_of(statement))
    yield from (Fact("unlike thesis", f"{one.id}: {one.sentence}") for one in DIFFERENCES)


@of_kind.register
def of_obligation(obligation: ToProve) -> Iterator[Fact]:
    """The claims that rest on it."""
    for claim in CLAIMS:
        if any(one.id == obligation.id for one in claim.obligations):
            yield Fact("shows", f"{claim.id}: {claim.sentence}")


@of_kind.register
def of_seen(statement: Model | Difference) -> Iterator[Fact]:
    """The scenario in which it is seen."""
    yield from seen_in(statement.scenario)


@of_kind.register
def of_evaluated(statement: Evaluated) -> Iterator[Fact]:
    """What was measured."""
    yield Fact("judgement", statement.judgement.value)
    yield Fact("measured in", f"docs/evaluation.md#{statement.section}")


@of_kind.register(Reading)
def of_reading(statement: Reading[Any]) -> Iterator[Fact]:
    """What others could read, and a scenario in which that would matter."""
    yield Fact("others could read", statement.others)
    yield from (Fact("alternative", f"{one.id}: {one.sentence}") for one in ALTERNATIVES if one.of == statement.id)
    if statement.scenario:
        yield replay(LIBRARY / "scenarios" / f"{statement.scenario}.json")


@of_kind.register
def of_case(statement: Case) -> Iterator[Fact]:
    """Where it happens."""
    yield Fact("where", said(statement.happened))


@of_kind.register
def of_case_of_places(statement: LevelCase | ChangeCase) -> Iterator[Fact]:
    """Where it is found."""
    yield Fact("where", said(statement.found))


@of_kind.register
def of_alternative(statement: Alternative) -> Iterator[Fact]:
    """What it is read instead of."""
    yield Fact("instead of", f"{statement.of}: {everything()[statement.of].sentence}")


@of_kind.register
def of_erratum(erratum: Erratum) -> Iterator[Fact]:
    """The printed rules, the scenario in which it is seen, what it refutes, what holds instead, and what shows that."""
    table = everything()
    named = {"printed": erratum.printed, "refutes": erratum.refuted, "mended by": erratum.mended}
    for label, names in (named | {"shown by": erratum.evidence}).items():
        yield from (Fact(label, f"{name}: {table[name].sentence}") for name in names)
    if not erratum.mended:
        yield Fact("mended", "no: kept on purpose")
    yield from seen_in(erratum.witness)


def seen_in(scenario: str) -> Iterator[Fact]:
    """A scenario, and how to play it."""
    yield Fact("seen in scenario", scenario)
    yield replay(LIBRARY / "scenarios" / f"{scenario}.json")


def replay(path: Path) -> Fact:
    """The command that plays a scenario."""
    return Fact("replay", f"graphbody simulate {relpath(path)}", code=True)


def said(thing: Any) -> str:
    """The first line of what something says of itself."""
    return (getdoc(thing) or "").partition("\n")[0]


@of_kind.register(Rule)
def of_rule(rule: Rule[Any, Any]) -> Iterator[Fact]:
    """Guard, effect, event and a scenario in which the rule fires; one that moves no body fires in none."""
    for conjunct in rule.guard:
        yield Fact("guard", f"{conjunct.__name__}: {said(conjunct)}")
    yield Fact("effect", f"{rule.effect.__name__}: {said(rule.effect)}")
    if rule.event is not None:
        yield Fact("event", rule.event)
    found = firings().get(rule.id)
    if found is None:
        return
    asked = f"{found.move.body} asked {found.move.asked}, moved {found.move.moved}"
    yield Fact("fires in", f"{found.path.stem}, step {found.step} ({asked}), for {found.body}")
    yield replay(found.path)


@cache
def firings() -> dict[str, Firing]:
    """For each rule the request of the library that ranks first of those in which it fires."""
    found: dict[str, Firing] = {}
    for path in library():
        for number, step in enumerate(play(path).steps, start=1):
            for move in step.moves:
                for body, rule in move.fired:
                    firing = Firing(path, number, body, move)
                    if rule not in found or firing.rank < found[rule].rank:
                        found[rule] = firing
    return found


@of_kind.register
def of_claim(claim: Claim) -> Iterator[Fact]:
    """Profile, premises, expected verdict and what is to show it."""
    table = statements()
    yield Fact("profile", claim.profile.name)
    yield Fact("about", claim.about)
    yield Fact("expected", claim.expected.value)
    for premise in claim.premises:
        yield Fact("assuming", f"{premise}: {table[premise].sentence}")
    for obligation in claim.obligations:
        scope = "any number of bodies" if obligation.bodies is None else f"{obligation.bodies} bodies"
        yield Fact("to prove", f"{obligation.id} ({scope})")
    if claim.hunt is not None:
        scope = "that keep the guidelines" if claim.hunt.guided else "of any kind"
        yield Fact("to hunt for", f"a witness in all scenes {scope}, up to {claim.hunt.most_bodies} bodies")
    if claim.sampled:
        yield Fact("tested", f"on random {claim.sampled}, in exact numbers and in floats")
    for item in claim.counts:
        yield Fact("to count", f"{item.id}: {said(item.program)}")
    if claim.erratum is not None:
        yield Fact("to refute", said(claim.erratum))
    yield Fact("run", f"graphbody check {claim.id}", code=True)
    witness = witness_of(claim)
    if witness.exists():
        yield replay(witness)


def witness_of(claim: Claim) -> Path:
    """Where the witness of a claim is written."""
    return WITNESSES / f"{file_name(claim.id)}.json"


def claims_about(statement: Statement) -> Iterator[Fact]:
    """The claims that are about a statement, or assume it."""
    family = statement.id.partition("/")[0]
    for claim in CLAIMS:
        if statement.id in claim.premises:
            yield Fact("assumed by", claim.id)
        elif claim is not statement and claim.about in (statement.id, family):
            yield Fact(f"{claim.expected.value} by", f"{claim.id}: {claim.sentence}")
