"""Unsupported cases and errata: each predicate is true of a witness and false of a near miss."""

import re
from dataclasses import replace
from fractions import Fraction

import msgspec
import pytest

from properties.conformance.validate import validate
from properties.contracts.fitting import long_edges_fit
from properties.engine.explore import explore
from properties.evidence.deeds import do
from properties.evidence.mended import OUTSIDE, SHOWN
from properties.explain import everything, explain, find, of_row
from properties.given import Exact
from properties.map import case_search as searching, cases as cases_page, errata as errata_page
from properties.map.case_search import ALL, RANK, Search, Witness, as_json, best, from_json
from properties.map.cases import preventing, that_keeps
from properties.map.replay import Replay
from properties.worlds.scenes import Platform, Shape, Stand, scene
from reference.play import LIBRARY, read_playable
from reference.recording import recording
from reference.world import World, world_of
from spec.case import parts_of, ran_into
from spec.conditions import PLANE_START
from spec.errata import ERRATA, REPLAYED
from spec.graph import Direction
from spec.profiles import OVERSHOOT, THESIS
from spec.unsupported import CASES, OF_CHANGES, OF_LEVELS

ZERO, ONE, TWO, QUARTER = Fraction(0), Fraction(1), Fraction(2), Fraction(1, 4)
G0, G1, G2, G3 = (Stand(edge=edge) for edge in range(4))
RIGHT = Direction.RIGHT
COMMON = {"margin": "1/4", **{f"width of {name}": "1" for name in "ABC"}}


def shape(heights, *stands, platform=None, short=False):
    return Shape(tuple(map(Fraction, heights)), stands, platform, short)


def numbers(lengths, left_of_a, asked, **more):
    grounds = {f"length of ground {place}": length for place, length in enumerate(lengths.split())}
    named = {key.replace("_", " of "): value for key, value in more.items()}
    return {**COMMON, **grounds, "left of A": left_of_a, "distance asked": asked, **named}


LEDGE, PIT, FAR_WALL = shape("10", G0, G1), shape("101", G0), shape("102", G0)
STACK = shape("10", G0, G1, Stand(top=1))
OVER_LEDGE = Platform(TWO, QUARTER)

SEEN = {
    "short-pit": (PIT, numbers("2 1/2 2", "1", "5/4"), {"length of ground 1": "1"}),
    "short-pit-heights": (FAR_WALL, numbers("2 1/2 2", "1", "3/4"), {"distance asked": "1/2"}),
    "overhang-from-body": (
        shape("02", Stand(top=1), G0),
        numbers("5/2 2", "0", "3/4", left_B="1"),
        {"distance asked": "1/2"},
    ),
    "tunnel": (
        shape("000", G0, platform=Platform(ONE / 2, QUARTER)),
        numbers("2 2 2", "0", "5/4"),
        {"distance asked": "1"},
    ),
    "fall-onto-middle": (
        shape("000", G3, G1, platform=OVER_LEDGE),
        numbers("2 2 2", "1/2", "7/4", left_B="3/2"),
        {"left of B": "1"},
    ),
    "sharp-ledge": (
        shape("000", Stand(top=1), G0, platform=Platform(ONE, ZERO)),
        numbers("2 2 2", "0", "5/4", left_B="3/2"),
        {"left of B": "1"},
    ),
    "fall-off-body": (shape("0", Stand(top=1), G0), numbers("6", "0", "5/4", left_B="2"), {"distance asked": "1"}),
    "landing-does-not-fit": (PIT, numbers("2 1/2 2", "1", "5/4"), {"length of ground 1": "1"}),
    "other-strings": (
        shape("101", G0, G2),
        numbers("2 1/2 3", "1", "3/8", left_B="0"),
        {"distance asked": "1/4"},
    ),
    "lands-near": (LEDGE, numbers("3 5", "1", "17/8", left_B="9/8"), {"left of B": "5/4"}),
    "ridden-top": (STACK, numbers("3 5", "1", "17/8", left_B="1/2", left_C="1/4", width_A="3/4"), {"left of C": "3/4"}),
    "leads-up": (STACK, numbers("3 5", "1", "17/8", left_B="1/2", left_C="1/4", width_A="3/4"), {"left of C": "3/4"}),
    "jump-onto-middle": (
        shape("201", G0, G1, G2),
        numbers("3 2 2", "0", "13/4", left_B="1/2", left_C="0", width_A="7/4"),
        {"width of A": "3/2"},
    ),
    "lands-in-terrain": (
        shape("102", G0, G1),
        numbers("3 2 2", "1", "17/8", left_B="1/2", width_A="7/4"),
        {"width of A": "3/2"},
    ),
    "through-floor": (
        shape("20", G0, G1, platform=Platform(ONE * 3 / 2, QUARTER)),
        numbers("3 5", "1", "17/8", left_B="1/2"),
        {"distance asked": "2"},
    ),
    "rider-carried": (
        shape("02", G0, Stand(top=0)),
        numbers("4 2", "1", "7/4", left_B="1/2"),
        {"distance asked": "3/2"},
    ),
    "rider-falls": (shape("102", G0, Stand(top=0)), numbers("3 1 2", "1", "9/4", left_B="1/2"), {"left of B": "0"}),
    "lands-too-far": (LEDGE, numbers("3 5", "1", "17/8", left_B="3/4"), {"distance asked": "11/4"}),
    "overhangs-meet": (
        shape("101", G0, Stand(edge=2, overhang=Direction.LEFT)),
        numbers("3 2 2", "0", "5/2", left_B="1/2", width_A="2"),
        {"distance asked": "9/4"},
    ),
    "walks-into-body": (
        shape("101", G0, G2),
        numbers("2 1/2 3", "1", "3/8", left_B="0"),
        {"distance asked": "1/4"},
    ),
    "out-of-sight": (
        shape("000", G0, G2, short=True),
        numbers("3 1/8 3", "1", "1", left_B="1/16"),
        {"length of ground 1": "1/4"},
    ),
    "stopped-from-above": (
        shape("10", G0, G2, platform=OVER_LEDGE),
        numbers("3 4", "1", "17/8", left_B="1/2"),
        {"left of B": "1"},
    ),
}


def request(of_shape, values):
    """The request of a scene in exact numbers, as each of its bodies has fulfilled it."""
    level, asked = scene(Exact(values), of_shape, guided=False)
    world = world_of(level)
    assert PLANE_START.holds(world, world.margin)
    deed, record = do(THESIS, world, 0, RIGHT, asked, ZERO)
    return parts_of(deed, record.fired, [(ask.body, ask.distance, ask.moved) for ask in record.asks])


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.id)
def test_a_case_happens_in_its_witness_and_not_in_a_near_miss(case):
    of_shape, values, change = SEEN[case.id.removeprefix("unsupported/")]
    assert len(change) == 1
    assert ran_into(case, request(of_shape, values))
    assert not ran_into(case, request(of_shape, values | change))


def test_a_body_that_is_pushed_runs_into_a_case_too():
    pushed = shape("101", G0, G0)
    values = numbers("5 1/2 2", "1", "13/4", left_B="5/2")
    parts = request(pushed, values)
    assert [deed.body for deed, _ in parts] == [0, 1]
    (short_pit,) = (case for case in CASES if case.id == "unsupported/short-pit")
    assert not short_pit.happened(*parts[0])
    assert short_pit.happened(*parts[1])
    assert parts[1][0].asked == Fraction(3)


def replay(name):
    """A scenario of the library."""
    return Replay(*read_playable(LIBRARY / "scenarios" / f"{name}.json"))


@pytest.mark.parametrize(("name", "platforms"), [("through-floor", True), ("lands-near", False), ("hill", False)])
def test_a_level_with_platforms_is_told_from_one_that_the_creator_makes(name, platforms):
    (case,) = OF_LEVELS
    assert case.found(World(replay(name).level)) == platforms


def test_terrain_that_moves_is_told_from_terrain_that_stays():
    (moving,) = OF_CHANGES
    graph = replay("hill").level.graph
    first = replace(graph.vertices[0], y=graph.vertices[0].y + 1)
    assert not moving.found(graph, replace(graph))
    assert moving.found(graph, replace(graph, vertices=(first, *graph.vertices[1:])))


def test_a_trace_in_which_terrain_moves_is_refused_with_the_place(tmp_path):
    recorded = recording(LIBRARY / "scenarios" / "hill.json")
    first = next(iter(recorded.lines))
    moved = {**msgspec.to_builtins(first), "vertices": [["0", "1"]]}
    path = tmp_path / "moved.jsonl"
    path.write_bytes(b"\n".join(map(msgspec.json.encode, (recorded.header, moved))) + b"\n")
    unread = validate(path).unread
    assert unread is not None
    assert f"{path}:2: $: Object contains unknown field `vertices`" in unread


@pytest.mark.parametrize("erratum", ERRATA, ids=lambda erratum: erratum.id)
def test_an_erratum_names_what_there_is_and_explains_itself(erratum):
    known = everything()
    assert all(name in known for name in (*erratum.printed, *erratum.refuted, *erratum.mended, *erratum.evidence))
    assert bool(erratum.mended) == bool(erratum.evidence)
    assert erratum.mended or replay(erratum.witness).broken == []
    if REPLAYED in erratum.evidence:
        assert erratum.witness in SHOWN or erratum.witness in OUTSIDE
    assert f"graphbody simulate reference/scenarios/{erratum.witness}.json" in "\n".join(explain(find(erratum.id)))


def test_every_mend_holds_in_its_witness_and_the_printed_rule_fires_there():
    assert list(errata_page.PART.broken({})) == []
    text = "\n".join(errata_page.PART.section({}))
    assert all(one.id in text for one in ERRATA)


def test_a_mend_that_does_not_hold_is_told(monkeypatch):
    wrong = replace(ERRATA[0], witness="figure-1-2-fall-edge", printed=("push/request",))
    monkeypatch.setattr(errata_page, "ERRATA", (wrong,))
    assert "expected one of `push/request` to fire" in next(errata_page.PART.broken({}))


@pytest.mark.parametrize("row", [*(f"U{number}" for number in range(1, 12)), "P5", "P6", "P7", "P8", "P9", "E12"])
def test_each_row_of_the_cases_finds_a_statement(row):
    assert of_row(row)


def test_the_search_finds_the_smallest_witness_and_what_it_keeps():
    search = Search(THESIS)
    search.go_through(LEDGE)
    found = best(search.found["unsupported/lands-near"])
    assert that_keeps(found, *ALL) is not None
    assert [from_json(as_json(one)) for one in found] == found
    assert all("unsupported/lands-near" in Replay.of(one.scenario).cases for one in found)
    assert search.uncatalogued == []


def test_the_search_tells_what_no_case_covers(monkeypatch):
    fewer = {name: case for name, case in searching.BY_ID.items() if name != "unsupported/lands-near"}
    monkeypatch.setattr(searching, "CASES", tuple(fewer.values()))
    monkeypatch.setattr(searching, "BY_ID", fewer)
    search = Search(THESIS)
    search.go_through(LEDGE)
    (first, *_) = search.uncatalogued
    assert Replay.of(first).broken == ["invariant/plane-margin"]


def witness(size, *ranks):
    guidelines = {rank: name for name, rank in RANK.items()}
    return Witness((size, 1, 0), (1, ONE), frozenset(guidelines[rank] for rank in ranks), {})


def test_of_witnesses_those_stay_that_no_simpler_one_serves_for():
    small, larger, useless = witness(1, "G3"), witness(2, "G3", "G5"), witness(3, "G5")
    assert best([useless, larger, small]) == [small, larger]
    assert preventing([small, larger]) == "G1 or G2 or G4"
    assert preventing([witness(1, "G1", "G3"), witness(1, "G2", "G3")]) == "G4 or G5 or G1 + G2"
    assert preventing([witness(1, *RANK.values())]) == "none"


def test_a_rule_at_fault_is_one_that_fired_for_the_body():
    for case in CASES:
        played = replay("ridden-top")
        if case.id in played.cases:
            assert played.fault(case) == "leave/jump"
    carried = replay("rider-carried-into-wall")
    (case,) = (case for case in CASES if case.id == "unsupported/rider-carried")
    assert carried.fault(case).startswith("walk/")
    with pytest.raises(ValueError, match="no body has run into"):
        carried.done[0].fault(next(case for case in CASES if case.id == "unsupported/short-pit"))


def test_landings_that_overshoot_do_not_fit_long_edges():
    assert explore(lambda given: long_edges_fit(OVERSHOOT.rules, given)).counterexample is not None


@pytest.fixture
def findings(monkeypatch):
    """What is found in one shape alone, under both readings of the landing."""
    alone = {"steps": lambda: [LEDGE]}
    for module in (cases_page, searching):
        monkeypatch.setattr(module, "GROUPS", alone)
    return {name: job() for name, job in cases_page.PART.jobs().items()}


def test_the_page_links_to_witnesses_that_run_into_their_cases(findings):
    text = "\n".join(cases_page.PART.section(findings))
    documents = cases_page.PART.witnesses(findings)
    assert set(re.findall(r"map/witnesses/([\w-]+)\.json", text)) == documents.keys()
    assert all(f"### {case.id}" in text for case in CASES)
    assert "unsupported/lands-near" in Replay.of(documents["lands-near-G1G2G3G4G5"]).cases
    assert list(cases_page.PART.broken(findings)) == []
    assert msgspec.json.decode(msgspec.json.encode(findings)) == findings


def test_a_witness_that_runs_into_nothing_is_told(findings):
    for one in findings["thesis, steps"]["cases"]["unsupported/lands-near"]:
        one["scenario"]["steps"][0]["request"]["distance"] = "1"
    assert any("expected unsupported/lands-near to happen" in line for line in cases_page.PART.broken(findings))
