"""What is proved of steps for any number of bodies is refuted for wrong rules, and for wrong steps."""

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from functools import partial
from itertools import chain, pairwise, product
from typing import NamedTuple

import numpy as np
import pytest
from library import first_step
from test_steps import with_effect

from properties.claims.repaired import (
    BOUNCES,
    FURTHEST,
    KEPT,
    LOSSES,
    MONOTONE,
    ROWS,
    SETTLED,
    STRETCHES,
    TIMES,
    WINDOWS,
    of_window,
)
from properties.closed_form import furthest, supports_in_one_row
from properties.contracts import bounces, endings, one_drive, stretches
from properties.contracts.request import judged
from properties.engine.explore import explore
from properties.evidence.courses import drive
from reference import batch
from reference.storeys import StoreyWorld
from spec.conditions import Condition
from spec.graph import Direction
from spec.profiles import REPAIRED
from spec.rule import Family
from spec.rules import step
from spec.rules.row import full_speed, its_own, no_speed, stands_still, standstill, takes_part, the_same
from spec.rules.settle import Found, front_most
from spec.storeys import Contact, Seat

RESTS = {
    obligation.id: obligation
    for obligation in (*ROWS, *SETTLED, *STRETCHES, *TIMES, *FURTHEST, *KEPT, *MONOTONE, *BOUNCES)
}
LATE = "stretches/room-is-used-up-in-time"
FAR = "one_drive/bodies-go-as-far-as-they-may (right)"


def broken(obligation, profile=REPAIRED):
    """What of an obligation is broken, with exact values."""
    found = explore(partial(judged, obligation.program, profile)).counterexample
    return () if found is None else found.broken


class Fault(NamedTuple):
    """A wrong effect of a rule, and the obligation that tells, with what it says."""

    field: str
    rule: str
    effect: Callable
    obligation: str
    says: str

    def told_by(self, obligations):
        """Whether its obligation, one of these, is broken as it says."""
        wrong = with_effect(self.field, self.rule, self.effect)
        return self.says in broken(obligations[self.obligation], wrong)


FAULTS = {
    "as fast as it likes": Fault(
        "way", "way/slower", full_speed, "steps/contacts-do-not-close", "they do not come nearer"
    ),
    "nobody is pushed": Fault(
        "forward", "row/pushed", its_own, "sweeps/motion-has-causes (right)", "who is urged is reached"
    ),
    "it pushes though it may not": Fault(
        "relay", "row/passes-nothing", the_same, "sweeps/motion-has-causes (left)", "who is urged is reached"
    ),
    "nobody is squeezed": Fault("meet", "row/squeezed", takes_part, "sweeps/speeds-meet-once", "it is held"),
    "the ground moves": Fault(
        "wish", "wish/carried", lambda urge: urge.drive.speed, "steps/wishes-are-of-drives", "it wishes so"
    ),
    "a contact late": Fault(
        "contact", "event/contact", lambda one: one.room * 2 / one.speed, LATE, "contact: the way to it is the room"
    ),
    "a wall late": Fault(
        "wall", "event/wall", lambda one: one.room * 2 / one.speed, LATE, "wall: the way to it is the room"
    ),
    "a loss late": Fault(
        "loss", "event/support-lost", lambda one: one.room * 2 / one.speed, LATE, "loss: the way to it is the room"
    ),
    "the motion does not count": Fault(
        "settle",
        "settle/jump",
        lambda footing: front_most(replace(footing, motion=footing.motion * 0)),
        "stretches/settling-keeps-apart (one above two)",
        "invariant/step-seat",
    ),
    "it stands on air": Fault(
        "settle",
        "settle/fall",
        lambda footing: Found(stands=True, support=None),
        "stretches/settling-keeps-apart (one above another)",
        "invariant/step-support",
    ),
    "who is pushed stays behind": Fault("forward", "row/pushed", its_own, FAR, "it is as far as the closed form says"),
    "nothing is passed on": Fault(
        "relay", "row/passes-on", no_speed, FAR, "it goes if it is reached and is not at its limit"
    ),
    "all are held": Fault("meet", "row/one-way", stands_still, FAR, "it is as far as the closed form says"),
    "nobody goes": Fault("way", "way/open", standstill, FAR, "it goes if it is reached and is not at its limit"),
    "who is carried stays behind": Fault(
        "wish",
        "wish/carried",
        lambda urge: urge.drive.speed,
        "one_drive/wishes-go-one-way",
        "it wishes its drive, or what its support does",
    ),
}


FAULTS |= {
    "who is fast stops behind a slower one": Fault(
        "way", "way/slower", standstill, "endings/faster-wishes-slow-nobody (right)", "it goes no slower"
    ),
    "nobody is squeezed above a slot": Fault(
        "meet", "row/squeezed", takes_part, "bounces/two-bounces-make-way", "it loses the one, then the other"
    ),
    "who is faster passes less on": Fault(
        "relay",
        "row/passes-on",
        lambda relay: relay.speed if relay.speed <= 1 else relay.speed * 0,
        "endings/faster-wishes-pass-on-no-less (left)",
        "no less goes on",
    ),
}


@pytest.mark.parametrize("fault", FAULTS.values(), ids=FAULTS)
def test_a_wrong_rule_is_refuted_with_values(fault):
    assert fault.told_by(RESTS)


def test_a_step_that_goes_on_too_long_or_records_wrongly_is_refuted(monkeypatch):
    monkeypatch.setattr(stretches, "go_on", lambda world, ways, time, marks: step.go_on(world, ways, time * 2, marks))
    kept = of_window(stretches.stretches_keep_apart, WINDOWS[0])
    assert "invariant/step-motion" in broken(kept)
    monkeypatch.setattr(stretches, "go_on", step.go_on)
    monkeypatch.setattr(step, "lasting", lambda ways, marks: marks)
    assert "what is recorded is so" in broken(kept)


def test_a_step_that_does_not_stop_at_the_first_event_is_refuted(monkeypatch):
    def at_the_end(coming, left):
        return step.Instant(left, tuple(coming), last=True)

    monkeypatch.setattr(stretches, "next_instant", at_the_end)
    assert "nothing comes before" in broken(RESTS["stretches/no-event-is-passed-over"])


def test_who_falls_next_to_another_without_looking_is_refuted(monkeypatch):
    blind = replace(REPAIRED.rules.settle, rules=[r for r in REPAIRED.rules.settle.rules if r.id != "settle/jump"])
    falls = replace(blind.rules[-1], guard=blind.rules[-1].guard[:2])
    wrong = replace(REPAIRED, rules=replace(REPAIRED.rules, settle=Family("settle", (*blind.rules[:-1], falls))))
    assert "invariant/step-margin" in broken(of_window(stretches.settling_keeps_apart, LOSSES[0]), wrong)


def test_a_step_in_which_one_loses_what_it_keeps_up_with_is_refuted(monkeypatch):
    monkeypatch.setattr(endings, "losses", lambda world, speeds: step.losses(world, {**speeds, 0: speeds[0] * 0}))
    kept = RESTS["endings/who-keeps-up-keeps-its-support (one on another)"]
    assert "it does not come nearer to its loss" in broken(kept)


def test_a_world_that_says_too_early_that_a_support_is_lost_is_refuted(monkeypatch):
    right = StoreyWorld.to_loss
    lost = RESTS["endings/what-is-lost-stays-lost (one on another)"]
    assert broken(lost) == ()
    monkeypatch.setattr(StoreyWorld, "to_loss", lambda self, body, way: right(self, body, way) - self.margin)
    assert "it is not held" in broken(lost)


def test_a_wrong_closed_form_is_refuted(monkeypatch):
    right = batch.accumulate

    def without_walls_beyond_the_next(operation, values, storey, direction):
        if operation is not np.minimum:
            right(operation, values, storey, direction)

    assert broken(RESTS["one_drive/sums-are-the-closed-form"]) == ()
    monkeypatch.setattr(batch, "accumulate", without_walls_beyond_the_next)
    assert "they agree" in broken(RESTS["one_drive/sums-are-the-closed-form"])


def test_a_closed_form_that_sweeps_walls_to_one_side_only_is_refuted(monkeypatch):
    right = batch.accumulate

    def to_the_left(operation, values, storey, direction):
        right(operation, values, storey, Direction.LEFT if operation is np.minimum else direction)

    monkeypatch.setattr(batch, "accumulate", to_the_left)
    assert "they agree" in broken(RESTS["one_drive/sums-are-the-closed-form"])


def test_what_the_closed_form_takes_for_granted_of_worlds_is_refuted_of_wrong_ones(monkeypatch):
    anything = Condition("condition/storeys-start", "Anything.", "-", lambda world, tolerance: True)
    monkeypatch.setattr(one_drive, "STOREYS_START", anything)
    assert "they are in order" in broken(RESTS["one_drive/supports-are-in-order (two on two)"])
    monkeypatch.setattr(StoreyWorld, "free_between", lambda world, left, right: True)
    assert "no wall is between them" in broken(RESTS["one_drive/no-wall-is-between (two and a wall)"])


def test_a_closed_form_that_counts_rooms_from_the_wrong_side_is_refuted(monkeypatch):
    right = one_drive.as_closed_form
    monkeypatch.setattr(
        one_drive, "as_closed_form", lambda far, limit, wished, pushed: right(far, limit, wished, pushed * -1)
    )
    assert "it is as far as the closed form says" in broken(RESTS[FAR])
    assert "they agree" in broken(RESTS["one_drive/sums-are-the-closed-form"])


def test_a_wall_between_supports_leaves_who_was_pushed_ahead_of_the_closed_form():
    world, drives, duration = first_step("repaired-wall-between-supports")
    places, ahead = list(world.places), len(world.places) - 1
    course = drive(REPAIRED.rules, world, drives, duration, Fraction(0))
    assert [place.support for place in course.after.places] == [place.support for place in places]
    assert course.after.span(ahead).left - places[ahead].left == 4
    assert furthest(world, drives, duration)[ahead] == 2
    assert not supports_in_one_row(world)


def test_another_number_of_instants_than_that_of_bounces_is_noticed():
    free = with_effect("meet", "row/squeezed", takes_part)
    with pytest.raises(AssertionError, match="quarterings"):
        bounces.instants_have_no_bound(free)


class Storey:
    """A storey with some bodies."""

    def __init__(self, bodies):
        self.bodies = range(bodies)

    def row(self, storey):
        """All of them."""
        return self.bodies


@pytest.mark.parametrize("bodies", range(1, 8))
def test_rows_are_of_bodies_whose_contacts_are_recorded(bodies):
    pairs = [Contact(body, (body + 1) % bodies) for body in range(bodies)] if bodies > 1 else []
    for touch in product((False, True), repeat=len(pairs)):
        marks = {pair for pair, touches in zip(pairs, touch, strict=True) if touches} | {Seat(0, 0, None)}
        found = list(step.rows(Storey(bodies), 0, marks))
        behind = {Contact(*pair) for row, _ in found for pair in pairwise(row)}
        closed = [row for row, closes in found if closes]
        assert sorted(chain.from_iterable(row for row, _ in found)) == list(range(bodies))
        assert behind == {mark for mark in marks if isinstance(mark, Contact)} - {
            Contact(row[-1], row[0]) for row in closed
        }
        assert bool(closed) == (bool(pairs) and all(touch))


def test_a_world_in_which_only_the_nearer_end_of_a_top_counts_is_refuted(monkeypatch):
    one = next(one for one in SETTLED if one.id.startswith("stretches/tops-are-in-order"))
    outcome = explore(lambda given: judged(one.program, REPAIRED, given))
    assert outcome.exhaustive
    assert outcome.counterexample is None
    monkeypatch.setattr(StoreyWorld, "offsets", lambda world, body, below: [world.offset(body, below)])
    outcome = explore(lambda given: judged(one.program, REPAIRED, given))
    assert outcome.counterexample is not None
    assert "nobody is further" in outcome.counterexample.broken
