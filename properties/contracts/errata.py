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
from reference.simulator import Game, move
from reference.world import World
from spec.body import Level
from spec.conditions import room_between
from spec.graph import Direction, Vertex
from spec.invariants import as_far_as_possible, bystanders_stay, no_overlap
from spec.profiles import Profile
from spec.transform import split

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


def pushes_with_short_edges(profile: Profile, given: Given, stage: Stage) -> None:
    """Whoever moves is pushed in contact, and the mover goes as far as possible, however short the edges are."""
    held = stage.set(any_level(given, bodies=2, edges=3, closed=False, edges_long=False))
    asked = given.number("distance asked")
    stage.steps.append(("A", asked))
    deed, _ = do(profile, held, 0, RIGHT, asked, asked * 0)
    given.ensure("bystanders stay, and it goes as far as possible", bystanders_stay(deed) & as_far_as_possible(deed))


def split_anywhere(profile: Profile, given: Given, stage: Stage) -> None:
    """A body comes as far on a level as on the same with an edge split, wherever it is split."""
    level = any_level(given, bodies=2, edges=2, closed=False)
    at = given.number("where the second edge is split")
    given.assume(at > 0)
    given.assume(level.graph.edges[1].length - at > 0)
    whole = World(level)
    parts = stage.set(split(level, 1, at, Vertex(level.graph.edges[0].length + at, at * 0)))
    asked = given.number("distance asked")
    stage.steps.append(("A", asked))
    ends = [do(profile, held, 0, RIGHT, asked, asked * 0)[0].after for held in (whole, parts)]
    for body in whole.handles():
        same = ends[0].travel(whole, body, RIGHT) == ends[1].travel(parts, body, RIGHT)
        given.ensure("the same way", same)


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
