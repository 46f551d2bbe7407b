"""The mutants of the world of strings, in what obligations ask of it, of ticks, and of the changes of a level.

Obligations on strings and on ticks catch each: they are wrong ones, of which the mutants of these say something else.
"""

from __future__ import annotations

from functools import cache

from properties.evidence.mutants.mutant import Mutant, mutants_of, told_apart

OF_LEVELS = ("reference.world", "reference.designs", "reference.simulator", "spec.transform")
ASKED = (
    "World.lay_out",
    "World.coordinate",
    "World.width",
    "World.apart",
    "World.beside",
    "World.to_wall",
    "World.nearly_round",
    "Facing.reach",
    "Facing.along",
    "Facing.tip",
    "Facing.beyond",
    "Facing.ahead",
    "Facing.gap",
    "Facing.place",
)
PLAYED = ("Game.request", "Game.tick")
ON_LEVELS = ("strings/", "designs/", "physics/", "ticks/")
"""The chapters of obligations on strings of any number of edges and bodies, and on ticks."""
CHANGES = ("mirror", "split")
LED = ("Leading.reach", "Leading.end", "Leading.beyond", "Leading.ahead", "Leading.gap")


@cache
def of_levels() -> dict[str, Mutant]:
    """All mutants of what is asked of a string, by a border or by a centre, of ticks, and of changes, by name."""
    made = [one for module in OF_LEVELS for one in mutants_of(module)]
    return told_apart([one for one in made if one.subject.partition(".")[2] in (*ASKED, *LED, *PLAYED, *CHANGES)])
