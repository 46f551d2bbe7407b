"""The mutants of the worlds: how storeys are surveyed, where places on a string are, how a string is mirrored or split.

Of the world of strings those functions are changed that an obligation on strings runs; what reads a level, and what is
asked about riders and ledges in the plane, is not.
"""

from __future__ import annotations

from functools import cache

from properties.evidence.mutants.mutant import Mutant, mutants_of, told_apart

EDITING = ("StoreyWorld.with_place", "StoreyWorld.without", "StoreyWorld.in_terrain", "StoreyWorld.at_one_place")
MEASURES = ("World.width", "World.apart", "World.coordinate", "World.to_wall", "World.length_of", "World.lay_out")
STEPS = ("Facing.ahead", "Facing.beyond", "Facing.reach", "Facing.along", "Facing.gap", "Facing.place", "World.beside")
ON_STRINGS = frozenset(f"world.{name}" for name in (*MEASURES, *STEPS))


@cache
def of_worlds() -> dict[str, Mutant]:
    """All mutants of the worlds, by name."""
    strings = [one for one in mutants_of("reference.world") if one.subject in ON_STRINGS]
    changes = mutants_of("spec.transform", "with_numbers")
    return told_apart([*mutants_of("reference.storeys", *EDITING), *strings, *changes])
