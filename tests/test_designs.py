"""The designs of a graphbody: wrong ones are caught, and the page says what is counted."""

from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given, settings

from properties.contracts import designs
from properties.contracts.designs import same_place
from properties.contracts.errata import Stage
from properties.designs_page import with_costs
from properties.engine.explore import explore
from properties.given import Exact
from properties.strategies.rows import trials
from reference.designs import Crossing, Leading, by_centre, by_order, crowd_of
from reference.play import LIBRARY, play
from reference.simulator import move
from reference.world import world_of
from spec.designs import BORDERS, DESIGNS, ONE, ONE_CACHED, THREE, TWO, Part, the_centre
from spec.graph import Direction
from spec.profiles import THESIS

PAGE = Path(__file__).parents[1] / "docs" / "designs.md"
RIGHT = Direction.RIGHT


def test_the_page_shows_what_is_counted():
    assert with_costs(PAGE.read_text()) == PAGE.read_text(), "run `make docs`"


def test_a_cost_reads_as_in_table_4_2():
    costs = [str(cost) for pair in designs.PRINTED.values() for cost in pair]
    assert costs == ["M_C", "M + L", "M_C + 2 M", "L", "M_C + M", "L", "M_C + M", "L"]
    assert str(designs.cost_of_a_move(THESIS, THREE, bodies=3, pushed=2)) == "3 M_C + 6 M"


@settings(max_examples=60, deadline=None)
@given(trials())
def test_all_designs_end_with_all_borders_at_the_same_place(trial):
    start = world_of(trial.level)
    plain, body = start.copy(), start.rows[0].order[trial.body]
    move(THESIS, plain, body, trial.direction, trial.asked)
    for design in DESIGNS:
        crowd = crowd_of(design, THESIS, start)
        crowd.move(body, trial.direction, trial.asked)
        for other in start.handles():
            for side in Direction:
                there = plain.coordinate(plain.bodies[other].border(side))
                assert same_place(plain, other, crowd.along(other, Part(side)), there), design.id


@pytest.mark.parametrize("design", DESIGNS, ids=lambda design: design.id)
def test_each_design_plays_the_figures_on_one_string(design):
    for name in ("walls", "valley", "pushing-boxes-5", "ring-of-two", "row-at-vertices"):
        playing = play(LIBRARY / "scenarios" / f"{name}.json")
        crowd = crowd_of(design, THESIS, playing.game.world.copy())
        for step in playing.steps:
            for done in step.moves:
                direction = Direction.LEFT if done.asked < 0 else RIGHT
                moved, _ = crowd.move(playing.game.handles[done.body], direction, abs(done.asked))
                assert moved * direction == done.moved, (name, done)


def broken_by(design):
    """Whether a design is refuted by a row of two."""
    for bodies, edges in ((1, 2), (2, 1)):
        outcome = explore(
            lambda given, size=(bodies, edges): designs.designs_agree(THESIS, given, *size, False, design, 0, RIGHT)
        )
        if outcome.counterexample is not None:
            return outcome.counterexample.broken
    return ()


def test_a_border_that_follows_by_half_is_caught(monkeypatch):
    whole = Crossing.freely
    monkeypatch.setattr(Crossing, "freely", lambda held, at, distance, towards: whole(held, at, distance / 2, towards))
    assert broken_by(TWO) == ("every border is at the same place",)


def test_a_centre_that_stops_for_walls_and_others_as_a_point_is_caught(monkeypatch):
    monkeypatch.setattr("reference.designs.Crossing.leading", leading_as_a_border)
    assert "it moves as far" in broken_by(ONE)
    assert "it moves as far" in broken_by(ONE_CACHED)
    assert broken_by(TWO) == ()


def leading_as_a_border(crossing, body):
    """The view of a border that leads, whatever leads."""
    return Leading(crossing, crossing.crowd.world.facing(crossing.direction), None)


@pytest.mark.parametrize(
    ("method", "wrong", "broken"),
    [
        ("reach", lambda view, at: view.plain.reach(at), "where no edge follows, the wall is as far as it reaches"),
        ("to_wall", lambda view, at: None, "the wall is that of the border"),
        ("end", lambda view, at: view.plain.end(at), "the end of the edge is reached"),
        ("beyond", lambda view, at: view.plain.beyond(at), "where an edge follows, the wall is further than that"),
        ("ahead", lambda view, body, at: None, "on the last edge a body ahead is seen"),
        ("gap", lambda view, at, other: view.plain.gap(at, other), "the gap is that of the borders"),
    ],
)
def test_what_a_centre_sees_wrongly_breaks_a_law(monkeypatch, method, wrong, broken):
    monkeypatch.setattr(Leading, method, wrong)
    found = [
        explore(lambda given, last=last: designs.centres_are_lawful(THESIS, given, RIGHT, False, last)).counterexample
        for last in (False, True)
    ]
    assert broken in {name for one in found if one is not None for name in one.broken}


def test_a_centre_that_is_stored_with_borders_and_leads_is_1ep_cached():
    assert replace(THREE, id=ONE_CACHED.id, leader=the_centre).stands_on(RIGHT) == ONE_CACHED.stands_on(RIGHT)
    assert set(THREE.stored) == set(ONE_CACHED.stored) == {*BORDERS, Part.CENTRE}


def test_without_a_margin_a_border_is_lost_in_floats_and_a_body_walked_into():
    walk = designs.walked_into(THESIS)
    assert walk.left < walk.right < walk.left + 1e-9
    assert walk.end - walk.left == pytest.approx(0.1)


@pytest.mark.parametrize(("design", "neighbour"), [(TWO, by_order), (ONE, by_order), (ONE, by_centre)])
def test_who_knows_the_order_or_looks_for_centres_overlaps_by_rounding_alone(design, neighbour):
    overlaps = [designs.play_line(THESIS, design, neighbour, float, 0.0, seed).overlap for seed in range(100)]
    assert 0 < max(overlaps) < designs.ROUNDING


@pytest.mark.parametrize(("asked", "alike"), [("2", True), ("5/2", False), ("3", False), ("7/2", True)])
def test_a_ledge_is_left_half_a_width_earlier_by_a_centre(asked, alike):
    """A body of width 2 whose centre is 2 before the ledge, and its rear border 3."""
    exact = Exact({"distance asked": asked})
    designs.ledges_are_left_alike(THESIS, exact, Stage())
    assert (exact.broken == []) == alike
