"""Velocity: what gravity, friction, drag and bounds make of it in a tick (6.3.1, figure 6.7).

Velocity is along the ground under the body, positive to the right. What is printed and what is mended are families that
differ: the normal force, the coefficient of friction, drag, and the minimum. The time of a tick and the masses are
greater than 0, coefficients and gravity at least 0.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, Generic

from spec.number import N, Truth, greater, zero_like
from spec.rule import AnyFamily, Chooser, Family, Rule


@dataclass(frozen=True)
class Slope(Generic[N]):
    """The ground under a body: how far it goes across and up, to the right, for each unit of the body's width.

    On one edge these are the cosine and the sine of its angle. `friction` is the ground's own coefficient, or None.
    """

    run: N
    rise: N
    friction: N | None = None

    @property
    def steepness(self) -> N:
        """The rise, positive where gravity accelerates to the right (6.3.2; A33, A34)."""
        return self.rise * -1


@dataclass(frozen=True)
class Material(Generic[N]):
    """What decides how the velocity of a dynamic body changes, besides its ground.

    Attributes:
        friction: its coefficient of friction; 0 for a body without a material.
        drag: as printed, the factor from 0 to 1 by which velocity is multiplied in each tick; 1 for none.
        damping: mended, how much velocity is lost for each unit of way, in 1 per second; 0 for none.
        slowest: the least speed; one that is slower stands. `fastest` is the greatest, or None if there is none.
        mass: in units of mass; the thesis has 1.
    """

    friction: N
    drag: N
    damping: N
    slowest: N
    fastest: N | None
    mass: N


@dataclass(frozen=True)
class Motion(Generic[N]):
    """How a body moves of its own, and what acts on it.

    Attributes:
        velocity: along the ground, in units of length per second, positive to the right.
        material: None for a static body.
        gravity: the gravity constant, times the body's gravity scale.
        force: along the ground, positive to the right (6.3.4; O7).
    """

    velocity: N
    material: Material[N] | None
    gravity: N
    force: N


@dataclass(frozen=True)
class VelocityRules:
    """The families from which a tick chooses how a velocity changes, handed along as those of a request are."""

    body: Chooser
    pull: Chooser
    normal: Chooser
    coefficient: Chooser
    friction: Chooser
    drag: Chooser
    fastest: Chooser
    slowest: Chooser
    after: Chooser

    def through(self, wrap: Callable[[Chooser], Chooser]) -> VelocityRules:
        """The same rules, each family wrapped."""
        return VelocityRules(**{name: wrap(getattr(self, name)) for name in VELOCITY_FAMILIES})


VELOCITY_FAMILIES = ("body", "pull", "normal", "coefficient", "friction", "drag", "fastest", "slowest", "after")


@dataclass(frozen=True)
class Turn(Generic[N]):
    """A body whose velocity is to be found, the ground under it, and the time of a tick."""

    rules: VelocityRules
    motion: Motion[N]
    slope: Slope[N]
    dt: N


@dataclass(frozen=True)
class Pull(Generic[N]):
    """A velocity, and by how much gravity and forces change it in a tick."""

    velocity: N
    gain: N


@dataclass(frozen=True)
class Weight(Generic[N]):
    """Gravity, and the ground that bears it."""

    gravity: N
    slope: Slope[N]


@dataclass(frozen=True)
class Touch(Generic[N]):
    """The coefficients of friction of a body, and of the ground if that has one."""

    body: N
    ground: N | None


@dataclass(frozen=True)
class Grip(Generic[N]):
    """A velocity, and by how much friction can lessen it in a tick."""

    velocity: N
    loss: N


@dataclass(frozen=True)
class Dragged(Generic[N]):
    """A velocity, what drags it, and the time of a tick."""

    velocity: N
    material: Material[N]
    dt: N


@dataclass(frozen=True)
class Bounded(Generic[N]):
    """A velocity, that before the tick, and a bound of its magnitude, if there is one."""

    velocity: N
    before: N
    bound: N | None


@dataclass(frozen=True)
class Moved(Generic[N]):
    """A velocity with which a body was to move, whether it did so all the way, and with which it moved in the end."""

    velocity: N
    dynamic: bool
    free: bool
    actual: N


def magnitude(number: N) -> N:
    """The number without its sign."""
    return greater(number, number * -1)


def signed(size: N, like: N) -> N:
    """A number of a size, with the sign of another."""
    return size * -1 if like < zero_like(like) else size


def is_static(turn: Turn[N]) -> Truth:
    """The body is static."""
    return turn.motion.material is None


def is_dynamic(turn: Turn[N]) -> Truth:
    """The body is dynamic."""
    return turn.motion.material is not None


def keeps_velocity(turn: Turn[N]) -> N:
    """The velocity is what it was set to."""
    return turn.motion.velocity


def forces_act(turn: Turn[N]) -> N:
    """Gravity, friction, drag, maximum, minimum, one after another."""
    rules, motion, material = turn.rules, turn.motion, turn.motion.material
    assert material is not None
    pull = Pull(motion.velocity, gain_of(motion, material, turn.slope, turn.dt))
    grip = Grip(chosen(rules.pull, pull), loss_of(rules, motion, material, turn.slope, turn.dt))
    dragged = chosen(rules.drag, Dragged(chosen(rules.friction, grip), material, turn.dt))
    bounded: N = chosen(rules.fastest, Bounded(dragged, motion.velocity, material.fastest))
    final: N = chosen(rules.slowest, Bounded(bounded, motion.velocity, material.slowest))
    return final


def gain_of(motion: Motion[N], material: Material[N], slope: Slope[N], dt: N) -> N:
    """What gravity and forces add to a velocity in a tick: steepness times gravity, and force by mass."""
    return (slope.steepness * motion.gravity + motion.force / material.mass) * dt


def loss_of(rules: VelocityRules, motion: Motion[N], material: Material[N], slope: Slope[N], dt: N) -> N:
    """What friction can take of a velocity in a tick: the coefficient times the normal force; mass cancels out."""
    coefficient: N = chosen(rules.coefficient, Touch(material.friction, slope.friction))
    normal: N = chosen(rules.normal, Weight(motion.gravity, slope))
    return normal * coefficient * dt


def chosen(family: Chooser, facts: Any) -> Any:
    """What the rule of a family does that applies."""
    return family.choose(facts).effect(facts)


def gains(pull: Pull[N]) -> N:
    """The velocity and what it gains."""
    return pull.velocity + pull.gain


def normal_printed(weight: Weight[N]) -> N:
    """Gravity less what of it is along the ground, as if that were a sum of lengths."""
    return weight.gravity - magnitude(weight.slope.steepness) * weight.gravity


def normal_by_cosine(weight: Weight[N]) -> N:
    """Gravity times the cosine of the slope."""
    return weight.slope.run * weight.gravity


def ground_has_none(touch: Touch[N]) -> Truth:
    """The ground has no coefficient of its own."""
    return touch.ground is None


def ground_has_one(touch: Touch[N]) -> Truth:
    """The ground has a coefficient of its own."""
    return touch.ground is not None


def of_the_body(touch: Touch[N]) -> N:
    """The body's own coefficient."""
    return touch.body


def mean_of_both(touch: Touch[N]) -> N:
    """The mean of the coefficients of body and ground."""
    assert touch.ground is not None
    return (touch.body + touch.ground) / 2


def outruns_friction(grip: Grip[N]) -> Truth:
    """The velocity is greater than what friction can take."""
    return magnitude(grip.velocity) > grip.loss


def held_by_friction(grip: Grip[N]) -> Truth:
    """The velocity is at most what friction can take."""
    return magnitude(grip.velocity) <= grip.loss


def slowed(grip: Grip[N]) -> N:
    """The velocity, less what friction takes of its magnitude."""
    return signed(magnitude(grip.velocity) - grip.loss, grip.velocity)


def stopped(grip: Grip[N]) -> N:
    """No velocity."""
    return zero_like(grip.velocity)


def by_a_factor(dragged: Dragged[N]) -> N:
    """The velocity times the drag, whatever the tick."""
    return dragged.velocity * dragged.material.drag


def by_the_way_made(dragged: Dragged[N]) -> N:
    """The velocity that is less than before by the damping times the way it makes in the tick."""
    return dragged.velocity / (dragged.material.damping * dragged.dt + 1)


def not_too_fast(bounded: Bounded[N]) -> Truth:
    """There is no maximum, or it is not exceeded."""
    return bounded.bound is None or magnitude(bounded.velocity) <= bounded.bound


def too_fast(bounded: Bounded[N]) -> Truth:
    """The maximum is exceeded."""
    return bounded.bound is not None and magnitude(bounded.velocity) > bounded.bound


def fast_enough(bounded: Bounded[N]) -> Truth:
    """The minimum is reached."""
    assert bounded.bound is not None
    return magnitude(bounded.velocity) >= bounded.bound


def too_slow(bounded: Bounded[N]) -> Truth:
    """The minimum is not reached."""
    assert bounded.bound is not None
    return magnitude(bounded.velocity) < bounded.bound


def slowing(bounded: Bounded[N]) -> Truth:
    """It is not faster than before the tick."""
    return magnitude(bounded.velocity) <= magnitude(bounded.before)


def speeding_up(bounded: Bounded[N]) -> Truth:
    """It is faster than before the tick."""
    return magnitude(bounded.velocity) > magnitude(bounded.before)


def as_it_is(bounded: Bounded[N]) -> N:
    """The velocity."""
    return bounded.velocity


def at_the_bound(bounded: Bounded[N]) -> N:
    """The maximum, in the direction of the velocity."""
    assert bounded.bound is not None
    return signed(bounded.bound, bounded.velocity)


def standing(bounded: Bounded[N]) -> N:
    """No velocity."""
    return zero_like(bounded.velocity)


def static_or_free(moved: Moved[N]) -> Truth:
    """It is static, or moved all the way."""
    return moved.free or not moved.dynamic


def was_hindered(moved: Moved[N]) -> Truth:
    """It is dynamic, and did not move all the way."""
    return moved.dynamic and not moved.free


def as_meant(moved: Moved[N]) -> N:
    """The velocity with which it was to move."""
    return moved.velocity


def as_moved(moved: Moved[N]) -> N:
    """The velocity with which it moved in the end."""
    return moved.actual


BODY: AnyFamily = Family(
    "body",
    (
        Rule(
            id="velocity/static",
            sentence="A static body has the velocity that is set: no gravity, friction, drag or bound changes it.",
            source="6.3.1; R26, A40",
            guard=(is_static,),
            effect=keeps_velocity,
        ),
        Rule(
            id="velocity/dynamic",
            sentence="In each tick the velocity of a dynamic body is changed by gravity, then friction, then drag, "
            "then the maximum, then the minimum.",
            source="6.3.1, F6.7; R10, R26, R27, A36",
            guard=(is_dynamic,),
            effect=forces_act,
        ),
    ),
)

PULL: AnyFamily = Family(
    "pull",
    (
        Rule(
            id="velocity/gravity",
            sentence="Gravity adds to the velocity the steepness times the gravity constant times the tick; a force "
            "adds its share of the mass times the tick.",
            source="F6.7, 6.3.4; R28, A34, O7",
            guard=(),
            effect=gains,
        ),
    ),
)

NORMAL_PRINTED: AnyFamily = Family(
    "normal",
    (
        Rule(
            id="velocity/normal-printed",
            sentence="The normal force is gravity times 1 less the magnitude of the steepness.",
            source="F6.7; R28, P1",
            guard=(),
            effect=normal_printed,
        ),
    ),
)

NORMAL: AnyFamily = Family(
    "normal",
    (
        Rule(
            id="velocity/normal",
            sentence="The normal force is gravity times the cosine of the slope.",
            source="6.3.2; R28, P1, P2",
            guard=(),
            effect=normal_by_cosine,
        ),
    ),
)

OWN_FRICTION: Rule[Any, Any] = Rule(
    id="velocity/own-friction",
    sentence="Where the ground has no coefficient of friction of its own, that of the body counts, which is 0 without "
    "a material.",
    source="F6.7; R28",
    guard=(ground_has_none,),
    effect=of_the_body,
)

COEFFICIENT_PRINTED: AnyFamily = Family(
    "coefficient",
    (
        OWN_FRICTION,
        Rule(
            id="velocity/friction-of-ground-unread",
            sentence="As printed, only the coefficient of the body counts, also where the ground has one.",
            source="F6.7, 6.3.4; R28",
            guard=(ground_has_one,),
            effect=of_the_body,
        ),
    ),
)

COEFFICIENT: AnyFamily = Family(
    "coefficient",
    (
        OWN_FRICTION,
        Rule(
            id="velocity/friction-mixed",
            sentence="Where the ground has a coefficient of friction, the mean of it and that of the body counts.",
            source="6.3.4; O9",
            guard=(ground_has_one,),
            effect=mean_of_both,
        ),
    ),
)

FRICTION: AnyFamily = Family(
    "friction",
    (
        Rule(
            id="velocity/friction-slows",
            sentence="Friction lessens the magnitude of the velocity by the coefficient times the normal force times "
            "the tick.",
            source="F6.7; R28",
            guard=(outruns_friction,),
            effect=slowed,
        ),
        Rule(
            id="velocity/friction-holds",
            sentence="Where that is the magnitude of the velocity or more, the body stands.",
            source="F6.7; R28, P2",
            guard=(held_by_friction,),
            effect=stopped,
        ),
    ),
)

DRAG_PRINTED: AnyFamily = Family(
    "drag",
    (
        Rule(
            id="velocity/drag-printed",
            sentence="In each tick the velocity is multiplied by the drag.",
            source="6.3.1, T2.2; R27, A37, P10",
            guard=(),
            effect=by_a_factor,
        ),
    ),
)

DRAG: AnyFamily = Family(
    "drag",
    (
        Rule(
            id="velocity/drag",
            sentence="Drag divides the velocity by 1 plus the damping times the tick: what it takes is the damping "
            "times the way made in the tick.",
            source="6.3.1; R27, A37, P10",
            guard=(),
            effect=by_the_way_made,
        ),
    ),
)

FASTEST: AnyFamily = Family(
    "fastest",
    (
        Rule(
            id="velocity/within-maximum",
            sentence="A velocity within the maximum, or without one, stays.",
            source="6.3.1; R27",
            guard=(not_too_fast,),
            effect=as_it_is,
        ),
        Rule(
            id="velocity/maximum",
            sentence="A velocity of a greater magnitude than the maximum becomes the maximum in its direction.",
            source="6.3.1; R27",
            guard=(too_fast,),
            effect=at_the_bound,
        ),
    ),
)

FAST_ENOUGH: Rule[Any, Any] = Rule(
    id="velocity/above-minimum",
    sentence="A velocity whose magnitude is the minimum or more stays.",
    source="6.3.1; R27, A35",
    guard=(fast_enough,),
    effect=as_it_is,
)

SLOWEST_PRINTED: AnyFamily = Family(
    "slowest",
    (
        FAST_ENOUGH,
        Rule(
            id="velocity/minimum-printed",
            sentence="A velocity whose magnitude is less than the minimum becomes 0, also that of a body which has "
            "just begun to move.",
            source="6.3.1; R27, A35",
            guard=(too_slow,),
            effect=standing,
        ),
    ),
)

SLOWEST: AnyFamily = Family(
    "slowest",
    (
        FAST_ENOUGH,
        Rule(
            id="velocity/minimum",
            sentence="A velocity whose magnitude is less than the minimum, and not greater than before the tick, "
            "becomes 0.",
            source="6.3.1; R27, A35",
            guard=(too_slow, slowing),
            effect=standing,
        ),
        Rule(
            id="velocity/begins",
            sentence="A velocity whose magnitude grows may be less than the minimum.",
            source="6.3.1; R27, A35",
            guard=(too_slow, speeding_up),
            effect=as_it_is,
        ),
    ),
)

AFTER_PRINTED: AnyFamily = Family(
    "after",
    (
        Rule(
            id="velocity/kept",
            sentence="What a body meets in its move changes neither its velocity nor that of what it pushes.",
            source="6.2.1c, 6.3.4; A2, A38",
            guard=(),
            effect=as_meant,
        ),
    ),
)

AFTER: AnyFamily = Family(
    "after",
    (
        Rule(
            id="velocity/unhindered",
            sentence="A body that has moved all the way keeps its velocity, and so does a static one; what it pushes "
            "gets none of it.",
            source="6.2.1c, 6.3.4; R26, A2, O8",
            guard=(static_or_free,),
            effect=as_meant,
        ),
        Rule(
            id="velocity/hindered",
            sentence="A dynamic body that has not moved all the way has the velocity with which it moved in the end.",
            source="6.2.1c, 6.3.4; A38, O8",
            guard=(was_hindered,),
            effect=as_moved,
        ),
    ),
)


def simulate_tick(rules: VelocityRules, motion: Motion[N], slope: Slope[N], dt: N) -> Motion[N]:
    """The motion of a body after its velocity has been found anew, which is the first act of a tick (5.2; R10)."""
    turn = Turn(rules, motion, slope, dt)
    return replace(motion, velocity=chosen(rules.body, turn))


def meet(rules: VelocityRules, motion: Motion[N], free: bool, actual: N) -> Motion[N]:
    """The motion of a body after its move: `free` if it moved all the way, and with which velocity in the end."""
    return replace(
        motion, velocity=chosen(rules.after, Moved(motion.velocity, motion.material is not None, free, actual))
    )
