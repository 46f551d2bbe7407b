"""Readings: what the thesis leaves open, as named choices (rows A of the register)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Generic, TypeVar

from spec.rules.leave import Landing, rear_at_near_end, rear_keeps_across

Choice = TypeVar("Choice", covariant=True)


@dataclass(frozen=True)
class Reading(Generic[Choice]):
    """A question the thesis leaves open; `sentence` is the answer taken, `choice` what computes it, if anything.

    `scenario` is one of the library in which the answer can be seen, if any.
    """

    id: str
    sentence: str
    source: str
    others: str
    choice: Choice
    scenario: str = ""

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

LANDING: Reading[Landing] = Reading(
    id="reading/landing-position",
    sentence="A falling body lands with its rear border at the foot of the fall edge, a jumping one with it at the "
    "near corner of the top.",
    source="6.2.1d, 6.2.1e, 6.4.1, 7.2; A15, A19",
    others="it keeps its horizontal position (the profile thesis/overshoot); centred",
    choice=rear_at_near_end,
)

LANDING_OVERSHOOT: Reading[Landing] = Reading(
    id="reading/landing-overshoot",
    sentence="A falling or jumping body keeps its horizontal position, so that it lands as far beyond the foot or the "
    "near corner as it had moved beyond the ledge.",
    source="1.2, 6.2.1d, 6.2.1e; A15, A19",
    others="its rear border lands at the foot or the near corner (the profile thesis)",
    choice=rear_keeps_across,
)


def reading(name: str, sentence: str, source: str, others: str, scenario: str = "") -> Reading[None]:
    """A reading that is written down in the rules themselves."""
    return Reading(f"reading/{name}", sentence, source, others, None, scenario)


OF_STRINGS: tuple[Reading[None], ...] = (
    reading(
        "at-the-limit",
        "At the push limit the body there counts as a wall, and the chain closes up to it.",
        "4.2; A6",
        "nothing moves",
    ),
    reading(
        "short-circle",
        "On a circle with less free space than the distance, the row moves by the free space and stops.",
        "4.2; A7",
        "the whole ring rotates",
    ),
    reading(
        "too-near",
        "Towards a body nearer than the margin the free distance is 0; a level may not start so.",
        "6.2.1; A10",
        "the bodies move apart",
    ),
    reading(
        "width",
        "A body's width is the distance along the graph between its borders.",
        "4.3.1, 4.3.2; A11, A31",
        "plus margins; Euclidean",
    ),
    reading(
        "margin-to-bodies",
        "The collision margin is kept towards bodies only, not towards walls.",
        "6.2.1; A9",
        "towards everything",
    ),
    reading(
        "sight",
        "Before each move along one edge the bodies on it and on the next ground edge are looked at; a "
        "border at a vertex is on both of its edges.",
        "6.2.1, 5.2; A12",
        "the same edge only; the whole string",
    ),
    reading(
        "occupied",
        "A body across several edges occupies all of them between its borders.",
        "6.2.1; A13",
        "its borders only",
    ),
    reading(
        "vertex-names",
        "A border at a vertex that two edges share is named by the edge that it came along, or by the next "
        "once it has been asked to go on; both names are one place.",
        "6.1.1; A57",
        "either name",
    ),
    reading(
        "unique-edge",
        "A level in which two ground edges leave a vertex in one direction is refused.",
        "6.1.3; A41",
        "the first; a fork",
    ),
    reading(
        "left-to-right",
        "Left to right is the order of the level's vertices, in the plane of the level unrolled.",
        "4.1.1; A58",
        "world axes",
    ),
    reading(
        "all-push",
        "Every body may push every other.",
        "1.1; A39",
        "only some bodies may",
    ),
    reading(
        "touching-characters",
        "Two touching characters under one key each act in their own turn, so one may move twice.",
        "1.1; A3, A53",
        "what others moved it counts",
    ),
    reading(
        "kept-speed",
        "A block leaves a body's velocity unchanged, and so does a push.",
        "6.2.1; A2, A38",
        "0; the pusher's; the actual distance per time",
    ),
)

OF_LEDGES: tuple[Reading[None], ...] = (
    reading(
        "both-in-overhang",
        "Both borders are in overhang when both are strictly beyond the same end.",
        "6.2.1d; A14",
        "either border; beyond any end",
    ),
    reading(
        "when-pushed-off",
        "A body that is pushed off its ledge falls inside the request that moved it, the front-most body first.",
        "6.2.1d; A4",
        "in its own turn; never, if its velocity is 0",
    ),
    reading(
        "landing-too-short",
        "A landing goes on onto the next ground edge, or overhangs; where a wall stands in the way it does not fit.",
        "6.2.1d; A16",
        "it is illegal",
    ),
    reading(
        "after-a-fall",
        "A request that ends in a fall or a jump returns the distance walked before it; the velocity is kept.",
        "6.2.1d; A17",
        "it goes on with what is left; the velocity is lost",
    ),
    reading("overhang", "A request may overhang a ledge by any distance.", "6.2.1; A55", "a maximum overhang"),
    reading(
        "when-to-jump",
        "A jump starts, like a fall, when both borders are beyond the ledge.",
        "6.2.1e; A18",
        "with the front border at the ledge",
    ),
    reading(
        "horizontal-distance",
        "The horizontal distance of a jump edge goes from the ledge to the nearest corner of the top, in the direction "
        "of the motion; it counts from 0 on, up to less than the body's width.",
        "6.2.1; A20",
        "to the far corner; unsigned; the gap between the intervals",
    ),
    reading("level-jump", "A jump edge of height 0 does not lead up.", "6.2.1; A21", "it leads up"),
    reading(
        "own-corners",
        "A body does not jump onto itself, its riders, theirs, or the corners of its own support.",
        "6.2.1; A22",
        "these count, and block it for ever",
    ),
    reading(
        "which-jump",
        "Of several jump edges that do not lead up, the one with the smallest drop is taken, among equals the one to "
        "the nearest corner, then the first in the level's order; others that lead up do not matter.",
        "6.2.1; A23",
        "two supports; any that leads up blocks",
    ),
    reading(
        "where-blocked",
        "A blocked body stands with its rear border exactly at the ledge, which is on the edge.",
        "6.2.1; A24",
        "in full overhang; the whole move is refused",
    ),
    reading(
        "live-jump-edges",
        "Jump edges are found by the side to which a ledge falls; where their tops are is read when they are used.",
        "6.1.3; A25",
        "all is fixed at start-up",
    ),
    reading(
        "end-of-a-top",
        "At the corner of a top without a near jump edge a body is blocked.",
        "4.4, 6.6c, 7.2; A26",
        "it falls; a wall stands there",
    ),
    reading(
        "carried",
        "A rider is carried with its support, unchecked.",
        "4.4; A27",
        "carried with collisions; it slides",
    ),
    reading("support-falls", "A rider goes with a support that falls.", "4.4; A28", "it drops"),
    reading(
        "one-support",
        "A rider has one support, and may overhang its top.",
        "4.4; A29",
        "its width changes",
    ),
    reading(
        "top-corners",
        "A top's corners are straight above the borders, by the body's height.",
        "T6.1, 1.2; A30",
        "along the normal of the ground",
    ),
    reading(
        "steep-edges",
        "An edge steeper than 60 degrees is a fall edge; seen from below it is a wall.",
        "6.1.3; A42",
        "another angle",
    ),
    reading(
        "one-fall",
        "A request passes any number of vertices, but falls or jumps once for each body.",
        "6.2.1; A48",
        "one transition; any number of falls",
    ),
    reading(
        "rider-speed",
        "A rider's own movement is relative to its support.",
        "4.4, 1.1; A52",
        "in the plane",
    ),
    reading(
        "top-to-ledge",
        "A jump edge between a ledge and a top also leads from the top to the ledge, if it does not lead up and the "
        "ledge's first body length is free.",
        "6.1.3; A54",
        "only from the ledge",
    ),
    reading(
        "position-in-overhang",
        "In overhang a border is on the line of its edge, continued.",
        "6.1.1; A56",
        "at the end of the edge",
    ),
)

OF_VELOCITIES: tuple[Reading[None], ...] = (
    reading(
        "steepness",
        "Steepness is how far it is down from one border of a body to the other, for each unit of its width along the "
        "graph: on one edge the sine of its angle, across a vertex the mean of the slopes under the body, and the run "
        "likewise.",
        "6.3.2; A33, A31",
        "for each unit of the distance through the air, which is irrational across a vertex; not for each unit of "
        "anything",
        "physics-slope",
    ),
    reading(
        "sign-of-steepness",
        "Steepness is positive where gravity accelerates to the right.",
        "6.3.2; A34",
        "positive uphill",
        "physics-slope-printed",
    ),
    reading(
        "velocity-along-the-ground",
        "A velocity is along the ground, in the direction of the tangent.",
        "T6.3; P4",
        'along the normal, as table 6.3 has it ("start velocity along the edges normal")',
        "physics-slope-printed",
    ),
    reading(
        "static-bodies",
        "Characters and bodies of which a level gives only the velocity are static; gravity, friction, drag and bounds "
        "leave them alone, on slopes too.",
        "6.3.1; R26, A40",
        "gravity pulls them; bounds and drag change them",
        "physics-barge-printed",
    ),
    reading(
        "minimum-velocity",
        "The minimum is one of the magnitude, after gravity and friction; so a body at rest does not begin to move "
        "where one tick gives it less.",
        "6.3.1; A35",
        "of the signed velocity; before gravity; not for a body that is speeding up (thesis/mended-velocity)",
        "physics-drag-printed",
    ),
    reading(
        "order-of-forces",
        "Gravity comes first, then friction, drag, the maximum and the minimum.",
        "6.3.1, F6.7; A36",
        "drag first",
        "physics-drag-printed",
    ),
    reading(
        "drag",
        "Drag is the factor by which the velocity is multiplied in each tick.",
        "6.3.1, T2.2; A37",
        "v (1 - drag dt); v / (1 + damping dt), as Box2D has it (thesis/mended-velocity)",
        "physics-drag-printed",
    ),
    reading(
        "gravity",
        "Gravity is 9.81 unless a level says otherwise.",
        "6.3.3; R28, P3",
        "10, with which the prototype came nearer to Box2D",
        "physics-slope-printed",
    ),
    reading(
        "velocity-kept-at-a-block",
        "A body that is stopped by a wall or a row goes on to push until friction has ended its velocity; one that is "
        "pushed keeps its own.",
        "6.2.1c, 6.3.4; A2, A38",
        "what is stopped has the velocity with which it moved in the end (thesis/mended-velocity); what is pushed has "
        "the pusher's",
        "physics-barge-printed",
    ),
    reading(
        "body-at-its-turn",
        "The slope under a body is that where it stands at its turn, also if it has been pushed there in this tick.",
        "5.2; R10, A3",
        "all velocities are found before anybody moves",
        "physics-barge-printed",
    ),
)

OF_STOREYS: tuple[Reading[None], ...] = (
    reading(
        "repaired/sliding-drive",
        "For the length of a tick, the drive of a body that moves of its own is its velocity, relative to what it "
        "stands on; all ground and all tops are level.",
        "6.3.1, 4.4; R26, A52",
        "in the plane, so that what carries it slips away below it",
        "repaired-slide",
    ),
    reading(
        "repaired/velocity-at-a-block",
        "A dynamic body that does not move with its velocity in the end of a tick has from then on the one with which "
        "it does, relative to what it stands on; what is pushed gets none.",
        "6.2.1c, 6.3.4; A2, A38, O8",
        "it keeps its velocity; what is pushed takes over the pusher's",
        "repaired-slide",
    ),
    reading(
        "repaired/friction-of-tops",
        "Only edges have a coefficient of friction of their own; under a body across a vertex it is the mean of those "
        "under its borders that have one. On the top of a body that of the rider counts alone.",
        "6.3.4; O9, P7",
        "the mean with that of the body below",
        "repaired-slide",
    ),
    reading(
        "repaired/in-the-plane",
        "A character that walks keeps its own velocity in the plane, whatever it stands on; what is not driven is "
        "carried.",
        "4.4, 1.1; A27, A52, A53",
        "a walker's velocity is relative to its support, so that it is twice as fast on another",
        "repaired-one-key",
    ),
    reading(
        "repaired/opposite-wishes",
        "Opposite wishes stall each other, whatever the speeds; so does a box that is carried slowly against a fast "
        "walker.",
        "6.2.1c; A2, P6",
        "the faster wins; the difference of the speeds is left",
        "repaired-squeezed",
    ),
    reading(
        "repaired/squeezed-passes-nothing",
        "What stands beyond a squeezed body is not pushed by it.",
        "6.2.1c; A2",
        "speeds go on through it",
        "repaired-squeezed-passes-nothing",
    ),
    reading(
        "repaired/may-not-push",
        "To a body that may not push, any other is a wall, one that moves if it moves. It may be pushed itself, but "
        "passes no push on.",
        "1.1; A39",
        "it can neither push nor be pushed; a second permission, to be pushed",
        "repaired-may-not-push",
    ),
    reading(
        "repaired/exact-pit",
        "A pit of exactly the body's width swallows a walker at the instant at which it fits, also in the middle of a "
        "step.",
        "6.2.1; A59",
        "only at the end of a request, which makes the outcome depend on the size of the step",
        "repaired-exact-pit",
    ),
    reading(
        "repaired/narrow-slot",
        "A body still holds one that has left its top while the gap between them is less than the margin, so that "
        "nothing falls into a slot narrower than the margin allows; it is carried for so long.",
        "6.2.1d; A14, R24",
        "only while they overlap",
        "repaired-slot",
    ),
    reading(
        "repaired/which-top",
        "Over several tops a body stands on the one that is front-most in its motion relative to the support it lost; "
        "without such motion on the one that it is over most, if it is over none on the nearest, then on the first in "
        "the level's order.",
        "6.2.1; A23",
        "the nearest; two supports",
        "repaired-front-most",
    ),
    reading(
        "repaired/support-falls",
        "A rider whose support falls looks for a support of its own: it follows only if nothing else holds it.",
        "4.4; A28",
        "it goes with its support",
        "repaired-support-falls",
    ),
    reading(
        "repaired/lost-for-an-instant",
        "A support that a body has moved off does not count again at the same instant; later it may, if it holds.",
        "6.2.1d; R21",
        "not until the motion turns",
        "repaired-slot",
    ),
    reading(
        "repaired/thin-wall",
        "Two bodies with a wall between them are no neighbours, so that none pushes the other through it. A level with "
        "a wall thinner than the margin is refused.",
        "6.2.1; A9, A12",
        "bodies collide through walls",
        "repaired-thin-wall",
    ),
    reading(
        "repaired/closed-ring",
        "A row of two bodies or more that closes on itself round a ring stands still; with any room left, it first "
        "goes on until the room is used up.",
        "4.2; R31, A7",
        "the whole ring rotates",
        "repaired-closed-ring",
    ),
    reading(
        "repaired/ends-of-levels",
        "The ends of a level on a line are walls, as high as one likes; ground that ends in the open within a level, "
        "without a fall edge, is refused.",
        "6.2.1b; R19, A42",
        "one falls off the end; an invisible wall",
        "repaired-scraped-off",
    ),
)

READINGS: tuple[Reading[object], ...] = (
    PUSH_LIMIT,
    TICK_ORDER,
    LANDING,
    LANDING_OVERSHOOT,
    *OF_STRINGS,
    *OF_LEDGES,
    *OF_VELOCITIES,
    *OF_STOREYS,
)
