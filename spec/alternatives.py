"""Alternatives: other readings of what the thesis leaves open, each a small change of the profile `thesis`.

An alternative that is about rules says here what changes. One that is about the world, the level or the tick has its
sentence here; what computes it is in the reference (`reference/alternatives.py`).
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

from spec.otherwise import (
    AT_THE_LEDGE,
    NEXT_NAME,
    OFF_THE_WALL,
    Instead,
    Requesting,
    Seen,
    any_up_blocks,
    either_border_falls,
    fall_where_it_fits,
    falls_at_the_instant,
    falls_on,
    front_jumps,
    goes_on,
    jump_to_the_middle,
    level_leads_up,
    one_vertex,
    refused_at_the_ledge,
    short_overhang,
    walled_corners,
    with_rule,
    without_margins,
)
from spec.profiles import OVERSHOOT, THESIS, Profile
from spec.rules.clearance import CLEARANCE, up_to_margin
from spec.rules.leave import LEAVE, fall, jump_down_least, stay
from spec.rules.request import request


@dataclass(frozen=True)
class Alternative:
    """Another answer to the question of a reading.

    Attributes:
        of: the ID of the reading to which it is another.
        profile: the rules under it; those of `thesis` where it is not about rules.
        request: how a request is carried out under it.
    """

    id: str
    sentence: str
    source: str
    of: str
    profile: Profile = THESIS
    request: Requesting = request

    kind = "alternative"


def thesis_with(**changes: Any) -> Profile:
    """The profile `thesis` with some families changed."""
    return replace(THESIS, rules=replace(THESIS.rules, **changes))


def twice_the_bodies(bodies: int) -> int:
    """Twice as many as there are bodies."""
    return 2 * bodies


def alternative(
    name: str, sentence: str, source: str, profile: Profile = THESIS, asked: Requesting = request
) -> Alternative:
    """An alternative; its name is that of its reading and its own."""
    return Alternative(f"reading/{name}", sentence, source, f"reading/{name.rpartition('/')[0]}", profile, asked)


OF_RULES: tuple[Alternative, ...] = (
    alternative(
        "push-limit/larger",
        "The push limit is twice the number of bodies, so that on a ring a body pushes itself.",
        "4.2; A8",
        replace(THESIS, push_limit=twice_the_bodies),
    ),
    alternative(
        "margin-to-bodies/walls-too",
        "The margin is kept towards walls too.",
        "6.2.1; A9",
        thesis_with(walk=OFF_THE_WALL),
    ),
    alternative(
        "too-near/apart",
        "Bodies that are nearer than the margin move apart when one moves towards the other.",
        "6.2.1; A10",
        thesis_with(clearance=with_rule(CLEARANCE, "clearance/too-near", effect=up_to_margin)),
    ),
    alternative(
        "vertex-names/next-edge",
        "A border at a vertex that two edges share is named by the edge ahead.",
        "6.1.1; A57",
        thesis_with(walk=NEXT_NAME),
    ),
    alternative(
        "landing-position/overshoot",
        "A falling or jumping body keeps its horizontal position: the profile `thesis/overshoot`.",
        "6.2.1d, 6.2.1e; A15, A19",
        OVERSHOOT,
    ),
    alternative(
        "landing-position/centred",
        "A jumping body lands in the middle of the top.",
        "6.2.1e; A19",
        thesis_with(leave=with_rule(LEAVE, "leave/jump", effect=jump_to_the_middle)),
    ),
    alternative(
        "both-in-overhang/either-border",
        "A body falls, jumps or is blocked as soon as one border is beyond the end of its edge.",
        "6.2.1d; A14",
        asked=either_border_falls,
    ),
    alternative(
        "landing-too-short/illegal",
        "Where the edge below is shorter than the body, the body does not fall: it is blocked at the ledge.",
        "6.2.1d; A16",
        thesis_with(leave=with_rule(LEAVE, "leave/fall", effect=fall_where_it_fits)),
    ),
    alternative(
        "after-a-fall/goes-on",
        "After a fall or a jump the body goes on by what it had moved beyond the ledge.",
        "6.2.1d; A17",
        asked=goes_on,
    ),
    alternative(
        "overhang/limited",
        "A border goes no further into overhang than its body's width and a margin.",
        "6.2.1; A55, O2",
        asked=short_overhang,
    ),
    alternative(
        "overhang/instant",
        "A move ends at the instant at which its body fits beside the ledge, and there it falls or jumps.",
        "6.2.1; A59",
        asked=falls_at_the_instant,
    ),
    alternative(
        "when-to-jump/front",
        "A jump starts when the front border is beyond the ledge.",
        "6.2.1e; A18",
        asked=front_jumps,
    ),
    alternative(
        "level-jump/leads-up",
        "A jump edge of height 0 leads up.",
        "6.2.1; A21",
        thesis_with(leave=Seen(LEAVE, level_leads_up)),
    ),
    alternative(
        "which-jump/any-up-blocks",
        "A near jump edge that leads up blocks, whatever the others do.",
        "6.2.1; A23",
        thesis_with(leave=Seen(LEAVE, any_up_blocks)),
    ),
    alternative(
        "where-blocked/overhang",
        "A blocked body stays in full overhang.",
        "6.2.1; A24",
        thesis_with(leave=Instead(LEAVE, AT_THE_LEDGE, stay)),
    ),
    alternative(
        "where-blocked/refused",
        "A request that would end blocked at a ledge does not move its body.",
        "6.2.1; A24",
        asked=refused_at_the_ledge,
    ),
    alternative(
        "end-of-a-top/wall",
        "At the corner of a top from which no jump edge is near stands a wall: nothing overhangs it.",
        "4.4, 6.6c; A26",
        asked=walled_corners,
    ),
    alternative(
        "one-fall/one-transition",
        "A request passes one vertex, and ends where it would pass another.",
        "6.2.1; A48",
        asked=one_vertex,
    ),
    alternative(
        "one-fall/any-number",
        "A body falls or jumps as often as it can in one request.",
        "6.2.1; A48",
        asked=falls_on,
    ),
)

OF_WORLDS: tuple[Alternative, ...] = (
    alternative("at-the-limit/nothing-moves", "A request in which the push limit is reached moves nobody.", "4.2; A6"),
    alternative(
        "short-circle/rotates",
        "On a circle with less free space than the distance, the whole ring goes round.",
        "4.2; A7",
    ),
    alternative(
        "push-limit/requests-per-tick",
        "The push limit counts all requests of one tick, however often the same body is asked.",
        "4.2; A5",
    ),
    alternative(
        "width/with-margins",
        "For jumps, a body's width is the distance between its borders and the margin on either side.",
        "4.3.2; A11",
        thesis_with(
            leave=with_rule(
                with_rule(LEAVE, "leave/fall", effect=without_margins(fall)),
                "leave/jump",
                effect=without_margins(jump_down_least),
            )
        ),
    ),
    alternative("width/euclidean", "A body's width is the distance of its borders in the plane.", "4.3.1; A31"),
    alternative("sight/same-edge", "Only bodies on the same edge are looked at.", "5.2, 6.2.1; A12"),
    alternative("sight/whole-string", "All bodies on the string of edges are looked at.", "6.2.1; A12"),
    alternative(
        "occupied/borders",
        "A body across several edges is only on the edges of its borders, also where it presses a button.",
        "6.2.1; A13",
    ),
    alternative(
        "unique-edge/first",
        "Of two ground edges that leave a vertex in one direction the first is taken; the other begins on its own.",
        "6.1.3; A41",
    ),
    alternative("left-to-right/world-axes", "Left to right is the direction of the world's x axis.", "4.1.1; A58"),
    alternative("steep-edges/45-degrees", "An edge steeper than 45 degrees is a fall edge.", "6.1.3; A42"),
    alternative(
        "both-in-overhang/any-ends",
        "Both borders are in overhang when each is beyond an end of the edge, be it the same or not.",
        "6.2.1d; A14",
    ),
    alternative(
        "horizontal-distance/far-corner",
        "The horizontal distance of a jump edge goes to the far corner of the top.",
        "6.2.1; A20",
    ),
    alternative(
        "horizontal-distance/unsigned",
        "The horizontal distance of a jump edge counts alike in both directions.",
        "6.2.1; A20",
    ),
    alternative(
        "horizontal-distance/intervals",
        "The horizontal distance of a jump edge is that to the interval of the top, 0 where it is below.",
        "6.2.1; A20",
    ),
    alternative(
        "own-corners/included",
        "A body's own top, the tops of its riders and of its support count as tops to jump to.",
        "6.2.1; A22",
    ),
    alternative(
        "live-jump-edges/fixed",
        "Where a jump edge leads, and whether it is near, is fixed at the start of the level.",
        "6.1.3; A25",
    ),
    alternative(
        "end-of-a-top/falls",
        "At the corner of a top with no near jump edge a body falls, and lands the margin beside its support.",
        "4.4, 7.2; A26",
    ),
    alternative(
        "carried/slides", "A rider stays where it is in the plane while its support moves under it.", "4.4; A27"
    ),
    alternative(
        "carried/with-collisions",
        "A rider is carried until it is the margin from another body, or at terrain, and slides from there.",
        "4.4; A27",
    ),
    alternative(
        "support-falls/drops",
        "A rider of a support that falls or jumps drops to the edge on which the support stood.",
        "4.4; A28",
    ),
    alternative(
        "top-corners/normal", "A top's corners are above the borders along the normal of the ground.", "T6.1; A30"
    ),
    alternative(
        "top-to-ledge/only-from-the-ledge",
        "Jump edges lead from ledges to tops and from top to top, but from no top to a ledge.",
        "6.1.3; A54",
    ),
    alternative("position-in-overhang/clamped", "In overhang a border is at the end of its edge.", "6.1.1; A56"),
)

OF_TICKS: tuple[Alternative, ...] = (
    alternative(
        "tick-order/simultaneous",
        "In a tick every character moves from the state at its beginning; where two moved a body, its own move "
        "counts, or the later one.",
        "5.2; A1",
    ),
    alternative(
        "kept-speed/pushers",
        "A pushed body takes the velocity of the character that pushed it, and goes on with it in its own turn.",
        "6.2.1c, 6.3.4; A2",
    ),
    alternative(
        "touching-characters/once", "A character that others have moved in a tick has no turn in it.", "6.2.1c; A3"
    ),
    alternative(
        "touching-characters/counts",
        "How far others have moved a character in a tick counts as its own movement.",
        "1.1; A53",
    ),
    alternative(
        "when-pushed-off/own-turn", "A body that is pushed off its ledge falls when it is next asked.", "6.2.1d; A4"
    ),
    alternative(
        "when-pushed-off/never",
        "A body that is pushed off its ledge stays beyond it until it moves itself.",
        "6.2.1d; A4",
    ),
    alternative("rider-speed/in-the-plane", "A character that rides moves by its own speed in the plane.", "4.4; A52"),
)

ALTERNATIVES: tuple[Alternative, ...] = (*OF_RULES, *OF_WORLDS, *OF_TICKS)
