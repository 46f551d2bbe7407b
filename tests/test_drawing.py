"""Drawings: well-formed whatever the names, the same each time, for levels, scenarios and traces; and the sketch."""

import json
from functools import cache
from itertools import islice
from xml.etree.ElementTree import fromstring

import msgspec
import pytest
from command import graphbody

from properties.drawings import Undrawable, drawn
from properties.sketch import sketch
from reference.draw import BadLine, frames, pages, strip
from reference.formats.files import FormatError
from reference.play import LIBRARY, library
from reference.recording import recording

SVG = "{http://www.w3.org/2000/svg}"
HOSTILE = ["<script>alert(1)</script>", "\"'&amp;", "\x00\x1b[31m\n", "\u202e\ufffe\u65e5\u672c", " ", "x" * 100]
SOME = [path for path in library() if path.stem in ("hill", "stack-at-the-seam", "rider-over-a-fall-overshoot")]
MOST = 12


def drawing(path, to_a_page=6):
    return list(pages(recording(path), to_a_page))


def of_class(page, name):
    return [node for node in fromstring(page).iter() if name in node.get("class", "").split()]


def row_of(names, gap=5, speed="0"):
    """A level with a body of each name, a row of boxes that are 4 long."""
    edge = [{"edge": 0, "location": str(i * gap)} for i in range(len(names))]
    ends = [{"edge": 0, "location": str(i * gap + 4)} for i in range(len(names))]
    bodies = [
        {"name": name, "left": left, "right": right, "speed": speed}
        for name, left, right in zip(names, edge, ends, strict=True)
    ]
    vertices = [["0", "0"], [str(len(names) * gap + 10), "0"]]
    return {"format": "graphbody/level@1", "name": "row", "margin": "1", "vertices": vertices, "bodies": bodies}


def scenario_of(level, steps):
    return {"format": "graphbody/scenario@1", "name": level["name"], "level": level, "steps": steps}


def asked(body, distance):
    return {"request": {"body": body, "distance": distance}}


def saved(directory, document, name="drawn.json"):
    path = directory / name
    path.write_text(json.dumps(document) if isinstance(document, dict) else "\n".join(map(json.dumps, document)))
    return path


def trace_of(path):
    """The trace of a scenario, as the command writes it, line by line."""
    found = recording(path)
    return [json.loads(msgspec.json.encode(line)) for line in (found.header, *found.lines)]


@cache
def first_moments(path):
    """The first moments of a scenario."""
    return list(islice(frames(recording(path)), MOST))


@pytest.mark.parametrize("path", library(), ids=lambda path: path.stem)
def test_every_scenario_has_a_picture_of_its_start_and_of_each_step(path):
    moments = first_moments(path)
    nodes = [node for page in pages(recording(path), 6, 0, MOST - 1) for node in fromstring(page).iter()]
    captions = [node.text for node in nodes if node.get("class") == "caption"]
    assert sum(text == "Start" or text.split(".")[0].isdigit() for text in captions) == len(moments)
    if not any("Shown: x" in (node.text or "") for node in nodes):
        titles = {node.text.split(" at (")[0] for node in nodes if node.tag == f"{SVG}title"}
        assert titles >= {body.name for body in moments[0].world.bodies}


@pytest.mark.parametrize("path", library(), ids=lambda path: path.stem)
def test_every_scenario_has_a_sketch_of_few_columns_in_ascii(path):
    for moment in first_moments(path):
        lines = list(sketch(moment.world, moment.asked()))
        assert all(len(line) <= 78 and line.isascii() and line.isprintable() for line in lines)
        assert len(lines) <= 22


@pytest.mark.parametrize("path", SOME, ids=lambda path: path.stem)
def test_a_scenario_and_its_trace_are_drawn_alike_and_the_same_each_time(path, tmp_path):
    trace = saved(tmp_path, trace_of(path), "trace.jsonl")
    assert drawing(path) == drawing(path) == drawing(trace)


def test_a_level_is_drawn_as_it_starts():
    (page,) = drawing(LIBRARY / "levels" / "huge-and-cute.json")
    assert [node.text for node in of_class(page, "caption")] == ["Start"]
    assert len(of_class(page, "button")) == 3


def test_what_differs_in_colour_differs_in_its_element_too():
    (page, *_) = drawing(LIBRARY / "scenarios" / "figure-4-4-dynamic-graph.json")
    for kind in ("character", "box", "ground", "fall", "jump", "wall", "margin", "contact", "support", "ghost", "eye"):
        assert of_class(page, kind), kind
    assert "prefers-color-scheme: dark" in page


@pytest.mark.parametrize(("name", "marks"), [("slanted-fall-edge", 1), ("figure-6-6d-tunnel", 2), ("hill", 0)])
def test_bodies_in_one_another_or_in_terrain_are_marked(name, marks):
    page, *_ = drawing(LIBRARY / "scenarios" / f"{name}.json")
    in_legend = marks > 0
    assert len(of_class(page, "overlap")) == marks + in_legend


def test_hostile_names_are_text(tmp_path):
    level = row_of(HOSTILE)
    path = saved(tmp_path, scenario_of(level | {"name": HOSTILE[0]}, [asked(name, "1") for name in HOSTILE]))
    for page in drawing(path):
        assert not list(fromstring(page).iter(f"{SVG}script"))
    for moment in frames(recording(path)):
        assert all(line.isascii() and line.isprintable() for line in sketch(moment.world))


def test_a_thousand_bodies_in_a_row(tmp_path):
    path = saved(tmp_path, scenario_of(row_of([f"Box {i}" for i in range(1000)]), [asked("Box 990", "5")]))
    (page,) = drawing(path)
    assert len(page) < 200_000
    assert "Shown: x from" in page
    for moment in frames(recording(path)):
        *rows, shown = sketch(moment.world, ["Box 990"])
        assert max(map(len, rows)) <= 78
        assert "the level is from 0 to 5010" in shown


@pytest.mark.parametrize(
    "level",
    [
        {"vertices": [["0", "0"], ["1" + "0" * 90, "0"]]},
        {"vertices": [[0.1, 1e98], [1e99, 1e98]]},
        {"vertices": [["0", "0"], ["4000000", "3000000"], ["4000001", "3000000"]]},
        {"vertices": [["0", "0"], ["12", "0"]], "circumference": "16"},
        {"vertices": [["0", "0"], ["0", "-5"]], "bodies": []},
    ],
    ids=["long", "floats", "slope", "ring", "empty"],
)
def test_odd_levels_are_drawn(level, tmp_path):
    path = saved(tmp_path, row_of(["A", "B"]) | level)
    (page,) = drawing(path)
    fromstring(page)
    (moment,) = frames(recording(path))
    assert list(sketch(moment.world))


def test_the_log_of_another_program_may_say_little(tmp_path):
    header, *lines = trace_of(LIBRARY / "scenarios" / "rider-over-a-fall.json")
    for line in lines:
        for field in ("moves", "events", "supports", "step"):
            line.pop(field)
    (first, _) = drawing(saved(tmp_path, [header, *lines], "foreign.jsonl"))
    assert "1. Right asked 3/2" in first


def test_some_steps_are_a_strip_of_their_own():
    found = recording(LIBRARY / "scenarios" / "pushing-boxes-5.json")
    page = strip(found, 7, 8)
    assert [node.text.split(".")[0] for node in of_class(page, "caption")] == ["7", "8"]
    assert not of_class(page, "name")


def test_pages_are_named_after_the_file_and_hold_six_panels(tmp_path):
    path = saved(tmp_path, scenario_of(row_of(["A"]) | {"name": "../../up"}, [asked("A", "1/2")] * 8), "a.b.json")
    assert list(drawn(path, tmp_path / "out", "")) == [tmp_path / "out" / name for name in ("a.b-1.svg", "a.b-2.svg")]
    assert list(drawn(path, tmp_path / "out", "2-7")) == [tmp_path / "out" / "a.b.svg"]
    assert list(drawn(path, tmp_path / "out", "8")) == [tmp_path / "out" / "a.b.svg"]
    assert sorted(file.name for file in (tmp_path / "out").iterdir()) == ["a.b-1.svg", "a.b-2.svg", "a.b.svg"]


@pytest.mark.parametrize("steps", ["3-", "x", "5-2", "-1", "9-10", "1-99999999999"])
def test_steps_that_are_not_there_are_refused(steps, tmp_path):
    path = saved(tmp_path, scenario_of(row_of(["A"]), [asked("A", "1")] * 8))
    with pytest.raises(Undrawable):
        list(drawn(path, tmp_path / "out", steps))
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("place", "problem"),
    [
        ({"name": "A", "left": {"edge": 0, "location": 2}, "right": {"edge": 0, "location": 2}}, "left border"),
        ({"name": "A", "left": {"top": "A", "location": 1}, "right": {"top": "A", "location": 2}}, "chain of supports"),
    ],
)
def test_a_line_that_cannot_be_drawn_is_named_and_nothing_is_written(place, problem, tmp_path):
    trace = trace_of(saved(tmp_path, scenario_of(row_of(["A"]), [asked("A", "1/8")] * 9)))
    trace[9]["bodies"] = [place]
    path = saved(tmp_path, trace, "broken.jsonl")
    with pytest.raises(BadLine, match=f"^10: .*{problem}"):
        drawing(path)
    done = graphbody("draw", path, "--out", "out", cwd=tmp_path)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.startswith(f"graphbody: {path}:10: $.bodies[0]")
    assert done.stderr.count("\n") == 1
    assert not (tmp_path / "out").exists()
    assert len(list(drawn(path, tmp_path / "out", "0-8"))) == 2


def test_a_line_that_cannot_be_read_is_named(tmp_path):
    trace = trace_of(saved(tmp_path, scenario_of(row_of(["A"]), [asked("A", "1/8")] * 3)))
    path = saved(tmp_path, [*trace, {"bodies": []}], "broken.jsonl")
    with pytest.raises(FormatError, match=r"broken\.jsonl:5: "):
        drawing(path)


def test_too_many_pages_are_refused_with_a_hint(tmp_path, monkeypatch):
    monkeypatch.setattr("properties.drawings.MOST_PAGES", 1)
    path = saved(tmp_path, scenario_of(row_of(["A"]), [asked("A", "1/8")] * 9))
    with pytest.raises(Undrawable, match="--steps A-B"):
        list(drawn(path, tmp_path, ""))


def test_where_nothing_can_be_written_is_said_in_one_line(tmp_path):
    path = saved(tmp_path, row_of(["A"]))
    done = graphbody("draw", path, "--out", path, cwd=tmp_path)
    assert done.returncode == 2
    assert done.stderr.count("\n") == 1


def test_the_command_prints_each_path(tmp_path):
    done = graphbody("draw", LIBRARY / "scenarios" / "one-edge.json", cwd=tmp_path)
    assert done.stdout == "build/drawings/one-edge.svg\n"
    fromstring((tmp_path / "build" / "drawings" / "one-edge.svg").read_text(encoding="utf-8"))
