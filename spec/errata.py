"""Errata: what is wrong with the rules as printed, each with the mended rules and the claims that show the mend.

P5 to P8 of the register are physically wrong and are kept in `repaired` on purpose: those have no mend.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Erratum:
    """A defect of the printed rules.

    Attributes:
        sentence: what is wrong; of one that is kept, also why.
        printed: the IDs of the printed rules and readings by which it comes.
        witness: a scenario of the library in which it is seen.
        refuted: the IDs of the claims that it refutes.
        mended: the IDs of what holds instead under `repaired`, and of a small change of the printed rules if there is
            one; none where the defect is kept.
        evidence: the IDs of the claims that show that the mend removes it.
    """

    id: str
    sentence: str
    source: str
    printed: tuple[str, ...]
    witness: str
    refuted: tuple[str, ...] = ()
    mended: tuple[str, ...] = ()
    evidence: tuple[str, ...] = ()

    kind = "erratum"


REPLAYED = "claim/witnesses-mended"
"""The claim that plays the witnesses under `repaired`."""

ON_STRINGS: tuple[Erratum, ...] = (
    Erratum(
        "erratum/short-edges",
        "A body that is nearer than the margin, but beyond the next ground edge, is not looked at: where edges are "
        "shorter than the margin it is not kept, and nobody is pushed.",
        "6.2.1; R24, A12",
        printed=("clearance/nobody", "reading/sight"),
        witness="edges-below-margin",
        refuted=("claim/no-overlap-on-short-edges", "claim/pushing-on-short-edges", "claim/split-anywhere"),
        mended=("difference/out-of-sight", "model/neighbours", "event/contact"),
        evidence=("claim/step-margin", REPLAYED),
    ),
    Erratum(
        "erratum/loops",
        "A chain of requests comes round to its mover also on a circle with room, whenever that is less than the "
        "distance; two requests then go further than one of their sum.",
        "4.2; E11, R31, A7, A8",
        printed=("push/limit", "reading/short-circle"),
        witness="ring-of-two",
        refuted=("claim/loops-only-on-a-full-circle", "claim/additive-on-any-ring"),
        mended=("difference/round-a-ring", "row/ring", "reading/repaired/closed-ring"),
        evidence=("claim/step-split", REPLAYED),
    ),
    Erratum(
        "erratum/neighbours-twice",
        "On a ring of two bodies, the list of left and right neighbours contains a body twice.",
        "4.2; E11",
        printed=("push/request",),
        witness="ring-of-two",
        refuted=("claim/neighbours-not-twice",),
        mended=("model/row", "row/ring"),
        evidence=("claim/step-margin", REPLAYED),
    ),
    Erratum(
        "erratum/one-key",
        "Two touching characters under one key act in turn, so that the one in front moves twice as far.",
        "1.1; R1, A1, A3, A53",
        printed=("reading/tick-order", "reading/touching-characters"),
        witness="touching-characters",
        refuted=("claim/constant-speed-in-contact",),
        mended=("difference/turns", "wish/plane", "row/own"),
        evidence=("claim/step-one-key", REPLAYED),
    ),
)

ON_LEDGES: tuple[Erratum, ...] = (
    Erratum(
        "erratum/jump-test-margin",
        "The test of jump edges compares their horizontal distance with the width alone, and leaves out the margin: a "
        "body falls to nearer to another than the margin.",
        "6.2.1; R24, R25, E12",
        printed=("leave/fall",),
        witness="lands-near",
        refuted=("claim/plane-margin", "claim/plane-margin/overshoot"),
        mended=("mend/margin-in-jump-test", "settle/jump", "settle/fall", "event/contact"),
        evidence=("claim/step-margin", REPLAYED),
    ),
    Erratum(
        "erratum/jump-proxy",
        "The horizontal distance from the ledge says whether the landing is free only where the fall is vertical and "
        "the landing level: else a body falls into another, or jumps onto one beside which it would have had room.",
        "6.2.1; P9, E12",
        printed=("leave/fall", "leave/jump", "reading/horizontal-distance"),
        witness="slanted-fall-edge",
        refuted=("claim/proxy-on-slanted-falls", "claim/proxy-on-tilted-landings"),
        mended=("settle/ground", "settle/jump", "settle/fall"),
        evidence=("claim/step-margin", "claim/step-seat"),
    ),
    Erratum(
        "erratum/overshoot",
        "A body that keeps its horizontal position in a fall may come down in the far wall of a pit, or in a body that "
        "stands a width away from the ledge.",
        "6.2.1d; A15, U11, E12",
        printed=("reading/landing-overshoot", "fit/wall", "leave/fall"),
        witness="overshoot-into-wall",
        refuted=(
            "claim/terrain/overshoot",
            "claim/plane-apart-of-two/overshoot",
            "claim/proxy-on-level-ground/overshoot",
        ),
        mended=("mend/landing-in-place", "difference/landing", "event/wall", "event/contact"),
        evidence=("claim/step-terrain", "claim/step-margin", REPLAYED),
    ),
    Erratum(
        "erratum/jumps-too-far",
        "A jump sets a body down at the near corner of the top, which may be further away than it was asked to move.",
        "1.2, 6.2.1e; R17, R33, A19",
        printed=("leave/jump", "reading/landing-position"),
        witness="lands-too-far",
        refuted=("claim/horizontal", "claim/horizontal/overshoot"),
        mended=("mend/landing-in-place", "difference/landing", "settle/jump"),
        evidence=("claim/step-motion", REPLAYED),
    ),
    Erratum(
        "erratum/ridden-top",
        "A jump edge leads to a top whoever stands there: a body jumps into the rider.",
        "6.2.1, 6.2.2; R25, U9",
        printed=("leave/jump",),
        witness="ridden-top",
        refuted=("claim/jump-clear-of-riders", "claim/jump-clear-of-riders/overshoot"),
        mended=("mend/look-at-landing", "model/neighbours", "event/contact"),
        evidence=("claim/step-margin", REPLAYED),
    ),
    Erratum(
        "erratum/leads-up",
        "Jump edges that lead up are dropped, and of the others the one with the smallest drop is taken: a body jumps "
        "down into one that stands higher.",
        "6.2.1; R25, A23",
        printed=("leave/jump", "reading/which-jump"),
        witness="ridden-top",
        refuted=("claim/what-leads-up-obstructs", "claim/what-leads-up-obstructs/overshoot"),
        mended=("mend/any-that-leads-up", "model/neighbours", "way/slower"),
        evidence=("claim/step-margin", REPLAYED),
    ),
    Erratum(
        "erratum/jumps-beside",
        "A jump looks at the top only that it leads to: the body comes down in terrain, or in another body, beside it.",
        "6.2.1, 6.6e; R25, A16",
        printed=("leave/jump", "fit/lands"),
        witness="lands-in-terrain",
        mended=("mend/look-at-landing", "event/wall", "event/contact"),
        evidence=("claim/step-terrain", "claim/step-margin", REPLAYED),
    ),
    Erratum(
        "erratum/through-floor",
        "A jump edge from an upper layer leads to a top on a lower one, whatever terrain is between.",
        "6.2.1, 6.2.2; R15, R22",
        printed=("leave/jump",),
        witness="through-floor",
        mended=("model/solid", "settle/ground"),
        evidence=("claim/step-terrain", "claim/step-seat"),
    ),
    Erratum(
        "erratum/stopped-from-above",
        "A body whose jump edge leads up blocks a ledge however high above it is.",
        "6.2.1; R25, A20",
        printed=("leave/blocked", "reading/horizontal-distance"),
        witness="stopped-from-above",
        mended=("model/neighbours", "settle/fall"),
        evidence=("claim/step-progress", REPLAYED),
    ),
    Erratum(
        "erratum/far-end-taken",
        "A body is stuck at a ledge where all jump edges lead up, or to where there is no room, though it may push.",
        "6.2.1; R25, A24, A54",
        printed=("leave/blocked", "reading/top-to-ledge", "reading/where-blocked"),
        witness="far-ledge-not-free",
        mended=("difference/far-end-taken", "row/pushed"),
        evidence=("claim/step-progress", REPLAYED),
    ),
)

ON_TOPS: tuple[Erratum, ...] = (
    Erratum(
        "erratum/carried",
        "A rider is carried unchecked, into walls and into other bodies.",
        "4.4; A27, U9",
        printed=("reading/carried", "walk/along"),
        witness="rider-carried-into-wall",
        refuted=("claim/carried-clear", "claim/carried-clear/overshoot"),
        mended=("difference/carried", "wish/carried", "way/wall", "way/slower"),
        evidence=("claim/step-margin", "claim/step-terrain", REPLAYED),
    ),
    Erratum(
        "erratum/support-falls",
        "A rider goes with a support that falls, into anything beside it.",
        "4.4; A28",
        printed=("reading/support-falls", "leave/fall"),
        witness="rider-over-a-fall",
        mended=("difference/support-falls", "reading/repaired/support-falls"),
        evidence=("claim/step-seat", REPLAYED),
    ),
    Erratum(
        "erratum/rider-speed",
        "A character on another walks at double speed, since its own movement is relative to its support.",
        "1.1, 4.4; R1, A52",
        printed=("reading/rider-speed",),
        witness="rider-with-own-speed",
        mended=("difference/rider-speed", "wish/plane", "reading/repaired/in-the-plane"),
        evidence=("claim/step-one-key", REPLAYED),
    ),
)

CONCEDED: tuple[Erratum, ...] = (
    Erratum(
        "erratum/short-pit",
        "A pit narrower than the body swallows it, for ledges have no jump edges to each other.",
        "6.6a; U1",
        printed=("leave/fall",),
        witness="figure-6-6a-short-pit",
        refuted=("claim/no-short-pit",),
        mended=("difference/narrow-pit", "model/holds"),
        evidence=("claim/step-seat", REPLAYED),
    ),
    Erratum(
        "erratum/overhang",
        "An overhang looks at nothing: it runs into the far wall of a pit, from the ground and from a top.",
        "6.6b, 6.6c; U2, U3",
        printed=("walk/overhang", "leave/stay"),
        witness="figure-6-6b-short-pit-with-heights",
        refuted=("claim/no-short-pit-heights", "claim/no-overhang-from-body"),
        mended=("difference/into-terrain", "way/wall"),
        evidence=("claim/step-terrain", REPLAYED),
    ),
    Erratum(
        "erratum/tunnel",
        "Nothing knows a body's height: it walks into a tunnel that is lower.",
        "6.6d; U4",
        printed=("walk/along",),
        witness="figure-6-6d-tunnel",
        refuted=("claim/no-tunnel",),
        mended=("model/solid", "way/wall"),
        evidence=("claim/step-terrain", REPLAYED),
    ),
    Erratum(
        "erratum/fall-onto-middle",
        "A body falls onto the middle of another, which no jump edge leads to, and comes to stand in it.",
        "6.6e; U5",
        printed=("leave/fall",),
        witness="figure-6-6e-falling-on-the-middle",
        refuted=("claim/no-fall-onto-middle",),
        mended=("settle/jump",),
        evidence=("claim/step-margin", REPLAYED),
    ),
    Erratum(
        "erratum/corner",
        "At the corner of a top with no near jump edge a body is stuck: it cannot fall off, nor step onto a ledge that "
        "begins in the middle of the top.",
        "6.6f, 7.2; U6, U7, A26",
        printed=("leave/nowhere", "reading/end-of-a-top"),
        witness="fall-off-a-body",
        refuted=("claim/no-sharp-ledge", "claim/no-fall-off-body"),
        mended=("difference/corner", "settle/fall"),
        evidence=("claim/step-progress", REPLAYED),
    ),
    Erratum(
        "erratum/other-strings",
        "A body does not see what is not on its string of edges: it walks into it, and overhangs meet over a pit.",
        "6.2.2; U9, A12",
        printed=("clearance/nobody", "walk/overhang"),
        witness="difference-other-string",
        refuted=("claim/no-other-strings",),
        mended=("difference/other-string", "model/neighbours", "event/contact"),
        evidence=("claim/step-margin", REPLAYED),
    ),
    Erratum(
        "erratum/landing-does-not-fit",
        "A landing in a pit shorter than the body ends inside the wall.",
        "6.2.1d; U11, A16",
        printed=("leave/fall", "fit/wall"),
        witness="landing-does-not-fit",
        refuted=("claim/no-landing-does-not-fit",),
        mended=("difference/into-terrain", "model/holds", "way/wall"),
        evidence=("claim/step-terrain", REPLAYED),
    ),
)

ON_SLOPES: tuple[Erratum, ...] = (
    Erratum(
        "erratum/normal-force",
        "The normal force is 1 - |sin| times gravity as printed; it is the cosine times gravity, so friction is too "
        "small on every slope.",
        "F6.7, 6.3.2; P1, R28",
        printed=("velocity/normal-printed",),
        witness="physics-slope-printed",
        refuted=("claim/friction-by-the-cosine",),
        mended=("velocity/normal",),
        evidence=("claim/rest-up-to-the-coefficient",),
    ),
    Erratum(
        "erratum/static-friction",
        "Static friction is said not to be simulated; a body at rest does stay at rest, for friction ends at 0, but as "
        "printed on too few slopes.",
        "6.3.2; P2, E3, R28",
        printed=("velocity/friction-holds", "velocity/normal-printed"),
        witness="physics-slope-printed",
        refuted=("claim/rest-on-slopes",),
        mended=("velocity/normal", "velocity/friction-holds"),
        evidence=("claim/rest-up-to-the-coefficient", "claim/rest-is-kept-by-friction/repaired"),
    ),
    Erratum(
        "erratum/drag-per-tick",
        "Drag multiplies the velocity once in each tick, so that it depends on the length of the tick.",
        "6.3.1, T2.2; P10, A37",
        printed=("velocity/drag-printed",),
        witness="physics-drag-printed",
        refuted=("claim/printed-drag-by-the-way",),
        mended=("velocity/drag",),
        evidence=("claim/drag-takes-by-the-way",),
    ),
    Erratum(
        "erratum/minimum-sticks",
        "A velocity below the minimum is set to 0, also that of a body that begins to move: it never does where a tick "
        "of gravity gives it less.",
        "6.3.1; R27, A35",
        printed=("velocity/minimum-printed",),
        witness="physics-drag-printed",
        refuted=("claim/minimum-lets-begin",),
        mended=("velocity/minimum", "velocity/begins"),
        evidence=("claim/rest-is-kept-by-friction/repaired",),
    ),
)

KEPT: tuple[Erratum, ...] = (
    Erratum(
        "erratum/falls-at-the-rear",
        "A body falls when its rear border leaves the ledge, not its centre of mass; kept, so that a body may bridge a "
        "pit of its width.",
        "6.2.1d; P5",
        printed=("leave/fall", "reading/both-in-overhang"),
        witness="figure-6-3d-unobstructed-ledge",
    ),
    Erratum(
        "erratum/pushing-makes-momentum",
        "A pusher sets any row in motion at its own speed, so that pushing makes momentum; kept, so that a puzzle does "
        "not depend on how many boxes are pushed.",
        "6.3.4; P6",
        printed=("push/request", "contact/open"),
        witness="pushing-boxes-5",
    ),
    Erratum(
        "erratum/unlimited-grip",
        "A rider goes with its support at any acceleration; kept, so that carrying can be relied on.",
        "4.4; P7",
        printed=("reading/carried",),
        witness="figure-6-1-position-lookup",
    ),
    Erratum(
        "erratum/falls-take-no-time",
        "A fall takes no time; kept, for only the display shows it: nothing can come between.",
        "6.2.1d, 6.4.1; P8",
        printed=("leave/fall",),
        witness="figure-1-2-fall-edge",
    ),
)

ERRATA: tuple[Erratum, ...] = (*ON_STRINGS, *ON_LEDGES, *ON_TOPS, *ON_SLOPES, *CONCEDED, *KEPT)
