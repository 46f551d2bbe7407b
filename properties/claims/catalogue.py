"""All claims."""

from __future__ import annotations

from properties.claims import comparison, enough, landings, ledges, repaired, string
from properties.claims.claim import Claim

CLAIMS: tuple[Claim, ...] = (
    *string.CLAIMS,
    *ledges.CLAIMS,
    *landings.CLAIMS,
    *enough.CLAIMS,
    *repaired.CLAIMS,
    *comparison.CLAIMS,
)
