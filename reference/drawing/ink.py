"""Ink and paper: the one style of all drawings, SVG elements, and how wide a text is.

Colours are named once, for light and for dark; whatever differs in colour differs in line, fill or label too.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from unicodedata import east_asian_width
from xml.etree.ElementTree import Element, SubElement

from reference.formats.files import one_line

HATCH, CROSSES = "graphbody-terrain", "graphbody-overlap"
STYLE = """
.graphbody { --paper: #ffffff; --ink: #1b1b1b; --soft: #5c5c5c; --ground: #ececea; --hatch: #b9b9b4;
  --character: #a9cdee; --box: #f8e3b4; --plank: #a8873f; --clash: #f4a9a0; }
@media (prefers-color-scheme: dark) {
  .graphbody { --paper: #14181d; --ink: #f0f0f0; --soft: #a9b0b8; --ground: #252b33; --hatch: #4a535e;
    --character: #275f95; --box: #58431a; --plank: #b08f4a; --clash: #8c2f2a; }
}
.graphbody { font-family: Helvetica, Arial, "Liberation Sans", "DejaVu Sans", sans-serif; }
.graphbody text { fill: var(--ink); font-size: 11px; }
.graphbody .name { font-size: 17px; font-weight: bold; }
.graphbody .note, .graphbody .legend, .graphbody .what { font-size: 12px; }
.graphbody .caption { font-size: 14px; font-weight: bold; }
.graphbody .number, .graphbody .edge { font-size: 10px; }
.graphbody .edge { fill: var(--soft); }
.graphbody .halo { paint-order: stroke; stroke: var(--paper); stroke-width: 3.5px; stroke-linejoin: round; }
.graphbody .halo.edge { stroke: var(--ground); }
.graphbody .middle { text-anchor: middle; }
.graphbody .paper { fill: var(--paper); }
.graphbody .solid { fill: var(--ground); }
.graphbody .clash { fill: var(--clash); }
.graphbody path, .graphbody line { fill: none; stroke: var(--ink); }
.graphbody .overlap { fill: url(#graphbody-overlap); stroke: var(--ink); stroke-width: 1.6; }
.graphbody .cross { stroke: var(--ink); stroke-width: 1.1; }
.graphbody path.terrain, .graphbody path.head { stroke: none; }
.graphbody path.terrain { fill: url(#graphbody-terrain); }
.graphbody path.head { fill: var(--ink); }
.graphbody .hatch { stroke: var(--hatch); stroke-width: 1; }
.graphbody .ground { stroke-width: 3; stroke-linecap: round; stroke-linejoin: round; }
.graphbody .under { stroke-width: 1; stroke: var(--soft); }
.graphbody .wall { stroke-width: 3; stroke-linecap: round; }
.graphbody .fall { stroke-width: 1.6; stroke-dasharray: 6 4; }
.graphbody .jump { stroke-width: 1.3; stroke-dasharray: 0.1 3.6; stroke-linecap: round; }
.graphbody .seam { stroke-width: 1.2; stroke-dasharray: 9 3 1.5 3; stroke: var(--soft); }
.graphbody .vertex { fill: var(--paper); stroke: var(--ink); stroke-width: 1.4; }
.graphbody path.character { fill: var(--character); stroke-width: 2.4; stroke-linejoin: round; }
.graphbody path.box { fill: var(--box); stroke-width: 1.2; }
.graphbody .plank { stroke-width: 0.9; stroke: var(--plank); }
.graphbody .ghost { stroke-width: 1.4; stroke-dasharray: 0.1 3.4; stroke-linecap: round; stroke: var(--soft); }
.graphbody .margin { stroke-width: 0.8; stroke-dasharray: 3 2; stroke: var(--soft); }
.graphbody .gap, .graphbody .request { stroke-width: 1; }
.graphbody .contact { stroke-width: 3; }
.graphbody .support, .graphbody .request { stroke-width: 1.6; }
.graphbody .dot, .graphbody .eye, .graphbody .pressed { fill: var(--ink); }
.graphbody .button { fill: var(--paper); stroke: var(--ink); stroke-width: 1.3; }
.graphbody .button.pressed { fill: var(--ink); }
"""


def element(parent: Element, tag: str, kind: str = "", **attributes: object) -> Element:
    """A new element inside another: its class, and its attributes with numbers to a tenth."""
    found = {"class": kind} if kind else {}
    found |= {name.replace("_", "-"): tenth(value) for name, value in attributes.items()}
    return SubElement(parent, tag, found)


def tenth(value: object) -> str:
    """A number to a tenth; anything else as it is."""
    return f"{round(value, 1) + 0:g}" if isinstance(value, float) and abs(value) < 1e5 else str(value)


def write(parent: Element, text: str, x: float, y: float, kind: str) -> Element:
    """A text whose base line begins, or has its middle, at a point."""
    found = element(parent, "text", kind, x=x, y=y)
    found.text = one_line(text)
    return found


def line(parent: Element, kind: str, *points: tuple[float, float], close: bool = False) -> Element:
    """A path through points."""
    return element(parent, "path", kind, d=path(points, close))


def path(points: Iterable[tuple[float, float]], close: bool = False) -> str:
    """Points as the data of a path."""
    data = " L".join(f"{tenth(x)} {tenth(y)}" for x, y in points)
    return f"M{data}{' Z' if close else ''}"


def head(parent: Element, tip: tuple[float, float], along: tuple[float, float], size: float = 6.0) -> None:
    """The head of an arrow, with its tip at a point, that points along a vector."""
    (x, y), (across, up) = tip, along
    length = (across * across + up * up) ** 0.5 or 1.0
    a, b = across / length * size, up / length * size
    line(parent, "head", (x, y), (x - a - b / 2, y - b + a / 2), (x - a + b / 2, y - b - a / 2), close=True)


def text_width(text: str, size: float) -> float:
    """How wide a text is at most, about."""
    return sum(char_width(char) for char in text) * size


def char_width(char: str) -> float:
    """How wide a character is, about, as a part of the size of the type."""
    if east_asian_width(char) in "WF":
        return 1.0
    if char in " .,:;|!'/ijltfI()-r":
        return 0.38 if char in "r()-" else 0.31
    return 0.78 if char.isupper() or char in "mw@%—…" else 0.6


def shortened(text: str, most: int) -> str:
    """A text of at most so many characters."""
    text = one_line(text) if text.strip() else repr(text)
    return text if len(text) <= most else text[: most - 1] + "…"


def wrapped(text: str, width: float, size: float) -> list[str]:
    """A text in lines that are at most so wide."""
    lines, current = [], ""
    for word in pieces(one_line(text), width, size):
        longer = f"{current} {word}" if current else word
        if current and text_width(longer, size) > width:
            lines.append(current)
            longer = word
        current = longer
    return [*lines, current] if current else lines


def pieces(text: str, width: float, size: float) -> Iterator[str]:
    """The words of a text, those that are longer than a line in parts."""
    most = max(1, int(width / size))
    for word in text.split():
        whole = text_width(word, size) <= width
        yield from [word] if whole else (word[i : i + most] for i in range(0, len(word), most))


def number(value: Fraction) -> str:
    """A number as it stands in a drawing: exact if that is short."""
    if len(str(value)) <= 7:
        return str(value)
    try:
        return f"{float(value):.4g}"
    except OverflowError:
        return "…"


def paper(width: float, height: float, title: str) -> Element:
    """An empty sheet with the style, and a background."""
    sheet = Element("svg", {"xmlns": "http://www.w3.org/2000/svg", "class": "graphbody", "role": "img"})
    for name, value in (("width", width), ("height", height), ("viewBox", f"0 0 {width:g} {height:g}")):
        sheet.set(name, tenth(value))
    element(sheet, "title").text = one_line(title)
    element(sheet, "style").text = STYLE
    tiles = element(sheet, "defs")
    pattern(tiles, HATCH, "solid", "hatch", "M-1 1 L1 -1 M-1 9 L9 -1 M7 9 L9 7")
    pattern(tiles, CROSSES, "clash", "cross", "M0 0 L8 8 M8 0 L0 8")
    element(sheet, "rect", "paper", width=width, height=height)
    return sheet


def pattern(parent: Element, name: str, fill: str, stroke: str, data: str) -> None:
    """A tile to fill areas with."""
    tile = element(parent, "pattern", id=name, width=8, height=8, patternUnits="userSpaceOnUse")
    element(tile, "rect", fill, width=8, height=8)
    element(tile, "path", stroke, d=data)
