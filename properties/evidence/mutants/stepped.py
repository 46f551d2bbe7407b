"""The mutants of the invariants of steps: each must condemn a right step of some world, or let a wrong one pass.

Right steps are those of the rules on random storeys, wrong ones those of the recorded mutants of rules and worlds. All
numbers are exact, so that tolerances are 0, and are not changed.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import replace
from functools import cache
from typing import Any

from properties.evidence.mutants.contracts import wrong_one
from properties.evidence.mutants.mutant import Mutant, mutants_of, told_apart
from properties.evidence.mutants.operators import EXACT
from properties.evidence.mutants.outings import STEPPED, course_in, kill_in, number_of
from properties.evidence.mutants.trial import CRASHES, Kill
from spec.stepped import OF_ONE_STEP, Course, StepInvariant

RIGHT, MOST_WRONG = 40, 30
"""How many right steps are tried; and how many wrong ones for each property."""
JUDGES = {f"{STEPPED}{one.id}": one for one in OF_ONE_STEP}


@cache
def of_judges() -> dict[str, Mutant]:
    """All mutants of the invariants of steps, by name."""
    return told_apart(list(mutants_of("spec.stepped", operators=EXACT)))


@cache
def right_step(number: int) -> Course[Any] | None:
    """What the rules make of the world of a number."""
    return course_in(number)


@cache
def wrong_step(wrong: str, number: int) -> Course[Any] | None:
    """What a mutant of the rules or the worlds makes of the world of a number."""
    with wrong_one(wrong).in_place():
        return course_in(number)


def kept(invariant: StepInvariant, course: Course[Any]) -> bool | None:
    """Whether an invariant holds of a step, judged anew; None if that crashes."""
    try:
        return bool(invariant.holds(Course(tuple(replace(one) for one in course.stretches))))
    except CRASHES:
        return None


def kill_of_judge(mutant: Mutant, caught: Mapping[str, Iterable[Kill]]) -> Kill | None:
    """The first step of which a mutant of the invariants says something else than they do."""
    return alarm(mutant) or silence(mutant, caught)


def alarm(mutant: Mutant) -> Kill | None:
    """A right step that a mutant of the invariants condemns."""
    for number in range(RIGHT):
        course = right_step(number)
        if course is not None:
            with mutant.in_place():
                condemning = [one.id for one in OF_ONE_STEP if kept(one, course) is False]
            if condemning:
                return kill_in(number, condemning[0])
    return None


def silence(mutant: Mutant, caught: Mapping[str, Iterable[Kill]]) -> Kill | None:
    """A wrong step that breaks an invariant, and with a mutant of the invariants in place does not."""
    tried: Counter[str] = Counter()
    for wrong, kill in ((name, kill) for name, kills in caught.items() for kill in kills):
        if kill.by in JUDGES and tried[kill.by] < MOST_WRONG:
            tried[kill.by] += 1
            course = wrong_step(wrong, number_of(kill))
            if course is not None:
                with wrong_one(wrong).in_place(), mutant.in_place():
                    passes = kept(JUDGES[kill.by], course)
                if passes:
                    return replace(kill, broken=(), on=wrong)
    return None
