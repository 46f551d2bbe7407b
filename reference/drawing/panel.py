"""One picture of one moment."""

from __future__ import annotations

from typing import Any
from xml.etree.ElementTree import Element

from reference.drawing import scene
from reference.drawing.bodies import (
    draw_body,
    draw_ghosts,
    draw_margins,
    draw_name,
    draw_overlaps,
    draw_support,
)
from reference.drawing.canvas import Canvas, Frame, Lens, bounds
from reference.drawing.gaps import draw_gap, gaps_seen, number_gap
from reference.drawing.ink import element
from reference.drawing.scene import Outline
from reference.drawing.terrain import draw_buttons, draw_edge_numbers, draw_ground, draw_jumps, draw_seam
from reference.world import World


def draw(parent: Element, frame: Frame, lens: Lens, x: float, y: float) -> set[str]:
    """Draw a moment at a place of a sheet; return the kinds of things that there are in it."""
    canvas = Canvas(view(parent, frame.world, lens, x, y), lens, frame)
    shapes = bodies_seen(canvas)
    for shape in shapes:
        draw_margins(canvas, shape)
    draw_ground(canvas)
    draw_ghosts(canvas)
    for shape in shapes:
        draw_body(canvas, shape)
    draw_overlaps(canvas, shapes)
    draw_between(canvas, shapes)
    draw_texts(canvas, shapes)
    draw_seam(parent, canvas, x, y)
    return canvas.shown


def draw_texts(canvas: Canvas, shapes: list[Outline]) -> None:
    """Names first, then what room there is for numbers."""
    canvas.taken.extend(bounds(canvas.lens, shape) for shape in shapes)
    for shape in shapes:
        draw_name(canvas, shape)
    for spots, gap in gaps_seen(canvas):
        number_gap(canvas, spots, gap)
    draw_edge_numbers(canvas)


def view(parent: Element, world: World[Any], lens: Lens, x: float, y: float) -> Element:
    """A part of a sheet that nothing is drawn beyond; a cylinder is cut at its seam."""
    side = lens.rim(world)
    width = lens.width - 2 * side
    box = f"{side:g} 0 {width:.1f} {lens.height:.1f}"
    return element(parent, "svg", x=x + side, y=y, width=width, height=lens.height, viewBox=box)


def bodies_seen(canvas: Canvas) -> list[Outline]:
    """The bodies, as often as they are seen."""
    outlines = scene.outlines(canvas.world)
    return [shape.shifted(by) for shape in outlines for by in canvas.images(shape.left, shape.right)]


def draw_between(canvas: Canvas, shapes: list[Outline]) -> None:
    """What is between bodies: gaps, supports, jump edges; and buttons."""
    if canvas.frame.jumps and canvas.lens.size(scene.unit_of(canvas.world)) >= 8:
        draw_jumps(canvas)
    for spots, gap in gaps_seen(canvas):
        draw_gap(canvas, spots, gap)
    for shape in shapes:
        draw_support(canvas, shape)
    draw_buttons(canvas)
