"""Random rows: open strings and rings, edges of any length, bodies in contact, borders exactly on boundaries."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from hypothesis import strategies as st

from properties.worlds.rows import located
from spec.body import Body, Level
from spec.graph import Direction, Graph, Vertex, polyline

GRIDS = (8, 10, 12)


@dataclass(frozen=True)
class Trial:
    """A level, a request of one of its bodies (by its place in the row) to move in a direction, and ticks after it.

    `keys` are the directions of the keys that are held, one for each tick.
    """

    level: Level[Fraction]
    body: int
    direction: Direction
    asked: Fraction
    keys: tuple[Direction, ...] = ()


def multiples(grid: int, most: int) -> st.SearchStrategy[Fraction]:
    """Multiples of one part of a grid from 0, small ones first. On a grid of tenths floats are not exact."""
    return st.integers(0, most * grid).map(lambda n: Fraction(n, grid))


@st.composite
def spaces(draw: st.DrawFn, grid: int, margin: Fraction, count: int) -> list[Fraction]:
    """Room between neighbours beyond the margin: none, a little or much; at times none between any."""
    if draw(st.sampled_from((False, False, False, True))):
        return [margin] * count
    room = st.one_of(st.just(Fraction(0)), multiples(grid, 1), multiples(grid, 4))
    return [margin + draw(room) for _ in range(count)]


@st.composite
def lengths_of_edges(
    draw: st.DrawFn, grid: int, total: Fraction, margin: Fraction, borders: list[Fraction]
) -> list[Fraction]:
    """Cut a string into edges no shorter than the margin, some of them exactly where a border stands."""
    cuts = draw(st.lists(st.one_of(st.sampled_from([*borders, total]), multiples(grid, int(total) + 1)), max_size=5))
    kept, last = [], Fraction(0)
    for cut in sorted(set(cuts)):
        if cut - last >= margin and total - cut >= margin:
            kept.append(cut - last)
            last = cut
    return [*kept, total - last]


def ground(lengths: list[Fraction], closed: bool) -> Graph[Fraction]:
    """Level ground of edges end to end."""
    along, vertices = Fraction(0), [Vertex(Fraction(0), Fraction(0))]
    for length in lengths:
        along += length
        vertices.append(Vertex(along, Fraction(0)))
    return polyline(vertices[:-1], along) if closed else polyline(vertices)


@st.composite
def levels(draw: st.DrawFn, most_bodies: int = 6) -> Level[Fraction]:
    """A valid level: a string of edges no shorter than the margin, with its bodies in the level's order."""
    grid, count, closed = draw(st.sampled_from(GRIDS)), draw(st.integers(1, most_bodies)), draw(st.booleans())
    margin = Fraction(draw(st.sampled_from((1, 2, 4))), grid)
    widths = [Fraction(1, grid) + draw(multiples(grid, 2)) for _ in range(count)]
    start = draw(st.one_of(st.just(Fraction(0)), multiples(grid, 3)))
    gaps = draw(spaces(grid, margin, count))
    lefts = [start + sum(widths[:i]) + sum(gaps[:i]) for i in range(count)]
    held = [(left, left + width) for left, width in zip(lefts, widths, strict=True)]
    end = held[-1][1]
    beyond = draw(st.one_of(st.just(Fraction(0)), multiples(grid, 6)))
    total = end - start + gaps[-1] if closed else max(end + beyond, margin)
    borders = [border for pair in held for border in pair if border < total]
    lengths = draw(lengths_of_edges(grid, total, margin, borders))
    round_ = [(left % total, right % total) for left, right in held] if closed else held
    speeds = [Fraction(draw(st.sampled_from((0, 0, 5, 50)))) for _ in held]
    bodies = [
        Body(chr(65 + i), located(lengths, left, closed), located(lengths, right, closed), speeds[i], Fraction(1))
        for i, (left, right) in enumerate(round_)
    ]
    return Level(ground(lengths, closed), margin, Fraction(1, 50), tuple(draw(st.permutations(bodies))))


@st.composite
def trials(draw: st.DrawFn) -> Trial:
    """A level and a request, often by exactly the free room, to exactly a wall or to exactly a vertex.

    On a ring the distance is at most once round, and half round for a body alone on it.
    """
    level = draw(levels())
    body = draw(st.integers(0, len(level.bodies) - 1))
    direction = draw(st.sampled_from(Direction))
    lengths = [edge.length for edge in level.graph.edges]
    sizes = [Fraction(0), level.margin, *lengths, *(edge.length / 2 for edge in level.graph.edges)]
    grid = draw(st.sampled_from(GRIDS))
    asked = draw(st.one_of(multiples(grid, 6), st.sampled_from(sizes), multiples(grid, 24)))
    total = sum(lengths, Fraction(0))
    if level.graph.circumference is not None:
        asked = min(asked, total / 2 if len(level.bodies) == 1 else total)
    keys = draw(st.lists(st.sampled_from(Direction), max_size=4))
    return Trial(level, body, direction, asked, tuple(keys))
