"""Playing under rules by which all bodies move at once: steps on storeys, with a record of what came when."""

from __future__ import annotations

from collections.abc import Container, Iterator, Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Any, Generic

from reference.formats.numbers import exact
from reference.formats.scenario import StepRecord
from reference.physics import left_to, set_off, with_motions
from reference.plan import check_added, plan_of, without
from reference.scene import Reach, Scene
from reference.simulator import Endless, Fulfilled, Happened, Record, heard_velocity
from reference.storeys import StoreyWorld
from reference.world import LevelError, World, standing
from spec.body import Body, Level
from spec.graph import Direction
from spec.number import N, greater, zero_like
from spec.profiles import SteppedProfile
from spec.rule import AnyRule, Chooser
from spec.rules.settle import Change
from spec.rules.step import Event, Moment, StepRules, step
from spec.rules.velocity import Motion
from spec.storeys import Contact, Drive, Seat

MOST_CHOSEN = 10_000_000

COMING = ("event/contact", "event/wall", "event/support-lost")
"""The rules that say when something comes: they have fired when it has come."""

STANDING = frozenset(
    (
        "settle/stay",
        "wish/carried",
        "row/own",
        "row/passes-on",
        "row/passes-nothing",
        "row/one-way",
        "way/open",
        "way/wall",
    )
)
"""The rules by which a body stands that nothing moves: of such a body nothing is told."""


@dataclass
class Chosen:
    """The rules that fired in a step, each with its body, once; `most` is how often rules may be chosen."""

    most: int
    chosen: int = 0
    fired: dict[tuple[int, str], None] = field(default_factory=dict)

    def count(self) -> None:
        """Count a choice.

        Raises:
            Endless: if there are too many.
        """
        self.chosen += 1
        if self.chosen > self.most:
            raise Endless(f"expected a step that ends, more than {self.most} rules fired")

    def told(self, moving: Container[int]) -> Iterator[tuple[int, str]]:
        """What fired, but for bodies that neither moved nor did more than stand."""
        active = {body for body, rule in self.fired if body in moving or rule not in STANDING}
        return (pair for pair in self.fired if pair[0] in active)


@dataclass(frozen=True)
class Noted:
    """A family whose choices are written into a record."""

    family: Chooser
    record: Chosen

    def choose(self, facts: Any) -> AnyRule:
        """Return the rule that applies, recorded."""
        rule = self.family.choose(facts)
        self.record.count()
        if rule.id not in COMING:
            self.record.fired[facts.body, rule.id] = None
        return rule


def run(
    rules: StepRules, world: StoreyWorld[N], drives: Mapping[int, Drive[N]], duration: N, most: int = MOST_CHOSEN
) -> tuple[list[Moment[N]], Chosen]:
    """Drive the bodies of a world for a time; return what came, and the rules that fired.

    Raises:
        Endless: if rules are chosen more than `most` times.
    """
    record = Chosen(most)
    noted = rules.through(lambda family: Noted(family, record))
    moments = []
    for moment in step(noted, world, drives, duration):
        moments.append(moment)
        record.fired.update({(event.mark.body, event.rule): None for event in moment.events})
    return moments, record


def run_in_reach(
    rules: StepRules, scene: Scene[N], driven: Mapping[int, Drive[N]], duration: N, most: int = MOST_CHOSEN
) -> tuple[list[Moment[N]], Chosen]:
    """Drive some bodies of a scene for a time; those whom that cannot reach stay, and are not looked at.

    Raises:
        Endless: if rules are chosen more than `most` times.
    """
    reached = Reach(scene, driven, duration).ways
    still = dict.fromkeys(reached, Drive(zero_like(duration)))
    part = scene.take_out(reached)
    try:
        return run(rules, part, {**still, **driven}, duration, most)
    finally:
        scene.put_back(part)


def told(names: list[str], duration: N, moments: list[Moment[N]]) -> Iterator[Happened[N]]:
    """What came in a step, in order, each with the time since its start and the velocities up to it."""
    for moment in moments:
        moving = {names[body]: speed for body, speed in moment.velocities.items() if speed != zero_like(speed)}
        come: list[Event[N] | Change] = [*moment.events, *moment.changes]
        for what in come:
            body, other = who(what)
            second = None if other is None else names[other]
            yield Happened(names[body], what.rule, duration - moment.left, moving, second)


def who(what: Event[Any] | Change) -> tuple[int, int | None]:
    """Whom something happens to, and the other body that it is about: met, lost or found."""
    if isinstance(what, Change):
        return what.seat.body, what.seat.support
    if isinstance(what.mark, Contact):
        return what.mark.left, what.mark.right
    return what.mark.body, what.mark.support if isinstance(what.mark, Seat) else None


@dataclass
class StepGame(Generic[N]):
    """A level of storeys being played: requests, ticks and drives, one after another; bodies come and go.

    `most` is how many rules may fire in a step. The level is one of storeys, which is for `check_plan` to check, in
    exact numbers.
    """

    profile: SteppedProfile
    level: Level[N]
    most: int = MOST_CHOSEN

    def __post_init__(self) -> None:
        """Set the level up."""
        self.plan = plan_of(self.level)
        self.scene = Scene(self.plan.start())
        self.shown: World[N] | None = World(self.level)
        self.names = [body.name for body in self.level.bodies]
        self.happened: tuple[Happened[N], ...] = ()
        self.speeds: Mapping[int, N] = {}

    @property
    def storeys(self) -> StoreyWorld[N]:
        """The bodies on their storeys, where they are now."""
        return self.scene.world

    @property
    def world(self) -> World[N]:
        """The level as it is now, its bodies on the edges of its graph; made when it is asked for."""
        if self.shown is None:
            self.shown = World(replace(self.level, bodies=self.plan.bodies(self.storeys)))
        return self.shown

    def request(self, body: str, distance: N) -> Fulfilled[N]:
        """Drive one body at unit speed for as long as a signed distance, positive to the right."""
        return self.step(*of_request(self.level, body, distance))[0]

    def tick(self, direction: Direction | None) -> list[Fulfilled[N]]:
        """One tick with one key held, or none: each character walks at its speed (R1, R4).

        A body with a velocity of its own is driven by it, relative to its support (R10, R26).
        """
        records = {body: Record(body) for body, _ in self.motions()}
        rules = {body: heard_velocity(self.profile, record) for body, record in records.items()}
        motions = {body: set_off(rules[body], self.world, body, motion) for body, motion in self.motions()}
        self.have(motions)
        results = self.step(*of_tick(self.level, direction))
        left = {body: left_to(rules[body], self.storeys, body, motions[body], self.speeds) for body in rules}
        self.have(left)
        fired = {self.names[body]: record.named(self.names[body]) for body, record in records.items()}
        return [replace(one, fired=(*fired.get(one.body, ()), *one.fired)) for one in results]

    def motions(self) -> Iterator[tuple[int, Motion[N]]]:
        """The bodies with a velocity of their own."""
        movers, handles = self.level.movers, self.level.handles
        return ((handles[held.name], held.motion) for held in movers if held.motion is not None)

    def have(self, motions: Mapping[int, Motion[N]]) -> None:
        """Let bodies have other motions."""
        if not motions:
            return
        self.level = with_motions(self.level, motions)
        self.plan, self.shown = replace(self.plan, level=self.level), None

    def drive(self, speeds: Mapping[str, N], duration: N) -> list[Fulfilled[N]]:
        """Drive bodies for a time: characters in the plane, boxes relative to what they stand on."""
        return self.step(*of_drive(self.level, speeds, duration))

    def add(self, body: Body[N]) -> list[Fulfilled[N]]:
        """Put a body into the level; it settles at once.

        Raises:
            LevelError: if it is not of the level's kind, or not clear of terrain and, by the margin, of other bodies.
        """
        level = replace(self.level, bodies=(*self.world.bodies, body))
        storeys = self.storeys.with_place(self.plan.place(standing(level), len(self.names)))
        check_added(level, storeys)
        return self.go_on(level, storeys)

    def remove(self, name: str) -> list[Fulfilled[N]]:
        """Take a body out of the level; those that stood on it settle at once.

        Raises:
            LevelError: if it is the last one, or there is a button on its top.
        """
        body, statics = self.names.index(name), len(self.level.graph.edges)
        if len(self.names) == 1:
            raise LevelError("$", "expected another body to be left: a storey is as high as a body")
        if any(button.edge == statics + body for button in self.level.buttons):
            raise LevelError("$.body", f"there is a button on the top of {name!r}")
        return self.go_on(without(self.level, body), self.storeys.without(body))

    def go_on(self, level: Level[N], storeys: StoreyWorld[N]) -> list[Fulfilled[N]]:
        """Go on with other bodies, which settle."""
        self.level, self.plan, self.scene = level, replace(self.plan, level=level), Scene(storeys)
        self.names = [body.name for body in level.bodies]
        return self.step({}, zero_like(level.margin))

    def step(self, driven: Mapping[int, Drive[N]], duration: N) -> list[Fulfilled[N]]:
        """Drive some bodies for a time; what fired is told with the first of them."""
        self.shown = None
        moments, record = run_in_reach(self.profile.rules, self.scene, driven, duration, self.most)
        self.speeds = moments[-1].velocities
        movers = {body for moment in moments for body, speed in moment.velocities.items() if speed * moment.moved}
        fired = tuple((self.names[body], rule) for body, rule in record.told({*driven, *movers}))
        self.happened = tuple(told(self.names, duration, moments))
        work = {"events": sum(len(moment.events) for moment in moments), "choices": record.chosen}
        results = []
        for body, drive in driven.items():
            moved = sum_of([moment.velocities[body] * moment.moved for moment in moments], duration)
            asked = drive.speed * duration
            results.append(Fulfilled(self.names[body], asked, moved, fired, max(1, len(movers)), work))
            fired, work = (), {}
        return results


Driven = tuple[dict[int, Drive[N]], N]
"""Who is driven how, and for how long."""


def of_request(level: Level[N], body: str, distance: N) -> Driven[N]:
    """What a request is as a step."""
    zero, one = zero_like(distance), unit(distance)
    return of_drive(level, {body: one * -1 if distance < zero else one}, greater(distance, zero - distance))


def of_tick(level: Level[N], direction: Direction | None) -> Driven[N]:
    """What a tick is as a step: characters walk, and bodies with a velocity of their own slide."""
    walking = {body.name: body.speed * direction for body in level.movers if body.speed and direction is not None}
    sliding = {body.name: body.motion.velocity for body in level.movers if body.motion is not None}
    return of_drive(level, {**walking, **sliding}, level.tick)


def of_drive(level: Level[N], speeds: Mapping[str, N], duration: N) -> Driven[N]:
    """What it is to drive some bodies: characters in the plane, boxes relative to what they stand on."""
    driven = {level.handles[name]: speed for name, speed in speeds.items()}
    return {body: Drive(speed, relative=not level.bodies[body].speed) for body, speed in driven.items()}, duration


def of_step(level: Level[Fraction], asked: StepRecord) -> Driven[Fraction]:
    """What a step of a scenario is, in exact numbers."""
    if asked.request is not None:
        return of_request(level, asked.request.body, exact(asked.request.distance, "$"))
    if asked.tick is not None:
        return of_tick(level, asked.tick.direction)
    assert asked.drive is not None
    speeds = {name: exact(speed, "$") for name, speed in asked.drive.speeds.items()}
    return of_drive(level, speeds, exact(asked.drive.time, "$"))


def unit(like: Any) -> Any:
    """One, as a number of the same kind."""
    return type(like)(1)


def sum_of(numbers: list[N], like: N) -> N:
    """The sum of numbers."""
    total = zero_like(like)
    for number in numbers:
        total = total + number
    return total
