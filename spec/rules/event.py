"""Event: when the motion of a step changes next.

What has come is recorded. Bodies in contact, or at a wall, do not come nearer any more, so that no event is found again
by comparing distances: in floats a rest too small to change a place would stop time.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Generic

from spec.number import N, greater, zero_like
from spec.rule import AnyFamily, Family, Rule
from spec.storeys import Mark


@dataclass(frozen=True)
class Nearing(Generic[N]):
    """Something that comes nearer: what there is left to go, and the speed, greater than 0, at which that lessens."""

    mark: Mark
    room: N
    speed: N

    @property
    def body(self) -> int:
        """The body, or the left one of two."""
        return self.mark.body


def time_left(nearing: Nearing[N]) -> N:
    """The room, by the speed; what has come nearer than that, in floats, comes at once."""
    return greater(nearing.room, zero_like(nearing.room)) / nearing.speed


CONTACT: AnyFamily = Family(
    "contact",
    (
        Rule(
            id="event/contact",
            sentence="Two neighbours that come nearer come into contact when the gap between them is the margin.",
            source="6.2.1; R24, R34",
            guard=(),
            effect=time_left,
            event="contact",
        ),
    ),
)

WALL: AnyFamily = Family(
    "wall",
    (
        Rule(
            id="event/wall",
            sentence="A body that moves towards a wall meets it when the distance to it is 0.",
            source="6.2.1b; R19, A9",
            guard=(),
            effect=time_left,
            event="wall",
        ),
    ),
)

LOSS: AnyFamily = Family(
    "loss",
    (
        Rule(
            id="event/support-lost",
            sentence="A body that moves relative to its support loses it at the instant at which it no longer holds.",
            source="6.2.1d, 6.2.1e, 7.2; R21, R22, A14, A59, U7",
            guard=(),
            effect=time_left,
            event="support-lost",
        ),
    ),
)
