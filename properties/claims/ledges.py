"""The claims about ledges, falls, jumps, tops and riders, under the profiles `thesis` and `thesis/overshoot`."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from properties.claims.claim import Claim, Hunt, Verdict
from properties.claims.string import of_rules
from properties.contracts import leaving, request
from properties.contracts.contract import LEAVING as LEAVING_CONTRACT, SEGMENT, Contract
from properties.given import Given
from spec.case import Case
from spec.complications import jumps_into_what_leads_up, jumps_onto_a_ridden_top
from spec.conditions import GUIDELINES, PLANE_START
from spec.invariants import Deed, Invariant
from spec.number import Truth
from spec.plane import (
    APART,
    HEIGHT_KEPT,
    HORIZONTAL,
    NEVER_RAISED,
    PLANE_MARGIN,
    SUPPORTS_END,
    TERRAIN,
    bodies_apart,
    negated,
)
from spec.profiles import OVERSHOOT, THESIS, Profile
from spec.readings import LANDING, LANDING_OVERSHOOT
from spec.rules.request import Rules
from spec.unsupported import PRINTED

Promise = Callable[[Deed[Any], frozenset[str]], Truth]
PROFILES = (THESIS, OVERSHOOT)
PREMISES = (PLANE_START.id, GUIDELINES.id)
CONTRACTS_OF: dict[Callable[[Rules, Given], None], tuple[Contract, ...]] = {
    leaving.leaving_keeps_its_contract: (LEAVING_CONTRACT,),
    request.segment_in_wall: (SEGMENT,),
}


def always(invariant: Invariant) -> Promise:
    """The promise that an invariant holds, whatever fired."""
    return lambda deed, fired: invariant.holds(deed)


def never(case: Callable[[Deed[Any], frozenset[str]], Truth]) -> Promise:
    """The promise that a case does not happen."""
    return lambda deed, fired: negated(case(deed, fired))


def carried_clear(deed: Deed[Any], fired: frozenset[str]) -> Truth:
    """Where the mover stays on its edge and pushes nobody, no bodies overlap."""
    return bodies_apart(deed) if "leave/stay" in fired and "push/request" not in fired else True


def suffix(profile: Profile) -> str:
    """What distinguishes the claims of a profile."""
    return profile.name.removeprefix("thesis")


def hunted(
    name: str,
    about: str,
    sentence: str,
    source: str,
    profile: Profile,
    promise: Promise,
    expected: Verdict,
    bodies: tuple[int, int],
    edges: int = 3,
    long: bool = False,
) -> Claim:
    """A claim about all small scenes that keep the guidelines, with from .. to so many bodies."""
    hunt = Hunt(name, promise, guided=True, most_bodies=bodies[1], most_edges=edges, least_bodies=bodies[0])
    return Claim(
        f"claim/{name}{suffix(profile)}",
        "plane",
        sentence,
        source,
        about,
        profile,
        PREMISES,
        expected,
        hunt=hunt,
        long=long,
    )


def of_invariant(
    invariant: Invariant,
    profile: Profile,
    expected: Verdict,
    bodies: tuple[int, int],
    edges: int = 3,
    long: bool = False,
    name: str = "",
) -> Claim:
    """The claim that an invariant holds in all small scenes that keep the guidelines."""
    own = name or invariant.id.removeprefix("invariant/")
    return hunted(
        own,
        invariant.id,
        invariant.sentence,
        invariant.source,
        profile,
        always(invariant),
        expected,
        bodies,
        edges,
        long,
    )


def of_case(case: Case) -> Claim:
    """The claim that an unsupported case does not happen, on levels that keep no guideline."""
    name = case.id.removeprefix("unsupported/")
    hunt = Hunt(name, never(case.happened), guided=False, most_bodies=2, most_edges=3)
    return Claim(
        id=f"claim/no-{name}",
        family="unsupported",
        sentence=f"On any level, this does not happen: {case.sentence[0].lower()}{case.sentence[1:]}",
        source=case.source,
        about=case.id,
        profile=THESIS,
        premises=(PLANE_START.id,),
        expected=Verdict.REFUTED,
        hunt=hunt,
        long=True,
    )


def proved(
    name: str,
    about: str,
    sentence: str,
    source: str,
    *programs: Callable[[Rules, Given], None],
    profile: Profile = THESIS,
) -> Claim:
    """A claim about any body at the end of any edge, proved by obligations that assume nothing."""
    obligations = tuple(of_rules(program, contracts=CONTRACTS_OF.get(program, ())) for program in programs)
    return Claim(f"claim/{name}", "ledges", sentence, source, about, profile, (), Verdict.PROVED, obligations)


LEAVING: tuple[Claim, ...] = (
    proved(
        "leaves-only-beyond",
        "leave",
        "A body falls or jumps only with both borders beyond the end of its edge; else it stays, or is "
        "cut back to the ledge.",
        "6.2.1d, 6.2.1e; R21, R22, R23, A14, A24",
        leaving.leaving_keeps_its_contract,
    ),
    proved(
        "no-jump-leads-up",
        "leave",
        "No fall and no jump leads up; a body falls only where no jump edge is near, and jumps down least.",
        "6.2.1; R25, R32, A21, A23",
        leaving.jumps_lead_down_least,
    ),
    proved(
        "stays-in-wall",
        "walk/in-wall",
        "A border that a landing has put inside a wall does not move further into it, nor back.",
        "6.2.1b; R17, U11",
        request.segment_in_wall,
    ),
    proved(
        "near-jump-edges",
        "leave",
        "The jump edges that count at a ledge are those whose horizontal distance is from 0 to the width.",
        "6.2.1; R25, A20",
        leaving.near_jumps_are_as_short,
    ),
    proved(
        "landing-position",
        LANDING.id,
        LANDING.sentence,
        LANDING.source,
        leaving.lands_at_the_near_end,
    ),
    proved(
        "landing-position/overshoot",
        LANDING_OVERSHOOT.id,
        LANDING_OVERSHOOT.sentence,
        LANDING_OVERSHOOT.source,
        leaving.lands_as_far_beyond,
        profile=OVERSHOOT,
    ),
    proved(
        "landing-keeps-width",
        "fit",
        "A landing keeps the body's width along the graph, or into the wall that it does not fit before.",
        "6.2.1d; R21, A16, A31",
        leaving.landing_keeps_width,
        leaving.fit_places_the_whole_width,
        profile=OVERSHOOT,
    ),
)

BOUNDED, REFUTED = Verdict.BOUNDED, Verdict.REFUTED

ONE_OR_TWO: tuple[Claim, ...] = tuple(
    of_invariant(invariant, profile, BOUNDED, (1, 2), long=True)
    for profile in PROFILES
    for invariant in (SUPPORTS_END, NEVER_RAISED, HEIGHT_KEPT)
)

DEFECTS: tuple[Claim, ...] = (
    of_invariant(TERRAIN, THESIS, BOUNDED, (1, 2), long=True),
    of_invariant(TERRAIN, OVERSHOOT, REFUTED, (1, 1)),
    of_invariant(APART, THESIS, BOUNDED, (1, 2), long=True, name="plane-apart-of-two"),
    of_invariant(APART, OVERSHOOT, REFUTED, (1, 2), name="plane-apart-of-two"),
    *(of_invariant(PLANE_MARGIN, profile, REFUTED, (1, 2)) for profile in PROFILES),
    *(of_invariant(HORIZONTAL, profile, REFUTED, (1, 2)) for profile in PROFILES),
    of_invariant(HORIZONTAL, THESIS, BOUNDED, (1, 1), name="horizontal-alone"),
    *(
        hunted(
            "jump-clear-of-riders",
            "leave/jump",
            "A body does not jump onto the top of a body into another that stands there.",
            "6.2.1, 6.2.2; R25, U9",
            profile,
            never(jumps_onto_a_ridden_top),
            REFUTED,
            (3, 3),
            edges=2,
            long=True,
        )
        for profile in PROFILES
    ),
    *(
        hunted(
            "what-leads-up-obstructs",
            "leave/jump",
            "A body does not jump into a body whose jump edge leads up.",
            "6.2.1; R25, A23",
            profile,
            never(jumps_into_what_leads_up),
            REFUTED,
            (3, 3),
            edges=2,
            long=True,
        )
        for profile in PROFILES
    ),
    *(
        hunted(
            "carried-clear",
            "reading/carried",
            "A rider is not carried into another body.",
            "4.4; A27, U9",
            profile,
            carried_clear,
            REFUTED,
            (3, 3),
            edges=2,
            long=True,
        )
        for profile in PROFILES
    ),
)

CLAIMS: tuple[Claim, ...] = (*LEAVING, *DEFECTS, *ONE_OR_TWO, *(of_case(case) for case in PRINTED))
