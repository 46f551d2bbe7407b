"""Random levels of storeys, as graphs: quick to draw, and the same for the same seed.

Ground is level, at 0 to 2 body heights; some levels are rings, some have a platform. Places and widths are eighths.
"""

from __future__ import annotations

from fractions import Fraction
from random import Random

from properties.worlds.scenes import Platform, Shape, profile_of_heights
from reference.plan import check_plan, edge_position, plan_of
from reference.world import LevelError, world_of
from spec.body import Body, EdgePosition, Level
from spec.graph import Direction, Graph, Vertex, polyline

GRID = 8
ONE = Fraction(1)
Border = EdgePosition[Fraction]
WIDTHS = (ONE, ONE, Fraction(3, 4), 2 * ONE)
MARGINS = (Fraction(1, 8), Fraction(1, 4), Fraction(1, 2))
SPEEDS = (Fraction(0), Fraction(25), Fraction(25), Fraction(50))
GAPS = (Fraction(0), Fraction(0), Fraction(1, 8), Fraction(1, 2), ONE, 3 * ONE)


def any_level(random: Random) -> Level[Fraction]:
    """A level of storeys with one to five bodies, that both profiles take."""
    while True:
        graph, margin = any_graph(random), random.choice(MARGINS)
        bodies = any_bodies(random, graph, margin)
        level = Level(graph, margin, Fraction(1, 50), tuple(bodies))
        try:
            world_of(level)
            check_plan(level)
        except LevelError:
            continue
        return level


def any_graph(random: Random) -> Graph[Fraction]:
    """Ground between walls, round a ring, or with a platform over it."""
    heights = [random.randrange(3) for _ in range(random.randint(1, 5))]
    lengths = [Fraction(random.choice((1, 4, 8, 10, 16, 24, 32)), GRID) for _ in heights]
    kind = random.random()
    if kind < 0.2:
        return ring(heights, lengths)
    platform = Platform(2 * ONE, ONE) if kind < 0.35 else None
    if platform is not None:
        heights, lengths = [0, 0, 0, *heights], [*(Fraction(random.randint(8, 32), GRID) for _ in range(3)), *lengths]
    return profile_of_heights(Shape(tuple(Fraction(height) for height in heights), (), platform), lengths)


def ring(heights: list[int], lengths: list[Fraction]) -> Graph[Fraction]:
    """Ground round a ring, with its seam in the middle of the first height."""
    vertices: list[Vertex[Fraction]] = []
    along = Fraction(0)
    for height, length in zip([*heights, heights[0]], [*lengths, ONE], strict=True):
        for x in (along, along + length):
            if not vertices or vertices[-1] != Vertex(x, Fraction(height)):
                vertices.append(Vertex(x, Fraction(height)))
        along += length
    return polyline(vertices, along + 1)


def any_bodies(random: Random, graph: Graph[Fraction], margin: Fraction) -> list[Body[Fraction]]:
    """Bodies on the ground from left to right, and on tops; whether they are clear of all else is to be seen."""
    found: list[Body[Fraction]] = []
    empty = Body("", EdgePosition(0, Fraction(0)), EdgePosition(0, ONE), Fraction(0), ONE)
    for string in plan_of(Level(graph, margin, ONE, (empty,))).strings:
        along = random.choice(GAPS)
        while random.random() < 0.7 and len(found) < 4:
            width = random.choice(WIDTHS)
            if along + width > string.row.length:
                break
            left = edge_position(string.row, along, Direction.LEFT)
            found.append(any_body(random, left, edge_position(string.row, along + width, Direction.RIGHT), len(found)))
            along += width + margin + random.choice(GAPS)
    random.shuffle(found)
    while found and random.random() < 0.5 and len(found) < 5:
        top, start = len(graph.edges) + random.randrange(len(found)), random.choice(GAPS) - ONE / 4
        end = start + random.choice(WIDTHS)
        found.append(any_body(random, EdgePosition(top, start), EdgePosition(top, end), len(found)))
    return found


def any_body(random: Random, left: Border, right: Border, number: int) -> Body[Fraction]:
    """A body at a place; most may push."""
    return Body(chr(65 + number), left, right, random.choice(SPEEDS), ONE, random.random() < 0.85)
