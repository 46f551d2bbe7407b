"""What the documents have from the code: the tables of fields in docs/formats.md."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from properties.schemas import KINDS, schema

BEGIN = "<!-- tables: made from the schemas -->\n"
END = "<!-- tables: end -->\n"
SIMPLE = {"string": "text", "boolean": "true or false", "integer": "whole number", "number": "number"}


def with_tables(page: str) -> str:
    """A page with the tables between its two marks made anew."""
    return with_part(page, BEGIN, formats_tables(), END)


def with_part(page: str, begin: str, part: str, end: str) -> str:
    """A page with what stands between two marks made anew."""
    before, _, rest = page.partition(begin)
    _, found, after = rest.partition(end)
    assert found, "the page has no place for the tables"
    return before + begin + part + end + after


def formats_tables() -> str:
    """A table of the fields of every record, in the order in which the kinds of files use them."""
    told: set[str] = set()
    return "".join(lines for kind in KINDS for lines in tables_of(kind, told))


def tables_of(kind: str, told: set[str]) -> Iterator[str]:
    """The tables of the records of a kind that have not been told of before."""
    records = schema(kind)["$defs"]
    waiting = [ref["$ref"] for ref in schema(kind).get("anyOf", [schema(kind)])]
    while waiting:
        name = waiting.pop(0).rpartition("/")[2]
        if name not in told:
            told.add(name)
            yield f"\n### {name}\n\n{table(records[name])}"
            waiting = list(references(records[name])) + waiting


def references(node: Any) -> Iterator[str]:
    """The records that a part of a schema refers to."""
    if isinstance(node, dict):
        if "$ref" in node:
            yield node["$ref"]
        for value in node.values():
            yield from references(value)
    if isinstance(node, list):
        for item in node:
            yield from references(item)


def table(record: dict[str, Any]) -> str:
    """What a record is, and its fields: name, kind of value, what holds if it is left out, meaning."""
    if "properties" not in record:
        return f"{record['description']}\n\n{value(record)}.\n"
    rows = ["| field | value | if left out | meaning |", "|---|---|---|---|"]
    for name, field in record["properties"].items():
        without = "needed" if name in record["required"] else default(field)
        rows.append(f"| `{name}` | {value(field)} | {without} | {field['description']} |")
    return "\n".join([record["description"], "", *rows, ""])


def default(field: dict[str, Any]) -> str:
    """What holds if a field is left out."""
    given = field["default"]
    return "" if given is None or given in ([], "") else f"`{given}`" if isinstance(given, str) else str(given).lower()


def value(node: dict[str, Any]) -> str:
    """In words, what a field may hold."""
    if "const" in node or "enum" in node:
        return " or ".join(f'`"{one}"`' for one in node.get("enum", [node.get("const")]))
    if "$ref" in node:
        name = node["$ref"].rpartition("/")[2]
        return f"[{name}](#{name.lower()})"
    if "anyOf" in node:
        return among(node["anyOf"])
    if "prefixItems" in node:
        return f"pair ({', '.join(map(value, node['prefixItems']))})"
    if node["type"] == "array":
        return f"list of {value(node['items'])}"
    if node["type"] == "object":
        return f"object with values: {value(node['additionalProperties'])}"
    return SIMPLE[str(node["type"])]


def among(choices: list[dict[str, Any]]) -> str:
    """In words, a choice of values; a number is a choice of its own ways to be written."""
    if any("pattern" in choice for choice in choices):
        return "number"
    return " or ".join(value(choice) for choice in choices if choice.get("type") != "null")
