"""A drawing of a world for the terminal: a side view in plain ASCII, a line of text for each row."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from reference.drawing import scene
from reference.drawing.ink import number
from reference.drawing.scene import Outline, Segment, Window
from reference.world import World
from spec.graph import Direction, EdgeType

COLUMNS, ROWS = 76, 18
WIDEST_BODY = 8


@dataclass
class Grid:
    """Rows of characters, and where in the plane they are; a row is twice as high as a column is wide."""

    window: Window
    scale: Fraction
    cells: dict[tuple[int, int], str] = field(default_factory=dict)

    def column(self, x: Fraction) -> int:
        """The column that begins nearest to a place."""
        return max(-COLUMNS, min(2 * COLUMNS, round((x - self.window.left) * self.scale)))

    def row(self, y: Fraction) -> int:
        """The row whose base line is nearest to a height; rows are counted upward."""
        return max(-1, min(2 * ROWS, round((y - self.window.bottom) * self.scale / 2)))

    def put(self, column: int, row: int, text: str) -> None:
        """Write from a column on, as far as it is on the paper: a column more on either side, for walls."""
        for i, char in enumerate(text):
            if -1 <= column + i <= COLUMNS and -1 <= row <= ROWS + 1:
                self.cells[column + i, row] = char

    def lines(self) -> Iterator[str]:
        """The rows from above."""
        rows = [row for _, row in self.cells] or [0]
        for row in range(max(rows), min(rows) - 1, -1):
            yield "".join(self.cells.get((column, row), " ") for column in range(-1, COLUMNS + 1)).rstrip()


def sketch(world: World[Any], asked: Iterable[str] = ()) -> Iterator[str]:
    """The world as seen from the side, around those who were asked to move if not all of it can be shown."""
    window = scene.window_of([world], set(asked), COLUMNS // 2)
    grid = Grid(window, scale_of(window, scene.unit_of(world)))
    reach = window.left, window.right
    draw_ground(grid, world, reach)
    for shape in sorted(scene.outlines(world), key=lambda shape: (shape.low, shape.left)):
        for by in scene.images(world, (shape.left, shape.right), reach):
            draw_body(grid, shape.shifted(by), world)
    yield from grid.lines()
    if window.cropped:
        (left, right), (start, end) = reach, window.whole
        yield f"(x from {number(left)} to {number(right)}; the level is from {number(start)} to {number(end)})"


def draw_ground(grid: Grid, world: World[Any], reach: scene.Range) -> None:
    """Edges, walls, and buttons as `o`."""
    for edge in scene.segments(world):
        for by in scene.images(world, (edge.start[0], edge.end[0]), reach):
            draw_edge(grid, edge.shifted(by).clipped(*reach))
    for (x, y), direction in scene.walls(world):
        for by in scene.images(world, (x, x), reach):
            draw_wall(grid, grid.column(x + by), grid.row(y), direction)
    for x, y in (scene.place_of(world, button) for button in world.level.buttons):
        for by in scene.images(world, (x, x), reach):
            grid.put(grid.column(x + by), grid.row(y), "o")


def scale_of(window: Window, unit: Fraction) -> Fraction:
    """How many columns a unit of length has."""
    wide, high = window.right - window.left, window.top - window.bottom
    scales = [WIDEST_BODY / unit]
    scales += [COLUMNS / wide] if wide else []
    scales += [2 * ROWS / high] if high else []
    return min(scales)


def draw_edge(grid: Grid, edge: Segment) -> None:
    """Level ground as `_`, slopes as `/` and `\\`, steep edges as `|`, fall edges as `:`."""
    left, right = grid.column(edge.start[0]), grid.column(edge.end[0])
    low, high = sorted((grid.row(edge.start[1]), grid.row(edge.end[1])))
    if edge.type is EdgeType.FALL or right - left < high - low:
        sign = ":" if edge.type is EdgeType.FALL else "|"
        for row in range(low, high):
            part = Fraction(2 * (row - low) + 1, 2 * (high - low))
            rising = edge.end[1] > edge.start[1]
            grid.put(left + int((right - left) * (part if rising else 1 - part)), row, sign)
        return
    if edge.thickness is not None and (under := grid.row(min(edge.start[1], edge.end[1]) - edge.thickness)) < low:
        grid.put(left, under - 1, '"' * (right - left))
    for column in range(left, right):
        grid.put(column, *slope(grid, edge, column, right - left, column - left))


def slope(grid: Grid, edge: Segment, column: int, count: int, index: int) -> tuple[int, str]:
    """The row and the sign of a ground edge in one of its columns."""
    rise = edge.end[1] - edge.start[1]
    before, after = (grid.row(edge.start[1] + rise * Fraction(i, count)) for i in (index, index + 1))
    if before == after:
        return before, "_"
    return min(before, after), "/" if after > before else "\\"


def draw_wall(grid: Grid, column: int, row: int, direction: Direction) -> None:
    """A wall, two rows high."""
    for up in (0, 1):
        grid.put(column if direction is Direction.RIGHT else column - 1, row + up, "|")


def draw_body(grid: Grid, shape: Outline, world: World[Any]) -> None:
    """A body: a box with as much of its name as fits, its roof of `-` for a box and of `^` for a character."""
    held, left = world.bodies[shape.body], grid.column(shape.left)
    width = max(1, min(2 * COLUMNS, int((shape.right - shape.left) * grid.scale)))
    middle = (shape.bottom[0][1] + shape.bottom[-1][1]) / 2
    low, high = grid.row(middle), grid.row(middle + shape.height)
    name = "".join(char if " " < char <= "~" else "?" for char in held.name.replace(" ", "") or "?")
    boxed = width >= 3
    for row in range(low, max(high, low + 1)):
        grid.put(left, row, f"|{' ' * (width - 2)}|" if boxed else fitted(name, width).ljust(width, "#"))
    if boxed:
        grid.put(left + 1, low + max(0, (high - low - 1) // 2), fitted(name, width - 2).center(width - 2))
        if high - low > 1:
            grid.put(left, high - 1, f".{('^' if held.speed else '-') * (width - 2)}.")


def fitted(name: str, room: int) -> str:
    """A name or its beginning; the number at its end is kept."""
    digits = name[len(name.rstrip("0123456789")) :][: room - 1]
    return name if len(name) <= room else name[: room - len(digits)] + digits
