"""Steps on storeys, as the invariants see them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from reference.simulator import Endless
from reference.storeys import StoreyWorld
from spec.rule import AnyRule, Chooser
from spec.rules.settle import Footing
from spec.rules.step import StepRules, step
from spec.stepped import Course, Stretch
from spec.storeys import Drive

MOST_INSTANTS = 300


def drive(
    rules: StepRules, world: StoreyWorld[Any], drives: Mapping[int, Drive[Any]], duration: Any, tolerance: Any
) -> Course[Any]:
    """Drive the bodies of a copy of a world for a time; return what came of it.

    Raises:
        Endless: if something comes at more instants than any test should see.
    """
    held, stretches = world.copy(), []
    before = world
    for moment in step(rules, held, drives, duration):
        after = held.copy()
        stretches.append(Stretch(before, after, moment.moved, moment.velocities, drives, tolerance))
        before = after
        if len(stretches) > MOST_INSTANTS:
            raise Endless(f"expected a step that ends, it has more than {MOST_INSTANTS} instants")
    return Course(tuple(stretches))


@dataclass
class Ties:
    """Notes whether a body that looks for a top, and had not moved on what it lost, is over two of them equally."""

    any: bool = False

    def watch(self, family: Chooser) -> Chooser:
        """The family, watched."""
        return Tied(family, self)


@dataclass(frozen=True)
class Tied:
    """A family whose situations are looked through for ties."""

    family: Chooser
    ties: Ties

    def choose(self, facts: Any) -> AnyRule:
        """Return the rule that applies."""
        if isinstance(facts, Footing) and not facts.motion and facts.tops:
            most = max(top.overlap for top in facts.tops)
            self.ties.any |= len({top.body for top in facts.tops if top.overlap == most}) > 1
        return self.family.choose(facts)
