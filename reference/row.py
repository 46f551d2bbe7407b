"""A world of one string of ground edges, open or closed, with its bodies kept in order.

Neighbours are looked up by order, so a query costs the same whatever else is in the level (O5). Work is
counted: collision queries (one per move along one edge) and look-ups of edges.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from typing import Generic

from spec.body import Body, EdgePosition, Level
from spec.graph import Direction, EdgeType, Graph
from spec.number import N, zero_like


class LevelError(ValueError):
    """A level that the world cannot hold; `place` says where, as in `$.bodies[2].right`."""

    def __init__(self, place: str, problem: str) -> None:
        """Name the place and what is expected there."""
        super().__init__(f"{place}: {problem}")
        self.place = place


@dataclass
class Work:
    """Counted work: collision queries and edge look-ups."""

    queries: int = 0
    look_ups: int = 0


def string_of(graph: Graph[N]) -> list[int]:
    """The edges of the only string of ground edges, from left to right; a ring starts at edge 0.

    Raises:
        LevelError: if an edge is no ground edge, a look-up has two results, or there are several strings.
    """
    for index, edge in enumerate(graph.edges):
        if edge.type is not EdgeType.GROUND:
            raise LevelError(f"$.vertices[{edge.left}]", f"edge {index} is steeper than 60 degrees: no ground")
        if len(graph.look_up(edge.right, Direction.RIGHT, EdgeType.GROUND)) > 1:
            raise LevelError(f"$.vertices[{edge.right}]", "two ground edges leave it in one direction (A41)")
    starts = [i for i, edge in enumerate(graph.edges) if not graph.look_up(edge.left, Direction.LEFT, EdgeType.GROUND)]
    string = starts[:1] or [0]
    while following := graph.look_up(graph.edges[string[-1]].right, Direction.RIGHT, EdgeType.GROUND):
        if following[0] == string[0]:
            break
        string.append(following[0])
    if len(string) != len(graph.edges):
        raise LevelError("$.vertices", "the ground edges do not form one string")
    return string


@dataclass
class Row(Generic[N]):
    """Bodies in order on one string of ground edges. Handles of bodies are places in that order.

    Attributes:
        bodies: from left to right; on a ring, by their left borders from the beginning of edge 0.
        length: of the whole string; `free` is what the bodies leave of it.
    """

    graph: Graph[N]
    margin: N
    bodies: list[Body[N]]
    closed: bool
    work: Work = field(default_factory=Work)

    def __post_init__(self) -> None:
        """Lay the edges end to end."""
        self.offsets: list[N] = [edge.length for edge in self.graph.edges]
        total = zero_like(self.margin)
        for index in string_of(self.graph):
            self.offsets[index] = total
            total = total + self.graph.edges[index].length
        self.length = total
        self.free = total
        for index in range(len(self.bodies)):
            self.free = self.free - self.width(index)

    def coordinate(self, at: EdgePosition[N]) -> N:
        """Distance along the string from its left end (on a ring, from the beginning of edge 0)."""
        return self.offsets[at.edge] + at.location

    def width(self, body: int) -> N:
        """Distance along the graph between the borders."""
        held = self.bodies[body]
        across = self.coordinate(held.right) - self.coordinate(held.left)
        return across + self.length if self.closed and across <= zero_like(across) else across

    def apart(self, near: EdgePosition[N], far: EdgePosition[N]) -> N:
        """Signed distance from a right border to the left border after it.

        On a ring a gap is never longer than all free space together, so what would be longer is an overlap.
        """
        distance = self.coordinate(far) - self.coordinate(near)
        if self.closed and distance < zero_like(distance):
            distance = distance + self.length
        return distance - self.length if self.closed and distance > self.free else distance

    def beside(self, body: int, direction: Direction) -> int | None:
        """The neighbour on one side, or None at the end of a row and for a body alone on a ring."""
        other = body + direction
        if self.closed:
            other %= len(self.bodies)
        return other if other != body and 0 <= other < len(self.bodies) else None

    def facing(self, direction: Direction) -> Facing[N]:
        """This world as a motion in one direction sees it."""
        return Facing(self, direction)

    def neighbours(self) -> Iterator[tuple[int, int]]:
        """Each body with its right neighbour; on a ring the last with the first."""
        for body in range(len(self.bodies)):
            right = self.beside(body, Direction.RIGHT)
            if right is not None:
                yield body, right

    def clear(self, left: int, right: int) -> N:
        """Signed distance between two neighbours."""
        return self.apart(self.bodies[left].right, self.bodies[right].left)

    def off_graph(self, body: int) -> Iterator[N]:
        """Location and distance to the end of the edge, of each border."""
        for at in (self.bodies[body].left, self.bodies[body].right):
            yield at.location
            yield self.graph.edges[at.edge].length - at.location

    def bodies_in_order(self) -> range:
        """All bodies, from left to right."""
        return range(len(self.bodies))

    def edge_lengths(self) -> list[N]:
        """The lengths of all ground edges."""
        return [edge.length for edge in self.graph.edges]

    def to_wall(self, body: int, direction: Direction) -> N | None:
        """Distance from the leading border to the end of the string; None on a ring."""
        if self.closed:
            return None
        along = self.coordinate(self.bodies[body].border(direction))
        return self.length - along if direction is Direction.RIGHT else along

    def travel(self, before: Row[N], body: int, direction: Direction) -> N:
        """How far a body has come in a direction.

        On a ring no body comes further than all free space, so what is nearer to a whole round is a step back.
        """
        start, now = (self.coordinate(row.bodies[body].border(direction)) for row in (before, self))
        distance = (now - start) * direction
        if self.closed and distance < zero_like(distance):
            distance = distance + self.length
        return distance - self.length if self.closed and distance * 2 > self.free + self.length else distance

    def copy(self) -> Row[N]:
        """An independent copy; the graph is shared."""
        return Row(self.graph, self.margin, list(self.bodies), self.closed)


@dataclass(frozen=True)
class Facing(Generic[N]):
    """A row as a motion in one direction sees it (`spec.world.View`)."""

    row: Row[N]
    direction: Direction

    @property
    def margin(self) -> N:
        """The collision margin."""
        return self.row.margin

    def front(self, body: int) -> EdgePosition[N]:
        """The border on the side of the motion."""
        return self.row.bodies[body].border(self.direction)

    def rear(self, body: int) -> EdgePosition[N]:
        """The border on the other side."""
        return self.row.bodies[body].border(self.direction.opposite)

    def reach(self, at: EdgePosition[N]) -> N:
        """Distance to the end of the edge."""
        return self.end(at).location - at.location if self.direction is Direction.RIGHT else at.location

    def along(self, at: EdgePosition[N], distance: N) -> EdgePosition[N]:
        """The position `distance` ahead on the same edge."""
        return replace(at, location=at.location + distance * self.direction)

    def end(self, at: EdgePosition[N]) -> EdgePosition[N]:
        """The end of the edge."""
        return self.tip(at.edge, self.direction)

    def tip(self, edge: int, direction: Direction) -> EdgePosition[N]:
        """One end of an edge."""
        length = self.row.graph.edges[edge].length
        return EdgePosition(edge, length if direction is Direction.RIGHT else zero_like(length))

    def following(self, edge: int) -> int | None:
        """The next ground edge, looked up by (vertex, direction, type)."""
        self.row.work.look_ups += 1
        vertex = self.row.graph.edges[edge].towards(self.direction)
        edges = self.row.graph.look_up(vertex, self.direction, EdgeType.GROUND)
        return edges[0] if edges else None

    def onward(self, at: EdgePosition[N]) -> EdgePosition[N] | None:
        """The beginning of the next ground edge."""
        following = self.following(at.edge)
        return None if following is None else self.tip(following, self.direction.opposite)

    def ahead(self, body: int, front: EdgePosition[N]) -> int | None:
        """The neighbour in this direction, if it is on this edge or the next."""
        self.row.work.queries += 1
        other = self.row.beside(body, self.direction)
        following = self.following(front.edge)
        if other is None or following is None:
            return other
        in_sight = self.reach(front) + self.row.graph.edges[following].length
        return other if self.gap(front, other) <= in_sight else None

    def gap(self, front: EdgePosition[N], other: int) -> N:
        """Distance to the facing border of a neighbour."""
        facing = self.row.bodies[other].border(self.direction.opposite)
        return self.row.apart(front, facing) if self.direction is Direction.RIGHT else self.row.apart(facing, front)

    def place(self, body: int, front: EdgePosition[N], rear: EdgePosition[N]) -> None:
        """Put the borders of a body."""
        left, right = (rear, front) if self.direction is Direction.RIGHT else (front, rear)
        self.row.bodies[body] = replace(self.row.bodies[body], left=left, right=right)


def check_borders(level: Level[N]) -> None:
    """Refuse borders that are not on the graph, and margins, ticks and edges without length."""
    zero = zero_like(level.margin)
    for name, value in (("margin", level.margin), ("tick", level.tick)):
        if value <= zero:
            raise LevelError(f"$.{name}", f"expected a number greater than 0, got {value}")
    for index, edge in enumerate(level.graph.edges):
        if edge.length <= zero:
            raise LevelError(f"$.vertices[{edge.right}]", f"edge {index} has no length")
    for index, body in enumerate(level.bodies):
        for side, at in (("left", body.left), ("right", body.right)):
            place = f"$.bodies[{index}].{side}"
            if not 0 <= at.edge < len(level.graph.edges):
                raise LevelError(f"{place}.edge", f"expected 0 to {len(level.graph.edges) - 1}, got {at.edge}")
            length = level.graph.edges[at.edge].length
            if not (zero <= at.location <= length):
                raise LevelError(f"{place}.location", f"expected 0 to {length}, got {at.location}")


def row_of(level: Level[N]) -> Row[N]:
    """The world of a level at its start.

    Raises:
        LevelError: if it is not one string of ground edges, or its bodies do not lie on it margin by margin.
    """
    check_borders(level)
    row = Row(level.graph, level.margin, list(level.bodies), closed=level.graph.circumference is not None)
    places = {body.name: f"$.bodies[{index}]" for index, body in enumerate(level.bodies)}
    zero = zero_like(level.margin)
    for index, body in enumerate(row.bodies):
        if row.width(index) <= zero:
            raise LevelError(places[body.name], "expected the left border to be left of the right border")
    row.bodies.sort(key=lambda body: row.coordinate(body.left))
    if row.closed and row.free < zero:
        raise LevelError("$.bodies", f"the bodies are wider than the ring by {zero - row.free}")
    for left, right in row.neighbours():
        clear = row.clear(left, right)
        if clear < level.margin:
            names = f"{row.bodies[left].name} and {row.bodies[right].name}"
            raise LevelError(places[row.bodies[right].name], f"{names} are {clear} apart, less than the margin")
    return row
