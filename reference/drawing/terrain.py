"""The level in a panel: terrain, edges by type, walls, vertices, jump edges, buttons and the seam."""

from __future__ import annotations

from fractions import Fraction
from xml.etree.ElementTree import Element

from reference.drawing import scene
from reference.drawing.canvas import Canvas, Lens, Spot
from reference.drawing.ink import element, head, line, path, text_width
from reference.drawing.scene import Segment
from spec.graph import EdgeType


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


def draw_buttons(canvas: Canvas) -> None:
    """Buttons, under the ground that they are in: hollow, or filled if pressed."""
    for at, pressed in zip(canvas.world.level.buttons, canvas.frame.pressed, strict=True):
        x, y = scene.place_of(canvas.world, at)
        for by in canvas.images(x, x):
            middle, ground = canvas.lens.spot((x + by, y))
            kind, up = ("button pressed", 3.0) if pressed else ("button", 8.0)
            element(canvas.group, "rect", kind, x=middle - 7, y=ground - up, width=14.0, height=up, rx=1.5)
            canvas.shown.add("pressed" if pressed else "button")


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
