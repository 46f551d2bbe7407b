"""What a panel is drawn on: the moment, the lens through which it is seen, and what is taken already."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any
from xml.etree.ElementTree import Element

from reference.drawing import scene
from reference.drawing.ink import text_width, write
from reference.drawing.scene import Outline, Point, Window
from reference.formats.numbers import exact
from reference.formats.trace import LineRecord
from reference.world import World

SIDE, HEAD, FOOT = 22.0, 26.0, 36.0
FAR = Fraction(10**5)
Spot = tuple[float, float]
Rect = tuple[float, float, float, float]


@dataclass(frozen=True)
class Frame:
    """A moment to draw: the world, the one before it and the line of the trace between them, if there is one.

    `jumps` is whether bodies jump along jump edges.
    """

    step: int
    world: World[Any]
    pressed: tuple[bool, ...]
    before: World[Any] | None = None
    line: LineRecord | None = None
    jumps: bool = True

    def asked(self) -> dict[str, Fraction]:
        """Who was asked to move, and which way."""
        if self.line is None:
            return {}
        if self.line.request is not None:
            return {self.line.request.body: Fraction(self.line.request.distance)}
        if self.line.drive is not None:
            return {name: exact(speed, "$") for name, speed in self.line.drive.speeds.items()}
        if self.line.tick is None or self.line.tick.direction is None:
            return {}
        way = Fraction(self.line.tick.direction)
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


def corners(lens: Lens, shape: Outline) -> list[Spot]:
    """The corners of a body: along its bottom to the right, then back along its top."""
    left, right = shape.top
    return [lens.spot(point) for point in (*shape.bottom, right, left)]


def bounds(lens: Lens, shape: Outline) -> Rect:
    """The rectangle around a body."""
    (x, y), (far_x, far_y) = lens.spot((shape.left, shape.high)), lens.spot((shape.right, shape.low))
    return x, y, far_x, far_y


def visible(canvas: Canvas, shape: Outline) -> tuple[float, float]:
    """From where to where a body is seen."""
    rect, rim = bounds(canvas.lens, shape), canvas.lens.rim(canvas.world)
    return max(rect[0], rim), min(rect[2], canvas.lens.width - rim)


def top_at(lens: Lens, shape: Outline, x: float) -> float:
    """How high in a picture the top of a body is."""
    (left, left_y), (right, right_y) = (lens.spot(point) for point in shape.top)
    return left_y + (right_y - left_y) * (x - left) / (right - left) if right > left else left_y
