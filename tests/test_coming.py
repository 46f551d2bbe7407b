"""Bodies that come and go at run time: what is refused, who settles, and what files say of it."""

import json
from fractions import Fraction

import msgspec
import pytest

from properties.conformance.validate import validate
from reference.draw import pages
from reference.formats.files import FormatError
from reference.formats.level import LevelRecord, level_of
from reference.itf import text
from reference.play import LIBRARY, play
from reference.recording import header_of, lines_of, recording
from reference.stepping import StepGame
from reference.world import LevelError
from spec.body import Body, EdgePosition
from spec.profiles import REPAIRED

SCENARIO = LIBRARY / "scenarios" / "bodies-come-and-go.json"
BUTTON = [{"top": "Box", "location": "1/2"}]
TOWER = {
    "format": "graphbody/level@1",
    "name": "tower",
    "margin": "1/8",
    "vertices": [["0", "0"], ["6", "0"], ["6", "1"], ["9", "1"]],
    "bodies": [
        {"name": "A", "left": {"edge": 0, "location": "1"}, "right": {"edge": 0, "location": "2"}, "speed": "1"},
        {"name": "Box", "left": {"top": "A", "location": "0"}, "right": {"top": "A", "location": "1"}},
        {"name": "Top", "left": {"top": "Box", "location": "1/4"}, "right": {"top": "Box", "location": "5/4"}},
    ],
}


def body(name, left, right, **more):
    """A body as a file has it; a place is (edge or name of a top, location)."""
    borders = {}
    for side, (on, location) in (("left", left), ("right", right)):
        borders[side] = {"top" if isinstance(on, str) else "edge": on, "location": location}
    return {"name": name, **borders, **more}


def written(tmp_path, steps, level=TOWER, profile="repaired"):
    """A scenario file."""
    path = tmp_path / "scenario.json"
    content = {"format": "graphbody/scenario@1", "name": "s", "level": level, "profile": profile, "steps": steps}
    path.write_text(json.dumps(content))
    return path


def game():
    """The tower, to be played."""
    return StepGame(REPAIRED, level_of(msgspec.convert(TOWER, LevelRecord)))


def places(played):
    """Where everybody is: storey, left border, support."""
    return {
        name: (place.storey, place.left, None if place.support is None else played.names[place.support])
        for name, place in zip(played.names, played.storeys.places, strict=True)
    }


def test_a_rider_of_what_goes_settles_at_once_and_so_do_its_own():
    played = game()
    assert played.remove("A") == []
    assert places(played) == {"Box": (0, 1, None), "Top": (1, Fraction(5, 4), "Box")}
    assert [(one.body, one.rule) for one in played.happened] == [
        ("Box", "settle/fall"),
        ("Box", "settle/ground"),
        ("Top", "settle/fall"),
        ("Top", "settle/jump"),
    ]
    assert {one.time for one in played.happened} == {0}


def test_what_stands_on_a_body_that_stays_is_as_it_was():
    played = game()
    played.remove("Top")
    assert places(played) == {"A": (0, 1, None), "Box": (1, 1, "A")}
    assert played.world.support(1) == 0


def test_bodies_that_come_and_go_leave_the_others_as_they_are():
    played = game()
    before = places(played)
    played.add(Body("New", EdgePosition(0, Fraction(3)), EdgePosition(0, Fraction(4)), Fraction(1), Fraction(1)))
    assert {name: place for name, place in places(played).items() if name != "New"} == before
    played.remove("New")
    assert places(played) == before


def test_a_game_goes_on_with_who_is_there():
    played = game()
    played.remove("A")
    assert played.request("Box", Fraction(1)).moved == 1
    assert places(played)["Top"] == (1, Fraction(9, 4), "Box")


@pytest.mark.parametrize(
    ("step", "problem"),
    [
        (
            {"add": body("A", (0, "4"), (0, "5"))},
            r"\$\.steps\[0\]\.add\.name: expected a name of its own",
        ),
        ({"add": body("N", (9, "4"), (9, "5"))}, r"\.add\.left\.edge: expected 0 to 2, got 9"),
        ({"add": body("N", ("Nobody", "4"), (0, "5"))}, r"\.add\.left\.top: no body is named 'Nobody'"),
        ({"add": body("N", (0, "x"), (0, "5"))}, r"\.add\.left\.location: expected"),
        (
            {"add": body("N", (0, "4"), (0, "5"), height="2")},
            r"\.add\.height: expected 1, the height of",
        ),
        ({"add": body("N", (0, "4"), (0, "5"), speed="-1")}, r"\.add\.speed: expected 0 or more"),
        ({"add": body("N", (0, "4"), (0, "4"))}, r"\.add: expected the left border to be left"),
        ({"add": body("N", (0, "4"), (0, "33/8"))}, r"\.add: expected a width greater than the margin, 1/8"),
        ({"add": body("N", (0, "3/2"), (0, "5/2"))}, r"\.add: 'A' and 'N' are -1/2 apart"),
        ({"add": body("N", (0, "17/8"), (0, "25/8"))}, None),
        ({"add": body("N", (0, "2"), (0, "3"))}, r"\.add: 'A' and 'N' are 0 apart, less than the margin"),
        ({"add": body("N", (0, "11/2"), (0, "13/2"))}, r"\.add: expected a body outside all terrain"),
        ({"add": body("N", (2, "0"), (0, "5"))}, r"\.add\.right\.edge: expected an edge that ground joins"),
        ({"add": body("N", (1, "0"), (1, "1/2"))}, r"\.add\.left\.edge: edge 1 is"),
        ({"add": body("N", ("N", "0"), ("N", "1"))}, r"\.add\.left\.top: no body is named 'N'"),
        ({"add": body("N", ("Box", "0"), ("Box", "1"))}, r"\.add: .* apart, less than the margin"),
        ({"remove": {"body": "Nobody"}}, r"\$\.steps\[0\]\.remove\.body: no body is named 'Nobody'"),
        ({"remove": {"body": "A"}, "tick": {"key": "left"}}, r"\$\.steps\[0\]: expected one of `request`"),
        ({"remove": "A"}, r"\$\.steps\[0\]\.remove: Expected"),
    ],
)
def test_a_body_that_can_not_come_or_go_is_refused_in_one_line(tmp_path, step, problem):
    path = written(tmp_path, [step])
    if problem is None:
        assert len(list(play(path).steps)) == 1
        return
    with pytest.raises(FormatError, match=problem) as caught:
        list(play(path).steps)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("steps", "problem"),
    [
        (["A", "Box", "Top"], r"\$\.steps\[2\]\.remove: expected another body to be left"),
        (["A", "A"], r"\$\.steps\[1\]\.remove\.body: no body is named 'A'"),
    ],
)
def test_a_level_is_never_without_a_body_and_nobody_goes_twice(tmp_path, steps, problem):
    with pytest.raises(FormatError, match=problem):
        list(play(written(tmp_path, [{"remove": {"body": name}} for name in steps])).steps)


def test_what_is_gone_can_not_be_asked_and_what_comes_can(tmp_path):
    gone = [{"remove": {"body": "Top"}}, {"request": {"body": "Top", "distance": "1"}}]
    with pytest.raises(FormatError, match=r"\$\.steps\[1\]\.request\.body: no body is named 'Top'"):
        play(written(tmp_path, gone))
    come = [{"add": body("N", (0, "3"), (0, "4"))}, {"request": {"body": "N", "distance": "1"}}]
    assert [[move.moved for move in step.moves] for step in play(written(tmp_path, come)).steps] == [[], [1]]


def test_a_body_with_a_button_on_its_top_stays_and_other_buttons_keep_their_bodies(tmp_path):
    level = {**TOWER, "buttons": BUTTON}
    with pytest.raises(FormatError, match="there is a button on the top of 'Box'"):
        list(play(written(tmp_path, [{"remove": {"body": "Box"}}], level)).steps)
    playing = play(written(tmp_path, [{"remove": {"body": "A"}}], level))
    list(playing.steps)
    game = playing.game
    assert [game.names[button.edge - len(game.level.graph.edges)] for button in game.level.buttons] == ["Box"]


@pytest.mark.parametrize("profile", ["thesis", "thesis/overshoot"])
@pytest.mark.parametrize("step", [{"add": body("N", (0, "3"), (0, "4"))}, {"remove": {"body": "Top"}}])
def test_where_bodies_move_one_after_another_a_level_keeps_its_bodies(tmp_path, step, profile):
    with pytest.raises(FormatError, match=r"\$\.steps\[0\]\.(add|remove): .*a level keeps its bodies"):
        play(written(tmp_path, [step], profile=profile))


def trace(tmp_path, change=lambda lines: None):
    """The trace of the scenario of the library, maybe changed."""
    playing = play(SCENARIO)
    lines = [json.loads(msgspec.json.encode(line)) for line in (header_of(playing, False), *lines_of(playing))]
    change(lines)
    path = tmp_path / "trace.jsonl"
    path.write_text("".join(f"{json.dumps(line)}\n" for line in lines))
    return path


def test_a_trace_tells_who_is_there_and_is_drawn_and_judged(tmp_path):
    path = trace(tmp_path)
    there = [sorted(place.name for place in line.bodies) for line in recording(path).lines]
    assert there[0] == ["A", "Rider"]
    assert there[2] == there[3] == ["A", "Chest", "Crate", "Rider"]
    assert there[-1] == ["A", "Chest", "Crate"]
    report = validate(path)
    assert report.conforms
    assert sum(report.found.values()) == 8
    assert "Chest comes" in "".join(pages(recording(path), 6))
    states = json.loads("".join(text(recording(path))))["states"]
    assert [state["action"]["tag"] for state in states[:4]] == ["Start", "Remove", "Add", "Add"]


def test_a_wrong_step_after_a_change_of_bodies_is_found(tmp_path):
    def shift(lines):
        lines[-1]["bodies"][0]["left"]["location"] = "13/4"
        lines[-1]["bodies"][0]["right"]["location"] = "17/4"

    assert not validate(trace(tmp_path, shift)).conforms


@pytest.mark.parametrize(
    ("change", "problem"),
    [
        (lambda lines: lines[1]["remove"].update(body="Nobody"), r"\$\.remove\.body: no body is named 'Nobody'"),
        (lambda lines: lines[2]["add"].update(name="A"), r"\$\.add\.name: expected a name of its own"),
        (lambda lines: lines[2]["add"]["left"].update(top="Box"), r"\$\.add\.left\.top: no body is named 'Box'"),
        (lambda lines: lines[2]["bodies"].pop(), r"\$\.bodies: expected the place of every body"),
        (lambda lines: lines[0].update(profile="thesis"), "a level keeps its bodies"),
    ],
)
def test_a_trace_that_can_not_be_is_refused(tmp_path, change, problem):
    with pytest.raises(FormatError, match=problem):
        list(recording(trace(tmp_path, change)).lines)


def test_an_api_call_that_is_refused_changes_nothing():
    played = game()
    before = places(played)
    with pytest.raises(LevelError):
        played.add(Body("N", EdgePosition(0, Fraction(1)), EdgePosition(0, Fraction(2)), Fraction(0), Fraction(1)))
    assert places(played) == before
    assert played.names == ["A", "Box", "Top"]


def test_two_bodies_at_one_place_on_a_ring_are_refused(tmp_path):
    vertices = [["0", "1"], ["4", "1"], ["4", "0"], ["6", "0"], ["6", "1"]]
    box, rider = body("Box", (2, "1/2"), (2, "3/2")), body("Rider", ("Box", "-1"), ("Box", "0"))
    bodies = [body("A", (0, "7/2"), (0, "9/2")), box, rider]
    ring = {"format": "graphbody/level@1", "name": "ring", "margin": "1/8", "circumference": "10"}
    path = written(tmp_path, [], {**ring, "vertices": vertices, "bodies": bodies})
    with pytest.raises(FormatError, match=r"\$\.level\.bodies\[2\]: 'A' and 'Rider' are at one place"):
        play(path)


def test_in_floats_a_body_comes_exactly_the_margin_away(tmp_path):
    held = {"name": "A", "left": {"edge": 0, "location": "6"}, "right": {"edge": 0, "location": "7"}}
    level = {
        "format": "graphbody/level@1",
        "name": "l",
        "margin": "1/10",
        "vertices": [[0, 0], [20, 0]],
        "bodies": [held],
    }
    come = {"name": "B", "left": {"edge": 0, "location": "71/10"}, "right": {"edge": 0, "location": "81/10"}}
    scenario = {"format": "graphbody/scenario@1", "name": "s", "level": level, "profile": "repaired"}
    path = tmp_path / "scenario.json"
    path.write_text(json.dumps({**scenario, "steps": [{"add": come}]}))
    for floats in (False, True):
        (step,) = play(path, floats).steps
        assert [one.name for one in step.bodies] == ["A", "B"]
