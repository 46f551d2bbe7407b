"""Why did gravity of 10 fit better than 9.81 (6.3.3, P3)? Guesses, each tried: what gravity would fit best under it.

A guess changes one thing, of the engine or of what the thesis prints. The gravity that fits best is the one for which
the places of the graphbody differ least from those of the box, in the sum of squares over all ticks. Without friction
and bounds a place is linear in gravity, so two runs of the rules tell all others.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import sqrt
from typing import Any

from evaluation import graphbodies
from evaluation.cases import FITTED, UNITY, Slide
from evaluation.graphbodies import AS_PRINTED, PRINTED, VELOCITY, Prototype

INSET = 0.01


@dataclass(frozen=True)
class Guess:
    """A guess, in words, and what it changes.

    Attributes:
        settings: of the engine.
        prototype: what graphbodies do otherwise.
        ticks: how long places are compared.
        late: by how many ticks the box is seen later than the graphbody.
        rubbing: the coefficient of friction of box and ground.
    """

    name: str
    settings: dict[str, Any]
    prototype: Prototype = AS_PRINTED
    ticks: int = 100
    late: int = 0
    rubbing: float = 0


GUESSES = (
    Guess("(f) as printed, with Unity's settings", {}),
    Guess("(a) one iteration of the solver", {"iterations": (1, 1)}),
    Guess("(a) the ground is an edge, no polygon", {"ground": "edge"}),
    Guess("(a) the box may not turn", {"turning": False}),
    Guess("(b) steepness not normalised, borders inset by 0.01", {}, Prototype(inset=INSET)),
    Guess("(c) the box starts 0.05 above the ground", {"above": 0.05}),
    Guess("(c) the ground is a chain of short edges", {"ground": "chain"}),
    Guess("(d) the box starts along the normal", {"heading": 90}),
    Guess("(e) the box has a drag of 0.05", {"damping": 0.05}),
    Guess("(e) the graphbody has a drag of 0.999", {}, Prototype(drag=0.999)),
    Guess("(e) moves, then finds its velocity; 1 s", {}, Prototype(moves_first=True), ticks=50),
    Guess("(e) moves, then finds its velocity; 2 s", {}, Prototype(moves_first=True)),
    Guess("(e) moves, then finds its velocity; 3 s", {}, Prototype(moves_first=True), ticks=150),
    Guess("(e) moves, then finds its velocity; 4 s", {}, Prototype(moves_first=True), ticks=200),
    Guess("(e) the box is seen a tick late", {}, late=1),
    Guess("(e) the graphbody is seen a tick late", {}, late=-1),
    Guess("(f) box and ground have Unity's friction of 0.4", {}, rubbing=0.4),
)


def squares(one: list[float], other: list[float]) -> float:
    """The sum of squares of differences."""
    return sum((a - b) ** 2 for a, b in zip(one, other, strict=True))


@dataclass(frozen=True)
class Fit:
    """Where a graphbody is at gravity 0, by how much that changes with gravity, and where the box is."""

    start: list[float]
    change: list[float]
    box: list[float]

    def error(self, gravity: float) -> float:
        """The root of the mean square of the differences."""
        places = [a + b * gravity for a, b in zip(self.start, self.change, strict=True)]
        return sqrt(squares(places, self.box) / len(self.box))

    @property
    def best(self) -> float:
        """The gravity that fits best."""
        needed = [a - b for a, b in zip(self.box, self.start, strict=True)]
        return sum(a * b for a, b in zip(self.change, needed, strict=True)) / sum(b * b for b in self.change)


def delayed(places: list[float], ticks: int) -> list[float]:
    """The same places, seen so many ticks late."""
    return [0.0] * ticks + places[: len(places) - ticks]


def fit(guess: Guess, run: Slide, box: list[float]) -> Fit:
    """What fits under a guess; `box` is where the box is after each tick."""
    rules, late = VELOCITY[PRINTED], max(0, -guess.late)
    low, high = (
        delayed(graphbodies.slide(rules, run, guess.ticks, gravity, guess.prototype), late)
        for gravity in (UNITY, FITTED)
    )
    change = [(b - a) / (FITTED - UNITY) for a, b in zip(low, high, strict=True)]
    start = [a - UNITY * b for a, b in zip(low, change, strict=True)]
    return Fit(start, change, delayed(box, max(0, guess.late)))
