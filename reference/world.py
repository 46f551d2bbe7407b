"""A world: strings of edges, static ones and the tops of bodies, each with its bodies kept in order.

Neighbours are looked up by order, so a query costs the same whatever else is in the level (O5). Work is
counted: collision queries (one per move along one edge) and look-ups of edges.

A body's handle is its place in the level's list of bodies. The static edges are numbered as in the graph; the top
of body N is the edge after them with number N, one edge whose length is the body's width (R9, R11).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from copy import copy
from dataclasses import dataclass, field, replace
from typing import Generic

from spec.body import Body, EdgePosition, Level
from spec.features import WIDE, Widths
from spec.graph import Direction, Edge, EdgeType, Graph, Vertex, extent
from spec.interpolation import linear
from spec.number import N, zero_like
from spec.world import Beyond, Jump

MOST_STOREYS = 100


class LevelError(ValueError):
    """A level that the world cannot hold; `place` says where, as in `$.bodies[2].right`."""

    def __init__(self, place: str, problem: str) -> None:
        """Name the place and what is expected there."""
        super().__init__(f"{place}: {problem}")
        self.place, self.problem = place, problem

    def under(self, place: str) -> LevelError:
        """The same of a level that is itself at a place in a document."""
        return LevelError(self.place.replace("$", place, 1), self.problem)


@dataclass
class Work:
    """Counted work: collision queries and edge look-ups."""

    queries: int = 0
    look_ups: int = 0


@dataclass
class Row(Generic[N]):
    """One string of edges laid end to end, and the bodies on it from left to right (on a ring, once round).

    Attributes:
        offsets: where each edge begins, along the string.
        free: what the bodies on a ring leave of its length.
    """

    edges: list[int]
    offsets: dict[int, N]
    length: N
    closed: bool
    order: list[int] = field(default_factory=list)
    place: dict[int, int] = field(default_factory=dict)
    free: N | None = None


def strings_of(graph: Graph[N]) -> list[tuple[list[int], bool]]:
    """The strings of ground edges, from left to right, and whether each is a ring.

    Raises:
        LevelError: if two ground edges leave a vertex in one direction.
    """
    for (vertex, direction, edge_type), edges in graph.table.items():
        if edge_type is EdgeType.GROUND and len(edges) > 1:
            both = f"ground edges {edges[0]} and {edges[1]}"
            raise LevelError(f"$.vertices[{vertex}]", f"{both} leave it to the {direction.name.lower()} (A41)")
    ground = [i for i, edge in enumerate(graph.edges) if edge.type is EdgeType.GROUND]
    starts = [i for i in ground if not graph.look_up(graph.edges[i].left, Direction.LEFT, EdgeType.GROUND)]
    strings = [(string_from(graph, start), False) for start in starts]
    found = {edge for string, _ in strings for edge in string}
    for index in ground:
        if index not in found:
            ring = string_from(graph, index)
            found.update(ring)
            strings.append((ring, True))
    return strings


def string_from(graph: Graph[N], start: int) -> list[int]:
    """The ground edges from one on to the right, once round at most."""
    string = [start]
    while following := graph.look_up(graph.edges[string[-1]].right, Direction.RIGHT, EdgeType.GROUND):
        if following[0] == start:
            break
        string.append(following[0])
    return string


class World(Generic[N]):
    """A level at one moment: where all bodies are, string by string. It is changed by placing bodies."""

    def __init__(self, level: Level[N]) -> None:
        """Lay the strings out and put the bodies in order.

        Raises:
            LevelError: if two ground edges leave a vertex in one direction.
        """
        self.level = level
        self.graph, self.margin, self.bodies = level.graph, level.margin, list(level.bodies)
        self.statics = len(level.graph.edges)
        self.work = Work()
        self.rows: list[Row[N]] = []
        self.row_of_edge: dict[int, Row[N]] = {}
        for string, closed in strings_of(level.graph):
            self.lay_out(string, [level.graph.edges[edge].length for edge in string], closed)
        for body in self.handles():
            self.lay_out([self.statics + body], [self.width(body)], closed=False)
        for body in self.handles():
            row = self.row(body)
            row.order.append(body)
        for row in self.rows:
            row.order.sort(key=lambda body: self.coordinate(self.bodies[body].left))
            self.settle(row)

    def lay_out(self, string: list[int], lengths: list[N], closed: bool) -> None:
        """Lay the edges of a string end to end."""
        offsets, along = {}, zero_like(self.margin)
        for edge, length in zip(string, lengths, strict=True):
            offsets[edge] = along
            along = along + length
        row = Row(string, offsets, along, closed)
        self.rows.append(row)
        for edge in string:
            self.row_of_edge[edge] = row

    def settle(self, row: Row[N]) -> None:
        """Note the places of the bodies of a string, and what they leave free of a ring."""
        row.place = {body: place for place, body in enumerate(row.order)}
        if row.closed:
            row.free = row.length
            for body in row.order:
                row.free = row.free - self.width(body)

    def handles(self) -> range:
        """The handles of all bodies, in the level's order."""
        return range(len(self.bodies))

    def row(self, body: int) -> Row[N]:
        """The string that a body is on."""
        return self.row_of_edge[self.bodies[body].left.edge]

    def support(self, body: int) -> int | None:
        """The body on whose top a body is, or None on the ground."""
        edge = self.bodies[body].left.edge
        return None if edge < self.statics else edge - self.statics

    def length_of(self, edge: int) -> N:
        """The length of an edge; that of a top is the width of its body."""
        return self.graph.edges[edge].length if edge < self.statics else self.width(edge - self.statics)

    def coordinate(self, at: EdgePosition[N]) -> N:
        """Distance along the string from its left end (on a ring, from where it was cut open)."""
        return self.row_of_edge[at.edge].offsets[at.edge] + at.location

    def width(self, body: int) -> N:
        """Distance along the graph between the borders."""
        held = self.bodies[body]
        if held.left.edge == held.right.edge and held.left.location < held.right.location:
            return held.right.location - held.left.location
        row = self.row(body)
        across = self.coordinate(held.right) - self.coordinate(held.left)
        return across + row.length if row.closed and across <= zero_like(across) else across

    def apart(self, near: EdgePosition[N], far: EdgePosition[N]) -> N:
        """Signed distance from a right border to the left border after it, on the same string.

        On a ring a gap is never longer than all free space together, so what is nearer to a whole round is an overlap.
        """
        row = self.row_of_edge[near.edge]
        distance = self.coordinate(far) - self.coordinate(near)
        if row.closed and distance < zero_like(distance):
            distance = distance + row.length
        return distance - row.length if self.nearly_round(row, distance) else distance

    def beside(self, body: int, direction: Direction) -> int | None:
        """The neighbour on one side, or None at the end of a row and for a body alone on a ring."""
        row = self.row(body)
        place = row.place[body] + direction
        if row.closed:
            place %= len(row.order)
        other = row.order[place] if 0 <= place < len(row.order) else None
        return None if other == body else other

    def facing(self, direction: Direction) -> Facing[N]:
        """This world as a motion in one direction sees it."""
        return Facing(self, direction)

    @property
    def closed(self) -> bool:
        """Whether the first string of edges is a ring."""
        return self.rows[0].closed

    def neighbours(self) -> Iterator[tuple[int, int]]:
        """Each body with its right neighbour on its string; on a ring the last with the first."""
        for row in self.rows:
            for body in row.order:
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
            yield self.length_of(at.edge) - at.location

    def bodies_in_order(self) -> Sequence[int]:
        """All bodies, string by string, from left to right."""
        return [body for row in self.rows for body in row.order]

    def edge_lengths(self) -> list[N]:
        """The lengths of all ground edges."""
        return [edge.length for edge in self.graph.edges if edge.type is EdgeType.GROUND]

    def to_wall(self, body: int, direction: Direction) -> N | None:
        """Distance from the leading border to the end of the string; None on a ring."""
        row = self.row(body)
        if row.closed:
            return None
        along = self.coordinate(self.bodies[body].border(direction))
        return row.length - along if direction is Direction.RIGHT else along

    def travel(self, before: World[N], body: int, direction: Direction) -> N:
        """How far a body has come in a direction along its string.

        On a ring no body comes further than all free space, so what is nearer to a whole round is a step back.
        """
        row = self.row(body)
        start, now = (world.coordinate(world.bodies[body].border(direction)) for world in (before, self))
        distance = (now - start) * direction
        if row.closed and distance < zero_like(distance):
            distance = distance + row.length
        return distance - row.length if self.nearly_round(row, distance) else distance

    def nearly_round(self, row: Row[N], distance: N) -> bool:
        """Whether a distance on a ring is nearer to a whole round than to all free space together."""
        return row.free is not None and bool(distance * 2 > row.free + row.length)

    def point(self, at: EdgePosition[N]) -> tuple[N, N]:
        """Where a position is in the plane: through the chain of supports down to a static edge (6.1.2; R12).

        Overhang continues the line of the edge (A56). A top is a height straight above its body (A30); where its
        body stands across a bend, it is interpolated between the corners (R13).
        """
        number, location, up = at.edge, at.location, zero_like(at.location)
        while number >= self.statics:
            held = self.bodies[number - self.statics]
            up = up + held.height
            if not self.straight(held):
                part = location / self.width(number - self.statics)
                x, y = linear(self.point(held.left), self.unrolled(held), part)
                return x, y + up
            number, location = held.left.edge, held.left.location + location
        edge = self.graph.edges[number]
        start = self.graph.vertices[edge.left]
        return start.x + location * edge.run, start.y + location * edge.rise + up

    def unrolled(self, held: Body[N]) -> tuple[N, N]:
        """Where the right border of a body is; on a cylinder never left of its left border."""
        x, y = self.point(held.right)
        circumference = self.graph.circumference
        if circumference is not None and x < self.point(held.left)[0]:
            return x + circumference, y
        return x, y

    def edges_under(self, body: int) -> tuple[Edge[N], Edge[N]]:
        """The static edges of the left and the right border of a body that stands on the ground."""
        held = self.bodies[body]
        return self.graph.edges[held.left.edge], self.graph.edges[held.right.edge]

    def extent(self, body: int) -> tuple[N, N]:
        """How far it is across and up from the left border of a body to the right one."""
        held = self.bodies[body]
        return extent(Vertex(*self.point(held.left)), Vertex(*self.unrolled(held)), zero_like(self.margin))

    def tip_point(self, edge: int, direction: Direction) -> tuple[N, N]:
        """Where an end of an edge is: a static one exactly at its vertex, in floats too."""
        if edge < self.statics:
            vertex = self.graph.vertices[self.graph.edges[edge].towards(direction)]
            return vertex.x, vertex.y
        return self.point(self.facing(direction).end(EdgePosition(edge, zero_like(self.margin))))

    def short_way(self, distance: N) -> N:
        """A horizontal distance; on a cylinder the short way round."""
        circumference = self.graph.circumference
        if circumference is None:
            return distance
        if distance * 2 > circumference:
            return distance - circumference
        return distance + circumference if distance * 2 < zero_like(distance) - circumference else distance

    def straight(self, held: Body[N]) -> bool:
        """Whether the ground under a body has one slope, all of it."""
        row = self.row_of_edge[held.left.edge]
        if held.left.edge == held.right.edge and (not row.closed or held.left.location < held.right.location):
            return True
        first, *others = self.ground_under(held, row)
        return all(bool(edge.run == first.run and edge.rise == first.rise) for edge in others)

    def ground_under(self, held: Body[N], row: Row[N]) -> list[Edge[N]]:
        """The ground edges under a body across a vertex of a string, from that of one border to that of the other."""
        first, last = (row.edges.index(at.edge) for at in (held.left, held.right))
        if row.closed and last <= first:
            under = row.edges[first:] + row.edges[: last + 1]
        else:
            under = row.edges[min(first, last) : max(first, last) + 1]
        return [self.graph.edges[edge] for edge in under]

    def put(self, body: int, left: EdgePosition[N], right: EdgePosition[N]) -> None:
        """Put a body where it is to be; on another string it takes its place in the order there."""
        before = self.row(body)
        self.bodies[body] = replace(self.bodies[body], left=left, right=right)
        row = self.row(body)
        if row is not before:
            self.reorder(before, [other for other in before.order if other != body])
            along = self.coordinate(left)
            place = sum(1 for other in row.order if self.coordinate(self.bodies[other].left) < along)
            self.reorder(row, [*row.order[:place], body, *row.order[place:]])

    def reorder(self, row: Row[N], order: list[int]) -> None:
        """Give a string another order of bodies; copies of this world keep theirs."""
        new = replace(row, order=order)
        self.settle(new)
        self.rows = [new if one is row else one for one in self.rows]
        for edge in new.edges:
            self.row_of_edge[edge] = new

    def pressed(self, button: EdgePosition[N]) -> bool:
        """Whether a character stands on a button: between its borders, on its string (1.1)."""
        row, along = self.row_of_edge[button.edge], self.coordinate(button)
        for body in row.order:
            if not self.bodies[body].speed:
                continue
            after = along - self.coordinate(self.bodies[body].left)
            if row.closed and after < zero_like(after):
                after = after + row.length
            if after >= zero_like(after) and after <= self.width(body):
                return True
        return False

    def solved(self) -> bool:
        """Whether every button is pressed (1.1)."""
        return all(self.pressed(button) for button in self.level.buttons)

    def copy(self) -> World[N]:
        """An independent copy, its work counted anew; the graph is shared, and strings until one changes."""
        other = copy(self)
        other.bodies, other.row_of_edge, other.work = list(self.bodies), dict(self.row_of_edge), Work()
        return other

    def become(self, other: World[N]) -> None:
        """Take over where the bodies of another world of this level are."""
        same = other.copy()
        self.bodies, self.rows, self.row_of_edge = same.bodies, same.rows, same.row_of_edge


@dataclass(frozen=True)
class Facing(Generic[N]):
    """A world as a motion in one direction sees it (`spec.world.View`)."""

    world: World[N]
    direction: Direction

    @property
    def margin(self) -> N:
        """The collision margin."""
        return self.world.margin

    def front(self, body: int) -> EdgePosition[N]:
        """The border on the side of the motion."""
        return self.world.bodies[body].border(self.direction)

    def rear(self, body: int) -> EdgePosition[N]:
        """The border on the other side."""
        return self.world.bodies[body].border(self.direction.opposite)

    def reach(self, at: EdgePosition[N]) -> N:
        """Distance to the end of the edge; negative in overhang."""
        return self.end(at).location - at.location if self.direction is Direction.RIGHT else at.location

    def along(self, at: EdgePosition[N], distance: N) -> EdgePosition[N]:
        """The position `distance` ahead on the same edge."""
        return replace(at, location=at.location + distance * self.direction)

    def end(self, at: EdgePosition[N]) -> EdgePosition[N]:
        """The end of the edge."""
        return self.tip(at.edge, self.direction)

    def tip(self, edge: int, direction: Direction) -> EdgePosition[N]:
        """One end of an edge."""
        length = self.world.length_of(edge)
        return EdgePosition(edge, length if direction is Direction.RIGHT else zero_like(length))

    def look_up(self, edge: int, edge_type: EdgeType) -> int | None:
        """What follows an edge, by (vertex, direction, type); nothing static follows a top."""
        if edge >= self.world.statics:
            return None
        self.world.work.look_ups += 1
        vertex = self.world.graph.edges[edge].towards(self.direction)
        edges = self.world.graph.look_up(vertex, self.direction, edge_type)
        return edges[0] if edges else None

    def beyond(self, at: EdgePosition[N]) -> Beyond[EdgePosition[N]]:
        """The next ground edge, or a ledge: the top of a fall edge, or the corner of a body (R15, R16)."""
        following = self.look_up(at.edge, EdgeType.GROUND)
        if following is not None:
            return Beyond(self.tip(following, self.direction.opposite), ledge=False)
        return Beyond(None, ledge=at.edge >= self.world.statics or self.fall_edge(at.edge) is not None)

    def fall_edge(self, edge: int) -> int | None:
        """The fall edge of which the end of an edge is the top; seen from below a fall edge is a wall (A42)."""
        fall = self.look_up(edge, EdgeType.FALL)
        return fall if fall is not None and self.leads_down(fall) else None

    def leads_down(self, fall: int) -> bool:
        """Whether a fall edge leads down in this direction."""
        rise = self.world.graph.edges[fall].rise * self.direction
        return bool(rise < zero_like(rise))

    def foot(self, at: EdgePosition[N]) -> EdgePosition[N] | None:
        """The beginning of the ground edge after the fall edge, or after several of them, all of which lead down."""
        fall = self.fall_edge(at.edge)
        while fall is not None:
            ground = self.look_up(fall, EdgeType.GROUND)
            if ground is not None:
                return self.tip(ground, self.direction.opposite)
            fall = self.fall_edge(fall)
        return None

    def ahead(self, body: int, front: EdgePosition[N]) -> int | None:
        """The neighbour in this direction, if it is on this edge or the next."""
        self.world.work.queries += 1
        other = self.world.beside(body, self.direction)
        following = self.look_up(front.edge, EdgeType.GROUND)
        if other is None or following is None:
            return other
        in_sight = self.reach(front) + self.world.graph.edges[following].length
        return other if self.gap(front, other) <= in_sight else None

    def gap(self, front: EdgePosition[N], other: int) -> N:
        """Distance to the facing border of a neighbour."""
        facing = self.world.bodies[other].border(self.direction.opposite)
        if self.direction is Direction.RIGHT:
            return self.world.apart(front, facing)
        return self.world.apart(facing, front)

    def pushes(self, body: int) -> bool:
        """Whether the body may push others."""
        return self.world.bodies[body].pushes

    def width(self, body: int) -> N:
        """Distance along the graph between the borders."""
        return self.world.width(body)

    def across(self, start: EdgePosition[N], end: EdgePosition[N]) -> N:
        """Horizontal distance in this direction; on a cylinder the short way round."""
        return self.world.short_way((self.world.point(end)[0] - self.world.point(start)[0]) * self.direction)

    def jumps(self, body: int, at: EdgePosition[N]) -> list[Jump[N, EdgePosition[N]]]:
        """The jump edges from the end of this edge: to tops, and from the corner of a top also to ledges (R15, A54)."""
        support = self.world.support(body)
        own = {body, support} | set(self.riders(body))
        tops = [self.tip(self.world.statics + other, self.direction.opposite) for other in self.world.handles()]
        found = [self.jump(at.edge, top, free=True) for other, top in enumerate(tops) if other not in own]
        if support is not None:
            found += [self.jump(at.edge, near, self.is_free(near, body)) for near in self.ledges()]
        return found

    def jump(self, edge: int, target: EdgePosition[N], free: bool) -> Jump[N, EdgePosition[N]]:
        """The jump edge from the end of an edge to the near end of another."""
        (x, y), back = self.world.tip_point(edge, self.direction), self.direction.opposite
        far_x, far_y = self.world.tip_point(target.edge, back)
        return Jump(target, self.world.short_way((far_x - x) * self.direction), y - far_y, free)

    def riders(self, body: int) -> Iterator[int]:
        """Those that ride on a body, and those that ride on them."""
        waiting = [body]
        while waiting:
            riders = self.world.row_of_edge[self.world.statics + waiting.pop()].order
            yield from riders
            waiting.extend(riders)

    def ledges(self) -> Iterator[EdgePosition[N]]:
        """The ledges that a body moving in this direction may step onto: their ground begins there."""
        back = Facing(self.world, self.direction.opposite)
        for row in self.world.rows:
            edge = row.edges[0 if self.direction is Direction.RIGHT else -1]
            if not row.closed and edge < self.world.statics and back.fall_edge(edge) is not None:
                yield self.tip(edge, self.direction.opposite)

    def is_free(self, near: EdgePosition[N], body: int) -> bool:
        """Whether the first body length from a ledge is free, and a margin more (A54)."""
        room = self.room(near)
        return room is None or bool(room >= self.world.width(body) + self.world.margin)

    def room(self, near: EdgePosition[N]) -> N | None:
        """How far the first body on a string is from the near end of it; None if nobody is there."""
        row = self.world.row_of_edge[near.edge]
        return self.gap(near, row.order[0 if self.direction is Direction.RIGHT else -1]) if row.order else None

    def place(self, body: int, front: EdgePosition[N], rear: EdgePosition[N]) -> None:
        """Put the borders of a body."""
        left, right = (rear, front) if self.direction is Direction.RIGHT else (front, rear)
        self.world.put(body, left, right)


def check_borders(level: Level[N]) -> None:
    """Refuse borders that are on no edge, and margins, ticks, heights and edges that are not greater than 0."""
    zero = zero_like(level.margin)
    for name, value in (("margin", level.margin), ("tick", level.tick)):
        if value <= zero:
            raise LevelError(f"$.{name}", f"expected a number greater than 0, got {value}")
    for index, body in enumerate(level.bodies):
        if body.height <= zero:
            raise LevelError(f"$.bodies[{index}].height", f"expected a number greater than 0, got {body.height}")
        for side, at in (("left", body.left), ("right", body.right)):
            check_edge(level, index, side, at)
        check_top(level, index, body)


def check_top(level: Level[N], index: int, body: Body[N]) -> None:
    """Refuse borders on two tops, or on a top and the ground, and borders on a top that are the wrong way round."""
    if max(body.left.edge, body.right.edge) < len(level.graph.edges):
        return
    if body.left.edge != body.right.edge:
        raise LevelError(f"$.bodies[{index}].right", "expected both borders on the same top")
    if body.left.location >= body.right.location:
        raise LevelError(f"$.bodies[{index}]", WIDE.expected)


def check_edge(level: Level[N], index: int, side: str, at: EdgePosition[N]) -> None:
    """Refuse an edge that is not there, or no ground."""
    statics, place = len(level.graph.edges), f"$.bodies[{index}].{side}"
    if not 0 <= at.edge < statics + len(level.bodies):
        raise LevelError(f"{place}.edge", f"expected 0 to {statics - 1}, got {at.edge}")
    if at.edge < statics and level.graph.edges[at.edge].type is EdgeType.FALL:
        raise LevelError(f"{place}.edge", f"edge {at.edge} is steeper than 60 degrees: expected a ground edge")


def check_supports(level: Level[N]) -> None:
    """Refuse a body that stands, through others, on itself, or on too many."""
    statics = len(level.graph.edges)
    for index, body in enumerate(level.bodies):
        edge, storeys = body.left.edge, 0
        while edge >= statics:
            edge, storeys = level.bodies[edge - statics].left.edge, storeys + 1
            if storeys > MOST_STOREYS:
                expected = f"expected a chain of supports that ends on the ground, at most {MOST_STOREYS} bodies below"
                raise LevelError(f"$.bodies[{index}].left.top", expected)


@dataclass(frozen=True)
class Stance:
    """How bodies may stand: which widths they have, and whether a top also holds one that is wholly beside it, nearer
    than the margin.
    """

    widths: Widths = WIDE
    beside: bool = False


STANDING = Stance()


def check_overhang(world: World[N], body: int, least: N, beside: bool) -> None:
    """Refuse a border beyond the end of its edge where there is no ledge, and a body wholly beyond an edge; a top may
    hold it `beside`, nearer than the margin.
    """
    on_top = beside and world.bodies[body].left.edge >= len(world.graph.edges)
    nearest = least - world.level.margin if on_top else least
    place = f"$.bodies[{body}]"
    overhangs = any(distance < least for distance in world.off_graph(body))
    for direction in Direction if overhangs else ():
        view = world.facing(direction)
        for side, at in (("front", view.front(body)), ("rear", view.rear(body))):
            off, gone = view.reach(at) < least, view.reach(at) <= nearest
            if off and (gone if side == "rear" else not view.beyond(at).ledge):
                name = direction.name.lower() if side == "front" else direction.opposite.name.lower()
                length = world.length_of(at.edge)
                raise LevelError(f"{place}.{name}.location", f"expected 0 to {length}, got {at.location}")


def check_buttons(world: World[N]) -> None:
    """Refuse buttons that are not on ground or on a top, between its ends."""
    for i, at in enumerate(world.level.buttons):
        if at.edge not in world.row_of_edge:
            raise LevelError(f"$.buttons[{i}].edge", f"edge {at.edge} is a fall edge: expected a ground edge")
        length = world.length_of(at.edge)
        if at.location < zero_like(length) or at.location > length:
            raise LevelError(f"$.buttons[{i}].location", f"expected 0 to {length}, got {at.location}")


def standing(level: Level[N], widths: Widths = WIDE, off: N | None = None) -> World[N]:
    """The world of a level in which bodies stand, wherever that is: perhaps within each other, or in a wall.

    `off` is how far its numbers may be off, if they may.

    Raises:
        LevelError: if a body has another width than bodies may have, or stands on nothing.
    """
    world = laid_out(level)
    check_widths(world, widths, zero_like(level.margin) if off is None else off)
    return world


def laid_out(level: Level[N]) -> World[N]:
    """The world of a level whose bodies have both borders on one string of edges each."""
    check_borders(level)
    check_supports(level)
    world = World(level)
    for body, held in enumerate(level.bodies):
        if world.row_of_edge[held.left.edge] is not world.row_of_edge[held.right.edge]:
            expected = f"expected an edge that ground joins to edge {held.left.edge}"
            raise LevelError(f"$.bodies[{body}].right.edge", expected)
    return world


def check_widths(world: World[N], widths: Widths, off: N) -> None:
    """Refuse a body of another width than bodies may have: any, if its left border is left of its right border."""
    for body in world.handles():
        if not widths.has(world.width(body), off):
            raise LevelError(f"$.bodies[{body}]", widths.expected)


def world_of(level: Level[N], tolerance: N | None = None, stance: Stance = STANDING) -> World[N]:
    """The world of a level at its start, whose bodies stand so.

    `tolerance` is how far its numbers may be off, if they may.

    Raises:
        LevelError: if its bodies do not lie on its strings of edges, margin by margin.
    """
    world = laid_out(level)
    least = zero_like(level.margin) if tolerance is None else zero_like(level.margin) - tolerance
    for body in world.handles():
        check_overhang(world, body, least, stance.beside)
    check_buttons(world)
    check_widths(world, stance.widths, zero_like(level.margin) - least)
    for row in world.rows:
        if row.closed and row.free is not None and row.free < least:
            raise LevelError("$.bodies", f"the bodies are wider than the ring by {row.free * -1}")
    for left, right in world.neighbours():
        clear = world.clear(left, right)
        if clear < level.margin + least:
            names = f"{world.bodies[left].name!r} and {world.bodies[right].name!r}"
            raise LevelError(f"$.bodies[{right}]", f"{names} are {clear} apart, less than the margin")
    return world
