"""The batch: its closed form against the events, where it fits and where not, in exact numbers and in floats."""

from dataclasses import replace
from fractions import Fraction
from functools import cache

import numpy as np
import pytest
from library import first_step

from properties.claims.repaired import BATCHES, GOING_ON
from properties.closed_form import by_batch
from properties.contracts.batching import batches_are_where_events_lead
from properties.contracts.request import judged
from properties.engine.explore import explore
from properties.evidence.comparisons import one_way_alike
from properties.evidence.courses import drive
from properties.strategies.storeys import Outing, outing
from properties.worlds.changes import backwards, floating, in_floats, mirrored
from reference import batch as batches
from reference.batch import Batch, Drives, accumulate, drives_of, storey_of
from reference.rounding import ROUNDINGS, UNIT_ROUNDOFF
from reference.storeys import Place, StoreyWorld, Terrain
from spec.graph import Direction
from spec.profiles import REPAIRED
from spec.storeys import Drive, Interval

ZERO = Fraction(0)
STILL = Drive(ZERO)


def solid(*pieces):
    """Terrain on one storey."""
    return tuple(Interval(Fraction(left), Fraction(right)) for left, right in pieces)


def line(length, storeys, *bodies):
    """A line with terrain on its storeys, and bodies: storey, left border, width, support."""
    places = [Place(storey, Fraction(left), Fraction(width), on) for storey, left, width, on in bodies]
    return StoreyWorld(Terrain(storeys, Interval(Fraction(0), Fraction(length))), Fraction(1, 4), places)


def driven(world, **speeds):
    """One body is driven in the plane, all others stand."""
    walking = {int(name[1:]): Drive(Fraction(speed), relative=False) for name, speed in speeds.items()}
    return dict.fromkeys(range(len(world.places)), STILL) | walking


def lefts(world):
    """Where all bodies are."""
    return [place.left for place in world.places]


def seats(world):
    """What all bodies stand on."""
    return [(place.storey, place.support) for place in world.places]


def by_events(world, drives, duration):
    """The world after a step from event to event."""
    return drive(REPAIRED.rules, world, drives, duration, duration * 0).after


def outings(many, first=0):
    """Random worlds and steps, with one to eight bodies."""
    made = (outing(first + seed, 1 + seed % 8, seed % 4) for seed in range(many))
    return [one for one in made if one.places]


OVER_A_WALL, ABOVE, TIME = first_step("repaired-wall-between-supports")
"""One rider is stopped by a wall before the next one sets off, and what they carry is in contact above that wall."""


def test_a_row_above_a_wall_that_stops_one_support_before_the_other_begins_has_no_closed_form():
    moved = by_events(OVER_A_WALL, ABOVE, TIME).places[5].left - OVER_A_WALL.places[5].left
    assert moved == 4
    assert by_batch(OVER_A_WALL, ABOVE, TIME) is None
    assert by_batch(mirrored(OVER_A_WALL), backwards(ABOVE), TIME) is None
    quarter = Fraction(1, 4)
    assert by_batch(OVER_A_WALL, ABOVE, quarter) == {0: quarter, 1: 0, 2: quarter, 3: 0, 4: quarter, 5: quarter}


def test_several_that_walk_at_one_speed_have_a_closed_form_and_two_speeds_have_none():
    world = line(30, (), (0, 1, 1, None), (0, 4, 1, None), (1, 4, 1, 1), (0, 7, 1, None))
    drives = driven(world, b0=2, b1=2)
    far = by_batch(world, drives, Fraction(3, 2))
    assert far == {0: 3, 1: 3, 2: 3, 3: Fraction(5, 4)}
    assert by_batch(world, driven(world, b0=2, b1=1), Fraction(3, 2)) is None
    assert by_batch(world, driven(world, b0=1, b1=-1), Fraction(1, 8)) is None


def test_who_just_loses_its_support_at_the_end_of_a_step_goes_by_events():
    world = line(30, (solid((0, 5)),), (1, 3, 1, None))
    assert by_batch(world, driven(world, b0=1), Fraction(2)) is None
    assert by_batch(world, driven(world, b0=1), Fraction(15, 8)) == {0: Fraction(15, 8)}
    rider = line(30, (), (0, 3, 1, None), (1, 3, 1, 0))
    assert by_batch(rider, driven(rider, b1=-1), Fraction(5, 4)) is None
    assert by_batch(rider, driven(rider, b1=-1), Fraction(1)) == {0: 0, 1: -1}


def test_a_hole_holds_who_does_not_fit_into_it():
    world = line(30, (solid((0, 5), (6, 9)),), (1, 3, 2, None))
    assert by_batch(world, driven(world, b0=1), Fraction(5)) == {0: 5}
    assert by_batch(line(30, (solid((0, 5), (7, 9)),), (1, 3, 2, None)), driven(world, b0=1), Fraction(5)) is None


def test_a_rider_that_is_pushed_off_its_support_before_that_follows_it_to_a_wall_goes_by_events():
    bodies = (0, 0, 6, None), (0, 10, 1, None), (1, 6, 3, 0), (1, Fraction(19, 2), 1, 1)
    world = line(30, ((), solid((13, 14))), *bodies)
    drives, duration = driven(world, b0=1), Fraction(23, 4)
    assert by_events(world, drives, duration).places[3].storey == 0
    assert by_batch(world, drives, duration) is None
    assert by_batch(world, drives, Fraction(3, 2)) == {0: Fraction(3, 2), 1: 0, 2: Fraction(3, 2), 3: Fraction(5, 4)}


@pytest.mark.parametrize("first", [0, pytest.param(10_000, marks=pytest.mark.slow)])
def test_many_levels_at_once_are_where_events_lead_in_exact_numbers(first):
    made = outings(200 if first == 0 else 2000, first)
    batch = Batch([one.world() for one in made], REPAIRED.rules)
    drives, durations = drives_of([one.drives_by_body for one in made]), np.array([one.duration for one in made])
    batch.drive(drives)
    for _ in range(2):
        before = [batch.world(level) for level in range(len(made))]
        batch.step(durations)
        assert 0.1 < batch.fits.mean() < 0.5
        for level, one in enumerate(made):
            after = by_events(before[level], one.drives_by_body, one.duration)
            assert batch.world(level).places == after.places
            assert batch.world(level).rows == after.rows


@pytest.mark.parametrize("many", [300, pytest.param(3000, marks=pytest.mark.slow)])
def test_many_levels_at_once_are_within_roundings_of_where_events_lead_exactly(many):
    made = outings(many, 50_000)
    batch = Batch([in_floats(one.world()) for one in made], REPAIRED.rules, slack=2.0**-40)
    drives, durations = drives_of([floating(one.drives_by_body) for one in made]), [float(one.duration) for one in made]
    before = [exactly(batch.world(level)) for level in range(len(made))]
    batch.drive(drives)
    batch.step(np.array(durations))
    assert batch.fits.mean() > 0.1
    for level in np.flatnonzero(batch.fits).tolist():
        after = by_events(before[level], made[level].drives_by_body, Fraction(durations[level]))
        assert seats(after) == seats(before[level])
        most = UNIT_ROUNDOFF["float64"] * ROUNDINGS * max(after.ends.right, after.ends.left)
        off = [abs(Fraction(now) - right) for now, right in zip(lefts(batch.world(level)), lefts(after), strict=True)]
        assert max(off) <= most


def ticks_agree(made, ticks):
    """Whether a batch is where events lead after each of some ticks, of which the second half is driven backwards."""
    batch, durations = Batch([one.world() for one in made], REPAIRED.rules), [one.duration / ticks for one in made]
    for tick in range(ticks):
        turned = [backwards(one.drives_by_body) if 2 * tick >= ticks else one.drives_by_body for one in made]
        before = [batch.world(level) for level in range(len(made))]
        batch.drive(drives_of(turned))
        batch.step(np.array(durations))
        for level, step in enumerate(zip(before, turned, durations, strict=True)):
            if batch.world(level).places != by_events(*step).places:
                return False
    return True


def test_tick_after_tick_levels_are_where_events_lead_in_exact_numbers():
    assert ticks_agree(outings(40), 8)


def all_straight(batch, layout, far, durations, right=Batch.straight):
    """As if all kept their speeds all the time."""
    return right(batch, layout, far, durations)[0], np.ones(len(durations), bool)


def goes_on(batch, levels):
    """As if nothing came any more."""
    batch.ahead[levels] = 1000
    return levels


def not_heard(batch, drives, right=Batch.drive):
    """As if levels in which drives change went on."""
    ahead = batch.ahead.copy()
    right(batch, drives)
    batch.ahead = ahead


def always_straight(batch, level, duration, right=Batch.run):
    """As if nothing came in steps without a closed form."""
    before = lefts(batch.world(level))
    world, rates = right(batch, level, duration)
    return world, rates or [(now - left) / (duration or 1) for now, left in zip(lefts(world), before, strict=True)]


def always_kept(batch, level):
    """As if, without a closed form, nothing came any more."""
    batch.ahead[level] = 1000
    return True


def of_others(layout, levels, right=batches.part_of):
    """The layout of other levels."""
    return right(layout, np.roll(levels, 1))


@pytest.mark.parametrize(
    ("place", "name", "wrong"),
    [
        (Batch, "straight", all_straight),
        (Batch, "go_on", goes_on),
        (Batch, "drive", not_heard),
        (Batch, "run", always_straight),
        (Batch, "kept_by_rules", always_kept),
        (batches, "part_of", of_others),
    ],
)
def test_a_batch_that_goes_on_wrongly_is_not_where_events_lead(monkeypatch, place, name, wrong):
    monkeypatch.setattr(place, name, wrong)
    assert not ticks_agree(outings(40), 8)


def test_while_nothing_comes_levels_are_looked_at_seldom(monkeypatch):
    looks, right = [], Batch.look
    monkeypatch.setattr(Batch, "look", lambda batch, *rest: (looks.append(1), right(batch, *rest)))
    world = line(30, (), (0, 1, 1, None), (0, 3, 1, None), (1, 3, 1, 1))
    batch = Batch([in_floats(world)], REPAIRED.rules)
    batch.drive(drives_of([floating(driven(world, b0=1))]))
    for _ in range(2500):
        batch.step(np.array([0.01]))
    assert batch.left.tolist() == pytest.approx([26, 27.25, 27.25])
    assert len(looks) < 50


def test_in_floats_a_row_that_is_pushed_tick_by_tick_is_within_roundings_of_where_it_comes_exactly():
    world = in_floats(line(28, (), *[(0, Fraction(1 + 14 * i, 10), Fraction(1, 3), None) for i in range(8)]))
    batch, tick = Batch([world], REPAIRED.rules), 0.013
    speeds = [1, *[0] * 7]
    batch.drive(drives_of([{body: Drive(float(speed), relative=False) for body, speed in enumerate(speeds)}]))
    drives = {body: Drive(Fraction(speed), relative=False) for body, speed in enumerate(speeds)}
    for number in range(2000):
        before = batch.world(0)
        batch.step(np.array([tick]))
        if number % 25 == 0:
            after = by_events(exactly(before), drives, Fraction(tick))
            off = [abs(Fraction(now) - right) for now, right in zip(lefts(batch.world(0)), lefts(after), strict=True)]
            assert max(off) <= batch.speck[0]
    assert batch.left[-1] == pytest.approx(28 - 1 / 3)


def test_in_floats_who_walks_as_slowly_as_roundings_does_not_stand():
    world = line(30, (), (0, 1, 1, None), (0, 9, 1, None))
    batch = Batch([in_floats(world)], REPAIRED.rules)
    way = float(batch.speck[0]) * 3 / 4
    batch.drive(drives_of([floating(driven(world, b0=1))]))
    for _ in range(1000):
        batch.step(np.array([way]))
    assert batch.left[0] - 1 == pytest.approx(1000 * way, rel=0.01)


def exactly(world):
    """A world of floats in exact numbers."""
    ends, margin = world.ends, Fraction(world.margin)
    storeys = tuple(solid(*((one.left, one.right) for one in storey)) for storey in world.terrain.solid)
    places = [replace(one, left=Fraction(one.left), width=Fraction(one.width)) for one in world.places]
    round_ = world.circumference
    terrain = Terrain(
        storeys, ends and Interval(Fraction(ends.left), Fraction(ends.right)), round_ and Fraction(round_)
    )
    return StoreyWorld(terrain, margin, places)


def test_in_floats_who_stands_stays_to_the_bit_and_rows_do_not_creep():
    bodies = [(0, Fraction(1 + 6 * i, 10), Fraction(1, 3), None) for i in range(10)]
    batch = Batch([in_floats(line(30, (), *bodies))], REPAIRED.rules)
    drives = drives_of([{0: Drive(1.0)} | {body: Drive(0.0) for body in range(1, 10)}])
    batch.drive(drives)
    batch.step(np.array([3.3]))
    rest = batch.left.copy()
    batch.drive(Drives(drives.speed * 0, drives.relative))
    for _ in range(100):
        batch.step(np.array([1.0]))
    assert np.array_equal(batch.left, rest)


WRONG = {
    "rooms": lambda layout, storey, left, right=batches.rooms: right(layout, storey, left) * 0,
    "lost": lambda layout, left, *rest: np.zeros(len(left), bool),
    "several_speeds": lambda level, speed: np.zeros(len(level), bool),
    "differ": lambda groups, values, many: np.zeros(many, bool),
    "accumulate": lambda operation, values, storey, direction: None,
}


@cache
def with_courses():
    """Some outings, each with its course, of which the batch knows where it leads."""
    places, drives = tuple(OVER_A_WALL.places), tuple(ABOVE.values())
    above = Outing(OVER_A_WALL.terrain, OVER_A_WALL.margin, places, drives, TIME, ZERO, ())
    made = [*outings(150), above]
    found = [(one, drive(REPAIRED.rules, one.world(), one.drives_by_body, one.duration, ZERO)) for one in made]
    assert all(one_way_alike(REPAIRED.rules, *pair) for pair in found)
    return found


@pytest.mark.parametrize("name", WRONG)
def test_a_wrong_batch_is_not_where_events_lead(monkeypatch, name):
    found = with_courses()
    monkeypatch.setattr(batches, name, WRONG[name])
    assert not all(one_way_alike(REPAIRED.rules, *pair) for pair in found)


@pytest.mark.parametrize("name", WRONG)
def test_a_wrong_batch_is_caught_by_a_world_of_the_bank(monkeypatch, name):
    assert batches_are_where_events_lead(REPAIRED) > 500
    monkeypatch.setattr(batches, name, WRONG[name])
    with pytest.raises(AssertionError):
        batches_are_where_events_lead(REPAIRED)


def test_a_wrong_batch_is_refuted(monkeypatch):
    pushes = next(one for one in BATCHES if "(a push)" in one.id)
    outcome = explore(lambda given: judged(pushes.program, REPAIRED, given))
    assert outcome.exhaustive
    assert outcome.counterexample is None
    assert outcome.promises > 0
    monkeypatch.setattr(batches, "rooms", WRONG["rooms"])
    outcome = explore(lambda given: judged(pushes.program, REPAIRED, given))
    assert outcome.counterexample is not None
    assert "they are so far on" in outcome.counterexample.broken


def test_a_batch_in_which_all_are_said_to_keep_their_speeds_is_refuted(monkeypatch):
    pushes = next(one for one in GOING_ON if "(a push)" in one.id)
    monkeypatch.setattr(Batch, "straight", all_straight)
    outcome = explore(lambda given: judged(pushes.program, REPAIRED, given))
    assert outcome.counterexample is not None
    assert "they are so far on" in outcome.counterexample.broken


@pytest.mark.parametrize("lengths", [[1], [5], [4, 4, 2, 1, 1], [3] * 150, [3] * 150 + [2] * 40 + [1]], ids=len)
@pytest.mark.parametrize("direction", Direction)
def test_rows_of_any_lengths_are_swept_from_end_to_end(lengths, direction):
    place = np.array([at for at in range(lengths[0]) for length in lengths if length > at])
    row = np.array([one for at in range(lengths[0]) for one, length in enumerate(lengths) if length > at])
    storey = storey_of(0, place, np.array([], int))
    assert [row[before] for before in storey.behind] == row[storey.first :].tolist()
    assert [place[before] + 1 for before in storey.behind] == place[storey.first :].tolist()
    values = np.random.default_rng(17).permutation(len(place)).astype(float)
    expected = values.copy()
    for one in range(len(lengths)):
        expected[row == one] = np.maximum.accumulate(values[row == one][::direction])[::direction]
    accumulate(np.maximum, values, storey, direction)
    assert values.tolist() == expected.tolist()
