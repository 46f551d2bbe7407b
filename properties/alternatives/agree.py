"""Readings that never differ: both run on the same scene of arbitrary sizes, and must end alike. A bounded proof."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

from properties.contracts.request import judged
from properties.engine.explore import Outcome, explore
from properties.evidence.hunt import start_in_order
from properties.given import Given
from properties.worlds.rows import any_level
from properties.worlds.scenes import Shape, scene, shapes
from reference.alternatives import VARIANTS
from reference.simulator import Game
from reference.world import World
from spec.body import Level
from spec.invariants import equal, every
from spec.number import Truth
from spec.profiles import THESIS

Draw = Callable[[Given], tuple[Level[Any], Any]]


def on_ledges(shape: Shape, given: Given) -> tuple[Level[Any], Any]:
    """Any level of a shape that keeps the guidelines, and any distance."""
    level, asked = scene(given, shape, guided=True)
    start_in_order(given, World(level))
    return level, asked


def on_string(bodies: int, edges: int, given: Given) -> tuple[Level[Any], Any]:
    """Any row on a line, no edge of which is shorter than the margin, and any distance."""
    return any_level(given, bodies, edges, closed=False), given.number("distance asked")


def draws(most_bodies: int, most_edges: int) -> Iterator[Draw]:
    """All kinds of scenes up to a size, on ledges and on strings."""
    for shape in shapes(most_bodies, most_edges, guided=True):
        yield partial(on_ledges, shape)
    for bodies in range(1, most_bodies + 1):
        for edges in range(1, most_edges + 1):
            yield partial(on_string, bodies, edges)


def ends_alike(reading: str, draw: Draw, profile: None, given: Given) -> None:
    """Ask the first body of a scene under an alternative and under the thesis; all bodies end in the same places."""
    level, asked = draw(given)
    games = (Game(THESIS, level), VARIANTS[reading].play(level))
    for game in games:
        game.request(level.bodies[0].name, asked)
    given.ensure("ends alike", same_places(games[0].world, games[1].world))


def same_places(one: World[Any], other: World[Any]) -> Truth:
    """Whether all bodies are in the same places in the plane, on the same supports."""
    truths: list[Truth] = [one.support(body) == other.support(body) for body in one.handles()]
    for held, beside in zip(one.bodies, other.bodies, strict=True):
        for at, there in ((held.left, beside.left), (held.right, beside.right)):
            points = zip(one.point(at), other.point(there), strict=True)
            truths += [equal(here, far, here * 0) for here, far in points]
    return every(truths)


def agreement(reading: str, bodies: int, edges: int) -> dict[str, Any]:
    """What the explorer says of an alternative: how many paths, and what is open or broken, if anything."""
    paths, unsettled = 0, []
    for draw in draws(bodies, edges):
        outcome: Outcome = explore(partial(judged, partial(ends_alike, reading, draw), None))
        paths += outcome.paths
        unsettled += outcome.open
        if outcome.counterexample is not None:
            unsettled.append(f"differ: {outcome.counterexample.values}")
    return {"paths": paths, "bodies": bodies, "edges": edges, "unsettled": unsettled}
