"""What is proved of steps compared, for any number of bodies, is refuted for wrong rules, worlds and steps."""

from dataclasses import replace

import pytest
from test_any_number import Fault, broken

from properties.claims.repaired import WINDOWS, of_window
from properties.claims.steps_compared import BELOW, CUT, MIRRORED, RENAMED
from properties.contracts import cuts, images, instants
from reference.storeys import StoreyWorld
from spec.graph import Direction
from spec.rules import step
from spec.rules.settle import Found
from spec.storeys import Contact

ALL = {obligation.id: obligation for obligation in (*MIRRORED, *RENAMED, *CUT, *BELOW)}


def most_under_it(footing):
    """The top that a body is over most, of equals the last one."""
    return Found(stands=True, support=max(footing.tops[::-1], key=lambda top: top.overlap).body)


def goes_right(meeting):
    """Who is squeezed goes to the right."""
    return replace(meeting.member, wish=meeting.right)


FAULTS = {
    "it takes the last top": Fault(
        "settle",
        "settle/jump",
        lambda footing: Found(stands=True, support=footing.tops[-1].body),
        "images/tops-look-alike (from behind)",
        "it stands on the same",
    ),
    "of equals the right one": Fault(
        "settle", "settle/jump", most_under_it, "images/tops-look-alike (from behind)", "it stands on the same"
    ),
    "it takes the top that is listed first": Fault(
        "settle",
        "settle/jump",
        lambda footing: Found(stands=True, support=min(top.body for top in footing.tops)),
        "images/tops-look-alike (in another order)",
        "it stands on the same",
    ),
    "who falls takes the top that is listed first": Fault(
        "settle",
        "settle/jump",
        lambda footing: Found(stands=True, support=min(top.body for top in footing.tops)),
        "images/settling-looks-alike (one above two, in another order)",
        "all settle alike",
    ),
    "the right wins": Fault(
        "meet", "row/squeezed", goes_right, "images/members-look-alike (from behind)", "it takes part alike"
    ),
    "the first one is not pushed": Fault(
        "forward",
        "row/pushed",
        lambda turn: turn.own if turn.body == 0 else turn.passed,
        "images/members-look-alike (in another order)",
        "the same reaches it, and goes on",
    ),
    "the second one is not squeezed": Fault(
        "meet",
        "row/squeezed",
        lambda meeting: meeting.member if meeting.body else replace(meeting.member, wish=meeting.right * 0),
        "images/rows-look-alike (in another order)",
        "both are as fast",
    ),
    "all wish to go to the right": Fault(
        "wish",
        "wish/plane",
        lambda urge: urge.drive.speed if urge.drive.speed >= 0 else urge.drive.speed * -1,
        "images/facts-look-alike (from behind)",
        "it wishes the same",
    ),
    "a ride to the right only": Fault(
        "wish",
        "wish/carried",
        lambda urge: urge.carried + urge.drive.speed if urge.carried >= 0 else urge.drive.speed,
        "images/velocities-look-alike (one on another, from behind)",
        "all are as fast",
    ),
    "a contact is late if the right one is listed first": Fault(
        "contact",
        "event/contact",
        lambda one: one.room * (2 if one.mark.left > one.mark.right else 1) / one.speed,
        "images/facts-look-alike (in another order)",
        "contact: it comes at the same time",
    ),
    "what comes comes in twice the time": Fault(
        "wall",
        "event/wall",
        lambda one: one.room * 2 / one.speed,
        "cuts/time-goes-by",
        "wall: it comes in what is left of the time",
    ),
    "a push adds to the speed": Fault(
        "forward",
        "row/pushed",
        lambda turn: turn.own + turn.passed,
        "parting/who-part-are-as-fast (both push)",
        "it is as fast ahead",
    ),
    "who is squeezed goes on": Fault(
        "meet", "row/squeezed", goes_right, "parting/who-is-beyond-is-as-fast (right)", "it passes on the same again"
    ),
    "a wall throws back": Fault(
        "way",
        "way/wall",
        lambda way: way.speed - 1,
        "parting/who-leaves-a-wall-is-as-fast (right)",
        "it is as fast ahead",
    ),
}


@pytest.mark.parametrize("fault", FAULTS.values(), ids=FAULTS)
def test_a_wrong_rule_is_refuted_with_values(fault):
    assert fault.told_by(ALL)


def test_a_world_that_is_not_the_same_from_behind_is_refuted(monkeypatch):
    right = StoreyWorld.to_loss

    def to_loss(world, body, direction):
        room = right(world, body, direction)
        return room if room is None or direction is Direction.RIGHT else room + world.margin

    monkeypatch.setattr(StoreyWorld, "to_loss", to_loss)
    assert "the same comes nearer: room" in broken(ALL["images/worlds-look-alike (one on another, from behind)"])


def test_who_is_seen_by_what_carries_it_is_refuted(monkeypatch):
    right = StoreyWorld.to_wall

    def to_wall(world, body, direction):
        ridden = any(place.support == body for place in world.places)
        return None if ridden else right(world, body, direction)

    monkeypatch.setattr(StoreyWorld, "to_wall", to_wall)
    assert broken(ALL["images/worlds-look-alike (one on another, without the rider)"])


def test_one_that_goes_further_in_one_direction_is_refuted(monkeypatch):
    right = StoreyWorld.advance
    monkeypatch.setattr(
        StoreyWorld, "advance", lambda world, body, way: right(world, body, way * 2 if way > 0 else way)
    )
    assert "all have gone the same way" in broken(ALL["images/ways-look-alike (alone, from behind)"])


def test_records_that_are_kept_on_one_side_only_are_refuted(monkeypatch):
    def lasting(ways, marks):
        left = step.lasting(ways, marks)
        return {mark for mark in left if not (isinstance(mark, Contact) and ways[mark.left] < ways[mark.left] * 0)}

    monkeypatch.setattr(images, "lasting", lasting)
    assert "the same is left" in broken(ALL["images/records-look-alike (from behind)"])


def test_a_step_that_records_late_or_forgets_is_refuted(monkeypatch):
    recorded = ALL["cuts/what-comes-is-nearer (two)"]
    monkeypatch.setattr(step, "lasting", lambda ways, marks: marks)
    assert "what is recorded is what touches" in broken(recorded)
    monkeypatch.setattr(step, "lasting", lambda ways, marks: set())
    assert "what is recorded is what touches" in broken(recorded)


def test_a_step_that_records_too_little_when_bodies_have_settled_is_refuted(monkeypatch):
    recorded = of_window(instants.what_touches_is_recorded_when_settled, WINDOWS[0])
    monkeypatch.setattr(instants, "settled", step.present)
    assert "what touches is recorded, and what was lost" in broken(recorded)
    monkeypatch.setattr(instants, "settled", lambda world, marks: step.touching(world))
    assert "what touches is recorded, and what was lost" in broken(recorded)


def test_a_step_that_goes_on_too_long_is_refuted(monkeypatch):
    monkeypatch.setattr(cuts, "go_on", lambda world, ways, time, marks: step.go_on(world, ways, time * 2, marks))
    assert "the same comes nearer: room" in broken(ALL["cuts/what-comes-is-nearer (two)"])


def test_a_step_that_does_not_stop_at_the_first_event_is_refuted(monkeypatch):
    def at_the_end(coming, left):
        return step.Instant(left, tuple(coming), last=True)

    monkeypatch.setattr(cuts, "next_instant", at_the_end)
    assert "nothing comes before the cut" in broken(ALL["cuts/instants-are-the-same"])
