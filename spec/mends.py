"""Mends: small changes of the printed rules, each of one decision, for defects that the thesis has or names.

A mend takes the rules and gives them back with one entry changed. What `repaired` does instead is another world.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from functools import partial
from typing import Any, Protocol

from spec.number import N, Truth, greater, zero_like
from spec.profiles import Profile
from spec.rules.leave import Departure, Landing, rear_keeps_across
from spec.rules.request import Rules
from spec.rules.walk import walk_freely
from spec.world import B, Jump, P, View

Depart = Callable[..., Departure[Any, Any]]


@dataclass(frozen=True)
class Mend:
    """A change of the printed rules: its sentence, its source, and the rules that it makes of others."""

    id: str
    sentence: str
    source: str
    mended: Callable[[Rules], Rules]

    kind = "mend"


class Wide(View[N, B, P], Protocol[N, B, P]):
    """A view that also knows who stands where a body would land."""

    def room(self, near: P, /) -> N | None:
        """How far the first body on a string is from the near end of it; None if nobody is there."""


Seen = Callable[[Departure[Any, Any], Any], Departure[Any, Any]]
"""What a body that leaves sees, by what it saw before and who it is."""


def departing(seen: Seen, rules: Rules) -> Rules:
    """Rules under which a body that leaves sees something else."""
    return replace(rules, depart=partial(depart_seeing, rules.depart, seen))


def depart_seeing(
    before: Depart, seen: Seen, rules: Rules, view: View[N, B, P], body: B, front: P, rear: P, moved: N
) -> Departure[N, P]:
    """Look as before; with the rear border beyond the end of its edge, see something else."""
    leaving = before(rules, view, body, front, rear, moved)
    return seen(leaving, body) if view.reach(rear) < zero_like(moved) else leaving


def near_with_margin(leaving: Departure[N, P], body: Any) -> Departure[N, P]:
    """Jump edges count up to less than the width and the margin."""
    zero, limit = zero_like(leaving.moved), leaving.width + leaving.view.margin
    near = [jump for jump in leaving.view.jumps(body, leaving.rear) if jump.across >= zero and jump.across < limit]
    return replace(leaving, near=tuple(near))


def up_obstructs(leaving: Departure[N, P], body: Any) -> Departure[N, P]:
    """Where a near jump edge leads up, only those that do are left."""
    up = tuple(jump for jump in leaving.near if jump.drop < zero_like(leaving.moved))
    return replace(leaving, near=up) if up else leaving


def landings_seen(leaving: Departure[N, P], body: Any) -> Departure[N, P]:
    """A landing where somebody stands is not free; that of a fall is then as if a jump edge led there."""
    near = tuple(replace(jump, free=jump.free and bool(has_room(leaving, jump.target))) for jump in leaving.near)
    if not near and leaving.foot is not None and not has_room(leaving, leaving.foot):
        zero = zero_like(leaving.moved)
        near = (Jump(leaving.foot, zero, zero, free=False),)
    return replace(leaving, near=near)


def has_room(leaving: Departure[N, P], near_end: P) -> Truth:
    """Nobody is on the string where a body lands, up to a margin beyond its front border."""
    view: Wide[N, Any, P] = leaving.view  # type: ignore[assignment]
    room = view.room(near_end)
    return (
        room is None or room >= view.across(near_end, leaving.landing(leaving, near_end)) + leaving.width + view.margin
    )


def in_place(leaving: Departure[N, P], near_end: P) -> P:
    """The rear border keeps its horizontal position, or as far ahead of the near end as the body fits before a wall."""
    view = leaving.view
    across = view.across(near_end, leaving.rear)
    if across < zero_like(across):
        return view.along(near_end, across)
    rear = rear_keeps_across(leaving, near_end)
    short = walk_freely(leaving.walk, view, rear, leaving.width).rest
    return walk_freely(leaving.walk, view, near_end, greater(view.across(near_end, rear) - short, zero_like(across))).at


def landing(choice: Landing, rules: Rules) -> Rules:
    """Rules with another landing."""
    return replace(rules, landing=choice)


MARGIN_IN_JUMP_TEST = Mend(
    "mend/margin-in-jump-test",
    "Jump edges count whose horizontal distance is less than the width and the margin.",
    "6.2.1; R24, R25, A20",
    partial(departing, near_with_margin),
)
ANY_THAT_LEADS_UP = Mend(
    "mend/any-that-leads-up",
    "A ledge at which any near jump edge leads up is obstructed, whatever others there are.",
    "6.2.1; R25, A23",
    partial(departing, up_obstructs),
)
LOOK_AT_LANDING = Mend(
    "mend/look-at-landing",
    "Where anybody stands within the width and the margin of a landing, nobody falls or jumps there.",
    "6.2.1; O4, U9",
    partial(departing, landings_seen),
)
LANDING_IN_PLACE = Mend(
    "mend/landing-in-place",
    "A body that falls or jumps keeps its horizontal position, but as far as it fits before a wall.",
    "1.2, 6.2.1d, 6.2.1e; R33, A15, A16, A19, U11",
    partial(landing, in_place),
)

MENDS: tuple[Mend, ...] = (MARGIN_IN_JUMP_TEST, ANY_THAT_LEADS_UP, LOOK_AT_LANDING, LANDING_IN_PLACE)


def mended(profile: Profile, mends: Iterable[Mend]) -> Profile:
    """A profile under some mends, made one after another: `MENDS` is an order in which none undoes another."""
    rules = profile.rules
    for mend in mends:
        rules = mend.mended(rules)
    return replace(profile, rules=rules)
