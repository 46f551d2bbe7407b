"""The second program beside the reference, which is used as its commands use it: a scenario file in, a trace out."""

import json
from fractions import Fraction
from pathlib import Path
from typing import Any

import msgspec
from independent.model import simulate

from reference.recording import recording

Said = dict[str, Any]
"""What a trace says of a step: moves, bodies, supports, and the events, those of an instant in no order of their own."""


def by_reference(scenario: dict[str, Any], path: Path) -> list[Said]:
    """Return what the reference says of each step; `path` is where the scenario is written for it."""
    path.write_text(json.dumps(scenario), encoding="utf-8")
    return [said_by_line(msgspec.to_builtins(line)) for line in recording(path).lines]


def said_by_line(line: dict[str, Any]) -> Said:
    """Return what the line of a trace says."""
    return {
        "moves": [(move["body"], Fraction(move["asked"]), Fraction(move["moved"])) for move in line["moves"]],
        "bodies": {body["name"]: (position(body["left"]), position(body["right"])) for body in line["bodies"]},
        "supports": line["supports"],
        "events": sorted(
            (Fraction(event["time"]), event["rule"], event["body"], event.get("other", "")) for event in line["events"]
        ),
    }


def position(border: dict[str, Any]) -> tuple[int | str, Fraction]:
    """Return an edge position: the number of an edge or the name of a top, and the location."""
    return border["edge"] if border.get("top") is None else border["top"], Fraction(border["location"])


def by_model(scenario: dict[str, Any]) -> list[Said]:
    """Return what the model says of each step."""
    return [
        {
            "moves": [(move["body"], move["asked"], move["moved"]) for move in outcome.moves],
            "bodies": {body["name"]: (position(body["left"]), position(body["right"])) for body in outcome.bodies},
            "supports": outcome.supports,
            "events": sorted((event.time, event.rule, event.body, event.other or "") for event in outcome.events),
        }
        for outcome in simulate(scenario)
    ]


def difference(scenario: dict[str, Any], path: Path) -> str | None:
    """Return the first thing that the two say otherwise, in one line, or None if they agree."""
    for step, (expected, seen) in enumerate(zip(by_reference(scenario, path), by_model(scenario), strict=True), 1):
        for what, value in expected.items():
            if seen[what] != value:
                return f"step {step}, {what}: the reference says {value}, the model {seen[what]}"
    return None
