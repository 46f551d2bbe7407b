"""The simulator: requests and ticks on a world, with a record of the rules that fired."""

from __future__ import annotations

from collections.abc import Callable, Generator
from dataclasses import asdict, dataclass, field, replace
from typing import Any, Generic

from reference.physics import set_off
from reference.world import Facing, Work, World
from spec.body import Body, Level
from spec.graph import Direction
from spec.number import N, greater, zero_like
from spec.profiles import AnyProfile, Profile
from spec.rule import AnyRule, Chooser
from spec.rules.request import Ask, Rules, request
from spec.rules.velocity import Motion, VelocityRules, meet

MOST_FIRED = 1_000_000


class Endless(Exception):
    """A request has fired more rules than it was given: it does not seem to end."""


@dataclass(frozen=True)
class Answered:
    """A request that a body made of its neighbour: who asked whom, for how much, and how far it moved."""

    asker: int
    body: int
    distance: Any
    moved: Any


@dataclass
class Record:
    """What happened in one request: the rules that fired, each with its body, and the longest chain of requests.

    `most` is how many rules may fire, if there is to be a limit.
    """

    body: int
    most: int | None = None
    fired: list[tuple[int, str]] = field(default_factory=list)
    asks: list[Answered] = field(default_factory=list)
    depth: int = 1

    def note(self, rule: str) -> None:
        """Note that a rule fired.

        Raises:
            Endless: if too many have.
        """
        self.fired.append((self.body, rule))
        if self.most is not None and len(self.fired) > self.most:
            raise Endless(f"expected a step that ends, more than {self.most} rules fired")

    def named(self, name: str) -> tuple[tuple[str, str], ...]:
        """The rules that fired, if they are all of the body of a name."""
        return tuple((name, rule) for _, rule in self.fired)

    @property
    def walks(self) -> int:
        """How often a border has walked along an edge."""
        return sum(rule.startswith("walk/") for _, rule in self.fired)

    @property
    def transitions(self) -> int:
        """How often a border has passed on to the next edge."""
        return sum(rule == "walk/onward" for _, rule in self.fired)


@dataclass(frozen=True)
class Heard:
    """A family whose choices are written into a record."""

    family: Chooser
    record: Record

    def choose(self, facts: Any) -> AnyRule:
        """Return the rule that applies, recorded."""
        rule = self.family.choose(facts)
        self.record.note(rule.id)
        return rule


def heard(rules: Rules, record: Record) -> Rules:
    """The same rules, recorded."""
    return rules.through(lambda family: Heard(family, record))


def heard_velocity(profile: AnyProfile, record: Record) -> VelocityRules:
    """The rules of velocity of a profile, recorded."""
    return profile.velocity.through(lambda family: Heard(family, record))


def fulfil(start: Ask[N, int], begin: Callable[[Ask[N, int]], Generator[Ask[N, int], N, N]], record: Record) -> N:
    """Run a request and, one inside the other, those that it makes; return the distance moved.

    The chain is a list, not a recursion: it may be as long as the row.
    """
    chain = [(start, begin(start))]
    answer: Any = None
    while True:
        current, running = chain[-1]
        record.body = current.body
        try:
            ask = running.send(answer)
        except StopIteration as end:
            answer = end.value
            chain.pop()
            if not chain:
                return answer  # type: ignore[no-any-return]
            record.asks.append(Answered(chain[-1][0].body, current.body, current.distance, answer))
        else:
            chain.append((ask, begin(ask)))
            record.depth = max(record.depth, len(chain))
            answer = None


def move(
    profile: Profile,
    world: World[N],
    body: int,
    direction: Direction,
    distance: N,
    most: int | None = None,
    asked: Callable[..., Generator[Ask[N, int], N, N]] = request,
) -> tuple[N, Record]:
    """Request `body` to move by `distance >= 0` in a direction; return the distance moved and the record.

    `asked` is how each request of the chain is carried out.

    Raises:
        Endless: if more than `most` rules fire.
    """
    record = Record(body, most)
    rules, view = heard(profile.rules, record), world.facing(direction)
    limit = profile.push_limit(len(world.bodies))

    def begin(ask: Ask[N, int]) -> Generator[Ask[N, int], N, N]:
        return asked(rules, view, ask.body, ask.distance, ask.spare)

    return fulfil(Ask(body, distance, limit - 1), begin, record), record


@dataclass(frozen=True)
class Happened(Generic[N]):
    """Something that came at an instant of a step: to whom, by which rule, when since the step began.

    Attributes:
        velocities: those with which bodies moved up to it, if not 0.
        other: the body that it met, or on which it stood or stands now, if any.
    """

    body: str
    rule: str
    time: N
    velocities: dict[str, N]
    other: str | None


@dataclass(frozen=True)
class Fulfilled(Generic[N]):
    """One request of a game: who was to move how far (negative to the left), how far it did, how, and at what cost.

    `depth` is how many bodies were asked, and `work` counts collision queries, edge look-ups and transitions to a next
    edge. Where all move at once, the first of a step tells of all of it: what fired, how many bodies moved, how many
    events came and rules were chosen.
    """

    body: str
    asked: N
    moved: N
    fired: tuple[tuple[str, str], ...]
    depth: int
    work: dict[str, int]


@dataclass
class Game(Generic[N]):
    """A valid level being played under a profile: requests and ticks, one after another.

    `most` is how many rules may fire in a request; `happened` is None, because nothing has a time where bodies move one
    after another.
    """

    profile: Profile
    level: Level[N]
    most: int = MOST_FIRED

    happened: None = None

    def __post_init__(self) -> None:
        """Set the level up; that it is valid is for `world_of` to check, in exact numbers."""
        self.world = self.laid_out()
        self.handles = {body.name: handle for handle, body in enumerate(self.level.bodies)}

    def laid_out(self) -> World[N]:
        """The world of the level."""
        return World(self.level)

    def asked(self, rules: Rules, view: Facing[N], body: int, distance: N, spare: int) -> Generator[Ask[N, int], N, N]:
        """Carry out one request of a chain."""
        return request(rules, view, body, distance, spare)

    def request(self, body: str, distance: N) -> Fulfilled[N]:
        """Request a body to move by a signed distance, positive to the right."""
        zero = zero_like(distance)
        direction = Direction.LEFT if distance < zero else Direction.RIGHT
        size = greater(distance, zero - distance)
        self.world.work = Work()
        moved, record = move(self.profile, self.world, self.handles[body], direction, size, self.most, self.asked)
        work = {**asdict(self.world.work), "transitions": record.transitions}
        fired = tuple((self.world.bodies[handle].name, rule) for handle, rule in record.fired)
        return Fulfilled(body, distance, moved * direction, fired, record.depth, work)

    def tick(self, direction: Direction | None) -> list[Fulfilled[N]]:
        """One tick with one key held, or none: each in turn moves by its speed or velocity times the tick (R1, R4)."""
        turns = []
        for name in self.profile.tick_order(list(self.handles)):
            body = self.world.bodies[self.handles[name]]
            if body.motion is not None:
                turns.append(self.roll(body, body.motion))
            elif body.speed and direction is not None:
                turns.append(self.request(name, self.per_tick(body.speed) * direction))
        return turns

    def roll(self, body: Body[N], motion: Motion[N]) -> Fulfilled[N]:
        """The turn of a body that moves of its own: velocity, then distance, then move (5.2; R10)."""
        handle, tick = self.handles[body.name], self.level.tick
        record = Record(handle)
        rules = heard_velocity(self.profile, record)
        meant = set_off(rules, self.world, handle, motion)
        done = self.request(body.name, self.per_tick(meant.velocity))
        after = meet(rules, meant, done.moved == done.asked, done.moved / tick)
        self.world.bodies[handle] = replace(self.world.bodies[handle], motion=after)
        return replace(done, fired=(*record.named(body.name), *done.fired))

    def per_tick(self, speed: N) -> N:
        """The distance that a speed covers in one tick."""
        return speed * self.level.tick
