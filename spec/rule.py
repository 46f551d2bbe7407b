"""What a rule is: a guard of named conjuncts and an effect, one small pure function each."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Generic, Protocol, TypeVar

from spec.number import Truth

Facts = TypeVar("Facts", contravariant=True)
Result = TypeVar("Result", covariant=True)


class GuardError(Exception):
    """Not exactly one rule of a family applies: the family is not a partition of its situations."""


@dataclass(frozen=True)
class Rule(Generic[Facts, Result]):
    """One rule of movement.

    `guard` is a tuple of predicates on the facts of a situation; the name of each function is the name of
    the conjunct. `effect` maps the facts to what the rule does. `sentence` is normative, `source` names the
    section of the thesis and the rows of the register. `event` is what has happened to the body when the rule has
    fired, in one word, if it is more than that it moves or stays.
    """

    id: str
    sentence: str
    source: str
    guard: tuple[Callable[[Facts], Truth], ...]
    effect: Callable[[Facts], Result]
    event: str | None = None

    kind = "rule"

    def applies(self, facts: Facts) -> bool:
        """Whether every conjunct of the guard holds."""
        return all(conjunct(facts) for conjunct in self.guard)


@dataclass(frozen=True)
class Family(Generic[Facts, Result]):
    """Rules of which exactly one applies in every situation they are asked about."""

    id: str
    rules: tuple[Rule[Facts, Result], ...]

    def choose(self, facts: Facts) -> Rule[Facts, Result]:
        """Return the only rule that applies.

        Raises:
            GuardError: if none applies, or more than one.
        """
        applying = [rule for rule in self.rules if rule.applies(facts)]
        if len(applying) != 1:
            raise GuardError(f"{self.id}: {[rule.id for rule in applying] or 'no rule'} applies")
        return applying[0]


AnyRule = Rule[Any, Any]
AnyFamily = Family[Any, Any]


class Chooser(Protocol):
    """Whatever chooses the rule for a situation: a family, or one that writes down what it chose."""

    def choose(self, facts: Any, /) -> AnyRule:
        """Return the only rule that applies."""
