"""Explorations that judge nothing: all paths of a program, and what holds at the end of each, to be asked later."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

import z3

from properties.engine.explore import Exploration, Path, solver_for_reals
from properties.engine.reals import formula_of
from properties.engine.simplest import Drawn, simplest_values
from properties.given import Given
from spec.number import Truth

Marks = Mapping[str, Truth]
"""What a program says at the end of a path, by name."""


class Undecided(Exception):
    """The solver does not know whether something can be, or the paths are too many."""


@dataclass(frozen=True)
class Place:
    """The end of a path: what holds of the values there, and what the program says of them."""

    literals: tuple[z3.BoolRef, ...]
    marks: Mapping[str, z3.BoolRef]


@dataclass
class Places:
    """The ends of all paths of a program, which together cover all values that its premises allow."""

    drawn: Drawn
    found: list[Place] = field(default_factory=list)

    def values(self, place: Place, *names: str) -> dict[str, Fraction | bool]:
        """Simple values at a place for which all that is named holds, as it can."""
        return simplest_values(self.drawn, [*place.literals, *(place.marks[name] for name in names)])

    def asker(self, place: Place) -> Asker:
        """Whoever can be asked what can be at a place."""
        return Asker(self, place)


class Asker:
    """Answers whether marks can hold together at a place."""

    def __init__(self, places: Places, place: Place) -> None:
        """Go to the place."""
        self.place, self.solver = place, solver_for_reals()
        self.solver.add(*places.drawn.signs(), *place.literals)

    def can(self, *names: str) -> bool:
        """Whether all that is named can hold at once.

        Raises:
            Undecided: if the solver does not know.
        """
        answer = self.solver.check(*(self.place.marks[name] for name in names))
        if answer == z3.unknown:
            raise Undecided(f"the solver does not know of {', '.join(names)}")
        return bool(answer == z3.sat)


def collect(program: Callable[[Given], Marks]) -> Places:
    """Run a program to the end of every path.

    Raises:
        Undecided: if the solver does not know of a branch, or there are too many.
    """
    places: list[Place] = []

    def noting(given: Any) -> None:
        marks = {name: formula_of(truth) for name, truth in program(given).items()}
        path: Path = given
        places.append(Place(tuple(path.literals), marks))

    exploration = Exploration(noting)
    outcome = exploration.run()
    if outcome.open or not outcome.exhaustive:
        raise Undecided("; ".join(outcome.open) or "the paths leave values out")
    return Places(exploration.drawn, places)


def possible(place: Place, names: Iterable[str]) -> list[str]:
    """Of some marks, those that are not false as they stand."""
    return [name for name in names if not z3.is_false(place.marks[name])]


def can_vary(place: Place, name: str) -> bool:
    """Whether a mark is not true as it stands."""
    return not z3.is_true(place.marks[name])
