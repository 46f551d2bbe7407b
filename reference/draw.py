"""Drawings of recordings as SVG: a picture of the start and of each step, a few to a page, in one style."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from itertools import chain, islice
from xml.etree.ElementTree import Element, tostring

from reference.drawing import ink, scene
from reference.drawing.canvas import SIDE, Frame, Lens
from reference.drawing.ink import wrapped, write
from reference.drawing.legend import draw_legend
from reference.drawing.panel import draw
from reference.drawing.scene import Window
from reference.formats.files import one_line
from reference.formats.numbers import exact
from reference.formats.trace import LineRecord, MoveRecord
from reference.recording import Recording, following, state_after
from reference.world import LevelError, World
from spec.profiles import Profile

WIDTH = 900.0
EDGE = 20.0
GUTTER = 16.0
LARGEST_UNIT, READABLE_UNIT = 58, 34
HIGHEST = 330
MOST_UNITS = 60
MOST_COLUMNS = 3


class BadLine(ValueError):
    """A line of a trace that cannot be drawn; the message begins with its number in the file."""


def frames(recording: Recording) -> Iterator[Frame]:
    """The start of a recording and each of its steps, one after another.

    Raises:
        BadLine: if a line of a trace has what cannot be drawn.
        FormatError: if a line cannot be read.
    """
    level = recording.level
    world = World(level)
    jumps = isinstance(recording.profile, Profile)
    yield Frame(0, world, pressed(world, None), jumps=jumps)
    for step, line in enumerate(recording.lines, start=1):
        before = world
        try:
            level = following(level, line)
            world = state_after(recording, level, line)
        except LevelError as error:
            raise BadLine(one_line(f"{step + 1}: {error}")) from None
        yield Frame(step, world, pressed(world, line), before, line, jumps)


def pressed(world: World[Fraction], line: LineRecord | None) -> tuple[bool, ...]:
    """Which buttons are pressed: as a line says, or else as the bodies stand."""
    buttons = world.level.buttons
    if line is not None and line.pressed is not None and len(line.pressed) == len(buttons):
        return tuple(line.pressed)
    return tuple(world.pressed(button) for button in buttons)


def chosen(recording: Recording, first: int, last: int | None) -> Iterator[Frame]:
    """The frames from a first to a last step; 0 is the start."""
    return islice(frames(recording), first, None if last is None else last + 1)


def pages(recording: Recording, to_a_page: int, first: int = 0, last: int | None = None) -> Iterator[str]:
    """A recording as SVG, page by page; no more of it than a page is held.

    Raises:
        BadLine: if a line of a trace has what cannot be drawn.
        FormatError: if a line cannot be read.
    """
    seen = chosen(recording, first, last)
    while some := list(islice(seen, to_a_page)):
        yield sheet(recording, some, headed=True)


def strip(recording: Recording, first: int, last: int | None = None) -> str:
    """Some steps as one SVG without a heading, for use in another document; 0 is the start.

    Raises:
        BadLine: if a line of a trace has what cannot be drawn.
        FormatError: if a line cannot be read.
    """
    return sheet(recording, list(chosen(recording, first, last)), headed=False)


@dataclass(frozen=True)
class Layout:
    """How the panels of a page are arranged: through which lens, and in how many columns."""

    lens: Lens
    columns: int

    @property
    def cell(self) -> float:
        """How wide a column is."""
        return (WIDTH - 2 * EDGE - GUTTER * (self.columns - 1)) / self.columns


def layout_of(seen: list[Frame]) -> Layout:
    """The most columns in which bodies are still of a readable size, and one scale for all panels."""
    worlds = [*(frame.world for frame in seen), *(frame.before for frame in seen[:1] if frame.before is not None)]
    asked = {name for frame in seen for name in frame.asked()}
    window = scene.window_of(worlds, asked, MOST_UNITS)
    unit = scene.unit_of(worlds[0])
    scales = {columns: scale_of(window, unit, columns) for columns in range(1, min(len(seen), MOST_COLUMNS) + 1)}
    enough = min(scales[1], READABLE_UNIT / unit)
    columns = max(columns for columns, scale in scales.items() if scale >= enough)
    return Layout(Lens(window, scales[columns]), columns)


def scale_of(window: Window, unit: Fraction, columns: int) -> Fraction:
    """How many pixels a unit of length can have in so many columns."""
    room = (WIDTH - 2 * EDGE - GUTTER * (columns - 1)) / columns - 2 * SIDE
    wide, high = window.right - window.left, window.top - window.bottom
    scales = [LARGEST_UNIT / unit]
    scales += [Fraction(int(room)) / wide] if wide else []
    scales += [Fraction(HIGHEST) / high] if high else []
    return min(scales)


def sheet(recording: Recording, seen: list[Frame], headed: bool) -> str:
    """A page of panels, with a legend."""
    layout = layout_of(seen)
    scratch = Element("g")
    y = heading(scratch, recording, seen, layout.lens.window) if headed else EDGE
    shown: set[str] = set()
    for start in range(0, len(seen), layout.columns):
        y = draw_row(scratch, seen[start : start + layout.columns], layout, y, shown)
    y = draw_legend(scratch, shown, EDGE, y + 6, WIDTH - EDGE) + EDGE / 2
    title = f"{recording.header.name}, {extent_of(seen)}"
    page = ink.paper(WIDTH, y, title)
    page.extend(scratch)
    return tostring(page, encoding="unicode") + "\n"


def extent_of(seen: list[Frame]) -> str:
    """Which steps a page shows."""
    first, last = seen[0].step, seen[-1].step
    if first == last:
        return f"step {first}" if first else "the start"
    return f"steps {first} to {last}" if first else f"the start and {'step 1' if last == 1 else f'steps 1 to {last}'}"


def heading(page: Element, recording: Recording, seen: list[Frame], window: Window) -> float:
    """The name of a recording, its note where it starts, and what part of the level is shown."""
    y = EDGE + 14
    header, width = recording.header, WIDTH - 2 * EDGE
    for text in wrapped(header.name, width, 17):
        write(page, text, EDGE, y, "name")
        y += 20
    notes = [header.note or header.level.note] if not seen[0].step else [extent_of(seen).capitalize() + "."]
    if window.cropped:
        parts = (window.left, window.right, *window.whole)
        notes.append("Shown: x from {} to {}; the level is from {} to {}.".format(*map(ink.number, parts)))
    for text in chain.from_iterable(wrapped(note, width, 12) for note in notes):
        write(page, text, EDGE, y, "note")
        y += 16
    return y + 8


def draw_row(page: Element, seen: list[Frame], layout: Layout, y: float, shown: set[str]) -> float:
    """Some panels side by side, each under its caption; return where they end."""
    captions = [list(caption(frame, layout.cell)) for frame in seen]
    high = max(sum(18 if kind == "caption" else 15 for kind, _ in lines) for lines in captions)
    for column, (frame, lines) in enumerate(zip(seen, captions, strict=True)):
        x, down = EDGE + column * (layout.cell + GUTTER), y + 12
        for kind, text in lines:
            write(page, text, x, down, kind)
            down += 18 if kind == "caption" else 15
        shown |= draw(page, frame, layout.lens, x, y + high)
    return y + high + layout.lens.height + 18


def caption(frame: Frame, width: float) -> Iterator[tuple[str, str]]:
    """What was asked and moved, and by which rules, in lines that fit."""
    for text in wrapped(what(frame), width, 14):
        yield "caption", text
    for sentence in happened(frame):
        for text in wrapped(sentence, width, 12):
            yield "what", text


def what(frame: Frame) -> str:
    """What was asked and moved in a step."""
    line = frame.line
    if line is None:
        return "Start"
    if line.add is not None:
        return f"{frame.step}. {ink.shortened(line.add.name, 24)} comes"
    if line.remove is not None:
        return f"{frame.step}. {ink.shortened(line.remove.body, 24)} goes"
    moves = "; ".join(moved(move) for move in line.moves or ())
    if line.tick is not None:
        return f"{frame.step}. Key {line.tick.key}: {moves}" if moves else f"{frame.step}. Key {line.tick.key}"
    if line.drive is not None:
        return f"{frame.step}. {moves or 'Nobody is driven'}"
    assert line.request is not None
    asked = f"{ink.shortened(line.request.body, 24)} asked {ink.number(exact(line.request.distance, '$'))}"
    return f"{frame.step}. {moves or asked}"


def moved(move: MoveRecord) -> str:
    """One request as it was fulfilled."""
    asked, went = (ink.number(exact(value, "$")) for value in (move.asked, move.moved))
    return f"{ink.shortened(move.body, 24)} asked {asked}, moved {went}"


def happened(frame: Frame) -> Iterator[str]:
    """The rules that decided a step, each with the bodies for which it did."""
    if frame.line is None:
        return
    decisive = [(event.rule, event.body) for event in frame.line.events or ()] or list(walked(frame.line))
    bodies: dict[str, dict[str, None]] = {}
    for rule, body in decisive:
        bodies.setdefault(rule, {})[body] = None
    if bodies:
        yield "; ".join(f"{ink.shortened(rule, 40)}: {listed(list(names))}" for rule, names in bodies.items())


def walked(line: LineRecord) -> Iterator[tuple[str, str]]:
    """The last rule by which each body walked."""
    last = {body: rule for move in line.moves or () for body, rule in move.fired or () if rule.startswith("walk/")}
    return ((rule, body) for body, rule in last.items())


def listed(names: list[str]) -> str:
    """Names, the last of many left out."""
    few = [ink.shortened(name, 24) for name in names[:4]]
    return ", ".join(few) + (f" and {len(names) - 4} more" if len(names) > 4 else "")
