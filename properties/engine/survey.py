"""Surveys: every path of a program with what is said on it, as formulas; what of it can hold together is asked later.

A program is explored once, with nothing assumed of what may or may not be needed. Then a set of conditions excludes
that a promise is broken exactly if no path on which it is broken can meet them. The maximal sets with which it can be
broken are found as MARCO finds them (Liffiton et al. 2016): a seed that no known set explains, grown as far as it goes.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

import z3

from properties.engine.explore import Exploration, Path, Program, solver_for_reals
from properties.engine.formulas import EngineError
from properties.engine.reals import formula_of
from properties.engine.simplest import Drawn, simplest_values
from spec.number import Truth


@dataclass(frozen=True)
class Trail:
    """One path of a program: the literals that lead along it, the rules that fired, and what is said on it, by name.

    `conditions` are the names of what may be assumed; the rest of what is said are promises. `place` is that of the
    trail among those that are looked at together.
    """

    place: int
    drawn: Drawn
    literals: Sequence[z3.BoolRef]
    said: Mapping[str, z3.BoolRef]
    fired: frozenset[str]
    conditions: frozenset[str]

    @property
    def denials(self) -> dict[str, z3.BoolRef]:
        """For each promise that is not plainly kept on this trail, that it is broken."""
        promises = {name: said for name, said in self.said.items() if name not in self.conditions}
        return {name: z3.Not(said) for name, said in promises.items() if not z3.is_true(said)}

    def can_keep(self, names: Sequence[str]) -> bool:
        """Whether some conditions can hold together on this trail."""
        return can_hold(self.solver(names), [])

    def solver(self, names: Sequence[str]) -> z3.Solver:
        """A solver that knows what leads along this trail, and that all that is named holds."""
        solver = solver_for_reals()
        solver.add(*self.drawn.signs(), *self.literals, *(self.said[name] for name in names))
        return solver


class Following(Path):
    """A path that writes down what is said on it, and judges nothing."""

    def __init__(self, exploration: Exploration) -> None:
        """Start with nothing said."""
        super().__init__(exploration)
        self.said: dict[str, z3.BoolRef] = {}

    def ensure(self, name: str, promise: Truth) -> None:
        """Write down what is said."""
        self.said[name] = formula_of(promise)
        self.promises += 1


class Survey(Exploration):
    """An exploration that keeps every path on which something was said."""

    def __init__(self, program: Program) -> None:
        """Nothing is kept yet."""
        super().__init__(program)
        self.kept: list[Following] = []

    def new_path(self) -> Path:
        """A path that writes down what is said on it."""
        self.kept.append(Following(self))
        return self.kept[-1]

    def witness(self, path: Path) -> None:
        """Whether premises can be met is asked of each trail."""


def surveyed(program: Program, conditions: frozenset[str], place: int) -> Iterator[Trail]:
    """Every path of a program.

    Raises:
        EngineError: if the exploration is not exhaustive.
    """
    survey = Survey(program)
    outcome = survey.run()
    if not outcome.exhaustive:
        raise EngineError(f"the survey is not exhaustive: {outcome.open}")
    for path in survey.kept:
        if path.said:
            yield Trail(place, survey.drawn, path.literals, path.said, frozenset(path.fired), conditions)


@dataclass(frozen=True)
class Breach:
    """A promise that can be broken although some conditions hold, and the trail on which it is."""

    conditions: frozenset[str]
    promise: str
    trail: Trail

    def values(self) -> dict[str, Fraction | bool]:
        """The simplest values that keep the conditions and break the promise."""
        trail = self.trail
        kept = [trail.said[name] for name in sorted(self.conditions)]
        return simplest_values(trail.drawn, [*trail.literals, *kept, trail.denials[self.promise]])


def can_hold(solver: z3.Solver, formulas: Sequence[z3.BoolRef]) -> bool:
    """Whether formulas can hold together with what a solver knows.

    Raises:
        EngineError: if the solver does not know.
    """
    answer = solver.check(*formulas)
    if answer == z3.unknown:
        raise EngineError(f"the solver does not know: {solver.reason_unknown()}")
    return bool(answer == z3.sat)


def breaches(found: Sequence[Trail], names: Sequence[str]) -> dict[str, list[Breach]]:
    """For each promise the maximal sets of conditions with which it can be broken, each on its first trail.

    On each trail only such sets are asked for as are not part of one that is known, until there are no more.
    """
    result: dict[str, list[Breach]] = {}
    for trail in found:
        solver = trail.solver(())
        if not can_hold(solver, [z3.Or(z3.BoolVal(False), *trail.denials.values())]):
            continue
        for promise, denial in trail.denials.items():
            solver.push()
            solver.add(denial)
            result[promise] = extended(result.get(promise, []), promise, trail, solver, names)
            solver.pop()
    return {promise: known for promise, known in result.items() if known}


def extended(known: list[Breach], promise: str, trail: Trail, solver: z3.Solver, names: Sequence[str]) -> list[Breach]:
    """The known maximal sets, and those of one trail on which a solver knows that a promise is broken."""
    conditions = {name: trail.said[name] for name in names}
    for breach in known:
        solver.add(beyond(breach.conditions, conditions))
    while can_hold(solver, []):
        breach = Breach(largest(solver, conditions), promise, trail)
        known = [*(one for one in known if not one.conditions <= breach.conditions), breach]
        solver.add(beyond(breach.conditions, conditions))
    return known


def beyond(held: frozenset[str], conditions: Mapping[str, z3.BoolRef]) -> z3.BoolRef:
    """Some condition outside a set holds."""
    return z3.Or(z3.BoolVal(False), *(formula for name, formula in conditions.items() if name not in held))


def largest(solver: z3.Solver, conditions: Mapping[str, z3.BoolRef]) -> frozenset[str]:
    """The conditions that can hold together with what a solver knows, each taken if it can hold with those before it.

    So it is always the same set, and none can be added. The solver has just found a model. In a model of those taken so
    far, what holds need not be asked.
    """
    model, held = solver.model(), dict[str, z3.BoolRef]()
    for name, formula in conditions.items():
        if not z3.is_true(model.eval(formula, model_completion=True)):
            if not can_hold(solver, [*held.values(), formula]):
                continue
            model = solver.model()
        held[name] = formula
    return frozenset(held)


def firsts(found: Sequence[Trail], names: Sequence[str]) -> list[Breach]:
    """For each promise that can be broken though all that is named holds, the first trail on which it is."""
    result: dict[str, Breach] = {}
    for trail in found:
        solver = trail.solver(names)
        for promise, denial in trail.denials.items():
            if promise not in result and can_hold(solver, [denial]):
                result[promise] = Breach(frozenset(names), promise, trail)
    return [result[name] for name in sorted(result)]
