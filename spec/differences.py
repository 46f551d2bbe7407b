"""Differences: why one step from one state ends otherwise under `repaired` than under `thesis`.

The list is closed: where bodies end in different places, one of these causes is at work.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Difference:
    """A cause for which the two profiles differ; `scenario` is one of the library in which it is seen."""

    id: str
    sentence: str
    source: str
    scenario: str

    kind = "difference"


LANDING = Difference(
    "difference/landing",
    "The thesis puts a body that falls or jumps with its rear border at the foot or the near corner, and ends its "
    "request there; repaired, it comes down where it lost its support, and goes on.",
    "6.2.1d, 6.2.1e; A15, A17, A19, A48",
    "figure-1-2-fall-edge",
)
AT_THE_LEDGE = Difference(
    "difference/at-the-ledge",
    "In the thesis a body whose rear border is exactly at the end of its edge stands on it; repaired, it has lost its "
    "support.",
    "6.2.1d; A14, A24",
    "figure-6-3d-unobstructed-ledge",
)
NARROW_PIT = Difference(
    "difference/narrow-pit",
    "In the thesis a pit narrower than the body swallows it; repaired, the ground beyond holds it.",
    "6.6a; U1",
    "figure-6-6a-short-pit",
)
HELD_BY_TOP = Difference(
    "difference/held-by-the-top",
    "In the thesis a body leaves a top when its rear border passes the corner; repaired, the top holds it until it is "
    "the margin beyond, and on a ring also if it is under it the other way round.",
    "6.2.1d; A14, R24",
    "repaired-slot",
)
STOPPED_BEFORE = Difference(
    "difference/stopped-before",
    "The thesis lets a body fall or jump that, repaired, is stopped on its support, by what stands beyond the ledge.",
    "6.2.1e, 6.6b; R25, A23, U2, U9",
    "difference-stopped-before",
)
CORNER = Difference(
    "difference/corner",
    "In the thesis the corner of a top with no jump edge near blocks a body; repaired, it goes on, and falls off.",
    "4.4, 6.6f, 7.2; A26, U6, U7",
    "fall-off-a-body",
)
FAR_END_TAKEN = Difference(
    "difference/far-end-taken",
    "In the thesis a body is blocked at a ledge where all jump edges lead up, or to where there is no room; repaired, "
    "it pushes what is there, or goes on.",
    "6.2.1; R25, A24, A54",
    "far-ledge-not-free",
)
SUPPORT_FALLS = Difference(
    "difference/support-falls",
    "In the thesis a rider goes with a support that falls or jumps; repaired, it looks for a support of its own.",
    "4.4; A28",
    "rider-over-a-fall",
)
CARRIED = Difference(
    "difference/carried",
    "In the thesis a rider is carried unchecked; repaired, it is stopped by walls and bodies, and slides.",
    "4.4; A27, U9",
    "rider-carried-into-wall",
)
OTHER_STRING = Difference(
    "difference/other-string",
    "In the thesis a body does not see what is not next to it on its string of edges; repaired, it meets all that is "
    "on its storey.",
    "6.2.2; A12, U9",
    "difference-other-string",
)
INTO_TERRAIN = Difference(
    "difference/into-terrain",
    "In the thesis an overhang goes on into a wall; repaired, the wall stops it.",
    "6.6b, 6.6c; U2, U3, U11",
    "figure-6-6b-short-pit-with-heights",
)
OUT_OF_SIGHT = Difference(
    "difference/out-of-sight",
    "In the thesis a body nearer than the margin is out of sight if it is beyond the next edge, which is shorter than "
    "the margin; repaired, edges do not matter.",
    "6.2.1; A12",
    "edges-below-margin",
)
ROUND_A_RING = Difference(
    "difference/round-a-ring",
    "In the thesis a chain that comes round to its mover is stopped by where that began; repaired, all of it moves at "
    "once, and stops only where it closes on itself.",
    "4.2; R31, A7, A8",
    "ring-of-two-at-once",
)
RIDER_SPEED = Difference(
    "difference/rider-speed",
    "In the thesis a character on a body that moves has its own speed on top; repaired, it has its own in the plane.",
    "1.1, 4.4; R1, A52",
    "rider-with-own-speed",
)
TURNS = Difference(
    "difference/turns",
    "In the thesis bodies move in turn, so that one moves twice, or stops at another that has yet to move; repaired, "
    "all move at once.",
    "1.1, 5.2; A1, A3, A53",
    "touching-characters",
)

DIFFERENCES: tuple[Difference, ...] = (
    LANDING,
    AT_THE_LEDGE,
    NARROW_PIT,
    HELD_BY_TOP,
    STOPPED_BEFORE,
    CORNER,
    FAR_END_TAKEN,
    SUPPORT_FALLS,
    CARRIED,
    OTHER_STRING,
    INTO_TERRAIN,
    OUT_OF_SIGHT,
    ROUND_A_RING,
    RIDER_SPEED,
    TURNS,
)
