"""The mutants of what obligations run beside rules and worlds: how a tick is made of requests, the closed form of a
batch, and how a vertex is moved.

An obligation fails; of a batch, if none does, a count of small worlds that it steps.
"""

from __future__ import annotations

from functools import cache

from properties.evidence.mutants.mutant import Mutant, mutants_of, told_apart

TEXTS = {
    "reference.simulator": ("simulator.move", "simulator.Game.request", "simulator.Game.tick"),
    "reference.batch": (
        "batch.storey_of",
        "batch.moves",
        "batch.ways",
        "batch.differ",
        "batch.several_speeds",
        "batch.sweep",
        "batch.along_rows",
        "batch.rooms",
        "batch.to_walls",
        "batch.accumulate",
        "batch.lost",
        "batch.reaches",
        "batch.furthest",
    ),
    "spec.graph": ("graph.extent",),
    "spec.transform": ("transform.shifted",),
}
"""The functions, by module."""
COUNTS = ("count: counts/rows-are-laid-out", "count: counts/batches-are-where-events-lead")
"""What catches those of a batch that no obligation does."""


@cache
def of_texts() -> dict[str, Mutant]:
    """All mutants of these functions, by name."""
    return told_apart([one for module, run in TEXTS.items() for one in mutants_of(module) if one.subject in run])
