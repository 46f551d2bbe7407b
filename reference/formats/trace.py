"""Trace files: JSON lines. The first is a header with the level, each other one is a step and the state after it."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Annotated, Literal

from msgspec import Meta

from reference.formats.files import Many, Name, Record, says
from reference.formats.level import BodyRecord, LevelRecord, Position, Tops, body_of, position_of
from reference.formats.numbers import Number, check_sums, exact
from reference.formats.scenario import DriveRecord, ProfileName, RemoveRecord, RequestRecord, StepRecord, TickRecord
from reference.world import LevelError

Count = Annotated[int, Meta(ge=1)]
ASIDE = "; not judged"


class HeaderRecord(Record, frozen=True):
    """The first line of a trace: the level as it was at the start, and what the numbers are."""

    format: Annotated[Literal["graphbody/trace@1"], says("what the file is, and the version of its format")]
    name: Annotated[Name, says("the name of the trace, often that of the scenario that was played")]
    profile: Annotated[ProfileName, says("the profile whose rules the trace follows")]
    numbers: Annotated[
        Literal["exact", "float64", "float32"],
        says("how the program that wrote the trace computes: exactly or in floats"),
    ]
    level: Annotated[LevelRecord, says("the level, with the bodies where they start")]
    grid: Annotated[
        Number | None,
        says("every number is a whole multiple of this, small enough that nothing is rounded; judged to the bit"),
    ] = None
    made_by: Annotated[str, says("the program that wrote the trace, and its version" + ASIDE)] = ""
    note: Annotated[str, says("what the trace shows" + ASIDE)] = ""


class MoveRecord(Record, frozen=True):
    """One request as it was fulfilled. A tick has one for each character, in turn."""

    body: Annotated[Name, says("who was to move")]
    asked: Annotated[Number, says("how far, in units of length; negative to the left")]
    moved: Annotated[Number, says("how far it moved, in units of length; negative to the left")]
    fired: Annotated[
        list[tuple[Name, str]] | None,
        says(
            "the IDs of the rules that fired, in order, each after the body that it moved; not judged under `repaired`"
        ),
    ] = None
    chain: Annotated[Count | None, says("how many bodies the request went through, or moved" + ASIDE)] = None
    work: Annotated[dict[str, int] | None, says("counts of what it took" + ASIDE)] = None


class EventRecord(Record, frozen=True):
    """What happened to a body in a step, beyond moving and staying."""

    body: Annotated[Name, says("to whom")]
    event: Annotated[str, says("what, in one word")]
    rule: Annotated[str, says("the ID of the rule by which it did")]
    time: Annotated[Number | None, says("when, in seconds since the step began; where all bodies move at once")] = None
    velocities: Annotated[dict[Name, Number] | None, says("the velocities up to then of the bodies that moved")] = None
    other: Annotated[Name | None, says("the body that it met, or whose top it lost or stands on now")] = None


class PlaceRecord(Record, frozen=True):
    """Where a body is after a step."""

    name: Annotated[Name, says("whose place it is")]
    left: Annotated[Position, says("where its left border is")]
    right: Annotated[Position, says("where its right border is")]
    velocity: Annotated[
        Number | None,
        says("its velocity then, in units of length per second; needed of a body that has one of its own in the level"),
    ] = None


class LineRecord(Record, frozen=True, kw_only=True):
    """Any other line of a trace: a step and the state after it.

    One of `request`, `tick`, `drive`, `add` and `remove` is given. What is left out is not judged.
    """

    step: Annotated[Count | None, says("the number of the step, counted from 1")] = None
    request: Annotated[RequestRecord | None, says("a body was to move by a distance")] = None
    tick: Annotated[TickRecord | None, says("a key was held")] = None
    drive: Annotated[DriveRecord | None, says("bodies were driven for a time; only under `repaired`")] = None
    add: Annotated[BodyRecord | None, says("a body was put into the level, there; only under `repaired`" + ASIDE)] = (
        None
    )
    remove: Annotated[RemoveRecord | None, says("a body was taken out of the level; only under `repaired`" + ASIDE)] = (
        None
    )
    moves: Annotated[Many[MoveRecord] | None, says("the requests as they were fulfilled, in order")] = None
    events: Annotated[list[EventRecord] | None, says("what happened, in order")] = None
    bodies: Annotated[Many[PlaceRecord], says("where all bodies that are in the level then are after the step")]
    supports: Annotated[
        dict[Name, Name] | None, says("after the step, for each body that stands on another, that other's name")
    ] = None
    pressed: Annotated[Many[bool] | None, says("after the step, for each button, whether it is pressed")] = None
    solved: Annotated[bool | None, says("after the step, whether all buttons are pressed")] = None

    @property
    def asked(self) -> StepRecord:
        """What was asked, as a step of a scenario."""
        return StepRecord(self.request, self.tick, self.drive, self.add, self.remove)


def check_line(line: LineRecord, tops: Tops) -> None:
    """Refuse a line that is not about the bodies and edges of the header's level.

    Raises:
        LevelError: with the place in the line.
    """
    seen: set[str] = set()
    for i, place in enumerate(line.bodies):
        check_name(place.name, tops, f"$.bodies[{i}].name")
        if place.name in seen:
            raise LevelError(f"$.bodies[{i}].name", f"expected each body once, got {place.name!r} again")
        seen.add(place.name)
    check_sums(locations_of(line, tops))
    for name in tops.edges:
        if name not in seen:
            raise LevelError("$.bodies", f"expected the place of every body, got none of {name!r}")
    if line.tick is not None and line.tick.times != 1:
        raise LevelError("$.tick.times", f"expected 1, a line of a trace for each tick, got {line.tick.times}")
    if line.request is not None:
        check_name(line.request.body, tops, "$.request.body")
        exact(line.request.distance, "$.request.distance")
    if line.add is not None:
        body_of(line.add, tops, "$.add")
    if line.drive is not None:
        check_drive(line.drive, tops)
    check_said(line, tops)


def check_drive(drive: DriveRecord, tops: Tops) -> None:
    """Refuse a drive of bodies that are not there, or for a time that is none."""
    if exact(drive.time, "$.drive.time") < 0:
        raise LevelError("$.drive.time", f"expected a time of at least 0, got {drive.time}")
    for name, speed in drive.speeds.items():
        check_name(name, tops, "$.drive.speeds")
        exact(speed, "$.drive.speeds")


def locations_of(line: LineRecord, tops: Tops) -> Iterator[tuple[str, tuple[Fraction, Fraction]]]:
    """Where the borders of the bodies are along their edges, with their places in the line."""
    for i, place in enumerate(line.bodies):
        left = position_of(place.left, tops, f"$.bodies[{i}].left")
        right = position_of(place.right, tops, f"$.bodies[{i}].right")
        yield f"$.bodies[{i}]", (left.location, right.location)


def check_said(line: LineRecord, tops: Tops) -> None:
    """Refuse moves and events of bodies that are not there, and moves without numbers."""
    for i, move in enumerate(line.moves or ()):
        check_name(move.body, tops, f"$.moves[{i}].body")
        exact(move.asked, f"$.moves[{i}].asked")
        exact(move.moved, f"$.moves[{i}].moved")
    for i, event in enumerate(line.events or ()):
        check_name(event.body, tops, f"$.events[{i}].body")


def check_name(name: str, tops: Tops, place: str) -> None:
    """Refuse the name of no body of the level."""
    if name not in tops.edges:
        raise LevelError(place, f"no body is named {name!r}")
