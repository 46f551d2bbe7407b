"""The map as files: what the parts have found out, their witnesses with pictures, and the page that shows it all."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from shutil import rmtree
from typing import Any

import msgspec

from properties.evidence.showing import Job
from properties.map import cases, errata, features, readings, theorem
from properties.map.part import Finding, Findings, Part
from reference.draw import strip
from reference.formats.files import FormatError, pieces, read, write, write_whole
from reference.formats.scenario import ScenarioRecord
from reference.recording import recording

PARTS: tuple[Part, ...] = (theorem.PART, cases.PART, errata.PART, features.PART, readings.PART)
DOCS = Path("docs")
MADE = "Made by `make map`. `make check` plays its witnesses again, and does not search again where there are none."
ABOUT = """\
The thesis gives guidelines for levels and says that they "cannot guarantee that there are no complications". This page
says what they do guarantee, what else is needed, and what goes wrong without. A cell is a witness, which is a scenario
that `graphbody simulate` plays; or a claim, of which [claims.md](reference/claims.md) has the verdict; or *bounded*: in
every level of the shapes that are named, whatever the sizes, `make map` has found no witness. That is not every level.
"""


def map_jobs() -> dict[Job, Callable[[], Finding]]:
    """All that is to be found out, part by part."""
    return {("map", part.name, name): job for part in PARTS for name, job in part.jobs().items()}


def findings_of(part: Part, found: Mapping[Job, Finding]) -> Findings:
    """What the jobs of a part have found out."""
    return {name: found["map", part.name, name] for name in part.jobs()}


def write_map(found: Mapping[Job, Finding], docs: Path = DOCS) -> None:
    """Write the page, and anew the directory with findings, witnesses and pictures."""
    to = docs / "map"
    rmtree(to, ignore_errors=True)
    page = ["# The map", "", ABOUT, MADE]
    for part in PARTS:
        findings = findings_of(part, found)
        write_json(to / f"{part.name}.json", findings)
        for name, scenario in part.witnesses(findings).items():
            write_witness(to, name, scenario)
        page += ["", f"## {part.title}", "", *part.section(findings)]
    write_whole(docs / "map.md", ("\n".join(page) + "\n").encode())


def write_witness(to: Path, name: str, scenario: Any) -> None:
    """Write a witness and its picture."""
    path = to / "witnesses" / f"{name}.json"
    # Through JSON, so that a file does not depend on which equal strings are one object: that decides what is left out.
    write(path, msgspec.json.decode(msgspec.json.encode(scenario), type=ScenarioRecord))
    write_whole(to / "pictures" / f"{name}.svg", strip(recording(path), 0).encode())


def write_json(path: Path, content: Any) -> None:
    """Write plain data so that it can be read, and compared line by line."""
    write_whole(path, msgspec.json.format(msgspec.json.encode(content), indent=2) + b"\n")


def read_findings(part: Part, docs: Path = DOCS) -> Findings:
    """What was found out and written.

    Raises:
        FormatError: if it cannot be read.
    """
    path = docs / "map" / f"{part.name}.json"
    content = b"".join(pieces(path, whole=True))
    try:
        return msgspec.json.decode(content, type=dict[str, Any])
    except msgspec.DecodeError as error:
        raise FormatError(f"{path}: expected what `make map` writes: {error}") from None


def wrong_on_the_map(docs: Path = DOCS) -> Iterator[str]:
    """What of the map does not hold when it is looked at again: findings, witnesses, pictures and the page."""
    page = (docs / "map.md").read_text() if (docs / "map.md").exists() else ""
    for part in PARTS:
        findings = read_findings(part, docs)
        yield from (f"{part.name}: {problem}" for problem in part.broken(findings))
        if "\n".join(part.section(findings)) not in page:
            yield f"{docs / 'map.md'}: expected what {part.name}.json says; run `make map`"
        for name, scenario in part.witnesses(findings).items():
            yield from stale(docs / "map", name, scenario)


def stale(to: Path, name: str, scenario: Any) -> Iterator[str]:
    """What of a witness is missing, or not as it was found, or drawn by another version."""
    path, picture = to / "witnesses" / f"{name}.json", to / "pictures" / f"{name}.svg"
    if not path.exists() or read(path, ScenarioRecord) != msgspec.convert(scenario, ScenarioRecord):
        yield f"{path}: expected the witness that was found; run `make map`"
    elif not picture.exists() or picture.read_text() != strip(recording(path), 0):
        yield f"{picture}: expected the drawing of its witness; run `make map`"
