"""What the contracts take for granted of a world, on a string of any number of edges and bodies.

What decides a capacity are gaps and walls. They depend on the coordinates of borders, on the length of the string and,
on a ring, on what the bodies leave free of it. A coordinate is the location, and the lengths of all edges before. So
edges that bear no border are summed up, here as one edge before, between or after the ones that do, of any length,
also 0; and the bodies of a ring are summed up as the free space, which is any number that the gap does not exceed.
"""

from __future__ import annotations

from typing import Any

from properties.given import HAS_LENGTH, HAS_WIDTH, Given
from properties.worlds.rows import string_graph
from reference.world import Facing, World
from spec.body import Body, EdgePosition, Level
from spec.conditions import HALVES_LONG, IN_ORDER
from spec.graph import Direction, Vertex
from spec.profiles import Profile
from spec.transform import mirror, split

GAPS_FIT = "the gaps of a ring sum up to its free space"


def any_edge(given: Given, name: str) -> Any:
    """The length of an edge."""
    length = given.number(f"length of {name}")
    given.assume(length > 0, HAS_LENGTH)
    return length


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
    bodies = (Body(chr(65 + i), left, right, margin * 0, margin) for i, (left, right) in enumerate(borders))
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
    given.assume(margin > 0, "the margin is positive")
    first = any_edge(given, "the first edge")
    lengths, edge = [given.number("length of all before"), first], 1
    if not one_edge:
        lengths += [given.number("length of all between"), any_edge(given, "the second edge")]
        edge = 3
    lengths.append(given.number("length of all after"))
    left, right = place(given, "the first border", 1, first), place(given, "the second border", edge, lengths[edge])
    if closed and given.flag("the ring was cut open between them"):
        left, right = right, left
    level = level_of(lengths, closed, margin, (left, right))
    along = coordinate(level, right) - coordinate(level, left)
    round_ = sum(lengths[1:], lengths[0]) if closed and along <= 0 else along * 0
    given.assume(along + round_ > 0, "the second border is after the first")
    return level


def coordinate(level: Level[Any], at: EdgePosition[Any]) -> Any:
    """The lengths of all edges before, and the location."""
    return sum((edge.length for edge in level.graph.edges[: at.edge]), start=at.location)


def check_alike(given: Given, level: Level[Any], other: Level[Any], turned: bool) -> None:
    """Promise that two levels have the same length, and their borders the same coordinates, gaps and walls."""
    free = given.number("free space of the ring")
    one, two = world_with(level, free), world_with(other, free)
    if one.closed:
        given.assume((one.width(0) <= free) & (free < one.rows[0].length), GAPS_FIT)
    given.ensure("the same margin", one.margin == two.margin)
    given.ensure("the same length", one.rows[0].length == two.rows[0].length)
    given.ensure("the same width", one.width(0) == two.width(0))
    given.ensure("the same gap", gap(one) == gap(two))
    for direction in Direction:
        towards = direction.opposite if turned else direction
        along, twin = (held.coordinate(held.bodies[0].border(d)) for held, d in ((one, direction), (two, towards)))
        given.ensure("the same coordinate", twin == (one.rows[0].length - along if turned else along))
        wall, twin_wall = one.to_wall(0, direction), two.to_wall(0, towards)
        given.ensure("the same wall", twin_wall is None if wall is None else wall == twin_wall)


def gap(held: World[Any]) -> Any:
    """The distance between the two borders, as if they were those of neighbours."""
    return held.apart(held.bodies[0].left, held.bodies[0].right)


def lay_out_sums_up(profile: Profile, given: Given, closed: bool, one_edge: bool) -> None:
    """A coordinate is the sum of the lengths before the edge, and the location; the string is as long as its edges."""
    level = two_borders(given, closed, one_edge)
    held = World(level)
    for at in (level.bodies[0].left, level.bodies[0].right):
        given.ensure("the sum before, and the location", held.coordinate(at) == coordinate(level, at))
    lengths = [edge.length for edge in level.graph.edges]
    given.ensure("as long as its edges", held.rows[0].length == sum(lengths[1:], lengths[0]))


def mirror_image_is_alike(profile: Profile, given: Given, closed: bool, one_edge: bool) -> None:
    """The mirror image of any string has the mirrored coordinates, gaps and walls."""
    level = two_borders(given, closed, one_edge)
    check_alike(given, level, mirror(level), turned=True)


def split_is_alike(profile: Profile, given: Given, closed: bool, one_edge: bool, cut: int) -> None:
    """A string with any edge split anywhere has the same coordinates, gaps and walls."""
    level = two_borders(given, closed, one_edge)
    at = given.number("where the edge is split")
    given.assume(at >= level.margin, HALVES_LONG.id)
    given.assume(level.graph.edges[cut].length - at >= level.margin, HALVES_LONG.id)
    check_alike(given, level, split(level, cut, at, Vertex(at, at)), turned=False)


def any_edges(given: Given, closed: bool, last: bool) -> tuple[list[Any], int]:
    """The lengths of any string, an edge of it, and the one that follows it, if it is not the last, by itself.

    On a ring of one edge that one follows itself.
    """
    own = any_edge(given, "the edge")
    if last:
        return ([own], 0) if closed else ([given.number("length of all before"), own], 1)
    onward = any_edge(given, "the next edge")
    if closed and given.flag("the ring begins with the next edge"):
        return [onward, given.number("length of all others"), own], 2
    return [given.number("length of all before"), own, onward, given.number("length of all after")], 1


def border_and_neighbour(given: Given, closed: bool, last: bool) -> Level[Any]:
    """Any border at the front of a body, on any edge, and the border of the body ahead, anywhere.

    Where the rear borders are decides nothing but the order: here they are at the ends of the string.
    """
    margin = given.number("margin")
    given.assume(margin > 0, "the margin is positive")
    lengths, edge = any_edges(given, closed, last)
    front = place(given, "the front", edge, lengths[edge])
    edges = range(len(lengths)) if closed else range(edge, len(lengths))
    other = next((e for e in edges[:-1] if given.flag(f"the body ahead is on edge {e}")), edges[-1])
    facing = place(given, "the body ahead", other, lengths[other])
    rears = EdgePosition(0, margin * 0), EdgePosition(len(lengths) - 1, lengths[-1])
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
        given.assume((view.gap(at, 1) <= free) & (free < held.rows[0].length), GAPS_FIT)
        given.assume(view.gap(at, 1) >= 0, IN_ORDER.id)
    check_steps(given, view, at)
    check_sight(given, view, at)
    check_placing(given, view, at)


def check_steps(given: Given, view: Facing[Any], at: EdgePosition[Any]) -> None:
    """Promise that a step on an edge lessens the distance to its end, and the gap, by the step."""
    reach, gap_now, step = view.reach(at), view.gap(at, 1), given.number("a step")
    given.assume((step <= reach) & (step <= gap_now), "the step is on the edge, and within the gap")
    further = view.along(at, step)
    given.ensure("the end of the edge is reached", view.reach(view.end(at)) == 0)
    given.ensure("it lessens the distance to the end", view.reach(further) == reach - step)
    given.ensure("it lessens the gap", view.gap(further, 1) == gap_now - step)


def check_sight(given: Given, view: Facing[Any], at: EdgePosition[Any]) -> None:
    """Promise where the next edge begins, where the wall is, and who is seen."""
    reach, gap_now, onward = view.reach(at), view.gap(at, 1), view.beyond(at).onward
    wall, ahead = view.world.to_wall(0, view.direction), view.ahead(0, at)
    if wall is not None:
        given.ensure("no body stands behind a wall", gap_now <= wall)
    if onward is None:
        given.ensure("where no edge follows, the wall is the end of the edge", wall == reach)
        given.ensure("on the last edge a body ahead is seen", ahead == 1)
        return
    given.ensure("on this edge and the next a body is seen", (gap_now <= reach + view.reach(onward)) == (ahead == 1))
    given.ensure("the next edge begins at its beginning", view.reach(onward) == view.world.length_of(onward.edge))
    if gap_now >= reach:
        given.ensure("the end of an edge is the beginning of the next", view.gap(onward, 1) == gap_now - reach)


def check_placing(given: Given, view: Facing[Any], at: EdgePosition[Any]) -> None:
    """Promise that placing a body moves no other, and changes no order."""
    before, end = view.world.bodies[1], view.end(at)
    view.place(0, end, view.rear(0))
    given.ensure("it is where it was placed", view.front(0) is end)
    given.ensure("no other body has moved", view.world.bodies[1] is before)
    given.ensure("the body ahead is the same", view.world.beside(0, view.direction) == 1)
