"""One picture of one moment: terrain, edges, bodies and what is between them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import pairwise
from typing import Any
from xml.etree.ElementTree import Element

from reference import scene
from reference.formats.files import one_line
from reference.formats.trace import LineRecord
from reference.ink import element, head, line, number, path, shortened, text_width, write
from reference.scene import Outline, Point, Segment, Window
from reference.world import World
from spec.graph import Direction, EdgeType
from spec.plane import Box

SIDE, HEAD, FOOT = 22.0, 26.0, 36.0
FAR = Fraction(10**5)
Spot = tuple[float, float]
Rect = tuple[float, float, float, float]


@dataclass(frozen=True)
class Frame:
    """A moment to draw: the world, the one before it and the line of the trace between them, if there is one."""

    step: int
    world: World[Any]
    pressed: tuple[bool, ...]
    before: World[Any] | None = None
    line: LineRecord | None = None

    def asked(self) -> dict[str, Fraction]:
        """Who was asked to move, and which way."""
        if self.line is None:
            return {}
        if self.line.request is not None:
            return {self.line.request.body: Fraction(self.line.request.distance)}
        assert self.line.tick is not None
        way = Fraction(1 if self.line.tick.key == "right" else -1)
        return {body.name: way for body in self.world.bodies if body.speed}


@dataclass(frozen=True)
class Lens:
    """From the plane to a picture: what it shows, and how many pixels a unit has."""

    window: Window
    scale: Fraction

    @property
    def width(self) -> float:
        """How wide the picture is."""
        return float((self.window.right - self.window.left) * self.scale) + 2 * SIDE

    @property
    def height(self) -> float:
        """How high the picture is."""
        return float((self.window.top - self.window.bottom) * self.scale) + HEAD + FOOT

    def spot(self, point: Point) -> Spot:
        """Where a point is in the picture; what is far outside is brought nearer."""
        x, y = (point[0] - self.window.left) * self.scale, (self.window.top - point[1]) * self.scale
        return SIDE + float(max(-FAR, min(FAR, x))), HEAD + float(max(-FAR, min(FAR, y)))

    def size(self, length: Fraction) -> float:
        """A length in pixels."""
        return float(min(FAR, length * self.scale))

    def rim(self, world: World[Any]) -> float:
        """How much at either side stays empty: on a cylinder all that is beyond the seam."""
        return SIDE if world.graph.circumference is not None and not self.window.cropped else 0.0

    @property
    def reach(self) -> tuple[Fraction, Fraction]:
        """From where to where things are drawn: beyond the window if there is more of the level there."""
        more = Fraction(int(SIDE) + 1) / self.scale if self.window.cropped else Fraction(0)
        return self.window.left - more, self.window.right + more


@dataclass(frozen=True)
class Canvas:
    """What is drawn on, through which lens, what of it is taken, and what there is to explain in a legend."""

    group: Element
    lens: Lens
    frame: Frame
    taken: list[Rect] = field(default_factory=list)
    shown: set[str] = field(default_factory=set)

    @property
    def world(self) -> World[Any]:
        """The world that is drawn."""
        return self.frame.world

    def images(self, left: Fraction, right: Fraction) -> Iterator[Fraction]:
        """How far to shift what goes from left to right to where it is seen."""
        return scene.images(self.world, (left, right), self.lens.reach)

    def free(self, rect: Rect) -> bool:
        """Whether nothing is there yet, and it is inside the picture."""
        rim = self.lens.rim(self.world) + 1
        inside = rect[0] >= rim and rect[2] <= self.lens.width - rim and rect[1] >= 1
        return inside and not any(overlap(rect, other) for other in self.taken)

    def label(self, text: str, x: float, y: float, kind: str, size: float) -> bool:
        """Write a text around a point, if there is room for it."""
        half = text_width(text, size) / 2
        rect = (x - half - 1, y - size * 0.8, x + half + 1, y + size * 0.2)
        if not self.free(rect):
            return False
        self.taken.append(rect)
        write(self.group, text, x, y, f"{kind} middle")
        return True


def overlap(a: Rect, b: Rect) -> bool:
    """Whether two rectangles have a part in common."""
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]


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
    if canvas.lens.size(scene.unit_of(canvas.world)) >= 8:
        draw_jumps(canvas)
    for spots, gap in gaps_seen(canvas):
        draw_gap(canvas, spots, gap)
    for shape in shapes:
        draw_support(canvas, shape)
    draw_buttons(canvas)


def draw_ground(canvas: Canvas) -> None:
    """Terrain, edges, walls and vertices."""
    seen = edges_seen(canvas)
    ground = [edge for edge in seen if edge.type is EdgeType.GROUND and edge.end[0] > edge.start[0]]
    data = " ".join(path(solid(canvas.lens, edge), close=True) for edge in ground)
    if data:
        element(canvas.group, "path", "terrain", d=data)
    for edge in ground:
        if edge.thickness is not None:
            line(canvas.group, "under", *solid(canvas.lens, edge), close=True)
    draw_walls(canvas)
    for edge in seen:
        draw_edge(canvas, edge)
    draw_vertices(canvas)


def edges_seen(canvas: Canvas) -> list[Segment]:
    """The edges, as far as they are seen."""
    left, right = canvas.lens.reach
    return [
        edge.shifted(by).clipped(left, right)
        for edge in scene.segments(canvas.world)
        for by in canvas.images(edge.start[0], edge.end[0])
    ]


def solid(lens: Lens, edge: Segment) -> list[Spot]:
    """The terrain under an edge, as far as it is seen."""
    start, end = lens.spot(edge.start), lens.spot(edge.end)
    if edge.thickness is None:
        return [start, end, (end[0], lens.height), (start[0], lens.height)]
    deep = lens.size(edge.thickness)
    return [start, end, (end[0], end[1] + deep), (start[0], start[1] + deep)]


def draw_walls(canvas: Canvas) -> None:
    """A wall goes up where a string ends, hatched on its far side."""
    for (x, y), direction in scene.walls(canvas.world):
        for by in canvas.images(x, x):
            (at, foot) = canvas.lens.spot((x + by, y))
            height = min(max(18.0, min(64.0, canvas.lens.size(scene.unit_of(canvas.world)) * 1.5)), foot - 3)
            line(canvas.group, "wall", (at, foot), (at, foot - height))
            for i in range(int(height / 8)):
                up = foot - 3 - i * 8
                line(canvas.group, "hatch", (at + 1.5 * direction, up), (at + 8 * direction, up - 6.5))
            canvas.shown.add("wall")


def draw_edge(canvas: Canvas, edge: Segment) -> None:
    """A ground edge, strong, or a fall edge, dashed, with a head where it leads down."""
    start, end = canvas.lens.spot(edge.start), canvas.lens.spot(edge.end)
    canvas.shown.add(edge.type.value)
    line(canvas.group, edge.type.value, start, end)
    if edge.type is EdgeType.FALL:
        high, low = sorted((start, end), key=lambda spot: spot[1])
        across, down = low[0] - high[0], low[1] - high[1]
        length = (across * across + down * down) ** 0.5 or 1.0
        short = min(5.0, length / 2) / length
        head(canvas.group, (low[0] - across * short, low[1] - down * short), (across, down), min(8.0, length))


def draw_vertices(canvas: Canvas) -> None:
    """A ring at each vertex, if they are not too many."""
    spots = set()
    for edge in scene.segments(canvas.world):
        for point in (edge.start, edge.end):
            spots |= {canvas.lens.spot((point[0] + by, point[1])) for by in canvas.images(point[0], point[0])}
    ordered = sorted(spots)
    crowded = len(ordered) > 2 * canvas.lens.width / 12
    for x, y in ordered:
        element(canvas.group, "circle", "vertex", cx=x, cy=y, r=1.5 if crowded else 2.8)


def draw_edge_numbers(canvas: Canvas) -> None:
    """The numbers of the edges, where there is room."""
    for edge in edges_seen(canvas):
        start, end = canvas.lens.spot(edge.start), canvas.lens.spot(edge.end)
        if edge.type is EdgeType.FALL:
            high, low = (start, end) if start[1] < end[1] else (end, start)
            number_fall(canvas, str(edge.edge), high, low, to_the_right=high is start)
        elif end[0] - start[0] >= 15:
            number_ground(canvas, str(edge.edge), start, end)


def number_fall(canvas: Canvas, text: str, high: Spot, low: Spot, to_the_right: bool) -> None:
    """The number of a fall edge, near its top, in the cliff or beside it."""
    if low[1] - high[1] < 16:
        return
    across = (low[0] - high[0]) * 14 / (low[1] - high[1])
    side = (text_width(text, 10) / 2 + 5) * (-1 if to_the_right else 1)
    for by in (side, -side):
        if canvas.label(text, high[0] + across + by, high[1] + 15, "edge halo", 10):
            return


def number_ground(canvas: Canvas, text: str, start: Spot, end: Spot) -> None:
    """The number of a ground edge, under its middle or beside that."""
    left, right = max(start[0], 0.0), min(end[0], canvas.lens.width)
    slant = (end[1] - start[1]) / (end[0] - start[0])
    for part in (0.5, 0.4, 0.6, 0.25, 0.75):
        x = left + (right - left) * part
        if canvas.label(text, x, start[1] + (x - start[0]) * slant + 16 + 6 * abs(slant), "edge halo", 10):
            return


def draw_jumps(canvas: Canvas) -> None:
    """Jump edges, dotted arcs."""
    for start, end, direction in scene.jump_edges(canvas.world):
        for by in canvas.images(*sorted((start[0], end[0]))):
            (x, y), (far_x, far_y) = (canvas.lens.spot((point[0] + by, point[1])) for point in (start, end))
            bend = (x + far_x) / 2 if far_y < y + 8 else far_x + 10 * direction
            top = y - max(9.0, abs(far_x - x) / 2)
            data = f"M{x:.1f} {y:.1f} Q{bend:.1f} {top:.1f} {far_x:.1f} {far_y:.1f}"
            element(canvas.group, "path", "jump", d=data)
            canvas.shown.add("jump")


def draw_ghosts(canvas: Canvas) -> None:
    """Where bodies that have moved were before."""
    if canvas.frame.before is None:
        return
    for old, new in zip(scene.outlines(canvas.frame.before), scene.outlines(canvas.world), strict=True):
        if old.bottom != new.bottom:
            for by in canvas.images(old.left, old.right):
                line(canvas.group, "ghost", *corners(canvas.lens, old.shifted(by)), close=True)
                canvas.shown.add("ghost")


def corners(lens: Lens, shape: Outline) -> list[Spot]:
    """The corners of a body: along its bottom to the right, then back along its top."""
    left, right = shape.top
    return [lens.spot(point) for point in (*shape.bottom, right, left)]


def bounds(lens: Lens, shape: Outline) -> Rect:
    """The rectangle around a body."""
    (x, y), (far_x, far_y) = lens.spot((shape.left, shape.high)), lens.spot((shape.right, shape.low))
    return x, y, far_x, far_y


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
        canvas.shown.add("overlap")


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


def visible(canvas: Canvas, shape: Outline) -> tuple[float, float]:
    """From where to where a body is seen."""
    rect, rim = bounds(canvas.lens, shape), canvas.lens.rim(canvas.world)
    return max(rect[0], rim), min(rect[2], canvas.lens.width - rim)


def draw_buttons(canvas: Canvas) -> None:
    """Buttons, under the ground that they are in: hollow, or filled if pressed."""
    for at, pressed in zip(canvas.world.level.buttons, canvas.frame.pressed, strict=True):
        x, y = scene.place_of(canvas.world, at)
        for by in canvas.images(x, x):
            middle, ground = canvas.lens.spot((x + by, y))
            kind, up = ("button pressed", 3.0) if pressed else ("button", 8.0)
            element(canvas.group, "rect", kind, x=middle - 7, y=ground - up, width=14.0, height=up, rx=1.5)
            canvas.shown.add("pressed" if pressed else "button")


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


def top_at(lens: Lens, shape: Outline, x: float) -> float:
    """How high in a picture the top of a body is."""
    (left, left_y), (right, right_y) = (lens.spot(point) for point in shape.top)
    return left_y + (right_y - left_y) * (x - left) / (right - left) if right > left else left_y


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


def draw_seam(parent: Element, canvas: Canvas, left: float, top: float) -> None:
    """Where a cylinder was cut open, at both ends of the picture."""
    round_ = canvas.world.graph.circumference
    if round_ is None:
        return
    start = canvas.lens.window.whole[0]
    for by in canvas.images(start, start):
        x, _ = canvas.lens.spot((start + by, Fraction(0)))
        line(parent, "seam", (left + x, top + 6), (left + x, top + canvas.lens.height))
        canvas.shown.add("seam")
