"""All claims."""

from __future__ import annotations

from properties.claims import (
    comparison,
    designs,
    display,
    enough,
    features,
    landings,
    ledges,
    repaired,
    rounding,
    steps_compared,
    string,
    velocity,
)
from properties.claims.claim import Claim

CLAIMS: tuple[Claim, ...] = (
    *string.CLAIMS,
    *ledges.CLAIMS,
    *repaired.CLAIMS,
    *steps_compared.CLAIMS,
    *comparison.CLAIMS,
    *velocity.CLAIMS,
    *display.CLAIMS,
    *designs.CLAIMS,
    *features.CLAIMS,
    *enough.CLAIMS,
    *landings.CLAIMS,
    *rounding.CLAIMS,
)
