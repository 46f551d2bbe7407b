"""The claims about what suffices in the plane: the guidelines, and what the map finds to be missing (6.2.2)."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from properties.claims.claim import Claim, Hunt, Verdict
from properties.claims.ledges import PREMISES, PROFILES, hunted
from spec.conditions import LEDGES_CLEAR, NOBODY_RIDES, ROOMY_GROUNDS, SHORT_REQUESTS
from spec.invariants import Deed, every
from spec.number import Truth
from spec.plane import IN_PLANE, PLANE_MARGIN
from spec.profiles import Profile

ENOUGH = (SHORT_REQUESTS, ROOMY_GROUNDS, NOBODY_RIDES, LEDGES_CLEAR)
SENTENCE = (
    "With the guidelines, short requests, roomy grounds, nobody that rides at the start and nobody near below a ledge, "
    "every invariant in the plane holds."
)


def all_in_plane(deed: Deed[Any], fired: frozenset[str]) -> Truth:
    """Every invariant in the plane holds."""
    return every(invariant.holds(deed) for invariant in IN_PLANE)


def enough(name: str, profile: Profile, bodies: tuple[int, int], edges: int) -> Claim:
    """The claim that the conditions suffice, in small scenes."""
    source = "6.2.2; G1, G2, G3, G4, G5"
    claim = hunted(
        name, PLANE_MARGIN.id, SENTENCE, source, profile, all_in_plane, Verdict.BOUNDED, bodies, edges, long=True
    )
    assert isinstance(claim.hunt, Hunt), "a hunted claim has a hunt"
    premises = (*PREMISES, *(condition.id for condition in ENOUGH))
    return replace(claim, premises=premises, hunt=replace(claim.hunt, premises=ENOUGH))


CLAIMS: tuple[Claim, ...] = tuple(
    enough(name, profile, bodies, edges)
    for profile in PROFILES
    for name, bodies, edges in (("enough-for-the-plane", (1, 2), 3), ("enough-for-three", (3, 3), 2))
)
