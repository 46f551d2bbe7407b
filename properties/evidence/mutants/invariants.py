"""The mutants of the invariants: each must judge some deed of the bank otherwise than it is to be judged."""

from __future__ import annotations

from functools import cache

from properties.evidence.mutants.mutant import Mutant, mutants_of, told_apart

JUDGES = ("spec.invariants", "spec.plane")


@cache
def of_invariants() -> dict[str, Mutant]:
    """All mutants of the invariants, by name."""
    return told_apart([mutant for module in JUDGES for mutant in mutants_of(module)])
