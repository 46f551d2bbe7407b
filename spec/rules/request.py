"""Request: a body is asked to move by a distance; it measures, pushes and walks, edge by edge.

A request is a generator. Where it needs its neighbour to move it yields an `Ask` and is sent the distance
that the neighbour moved. So the chain of requests may be as long as the row (no recursion), and a proof can
answer an `Ask` by the contract of a request instead of by another run of it.
"""

from __future__ import annotations

from collections.abc import Callable, Generator
from dataclasses import dataclass, replace
from typing import Any, Generic

from spec.number import N, greater, lesser, zero_like
from spec.rule import Chooser
from spec.rules.clearance import Sight
from spec.rules.leave import Departure, Landing, Placement
from spec.rules.push import Answer, Want, Way
from spec.rules.walk import Motion, Tow, walk
from spec.world import B, P, View


@dataclass(frozen=True)
class Ask(Generic[N, B]):
    """A request to `body` to move by `distance`, after which `spare` more bodies may be asked."""

    body: B
    distance: N
    spare: int


@dataclass(frozen=True)
class Rules:
    """The families that a request chooses its rules from, handed along so that a proof, a mutant or a record
    of what fired can stand in for any of them. `segment` is the motion of a front border along one edge, `depart` the
    look at what lies beyond the end of its edge.
    """

    clearance: Chooser
    push: Chooser
    contact: Chooser
    walk: Chooser
    follow: Chooser
    leave: Chooser
    fit: Chooser
    landing: Landing
    segment: Callable[..., Generator[Ask[Any, Any], Any, Motion[Any, Any]]]
    depart: Callable[..., Departure[Any, Any]]

    def through(self, wrap: Callable[[Chooser], Chooser]) -> Rules:
        """The same rules, each family wrapped."""
        wrapped: dict[str, Any] = {name: wrap(getattr(self, name)) for name in FAMILIES}
        return replace(self, **wrapped)


FAMILIES = ("clearance", "push", "contact", "walk", "follow", "leave", "fit")


def look(view: View[N, B, P], motion: Motion[N, P], other: B | None) -> Sight[N]:
    """Measure the distance to what is ahead, for a stride that ends on this edge, or in overhang."""
    overhangs = view.beyond(motion.at).ledge
    reach = greater(view.reach(motion.at), zero_like(motion.rest))
    stride = motion.rest if overhangs else lesser(motion.rest, reach)
    gap = zero_like(stride) if other is None else view.gap(motion.at, other)
    return Sight(stride, other is not None, gap, view.margin)


def segment(
    rules: Rules, view: View[N, B, P], body: B, motion: Motion[N, P], spare: int
) -> Generator[Ask[N, B], N, Motion[N, P]]:
    """Move a front border along one edge: measure, ask the neighbour if need be, then walk (table 4.1, R5)."""
    other = view.ahead(body, motion.at)
    sight = look(view, motion, other)
    room = rules.clearance.choose(sight).effect(sight)
    want = Want(sight.stride, room, spare, view.pushes(body))
    asked = rules.push.choose(want).effect(want)
    granted = zero_like(sight.stride)
    if other is not None and asked is not None:
        granted = yield Ask(other, asked, spare - 1)
    answer = Answer(sight.stride, room, granted)
    way: Way[N] = rules.contact.choose(answer).effect(answer)
    return walk(rules.walk, view, motion, way)


def request(rules: Rules, view: View[N, B, P], body: B, distance: N, spare: int) -> Generator[Ask[N, B], N, N]:
    """Move `body` by up to `distance >= 0` and return the distance actually moved (6.2.1; R8, R17).

    The front border moves first, edge by edge, with collisions; then the rear border follows by the same distance;
    then, if it is beyond a ledge, the body falls or jumps (R23), at most once (A48). `spare` is how many further
    bodies the chain of requests may ask.
    """
    motion = Motion(view.front(body), rest=distance)
    while motion.going:
        motion = yield from rules.segment(rules, view, body, motion, spare)
    tow = Tow(view, rules.walk, view.rear(body), distance - motion.rest)
    rear = rules.follow.choose(tow).effect(tow)
    leaving = rules.depart(rules, view, body, motion.at, rear, tow.moved)
    placement: Placement[N, P] = rules.leave.choose(leaving).effect(leaving)
    view.place(body, placement.front, placement.rear)
    return placement.moved


def depart(rules: Rules, view: View[N, B, P], body: B, front: P, rear: P, moved: N) -> Departure[N, P]:
    """Look at the jump edges and the fall edge where a body is beyond the end of its edge (6.2.1; R23, R25, A20)."""
    width, zero = view.width(body), zero_like(moved)
    gone = view.reach(rear) < zero
    jumps = view.jumps(body, rear) if gone else ()
    near = tuple(jump for jump in jumps if jump.across >= zero and jump.across < width)
    return Departure(
        view,
        walk=rules.walk,
        fit=rules.fit,
        landing=rules.landing,
        front=front,
        rear=rear,
        moved=moved,
        width=width,
        near=near,
        foot=view.foot(rear) if gone else None,
    )
