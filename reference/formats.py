"""Level and scenario files: JSON with a `format` field, exact numbers as strings, errors that name the place.

Exact numbers travel as strings (`"3/2"`, `"-0.25"`); JSON numbers are accepted at their exact binary value.
"""

from __future__ import annotations

import re
from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from typing import Literal, TypeVar

import msgspec

from reference.row import LevelError
from spec.body import Body, EdgePosition, Level
from spec.graph import Edge, Graph, IrrationalLength, Vertex, polyline

MOST_DIGITS = 100
MOST_BODIES = 100_000
NUMBER = re.compile(r"[+-]?[0-9]+(/[0-9]+|\.[0-9]+)?")
PLACE = re.compile(r"(?P<problem>.*) - at `(?P<place>\$.*)`", re.DOTALL)

Number = str | int | float
T = TypeVar("T")


class FormatError(ValueError):
    """A file that cannot be read; the message is one line that names the place and what is expected."""


class Record(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """What every object in a file is: its fields and no others."""


class Position(Record, frozen=True):
    """An edge position: an edge's number in the order of the vertices, and a location from its left end."""

    edge: int
    location: Number


class BodyRecord(Record, frozen=True):
    """A body: its name, its two borders, and its speed (distance per second; 0 for a box)."""

    name: str
    left: Position
    right: Position
    speed: Number = "0"


class LevelRecord(Record, frozen=True):
    """A level: a list of vertices from left to right, round a cylinder if it has a circumference."""

    format: Literal["graphbody/level@1"]
    name: str
    vertices: list[tuple[Number, Number]]
    bodies: list[BodyRecord]
    margin: Number = "1/100"
    tick: Number = "1/50"
    circumference: Number | None = None
    note: str = ""


class RequestRecord(Record, frozen=True):
    """A request: a body is to move by a distance, negative to the left."""

    body: str
    distance: Number


class TickRecord(Record, frozen=True):
    """Ticks with one key held."""

    key: Literal["left", "right"]
    times: int = 1


class StepRecord(Record, frozen=True):
    """One step of a scenario: either a request or ticks."""

    request: RequestRecord | None = None
    tick: TickRecord | None = None


class ScenarioRecord(Record, frozen=True):
    """A scenario: a level, in the file or beside it, a profile, and steps."""

    format: Literal["graphbody/scenario@1"]
    name: str
    level: str | LevelRecord
    steps: list[StepRecord]
    profile: str = "thesis"
    note: str = ""


def read(path: Path, kind: type[T]) -> T:
    """Decode a file.

    Raises:
        FormatError: with the file, the place in it and what is expected there.
    """
    try:
        return msgspec.json.decode(path.read_bytes(), type=kind)
    except OSError as error:
        raise FormatError(f"{path}: {error.strerror}") from None
    except msgspec.ValidationError as error:
        found = PLACE.fullmatch(str(error))
        place, problem = (found["place"], found["problem"]) if found else ("$", str(error))
        raise FormatError(f"{path}: {place}: {problem}") from None
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError) as error:
        raise FormatError(f"{path}: not JSON: {error}") from None


def exact(value: Number, place: str) -> Fraction:
    """The exact value of a number in a file.

    Raises:
        LevelError: if it is no number, or has too many digits.
    """
    if isinstance(value, str):
        if len(value) > MOST_DIGITS:
            raise LevelError(place, f"expected at most {MOST_DIGITS} characters, got {len(value)}")
        if not NUMBER.fullmatch(value):
            raise LevelError(place, f'expected a number such as 2, "3/2" or "0.25", got {value!r}')
    try:
        return Fraction(value)
    except (ValueError, OverflowError, ZeroDivisionError):
        raise LevelError(place, f"expected a finite number, got {value!r}") from None


def number_text(value: Fraction | float) -> Number:
    """A number as it stands in a file: exact ones as strings, floats as JSON numbers."""
    return str(value) if isinstance(value, Fraction) else value


def position_of(record: Position, place: str) -> EdgePosition[Fraction]:
    """An edge position with exact numbers."""
    return EdgePosition(record.edge, exact(record.location, f"{place}.location"))


def level_of(record: LevelRecord, place: str = "$") -> Level[Fraction]:
    """The level of a record; whether a world can hold it is for the world to say.

    Raises:
        LevelError: if a number, a name or an edge is not as it must be.
    """
    if len(record.bodies) > MOST_BODIES:
        raise LevelError(f"{place}.bodies", f"expected at most {MOST_BODIES} bodies, got {len(record.bodies)}")
    vertices = [
        Vertex(exact(x, f"{place}.vertices[{i}][0]"), exact(y, f"{place}.vertices[{i}][1]"))
        for i, (x, y) in enumerate(record.vertices)
    ]
    round_ = record.circumference
    circumference = None if round_ is None else exact(round_, f"{place}.circumference")
    if len(vertices) < (2 if circumference is None else 1):
        raise LevelError(f"{place}.vertices", "expected two vertices or more (one on a cylinder)")
    check_left_to_right(vertices, circumference, place)
    try:
        graph = polyline(vertices, circumference)
    except IrrationalLength as error:
        raise LevelError(f"{place}.vertices[{error.edge}]", str(error)) from None
    bodies = tuple(body_of(body, f"{place}.bodies[{i}]") for i, body in enumerate(record.bodies))
    names = [body.name for body in bodies]
    for i, name in enumerate(names):
        if name in names[:i]:
            raise LevelError(f"{place}.bodies[{i}].name", f"expected a name of its own, got {name!r} again")
    margin, tick = exact(record.margin, f"{place}.margin"), exact(record.tick, f"{place}.tick")
    return Level(graph, margin, tick, bodies)


def check_left_to_right(vertices: list[Vertex[Fraction]], circumference: Fraction | None, place: str) -> None:
    """Refuse vertices that do not go from left to right, once round at most (A58)."""
    for i, (left, right) in enumerate(pairwise(vertices)):
        if right.x < left.x:
            raise LevelError(f"{place}.vertices[{i + 1}]", f"expected x of {left.x} or more, got {right.x}")
    if circumference is not None and vertices[-1].x - vertices[0].x >= circumference:
        raise LevelError(f"{place}.circumference", "expected more than the distance of the first and last vertex")


def body_of(record: BodyRecord, place: str) -> Body[Fraction]:
    """A body with exact numbers."""
    if not record.name:
        raise LevelError(f"{place}.name", "expected a name, got an empty one")
    speed = exact(record.speed, f"{place}.speed")
    if speed < 0:
        raise LevelError(f"{place}.speed", f"expected 0 or more, got {speed}")
    left, right = position_of(record.left, f"{place}.left"), position_of(record.right, f"{place}.right")
    return Body(record.name, left, right, speed)


def level_record(level: Level[Fraction], name: str, note: str = "") -> LevelRecord:
    """The record of a level that was made from a list of vertices."""
    text = number_text

    def position(at: EdgePosition[Fraction]) -> Position:
        return Position(at.edge, text(at.location))

    return LevelRecord(
        format="graphbody/level@1",
        name=name,
        note=note,
        vertices=[(text(v.x), text(v.y)) for v in level.graph.vertices],
        circumference=None if level.graph.circumference is None else text(level.graph.circumference),
        margin=text(level.margin),
        tick=text(level.tick),
        bodies=[BodyRecord(b.name, position(b.left), position(b.right), text(b.speed)) for b in level.bodies],
    )


def read_scenario(path: Path) -> tuple[ScenarioRecord, LevelRecord]:
    """A scenario and its level, which is in the file or in one beside it.

    Raises:
        FormatError: if either cannot be read.
    """
    scenario = read(path, ScenarioRecord)
    for i, step in enumerate(scenario.steps):
        if (step.request is None) == (step.tick is None):
            raise FormatError(f"{path}: $.steps[{i}]: expected either `request` or `tick`")
        if step.tick is not None and not 1 <= step.tick.times <= MOST_BODIES:
            raise FormatError(f"{path}: $.steps[{i}].tick.times: expected 1 to {MOST_BODIES}")
    if isinstance(scenario.level, LevelRecord):
        return scenario, scenario.level
    return scenario, read(path.parent / scenario.level, LevelRecord)


def write(path: Path, record: msgspec.Struct) -> None:
    """Write a record as readable JSON, fields that hold their default left out."""
    path.parent.mkdir(parents=True, exist_ok=True)
    fields = msgspec.to_builtins(record)
    defaults = {field.name: field.default for field in msgspec.structs.fields(record)}
    kept = {name: value for name, value in fields.items() if value != defaults.get(name, msgspec.NODEFAULT)}
    path.write_bytes(msgspec.json.format(msgspec.json.encode(kept), indent=2) + b"\n")


def in_floats(level: Level[Fraction]) -> Level[float]:
    """The level in binary floating point, as a game would hold it."""
    round_ = level.graph.circumference
    vertices = tuple(Vertex(float(v.x), float(v.y)) for v in level.graph.vertices)
    edges = tuple(Edge(e.left, e.right, e.type, float(e.length)) for e in level.graph.edges)

    def position(at: EdgePosition[Fraction]) -> EdgePosition[float]:
        return EdgePosition(at.edge, float(at.location))

    return Level(
        Graph(vertices, edges, None if round_ is None else float(round_)),
        float(level.margin),
        float(level.tick),
        tuple(Body(b.name, position(b.left), position(b.right), float(b.speed)) for b in level.bodies),
    )
