"""The claims about landings: where they fit, and where the test of jump edges tells that they are free (E12, P9)."""

from __future__ import annotations

from properties.claims.claim import Claim, Erratum, Verdict
from properties.claims.ledges import hunted
from properties.claims.string import of_rules
from properties.contracts import fitting, proxy
from spec.conditions import GUIDELINES
from spec.profiles import OVERSHOOT, THESIS

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
