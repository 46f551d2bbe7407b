"""The formats: their schemas, what is published about them, traces that can be read again, and ITF."""

import json
import re
import subprocess
import sys
from fractions import Fraction
from functools import cache
from pathlib import Path

import msgspec
import pytest
from command import graphbody
from jsonschema import Draft202012Validator

from properties.claims.claim import Verdict
from properties.conformance.validate import MOST_IN_PLANE
from properties.conformance.ways import MOST_DECISIONS, MOST_OUTCOMES, MOST_WAYS
from properties.pages import with_tables
from properties.results import ClaimResult, Evidence, Ledger, Results
from properties.schemas import KINDS, schema
from reference.formats.files import MOST_BYTES, MOST_CHARACTERS, MOST_ITEMS, read
from reference.formats.level import MOST_BUTTONS, LevelRecord, valid_level
from reference.formats.numbers import MOST_DIGITS, MOST_LONG
from reference.plan import check_plan
from reference.play import LIBRARY, library, play
from reference.recording import recording
from reference.rounding import ROUNDINGS
from reference.world import MOST_STOREYS

PAGE = Path(__file__).parents[1] / "docs" / "formats.md"
VALIDATORS = {kind: Draft202012Validator(schema(kind)) for kind in KINDS}


def check(kind, document):
    """Hold a document against the schema of its kind."""
    assert not [error.message for error in VALIDATORS[kind].iter_errors(document)]


@cache
def traced(path, *options):
    """The lines of the trace of a scenario, as the command prints them."""
    return graphbody("simulate", path, "--json", *options).stdout.splitlines()


@pytest.mark.parametrize("kind", KINDS)
def test_a_schema_is_a_schema_and_every_field_in_it_says_what_it_means(kind):
    published = json.loads(graphbody("schema", kind).stdout)
    Draft202012Validator.check_schema(published)
    assert published["$schema"] == Draft202012Validator.META_SCHEMA["$id"]
    for record in published["$defs"].values():
        assert record["description"]
        for name, field in record.get("properties", {}).items():
            assert field.get("description"), name


def test_the_kinds_of_files_are_listed_and_another_kind_is_refused():
    listed = graphbody("schema").stdout.splitlines()
    assert [line.split()[0] for line in listed] == list(KINDS)
    done = graphbody("schema", "levle")
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == "graphbody: expected one of level, scenario, trace, validation, lint, results, got 'levle'\n"


def test_a_schema_is_printed_without_the_solver():
    code = "import properties.schemas, sys; print([m for m in ('z3', 'hypothesis', 'numpy') if m in sys.modules])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


@pytest.mark.parametrize("kind", ["level", "scenario"])
def test_the_library_is_as_the_schemas_say(kind):
    for path in (LIBRARY / f"{kind}s").glob("*.json"):
        check(kind, json.loads(path.read_text()))


@pytest.mark.parametrize("options", [(), ("--floats",)], ids=["exact", "floats"])
@pytest.mark.parametrize("path", library(), ids=lambda path: path.stem)
def test_a_trace_is_as_its_schema_says_and_is_read_again(tmp_path, path, options):
    lines = traced(path, *options)
    for line in lines:
        check("trace", json.loads(line))
    (tmp_path / "trace.jsonl").write_text("\n".join(lines))
    again = recording(tmp_path / "trace.jsonl")
    assert [again.header, *again.lines] == [
        msgspec.json.decode(line, type=kind)
        for line, kind in zip(lines, [type(again.header), *KINDS["trace"].documents[1:] * len(lines)], strict=False)
    ]


def test_what_sums_make_of_the_longest_numbers_is_read_again(tmp_path):
    primes = [10**30 + 57, 10**30 + 99]
    level = {
        "format": "graphbody/level@1",
        "name": "long numbers",
        "vertices": [[str(-(10**99)), "0"], [str(10**99), "0"]],
        "bodies": [
            {"name": "A", "left": {"edge": 0, "location": f"1/{primes[0]}"}, "right": {"edge": 0, "location": "1"}},
            {"name": "B", "left": {"edge": 0, "location": "2"}, "right": {"edge": 0, "location": "3"}},
        ],
    }
    step = {"request": {"body": "A", "distance": f"{10**80}/{primes[1]}"}}
    scenario = {"format": "graphbody/scenario@1", "name": "long numbers", "level": level, "steps": [step]}
    (tmp_path / "scenario.json").write_text(json.dumps(scenario))
    (tmp_path / "trace.jsonl").write_text("\n".join(traced(tmp_path / "scenario.json")))
    (line,) = recording(tmp_path / "trace.jsonl").lines
    assert max(len(place.left.location) for place in line.bodies) > 100


def test_results_are_as_their_schema_says():
    rests_on = Ledger(["condition/x"], [], [], ["push/none"], 3, 9, True, 4, 2, {"contract/x": 7}, 1000, 0.05, 3, False)
    values = {"margin": "1/4", "ahead": True}
    shown = Evidence("prove x", "z3", 3, 9, True, ["condition/x"], [], [], values, {"contract/x": 7}, [1000])
    claim = ClaimResult(
        "claim/x",
        "string",
        "thesis",
        [],
        Verdict.BOUNDED,
        Verdict.TESTED,
        8,
        9,
        "z3",
        0.5,
        None,
        rests_on,
        ["prove x"],
    )
    results = Results("graphbody/results@1", "0" * 64, {"python": "3.11"}, [claim], [shown])
    check("results", json.loads(msgspec.json.encode(results)))


def test_the_tables_on_the_page_are_those_of_the_schemas():
    page = PAGE.read_text()
    assert with_tables(page) == page


def number(value):
    """The number that a rational in ITF stands for."""
    assert value.keys() == {"num", "den"}
    return Fraction(int(value["num"]["#bigint"]), int(value["den"]["#bigint"]))


@pytest.mark.parametrize("path", library(), ids=lambda path: path.stem)
def test_itf_has_a_state_for_the_start_and_one_for_each_step_with_exact_numbers(tmp_path, path):
    itf = json.loads(graphbody("itf", path).stdout)
    _, *steps = map(json.loads, traced(path))
    assert len(itf["states"]) == len(steps) + 1
    assert all(state.keys() == {"#meta", *itf["vars"]} for state in itf["states"])
    for step, state in zip(steps, itf["states"][1:], strict=True):
        borders = dict(state["bodies"]["#map"])
        for body in step["bodies"]:
            assert number(borders[body["name"]]["left"]["location"]) == Fraction(body["left"]["location"])
            assert number(borders[body["name"]]["right"]["location"]) == Fraction(body["right"]["location"])
    (tmp_path / "trace.jsonl").write_text("\n".join(traced(path)))
    assert json.loads(graphbody("itf", tmp_path / "trace.jsonl").stdout) == itf


def test_itf_of_floats_has_their_exact_binary_values_and_names_what_a_trace_leaves_out(tmp_path):
    header, first, *_ = map(json.loads, traced(library()[0], "--floats"))
    bare = {key: first[key] for key in ("request", "tick", "drive", "bodies") if key in first}
    bare["bodies"][0]["left"]["location"] = 0.1
    (tmp_path / "trace.jsonl").write_text(f"{json.dumps(header)}\n{json.dumps(bare)}\n")
    state = json.loads(graphbody("itf", tmp_path / "trace.jsonl").stdout)["states"][1]
    assert number(state["bodies"]["#map"][0][1]["left"]["location"]) == Fraction(0.1)
    assert state["#meta"]["left_out"][:2] == ["fired", "events"]


def test_a_game_of_a_thousand_bodies_in_a_row(tmp_path):
    count = 1000
    bodies = [
        {"name": f"B{i}", "left": {"edge": 0, "location": 2 * i}, "right": {"edge": 0, "location": 2 * i + 1}}
        for i in range(count)
    ]
    vertices = [[0, 0], [3 * count, 0]]
    level = {"format": "graphbody/level@1", "name": "row", "vertices": vertices, "bodies": bodies}
    step = {"request": {"body": "B0", "distance": 2 * count}}
    scenario = {"format": "graphbody/scenario@1", "name": "row", "level": level, "steps": [step]}
    (tmp_path / "row.json").write_text(json.dumps(scenario))
    lines = traced(tmp_path / "row.json")
    assert json.loads(lines[1])["moves"][0]["chain"] == count
    (tmp_path / "trace.jsonl").write_text("\n".join(lines))
    itf = graphbody("itf", tmp_path / "trace.jsonl")
    assert itf.returncode == 0
    assert itf.stdout == graphbody("itf", tmp_path / "row.json").stdout
    assert len(json.loads(itf.stdout)["states"][1]["bodies"]["#map"]) == count


def blocks(language):
    """The examples on the page in one language."""
    return re.findall(rf"```{language}\n(.*?)```", PAGE.read_text(), re.DOTALL)


@pytest.fixture
def examples(tmp_path, monkeypatch):
    """The examples on the page as files, in the directory in which the commands run."""
    monkeypatch.chdir(tmp_path)
    level, platform, scenario, storeys = blocks("json")
    (trace,) = blocks("jsonl")
    files = {"level.json": level, "platform.json": platform, "scenario.json": scenario, "storeys.json": storeys}
    files["trace.jsonl"] = trace
    for name, content in files.items():
        (tmp_path / name).write_text(content)


@pytest.mark.usefixtures("examples")
def test_the_examples_on_the_page_are_as_the_schemas_say_and_do_what_the_page_says():
    check("level", json.loads(Path("level.json").read_text()))
    check("scenario", json.loads(Path("scenario.json").read_text()))
    for line in Path("trace.jsonl").read_text().splitlines():
        check("trace", json.loads(line))
    assert graphbody("simulate", "level.json").returncode == 0
    assert graphbody("simulate", "platform.json").returncode == 0
    check_plan(valid_level(read(Path("storeys.json"), LevelRecord), "$"))
    played = graphbody("simulate", "scenario.json")
    assert played.returncode == 0
    assert "".join(f"    {line}".rstrip() + "\n" for line in played.stdout.splitlines()) in PAGE.read_text()


@pytest.mark.usefixtures("examples")
def test_the_trace_on_the_page_is_that_of_the_scenario_in_floats():
    steps = play(Path("scenario.json"), floats=True).steps
    for line, step in zip(recording(Path("trace.jsonl")).lines, steps, strict=True):
        assert type(line.asked.asked[0]) is type(step.asked)
        for place, body in zip(line.bodies, step.bodies, strict=True):
            assert (place.left.edge, place.right.edge) == (body.left.edge, body.right.edge)
            assert (place.left.location, place.right.location) == (body.left.location, body.right.location)


@pytest.mark.usefixtures("examples")
def test_the_trace_on_the_page_conforms_and_the_wrong_one_is_told_as_the_page_says():
    assert graphbody("validate", "trace.jsonl").returncode == 0
    trace = Path("trace.jsonl").read_text()
    right = '"left": {"edge": 2, "location": 0.0}, "right": {"edge": 2, "location": 1.0}'
    wrong = '"left": {"edge": 2, "location": 0.5}, "right": {"edge": 2, "location": 1.5}'
    Path("trace.jsonl").write_text(trace.replace(right, wrong))
    done = graphbody("validate", "trace.jsonl")
    assert done.returncode == 1
    assert "".join(f"    {line}\n" for line in done.stdout.splitlines()) in PAGE.read_text()
    page = " ".join(PAGE.read_text().split())
    most = f"{MOST_OUTCOMES} outcomes, {MOST_DECISIONS} decisions"
    assert f"({MOST_WAYS} ways for a request, four times as many for a step, {most})" in page
    assert f"Else it is {ROUNDINGS} roundings" in page
    assert f"with up to {MOST_IN_PLANE} bodies" in page


@pytest.mark.usefixtures("examples")
def test_the_refusal_on_the_page_is_what_is_printed():
    level = json.loads(Path("level.json").read_text())
    level["bodies"][1]["left"]["edge"] = 7
    Path("level.json").write_text(json.dumps(level))
    assert f"    {graphbody('simulate', 'level.json').stderr}" in PAGE.read_text()


def test_the_limits_on_the_page_are_those_of_the_code():
    table = PAGE.read_text().split("| what | at most |")[1].split("\n\n")[0]
    limits = [int(found.replace(",", "")) for found in re.findall(r"\| (\d[\d,]*)", table)]
    digits = [MOST_DIGITS, MOST_DIGITS]
    items = [MOST_ITEMS, MOST_BUTTONS, MOST_STOREYS, MOST_CHARACTERS, MOST_LONG]
    assert limits == [MOST_BYTES // 2**20, *items, *digits]


@pytest.mark.parametrize(
    ("beside", "profile", "accepted"), [(1, "repaired", True), (2, "repaired", False), (1, "thesis", False)]
)
def test_a_top_holds_a_body_that_is_wholly_beside_it_under_repaired_only(tmp_path, beside, profile, accepted):
    borders = [{"top": "A", "location": f"{-8 - beside}/8"}, {"top": "A", "location": f"{-beside}/8"}]
    ground = [{"edge": 0, "location": str(x)} for x in (3, 4)]
    bodies = [{"name": name, "left": at[0], "right": at[1]} for name, at in (("A", ground), ("R", borders))]
    level = {"format": "graphbody/level@1", "name": "beside", "margin": "1/4", "vertices": [["0", "0"], ["9", "0"]]}
    request = {"request": {"body": "A", "distance": "1"}}
    scenario = {"format": "graphbody/scenario@1", "name": "beside", "profile": profile, "steps": [request]}
    file = tmp_path / "beside.json"
    file.write_text(json.dumps(scenario | {"level": level | {"bodies": bodies}}))
    done = graphbody("simulate", str(file))
    assert done.returncode == (0 if accepted else 2)
    if not accepted:
        assert f"bodies[1].right.location: expected 0 to 1, got {Fraction(-beside, 8)}" in done.stderr
