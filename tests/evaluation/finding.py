"""What is found of a statement of the thesis, and how numbers are told."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from evaluation.tables import Line, Table, number
from spec.evaluated import Evaluated, Judgement

BOX2D, PRINTED, MENDED = "Box2D", "graphbody printed", "graphbody mended"
THESIS, SCANNING, REPAIRED = "graphbody thesis", "graphbody thesis, full scan", "graphbody repaired"

Tables = Mapping[str, Table]
Rows = tuple[tuple[str, ...], ...]


@dataclass(frozen=True)
class Fact:
    """What was recorded of a row before this run, what this run has, and whether that is the same."""

    row: str
    recorded: str
    here: str
    same: bool


@dataclass(frozen=True)
class Finding:
    """What is found of a statement.

    Attributes:
        engine: what Box2D does.
        spec: what this specification does.
        text: more about it, in paragraphs.
        facts: what was recorded of it before.
        table: the header and rows of a table, if there is one.
        figure: the name of a figure, and what it shows.
    """

    statement: Evaluated
    judgement: Judgement
    engine: str
    spec: str
    text: tuple[str, ...]
    facts: tuple[Fact, ...] = ()
    table: Rows = ()
    figure: tuple[str, str] | None = None


def judged(holds: bool) -> Judgement:
    """Confirmed if it holds, else refuted."""
    return Judgement.CONFIRMED if holds else Judgement.REFUTED


def digits(value: float) -> str:
    """A number with two digits that count, and no exponent."""
    return f"{value:.0f}" if abs(value) >= 100 else f"{float(f'{value:.2g}'):.10f}".rstrip("0").rstrip(".")


def length(metres: float) -> str:
    """A length of two digits that count."""
    return f"{digits(metres * 1000)} mm" if abs(metres) < 0.0995 else f"{digits(metres)} m"


def most(lines: Iterable[Line], key: str) -> float:
    """The greatest of some numbers."""
    return max(number(line, key) for line in lines)


def least(lines: Iterable[Line], key: str) -> float:
    """The least of some numbers."""
    return min(number(line, key) for line in lines)
