"""Trying mutants of steps on random storeys: worlds made from numbers, in exact numbers, the same for every mutant.

The worlds are made before a mutant is in place: one that spoils the world itself would spoil how it is made.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

from properties.evidence.mutants.trial import CRASHES, Kill, ended
from properties.evidence.sample import Campaign
from properties.evidence.sample_steps import STOREYS
from properties.strategies.storeys import MOST_BODIES, MOST_STOREYS, Outing, outing
from spec.profiles import REPAIRED

STEPPED, WORLD = "storeys: ", "world"
MANY, ALL, CRASHED, MOST_SECONDS = 15, 240, 3, 1
"""How many worlds are tried for all that fails in them; how many if nothing does; after how many that crash no more are
tried; and after how many seconds of the processor a step does not end, which takes some hundredths.
"""


@cache
def outing_of(number: int) -> Outing:
    """The world of a number, and a step in it."""
    return outing(number, 1 + number % MOST_BODIES, number % (MOST_STOREYS + 1))


def made() -> None:
    """Make all worlds that may be tried."""
    for number in range(ALL):
        outing_of(number)


def broken_in(number: int) -> tuple[str, ...] | None:
    """The properties that fail in the world of a number; None if it crashes."""
    held = outing_of(number)
    if not held.places:
        return ()
    try:
        with ended(MOST_SECONDS):
            return tuple(dict.fromkeys(STOREYS.failing(REPAIRED, held, False, Campaign(STOREYS))))
    except CRASHES:
        return None


def kill_in(number: int, broken: str) -> Kill:
    """A property that fails in a world."""
    return Kill(f"{STEPPED}{broken}", (broken,), {WORLD: str(number)})


def number_of(kill: Kill) -> int:
    """The number of the world of a kill; what is 0 is not written in a record."""
    return int(str(kill.values.get(WORLD, "0")))


def kills_by_storeys(first: bool = False) -> Iterator[Kill]:
    """For each property, the first world in which it fails with a mutant in place; only the `first` such property."""
    found: set[str] = set()
    crashed = 0
    for number in range(ALL):
        if (found and (first or number >= MANY)) or crashed == CRASHED:
            return
        broken = broken_in(number)
        crashed += broken is None
        for name in broken or ():
            if name not in found:
                found.add(name)
                yield kill_in(number, name)


def crash_in_storeys() -> str | None:
    """The first world that crashes with a mutant in place."""
    return next((f"the world {number} of storeys" for number in range(MANY) if broken_in(number) is None), None)
