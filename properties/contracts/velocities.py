"""What is shown of velocities: of one tick with any pull and any friction, and of some on slopes of known directions.

Rules of velocity multiply numbers that are all unknown, which the engine does not. But what a tick does depends on the
slope, the gravity, the coefficient, the mass, the force and the time through two products alone: how much gravity and
forces add (`gain_of`), and how much friction can take (`loss_of`). On level ground, with all else 1, the force is the
first and the gravity the second. So a tick with any force and any gravity there is a tick with any of these anywhere.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any

from properties.contracts.families import promise_one
from properties.contracts.request import Seen
from properties.given import Given
from spec.number import Truth, lesser
from spec.rule import AnyFamily, Family, Rule
from spec.rules.velocity import (
    Bounded,
    Dragged,
    Grip,
    Material,
    Motion,
    Moved,
    Pull,
    Slope,
    Touch,
    Turn,
    VelocityRules,
    Weight,
    magnitude,
    meet,
    signed,
    simulate_tick,
)

ONE, ZERO = Fraction(1), Fraction(0)
LEVEL = Slope(ONE, ZERO)
GRAVITY, TICK = Fraction(10), Fraction(1, 50)
COEFFICIENTS = tuple(Fraction(n, 4) for n in (0, 1, 2, 3, 4, 8))
RISES = (Fraction(0), Fraction(3, 5), Fraction(-20, 29))
TICKS = (Fraction(1, 50), Fraction(1, 60), Fraction(1, 8))
DRAGS = tuple(Fraction(n, 10) for n in (0, 5, 9, 10))
DAMPINGS = tuple(Fraction(n) for n in (0, 1, 5, 40))
MOST_TICKS = 5


def any_velocity(given: Given, name: str) -> Any:
    """Any velocity, or change of one."""
    return given.number(f"{name} to the right") - given.number(f"{name} to the left")


def any_material(**known: Any) -> Material[Any]:
    """A material with a coefficient of 1 that nothing drags and nothing bounds, but for what is known otherwise."""
    return replace(Material(ONE, ONE, ZERO, ZERO, None, ONE), **known)


def any_pull(given: Given, velocity: Any, **known: Any) -> Motion[Any]:
    """A motion to which a tick on level ground of length 1 adds anything, and of which friction can take anything."""
    loss, gain = given.number("what friction can take"), any_velocity(given, "what gravity and forces add")
    return Motion(velocity, any_material(**known), gravity=loss, force=gain)


def seen_in(rules: VelocityRules, given: Given) -> VelocityRules:
    """The rules, seen."""
    return rules.through(lambda family: Seen(family, given))


def with_any_drag(rules: VelocityRules, given: Given) -> VelocityRules:
    """The rules, with any drag that leaves some part of any velocity, and its direction."""

    def leaves_some(dragged: Dragged[Any]) -> Any:
        left = given.number("what drag leaves")
        given.assume(left <= magnitude(dragged.velocity), "drag leaves a part of a velocity")
        given.assume((left > 0) | (dragged.velocity == 0), "drag does not leave nothing")
        return signed(left, dragged.velocity)

    some = Rule("drag", "Any drag.", "", (), leaves_some)
    drag: AnyFamily = Family("drag", (some,))
    return replace(seen_in(rules, given), drag=drag)


def between(velocity: Any, other: Any) -> Truth:
    """Whether a velocity is a part of another, from nothing to all of it."""
    forwards = (velocity >= 0) & (velocity <= other)
    return forwards | ((velocity <= 0) & (velocity >= other))  # type: ignore[no-any-return]


def body_has_one(rules: VelocityRules, given: Given) -> None:
    """A static or a dynamic body."""
    material = any_material() if given.flag("the body is dynamic") else None
    motion = Motion(any_velocity(given, "velocity"), material, given.number("gravity"), any_velocity(given, "force"))
    promise_one(given, rules.body, Turn(rules, motion, LEVEL, ONE))


def pull_has_one(rules: VelocityRules, given: Given) -> None:
    """Any velocity and gain."""
    promise_one(given, rules.pull, Pull(any_velocity(given, "velocity"), any_velocity(given, "gain")))


def normal_has_one(rules: VelocityRules, given: Given) -> None:
    """Any gravity on any slope."""
    promise_one(given, rules.normal, Weight(given.number("gravity"), Slope(ONE, any_velocity(given, "rise"))))


def coefficient_has_one(rules: VelocityRules, given: Given) -> None:
    """Ground with any coefficient, or none."""
    ground = given.number("of the ground") if given.flag("the ground has a coefficient") else None
    promise_one(given, rules.coefficient, Touch(given.number("of the body"), ground))


def friction_has_one(rules: VelocityRules, given: Given) -> None:
    """Any velocity, any friction."""
    promise_one(given, rules.friction, Grip(any_velocity(given, "velocity"), given.number("loss")))


def drag_has_one(rules: VelocityRules, given: Given) -> None:
    """Any velocity."""
    promise_one(given, rules.drag, Dragged(any_velocity(given, "velocity"), any_material(), ONE))


def fastest_has_one(rules: VelocityRules, given: Given) -> None:
    """Any velocity, any maximum, or none."""
    bound = given.number("maximum") if given.flag("there is a maximum") else None
    promise_one(given, rules.fastest, Bounded(any_velocity(given, "velocity"), any_velocity(given, "before"), bound))


def slowest_has_one(rules: VelocityRules, given: Given) -> None:
    """Any velocity, any minimum."""
    minimum = given.number("minimum")
    promise_one(given, rules.slowest, Bounded(any_velocity(given, "velocity"), any_velocity(given, "before"), minimum))


def after_has_one(rules: VelocityRules, given: Given) -> None:
    """Any velocities, hindered or not."""
    meant, actual = any_velocity(given, "velocity"), any_velocity(given, "actual velocity")
    dynamic, free = given.flag("the body is dynamic"), given.flag("it moved all the way")
    promise_one(given, rules.after, Moved(meant, dynamic, free, actual))


def static_velocities_stay(rules: VelocityRules, given: Given) -> None:
    """A static body has the velocity that is set, whatever acts on it."""
    motion = Motion(any_velocity(given, "velocity"), None, given.number("gravity"), any_velocity(given, "force"))
    after = simulate_tick(seen_in(rules, given), motion, Slope(ONE, any_velocity(given, "rise")), ONE)
    given.ensure("the velocity is as set", after.velocity == motion.velocity)


def velocities_are_bounded(rules: VelocityRules, given: Given) -> None:
    """After a tick no velocity is greater than the maximum."""
    fastest = given.number("maximum")
    motion = any_pull(given, any_velocity(given, "velocity"), fastest=fastest, slowest=given.number("minimum"))
    after = simulate_tick(with_any_drag(rules, given), motion, LEVEL, ONE)
    given.ensure("the maximum is kept", magnitude(after.velocity) <= fastest)


def friction_turns_nothing(rules: VelocityRules, given: Given) -> None:
    """Friction takes of a velocity what it can, and no more than all of it."""
    grip = Grip(any_velocity(given, "velocity"), given.number("what friction can take"))
    rule = Seen(rules.friction, given).choose(grip)
    left = rule.effect(grip)
    given.ensure("a part is left", between(left, grip.velocity))
    taken = magnitude(grip.velocity) - magnitude(left)
    given.ensure("it takes what it can", taken == lesser(grip.loss, magnitude(grip.velocity)))


def friction_is_mixed(rules: VelocityRules, given: Given) -> None:
    """The coefficient is that of the body on ground without one, else as far from one as from the other."""
    body, ground = given.number("of the body"), given.number("of the ground")
    family = Seen(rules.coefficient, given)
    alone, both = (family.choose(touch).effect(touch) for touch in (Touch(body, None), Touch(body, ground)))
    given.ensure("that of the body alone", alone == body)
    given.ensure("in the middle of both", both - body == ground - both)


def friction_is_of_the_body(rules: VelocityRules, given: Given) -> None:
    """The coefficient is that of the body, whatever the ground."""
    body, ground = given.number("of the body"), given.number("of the ground")
    family = Seen(rules.coefficient, given)
    for touch in (Touch(body, None), Touch(body, ground)):
        given.ensure("that of the body", family.choose(touch).effect(touch) == body)


def resistance_only_resists(rules: VelocityRules, given: Given) -> None:
    """What a tick does after gravity and forces only takes of the velocity, and never turns it round."""
    fastest = given.number("maximum") if given.flag("there is a maximum") else None
    motion = any_pull(given, any_velocity(given, "velocity"), fastest=fastest, slowest=given.number("minimum"))
    after = simulate_tick(with_any_drag(rules, given), motion, LEVEL, ONE)
    given.ensure("a part is left of what is pulled", between(after.velocity, motion.velocity + motion.force))


def rest_is_kept_by_friction(rules: VelocityRules, given: Given) -> None:
    """A body at rest stays at rest exactly where friction can take all that gravity and forces add; no minimum."""
    rest_is_kept(rules, given, ZERO)


def rest_is_kept_whatever_the_minimum(rules: VelocityRules, given: Given) -> None:
    """The same with any minimum."""
    rest_is_kept(rules, given, given.number("minimum"))


def rest_is_kept(rules: VelocityRules, given: Given, minimum: Any) -> None:
    """Promise that a body at rest stays there exactly where friction holds it."""
    fastest = given.number("maximum")
    given.assume(fastest > 0, "the maximum is greater than 0")
    motion = any_pull(given, ZERO, fastest=fastest, slowest=minimum)
    after = simulate_tick(with_any_drag(rules, given), motion, LEVEL, ONE)
    held = magnitude(motion.force) <= motion.gravity
    given.ensure("rest where friction holds, and only there", bool(after.velocity == 0) == bool(held))


def minimum_stops_all(rules: VelocityRules, given: Given) -> None:
    """After a tick a body stands, or is as fast as the minimum."""
    _, after, minimum = tick_with_minimum(rules, given)
    given.ensure("it stands, or is fast enough", (after == 0) | (magnitude(after) >= minimum))


def minimum_stops_the_slowing(rules: VelocityRules, given: Given) -> None:
    """After a tick a body stands, is as fast as the minimum, or is faster than before."""
    before, after, minimum = tick_with_minimum(rules, given)
    slow = (after == 0) | (magnitude(after) >= minimum)
    given.ensure("it stands, is fast enough, or speeds up", slow | (magnitude(after) > magnitude(before)))


def tick_with_minimum(rules: VelocityRules, given: Given) -> tuple[Any, Any, Any]:
    """A velocity before and after a tick, and the minimum."""
    before, minimum = any_velocity(given, "velocity"), given.number("minimum")
    motion = any_pull(given, before, slowest=minimum)
    return before, simulate_tick(with_any_drag(rules, given), motion, LEVEL, ONE).velocity, minimum


def any_move(rules: VelocityRules, given: Given) -> tuple[Any, Any, Any, bool]:
    """A velocity before and after a move, that in the end of it, and whether the body is static or moved freely."""
    dynamic, free = given.flag("the body is dynamic"), given.flag("it moved all the way")
    before, actual = any_velocity(given, "velocity"), any_velocity(given, "actual velocity")
    motion = Motion(before, any_material() if dynamic else None, ZERO, ZERO)
    return before, meet(seen_in(rules, given), motion, free, actual).velocity, actual, free or not dynamic


def velocities_are_kept(rules: VelocityRules, given: Given) -> None:
    """No move changes a velocity."""
    before, after, _, _ = any_move(rules, given)
    given.ensure("the velocity is kept", after == before)


def hindered_velocities_are_lost(rules: VelocityRules, given: Given) -> None:
    """A dynamic body that has not moved all the way has the velocity in the end, and any other its own."""
    before, after, actual, keeps = any_move(rules, given)
    given.ensure("the velocity is kept, or that in the end", after == (before if keeps else actual))


def any_slope(given: Given) -> Slope[Any]:
    """Any slope, to either side."""
    return Slope(given.number("run"), any_velocity(given, "rise"))


def rests_up_to_the_coefficient(rules: VelocityRules, given: Given, coefficient: Fraction) -> None:
    """A body rests exactly on slopes whose tangent is at most the coefficient."""
    slope = any_slope(given)
    motion = Motion(ZERO, any_material(friction=coefficient), GRAVITY, ZERO)
    after = simulate_tick(seen_in(rules, given), motion, slope, TICK)
    gentle = magnitude(slope.rise) <= slope.run * coefficient
    given.ensure("rest up to the coefficient, and only there", bool(after.velocity == 0) == bool(gentle))


def rests_up_to_the_printed_slope(rules: VelocityRules, given: Given, coefficient: Fraction) -> None:
    """As printed, a body rests exactly where the sine is at most the coefficient by 1 and the coefficient."""
    slope = any_slope(given)
    motion = Motion(ZERO, any_material(friction=coefficient), GRAVITY, ZERO)
    after = simulate_tick(seen_in(rules, given), motion, slope, TICK)
    gentle = magnitude(slope.rise) * (1 + coefficient) <= coefficient
    given.ensure("rest up to the printed slope, and only there", bool(after.velocity == 0) == bool(gentle))


def follows_the_sum(rules: VelocityRules, given: Given, rise: Fraction, dt: Fraction) -> None:
    """Without friction and drag, a body has come after each tick as far as s = v0 T - a T^2 / 2 - a dt T / 2 says."""
    gravity, start = given.number("gravity"), any_velocity(given, "velocity")
    slowing, seen = gravity * rise, seen_in(rules, given)
    motion = Motion(start, any_material(friction=ZERO), gravity, ZERO)
    way = ZERO
    for count in range(1, MOST_TICKS + 1):
        motion = simulate_tick(seen, motion, Slope(ONE, rise), dt)
        way, time = way + motion.velocity * dt, dt * count
        expected = start * time - slowing * (time * time / 2) - slowing * (dt * time / 2)
        given.ensure(f"the way is that of the sum, tick {count}", way == expected)


def drag_leaves_a_part(rules: VelocityRules, given: Given, drag: Fraction, damping: Fraction) -> None:
    """Drag leaves a part of a velocity, in its direction."""
    material = any_material(drag=drag, damping=damping)
    dragged = Dragged(any_velocity(given, "velocity"), material, TICK)
    left = Seen(rules.drag, given).choose(dragged).effect(dragged)
    given.ensure("a part is left", between(left, dragged.velocity))


def damping_takes_by_the_way(rules: VelocityRules, given: Given, damping: Fraction, dt: Fraction) -> None:
    """What drag takes of a velocity is the damping times the way made in the tick."""
    dragged = Dragged(any_velocity(given, "velocity"), any_material(damping=damping), dt)
    left = Seen(rules.drag, given).choose(dragged).effect(dragged)
    given.ensure("the damping times the way", dragged.velocity - left == left * dt * damping)
