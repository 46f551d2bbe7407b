"""A quick look at logs of steps in floats: which lines are beyond doubt, many at once, by the closed form of a step.

A line is beyond doubt if each of these is so by more than all errors of this look together; all others are for the
judge, which so says of every line what it says without this.
- The step has a closed form from the log's own state before it, in which all are between their walls, held, and apart.
- Everybody is then on what it was on, within the tolerance of where the closed form has it, apart and between walls.
- What the line says of moves, supports and the goal is so, and nothing in it is unknown, missing or said otherwise.

The look computes in numbers of 64 bits or more; the tolerance is made of roundings of 53. A place comes about in less
than 500 operations, for as many bodies as are looked at: four for each body of its row and those it stands on, ten for
each storey. Their numbers are below four times the largest of the level. So one rounding of 53 bits is more than all.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Annotated, Any, Literal

import msgspec
import numpy as np
from msgspec import Meta

from properties.conformance.stepping import OfSteps
from reference.batch import Array, Drives, Layout, Standing, furthest, ground_of, is_plain, lay_out, on_ground, standing
from reference.formats.files import Many, Name
from reference.formats.numbers import exact
from reference.formats.scenario import TickRecord
from reference.formats.trace import Count, LineRecord
from reference.recording import Recording, state_after, supports_of
from reference.rounding import UNIT_ROUNDOFF, largest, tolerance
from reference.stepping import of_tick
from reference.storeys import Place, StoreyWorld
from reference.world import LevelError
from spec.body import Level

Extended = np.longdouble
MANTISSA, MOST_BODIES = 63, 24
SMALLEST, LARGEST = 2.0**-200, 2**53
"""Between these, whole numbers of a log are floats, and sums of its numbers have few enough digits."""
NEAR = 0.5
"""Who is nearer to another than this part of the margin is not looked at."""

KeyName = Literal["left", "right", "none"]
KEYS: tuple[KeyName, ...] = ("left", "right", "none")


class Strict(msgspec.Struct, forbid_unknown_fields=True, gc=False):
    """What every object is, with fewer kinds of values than in a file: what is of another kind is for the judge."""


class At(Strict):
    """A border."""

    location: float
    edge: int | None = None
    top: str | None = None


class Spot(Strict):
    """A body after a step."""

    name: str
    left: At
    right: At


class Asked(Strict):
    """A request."""

    body: str
    distance: float | str


class Key(Strict):
    """A tick."""

    key: KeyName
    times: Literal[1] = 1


class Driven(Strict):
    """A drive."""

    speeds: dict[str, float | str]
    time: float | str


class Moved(Strict):
    """A request as it was fulfilled."""

    body: str
    asked: float
    moved: float
    fired: list[tuple[Name, str]] | None = None
    chain: Count | None = None
    work: dict[str, int] | None = None


class Came(Strict):
    """What happened to a body."""

    body: str
    event: str
    rule: str
    time: float | None = None
    velocities: dict[Name, float] | None = None
    other: Name | None = None


class Line(Strict):
    """A line of a log."""

    bodies: Many[Spot]
    step: int | None = None
    request: Asked | None = None
    tick: Key | None = None
    drive: Driven | None = None
    moves: Many[Moved] | None = None
    events: list[Came] | None = None
    supports: dict[str, str] | None = None
    pressed: Annotated[list[bool], Meta(max_length=0)] | None = None
    solved: bool | None = None


LINE = msgspec.json.Decoder(Line)


Wish = tuple[Any, tuple[tuple[int, Any], ...]]
"""What a line asks for: how long, and of each driven body, in order, its number and its speed."""


@dataclass(frozen=True)
class Model:
    """How bodies stand that have certain seats, how wide they are, and who stands on whom."""

    standing: Standing
    width: Array
    supports: dict[str, str]


@dataclass(frozen=True)
class States:
    """Where the bodies are in each line, and their seats: of strings or of tops, -1 if a line says nothing of use."""

    left: Array
    width: Array
    seats: Array


@dataclass
class Look:
    """What is known of a log before its lines are looked at.

    Attributes:
        names: the numbers of bodies by their names.
        codes: the numbers of edges, tops among them, by what stands for them in a border.
        seats: for each number of an edge that of its string; for that of a top the same beyond all strings.
        starts: where ground edges begin; 0 for tops.
        relative: whether a body is driven relative to its support.
        keys: what a tick asks for, by its key.
        margin: the level's.
        largest: the largest number of the level.
        tolerance: the least that a step of the log may be off.
        error: more than this look may be off.
        models: for seats of all bodies how they stand then, if that is known.
    """

    log: Recording
    referee: OfSteps
    names: dict[str, int]
    codes: dict[tuple[int | None, str | None], int]
    seats: Array
    starts: Array
    relative: Array
    keys: dict[KeyName, Wish]
    margin: Any
    largest: Any
    tolerance: Any
    error: Any
    models: dict[bytes, Model | None] = field(default_factory=dict)

    def certain(self, texts: Sequence[bytes], number: int, close: bool) -> Array:
        """For each of some lines whether it is beyond doubt; never so the first, which has a number in the file.

        If `close`, bodies may be nearer to each other than the margin: that they are has been said.
        """
        nearest = self.margin * -NEAR if close else self.error - self.tolerance
        lines = [self.read(text, step) for step, text in enumerate(texts, start=number - 1)]
        states, result = self.states(lines), np.zeros(len(lines), bool)
        same = (states.seats[1:] == states.seats[:-1]).all(axis=1) & (states.seats[1:, 0] >= 0)
        wishes = {step: wish for step in (1 + np.flatnonzero(same)).tolist() if (wish := self.wish(lines[step]))}
        groups: dict[bytes, list[int]] = {}
        for step in wishes:
            groups.setdefault(states.seats[step].tobytes(), []).append(step)
        for seats, steps in groups.items():
            if seats not in self.models:
                self.models[seats] = self.model(texts[steps[0] - 1])
            model = self.models[seats]
            if model is not None:
                far, fits = self.as_it_should(model, np.array(steps), [wishes[step] for step in steps], states, nearest)
                for step, moved, fit in zip(steps, far, fits.tolist(), strict=True):
                    result[step] = fit and self.tells(lines[step], wishes[step], moved, model)
        return result

    def read(self, text: bytes, step: int) -> Line | None:
        """A line, if it has nothing that is not looked at, and its bodies are in the order of the level."""
        try:
            line = LINE.decode(text)
        except (msgspec.DecodeError, UnicodeError, RecursionError):
            return None
        named = [spot.name for spot in line.bodies] == list(self.names)
        return line if named and (line.step is None or line.step == step) else None

    def states(self, lines: Sequence[Line | None]) -> States:
        """Where the bodies are in each line; riders are where their supports are, and so much farther."""
        bodies = len(self.names)
        known = [place for place, line in enumerate(lines) if line is not None]
        sides = [at for line in lines if line for spot in line.bodies for at in (spot.left, spot.right)]
        codes, locations = np.full((len(lines), bodies, 2), -1), np.zeros((len(lines), bodies, 2))
        get = self.codes.get
        codes[known] = np.reshape([get((at.edge, at.top), -1) for at in sides], (-1, bodies, 2))
        locations[known] = np.reshape([at.location for at in sides], (-1, bodies, 2))
        at, seats = self.starts[codes] + locations, self.seats[codes]
        sizes = np.abs(locations)
        sound = (codes >= 0) & (sizes <= self.largest) & ((sizes >= SMALLEST) | (sizes == 0))
        sound &= (seats[..., :1] == seats[..., 1:]) & (at[..., :1] < at[..., 1:])
        seats = np.where(sound.all(axis=(1, 2))[:, None], seats[..., 0], -1)
        return States(at[..., 0], at[..., 1] - at[..., 0], seats)

    def wish(self, line: Line | None) -> Wish | None:
        """What a line asks for, if that is one thing, of known bodies, and not further than the level is large."""
        if line is None or (line.request is not None) + (line.tick is not None) + (line.drive is not None) != 1:
            return None
        if line.tick is not None:
            return self.keys[line.tick.key]
        try:
            time, speeds = asked_of(line)
        except LevelError:
            return None
        if time < 0 or not all(name in self.names for name in speeds):
            return None
        if not all(abs(speed) * time <= self.largest for speed in speeds.values()):
            return None
        return time, tuple((self.names[name], speed) for name, speed in speeds.items())

    def model(self, text: bytes) -> Model | None:
        """How the bodies stand after a line."""
        try:
            line = msgspec.json.decode(text, type=LineRecord)
            world = state_after(self.log, self.log.level, line)
            storeys = self.referee.storeys(world)
        except LevelError:
            return None
        if any(
            is_between(storeys, place, 4 * tolerance(self.log.header.numbers, self.log.level))
            for place in storeys.places
        ):
            return None
        found = standing(storeys, object)
        edges = np.array([extended(edge) for edge in found.edges.ravel()]).reshape(found.edges.shape)
        width = np.array([extended(place.width) for place in storeys.places])
        return Model(Standing(found.kinds, edges), width, supports_of(world.level.bodies, world.level))

    def as_it_should(
        self, model: Model, steps: Array, wishes: Sequence[Wish], states: States, nearest: Any
    ) -> tuple[Array, Array]:
        """How far bodies come in each of some steps in which they stand so, and whether these are beyond doubt."""
        many, bodies = len(steps), len(self.names)
        speeds, times = np.zeros((many, bodies), Extended), np.array([time for time, _ in wishes], Extended)
        relative = np.ones((many, bodies), bool)
        for place, (_, driven) in enumerate(wishes):
            for body, speed in driven:
                speeds[place, body], relative[place, body] = speed, self.relative[body]
        before, after = self.lefts(model, states, steps - 1), self.lefts(model, states, steps)
        width, now = states.width[steps - 1].ravel(), states.width[steps].ravel()
        level, every = np.repeat(np.arange(many), bodies), np.arange(many * bodies)
        margin = np.full(many * bodies, self.margin)
        layout = lay_out([model.standing] * many, every, level * bodies, level, width, margin)
        order = layout.order
        drives = Drives(speeds.ravel()[order], relative.ravel()[order])
        far, fits = furthest(layout, before[order], drives, times, self.error)
        off = np.abs(after[order] - (before[order] + far)) + np.abs(now - width)[order]
        wrong = off > self.tolerance - self.error
        wrong |= np.abs(width - np.tile(model.width, many))[order] > self.tolerance
        wrong |= self.misplaced(layout, before[order], width[order], self.margin * -NEAR)
        wrong |= self.misplaced(layout, after[order], now[order], nearest)
        fits[layout.level[wrong]] = False
        ways = np.zeros_like(far)
        ways[order] = far
        return ways.reshape(many, bodies), fits

    def lefts(self, model: Model, states: States, lines: Array) -> Array:
        """Where the left borders are in some lines in which bodies stand so."""
        left = states.left[lines]
        storey, support = model.standing.kinds[:, 0], model.standing.kinds[:, 3]
        for body in np.argsort(storey).tolist():
            if support[body] != body:
                left[:, body] += left[:, support[body]]
        return left.ravel()

    def misplaced(self, layout: Layout, left: Array, width: Array, nearest: Any) -> Array:
        """Who is beyond a wall, by half of what may be off, or has less room than the least to the one before it."""
        walls = layout.edges[0] - left, left + width - layout.edges[1]
        found: Array = np.maximum(*walls) > self.tolerance / 2 - self.error
        for storey in layout.storeys:
            those = storey.bodies
            at, size = left[those], (width + layout.margin)[those]
            behind, ahead = storey.behind, slice(storey.first, None)
            found[those][ahead] |= at[ahead] - (at[behind] + size[behind]) < nearest
        return found

    def tells(self, line: Line | None, wish: Wish, far: Array, model: Model) -> bool:
        """Whether all else that a line says is so: of moves, supports, events, and a goal that there is none of."""
        assert line is not None
        if line.supports not in (None, model.supports) or line.solved is False:
            return False
        if line.events and not all(event.body in self.names for event in line.events):
            return False
        return line.moves is None or self.moved(line.moves, wish, far)

    def moved(self, moves: Sequence[Moved], wish: Wish, far: Array) -> bool:
        """Whether those who were asked to move have moved as told."""
        time, driven = wish
        most = self.tolerance - self.error
        return [self.names.get(move.body) for move in moves] == [body for body, _ in driven] and all(
            abs(move.asked - speed * time) <= most and abs(move.moved - far[body]) <= most
            for move, (body, speed) in zip(moves, driven, strict=True)
        )


def asked_of(line: Line) -> tuple[Any, dict[str, Any]]:
    """How long whom to drive how fast a request or a drive is.

    Raises:
        LevelError: if a number is none.
    """
    if line.request is not None:
        distance = number(line.request.distance)
        return abs(distance), {line.request.body: -1 if distance < 0 else 1}
    assert line.drive is not None
    return number(line.drive.time), {name: number(speed) for name, speed in line.drive.speeds.items()}


def number(value: float | str) -> Any:
    """A number of a line, with at least 64 bits."""
    return Extended(value) if isinstance(value, float) else extended(exact(value, "$"))


def is_between(world: StoreyWorld[Fraction], place: Place[Fraction], by: Fraction) -> bool:
    """Whether a body so nearly fits into a gap of its ground that it may as well fit."""
    if not on_ground(place):
        return False
    one, other = (ground_of(world, replace(place, width=place.width + more)) for more in (by, -by))
    return one != other


def extended(value: Fraction) -> Any:
    """A number with at least 64 bits."""
    return Extended(value.numerator) / Extended(value.denominator)


def look_of(log: Recording, referee: OfSteps) -> Look | None:
    """What to look at a log with, or None if none of its lines can be beyond doubt."""
    level, header, plan = log.level, log.header, referee.plan
    if np.finfo(Extended).nmant < MANTISSA or header.numbers == "exact" or header.grid is not None or level.buttons:
        return None
    if len(level.bodies) > MOST_BODIES or any(body.motion is not None for body in level.bodies):
        return None
    off, most = tolerance(header.numbers, level), largest(level)
    error = UNIT_ROUNDOFF["float64"] * most
    fast = any(body.speed * level.tick > most for body in level.bodies)
    if fast or most >= LARGEST or off < 8 * error or not is_plain(plan.start()):
        return None
    statics = len(level.graph.edges)
    ground = {edge: string for string, one in enumerate(plan.strings) for edge in one.row.edges}
    codes: dict[tuple[int | None, str | None], int] = {(edge, None): edge for edge in ground}
    codes |= {(None, body.name): statics + handle for handle, body in enumerate(level.bodies)}
    seats = [ground.get(edge, -1) for edge in range(statics)] + [
        len(ground) + body for body in range(len(level.bodies))
    ]
    starts = [extended(level.graph.vertices[edge.left].x) for edge in level.graph.edges]
    return Look(
        log,
        referee,
        {body.name: handle for handle, body in enumerate(level.bodies)},
        codes,
        np.array(seats),
        np.array([*starts, *(Extended(0) for _ in level.bodies)]),
        np.array([not body.speed for body in level.bodies]),
        {key: key_wish(level, TickRecord(key)) for key in KEYS},
        *(extended(one) for one in (level.margin, most, off, error)),
    )


def key_wish(level: Level[Fraction], tick: TickRecord) -> Wish:
    """What a tick asks for."""
    drives, time = of_tick(level, tick.direction)
    return extended(time), tuple((body, extended(drive.speed)) for body, drive in drives.items())
