"""Recordings: what a trace holds, read from a trace or made by playing a scenario."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from importlib.metadata import version
from pathlib import Path
from typing import Any

from reference.formats.files import FormatError, decode, one_line, pieces
from reference.formats.level import (
    BodyRecord,
    Tops,
    body_of,
    position_of,
    position_record,
    tops_after,
    tops_in,
    tops_of,
    valid_level,
)
from reference.formats.numbers import exact, number_text
from reference.formats.scenario import DriveRecord, RemoveRecord, RequestRecord, TickRecord, check_step
from reference.formats.trace import EventRecord, HeaderRecord, LineRecord, MoveRecord, PlaceRecord, check_line
from reference.plan import without
from reference.play import ONE_BY_ONE, SAME_BODIES, Played, Playing, format_of, play, profile_of, stance_of, widths_of
from reference.rounding import PART
from reference.simulator import Fulfilled, Happened
from reference.world import LevelError, World, standing
from spec.body import Body, Level
from spec.profiles import AnyProfile, SteppedProfile
from spec.registry import rules_of
from spec.rules.velocity import Motion


@dataclass(frozen=True)
class Recording:
    """A trace: its header, the level and the profile that the header is about, and its lines as they come."""

    header: HeaderRecord
    level: Level[Any]
    profile: AnyProfile
    lines: Iterator[LineRecord]

    @property
    def most_off(self) -> Fraction:
        """How far its numbers may be off at most."""
        return Fraction(0) if self.header.numbers == "exact" else Fraction(self.level.margin) / PART


def recording(path: Path, floats: bool = False) -> Recording:
    """The recording in a trace file, or that of a scenario or level file when it is played.

    Raises:
        FormatError: one line that names the file, its line and the place, now or when a line is reached.
    """
    if format_of(path).startswith("graphbody/trace@"):
        return read_trace(path)
    playing = play(path, floats)
    profile = playing.game.profile
    level = valid_level(playing.level, "$", stance=stance_of(profile))
    return Recording(header_of(playing, floats), level, profile, lines_of(playing))


def read_trace(path: Path) -> Recording:
    """The recording in a trace file; its lines are read one after another.

    Raises:
        FormatError: one line that names the file, its line and the place, now or when a line is reached.
    """
    content = pieces(path)
    header = decode(next(content, b""), HeaderRecord, f"{path}:1")
    try:
        profile = profile_of(header.profile)
        level = valid_level(header.level, "$.level", header.numbers, stance_of(profile))
    except LevelError as error:
        raise FormatError(one_line(f"{path}:1: {error}")) from None
    tops = tops_of(header.level, len(level.graph.edges))
    lines = read_lines(path, content, tops)
    return Recording(header, level, profile, lines if isinstance(profile, SteppedProfile) else undriven(path, lines))


def undriven(path: Path, lines: Iterator[LineRecord]) -> Iterator[LineRecord]:
    """The same lines; none may be a drive, or let a body come or go."""
    for number, line in enumerate(lines, start=2):
        if line.drive is not None:
            raise FormatError(f"{path}:{number}: $.drive: {ONE_BY_ONE}")
        if line.add is not None or line.remove is not None:
            raise FormatError(f"{path}:{number}: $: {SAME_BODIES}")
        yield line


def read_lines(path: Path, content: Iterator[bytes], tops: Tops, first: int = 1) -> Iterator[LineRecord]:
    """The lines after the header of a trace, the first of them with a number; it may end in empty ones."""
    for number, text in enumerate(content, start=first):
        where = f"{path}:{number + 1}"
        if not text.strip() and not any(rest.strip() for rest in content):
            return
        line = decode(text, LineRecord, where)
        check_step(line.asked, f"{where}: $")
        if line.step is not None and line.step != number:
            raise FormatError(f"{where}: $.step: expected {number}, got {line.step}")
        try:
            tops = tops_after(tops, *line.asked.comings, "$")
            check_line(line, tops)
        except LevelError as error:
            raise FormatError(one_line(f"{where}: {error}")) from None
        yield line


def header_of(playing: Playing, floats: bool) -> HeaderRecord:
    """The header of the trace of a scenario."""
    scenario = playing.scenario
    return HeaderRecord(
        format="graphbody/trace@1",
        name=scenario.name,
        profile=scenario.profile,
        numbers="float64" if floats else "exact",
        level=playing.level,
        made_by=f"graphbody {version('graphbody')}",
        note=scenario.note,
    )


def lines_of(playing: Playing) -> Iterator[LineRecord]:
    """The lines of the trace of a scenario, as it is played."""
    events = events_of(playing.game.profile)
    for number, step in enumerate(playing.steps, start=1):
        yield line_of(step, number, playing.game.level, events)


def events_of(profile: AnyProfile) -> dict[str, str]:
    """The events of a profile, by the IDs of the rules by which they come about."""
    return {rule.id: rule.event for rule in rules_of(profile) if rule.event is not None}


def line_of(step: Played[Any], number: int, level: Level[Any], events: dict[str, str]) -> LineRecord:
    """A step as it stands in a trace."""
    return LineRecord(
        step=number,
        request=step.asked if isinstance(step.asked, RequestRecord) else None,
        tick=step.asked if isinstance(step.asked, TickRecord) else None,
        drive=step.asked if isinstance(step.asked, DriveRecord) else None,
        add=step.asked if isinstance(step.asked, BodyRecord) else None,
        remove=step.asked if isinstance(step.asked, RemoveRecord) else None,
        moves=[move_record(move) for move in step.moves],
        events=list(event_records(step, events)),
        bodies=[place_record(body, level) for body in step.bodies],
        supports=supports_of(step.bodies, level),
        pressed=list(step.pressed) if step.pressed else None,
        solved=all(step.pressed) if step.pressed else None,
    )


def event_records(step: Played[Any], events: dict[str, str]) -> Iterator[EventRecord]:
    """What happened in a step as it stands in a trace; with its time, where all bodies move at once."""
    if step.happened is not None:
        yield from (event_record(one, events) for one in step.happened)
        return
    for move in step.moves:
        yield from (EventRecord(body, events[rule], rule) for body, rule in move.fired if rule in events)


def event_record(one: Happened[Any], events: dict[str, str]) -> EventRecord:
    """What happened at an instant as it stands in a trace."""
    speeds = {name: number_text(speed) for name, speed in one.velocities.items()}
    return EventRecord(one.body, events[one.rule], one.rule, number_text(one.time), speeds, one.other)


def move_record(move: Fulfilled[Any]) -> MoveRecord:
    """A request as it was fulfilled, as it stands in a trace."""
    asked, moved = number_text(move.asked), number_text(move.moved)
    return MoveRecord(move.body, asked, moved, list(move.fired), move.depth, move.work)


def place_record(body: Body[Any], level: Level[Any]) -> PlaceRecord:
    """Where a body is, as it stands in a trace."""
    velocity = None if body.motion is None else number_text(body.motion.velocity)
    return PlaceRecord(body.name, position_record(body.left, level), position_record(body.right, level), velocity)


def supports_of(bodies: tuple[Body[Any], ...], level: Level[Any]) -> dict[str, str]:
    """For each body that stands on another, which."""
    statics = len(level.graph.edges)
    return {body.name: bodies[body.left.edge - statics].name for body in bodies if body.left.edge >= statics}


def following(level: Level[Fraction], line: LineRecord) -> Level[Fraction]:
    """The level after a line: with the body that it adds, or without the one that it removes."""
    if line.add is not None:
        tops = tops_after(tops_in(level), line.add.name, None, "$")
        return replace(level, bodies=(*level.bodies, body_of(line.add, tops, "$.add")))
    if line.remove is not None:
        return without(level, [body.name for body in level.bodies].index(line.remove.body))
    return level


def state_after(recording: Recording, level: Level[Fraction], line: LineRecord) -> World[Fraction]:
    """The world of a level in which a line of a trace says that its step ended: any state that bodies can be in, good
    or bad.

    Raises:
        LevelError: if bodies cannot be so.
    """
    tops = tops_in(level)
    places = {place.name: (f"$.bodies[{i}]", place) for i, place in enumerate(line.bodies)}
    bodies = []
    for body in level.bodies:
        at, place = places[body.name]
        left, right = position_of(place.left, tops, f"{at}.left"), position_of(place.right, tops, f"{at}.right")
        motion = motion_after(body, place.velocity, f"{at}.velocity")
        bodies.append(replace(body, left=left, right=right, motion=motion))
    return standing(replace(level, bodies=tuple(bodies)), widths_of(recording.profile), recording.most_off)


def motion_after(body: Body[Fraction], velocity: Any, place: str) -> Motion[Fraction] | None:
    """The motion of a body with the velocity that a line says it has.

    Raises:
        LevelError: if the body has none, or the line does not say a number where it has.
    """
    if body.motion is None:
        if velocity is not None:
            raise LevelError(place, f"expected none: {body.name!r} has no velocity of its own")
        return None
    if velocity is None:
        raise LevelError(place, f"expected the velocity of {body.name!r}, which moves of its own")
    return replace(body.motion, velocity=exact(velocity, place))
