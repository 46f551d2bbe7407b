"""Numbers as a machine holds them: each sum is rounded, by an error that is any number up to a rounding.

A sum above 0 is not rounded to 0 or below, nor one below it to 0 or above, and the same sum of the same numbers is
rounded alike: so it is in all binary floats. All else is exact: comparisons, and products with a number that changes
only the sign or the exponent. A product with another known number is rounded as a sum is. A quotient is too, but by
what a rounding would be if it were divided alike: so large an error it makes when it is multiplied again. A product of
two numbers of the machine is refused.

A rounding is the unit: what is shown of it is shown of a rounding of any size, for then all numbers are as many times
larger. It knows nothing of bodies.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from properties.given import Given

WITHOUT_ERROR = (-2, -1, 0, 1, 2)
A_ROUNDING = "an error is at most a rounding, and changes no sign"


@dataclass
class Machine:
    """What holds numbers. It remembers what it has worked out, and of which numbers; `errors` counts its roundings."""

    given: Given
    errors: int = 0
    known: dict[tuple[str, int, int], tuple[Rounded, Any, Any]] = field(default_factory=dict)

    def rounded(self, exact: Any) -> Rounded:
        """The number that is held in the place of an exact result."""
        self.errors += 1
        error = self.given.number(f"error {self.errors}")
        result = exact + error - 1
        signs = ((exact >= 0) == (result >= 0)) & ((exact <= 0) == (result <= 0))
        self.given.assume((error <= 2) & signs, A_ROUNDING)
        return Rounded(self, result)

    def divided(self, one: Rounded, by: Any) -> Rounded:
        """A quotient by a known number."""
        return one if by == 1 else Rounded(self, self.rounded(one.held).held / Fraction(by))

    def sum(self, one: Any, two: Any) -> Rounded:
        """A sum; the order of the two is nothing to it."""
        one, two = sorted((one, two), key=id)
        return self.once("+", one, two, lambda: self.rounded(held(one) + held(two)))

    def difference(self, one: Any, two: Any) -> Rounded:
        """A difference; of a number and itself it is 0."""
        return self.once("-", one, two, lambda: one * 0 if one is two else self.rounded(held(one) - held(two)))

    def once(self, operation: str, one: Any, two: Any, result: Callable[[], Rounded]) -> Rounded:
        """What has been worked out before of the very same numbers is what it was."""
        at = (operation, id(one), id(two))
        if at not in self.known:
            self.known[at] = result(), one, two
        return self.known[at][0]


@dataclass(frozen=True, eq=False)
class Rounded:
    """A number that a machine holds. It is `nothing` where the program itself says that it is 0."""

    machine: Machine = field(repr=False)
    held: Any
    nothing: bool = False

    def __add__(self, other: Any) -> Any:
        if is_nothing(other):
            return self
        return other if self.nothing else self.machine.sum(self, other)

    __radd__ = __add__

    def __sub__(self, other: Any) -> Any:
        return self if is_nothing(other) else self.machine.difference(self, other)

    def __mul__(self, other: Any) -> Rounded:
        if not isinstance(other, int | Fraction):
            raise TypeError(f"a product with {other} is rounded, in a way that is not known here")
        if other == 1:
            return self
        if other not in WITHOUT_ERROR:
            return self.machine.once("*", self, other, lambda: self.machine.rounded(self.held * other))
        nothing = self.nothing or other == 0
        return self.machine.once("*", self, int(other), lambda: Rounded(self.machine, self.held * int(other), nothing))

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Rounded:
        if not isinstance(other, int | Fraction):
            raise TypeError(f"a quotient by {other} is rounded, in a way that is not known here")
        return self.machine.once("/", self, other, lambda: self.machine.divided(self, other))

    def __lt__(self, other: Any) -> Any:
        return self.held < held(other)

    def __le__(self, other: Any) -> Any:
        return self.held <= held(other)

    def __gt__(self, other: Any) -> Any:
        return self.held > held(other)

    def __ge__(self, other: Any) -> Any:
        return self.held >= held(other)

    def __eq__(self, other: object) -> Any:
        return self.held == held(other)

    __hash__ = None  # type: ignore[assignment]


def held(number: Any) -> Any:
    """What a machine holds of a number; a number that is known it holds as it is."""
    return number.held if isinstance(number, Rounded) else number


def is_nothing(number: Any) -> bool:
    """Whether the program itself says that a number is 0: then nothing is rounded when it is added."""
    return number.nothing if isinstance(number, Rounded) else isinstance(number, int) and number == 0
