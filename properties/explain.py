"""Explanations: everything the project knows about one ID, as lines of text."""

from __future__ import annotations

import re
from collections.abc import Iterator
from difflib import get_close_matches
from inspect import getdoc
from os.path import relpath
from typing import Any

from properties.claims.catalogue import CLAIMS
from properties.claims.claim import Claim
from properties.evidence.files import WITNESSES, file_name
from reference.play import LIBRARY, library, play
from spec.models import Model
from spec.readings import Reading
from spec.registry import Statement, statements
from spec.rule import Rule


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


def find(name: str) -> Statement:
    """The statement with an ID; a claim's `claim/` may be left out.

    Raises:
        UnknownID: if there is none.
    """
    table = everything()
    for candidate in (name, f"claim/{name}"):
        if candidate in table:
            return table[candidate]
    raise UnknownID(name, list(table))


def of_row(row: str) -> list[Statement]:
    """The statements whose source is a row of the register, as in R22 or A15.

    Raises:
        UnknownID: if there is none.
    """
    found = [one for one in everything().values() if re.search(rf"\b{re.escape(row)}\b", one.source)]
    if not found:
        raise UnknownID(row, list(everything()))
    return found


def explain(statement: Statement) -> Iterator[str]:
    """All about a statement."""
    yield f"{statement.id}  ({statement.kind})"
    yield f"  {statement.sentence}"
    yield f"  source: {statement.source}"
    if isinstance(statement, Rule):
        yield from explain_rule(statement)
    elif isinstance(statement, Claim):
        yield from explain_claim(statement)
    elif isinstance(statement, Model):
        yield f"  seen in scenario {statement.scenario}"
        yield f"  replay: graphbody simulate {relpath(LIBRARY / 'scenarios' / statement.scenario)}.json"
    elif isinstance(statement, Reading):
        yield f"  others could read: {statement.others}"
    yield from claims_about(statement)


def said(thing: Any) -> str:
    """The first line of what something says of itself."""
    return (getdoc(thing) or "").partition("\n")[0]


def explain_rule(rule: Rule[Any, Any]) -> Iterator[str]:
    """Guard, effect and a scenario in which the rule fires."""
    for conjunct in rule.guard:
        yield f"  guard  {conjunct.__name__}: {said(conjunct)}"
    yield f"  effect {rule.effect.__name__}: {said(rule.effect)}"
    yield from firing(rule.id)


def firing(rule: str) -> Iterator[str]:
    """The shortest scenario of the library in which a rule fires, and the request in which it does."""
    found = []
    for path in library():
        playing = play(path)
        for number, step in enumerate(playing.steps, start=1):
            for move in step.moves:
                bodies = [body for body, fired in move.fired if fired == rule]
                if bodies:
                    found.append((len(move.fired), path, playing.scenario.name, number, move, bodies[0]))
    if found:
        _, path, name, number, move, body = min(found, key=lambda entry: entry[0])
        asked = f"{move.body} asked {move.asked}, moved {move.moved}"
        yield f"  fires in scenario {name}, step {number} ({asked}), for {body}"
        yield f"  replay: graphbody simulate {relpath(path)}"


def explain_claim(claim: Claim) -> Iterator[str]:
    """Profile, premises, expected verdict and what is to show it."""
    table = statements()
    yield f"  profile: {claim.profile.name}; expected: {claim.expected.value}; about: {claim.about}"
    for premise in claim.premises:
        yield f"  assuming {premise}: {table[premise].sentence}"
    for obligation in claim.obligations:
        scope = "any number of bodies" if obligation.bodies is None else f"{obligation.bodies} bodies"
        yield f"  to prove ({scope}) {obligation.id}"
    if claim.hunt is not None:
        scope = "that keep the guidelines" if claim.hunt.guided else "of any kind"
        yield f"  to hunt for a witness in all scenes {scope}, up to {claim.hunt.most_bodies} bodies"
    if claim.sampled:
        yield "  tested on random rows, in exact numbers and in floats"
    for item in claim.counts:
        yield f"  to count {item.id}: {said(item.program)}"
    if claim.erratum is not None:
        yield f"  to refute: {said(claim.erratum)}"
    yield f"  run: graphbody check {claim.id}"
    witness = WITNESSES / f"{file_name(claim.id)}.json"
    if witness.exists():
        yield f"  replay its witness: graphbody simulate {witness}"


def claims_about(statement: Statement) -> Iterator[str]:
    """The claims that are about a statement, or assume it."""
    family = statement.id.partition("/")[0]
    for claim in CLAIMS:
        if statement.id in claim.premises:
            yield f"  assumed by {claim.id}"
        elif claim is not statement and claim.about in (statement.id, family):
            yield f"  {claim.expected.value} by {claim.id}: {claim.sentence}"
