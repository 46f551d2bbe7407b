"""The claim of the benchmarks: in a tick of a row on one line, in which characters push, all keep the margin.

The first bodies of the row are the characters; they move to the right in turn, each at a speed of its own.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import partial
from typing import Any

from benchmarks.row import Row, fulfil, move, row_of
from properties.contracts.request import seen_by
from properties.engine.explore import Outcome, explore
from properties.engine.merge import merged
from properties.given import Given
from properties.worlds.rows import any_level
from reference.simulator import Game
from spec.graph import Direction
from spec.profiles import THESIS
from spec.rules.request import Ask


@dataclass(frozen=True)
class Numbers:
    """What is drawn: reals, or whole numbers. `lacking` is what the rules take the margin to be less than it is."""

    whole: bool = False
    lacking: int = 0

    def draw(self, given: Given, name: str) -> Any:
        """Any number, at least 0."""
        return given.natural(name) if self.whole else given.number(name)

    def positive(self, given: Given, name: str) -> Any:
        """Any number, at least 1: by choice of the unit, that is any that is more than 0."""
        number = self.draw(given, name)
        given.assume(number >= 1)
        return number


def any_row(numbers: Numbers, given: Given, bodies: int) -> tuple[Row, Any]:
    """Any row that keeps the margin, and the margin."""
    margin = numbers.positive(given, "margin")
    widths = [numbers.positive(given, f"width of body {body}") for body in range(bodies)]
    rooms = [numbers.draw(given, f"room after body {body}") for body in range(bodies)]
    row = row_of(margin, numbers.draw(given, "room before body 0"), widths, rooms)
    row.margin = margin - numbers.lacking
    return row, margin


Mover = Callable[[Given, Row, Ask[Any, int]], None]


def tick(mover: Mover, numbers: Numbers, bodies: int, characters: int, given: Given) -> None:
    """The claim."""
    row, margin = any_row(numbers, given, bodies)
    for character in range(characters):
        asked = numbers.draw(given, f"speed of body {character} times tick")
        mover(given, row, Ask(character, asked, bodies - 1))
    for place, kept in enumerate(row.keeps(margin)):
        given.ensure(f"the margin after body {place}", kept)


def on_paths(given: Given, row: Row, ask: Ask[Any, int]) -> None:
    """Each way in which a move can go has paths of its own."""
    move(seen_by(given, THESIS.rules), row, ask)


def in_one(given: Given, row: Row, ask: Ask[Any, int]) -> None:
    """At the end of a body's move, one path goes on."""

    def part(inner: Given) -> list[Any]:
        held = row.copy()
        move(seen_by(inner, THESIS.rules), held, ask)
        return held.shifts(row)

    row.shift(merged(given, part))


def promise_contract(numbers: Numbers, given: Given) -> None:
    """What a request of a body promises, if its neighbour's does: moves up to what was asked, and keeps the margin.

    It follows for any number of bodies by induction on the spare asks, and for any number of requests.
    """
    row, margin = any_row(numbers, given, 2 if given.flag("a body is ahead") else 1)
    before, asked = row.copy(), numbers.draw(given, "distance asked")
    ask = Ask(0, asked, given.natural("bodies that may be asked"))

    def answer(further: Ask[Any, int]) -> Any:
        given.ensure("it asks the next body, for at least 0", (further.body == 1) & (further.distance >= 0))
        given.ensure("the chain is one shorter", further.spare == ask.spare - 1)
        granted = numbers.draw(given, "distance granted")
        given.assume(granted <= further.distance)
        given.assume(granted <= row.reach(row.front(1)))
        row.place(1, row.front(1) + granted, row.rear(1) + granted)
        return granted

    moved = fulfil(seen_by(given, THESIS.rules), row, ask, answer)
    given.ensure("it moves up to what was asked", (moved >= 0) & (moved <= asked))
    given.ensure(
        "both borders move by that", (row.front(0) == before.front(0) + moved) & (row.rear(0) == before.rear(0) + moved)
    )
    given.ensure("it stays on the edge", row.reach(row.front(0)) >= 0)
    for kept in row.keeps(margin):
        given.ensure("it keeps the margin", kept)


def simulated(bodies: int, given: Given) -> None:
    """The claim with one character, on the simulator itself, with all that it looks up and records."""
    level = any_level(given, bodies, edges=1, closed=False, speed=1)
    only_first = tuple(
        body if place == 0 else replace(body, speed=Fraction(0)) for place, body in enumerate(level.bodies)
    )
    game = Game(THESIS, replace(level, bodies=only_first))
    game.tick(Direction.RIGHT)
    for left, right in game.world.neighbours():
        given.ensure(f"the margin after body {left}", game.world.clear(left, right) >= level.margin)


def by_paths(bodies: int, characters: int, numbers: Numbers) -> Outcome:
    """Settle the claim path by path."""
    return explore(partial(tick, on_paths, numbers, bodies, characters))


def by_merging(bodies: int, characters: int, numbers: Numbers) -> Outcome:
    """Settle the claim with paths merged at the end of each body's move."""
    return explore(partial(tick, in_one, numbers, bodies, characters))


def by_contract(numbers: Numbers) -> Outcome:
    """Settle the claim for any number of bodies and characters, by the contract of a request."""
    return explore(partial(promise_contract, numbers))


def by_simulator(bodies: int) -> Outcome:
    """Settle the claim path by path, on the simulator."""
    return explore(partial(simulated, bodies))


def verdict(outcome: Outcome) -> str:
    """What an exploration concluded."""
    if outcome.proved:
        return "proved"
    return "unknown" if outcome.counterexample is None else "refuted"
