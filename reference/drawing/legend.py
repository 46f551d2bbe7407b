"""The legend of a drawing: a sample of each kind of thing that is in it, with its name."""

from __future__ import annotations

from collections.abc import Callable
from xml.etree.ElementTree import Element

from reference.drawing.ink import element, head, line, path, text_width, write

SAMPLE = 28.0


def character(group: Element, x: float, y: float) -> None:
    """A character."""
    data = f"M{x + 6:.1f} {y:.1f} V{y - 10:.1f} q0 -6 6 -6 h4 q6 0 6 6 V{y:.1f} Z"
    element(group, "path", "character", d=data)
    for eye in (x + 13, x + 18):
        element(group, "circle", "eye", cx=eye, cy=y - 9, r=1.6)


def box(group: Element, x: float, y: float) -> None:
    """A box, with its borders as dots."""
    corners = [(x + 6, y), (x + 22, y), (x + 22, y - 16), (x + 6, y - 16)]
    line(group, "box", *corners, close=True)
    line(group, "plank", (x + 9, y - 3), (x + 19, y - 3), (x + 19, y - 13), (x + 9, y - 13), close=True)
    for end in (x + 6, x + 22):
        element(group, "circle", "dot", cx=end, cy=y, r=2.2)


def ghost(group: Element, x: float, y: float) -> None:
    """Where a body was."""
    line(group, "ghost", (x + 6, y), (x + 22, y), (x + 22, y - 16), (x + 6, y - 16), close=True)


def margin(group: Element, x: float, y: float) -> None:
    """The margin beside a body."""
    element(group, "path", "box", d=path([(x + 2, y), (x + 15, y), (x + 15, y - 16), (x + 2, y - 16)]))
    line(group, "margin", (x + 15, y), (x + 25, y), (x + 25, y - 16), (x + 15, y - 16))


def wall(group: Element, x: float, y: float) -> None:
    """A wall."""
    line(group, "wall", (x + 11, y), (x + 11, y - 16))
    for up in (1, 7, 13):
        line(group, "hatch", (x + 12, y - up), (x + 18, y - up - 5))


def ground(group: Element, x: float, y: float) -> None:
    """A ground edge between vertices."""
    line(group, "ground", (x + 1, y - 6), (x + 27, y - 6))
    for end in (x + 1, x + 27):
        element(group, "circle", "vertex", cx=end, cy=y - 6, r=2.8)


def fall(group: Element, x: float, y: float) -> None:
    """A fall edge."""
    line(group, "fall", (x + 14, y - 17), (x + 14, y - 2))
    head(group, (x + 14, y + 1), (0, 1), 8)


def jump(group: Element, x: float, y: float) -> None:
    """A jump edge."""
    element(group, "path", "jump", d=f"M{x + 3:.1f} {y - 3:.1f} q11 -18 22 0")


def gap(group: Element, x: float, y: float) -> None:
    """A gap."""
    line(group, "gap", (x + 2, y - 6), (x + 26, y - 6))
    head(group, (x + 1, y - 6), (-1, 0), 5)
    head(group, (x + 27, y - 6), (1, 0), 5)


def contact(group: Element, x: float, y: float) -> None:
    """Contact."""
    element(group, "path", "box", d=path([(x + 1, y), (x + 9, y), (x + 9, y - 14), (x + 1, y - 14)], close=True))
    element(group, "path", "box", d=path([(x + 19, y), (x + 27, y), (x + 27, y - 14), (x + 19, y - 14)], close=True))
    line(group, "contact", (x + 9, y - 4), (x + 19, y - 4))


def clash(group: Element, x: float, y: float) -> None:
    """Where a body is in another or in terrain."""
    element(group, "rect", "overlap", x=x + 6, y=y - 16, width=16.0, height=16.0)


def support(group: Element, x: float, y: float) -> None:
    """The link between a rider and its support."""
    line(group, "margin", (x + 4, y - 7), (x + 24, y - 7))
    line(group, "support", (x + 14, y - 12), (x + 14, y - 2))
    for end in (y - 12, y - 2):
        element(group, "circle", "dot", cx=x + 14, cy=end, r=2)


def request(group: Element, x: float, y: float) -> None:
    """Where a body was asked to go."""
    line(group, "request", (x + 3, y - 6), (x + 20, y - 6))
    head(group, (x + 25, y - 6), (1, 0), 7)


def button(group: Element, x: float, y: float) -> None:
    """A button."""
    element(group, "rect", "button", x=x + 7, y=y - 8, width=14.0, height=8.0, rx=1.5)


def pressed(group: Element, x: float, y: float) -> None:
    """A button that is pressed."""
    element(group, "rect", "button pressed", x=x + 7, y=y - 3, width=14.0, height=3.0, rx=1.5)


def seam(group: Element, x: float, y: float) -> None:
    """The seam of a cylinder."""
    line(group, "seam", (x + 14, y - 17), (x + 14, y + 2))


SAMPLES: dict[str, tuple[str, Callable[[Element, float, float], None]]] = {
    "character": ("character", character),
    "box": ("box", box),
    "request": ("asked to move", request),
    "ghost": ("before the step", ghost),
    "margin": ("margin", margin),
    "contact": ("in contact: the margin apart", contact),
    "gap": ("gap", gap),
    "overlap": ("in a body or in terrain", clash),
    "support": ("stands on", support),
    "ground": ("ground edge", ground),
    "wall": ("wall", wall),
    "fall": ("fall edge", fall),
    "jump": ("jump edge", jump),
    "button": ("button", button),
    "pressed": ("button, pressed", pressed),
    "seam": ("seam of the cylinder", seam),
}


def draw_legend(page: Element, shown: set[str], left: float, top: float, right: float) -> float:
    """A sample of each kind of thing that is shown, in lines; return where they end."""
    group = element(page, "g")
    x, y = left, top + 18
    for kind, (name, sample) in SAMPLES.items():
        if kind not in shown:
            continue
        width = SAMPLE + 6 + text_width(name, 12) + 14
        if x + width > right:
            x, y = left, y + 26
        sample(group, x, y)
        write(group, name, x + SAMPLE + 6, y - 3, "legend")
        x += width
    return y + 6
