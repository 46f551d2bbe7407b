"""The mutants of the contracts: of the obligations, and of the window on which they speak.

A wrong contract fails on the true rules, or it assumes other premises than it did, or it says of a wrong rule something
else than the contract does: of recorded values, other promises are broken. The last needs no solver.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cache

from properties.engine.explore import explore
from properties.evidence.mutants.mutant import Mutant, mutants_of, told_apart
from properties.evidence.mutants.operators import WEAKENING
from properties.evidence.mutants.rules import of_rules
from properties.evidence.mutants.trial import CRASHES, Kill, programs, replayed, told
from properties.evidence.showing import texts

CONTRACTS = (
    "properties.contracts.contract",
    "properties.contracts.request",
    "properties.contracts.lemma",
    "properties.contracts.leaving",
    "properties.contracts.families",
    "properties.worlds.window",
)
PREMISES = "other premises"

Caught = Mapping[str, Iterable[Kill]]
"""The kills of the mutants of the rules, by name of the mutant."""


@cache
def of_contracts() -> dict[str, Mutant]:
    """All mutants of the contracts, by name."""
    return told_apart([mutant for module in CONTRACTS for mutant in mutants_of(module, operators=WEAKENING)])


def kill_of_contract(
    mutant: Mutant, caught: Caught, calls: Mapping[str, frozenset[str]], premises: Mapping[str, tuple[str, ...]]
) -> Kill | None:
    """What catches a mutant of a contract: the first of its kind in a fixed order."""
    mine = [name for name, functions in calls.items() if functions & mutant.reached]
    return disagreement(mutant, caught, frozenset(mine)) or failure(mutant, mine, premises)


def disagreement(mutant: Mutant, caught: Caught, mine: frozenset[str]) -> Kill | None:
    """A recorded kill of a wrong rule of which the mutant says another thing."""
    for name, kills in caught.items():
        for kill in kills:
            if kill.by in mine and (now := said_otherwise(mutant, of_rules()[name], kill)) is not None:
                return Kill(kill.by, now, kill.values, name)
    return None


def said_otherwise(mutant: Mutant, rule: Mutant, kill: Kill) -> tuple[str, ...] | None:
    """What a mutant of a contract says is broken at the values of a kill, if that is not what was said."""
    with rule.in_place(), mutant.in_place():
        now = replayed(kill.by, kill.values)
    return now if now is not None and now != kill.broken else None


def failure(mutant: Mutant, mine: Iterable[str], premises: Mapping[str, tuple[str, ...]]) -> Kill | None:
    """An obligation that fails on the true rules with the mutant in place, or assumes what it did not."""
    with mutant.in_place():
        for name in mine:
            try:
                outcome = explore(programs()[name])
            except CRASHES:
                continue
            if outcome.counterexample is not None:
                return Kill(name, told(outcome.counterexample.broken), texts(outcome.counterexample.values))
            if told(outcome.assumed) != premises[name]:
                return Kill(name, (PREMISES,), {})
    return None


def premises_of(name: str) -> tuple[str, ...]:
    """The names of all premises that an obligation assumes, the signs of what it draws included."""
    return told(explore(programs()[name]).assumed)
