"""Played steps as text and as JSON lines."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any

from reference.formats import number_text
from reference.play import Played
from spec.body import Body, EdgePosition


def position(at: EdgePosition[Any]) -> str:
    """An edge position as text: edge number and location."""
    return f"{at.edge}:{at.location}"


def text_lines(step: Played[Any] | None, bodies: tuple[Body[Any], ...]) -> Iterator[str]:
    """What was asked and moved, the rules that fired for each body, and where all bodies are."""
    for event in step.events if step is not None else []:
        yield f"\n{event.body} asked {event.distance}, moved {event.moved}; chain of {event.depth}"
        fired: dict[str, list[str]] = {}
        for body, rule in event.fired:
            fired.setdefault(body, []).append(rule)
        for body, rules in fired.items():
            yield f"  {body}: {' '.join(rules)}"
    yield "  at " + "  ".join(f"{body.name} {position(body.left)}..{position(body.right)}" for body in bodies)


def json_line(step: Played[Any]) -> str:
    """A step as one line of JSON: its requests, the rules that fired, and all bodies after it."""
    return json.dumps(
        {
            "requests": [
                {
                    "body": event.body,
                    "distance": number_text(event.distance),
                    "moved": number_text(event.moved),
                    "depth": event.depth,
                    "fired": [{"body": body, "rule": rule} for body, rule in event.fired],
                }
                for event in step.events
            ],
            "bodies": [
                {"name": body.name, "left": border(body.left), "right": border(body.right)} for body in step.bodies
            ],
        }
    )


def border(at: EdgePosition[Any]) -> dict[str, Any]:
    """An edge position as it stands in a file."""
    return {"edge": at.edge, "location": number_text(at.location)}
