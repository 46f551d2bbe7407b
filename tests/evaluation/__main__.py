"""`python -m evaluation`: run all anew and write docs/evaluation.md with its data and figures.

`python -m evaluation check` runs all but the times, writes nothing, and fails if anything differs from what is there.
"""

from __future__ import annotations

import sys
from pathlib import Path
from tempfile import TemporaryDirectory

from evaluation.figures import draw
from evaluation.measure import measured
from evaluation.page import page
from evaluation.tables import Table, read, read_all
from evaluation.timing import times

DOCS = Path(__file__).parents[2] / "docs"
DATA, PAGE = DOCS / "evaluation", DOCS / "evaluation.md"


def write(tables: list[Table], data: Path, document: Path) -> None:
    """Write data, figures and page."""
    data.mkdir(exist_ok=True)
    for table in tables:
        table.write(data)
    written = read_all(data)
    draw(written, data)
    document.write_text(page(written))


def stale() -> list[Path]:
    """What differs from a new run, but for the times, which are taken over."""
    with TemporaryDirectory() as directory:
        data, document = Path(directory) / DATA.name, Path(directory) / PAGE.name
        write([*measured(), read(DATA, "times")], data, document)
        pairs = [(document, PAGE), *((path, DATA / path.name) for path in sorted(data.iterdir()))]
        return [old for new, old in pairs if not old.exists() or old.read_bytes() != new.read_bytes()]


def main(arguments: list[str]) -> int:
    """Run, or check; the exit status."""
    if arguments not in ([], ["check"]):
        print(f"evaluation: expected nothing or check, got {' '.join(arguments)}", file=sys.stderr)
        return 2
    if not arguments:
        write([*measured(), times()], DATA, PAGE)
        print(f"{PAGE.relative_to(DOCS.parent)}, and its data and figures in {DATA.relative_to(DOCS.parent)}")
        return 0
    differing = stale()
    for path in differing:
        print(f"{path.relative_to(DOCS.parent)}: differs from a new run; `make evaluation` writes it anew")
    return 1 if differing else 0


sys.exit(main(sys.argv[1:]))
