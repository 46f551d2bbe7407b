"""A step in numbers that are known nearly: what else of it is in doubt than comparisons of the same two values.

Velocities are known exactly, but for those that are sums. Where two bodies look for their supports at distances that
happen to be the same, a machine may have rounded them otherwise; and so it may have two times that are the same.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import cycle
from typing import Any

from properties.engine.ties import TIES, Near, value_of
from reference.storeys import StoreyWorld
from spec.number import Truth
from spec.rule import AnyRule, Chooser
from spec.rules.event import Nearing
from spec.rules.step import Moment, StepRules
from spec.rules.wish import Urge

NEVER = Fraction(10**100)
"""A time after the end of every step."""

EVENTS_APART = 2**10
"""As many events in a row are told apart, all of them by less than this part of the tolerance."""

Signs = dict[tuple[Fraction, Fraction], frozenset[int]]


class EachByItself(StoreyWorld[Any]):
    """Storeys on which ties are broken for each body by itself when it looks for its support."""

    signs: dict[int, Signs]

    def copy(self) -> EachByItself:
        """An independent copy, of which no tie is broken yet."""
        return each_by_itself(self)

    def grounded(self, body: int) -> Truth:
        """Whether a body is over the ground of its storey."""
        with self.by_itself(body):
            return super().grounded(body)

    def tops(self, body: int) -> Sequence[int]:
        """The bodies one storey below whose tops would hold a body, from left to right."""
        with self.by_itself(body):
            return super().tops(body)

    @contextmanager
    def by_itself(self, body: int) -> Iterator[None]:
        """Break ties as they were broken for a body."""
        token = TIES.set(replace(TIES.get(), signs=self.signs.setdefault(body, {})))
        try:
            yield
        finally:
            TIES.reset(token)


def each_by_itself(world: StoreyWorld[Any]) -> EachByItself:
    """The same storeys, with ties broken for each body by itself."""
    other = EachByItself(world.terrain, world.margin, ())
    other.places, other.rows = list(world.places), {storey: list(row) for storey, row in world.rows.items()}
    other.signs = {}
    return other


def with_known_speeds(moment: Moment[Any]) -> Moment[Any]:
    """An instant with the exact values of its velocities."""
    return replace(moment, velocities={body: value_of(speed) for body, speed in moment.velocities.items()})


def with_rounded_sums(rules: StepRules) -> StepRules:
    """The rules with wishes that are known nearly where they are sums."""
    coming = {name: Coming(getattr(rules, name)) for name in ("contact", "wall", "loss")}
    return replace(rules, wish=Summed(rules.wish), **coming)


@dataclass(frozen=True)
class Summed:
    """A family of wishes: one that is a sum of two velocities, neither of which is 0, is rounded."""

    family: Chooser

    def choose(self, facts: Urge[Any]) -> AnyRule:
        """Return the rule that applies."""
        rule = self.family.choose(facts)
        if not facts.drive.relative or not value_of(facts.carried):
            return rule
        return replace(
            rule, effect=lambda urge: Near(value_of(rule.effect(urge))) if urge.drive.speed else urge.carried
        )


@dataclass(frozen=True)
class Coming:
    """A family of what comes: with a rounded speed that is taken to come nearer, and does not, it never comes."""

    family: Chooser

    def choose(self, facts: Nearing[Any]) -> AnyRule:
        """Return the rule that applies."""
        rule = self.family.choose(facts)
        return rule if value_of(facts.speed) > 0 else replace(rule, effect=lambda nearing: Near(NEVER))


def told_apart(rules: StepRules, tolerance: Fraction) -> StepRules:
    """The rules with events of which no two come at one instant."""
    counted, by = cycle(range(EVENTS_APART)), tolerance / EVENTS_APART**2
    later = {name: Later(getattr(rules, name), by, counted) for name in ("contact", "wall", "loss")}
    return replace(rules, **later)


@dataclass(frozen=True)
class Later:
    """A family of what comes: each a little later than its rule says, by as many times a number as are counted."""

    family: Chooser
    by: Fraction
    counted: Iterator[int]

    def choose(self, facts: Nearing[Any]) -> AnyRule:
        """Return the rule that applies."""
        rule, late = self.family.choose(facts), self.by * next(self.counted)
        return replace(rule, effect=lambda nearing: rule.effect(nearing) + late)
