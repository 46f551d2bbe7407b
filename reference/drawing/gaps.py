"""Gaps between neighbours in a panel: dimension lines and their numbers."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise

from reference.drawing import scene
from reference.drawing.canvas import HEAD, Canvas, Spot
from reference.drawing.ink import head, line, number, text_width


def gaps_seen(canvas: Canvas) -> Iterator[tuple[list[Spot], Fraction]]:
    """The gaps between neighbours that are large enough to be seen, each with the line along it."""
    world = canvas.world
    for left, right in world.neighbours():
        near, far = world.bodies[left], world.bodies[right]
        gap = Fraction(world.clear(left, right))
        if canvas.lens.size(gap) >= 5:
            points = scene.way(world, near.right, far.left)
            lift = max(Fraction(min(near.height, far.height)) / 4, 6 / canvas.lens.scale)
            for by in canvas.images(points[0][0], points[-1][0]):
                shown = scene.within([(x + by, y + lift) for x, y in points], *canvas.lens.reach)
                if len(shown) > 1:
                    yield [canvas.lens.spot(point) for point in shown], gap


def in_contact(canvas: Canvas, gap: Fraction) -> bool:
    """Whether a gap is the margin, but for what floats round."""
    margin = Fraction(canvas.world.margin)
    return abs(gap - margin) * 10**9 <= margin


def draw_gap(canvas: Canvas, spots: list[Spot], gap: Fraction) -> None:
    """A bar between bodies in contact, else a dimension line along the ground."""
    kind = "contact" if in_contact(canvas, gap) else "gap"
    canvas.shown.add(kind)
    line(canvas.group, kind, *spots)
    if kind == "gap" and canvas.lens.size(gap) >= 16:
        head(canvas.group, spots[0], (spots[0][0] - spots[1][0], spots[0][1] - spots[1][1]), 5)
        head(canvas.group, spots[-1], (spots[-1][0] - spots[-2][0], spots[-1][1] - spots[-2][1]), 5)


def number_gap(canvas: Canvas, spots: list[Spot], gap: Fraction) -> None:
    """How long a gap is, on its line or above it; that of bodies in contact is known."""
    if in_contact(canvas, gap):
        return
    x, y = halfway(spots)
    on_it = canvas.lens.size(gap) >= text_width(number(gap), 10) + 24
    for raised in (3.5,) if on_it else (-4, y_above(canvas, x) - y):
        if canvas.label(number(gap), x, y + raised, "number halo", 10):
            return


def y_above(canvas: Canvas, x: float) -> float:
    """Where there is room for a number above the bodies near a place."""
    return min((rect[1] for rect in canvas.taken if rect[0] < x + 14 and rect[2] > x - 14), default=HEAD) - 4


def halfway(spots: list[Spot]) -> Spot:
    """The middle of a path."""
    lengths = [((b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2) ** 0.5 for a, b in pairwise(spots)]
    rest = sum(lengths) / 2
    for (a, b), length in zip(pairwise(spots), lengths, strict=True):
        if rest <= length and length:
            part = rest / length
            return a[0] + (b[0] - a[0]) * part, a[1] + (b[1] - a[1]) * part
        rest -= length
    return spots[0]
