"""Merging: a part of a program is explored where it stands, and one path goes on with what its paths returned.

Where the paths of the part return different numbers, a new variable stands for them, defined by the condition of each
path. Definitions outlive the paths on which they were made: without them, the variable could be anything.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import z3

from properties.engine.explore import Exploration, Merge, Path
from properties.engine.formulas import EngineError, ask, disjunction, opposite, references
from properties.engine.reals import Symbolic, parted, term_of
from properties.given import Given

Part = Callable[[Given], Sequence[Any]]


class PartExploration(Exploration):
    """The exploration of a part, under what holds on the path that has met it."""

    def __init__(self, path: Path, part: Part) -> None:
        """Share the solver and the outcome of the exploration around it."""
        super().__init__(self.run_part)
        self.around, self.part, self.outside = path, part, path.exploration
        self.solver, self.drawn, self.outcome = self.outside.solver, self.outside.drawn, self.outside.outcome
        self.names = self.outside.names
        self.returned: list[Sequence[Any]] = []
        self.known: dict[tuple[Any, ...], Symbolic] = {}

    def run_part(self, given: Given) -> None:
        """Run the part once."""
        self.returned.append(self.part(given))

    def new_path(self) -> Path:
        """A path that knows what was decided before the part."""
        path = Path(self)
        path.decided = dict(self.around.decided)
        return path

    def premises_so_far(self) -> dict[str, z3.BoolRef]:
        """The premises of the program around the part."""
        return dict(self.outside.premises)

    def witness(self, path: Path) -> None:
        """Premises are the whole program's, and so is the witness of them."""

    def refute(self, place: list[z3.BoolRef], promise: str, denial: z3.BoolRef) -> None:
        """A promise is broken by values of the whole program."""
        self.outside.refute([*self.definitions, *self.around.literals, *place], promise, denial)

    def check_coverage(self) -> None:
        """Make sure that the paths, none of which a premise may cut off, leave out no values that lead here."""
        if len(self.covered) != len(self.returned) or self.premises != self.outside.premises:
            raise EngineError("a part that is merged assumes something, or draws")
        elsewhere = opposite(disjunction(*self.places))
        if ask(self.solver, references([elsewhere, *self.definitions, *self.premises.values()])) != z3.unsat:
            raise EngineError("the paths of a part do not cover all values")

    def merge(self, numbers: Sequence[Any]) -> Any:
        """One number for those that the paths returned; numbers that are written alike on each path are one."""
        written = tuple((frozenset(parted(number).parts.items()), parted(number).constant) for number in numbers)
        if len(set(written)) == 1:
            return numbers[0]
        if written not in self.known:
            self.known[written] = self.defined(numbers)
        return self.known[written]

    def defined(self, numbers: Sequence[Any]) -> Symbolic:
        """A new variable, defined as the number of the path that the values take."""
        merged = Symbolic.of(f"merged {next(self.names)}")
        term = term_of(numbers[-1])
        for case, number in zip(self.places[:-1], numbers[:-1], strict=True):
            term = z3.If(case, term_of(number), term)
        self.definitions.append(term_of(merged) == term)
        return merged


def merged(given: Given, part: Part) -> list[Any]:
    """The numbers that a part of a program returns, of which it may assume nothing; on known values it just runs."""
    if not isinstance(given, Path):
        return list(part(given))
    met = (given.merges, *given.branches)
    known = given.exploration.merges
    if met not in known:
        known[met] = explored(given, part)
        given.exploration.definitions += known[met].definitions
    given.define(known[met].definitions)
    return known[met].numbers


def explored(path: Path, part: Part) -> Merge:
    """Explore a part, and merge what it returns."""
    exploration = PartExploration(path, part)
    exploration.explore_all()
    numbers = [exploration.merge(numbers) for numbers in zip(*exploration.returned, strict=True)]
    return Merge(tuple(path.literals), numbers, exploration.definitions)
