"""The mutants of the world of storeys: how what is there is measured, and how bodies are moved and let down in it.

Each must have something of the bank measured otherwise than it is to be, or a property of steps fail on random storeys.
"""

from __future__ import annotations

from functools import cache

from properties.contracts.measuring import BANK
from properties.evidence.mutants.mutant import Mutant, mutants_of, told_apart
from properties.evidence.mutants.trial import CRASHES, Kill, ended

EDITING = ("StoreyWorld.with_place", "StoreyWorld.without", "StoreyWorld.in_terrain", "StoreyWorld.at_one_place")
MEASURED, MEASURE, WRONG = "count: counts/storeys-are-measured", "measure", "it is measured wrongly"


@cache
def of_worlds() -> dict[str, Mutant]:
    """All mutants of the world of storeys, by name."""
    return told_apart(list(mutants_of("reference.storeys", *EDITING)))


def measured_otherwise(name: str) -> tuple[str, ...] | None:
    """Whether something of the bank is measured otherwise than it is to be; None if that crashes, or does not end."""
    one = next(one for one in BANK if one.name == name)
    try:
        with ended():
            return () if one.is_right() else (WRONG,)
    except CRASHES:
        return None


def kill_by_measures() -> Kill | None:
    """The first of the bank that is measured wrongly with a mutant in place."""
    return next((Kill(MEASURED, (WRONG,), {MEASURE: one.name}) for one in BANK if measured_otherwise(one.name)), None)
