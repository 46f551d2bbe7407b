"""Files: the library is in order, and bad input gets one line that names the place."""

import json

import pytest

from reference.formats.files import FormatError, read
from reference.formats.level import LevelRecord, level_of, level_record
from reference.play import LIBRARY, library, play
from reference.world import LevelError, world_of
from spec.conditions import EDGES_LONG, MARGINS_KEPT

LEVELS = sorted((LIBRARY / "levels").glob("*.json"))
GOOD = {
    "format": "graphbody/level@1",
    "name": "good",
    "vertices": [["0", "0"], ["10", "0"]],
    "bodies": [
        {"name": "A", "left": {"edge": 0, "location": "1"}, "right": {"edge": 0, "location": "2"}},
        {"name": "B", "left": {"edge": 0, "location": "4"}, "right": {"edge": 0, "location": "5"}},
    ],
}


def changed(path, value):
    """The good level with one value changed; a path is a list of keys."""
    level = json.loads(json.dumps(GOOD))
    target = level
    for key in path[:-1]:
        target = target[key]
    target[path[-1]] = value
    return level


def load(tmp_path, text):
    """Read a level file as the command line does, up to its world."""
    path = tmp_path / "level.json"
    path.write_bytes(text if isinstance(text, bytes) else json.dumps(text).encode())
    return world_of(level_of(read(path, LevelRecord)))


def test_there_are_at_least_ten_levels_and_each_is_played():
    assert len(LEVELS) >= 10
    levels = [read(path, object)["level"] for path in library()]
    played = {level.rpartition("/")[2] for level in levels if isinstance(level, str)}
    assert played == {path.name for path in LEVELS}


@pytest.mark.parametrize("path", LEVELS, ids=lambda path: path.stem)
def test_a_level_of_the_library_is_valid_named_after_its_file_and_survives_a_round_trip(path):
    record = read(path, LevelRecord)
    level = level_of(record)
    assert record.name == path.stem
    assert record.note
    assert level_of(level_record(level, record.name)) == level
    start = world_of(level)
    assert MARGINS_KEPT.holds(start, 0)
    assert EDGES_LONG.holds(start, 0) == (path.stem != "edges-below-margin")


@pytest.mark.parametrize("path", library(), ids=lambda path: path.stem)
def test_a_scenario_of_the_library_does_the_same_in_floats(path):
    runs = [list(play(path, floats).steps) for floats in (False, True)]
    for exact, binary in zip(*runs, strict=True):
        assert [m.fired for m in exact.moves] == [m.fired for m in binary.moves]
        for one, two in zip(exact.bodies, binary.bodies, strict=True):
            assert one.left.edge == two.left.edge
            assert two.left.location == pytest.approx(float(one.left.location), abs=1e-9)


@pytest.mark.parametrize(
    ("path", "value", "place"),
    [
        (["margin"], "0", r"\$\.margin: expected a number greater than 0"),
        (["margin"], "nan", r"\$\.margin: expected a number"),
        (["margin"], "1/0", r"\$\.margin: expected a finite number"),
        (["margin"], "1" * 1000, r"\$\.margin: expected at most 400 characters"),
        (["margin"], [], r"\$\.margin: Expected"),
        (["surprise"], 1, r"\$: Object contains unknown field `surprise`"),
        (["format"], "graphbody/level@9", r"\$\.format: expected graphbody/level@1, got 'graphbody/level@9'"),
        (["vertices"], [[0, 0]], r"\$\.vertices: expected two vertices or more"),
        (["vertices", 1], ["-1", "0"], r"\$\.vertices\[1\]: expected x of 0 or more"),
        (["vertices", 1], ["0", "0"], r"\$\.vertices\[0\]: edge 0 has no length"),
        (["vertices", 1], ["1", "1"], r"\$\.vertices\[0\]: edge 0 has an irrational length"),
        (["vertices", 1], ["3", "400"], r"irrational length"),
        (["vertices", 1], ["5", "12"], r"\$\.bodies\[0\]\.left\.edge: edge 0 is steeper than 60 degrees"),
        (["circumference"], "10", r"\$\.circumference: expected more than"),
        (["bodies", 1, "name"], "A", r"\$\.bodies\[1\]\.name: expected a name of its own"),
        (["bodies", 1, "name"], "", r"\$\.bodies\[1\]\.name: Expected `str` of length >= 1"),
        (["bodies", 1, "left", "edge"], 7, r"\$\.bodies\[1\]\.left\.edge: expected 0 to 0, got 7"),
        (["bodies", 1, "left", "location"], "11", r"\$\.bodies\[1\]\.left\.location: expected 0 to 10"),
        (["bodies", 1, "left", "location"], "5", r"\$\.bodies\[1\]: expected the left border to be left"),
        (["bodies", 1, "left", "location"], "3/2", r"\$\.bodies\[1\]: 'A' and 'B' are -1/2 apart"),
        (["bodies", 1, "speed"], "-1", r"\$\.bodies\[1\]\.speed: expected 0 or more"),
    ],
)
def test_a_bad_value_is_named_with_its_place(tmp_path, path, value, place):
    with pytest.raises((FormatError, LevelError), match=place):
        load(tmp_path, changed(path, value))


@pytest.mark.parametrize(
    "text", [b"", b"{", b"\x00\xff\xfe", b"[" * 100_000, json.dumps(GOOD).encode()[:-9], b'{"vertices": [[0, 1e400]]}']
)
def test_what_is_not_a_level_is_refused_in_one_line(tmp_path, text):
    with pytest.raises(FormatError) as caught:
        load(tmp_path, text)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("scenario", "floats"),
    [
        ({"level": "\u0000", "steps": []}, False),
        ({"level": {**GOOD, "vertices": [[-1.7e308, 0], [1.7e308, 0]]}, "steps": []}, True),
        ({"level": GOOD, "steps": [{"request": {"body": "A", "distance": 10**4000}}]}, True),
        ({"level": GOOD, "steps": [{"request": {"body": "no\nbody", "distance": 1}}]}, False),
        ({"level": GOOD, "steps": [{}]}, False),
        ({"level": {**GOOD, "sur\nprise": 1}, "steps": []}, False),
    ],
)
def test_a_bad_scenario_is_refused_in_one_line(tmp_path, scenario, floats):
    path = tmp_path / "scenario.json"
    path.write_text(json.dumps({"format": "graphbody/scenario@1", "name": "bad", **scenario}))
    with pytest.raises(FormatError) as caught:
        play(path, floats)
    assert "\n" not in str(caught.value)


def test_borders_that_floats_do_not_tell_apart_are_refused_in_floats(tmp_path):
    level = changed(["bodies", 0, "right", "location"], "1." + "0" * 30 + "1")
    path = tmp_path / "level.json"
    path.write_text(json.dumps(level))
    play(path)
    with pytest.raises(FormatError, match=r"level.json: \$\.bodies\[0\]: expected borders that floats tell apart"):
        play(path, floats=True)


def test_bodies_wider_than_their_ring_are_refused(tmp_path):
    level = {**GOOD, "circumference": "20", "vertices": [["0", "0"], ["10", "0"]]}
    level["bodies"] = [
        {"name": "A", "left": {"edge": 0, "location": "1"}, "right": {"edge": 1, "location": "9"}},
        {"name": "B", "left": {"edge": 0, "location": "2"}, "right": {"edge": 1, "location": "8"}},
    ]
    with pytest.raises(LevelError, match="wider than the ring"):
        load(tmp_path, level)


@pytest.mark.parametrize(
    ("button", "place"),
    [
        ({"edge": 1, "location": "1/2"}, r"\$\.buttons\[0\]\.edge: edge 1 is a fall edge"),
        ({"edge": 0, "location": "11"}, r"\$\.buttons\[0\]\.location: expected 0 to 10, got 11"),
        ({"top": "A", "location": "-1"}, r"\$\.buttons\[0\]\.location: expected 0 to 1"),
    ],
)
def test_a_button_is_on_ground_or_on_a_top(tmp_path, button, place):
    level = {**GOOD, "vertices": [["0", "0"], ["10", "0"], ["10", "-1"], ["20", "-1"]], "buttons": [button]}
    with pytest.raises(LevelError, match=place):
        load(tmp_path, level)


def test_numbers_are_read_exactly(tmp_path):
    row = load(tmp_path, changed(["bodies", 0, "left", "location"], 0.1))
    assert row.bodies[0].left.location == 0.1
    assert str(row.bodies[0].left.location) != "1/10"


def test_the_puzzle_is_solved_by_one_recorded_scenario_and_not_by_the_other():
    ends = {}
    for path in library():
        playing = play(path)
        if playing.scenario.solved is not None:
            list(playing.steps)
            ends[playing.scenario.name] = (playing.scenario.solved, playing.game.world.solved())
    assert ends["huge-and-cute-solved"] == (True, True)
    assert ends["huge-and-cute-failed"] == (False, False)
    assert all(expected == reached for expected, reached in ends.values())
