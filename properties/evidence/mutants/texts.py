"""The mutants of what obligations run beside rules and worlds of storeys: the world of strings, in what they ask of it;
how a tick is made of requests; the changes of a level; the closed form of a batch.

An obligation fails; of a batch, if none does, a count of small worlds that it steps. They are wrong ones, of which the
mutants of these obligations say something else.
"""

from __future__ import annotations

from functools import cache

from properties.evidence.mutants.mutant import Mutant, mutants_of, told_apart

OF_WORLD = ("lay_out", "coordinate", "width", "apart", "beside", "to_wall", "nearly_round")
OF_FACING = ("reach", "along", "tip", "beyond", "ahead", "gap", "place")
OF_ROWS = ("storey_of", "along_rows", "accumulate", "rooms", "to_walls", "sweep")
OF_BATCH = ("moves", "ways", "differ", "several_speeds", "lost", "reaches", "furthest")
TEXTS = {
    "reference.world": (*(f"World.{one}" for one in OF_WORLD), *(f"Facing.{one}" for one in OF_FACING)),
    "reference.designs": ("Leading.reach", "Leading.end", "Leading.beyond", "Leading.ahead", "Leading.gap"),
    "reference.simulator": ("move", "Game.request", "Game.tick"),
    "reference.batch": (*OF_ROWS, *OF_BATCH),
    "spec.graph": ("extent",),
    "spec.transform": ("shifted", "mirror", "split"),
}
"""The functions, by module."""
ON_STRINGS = ("strings/", "designs/", "physics/", "ticks/")
"""The chapters of obligations on strings of any number of edges and bodies, and on ticks; all are tried."""
COUNTS = ("count: counts/rows-are-laid-out", "count: counts/batches-are-where-events-lead")
"""What catches those of a batch that no obligation does."""


@cache
def of_texts() -> dict[str, Mutant]:
    """All mutants of these functions, by name."""
    return told_apart(
        [one for module, run in TEXTS.items() for one in mutants_of(module) if one.subject.partition(".")[2] in run]
    )
