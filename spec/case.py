"""What cases are said in: a request seen from each body that it moved, and what that body has run into.

A case is a predicate of a `Deed` and of the rules that fired for its body. `before` and `after` are worlds whose start
was in order, in the graph and in the plane. A body that is pushed is seen as a mover too: see `parts_of`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

from spec.graph import EdgeType
from spec.invariants import Deed
from spec.number import Truth, zero_like
from spec.plane import Box, box, boxes, images, negated, terrain

Fired = frozenset[str]
Part = tuple[Deed[Any], Fired]
"""A request as one of its bodies has fulfilled it, and the rules that fired for that body."""


@dataclass(frozen=True)
class Case:
    """An unsupported case: its sentence, its source, and whether a body has run into it."""

    id: str
    sentence: str
    source: str
    happened: Callable[[Deed[Any], Fired], Truth]

    kind = "unsupported"


def some(truths: Iterable[Truth]) -> Truth:
    """Whether one of them holds, without deciding one after another."""
    result: Any = False
    for truth in truths:
        result = result | truth
    return result  # type: ignore[no-any-return]


def parts_of(deed: Deed[Any], fired: Iterable[tuple[int, str]], asks: Iterable[tuple[int, Any, Any]]) -> list[Part]:
    """A request as each of its bodies has fulfilled it, the mover first.

    `fired` are the rules with their bodies, and `asks` who was asked for how much, and moved how far. Who was asked
    several times in one request has fulfilled the sum.
    """
    rules: dict[int, set[str]] = {deed.body: set()}
    for body, rule in fired:
        rules.setdefault(body, set()).add(rule)
    deeds = {deed.body: deed}
    for body, distance, moved in asks:
        if body != deed.body:
            zero = zero_like(deed.asked)
            known = deeds.get(body, replace(deed, body=body, asked=zero, moved=zero))
            deeds[body] = replace(known, asked=known.asked + distance, moved=known.moved + moved)
    return [(one, frozenset(rules.get(body, ()))) for body, one in deeds.items()]


def ran_into(case: Case, parts: Iterable[Part]) -> Truth:
    """Whether a body of a request has run into a case."""
    return some(case.happened(*part) for part in parts)


def overlap(one: Box[Any], other: Box[Any]) -> Truth:
    """Whether two boxes overlap."""
    return negated(one.clear_of(other, one.left * 0))


def in_terrain(world: Any, bodies: Iterable[int]) -> Truth:
    """Whether one of some bodies reaches into terrain."""
    held = [one for one in (box(world, body) for body in bodies) if one is not None]
    solids = [image for solid in terrain(world) for image in images(world, solid)]
    return some(overlap(one, solid) for one in held for solid in solids)


def terrain_off(world: Any, body: int) -> Iterator[Box[Any]]:
    """What is solid under level ground that is not on a body's string."""
    own = world.row(body).edges
    for number, edge in enumerate(world.graph.edges):
        if edge.type is EdgeType.GROUND and edge.rise == 0 and number not in own:
            start = world.graph.vertices[edge.left]
            bottom = None if edge.thickness is None else start.y - edge.thickness
            yield Box(start.x, start.x + edge.length, bottom, start.y)


def nearer(world: Any, bodies: Iterable[int], others: Iterable[int], distance: Any) -> Truth:
    """Whether one of some bodies is beside one of some others, and nearer than a distance."""
    held, pairs = boxes(world), ((body, other) for body in bodies for other in others)
    return some(
        negated(held[body].clear_of(image, distance))
        for body, other in pairs
        if body in held and other in held
        for image in images(world, held[other])
    )


def all_but(world: Any, bodies: Iterable[int]) -> list[int]:
    """All other bodies."""
    left_out = set(bodies)
    return [body for body in world.handles() if body not in left_out]


def mover_in_terrain(deed: Deed[Any]) -> Truth:
    """Whether the mover's box reaches into terrain."""
    return in_terrain(deed.after, [deed.body])


def mover_in_body(deed: Deed[Any]) -> Truth:
    """Whether the mover's box overlaps that of another body."""
    return nearer(deed.after, [deed.body], all_but(deed.after, [deed.body]), zero_like(deed.asked))


def mover_near_body(deed: Deed[Any]) -> Truth:
    """Whether the mover's box is beside that of another body, nearer than the margin."""
    return nearer(deed.after, [deed.body], all_but(deed.after, [deed.body]), deed.after.margin)


def riders_of(deed: Deed[Any]) -> Sequence[int]:
    """Those that stood on the mover, and those that stood on them."""
    before: Any = deed.before
    return list(before.facing(deed.direction).riders(deed.body))


def landed(fired: Fired) -> bool:
    """Whether the body fell or jumped."""
    return "leave/fall" in fired or "leave/jump" in fired


def on_body(deed: Deed[Any]) -> bool:
    """Whether the mover stood on a body."""
    before: Any = deed.before
    return before.support(deed.body) is not None


def in_overhang(deed: Deed[Any]) -> Truth:
    """Whether the mover's front border ends in overhang."""
    return overhanging(deed.after, deed.body, deed.direction)


def overhanging(world: Any, body: int, direction: Any) -> Truth:
    """Whether a body's border on one side is in overhang."""
    view = world.facing(direction)
    return view.reach(view.front(body)) < world.margin * 0  # type: ignore[no-any-return]
