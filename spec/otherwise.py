"""Rules otherwise: the small changes of which alternatives are made (`spec/alternatives.py`).

A rule has another guard or effect; a family looks at its facts otherwise; a request is carried out otherwise.
"""

from __future__ import annotations

from collections.abc import Callable, Generator
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from spec.number import N, Truth, greater, lesser, zero_like
from spec.rule import AnyFamily, AnyRule, Chooser, Family
from spec.rules.leave import (
    Departure,
    Placement,
    fall,
    jump_down_least,
    some_usable,
    stay,
    stop_at_the_ledge,
)
from spec.rules.request import Ask, Rules, depart, request, segment
from spec.rules.walk import (
    WALK,
    Motion,
    Step,
    edge_follows,
    no_edge_follows,
    no_ledge_follows,
    pass_on,
    reaches_the_end,
    stop_after,
    walk_freely,
    way_open,
)
from spec.world import P

Requesting = Callable[[Rules, Any, Any, Any, int], Generator[Ask[Any, Any], Any, Any]]
"""How a request is carried out; `spec.rules.request.request` is how the thesis does it."""


@dataclass(frozen=True)
class Seen:
    """A family to which its facts look otherwise."""

    family: Chooser
    change: Callable[[Any], Any]

    def choose(self, facts: Any) -> AnyRule:
        """Return the rule that applies to the facts as they look."""
        seen = self.change(facts)
        rule = self.family.choose(seen)
        return replace(rule, effect=lambda _: rule.effect(seen))


@dataclass(frozen=True)
class Instead:
    """A family of which some rules, named by their IDs, have another effect."""

    family: Chooser
    rules: tuple[str, ...]
    effect: Callable[[Any], Any]

    def choose(self, facts: Any) -> AnyRule:
        """Return the rule that applies, with its effect."""
        rule = self.family.choose(facts)
        return replace(rule, effect=self.effect) if rule.id in self.rules else rule


@dataclass
class Noted:
    """A family of which the last choice is kept, with its facts."""

    family: Chooser
    facts: Any = None
    rule: AnyRule | None = None

    def choose(self, facts: Any) -> AnyRule:
        """Return the rule that applies, noted."""
        self.facts, self.rule = facts, self.family.choose(facts)
        return self.rule

    @property
    def left(self) -> bool:
        """Whether the body has left its edge: fallen or jumped."""
        return self.rule is not None and self.rule.event in ("fall", "jump")


def with_rule(family: AnyFamily, rule: str, **changes: Any) -> AnyFamily:
    """A family of which one rule is changed."""
    assert rule in [one.id for one in family.rules]
    return Family(family.id, tuple(replace(one, **changes) if one.id == rule else one for one in family.rules))


HALF = Fraction(1, 2)
AT_THE_LEDGE = ("leave/blocked", "leave/nowhere")

# Walls


def ends_off_the_wall(step: Step[N, P]) -> Truth:
    """What is left to move ends on the edge, at the margin from its end if that is a wall."""
    return step.motion.rest <= step.reach - margin_at_end(step)


def exceeds_up_to_wall(step: Step[N, P]) -> Truth:
    """What is left to move exceeds the edge, less the margin if its end is a wall."""
    return step.motion.rest > step.reach - margin_at_end(step)


def margin_at_end(step: Step[N, P]) -> N:
    """The margin where the edge ends at a wall, else 0."""
    walled = step.beyond.onward is None and not step.beyond.ledge
    return step.view.margin if walled else zero_like(step.reach)


def move_to_the_margin(step: Step[N, P]) -> Motion[N, P]:
    """Move until the wall is the margin away, if it is not nearer, and stop."""
    distance = step.reach - step.view.margin
    free = distance if distance > zero_like(distance) else zero_like(distance)
    return stop_after(free, step.view.along(step.motion.at, free), step.motion)


OFF_THE_WALL = with_rule(
    with_rule(WALK, "walk/along", guard=(way_open, ends_off_the_wall)),
    "walk/wall",
    guard=(way_open, exceeds_up_to_wall, no_edge_follows, no_ledge_follows, reaches_the_end),
    effect=move_to_the_margin,
)

# Vertices


def ends_before_the_next(step: Step[N, P]) -> Truth:
    """What is left to move ends on the edge, and before its end if another ground edge follows."""
    if step.beyond.onward is not None:
        return step.motion.rest < step.reach
    return step.motion.rest <= step.reach


def comes_to_the_next(step: Step[N, P]) -> Truth:
    """What is left to move takes it to the end of the edge, or exceeds it."""
    return step.motion.rest >= step.reach


NEXT_NAME = with_rule(
    with_rule(WALK, "walk/along", guard=(way_open, ends_before_the_next)),
    "walk/onward",
    guard=(way_open, comes_to_the_next, edge_follows),
    effect=pass_on,
)

# Ledges


def level_leads_up(leaving: Departure[N, Any]) -> Departure[N, Any]:
    """Jump edges of height 0 look as if nobody could stand there."""
    near = [replace(jump, free=jump.free and bool(jump.drop > zero_like(jump.drop))) for jump in leaving.near]
    return replace(leaving, near=tuple(near))


def any_up_blocks(leaving: Departure[N, Any]) -> Departure[N, Any]:
    """Where one near jump edge leads up, no other looks free."""
    if any(jump.drop < zero_like(jump.drop) for jump in leaving.near):
        return replace(leaving, near=tuple(replace(jump, free=False) for jump in leaving.near))
    return leaving


def fall_where_it_fits(leaving: Departure[N, Any]) -> Placement[N, Any]:
    """Fall, if the edge there takes the whole body; else the move is cut back to the ledge."""
    landed = fall(leaving)
    return landed if leaving.view.reach(landed.rear) >= leaving.width else stop_at_the_ledge(leaving)


def jump_to_the_middle(leaving: Departure[N, Any]) -> Placement[N, Any]:
    """Jump, and land with the middle of the body on the middle of the top."""

    def centred(facts: Departure[N, Any], near_end: Any) -> Any:
        beyond = facts.view.beyond(near_end)
        if not beyond.ledge or facts.view.foot(near_end) is not None:
            return near_end  # it is ground, not a top
        room: Any = facts.view.reach(near_end) - facts.width
        return facts.view.along(near_end, room * HALF)

    return jump_down_least(replace(leaving, landing=centred))


def without_margins(effect: Callable[[Any], Any]) -> Callable[[Any], Any]:
    """The same effect for a body whose width does not count the margins on either side."""

    def as_wide_as_its_borders(leaving: Departure[N, Any]) -> Placement[N, Any]:
        return effect(replace(leaving, width=leaving.width - leaving.view.margin * 2))  # type: ignore[no-any-return]

    return as_wide_as_its_borders


# Requests


def refused_at_the_ledge(rules: Rules, view: Any, body: Any, distance: Any, spare: int) -> Generator[Any, Any, Any]:
    """A request that ends blocked at a ledge does not move its body at all."""

    def refused(leaving: Departure[Any, Any]) -> Placement[Any, Any]:
        return Placement(view.front(body), view.rear(body), zero_like(leaving.moved))

    stubborn = Instead(rules.leave, AT_THE_LEDGE, refused)
    return (yield from request(replace(rules, leave=stubborn), view, body, distance, spare))


@dataclass(frozen=True)
class ByTheFront:
    """The family `leave` of a body that leaves its edge as soon as its front border is beyond the end."""

    rules: Rules
    view: Any
    body: Any
    only_jumps: bool

    def choose(self, leaving: Departure[Any, Any]) -> AnyRule:
        """Return the rule for its front border, if that is beyond, else the rule of the thesis."""
        if self.view.reach(leaving.front) >= zero_like(leaving.moved):
            return self.rules.leave.choose(leaving)
        early = depart(self.rules, self.view, self.body, leaving.front, leaving.front, leaving.moved)
        if self.only_jumps and not some_usable(early):
            return self.rules.leave.choose(leaving)
        rule = self.rules.leave.choose(early)
        cut_back = rule.id in AT_THE_LEDGE
        return replace(rule, effect=self.stop_with_the_front if cut_back else lambda _: rule.effect(early))

    def stop_with_the_front(self, leaving: Departure[Any, Any]) -> Placement[Any, Any]:
        """Cut the move back to where the front border is at the end of its edge."""
        return cut_to_the_front(self.rules, self.view, self.body, leaving)


def cut_to_the_front(rules: Rules, view: Any, body: Any, leaving: Departure[Any, Any]) -> Placement[Any, Any]:
    """Cut a move back to where the front border is at the end of its edge, or to its start if that was beyond."""
    moved = greater(leaving.moved + view.reach(leaving.front), zero_like(leaving.moved))
    front, rear = (walk_freely(rules.walk, view, at, moved).at for at in (view.front(body), view.rear(body)))
    return Placement(front, rear, moved)


def either_border_falls(rules: Rules, view: Any, body: Any, distance: Any, spare: int) -> Generator[Any, Any, Any]:
    """A body leaves its edge as soon as one of its borders is beyond the end."""
    early = ByTheFront(rules, view, body, only_jumps=False)
    return (yield from request(replace(rules, leave=early), view, body, distance, spare))


def front_jumps(rules: Rules, view: Any, body: Any, distance: Any, spare: int) -> Generator[Any, Any, Any]:
    """A body jumps, where it can, as soon as its front border is beyond the ledge; it falls as in the thesis."""
    early = ByTheFront(rules, view, body, only_jumps=True)
    return (yield from request(replace(rules, leave=early), view, body, distance, spare))


def goes_on(rules: Rules, view: Any, body: Any, distance: Any, spare: int) -> Generator[Any, Any, Any]:
    """After a fall or a jump the body goes on by what it had moved beyond the ledge."""
    noted = Noted(rules.leave)
    moved = yield from request(replace(rules, leave=noted), view, body, distance, spare)
    if not noted.left:
        return moved
    beyond = zero_like(moved) - view.reach(noted.facts.rear)
    further = yield from request(rules, view, body, beyond, spare)
    return moved - beyond + further


def falls_on(rules: Rules, view: Any, body: Any, distance: Any, spare: int) -> Generator[Any, Any, Any]:
    """After a fall or a jump the body falls or jumps again, as often as it can."""
    noted = Noted(rules.leave)
    moved = yield from request(replace(rules, leave=noted), view, body, distance, spare)
    while noted.left:
        yield from request(replace(rules, leave=noted), view, body, zero_like(moved), spare)
    return moved


def one_vertex(rules: Rules, view: Any, body: Any, distance: Any, spare: int) -> Generator[Any, Any, Any]:
    """The front border passes one vertex; where it would pass another, the move ends."""
    passed = []

    def once(
        rules: Rules, view: Any, body: Any, motion: Motion[Any, Any], spare: int
    ) -> Generator[Any, Any, Motion[Any, Any]]:
        after: Motion[Any, Any] = yield from segment(rules, view, body, motion, spare)
        passed.append(after.going)
        return replace(after, going=after.going and sum(passed) == 1)

    return (yield from request(replace(rules, segment=once), view, body, distance, spare))


def walled_corners(rules: Rules, view: Any, body: Any, distance: Any, spare: int) -> Generator[Any, Any, Any]:
    """The front border stops at the corner of a top, unless a jump edge is near there."""

    def stopped(leaving: Departure[Any, Any]) -> Placement[Any, Any]:
        early = depart(rules, view, body, leaving.front, leaving.front, leaving.moved)
        if view.reach(leaving.front) >= zero_like(leaving.moved) or early.foot is not None or early.near:
            return stay(leaving)
        return cut_to_the_front(rules, view, body, leaving)

    walled = Instead(rules.leave, ("leave/stay", "leave/nowhere"), stopped)
    return (yield from request(replace(rules, leave=walled), view, body, distance, spare))


def short_overhang(rules: Rules, view: Any, body: Any, distance: Any, spare: int) -> Generator[Any, Any, Any]:
    """A border goes no further into overhang than its body is wide, and a margin."""

    def limited(step: Step[Any, Any]) -> Motion[Any, Any]:
        most = lesser(step.way.distance, step.reach + view.width(body) + view.margin)
        return stop_after(most, view.along(step.motion.at, most), step.motion)

    shorter = Instead(rules.walk, ("walk/overhang",), limited)
    return (yield from request(replace(rules, walk=shorter), view, body, distance, spare))


def falls_at_the_instant(rules: Rules, view: Any, body: Any, distance: Any, spare: int) -> Generator[Any, Any, Any]:
    """A move ends, and the body leaves its edge, when its rear border is at the ledge."""
    cut = []

    def limited(step: Step[Any, Any]) -> Motion[Any, Any]:
        most = lesser(step.way.distance, step.reach + view.width(body))
        cut.append(bool(most < step.way.distance))
        return stop_after(most, view.along(step.motion.at, most), step.motion)

    def gone(leaving: Departure[Any, Any]) -> Departure[Any, Any]:
        if not any(cut):
            return leaving
        return depart(rules, view, body, leaving.front, view.along(leaving.rear, view.margin), leaving.moved)

    leave = Instead(Seen(rules.leave, gone), AT_THE_LEDGE, stop_at_the_ledge)
    shorter = Instead(rules.walk, ("walk/overhang",), limited)
    return (yield from request(replace(rules, walk=shorter, leave=leave), view, body, distance, spare))
