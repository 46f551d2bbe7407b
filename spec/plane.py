"""Invariants in the plane: bodies as boxes above level ground, and solid terrain below it.

They say what the graph cannot see: bodies on different strings of edges, walls, ceilings. A body on a slope has no
box and is left out.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations
from typing import Any, Generic

from spec.graph import EdgeType
from spec.invariants import Deed, Invariant, every
from spec.number import N, Truth, zero_like


@dataclass(frozen=True)
class Box(Generic[N]):
    """An upright rectangle; `bottom` is None where it has no end."""

    left: N
    right: N
    bottom: N | None
    top: N

    def beside(self, other: Box[N]) -> Truth:
        """Whether there is a height that is inside both."""
        above: Any = True if other.bottom is None else self.top > other.bottom
        below: Any = True if self.bottom is None else other.top > self.bottom
        return above & below  # type: ignore[no-any-return]

    def clear_of(self, other: Box[N], distance: N) -> Truth:
        """Whether they are beside each other only at a distance, or not at all beside."""
        apart = (self.right + distance <= other.left) | (other.right + distance <= self.left)
        return apart | negated(self.beside(other))  # type: ignore[no-any-return]


def negated(truth: Any) -> Truth:
    """The opposite of a truth, without deciding it."""
    opposite: Truth = truth == False  # noqa: E712
    return opposite


def box(world: Any, body: int) -> Box[Any] | None:
    """The box of a body that stands level; None on a slope."""
    held = world.bodies[body]
    (left, bottom), (right, right_bottom) = world.point(held.left), world.point(held.right)
    if bottom != right_bottom:
        return None
    circumference = world.graph.circumference
    if circumference is not None and right < left:
        right = right + circumference
    return Box(left, right, bottom, bottom + held.height)


def boxes(world: Any) -> dict[int, Box[Any]]:
    """The boxes of all bodies that have one."""
    found = {body: box(world, body) for body in world.handles()}
    return {body: one for body, one in found.items() if one is not None}


def terrain(world: Any) -> Iterator[Box[Any]]:
    """What is solid under level ground edges."""
    graph = world.graph
    for edge in graph.edges:
        if edge.type is EdgeType.GROUND and edge.rise == 0:
            start = graph.vertices[edge.left]
            bottom = None if edge.thickness is None else start.y - edge.thickness
            yield Box(start.x, start.x + edge.length, bottom, start.y)


def images(world: Any, one: Box[Any]) -> list[Box[Any]]:
    """A box, and on a cylinder its images once round to either side."""
    circumference = world.graph.circumference
    if circumference is None:
        return [one]
    return [Box(one.left + by, one.right + by, one.bottom, one.top) for by in (-circumference, 0, circumference)]


def apart(world: Any, distance: Any) -> Truth:
    """Whether all bodies that are beside each other are at least a distance apart."""
    pairs = combinations(boxes(world).values(), 2)
    return every(one.clear_of(image, distance) for one, other in pairs for image in images(world, other))


def bodies_apart(deed: Deed[N]) -> Truth:
    """No two boxes overlap."""
    return apart(deed.after, zero_like(deed.asked) - deed.tolerance)


def margins_in_plane(deed: Deed[N]) -> Truth:
    """Boxes beside each other keep the margin."""
    return apart(deed.after, deed.after.margin - deed.tolerance)


def outside_terrain(world: Any, tolerance: Any) -> Truth:
    """Whether no box reaches into terrain."""
    return every(
        one.clear_of(image, tolerance * -1)
        for one in boxes(world).values()
        for solid in terrain(world)
        for image in images(world, solid)
    )


def no_terrain_entered(deed: Deed[N]) -> Truth:
    """No box reaches into terrain."""
    return outside_terrain(deed.after, deed.tolerance)


def supports_end(deed: Deed[N]) -> Truth:
    """Every chain of supports ends on the ground."""
    world: Any = deed.after
    for body in world.handles():
        below: int | None = body
        for _ in world.handles():
            below = None if below is None else world.support(below)
        if below is not None:
            return False
    return True


def heights(world: Any, body: int) -> tuple[Any, Any]:
    """How high the borders of a body are."""
    held = world.bodies[body]
    return world.point(held.left)[1], world.point(held.right)[1]


def never_raised(deed: Deed[N]) -> Truth:
    """Over level ground, no request raises anybody."""
    before: Any = deed.before
    pairs = [(heights(deed.after, body), heights(before, body)) for body in before.handles()]
    return every(now <= then + deed.tolerance for after, start in pairs for now, then in zip(after, start, strict=True))


def carriers(world: Any, body: int) -> list[int]:
    """A body and all it stands on."""
    chain = [body]
    for _ in world.bodies:
        below = world.support(chain[-1])
        if below is None:
            break
        chain.append(below)
    return chain


def height_kept(deed: Deed[N]) -> Truth:
    """Over level ground, whoever neither left its string nor stands on one that did is as high as before."""
    before, after = deed.before, deed.after
    truths = []
    for body in before.handles():  # type: ignore[attr-defined]
        chain = carriers(before, body)
        if all(same_string(before, after, held) for held in chain):
            for then, now in zip(heights(before, body), heights(after, body), strict=True):
                truths.append((then - now <= deed.tolerance) & (now - then <= deed.tolerance))
    return every(truths)


def same_string(before: Any, after: Any, body: int) -> bool:
    """Whether a body is on the string it was on."""
    return bool(before.rows.index(before.row(body)) == after.rows.index(after.row(body)))


def horizontal_within(deed: Deed[N]) -> Truth:
    """The mover's borders move horizontally by at most the distance asked."""
    before, after = deed.before, deed.after
    view, zero = before.facing(deed.direction), zero_like(deed.asked)  # type: ignore[attr-defined]
    start, end = view.rear(deed.body), after.facing(deed.direction).rear(deed.body)  # type: ignore[attr-defined]
    went = after.short_way((after.point(end)[0] - before.point(start)[0]) * deed.direction)  # type: ignore[attr-defined]
    return (went <= deed.asked + deed.tolerance) & (went >= zero - deed.tolerance)  # type: ignore[no-any-return]


APART = Invariant(
    "invariant/plane-apart", "In the plane, no two bodies overlap.", "1.2, 6.2.1; R3, R24, U9", bodies_apart
)
PLANE_MARGIN = Invariant(
    "invariant/plane-margin",
    "In the plane, bodies beside each other are at least the collision margin apart.",
    "6.2.1; R24, U9",
    margins_in_plane,
)
TERRAIN = Invariant("invariant/terrain", "No body enters terrain.", "6.2.2; R19, U2, U4, U11", no_terrain_entered)
SUPPORTS_END = Invariant(
    "invariant/supports-end", "Every chain of supports ends on the ground.", "6.1.2; R12, A22", supports_end
)
NEVER_RAISED = Invariant(
    "invariant/never-raised", "Over level ground, no request raises a body.", "abstract, 6.2.1; R25, R32", never_raised
)
HEIGHT_KEPT = Invariant(
    "invariant/height-kept",
    "Over level ground, a body's height changes only when it, or a body it stands on, falls or jumps.",
    "6.2.1d, 6.2.1e; R21, R22",
    height_kept,
)
HORIZONTAL = Invariant(
    "invariant/horizontal",
    "A request moves its body horizontally by at most the distance asked, and not back.",
    "1.2, 6.2.1; R17, R33",
    horizontal_within,
)

IN_PLANE: tuple[Invariant, ...] = (
    APART,
    PLANE_MARGIN,
    TERRAIN,
    SUPPORTS_END,
    NEVER_RAISED,
    HEIGHT_KEPT,
    HORIZONTAL,
)
