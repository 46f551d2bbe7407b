"""Trace files: JSON lines. The first is a header with the level, each other one is a step and the state after it."""

from __future__ import annotations

from typing import Annotated, Literal

from msgspec import Meta

from reference.formats.files import Many, Name, Record
from reference.formats.level import LevelRecord, Position
from reference.formats.numbers import Number
from reference.formats.scenario import RequestRecord, TickRecord

Count = Annotated[int, Meta(ge=1)]


class HeaderRecord(Record, frozen=True):
    """The first line of a trace: the level at its start, and what its numbers are.

    `numbers` says how the program that wrote the trace computes. With a `grid` every number is a whole multiple of it,
    small enough that nothing is ever rounded; then the trace is judged to the bit.
    """

    format: Literal["graphbody/trace@1"]
    name: Name
    profile: str
    numbers: Literal["exact", "float64", "float32"]
    level: LevelRecord
    grid: Number | None = None
    made_by: str = ""
    note: str = ""


class MoveRecord(Record, frozen=True):
    """One request as it was fulfilled: what was asked and moved, and the rules that fired, each with its body.

    `chain` is how many bodies requests went through; `work` counts what it took. Neither is judged.
    """

    body: Name
    asked: Number
    moved: Number
    fired: Many[tuple[Name, str]] | None = None
    chain: Count | None = None
    work: dict[str, int] | None = None


class EventRecord(Record, frozen=True):
    """What happened to a body in a step, in one word, and the rule by which it did."""

    body: Name
    event: str
    rule: str


class PlaceRecord(Record, frozen=True):
    """Where a body is after a step."""

    name: Name
    left: Position
    right: Position


class LineRecord(Record, frozen=True, kw_only=True):
    """Any other line of a trace: a request or a tick, and the state after it; what else it says is checked too.

    `supports` names for each body that stands on another the one it stands on; `pressed` says of each button whether it
    is, and `solved` whether all are.
    """

    step: Count | None = None
    request: RequestRecord | None = None
    tick: TickRecord | None = None
    moves: Many[MoveRecord] | None = None
    events: Many[EventRecord] | None = None
    bodies: Many[PlaceRecord]
    supports: dict[Name, Name] | None = None
    pressed: Many[bool] | None = None
    solved: bool | None = None
