"""Readable counterexamples: the smallest grid on which one exists, then small numbers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from fractions import Fraction

import z3

from properties.engine.formulas import EngineError

GRIDS = (1, 2, 4, 10, 100)
HALVINGS = 12
SEARCH_BUDGET = 4_000_000


@dataclass
class Drawn:
    """The values a program has drawn, by name."""

    numbers: dict[str, z3.ArithRef] = field(default_factory=dict)
    naturals: dict[str, z3.ArithRef] = field(default_factory=dict)
    flags: dict[str, z3.BoolRef] = field(default_factory=dict)

    def number(self, name: str) -> z3.ArithRef:
        """The real of that name."""
        if name not in self.numbers:
            self.numbers[name] = z3.Real(name)
        return self.numbers[name]

    def natural(self, name: str) -> z3.ArithRef:
        """The whole number of that name."""
        if name not in self.naturals:
            self.naturals[name] = z3.Int(name)
        return self.naturals[name]

    def flag(self, name: str) -> z3.BoolRef:
        """The truth value of that name."""
        if name not in self.flags:
            self.flags[name] = z3.Bool(name)
        return self.flags[name]

    def signs(self) -> list[z3.BoolRef]:
        """What holds of every number drawn: it is at least 0."""
        return [term >= 0 for term in (*self.numbers.values(), *self.naturals.values())]

    def translated(self, context: z3.Context) -> Drawn:
        """The same values in another context of the solver."""
        kinds = (self.numbers, self.naturals, self.flags)
        return Drawn(*({name: term.translate(context) for name, term in kind.items()} for kind in kinds))

    def values(self, model: z3.ModelRef) -> dict[str, Fraction | bool]:
        """The exact values of a model, those it leaves open included."""
        exact = {name: model.eval(term, model_completion=True).as_fraction() for name, term in self.numbers.items()}
        whole = {name: model.eval(term, model_completion=True).as_long() for name, term in self.naturals.items()}
        truth = {name: z3.is_true(model.eval(term, model_completion=True)) for name, term in self.flags.items()}
        return {name: Fraction(number) for name, number in {**exact, **whole}.items()} | truth


def solved(drawn: Drawn, formulas: Sequence[z3.BoolRef]) -> tuple[Drawn, z3.Solver]:
    """A solver that has found values that satisfy formulas, which some do.

    It has a context of its own, so that its values do not depend on what was solved before.

    Raises:
        EngineError: if it finds none.
    """
    context = z3.Context()
    own, solver = drawn.translated(context), z3.SolverFor("QF_LIRA", ctx=context)
    solver.set("rlimit", SEARCH_BUDGET)
    solver.add(*own.signs(), *(formula.translate(context) for formula in formulas))
    if solver.check() != z3.sat:
        raise EngineError("no values were found where there are some")
    return own, solver


def some_values(drawn: Drawn, formulas: Sequence[z3.BoolRef]) -> dict[str, Fraction | bool]:
    """Values that satisfy formulas, which some do."""
    own, solver = solved(drawn, formulas)
    return own.values(solver.model())


def simplest_values(drawn: Drawn, formulas: Sequence[z3.BoolRef]) -> dict[str, Fraction | bool]:
    """Values that satisfy formulas, which some do: on the coarsest grid that has any, then small."""
    own, solver = solved(drawn, formulas)
    best, context = solver.model(), solver.ctx
    for grid in GRIDS:
        solver.push()
        for name, term in own.numbers.items():
            solver.add(term * grid == z3.ToReal(z3.Int(f"{name} on a grid of 1/{grid}", context)))
        if solver.check() == z3.sat:
            best = smallest(solver, list(own.numbers.values()), solver.model())
            break
        solver.pop()
    return own.values(best)


def smallest(solver: z3.Solver, terms: list[z3.ArithRef], model: z3.ModelRef) -> z3.ModelRef:
    """A model in which the sum of the terms is about as small as it can be, by halving."""
    total = z3.Sum([z3.RealVal(0, solver.ctx), *terms])
    low, high = Fraction(0), Fraction(model.eval(total, model_completion=True).as_fraction())
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        if solver.check(total <= z3.Q(middle.numerator, middle.denominator, solver.ctx)) == z3.sat:
            model = solver.model()
            high = Fraction(model.eval(total, model_completion=True).as_fraction())
        else:
            low = middle
    return model
