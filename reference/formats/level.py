"""Level files: a graph, bodies where they start, and the goal."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise
from typing import Annotated, Any, Literal

from msgspec import Meta

from reference.formats.files import Many, Name, Record
from reference.formats.numbers import Number, check_denominators, exact, number_text
from reference.world import LevelError, world_of
from spec.body import Body, EdgePosition, Level
from spec.graph import Edge, EdgeType, ExplicitEdge, Graph, IrrationalLength, NoLength, Vertex, explicit, polyline

Index = Annotated[int, Meta(ge=0)]


class Position(Record, frozen=True):
    """An edge position: a static edge by its number or the top of a body by its name, and a location from its left."""

    location: Number
    edge: Index | None = None
    top: Name | None = None


class BodyRecord(Record, frozen=True):
    """A body: name, borders, speed (distance per second; 0 for a box), height, and whether it may push others."""

    name: Name
    left: Position
    right: Position
    speed: Number = "0"
    height: Number = "1"
    pushes: bool = True


class EdgeRecord(Record, frozen=True):
    """An edge of an explicit graph, from its left to its right vertex; without a type, its steepness decides it.

    Under a ground edge all is solid, or down to `thickness` only.
    """

    left: Index
    right: Index
    type: Literal["ground", "fall"] | None = None
    thickness: Number | None = None


class LevelRecord(Record, frozen=True):
    """A level: vertices, joined from left to right, or as `edges` says; round a cylinder if it has a circumference.

    Its goal is that a character stands on each of its buttons.
    """

    format: Literal["graphbody/level@1"]
    name: Name
    vertices: Many[tuple[Number, Number]]
    bodies: Many[BodyRecord]
    margin: Number = "1/100"
    tick: Number = "1/50"
    circumference: Number | None = None
    edges: Many[EdgeRecord] | None = None
    buttons: Many[Position] = []  # noqa: RUF012 (a struct copies it)
    note: str = ""


def position_of(record: Position, tops: dict[str, int], place: str) -> EdgePosition[Fraction]:
    """An edge position with exact numbers; `tops` are the edges of the tops of bodies, by name."""
    if (record.edge is None) == (record.top is None):
        raise LevelError(place, "expected either `edge` or `top`")
    if record.top is not None and record.top not in tops:
        raise LevelError(f"{place}.top", f"no body is named {record.top!r}")
    if record.edge is not None and not record.edge < (statics := min(tops.values(), default=0)):
        raise LevelError(f"{place}.edge", f"expected 0 to {statics - 1}, got {record.edge}")
    edge = tops[record.top] if record.top is not None else record.edge
    assert edge is not None
    return EdgePosition(edge, exact(record.location, f"{place}.location"))


def level_of(record: LevelRecord) -> Level[Fraction]:
    """The level of a record; whether a world can hold it is for the world to say.

    Raises:
        LevelError: if a number, a name or an edge is not as it must be.
    """
    graph = graph_of(record)
    tops = tops_of(record, len(graph.edges))
    bodies = tuple(body_of(body, tops, f"$.bodies[{i}]") for i, body in enumerate(record.bodies))
    buttons = tuple(position_of(at, tops, f"$.buttons[{i}]") for i, at in enumerate(record.buttons))
    margin, tick = exact(record.margin, "$.margin"), exact(record.tick, "$.tick")
    level = Level(graph, margin, tick, bodies, buttons)
    check_denominators([*numbers_of(level), *distances_per_tick(level)])
    return level


def valid_level(record: LevelRecord, place: str) -> Level[Fraction]:
    """The level of a record that is at `place` in a document, if a world can hold it.

    Raises:
        LevelError: if not.
    """
    try:
        level = level_of(record)
        world_of(level)
    except LevelError as error:
        raise error.under(place) from None
    return level


def numbers_of(level: Level[Fraction]) -> Iterator[tuple[str, Fraction]]:
    """The numbers of a level that sums are made of, each with its place."""
    for i, vertex in enumerate(level.graph.vertices):
        yield from ((f"$.vertices[{i}]", number) for number in (vertex.x, vertex.y))
    for i, edge in enumerate(level.graph.edges):
        yield f"$.edges[{i}].thickness", edge.thickness or edge.length
    for i, body in enumerate(level.bodies):
        yield from ((f"$.bodies[{i}]", number) for number in (body.left.location, body.right.location, body.height))
    yield "$.margin", level.margin


def distances_per_tick(level: Level[Fraction]) -> Iterator[tuple[str, Fraction]]:
    """How far the bodies of a level want to move in a tick, each with its place."""
    for i, body in enumerate(level.bodies):
        yield f"$.bodies[{i}].speed", body.speed * level.tick


def tops_of(record: LevelRecord, statics: int) -> dict[str, int]:
    """The edges of the tops of bodies, by the bodies' names."""
    tops: dict[str, int] = {}
    for i, body in enumerate(record.bodies):
        if body.name in tops:
            raise LevelError(f"$.bodies[{i}].name", f"expected a name of its own, got {body.name!r} again")
        tops[body.name] = statics + i
    return tops


def graph_of(record: LevelRecord) -> Graph[Fraction]:
    """The graph of a level, joined from left to right or as its edges say (6.1.3; R30)."""
    vertices = [
        Vertex(exact(x, f"$.vertices[{i}][0]"), exact(y, f"$.vertices[{i}][1]"))
        for i, (x, y) in enumerate(record.vertices)
    ]
    round_ = record.circumference
    circumference = None if round_ is None else exact(round_, "$.circumference")
    if len(vertices) < (2 if circumference is None else 1):
        raise LevelError("$.vertices", "expected two vertices or more (one on a cylinder)")
    try:
        if record.edges is not None:
            return explicit(
                [explicit_edge(edge, i, len(vertices)) for i, edge in enumerate(record.edges)],
                vertices,
                circumference,
            )
        check_left_to_right(vertices, circumference)
        return polyline(vertices, circumference)
    except (IrrationalLength, NoLength) as error:
        where = "vertices" if record.edges is None else "edges"
        raise LevelError(f"$.{where}[{error.edge}]", str(error)) from None


def explicit_edge(record: EdgeRecord, index: int, vertices: int) -> ExplicitEdge:
    """An edge of an explicit graph with exact numbers."""
    for side, vertex in (("left", record.left), ("right", record.right)):
        if vertex >= vertices:
            raise LevelError(f"$.edges[{index}].{side}", f"expected 0 to {vertices - 1}, got {vertex}")
    thickness = None if record.thickness is None else exact(record.thickness, f"$.edges[{index}].thickness")
    return ExplicitEdge(record.left, record.right, None if record.type is None else EdgeType(record.type), thickness)


def check_left_to_right(vertices: list[Vertex[Fraction]], circumference: Fraction | None) -> None:
    """Refuse vertices that do not go from left to right, once round at most (A58)."""
    for i, (left, right) in enumerate(pairwise(vertices)):
        if right.x < left.x:
            raise LevelError(f"$.vertices[{i + 1}]", f"expected x of {left.x} or more, got {right.x}")
    if circumference is not None and vertices[-1].x - vertices[0].x >= circumference:
        raise LevelError("$.circumference", "expected more than the distance of the first and last vertex")


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
