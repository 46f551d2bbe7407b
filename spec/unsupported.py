"""Unsupported cases: what the thesis says its rules do not support (6.1.3, 6.2.1, 6.2.2, 7.2), as predicates.

`CASES` are those that a request runs into, with those that were found by search (`spec/complications.py`); a level is
of the kinds in `OF_LEVELS`, and from one state to the next a level changes as in `OF_CHANGES`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import combinations
from typing import Any

from spec.case import (
    Case,
    Fired,
    in_overhang,
    landed,
    mover_in_body,
    mover_in_terrain,
    nearer,
    on_body,
    overlap,
    some,
    terrain_off,
)
from spec.complications import FOUND
from spec.graph import EdgeType, Graph
from spec.guidelines import SINGLE_LAYER
from spec.invariants import Deed
from spec.number import Truth
from spec.plane import box, images, negated


def facing_ledges(deed: Deed[Any]) -> list[tuple[Any, Any]]:
    """The ledges ahead of the end of the mover's string: how far across, and how far below it."""
    view = deed.before.facing(deed.direction)  # type: ignore[attr-defined]
    world: Any = deed.before
    edge = world.row(deed.body).edges[-1 if deed.direction > 0 else 0]
    end = view.tip(edge, deed.direction)
    top = world.point(end)[1]
    return [(signed_across(world, end, near) * deed.direction, top - world.point(near)[1]) for near in view.ledges()]


def signed_across(world: Any, start: Any, end: Any) -> Any:
    """Horizontal distance to the right."""
    return world.short_way(world.point(end)[0] - world.point(start)[0])


def short_pit(deed: Deed[Any], fired: Fired) -> Truth:
    """It fell although a ledge at the same height was less than its width away."""
    width, zero = deed.before.width(deed.body), deed.asked * 0
    near = [(across >= zero) & (across < width) & (drop == zero) for across, drop in facing_ledges(deed)]
    return some(near) if "leave/fall" in fired else False


def overhang_into_wall(deed: Deed[Any], fired: Fired) -> Truth:
    """On the ground, its overhang reaches into terrain."""
    stays = not landed(fired) and not on_body(deed)
    return in_overhang(deed) & mover_in_terrain(deed) if stays else False


def overhang_from_body(deed: Deed[Any], fired: Fired) -> Truth:
    """On a body, its overhang reaches into terrain."""
    stays = not landed(fired) and on_body(deed)
    return in_overhang(deed) & mover_in_terrain(deed) if stays else False


def tunnel(deed: Deed[Any], fired: Fired) -> Truth:
    """On the ground and not in overhang, it reaches into terrain."""
    stays = not landed(fired) and not on_body(deed)
    return negated(in_overhang(deed)) & mover_in_terrain(deed) if stays else False


def falls_onto_body(deed: Deed[Any], fired: Fired) -> Truth:
    """It fell into another body."""
    return mover_in_body(deed) if "leave/fall" in fired else False


def ledge_under(deed: Deed[Any]) -> Truth:
    """Whether a ledge that does not lead up begins in the middle of the top on which the mover stood."""
    before: Any = deed.before
    below = before.support(deed.body)
    width, height, zero = before.width(below), before.bodies[below].height, deed.asked * 0
    return some(
        [
            (across < zero) & (across + width > zero) & (drop >= zero) & (drop < height)
            for across, drop in facing_ledges(deed)
        ]
    )


def sharp_ledge(deed: Deed[Any], fired: Fired) -> Truth:
    """It is blocked at the corner of a top, in the middle of which a ledge begins that it could step onto."""
    return ledge_under(deed) if "leave/nowhere" in fired and on_body(deed) else False


def falls_off_body(deed: Deed[Any], fired: Fired) -> Truth:
    """It is blocked at the corner of a top with nothing to step onto."""
    return negated(ledge_under(deed)) if "leave/nowhere" in fired and on_body(deed) else False


def does_not_fit(deed: Deed[Any], fired: Fired) -> Truth:
    """Its landing did not fit before a wall."""
    return "fit/wall" in fired


def other_strings(deed: Deed[Any], fired: Fired) -> Truth:
    """Two bodies on different strings are nearer than the margin, or one reaches into terrain off its string."""
    world: Any = deed.after
    pairs = [pair for pair in combinations(world.handles(), 2) if world.row(pair[0]) is not world.row(pair[1])]
    near = [nearer(world, [one], [other], world.margin) for one, other in pairs]
    return some([*near, *(in_terrain_off(world, body) for body in world.handles())])


def in_terrain_off(world: Any, body: int) -> Truth:
    """Whether a body reaches into terrain that is not under its own string."""
    mine = box(world, body)
    if mine is None:
        return False
    return some(overlap(mine, image) for solid in terrain_off(world, body) for image in images(world, solid))


PRINTED: tuple[Case, ...] = (
    Case("unsupported/short-pit", "A pit narrower than the body swallows it.", "6.6a; U1", short_pit),
    Case(
        "unsupported/short-pit-heights",
        "Over a short pit with a higher far side, the overhang runs into the far wall.",
        "6.6b; U2",
        overhang_into_wall,
    ),
    Case(
        "unsupported/overhang-from-body",
        "From the top of a body, the overhang runs into a wall.",
        "6.6c; U3",
        overhang_from_body,
    ),
    Case("unsupported/tunnel", "A body walks into a tunnel that is lower than the body.", "6.6d; U4", tunnel),
    Case(
        "unsupported/fall-onto-middle",
        "A body falls onto the middle of another body, and comes to stand in it.",
        "6.6e; U5",
        falls_onto_body,
    ),
    Case(
        "unsupported/sharp-ledge",
        "A body does not step onto a ledge that begins in the middle of the top it stands on.",
        "6.6f; U6",
        sharp_ledge,
    ),
    Case("unsupported/fall-off-body", "A body cannot fall off another body.", "7.2; U7, A26", falls_off_body),
    Case("unsupported/landing-does-not-fit", "A landing does not fit before a wall.", "6.2.1d; U11, A16", does_not_fit),
    Case(
        "unsupported/other-strings",
        "A body comes to nearer than the margin to one on another string, or into terrain off its string.",
        "6.2.2; U9",
        other_strings,
    ),
)

CASES: tuple[Case, ...] = (*PRINTED, *FOUND)

GENERAL = "unsupported/other-strings"
"""The case that says only what a body has run into, of which other cases say how."""


@dataclass(frozen=True)
class LevelCase:
    """An unsupported kind of level; `found` says whether a world is one."""

    id: str
    sentence: str
    source: str
    found: Callable[[Any], Truth]

    kind = "unsupported"


def not_by_the_creator(world: Any) -> Truth:
    """The creator from a list of vertices does not make this graph: by steepness, and solid all the way down (R30)."""
    as_made = [edge.thickness is None and is_ground(edge) == by_steepness(edge) for edge in world.graph.edges]
    return negated(SINGLE_LAYER.kept(world)) if all(as_made) else True


def is_ground(edge: Any) -> bool:
    """Whether bodies walk on an edge."""
    return bool(edge.type is EdgeType.GROUND)


def by_steepness(edge: Any) -> bool:
    """Whether an edge is ground by its steepness: at most 60 degrees (A42)."""
    return bool(edge.rise * edge.rise <= 3 * edge.run * edge.run)


OF_LEVELS: tuple[LevelCase, ...] = (
    LevelCase(
        "unsupported/platforms",
        "The creator from a list of vertices makes no floating platforms and no layers; levels that name their edges "
        "have them.",
        "6.1.3; U8, R30",
        not_by_the_creator,
    ),
)


@dataclass(frozen=True)
class ChangeCase:
    """An unsupported change of a level; `found` says whether two graphs, of one state and the next, differ by it."""

    id: str
    sentence: str
    source: str
    found: Callable[[Graph[Any], Graph[Any]], Truth]

    kind = "unsupported"


def terrain_moved(before: Graph[Any], after: Graph[Any]) -> Truth:
    """A vertex is elsewhere, or an edge is another, than before."""
    return (before.vertices, before.edges, before.circumference) != (after.vertices, after.edges, after.circumference)


OF_CHANGES: tuple[ChangeCase, ...] = (
    ChangeCase(
        "unsupported/moving-terrain",
        "Static geometry moves: no state of a level says so, and a trace that does is refused.",
        "4.4; U10",
        terrain_moved,
    ),
)
