"""The record of what catches each mutant: files of the project, so that no kill is lost unnoticed.

It says, for each mutant, what catches it and at which exact values; for each claim, what it rests on; for each
obligation, what it assumes. `make mutants` tries all of it again, on the sources as they are.
"""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from shutil import rmtree
from typing import Any

from properties.evidence.mutants.trial import Kill

RECORD = Path("docs/mutants")
Kills = dict[str, tuple[Kill, ...]]


@dataclass(frozen=True)
class Record:
    """What was found of all mutants.

    Attributes:
        claims: what each claim rests on.
        premises: the names of what each obligation assumes.
        kills: for each group of mutants, what catches each of them; empty for one that survives.
        equal: the mutants that survive, and are shown to say the same, with what shows it.
    """

    claims: dict[str, tuple[str, ...]]
    premises: dict[str, tuple[str, ...]]
    kills: dict[str, Kills] = field(default_factory=dict)
    equal: dict[str, str] = field(default_factory=dict)

    def survivors(self) -> Iterator[str]:
        """The mutants that nothing catches, and nothing shows to say the same."""
        for kills in self.kills.values():
            yield from (name for name, found in kills.items() if not found and name not in self.equal)


def as_lines(table: Mapping[str, Any]) -> str:
    """A table as JSON, a line for each entry."""
    lines = (f" {json.dumps(name)}: {json.dumps(value)}" for name, value in table.items())
    return "{\n" + ",\n".join(lines) + "\n}"


def plain(kill: Kill) -> dict[str, Any]:
    """A kill as it is written: what is empty, 0 or false is left out."""
    values = {name: value for name, value in kill.values.items() if value not in (False, "0")}
    told = {"by": kill.by, "on": kill.on, "broken": kill.broken, "values": values}
    return {name: value for name, value in told.items() if value}


def write_record(record: Record, directory: Path = RECORD) -> None:
    """Write a record anew: a file for each group of mutants, and for all else."""
    parts: dict[str, Mapping[str, Any]] = {"claims": record.claims, "premises": record.premises}
    for group, table in record.kills.items():
        parts[group] = {name: [plain(kill) for kill in found] for name, found in table.items()}
    parts["equal"] = record.equal
    rmtree(directory, ignore_errors=True)
    directory.mkdir(parents=True)
    for name, part in parts.items():
        (directory / f"{name}.json").write_text(f"{as_lines(part)}\n")


def read_record(directory: Path = RECORD) -> Record:
    """Read a record; nothing is recorded where there is none."""
    if not directory.exists():
        return Record({}, {})
    parts = {path.stem: json.loads(path.read_text()) for path in sorted(directory.glob("*.json"))}
    claims, premises = (
        {name: tuple(said) for name, said in parts.pop(part).items()} for part in ("claims", "premises")
    )
    equal = parts.pop("equal")
    kills = {group: {name: read_kills(found) for name, found in table.items()} for group, table in parts.items()}
    return Record(claims, premises, kills, equal)


def read_kills(found: list[dict[str, Any]]) -> tuple[Kill, ...]:
    """The kills of a mutant, as they were written."""
    return tuple(
        Kill(one["by"], tuple(one.get("broken", ())), one.get("values", {}), one.get("on", "")) for one in found
    )


def columns(record: Record) -> dict[tuple[str, ...], list[str]]:
    """The claims by what they rest on: those that rest on the same catch the same."""
    found: dict[tuple[str, ...], list[str]] = {}
    for claim, evidence in record.claims.items():
        found.setdefault(evidence, []).append(claim.removeprefix("claim/"))
    return {evidence: claims for evidence, claims in found.items() if evidence}


def by_construction(record: Record) -> dict[str, str]:
    """The claims that catch no mutant, or none by what they alone rest on, and which evidence that is."""
    catching = {kill.by for table in record.kills.values() for kills in table.values() for kill in kills}
    rests = Counter(one for evidence in columns(record) for one in evidence)
    found = {}
    for evidence, claims in columns(record).items():
        own = [one for one in evidence if rests[one] == 1]
        if not catching & set(own or evidence):
            why = f"{', '.join(own) if own else 'all that it rests on'} catches no mutant"
            found.update(dict.fromkeys(claims, why))
    return found


def number_caught(record: Record, claim: str) -> int | None:
    """How many mutants the evidence of a claim catches; None if none are tried on it."""
    mine = set(record.claims.get(claim, ()))
    tables = record.kills.values()
    found = sum(any(kill.by in mine for kill in kills) for table in tables for kills in table.values())
    return found if mine else None
