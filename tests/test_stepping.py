"""Steps in which all bodies move at once: the domain, drives in files, and the judge of their traces."""

import json
import re
from fractions import Fraction
from pathlib import Path
from random import Random

import msgspec
import pytest
from command import graphbody
from independent.levels import scenario as scenario_of

from properties.conformance.account import account
from properties.conformance.judge import Finding
from properties.conformance.validate import validate
from reference.formats.files import FormatError
from reference.plan import check_plan, plan_of
from reference.play import library, play
from reference.recording import header_of, lines_of
from reference.stepping import StepGame, of_step
from reference.world import LevelError
from spec.storeys import Interval, once_round

REPAIRED = [path for path in library() if path.stem.startswith("repaired-")]
LEVEL = {
    "format": "graphbody/level@1",
    "name": "pit",
    "margin": "1/8",
    "vertices": [["0", "1"], ["4", "1"], ["4", "0"], ["6", "0"], ["6", "1"], ["9", "1"]],
    "bodies": [
        {"name": "A", "left": {"edge": 0, "location": "0"}, "right": {"edge": 0, "location": "1"}, "speed": "1"},
        {"name": "Box", "left": {"edge": 0, "location": "2"}, "right": {"edge": 0, "location": "3"}},
    ],
}


def scenario(tmp_path: Path, steps: list[object], level: object = LEVEL, profile: str = "repaired") -> Path:
    """A scenario file."""
    path = tmp_path / "scenario.json"
    content = {"format": "graphbody/scenario@1", "name": "s", "level": level, "profile": profile, "steps": steps}
    path.write_text(json.dumps(content))
    return path


def trace(path: Path, floats: bool = False) -> list[dict]:
    """The lines of the trace of a scenario."""
    playing = play(path, floats)
    return [json.loads(msgspec.json.encode(line)) for line in (header_of(playing, floats), *lines_of(playing))]


def written(tmp_path: Path, lines: list[dict]) -> Path:
    """A trace file."""
    path = tmp_path / "trace.jsonl"
    path.write_text("".join(f"{json.dumps(line)}\n" for line in lines))
    return path


def drive(time: str = "1", **speeds: str) -> dict:
    """A step that drives bodies."""
    return {"drive": {"speeds": speeds, "time": time}}


@pytest.mark.parametrize(
    ("change", "expected"),
    [
        ({"vertices": [["0", "0"], ["4", "3"]]}, r"\$\.level\.vertices\[0\]: expected ground edge 0, .* to be level"),
        ({"vertices": [["0", "13"], ["4", "13"], ["9", "1"], ["12", "1"]]}, r"expected fall edge 1, .* to be vertical"),
        ({"vertices": [["0", "1"], ["4", "1"], ["4", "1/2"], ["9", "1/2"]]}, r"vertices\[0\]\.y: .* a multiple of 1"),
        ({"vertices": [["0", "1"], ["4", "1"], ["4", "0"], ["6", "0"]], "margin": "1"}, r"expected a width greater"),
        (
            {"vertices": [["0", "1"], ["4", "1"], ["4", "0"], ["6", "0"], ["6", "1"], ["49/8", "1"], ["49/8", "0"],
                          ["9", "0"]], "margin": "1/4"},
            r"\$\.level\.vertices\[4\]: expected a wall at least as thick as the margin, got 1/8",
        ),
        (
            {"edges": [{"left": 0, "right": 1, "type": "ground"}, {"left": 2, "right": 3, "type": "ground"}],
             "vertices": [["0", "0"], ["4", "0"], ["5", "0"], ["9", "0"]]},
            r"\$\.level\.vertices: expected a closed floor, there is none between 4 and 5",
        ),
        (
            {"edges": [{"left": 0, "right": 1, "type": "ground"},
                       {"left": 2, "right": 3, "type": "ground", "thickness": "1"}],
             "vertices": [["0", "0"], ["9", "0"], ["4", "2"], ["9", "2"]]},
            r"\$\.level\.vertices\[2\]: ground ends to the left in the open: expected a fall edge",
        ),
        (
            {"edges": [{"left": 0, "right": 1, "type": "ground"},
                       {"left": 2, "right": 3, "type": "ground", "thickness": "1/2"}],
             "vertices": [["0", "0"], ["9", "0"], ["0", "2"], ["9", "2"]]},
            r"\$\.level\.edges\[1\]\.thickness: expected a multiple of 1, the height of a body, got 1/2",
        ),
        ({"bodies": []}, r"\$\.level\.bodies: expected a body"),
    ],
)  # fmt: skip
def test_a_level_that_is_not_one_of_storeys_is_refused_by_its_place(tmp_path, change, expected):
    with pytest.raises(FormatError, match=expected):
        play(scenario(tmp_path, [], LEVEL | change))


def test_a_fall_edge_the_wrong_way_round_is_named(tmp_path):
    ends = [(0, 1, "ground"), (2, 3, "ground"), (1, 4, "ground"), (2, 1, "fall")]
    edges = [{"left": left, "right": right, "type": kind} for left, right, kind in ends]
    edges[1]["thickness"] = "1"
    level = LEVEL | {"vertices": [["0", "0"], ["4", "0"], ["4", "2"], ["9", "2"], ["9", "0"]], "edges": edges}
    with pytest.raises(FormatError, match=r"vertices\[2\]: .* fall edge 3 is there, with its left and right"):
        play(scenario(tmp_path, [], level))


@pytest.mark.parametrize(
    ("step", "expected"),
    [
        (drive(B="1"), r"\$\.steps\[0\]\.drive\.speeds: no body is named 'B'"),
        (drive(A="x"), r"\$\.steps\[0\]\.drive\.speeds: expected a number"),
        (drive("-1", A="1"), r"\$\.steps\[0\]\.drive\.time: expected a time of at least 0, got -1"),
        (drive("1e400", A="1"), r"\$\.steps\[0\]\.drive\.time"),
        (
            drive(A="1") | {"tick": {"key": "left"}},
            r"\$\.steps\[0\]: expected one of `request`, `tick`, `drive`, `add` and `remove`",
        ),
    ],
)
def test_a_bad_drive_is_refused(tmp_path, step, expected):
    with pytest.raises(FormatError, match=expected):
        play(scenario(tmp_path, [step]))


def test_a_drive_is_refused_where_bodies_move_one_after_another(tmp_path):
    path = scenario(tmp_path, [drive(A="1")], profile="thesis")
    with pytest.raises(FormatError, match=r"\$\.steps\[0\]\.drive: expected a request or a tick"):
        play(path)
    lines = trace(scenario(tmp_path, [drive(A="1")]))
    lines[0]["profile"] = "thesis"
    report = validate(written(tmp_path, lines))
    assert report.unread is not None
    assert "$.drive: expected a request or a tick" in report.unread


def test_an_event_has_its_time_its_velocities_and_its_rule(tmp_path):
    events = trace(scenario(tmp_path, [drive("5", A="1")]))[1]["events"]
    contact = {"body": "A", "event": "contact", "rule": "event/contact"}
    assert events[0] == contact | {"time": "7/8", "velocities": {"A": "1"}, "other": "Box"}
    assert [(event["rule"], event["time"]) for event in events[1:4]] == [
        ("event/support-lost", "23/8"), ("settle/fall", "23/8"), ("settle/ground", "23/8")
    ]  # fmt: skip


@pytest.mark.parametrize("path", REPAIRED, ids=lambda path: path.stem)
def test_bodies_on_storeys_are_where_their_edge_positions_say(path):
    game = play(path).game
    assert isinstance(game, StepGame)
    for step in play(path).scenario.steps:
        game.step(*of_step(game.level, step))
        again = [game.plan.place(game.world, body) for body in game.world.handles()]
        assert again == game.storeys.places


def test_what_a_step_does_that_no_rule_does_is_told_with_what_the_rules_do(tmp_path):
    lines = trace(scenario(tmp_path, [drive("5", A="1")]))
    lines[1]["bodies"][0]["right"]["location"] = "17/4"
    lines[1]["bodies"][0]["left"]["location"] = "13/4"
    report = validate(written(tmp_path, lines))
    assert report.found[Finding.DIVERGES] == 1
    assert report.first is not None
    told = "\n".join(account(report, None))
    assert "A left: expected" in told
    assert "by the rules: at 7/8: A event/contact Box" in told
    replay = tmp_path / "replay.json"
    replay.write_bytes(msgspec.json.encode(report.first.scenario))
    assert next(iter(play(replay).steps)).moves[0].body == "A"


@pytest.mark.parametrize("off", [1 / 8, -1 / 8, 1e-6])
def test_a_wrong_step_of_floats_is_told(tmp_path, off):
    lines = trace(scenario(tmp_path, [drive("5", A="1"), drive("1/2", A="-1")]), floats=True)
    for border in ("left", "right"):
        lines[2]["bodies"][0][border]["location"] += off
    report = validate(written(tmp_path, lines))
    assert (report.found[Finding.AGREES], report.found[Finding.DIVERGES], report.unread) == (1, 1, None)
    told = "\n".join(account(report, None))
    assert "by the rules: A moves at -1 up to 1/2" in told
    assert "wish/plane" in told


GONE = {"remove": {"body": "Box"}}


def come(left: str, right: str, edge: int = 2) -> dict:
    """A step that adds a crate."""
    return {
        "add": {"name": "Crate", "left": {"edge": edge, "location": left}, "right": {"edge": edge, "location": right}}
    }


@pytest.mark.parametrize("floats", [False, True])
def test_lines_in_which_bodies_come_and_go_are_judged(tmp_path, floats):
    lines = trace(scenario(tmp_path, [come("0", "1"), GONE, drive(A="1")]), floats)
    assert validate(written(tmp_path, lines)).found == {Finding.AGREES: 3}
    wrong = json.loads(json.dumps(lines))
    wrong[2]["bodies"][0]["left"]["location"] = wrong[2]["bodies"][0]["right"]["location"] = "1/2"
    wrong[2]["bodies"][0]["right"]["location"] = "3/2"
    assert validate(written(tmp_path, wrong)).found[Finding.DIVERGES]
    wrong = json.loads(json.dumps(lines))
    wrong[1]["add"] |= {"left": {"edge": 0, "location": "5/2"}, "right": {"edge": 0, "location": "7/2"}}
    report = validate(written(tmp_path, wrong))
    assert report.first is not None
    assert "Crate add: expected 1/8 to Box, seen -1/2" in "\n".join(account(report, None))


def test_a_body_that_finds_no_room_is_refused_before_anything_is_told(tmp_path, capsys):
    path = scenario(tmp_path, [drive(A="1"), come("5/2", "7/2", edge=0)])
    ran = graphbody("simulate", path)
    assert ran.returncode == 2
    assert not ran.stdout
    assert ran.stderr.count("\n") == 1
    assert "$.steps[1].add: 'Box' and 'Crate'" in ran.stderr


def test_a_step_of_floats_at_a_boundary_may_come_out_either_way(tmp_path):
    lines = trace(scenario(tmp_path, [drive("4", A="1")]), floats=True)
    fallen = json.loads(json.dumps(lines))
    assert lines[1]["bodies"][0]["left"]["top"] == "Box"
    fallen[1]["bodies"][0] = {"name": "A", "left": {"edge": 0, "location": 3.9999999999999996},
                              "right": {"edge": 0, "location": 5.0}}  # fmt: skip
    fallen[1]["supports"] = {}
    report = validate(written(tmp_path, fallen))
    assert report.conforms, "\n".join(account(report, None))


def test_places_on_a_ring_are_counted_once_round_in_few_steps():
    assert once_round(Fraction(29, 2), Fraction(7)) == Fraction(1, 2)
    assert once_round(Fraction(-1, 2), Fraction(7)) == Fraction(13, 2)
    assert once_round(Fraction(-14), Fraction(7)) == 0
    assert once_round(Fraction(10**300), Fraction(3)) == 1


def test_terrain_across_the_seam_of_a_ring_is_one_piece():
    path = next(path for path in library() if path.stem == "pit-at-the-seam")
    level = play(path).game.level
    check_plan(level)
    (solid,) = plan_of(level).terrain.solid
    assert len(solid) == 1
    assert isinstance(solid[0], Interval)


def test_the_first_problem_of_a_level_is_named():
    level = play(next(path for path in library() if path.stem == "hill")).game.level
    with pytest.raises(LevelError) as refusal:
        check_plan(level)
    assert re.fullmatch(r"\$\.vertices\[\d\]", refusal.value.place)


def float_level(**more: object) -> dict:
    """A level on tenths with a wall of two storeys."""
    vertices = [["-1/2", "0"], ["2", "0"], ["2", "2"], ["7", "2"]]
    at = {"left": {"edge": 1, "location": "7/10"}, "right": {"edge": 1, "location": "2"}}
    ends = [(0, 1, "ground"), (2, 3, "ground"), (1, 2, "fall")]
    edges = [{"left": left, "right": right, "type": kind} for left, right, kind in ends]
    return LEVEL | {"margin": "1/10", "vertices": vertices, "edges": edges, "bodies": [{"name": "A", **at, **more}]}


def test_in_floats_a_body_falls_along_a_wall_of_several_storeys_to_its_foot(tmp_path):
    path = scenario(tmp_path, [drive(A="-2")], float_level(speed="1"))
    (step,) = play(path, floats=True).steps
    assert [one.rule for one in step.happened][-2:] == ["settle/fall", "settle/ground"]
    assert step.bodies[0].left.edge == 0
    assert validate(written(tmp_path, trace(path, floats=True))).conforms


@pytest.mark.parametrize("seed", range(40))
def test_float_traces_of_random_levels_conform(tmp_path, seed):
    given = scenario_of(Random(seed), f"level {seed}")
    path = tmp_path / "scenario.json"
    path.write_text(json.dumps(given))
    try:
        lines = trace(path, floats=True)
    except FormatError:
        pytest.skip("no level of storeys")
    report = validate(written(tmp_path, lines))
    assert report.conforms, "\n".join(account(report, None))


def test_where_nobody_is_driven_a_trace_has_no_moves_and_conforms(tmp_path):
    level = LEVEL | {"bodies": LEVEL["bodies"][1:]}
    lines = trace(scenario(tmp_path, [{"tick": {"key": "left"}}, drive()], level))
    assert [line["moves"] for line in lines[1:]] == [[], []]
    assert validate(written(tmp_path, lines)).conforms


def test_of_two_events_at_one_instant_either_may_come_first_in_floats(tmp_path):
    """R, which rides C, comes to the wall as C ceases to hold it. In floats it comes there first, and stays on C."""
    bodies = [
        {"name": "Low", "left": {"edge": 0, "location": "0"}, "right": {"edge": 0, "location": "3/5"}},
        {"name": "C", "left": {"edge": 0, "location": "4/5"}, "right": {"edge": 0, "location": "13/10"}},
        {"name": "R", "left": {"top": "C", "location": "-2/5"}, "right": {"top": "C", "location": "1/5"}, "speed": "1"},
    ]
    level = {**LEVEL, "margin": "1/5", "vertices": [["0", "0"], ["23/10", "0"]], "bodies": bodies}
    path = scenario(tmp_path, [drive("5/2", R="-1")], level)
    exactly, nearly = (trace(path, floats)[1]["supports"]["R"] for floats in (False, True))
    assert (exactly, nearly) == ("Low", "C")
    lines = trace(path, floats=True)
    assert validate(written(tmp_path, lines)).found == {Finding.ONE_OF_SEVERAL: 1}
    for side in ("left", "right"):
        lines[1]["bodies"][2][side]["location"] += 0.1
    assert validate(written(tmp_path, lines)).found == {Finding.DIVERGES: 1}
