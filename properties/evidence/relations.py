"""Properties that compare runs: two requests and one, a level and its mirror image, the rules and the closed form.

Each takes a trial and its world, in exact numbers or in floats, and says whether the property holds.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from properties.closed_form import displacements
from properties.evidence.deeds import MOST_RULES
from properties.strategies.rows import Trial
from reference.simulator import Game, move
from reference.world import World, world_of
from spec.body import Level
from spec.conditions import room_between
from spec.graph import Vertex
from spec.invariants import (
    ADDITIVE,
    CLOSED_FORM,
    DETERMINISM,
    EDGE_SPLIT,
    MARGINS_OVER_TIME,
    MIRROR,
    NO_OVERLAP,
    ON_GRAPH,
    ORDER,
    ORDER_OVER_TIME,
    RIGID_WIDTH,
    TRANSLATION,
    Deed,
    Invariant,
    equal,
)
from spec.profiles import Profile
from spec.transform import in_floats, mirror, moved, split


@dataclass(frozen=True)
class Check:
    """A property of a trial, run in a world of exact numbers or of floats."""

    id: str
    holds: Callable[[Profile, Trial, World[Any], Any], Any]


def placed(world: World[Any]) -> list[tuple[str, Any, Any]]:
    """Where all bodies are, by name and by coordinates along the string."""
    return sorted((body.name, world.coordinate(body.left), world.coordinate(body.right)) for body in world.bodies)


def alike(one: World[Any], two: World[Any], tolerance: Any) -> bool:
    """Whether two rows hold the same bodies at the same places of their strings."""
    pairs = zip(placed(one), placed(two), strict=True)
    return all(
        a[0] == b[0] and all(near(one, x, y, tolerance) for x, y in zip(a[1:], b[1:], strict=True)) for a, b in pairs
    )


def near(world: World[Any], x: Any, y: Any, tolerance: Any) -> bool:
    """Whether two coordinates are the same place."""
    return any(
        equal(x, y + shift, tolerance)
        for shift in ([0, world.rows[0].length, -world.rows[0].length] if world.closed else [0])
    )


def after(profile: Profile, world: World[Any], trial: Trial, *distances: Any) -> World[Any]:
    """The world after requests one after another, of the trial's body in its direction."""
    result = world.copy()
    for distance in distances:
        move(profile, result, trial.body, trial.direction, distance)
    return result


def exact_chain(profile: Profile, trial: Trial, world: World[Any], tolerance: Any) -> bool:
    """The rules move every body as far as the closed form says."""
    asked = trial.asked + world.margin * 0
    result = after(profile, world, trial, asked)
    expected = displacements(world, trial.body, trial.direction, asked, profile.push_limit(len(world.bodies)))
    return all(
        equal(result.travel(world, body, trial.direction), expected.get(body, asked * 0), tolerance)
        for body in world.bodies_in_order()
    )


def additive(profile: Profile, trial: Trial, world: World[Any], tolerance: Any) -> bool:
    """Two requests do what one of their sum does; on a ring, if their sum fits into the free space."""
    asked = trial.asked + world.margin * 0
    asked = min(asked, room_between(world)) if world.closed and len(world.bodies) > 1 else asked
    part = asked / 3
    return alike(after(profile, world, trial, part, asked - part), after(profile, world, trial, asked), tolerance)


def deterministic(profile: Profile, trial: Trial, world: World[Any], tolerance: Any) -> bool:
    """The same request twice gives the very same state and record."""
    one, two = world.copy(), world.copy()
    asked = trial.asked + world.margin * 0
    runs = [move(profile, held, trial.body, trial.direction, asked) for held in (one, two)]
    return one.bodies == two.bodies and runs[0][0] == runs[1][0] and runs[0][1].fired == runs[1][1].fired


def in_kind(level: Level[Fraction], like: World[Any]) -> World[Any]:
    """The world of a level, in the same kind of numbers as another."""
    return world_of(level) if isinstance(like.margin, Fraction) else world_of_floats(level)


def world_of_floats(level: Level[Fraction]) -> World[float]:
    """The world of a level in floats; that it is valid is checked in exact numbers."""
    world_of(level)
    return World(in_floats(level))


def unchanged_by(
    change: Callable[[Level[Fraction]], Level[Fraction] | None], turned: bool = False
) -> Callable[..., bool]:
    """Whether a change of the level changes no displacement; `turned` if it exchanges left and right."""

    def holds(profile: Profile, trial: Trial, world: World[Any], tolerance: Any) -> bool:
        level = change(trial.level)
        if level is None:
            return True
        asked, other = trial.asked + world.margin * 0, in_kind(level, world)
        towards = trial.direction.opposite if turned else trial.direction
        one = after(profile, world, trial, asked)
        two = after(profile, other, replace(trial, direction=towards), asked)
        return all(
            equal(one.travel(world, body, trial.direction), two.travel(other, body, towards), tolerance)
            for body in world.handles()
        )

    return holds


def split_longest(level: Level[Fraction]) -> Level[Fraction] | None:
    """The level with its longest edge split in the middle, if both halves are as long as the margin."""
    lengths = [edge.length for edge in level.graph.edges]
    edge = lengths.index(max(lengths))
    at, left = lengths[edge] / 2, level.graph.vertices[level.graph.edges[edge].left]
    return split(level, edge, at, Vertex(left.x + at, left.y)) if at >= level.margin else None


def moved_away(level: Level[Fraction]) -> Level[Fraction]:
    """The level moved by a vector."""
    return moved(level, Vertex(Fraction(-7), Fraction(5, 3)))


def over_time(*kept: Invariant) -> Callable[..., bool]:
    """Whether what is kept holds after the request, and after each tick, as against the start."""

    def holds(profile: Profile, trial: Trial, world: World[Any], tolerance: Any) -> bool:
        game, zero = Game(profile, world.level, MOST_RULES), world.margin * 0
        game.request(world.bodies[trial.body].name, (trial.asked + zero) * trial.direction)
        for key in (*trial.keys, None):
            deed = Deed(world, game.world, trial.body, trial.direction, zero, zero, 1, 1, 0, tolerance)
            if not all(invariant.holds(deed) for invariant in kept):
                return False
            if key is not None:
                game.tick(key)
        return True

    return holds


RELATIONS = (
    Check(CLOSED_FORM.id, exact_chain),
    Check(ADDITIVE.id, additive),
    Check(DETERMINISM.id, deterministic),
    Check(MIRROR.id, unchanged_by(mirror, turned=True)),
    Check(EDGE_SPLIT.id, unchanged_by(split_longest)),
    Check(TRANSLATION.id, unchanged_by(moved_away)),
    Check(MARGINS_OVER_TIME.id, over_time(NO_OVERLAP)),
    Check(ORDER_OVER_TIME.id, over_time(ORDER, RIGID_WIDTH, ON_GRAPH)),
)
