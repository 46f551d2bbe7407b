"""The claims about landings, and about the cases together: E10, E12, P9."""

from __future__ import annotations

from properties.claims.claim import Claim, Count, Erratum, Verdict
from properties.claims.ledges import hunted, suffix
from properties.claims.string import of_rules
from properties.contracts import fitting, proxy
from spec.conditions import GUIDELINES, PLANE_START
from spec.profiles import OVERSHOOT, THESIS, Profile

ABOUT = "reading/horizontal-distance"
EXACT = (
    "On level ground at the foot of a vertical fall edge, a body falls only where the landing is in no other body, and "
    "jumps onto one there only where it would have fallen into it: the test of jump edges is exact but for the margin."
)


def wrong(name: str, sentence: str, erratum: Erratum) -> Claim:
    """A claim about ground that is not level, which is expected to be refuted."""
    return Claim(
        f"claim/{name}", "errata", sentence, "6.2.1; E12, P9", ABOUT, THESIS, (), Verdict.REFUTED, erratum=erratum
    )


def cases_are_complete(profile: Profile) -> int:
    """Whenever a request of a random game breaks an invariant in the plane, one of the cases has happened."""
    from properties.evidence.complete import cases_are_complete as in_games

    return in_games(profile)


CLAIMS: tuple[Claim, ...] = (
    *(
        hunted(
            "proxy-on-level-ground",
            ABOUT,
            EXACT,
            "6.2.1; E12, R25",
            profile,
            proxy.falls_only_where_free,
            verdict,
            (1, 2),
            long=True,
        )
        for profile, verdict in ((THESIS, Verdict.BOUNDED), (OVERSHOOT, Verdict.REFUTED))
    ),
    Claim(
        id="claim/long-edges-fit",
        family="ledges",
        sentence="Within the guidelines every landing fits: a body that comes down at the near end of an edge stands "
        "on that edge alone.",
        source="6.2.2, 6.2.1d; E10, G1, G4, U11, A16",
        about="fit",
        profile=THESIS,
        premises=(GUIDELINES.id,),
        expected=Verdict.PROVED,
        obligations=(of_rules(fitting.long_edges_fit, GUIDELINES.id),),
        long=True,
    ),
    *(
        Claim(
            id=f"claim/cases-are-complete{suffix(profile)}",
            family="unsupported",
            sentence="In games on levels with ledges, whenever a request that begins in order breaks an invariant in "
            "the plane, one of the unsupported cases has happened, of which unsupported/other-strings does not count.",
            source="6.2.2; E10, U9",
            about="unsupported",
            profile=profile,
            premises=(PLANE_START.id,),
            expected=Verdict.TESTED,
            counts=(Count("cases-are-complete", cases_are_complete),),
            long=True,
        )
        for profile in (THESIS, OVERSHOOT)
    ),
    wrong(
        "proxy-on-slanted-falls",
        "Down a slanted fall edge, a body falls only where the landing is in no other body.",
        proxy.proxy_on_slanted_falls,
    ),
    wrong(
        "proxy-on-tilted-landings",
        "A body jumps onto one on tilted ground only where it would not have had room beside it.",
        proxy.proxy_on_tilted_landings,
    ),
)
