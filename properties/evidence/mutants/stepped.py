"""The mutants of the invariants of steps: each must judge some step of the bank otherwise than it is to be judged.

Numbers of the bank are exact, so that tolerances are 0, and are not changed.
"""

from __future__ import annotations

from functools import cache

from properties.contracts.judging_steps import Invented, bank, misjudged
from properties.evidence.mutants.mutant import Mutant, mutants_of, told_apart
from properties.evidence.mutants.operators import EXACT
from properties.evidence.mutants.trial import CRASHES, CRASHING, Kill

BANK_OF_STEPS, STEP = "count: counts/step-invariants-judge", "step"


@cache
def of_judges() -> dict[str, Mutant]:
    """All mutants of the invariants of steps, by name."""
    return told_apart(list(mutants_of("spec.stepped", operators=EXACT)))


@cache
def steps() -> dict[str, Invented]:
    """The steps of the bank, by name."""
    return {one.name: one for one in bank()}


def judged_otherwise(name: str) -> tuple[str, ...] | None:
    """The invariants that judge a step of the bank otherwise than they are to; None if that crashes."""
    try:
        return misjudged(steps()[name])
    except CRASHES:
        return None


def kill_of_judge(mutant: Mutant) -> Kill | None:
    """The first step of the bank that a mutant of the invariants misjudges."""
    with mutant.in_place():
        told = ((name, judged_otherwise(name)) for name in steps())
        return next((Kill(BANK_OF_STEPS, wrong, {STEP: name}) for name, wrong in told if wrong), None)


def crash_of_judge(mutant: Mutant) -> str | None:
    """The first step of the bank of which a mutant of the invariants cannot tell."""
    with mutant.in_place():
        crashed = next((name for name in steps() if judged_otherwise(name) is None), None)
    return None if crashed is None else f"{CRASHING}: {crashed}"
