"""Leave: a body whose borders are both beyond the end of its edge falls, jumps or is blocked.

First it moves, then it falls or jumps (6.2.1). Jump edges lead to the tops of bodies that stand in the way of the
fall; the body takes the one that leads down least.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Generic

from spec.number import N, Truth, greater, lesser, zero_like
from spec.rule import AnyFamily, Chooser, Family, Rule
from spec.rules.walk import Motion, walk_freely
from spec.world import Jump, P, View


@dataclass(frozen=True)
class Placement(Generic[N, P]):
    """Where a body comes to stand, and how far it has moved there."""

    front: P
    rear: P
    moved: N


Landing = Callable[["Departure[Any, Any]", Any], Any]


@dataclass(frozen=True)
class Departure(Generic[N, P]):
    """A body after its move, before it falls or jumps.

    Attributes:
        near: the jump edges whose horizontal extent is at least 0 and less than the body's width.
        foot: where the fall edge at the end of its edge leads, or None if there is none.
        landing: where the rear border comes down, at a given near end (a reading: A15, A19).
    """

    view: View[N, Any, P]
    walk: Chooser
    fit: Chooser
    landing: Landing
    front: P
    rear: P
    moved: N
    width: N
    near: Sequence[Jump[N, P]]
    foot: P | None


def rear_on_edge(leaving: Departure[N, P]) -> Truth:
    """The rear border is not beyond the end of its edge."""
    return leaving.view.reach(leaving.rear) >= zero_like(leaving.moved)


def rear_beyond(leaving: Departure[N, P]) -> Truth:
    """The rear border is beyond the end of its edge, and so is the front border, which is further on."""
    return leaving.view.reach(leaving.rear) < zero_like(leaving.moved)


def unobstructed(leaving: Departure[N, P]) -> Truth:
    """No jump edge at the ledge is as short as the body is wide."""
    return not leaving.near


def obstructed(leaving: Departure[N, P]) -> Truth:
    """A jump edge at the ledge is as short as the body is wide."""
    return bool(leaving.near)


def fall_edge_there(leaving: Departure[N, P]) -> Truth:
    """A fall edge begins there."""
    return leaving.foot is not None


def no_fall_edge(leaving: Departure[N, P]) -> Truth:
    """No fall edge begins there: it is the corner of a top."""
    return leaving.foot is None


def usable(leaving: Departure[N, P]) -> list[Jump[N, P]]:
    """The near jump edges that do not lead up, and whose far end is free."""
    return [jump for jump in leaving.near if jump.free and jump.drop >= zero_like(leaving.moved)]


def some_usable(leaving: Departure[N, P]) -> Truth:
    """One of them does not lead up, and its far end is free."""
    return bool(usable(leaving))


def none_usable(leaving: Departure[N, P]) -> Truth:
    """All of them lead up, or to where no body may stand."""
    return not usable(leaving)


def stay(leaving: Departure[N, P]) -> Placement[N, P]:
    """Stay where the move has led."""
    return Placement(leaving.front, leaving.rear, leaving.moved)


def stop_at_the_ledge(leaving: Departure[N, P]) -> Placement[N, P]:
    """Cut the move back so that the rear border stands at the end of the edge (A24)."""
    too_far = leaving.view.reach(leaving.rear)
    return Placement(
        leaving.view.along(leaving.front, too_far), leaving.view.end(leaving.rear), leaving.moved + too_far
    )


def land_at(leaving: Departure[N, P], near_end: P) -> Placement[N, P]:
    """Come down at the near end of an edge, the front border a width ahead along the graph."""
    rear = leaving.landing(leaving, near_end)
    motion = walk_freely(leaving.walk, leaving.view, rear, leaving.width)
    front = leaving.fit.choose(motion).effect((leaving.view, motion))
    return Placement(front, rear, leaving.moved)


def fall(leaving: Departure[N, P]) -> Placement[N, P]:
    """Land on the ground edge after the fall edge."""
    assert leaving.foot is not None
    return land_at(leaving, leaving.foot)


def jump_down_least(leaving: Departure[N, P]) -> Placement[N, P]:
    """Take the usable jump edge that leads down least, among equals the shortest (A23)."""
    candidates = usable(leaving)
    assert candidates, "a jump needs a usable jump edge"
    best = candidates[0]
    for jump in candidates[1:]:
        if jump.drop < best.drop or (jump.drop <= best.drop and jump.across < best.across):
            best = jump
    return land_at(leaving, best.target)


LEAVE: AnyFamily = Family(
    "leave",
    (
        Rule(
            id="leave/stay",
            sentence="A body with a border on its edge stays on it.",
            source="6.2.1d; R21, R23, A14",
            guard=(rear_on_edge,),
            effect=stay,
        ),
        Rule(
            id="leave/fall",
            sentence="With both borders beyond an unobstructed ledge, a body falls to the ground after the fall edge.",
            source="6.2.1d; R3, R21, R25, A4, A17, A48",
            guard=(rear_beyond, unobstructed, fall_edge_there),
            effect=fall,
            event="fall",
        ),
        Rule(
            id="leave/jump",
            sentence="With both borders beyond an obstructed ledge, a body takes the jump edge that leads down least.",
            source="6.2.1e, 6.2.1; R15, R22, R25, R32, A21, A23",
            guard=(rear_beyond, some_usable),
            effect=jump_down_least,
            event="jump",
        ),
        Rule(
            id="leave/blocked",
            sentence="Where every near jump edge leads up, the move ends with the rear border at the ledge.",
            source="6.2.1; R25, R32, A24, A54",
            guard=(rear_beyond, obstructed, none_usable),
            effect=stop_at_the_ledge,
            event="blocked",
        ),
        Rule(
            id="leave/nowhere",
            sentence="At the corner of a top with no near jump edge, the move ends with the rear border at the corner.",
            source="4.4, 6.6c, 7.2; U7, A24, A26",
            guard=(rear_beyond, unobstructed, no_fall_edge),
            effect=stop_at_the_ledge,
            event="nowhere",
        ),
    ),
)


def all_placed(motion: Motion[N, P]) -> Truth:
    """The whole width found its place."""
    return motion.rest <= zero_like(motion.rest)


def some_left(motion: Motion[N, P]) -> Truth:
    """A wall stands where a part of the body is to be."""
    return motion.rest > zero_like(motion.rest)


def where_the_width_ends(landed: tuple[View[N, Any, P], Motion[N, P]]) -> P:
    """Where the width ends: what is left of it lies beyond the end of the edge, inside the wall."""
    view, motion = landed
    return view.along(motion.at, motion.rest)


FIT: AnyFamily = Family(
    "fit",
    (
        Rule(
            id="fit/lands",
            sentence="A body lands across as many ground edges as it is wide, or in overhang at a ledge.",
            source="6.2.1d; R21, A16",
            guard=(all_placed,),
            effect=where_the_width_ends,
        ),
        Rule(
            id="fit/wall",
            sentence="Where a wall stands within its width, the landing does not fit: the body stands inside it.",
            source="6.2.1d; U11, A16",
            guard=(some_left,),
            effect=where_the_width_ends,
            event="lands-in-wall",
        ),
    ),
)


def rear_at_near_end(leaving: Departure[N, P], near_end: P) -> P:
    """The rear border lands at the near end itself: at the foot of the fall edge, or at the near corner."""
    return near_end


def rear_keeps_across(leaving: Departure[N, P], near_end: P) -> P:
    """The rear border keeps its horizontal position, as far as it is beyond the near end and there is ground."""
    beyond = leaving.view.across(near_end, leaving.rear)
    distance = greater(beyond, zero_like(beyond))
    rear = walk_freely(leaving.walk, leaving.view, near_end, distance).at
    return leaving.view.along(rear, lesser(leaving.view.reach(rear), zero_like(distance)))
