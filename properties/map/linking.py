"""Links from the map to the claims, with the verdicts that the check holds them to."""

from __future__ import annotations

from properties.claims.catalogue import CLAIMS
from properties.claims.claim import Claim
from properties.handbook import slug


def claim_link(name: str) -> str:
    """A link to a claim, with its verdict."""
    return f"[{name}](reference/claims.md#{slug(name)}) ({claim_of(name).expected})"


def claim_of(name: str) -> Claim:
    """The claim of an ID."""
    return next(claim for claim in CLAIMS if claim.id == name)
