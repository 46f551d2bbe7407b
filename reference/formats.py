"""Level and scenario files: JSON with a `format` field, exact numbers as strings, errors that name the place.

Exact numbers travel as strings (`"3/2"`, `"-0.25"`); JSON numbers are accepted at their exact binary value.
"""

from __future__ import annotations

import re
from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from typing import Any, Literal, TypeVar

import msgspec

from reference.world import LevelError
from spec.body import Body, EdgePosition, Level
from spec.graph import Edge, EdgeType, ExplicitEdge, Graph, IrrationalLength, NoLength, Vertex, explicit, polyline

MOST_DIGITS = 100
MOST_BODIES = 100_000
NUMBER = re.compile(r"[+-]?[0-9]+(/[0-9]+|\.[0-9]+)?")
PLACE = re.compile(r"(?P<problem>.*) - at `(?P<place>\$.*)`", re.DOTALL)

Number = str | int | float
T = TypeVar("T")


class FormatError(ValueError):
    """A file that cannot be read; the message is one line that names the place and what is expected."""


class Record(msgspec.Struct, forbid_unknown_fields=True, omit_defaults=True, frozen=True):
    """What every object in a file is: its fields and no others."""


class Position(Record, frozen=True):
    """An edge position: a static edge by its number or the top of a body by its name, and a location from its left."""

    location: Number
    edge: int | None = None
    top: str | None = None


class BodyRecord(Record, frozen=True):
    """A body: name, borders, speed (distance per second; 0 for a box), height, and whether it may push others."""

    name: str
    left: Position
    right: Position
    speed: Number = "0"
    height: Number = "1"
    pushes: bool = True


class EdgeRecord(Record, frozen=True):
    """An edge of an explicit graph, from its left to its right vertex; without a type, its steepness decides it.

    Under a ground edge all is solid, or down to `thickness` only.
    """

    left: int
    right: int
    type: Literal["ground", "fall"] | None = None
    thickness: Number | None = None


class LevelRecord(Record, frozen=True):
    """A level: vertices, joined from left to right, or as `edges` says; round a cylinder if it has a circumference.

    Its goal is that a character stands on each of its buttons.
    """

    format: Literal["graphbody/level@1"]
    name: str
    vertices: list[tuple[Number, Number]]
    bodies: list[BodyRecord]
    margin: Number = "1/100"
    tick: Number = "1/50"
    circumference: Number | None = None
    edges: list[EdgeRecord] | None = None
    buttons: list[Position] = []
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
    """A scenario: a level, in the file or beside it, a profile and steps; `solved`: whether they reach its goal."""

    format: Literal["graphbody/scenario@1"]
    name: str
    level: str | LevelRecord
    steps: list[StepRecord]
    profile: str = "thesis"
    solved: bool | None = None
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
        raise FormatError(one_line(f"{path}: {place}: {problem}")) from None
    except (msgspec.DecodeError, RecursionError) as error:
        raise FormatError(one_line(f"{path}: not JSON: {error}")) from None
    except ValueError as error:
        raise FormatError(one_line(f"{str(path)!r}: {error}")) from None


def one_line(text: str) -> str:
    """A text with whatever would break its line escaped."""
    return "".join(char if char.isprintable() else repr(char)[1:-1] for char in text)


def exact(value: Number, place: str) -> Fraction:
    """The exact value of a number in a file.

    Raises:
        LevelError: if it is no number, or has too many digits.
    """
    if isinstance(value, int) and abs(value) >= 10**MOST_DIGITS:
        raise LevelError(place, f"expected at most {MOST_DIGITS} digits")
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


def position_of(record: Position, tops: dict[str, int], place: str) -> EdgePosition[Fraction]:
    """An edge position with exact numbers; `tops` are the edges of the tops of bodies, by name."""
    if (record.edge is None) == (record.top is None):
        raise LevelError(place, "expected either `edge` or `top`")
    if record.top is not None and record.top not in tops:
        raise LevelError(f"{place}.top", f"no body is named {record.top!r}")
    if record.edge is not None and not 0 <= record.edge < (statics := min(tops.values(), default=0)):
        raise LevelError(f"{place}.edge", f"expected 0 to {statics - 1}, got {record.edge}")
    edge = tops[record.top] if record.top is not None else record.edge
    assert edge is not None
    return EdgePosition(edge, exact(record.location, f"{place}.location"))


def level_of(record: LevelRecord, place: str = "$") -> Level[Fraction]:
    """The level of a record; whether a world can hold it is for the world to say.

    Raises:
        LevelError: if a number, a name or an edge is not as it must be.
    """
    if len(record.bodies) > MOST_BODIES:
        raise LevelError(f"{place}.bodies", f"expected at most {MOST_BODIES} bodies, got {len(record.bodies)}")
    graph = graph_of(record, place)
    tops = tops_of(record, len(graph.edges), place)
    bodies = tuple(body_of(body, tops, f"{place}.bodies[{i}]") for i, body in enumerate(record.bodies))
    buttons = tuple(position_of(at, tops, f"{place}.buttons[{i}]") for i, at in enumerate(record.buttons))
    margin, tick = exact(record.margin, f"{place}.margin"), exact(record.tick, f"{place}.tick")
    return Level(graph, margin, tick, bodies, buttons)


def tops_of(record: LevelRecord, statics: int, place: str) -> dict[str, int]:
    """The edges of the tops of bodies, by the bodies' names."""
    tops: dict[str, int] = {}
    for i, body in enumerate(record.bodies):
        if not body.name:
            raise LevelError(f"{place}.bodies[{i}].name", "expected a name, got an empty one")
        if body.name in tops:
            raise LevelError(f"{place}.bodies[{i}].name", f"expected a name of its own, got {body.name!r} again")
        tops[body.name] = statics + i
    return tops


def graph_of(record: LevelRecord, place: str) -> Graph[Fraction]:
    """The graph of a level, joined from left to right or as its edges say (6.1.3; R30)."""
    vertices = [
        Vertex(exact(x, f"{place}.vertices[{i}][0]"), exact(y, f"{place}.vertices[{i}][1]"))
        for i, (x, y) in enumerate(record.vertices)
    ]
    round_ = record.circumference
    circumference = None if round_ is None else exact(round_, f"{place}.circumference")
    if len(vertices) < (2 if circumference is None else 1):
        raise LevelError(f"{place}.vertices", "expected two vertices or more (one on a cylinder)")
    try:
        if record.edges is not None:
            return explicit(
                [explicit_edge(edge, i, len(vertices), place) for i, edge in enumerate(record.edges)],
                vertices,
                circumference,
            )
        check_left_to_right(vertices, circumference, place)
        return polyline(vertices, circumference)
    except (IrrationalLength, NoLength) as error:
        where = "vertices" if record.edges is None else "edges"
        raise LevelError(f"{place}.{where}[{error.edge}]", str(error)) from None


def explicit_edge(record: EdgeRecord, index: int, vertices: int, place: str) -> ExplicitEdge:
    """An edge of an explicit graph with exact numbers."""
    for side, vertex in (("left", record.left), ("right", record.right)):
        if not 0 <= vertex < vertices:
            raise LevelError(f"{place}.edges[{index}].{side}", f"expected 0 to {vertices - 1}, got {vertex}")
    thickness = None if record.thickness is None else exact(record.thickness, f"{place}.edges[{index}].thickness")
    return ExplicitEdge(record.left, record.right, None if record.type is None else EdgeType(record.type), thickness)


def check_left_to_right(vertices: list[Vertex[Fraction]], circumference: Fraction | None, place: str) -> None:
    """Refuse vertices that do not go from left to right, once round at most (A58)."""
    for i, (left, right) in enumerate(pairwise(vertices)):
        if right.x < left.x:
            raise LevelError(f"{place}.vertices[{i + 1}]", f"expected x of {left.x} or more, got {right.x}")
    if circumference is not None and vertices[-1].x - vertices[0].x >= circumference:
        raise LevelError(f"{place}.circumference", "expected more than the distance of the first and last vertex")


def body_of(record: BodyRecord, tops: dict[str, int], place: str) -> Body[Fraction]:
    """A body with exact numbers."""
    speed, height = exact(record.speed, f"{place}.speed"), exact(record.height, f"{place}.height")
    if speed < 0:
        raise LevelError(f"{place}.speed", f"expected 0 or more, got {speed}")
    left, right = position_of(record.left, tops, f"{place}.left"), position_of(record.right, tops, f"{place}.right")
    return Body(record.name, left, right, speed, height, record.pushes)


def level_record(level: Level[Fraction], name: str, note: str = "") -> LevelRecord:
    """The record of a level, its edges written out unless they are those of a list of vertices."""
    graph, text = level.graph, number_text
    round_ = None if graph.circumference is None else text(graph.circumference)

    def position(at: EdgePosition[Fraction]) -> Position:
        return position_record(at, level)

    return LevelRecord(
        format="graphbody/level@1",
        name=name,
        note=note,
        vertices=[(text(v.x), text(v.y)) for v in graph.vertices],
        edges=None if is_polyline(graph) else [edge_record(edge) for edge in graph.edges],
        circumference=round_,
        margin=text(level.margin),
        tick=text(level.tick),
        bodies=[
            BodyRecord(b.name, position(b.left), position(b.right), text(b.speed), text(b.height), b.pushes)
            for b in level.bodies
        ],
        buttons=[position(at) for at in level.buttons],
    )


def position_record(at: EdgePosition[Any], level: Level[Any]) -> Position:
    """An edge position as it stands in a file."""
    statics = len(level.graph.edges)
    if at.edge < statics:
        return Position(number_text(at.location), edge=at.edge)
    return Position(number_text(at.location), top=level.bodies[at.edge - statics].name)


def edge_record(edge: Edge[Fraction]) -> EdgeRecord:
    """An edge as it stands in a file."""
    thickness = None if edge.thickness is None else number_text(edge.thickness)
    return EdgeRecord(edge.left, edge.right, edge.type.value, thickness)


def is_polyline(graph: Graph[Fraction]) -> bool:
    """Whether a graph is what joining its vertices from left to right gives."""
    if any(right.x < left.x for left, right in pairwise(graph.vertices)):
        return False
    try:
        return polyline(graph.vertices, graph.circumference) == graph
    except (IrrationalLength, NoLength):
        return False


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
    """Write a record as readable JSON, without fields that hold their default."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(msgspec.json.format(msgspec.json.encode(record), indent=2) + b"\n")


def in_floats(level: Level[Fraction]) -> Level[float]:
    """The level in binary floating point, as a game would hold it."""
    round_ = level.graph.circumference
    vertices = tuple(Vertex(float(v.x), float(v.y)) for v in level.graph.vertices)
    edges = tuple(
        Edge(
            e.left,
            e.right,
            e.type,
            float(e.length),
            float(e.run),
            float(e.rise),
            None if e.thickness is None else float(e.thickness),
        )
        for e in level.graph.edges
    )

    def position(at: EdgePosition[Fraction]) -> EdgePosition[float]:
        return EdgePosition(at.edge, float(at.location))

    return Level(
        Graph(vertices, edges, None if round_ is None else float(round_)),
        float(level.margin),
        float(level.tick),
        tuple(
            Body(b.name, position(b.left), position(b.right), float(b.speed), float(b.height), b.pushes)
            for b in level.bodies
        ),
        tuple(position(at) for at in level.buttons),
    )
