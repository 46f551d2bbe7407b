"""Linting levels: every place where something is not kept, requests that go wrong there, hostile levels."""

import json
from fractions import Fraction
from pathlib import Path

import pytest
from command import graphbody

from properties.lint.account import COLUMNS, account, anything, record_of, write_scenarios
from properties.lint.findings import found_in, grouped, opened
from properties.lint.search import MOST_REQUESTS
from reference.formats.files import FormatError
from reference.formats.level import level_of
from reference.play import LIBRARY, play
from reference.world import World
from spec.conditions import EDGES_LONG, PLANE_START, clearances_demanded
from spec.demand import all_met, breaches
from spec.graph import Direction
from spec.guidelines import GUIDELINES, sizes_of
from spec.invariants import Deed
from spec.plane import IN_PLANE, apart, outside_terrain
from spec.profiles import Profile

LEVELS = LIBRARY / "levels"


def linted(name, tmp_path, profile=None):
    """What is found in a level of the library."""
    level = opened(LEVELS / f"{name}.json", profile)
    return level, record_of(level, found_in(level), tmp_path)


def level_file(tmp_path, bodies, vertices, **more):
    """A level file of bodies, each on an edge from one location to another."""
    held = [
        {"name": name, "left": {"edge": edge, "location": left}, "right": {"edge": edge, "location": right}}
        for name, edge, left, right in bodies
    ]
    path = tmp_path / "level.json"
    document = {"format": "graphbody/level@1", "name": "level", "vertices": vertices, "bodies": held, **more}
    path.write_text(json.dumps(document))
    return path


@pytest.fixture
def few_requests(monkeypatch):
    """A search that is over after some of the requests."""
    monkeypatch.setattr("properties.lint.search.MOST_REQUESTS", 300)


def lint(path, profile=None):
    """What is found in a level file."""
    level = opened(path, profile)
    return record_of(level, found_in(level))


@pytest.mark.parametrize("path", sorted(LEVELS.glob("*.json")), ids=lambda path: path.stem)
def test_a_guideline_is_kept_exactly_where_it_has_no_breaches(path):
    world = World(level_of(play(path).level))
    for guideline in GUIDELINES:
        demands = list(guideline.demands(world.graph, grouped(sizes_of(world))))
        assert bool(guideline.kept(world)) == (not breaches(demands)), guideline.id
    in_plane = bool(apart(world, world.margin) & outside_terrain(world, world.margin * 0))
    assert bool(all_met(clearances_demanded(world))) == in_plane


@pytest.mark.parametrize("name", ["figure-6-6a-short-pit", "pillar", "edges-below-margin", "stairs"])
def test_what_goes_wrong_in_a_level_is_played_again_and_breaks_what_is_told(name, tmp_path):
    _, record = linted(name, tmp_path)
    write_scenarios(record, tmp_path)
    wrongs = [*(one.wrong for one in record.findings if one.wrong is not None), *record.wrong]
    assert wrongs or name in ("pillar", "stairs")
    for wrong in wrongs:
        playing = play(Path(wrong.replay.removeprefix("graphbody simulate ")))
        states = [playing.game.world.copy()]
        for step in playing.steps:
            states.append(playing.game.world.copy())
            (move,) = step.moves
        direction = Direction.RIGHT if move.asked > 0 else Direction.LEFT
        body = playing.game.handles[move.body]
        deed = Deed(*states[-2:], body, direction, abs(move.asked), abs(move.moved), 1, 1, 0, Fraction(0))
        broken = [one.id for one in IN_PLANE if not one.holds(deed)]
        assert broken == [name for name in wrong.broken if name.startswith("invariant/")]


def test_a_short_pit_is_found_with_the_number_that_mends_it(tmp_path):
    _, record = linted("figure-6-6a-short-pit", tmp_path)
    (one,) = record.findings
    assert (one.statement, one.place) == ("guideline/long-grounds", "$.vertices[2]")
    assert one.what == "ground edge 2, from (4, 0) to (19/4, 0)"
    assert (one.seen, one.mend) == ("is 3/4 long, less than 1, the width of body 'A'", "make it at least 1 long")
    assert one.wrong is not None
    assert "unsupported/short-pit" in one.wrong.broken


def test_bodies_of_several_sizes_are_each_found_and_an_edge_once_for_the_widest(tmp_path):
    bodies = [("A", 0, "0", "1"), ("B", 0, "2", "4"), ("C", 0, "5", "7"), ("D", 1, "0", "1/2")]
    record = lint(level_file(tmp_path, bodies, [["0", "0"], ["10", "0"], ["11", "0"]]))
    sizes = [one.what for one in record.findings if one.statement == "guideline/uniform-size"]
    assert sizes == ["body 'B'", "body 'C'", "body 'D'"]
    (edge,) = [one for one in record.findings if one.statement == "guideline/long-grounds"]
    assert edge.seen == "is 1 long, less than 2, the width of bodies 'B' and 'C'"


@pytest.mark.usefixtures("few_requests")
def test_a_fall_edge_that_ends_at_no_ground_is_found_and_stops_who_comes_to_it(tmp_path):
    edges = [{"type": "ground", "left": 0, "right": 1}, {"type": "fall", "left": 1, "right": 2}]
    vertices = [["0", "1"], ["4", "1"], ["4", "0"]]
    (one,) = lint(level_file(tmp_path, [("A", 0, "2", "3")], vertices, edges=edges)).findings
    assert (one.statement, one.place, one.seen) == ("guideline/level-landings", "$.edges[1]", "ends at no ground")


def test_a_ground_edge_shorter_than_the_margin_is_named_among_all_edges(tmp_path):
    vertices = [["0", "1"], ["0", "0"], ["4", "0"], ["33/8", "0"], ["8", "0"]]
    record = lint(level_file(tmp_path, [("A", 1, "0", "1")], vertices, margin="1/4"))
    (short,) = [one for one in record.findings if one.statement == EDGES_LONG.id]
    assert (short.place, short.seen) == ("$.vertices[2]", "is 1/8 long, shorter than the margin, 1/4")


def test_bodies_that_stand_in_each_other_are_found_and_nothing_is_tried(tmp_path):
    edges = [{"left": 0, "right": 1}, {"left": 2, "right": 3, "thickness": "1/4"}]
    vertices = [["0", "0"], ["9", "0"], ["2", "1/2"], ["5", "1/2"]]
    bodies = [("A", 0, "1", "3"), ("B", 1, "1/2", "5/2")]
    level = opened(level_file(tmp_path, bodies, vertices, edges=edges), None)
    record = record_of(level, found_in(level))
    clearances = [(one.place, one.seen) for one in record.findings if one.statement == PLANE_START.id]
    assert ("$.bodies[1]", "is nearer to body 'A' than the margin, 1/100") in clearances
    assert ("$.bodies[0]", "is in the terrain under edge 1") in clearances
    assert record.requests == 0
    assert "No request was tried" in "\n".join(account(level, record))


def test_a_level_that_keeps_all_guidelines_yet_goes_wrong_is_told(tmp_path):
    vertices = [["0", "1"], ["4", "1"], ["4", "0"], ["8", "0"]]
    bodies = [("A", 0, "2", "3"), ("B", 2, "21/20", "41/20")]
    level = opened(level_file(tmp_path, bodies, vertices, margin="1/10"), None)
    record = record_of(level, found_in(level))
    assert record.findings == []
    assert {name for wrong in record.wrong for name in wrong.broken} >= {"invariant/plane-margin"}
    assert "It keeps all guidelines, yet:" in "\n".join(account(level, record))
    assert anything(record)


@pytest.mark.usefixtures("few_requests")
@pytest.mark.parametrize("profile", ["repaired", None])
def test_whether_a_level_is_one_of_storeys_is_told_with_the_place(profile, tmp_path):
    level, record = linted("hill", tmp_path, profile)
    assert record.storeys is not None
    assert record.storeys.startswith("$.vertices[")
    assert bool(record.findings) == (profile == "repaired")
    told = [line for line in account(level, record) if "graphbody simulate" not in line]
    assert max(map(len, told)) <= COLUMNS


@pytest.mark.slow
def test_the_same_of_a_thousand_bodies_is_bounded_work(tmp_path):
    vertices = [[str(x), str(y)] for i in range(500) for x, y in ((3 * i, i % 2), (3 * i + 3, i % 2))]
    bodies = [(f"B{i}", 2 * (i // 2), "1/10" if i % 2 else "2", "1" if i % 2 else "29/10") for i in range(1000)]
    level = opened(level_file(tmp_path, bodies, vertices), None)
    found = found_in(level)
    assert 0 < found.searched.requests <= MOST_REQUESTS
    assert found.searched.spent
    assert not record_of(level, found).all_tried


def test_places_in_a_scenario_are_places_in_the_file_that_has_them(tmp_path):
    document = json.loads((LEVELS / "figure-6-6a-short-pit.json").read_text())
    inside = tmp_path / "inside.json"
    inside.write_text(json.dumps({"format": "graphbody/scenario@1", "name": "inside", "level": document, "steps": []}))
    assert lint(inside).findings[0].place == "$.level.vertices[2]"
    assert lint(LIBRARY / "scenarios" / "figure-6-6a-short-pit.json").findings[0].place == "$.vertices[2]"


def test_bad_input_names_the_place(tmp_path):
    with pytest.raises(FormatError, match=r"bodies\[0\]: expected the left border"):
        opened(level_file(tmp_path, [("A", 0, "2", "1")], [["0", "0"], ["9", "0"]]), None)
    with pytest.raises(FormatError, match="expected one of thesis"):
        opened(LEVELS / "hill.json", "no-such-profile")


def test_the_exit_status_says_whether_anything_was_found(tmp_path):
    assert graphbody("lint", LEVELS / "one-edge.json", cwd=tmp_path).returncode == 0
    assert not (tmp_path / "build").exists()
    found = graphbody("lint", LEVELS / "figure-6-6a-short-pit.json", "--json", cwd=tmp_path)
    assert found.returncode == 1
    wrong = json.loads(found.stdout)["findings"][0]["wrong"]
    assert graphbody(*wrong["replay"].split()[1:], cwd=tmp_path).returncode == 0
    refused = graphbody("lint", "missing.json", cwd=tmp_path)
    assert (refused.returncode, refused.stdout, len(refused.stderr.splitlines())) == (2, "", 1)


@pytest.mark.usefixtures("few_requests")
def test_what_a_feature_makes_meaningless_is_not_told_without_it(monkeypatch):
    path = LIBRARY / "scenarios" / "feature-no-collisions.json"
    told = {name for wrong in lint(path).wrong for name in wrong.broken}
    meaningless = {"invariant/plane-apart", "invariant/plane-margin", "unsupported/fall-onto-middle"}
    assert not told & meaningless
    monkeypatch.setattr(Profile, "not_asked", frozenset())
    assert {name for wrong in lint(path).wrong for name in wrong.broken} >= meaningless
    assert {name for wrong in lint(path, "thesis/overshoot").wrong for name in wrong.broken}
