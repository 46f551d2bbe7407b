"""The mutants of the invariants of steps: each must condemn a right step of some world, or let a wrong one pass.

Right steps are those of the rules on random storeys, wrong ones those of the recorded mutants of rules and worlds. All
numbers are exact, so that tolerances are 0, and are not changed.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from functools import cache

from properties.evidence.mutants.contracts import wrong_one
from properties.evidence.mutants.mutant import Mutant, mutants_of, told_apart
from properties.evidence.mutants.operators import EXACT
from properties.evidence.mutants.outings import STEPPED, WORLD, broken_in, kill_in, kills_by_storeys
from properties.evidence.mutants.trial import Kill

MOST_WRONG = 60
"""How many wrong steps are tried for each property."""


@cache
def of_judges() -> dict[str, Mutant]:
    """All mutants of the invariants of steps, by name."""
    return told_apart(list(mutants_of("spec.stepped", operators=EXACT)))


def kill_of_judge(mutant: Mutant, caught: Mapping[str, Iterable[Kill]]) -> Kill | None:
    """The first step of which a mutant of the invariants says something else than they do."""
    with mutant.in_place():
        alarm = next(kills_by_storeys(first=True), None)
    return alarm or silence(mutant, caught)


def silence(mutant: Mutant, caught: Mapping[str, Iterable[Kill]]) -> Kill | None:
    """A wrong step that breaks a property, and with a mutant of the invariants in place does not."""
    tried: Counter[str] = Counter()
    for wrong, kill in ((name, kill) for name, kills in caught.items() for kill in kills):
        if kill.by.startswith(STEPPED) and tried[kill.by] < MOST_WRONG:
            tried[kill.by] += 1
            number, (name,) = int(str(kill.values[WORLD])), kill.broken
            with wrong_one(wrong).in_place(), mutant.in_place():
                broken = broken_in(number)
            if broken is not None and name not in broken:
                return kill_in(number, name, still=False, on=wrong)
    return None
