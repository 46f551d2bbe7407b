"""The claims that compare steps on storeys: with their mirror images, with other orders of bodies, with steps cut in
two, and with the same without riders.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial

from properties.claims.claim import Claim, Obligation, Verdict
from properties.claims.repaired import (
    LOSSES,
    ROWS,
    SETTLED,
    START,
    STILL,
    STRETCHES,
    TWO_BELOW,
    WINDOWS,
    holds,
    of_steps,
    of_way,
)
from properties.claims.string import name_of
from properties.contracts import cuts, images, parting
from properties.contracts.images import View, from_behind, renamed
from properties.given import Given
from properties.worlds.storeys import Member, Setting
from spec.conditions import WALLS_THICK
from spec.graph import Direction
from spec.profiles import SteppedProfile
from spec.rules.step import StepRules
from spec.stepped import STEP_BODY_ORDER, STEP_MIRROR, STEP_RIDERS, STEP_SPLIT

PROVED = Verdict.PROVED
THICK = WALLS_THICK.id

ONE = (Setting("alone", (Member(0, STILL),)), Setting("alone on a ring", (Member(0, STILL),), ring=True))
BESIDE = (
    Setting("two beside each other", (Member(1, STILL), Member(1, STILL)), (1, 1)),
    Setting("two beside each other on a ring", (Member(1, STILL), Member(1, STILL)), (1,), ring=True),
)
RIDDEN = (
    Setting("one on another", (Member(0, STILL), Member(1, STILL, 0))),
    Setting("one on another on a ring", (Member(0, STILL), Member(1, STILL, 0)), ring=True),
)
Viewed = Callable[[], View]
"""A view, made where it is used, so that a wrong one is noticed."""

OF_MEMBERS = (images.rows_look_alike, images.members_look_alike)
BEHIND, ALONE = "from behind", "without the rider"
PUSHING = {"neither pushes": (), "the one behind pushes": (0,), "the one ahead pushes": (1,), "both push": (0, 1)}
CARRIED = {"one off another": (0,), "one above two": (1, 2)}
"""Who is below, where it is not the second of two."""


def in_view(program: Callable[[StepRules, Given, View], None], name: str, view: Viewed) -> Obligation:
    """An obligation on the rules of a step, in another view."""

    def of_profile(profile: SteppedProfile, given: Given) -> None:
        program(profile.rules, given, view())

    return Obligation(f"{name_of(program)} ({name})", of_profile)


def of_worlds(
    program: Callable[[StepRules, Given, Setting, View], None], setting: Setting, name: str, view: Viewed, *needs: str
) -> Obligation:
    """An obligation on the few that a setting has, whatever else is in the world, in another view."""

    def of_profile(profile: SteppedProfile, given: Given) -> None:
        program(profile.rules, given, setting, view())

    return Obligation(f"{name_of(program)} ({setting.name}, {name})", of_profile, needs)


def of_cut(program: Callable[[StepRules, Given, Setting], None], setting: Setting) -> Obligation:
    """An obligation on the few that a setting has, in a step that is cut in two."""

    def of_profile(profile: SteppedProfile, given: Given) -> None:
        program(profile.rules, given, setting)

    return Obligation(f"{name_of(program)} ({setting.name})", of_profile, (START,))


def of_two(name: str, pushing: tuple[int, ...]) -> Obligation:
    """That two who part are as fast, of whom some may push."""

    def of_profile(profile: SteppedProfile, given: Given) -> None:
        parting.who_part_are_as_fast(profile.rules, given, Direction.RIGHT, pushing)

    return Obligation(f"{name_of(parting.who_part_are_as_fast)} ({name})", of_profile)


def seen(name: str, view: Callable[[int], View], least: int, *needs: str) -> tuple[Obligation, ...]:
    """That all of a step is alike in a view of so many bodies, in windows of so many at least; settling needs more."""
    windows = [one for one in WINDOWS if len(one.members) >= least]
    losses = [one for one in (*LOSSES, *BESIDE) if len(one.members) >= least]
    return (
        *(in_view(program, name, partial(view, 4)) for program in (images.facts_look_alike, images.tops_look_alike)),
        *(in_view(program, name, partial(view, 2)) for program in (images.records_look_alike, *OF_MEMBERS)),
        *(of_worlds(images.worlds_look_alike, one, name, partial(view, len(one.members)), START) for one in windows),
        *(of_worlds(images.ways_look_alike, one, name, partial(view, 1), START) for one in ONE if least == 1),
        *(of_worlds(images.settling_looks_alike, one, name, partial(view, len(one.members)), *needs) for one in losses),
        of_worlds(images.tops_are_listed_alike, TWO_BELOW, name, partial(view, len(TWO_BELOW.members))),
        of_worlds(images.velocities_look_alike, RIDDEN[0], name, partial(view, 2), START),
    )


MIRRORED = seen(BEHIND, from_behind, 1, THICK)
RENAMED = seen("in another order", renamed, 2)
CUT = (
    *of_steps(cuts.records_last, cuts.time_goes_by, cuts.instants_are_the_same),
    *(of_cut(cuts.two_ways_are_one, setting) for setting in ONE),
    *(of_cut(cuts.who_is_held_has_room, setting) for setting in WINDOWS),
    *(of_cut(cuts.what_comes_is_nearer, setting) for setting in WINDOWS),
    *(of_two(name, pushing) for name, pushing in PUSHING.items()),
    *(
        of_way(program, Direction.RIGHT)
        for program in (parting.who_is_beyond_is_as_fast, parting.who_leaves_a_wall_is_as_fast)
    ),
    *(in_view(program, BEHIND, partial(from_behind, 2)) for program in OF_MEMBERS),
)
BELOW = (
    *(of_worlds(images.worlds_look_alike, one, ALONE, partial(View, (0,)), START) for one in RIDDEN),
    *(
        of_worlds(images.settling_looks_alike, one, "without those above", partial(View, CARRIED.get(one.name, (1,))))
        for one in LOSSES
        if len(one.members) > 1
    ),
    of_worlds(images.velocities_look_alike, RIDDEN[0], ALONE, partial(View, (0,)), START),
)
KEPT = (*STRETCHES, *SETTLED)

CLAIMS: tuple[Claim, ...] = (
    holds(STEP_SPLIT, PROVED, *CUT, *KEPT, *ROWS),
    replace(holds(STEP_MIRROR, PROVED, *MIRRORED, *KEPT), premises=(START, THICK)),
    holds(STEP_BODY_ORDER, PROVED, *RENAMED, *KEPT),
    holds(STEP_RIDERS, PROVED, *BELOW, *CUT, *KEPT, *ROWS),
)
