"""Every exploration of a run as a file in SMT-LIB 2, for another solver; and a list of what must be there.

Files are written by the process that explores, from the very formulas it met. The list is written from the verdicts of
the run, so that a file that is missing, or that says another thing than the run did, is noticed.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from properties.engine.explore import Exploration, watched_by
from properties.engine.smtlib import script_of
from properties.evidence.files import LISTED
from properties.evidence.hunt import in_order
from properties.evidence.settle import by_id
from properties.evidence.showing import Job, Showing

EXPLORING = ("prove", "refute", "hunt")


class Unwritable(Exception):
    """The directory of an export is in use."""


@dataclass
class Recorder:
    """Writes the explorations that it is shown; `only_broken` leaves out those without a counterexample."""

    directory: Path
    stem: str
    many: bool = False
    only_broken: bool = False
    shown: int = 0

    def __call__(self, exploration: Exploration) -> None:
        """Write an exploration, to a file that was not there."""
        if self.only_broken and exploration.outcome.counterexample is None:
            return
        self.shown += 1
        name = numbered(self.stem, self.shown) if self.many else self.stem
        with (self.directory / f"{name}.smt2").open("x") as file:
            file.write(script_of(exploration, name))


def stem_of(job: Iterable[str]) -> str:
    """The name of the file of a job, in plain characters."""
    return re.sub(r"[^a-z0-9]+", "-", " ".join(job).replace("claim/", "")).strip("-")


def numbered(stem: str, number: int) -> str:
    """The name of one file of many."""
    return f"{stem}-{number:03}"


def prepare(directory: Path) -> None:
    """Make a directory in which nothing is that could be taken for part of the export."""
    if directory.exists() and (not directory.is_dir() or any(directory.iterdir())):
        raise Unwritable(f"{directory}: expected a directory that is empty or not there yet, to export to")
    directory.mkdir(parents=True, exist_ok=True)


def exported(directory: Path, jobs: Mapping[Job, Callable[[], Showing]]) -> dict[Job, Callable[[], Showing]]:
    """The same jobs; those that explore write what they explored."""
    return {
        job: partial(recording, directory, job, task) if job[0] in EXPLORING else task for job, task in jobs.items()
    }


def recording(directory: Path, job: Job, task: Callable[[], Showing]) -> Showing:
    """Run a job, and write what it explored."""
    with watched_by(Recorder(directory, stem_of(job), many=job[0] == "hunt")):
        return task()


def expected(job: Job, showing: Showing, seed: int) -> dict[str, str]:
    """The files of a job, and what is to be answered of each: what a hunt went through, one after another."""
    last = "sat" if showing.failures else "unknown" if showing.open else "unsat"
    if job[0] != "hunt":
        return {f"{stem_of(job)}.smt2": last}
    hunt = by_id(job[1]).hunt
    assert hunt is not None
    order = in_order(hunt, seed)
    gone_through = len(order) if showing.shape is None else order.index(showing.shape) + 1
    files = [f"{numbered(stem_of(job), i + 1)}.smt2" for i in range(gone_through)]
    return dict.fromkeys(files, "unsat") | {files[-1]: last}


def list_export(directory: Path, showings: Mapping[Job, Showing], seed: int) -> int:
    """Write the list of what a run must have exported; return how many files that are."""
    files: dict[str, str] = {}
    for job, showing in showings.items():
        if job[0] in EXPLORING:
            files |= expected(job, showing, seed)
    return write_list(directory, files)


def write_list(directory: Path, files: Mapping[str, str]) -> int:
    """Write the list of an export: for each file what is to be answered; return how many there are."""
    (directory / LISTED).write_text(json.dumps(dict(sorted(files.items())), indent=1) + "\n")
    return len(files)
