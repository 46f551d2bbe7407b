"""The data of a run as CSV: each line says first what was run, by which engine, and by which version of it."""

from __future__ import annotations

import csv
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

DECIMALS = 6
WORDS = ("run", "engine", "version", "guess", "counted")
"""The columns that hold words; all others hold numbers."""

Line = Mapping[str, str | float]


class Engine(NamedTuple):
    """What has moved the bodies, and its version."""

    name: str
    version: str

    def line(self, run: str, **values: str | float) -> Line:
        """A line of a table about a run of it."""
        return {"run": run, "engine": self.name, "version": self.version, **values}


@dataclass(frozen=True)
class Table:
    """A table of a run, by the name of its file."""

    name: str
    lines: Sequence[Line]

    def of(self, engine: str) -> list[Line]:
        """The lines about one engine."""
        return [line for line in self.lines if line["engine"] == engine]

    def write(self, directory: Path) -> None:
        """Write it as CSV."""
        with (directory / f"{self.name}.csv").open("w", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(self.lines[0])
            writer.writerows([text(value) for value in line.values()] for line in self.lines)


def read(directory: Path, name: str) -> Table:
    """Read a table; what looks like a number is one."""
    with (directory / f"{name}.csv").open(newline="") as file:
        lines = [{key: value_of(key, item) for key, item in line.items()} for line in csv.DictReader(file)]
    return Table(name, lines)


def value_of(key: str, item: str) -> str | float:
    """A value from its text."""
    return item if key in WORDS else float(item)


def text(value: str | float) -> str:
    """A value as text, in at most six decimals."""
    return value if isinstance(value, str) else f"{round(value, DECIMALS) + 0:.{DECIMALS}f}".rstrip("0").rstrip(".")


def number(line: Line, key: str) -> float:
    """A number of a line."""
    return float(line[key])


def joined(tables: Iterable[Table]) -> list[Table]:
    """Tables of the same name as one."""
    lines: dict[str, list[Line]] = {}
    for table in tables:
        lines.setdefault(table.name, []).extend(table.lines)
    return [Table(name, those) for name, those in lines.items()]


def by(lines: Iterable[Line], *keys: str) -> dict[tuple[float, ...], Line]:
    """Lines by the numbers that tell them apart."""
    return {tuple(number(line, key) for key in keys): line for line in lines}


NAMES = ("slope", "flat", "ends", "rest", "differences", "gravity", "wall", "constant", "row", "scene", "times")


def read_all(directory: Path) -> dict[str, Table]:
    """All tables of a run."""
    return {name: read(directory, name) for name in NAMES}
