"""The plan of a level: its storeys, made from its graph, and the way back from places on storeys to edge positions.

A level of the graph is one of storeys if all its bodies have one height, its ground is level, at multiples of that
above a closed floor, and its terrain is solid in whole storeys. Any other is refused, with the place in the way.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any, Generic, cast

from reference.storeys import Place, StoreyWorld, Terrain
from reference.world import LevelError, Row, World
from spec.body import Body, EdgePosition, Level
from spec.graph import Direction, Edge, EdgeType
from spec.number import N, greater, lesser, zero_like
from spec.storeys import Interval, once_round


@dataclass(frozen=True)
class String(Generic[N]):
    """A string of ground edges on a storey: where it begins in the plane, and its edges laid end to end."""

    storey: int
    start: N
    row: Row[N]


@dataclass(frozen=True)
class Plan(Generic[N]):
    """A level, the terrain of its storeys, and the strings of its graph on them, from left to right."""

    level: Level[N]
    terrain: Terrain[N]
    strings: tuple[String[N], ...]

    def start(self) -> StoreyWorld[N]:
        """The bodies on their storeys, where the level has them."""
        world = World(self.level)
        places = [self.place(world, body) for body in world.handles()]
        return StoreyWorld(self.terrain, self.level.margin, places)

    def place(self, world: World[N], body: int) -> Place[N]:
        """Where a body of a world of edge positions stands."""
        held = world.bodies[body]
        left, height = world.point(held.left)
        round_ = self.terrain.circumference
        left = left if round_ is None else once_round(left, round_)
        return Place(self.storey_at(height), left, world.width(body), world.support(body), held.pushes)

    def storey_at(self, height: N) -> int:
        """The storey of a height."""
        return storey_of(self.level, height)

    def bodies(self, world: StoreyWorld[N]) -> tuple[Body[N], ...]:
        """The bodies of the level with their borders where they are on the storeys."""
        return tuple(self.body(world, body, held) for body, held in enumerate(self.level.bodies))

    def body(self, world: StoreyWorld[N], body: int, held: Body[N]) -> Body[N]:
        """A body with its borders as edge positions on the top, or the string of edges, that it stands on."""
        place = world.places[body]
        if place.support is not None:
            top, offset = len(self.level.graph.edges) + place.support, world.offset(body, place.support)
            return replace(held, left=EdgePosition(top, offset), right=EdgePosition(top, offset + place.width))
        string, along = self.under(place)
        return replace(
            held,
            left=edge_position(string.row, along, Direction.LEFT),
            right=edge_position(string.row, along + place.width, Direction.RIGHT),
        )

    def under(self, place: Place[N]) -> tuple[String[N], N]:
        """The first string under a body on the ground, and where along it its left border is.

        In floats a body may have come off its ground by a rounding: then the string that it is nearest to.
        """
        strings = [string for string in self.strings if string.storey == place.storey]
        found = [(string, along) for string in strings for along in self.alongs(string, place)]
        best = found[0]
        for one in found:
            if overlap(*one, place) > zero_like(place.left):
                return one
            if overlap(*one, place) > overlap(*best, place):
                best = one
        return best

    def alongs(self, string: String[N], place: Place[N]) -> Iterator[N]:
        """Where along a string a body's left border is; on a ring there are two ways to see it."""
        along, round_ = place.left - string.start, self.terrain.circumference
        if round_ is None:
            yield along
        else:
            along = once_round(along, round_)
            yield along
            yield along - round_


def overlap(string: String[N], along: N, place: Place[N]) -> N:
    """How much of a body is over a string along which its left border is so far; less than 0 beside it."""
    return lesser(along + place.width, string.row.length) - greater(along, zero_like(along))


def edge_position(row: Row[N], along: N, side: Direction) -> EdgePosition[N]:
    """A place along a string as an edge position; at a vertex a border is on the edge that its body is on (A57).

    Beyond the ends of the string it overhangs the last edge there.
    """
    if row.closed and along >= row.length and (side is Direction.LEFT or along > row.length):
        along = along - row.length
    last = row.edges[-1]
    for edge, following in zip(row.edges, [*row.edges[1:], None], strict=True):
        end = row.length if following is None else row.offsets[following]
        if along < end or (side is Direction.RIGHT and along <= end) or edge == last:
            return EdgePosition(edge, along - row.offsets[edge])
    raise AssertionError("a string has edges")


def base_of(level: Level[N]) -> N:
    """The height of the lowest ground: the floor."""
    heights = [height_of(level, edge) for edge in grounds_of(level)]
    lowest = heights[0]
    for height in heights:
        lowest = lesser(lowest, height)
    return lowest


def grounds_of(level: Level[N]) -> list[Edge[N]]:
    """The ground edges of a level."""
    return [edge for edge in level.graph.edges if edge.type is EdgeType.GROUND]


def begins(level: Level[N], edge: Edge[N]) -> N:
    """Where an edge begins; on a cylinder counted once round."""
    x, round_ = level.graph.vertices[edge.left].x, level.graph.circumference
    return x if round_ is None else once_round(x, round_)


def ends(level: Level[N], edge: Edge[N]) -> N:
    """Where an edge ends: exactly where the next begins, in floats too; on a cylinder maybe beyond once round."""
    x, round_ = level.graph.vertices[edge.right].x, level.graph.circumference
    if round_ is None:
        return x
    end = once_round(x, round_)
    return end if end > begins(level, edge) else end + round_


def height_of(level: Level[N], edge: Edge[N]) -> N:
    """How high a level edge is."""
    return level.graph.vertices[edge.left].y


def storey_of(level: Level[N], height: N) -> int:
    """The storey of a height: in floats the nearest."""
    storeys: Any = (height - base_of(level)) / level.bodies[0].height
    return int(storeys.__round__())


def plan_of(level: Level[N]) -> Plan[N]:
    """The plan of a level that is one of storeys, in exact numbers or in floats."""
    world = World(level)
    strings = []
    for row in world.rows:
        if row.edges[0] < world.statics:
            first = level.graph.edges[row.edges[0]]
            strings.append(String(storey_of(level, height_of(level, first)), begins(level, first), row))
    strings.sort(key=lambda string: string.start)
    return Plan(level, terrain_of(level), tuple(strings))


def terrain_of(level: Level[N]) -> Terrain[N]:
    """What is solid on each storey of a level."""
    round_ = level.graph.circumference
    top = max(storey_of(level, height_of(level, edge)) for edge in grounds_of(level))
    solid = [merged(solids(level, storey), round_) for storey in range(top)]
    return Terrain(tuple(solid), None if round_ is not None else ends_of(level), round_)


def ends_of(level: Level[N]) -> Interval[N]:
    """Where the ground of a level begins and ends."""
    places = [level.graph.vertices[vertex].x for edge in grounds_of(level) for vertex in (edge.left, edge.right)]
    left = right = places[0]
    for place in places:
        left, right = lesser(left, place), greater(right, place)
    return Interval(left, right)


def solids(level: Level[N], storey: int) -> Iterator[Interval[N]]:
    """The ground edges whose terrain fills a storey, from left to right; -1 is what is below the floor."""
    for edge in sorted(grounds_of(level), key=lambda edge: begins(level, edge)):
        left, height = begins(level, edge), height_of(level, edge)
        lowest = -1 if edge.thickness is None else storey_of(level, height - edge.thickness)
        if lowest <= storey < storey_of(level, height):
            yield Interval(left, ends(level, edge))


def merged(intervals: Iterable[Interval[N]], circumference: N | None) -> tuple[Interval[N], ...]:
    """Intervals, given by their left ends in order, as few as cover the same; on a ring also across its seam."""
    found: list[Interval[N]] = []
    for one in intervals:
        if found and one.left <= found[-1].right:
            found[-1] = Interval(found[-1].left, greater(found[-1].right, one.right))
        else:
            found.append(one)
    if circumference is not None and len(found) > 1 and found[-1].right >= found[0].left + circumference:
        found = [*found[1:-1], Interval(found[-1].left, found[0].right + circumference)]
    return tuple(found)


def without(level: Level[N], body: int) -> Level[N]:
    """The level without a body. Tops are numbered anew for its buttons; where bodies are is as it was."""
    top = len(level.graph.edges) + body
    rest = tuple(held for other, held in enumerate(level.bodies) if other != body)
    buttons = tuple(replace(at, edge=at.edge - (at.edge > top)) for at in level.buttons)
    return replace(level, bodies=rest, buttons=buttons)


def check_plan(level: Level[Fraction]) -> None:
    """Refuse a level that is not one of storeys.

    Raises:
        LevelError: with the first place that is in the way, and what is expected there.
    """
    check_sizes(level)
    for index, edge in enumerate(level.graph.edges):
        check_edge(level, index, edge)
    check_floor(level)
    check_walls(level)
    check_ends(level)
    check_bodies(level)


def check_sizes(level: Level[Fraction]) -> None:
    """Refuse bodies of several heights, or not wider than the margin."""
    if not level.bodies:
        raise LevelError("$.bodies", "expected a body: its height is that of a storey")
    world = World(level)
    for index in range(len(level.bodies)):
        check_size(level, world, index)


def check_size(level: Level[N], world: World[N], index: int) -> None:
    """Refuse a body of another height than the first, or not wider than the margin."""
    height, expected = level.bodies[index].height, level.bodies[0].height
    if height != expected:
        problem = f"expected {expected}, the height of the first body, got {height}"
        raise LevelError(f"$.bodies[{index}].height", problem)
    if world.width(index) <= level.margin:
        raise LevelError(f"$.bodies[{index}]", f"expected a width greater than the margin, {level.margin}")


def check_edge(level: Level[Fraction], index: int, edge: Edge[Fraction]) -> None:
    """Refuse slopes, slanted fall edges, ground between two storeys, and terrain that fills part of one."""
    place, height = f"$.vertices[{edge.left}]", level.bodies[0].height
    if edge.type is EdgeType.FALL:
        if edge.run:
            raise LevelError(place, f"expected fall edge {index}, which begins here, to be vertical")
        return
    if edge.rise:
        raise LevelError(place, f"expected ground edge {index}, which begins here, to be level, got one that rises")
    up = height_of(level, edge) - base_of(level)
    if up % height:
        raise LevelError(f"{place}.y", f"expected a multiple of {height}, a body's height, above the floor, got {up}")
    if edge.thickness is not None and (edge.thickness % height or not edge.thickness):
        place = f"$.edges[{index}].thickness"
        raise LevelError(place, f"expected a multiple of {height}, the height of a body, got {edge.thickness}")


def check_floor(level: Level[Fraction]) -> None:
    """Refuse a level in which one could fall for ever."""
    floor = merged(solids(level, -1), level.graph.circumference)
    if level.graph.circumference is not None:
        closed = len(floor) == 1 and floor[0].right - floor[0].left >= level.graph.circumference
    else:
        closed = len(floor) == 1 and floor[0] == ends_of(level)
    if not closed:
        where = f"between {floor[0].right} and {floor[1].left}" if len(floor) > 1 else "at an end"
        raise LevelError("$.vertices", f"expected a closed floor, there is none {where}")


def check_walls(level: Level[Fraction]) -> None:
    """Refuse walls thinner than the margin: bodies on both sides would be nearer to each other than that."""
    for storey in plan_of(level).terrain.solid:
        for wall in storey:
            if wall.right - wall.left < level.margin:
                edges = [edge for edge in grounds_of(level) if begins(level, edge) == wall.left]
                vertex = max(edges, key=lambda edge: height_of(level, edge)).left
                expected = f"expected a wall at least as thick as the margin, got {wall.right - wall.left}"
                raise LevelError(f"$.vertices[{vertex}]", expected)


def check_ends(level: Level[Fraction]) -> None:
    """Refuse ground that ends in the open without a fall edge: in the graph that is a wall, on storeys it is none."""
    plan = plan_of(level)
    world = World(level)
    for string in plan.strings:
        for direction in Direction if not string.row.closed else ():
            edge = string.row.edges[-1 if direction is Direction.RIGHT else 0]
            x = string.start + (string.row.length if direction is Direction.RIGHT else 0)
            if world.facing(direction).fall_edge(edge) is None and is_open(plan, string.storey, x, direction):
                vertex = level.graph.edges[edge].towards(direction)
                raise LevelError(f"$.vertices[{vertex}]", open_end(level, vertex, direction))


def open_end(level: Level[Fraction], vertex: int, direction: Direction) -> str:
    """What is expected where ground ends in the open: a fall edge that leaves in that direction."""
    expected = (
        f"ground ends to the {direction.name.lower()} in the open: expected a fall edge that leads down from here"
    )
    for index, edge in enumerate(level.graph.edges):
        if edge.type is EdgeType.FALL and vertex in (edge.left, edge.right):
            return f"{expected}; fall edge {index} is there, with its left and right vertex the wrong way round"
    return f"{expected}, or terrain beyond"


def is_open(plan: Plan[Fraction], storey: int, x: Fraction, direction: Direction) -> bool:
    """Whether there is no wall just beyond a place."""
    terrain = plan.terrain
    if terrain.ends is not None and x == (terrain.ends.right if direction is Direction.RIGHT else terrain.ends.left):
        return False
    for solid in terrain.on(storey):
        side = solid.left if direction is Direction.RIGHT else solid.right
        around = [x] if terrain.circumference is None else [x, x + terrain.circumference, x - terrain.circumference]
        if side in around or any(solid.left < image < solid.right for image in around):
            return False
    return True


def check_bodies(level: Level[Fraction]) -> None:
    """Refuse bodies in terrain, or nearer to each other than the margin."""
    world = plan_of(level).start()
    for body in range(len(level.bodies)):
        check_outside(world, body)
    check_places(level, world)
    for left, right in world.neighbours():
        check_apart(level, world, left, right, right)


def check_places(level: Level[N], world: StoreyWorld[N]) -> None:
    """Refuse two bodies at one place."""
    for left, right in world.at_one_place():
        names = f"{level.bodies[left].name!r} and {level.bodies[right].name!r}"
        raise LevelError(f"$.bodies[{max(left, right)}]", f"{names} are at one place")


def check_outside(world: StoreyWorld[N], body: int) -> None:
    """Refuse a body in terrain."""
    rooms = [world.to_wall(body, direction) for direction in Direction]
    if world.in_terrain(body) or any(room is not None and room < zero_like(room) for room in rooms):
        raise LevelError(f"$.bodies[{body}]", "expected a body outside all terrain")


def check_apart(level: Level[N], world: StoreyWorld[N], left: int, right: int, at: int) -> None:
    """Refuse neighbours nearer to each other than the margin, by more than roundings in floats; the place is of one."""
    if world.gap(left, right) < level.margin - roundings(level.margin):
        names = f"{level.bodies[left].name!r} and {level.bodies[right].name!r}"
        raise LevelError(f"$.bodies[{at}]", f"{names} are {world.gap(left, right)} apart, less than the margin")


def roundings(margin: N) -> N:
    """What the gap between two bodies may be short of the margin in floats; 0 on exact numbers."""
    return cast(N, margin / 2**20) if isinstance(margin, float) else zero_like(margin)


def check_added(level: Level[N], world: StoreyWorld[N]) -> None:
    """Refuse a last body that another would not leave room for; the others are as a step has left them.

    Raises:
        LevelError: if its height or width, or its place, is not as it must be.
    """
    body = len(level.bodies) - 1
    check_size(level, World(level), body)
    check_outside(world, body)
    check_places(level, world)
    for left, right in world.neighbours():
        if body in (left, right):
            check_apart(level, world, left, right, body)
