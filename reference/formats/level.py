"""Level files: a graph, bodies where they start, and the goal."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from typing import Annotated, Any, Literal

from msgspec import Meta

from reference.formats.files import Many, Name, Record, says
from reference.formats.numbers import Number, check_sums, exact, number_text
from reference.rounding import Precision, tolerance
from reference.world import STANDING, LevelError, Stance, world_of
from spec.body import Body, EdgePosition, Level
from spec.graph import Edge, EdgeType, ExplicitEdge, Graph, IrrationalLength, NoLength, Vertex, explicit, polyline
from spec.rules.velocity import Material, Motion

MOST_BUTTONS = 100
Index = Annotated[int, Meta(ge=0)]


class Position(Record, frozen=True):
    """An edge position: one edge, static or the top of a body, and how far along it. Either `edge` or `top` is given.

    A location below 0 or beyond the edge's length is overhang, which only a ledge permits. Under `repaired` a
    top also holds a body that is wholly beside it, nearer than the margin.
    """

    location: Annotated[Number, says("distance along the edge from its left end, in units of length")]
    edge: Annotated[Index | None, says("a static edge, by its number, counted from 0")] = None
    top: Annotated[Name | None, says("the top of a body, by the body's name")] = None


class MaterialRecord(Record, frozen=True):
    """What a dynamic body is made of, and what acts on it. All numbers but the force are at least 0."""

    friction: Annotated[Number, says("its coefficient of friction")] = "0"
    drag: Annotated[
        Number,
        says(
            "by what its velocity is multiplied in each tick, from 0 to 1; only under `thesis` and `thesis/overshoot`"
        ),
    ] = "1"
    damping: Annotated[
        Number,
        says(
            "how much velocity it loses for each unit of way, in 1 per second; only under `repaired` and "
            "`thesis/mended-velocity`"
        ),
    ] = "0"
    slowest: Annotated[Number, says("its least speed, in units of length per second; if it is slower, it stands")] = "0"
    fastest: Annotated[
        Number | None, says("its greatest speed, in units of length per second; if left out, there is none")
    ] = None
    mass: Annotated[Number, says("its mass, more than 0")] = "1"
    gravity: Annotated[
        Number, says("the gravity constant times the body's gravity scale, in units of length per second squared")
    ] = "981/100"
    force: Annotated[
        Number,
        says("what pushes it along the ground, in units of mass times length per second squared; negative to the left"),
    ] = "0"


class BodyRecord(Record, frozen=True):
    """A body where it starts: a character if it has a speed, else a box."""

    name: Annotated[Name, says("its name; no other body of the level has it")]
    left: Annotated[Position, says("where its left border is")]
    right: Annotated[Position, says("where its right border is")]
    speed: Annotated[Number, says("units of length per second while a key is held; 0 for a box")] = "0"
    height: Annotated[Number, says("height in units of length, more than 0; others may stand on its top")] = "1"
    pushes: Annotated[bool, says("whether it may push others")] = True
    velocity: Annotated[
        Number | None,
        says(
            "for a box that moves of its own in each tick, how fast it is along what it stands on, in units of length "
            "per second, negative to the left; if left out, 0 with a `material`, else it does not move of its own"
        ),
    ] = None
    material: Annotated[
        MaterialRecord | None,
        says("for a dynamic box, which feels gravity, friction and drag; if left out, its velocity stays as it is set"),
    ] = None


class EdgeRecord(Record, frozen=True):
    """An edge of an explicit graph, from its left to its right vertex."""

    left: Annotated[Index, says("its left vertex, by its number, counted from 0")]
    right: Annotated[Index, says("its right vertex, by its number")]
    type: Annotated[
        Literal["ground", "fall"] | None,
        says("bodies walk on `ground` and drop down `fall`; if left out, steeper than 60 degrees is `fall`"),
    ] = None
    thickness: Annotated[
        Number | None,
        says("how far down it is solid under a ground edge, in units of length; if left out, all the way"),
    ] = None
    friction: Annotated[
        Number | None, says("its coefficient of friction; if left out, that of the body alone counts")
    ] = None


class LevelRecord(Record, frozen=True):
    """A level: the graph, the bodies where they start, and the goal.

    The edges join the vertices from left to right, or are those of `edges`. Edges are numbered from 0, from the left or
    in the order of `edges`; their lengths must be rational numbers.
    """

    format: Annotated[Literal["graphbody/level@1"], says("what the file is, and the version of its format")]
    name: Annotated[Name, says("the name of the level")]
    vertices: Annotated[
        Annotated[Many[tuple[Number, Number]], Meta(min_length=1)],
        says("the points of the graph: x, which grows to the right, and y, which grows up"),
    ]
    bodies: Annotated[Many[BodyRecord], says("the bodies; in this order they take their turns in a tick")]
    margin: Annotated[
        Number, says("the collision margin: how near two bodies may come, in units of length, more than 0")
    ] = "1/100"
    tick: Annotated[Number, says("the length of a tick in seconds, more than 0")] = "1/50"
    circumference: Annotated[
        Number | None, says("on a cylinder, how far it is once round, in units of length; if left out, a plane")
    ] = None
    edges: Annotated[
        Many[EdgeRecord] | None,
        says("the edges; if left out, each vertex is joined to the next one, and round a cylinder"),
    ] = None
    buttons: Annotated[
        Annotated[list[Position], Meta(max_length=MOST_BUTTONS)],
        says("the goal: on each of these places a character stands, all at the same time"),
    ] = []  # noqa: RUF012 (a struct copies it)
    note: Annotated[str, says("what the level is there for; nothing depends on it")] = ""


@dataclass(frozen=True)
class Tops:
    """The edges of the tops of bodies, by the bodies' names; static edges are those numbered below `statics`."""

    statics: int
    edges: dict[str, int]


def tops_in(level: Level[Any]) -> Tops:
    """The edges of the tops of the bodies of a level."""
    statics = len(level.graph.edges)
    return Tops(statics, {body.name: statics + i for i, body in enumerate(level.bodies)})


def tops_after(tops: Tops, added: str | None, removed: str | None, place: str) -> Tops:
    """The tops when a body is added or removed; those after one that is removed are numbered anew.

    Raises:
        LevelError: if a body that is added has another's name, or none has that of one to be removed.
    """
    names = list(tops.edges)
    if added is not None:
        if added in names:
            raise LevelError(f"{place}.add.name", f"expected a name of its own, got {added!r} again")
        names.append(added)
    if removed is not None:
        if removed not in names:
            raise LevelError(f"{place}.remove.body", f"no body is named {removed!r}")
        names.remove(removed)
    return Tops(tops.statics, {name: tops.statics + i for i, name in enumerate(names)})


def position_of(record: Position, tops: Tops, place: str) -> EdgePosition[Fraction]:
    """An edge position with exact numbers.

    Raises:
        LevelError: if it is not on one edge that is there, or its location is no number.
    """
    if (record.edge is None) == (record.top is None):
        raise LevelError(place, "expected either `edge` or `top`")
    if record.top is not None and record.top not in tops.edges:
        raise LevelError(f"{place}.top", f"no body is named {record.top!r}")
    if record.edge is not None and record.edge >= tops.statics:
        raise LevelError(f"{place}.edge", f"expected 0 to {tops.statics - 1}, got {record.edge}")
    edge = tops.edges[record.top] if record.top is not None else record.edge
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
    check_sums([*numbers_of(level), *distances_per_tick(level)])
    return level


def valid_level(
    record: LevelRecord, place: str, numbers: Precision = "exact", stance: Stance = STANDING
) -> Level[Fraction]:
    """The level of a record that is at `place` in a document, if a world can hold it, in such numbers, standing so.

    Raises:
        LevelError: if not.
    """
    try:
        level = level_of(record)
        world_of(level, tolerance(numbers, level), stance)
    except LevelError as error:
        raise error.under(place) from None
    return level


def numbers_of(level: Level[Fraction]) -> Iterator[tuple[str, tuple[Fraction, ...]]]:
    """The numbers of a level that sums are made of, with their places."""
    for i, vertex in enumerate(level.graph.vertices):
        yield f"$.vertices[{i}]", (vertex.x, vertex.y)
    for i, edge in enumerate(level.graph.edges):
        yield f"$.edges[{i}].thickness", (edge.thickness or edge.length,)
    for i, body in enumerate(level.bodies):
        yield f"$.bodies[{i}]", (body.left.location, body.right.location, body.height)
    yield "$.margin", (level.margin,)
    yield "$.circumference", (level.graph.circumference or level.margin,)


def distances_per_tick(level: Level[Fraction]) -> Iterator[tuple[str, tuple[Fraction, ...]]]:
    """How far the bodies of a level want to move in a tick, with their places."""
    for i, body in enumerate(level.bodies):
        yield f"$.bodies[{i}].speed", (body.speed * level.tick,)
        if body.motion is not None:
            yield f"$.bodies[{i}].velocity", (body.motion.velocity, body.motion.velocity * level.tick)


def tops_of(record: LevelRecord, statics: int) -> Tops:
    """The edges of the tops of bodies, by the bodies' names; they are numbered after the static edges."""
    edges: dict[str, int] = {}
    for i, body in enumerate(record.bodies):
        if body.name in edges:
            raise LevelError(f"$.bodies[{i}].name", f"expected a name of its own, got {body.name!r} again")
        edges[body.name] = statics + i
    return Tops(statics, edges)


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
    friction = None if record.friction is None else exact(record.friction, f"$.edges[{index}].friction")
    if friction is not None and friction < 0:
        raise LevelError(f"$.edges[{index}].friction", f"expected 0 or more, got {friction}")
    edge_type = None if record.type is None else EdgeType(record.type)
    return ExplicitEdge(record.left, record.right, edge_type, thickness, friction)


def check_left_to_right(vertices: list[Vertex[Fraction]], circumference: Fraction | None) -> None:
    """Refuse vertices that do not go from left to right, once round at most (A58)."""
    for i, (left, right) in enumerate(pairwise(vertices)):
        if right.x < left.x:
            raise LevelError(f"$.vertices[{i + 1}]", f"expected x of {left.x} or more, got {right.x}")
    if circumference is not None and vertices[-1].x - vertices[0].x >= circumference:
        raise LevelError("$.circumference", "expected more than the distance of the first and last vertex")


def body_of(record: BodyRecord, tops: Tops, place: str) -> Body[Fraction]:
    """A body with exact numbers."""
    speed, height = exact(record.speed, f"{place}.speed"), exact(record.height, f"{place}.height")
    if speed < 0:
        raise LevelError(f"{place}.speed", f"expected 0 or more, got {speed}")
    left, right = position_of(record.left, tops, f"{place}.left"), position_of(record.right, tops, f"{place}.right")
    return Body(record.name, left, right, speed, height, record.pushes, motion_of(record, speed, place))


def motion_of(record: BodyRecord, speed: Fraction, place: str) -> Motion[Fraction] | None:
    """How a body moves of its own, or None if it does not.

    Raises:
        LevelError: if a number is not as it must be, or a character has a velocity.
    """
    if record.velocity is None and record.material is None:
        return None
    if speed:
        what = "velocity" if record.material is None else "material"
        raise LevelError(f"{place}.{what}", "expected none: a character has the speed that is set while a key is held")
    velocity = exact("0" if record.velocity is None else record.velocity, f"{place}.velocity")
    if record.material is None:
        return Motion(velocity, None, Fraction(0), Fraction(0))
    return of_material(record.material, velocity, f"{place}.material")


def of_material(record: MaterialRecord, velocity: Fraction, place: str) -> Motion[Fraction]:
    """The motion of a dynamic body.

    Raises:
        LevelError: if a number is not as it must be.
    """

    def number(name: str) -> Fraction:
        found = exact(getattr(record, name), f"{place}.{name}")
        if found < 0:
            raise LevelError(f"{place}.{name}", f"expected 0 or more, got {found}")
        return found

    drag, mass = number("drag"), number("mass")
    if drag > 1:
        raise LevelError(f"{place}.drag", f"expected 0 to 1, got {drag}")
    if not mass:
        raise LevelError(f"{place}.mass", f"expected a number greater than 0, got {mass}")
    fastest = None if record.fastest is None else number("fastest")
    material = Material(number("friction"), drag, number("damping"), number("slowest"), fastest, mass)
    return Motion(velocity, material, number("gravity"), exact(record.force, f"{place}.force"))


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
        bodies=[body_record(body, position(body.left), position(body.right)) for body in level.bodies],
        buttons=[position(at) for at in level.buttons],
    )


def body_record(body: Body[Fraction], left: Position, right: Position) -> BodyRecord:
    """A body as it stands in a file."""
    text, motion = number_text, body.motion
    velocity = None if motion is None else text(motion.velocity)
    material = None if motion is None or motion.material is None else material_record(motion, motion.material)
    speed, height = text(body.speed), text(body.height)
    return BodyRecord(body.name, left, right, speed, height, body.pushes, velocity, material)


def material_record(motion: Motion[Fraction], material: Material[Fraction]) -> MaterialRecord:
    """What a dynamic body is made of, and what acts on it, as it stands in a file."""
    text = number_text
    return MaterialRecord(
        friction=text(material.friction),
        drag=text(material.drag),
        damping=text(material.damping),
        slowest=text(material.slowest),
        fastest=None if material.fastest is None else text(material.fastest),
        mass=text(material.mass),
        gravity=text(motion.gravity),
        force=text(motion.force),
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
    friction = None if edge.friction is None else number_text(edge.friction)
    return EdgeRecord(edge.left, edge.right, edge.type.value, thickness, friction)


def is_polyline(graph: Graph[Fraction]) -> bool:
    """Whether a graph is what joining its vertices from left to right gives."""
    if any(right.x < left.x for left, right in pairwise(graph.vertices)):
        return False
    try:
        return polyline(graph.vertices, graph.circumference) == graph
    except (IrrationalLength, NoLength):
        return False
