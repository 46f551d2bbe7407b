"""The programs that `make bench` times say what they should: all of them prove the claim, and refute a wrong one."""

import pytest
from benchmarks import claim
from benchmarks.other import crosshair
from benchmarks.steps import SPEED, TICK, Pushed, at_once, by_events, of_random_levels

RIGHT, WRONG = claim.Numbers(), claim.Numbers(lacking=1)
WAYS = {
    "paths": lambda numbers: claim.by_paths(2, 2, numbers),
    "merged": lambda numbers: claim.by_merging(2, 2, numbers),
    "contract": claim.by_contract,
}


@pytest.mark.parametrize("way", WAYS)
def test_each_way_proves_the_claim(way):
    assert claim.verdict(WAYS[way](RIGHT)) == "proved"


@pytest.mark.parametrize("way", WAYS)
def test_each_way_refutes_the_claim_of_a_margin_that_is_one_off(way):
    assert claim.verdict(WAYS[way](WRONG)) == "refuted"


def test_the_claim_holds_on_the_simulator():
    assert claim.verdict(claim.by_simulator(2)) == "proved"


@pytest.mark.parametrize(("lacking", "concluded"), [(0, "confirmed"), (1, "refuted")])
def test_crosshair_agrees(lacking, concluded):
    assert crosshair(2, 2, lacking, most_seconds=60)["verdict"] == concluded


def test_more_bodies_than_two_are_merged_as_they_move_in_turn():
    assert claim.verdict(claim.by_merging(3, 3, RIGHT)) == "proved"
    assert claim.verdict(claim.by_merging(3, 3, WRONG)) == "refuted"


@pytest.mark.parametrize("scene", [Pushed("row", 3, 2), Pushed("stack", 3)], ids=str)
def test_all_ways_to_step_bring_the_bodies_to_the_same_places(scene):
    closed = at_once(scene, 1), at_once(scene, 50, anew=True), at_once(scene, 50)
    ways = by_events(scene, floats=False), by_events(scene, floats=True), *closed
    for way in ways:
        way.program()
    assert {round(way.come() / way.ticks, 9) for way in ways} == {float(SPEED * TICK)}
    assert ways[-1].steps == scene.ticks * (50 // len(scene.world().places))
    assert ways[-1].counted() == {"share": 1}


def test_random_levels_have_a_closed_form_in_some_steps():
    prepared = of_random_levels(20)
    prepared.program()
    assert 0 < prepared.counted()["share"] < 1
