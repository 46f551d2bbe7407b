"""What the contracts take for granted of a world, on a string of any number of edges and bodies.

What decides a capacity are gaps and walls. They depend on the coordinates of borders, on the length of the string and,
on a ring, on what the bodies leave free of it. A coordinate is the location, and the lengths of all edges before. So
edges that bear no border are summed up, here as one edge before, between or after the ones that do, of any length,
also 0; and the bodies of a ring are summed up as the free space, which is any number that the gap does not exceed.
"""

from __future__ import annotations

from typing import Any

from properties.given import HAS_WIDTH, Given
from properties.worlds.rows import string_graph
from reference.world import Facing, World
from spec.body import Body, EdgePosition, Level
from spec.conditions import HALVES_LONG, IN_ORDER
from spec.graph import Direction, Edge, Graph, Vertex
from spec.profiles import Profile
from spec.transform import mirror, split

GAPS_FIT = "the gaps of a ring sum up to its free space"
SOMEBODY = "the free space of a ring is less than all of it"


def place(given: Given, name: str, edge: int, length: Any) -> EdgePosition[Any]:
    """Any place on an edge."""
    location = given.number(f"place of {name}")
    given.assume(location <= length, "a border is on its edge")
    return EdgePosition(edge, location)


def level_of(
    lengths: list[Any], closed: bool, margin: Any, *borders: tuple[EdgePosition[Any], EdgePosition[Any]]
) -> Level[Any]:
    """Level ground of edges end to end, and bodies with these borders."""
    graph = string_graph(lengths, sum(lengths[1:], lengths[0]) if closed else None)
    bodies = (Body(str(i), left, right, margin * 0, margin) for i, (left, right) in enumerate(borders))
    return Level(graph, margin, margin, tuple(bodies))


def world_with(level: Level[Any], free: Any) -> World[Any]:
    """The world of a level; of a ring so much is free, whoever else is on it."""
    held = World(level)
    if held.closed:
        held.rows[0].free = free
    return held


def two_borders(given: Given, closed: bool, one_edge: bool) -> Level[Any]:
    """Any two borders on any string, on one edge or two; the body that has them also stands for a gap between two."""
    margin = given.number("margin")
    first = given.number("length of the first edge")
    lengths, edge = [given.number("length of all before"), first], 1
    if not one_edge:
        lengths += [given.number("length of all between"), given.number("length of the second edge")]
        edge = 3
    lengths.append(given.number("length of all after"))
    left, right = place(given, "the first border", 1, first), place(given, "the second border", edge, lengths[edge])
    if closed and given.flag("the ring was cut open between them"):
        left, right = right, left
    return level_of(lengths, closed, margin, (left, right))


def coordinate(level: Level[Any], at: EdgePosition[Any]) -> Any:
    """The lengths of all edges before, and the location."""
    return sum((edge.length for edge in level.graph.edges[: at.edge]), start=at.location)


def check_alike(given: Given, level: Level[Any], other: Level[Any], turned: bool) -> None:
    """Promise that two levels have the same length, and their borders the same coordinates, gaps and walls.

    The margin is copied with all else of a level.
    """
    free = given.number("free space of the ring")
    one, two = world_with(level, free), world_with(other, free)
    given.ensure("the same length", one.rows[0].length == two.rows[0].length)
    given.ensure("the same width", one.width(0) == two.width(0))
    given.ensure("the same gap", gap(one) == gap(two))
    for direction in Direction:
        towards = direction.opposite if turned else direction
        along, twin = (held.coordinate(held.bodies[0].border(d)) for held, d in ((one, direction), (two, towards)))
        given.ensure("the same coordinate", twin == (one.rows[0].length - along if turned else along))
        wall, twin_wall = one.to_wall(0, direction), two.to_wall(0, towards)
        given.ensure("the same wall", twin_wall is None if wall is None else wall == twin_wall)


def across(graph: Graph[Any], edge: Edge[Any]) -> Any:
    """How far an edge leads to the right, from vertex to vertex."""
    return graph.vertices[edge.right].x - graph.vertices[edge.left].x


def gap(held: World[Any]) -> Any:
    """The distance between the two borders, as if they were those of neighbours."""
    return held.apart(held.bodies[0].left, held.bodies[0].right)


def lay_out_sums_up(profile: Profile, given: Given, closed: bool, one_edge: bool) -> None:
    """A coordinate is the sum of the lengths before the edge, and the location; the string is as long as its edges.

    A body is as wide, and two borders are as far apart, as it is from the one to the other.
    """
    level = two_borders(given, closed, one_edge)
    held, left, right = World(level), level.bodies[0].left, level.bodies[0].right
    for at in (left, right):
        given.ensure("the sum before, and the location", held.coordinate(at) == coordinate(level, at))
    lengths = [edge.length for edge in level.graph.edges]
    round_, along = sum(lengths[1:], lengths[0]), coordinate(level, right) - coordinate(level, left)
    given.ensure("as long as its edges", held.rows[0].length == round_)
    if closed:
        check_ways_round(given, level, along)
    else:
        given.ensure("as wide as from border to border", held.width(0) == along)
        given.ensure("as far apart as from border to border", gap(held) == along)


def check_ways_round(given: Given, level: Level[Any], along: Any) -> None:
    """Promise that on a ring a body is as wide, and two borders are as far apart, as the way round.

    A gap that is nearer to a whole round than to all free space is an overlap.
    """
    free = given.number("free space of the ring")
    held = world_with(level, free)
    apart, round_ = gap(held), held.rows[0].length
    given.assume(free < round_, SOMEBODY)
    given.ensure(
        "as far apart as some way round", (apart == along) | (apart == along + round_) | (apart == along - round_)
    )
    given.ensure("a gap is nearer to all free space", apart + apart <= free + round_)
    given.ensure("an overlap is nearer to a whole round", apart + apart > free - round_)
    given.assume(along > round_ * -1, "the borders are not the two ends where the ring was cut open")
    given.ensure("as wide as the way round", held.width(0) == (along if along > 0 else along + round_))


def mirror_image_is_alike(profile: Profile, given: Given, closed: bool, one_edge: bool) -> None:
    """The mirror image of any string has the mirrored coordinates, gaps and walls."""
    level = two_borders(given, closed, one_edge)
    other = mirror(level)
    for edge, twin in zip(level.graph.edges, reversed(other.graph.edges), strict=True):
        given.ensure("each edge leads as far across", across(level.graph, edge) == across(other.graph, twin))
    check_alike(given, level, other, turned=True)


def split_is_alike(profile: Profile, given: Given, closed: bool, one_edge: bool, cut: int) -> None:
    """A string with any edge split anywhere has the same coordinates, gaps and walls."""
    level = two_borders(given, closed, one_edge)
    at = given.number("where the edge is split")
    given.assume(at >= level.margin, HALVES_LONG.id)
    given.assume(level.graph.edges[cut].length - at >= level.margin, HALVES_LONG.id)
    other = split(level, cut, at, Vertex(at, at))
    for half in (other.graph.edges[cut], other.graph.edges[-1]):
        given.ensure("each half is as long as the margin", half.length >= level.margin)
    for border in (other.bodies[0].left, other.bodies[0].right):
        if border.edge == len(level.graph.edges):
            given.ensure("who is on the new edge is right of where it was split", border.location > 0)
    check_alike(given, level, other, turned=False)


def any_edges(given: Given, closed: bool, last: bool) -> tuple[list[Any], int]:
    """The lengths of any string, an edge of it, and the one that follows it, if it is not the last, by itself.

    On a ring of one edge that one follows itself.
    """
    own = given.number("length of the edge")
    if last:
        return ([own], 0) if closed else ([given.number("length of all before"), own], 1)
    onward = given.number("length of the next edge")
    if closed and given.flag("the ring begins with the next edge"):
        return [onward, given.number("length of all others"), own], 2
    return [given.number("length of all before"), own, onward, given.number("length of all after")], 1


def border_and_neighbour(given: Given, closed: bool, last: bool) -> Level[Any]:
    """Any border at the front of a body, on any edge, and the border of the body ahead, anywhere.

    Where the rear borders are decides nothing but the order: here they are at the ends of the string.
    """
    margin = given.number("margin")
    lengths, edge = any_edges(given, closed, last)
    front = place(given, "the front", edge, lengths[edge])
    edges = range(len(lengths)) if closed else range(edge, len(lengths))
    other = next((e for e in edges[:-1] if given.flag(f"the body ahead is on edge {e}")), edges[-1])
    facing = place(given, "the body ahead", other, lengths[other])
    rears = EdgePosition(0, margin * 0), EdgePosition(edges[-1], lengths[-1])
    level = level_of(lengths, closed, margin, (rears[0], front), (facing, rears[1]))
    if not closed:
        given.assume(coordinate(level, facing) >= coordinate(level, front), IN_ORDER.id)
        for left, right in ((rears[0], front), (facing, rears[1])):
            given.assume(coordinate(level, right) > coordinate(level, left), HAS_WIDTH)
    return level


def laws_hold(profile: Profile, given: Given, direction: Direction, closed: bool, last: bool) -> None:
    """The laws of `spec.world.View`, at any border, with any body ahead; to the left, in the mirror image."""
    level, free = border_and_neighbour(given, closed, last), given.number("free space of the ring")
    held = world_with(level if direction is Direction.RIGHT else mirror(level), free)
    view, at = held.facing(direction), held.facing(direction).front(0)
    if closed:
        given.assume(free < held.rows[0].length, SOMEBODY)
    check_steps(given, view, at)
    check_sight(given, view, at)
    check_placing(given, view, at)


def check_steps(given: Given, view: Facing[Any], at: EdgePosition[Any]) -> None:
    """Promise that a step within the gap lessens the distance to the end of the edge, and the gap, by the step."""
    reach, gap_now, step = view.reach(at), view.gap(at, 1), given.number("a step")
    given.assume(step <= gap_now, IN_ORDER.id)
    further = view.along(at, step)
    given.ensure("the end of the edge is reached", view.reach(view.end(at)) == 0)
    given.ensure("it lessens the distance to the end", view.reach(further) == reach - step)
    given.ensure("it lessens the gap", view.gap(further, 1) == gap_now - step)


def check_sight(given: Given, view: Facing[Any], at: EdgePosition[Any]) -> None:
    """Promise where the next edge begins, where the wall is, and who is seen."""
    reach, gap_now, onward = view.reach(at), view.gap(at, 1), view.beyond(at).onward
    wall, ahead = view.world.to_wall(0, view.direction), view.ahead(0, at)
    given.ensure("the end of level ground is no ledge", not view.beyond(at).ledge)
    if wall is not None:
        given.ensure("no body stands behind a wall", gap_now <= wall)
    if onward is None:
        given.ensure("where no edge follows, the wall is the end of the edge", wall == reach)
        given.ensure("on the last edge a body ahead is seen", [ahead] == [1])
        return
    in_sight = bool(gap_now <= reach + view.reach(onward))
    given.ensure("on this edge and the next a body is seen", [ahead] == [1 if in_sight else None])
    given.ensure("the next edge begins at its beginning", view.reach(onward) == view.world.length_of(onward.edge))
    if gap_now >= reach:
        given.ensure("the end of an edge is the beginning of the next", view.gap(onward, 1) == gap_now - reach)


def check_placing(given: Given, view: Facing[Any], at: EdgePosition[Any]) -> None:
    """Promise that placing a body moves no other, and changes no order."""
    before, end = view.world.bodies[1], view.end(at)
    view.place(0, end, view.rear(0))
    given.ensure("it is where it was placed", view.front(0) is end)
    given.ensure("no other body has moved", view.world.bodies[1] is before)
    given.ensure("the body ahead is the same", [view.world.beside(0, view.direction)] == [1])
