"""Numbers of an ordered field, as far as the rules of movement use them.

The same rules run on `fractions.Fraction` (exact), on `float` (as a game does) and on symbolic reals (as a
proof does). They add, subtract, multiply by a direction and compare; a step also multiplies speeds by times, and
divides distances by speeds that are not 0. Velocities are also added to, and divided by, whole numbers.
"""

from __future__ import annotations

from typing import Any, Protocol, Self, TypeVar


class Truth(Protocol):
    """The outcome of a comparison: a Boolean, or a formula whose `__bool__` decides a path."""

    def __bool__(self) -> bool: ...
    def __and__(self, other: Any, /) -> Any: ...
    def __or__(self, other: Any, /) -> Any: ...


class Number(Protocol):
    """An element of an ordered field."""

    def __add__(self, other: Self | int, /) -> Self: ...
    def __sub__(self, other: Self, /) -> Self: ...
    def __mul__(self, other: Self | int, /) -> Self: ...
    def __truediv__(self, other: Self | int, /) -> Self: ...
    def __lt__(self, other: Self, /) -> Truth: ...
    def __le__(self, other: Self, /) -> Truth: ...
    def __gt__(self, other: Self, /) -> Truth: ...
    def __ge__(self, other: Self, /) -> Truth: ...


N = TypeVar("N", bound=Number)


def lesser(a: N, b: N) -> N:
    """The smaller of two numbers."""
    return a if a <= b else b


def greater(a: N, b: N) -> N:
    """The larger of two numbers."""
    return a if a >= b else b


def zero_like(number: N) -> N:
    """Zero, of the same kind as `number`."""
    return number * 0
