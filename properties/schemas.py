"""The JSON Schemas of the formats, made from the records that read and write them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import msgspec

from properties.conformance.record import ValidationRecord
from properties.lint.record import LintRecord
from properties.results import Results
from reference.formats.level import LevelRecord
from reference.formats.scenario import ScenarioRecord
from reference.formats.trace import HeaderRecord, LineRecord

DIALECT = "https://json-schema.org/draft/2020-12/schema"


@dataclass(frozen=True)
class Kind:
    """A kind of file: what it is, in a sentence, and what a document in it may be."""

    sentence: str
    documents: tuple[type[msgspec.Struct], ...]


KINDS = {
    "level": Kind("a graph, the bodies where they start, and the goal", (LevelRecord,)),
    "scenario": Kind("a level, and what is asked of its bodies, step by step", (ScenarioRecord,)),
    "trace": Kind(
        "JSON lines: a header with the level, then each step with the state after it", (HeaderRecord, LineRecord)
    ),
    "validation": Kind("what `graphbody validate --json` found in a trace, one line each", (ValidationRecord,)),
    "lint": Kind("what `graphbody lint --json` found in a level", (LintRecord,)),
    "results": Kind("what a run of the check showed, claim by claim", (Results,)),
}


def schema(name: str) -> dict[str, Any]:
    """The JSON Schema of a document of a kind; that of a trace is the schema of one line."""
    kind = KINDS[name]
    documents, records = msgspec.json.schema_components(kind.documents, ref_template="#/$defs/{name}")
    top = documents[0] if len(documents) == 1 else {"anyOf": list(documents)}
    whole = {"$schema": DIALECT, "title": f"graphbody {name}", "description": kind.sentence, **top, "$defs": records}
    return tidied(whole)  # type: ignore[no-any-return]


def tidied(node: Any) -> Any:
    """A schema without what only Python means: names of classes, and how docstrings are laid out."""
    if isinstance(node, list):
        return [tidied(item) for item in node]
    if not isinstance(node, dict):
        return node.removesuffix("Record") if isinstance(node, str) else node
    tidy = {key.removesuffix("Record"): tidied(value) for key, value in node.items()}
    if isinstance(tidy.get("description"), str):
        tidy["description"] = " ".join(tidy["description"].split())
    if len(tidy.get("enum", ())) == 1:
        tidy["const"] = tidy.pop("enum")[0]
    return tidy
