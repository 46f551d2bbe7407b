"""The quick look at logs of steps: it changes no account, whatever is wrong with a log, and settles many lines."""

import json
from collections import Counter
from dataclasses import replace
from random import Random

import msgspec
import numpy as np
import pytest
from benchmarks.logs import boxes_and_ticks, traces_of

from properties.comparison.levels import any_level
from properties.conformance import quick, validate as validation
from properties.conformance.account import json_line
from properties.conformance.validate import validate
from reference.formats.files import FormatError
from reference.formats.level import level_record
from reference.formats.scenario import DriveRecord, RequestRecord, ScenarioRecord, StepRecord, TickRecord
from reference.play import library

SLIPS = (1e-17, 1e-16, 3e-16, 1e-15, 2e-15, 4e-15, 8e-15, 2e-14, 1e-12, 1e-6, 0.1, 1.0)
OF_REPAIRED = [path for path in library() if json.loads(path.read_bytes()).get("profile") == "repaired"]


def account(path):
    """What a validation says of a file."""
    try:
        return json_line(validate(path), None)
    except FormatError as error:
        return str(error)


@pytest.fixture
def both(monkeypatch, tmp_path):
    """What validations with and without the look say of a log; what the look settles is counted."""
    counts, path = Counter(), tmp_path / "trace.jsonl"

    def counted(log, referee):
        look = quick.look_of(log, referee)
        if look is not None:
            certain = look.certain

            def counting(*args):
                found = certain(*args)
                counts.update(lines=len(found) - 1, certain=int(found.sum()))
                return found

            look.certain = counting
        return look

    def accounts(lines, at_once=1024):
        path.write_bytes(b"\n".join(lines) + b"\n")
        monkeypatch.setattr(validation, "AT_ONCE", at_once)
        found = []
        for look in (counted, lambda log, referee: None):
            monkeypatch.setattr(validation, "look_of", look)
            found.append(account(path))
        return found

    accounts.counts = counts
    return accounts


def slip(random, line):
    """Put a body a little, or not so little, elsewhere; mostly both its borders."""
    body, by = random.choice(line["bodies"]), random.choice(SLIPS) * random.choice((1, -1))
    for side in ("left", "right") if random.random() < 0.7 else (random.choice(("left", "right")),):
        body[side]["location"] += by


def other_edge(random, line):
    """Put a border on another edge, or nowhere."""
    at = random.choice(line["bodies"])[random.choice(("left", "right"))]
    at.pop("top", None)
    at["edge"] = random.choice((0, 1, 2, 3, -1, None))


def told_otherwise(random, line):
    """Say something else of moves, supports, events or the goal."""
    name = random.choice(line["bodies"])["name"]
    moves = [{"body": name, "asked": 0.5, "moved": 0.5 + random.choice(SLIPS)}]
    events = [{"body": random.choice((name, "Nobody")), "event": "wall", "rule": "event/wall"}]
    said = {"moves": moves, "events": events, "supports": {name: name}, "solved": False, "pressed": [], "step": 1}
    key = random.choice(list(said))
    line[key] = said[key]


def out_of_shape(random, line):
    """Break what the format promises, or use what the look does not know."""
    body = random.choice(line["bodies"])
    random.choice(
        (
            line["bodies"].reverse,
            lambda: line["bodies"].remove(body),
            lambda: body.update(name="Nobody"),
            lambda: body.update(more=1),
            lambda: body.update(velocity=0.0),
            lambda: body["left"].update(location=str(body["left"]["location"])),
            lambda: body["left"].update(location=1e-300),
            lambda: body["left"].update(location=1e300),
            lambda: line.update(request={"body": body["name"], "distance": random.choice((0.25, "1/4", "x", 1e300))}),
            lambda: line.update(tick={"key": "left", "times": random.choice((1, 2))}),
            lambda: line.update(add={"name": "New", "left": body["left"], "right": body["right"]}),
            lambda: line.update(remove={"body": body["name"]}),
        )
    )()


FAULTS = (slip, slip, slip, slip, other_edge, told_otherwise, out_of_shape)


def faulty(random, lines):
    """The lines of a log, with a fault in one, or with one that is empty, or there twice."""
    place = random.randrange(1, len(lines))
    if random.random() < 0.05:
        return [*lines[:place], random.choice((b"", b"{", lines[place])), *lines[place:]]
    line = json.loads(lines[place])
    random.choice(FAULTS)(random, line)
    return [*lines[:place], json.dumps(line).encode(), *lines[place + 1 :]]


@pytest.mark.parametrize("path", OF_REPAIRED, ids=lambda path: path.stem)
def test_the_look_changes_no_account_of_a_trace_of_the_library(path, both):
    for log in traces_of(path):
        with_look, without = both(log, 2)
        assert with_look == without


@pytest.mark.slow
@pytest.mark.parametrize("path", OF_REPAIRED, ids=lambda path: path.stem)
def test_the_look_changes_no_account_of_a_faulty_trace_of_the_library(path, both):
    random = Random(path.stem)
    for lines in traces_of(path):
        for _ in range(3):
            with_look, without = both(faulty(random, lines), random.choice((1, 2, 1024)))
            assert with_look == without


def game(random, tmp_path):
    """A random level of storeys, at some scale, with requests, ticks and drives of all sizes, as a scenario."""
    level, steps = any_level(random), []
    level = replace(level, bodies=tuple(replace(body, pushes=random.random() < 0.95) for body in level.bodies))
    names = [body.name for body in level.bodies]
    for _ in range(random.randint(4, 12)):
        far, body = random.choice((0.1, 1 / 3, 0.5, 1.0, 2.7)) * random.choice((1, -1)), random.choice(names)
        request, tick = RequestRecord(body, far), TickRecord(random.choice(("left", "right")))
        drive = DriveRecord({body: far, random.choice(names): far}, random.choice((0.1, 1.0)))
        kind = random.random()
        steps.append(
            StepRecord(request) if kind < 0.5 else StepRecord(tick=tick) if kind < 0.8 else StepRecord(drive=drive)
        )
    path = tmp_path / "scenario.json"
    scenario = ScenarioRecord("graphbody/scenario@1", "game", level_record(level, "game"), steps, "repaired")
    path.write_bytes(msgspec.json.encode(scenario))
    return path


@pytest.mark.parametrize("games", [12, pytest.param(150, marks=pytest.mark.slow)])
def test_the_look_changes_no_account_of_a_random_game(games, both, tmp_path):
    for number in range(games):
        random = Random(number)
        lines = random.choice(traces_of(game(random, tmp_path)))
        for log in (lines, faulty(random, lines), faulty(random, lines)):
            with_look, without = both(log, random.choice((1, 3, 1024)))
            assert with_look == without, number
    assert both.counts["certain"] > 0.2 * both.counts["lines"]


def test_where_the_margin_is_broken_for_good_lines_are_looked_at_again_once_that_is_said(both, tmp_path):
    lines = traces_of(boxes_and_ticks(tmp_path, 1))[1][:120]
    for place in range(90, len(lines)):
        line = json.loads(lines[place])
        for side in ("left", "right"):
            line["bodies"][0][side]["location"] += 1e-6
        lines[place] = json.dumps(line).encode()
    with_look, without = both(lines)
    assert with_look == without
    assert json.loads(with_look)["broken"] == {"invariant/no-overlap": 91, "invariant/plane-margin": 91}
    assert both.counts["certain"] > 0.9 * len(lines)


WRONG = {
    "tolerance": lambda *args, right=quick.tolerance: 100 * right(*args),
    "furthest": lambda layout, left, drives, times, slack: (left * 0, np.ones(len(times), bool)),
}


@pytest.mark.parametrize("name", WRONG)
def test_a_wrong_look_changes_accounts(name, both, monkeypatch, tmp_path):
    lines = traces_of(boxes_and_ticks(tmp_path, 1))[1][:40]
    line = json.loads(lines[20])
    for side in ("left", "right"):
        line["bodies"][0][side]["location"] += 1e-12
    off, stands = json.dumps(line).encode(), lines[19]
    log = [*lines[:20], off if name == "tolerance" else stands, *lines[21:]]
    with_look, without = both(log)
    assert with_look == without
    monkeypatch.setattr(quick, name, WRONG[name])
    with_look, without = both(log)
    assert with_look != without
