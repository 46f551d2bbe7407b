"""The judge of steps in which all bodies move at once: whether one is allowed, from the log's own state before it.

Where numbers are known nearly, the exact outcome is tried first; then every way in which ties may be broken.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import groupby
from math import ceil
from typing import Any

from properties.conformance.diagnosis import Trouble
from properties.conformance.doubt import each_by_itself, told_apart, with_known_speeds, with_rounded_sums
from properties.conformance.judge import Difference, Expected, Finding, Judgement, position_text
from properties.conformance.log import ZERO, Request, Step, minima_moved
from properties.conformance.minimise import with_bodies, without_needless
from properties.conformance.said import as_json, of_the_moves, of_the_velocities
from properties.conformance.spread import Spread, roundings_of, spread
from properties.engine.ties import TIES, Choices, Near, Ties, TooManyWays, every_way, value_of
from reference.formats.files import FormatError
from reference.formats.level import BodyRecord, LevelRecord, level_record, valid_level
from reference.formats.numbers import exact, readable
from reference.formats.scenario import ScenarioRecord
from reference.formats.trace import EventRecord, LineRecord
from reference.physics import left_to, set_off, with_motions
from reference.plan import Plan, check_plan
from reference.play import stance_of
from reference.recording import Recording, event_record, events_of
from reference.rounding import PART, ROUNDINGS, UNIT_ROUNDOFF, Precision, largest, rounding
from reference.simulator import Endless, Happened
from reference.stepping import MOST_CHOSEN, Driven, StepGame, of_step, run, told
from reference.storeys import StoreyWorld, Terrain
from reference.world import LevelError, World
from spec.body import Body, Level
from spec.graph import Direction
from spec.profiles import SteppedProfile
from spec.rule import GuardError
from spec.rules.step import Moment, StepRules
from spec.rules.velocity import Motion
from spec.storeys import Drive, Interval, short_way

MOST_WAYS = 500
MOST_CHOICES = 100_000
MORE_WORK = 4
"""How many times as many rules a way may take in which ties are broken otherwise. One that takes more does not end: a
rest of time that is as good as none may be taken for some, again and again.
"""

Drives = Mapping[int, Drive[Fraction]]


@dataclass(frozen=True)
class Outcome:
    """What came of a step: the storeys after it, how far each body moved, what happened, how many rules it took, and
    from instant to instant how it went.
    """

    storeys: StoreyWorld[Any]
    moved: Mapping[int, Fraction]
    happened: tuple[Happened[Any], ...]
    speeds: Mapping[int, Any]
    work: int
    moments: Sequence[Moment[Any]]


@dataclass(frozen=True)
class OfSteps:
    """Who judges steps in which bodies move all at once: the plan of a log's level, and the profile.

    `nearly` is how well velocities are known, `numbers` what the log computes in.
    """

    plan: Plan[Fraction]
    profile: SteppedProfile
    nearly: Fraction
    numbers: Precision = "float64"

    def asked(self, before: World[Fraction], line: LineRecord) -> tuple[Request, ...]:
        """How far each driven body would come if nothing were in its way."""
        drives, time = self.driven(before, line)
        return tuple((body, way(drive.speed), abs(drive.speed) * time) for body, drive in drives.items())

    def walks(self, step: Step) -> int:
        """As often as makes up for how far what is rounded spreads."""
        driven = self.driven(step.before, step.line)
        outcome = self.outcome(self.storeys(step.before), driven)
        distances = (distance for _, _, distance in step.asked)
        one = ROUNDINGS * rounding(self.numbers, self.plan.level, *distances)
        return max(1, ceil(self.spread(outcome, driven).off / one))

    def spread(self, outcome: Outcome, asked: Driven[Fraction]) -> Spread:
        """How far what is rounded spreads on the way to an outcome."""
        roundoff, moving = UNIT_ROUNDOFF[self.numbers], [drive for drive in asked[0].values() if drive.speed]
        sums = max(0, min(len(moving) - 1, sum(drive.relative for drive in moving)))
        roundings = roundings_of(self.plan.terrain.circumference is not None)
        return spread(outcome.moments, roundings, roundoff, largest(self.plan.level), sums)

    def within(self, outcome: Outcome, asked: Driven[Fraction], tolerance: Fraction) -> Fraction:
        """How far off a step may be that went as an outcome did; the tolerance at least."""
        if not tolerance:
            return tolerance
        return max(tolerance, min(self.plan.level.margin / PART, self.spread(outcome, asked).off))

    def judge(self, step: Step, tolerance: Fraction) -> tuple[Judgement, list[Difference]]:
        """Where the bodies are after a step, and what the line says of their ways; of events in exact numbers."""
        judgement, outcome = self.found(step, tolerance)
        said: list[Difference] = []
        if judgement.finding in (Finding.AGREES, Finding.ONE_OF_SEVERAL):
            within = self.within(outcome, self.driven(step.before, step.line), tolerance)
            said += of_the_moves(step.line, step.asked, judgement.expected, within, rules_known=False)
            said += self.of_the_events(step.line, outcome) if not tolerance else ()
        return judgement, said

    def motions(self, before: World[Fraction], line: LineRecord) -> dict[int, Motion[Fraction]]:
        """The motions with which bodies set off in a tick; in other steps none does.

        A velocity that is known nearly may be less than the minimum or not; then it is what the line says it is.
        """
        found: dict[int, Motion[Fraction]] = {}
        told = {place.name: exact(place.velocity or 0, "$") for place in line.bodies}
        for by in dict.fromkeys((ZERO, self.nearly, -self.nearly)) if line.tick is not None else ():
            for body, held in enumerate(with_motions(before.level, minima_moved(before.bodies, by)).bodies):
                if held.motion is not None:
                    meant = set_off(self.profile.velocity, before, body, held.motion)
                    if body not in found or abs(meant.velocity - told[held.name]) <= self.nearly:
                        found[body] = meant
        return found

    def driven(self, before: World[Fraction], line: LineRecord) -> Driven[Fraction]:
        """Who is driven how in a step, and for how long."""
        return of_step(with_motions(self.plan.level, self.motions(before, line)), line.asked)

    def left(self, step: Step, outcome: Outcome) -> tuple[Body[Fraction], ...]:
        """The bodies before a step with the motions that are left to them after it."""
        rules, storeys = self.profile.velocity, exactly(outcome.storeys, self.plan.terrain)
        speeds = {body: value_of(speed) for body, speed in outcome.speeds.items()}
        motions = self.motions(step.before, step.line).items()
        left = {body: left_to(rules, storeys, body, motion, speeds) for body, motion in motions}
        return with_motions(step.before.level, left).bodies

    def found(self, step: Step, tolerance: Fraction) -> tuple[Judgement, Outcome]:
        """What was found of a step, and what came of it by the rules."""
        before, seen = self.storeys(step.before), self.storeys(step.after)
        outcome = self.outcome(before, self.driven(step.before, step.line))
        differences = tuple(self.displaced(outcome.storeys, seen, tolerance, step.after))
        differences += tuple(of_the_velocities(step.after, self.left(step, outcome), tolerance))
        finding = Finding.AGREES
        if differences:
            finding, outcome = self.among_all_ways(step, before, seen, tolerance, outcome)
        world = World(replace(self.plan.level, bodies=self.plan.bodies(exactly(outcome.storeys, self.plan.terrain))))
        moved = tuple(outcome.moved[body] for body, _, _ in step.asked)
        return Judgement(finding, Expected(world, moved, ()), differences), outcome

    def trouble(self, step: Step, log: Recording, judgement: Judgement, tolerance: Fraction) -> Trouble:
        """What happened by the rules, and the step as a small scenario."""
        first = judgement.differences[0]
        note = f"Line {step.number} of {log.header.name} has {first}."
        scenario = self.scenario(step, first.body, f"line-{step.number}", note)
        happened = self.outcome(self.storeys(step.before), self.driven(step.before, step.line)).happened
        story = tuple(f"at {readable(one.time)}: {one.body} {one.rule} {one.other or ''}".strip() for one in happened)
        story = (*self.course(step, first.body), *story)
        return Trouble(step, judgement.finding, judgement.differences, None, scenario, story=story)

    def course(self, step: Step, body: str) -> Iterator[str]:
        """How a body moves by the rules, from event to event, and by which rules."""
        after = self.storeys(step.before)
        driven, time = self.driven(step.before, step.line)
        handle = [held.name for held in self.plan.level.bodies].index(body)
        moments, chosen = run(self.profile.rules, after, self.drives(driven), time, MOST_CHOICES)
        for moment in moments:
            yield f"{body} moves at {readable(moment.velocities[handle])} up to {readable(time - moment.left)}"
        yield f"{body}: {' '.join(rule for one, rule in chosen.fired if one == handle)}"

    def drives(self, driven: Drives) -> Drives:
        """What is driven, and all others, which are not."""
        return {body: Drive(Fraction(0)) for body in range(len(self.plan.level.bodies))} | dict(driven)

    def storeys(self, world: World[Fraction]) -> StoreyWorld[Fraction]:
        """The storeys of a state."""
        places = [self.plan.place(world, body) for body in world.handles()]
        return StoreyWorld(self.plan.terrain, self.plan.level.margin, places)

    def outcome(self, before: StoreyWorld[Any], asked: Driven[Fraction], most: int = MOST_CHOSEN) -> Outcome:
        """What the rules make of a step.

        Raises:
            Endless: if rules are chosen more than `most` times.
        """
        driven, time = asked
        names = [body.name for body in self.plan.level.bodies]
        drives, after = self.drives(driven), before.copy()
        came, chosen = run(self.profile.rules, after, drives, time + before.margin * 0, most)
        moments = [with_known_speeds(moment) for moment in came]
        moved = {body: sum((m.velocities[body] * value_of(m.moved) for m in moments), Fraction(0)) for body in drives}
        happened = tuple(told(names, time, moments))
        return Outcome(after, moved, happened, moments[-1].velocities, chosen.chosen, moments)

    def among_all_ways(
        self, step: Step, before: StoreyWorld[Any], seen: StoreyWorld[Any], tolerance: Fraction, first: Outcome
    ) -> tuple[Finding, Outcome]:
        """Whether the bodies are where they may be if ties are broken in another way, and what happened then.

        Ties of the same two values are broken alike all through the step, or else for each body by itself when it looks
        for its support. Velocities are exact, or else those that are sums are not. Of events at one instant, of which
        such a tie does not tell which is which, any may come first.
        """
        asked = self.driven(step.before, step.line)
        least, most = tolerance * slowest(asked[0]), self.plan.level.margin / PART * slowest(asked[0])
        apart = max(least, min(most, self.spread(first, asked).apart)) if tolerance else tolerance
        finding, rules, near = Finding.DIVERGES, self.profile.rules, nearly(before)
        ways = (
            (rules, near),
            (with_rounded_sums(rules), near),
            (rules, each_by_itself(near)),
            (told_apart(rules, least), near),
        )
        for some, where in ways if tolerance else ():
            try:
                for outcome in self.ways(some, where, asked, apart, MORE_WORK * first.work):
                    if self.agrees(step, outcome, seen, self.within(outcome, asked, tolerance)):
                        return Finding.ONE_OF_SEVERAL, outcome
            except TooManyWays:
                finding = Finding.AMBIGUOUS
        return finding, first

    def ways(
        self, rules: StepRules, before: StoreyWorld[Any], asked: Driven[Fraction], apart: Fraction, most: int
    ) -> Iterator[Outcome]:
        """The outcomes of a step by rules, with ties broken in every way: of numbers so far apart at most.

        Raises:
            TooManyWays: if there are too many.
        """
        judge = replace(self, profile=replace(self.profile, rules=rules))

        def one_way(choices: Choices) -> Outcome | None:
            token = TIES.set(Ties(apart, choices))
            try:
                return judge.outcome(before, asked, most)
            except (Endless, GuardError):
                return None
            finally:
                TIES.reset(token)

        yield from (outcome for outcome in every_way(one_way, MOST_WAYS) if outcome is not None)

    def agrees(self, step: Step, outcome: Outcome, seen: StoreyWorld[Any], tolerance: Fraction) -> bool:
        """Whether bodies are seen where an outcome has them, with the velocities that it leaves to them."""
        wrong = of_the_velocities(step.after, self.left(step, outcome), tolerance)
        return not any(self.elsewhere(outcome.storeys, seen, tolerance)) and not any(wrong)

    def displaced(
        self, expected: StoreyWorld[Any], seen: StoreyWorld[Any], tolerance: Fraction, after: World[Fraction]
    ) -> Iterator[Difference]:
        """The bodies that are seen elsewhere, or on something else, than they are expected to be."""
        for body, side, off in self.elsewhere(expected, seen, tolerance):
            held, place = self.plan.bodies(expected)[body], expected.places[body]
            right = f"{position_text(self.plan.level, getattr(held, side))}, at {readable(getattr(place, side))}"
            held, place = after.bodies[body], seen.places[body]
            told = f"{position_text(after.level, getattr(held, side))}, at {readable(getattr(place, side))}"
            yield Difference(held.name, side, right, told, off)

    def elsewhere(
        self, expected: StoreyWorld[Any], seen: StoreyWorld[Any], tolerance: Fraction
    ) -> Iterator[tuple[int, str, Fraction]]:
        """The borders that are seen elsewhere, by how much; 0 where that is on something else."""
        for body, (one, two) in enumerate(zip(expected.places, seen.places, strict=True)):
            apart = abs(short_way(value_of(one.left) - two.left, self.plan.terrain.circumference))
            same = one.storey == two.storey and one.support == two.support
            for side, off in (("left", apart), ("right", abs(apart + value_of(one.width) - two.width))):
                if not same or off > tolerance:
                    yield body, side, off if same else Fraction(0)

    def of_the_events(self, line: LineRecord, outcome: Outcome) -> Iterator[Difference]:
        """What a line says of its events, and is not so."""
        if line.events is None:
            return
        events = events_of(self.profile)
        right = [event_record(one, events) for one in outcome.happened]
        if len(line.events) != len(right):
            yield Difference("", "events", f"{len(right)} events", f"{len(line.events)} events")
            return
        for place, (told_, one) in enumerate(
            zip(by_instant(line.events, right), by_instant(right, right), strict=True)
        ):
            if wrong := event_text(told_, one):
                yield Difference(told_.body, f"events[{place}]", *wrong)
                return

    def scenario(self, step: Step, body: str, name: str, note: str) -> ScenarioRecord | None:
        """The step as a scenario, without the bodies that do not matter to where one comes to be."""
        level = level_record(replace(self.plan.level, bodies=step.before.level.bodies, buttons=()), name)
        end = self.end(level, step.line, body)
        driven = {self.plan.level.bodies[one].name for one, _, _ in step.asked}
        if end is None:
            return None

        def needs_only(bodies: list[BodyRecord]) -> bool:
            return self.end(with_bodies(level, bodies), step.line, body) == end

        level = with_bodies(level, without_needless(level.bodies, needs_only, {body, *driven}))
        return ScenarioRecord("graphbody/scenario@1", name, level, [step.line.asked], self.profile.name, note=note)

    def end(self, record: LevelRecord, line: LineRecord, body: str) -> tuple[int, Fraction, str | None] | None:
        """Where a body of a level comes to be: storey, left border, on whose top; None if it cannot be played."""
        try:
            level = valid_level(record, "$", stance=stance_of(self.profile))
            check_plan(level)
        except (FormatError, LevelError):
            return None
        game = StepGame(self.profile, level, MOST_CHOICES)
        if line.tick is None:
            game.step(*of_step(level, line.asked))
        else:
            game.tick(line.tick.direction)
        place = game.storeys.places[game.names.index(body)]
        return place.storey, place.left, None if place.support is None else game.names[place.support]


def way(speed: Fraction) -> Direction:
    """The direction of a speed."""
    return Direction.LEFT if speed < 0 else Direction.RIGHT


def slowest(drives: Drives) -> Fraction:
    """How much time a distance of 1 may take at most: by the least speed, or difference of speeds, that is not 0."""
    speeds = {Fraction(0), *(drive.speed for drive in drives.values())}
    least = min((abs(one - two) for one in speeds for two in speeds if one != two), default=Fraction(1))
    return max(Fraction(1), 1 / least)


def nearly(world: StoreyWorld[Fraction]) -> StoreyWorld[Any]:
    """The same storeys, their numbers known nearly."""

    def interval(one: Interval[Fraction]) -> Interval[Any]:
        return Interval(Near(one.left), Near(one.right))

    ground = world.terrain
    terrain: Terrain[Any] = Terrain(
        tuple(tuple(interval(one) for one in solid) for solid in ground.solid),
        None if ground.ends is None else interval(ground.ends),
        None if ground.circumference is None else Near(ground.circumference),
    )
    other = world.copy()
    return with_numbers(other, terrain, Near)


def exactly(world: StoreyWorld[Any], terrain: Terrain[Fraction]) -> StoreyWorld[Fraction]:
    """The same storeys, with the exact values of their places, on exact terrain."""
    return with_numbers(world.copy(), terrain, value_of)


def with_numbers(world: StoreyWorld[Any], terrain: Terrain[Any], number: Callable[[Any], Any]) -> StoreyWorld[Any]:
    """Storeys with places in other numbers, in the order in which they are."""
    world.terrain, world.margin = terrain, number(world.margin)
    world.places = [replace(one, left=number(one.left), width=number(one.width)) for one in world.places]
    return world


def by_instant(events: list[EventRecord], right: list[EventRecord]) -> list[EventRecord]:
    """As many events as there are by the rules, those of one instant in one order: a log may tell them in any."""
    pairs = zip((one.time for one in right), events, strict=True)
    instants = (sorted((one for _, one in some), key=name_of) for _, some in groupby(pairs, key=lambda pair: pair[0]))
    return [one for instant in instants for one in instant]


def name_of(event: EventRecord) -> tuple[str, str, str]:
    """What tells events of one instant apart."""
    return event.body, event.rule, event.other or ""


def event_text(told: EventRecord, right: EventRecord) -> tuple[str, str] | None:
    """An event as it is and as a line tells it, where these differ; what a line leaves out is not judged."""
    same = (told.body, told.event, told.rule) == (right.body, right.event, right.rule)
    same &= told.time is None or exact(told.time, "$") == exact(right.time or 0, "$")
    same &= told.velocities is None or speeds_of(told) == speeds_of(right)
    same &= told.other is None or told.other == right.other
    return None if same else (as_json(right), as_json(told))


def speeds_of(event: EventRecord) -> dict[str, Fraction]:
    """The velocities of an event."""
    return {name: exact(speed, "$") for name, speed in (event.velocities or {}).items()}


@dataclass(frozen=True)
class OfChanges:
    """Who judges a line in which a body comes or goes, from the state before it, by the judges of before and after."""

    state: World[Fraction]
    before: OfSteps
    after: OfSteps

    def asked(self, before: World[Fraction], line: LineRecord) -> tuple[Request, ...]:
        """Nobody is driven."""
        return ()

    def walks(self, step: Step) -> int:
        """Nobody moves but down."""
        return 1

    def judge(self, step: Step, tolerance: Fraction) -> tuple[Judgement, list[Difference]]:
        """Whether there is room for who comes, who loses a support settles, and all others stay."""
        start = self.start(step.line)
        outcome = self.after.outcome(start, ({}, Fraction(0)))
        seen, level = self.after.storeys(step.after), self.after.plan.level
        displaced = self.after.displaced(outcome.storeys, seen, tolerance, step.after)
        differences = (*(no_room(start, level, tolerance) if step.line.add is not None else ()), *displaced)
        world = World(replace(level, bodies=self.after.plan.bodies(outcome.storeys)))
        finding = Finding.DIVERGES if differences else Finding.AGREES
        said = () if tolerance or differences else self.after.of_the_events(step.line, outcome)
        return Judgement(finding, Expected(world, (), ()), differences), list(said)

    def start(self, line: LineRecord) -> StoreyWorld[Fraction]:
        """The storeys with the body that comes, where the line puts it, or without the one that goes."""
        storeys, level = self.before.storeys(self.state), self.after.plan.level
        if line.remove is not None:
            return storeys.without([body.name for body in self.state.bodies].index(line.remove.body))
        world = World(replace(level, bodies=(*self.state.bodies, level.bodies[-1])))
        return storeys.with_place(self.after.plan.place(world, len(self.state.bodies)))

    def trouble(self, step: Step, log: Recording, judgement: Judgement, tolerance: Fraction) -> Trouble:
        """What differs."""
        return Trouble(step, judgement.finding, judgement.differences, None, None)


def no_room(world: StoreyWorld[Fraction], level: Level[Fraction], tolerance: Fraction) -> Iterator[Difference]:
    """What is in the way of the last body, which has come; its height, if it is not that of a storey."""
    body = len(level.bodies) - 1
    name, place = level.bodies[body].name, world.places[body]
    if level.bodies[body].height != level.bodies[0].height:
        yield Difference(name, "height", readable(level.bodies[0].height), readable(level.bodies[body].height))
    if world.in_terrain(body):
        yield Difference(name, "add", "a place outside all terrain", f"from {place.left} to {place.right}")
    for other in world.row(place.storey):
        gap = -world.overlap(body, other)
        if other != body and gap < world.margin - tolerance:
            yield Difference(name, "add", f"{world.margin} to {level.bodies[other].name}", readable(gap))
