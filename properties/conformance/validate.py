"""Validation: a log is read line by line, each step is judged, and what was found is summed up."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from fractions import Fraction
from itertools import chain, islice
from pathlib import Path
from typing import Protocol

import numpy as np

from properties.conformance.diagnosis import Trouble, diagnose
from properties.conformance.judge import Difference, Finding, Judgement, judge
from properties.conformance.log import (
    Grid,
    Request,
    Step,
    grid_of,
    precision,
    requests_of,
    rolled,
    tolerance_of,
)
from properties.conformance.minimise import Reduction
from properties.conformance.quick import look_of
from properties.conformance.said import (
    of_the_events,
    of_the_grid,
    of_the_moves,
    of_the_rolls,
    of_the_state,
    of_the_velocities,
)
from properties.conformance.stepping import OfChanges, OfSteps
from properties.conformance.walks import most_walks
from reference.formats.files import FormatError, one_line, pieces
from reference.formats.level import tops_in
from reference.formats.trace import LineRecord
from reference.plan import check_plan, plan_of
from reference.recording import Recording, following, read_lines, read_trace, state_after
from reference.rounding import tolerance as rounding
from reference.simulator import MOST_FIRED, Endless, Fulfilled, move
from reference.world import LevelError, World
from spec.body import Level
from spec.graph import Direction, EdgeType
from spec.invariants import NO_OVERLAP, RIGID_WIDTH, Deed, Invariant
from spec.plane import APART, NEVER_RAISED, PLANE_MARGIN, TERRAIN
from spec.profiles import PROFILES, AnyProfile, Profile
from spec.rule import GuardError

OF_STRINGS: tuple[Invariant, ...] = (NO_OVERLAP, RIGID_WIDTH)
IN_PLANE: tuple[Invariant, ...] = (APART, PLANE_MARGIN, TERRAIN)
MOST_IN_PLANE = 32
ANY_SLACK = Fraction(1, 100)
AT_ONCE = 1024


@dataclass(frozen=True)
class Breach:
    """A line of a log in which an invariant is broken, and whether the step is one that the rules allow."""

    line: int
    allowed: bool


@dataclass
class Report:
    """What was found in one log.

    Attributes:
        found: how many steps were found to be what.
        first: the first step that diverges or is ambiguous.
        broken: for each invariant that was broken, by the log's own states, where it was first.
        invalid: the line and the place of a state that no body can be in, at which the validation ended.
        unread: what is wrong with a line that cannot be read, at which the validation ended.
    """

    path: Path
    profile: str
    found: Counter[Finding] = field(default_factory=Counter)
    first: Trouble | None = None
    broken: dict[str, Breach] = field(default_factory=dict)
    invalid: str | None = None
    unread: str | None = None

    @property
    def conforms(self) -> bool:
        """Whether every step is one that the rules allow."""
        return (
            self.invalid is None
            and self.unread is None
            and not self.found[Finding.DIVERGES]
            and not self.found[Finding.AMBIGUOUS]
        )


class Crash(Exception):
    """The validator itself failed at a line: that says nothing of the log."""


class StateError(Exception):
    """A line of a log says that its step ended in a state that no body can be in."""


def validate(path: Path) -> Report:
    """Judge every step of a trace from the trace's own state before it.

    Raises:
        FormatError: one line, if the file is not a trace.
        Crash: if this program fails.
    """
    log = read_trace(path)
    report = Report(path, log.profile.name)
    try:
        grid, referee = grid_of(log), referee_of(log)
    except LevelError as error:
        raise FormatError(one_line(f"{path}:1: {error}")) from None
    try:
        for step, log_now, referee_now in doubtful(path, log, referee, report):
            look_at(step, log_now, referee_now, grid, report)
    except Endless as error:
        report.unread = f"{path}:{step.number}: $: {error}"
    except FormatError as error:
        report.unread = str(error)
    except GuardError as error:
        report.invalid = f"{path}:{step.number - 1}: $.bodies: no rule says what comes of it, {error}"
    except StateError as error:
        report.invalid = str(error)
    except Exception as error:
        raise Crash(f"{path}: internal error, please report it: {error!r}") from error
    if not report.found and report.unread is None and report.invalid is None:
        raise FormatError(f"{path}:2: $: expected a step after the header")
    return report


def referee_of(log: Recording) -> Referee:
    """Who judges a log of its profile.

    Raises:
        LevelError: if the level is not one that the profile is about.
    """
    nearly = tolerance_of(log.header, log.level, ()) / log.level.tick
    if isinstance(log.profile, Profile):
        return OfRequests(log.level, log.profile, nearly)
    check_plan(log.level)
    numbers = precision(log.header)
    return OfSteps(plan_of(log.level), log.profile, nearly, "float64" if numbers == "exact" else numbers)


def referee_after(log: Recording, referee: OfSteps) -> OfSteps:
    """The judge of a log when bodies have come or gone."""
    return replace(referee, plan=replace(referee.plan, level=log.level))


def doubtful(path: Path, log: Recording, referee: Referee, report: Report) -> Iterator[Judged]:
    """The steps of a log that are to be judged; those that a quick look finds to be beyond doubt are counted.

    After an empty line, and after one with which a body comes or goes, all are.
    """
    look = look_of(log, referee) if isinstance(referee, OfSteps) else None
    if look is None:
        yield from steps_of(path, log, referee, World(log.level), 2)
        return
    content, number = pieces(path), 2
    before = next(content, b"")
    state: World[Fraction] | None = World(log.level)
    rest: list[bytes] = []
    while texts := rest or list(islice(content, AT_ONCE)):
        close = too_close(report)
        certain, rest, done = look.certain([before, *texts], number - 1, close)[1:], [], 0
        for place in np.flatnonzero(~certain).tolist():
            report.found += Counter({Finding.AGREES: place - done})
            if place > done or state is None:
                state = state_of(path, log, texts[place - 1] if place else before, number + place - 1)
            whole = not texts[place].strip() or comes_or_goes(texts[place])
            some = chain(texts[place:], content) if whole else iter([texts[place]])
            for judged in steps_of(path, with_lines(path, log, some, number + place), referee, state, number + place):
                yield judged
                state = judged[0].after
            if whole:
                return
            done = place + 1
            if too_close(report) != close:
                texts, rest = texts[:done], texts[done:]
                break
        report.found += Counter({Finding.AGREES: len(texts) - done})
        state = state if done == len(texts) else None
        before, number = texts[-1], number + len(texts)


def too_close(report: Report) -> bool:
    """Whether it has been said that the margin is broken: roundings that add up bring bodies nearer, and nothing
    puts that right, so that it would be of all lines from there on.
    """
    return {NO_OVERLAP.id, PLANE_MARGIN.id} <= report.broken.keys()


def comes_or_goes(text: bytes) -> bool:
    """Whether with a line a body may come or go."""
    return b'"add"' in text or b'"remove"' in text or b"\\" in text


def with_lines(path: Path, log: Recording, texts: Iterator[bytes], number: int) -> Recording:
    """A log with other lines, which have yet to be read; the first has a number in the file."""
    return replace(log, lines=read_lines(path, texts, tops_in(log.level), number - 1))


def state_of(path: Path, log: Recording, text: bytes, number: int) -> World[Fraction]:
    """The state after a line that is beyond doubt."""
    (line,) = with_lines(path, log, iter([text]), number).lines
    return world_after(log, line, f"{path}:{number}")


def steps_of(path: Path, log: Recording, referee: Referee, state: World[Fraction], first: int) -> Iterator[Judged]:
    """The steps of a log, one after another, each with the level and the judge that it is for.

    The lines of the log begin with a number in the file, after a state.

    Raises:
        FormatError: at the first line that is none.
        StateError: at the first line that says that its step ended in a state that no body can be in.
    """
    for number, line in enumerate(log.lines, start=first):
        if (line.add is not None or line.remove is not None) and isinstance(referee, OfSteps):
            log, before = replace(log, level=following(log.level, line)), referee
            referee = referee_after(log, referee)
            after = world_after(log, line, f"{path}:{number}")
            yield Step(number, after, (), line, after), log, OfChanges(state, before, referee)
            state = after
            continue
        asked, after = referee.asked(state, line), world_after(log, line, f"{path}:{number}")
        yield Step(number, state, asked, line, after), log, referee
        state = after


def world_after(log: Recording, line: LineRecord, where: str) -> World[Fraction]:
    """The state that a line says that its step ended in.

    Raises:
        StateError: if no body can be so.
    """
    try:
        return state_after(log, log.level, line)
    except LevelError as error:
        raise StateError(one_line(f"{where}: {error}")) from None


class Referee(Protocol):
    """Who judges the steps of a log."""

    def asked(self, before: World[Fraction], line: LineRecord, /) -> tuple[Request, ...]:
        """Who was to move how far in a step."""

    def walks(self, step: Step, /) -> int:
        """How often in a step what was rounded is rounded again, by the rules in exact numbers; at least once."""

    def judge(self, step: Step, tolerance: Fraction, /) -> tuple[Judgement, list[Difference]]:
        """What was found of a step, and what its line says of it that is not so."""

    def trouble(self, step: Step, log: Recording, judgement: Judgement, tolerance: Fraction, /) -> Trouble:
        """All that can be said of a step that diverges."""


Judged = tuple[Step, Recording, Referee]
"""A step that is to be judged, with the level and the judge that it is for."""


@dataclass(frozen=True)
class OfRequests:
    """Who judges steps in which bodies move one after another; `nearly` is how well velocities are known."""

    level: Level[Fraction]
    profile: Profile
    nearly: Fraction

    def asked(self, before: World[Fraction], line: LineRecord) -> tuple[Request, ...]:
        """The requests of a line, in order."""
        return requests_of(before, self.profile, line, self.nearly)

    def walks(self, step: Step) -> int:
        """How often a border walks along an edge, or may on a machine where there are ties."""
        world, limit, found = step.before.copy(), self.profile.push_limit(len(step.before.bodies)), 0
        for request in step.asked:
            most = most_walks(world, request, limit)
            _, record = move(self.profile, world, *request, MOST_FIRED)
            found += max(most, record.walks)
        return max(1, found)

    def judge(self, step: Step, tolerance: Fraction) -> tuple[Judgement, list[Difference]]:
        """Where the bodies are, and what the line says of its requests; of rules where they are known."""
        judgement = judge(self.profile, step.before, step.asked, step.after, tolerance)
        said: list[Difference] = []
        if judgement.finding in (Finding.AGREES, Finding.ONE_OF_SEVERAL):
            rules_known = judgement.finding is Finding.AGREES and not tolerance and in_one_order(step.before)
            said += of_the_moves(step.line, step.asked, judgement.expected, tolerance, rules_known)
            said += of_the_events(step.line, self.profile, judgement.expected) if rules_known else ()
            said += self.of_velocities(step, tolerance, rules_known)
        return judgement, said

    def of_velocities(self, step: Step, tolerance: Fraction, rules_known: bool) -> Iterator[Difference]:
        """What the line says of velocities, which change in ticks only; of their rules too, if these are known."""
        turns, world = list[Fulfilled[Fraction]](), step.before
        if step.line.tick is not None:
            turns, world = rolled(step.before, self.profile, step.line, self.nearly)
        yield from of_the_velocities(step.after, world.bodies, tolerance)
        yield from of_the_rolls(step.line, turns) if rules_known else ()

    def trouble(self, step: Step, log: Recording, judgement: Judgement, tolerance: Fraction) -> Trouble:
        """Which rule diverges, and the step as a small scenario."""
        diagnosis = diagnose(self.profile, step, judgement, tolerance)
        slack = diagnosis.difference.apart / 4 or ANY_SLACK
        reduction = Reduction(self.profile, step, diagnosis.difference.body, judgement.expected, slack)
        note = f"Line {step.number} of {log.header.name} has {diagnosis.difference}."
        scenario = reduction.smallest(f"line-{step.number}", note)
        return Trouble(step, judgement.finding, judgement.differences, diagnosis, scenario)


def look_at(step: Step, log: Recording, referee: Referee, grid: Grid | None, report: Report) -> None:
    """Judge a step; explain it if it is the first of its kind."""
    walks = 1 if precision(log.header) == "exact" else referee.walks(step)
    tolerance = tolerance_of(log.header, log.level, step.asked, walks)
    judgement, said = referee.judge(step, tolerance)
    finding, differences = judgement.finding, judgement.differences
    said = [*of_the_grid(step, grid), *of_the_state(step.line, step.after, tolerance), *said]
    if said and finding is not Finding.DIVERGES:
        finding, differences = Finding.DIVERGES, tuple(said)
    report.found[finding] += 1
    if finding in (Finding.DIVERGES, Finding.AMBIGUOUS) and report.first is None:
        found = replace(judgement, finding=finding, differences=differences)
        report.first = trouble(step, log, referee, found, tolerance)
    for invariant in broken_by(step, tolerance, PROFILES[log.header.profile]):
        report.broken.setdefault(invariant.id, Breach(step.number, allowed=finding is not Finding.DIVERGES))


def in_one_order(world: World[Fraction]) -> bool:
    """Whether no two bodies of a string begin at the same place, so that their order is known."""
    begins = [(id(world.row(body)), world.coordinate(world.bodies[body].left)) for body in world.handles()]
    return len(set(begins)) == len(begins)


def trouble(step: Step, log: Recording, referee: Referee, judgement: Judgement, tolerance: Fraction) -> Trouble:
    """All that can be said of a step that diverges."""
    moved = [difference for difference in judgement.differences if difference.field in ("left", "right")]
    if not moved:
        return Trouble(step, judgement.finding, judgement.differences, None, None)
    distances = (distance for _, _, distance in step.asked)
    in_floats = rounding("float64", log.level, *distances, walks=referee.walks(step))
    rounded = not tolerance and all(0 < difference.apart <= in_floats for difference in moved)
    return replace(referee.trouble(step, log, judgement, tolerance), rounded=rounded)


def broken_by(step: Step, tolerance: Fraction, profile: AnyProfile) -> Iterator[Invariant]:
    """The invariants that mean something under a profile, and hold before a step and not after it; those in the plane
    if bodies are not too many.
    """
    few = len(step.after.bodies) <= MOST_IN_PLANE
    level = all(edge.rise == 0 for edge in step.after.graph.edges if edge.type is EdgeType.GROUND)
    judged = (*OF_STRINGS, *(IN_PLANE if few else ()), *((NEVER_RAISED,) if few and level else ()))
    for invariant in (one for one in judged if one.id not in profile.not_asked):
        if not invariant.holds(deed_of(step, step.before, step.after, tolerance)):
            yield invariant


def deed_of(step: Step, before: World[Fraction], after: World[Fraction], tolerance: Fraction) -> Deed[Fraction]:
    """A step as the invariants see it, as far as a log tells."""
    body, direction, asked = step.asked[0] if step.asked else (0, Direction.RIGHT, Fraction(0))
    return Deed(before, after, body, direction, asked, asked, 0, 0, 0, tolerance)
