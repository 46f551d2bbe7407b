"""What is shown of whole small rows on the reference world itself: who is beside whom, requests from beginning to end.

They repeat, without contracts and with nothing summed up, what is proved of all.
"""

from __future__ import annotations

from typing import Any

from properties.evidence.deeds import do
from properties.given import Given
from properties.worlds.rows import any_level
from reference.world import Facing, World
from spec.body import Level
from spec.graph import Direction, Vertex, extent
from spec.invariants import OF_ONE_REQUEST, every
from spec.profiles import Profile
from spec.transform import mirror, shifted


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
    """An edge leads from one vertex to the other, as far across and up as between the two moved by a vector."""
    left, right, by = (Vertex(given.number(f"{name}.x"), given.number(f"{name}.y")) for name in ("left", "right", "by"))
    shift, moved = given.number("once round"), shifted(left, by)
    across, up = extent(left, right, shift)
    across_after, up_after = extent(moved, shifted(right, by), shift)
    given.ensure("it leads to the other across", left.x + across == right.x + shift)
    given.ensure("it leads to the other up", left.y + up == right.y)
    given.ensure("a vertex is moved across by the vector", moved.x == left.x + by.x)
    given.ensure("a vertex is moved up by the vector", moved.y == left.y + by.y)
    given.ensure("as far across", across == across_after)
    given.ensure("as far up", up == up_after)


def mirror_has_the_same_facts(profile: Profile, given: Given, bodies: int, edges: int, closed: bool) -> None:
    """The mirror image of a row has the mirrored gaps and walls."""
    level = any_level(given, bodies, edges, closed)
    image = mirror(level)
    reversed_row = Level(image.graph, image.margin, image.tick, tuple(reversed(image.bodies)))
    check_same_facts(given, level, reversed_row, turned=True)


def neighbours_are_lawful(profile: Profile, given: Given, bodies: int, edges: int, closed: bool) -> None:
    """The reference world puts bodies in order: the one beside a body is the next, in both directions."""
    held = World(any_level(given, bodies, edges, closed))
    for direction in Direction:
        for body in held.bodies_in_order():
            following = body + direction
            following = following % bodies if closed else following
            expected = following if 0 <= following < bodies else None
            given.ensure("the neighbour is the next in the row", held.beside(body, direction) == expected)


def rows_keep_the_invariants(
    profile: Profile, given: Given, bodies: int, edges: int, closed: bool, direction: Direction, mover: int
) -> None:
    """Any request of a whole row keeps every invariant of one request."""
    held = World(any_level(given, bodies, edges, closed))
    asked = given.number("distance asked")
    deed, _ = do(profile, held, mover, direction, asked, asked * 0)
    for invariant in OF_ONE_REQUEST:
        given.ensure(invariant.id, every([invariant.holds(deed)]))
