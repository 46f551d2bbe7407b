"""Readings: what the thesis leaves open, as named choices (rows A of the register)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Generic, TypeVar

Choice = TypeVar("Choice", covariant=True)


@dataclass(frozen=True)
class Reading(Generic[Choice]):
    """A question the thesis leaves open; `sentence` is the answer taken, `choice` what computes it, if anything."""

    id: str
    sentence: str
    source: str
    others: str
    choice: Choice

    kind = "reading"


def number_of_bodies(bodies: int) -> int:
    """As many bodies as there are in the level."""
    return bodies


def as_listed(names: Sequence[str]) -> Sequence[str]:
    """The order of the level's list of bodies."""
    return names


PUSH_LIMIT: Reading[Callable[[int], int]] = Reading(
    id="reading/push-limit",
    sentence="The push limit counts the bodies in the chain of one request, the mover among them; by default it "
    "is the number of bodies, and never more.",
    source="4.2; A5, A8",
    others="requests per tick; a larger limit, under which a body on a ring pushes itself",
    choice=number_of_bodies,
)

TICK_ORDER: Reading[Callable[[Sequence[str]], Sequence[str]]] = Reading(
    id="reading/tick-order",
    sentence="In a tick the bodies move one after another, in the level's order of bodies.",
    source="5.2; R4, A1, A53",
    others="characters first; simultaneously",
    choice=as_listed,
)

RECORDED: tuple[Reading[None], ...] = (
    Reading(
        id="reading/at-the-limit",
        sentence="At the push limit the body there counts as a wall, and the chain closes up to it.",
        source="4.2; A6",
        others="nothing moves",
        choice=None,
    ),
    Reading(
        id="reading/short-circle",
        sentence="On a circle with less free space than the distance, the row moves by the free space and stops.",
        source="4.2; A7",
        others="the whole ring rotates",
        choice=None,
    ),
    Reading(
        id="reading/too-near",
        sentence="Towards a body nearer than the margin the free distance is 0; a level may not start so.",
        source="6.2.1; A10",
        others="the bodies move apart",
        choice=None,
    ),
    Reading(
        id="reading/width",
        sentence="A body's width is the distance along the graph between its borders.",
        source="4.3.1, 4.3.2; A11, A31",
        others="plus margins; Euclidean",
        choice=None,
    ),
    Reading(
        id="reading/margin-to-bodies",
        sentence="The collision margin is kept towards bodies only, not towards walls.",
        source="6.2.1; A9",
        others="towards everything",
        choice=None,
    ),
    Reading(
        id="reading/sight",
        sentence="Before each move along one edge the bodies on it and on the next ground edge are looked at; a "
        "border at a vertex is on both of its edges.",
        source="6.2.1, 5.2; A12",
        others="the same edge only; the whole string",
        choice=None,
    ),
    Reading(
        id="reading/occupied",
        sentence="A body across several edges occupies all of them between its borders.",
        source="6.2.1; A13",
        others="its borders only",
        choice=None,
    ),
    Reading(
        id="reading/vertex-names",
        sentence="A border at a vertex that two edges share is named by the edge that it came along, or by the next "
        "once it has been asked to go on; both names are one place.",
        source="6.1.1; A57",
        others="either name",
        choice=None,
    ),
    Reading(
        id="reading/unique-edge",
        sentence="A level in which two ground edges leave a vertex in one direction is refused.",
        source="6.1.3; A41",
        others="the first; a fork",
        choice=None,
    ),
    Reading(
        id="reading/left-to-right",
        sentence="Left to right is the order of the level's vertices, in the plane of the level unrolled.",
        source="4.1.1; A58",
        others="world axes",
        choice=None,
    ),
    Reading(
        id="reading/all-push",
        sentence="Every body may push every other.",
        source="1.1; A39",
        others="only some bodies may",
        choice=None,
    ),
    Reading(
        id="reading/touching-characters",
        sentence="Two touching characters under one key each act in their own turn, so one may move twice.",
        source="1.1; A3, A53",
        others="what others moved it counts",
        choice=None,
    ),
    Reading(
        id="reading/kept-speed",
        sentence="A block leaves a body's velocity unchanged, and so does a push.",
        source="6.2.1; A2, A38",
        others="0; the pusher's; the actual distance per time",
        choice=None,
    ),
)

READINGS: tuple[Reading[object], ...] = (PUSH_LIMIT, TICK_ORDER, *RECORDED)
