"""The shapes of a world in its plane, as pictures need them: exact numbers, unrolled where the level is a cylinder."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from itertools import pairwise
from math import ceil, floor
from typing import Any

from reference.world import World
from spec.body import EdgePosition
from spec.graph import Direction, EdgeType
from spec.plane import carriers

Point = tuple[Fraction, Fraction]
Range = tuple[Fraction, Fraction]


@dataclass(frozen=True)
class Outline:
    """A body in the plane: what it stands on from its left to its right border, and its height straight above."""

    body: int
    bottom: tuple[Point, ...]
    height: Fraction

    @cached_property
    def left(self) -> Fraction:
        """Where it begins."""
        return min(x for x, _ in self.bottom)

    @cached_property
    def right(self) -> Fraction:
        """Where it ends."""
        return max(x for x, _ in self.bottom)

    @cached_property
    def low(self) -> Fraction:
        """Its lowest point."""
        return min(y for _, y in self.bottom)

    @cached_property
    def top(self) -> tuple[Point, Point]:
        """The line from its left to its right upper corner."""
        (x, y), (far_x, far_y) = self.bottom[0], self.bottom[-1]
        return (x, y + self.height), (far_x, far_y + self.height)

    @cached_property
    def high(self) -> Fraction:
        """Its highest point."""
        return max(y for _, y in (*self.top, *self.bottom))

    def shifted(self, by: Fraction) -> Outline:
        """Its image to the right."""
        return self if by == 0 else replace(self, bottom=tuple((x + by, y) for x, y in self.bottom))


@dataclass(frozen=True)
class Segment:
    """A static edge in the plane."""

    edge: int
    type: EdgeType
    start: Point
    end: Point
    thickness: Fraction | None

    def clipped(self, left: Fraction, right: Fraction) -> Segment:
        """The part of it from `left` to `right`; one that is vertical is whole."""
        (x, y), (far_x, far_y) = self.start, self.end
        if far_x <= x:
            return self
        slope = (far_y - y) / (far_x - x)
        begin, stop = max(x, left), min(far_x, right)
        return replace(self, start=(begin, y + (begin - x) * slope), end=(stop, y + (stop - x) * slope))

    def shifted(self, by: Fraction) -> Segment:
        """Its image to the right."""
        (x, y), (far_x, far_y) = self.start, self.end
        return replace(self, start=(x + by, y), end=(far_x + by, far_y))


@dataclass(frozen=True)
class Window:
    """The part of the plane that a picture shows; `whole` is how far the level goes from left to right."""

    left: Fraction
    right: Fraction
    bottom: Fraction
    top: Fraction
    whole: Range

    @property
    def cropped(self) -> bool:
        """Whether some of the level is to the left or right of it."""
        return (self.left, self.right) != self.whole


def within(points: Sequence[Point], left: Fraction, right: Fraction) -> list[Point]:
    """The part of a line, which goes to the right, from `left` to `right`; empty if there is none."""
    found: list[Point] = []
    for start, end in pairwise(points):
        if end[0] >= left and start[0] <= right:
            part = Segment(0, EdgeType.GROUND, start, end, None).clipped(left, right)
            found += [part.end] if found else [part.start, part.end]
    return found


def place_of(world: World[Any], at: EdgePosition[Any]) -> Point:
    """Where a position is, in exact numbers."""
    x, y = world.point(at)
    return Fraction(x), Fraction(y)


def way(world: World[Any], near: EdgePosition[Any], far: EdgePosition[Any]) -> tuple[Point, ...]:
    """The line from a position to one further right on its string, round the cylinder if need be."""
    start, stop = place_of(world, near), place_of(world, far)
    row = world.row_of_edge[near.edge]
    straight = near.edge == far.edge and (near.location <= far.location or not row.closed)
    if straight or world.row_of_edge[far.edge] is not row:
        return start, stop
    first, ahead = row.edges.index(near.edge), segment_of(world, near.edge)
    points, shift = [start, ahead.end], Fraction(0)
    for edge in row.edges[first + 1 :] + (row.edges[: first + 1] if row.closed else []):
        segment = segment_of(world, edge)
        shift = points[-1][0] - segment.start[0]
        if edge == far.edge:
            return (*points, (stop[0] + shift, stop[1]))
        points.append(segment.shifted(shift).end)
    return start, stop


def outline(world: World[Any], body: int) -> Outline:
    """A body in the plane."""
    held = world.bodies[body]
    return Outline(body, way(world, held.left, held.right), Fraction(held.height))


def outlines(world: World[Any]) -> list[Outline]:
    """All bodies in the plane."""
    return [outline(world, body) for body in world.handles()]


def segment_of(world: World[Any], index: int) -> Segment:
    """A static edge in the plane; on a cylinder its end may be once round."""
    edge = world.graph.edges[index]
    start, end = world.graph.vertices[edge.left], world.graph.vertices[edge.right]
    x, far_x = Fraction(start.x), Fraction(end.x)
    round_ = world.graph.circumference
    if round_ is not None and (far_x < x or edge.left == edge.right):
        far_x += Fraction(round_)
    thickness = None if edge.thickness is None else Fraction(edge.thickness)
    return Segment(index, edge.type, (x, Fraction(start.y)), (far_x, Fraction(end.y)), thickness)


def segments(world: World[Any]) -> list[Segment]:
    """All static edges in the plane."""
    return [segment_of(world, index) for index in range(world.statics)]


def images(world: World[Any], reach: Range, window: Range) -> Iterator[Fraction]:
    """How far to shift what goes from left to right so that it is in a window: 0, or on a cylinder what is needed."""
    round_ = world.graph.circumference
    if round_ is None:
        if reach[1] >= window[0] and reach[0] <= window[1]:
            yield Fraction(0)
        return
    once = Fraction(round_)
    for times in range(ceil((window[0] - reach[1]) / once), floor((window[1] - reach[0]) / once) + 1):
        yield times * once


def walls(world: World[Any]) -> Iterator[tuple[Point, Direction]]:
    """The ends of strings at which no ledge is and no cliff begins, and on which side of the string they are."""
    for row in world.rows:
        for direction in Direction:
            edge = row.edges[-1 if direction is Direction.RIGHT else 0]
            view = world.facing(direction)
            if edge >= world.statics or row.closed or view.look_up(edge, EdgeType.FALL) is not None:
                continue
            segment = segment_of(world, edge)
            yield (segment.end if direction is Direction.RIGHT else segment.start), direction


def jump_edges(world: World[Any]) -> Iterator[tuple[Point, Point, Direction]]:
    """The jump edges from ledges and from tops with riders that are shorter than the widest body and not upward."""
    widest = max((world.width(body) for body in world.handles()), default=world.margin)
    for direction in Direction:
        view = world.facing(direction)
        for row in world.rows:
            end = view.tip(row.edges[-1 if direction is Direction.RIGHT else 0], direction)
            if row.closed or not view.beyond(end).ledge or (end.edge >= world.statics and not row.order):
                continue
            x, y = (Fraction(number) for number in world.tip_point(end.edge, direction))
            for jump in leads(world, end, direction):
                if 0 <= jump.across < widest and jump.drop >= 0 and (jump.across or jump.drop):
                    yield (x, y), (x + Fraction(jump.across) * direction, y - Fraction(jump.drop)), direction


def leads(world: World[Any], end: EdgePosition[Any], direction: Direction) -> Iterator[Any]:
    """The jump edges from a ledge, or from the corner of a top, for the first of its riders, to what is beside it."""
    view = world.facing(direction)
    if end.edge < world.statics:
        for body in world.handles():
            yield view.jump(end.edge, view.tip(world.statics + body, direction.opposite), free=True)
        return
    rider = world.row_of_edge[end.edge].order[0]
    below = {world.statics + body for body in carriers(world, rider)}
    yield from (jump for jump in view.jumps(rider, end) if jump.target.edge not in below)


def unit_of(world: World[Any]) -> Fraction:
    """The width of a middling body: what pictures are measured by."""
    widths = sorted(abs(Fraction(world.width(body))) for body in world.handles())
    if widths and widths[(len(widths) - 1) // 2] > 0:
        return widths[(len(widths) - 1) // 2]
    return max(segment.end[0] - segment.start[0] for segment in segments(world)) / 8 or Fraction(1)


def range_of(values: Iterable[Fraction]) -> Range:
    """The least and the greatest."""
    numbers = list(values)
    return min(numbers), max(numbers)


def cropped(whole: Range, bodies: Range, asked: Range, most: Fraction) -> Range:
    """At most so much of a whole: if it is too long what the bodies take up, or from a little before who was asked.

    It is up to four times as much where those who were asked go so far.
    """
    most = max(most, min((asked[1] - asked[0]) * 5 / 4, 4 * most))
    if whole[1] - whole[0] <= most:
        return whole
    room = most / 20
    near = max(whole[0], bodies[0] - room), min(whole[1], bodies[1] + room)
    if near[1] - near[0] <= most:
        return near
    start = max(whole[0], min(asked[0] - most / 4, whole[1] - most))
    return start, start + most


def window_of(worlds: Sequence[World[Any]], asked: set[str], most: int) -> Window:
    """What a picture of some worlds of one level shows: all of it, or a part at most so many middling bodies long."""
    first, longest = worlds[0], unit_of(worlds[0]) * most
    edges, named = segments(first), [(world.bodies[one.body].name, one) for world in worlds for one in outlines(world)]
    places = ends([shape for _, shape in named], first)
    whole = range_of([x for edge in edges for x in (edge.start[0], edge.end[0])] + places)
    if first.graph.circumference is not None:
        start = min(Fraction(vertex.x) for vertex in first.graph.vertices)
        whole = start, start + Fraction(first.graph.circumference)
        named = [(name, one.shifted(by)) for name, one in named for by in images(first, (one.left, one.left), whole)]
    shapes = [shape for _, shape in named]
    movers = [shape for name, shape in named if name in asked] or shapes[:1]
    sides = cropped(whole, range_of(ends(shapes, first) or whole), range_of(ends(movers, first) or whole), longest)
    heights = [y for edge in edges for y in levels(first, edge, sides)]
    heights += [y for shape in shapes if shape.right >= sides[0] and shape.left <= sides[1] for y in storey(shape)]
    seen, moved = storeys(shapes) or heights, storeys(movers) or heights
    up = cropped(range_of(heights), range_of(seen), range_of(moved), longest / 2)
    return Window(*sides, *up, whole)


def ends(shapes: list[Outline], world: World[Any]) -> list[Fraction]:
    """Where bodies begin and end."""
    return [x for shape in shapes for x in (shape.left, shape.right)]


def storey(shape: Outline) -> Range:
    """How low and how high a body is."""
    return shape.low, shape.high


def storeys(shapes: list[Outline]) -> list[Fraction]:
    """How low and how high bodies are."""
    return [y for shape in shapes for y in storey(shape)]


def levels(world: World[Any], edge: Segment, sides: Range) -> Iterator[Fraction]:
    """How high the ends of an edge are, or of what is seen of it."""
    for by in images(world, (edge.start[0], edge.end[0]), sides):
        part = edge.shifted(by).clipped(*sides)
        yield from (part.start[1], part.end[1])
        if part.type is EdgeType.GROUND and part.thickness is not None:
            yield min(part.start[1], part.end[1]) - part.thickness
