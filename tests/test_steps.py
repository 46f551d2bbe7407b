"""Steps on storeys: what is easily got wrong, the invariants at work on wrong rules, and many games in floats."""

from dataclasses import replace
from fractions import Fraction
from random import Random

import pytest

from properties.contracts.request import judged
from properties.contracts.steps import squeezed_bodies_stand, steps_keep_the_invariants
from properties.engine.explore import explore
from properties.evidence.comparisons import after
from properties.evidence.courses import drive
from properties.evidence.sample import FLOAT_TOLERANCE, ONE_RULE, Campaign, campaign
from properties.evidence.sample_steps import STOREYS
from properties.strategies.storeys import Maker, outing
from properties.worlds.changes import floating, in_floats
from properties.worlds.storeys import Member, Setting
from reference.stepping import COMING
from reference.storeys import Place, StoreyWorld, Terrain
from spec.graph import Direction
from spec.profiles import REPAIRED
from spec.registry import rules_of
from spec.rule import Family
from spec.rules.row import full_speed, its_own, takes_part, the_same
from spec.rules.settle import front_most
from spec.stepped import (
    OF_ONE_STEP,
    STEP_INSTANTS,
    STEP_INSTANTS_OF_ONE,
    STEP_SEAT,
    Course,
    Stretch,
    all_held,
    margins_kept,
    outside_terrain,
)
from spec.storeys import Drive, Interval

STILL = Drive(Fraction(0))


def line(length, margin, *places):
    """The floor of a line."""
    return StoreyWorld(Terrain((), Interval(Fraction(0), Fraction(length))), Fraction(margin), places)


def ring(length, grounds, margin, *places):
    """A ring with grounds one storey up."""
    solid = tuple(Interval(Fraction(left), Fraction(right)) for left, right in grounds)
    return StoreyWorld(Terrain((solid,), None, Fraction(length)), Fraction(margin), places)


def test_a_body_that_goes_nearly_round_a_ring_does_not_fall_through_a_hole_that_it_does_not_fit_into():
    world = ring(4, [(0, 2)], 1, Place(1, Fraction(3), Fraction(3), None))
    course = drive(REPAIRED.rules, world, {0: Drive(Fraction(1))}, Fraction(3), Fraction(0))
    assert course.after.storey(0) == 1


def test_a_ring_that_a_falling_body_closes_stands_still_in_one_step_as_in_two():
    places = (
        Place(0, Fraction(0), Fraction(3), None),
        Place(0, Fraction(8), Fraction(3), None),
        Place(1, Fraction(2), Fraction(3), 0),
    )
    world = StoreyWorld(Terrain((), None, Fraction(12)), Fraction(1), places)
    drives = {0: STILL, 1: STILL, 2: Drive(Fraction(1), relative=False)}
    for durations in ((10,), (2, 8), (5, 5)):
        end = after(REPAIRED.rules, world, drives, *map(Fraction, durations))
        assert [(place.storey, place.left) for place in end.places] == [(0, 0), (0, 8), (0, 4)]


def test_a_squeezed_body_stands_even_if_it_may_not_push_back():
    places = Place(0, Fraction(0), Fraction(2), None), Place(0, Fraction(3), Fraction(2), None, pushes=False)
    world = line(9, 1, *places)
    drives = {0: Drive(Fraction(1), relative=False), 1: Drive(Fraction(-1), relative=False)}
    course = drive(REPAIRED.rules, world, drives, Fraction(1), Fraction(0))
    assert [course.after.span(body).left for body in (0, 1)] == [0, 3]


def test_a_wide_body_is_carried_round_a_ring_by_what_it_is_over_whichever_border_is_nearer():
    places = Place(0, Fraction(0), Fraction(3), None), Place(1, Fraction(0), Fraction(3), 0)
    world = StoreyWorld(Terrain((), None, Fraction(6)), Fraction(1, 4), places)
    for driven in (0, 1):
        course = drive(
            REPAIRED.rules,
            world,
            {driven: Drive(Fraction(1)), 1 - driven: Drive(Fraction(0))},
            Fraction(9),
            Fraction(0),
        )
        assert [course.after.storey(body) for body in (0, 1)] == [0, 1]
        assert len(course.stretches) == 1


@pytest.mark.parametrize("shift", range(0, 40, 3))
def test_a_top_that_holds_at_both_ends_is_front_most_wherever_the_ring_is_cut_open(shift):
    def at(storey, left, width, support=None):
        return Place(storey, Fraction((left + shift) % 40, 8), Fraction(width, 8), support)

    for way, below, start in ((1, 28, 36), (-1, 26, 4)):
        places = at(0, 4, 8), at(0, 25, 14), at(1, below, 10, 1), at(2, start, 24, 2)
        world = StoreyWorld(Terrain((), None, Fraction(5)), Fraction(1, 4), places)
        drives = dict.fromkeys(range(3), STILL) | {3: Drive(Fraction(way), relative=False)}
        end = after(REPAIRED.rules, world, drives, Fraction(1, 2))
        assert (end.storey(3), end.support(3)) == (1, 1)


def test_who_rides_along_while_its_support_falls_takes_the_top_that_it_is_over_most():
    solid = (Interval(Fraction(0), Fraction(6)),)
    terrain = Terrain((solid,), Interval(Fraction(0), Fraction(12)))
    places = (
        Place(1, Fraction(5, 2), Fraction(1), None),
        Place(1, Fraction(15, 4), Fraction(1), None),
        Place(1, Fraction(5), Fraction(1), None),
        Place(2, Fraction(9, 4), Fraction(4), 2),
    )
    world = StoreyWorld(terrain, Fraction(1, 4), places)
    drives = {0: STILL, 1: STILL, 2: Drive(Fraction(1)), 3: STILL}
    course = drive(REPAIRED.rules, world, drives, Fraction(1), Fraction(0))
    assert [course.after.storey(body) for body in (2, 3)] == [0, 2]
    assert [course.after.overlap(3, body) for body in (0, 1)] == [Fraction(1, 4), 1]
    assert course.after.support(3) == 1


def closes_by_falling(one):
    """Whether in a stretch somebody comes down into contact on both sides."""
    after = Stretch(one.after, one.after, one.lasted, one.velocities, one.drives, one.tolerance).contacts
    fallen = [body for body in one.drives if one.after.storey(body) < one.before.storey(body)]
    return any(all((body, side) in after for side in Direction) for body in fallen)


def lands_between_tops(one):
    """Whether in a stretch somebody comes down to two tops of which one holds it at both ends."""
    fallen = [body for body in one.drives if one.after.storey(body) < one.before.storey(body)]
    return any(len(one.after.tops(body)) > len(set(one.after.tops(body))) > 1 for body in fallen)


@pytest.mark.parametrize(
    ("make", "happens", "floor"),
    [
        (lambda maker: maker.exact_fit(Fraction(1, 4), 3), closes_by_falling, 0.1),
        (lambda maker: maker.tower(Fraction(1, 4)), lands_between_tops, 0.1),
    ],
    ids=("one closes a ring by falling", "a top holds one at both ends"),
)
def test_random_rings_are_not_tame(make, happens, floor):
    found = 0
    for number in range(100):
        maker = Maker(Random(number), 4)
        terrain, placed = make(maker)
        drives, world = dict(enumerate(maker.drives(len(placed)))), StoreyWorld(terrain, Fraction(1, 4), placed)
        course = drive(REPAIRED.rules, world, drives, Fraction(3), Fraction(0))
        found += any(map(happens, course.stretches))
    assert found >= floor * 100


@pytest.mark.parametrize("floats", [False, True])
def test_a_short_campaign_holds_is_not_tame_and_fires_every_rule(floats):
    result = campaign(REPAIRED, floats, examples=150, sampling=STOREYS)
    assert result.failures == {}
    assert result.tame == []
    assert {rule.id for rule in rules_of(REPAIRED)} - set(result.shares) == set(COMING)


def with_effect(field, rule_id, effect):
    """The profile with another effect of one rule."""
    family = getattr(REPAIRED.rules, field)
    rules = tuple(replace(rule, effect=effect) if rule.id == rule_id else rule for rule in family.rules)
    return replace(REPAIRED, rules=replace(REPAIRED.rules, **{field: Family(family.id, rules)}))


FAULTS = {
    "a body is as fast as it likes behind a slower one": ("way", "way/slower", full_speed, "step-instants"),
    "nobody is pushed": ("forward", "row/pushed", its_own, "step-progress"),
    "one that may not push pushes": ("relay", "row/passes-nothing", the_same, "step-bystanders"),
    "nobody is squeezed": ("meet", "row/squeezed", takes_part, "step-squeezed"),
    "the support is left late": ("loss", "event/support-lost", lambda one: one.room * 2 / one.speed, "step-support"),
    "a wall is met late": ("wall", "event/wall", lambda one: one.room * 2 / one.speed, "step-terrain"),
    "a contact comes late": ("contact", "event/contact", lambda one: one.room * 2 / one.speed, "step-margin"),
    "the motion does not count": (
        "settle",
        "settle/jump",
        lambda footing: front_most(replace(footing, motion=footing.motion * 0)),
        "step-seat",
    ),
}


@pytest.mark.parametrize("fault", FAULTS, ids=str)
def test_a_wrong_rule_is_caught_by_name(fault):
    field, rule, effect, caught = FAULTS[fault]
    wrong = with_effect(field, rule, effect)
    failures = set()
    for number in range(150):
        seen = campaign_of(wrong, number)
        failures |= set(seen)
        if f"invariant/{caught}" in failures:
            return
    pytest.fail(f"only {failures} failed")


def campaign_of(profile, number):
    """The properties that fail on the world of a number."""
    trial = outing(number, 1 + number % 8, number % 4)
    return STOREYS.failing(profile, trial, False, Campaign(STOREYS)) if trial.places else []


def test_a_family_with_a_hole_is_named():
    way = Family("way", REPAIRED.rules.way.rules[1:])
    failures = [campaign_of(replace(REPAIRED, rules=replace(REPAIRED.rules, way=way)), number) for number in range(3)]
    assert [ONE_RULE] in failures


def test_a_wrong_rule_is_refuted_with_values():
    late = with_effect("contact", "event/contact", lambda one: one.room * 2 / one.speed)
    setting = Setting("a push", (Member(0, Drive(Fraction(1))), Member(0, STILL)))
    outcome = explore(lambda given: judged(lambda p, g: steps_keep_the_invariants(p, g, setting), late, given))
    assert outcome.counterexample is not None
    assert "invariant/step-margin" in outcome.counterexample.broken
    careless = with_effect("meet", "row/squeezed", lambda one: replace(one.member, wish=one.right * 0, pushes=False))
    outcome = explore(lambda given: judged(lambda p, g: squeezed_bodies_stand(p.rules, g), careless, given))
    assert outcome.counterexample is not None
    assert "it stands" in outcome.counterexample.broken


@pytest.mark.parametrize("seed", [0, *(pytest.param(seed, marks=pytest.mark.slow) for seed in range(1, 4))])
def test_float_games_never_stall_and_end_where_they_may(seed):
    random, games = Random(seed), 0
    for number in range(150):
        trial = outing(random.randrange(2**30), 2 + number % 7, number % 4)
        for _ in range(4 if trial.places else 0):
            games += 1
            world = in_floats(trial.world())
            for _ in range(2):
                drives, duration = (
                    any_drives(random, len(trial.places)),
                    random.choice((0.02, 0.1, 1.0, random.random())),
                )
                course = drive(REPAIRED.rules, world, drives, duration, FLOAT_TOLERANCE)
                world = course.after
                assert STEP_INSTANTS.holds(course), number
                assert margins_kept(world, FLOAT_TOLERANCE), number
                assert outside_terrain(world, FLOAT_TOLERANCE), number
                assert all_held(world, FLOAT_TOLERANCE), number
    assert games > 500


def any_drives(random, bodies):
    """Drives in floats: whole speeds, or ones that are not."""
    drives = floating(dict(enumerate(Maker(random, 10).drives(bodies))))
    share = random.choice((1, random.random()))
    return {body: replace(one, speed=one.speed * share) for body, one in drives.items()}


def test_every_invariant_holds_of_a_step_in_which_nothing_happens():
    world = line(9, 1, Place(0, Fraction(0), Fraction(2), None))
    course = drive(REPAIRED.rules, world, {0: STILL}, Fraction(0), Fraction(0))
    assert all(invariant.holds(course) for invariant in OF_ONE_STEP)


def test_more_instants_than_one_drive_can_make_are_noticed():
    world = line(9, 1, Place(0, Fraction(0), Fraction(2), None))
    drives = {0: Drive(Fraction(1))}
    (stretch,) = drive(REPAIRED.rules, world, drives, Fraction(1), Fraction(0)).stretches
    assert STEP_INSTANTS_OF_ONE.holds(Course((stretch,) * 8))
    assert not STEP_INSTANTS_OF_ONE.holds(Course((stretch,) * 9))


@pytest.mark.parametrize(
    ("places", "ground", "way", "seat"),
    [
        ([Place(0, 2, 2, None), Place(0, 5, 2, None), Place(1, 2, 2, 0)], (), Fraction(7, 8), 1),
        ([Place(0, 2, 2, None), Place(1, 2, 2, 0)], (Interval(5, 9),), Fraction(9, 8), None),
        ([Place(0, 2, 1, None), Place(0, Fraction(7, 2), 1, None), Place(1, 2, 3, 0)], (), 0, 1),
    ],
    ids=("onto the next top", "onto the ground", "at rest"),
)
def test_a_body_that_leaves_a_support_that_still_holds_it_is_noticed(places, ground, way, seat):
    terrain = Terrain((tuple(ground),) if ground else (), Interval(0, 20))
    before, mover = StoreyWorld(terrain, Fraction(1, 4), places), len(places) - 1
    after = before.copy()
    after.advance(mover, way)
    still = dict.fromkeys(range(len(places)), Fraction(0))
    drives = dict.fromkeys(still, STILL) | {mover: Drive(Fraction(way and 1), relative=False)}
    speeds = still | {mover: Fraction(way and 1)}
    kept = Stretch(before, after.copy(), Fraction(way or 1), speeds, drives, Fraction(0))
    assert STEP_SEAT.holds(Course((kept,)))
    after.stand(mover, seat)
    assert not STEP_SEAT.holds(Course((replace(kept, after=after),)))
