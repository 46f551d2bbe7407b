"""Display: how what has been simulated is shown. It moves no body; it shows smoothly what moves at once.

A display step takes a time. It shows the state that the simulation has come to, and knows how each body was shown
before.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, Generic

from spec.number import N, Truth
from spec.rule import AnyFamily, Chooser, Family, Rule


@dataclass(frozen=True)
class Descent(Generic[N]):
    """How high a body is shown, and how high it is (`target`), on its support as that is shown.

    `falling` says whether it is shown falling, and `by` how far it is to sink in this display step, at least 0.
    """

    shown: N
    target: N
    falling: bool
    by: N


def not_falling(descent: Descent[N]) -> Truth:
    """The body is not shown falling."""
    return not descent.falling


def falling(descent: Descent[N]) -> Truth:
    """The body is shown falling."""
    return descent.falling


def stays_above(descent: Descent[N]) -> Truth:
    """Sinking leaves it above its target."""
    return descent.shown - descent.by > descent.target


def would_pass(descent: Descent[N]) -> Truth:
    """Sinking takes it to its target or below."""
    return descent.shown - descent.by <= descent.target


def at_the_target(descent: Descent[N]) -> Descent[N]:
    """Show it at its target; it falls no more."""
    return replace(descent, shown=descent.target, falling=False)


def lower(descent: Descent[N]) -> Descent[N]:
    """Show it lower."""
    return replace(descent, shown=descent.shown - descent.by)


VERTICAL: AnyFamily = Family(
    "vertical",
    (
        Rule(
            id="display/stands",
            sentence="A body that is not shown falling is shown as high as it is.",
            source="6.4.1, 5.2; R29, R35",
            guard=(not_falling,),
            effect=at_the_target,
        ),
        Rule(
            id="display/sinks",
            sentence="A body that is shown falling keeps its height on the screen, but for what it sinks in this "
            "display step.",
            source="6.4.1; R29, R33",
            guard=(falling, stays_above),
            effect=lower,
        ),
        Rule(
            id="display/lands",
            sentence="A body that would sink to its target or below is shown at its target, and is shown falling no "
            "more.",
            source="6.4.1; R29, R33",
            guard=(falling, would_pass),
            effect=at_the_target,
        ),
    ),
)


@dataclass(frozen=True)
class Shift(Generic[N]):
    """Where a body is shown horizontally, and where it is."""

    shown: N
    target: N


def at_once(shift: Shift[N]) -> N:
    """Show it where it is."""
    return shift.target


ACROSS: AnyFamily = Family(
    "across",
    (
        Rule(
            id="display/across",
            sentence="Horizontally a body is shown where it is, at once.",
            source="6.4.1; R29",
            guard=(),
            effect=at_once,
        ),
    ),
)


@dataclass(frozen=True)
class Swing(Generic[N]):
    """The angle at which a body is shown, and that of its ground (`target`, the way round on which it is nearer).

    `turning` says whether it is shown turning, and `by` how far it is to turn in this display step, at least 0.
    """

    shown: N
    target: N
    turning: bool
    by: N


def not_turning(swing: Swing[N]) -> Truth:
    """The body is not shown turning."""
    return not swing.turning


def turning(swing: Swing[N]) -> Truth:
    """The body is shown turning."""
    return swing.turning


def stays_below(swing: Swing[N]) -> Truth:
    """Turning to the left leaves it short of its target."""
    return swing.target - swing.shown > swing.by


def not_below(swing: Swing[N]) -> Truth:
    """Turning to the left would not leave it short of its target."""
    return swing.target - swing.shown <= swing.by


def stays_beyond(swing: Swing[N]) -> Truth:
    """Turning to the right leaves it short of its target."""
    return swing.shown - swing.target > swing.by


def not_beyond(swing: Swing[N]) -> Truth:
    """Turning to the right would not leave it short of its target."""
    return swing.shown - swing.target <= swing.by


def as_its_ground(swing: Swing[N]) -> Swing[N]:
    """Show it as its ground is; it turns no more."""
    return replace(swing, shown=swing.target, turning=False)


def to_the_left(swing: Swing[N]) -> Swing[N]:
    """Show it turned further to the left."""
    return replace(swing, shown=swing.shown + swing.by)


def to_the_right(swing: Swing[N]) -> Swing[N]:
    """Show it turned further to the right."""
    return replace(swing, shown=swing.shown - swing.by)


ROTATION: AnyFamily = Family(
    "rotation",
    (
        Rule(
            id="display/upright",
            sentence="A body that is not shown turning is shown at the angle of its ground.",
            source="5.2, 2.2; R35",
            guard=(not_turning,),
            effect=as_its_ground,
        ),
        Rule(
            id="display/turns-left",
            sentence="A body that is shown turning turns to the left by the turning speed while its target is further "
            "to the left than that.",
            source="6.4.2; O10, R35",
            guard=(turning, stays_below),
            effect=to_the_left,
        ),
        Rule(
            id="display/turns-right",
            sentence="A body that is shown turning turns to the right by the turning speed while its target is further "
            "to the right than that.",
            source="6.4.2; O10, R35",
            guard=(turning, stays_beyond),
            effect=to_the_right,
        ),
        Rule(
            id="display/turned",
            sentence="A body that would turn to its target or past it is shown there, and is shown turning no more.",
            source="6.4.2; O10, R35",
            guard=(turning, not_below, not_beyond),
            effect=as_its_ground,
        ),
    ),
)

Sinking = Callable[[Any, Any, Any], Any]
"""How far a body sinks in a display step, of the times since its fall began before and after it, and the fall speed."""


def by_the_time_fallen(before: N, after: N, speed: N) -> N:
    """The time since the fall began, times the fall speed."""
    return after * speed


def fallen(time: N, speed: N) -> N:
    """How far a body has fallen in a time: its square, times the fall speed."""
    return time * time * speed


def by_the_way_fallen(before: N, after: N, speed: N) -> N:
    """What the way fallen has grown by."""
    return fallen(after, speed) - fallen(before, speed)


@dataclass(frozen=True)
class DisplayRules:
    """The families that a display step chooses from, handed along so that a record or a wrong rule can stand in."""

    vertical: Chooser
    across: Chooser
    rotation: Chooser
    sinking: Sinking

    def through(self, wrap: Callable[[Chooser], Chooser]) -> DisplayRules:
        """The same rules, each family wrapped."""
        vertical, across, rotation = map(wrap, (self.vertical, self.across, self.rotation))
        return replace(self, vertical=vertical, across=across, rotation=rotation)
