"""Symbolic numbers and truths. A truth that is asked for a Boolean decides the path of the run."""

from __future__ import annotations

from collections.abc import Callable
from contextvars import ContextVar
from fractions import Fraction
from typing import Any

import z3

DECIDE: ContextVar[Callable[[z3.BoolRef], bool]] = ContextVar("decide")


class SymbolicTruth:
    """A formula. `bool()` of it forks the run; `&` and `|` do not."""

    __slots__ = ("formula",)
    __hash__ = None  # type: ignore[assignment]

    def __init__(self, formula: z3.BoolRef) -> None:
        self.formula = formula

    def __bool__(self) -> bool:
        return DECIDE.get()(self.formula)

    def __and__(self, other: Any) -> SymbolicTruth:
        return SymbolicTruth(z3.And(self.formula, formula_of(other)))

    __rand__ = __and__

    def __or__(self, other: Any) -> SymbolicTruth:
        return SymbolicTruth(z3.Or(self.formula, formula_of(other)))

    __ror__ = __or__

    def __eq__(self, other: object) -> Any:
        return SymbolicTruth(self.formula == formula_of(other))


def formula_of(truth: object) -> z3.BoolRef:
    """The formula of a truth, symbolic or not."""
    return truth.formula if isinstance(truth, SymbolicTruth) else z3.BoolVal(bool(truth))


def term_of(number: object) -> z3.ArithRef:
    """The term of a number. Floats are taken at their exact binary value."""
    if isinstance(number, Symbolic):
        return number.term
    if isinstance(number, int):
        return z3.IntVal(number)
    if isinstance(number, Fraction | float):
        exact = Fraction(number)
        return z3.Q(exact.numerator, exact.denominator)
    raise TypeError(f"not a number: {number!r}")


class Symbolic:
    """A symbolic real or whole number. `==` gives a formula, never a structural comparison."""

    __slots__ = ("term",)
    __hash__ = None  # type: ignore[assignment]

    def __init__(self, term: z3.ArithRef) -> None:
        self.term = term

    def __add__(self, other: Any) -> Symbolic:
        return Symbolic(self.term + term_of(other))

    def __radd__(self, other: Any) -> Symbolic:
        return Symbolic(term_of(other) + self.term)

    def __sub__(self, other: Any) -> Symbolic:
        return Symbolic(self.term - term_of(other))

    def __rsub__(self, other: Any) -> Symbolic:
        return Symbolic(term_of(other) - self.term)

    def __mul__(self, other: Any) -> Symbolic:
        return Symbolic(z3.simplify(self.term * term_of(other)))

    __rmul__ = __mul__

    def __lt__(self, other: Any) -> SymbolicTruth:
        return SymbolicTruth(self.term < term_of(other))

    def __le__(self, other: Any) -> SymbolicTruth:
        return SymbolicTruth(self.term <= term_of(other))

    def __gt__(self, other: Any) -> SymbolicTruth:
        return SymbolicTruth(self.term > term_of(other))

    def __ge__(self, other: Any) -> SymbolicTruth:
        return SymbolicTruth(self.term >= term_of(other))

    def __eq__(self, other: object) -> Any:
        return SymbolicTruth(self.term == term_of(other))

    def __ne__(self, other: object) -> Any:
        return SymbolicTruth(self.term != term_of(other))
