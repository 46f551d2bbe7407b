"""The simulator: requests and ticks on a world, with a record of the rules that fired."""

from __future__ import annotations

from collections.abc import Callable, Generator
from dataclasses import dataclass, field
from typing import Any, Generic

from reference.world import World, world_of
from spec.body import Level
from spec.graph import Direction
from spec.number import N, greater, zero_like
from spec.profiles import Profile
from spec.rule import AnyRule, Chooser
from spec.rules.request import Ask, Rules, request


@dataclass
class Record:
    """What happened in one request: the rules that fired, each with its body, and the chain of requests."""

    body: int
    fired: list[tuple[int, str]] = field(default_factory=list)
    asked: list[Ask[Any, int]] = field(default_factory=list)
    depth: int = 1


@dataclass(frozen=True)
class Heard:
    """A family whose choices are written into a record."""

    family: Chooser
    record: Record

    def choose(self, facts: Any) -> AnyRule:
        """Return the rule that applies, recorded."""
        rule = self.family.choose(facts)
        self.record.fired.append((self.record.body, rule.id))
        return rule


def heard(rules: Rules, record: Record) -> Rules:
    """The same rules, recorded."""
    return rules.through(lambda family: Heard(family, record))


def fulfil(start: Ask[N, int], begin: Callable[[Ask[N, int]], Generator[Ask[N, int], N, N]], record: Record) -> N:
    """Run a request and, one inside the other, those that it makes; return the distance moved.

    The chain is a list, not a recursion: it may be as long as the row.
    """
    chain = [(start.body, begin(start))]
    answer: Any = None
    while True:
        record.body, running = chain[-1]
        try:
            ask = running.send(answer)
        except StopIteration as end:
            answer = end.value
            chain.pop()
            if not chain:
                return answer  # type: ignore[no-any-return]
        else:
            record.asked.append(ask)
            chain.append((ask.body, begin(ask)))
            record.depth = max(record.depth, len(chain))
            answer = None


def move(profile: Profile, world: World[N], body: int, direction: Direction, distance: N) -> tuple[N, Record]:
    """Request `body` to move by `distance >= 0` in a direction; return the distance moved and the record."""
    record = Record(body)
    rules, view = heard(profile.rules, record), world.facing(direction)
    limit = profile.push_limit(len(world.bodies))

    def begin(ask: Ask[N, int]) -> Generator[Ask[N, int], N, N]:
        return request(rules, view, ask.body, ask.distance, ask.spare)

    return fulfil(Ask(body, distance, limit - 1), begin, record), record


@dataclass(frozen=True)
class Event(Generic[N]):
    """One request of a game: who was to move how far (negative to the left), how far it did, and how."""

    body: str
    distance: N
    moved: N
    fired: tuple[tuple[str, str], ...]
    depth: int


@dataclass
class Game(Generic[N]):
    """A level being played under a profile: requests and ticks, one after another."""

    profile: Profile
    level: Level[N]

    def __post_init__(self) -> None:
        """Set the level up.

        Raises:
            LevelError: if the level is not in the domain of the rules.
        """
        self.world = world_of(self.level)
        self.handles = {body.name: handle for handle, body in enumerate(self.level.bodies)}

    def request(self, body: str, distance: N) -> Event[N]:
        """Request a body to move by a signed distance, positive to the right."""
        zero = zero_like(distance)
        direction = Direction.LEFT if distance < zero else Direction.RIGHT
        size = greater(distance, zero - distance)
        moved, record = move(self.profile, self.world, self.handles[body], direction, size)
        fired = tuple((self.world.bodies[handle].name, rule) for handle, rule in record.fired)
        return Event(body, distance, moved * direction, fired, record.depth)

    def tick(self, direction: Direction) -> list[Event[N]]:
        """One tick with one key held: each character in turn moves by its speed times the tick (R1, R4)."""
        bodies = {body.name: body for body in self.level.bodies}
        characters = [name for name in self.profile.tick_order(list(bodies)) if bodies[name].speed]
        return [self.request(name, self.per_tick(bodies[name].speed) * direction) for name in characters]

    def per_tick(self, speed: N) -> N:
        """The distance that a speed covers in one tick."""
        return speed * self.level.tick  # type: ignore[operator]
