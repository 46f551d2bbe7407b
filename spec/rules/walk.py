"""Walk: a border moves along its edge, on to the next, or up to a wall.

Step 3 of table 4.1, "move self". The front border walks where the way is clear; the rear border follows by
the distance actually moved, without looking.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, Generic

from spec.number import N, Truth, zero_like
from spec.rule import AnyFamily, Chooser, Family, Rule
from spec.rules.push import Way
from spec.world import Beyond, P, View


@dataclass(frozen=True)
class Motion(Generic[N, P]):
    """A border under way: where it is, and what is left of the distance asked.

    What it has moved is what was asked less what is left. So, in floats too, a border that nothing stopped has moved
    by exactly what was asked.
    """

    at: P
    rest: N
    going: bool = True


@dataclass(frozen=True)
class Step(Generic[N, P]):
    """A motion, the way that is open to it on its edge, how far the edge reaches and what lies beyond it."""

    view: View[N, Any, P]
    motion: Motion[N, P]
    way: Way[N]
    reach: N
    beyond: Beyond[P]


def way_open(step: Step[N, P]) -> Truth:
    """No body stops the motion on this edge."""
    return not step.way.blocked


def way_blocked(step: Step[N, P]) -> Truth:
    """A body stops the motion on this edge."""
    return step.way.blocked


def ends_on_edge(step: Step[N, P]) -> Truth:
    """What is left to move does not exceed the edge."""
    return step.motion.rest <= step.reach


def exceeds_edge(step: Step[N, P]) -> Truth:
    """What is left to move exceeds the edge."""
    return step.motion.rest > step.reach


def edge_follows(step: Step[N, P]) -> Truth:
    """A ground edge follows."""
    return step.beyond.onward is not None


def no_edge_follows(step: Step[N, P]) -> Truth:
    """No ground edge follows."""
    return step.beyond.onward is None


def ledge_follows(step: Step[N, P]) -> Truth:
    """The edge ends at a ledge, or at the corner of a top."""
    return step.beyond.ledge


def no_ledge_follows(step: Step[N, P]) -> Truth:
    """The edge does not end at a ledge."""
    return not step.beyond.ledge


def reaches_the_end(step: Step[N, P]) -> Truth:
    """The border is not beyond the end of its edge."""
    return step.reach >= zero_like(step.reach)


def beyond_the_end(step: Step[N, P]) -> Truth:
    """The border is beyond the end of its edge."""
    return step.reach < zero_like(step.reach)


def stop_after(distance: N, at: P, motion: Motion[N, P]) -> Motion[N, P]:
    """The motion, ended at a position `distance` further on."""
    return Motion(at, rest=motion.rest - distance, going=False)


def move_by_the_way(step: Step[N, P]) -> Motion[N, P]:
    """Move as far as the way is open, and stop."""
    distance = step.way.distance
    return stop_after(distance, step.view.along(step.motion.at, distance), step.motion)


def move_to_the_end(step: Step[N, P]) -> Motion[N, P]:
    """Move to the end of the edge, and stop."""
    return stop_after(step.reach, step.view.end(step.motion.at), step.motion)


def pass_on(step: Step[N, P]) -> Motion[N, P]:
    """Move to the end of the edge and go on at the beginning of the next."""
    assert step.beyond.onward is not None
    ended = stop_after(step.reach, step.beyond.onward, step.motion)
    return replace(ended, going=True)


WALK: AnyFamily = Family(
    "walk",
    (
        Rule(
            id="walk/along",
            sentence="On an open way, a distance that ends on the edge changes the location by it.",
            source="6.2.1a; R7, R18",
            guard=(way_open, ends_on_edge),
            effect=move_by_the_way,
        ),
        Rule(
            id="walk/onward",
            sentence="On an open way, what exceeds the edge carries over to the next ground edge.",
            source="6.2.1a; R14, R18",
            guard=(way_open, exceeds_edge, edge_follows),
            effect=pass_on,
        ),
        Rule(
            id="walk/wall",
            sentence="Where no ground edge follows and no ledge, the move ends at the end of the edge.",
            source="6.2.1b; R19",
            guard=(way_open, exceeds_edge, no_edge_follows, no_ledge_follows, reaches_the_end),
            effect=move_to_the_end,
            event="wall",
        ),
        Rule(
            id="walk/in-wall",
            sentence="A border that a landing has put inside a wall does not move further into it, nor back.",
            source="6.2.1b; R17, U11",
            guard=(way_open, no_edge_follows, no_ledge_follows, beyond_the_end),
            effect=move_by_the_way,
            event="in-wall",
        ),
        Rule(
            id="walk/overhang",
            sentence="At a ledge a border goes on into overhang: it keeps its edge and exceeds it.",
            source="4.3.1, 6.2.1d; R7, R16, R21, A55",
            guard=(way_open, exceeds_edge, ledge_follows),
            effect=move_by_the_way,
            event="overhang",
        ),
        Rule(
            id="walk/blocked",
            sentence="A move that a body stops ends at the margin from it.",
            source="6.2.1c; R20, R24, R34",
            guard=(way_blocked,),
            effect=move_by_the_way,
        ),
    ),
)


def walk(rules: Chooser, view: View[N, Any, P], motion: Motion[N, P], way: Way[N]) -> Motion[N, P]:
    """Walk one edge, by the rule of `rules` that applies."""
    at = motion.at
    step = Step(view, motion, way, reach=view.reach(at), beyond=view.beyond(at))
    after: Motion[N, P] = rules.choose(step).effect(step)
    return after


def walk_freely(rules: Chooser, view: View[N, Any, P], at: P, distance: N) -> Motion[N, P]:
    """Walk a border by a distance, edge by edge, on an open way."""
    motion = Motion(at, rest=distance)
    while motion.going:
        motion = walk(rules, view, motion, Way(motion.rest, blocked=False))
    return motion


@dataclass(frozen=True)
class Tow(Generic[N, P]):
    """The rear border of a body whose front border has moved by `moved`; it walks by the rules `walk`."""

    view: View[N, Any, P]
    walk: Chooser
    rear: P
    moved: N


def follow_by_the_same(tow: Tow[N, P]) -> P:
    """Walk the rear border by the distance moved, on an open way."""
    return walk_freely(tow.walk, tow.view, tow.rear, tow.moved).at


FOLLOW: AnyFamily = Family(
    "follow",
    (
        Rule(
            id="follow/rear",
            sentence="The rear border follows by the distance that the front border moved, without collisions.",
            source="4.3.1, 4.3.2; R8, A13",
            guard=(),
            effect=follow_by_the_same,
        ),
    ),
)
