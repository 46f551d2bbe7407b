"""Playing scenarios: from a file, step by step, in exact numbers or in floats."""

from __future__ import annotations

from collections.abc import Iterator, Set
from dataclasses import dataclass
from fractions import Fraction
from itertools import chain
from pathlib import Path
from typing import Any, Generic

import msgspec

from reference.formats.files import FormatError, decode, one_line, pieces, read
from reference.formats.level import (
    BodyRecord,
    LevelRecord,
    Tops,
    body_of,
    distances_per_tick,
    numbers_of,
    tops_after,
    tops_in,
    valid_level,
)
from reference.formats.numbers import check_sums, exact
from reference.formats.scenario import Asked, DriveRecord, ScenarioRecord, StepRecord, TickRecord, read_scenario
from reference.plan import check_plan
from reference.simulator import Endless, Fulfilled, Game, Happened
from reference.stepping import StepGame
from reference.world import LevelError, Stance
from spec.body import Body, Level
from spec.features import WIDE, Widths
from spec.number import N
from spec.profiles import PROFILES, AnyProfile, SteppedProfile
from spec.transform import body_with_numbers, in_floats

LIBRARY = Path(__file__).parent

SAME_BODIES = "expected a request or a tick: under this profile a level keeps its bodies"
ONE_BY_ONE = 'expected a request or a tick: only under "profile": "repaired" are bodies driven, all at once'

AnyGame = Game[Any] | StepGame[Any]


class Unwieldy(Exception):
    """Velocities have made exact numbers so long that no file can hold them."""


@dataclass(frozen=True)
class Played(Generic[N]):
    """One request, tick or drive: how it was fulfilled, all bodies after it, and which buttons are pressed."""

    asked: Asked
    moves: tuple[Fulfilled[N], ...]
    bodies: tuple[Body[N], ...]
    pressed: tuple[bool, ...]
    happened: tuple[Happened[N], ...] | None


@dataclass(frozen=True)
class Playing:
    """A scenario, its level as it stands in the file, the game, and its steps as they are played."""

    scenario: ScenarioRecord
    level: LevelRecord
    game: AnyGame
    steps: Iterator[Played[Any]]


class Tagged(msgspec.Struct, frozen=True):
    """Any document, as far as its format."""

    format: str


def library() -> list[Path]:
    """The scenarios that come with the project, by name."""
    return sorted((LIBRARY / "scenarios").glob("*.json"))


def format_of(path: Path) -> str:
    """What a file says it is. The first line of a trace is a document of its own.

    Raises:
        FormatError: if it does not say.
    """
    if path.exists() and not path.is_file() and not path.is_dir():
        raise FormatError(one_line(f"{path}: expected a file, which can be read more than once"))
    try:
        return decode(next(pieces(path), b""), Tagged, str(path)).format
    except FormatError:
        return read(path, Tagged).format


def read_playable(path: Path) -> tuple[ScenarioRecord, LevelRecord]:
    """A scenario and its level; a level is a scenario without steps.

    Raises:
        FormatError: if either cannot be read.
    """
    found = format_of(path)
    if found.startswith("graphbody/trace@"):
        raise FormatError(f"{path}: $.format: expected a level or a scenario; a trace is for validate, draw and itf")
    if not found.startswith("graphbody/level@"):
        return read_scenario(path)
    level = read(path, LevelRecord)
    return ScenarioRecord("graphbody/scenario@1", level.name, level=path.name, steps=[], note=level.note), level


def profile_of(name: str) -> AnyProfile:
    """The profile of a name.

    Raises:
        LevelError: if there is none.
    """
    if name not in PROFILES:
        raise LevelError("$.profile", f"expected one of {', '.join(PROFILES)}, got {name!r}")
    return PROFILES[name]


def widths_of(profile: AnyProfile) -> Widths:
    """The widths that bodies have under a profile."""
    return WIDE if isinstance(profile, SteppedProfile) else profile.widths


def stance_of(profile: AnyProfile) -> Stance:
    """How bodies may stand under a profile: where they stand in whole steps, a top holds whoever is
    nearer than the margin.
    """
    return Stance(widths_of(profile), beside=isinstance(profile, SteppedProfile))


def set_up(scenario: ScenarioRecord, level: LevelRecord, floats: bool) -> AnyGame:
    """The game of a scenario at its start.

    Raises:
        LevelError: if the level, the profile or a step's body is not as it must be.
    """
    profile = profile_of(scenario.profile)
    held = valid_level(level, "$.level", stance=stance_of(profile))
    distances = list(distances_of(scenario, held))
    asked = ((place, (distance,)) for place, distance in distances)
    check_sums(chain(numbers_of(held), distances_per_tick(held), asked))
    numbers = rounded(held) if floats else held
    if isinstance(profile, SteppedProfile):
        check_storeys(held)
        return StepGame(profile, numbers)
    check_requests(scenario)
    return Game(profile, numbers)


def check_requests(scenario: ScenarioRecord) -> None:
    """Refuse drives where bodies move one after another, and bodies that come and go.

    Raises:
        LevelError: with the place in the scenario.
    """
    for i, step in enumerate(scenario.steps):
        if step.drive is not None:
            raise LevelError(f"$.steps[{i}].drive", ONE_BY_ONE)
        for name, given in (("add", step.add), ("remove", step.remove)):
            if given is not None:
                raise LevelError(f"$.steps[{i}].{name}", SAME_BODIES)


def check_storeys(level: Level[Fraction]) -> None:
    """Refuse a level that is not one of storeys.

    Raises:
        LevelError: with the place in the scenario.
    """
    try:
        check_plan(level)
    except LevelError as error:
        raise error.under("$.level") from None


def rounded(level: Level[Any]) -> Level[float]:
    """A level in floats.

    Raises:
        LevelError: if floats do not tell the borders of a body apart.
    """
    binary = in_floats(level)
    for i, (body, exactly) in enumerate(zip(binary.bodies, level.bodies, strict=True)):
        if body.left == body.right and exactly.left != exactly.right:
            raise LevelError(f"$.level.bodies[{i}]", "expected borders that floats tell apart")
    return binary


def distances_of(scenario: ScenarioRecord, level: Level[Any]) -> Iterator[tuple[str, Fraction]]:
    """The distances that a scenario asks for, each with its place."""
    tops = tops_in(level)
    for i, step in enumerate(scenario.steps):
        tops = tops_after(tops, *step.comings, f"$.steps[{i}]")
        if step.request is not None:
            if step.request.body not in tops.edges:
                raise LevelError(f"$.steps[{i}].request.body", f"no body is named {step.request.body!r}")
            place = f"$.steps[{i}].request.distance"
            yield place, exact(step.request.distance, place)
        if step.drive is not None:
            yield from driven_distances(step.drive, tops.edges.keys(), f"$.steps[{i}].drive")
        if step.add is not None:
            yield from added_distances(step.add, tops, level.tick, f"$.steps[{i}].add")


def driven_distances(drive: DriveRecord, names: Set[str], where: str) -> Iterator[tuple[str, Fraction]]:
    """How far bodies want to move in a drive, and their speeds, with their places.

    Raises:
        LevelError: if there is no such body, or the time is less than 0.
    """
    time = exact(drive.time, f"{where}.time")
    if time < 0:
        raise LevelError(f"{where}.time", f"expected a time of at least 0, got {drive.time}")
    for name, speed in drive.speeds.items():
        place = f"{where}.speeds"
        if name not in names:
            raise LevelError(place, f"no body is named {name!r}")
        yield place, exact(speed, place)
        yield place, exact(speed, place) * time


def added_distances(added: BodyRecord, tops: Tops, tick: Fraction, where: str) -> Iterator[tuple[str, Fraction]]:
    """The numbers of a body that is added, and how far it wants to move in a tick, with their places.

    Raises:
        LevelError: if a number or an edge is not as it must be.
    """
    body = body_of(added, tops, where)
    for number in (body.left.location, body.right.location, body.height, body.speed, body.speed * tick):
        yield where, number


def steps(game: AnyGame, asked: list[StepRecord], floats: bool, path: Path) -> Iterator[Played[Any]]:
    """Play the steps one after another, tick by tick.

    Raises:
        FormatError: if a step takes more rules than any is allowed to, or a body can not come or go.
    """
    for number, step in enumerate(asked):
        try:
            yield from ticks(game, step, floats)
            yield from comings(game, step, floats)
        except LevelError as error:
            place = error.place.removeprefix(f"$.bodies[{len(game.level.bodies)}]").removeprefix("$")
            kind = "remove" if step.add is None else "add"
            raise FormatError(one_line(f"{path}: $.steps[{number}].{kind}{place}: {error.problem}")) from None
        except (Endless, Unwieldy) as error:
            raise FormatError(f"{path}: $.steps[{number}]: {error}") from None


def ticks(game: AnyGame, step: StepRecord, floats: bool) -> Iterator[Played[Any]]:
    """Play one step, tick by tick."""
    if step.request is not None:
        distance = exact(step.request.distance, "$")
        yield played(game, step.request, [game.request(step.request.body, float(distance) if floats else distance)])
    if step.tick is not None:
        tick = TickRecord(step.tick.key)
        for count in range(1, step.tick.times + 1):
            moves = game.tick(tick.direction)
            check_length(game, count)
            yield played(game, tick, moves)
    if step.drive is not None and isinstance(game, StepGame):
        kind: Any = float if floats else Fraction
        speeds = {name: kind(exact(speed, "$")) for name, speed in step.drive.speeds.items()}
        yield played(game, step.drive, game.drive(speeds, kind(exact(step.drive.time, "$"))))


def check_length(game: AnyGame, count: int) -> None:
    """Refuse to go on where velocities make exact numbers longer and longer, so that no trace could be read again.

    Raises:
        Unwieldy: if that is so after so many ticks of a step.
    """
    for body in game.world.bodies:
        if body.motion is None or not isinstance(body.motion.velocity, Fraction):
            continue
        try:
            check_sums([("$", (body.left.location, body.right.location, body.motion.velocity))])
        except LevelError as error:
            raise Unwieldy(f"tick {count}: {body.name!r}: {error.problem}; floats have no such limit") from None


def comings(game: AnyGame, step: StepRecord, floats: bool) -> Iterator[Played[Any]]:
    """Let a body come or go.

    Raises:
        LevelError: if it can not; of one that comes the place is that of the last body.
    """
    if step.add is not None and isinstance(game, StepGame):
        body: Body[Any] = body_of(step.add, tops_in(game.level), "$")
        yield played(game, step.add, game.add(body_with_numbers(body, float) if floats else body))
    if step.remove is not None and isinstance(game, StepGame):
        yield played(game, step.remove, game.remove(step.remove.body))


def played(game: AnyGame, asked: Asked, moves: list[Fulfilled[Any]]) -> Played[Any]:
    """What came of a step, now that it has been played."""
    pressed = tuple(game.world.pressed(button) for button in game.level.buttons)
    return Played(asked, tuple(moves), tuple(game.world.bodies), pressed, game.happened)


def play(path: Path, floats: bool = False) -> Playing:
    """Open a scenario file to be played; a level file is a scenario without steps.

    Raises:
        FormatError: one line that names the file and the place, if anything in it is not as it must be.
    """
    scenario, level = read_playable(path)
    try:
        game = set_up(scenario, level, floats)
    except LevelError as error:
        in_level = isinstance(scenario.level, str) and error.place.startswith("$.level")
        place = f"{path.parent / str(scenario.level)}: ${error.place[7:]}" if in_level else f"{path}: {error.place}"
        raise FormatError(one_line(f"{place}: {error.problem}")) from None
    return Playing(scenario, level, game, steps(game, scenario.steps, floats, path))
