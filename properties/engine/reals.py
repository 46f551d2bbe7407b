"""Symbolic numbers and truths. A truth that is asked for a Boolean decides the path of the run.

A number is a sum of variables with exact coefficients; it becomes a term of the solver only where it is compared.
A comparison is kept in one form, however it was written, so that what was asked before is known again.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from contextvars import ContextVar
from fractions import Fraction
from functools import lru_cache
from typing import Any

import z3

from properties.engine.formulas import conjunction, disjunction, opposite

DECIDE: ContextVar[Callable[[z3.BoolRef], bool]] = ContextVar("decide")

Variable = tuple[str, bool]
"""The name of a variable, and whether it is a whole number."""


Known = int | Fraction
"""A number that is known exactly. Whole ones are added faster."""


def known(number: Any) -> Known:
    """A number at its exact value, as a whole one if it is one."""
    if isinstance(number, int):
        return number
    exact = number if isinstance(number, Fraction) else Fraction(number)
    return exact.numerator if exact.denominator == 1 else exact


class SymbolicTruth:
    """A formula, or the opposite of one. `bool()` of it forks the run; `&` and `|` do not."""

    __slots__ = ("atom", "negative")
    __hash__ = None  # type: ignore[assignment]

    def __init__(self, atom: z3.BoolRef, negative: bool = False) -> None:
        self.atom, self.negative = atom, negative

    @property
    def formula(self) -> z3.BoolRef:
        """The formula as a whole."""
        return opposite(self.atom) if self.negative else self.atom

    def __bool__(self) -> bool:
        return DECIDE.get()(self.atom) != self.negative

    def __and__(self, other: Any) -> Any:
        if isinstance(other, bool):
            return self if other else False
        return SymbolicTruth(conjunction(self.formula, formula_of(other)))

    __rand__ = __and__

    def __or__(self, other: Any) -> Any:
        if isinstance(other, bool):
            return True if other else self
        return SymbolicTruth(disjunction(self.formula, formula_of(other)))

    __ror__ = __or__

    def __eq__(self, other: object) -> Any:
        if isinstance(other, bool):
            return self if other else negated(self)
        return SymbolicTruth(self.formula == formula_of(other))


def formula_of(truth: object) -> z3.BoolRef:
    """The formula of a truth, symbolic or not."""
    return truth.formula if isinstance(truth, SymbolicTruth) else z3.BoolVal(bool(truth))


@lru_cache(maxsize=100_000)
def compared(parts: tuple[tuple[Variable, Known], ...], constant: Known, relation: str) -> z3.BoolRef:
    """The formula that a sum is less than 0 (`<`), at most 0 (`<=`) or 0 (`==`)."""
    total = sum_of(parts, constant)
    formula = {"<": total < 0, "<=": total <= 0, "==": total == 0}[relation]
    return z3.simplify(formula, som=True, arith_lhs=True, sort_sums=True)


def sum_of(parts: Iterable[tuple[Variable, Known]], constant: Known) -> z3.ArithRef:
    """The solver's term of a sum."""
    terms = [variable(name) if factor == 1 else numeral(factor) * variable(name) for name, factor in parts]
    return z3.Sum([*terms, numeral(constant)])


def numeral(number: Known) -> z3.RatNumRef:
    """The solver's term of a known number."""
    return z3.RealVal(str(number))


def term_of(number: Any) -> z3.ArithRef:
    """The solver's term of a number, symbolic or not."""
    return sum_of(parted(number).parts.items(), parted(number).constant)


@lru_cache(maxsize=10_000)
def variable(name: Variable) -> z3.ArithRef:
    """The solver's variable, as a real."""
    return z3.ToReal(z3.Int(name[0])) if name[1] else z3.Real(name[0])


class Symbolic:
    """A symbolic real or whole number, linear in its variables. `==` gives a formula, never a structural comparison.

    Floats are taken at their exact binary value.
    """

    __slots__ = ("constant", "parts")
    __hash__ = None  # type: ignore[assignment]

    def __init__(self, parts: dict[Variable, Known], constant: Known) -> None:
        self.parts, self.constant = parts, constant

    @classmethod
    def of(cls, name: str, whole: bool = False) -> Symbolic:
        """The variable of a name."""
        return cls({(name, whole): 1}, 0)

    def plus(self, other: Any, sign: int) -> Symbolic:
        """The sum with another number, or with the opposite of one."""
        if not isinstance(other, Symbolic):
            return Symbolic(self.parts, self.constant + known(other) * sign)
        parts = dict(self.parts)
        for name, share in other.parts.items():
            signed = share if sign > 0 else -share
            total = parts[name] + signed if name in parts else signed
            if total:
                parts[name] = total
            else:
                del parts[name]
        return Symbolic(parts, self.constant + other.constant * sign)

    def __add__(self, other: Any) -> Symbolic:
        return self.plus(other, 1)

    __radd__ = __add__

    def __sub__(self, other: Any) -> Symbolic:
        return self.plus(other, -1)

    def __rsub__(self, other: Any) -> Symbolic:
        return (self * -1).plus(other, 1)

    def __mul__(self, other: Any) -> Symbolic:
        """The product with a known number; a product of two unknown ones is not linear, and is refused."""
        if isinstance(other, Symbolic):
            if other.parts:
                raise TypeError("a product of symbolic numbers is not linear")
            other = other.constant
        if not other:
            return Symbolic({}, 0)
        factor = known(other)
        return Symbolic({name: share * factor for name, share in self.parts.items()}, self.constant * factor)

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Symbolic:
        """The quotient by a known number; one by an unknown number is not linear, and is refused."""
        divisor = parted(other)
        if divisor.parts:
            raise TypeError("a quotient by a symbolic number is not linear")
        return self * (1 / Fraction(divisor.constant))

    def compare(self, other: Any, relation: str) -> Any:
        """Whether the difference is in a relation to 0: a plain Boolean where no variable is left in it."""
        difference = self.plus(other, -1)
        if not difference.parts:
            left = difference.constant
            return {"<": left < 0, "<=": left <= 0, "==": left == 0}[relation]
        parts = sorted(difference.parts.items())
        first, constant = parts[0][1], difference.constant
        turned = first < 0 and relation != "=="
        if first != 1:
            scale = first if first == -1 else 1 / Fraction(first)
            parts, constant = [(name, share * scale) for name, share in parts], constant * scale
        if turned:
            relation = "<=" if relation == "<" else "<"
        formula = compared(tuple(parts), constant, relation)
        return SymbolicTruth(formula, negative=turned)

    def __lt__(self, other: Any) -> Any:
        return self.compare(other, "<")

    def __le__(self, other: Any) -> Any:
        return self.compare(other, "<=")

    def __gt__(self, other: Any) -> Any:
        return negated(self.compare(other, "<="))

    def __ge__(self, other: Any) -> Any:
        return negated(self.compare(other, "<"))

    def __eq__(self, other: object) -> Any:
        return self.compare(other, "==")

    def __ne__(self, other: object) -> Any:
        return negated(self.compare(other, "=="))


def parted(number: Any) -> Symbolic:
    """A number as a sum, symbolic or not."""
    return number if isinstance(number, Symbolic) else Symbolic({}, known(number))


def negated(truth: Any) -> Any:
    """The opposite of a truth, without deciding it."""
    return SymbolicTruth(truth.atom, not truth.negative) if isinstance(truth, SymbolicTruth) else not truth
