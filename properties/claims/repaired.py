"""The claims about steps on storeys, under the profile `repaired`."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from properties.claims.claim import Claim, Count, Obligation, Verdict
from properties.claims.string import name_of, of_rules
from properties.contracts import (
    batches,
    batching,
    bounces,
    endings,
    instants,
    judging_steps,
    measuring,
    one_drive,
    reach,
    step_families,
    steps,
    stretches,
    sweeps,
)
from properties.given import Given
from properties.worlds.storeys import Member, Setting
from spec.conditions import STOREYS_START
from spec.graph import Direction
from spec.invariants import Relation
from spec.profiles import REPAIRED, SteppedProfile
from spec.rules.step import StepRules
from spec.stepped import (
    STEP_BYSTANDERS,
    STEP_FURTHEST,
    STEP_INSTANTS,
    STEP_INSTANTS_OF_ONE,
    STEP_MARGIN,
    STEP_MOTION,
    STEP_NOT_RAISED,
    STEP_ONE_KEY,
    STEP_ONE_WAY,
    STEP_ORDER,
    STEP_OUT_OF_REACH,
    STEP_PROGRESS,
    STEP_SEAT,
    STEP_SPLIT,
    STEP_SQUEEZED,
    STEP_SUPPORT,
    STEP_TERRAIN,
    StepInvariant,
)
from spec.storeys import Drive

PROVED, BOUNDED, TESTED = Verdict.PROVED, Verdict.BOUNDED, Verdict.TESTED
START = STOREYS_START.id

STILL = Drive(Fraction(0))
RIGHT, LEFT, FAST = (Drive(Fraction(speed), relative=False) for speed in (1, -1, 2))
SLIDES = Drive(Fraction(1))

ALONE = Setting("alone", (Member(0, RIGHT),))
PIT = Setting("over a pit", (Member(1, RIGHT),), (2,))
STAIRS = Setting("down stairs", (Member(2, RIGHT),), (1, 1))
ROUND = Setting("round a ring", (Member(1, RIGHT),), (1,), ring=True)
PUSH = Setting("a push", (Member(0, RIGHT), Member(0, STILL)))
TOWARDS = Setting("towards each other", (Member(0, RIGHT), Member(0, LEFT)))
CHASE = Setting("a chase", (Member(0, FAST), Member(0, RIGHT)))
RING_PUSH = Setting("a push on a ring", (Member(0, RIGHT), Member(0, STILL)), ring=True)
RIDE = Setting("a ride", (Member(0, RIGHT), Member(1, STILL, 0)))
WALKS_ON = Setting("a walk on a walker", (Member(0, RIGHT), Member(1, FAST, 0)))
SQUEEZE = Setting("a squeeze", (Member(0, RIGHT), Member(0, STILL), Member(0, LEFT)))
THREE = Setting("a push of two", (Member(0, RIGHT), Member(0, STILL), Member(0, STILL)))
NO_PUSH = Setting("one that may not push", (Member(0, FAST), Member(0, STILL, pushes=False), Member(0, LEFT)))
TOGETHER = Setting("two that walk together", (Member(0, RIGHT), Member(0, RIGHT)))
TO_THE_LEFT = Setting("a push to the left", (Member(0, STILL), Member(0, LEFT)))
PUSHED_OFF = Setting("a push off a ledge", (Member(1, RIGHT), Member(1, STILL)), (1,))
PUSHED_RIDE = Setting("a push of a carrier", (Member(0, RIGHT), Member(0, STILL), Member(1, STILL, 1)))
SLIDE = Setting("a slide on a walker", (Member(0, RIGHT), Member(1, SLIDES, 0)), (1,))

SMALL = (ALONE, PIT, STAIRS, ROUND, PUSH, TOWARDS, CHASE, RING_PUSH, RIDE, WALKS_ON, SQUEEZE, THREE)
LARGER = (NO_PUSH, PUSHED_RIDE, PUSHED_OFF, SLIDE)


def of_setting(program: Callable[[SteppedProfile, Given, Setting], None], setting: Setting) -> Obligation:
    """An obligation on all steps of a setting."""

    def of_profile(profile: SteppedProfile, given: Given) -> None:
        program(profile, given, setting)

    name = f"steps/{program.__name__.replace('_', '-')} ({setting.name})"
    return Obligation(name, of_profile, (START,), "ring" if setting.ring else "line", len(setting.members))


def of_window(program: Callable[[StepRules, Given, Setting], None], setting: Setting) -> Obligation:
    """An obligation on the few that a setting has, whatever else is in the world."""

    def of_profile(profile: SteppedProfile, given: Given) -> None:
        program(profile.rules, given, setting)

    return Obligation(f"{name_of(program)} ({setting.name})", of_profile, (START,) if program in FROM_START else ())


def of_way(program: Callable[[StepRules, Given, Direction], None], ahead: Direction) -> Obligation:
    """An obligation on a row of any length, swept in a direction."""

    def of_profile(profile: SteppedProfile, given: Given) -> None:
        program(profile.rules, given, ahead)

    return Obligation(f"{name_of(program)} ({ahead.name.lower()})", of_profile)


def of_steps(*programs: Callable[[StepRules, Given], None]) -> tuple[Obligation, ...]:
    """Obligations on the rules of a step, for any number of bodies."""
    return tuple(of_rules(program) for program in programs)


WHOLE_STEPS = tuple(of_setting(steps.steps_keep_the_invariants, setting) for setting in SMALL)
LARGER_STEPS = tuple(of_setting(steps.steps_keep_the_invariants, setting) for setting in LARGER)
MIRRORED = tuple(of_setting(steps.steps_have_mirror_images, one) for one in (ALONE, PUSH, CHASE, RIDE))
IN_BATCHES = (ALONE, PIT, PUSH, TO_THE_LEFT, TOGETHER, RIDE, THREE)
BATCHES = tuple(of_setting(batches.batches_end_where_events_lead, one) for one in IN_BATCHES)
GOING_ON = tuple(of_setting(batches.speeds_are_kept_for_any_part, one) for one in IN_BATCHES)
SPLIT = tuple(of_setting(steps.steps_may_be_split, one) for one in (ALONE, PUSH, TOWARDS))


WINDOWS = (
    Setting("two", (Member(0, STILL), Member(0, STILL))),
    Setting("two on a ring", (Member(0, STILL), Member(0, STILL)), ring=True),
    Setting("two and a wall", (Member(0, STILL), Member(0, STILL)), (1,)),
    Setting("one and a wall on a ring", (Member(0, STILL),), (1,), ring=True),
    Setting("one on pieces of ground", (Member(1, STILL),), (2,)),
    Setting("one on ground before a wall", (Member(1, STILL),), (1, 1)),
    Setting("one on ground of a ring", (Member(1, STILL),), (1,), ring=True),
    Setting("one on another", (Member(0, STILL), Member(1, STILL, 0))),
    Setting("one on another on a ring", (Member(0, STILL), Member(1, STILL, 0)), ring=True),
)
LOSSES = (
    Setting("one above another", (Member(1, STILL), Member(0, STILL)), (1,)),
    Setting("one above another on a ring", (Member(1, STILL), Member(0, STILL)), (1,), ring=True),
    Setting("one before a wall", (Member(1, STILL),), (1, 1)),
    Setting("one off another", (Member(0, STILL), Member(1, STILL, 0)), (1,)),
    Setting("one above two", (Member(1, STILL), Member(0, STILL), Member(0, STILL))),
    Setting("two high up", (Member(2, STILL), Member(1, STILL)), (1, 1)),
    Setting("one on another that falls", (Member(2, STILL, 1), Member(1, STILL)), (1,)),
)
TWO_BELOW = Setting("one above two on a ring", (Member(1, STILL), Member(0, STILL), Member(0, STILL)), ring=True)
FROM_START = (
    stretches.stretches_keep_apart,
    stretches.what_touches_is_recorded,
    instants.no_time_changes_nothing,
    instants.what_touches_is_recorded_when_settled,
    one_drive.supports_are_in_order,
    one_drive.no_wall_is_between,
    endings.who_keeps_up_keeps_its_support,
    endings.what_is_lost_stays_lost,
)
CONTACTS = of_steps(steps.contacts_do_not_close)
TIMES = (
    *of_steps(stretches.no_event_is_passed_over, stretches.room_is_used_up_in_time),
    *(of_window(stretches.what_touches_is_recorded, setting) for setting in WINDOWS[:4]),
    of_window(instants.no_time_changes_nothing, WINDOWS[0]),
    of_window(instants.what_touches_is_recorded_when_settled, WINDOWS[0]),
    *of_steps(instants.what_has_not_parted_stays_recorded, instants.neighbours_stay_in_contact),
)
STRETCHES = (*CONTACTS, *TIMES, *(of_window(stretches.stretches_keep_apart, setting) for setting in WINDOWS))
SETTLED = (
    *of_steps(instants.what_was_lost_is_not_looked_at),
    of_window(stretches.tops_are_in_order, TWO_BELOW),
    *(of_window(stretches.settling_keeps_apart, setting) for setting in LOSSES),
)
ROWS = (
    *of_steps(steps.wishes_are_of_drives, steps.squeezed_bodies_stand, sweeps.speeds_meet_once),
    *(of_way(sweeps.motion_has_causes, ahead) for ahead in Direction),
)
REACH = (*of_steps(reach.wishes_add_one_drive), *(of_way(reach.rows_add_no_speed, ahead) for ahead in Direction))
ONE_KEY = tuple(of_way(sweeps.nobody_is_faster_than_all_wish, ahead) for ahead in Direction)

FURTHEST = (
    *(of_way(one_drive.bodies_go_as_far_as_they_may, ahead) for ahead in Direction),
    *of_steps(one_drive.wishes_go_one_way, one_drive.sums_are_the_closed_form),
    of_window(one_drive.supports_are_in_order, one_drive.TWO_ON_TWO),
    of_window(one_drive.no_wall_is_between, WINDOWS[2]),
)

MONOTONE = (
    *(of_way(endings.faster_wishes_pass_on_no_less, ahead) for ahead in Direction),
    *(of_way(endings.faster_wishes_slow_nobody, ahead) for ahead in Direction),
)
BOUNCES = of_steps(bounces.two_bounces_make_way)
ON_ANOTHER = WINDOWS[7]
KEPT = (
    *of_steps(instants.what_has_not_parted_stays_recorded),
    of_window(endings.who_keeps_up_keeps_its_support, ON_ANOTHER),
    of_window(endings.what_is_lost_stays_lost, ON_ANOTHER),
)
OF_ONE = (*CONTACTS, *ROWS, *ONE_KEY, *KEPT, *of_steps(one_drive.wishes_go_one_way), *SETTLED)


def holds(about: StepInvariant | Relation, expected: Verdict, *obligations: Obligation, long: bool = False) -> Claim:
    """The claim that all steps have a property; it is also tested on random storeys."""
    return Claim(
        id=f"claim/{about.id.removeprefix('invariant/')}",
        family="steps",
        sentence=about.sentence,
        source=about.source,
        about=about.id,
        profile=REPAIRED,
        premises=(START,),
        expected=expected,
        obligations=obligations,
        sampled="storeys",
        long=long,
    )


def proved(name: str, about: str, sentence: str, source: str, *programs: Callable[[StepRules, Given], None]) -> Claim:
    """A claim about rows of any length, proved by obligations that assume nothing."""
    obligations = of_steps(*programs)
    return Claim(f"claim/{name}", "steps", sentence, source, about, REPAIRED, (), PROVED, obligations)


CLAIMS: tuple[Claim, ...] = (
    *(holds(invariant, PROVED, *STRETCHES, *SETTLED) for invariant in (STEP_MARGIN, STEP_TERRAIN, STEP_SUPPORT)),
    *(holds(invariant, PROVED, *SETTLED) for invariant in (STEP_SEAT, STEP_NOT_RAISED)),
    *(holds(invariant, PROVED, *STRETCHES) for invariant in (STEP_ORDER, STEP_MOTION)),
    *(holds(invariant, PROVED, *ROWS) for invariant in (STEP_BYSTANDERS, STEP_PROGRESS, STEP_SQUEEZED)),
    holds(STEP_ONE_KEY, PROVED, *ROWS, *ONE_KEY),
    holds(STEP_INSTANTS, BOUNDED, *WHOLE_STEPS, long=True),
    holds(STEP_INSTANTS_OF_ONE, PROVED, *OF_ONE),
    *(holds(relation, PROVED, *FURTHEST) for relation in (STEP_FURTHEST, STEP_ONE_WAY)),
    holds(STEP_OUT_OF_REACH, TESTED),
    proved(
        "one-step-rule-applies",
        "rules",
        "Within each family that a step chooses from, exactly one rule applies in every situation.",
        "6.2.1; R5",
        step_families.wish_has_one,
        step_families.forward_has_one,
        step_families.relay_has_one,
        step_families.meet_has_one,
        step_families.way_has_one,
        step_families.settle_has_one,
    ),
    proved(
        "contacts-do-not-close",
        "way/slower",
        "In a row of any length, the body behind is never faster than the one ahead in contact, and nobody moves on at "
        "a wall.",
        "6.2.1b, 6.2.1c; R19, R20, R24",
        steps.contacts_do_not_close,
    ),
    Claim(
        id="claim/instants-have-no-bound",
        family="steps",
        sentence="With several drives, instants have no bound in the numbers of bodies, storeys and pieces of terrain: "
        "four bodies without terrain have as many as one likes.",
        source="6.2.1; R17",
        about=STEP_INSTANTS.id,
        profile=REPAIRED,
        premises=(),
        expected=PROVED,
        obligations=BOUNCES,
        counts=(Count(name_of(bounces.instants_have_no_bound), bounces.instants_have_no_bound),),
    ),
    Claim(
        id="claim/rows-are-monotone",
        family="steps",
        sentence="In a row of any length that does not close, who wishes to go faster to the right makes nobody slower "
        "to the right.",
        source="6.2.1c; R20",
        about="row/pushed",
        profile=REPAIRED,
        premises=(),
        expected=PROVED,
        obligations=MONOTONE,
    ),
    proved(
        "squeezed-bodies-stand",
        "row/squeezed",
        "In a row of any length, a squeezed body stands and passes nothing on, and so does any in a row that closes.",
        "6.2.1c, 4.2; R20, R31, A2, A7",
        steps.squeezed_bodies_stand,
    ),
    proved(
        "speeds-are-wished",
        "row/pushed",
        "The speed of a body in a row is the greater of its own wish and of what is passed on to it; it passes on that "
        "speed, or nothing.",
        "4.2, 6.2.1c; R6, R20",
        steps.speeds_are_wished,
    ),
    proved(
        "tops-are-chosen",
        "settle/jump",
        "Of two tops a body takes the last one in the direction of its motion; without motion the one that it is over "
        "most, and of equals the first in the level's order.",
        "6.2.1e; R22, R25, A21, A23",
        steps.tops_are_chosen,
    ),
    Claim(
        id="claim/drives-add-up",
        family="steps",
        sentence="In rows of any length, nobody is faster than its support and the fastest drive in its row, added up.",
        source="4.2, 4.4; R20, A27",
        about=STEP_OUT_OF_REACH.id,
        profile=REPAIRED,
        premises=(),
        expected=PROVED,
        obligations=REACH,
    ),
    Claim(
        id="claim/step-invariants-judge",
        family="work",
        sentence="Of each step of a bank of right and wrong ones, each invariant says what is to be said of it.",
        source="6.2.1; R5, R20",
        about="invariants",
        profile=REPAIRED,
        premises=(),
        expected=TESTED,
        counts=(Count("counts/step-invariants-judge", judging_steps.step_invariants_judge),),
    ),
    Claim(
        id="claim/storeys-are-measured",
        family="reference",
        sentence="In each world of a bank of storeys, distances, grounds and neighbours are what they are to be.",
        source="6.2.1; R12, R19, R24",
        about="world",
        profile=REPAIRED,
        premises=(),
        expected=TESTED,
        counts=(Count("counts/storeys-are-measured", measuring.storeys_are_measured),),
    ),
    Claim(
        id="claim/batches-end-alike",
        family="steps",
        sentence="A batch ends where whole steps of small worlds do, wherever it says that they have a closed form.",
        source=STEP_ONE_WAY.source,
        about=STEP_ONE_WAY.id,
        profile=REPAIRED,
        premises=(START,),
        expected=BOUNDED,
        obligations=BATCHES,
        counts=(
            Count("counts/rows-are-laid-out", batching.rows_are_laid_out),
            Count("counts/batches-are-where-events-lead", batching.batches_are_where_events_lead),
        ),
    ),
    Claim(
        id="claim/batches-go-on",
        family="steps",
        sentence="Where a batch says that all keep their speeds for a time, whole steps of any part of it lead each as "
        "far as its speed does in that part.",
        source=STEP_SPLIT.source,
        about=STEP_SPLIT.id,
        profile=REPAIRED,
        premises=(START,),
        expected=BOUNDED,
        obligations=GOING_ON,
        long=True,
    ),
    Claim(
        id="claim/whole-steps",
        family="steps",
        sentence="Whole steps of small worlds, with riders, ledges and one that may not push, keep every invariant, "
        "and so does settling on two round a ring; of some, the mirror image does the mirror image, and they may be "
        "cut in two.",
        source="6.2.1; R5, R20",
        about="invariants",
        profile=REPAIRED,
        premises=(START,),
        expected=BOUNDED,
        obligations=(
            *WHOLE_STEPS,
            *LARGER_STEPS,
            *MIRRORED,
            *SPLIT,
            of_window(stretches.settling_keeps_apart, TWO_BELOW),
        ),
        long=True,
    ),
)
