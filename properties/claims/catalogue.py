"""All claims."""

from __future__ import annotations

from properties.claims import comparison, features, ledges, repaired, string
from properties.claims.claim import Claim

CLAIMS: tuple[Claim, ...] = (*string.CLAIMS, *ledges.CLAIMS, *repaired.CLAIMS, *comparison.CLAIMS, *features.CLAIMS)
