"""Played steps as text."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from reference.formats.level import BodyRecord
from reference.formats.scenario import Asked, RemoveRecord
from reference.play import AnyGame, Played
from reference.simulator import Fulfilled
from spec.body import EdgePosition


def position(at: EdgePosition[Any], game: AnyGame) -> str:
    """An edge position as text: the edge's number, or whose top it is, and the location."""
    statics = game.world.statics
    edge = str(at.edge) if at.edge < statics else f"top of {game.world.bodies[at.edge - statics].name}"
    return f"{edge}:{at.location}"


def came_or_went(asked: Asked) -> str | None:
    """Who came or went, if that was asked."""
    if isinstance(asked, BodyRecord):
        return f"{asked.name} comes"
    return f"{asked.body} goes" if isinstance(asked, RemoveRecord) else None


def asked_and_moved(move: Fulfilled[Any]) -> str:
    """A request as it was fulfilled."""
    return f"{move.body} asked {move.asked}, moved {move.moved}; chain of {move.depth}"


def what_came(step: Played[Any]) -> Iterator[str]:
    """What was asked and moved, by which rules, and what happened when."""
    coming = came_or_went(step.asked)
    if coming:
        yield f"\n{coming}"
    for move in step.moves:
        yield f"\n{asked_and_moved(move)}"
        fired: dict[str, list[str]] = {}
        for body, rule in move.fired:
            fired.setdefault(body, []).append(rule)
        for body, rules in fired.items():
            yield f"  {body}: {' '.join(rules)}"
    for one in step.happened or ():
        moving = ", ".join(f"{name} {speed}" for name, speed in one.velocities.items()) or "nobody"
        yield f"  at {one.time}: {one.body} {one.rule}{f' {one.other}' if one.other else ''}; moving: {moving}"


def text_lines(step: Played[Any] | None, game: AnyGame) -> Iterator[str]:
    """What was asked and moved, the rules that fired, where all bodies are, and whether the goal is reached."""
    if step is not None:
        yield from what_came(step)
    points = [game.world.point(held.left) for held in game.world.bodies]
    for (x, y), held in sorted(zip(points, game.world.bodies, strict=True), key=lambda pair: pair[0]):
        yield f"  {held.name} from {position(held.left, game)} to {position(held.right, game)}, at ({x}, {y})"
    if game.level.buttons:
        yield f"  goal: {'reached' if game.world.solved() else 'not reached'}"
