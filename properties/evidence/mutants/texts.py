"""The mutants of what obligations run beside rules and worlds: how a tick is made of requests, the closed form of a row
in a batch, and how a vertex is moved.
"""

from __future__ import annotations

from functools import cache

from properties.evidence.mutants.mutant import Mutant, mutants_of, told_apart

TEXTS = {
    "reference.simulator": ("simulator.move", "simulator.Game.request", "simulator.Game.tick", "simulator.Game.per_tick"),
    "reference.batch": ("batch.along_rows", "batch.accumulate", "batch.storey_of"),
    "spec.graph": ("graph.extent",),
    "spec.transform": ("transform.shifted",),
}
"""The functions, by module."""


@cache
def of_texts() -> dict[str, Mutant]:
    """All mutants of these functions, by name."""
    return told_apart([one for module, run in TEXTS.items() for one in mutants_of(module) if one.subject in run])
