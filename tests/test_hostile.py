"""Hostile input: whatever is in a file, it is accepted, or refused in one line that names the place."""

import json
from itertools import islice

import pytest
from hypothesis import HealthCheck, given, seed, settings, strategies as st
from jsonschema import Draft202012Validator
from typer.testing import CliRunner

from properties.cli import app
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
RUNS = settings(max_examples=350, deadline=None, database=None, suppress_health_check=list(HealthCheck))


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
            target[last] = draw(HOSTILE)
    return document


def lines(*documents):
    """The bytes of JSON lines."""
    return b"".join(json.dumps(document).encode() + b"\n" for document in documents)


def trace_of(path, floats=False):
    """The trace of a scenario, as the command line prints it."""
    done = CliRunner().invoke(app, ["simulate", str(path), "--json", *(["--floats"] if floats else [])])
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
            playing = play(path)
            playing.game.most = 500
            list(islice(playing.steps, 2))
    except FormatError as error:
        return str(error)
    except Endless:
        return None
    return None


@pytest.mark.parametrize("kind", [*PLAYED, "trace"])
def test_documents_made_from_the_schemas(tmp_path, kind):
    accepted = []

    @seed(SEED)
    @RUNS
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


@pytest.mark.parametrize("kind", GOOD)
def test_good_documents_with_a_few_places_spoiled(tmp_path, kind):
    accepted = []

    @seed(SEED)
    @RUNS
    @given(st.data())
    def each(data):
        found = list(data.draw(st.sampled_from(GOOD[kind])))
        at = data.draw(st.integers(0, len(found) - 1))
        found[at] = spoiled(data.draw, found[at])
        accepted.append(outcome(tmp_path / f"{kind}.json", lines(*found)))

    each()
    assert 0.02 < sum(accepted) / len(accepted) < 0.9


@pytest.mark.parametrize("kind", GOOD)
def test_good_files_cut_short_or_with_bytes_changed(tmp_path, kind):
    @seed(SEED)
    @RUNS
    @given(st.data())
    def each(data):
        content = bytearray(lines(*data.draw(st.sampled_from(GOOD[kind]))))
        for at in data.draw(st.lists(st.integers(0, len(content) - 1), max_size=3)):
            content[at] = data.draw(st.integers(0, 255))
        outcome(tmp_path / f"{kind}.json", bytes(content[: data.draw(st.integers(0, len(content)))]))

    each()
