"""All claims."""

from __future__ import annotations

from properties.claims import comparison, ledges, proxy, repaired, string
from properties.claims.claim import Claim

CLAIMS: tuple[Claim, ...] = (*string.CLAIMS, *ledges.CLAIMS, *proxy.CLAIMS, *repaired.CLAIMS, *comparison.CLAIMS)
