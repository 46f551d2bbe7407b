"""What has been shown already, on disk, one file for each job: an interrupted run goes on from there.

A result is stored with the hash of the sources that it is about. It is never given out for others.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Any, Generic, TypeVar
from urllib.parse import quote

import msgspec

from properties.evidence.showing import Job
from properties.evidence.sources import sources
from reference.formats.files import write_whole

Result = TypeVar("Result")


class Stored(msgspec.Struct, frozen=True):
    """A result, what it is the result of, and the sources that it is about."""

    job: Job
    sources: str
    showing: msgspec.Raw


@dataclass(frozen=True)
class Store(Generic[Result]):
    """A directory of results of one kind, and the sources that are current."""

    directory: Path
    sources: str
    kind: type[Result]

    def path(self, job: Job) -> Path:
        """Where the result of a job is."""
        return self.directory / f"{quote('|'.join(job), safe=' |(),')}.json".replace("|", "+")

    def get(self, job: Job) -> Result | None:
        """The result of a job, if there is one and it is about the current sources."""
        try:
            found = msgspec.json.decode(self.path(job).read_bytes(), type=Stored)
            if found.sources != self.sources or found.job != job:
                return None
            return msgspec.json.decode(found.showing, type=self.kind, dec_hook=from_text)
        except (OSError, msgspec.DecodeError):
            return None

    def current(self, jobs: Iterable[Job]) -> dict[Job, Result]:
        """The results of those jobs that have one."""
        return {job: found for job in jobs if (found := self.get(job)) is not None}

    def put(self, job: Job, showing: Result) -> None:
        """Keep a result, also if it is interrupted: all of it, or what was there before."""
        shown = msgspec.Raw(msgspec.json.encode(showing, enc_hook=str))
        write_whole(self.path(job), msgspec.json.encode(Stored(job, self.sources, shown)))

    def run(self, job: Job, evidence: Callable[[], Result]) -> Result:
        """Run a job and keep what it showed, unless the sources have changed since the run began."""
        showing = evidence()
        if sources() == self.sources:
            self.put(job, showing)
        return showing


def from_text(kind: type[Any], text: Any) -> Any:
    """A fraction, from its text."""
    assert kind is Fraction
    return Fraction(text)
