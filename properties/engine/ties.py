"""Numbers that are known only nearly: a comparison of two that are as good as equal may come out either way.

No solver is needed: values are known, only ties are open. A run makes choices; all runs together make all of them. It
knows nothing of bodies.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextvars import ContextVar
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any, TypeVar

T = TypeVar("T")
EITHER = frozenset((-1, 0, 1))


class TooManyWays(Exception):
    """There are more ways to go than were allowed to be looked at."""


@dataclass
class Choices:
    """The choices of one run: those of the run before up to the last that is new, then always the first option."""

    taken: list[int] = field(default_factory=list)
    options: list[int] = field(default_factory=list)
    met: int = 0

    def choose(self, options: int) -> int:
        """Choose one of so many options."""
        if self.met == len(self.taken):
            self.taken.append(0)
            self.options.append(options)
        self.met += 1
        return self.taken[self.met - 1]

    def following(self) -> Choices | None:
        """The choices of the next run; None after the last."""
        last = next((i for i in reversed(range(self.met)) if self.taken[i] + 1 < self.options[i]), None)
        if last is None:
            return None
        return Choices([*self.taken[:last], self.taken[last] + 1], self.options[: last + 1])


def every_way(run: Callable[[Choices], T], most: int) -> Iterator[T]:
    """What a run returns, for all choices that it may make.

    Raises:
        TooManyWays: if there are more than `most`.
    """
    choices: Choices | None = Choices()
    for _ in range(most):
        assert choices is not None
        yield run(choices)
        choices = choices.following()
        if choices is None:
            return
    raise TooManyWays(f"more than {most} ways")


@dataclass
class Ties:
    """How the ties of a run are broken. What was asked twice since `anew` is answered alike.

    Without a tolerance there are no ties.
    """

    tolerance: Fraction
    choices: Choices
    signs: dict[tuple[Fraction, Fraction], frozenset[int]] = field(default_factory=dict)

    def anew(self) -> None:
        """Forget what was answered: from here on other questions are asked."""
        self.signs.clear()

    def holds(self, a: Fraction, b: Fraction, signs: frozenset[int]) -> bool:
        """Whether the sign of `a - b` is one of `signs`; the exact answer is the first choice."""
        difference = a - b
        exact = ((difference > 0) - (difference < 0)) in signs
        if (not difference and a is b) or not self.tolerance or abs(difference) > self.tolerance:
            return exact
        if a < b:
            a, b, signs = b, a, frozenset(-sign for sign in signs)
        possible = self.signs.get((a, b), EITHER)
        if not possible & signs or not possible - signs:
            return bool(possible & signs)
        answer = exact == (self.choices.choose(2) == 0)
        self.signs[a, b] = possible & signs if answer else possible - signs
        return answer


TIES: ContextVar[Ties] = ContextVar("ties")


class Near:
    """A number that is known nearly. Sums and products are exact; comparisons are for the ties of the run."""

    __slots__ = ("value",)
    __hash__ = None  # type: ignore[assignment]

    def __init__(self, value: Fraction) -> None:
        self.value = value

    def __add__(self, other: Any) -> Near:
        return Near(self.value + value_of(other))

    __radd__ = __add__

    def __sub__(self, other: Any) -> Near:
        return Near(self.value - value_of(other))

    def __rsub__(self, other: Any) -> Near:
        return Near(value_of(other) - self.value)

    def __mul__(self, other: Any) -> Near:
        return Near(self.value * value_of(other))

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Near:
        return Near(self.value / value_of(other))

    def __lt__(self, other: Any) -> bool:
        return TIES.get().holds(self.value, value_of(other), frozenset((-1,)))

    def __le__(self, other: Any) -> bool:
        return TIES.get().holds(self.value, value_of(other), frozenset((-1, 0)))

    def __gt__(self, other: Any) -> bool:
        return TIES.get().holds(self.value, value_of(other), frozenset((1,)))

    def __ge__(self, other: Any) -> bool:
        return TIES.get().holds(self.value, value_of(other), frozenset((0, 1)))

    def __eq__(self, other: object) -> bool:
        return TIES.get().holds(self.value, value_of(other), frozenset((0,)))


def value_of(number: Any) -> Fraction:
    """The exact value of a number, known nearly or not."""
    return number.value if isinstance(number, Near) else Fraction(number)
