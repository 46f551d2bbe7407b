"""Events of steps in which all bodies move at once: what a trace tells of each, and what is made of it."""

import json
from fractions import Fraction
from xml.etree.ElementTree import fromstring

import pytest

from reference.draw import pages
from reference.itf import text
from reference.play import library
from reference.recording import recording
from spec.profiles import REPAIRED
from spec.registry import rules_of

EVENTS = {rule.id: rule.event for rule in rules_of(REPAIRED) if rule.event is not None}
STEPPED = [path for path in library() if recording(path).header.profile == REPAIRED.name]
BETWEEN_TWO = {"event/contact", "settle/jump"}


def lasted(line, level):
    """How long a step lasts."""
    if line.request is not None:
        return abs(Fraction(line.request.distance))
    if line.drive is not None:
        return Fraction(line.drive.time)
    return level.tick if line.tick is not None else Fraction(0)


def lines(path):
    """The lines of a scenario, and the level that it starts from."""
    record = recording(path)
    return [(line, record.level) for line in record.lines]


@pytest.mark.parametrize("path", STEPPED, ids=lambda path: path.stem)
def test_each_event_has_its_time_its_velocities_and_its_rule(path):
    for line, level in lines(path):
        names, gone = {place.name for place in line.bodies}, line.asked.comings[1]
        times = [Fraction(event.time) for event in line.events]
        assert times == sorted(times)
        assert all(0 <= time <= lasted(line, level) for time in times)
        for event in line.events:
            assert event.event == EVENTS[event.rule]
            assert {event.body, *event.velocities} <= names
            assert all(Fraction(speed) for speed in event.velocities.values())
            assert event.other is None or event.other in names - {event.body, gone}
            assert event.other is not None or event.rule not in BETWEEN_TWO
            assert event.body in event.velocities or event.rule != "event/wall"


@pytest.mark.parametrize("path", STEPPED, ids=lambda path: path.stem)
def test_what_fired_as_an_event_is_told_as_one(path):
    for line, _ in lines(path):
        fired = {(body, rule) for move in line.moves for body, rule in move.fired if rule in EVENTS}
        assert fired == {(event.body, event.rule) for event in line.events} or not line.moves


@pytest.mark.parametrize("path", STEPPED, ids=lambda path: path.stem)
def test_such_traces_are_drawn_and_written_as_itf(path):
    states = json.loads("".join(text(recording(path))))["states"]
    told = [event for state in states for event in state["events"]]
    assert all(set(event) == {"body", "event", "rule", "time", "velocities", "other"} for event in told)
    assert len(told) == sum(len(line.events) for line, _ in lines(path))
    drawn = list(pages(recording(path), 6))
    assert drawn
    for page in drawn:
        assert fromstring(page).tag.endswith("svg")


def test_a_tick_without_characters_still_tells_who_falls(tmp_path):
    body = {"name": "Box", "left": {"edge": 0, "location": "4"}, "right": {"edge": 0, "location": "5"}}
    level = {"format": "graphbody/level@1", "name": "l", "vertices": [[0, 1], [4, 1], [4, 0], [9, 0]], "bodies": [body]}
    scenario = {"format": "graphbody/scenario@1", "name": "s", "level": level, "profile": "repaired"}
    path = tmp_path / "scenario.json"
    path.write_text(json.dumps({**scenario, "steps": [{"tick": {"key": "left"}}]}))
    (line,) = recording(path).lines
    assert [event.rule for event in line.events] == ["settle/fall", "settle/ground"]
    assert [(move.body, move.asked, move.moved) for move in line.moves] == []
