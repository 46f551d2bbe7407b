"""The second program beside the reference, which is used as its commands use it: a scenario file in, a trace out."""

import json
from fractions import Fraction
from pathlib import Path
from typing import Any

import msgspec

from independent.model import simulate
from reference.recording import recording

Line = dict[str, Any]
"""A line of a trace."""

Said = dict[str, Any]
"""What a step comes to: moves, bodies, supports, and the events, those of an instant in an order of ours."""


def by_reference(scenario: dict[str, Any], path: Path) -> list[Line]:
    """Return the lines of the reference for a scenario, which is written to `path` for it.

    Raises:
        FormatError: if the reference refuses the scenario.
    """
    path.write_text(json.dumps(scenario), encoding="utf-8")
    return [msgspec.to_builtins(line) for line in recording(path).lines]


def said_by_reference(line: Line, around: Fraction | None) -> Said:
    """Return what a line of the reference says, on a cylinder of a circumference."""
    events = [(Fraction(one["time"]), one["rule"], one["body"], one.get("other", "")) for one in line["events"]]
    return {
        "moves": [(move["body"], Fraction(move["asked"]), Fraction(move["moved"])) for move in line["moves"]],
        "bodies": places(line["bodies"], around),
        "supports": line["supports"],
        "events": sorted(events),
    }


def places(bodies: list[dict[str, Any]], around: Fraction | None) -> dict[str, Any]:
    """Return for each body its left and its right border."""
    return {body["name"]: tuple(position(body[side], around) for side in ("left", "right")) for body in bodies}


def position(border: dict[str, Any], around: Fraction | None) -> tuple[int | str, Fraction]:
    """Return an edge position: the number of an edge or the name of a top, and the location.

    On a cylinder a body can be as far from the corner of a top one way round as the other; either may be said.
    """
    top, location = border.get("top"), Fraction(border["location"])
    if top is None:
        return border["edge"], location
    return top, location if around is None else location % around


def circumference(scenario: dict[str, Any]) -> Fraction | None:
    """Return the circumference of the level of a scenario, None on a line."""
    around = scenario["level"].get("circumference")
    return None if around is None else Fraction(around)


def said_by_model(scenario: dict[str, Any]) -> list[Said]:
    """Return what the model says of each step."""
    around = circumference(scenario)
    return [
        {
            "moves": [(move["body"], move["asked"], move["moved"]) for move in outcome.moves],
            "bodies": places(outcome.bodies, around),
            "supports": outcome.supports,
            "events": sorted((event.time, event.rule, event.body, event.other or "") for event in outcome.events),
        }
        for outcome in simulate(scenario)
    ]


def difference(lines: list[Line], scenario: dict[str, Any]) -> str | None:
    """Return the first thing of which the model says otherwise than the lines, or None if they agree."""
    for step, (line, seen) in enumerate(zip(lines, said_by_model(scenario), strict=True), 1):
        for what, value in said_by_reference(line, circumference(scenario)).items():
            if seen[what] != value:
                return f"step {step}, {what}: expected {plain(value)}, got {plain(seen[what])}"
    return None


def plain(value: Any) -> str:
    """Return a value with its fractions as a file has them."""
    match value:
        case dict():
            return "{" + ", ".join(f"{key}: {plain(one)}" for key, one in value.items()) + "}"
        case tuple() | list():
            return "[" + ", ".join(map(plain, value)) + "]"
        case _:
            return str(value)
