"""All claims."""

from __future__ import annotations

from properties.claims import comparison, landings, ledges, repaired, string, velocity
from properties.claims.claim import Claim

CLAIMS: tuple[Claim, ...] = (
    *string.CLAIMS,
    *ledges.CLAIMS,
    *landings.CLAIMS,
    *repaired.CLAIMS,
    *comparison.CLAIMS,
    *velocity.CLAIMS,
)
