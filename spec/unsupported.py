"""Unsupported cases (6.2.2, 7.2): each a predicate that says whether a request has run into it.

`before` and `after` are worlds whose start was in order, in the graph and in the plane; `fired` are the rules that
fired for the mover.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from spec.invariants import Deed
from spec.number import Truth
from spec.plane import Box, box, boxes, heights, images, negated, terrain


@dataclass(frozen=True)
class Case:
    """An unsupported case: its sentence, its source, and whether a request has run into it."""

    id: str
    sentence: str
    source: str
    happened: Callable[[Deed[Any], frozenset[str]], Truth]

    kind = "unsupported"


def some(truths: list[Truth]) -> Truth:
    """Whether one of them holds, without deciding one after another."""
    result: Any = False
    for truth in truths:
        result = result | truth
    return result  # type: ignore[no-any-return]


def mover_in_terrain(deed: Deed[Any]) -> Truth:
    """Whether the mover's box reaches into terrain."""
    world: Any = deed.after
    mine = box(world, deed.body)
    if mine is None:
        return False
    solids = [image for solid in terrain(world) for image in images(world, solid)]
    return some([overlap(mine, solid) for solid in solids])


def mover_in_body(deed: Deed[Any]) -> Truth:
    """Whether the mover's box overlaps that of another body."""
    world: Any = deed.after
    mine = box(world, deed.body)
    if mine is None:
        return False
    others = [other for body, other in boxes(world).items() if body != deed.body]
    return some([overlap(mine, image) for other in others for image in images(world, other)])


def overlap(one: Box[Any], other: Box[Any]) -> Truth:
    """Whether two boxes overlap."""
    return negated(one.clear_of(other, one.left * 0))


def on_body(deed: Deed[Any]) -> bool:
    """Whether the mover stood on a body."""
    before: Any = deed.before
    return before.support(deed.body) is not None


def in_overhang(deed: Deed[Any]) -> Truth:
    """Whether the mover's front border ends in overhang."""
    view = deed.after.facing(deed.direction)  # type: ignore[attr-defined]
    return view.reach(view.front(deed.body)) < deed.asked * 0  # type: ignore[no-any-return]


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


def short_pit(deed: Deed[Any], fired: frozenset[str]) -> Truth:
    """It fell although a ledge at the same height was less than its width away."""
    width, zero = deed.before.width(deed.body), deed.asked * 0
    near = [(across >= zero) & (across < width) & (drop == zero) for across, drop in facing_ledges(deed)]
    return some(near) if "leave/fall" in fired else False


def overhang_into_wall(deed: Deed[Any], fired: frozenset[str]) -> Truth:
    """On the ground, its overhang reaches into terrain."""
    stays = "leave/stay" in fired and not on_body(deed)
    return in_overhang(deed) & mover_in_terrain(deed) if stays else False


def overhang_from_body(deed: Deed[Any], fired: frozenset[str]) -> Truth:
    """On a body, its overhang reaches into terrain."""
    stays = "leave/stay" in fired and on_body(deed)
    return in_overhang(deed) & mover_in_terrain(deed) if stays else False


def tunnel(deed: Deed[Any], fired: frozenset[str]) -> Truth:
    """On the ground and not in overhang, it reaches into terrain."""
    stays = "leave/stay" in fired and not on_body(deed)
    return negated(in_overhang(deed)) & mover_in_terrain(deed) if stays else False


def falls_onto_body(deed: Deed[Any], fired: frozenset[str]) -> Truth:
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


def sharp_ledge(deed: Deed[Any], fired: frozenset[str]) -> Truth:
    """It is blocked at the corner of a top, in the middle of which a ledge begins that it could step onto."""
    return ledge_under(deed) if "leave/nowhere" in fired else False


def falls_off_body(deed: Deed[Any], fired: frozenset[str]) -> Truth:
    """It is blocked at the corner of a top with nothing to step onto."""
    return negated(ledge_under(deed)) if "leave/nowhere" in fired else False


def does_not_fit(deed: Deed[Any], fired: frozenset[str]) -> Truth:
    """Its landing did not fit before a wall."""
    return "fit/wall" in fired


def jumps_onto_a_ridden_top(deed: Deed[Any], fired: frozenset[str]) -> Truth:
    """It jumped onto a top on which another body stands, and into that body."""
    world: Any = deed.after
    ridden = len(world.row(deed.body).order) > 1
    return mover_in_body(deed) if "leave/jump" in fired and ridden else False


def jumps_into_what_leads_up(deed: Deed[Any], fired: frozenset[str]) -> Truth:
    """It jumped into a body whose top is above the ledge."""
    before, after = deed.before, deed.after
    mine, level = box(after, deed.body), heights(before, deed.body)[0]
    if "leave/jump" not in fired or mine is None:
        return False
    others = [box(after, body) for body in after.handles() if body != deed.body]  # type: ignore[attr-defined]
    return some([overlap(mine, other) & (other.top > level) for other in others if other is not None])


CASES: tuple[Case, ...] = (
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
)


@dataclass(frozen=True)
class Recorded:
    """An unsupported case that no request runs into by itself; `sentence` says what becomes of it here."""

    id: str
    sentence: str
    source: str

    kind = "unsupported"


RECORDED: tuple[Recorded, ...] = (
    Recorded(
        "unsupported/platforms",
        "The creator from a list of vertices makes no floating platforms; levels that name their edges have them.",
        "6.1.3; U8, R30",
    ),
    Recorded(
        "unsupported/other-strings",
        "A body does not see what is not on its own string of edges: see the claims about the plane.",
        "6.2.2; U9",
    ),
    Recorded("unsupported/moving-terrain", "Static geometry does not move.", "4.4; U10"),
)
