"""Push: a body that wants more room than it has asks its neighbour to make room.

Step 2 of table 4.1, "move other body (if necessary)". The neighbour treats what it is asked like any other
request, so requests form a chain along the row.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Generic

from spec.number import N, Truth
from spec.rule import AnyFamily, Family, Rule


@dataclass(frozen=True)
class Want(Generic[N]):
    """A stride, the room there is for it, how many more bodies the chain may move, and whether this one may push."""

    stride: N
    room: N
    spare: int
    pushes: bool


def enough_room(want: Want[N]) -> Truth:
    """The room takes the whole stride."""
    return want.stride <= want.room


def short_of_room(want: Want[N]) -> Truth:
    """The stride is longer than the room."""
    return want.stride > want.room


def may_ask(want: Want[N]) -> Truth:
    """The push limit leaves another body to be asked."""
    return want.spare > 0


def may_not_ask(want: Want[N]) -> Truth:
    """The push limit is reached."""
    return want.spare <= 0


def permitted(want: Want[N]) -> Truth:
    """The body may push others."""
    return want.pushes


def forbidden(want: Want[N]) -> Truth:
    """The body may not push others."""
    return not want.pushes


def nothing(want: Want[N]) -> None:
    """Ask nothing of anyone."""


def what_is_missing(want: Want[N]) -> N:
    """Ask for what the stride exceeds the room by."""
    return want.stride - want.room


PUSH: AnyFamily = Family(
    "push",
    (
        Rule(
            id="push/none",
            sentence="A stride that fits into the free room asks nothing of anyone.",
            source="4.2, 6.2.1a; R5, R18",
            guard=(enough_room,),
            effect=nothing,
        ),
        Rule(
            id="push/request",
            sentence="A stride that exceeds the free room requests its neighbour to move by the excess.",
            source="4.2, T4.1, 6.2.1c; R6, R20",
            guard=(short_of_room, permitted, may_ask),
            effect=what_is_missing,
            event="push",
        ),
        Rule(
            id="push/limit",
            sentence="At the push limit the neighbour is not asked: it counts as a wall.",
            source="4.2; R31, A5, A6, A8",
            guard=(short_of_room, permitted, may_not_ask),
            effect=nothing,
            event="push-limit",
        ),
        Rule(
            id="push/forbidden",
            sentence="A body that may not push asks nobody: its neighbour counts as a wall.",
            source="1.1; A39",
            guard=(short_of_room, forbidden),
            effect=nothing,
            event="may-not-push",
        ),
    ),
)


@dataclass(frozen=True)
class Answer(Generic[N]):
    """The room there was, the stride wanted, and what the neighbour `granted` of what was `asked`."""

    stride: N
    room: N
    granted: N


def made_way(answer: Answer[N]) -> Truth:
    """With what was granted, the stride fits."""
    return answer.stride - answer.room <= answer.granted


def stood_still(answer: Answer[N]) -> Truth:
    """The neighbour moved by less than was asked."""
    return answer.stride - answer.room > answer.granted


@dataclass(frozen=True)
class Way(Generic[N]):
    """How far a border may move now, and whether a body ends the motion there."""

    distance: N
    blocked: bool


def the_stride(answer: Answer[N]) -> Way[N]:
    """The stride, unhindered."""
    return Way(answer.stride, blocked=False)


def up_to_contact(answer: Answer[N]) -> Way[N]:
    """As far as the neighbour has made room, and no further."""
    return Way(answer.room + answer.granted, blocked=True)


CONTACT: AnyFamily = Family(
    "contact",
    (
        Rule(
            id="contact/open",
            sentence="Where the room, with what the neighbour gave, takes the stride, the way is open.",
            source="6.2.1c; R20",
            guard=(made_way,),
            effect=the_stride,
        ),
        Rule(
            id="contact/stop",
            sentence="A body stops where the bodies that it pushes stop.",
            source="6.2.1c; R20, R24, R31",
            guard=(stood_still,),
            effect=up_to_contact,
            event="stopped",
        ),
    ),
)
