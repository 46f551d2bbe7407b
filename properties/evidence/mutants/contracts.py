"""The mutants of the contracts, of the obligations, and of the window on which they speak.

A wrong one fails on the true rules, or it assumes other premises than it did, or it says of a wrong rule something
else than the true one does: of recorded values, other promises are broken. The last needs no solver. What lemmas
promise rests on contracts alone, and no wrong rule breaks it; there wrong contracts take the place of wrong rules.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from typing import Any

from properties.claims.catalogue import CLAIMS
from properties.contracts.request import ONE_RULE
from properties.engine.explore import explore
from properties.evidence.mutants.mutant import Mutant, mutants_of, told_apart
from properties.evidence.mutants.operators import WEAKENING
from properties.evidence.mutants.rules import of_displays, of_rules, of_steps, of_velocities
from properties.evidence.mutants.texts import of_texts
from properties.evidence.mutants.trial import (
    CRASHES,
    Kill,
    ended,
    explored,
    kills_by_counts,
    kills_by_proofs,
    programs,
    replayed,
    said_by,
    told,
)
from properties.evidence.mutants.worlds import of_worlds
from properties.evidence.showing import texts
from properties.given import Given
from spec.invariants import every
from spec.number import Truth
from spec.plane import negated

CONTRACTS = ("properties.contracts.contract",)
OBLIGATIONS = (
    "properties.contracts.request",
    "properties.contracts.lemma",
    "properties.contracts.leaving",
    "properties.contracts.fitting",
    "properties.contracts.features",
    "properties.contracts.ticks",
    "properties.contracts.rows",
    "properties.contracts.families",
    "properties.contracts.steps",
    "properties.contracts.step_families",
    "properties.contracts.sweeps",
    "properties.contracts.instants",
    "properties.contracts.stretches",
    "properties.contracts.one_drive",
    "properties.contracts.batches",
    "properties.contracts.endings",
    "properties.contracts.bounces",
    "properties.contracts.reach",
    "properties.contracts.images",
    "properties.contracts.cuts",
    "properties.contracts.parting",
    "properties.contracts.rounding",
    "properties.contracts.rounded_steps",
    "properties.contracts.velocities",
    "properties.contracts.strings",
    "properties.contracts.display",
    "properties.contracts.designs",
    "properties.contracts.physics",
    "properties.worlds.window",
)
WHOLE_STEPS = (
    "seen_by",
    "steps_keep_the_invariants",
    "steps_have_mirror_images",
    "steps_may_be_split",
    "rows_keep_the_invariants",
    "neighbours_are_lawful",
    "mirror_has_the_same_facts",
    "check_same_facts",
    "facts",
    "same",
    "batches_end_where_events_lead",
    "speeds_are_kept_for_any_part",
)
"""What is about worlds of fixed shape, on which no mutants are tried."""
SPARED = ("ways_round", "at_most_round", "one_way", "take_a_margin")
"""What only has proofs come to their end, or sooner."""
COUNTED = {
    "properties.contracts.display": (
        "steps_to_land",
        "falls_end",
        "cuts_do_not_matter",
        "every_display_rule_fires",
        "nobody_drops_unseen",
        "circles_are_even",
        "before_a_pit",
        "any_tick",
        "frames_do_not_matter",
        "nobody_is_shown_rising",
    ),
    "properties.contracts.designs": (
        "designs_agree",
        "random_level",
        "designs_agree_on_random_rows",
        "same_place",
        "cost_of_a_move",
        "cost_of_a_look_up",
        "designs_cost",
        "three_cost_as_two",
        "ledges_are_left_alike",
        "play_line",
        "margins_are_for_floats",
        "walked_into",
    ),
    "properties.contracts.physics": (
        "velocity_after_a_tick",
        "rest_on_slopes",
        "friction_by_the_cosine",
        "drag_by_the_way",
        "minimum_lets_begin",
        "no_higher_through_a_valley",
        "directions",
        "any_dynamic",
        "energy_is_not_gained",
        "sums_are_followed",
        "stopping_ways",
        "drag_is_by_the_way",
        "part_is_left",
        "held_on",
        "Watched.request",
        "any_slide",
        "place",
        "invariants_hold_at_any_velocity",
    ),
}
"""What is no obligation on which mutants are tried, module by module: counts, witnesses on one level, whole rows."""
PREMISES = "other premises"
MOST_WRONG, CRASHED = 60, 3
"""On how many wrong ones it is looked for what a mutant passes over; after how many that crash no more are tried."""

Calls = Mapping[str, frozenset[str]]
"""The functions that each obligation runs."""

Caught = Mapping[str, Iterable[Kill]]
"""The kills of the mutants of the rules and of the contracts, by name of the mutant."""


def weakened(modules: Iterable[str]) -> dict[str, Mutant]:
    """All mutants of some modules by the operators that drop, widen or negate."""
    left_out = {module: (*WHOLE_STEPS, *SPARED, *COUNTED.get(module, ())) for module in modules}
    return told_apart(
        [one for module, names in left_out.items() for one in mutants_of(module, *names, operators=WEAKENING)]
    )


@cache
def of_contracts() -> dict[str, Mutant]:
    """All mutants of the contracts, by name."""
    return weakened(CONTRACTS)


@cache
def of_obligations() -> dict[str, Mutant]:
    """All mutants of the obligations and of the window, by name."""
    return weakened(OBLIGATIONS)


WRONG_ONES = (of_rules, of_steps, of_velocities, of_displays, of_worlds, of_texts, of_contracts)
"""What makes the mutants of which obligations are to notice each."""


@cache
def wrong_ones() -> dict[str, Mutant]:
    """The mutants that obligations catch, by name."""
    return {name: mutant for made in WRONG_ONES for name, mutant in made().items()}


def kills_of_contract(
    mutant: Mutant, caught: Caught, calls: Calls, premises: Mapping[str, tuple[str, ...]]
) -> tuple[Kill, ...]:
    """What catches a mutant of a contract: the first thing that does, and all lemmas, which rest on contracts alone."""
    with mutant.in_place():
        proofs = kills_by_proofs(mutant, {name: calls[name] for name in calls if rests_on_contracts(calls[name])})
        lemmas = {kill.by: kill for kill in proofs}
    first = kill_of_obligation(mutant, caught, calls, premises)
    return tuple(lemmas.values()) if first is None or first == lemmas.get(first.by) else (first, *lemmas.values())


def rests_on_contracts(functions: Iterable[str]) -> bool:
    """Whether an obligation runs no rule: contracts stand in for all of them."""
    return not any(function.startswith("rules.") for function in functions)


def kill_of_obligation(
    mutant: Mutant, caught: Caught, calls: Calls, premises: Mapping[str, tuple[str, ...]]
) -> Kill | None:
    """What catches a mutant of an obligation: the first of its kind in a fixed order."""
    mine = [name for name, functions in calls.items() if functions & mutant.reached]
    kills = [(name, kill) for name, kills in caught.items() for kill in kills if kill.by in mine and not kill.on]
    kills.sort(key=lambda told: mine.index(told[1].by))
    return disagreement(mutant, kills) or failure(mutant, mine, premises) or miscount(mutant) or leniency(mutant, kills)


def miscount(mutant: Mutant) -> Kill | None:
    """An exact count of its module that fails on the true rules with the mutant in place."""
    module = mutant.target.__module__
    mine = [claim for claim in CLAIMS if any(one.program.__module__ == module for one in claim.counts)]
    with mutant.in_place():
        return next(kills_by_counts(mine), None)


def disagreement(mutant: Mutant, kills: Iterable[tuple[str, Kill]]) -> Kill | None:
    """A recorded kill of a wrong rule or a wrong contract of which the mutant says another thing."""
    for name, kill in kills:
        if (now := said_otherwise(mutant, wrong_ones()[name], kill)) is not None:
            return Kill(kill.by, now, kill.values, name)
    return None


def said_otherwise(mutant: Mutant, wrong: Mutant, kill: Kill) -> tuple[str, ...] | None:
    """What a mutant of an obligation says is broken at the values of a kill, if that is not what was said."""
    if kill.broken == (PREMISES,) or mutant.target is wrong.target:
        return None
    with wrong.in_place(), mutant.in_place():
        now = replayed(kill.by, kill.values)
    return now if now is not None and now != kill.broken else None


def failure(mutant: Mutant, mine: Iterable[str], premises: Mapping[str, tuple[str, ...]]) -> Kill | None:
    """An obligation that fails on the true rules with the mutant in place, or assumes what it did not."""
    with mutant.in_place():
        for name in mine:
            try:
                exploration = explored(name)
            except CRASHES:
                continue
            found = exploration.outcome.counterexample
            if found is not None:
                return Kill(name, told(found.broken), texts(found.values))
            if said_by(exploration) != premises[name]:
                return Kill(name, (PREMISES,), {})
    return None


@dataclass(frozen=True)
class Noted:
    """A `Given` in which promises are noted by name, and not judged; premises are noted too, unless they are taken."""

    given: Given
    taken: bool
    premises: list[Truth] = field(default_factory=list)
    promises: dict[str, Truth] = field(default_factory=dict)

    def number(self, name: str, premise: str = "") -> Any:
        """The number of that name."""
        return self.given.number(name, premise)

    def natural(self, name: str) -> Any:
        """The whole number of that name."""
        return self.given.natural(name)

    def flag(self, name: str) -> bool:
        """The truth value of that name."""
        return self.given.flag(name)

    def assume(self, premise: Truth, name: str = "") -> None:
        """Go on only where the premise holds, or note it."""
        if self.taken:
            self.given.assume(premise, name)
        else:
            self.premises.append(premise)

    def ensure(self, name: str, promise: Truth) -> None:
        """Note a promise."""
        self.promises[name] = every([self.promises.get(name, True), promise])

    def saw(self, rule: str) -> None:
        """Note nothing: a rule fired."""


def leniency(mutant: Mutant, kills: Sequence[tuple[str, Kill]]) -> Kill | None:
    """Values at which a wrong rule or a wrong contract breaks an obligation, and the mutant says nothing of it.

    They are looked for on wrong ones that are known to break it: first on one for each set of promises that are broken,
    last on those of which only no rule applies, or two: there no promise is judged.
    """
    first: list[tuple[str, Kill]] = []
    other: list[tuple[str, Kill]] = []
    crashed, known = 0, set[tuple[str, ...]]()
    for name, kill in kills:
        if kill.broken != (PREMISES,):
            (other if kill.broken in known else first).append((name, kill))
            known.add(kill.broken)
    other.sort(key=lambda told: told[1].broken == (ONE_RULE,))
    for name, kill in [*first, *other][:MOST_WRONG]:
        try:
            with wrong_ones()[name].in_place():
                found = passed_over(mutant, kill.by)
        except CRASHES:
            crashed += 1
            if crashed == CRASHED:
                return None
            continue
        told_by = None if found is None else disagreement(mutant, [(name, found)])
        if told_by is not None:
            return told_by
    return None


def passed_over(mutant: Mutant, name: str) -> Kill | None:
    """What breaks a promise of an obligation, but not what the mutant makes of it, if anything does."""

    def program(given: Given) -> None:
        own, other = Noted(given, taken=True), Noted(given, taken=False)
        programs()[name](own)
        with mutant.in_place():
            programs()[name](other)
        for said, promise in own.promises.items():
            given.ensure(said, promise | every([*other.premises, negated(other.promises.get(said, True))]))

    with ended():
        found = explore(program).counterexample
    if found is None:
        return None
    values = texts(found.values)
    broken = replayed(name, values)
    return Kill(name, broken, values) if broken else None
