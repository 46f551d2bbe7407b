"""The smallest scenario for a step that diverges: without bodies that do not matter, in simple numbers."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import partial

import msgspec

from properties.conformance.judge import Expected, expect
from properties.conformance.log import Step, requests_of
from properties.conformance.said import fired_in
from reference.formats.level import BodyRecord, LevelRecord, level_of, level_record
from reference.formats.numbers import exact
from reference.formats.scenario import ScenarioRecord, StepRecord
from reference.formats.trace import LineRecord
from reference.play import stance_of
from reference.recording import events_of
from reference.simulator import Endless
from reference.world import LevelError, World, standing, world_of
from spec.body import EdgePosition
from spec.profiles import Profile

MOST_SMALLER, MOST_WORK = 200, 100_000
DENOMINATORS = (1, 2, 4, 10, 20, 100, 1000, 10**6, 10**9, 10**12)


@dataclass
class Reduction:
    """The search for a smaller step in which a body still ends where it was expected, and the same happens to it.

    Attributes:
        slack: how far from there its borders may then be.
        trials: how many more steps may be tried.
    """

    profile: Profile
    step: Step
    body: str
    expected: Expected
    slack: Fraction
    trials: int = MOST_SMALLER

    def __post_init__(self) -> None:
        """Try less often what takes long."""
        self.trials = min(MOST_SMALLER, MOST_WORK // (1 + sum(len(record.fired) for record in self.expected.records)))

    def smallest(self, name: str, note: str) -> ScenarioRecord | None:
        """The smallest scenario that is found; None if no simulator would accept the state before the step."""
        line = self.step.line
        level = level_record(replace(self.step.before.level, buttons=()), name)
        kept = {self.body, *([] if line.request is None else [line.request.body])}

        def needs_only(bodies: list[BodyRecord]) -> bool:
            return self.same(with_bodies(level, bodies), line)

        level = with_bodies(level, without_needless(level.bodies, needs_only, kept))
        simple = (pair for pair in simpler(level, line) if self.playable(pair[0]) and self.same(*pair))
        found = next(simple, (level, line))
        if not self.playable(found[0]):
            return None
        level, line = found
        asked = StepRecord(request=line.request, tick=line.tick)
        return ScenarioRecord("graphbody/scenario@1", name, level, [asked], self.profile.name, note=note)

    def same(self, level: LevelRecord, line: LineRecord) -> bool:
        """Whether the body ends where it was expected, and the same happens to it."""
        self.trials -= 1
        if self.trials < 0:
            return False
        try:
            held = standing(level_of(level), self.profile.widths)
            expected = expect(self.profile, held, requests_of(held, self.profile, line))
        except (LevelError, Endless):
            return False
        if self.happened(expected) != self.happened(self.expected):
            return False
        pairs = zip(borders(expected, self.body), borders(self.expected, self.body), strict=True)
        return all(self.near(one, two) for one, two in pairs)

    def playable(self, level: LevelRecord) -> bool:
        """Whether a simulator accepts a level."""
        try:
            world_of(level_of(level), stance=stance_of(self.profile))
        except LevelError:
            return False
        return True

    def near(self, one: EdgePosition[Fraction], two: EdgePosition[Fraction]) -> bool:
        """Whether two borders are as good as in the same place: of tops the number may have changed."""
        statics = self.step.before.statics
        return min(one.edge, statics) == min(two.edge, statics) and abs(one.location - two.location) <= self.slack

    def happened(self, expected: Expected) -> list[str]:
        """What happened to the body, in words."""
        events = events_of(self.profile)
        fired = [pair for i in range(len(expected.records)) for pair in fired_in(expected, i)]
        return [events[rule] for body, rule in fired if body == self.body and rule in events]


def borders(expected: Expected, name: str) -> tuple[EdgePosition[Fraction], EdgePosition[Fraction]]:
    """The borders of a body after a step."""
    body = next(body for body in expected.world.bodies if body.name == name)
    return body.left, body.right


def with_bodies(level: LevelRecord, bodies: list[BodyRecord]) -> LevelRecord:
    """The level with other bodies."""
    return msgspec.structs.replace(level, bodies=bodies)


def without_needless(
    bodies: list[BodyRecord], needs_only: Callable[[list[BodyRecord]], bool], kept: set[str]
) -> list[BodyRecord]:
    """The bodies that are needed: the others are left out by halves, quarters and so on, down to single ones."""
    size = len(bodies)
    while size:
        start = 0
        while start < len(bodies):
            rest = [body for i, body in enumerate(bodies) if body.name in kept or not start <= i < start + size]
            if len(rest) < len(bodies) and needs_only(rest):
                bodies = rest
            else:
                start += size
        size //= 2
    return bodies


def simpler(level: LevelRecord, line: LineRecord) -> Iterator[tuple[LevelRecord, LineRecord]]:
    """The step with its numbers rounded to simple fractions, the simplest first: of the whole level, or of bodies only.

    Last as it is, but for a margin that the bodies keep.
    """
    for most in DENOMINATORS:
        rounded = partial(simple, most=most)
        request = line.request
        if request is not None:
            request = msgspec.structs.replace(request, distance=rounded(request.distance))
        simple_line, bodies = msgspec.structs.replace(line, request=request), [at(b, rounded) for b in level.bodies]
        yield with_bodies(in_whole(level, rounded), bodies), simple_line
        yield with_bodies(level, bodies), simple_line
    yield msgspec.structs.replace(level, margin=str(margin_kept(level))), line


def simple(number: str | int | float, most: int) -> str:
    """The nearest fraction whose denominator is no larger than allowed."""
    return str(exact(number, "$").limit_denominator(most))


def at(body: BodyRecord, rounded: Callable[..., str]) -> BodyRecord:
    """The body with its numbers rounded."""
    left, right = (
        msgspec.structs.replace(border, location=rounded(border.location)) for border in (body.left, body.right)
    )
    return msgspec.structs.replace(body, left=left, right=right, speed=rounded(body.speed), height=rounded(body.height))


def in_whole(level: LevelRecord, rounded: Callable[..., str]) -> LevelRecord:
    """The level with the numbers of its graph, its margin and its tick rounded."""
    round_ = None if level.circumference is None else rounded(level.circumference)
    return msgspec.structs.replace(
        level,
        vertices=[(rounded(x), rounded(y)) for x, y in level.vertices],
        margin=rounded(level.margin),
        tick=rounded(level.tick),
        circumference=round_,
    )


def margin_kept(level: LevelRecord) -> Fraction:
    """The margin, or what the nearest neighbours are apart if that is less."""
    world = World(level_of(level))
    return min([world.margin, *(world.clear(*pair) for pair in world.neighbours())])
