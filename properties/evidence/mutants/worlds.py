"""The mutants of the world of storeys: how what is there is measured, and how bodies are moved and let down in it."""

from __future__ import annotations

from functools import cache

from properties.evidence.mutants.mutant import Mutant, mutants_of, told_apart

EDITING = ("StoreyWorld.with_place", "StoreyWorld.without", "StoreyWorld.in_terrain", "StoreyWorld.at_one_place")


@cache
def of_worlds() -> dict[str, Mutant]:
    """All mutants of the world of storeys, by name."""
    return told_apart(list(mutants_of("reference.storeys", *EDITING)))
