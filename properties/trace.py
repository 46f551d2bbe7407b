"""Played steps as text and as JSON lines."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any

import msgspec

from reference.formats import number_text, position_record
from reference.play import Played
from reference.simulator import Game
from spec.body import EdgePosition


def position(at: EdgePosition[Any], game: Game[Any]) -> str:
    """An edge position as text: the edge's number, or whose top it is, and the location."""
    statics = game.world.statics
    edge = str(at.edge) if at.edge < statics else f"top of {game.world.bodies[at.edge - statics].name}"
    return f"{edge}:{at.location}"


def text_lines(step: Played[Any] | None, game: Game[Any]) -> Iterator[str]:
    """What was asked and moved, the rules that fired, where all bodies are, and whether the goal is reached."""
    for event in step.events if step is not None else []:
        yield f"\n{event.body} asked {event.distance}, moved {event.moved}; chain of {event.depth}"
        fired: dict[str, list[str]] = {}
        for body, rule in event.fired:
            fired.setdefault(body, []).append(rule)
        for body, rules in fired.items():
            yield f"  {body}: {' '.join(rules)}"
    for held in sorted(game.world.bodies, key=lambda held: game.world.point(held.left)):
        x, y = game.world.point(held.left)
        yield f"  {held.name} from {position(held.left, game)} to {position(held.right, game)}, at ({x}, {y})"
    if game.level.buttons:
        yield f"  goal: {'reached' if game.world.solved() else 'not reached'}"


def json_line(step: Played[Any], game: Game[Any]) -> str:
    """A step as one line of JSON: its requests, the rules that fired, and all bodies after it."""
    requests = [
        {
            "body": event.body,
            "distance": number_text(event.distance),
            "moved": number_text(event.moved),
            "depth": event.depth,
            "work": event.work,
            "fired": [{"body": body, "rule": rule} for body, rule in event.fired],
        }
        for event in step.events
    ]
    bodies = [
        {"name": held.name, "left": border(held.left, game), "right": border(held.right, game)} for held in step.bodies
    ]
    line: dict[str, Any] = {"requests": requests, "bodies": bodies}
    if game.level.buttons:
        line["solved"] = game.world.solved()
    return json.dumps(line)


def border(at: EdgePosition[Any], game: Game[Any]) -> Any:
    """An edge position as it stands in a file."""
    return msgspec.to_builtins(position_record(at, game.level))
