"""Event: when the motion of a step changes next."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Generic

from spec.number import N, Truth, greater, zero_like
from spec.rule import AnyFamily, Family, Rule
from spec.storeys import Mark


@dataclass(frozen=True)
class Nearing(Generic[N]):
    """Something that comes nearer: what there is left to go, the speed at which that lessens, and whether it has come.

    What has come is recorded for the rest of the step. It is never found again by comparing distances, because in
    floats a rest too small to change a place would stop time.
    """

    mark: Mark
    room: N
    speed: N
    recorded: bool

    @property
    def body(self) -> int:
        """The body, or the left one of two."""
        return self.mark.body


def not_yet(nearing: Nearing[N]) -> Truth:
    """It is not recorded."""
    return not nearing.recorded


def already(nearing: Nearing[N]) -> Truth:
    """It is recorded."""
    return nearing.recorded


def time_left(nearing: Nearing[N]) -> N:
    """The room, by the speed."""
    return greater(nearing.room, zero_like(nearing.room)) / nearing.speed


def never(nearing: Nearing[N]) -> None:
    """It does not come again."""


CONTACT: AnyFamily = Family(
    "contact",
    (
        Rule(
            id="event/contact",
            sentence="Two neighbours that come nearer come into contact when the gap between them is the margin.",
            source="6.2.1; R24, R34",
            guard=(not_yet,),
            effect=time_left,
            event="contact",
        ),
        Rule(
            id="event/in-contact",
            sentence="Two bodies stay in contact until they part, or one of them changes its storey; for so long "
            "their gap is not looked at.",
            source="6.2.1c; R20",
            guard=(already,),
            effect=never,
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
            guard=(not_yet,),
            effect=time_left,
            event="wall",
        ),
        Rule(
            id="event/at-wall",
            sentence="A body is at a wall until it moves away from it or changes its storey; for so long "
            "the distance is not looked at.",
            source="6.2.1b; R19",
            guard=(already,),
            effect=never,
        ),
    ),
)

LOSS: AnyFamily = Family(
    "loss",
    (
        Rule(
            id="event/support-lost",
            sentence="A body that moves relative to its support loses it at the instant in which it no longer holds.",
            source="6.2.1d, 6.2.1e, 7.2; R21, R22, A14, A59, U7",
            guard=(),
            effect=time_left,
            event="support-lost",
        ),
    ),
)
