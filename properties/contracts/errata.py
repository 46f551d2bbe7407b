"""Promises that the printed rules, or the thesis' remarks on them, do not keep: each is refuted by a witness.

Each function takes a stage, on which its level and its requests are noted, so that a counterexample becomes a
scenario.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from properties.evidence.deeds import do
from properties.given import Given
from properties.worlds.rows import any_level
from reference.world import World
from reference.simulator import Game, move
from spec.body import Level
from spec.conditions import room_between
from spec.graph import Direction
from spec.invariants import no_overlap
from spec.profiles import Profile

RIGHT = Direction.RIGHT


@dataclass
class Stage:
    """The level of a scenario, and its steps: a body and a distance each, or None for a tick to the right."""

    level: Level[Any] | None = None
    steps: list[tuple[str, Any] | None] = field(default_factory=list)

    def set(self, level: Level[Any]) -> World[Any]:
        """Note the level; return its row."""
        self.level = level
        return World(level)


def margin_with_short_edges(profile: Profile, given: Given, stage: Stage) -> None:
    """A body keeps the margin, however short the edges are."""
    held = stage.set(any_level(given, bodies=2, edges=3, closed=False, edges_long=False))
    asked = given.number("distance asked")
    stage.steps.append(("A", asked))
    deed, _ = do(profile, held, 0, RIGHT, asked, asked * 0)
    given.ensure("neighbours keep the margin", no_overlap(deed))


def additive_on_any_ring(profile: Profile, given: Given, stage: Stage) -> None:
    """Two requests do what one of their sum does, however long they are."""
    held = stage.set(any_level(given, bodies=2, edges=1, closed=True))
    once, twice = held.copy(), held.copy()
    part = given.number("distance asked, twice")
    stage.steps.extend([("A", part), ("A", part)])
    for _ in range(2):
        move(profile, twice, 0, RIGHT, part)
    move(profile, once, 0, RIGHT, part + part)
    same = once.coordinate(once.bodies[0].left) == twice.coordinate(twice.bodies[0].left)
    given.ensure("two requests are one", same)


def neighbours_are_two(profile: Profile, given: Given, stage: Stage) -> None:
    """The list of left and right neighbours does not contain a body twice."""
    held = stage.set(any_level(given, bodies=2, edges=1, closed=True))
    stage.steps.append(("A", given.number("distance asked")))
    given.ensure("the neighbours are two", held.beside(0, RIGHT) != held.beside(0, RIGHT.opposite))


def loops_only_on_a_full_circle(profile: Profile, given: Given, stage: Stage) -> None:
    """A chain comes round to its mover only on a circle that is fully filled."""
    held = stage.set(any_level(given, bodies=2, edges=1, closed=True))
    asked, free = given.number("distance asked"), room_between(held)
    stage.steps.append(("A", asked))
    _, record = move(profile, held, 0, RIGHT, asked)
    round_ = any(rule == "push/limit" for _, rule in record.fired)
    given.ensure("a chain that comes round had no room", (not round_) | (free <= 0))


def one_step_a_tick(profile: Profile, given: Given, stage: Stage) -> None:
    """Two characters under one key move at their own constant speed, touching or not."""
    level = any_level(given, bodies=2, edges=1, closed=False, speed=1)
    held = stage.set(level)
    stage.steps.append(None)
    game = Game(profile, level)
    game.tick(RIGHT)
    for body in held.bodies_in_order():
        given.ensure("nobody moves further than its speed allows", game.world.travel(held, body, RIGHT) <= level.tick)
