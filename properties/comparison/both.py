"""One step under both profiles from the same state, and what came of it."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

from reference.formats.scenario import StepRecord
from reference.plan import Plan, plan_of
from reference.simulator import Fulfilled, Game
from reference.stepping import run
from reference.storeys import Place, StoreyWorld
from reference.world import World
from spec.body import Level
from spec.graph import Direction
from spec.profiles import REPAIRED, THESIS
from spec.rules.step import Moment
from spec.storeys import Drive

MOST_RULES = 20_000
Turn = Fulfilled[Fraction]


@dataclass(frozen=True)
class Asked:
    """A request of a body for a signed distance or, without a body, a tick with the key of a direction held."""

    body: int | None
    distance: Fraction


@dataclass(frozen=True)
class Both:
    """One step under both profiles: the state before it, and what came of it under each.

    Attributes:
        before, start: the state before, on strings of edges and on storeys.
        turns: the requests of the thesis, one after another.
        after, ended: the state after them, on strings and on storeys.
        moments: the instants of the repaired step.
        chosen: the rules that fired in it, with their bodies.
        settled: the storeys after it.
    """

    asked: Asked
    before: World[Fraction]
    start: StoreyWorld[Fraction]
    turns: tuple[Turn, ...]
    after: World[Fraction]
    ended: StoreyWorld[Fraction]
    moments: tuple[Moment[Fraction], ...]
    chosen: frozenset[tuple[int, str]]
    settled: StoreyWorld[Fraction]

    @property
    def handles(self) -> range:
        """All bodies."""
        return self.before.handles()

    @property
    def direction(self) -> Direction:
        """The direction of what was asked."""
        return Direction.RIGHT if self.asked.distance > 0 else Direction.LEFT

    @cached_property
    def differing(self) -> frozenset[int]:
        """The bodies that end in different places."""
        pairs = zip(self.ended.places, self.settled.places, strict=True)
        return frozenset(body for body, (one, other) in enumerate(pairs) if spot(one) != spot(other))

    def handle(self, name: str) -> int:
        """The body of a name."""
        return next(body for body in self.handles if self.before.bodies[body].name == name)

    def those(self, turn: Turn, *rules: str) -> frozenset[int]:
        """The bodies for which one of some rules fired in a turn; any, if none are named."""
        return frozenset(self.handle(name) for name, rule in turn.fired if not rules or rule in rules)

    def fired(self, *rules: str) -> frozenset[int]:
        """The bodies for which one of some rules fired under the thesis."""
        return frozenset(body for turn in self.turns for body in self.those(turn, *rules))

    def repaired(self, *rules: str) -> frozenset[int]:
        """The bodies for which one of some rules fired in the repaired step."""
        return frozenset(body for body, rule in self.chosen if rule in rules)

    def driven(self, body: int) -> bool:
        """Whether a body is to move of its own."""
        return self.asked.body == body or (self.asked.body is None and bool(self.before.bodies[body].speed))

    def moved(self, body: int) -> bool:
        """Whether a body moved at some time of the repaired step."""
        return any(moment.velocities[body] * moment.moved for moment in self.moments)

    @cached_property
    def left(self) -> frozenset[int]:
        """The bodies that the thesis let fall or jump."""
        return self.fired("leave/fall", "leave/jump")

    @cached_property
    def changed(self) -> frozenset[int]:
        """The bodies that settled anew in the repaired step."""
        return frozenset(change.seat.body for moment in self.moments for change in moment.changes)

    @property
    def rides(self) -> bool:
        """Whether a body stands on another."""
        return any(place.support is not None for place in self.start.places)

    @property
    def legal(self) -> bool:
        """Whether the thesis has left the bodies the margin apart, outside terrain."""
        return legal(self.ended)


def spot(place: Place[Fraction]) -> tuple[int, Fraction]:
    """Where a body is in the plane: its storey and its left border."""
    return place.storey, place.left


def in_terrain(world: StoreyWorld[Fraction], body: int) -> bool:
    """Whether a body reaches into terrain."""
    rooms = [world.to_wall(body, direction) for direction in Direction]
    return world.in_terrain(body) or any(room is not None and room < 0 for room in rooms)


def legal(world: StoreyWorld[Fraction]) -> bool:
    """Whether bodies are the margin apart, and outside terrain."""
    near = any(world.gap(*pair) < world.margin for pair in world.neighbours()) or any(world.at_one_place())
    return not near and not any(in_terrain(world, body) for body in range(len(world.places)))


@dataclass
class Pair:
    """A level played under the thesis; each step is played under the repaired rules too, from the same state."""

    level: Level[Fraction]

    def __post_init__(self) -> None:
        self.plan: Plan[Fraction] = plan_of(self.level)
        self.game = Game(THESIS, self.level, MOST_RULES)

    def step(self, asked: Asked) -> Both:
        """Play a step; the state after it is that of the thesis."""
        before = self.game.world.copy()
        start = self.storeys(before)
        settled = start.copy()
        moments, record = run(REPAIRED.rules, settled, *self.drives(asked), MOST_RULES)
        turns, after = self.turns(asked), self.game.world.copy()
        chosen = frozenset(record.fired)
        return Both(asked, before, start, turns, after, self.storeys(after), tuple(moments), chosen, settled)

    def storeys(self, world: World[Fraction]) -> StoreyWorld[Fraction]:
        """A world of edge positions on its storeys."""
        places = [self.plan.place(world, body) for body in world.handles()]
        return StoreyWorld(self.plan.terrain, world.margin, places)

    def turns(self, asked: Asked) -> tuple[Turn, ...]:
        """The step under the thesis."""
        if asked.body is None:
            return tuple(self.game.tick(Direction.RIGHT if asked.distance > 0 else Direction.LEFT))
        return (self.game.request(self.level.bodies[asked.body].name, asked.distance),)

    def drives(self, asked: Asked) -> tuple[dict[int, Drive[Any]], Fraction]:
        """The same step as drives, and how long it takes."""
        sign, drives = Fraction(1 if asked.distance > 0 else -1), {}
        for handle, body in enumerate(self.level.bodies):
            alone, walks = asked.body == handle, asked.body is None and bool(body.speed)
            speed = sign if alone else body.speed * sign if walks else Fraction(0)
            drives[handle] = Drive(speed, relative=not (body.speed and (alone or walks)))
        return drives, self.level.tick if asked.body is None else abs(asked.distance)

    def all_asked(self, step: StepRecord) -> list[Asked]:
        """A request, or the ticks, of a step of a scenario."""
        if step.tick is not None:
            return [Asked(None, Fraction(1 if step.tick.key == "right" else -1))] * step.tick.times
        assert step.request is not None
        names = [body.name for body in self.level.bodies]
        return [Asked(names.index(step.request.body), Fraction(step.request.distance))]
