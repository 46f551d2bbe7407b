"""Hostile input: whatever is in a file, it is accepted, or refused in one line that names the place."""

import json
import re
from copy import deepcopy
from itertools import islice

import pytest
from command import graphbody
from hypothesis import HealthCheck, given, seed, settings, strategies as st
from jsonschema import Draft202012Validator

from properties.evidence.sample import SEED
from properties.schemas import schema
from reference.formats.files import FormatError
from reference.play import LIBRARY, library, play
from reference.recording import recording
from reference.simulator import Endless

PLAYED = ("level", "scenario")
VALIDATORS = {kind: Draft202012Validator(schema(kind)) for kind in (*PLAYED, "trace")}
LEVEL = {
    "format": "graphbody/level@1",
    "name": "good",
    "vertices": [["0", "0"], ["10", "0"], ["10", "-1"], ["20", "-1"]],
    "bodies": [
        {"name": "A", "left": {"edge": 0, "location": "1"}, "right": {"edge": 0, "location": "2"}, "speed": "1"},
        {"name": "B", "left": {"edge": 0, "location": "4"}, "right": {"edge": 0, "location": "5"}},
        {"name": "C", "left": {"top": "B", "location": "0"}, "right": {"top": "B", "location": "1"}},
    ],
    "buttons": [{"edge": 2, "location": "3"}],
}
SCENARIO = {
    "format": "graphbody/scenario@1",
    "name": "good",
    "level": LEVEL,
    "steps": [{"request": {"body": "A", "distance": "3"}}, {"tick": {"key": "right", "times": 2}}],
}
TEXTS = ["A", "B", "C", "", "\x00\n", "\ud800", "x" * 200, "graphbody/level@1", "graphbody/level@2", "../../..", "."]
NUMBERS = ["0", "3/2", "-1", "0.25", "1/0", "9" * 90, "9" * 999, "1/" + "7" * 90, "NaN", "1e400", "0x1", "١"]
VALUES = [None, True, 0, 1, 2, -1, 0.1, -0.0, 5e-324, 1.7e308, 2**63, 2**64, 10**99, 10**400, [], {}, [[]], {"a": 1}]
HOSTILE = st.sampled_from(TEXTS + NUMBERS + VALUES + [float("inf"), float("nan")])
RUNS = settings(deadline=None, database=None, suppress_health_check=list(HealthCheck))
FILES = [pytest.param(many, marks=pytest.mark.slow) if many > 100 else many for many in (100, 350)]
"""How many files are tried: all of them among the slow tests only."""


def documents(kind):
    """Files made from the schema of a kind, document by document, here and there with a hostile value instead."""
    records = schema(kind)["$defs"]
    if kind != "trace":
        return st.tuples(made(records[kind.title()], records))
    header, steps = made(records["Header"], records), some(records["Line"], records)
    return st.builds(lambda first, others: [first, *others], header, steps)


def made(node, records):
    """What a part of a schema permits, or, one time in sixty, a hostile value."""
    permitted = permits(node, records)
    return st.integers(0, 59).flatmap(lambda n: HOSTILE if n == 7 else permitted)


def some(node, records, least=0):
    """A list of a few of what a part of a schema permits."""
    return st.lists(made(node, records), min_size=least, max_size=least + 2)


def permits(node, records):
    """What a part of a schema permits."""
    if "$ref" in node:
        return st.deferred(lambda: permits(records[node["$ref"].rpartition("/")[2]], records))
    if "anyOf" in node:
        return st.one_of([made(choice, records) for choice in node["anyOf"]])
    if "const" in node or "enum" in node:
        return st.sampled_from(node.get("enum", [node.get("const")]))
    if "pattern" in node:
        return st.sampled_from(NUMBERS[:4])
    if node["type"] == "array":
        if "prefixItems" in node:
            return st.tuples(*[made(item, records) for item in node["prefixItems"]])
        return some(node["items"], records, node.get("minItems", 0))
    if node["type"] == "object" and "properties" in node:
        fields = {name: made(field, records) for name, field in node["properties"].items()}
        needed = {name: fields.pop(name) for name in node["required"]}
        return st.fixed_dictionaries(needed, optional=fields)
    return {
        "object": st.dictionaries(st.sampled_from(TEXTS[:3]), HOSTILE, max_size=2),
        "string": st.sampled_from(TEXTS[:3]),
        "integer": st.integers(node.get("minimum", 0), 3),
        "number": st.sampled_from([0, 0.5, 3]),
        "boolean": st.booleans(),
        "null": st.none(),
    }[node["type"]]


def places(document, path=()):
    """The paths of all places in a document."""
    yield path
    inside = (
        document.items() if isinstance(document, dict) else enumerate(document) if isinstance(document, list) else ()
    )
    for key, value in inside:
        yield from places(value, (*path, key))


def spoiled(draw, document):
    """A document with one to three places replaced, deleted or doubled."""
    document = json.loads(json.dumps(document))
    for _ in range(draw(st.integers(1, 3))):
        found = [path for path in places(document) if path]
        if not found:
            break
        *path, last = draw(st.sampled_from(found))
        target = document
        for key in path:
            target = target[key]
        how = draw(st.sampled_from(["replace", "delete", "double"]))
        if how == "delete":
            del target[last]
        elif how == "double" and isinstance(target, list):
            target.insert(last, target[last])
        else:
            target[last] = deepcopy(draw(HOSTILE))
    return document


def lines(*documents):
    """The bytes of JSON lines."""
    return b"".join(json.dumps(document).encode() + b"\n" for document in documents)


def trace_of(path, floats=False):
    """The trace of a scenario, as the command line prints it."""
    done = graphbody("simulate", path, "--json", *(["--floats"] if floats else []))
    return [json.loads(line) for line in done.stdout.splitlines()]


def outcome(path, content):
    """Load a file, and play or read a little of it: the schema holds what is accepted, one line says what is not."""
    path.write_bytes(content)
    refused = lead_in(path)
    if refused is not None:
        assert refused.isprintable()
        assert refused.startswith(str(path.parent))
        return False
    read = [json.loads(line) for line in content.splitlines()] if path.stem == "trace" else [json.loads(content)]
    for document in read:
        assert not list(VALIDATORS[path.stem].iter_errors(document))
    return True


def lead_in(path):
    """Do what the commands do with a file at first, or, if it is a trace, with all of it; say why it is refused."""
    try:
        if path.stem == "trace":
            list(recording(path).lines)
        else:
            playing = play(path, floats=path.stem == "scenario")
            playing.game.most = 500
            list(islice(playing.steps, 2))
    except FormatError as error:
        return str(error)
    except Endless:
        return None
    return None


@pytest.mark.parametrize("many", FILES)
@pytest.mark.parametrize("kind", [*PLAYED, "trace"])
def test_documents_made_from_the_schemas(tmp_path, kind, many):
    accepted = []

    @seed(SEED)
    @settings(RUNS, max_examples=many)
    @given(documents(kind))
    def each(found):
        accepted.append(outcome(tmp_path / f"{kind}.json", lines(*found)))

    each()
    print(f"{sum(accepted)} of {len(accepted)} accepted")


GOOD = {
    "level": [[LEVEL]] + [[json.loads(path.read_text())] for path in sorted((LIBRARY / "levels").glob("*.json"))],
    "scenario": [[SCENARIO]],
    "trace": [trace_of(path) for path in sorted(library(), key=lambda path: path.stat().st_size)[:9]],
}


@pytest.mark.parametrize("many", FILES)
@pytest.mark.parametrize("kind", GOOD)
def test_good_documents_with_a_few_places_spoiled(tmp_path, kind, many):
    accepted = []

    @seed(SEED)
    @settings(RUNS, max_examples=many)
    @given(st.data())
    def each(data):
        found = list(data.draw(st.sampled_from(GOOD[kind])))
        at = data.draw(st.integers(0, len(found) - 1))
        found[at] = spoiled(data.draw, found[at])
        accepted.append(outcome(tmp_path / f"{kind}.json", lines(*found)))

    each()
    assert 0.02 < sum(accepted) / len(accepted) < 0.9


@pytest.mark.parametrize("many", FILES)
@pytest.mark.parametrize("kind", GOOD)
def test_good_files_cut_short_or_with_bytes_changed(tmp_path, kind, many):
    @seed(SEED)
    @settings(RUNS, max_examples=many)
    @given(st.data())
    def each(data):
        content = bytearray(lines(*data.draw(st.sampled_from(GOOD[kind]))))
        for at in data.draw(st.lists(st.integers(0, len(content) - 1), max_size=3)):
            content[at] = data.draw(st.integers(0, 255))
        outcome(tmp_path / f"{kind}.json", bytes(content[: data.draw(st.integers(0, len(content)))]))

    each()


def changed(document, *path, to):
    """A copy of a document with another value at a place."""
    document = json.loads(json.dumps(document))
    target = document
    for key in path[:-1]:
        target = target[key]
    target[path[-1]] = to
    return document


A, B, C = LEVEL["bodies"]
RING = {"circumference": "20", "vertices": [["0", "0"], ["10", "0"]], "buttons": []}
ROUND = [
    {**body, "left": {"edge": 0, "location": at}, "right": {"edge": 1, "location": "9"}}
    for body, at in ((A, 1), (B, 2))
]
TWICE = [{"left": 0, "right": 1}, {"left": 0, "right": 1}, {"left": 1, "right": 2}, {"left": 2, "right": 3}]
TOWER = [A, *({**C, "name": f"T{i}", "left": C["left"] | {"top": f"T{i - 1}" if i else "A"}} for i in range(101))]
TOWER = [TOWER[0], *({**body, "right": {**body["left"], "location": "1"}} for body in TOWER[1:])]
BAD_LEVELS = {
    "a wrong type": (changed(LEVEL, "bodies", 1, "left", to=7), r"\$\.bodies\[1\]\.left: Expected `object`, got `int`"),
    "a missing field": ({k: v for k, v in LEVEL.items() if k != "name"}, r"\$: .* missing required field `name`"),
    "an unknown field": (changed(LEVEL, "bodies", 0, "sp\need", to=1), r"\$\.bodies\[0\]: .* unknown field `sp\\need`"),
    "another version": (
        changed(LEVEL, "format", to="graphbody/level@9"),
        r"\$\.format: expected graphbody/level@1, got 'graphbody/level@9'",
    ),
    "not a number": (changed(LEVEL, "margin", to=float("nan")), "not JSON: JSON is malformed"),
    "infinity": (changed(LEVEL, "margin", to=float("inf")), "not JSON: JSON is malformed"),
    "too large a float": ('{"format": "graphbody/level@1", "margin": 1e400}', r"\$\.margin: Number out of range"),
    "a thousand digits": (changed(LEVEL, "margin", to="7" * 1000), r"\$\.margin: expected at most 400 characters"),
    "a thousand digits, bare": (changed(LEVEL, "margin", to=10**999), r"\$\.margin: expected at most 400 digits"),
    "five thousand digits": (
        f'{{"format": "graphbody/level@1", "margin": {"7" * 5000}}}',
        r"\$\.margin: Integer value out of range",
    ),
    "too large": (changed(LEVEL, "bodies", 1, "height", to="7" * 101), r"\$\.bodies\[1\]: expected .* 100 digits"),
    "denominators": (changed(LEVEL, "bodies", 1, "height", to="1/" + "7" * 101), r"\$\.bodies\[1\]: .* 100 digits"),
    "many bodies": (changed(LEVEL, "bodies", to=[A] * 100_001), r"\$\.bodies: Expected `array` of length <= 100000"),
    "deep nesting": ('{"a":' * 1_000_000, r"\$: (expected .* nested less deeply|.* unknown field `a`)"),
    "a name twice": (changed(LEVEL, "bodies", 1, "name", to="A"), r"\$\.bodies\[1\]\.name: expected a name of its own"),
    "an unknown edge": (
        changed(LEVEL, "bodies", 1, "left", "edge", to=3),
        r"\$\.bodies\[1\]\.left\.edge: expected 0 to 2",
    ),
    "an unknown top": (
        changed(LEVEL, "bodies", 2, "left", "top", to="D"),
        r"\$\.bodies\[2\]\.left\.top: no body is named",
    ),
    "no such button": (changed(LEVEL, "buttons", 0, "edge", to=3), r"\$\.buttons\[0\]\.edge: expected 0 to 2, got 3"),
    "an overlap": (
        changed(LEVEL, "bodies", 1, "left", "location", to=1.5),
        r"\$\.bodies\[1\]: 'A' and 'B' are -1/2 apart",
    ),
    "on two strings": (
        changed(LEVEL, "bodies", 1, "right", "edge", to=2),
        r"\$\.bodies\[1\]\.right\.edge: expected an edge",
    ),
    "inside out": (
        changed(LEVEL, "bodies", 2, "right", "location", to=0),
        r"\$\.bodies\[2\]: expected the left border to be",
    ),
    "two edges under one key": (
        LEVEL | {"edges": TWICE},
        r"\$\.vertices\[0\]: ground edges 0 and 1 leave it to the right",
    ),
    "wider than their ring": (LEVEL | RING | {"bodies": ROUND}, r"\$\.bodies: the bodies are wider than the ring by"),
    "wider than its ring": (
        LEVEL | RING | {"bodies": [changed(ROUND[0], "right", to={"edge": 1, "location": "199/10"})]},
        r"\$\.bodies\[0\]\.right\.location: expected 0 to 10",
    ),
    "a tower": (LEVEL | {"bodies": TOWER}, r"\$\.bodies\[101\]\.left\.top: expected a chain of supports"),
    "on itself": (changed(LEVEL, "bodies", 2, "left", "top", to="C"), r"\$\.bodies\[2\]\.right: expected both borders"),
    "binary garbage": (bytes(range(256)), "not JSON: JSON is malformed"),
    "nothing": (b"", r"\$: expected a JSON document, got nothing"),
    "cut short": (json.dumps(LEVEL)[:-9], "not JSON: Input data was truncated"),
}


def refusal(directory, *arguments):
    """The one line in which a command refuses bad input, having printed nothing and written nothing."""
    there = sorted(directory.iterdir())
    done = graphbody(*arguments)
    assert done.returncode == 2
    assert done.stdout == ""
    assert done.stderr.startswith(f"graphbody: {directory}")
    assert done.stderr.count("\n") == 1
    assert done.stderr[:-1].isprintable()
    assert sorted(directory.iterdir()) == there
    return done.stderr


def written(path, content):
    """A file with bytes, a text or a document."""
    text = content if isinstance(content, str | bytes) else json.dumps(content)
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return path


@pytest.mark.parametrize("command", ["simulate", "itf"])
@pytest.mark.parametrize(("content", "expected"), BAD_LEVELS.values(), ids=BAD_LEVELS)
def test_a_bad_level_is_refused_wherever_it_is(tmp_path, command, content, expected):
    alone = written(tmp_path / "level.json", content)
    assert re.search(f"level.json: {expected}", refusal(tmp_path, command, alone))
    beside = written(tmp_path / "beside.json", SCENARIO | {"level": "level.json"})
    assert re.search(f"level.json: {expected}", refusal(tmp_path, command, beside))
    if isinstance(content, dict):
        inside = expected.replace(r"\$", r"\$\.level", 1)
        scenario = written(tmp_path / "scenario.json", SCENARIO | {"level": content})
        assert re.search(f"scenario.json: {inside}", refusal(tmp_path, command, scenario))
        header = GOOD["trace"][0][0] | {"level": content}
        trace = written(tmp_path / "trace.jsonl", json.dumps(header))
        assert re.search(f"trace.jsonl(:1)?: {inside}", refusal(tmp_path, "itf", trace))


@pytest.mark.parametrize(
    ("changes", "expected"),
    [
        ({"steps": [{}]}, r"\$\.steps\[0\]: expected one of `request`, `tick`, `drive`, `add` and `remove`"),
        (
            {"steps": [{"request": {"body": "D", "distance": 1}}]},
            r"\$\.steps\[0\]\.request\.body: no body is named 'D'",
        ),
        (
            {"steps": [{"request": {"body": "A", "distance": "x"}}]},
            r"\$\.steps\[0\]\.request\.distance: expected a number",
        ),
        ({"steps": [{"tick": {"key": "up"}}]}, r"\$\.steps\[0\]\.tick\.key: expected left or none or right, got 'up'"),
        ({"steps": [{"tick": {"key": "left", "times": 60_000}}] * 2}, r"\$\.steps\[1\]: expected at most 100000"),
        (
            {"profile": "x" * 100_000},
            r"\$\.profile: expected one of thesis, thesis/overshoot, thesis/mended-velocity, repaired, .*, got 'xxx",
        ),
        ({"level": "."}, r"Is a directory"),
        ({"level": "\x00"}, r"embedded null byte"),
        ({"level": "x" * 256}, r"\$\.level: Expected"),
        ({"level": "missing.json"}, r"missing.json: No such file or directory"),
    ],
)
def test_a_bad_scenario_is_refused(tmp_path, changes, expected):
    path = written(tmp_path / "scenario.json", SCENARIO | changes)
    for command in ("simulate", "itf"):
        assert re.search(expected, refusal(tmp_path, command, path))


@pytest.mark.parametrize(
    ("path", "value", "expected"),
    [
        (["step"], 7, r"\$\.step: expected 2, got 7"),
        (["bodies", 0, "name"], "D", r"\$\.bodies\[0\]\.name: no body is named 'D'"),
        (["bodies", 0, "name"], "B", r"\$\.bodies\[1\]\.name: expected each body once, got 'B' again"),
        (["bodies"], [], r"\$\.bodies: expected the place of every body, got none of 'A'"),
        (["bodies", 0, "left", "edge"], 9, r"\$\.bodies\[0\]\.left\.edge: expected 0 to 2, got 9"),
        (["bodies", 0, "left", "location"], "1/0", r"\$\.bodies\[0\]\.left\.location: expected a finite number"),
        (["bodies", 0, "left", "location"], "1/" + "7" * 300, r"\$\.bodies\[0\]: expected .* 100 digits"),
        (["tick"], None, r"\$: expected one of `request`, `tick`, `drive`, `add` and `remove`"),
        (["moves", 0, "moved"], "far", r"\$\.moves\[0\]\.moved: expected a number"),
        (["events"], [{"body": "D", "event": "fall", "rule": "x"}], r"\$\.events\[0\]\.body: no body is named 'D'"),
        ([], "cut", r"not JSON: Input data was truncated"),
    ],
)
def test_a_bad_line_of_a_trace_is_refused_when_it_is_reached(tmp_path, path, value, expected):
    header, first, second, *_ = trace_of(written(tmp_path / "scenario.json", SCENARIO))
    last = json.dumps(changed(second, *path, to=value) if path else second)
    content = lines(header, first) + last[: -9 if not path else None].encode()
    done = graphbody("itf", written(tmp_path / "trace.jsonl", content))
    assert done.returncode == 2
    assert re.fullmatch(rf"graphbody: {tmp_path}/trace.jsonl:3: {expected}.*\n", done.stderr)


def test_a_directory_and_a_trace_are_no_scenario(tmp_path):
    assert "Is a directory" in refusal(tmp_path, "simulate", tmp_path)
    assert "Is a directory" in refusal(tmp_path, "itf", tmp_path)
    trace = written(tmp_path / "trace.jsonl", lines(*GOOD["trace"][0]))
    assert re.search(
        r"trace.jsonl: \$\.format: expected a level or a scenario; a trace is for validate",
        refusal(tmp_path, "simulate", trace),
    )
