"""Drawings as files: a page of six panels in each, named after the file that they are drawn from."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import islice
from pathlib import Path

from reference.draw import BadLine, chosen, pages
from reference.formats.files import FormatError, one_line
from reference.recording import recording

TO_A_PAGE = 6
MOST_PAGES = 1000
STEPS = re.compile(r"([0-9]{1,9})(?:-([0-9]{1,9}))?")


class Undrawable(ValueError):
    """What cannot be drawn, or not written; the message is one line."""


def drawn(file: Path, out: Path, steps: str) -> Iterator[Path]:
    """Draw a file, page by page, and name each page as it is written; nothing is if not all can be drawn.

    Raises:
        Undrawable: if the file cannot be drawn, or is too long, or the pages cannot be written.
    """
    first, last = range_of(steps)
    count = panels(file, first, last)
    names = [f"{file.stem}.svg"] if count <= TO_A_PAGE else [f"{file.stem}-{i}.svg" for i in range(1, MOST_PAGES + 1)]
    for name, page in zip(names, pages(recording(file), TO_A_PAGE, first, last), strict=False):
        save(out / name, page)
        yield out / name


def range_of(steps: str) -> tuple[int, int | None]:
    """The first and the last step to draw; all if nothing is said."""
    if not steps:
        return 0, None
    found = STEPS.fullmatch(steps)
    first, last = (int(found[1]), int(found[2] or found[1])) if found else (1, 0)
    if last < first:
        raise Undrawable(one_line(f"--steps: expected A-B, as in 3-8, got {steps!r}"))
    return first, last


def panels(file: Path, first: int, last: int | None) -> int:
    """How many panels there are to draw, all of which can be drawn."""
    try:
        count = sum(1 for _ in islice(chosen(recording(file), first, last), MOST_PAGES * TO_A_PAGE + 1))
    except FormatError as error:
        raise Undrawable(str(error)) from None
    except BadLine as error:
        raise Undrawable(one_line(f"{file}:{error}")) from None
    if count > MOST_PAGES * TO_A_PAGE:
        raise Undrawable(one_line(f"{file}: more than {MOST_PAGES} pages; choose some of its steps with --steps A-B"))
    if not count:
        raise Undrawable(one_line(f"{file}: it has fewer than {first} steps"))
    return count


def save(path: Path, page: str) -> None:
    """Write a page, whole or not at all."""
    part = path.with_name(f"{path.name}.part")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        part.write_text(page, encoding="utf-8")
        part.replace(path)
    except OSError as error:
        if part.is_file():
            part.unlink()
        raise Undrawable(one_line(f"{path}: {error.strerror}")) from None
