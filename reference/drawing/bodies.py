"""Bodies in a panel: outlines, borders, margins, supports, names, and where they are in one another."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Any
from xml.etree.ElementTree import Element

from reference.drawing import scene
from reference.drawing.canvas import FAR, Canvas, Rect, Spot, bounds, corners, overlap, top_at, visible
from reference.drawing.ink import element, head, line, number, path, shortened, text_width, write
from reference.drawing.scene import Outline
from reference.drawing.terrain import edges_seen
from reference.formats.files import one_line
from reference.world import World
from spec.graph import Direction, EdgeType
from spec.plane import Box


def draw_ghosts(canvas: Canvas) -> None:
    """Where bodies that have moved, or gone, were before."""
    before = canvas.frame.before
    if before is None:
        return
    now = {canvas.world.bodies[shape.body].name: shape.bottom for shape in scene.outlines(canvas.world)}
    for old in scene.outlines(before):
        if now.get(before.bodies[old.body].name) != old.bottom:
            for by in canvas.images(old.left, old.right):
                line(canvas.group, "ghost", *corners(canvas.lens, old.shifted(by)), close=True)
                canvas.shown.add("ghost")


def draw_margins(canvas: Canvas, shape: Outline) -> None:
    """The collision margin, on both sides of a body, up to a wall."""
    for side, border in ((Direction.LEFT, shape.bottom[0]), (Direction.RIGHT, shape.bottom[-1])):
        margin = margin_beside(canvas.world, shape.body, side)
        if canvas.lens.size(margin) >= 3:
            across, up = slope_at(canvas.world, canvas.world.bodies[shape.body].border(side).edge)
            far = border[0] + across * margin * side, border[1] + up * margin * side
            high, far_high = (border[0], border[1] + shape.height), (far[0], far[1] + shape.height)
            line(canvas.group, "margin", *(canvas.lens.spot(point) for point in (border, far, far_high, high)))
            canvas.shown.add("margin")


def margin_beside(world: World[Any], body: int, side: Direction) -> Fraction:
    """The collision margin, or how much of it is before the wall."""
    to_wall = world.to_wall(body, side)
    view = world.facing(side)
    if (
        to_wall is None
        or view.beyond(view.tip(world.row(body).edges[-1 if side is Direction.RIGHT else 0], side)).ledge
    ):
        return Fraction(world.margin)
    return max(Fraction(0), min(Fraction(world.margin), Fraction(to_wall)))


def slope_at(world: World[Any], edge: int) -> tuple[Fraction, Fraction]:
    """How far an edge goes across and up for a unit of its length; a top as the ground under it, unless it is bent."""
    while edge >= world.statics:
        held = world.bodies[edge - world.statics]
        if not world.straight(held):
            (x, y), (far_x, far_y) = (scene.place_of(world, at) for at in (held.left, held.right))
            width = Fraction(world.width(edge - world.statics)) or Fraction(1)
            return (far_x - x) / width, (far_y - y) / width
        edge = held.left.edge
    return Fraction(world.graph.edges[edge].run), Fraction(world.graph.edges[edge].rise)


def draw_body(canvas: Canvas, shape: Outline) -> None:
    """A body: a character is round and bold and looks ahead, a box is a crate; its borders are dots."""
    held = canvas.world.bodies[shape.body]
    kind = "character" if held.speed else "box"
    canvas.shown.add(kind)
    group = element(canvas.group, "g")
    element(group, "title").text = one_line(
        f"{held.name} at ({number(shape.bottom[0][0])}, {number(shape.bottom[0][1])})"
    )
    spots = corners(canvas.lens, shape)
    element(group, "path", kind, d=rounded(spots) if held.speed else path(spots, close=True))
    width, height = abs(spots[-2][0] - spots[-1][0]), canvas.lens.size(shape.height)
    if held.speed and width >= 12 and height >= 12:
        draw_eyes(group, spots, height, canvas.frame.asked().get(held.name, 1))
    elif width >= 22 and height >= 18:
        draw_planks(group, spots, len(shape.bottom))
    if width >= 8:
        for x, y in (spots[0], spots[len(shape.bottom) - 1]):
            element(group, "circle", "dot", cx=x, cy=y, r=2.2)


def rounded(spots: list[Spot]) -> str:
    """The path of a body whose upper corners are round."""
    *bottom, (right, right_y), (left, left_y) = spots
    size = max(0.0, min(8.0, (right - left) / 3, (bottom[0][1] - left_y) / 3))
    slant = (right_y - left_y) / (right - left) * size if right > left else 0.0
    data = path([*bottom, (right, right_y + size)])
    data += f" Q{right:.1f} {right_y:.1f} {right - size:.1f} {right_y - slant:.1f}"
    data += f" L{left + size:.1f} {left_y + slant:.1f} Q{left:.1f} {left_y:.1f} {left:.1f} {left_y + size:.1f}"
    return f"{data} Z"


def draw_eyes(group: Element, spots: list[Spot], height: float, way: Fraction | int) -> None:
    """Two eyes that look where the body is asked to go."""
    (right, right_y), (left, left_y) = spots[-2:]
    part = 0.62 if way >= 0 else 0.38
    x, y = left + (right - left) * part, left_y + (right_y - left_y) * part + min(11.0, height * 0.28)
    for side in (-1, 1):
        element(
            group, "circle", "eye", cx=x + side * min(4.2, (right - left) / 8), cy=y, r=min(2.4, (right - left) / 12)
        )


def draw_planks(group: Element, spots: list[Spot], count: int) -> None:
    """The frame of a crate."""
    bottom, (right, left) = spots[:count], spots[count:]
    rim = 3.5
    low = [(min(max(x, left[0] + rim), right[0] - rim), y - rim) for x, y in bottom]
    line(group, "plank", *low, (right[0] - rim, right[1] + rim), (left[0] + rim, left[1] + rim), close=True)


def draw_support(canvas: Canvas, shape: Outline) -> None:
    """A link between a rider and what it stands on."""
    below, seen = canvas.world.support(shape.body), visible(canvas, shape)
    if below is None or seen[1] - seen[0] < 8 or canvas.lens.size(shape.height) < 12:
        return
    carrier = scene.outline(canvas.world, below)
    canvas.shown.add("support")
    for by in canvas.images(carrier.left, carrier.right):
        under = visible(canvas, carrier.shifted(by))
        left, right = max(seen[0], under[0]), min(seen[1], under[1])
        if left < right:
            link(canvas, left + min(7.0, (right - left) / 2), [canvas.lens.spot(point) for point in shape.bottom])


def link(canvas: Canvas, x: float, bottom: list[Spot]) -> None:
    """A short rod through the bottom of a body."""
    (left, low), (right, high) = bottom[0], bottom[-1]
    y = low + (high - low) * (x - left) / (right - left)
    line(canvas.group, "support", (x, y - 5), (x, y + 5))
    for end in (y - 5, y + 5):
        element(canvas.group, "circle", "dot", cx=x, cy=end, r=2)


def draw_overlaps(canvas: Canvas, shapes: list[Outline]) -> None:
    """Where bodies that stand level are in one another or in the terrain under level ground, crossed lines."""
    level = sorted((shape for shape in shapes if len({y for _, y in shape.bottom}) == 1), key=lambda shape: shape.left)
    boxes = [Box(shape.left, shape.right, shape.low, shape.high) for shape in level]
    for i, one in enumerate(boxes):
        for other in boxes[i + 1 :]:
            if other.left >= one.right:
                break
            cross_out(canvas, one, other)
    for edge in edges_seen(canvas):
        if edge.type is EdgeType.GROUND and edge.start[1] == edge.end[1]:
            top = edge.start[1]
            bottom = canvas.lens.window.bottom - FAR if edge.thickness is None else top - edge.thickness
            for one in boxes:
                cross_out(canvas, one, Box(edge.start[0], edge.end[0], bottom, top))


def cross_out(canvas: Canvas, one: Box[Fraction], other: Box[Fraction]) -> None:
    """Cross out what two boxes have in common."""
    assert one.bottom is not None
    assert other.bottom is not None
    left, right = max(one.left, other.left), min(one.right, other.right)
    bottom, top = max(one.bottom, other.bottom), min(one.top, other.top)
    if left < right and bottom < top:
        (x, y), (far_x, far_y) = canvas.lens.spot((left, top)), canvas.lens.spot((right, bottom))
        element(canvas.group, "rect", "overlap", x=x, y=y, width=far_x - x, height=far_y - y)
        canvas.taken.append((x, y, far_x, far_y))
        canvas.shown.add("overlap")


def draw_request(canvas: Canvas, shape: Outline, way: int) -> None:
    """An arrow the way that a body was asked to move: low in it, or above it if it is small."""
    (left, right), height = visible(canvas, shape), canvas.lens.size(shape.height)
    x, low = (left + right) / 2, height - 8 if height >= 34 and right - left >= 20 else -7
    half = min(12.0, (right - left) * 0.3) if low > 0 else 9.0
    tail, tip = ((x + along * way, top_at(canvas.lens, shape, x + along * way) + low) for along in (-half, half))
    line(canvas.group, "request", tail, ((tail[0] + 3 * tip[0]) / 4, (tail[1] + 3 * tip[1]) / 4))
    head(canvas.group, tip, (tip[0] - tail[0], tip[1] - tail[1]), 7)
    canvas.shown.add("request")
    if low < 0:
        canvas.taken.append((x - half, min(tail[1], tip[1]) - 4, x + half, max(tail[1], tip[1]) + 4))


def draw_name(canvas: Canvas, shape: Outline) -> None:
    """The name of a body where there is room for it, and an arrow if it was asked to move."""
    held, (left, right) = canvas.world.bodies[shape.body], visible(canvas, shape)
    way = canvas.frame.asked().get(held.name)
    if right - left < 5:
        return
    if way:
        draw_request(canvas, shape, 1 if way > 0 else -1)
    height, x, room = canvas.lens.size(shape.height), (left + right) / 2, right - left
    lowered = (7 if held.speed else 4) - (3 if way and height >= 34 else 0)
    inside = top_at(canvas.lens, shape, x) + height / 2 + lowered
    above = bounds(canvas.lens, shape)[1] - 5
    for text in names(held.name, room):
        half = text_width(text, 11) / 2 + 5
        own = (x - half, inside - 9, x + half, inside + 2)
        if 2 * half <= room and height >= (30 if held.speed else 18) and alone(canvas, own):
            write(canvas.group, text, x, inside, "body middle")
            canvas.taken.append(own)
            return
        places = [(x, above), (x, above - 13)]
        if canvas.world.support(shape.body) is not None:
            places += [(right + half, inside), (left - half, inside)]
        if any(canvas.label(text, *place, "body halo", 11) for place in places):
            return


def alone(canvas: Canvas, rect: Rect) -> bool:
    """Whether nothing but one body is there."""
    return sum(overlap(rect, other) for other in canvas.taken) <= 1


def names(name: str, room: float) -> Iterator[str]:
    """A name, and shorter ones: the initials of its words with what is a number, and the number alone."""
    text = one_line(name)
    words = text.split() or [text]
    if room >= 22:
        yield from [text] if len(text) <= 24 else []
        yield shortened(text, 12)
    if room >= 22 or not words[-1].isdigit():
        yield "".join(word[0] + "".join(filter(str.isdigit, word[1:])) for word in words)[:4]
    if words[-1].isdigit():
        yield words[-1][:4]
