"""The claims about velocities: as printed, under the profile `thesis`; mended, under `repaired`."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import partial
from typing import Any

from properties.claims.claim import Claim, Count, Erratum, Obligation, Verdict
from properties.claims.string import name_of
from properties.contracts import physics, velocities
from properties.contracts.velocities import COEFFICIENTS, DAMPINGS, DRAGS, RISES, TICKS
from properties.given import Given
from spec.profiles import REPAIRED, THESIS, AnyProfile
from spec.rules.velocity import VelocityRules

PROVED, BOUNDED, TESTED, REFUTED = Verdict.PROVED, Verdict.BOUNDED, Verdict.TESTED, Verdict.REFUTED
BOTH: tuple[tuple[AnyProfile, str], ...] = ((THESIS, ""), (REPAIRED, "/repaired"))
Program = Callable[[VelocityRules, Given], None]


def of_velocity(program: Program) -> Obligation:
    """An obligation on the rules of velocity, for any body in any tick."""
    return Obligation(name_of(program), partial(under, program))


def under(program: Program, profile: AnyProfile, given: Given) -> None:
    """Run an obligation on the rules of velocity of a profile."""
    program(profile.velocity, given)


def of_known(program: Callable[..., None], shape: str, values: Iterable[tuple[Any, ...]]) -> tuple[Obligation, ...]:
    """Obligations in which some numbers are those of a list, which is the shape of it."""

    def known(one: tuple[Any, ...]) -> Program:
        return lambda rules, given: program(rules, given, *one)

    return tuple(
        Obligation(f"{name_of(program)} ({', '.join(map(str, one))})", partial(under, known(one)), shape=shape)
        for one in values
    )


def proved(name: str, about: str, sentence: str, source: str, *programs: Program) -> tuple[Claim, ...]:
    """A claim about any body in any tick, under both profiles."""
    obligations = tuple(map(of_velocity, programs))
    return tuple(
        Claim(f"claim/{name}{suffix}", "velocity", sentence, source, about, profile, (), PROVED, obligations)
        for profile, suffix in BOTH
    )


def both_proved(
    name: str, source: str, printed: tuple[str, str], as_printed: Program, mended: tuple[str, str], as_mended: Program
) -> tuple[Claim, Claim]:
    """A claim about any body in any tick, as printed and mended; of each what it is about, and its sentence."""

    def claim(suffix: str, profile: AnyProfile, said: tuple[str, str], program: Program) -> Claim:
        about, sentence = said
        own = (of_velocity(program),)
        return Claim(f"claim/{name}{suffix}", "velocity", sentence, source, about, profile, (), PROVED, own)

    return claim("", THESIS, printed, as_printed), claim("/repaired", REPAIRED, mended, as_mended)


def judged(
    name: str,
    about: str,
    sentence: str,
    source: str,
    count: Callable[[Any], int],
    *known: Obligation,
    profiles: tuple[tuple[AnyProfile, str], ...] = BOTH,
) -> tuple[Claim, ...]:
    """A claim that multiplies numbers which are all unknown: tested, and bounded where `known` ones are of a list."""
    verdict = BOUNDED if known else TESTED
    counts = (Count(count.__name__.replace("_", "-"), count),)
    return tuple(
        Claim(f"claim/{name}{suffix}", "velocity", sentence, source, about, profile, (), verdict, known, counts=counts)
        for profile, suffix in profiles
    )


def refuted(name: str, about: str, sentence: str, source: str, erratum: Erratum) -> Claim:
    """A claim that the printed rules of velocity do not keep."""
    return Claim(f"claim/{name}", "velocity", sentence, source, about, THESIS, (), REFUTED, erratum=erratum)


MENDED_ONLY: tuple[tuple[AnyProfile, str], ...] = ((REPAIRED, ""),)
PRINTED_ONLY: tuple[tuple[AnyProfile, str], ...] = ((THESIS, ""),)
COEFFICIENT = [(one,) for one in COEFFICIENTS]
DRAGGED = [(drag, damping) for drag, damping in zip(DRAGS, DAMPINGS, strict=True)]

CLAIMS: tuple[Claim, ...] = (
    *proved(
        "one-velocity-rule-applies",
        "rules",
        "Within each family that finds a velocity, exactly one rule applies in every situation.",
        "6.3.1; R26, R27",
        velocities.body_has_one,
        velocities.pull_has_one,
        velocities.normal_has_one,
        velocities.coefficient_has_one,
        velocities.friction_has_one,
        velocities.drag_has_one,
        velocities.fastest_has_one,
        velocities.slowest_has_one,
        velocities.after_has_one,
    ),
    *proved(
        "speed-is-bounded",
        "velocity/maximum",
        "After a tick no dynamic body is faster than its maximum, and a static one is as fast as it was set.",
        "6.3.1; R26, R27",
        velocities.velocities_are_bounded,
        velocities.static_velocities_stay,
    ),
    *proved(
        "friction-turns-nothing",
        "velocity/friction-holds",
        "Friction takes of a velocity what it can, at most all of it, and never turns it round.",
        "F6.7; R28",
        velocities.friction_turns_nothing,
    ),
    *proved(
        "resistance-only-resists",
        "velocity/dynamic",
        "Friction, drag, maximum and minimum together leave a part of the velocity that gravity and forces have made, "
        "and never turn it round, whatever part drag leaves.",
        "6.3.1, F6.7; R27, R28, A36",
        velocities.resistance_only_resists,
    ),
    *both_proved(
        "rest-is-kept-by-friction",
        "F6.7; R27, R28, A35, P2",
        (
            "velocity/friction-holds",
            "Without a minimum, a body at rest stays at rest exactly where friction can take all that gravity and "
            "forces add in a tick.",
        ),
        velocities.rest_is_kept_by_friction,
        (
            "velocity/friction-holds",
            "A body at rest stays at rest exactly where friction can take all that gravity and forces add in a tick, "
            "whatever the minimum.",
        ),
        velocities.rest_is_kept_whatever_the_minimum,
    ),
    *both_proved(
        "coefficient-of-friction",
        "F6.7, 6.3.4; R28, O9",
        ("velocity/own-friction", "The coefficient of friction is that of the body, whatever ground it is on."),
        velocities.friction_is_of_the_body,
        (
            "velocity/friction-mixed",
            "The coefficient of friction is in the middle between that of the body and that of the ground, if it has "
            "one.",
        ),
        velocities.friction_is_mixed,
    ),
    *both_proved(
        "minimum-stops",
        "6.3.1; R27, A35",
        ("velocity/minimum-printed", "After a tick no dynamic body is slower than its minimum and not at rest."),
        velocities.minimum_stops_all,
        (
            "velocity/minimum",
            "After a tick no dynamic body is slower than its minimum and not at rest, unless it has become faster.",
        ),
        velocities.minimum_stops_the_slowing,
    ),
    *both_proved(
        "velocity-after-a-move",
        "6.2.1c, 6.3.4; A2, A38, O8",
        ("velocity/kept", "The velocity after a move is that before it, whatever the body met."),
        velocities.velocities_are_kept,
        (
            "velocity/hindered",
            "The velocity after a move is that before it if the body is static or moved all the way, else that in the "
            "end.",
        ),
        velocities.hindered_velocities_are_lost,
    ),
    *judged(
        "rest-up-to-the-coefficient",
        "velocity/normal",
        "A body at rest stays at rest exactly on slopes whose tangent is at most the coefficient of friction: on any "
        "slope for the coefficients of a list.",
        "F6.7; P1, P2",
        physics.part_is_left,
        *of_known(velocities.rests_up_to_the_coefficient, "coefficients", COEFFICIENT),
        profiles=MENDED_ONLY,
    ),
    *judged(
        "rest-up-to-the-printed-slope",
        "velocity/normal-printed",
        "As printed, a body at rest stays at rest exactly on slopes whose sine is at most mu / (1 + mu), where mu is "
        "the coefficient of friction: on any slope for the coefficients of a list.",
        "F6.7; P2, E3",
        physics.part_is_left,
        *of_known(velocities.rests_up_to_the_printed_slope, "coefficients", COEFFICIENT),
        profiles=PRINTED_ONLY,
    ),
    *judged(
        "no-energy-gained",
        "velocity/dynamic",
        "On a slope, in a tick of any length, the energy of motion grows by no more than gravity and forces give on "
        "the way of the tick.",
        "F6.7; R10, R28",
        physics.energy_is_not_gained,
    ),
    *judged(
        "way-without-friction",
        "velocity/gravity",
        "Without friction and drag the way after a time T is s = v0 T - a T^2 / 2 - a dt T / 2, where a is what the "
        "slope slows: for any v0 and gravity on the slopes and for the ticks of a list, up to five of them.",
        "6.3.3, F6.10; R10, R28, E1",
        physics.sums_are_followed,
        *of_known(velocities.follows_the_sum, "slopes", [(rise, dt) for rise in RISES for dt in TICKS[:2]]),
    ),
    *judged(
        "stopping-way",
        "velocity/friction-slows",
        "On level ground a body with velocity v0 stops on the way v0^2 / (2 a) - v0 dt / 2 + a dt^2 f (1 - f) / 2, "
        "where a is the coefficient times gravity and f what v0 / (a dt) is above a whole number.",
        "6.3.3, F6.11; R10, R28, E2",
        physics.stopping_ways,
    ),
    *judged(
        "drag-leaves-a-part",
        "velocity/drag",
        "Drag leaves a part of a velocity, in its direction: for any velocity with the drags of a list.",
        "6.3.1; R27, A37",
        physics.part_is_left,
        *of_known(velocities.drag_leaves_a_part, "drags", DRAGGED),
    ),
    *judged(
        "drag-takes-by-the-way",
        "velocity/drag",
        "What drag alone takes of a velocity is the damping times the way, however many ticks of whatever length that "
        "takes: for any velocity in one tick with the dampings and ticks of a list.",
        "6.3.1; R27, A37, P10",
        physics.drag_is_by_the_way,
        *of_known(velocities.damping_takes_by_the_way, "drags", [(c, dt) for c in DAMPINGS for dt in TICKS]),
        profiles=MENDED_ONLY,
    ),
    Claim(
        "claim/velocities-ask-for-their-way",
        "velocity",
        "A tick asks each body that moves of its own once, in its turn, for its new velocity times the tick, in the "
        "direction of that; and no request sees more of velocities.",
        "5.2; R10, R26",
        "velocity/dynamic",
        THESIS,
        (),
        PROVED,
        (Obligation("physics/velocities-ask-for-their-way", physics.velocities_ask_for_their_way),),
    ),
    *judged(
        "invariants-at-any-velocity",
        "invariants",
        "The requests of ticks in which bodies slide with any velocities, on slopes too, keep every invariant of one "
        "request.",
        "5.2; R10, R24",
        physics.invariants_hold_at_any_velocity,
        profiles=PRINTED_ONLY,
    ),
    refuted(
        "rest-on-slopes",
        "velocity/normal-printed",
        "As printed, a body at rest stays at rest exactly on slopes whose tangent is at most the coefficient.",
        "F6.7; P2",
        physics.rest_on_slopes,
    ),
    refuted(
        "friction-by-the-cosine",
        "velocity/normal-printed",
        "As printed, friction takes of a sliding body the coefficient times gravity times the cosine of the slope.",
        "F6.7; P1",
        physics.friction_by_the_cosine,
    ),
    refuted(
        "printed-drag-by-the-way",
        "velocity/drag-printed",
        "As printed, what drag takes of a velocity it takes on the same way, whatever the tick.",
        "6.3.1; P10",
        physics.drag_by_the_way,
    ),
    refuted(
        "no-higher-through-a-valley",
        "velocity/gravity",
        "A body that is let go on one side of a valley of two equal slopes, without friction, comes no higher on the "
        "other side, whatever the tick.",
        "F6.7; R10, A33",
        physics.no_higher_through_a_valley,
    ),
    refuted(
        "minimum-lets-begin",
        "velocity/minimum-printed",
        "On a slope without friction a body at rest begins to move, whatever its least speed.",
        "6.3.1; A35",
        physics.minimum_lets_begin,
    ),
)
