"""Traces as ITF, the JSON trace format of Apalache and Quint, state by state.

ITF has whole numbers, but no fractions: each number of a trace is a record of its numerator and its denominator.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from reference.formats.level import BodyRecord, Position
from reference.formats.trace import EventRecord, HeaderRecord, LineRecord, PlaceRecord
from reference.recording import Recording, place_record
from reference.world import World

ADR = "https://apalache-mc.org/docs/adr/015adr-trace.html"
RATIONAL = "a record of two whole numbers, num and den, that stands for num/den"
# How Apalache writes the value of a variant that has none.
UNIT = "U_OF_UNIT"
WHERE = (
    "bodies.left.location",
    "bodies.right.location",
    "action.value.distance",
    "action.value.time",
    "action.value.speeds",
    "events.time",
    "events.velocities",
    "velocities",
)


def text(trace: Recording) -> Iterator[str]:
    """The JSON text of a trace in ITF, piece by piece; there is never more of it in memory than one state.

    Raises:
        FormatError: when a line of the trace is reached that is not as it must be.
    """
    buttons = bool(trace.level.buttons)
    names = ["step", "action", "bodies", "fired", "events", *(["pressed", "solved"] if buttons else [])]
    names += ["velocities"] if any(body.motion is not None for body in trace.level.bodies) else []
    yield f'{{"#meta": {json.dumps(meta_of(trace.header))},\n"vars": {json.dumps(names)},\n"states": [\n'
    yield json.dumps(start_of(trace))
    for number, line in enumerate(trace.lines, start=1):
        yield ",\n" + json.dumps(state_of(line, number, buttons))
    yield "\n]}\n"


def meta_of(header: HeaderRecord) -> dict[str, Any]:
    """What a reader is told of a trace."""
    return {
        "format": "ITF",
        "format-description": ADR,
        "source": header.name,
        "description": header.note,
        "profile": header.profile,
        "numbers": header.numbers,
        "rational": {"encoding": RATIONAL, "where": list(WHERE)},
    }


def start_of(trace: Recording) -> dict[str, Any]:
    """The state before the first step."""
    world = World(trace.level)
    pressed = [world.pressed(button) for button in trace.level.buttons]
    places = [place_record(body, trace.level) for body in trace.level.bodies]
    line = LineRecord(bodies=places, moves=[], events=[], pressed=pressed, solved=all(pressed))
    return state_of(line, 0, bool(pressed))


def state_of(line: LineRecord, number: int, buttons: bool) -> dict[str, Any]:
    """The state after a step. What the trace leaves out is empty here, or false, and named in `#meta`."""
    fired = [pair for move in line.moves or () for pair in move.fired or ()]
    state: dict[str, Any] = {
        "#meta": {"index": number, "left_out": left_out(line, buttons)},
        "step": whole(number),
        "action": action_of(line),
        "bodies": {"#map": [[place.name, borders_of(place)] for place in line.bodies]},
        "fired": [{"body": body, "rule": rule} for body, rule in fired],
        "events": [event_of(one) for one in line.events or ()],
    }
    if buttons:
        state |= {"pressed": line.pressed or [], "solved": line.solved or False}
    rolling = [[place.name, rational(place.velocity)] for place in line.bodies if place.velocity is not None]
    return state | ({"velocities": {"#map": rolling}} if rolling else {})


def event_of(one: EventRecord) -> dict[str, Any]:
    """What happened to a body; where all bodies move at once also when, how they moved up to then, and with whom."""
    event: dict[str, Any] = {"body": one.body, "event": one.event, "rule": one.rule}
    if one.time is None:
        return event
    moving = [[name, rational(speed)] for name, speed in (one.velocities or {}).items()]
    other = {"tag": "Nobody", "value": UNIT} if one.other is None else {"tag": "Body", "value": {"body": one.other}}
    return event | {"time": rational(one.time), "velocities": {"#map": moving}, "other": other}


def left_out(line: LineRecord, buttons: bool) -> list[str]:
    """The variables of which a line of a trace says nothing."""
    fired = [move.fired for move in line.moves] if line.moves is not None else [None]
    said = {"fired": None not in fired, "events": line.events is not None}
    if buttons:
        said |= {"pressed": line.pressed is not None, "solved": line.solved is not None}
    return [name for name, there in said.items() if not there]


def action_of(line: LineRecord) -> dict[str, Any]:
    """What was asked in a step, as a variant; at the start nothing was."""
    if line.request is not None:
        asked = {"body": line.request.body, "distance": rational(line.request.distance)}
        return {"tag": "Request", "value": asked}
    if line.tick is not None:
        return {"tag": "Tick", "value": {"key": line.tick.key, "times": whole(line.tick.times)}}
    if line.drive is not None:
        speeds = [[name, rational(speed)] for name, speed in line.drive.speeds.items()]
        return {"tag": "Drive", "value": {"speeds": {"#map": speeds}, "time": rational(line.drive.time)}}
    if line.add is not None:
        return {"tag": "Add", "value": added(line.add)}
    if line.remove is not None:
        return {"tag": "Remove", "value": {"body": line.remove.body}}
    return {"tag": "Start", "value": UNIT}


def added(body: BodyRecord) -> dict[str, Any]:
    """A body that comes."""
    borders = {"left": position(body.left), "right": position(body.right)}
    numbers = {"speed": rational(body.speed), "height": rational(body.height)}
    return {"body": body.name, "pushes": body.pushes, **borders, **numbers}


def borders_of(place: PlaceRecord) -> dict[str, Any]:
    """The borders of a body."""
    return {"left": position(place.left), "right": position(place.right)}


def position(at: Position) -> dict[str, Any]:
    """An edge position: a static edge or the top of a body, and how far along it."""
    if at.edge is not None:
        on = {"tag": "Edge", "value": {"number": whole(at.edge)}}
    else:
        on = {"tag": "Top", "value": {"body": at.top}}
    return {"on": on, "location": rational(at.location)}


def rational(value: str | int | float) -> dict[str, Any]:
    """A number, exactly."""
    fraction = Fraction(value)
    return {"num": whole(fraction.numerator), "den": whole(fraction.denominator)}


def whole(value: int) -> dict[str, str]:
    """A whole number, of any size."""
    return {"#bigint": str(value)}
