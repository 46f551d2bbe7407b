"""Features (8): falls, collisions and width, each of which a profile can do without."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from itertools import permutations
from typing import Any

from spec.invariants import Deed, Invariant, every
from spec.number import N, Truth, zero_like
from spec.plane import negated
from spec.rule import AnyFamily, AnyRule, Family, Rule
from spec.rules.clearance import whole_stride
from spec.rules.leave import LEAVE, Departure
from spec.rules.request import Rules
from spec.rules.walk import (
    WALK,
    Motion,
    Step,
    beyond_the_end,
    exceeds_edge,
    ledge_follows,
    move_to_the_end,
    reaches_the_end,
    stop_after,
    way_open,
)
from spec.world import P


@dataclass(frozen=True)
class Widths:
    """Which widths bodies have, in numbers that may be off by so much, and what is expected where one has another."""

    has: Callable[[Any, Any], Truth]
    expected: str


@dataclass(frozen=True)
class Feature:
    """A feature: its sentence, its source, and what becomes of the rules without it.

    Attributes:
        not_asked: the IDs of what means nothing without it: invariants and unsupported cases.
        widths: those that bodies have without it, if they are not any.
    """

    id: str
    sentence: str
    source: str
    off: Callable[[Rules], Rules]
    not_asked: frozenset[str] = frozenset()
    widths: Widths | None = None

    kind = "feature"

    @property
    def name(self) -> str:
        """Its name, as it stands in that of a profile."""
        return self.id.removeprefix("feature/")


def more_than_nothing(width: N, off: N) -> Truth:
    """Bodies are wider than nothing."""
    return width > zero_like(width)


def nothing(width: N, off: N) -> Truth:
    """Bodies are points: their borders are in one place, but for what roundings make of that."""
    return (width <= off) & (width * -1 <= off)  # type: ignore[no-any-return]


WIDE = Widths(more_than_nothing, "expected the left border to be left of the right border")
POINTS = Widths(nothing, "expected both borders at one place, and on no ring: under this profile bodies have no width")


class Unobstructed(Family[Departure[Any, Any], Any]):
    """Rules of leaving an edge where no jump edge counts."""

    def choose(self, facts: Departure[Any, Any]) -> AnyRule:
        """Return the only rule that applies where no jump edge is near."""
        return super().choose(replace(facts, near=()))


def some_of(family: Family[Any, Any], *names: str) -> tuple[AnyRule, ...]:
    """Those rules of a family that have these names."""
    return tuple(rule for rule in family.rules if rule.id.rpartition("/")[2] in names)


def stand_still(step: Step[N, P]) -> Motion[N, P]:
    """Stay where the motion began."""
    return stop_after(zero_like(step.reach), step.motion.at, step.motion)


WALLED: AnyFamily = Family(
    "walk",
    (
        *some_of(WALK, "along", "onward", "wall", "in-wall", "blocked"),
        Rule(
            id="walk/at-ledge",
            sentence="Without falls a ledge is a wall: the move ends at the end of the edge.",
            source="8.0.1; E8",
            guard=(way_open, exceeds_edge, ledge_follows, reaches_the_end),
            effect=move_to_the_end,
            event="wall",
        ),
        Rule(
            id="walk/beyond-ledge",
            sentence="Without falls a border that began in overhang goes no further.",
            source="8.0.1; E8",
            guard=(way_open, exceeds_edge, ledge_follows, beyond_the_end),
            effect=stand_still,
            event="wall",
        ),
    ),
)

FREE: AnyFamily = Family(
    "clearance",
    (
        Rule(
            id="clearance/free",
            sentence="Without collisions nobody is in the way: the whole stride is free.",
            source="8.0.1; E8",
            guard=(),
            effect=whole_stride,
        ),
    ),
)


def without_falls(rules: Rules) -> Rules:
    """No border goes beyond a ledge, so that nobody falls or jumps."""
    return replace(rules, walk=WALLED, leave=Family("leave", some_of(LEAVE, "stay")))


def without_collisions(rules: Rules) -> Rules:
    """Nobody sees another body, nor a jump edge to its top."""
    return replace(rules, clearance=FREE, leave=Unobstructed("leave", some_of(LEAVE, "stay", "fall", "nowhere")))


def unchanged(rules: Rules) -> Rules:
    """The same rules."""
    return rules


FALLS = Feature(
    "feature/falls",
    "Bodies fall down fall edges. Without, a ledge is a wall, and nobody falls or jumps.",
    "8, 8.0.1; E8, R3",
    without_falls,
)
COLLISIONS = Feature(
    "feature/collisions",
    "Bodies collide. Without, they walk through each other, and do not jump onto each other.",
    "8, 8.0.1; E8, R3",
    without_collisions,
    frozenset(
        {"invariant/no-overlap", "invariant/plane-apart", "invariant/plane-margin", "unsupported/fall-onto-middle"}
    ),
)
WIDTH = Feature(
    "feature/width",
    "Bodies have a width. Without, both borders of a body are at one place.",
    "8, 8.0.1; E8, E15",
    unchanged,
    widths=POINTS,
)


def plane_order(deed: Deed[Any]) -> Truth:
    """Whoever was on the left of another is still not on its right."""
    before, after = places(deed.before), places(deed.after)
    pairs = permutations(range(len(before)), 2)
    return every(negated(before[one] < before[other]) | (after[one] <= after[other]) for one, other in pairs)


def places(world: Any) -> list[Any]:
    """Where in the plane the left borders of all bodies are."""
    return [world.point(held.left)[0] for held in world.bodies]


PLANE_ORDER = Invariant(
    "invariant/plane-order",
    "In a single layer, no request changes the order of bodies from left to right.",
    "8.0.1; E15",
    plane_order,
)

FEATURES: tuple[Feature, ...] = (COLLISIONS, FALLS, WIDTH)
"""In the order in which they are taken away: without falls there is nothing left to leave an edge by."""
