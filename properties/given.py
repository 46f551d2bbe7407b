"""Where a claim's values come from.

An obligation is an ordinary function of a `Given`: it draws values, assumes premises, runs the rules and
ensures what they promise. The same function is proved (values are symbolic), replayed (values are the exact
numbers of a counterexample) and sampled (values are drawn at random).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any, Protocol

from spec.number import Truth

HAS_LENGTH, HAS_WIDTH = "edges have a length", "bodies have a width"


class Infeasible(Exception):
    """The values drawn do not satisfy a premise: this run says nothing."""


class Given(Protocol):
    """A source of values, and the judge of what is assumed and ensured of them."""

    def number(self, name: str, premise: str = "") -> Any:
        """An arbitrary number, at least 0; `premise` is the ID of the condition that says so, if one does."""

    def natural(self, name: str) -> Any:
        """An arbitrary whole number, at least 0."""

    def flag(self, name: str) -> bool:
        """Either truth value."""

    def assume(self, premise: Truth, name: str = ...) -> None:
        """Go on only where the premise holds; its name is the ID of a condition, or says what is assumed."""

    def ensure(self, name: str, promise: Truth) -> None:
        """Judge a promise."""

    def saw(self, rule: str) -> None:
        """Note that a rule fired."""


@dataclass
class Exact:
    """Values that are known, as exact numbers or their text. Names not given are 0 and False."""

    values: Mapping[str, Fraction | bool | str]
    broken: list[str] = field(default_factory=list)
    promises: int = 0
    rules: set[str] = field(default_factory=set)

    def number(self, name: str, premise: str = "") -> Fraction:
        """The number of that name."""
        return Fraction(self.values.get(name, 0))

    def natural(self, name: str) -> int:
        """The whole number of that name."""
        return int(self.values.get(name, 0))

    def flag(self, name: str) -> bool:
        """The truth value of that name."""
        return bool(self.values.get(name, False))

    def assume(self, premise: Truth, name: str = "") -> None:
        """Stop where the premise does not hold."""
        if not premise:
            raise Infeasible

    def ensure(self, name: str, promise: Truth) -> None:
        """Note a promise, and whether it is broken."""
        self.promises += 1
        if not promise:
            self.broken.append(name)

    def saw(self, rule: str) -> None:
        """Note that a rule fired."""
        self.rules.add(rule)
