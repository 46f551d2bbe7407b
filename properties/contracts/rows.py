"""What is shown of whole rows on the reference world itself: its laws, and requests from beginning to end.

The laws are what the windows of `contracts/request` take for granted of a world. Requests of whole small rows
repeat, without contracts, what the contracts prove of all.
"""

from __future__ import annotations

from typing import Any

from properties.evidence.deeds import do
from properties.given import Given
from properties.worlds.rows import any_level
from reference.world import Facing, World
from spec.body import Level
from spec.conditions import HALVES_LONG
from spec.graph import Direction, Vertex, extent
from spec.invariants import OF_ONE_REQUEST, every
from spec.profiles import Profile
from spec.transform import mirror, shifted, split


def same(a: Any | None, b: Any | None) -> Any:
    """Whether both are absent, or both are there and equal."""
    return a is b if a is None or b is None else a == b


def facts(view: Facing[Any], body: int) -> tuple[Any, Any]:
    """What decides a body's capacity in a direction: the gap to the body ahead, and the distance to the wall."""
    ahead = view.world.beside(body, view.direction)
    gap = None if ahead is None else view.gap(view.front(body), ahead)
    return gap, view.world.to_wall(body, view.direction)


def check_same_facts(given: Given, level: Level[Any], other: Level[Any], turned: bool) -> None:
    """Promise that two levels give every body the same gaps and walls, in either direction."""
    one, two = World(level), World(other)
    last = len(level.bodies) - 1
    for direction in Direction:
        for body in one.bodies_in_order():
            twin = last - body if turned else body
            gap, wall = facts(one.facing(direction), body)
            twin_gap, twin_wall = facts(two.facing(direction.opposite if turned else direction), twin)
            given.ensure(f"{direction.name}: the same gap ahead of body {body}", same(gap, twin_gap))
            given.ensure(f"{direction.name}: the same distance to the wall for body {body}", same(wall, twin_wall))


def translation_keeps_extents(profile: Profile, given: Given) -> None:
    """An edge between two vertices extends as far across and up as between the two moved by a vector."""
    left, right, by = (Vertex(given.number(f"{name}.x"), given.number(f"{name}.y")) for name in ("left", "right", "by"))
    shift = given.number("once round")
    across, up = extent(left, right, shift)
    across_after, up_after = extent(shifted(left, by), shifted(right, by), shift)
    given.ensure("as far across", across == across_after)
    given.ensure("as far up", up == up_after)


def border_keeps_coordinate(profile: Profile, given: Given, bodies: int, edges: int, closed: bool, cut: int) -> None:
    """Splitting an edge keeps the coordinate of any border, and the length of the string."""
    level = any_level(given, bodies, edges, closed)
    at = given.number("where the edge is split")
    given.assume(level.graph.edges[cut].length - at > 0, "the split is on the edge")
    one, two = World(level), World(split(level, cut, at, Vertex(at, at)))
    given.ensure("the same length", one.rows[0].length == two.rows[0].length)
    for direction in Direction:
        border, twin = (held.coordinate(held.bodies[0].border(direction)) for held in (one, two))
        given.ensure("the same coordinate", border == twin)


def mirror_has_the_same_facts(profile: Profile, given: Given, bodies: int, edges: int, closed: bool) -> None:
    """The mirror image of a row has the mirrored gaps and walls."""
    level = any_level(given, bodies, edges, closed)
    image = mirror(level)
    reversed_row = Level(image.graph, image.margin, image.tick, tuple(reversed(image.bodies)))
    check_same_facts(given, level, reversed_row, turned=True)


def split_has_the_same_facts(profile: Profile, given: Given, bodies: int, edges: int, closed: bool) -> None:
    """Splitting the first edge of a row keeps all gaps and walls."""
    level = any_level(given, bodies, edges, closed)
    at = given.number("where the edge is split")
    given.assume(at >= level.margin, HALVES_LONG.id)
    given.assume(level.graph.edges[0].length - at >= level.margin, HALVES_LONG.id)
    check_same_facts(given, level, split(level, 0, at, Vertex(at, at)), turned=False)


def world_is_lawful(profile: Profile, given: Given, bodies: int, edges: int, closed: bool) -> None:
    """The reference world keeps the laws of `spec.world.View`, in both directions."""
    held = World(any_level(given, bodies, edges, closed))
    for direction in Direction:
        view = held.facing(direction)
        for body in held.bodies_in_order():
            check_laws(given, view, body)


def steps_are_lawful(profile: Profile, given: Given, bodies: int, edges: int, closed: bool) -> None:
    """A step on an edge lessens the distance to its end, and the gap to the body ahead, by the step."""
    view = World(any_level(given, bodies, edges, closed)).facing(Direction.RIGHT)
    step, at = given.number("a step on the edge"), view.front(0)
    given.assume(step <= view.reach(at), "the step is on the edge")
    further, other = view.along(at, step), view.world.beside(0, Direction.RIGHT)
    given.ensure("it lessens the distance to the end", view.reach(further) == view.reach(at) - step)
    assert other is not None
    given.assume(step <= view.gap(at, other), "the step is within the gap")
    given.ensure("it lessens the gap", view.gap(further, other) == view.gap(at, other) - step)


def check_laws(given: Given, view: Facing[Any], body: int) -> None:
    """Promise the laws at one border."""
    at, step = view.front(body), view.reach(view.front(body))
    given.ensure("a border is on its edge", (step >= 0) & (view.along(at, step).location == view.end(at).location))
    onward = view.beyond(at).onward
    other = view.world.beside(body, view.direction)
    wall = view.world.to_wall(body, view.direction)
    if onward is None:
        given.ensure("where no edge follows, the wall is the end of the edge", same(wall, step))
    if other is None:
        return
    gap = view.gap(at, other)
    given.ensure("a valid start keeps the margin", gap >= view.margin)
    if onward is not None and gap > step:
        given.ensure("the end of an edge is the beginning of the next", view.gap(onward, other) == gap - step)
    if onward is None:
        given.ensure("on the last edge a body ahead is seen", view.ahead(body, at) == other)
    else:
        in_sight = view.ahead(body, at) is not None
        given.ensure("on this edge and the next a body is seen", (gap <= step + view.reach(onward)) == in_sight)
    if wall is not None:
        given.ensure("no body stands behind a wall", gap < wall)


def rows_keep_the_invariants(
    profile: Profile, given: Given, bodies: int, edges: int, closed: bool, direction: Direction, mover: int
) -> None:
    """Any request of a whole row keeps every invariant of one request."""
    held = World(any_level(given, bodies, edges, closed))
    asked = given.number("distance asked")
    deed, _ = do(profile, held, mover, direction, asked, asked * 0)
    for invariant in OF_ONE_REQUEST:
        given.ensure(invariant.id, every([invariant.holds(deed)]))
