"""Reading and writing documents: what every record is, how large a file may be, and errors of one line."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Annotated, Any, TypeVar

import msgspec
from msgspec import Meta, inspect

BYTE_ORDER_MARK = b"\xef\xbb\xbf"
MOST_BYTES = 64 * 2**20
MOST_ITEMS = 100_000
MOST_CHARACTERS = 100
MOST_SHOWN = 1000
WORD = "Invalid enum value "
PLACE = re.compile(r"(?P<problem>.*) - at `(?P<place>\$.*)`", re.DOTALL)

T = TypeVar("T")
Item = TypeVar("Item")


def says(text: str) -> Meta:
    """What a field means, with its unit; it stands in the schema and in the tables of docs/formats.md."""
    return Meta(description=text)


Name = Annotated[str, Meta(min_length=1, max_length=MOST_CHARACTERS)]
Many = Annotated[list[Item], Meta(max_length=MOST_ITEMS)]


class FormatError(ValueError):
    """A file that cannot be read; the message is one line that names the place and what is expected."""


class Record(msgspec.Struct, forbid_unknown_fields=True, omit_defaults=True, frozen=True):
    """What every object in a file is: its fields and no others."""


def one_line(text: str) -> str:
    """A text with whatever would break its line escaped, cut short if it is long."""
    shown = text if len(text) <= MOST_SHOWN else text[:MOST_SHOWN] + "…"
    return "".join(char if char.isprintable() else repr(char)[1:-1] for char in shown)


def decode(content: bytes, kind: type[T], where: str) -> T:
    """Decode one document; `where` names the file, and the line in it.

    Raises:
        FormatError: with the place in the document and what is expected there.
    """
    if not content.strip():
        raise FormatError(one_line(f"{where}: $: expected a JSON document, got nothing"))
    try:
        return msgspec.json.decode(content.removeprefix(BYTE_ORDER_MARK), type=kind)
    except msgspec.ValidationError as error:
        found = PLACE.fullmatch(str(error))
        place, problem = (found["place"], found["problem"]) if found else ("$", str(error))
        if problem.startswith(WORD):
            problem = f"expected {' or '.join(permitted(kind, place))}, got {problem.removeprefix(WORD)}"
        raise FormatError(one_line(f"{where}: {place}: {problem}")) from None
    except RecursionError:
        raise FormatError(one_line(f"{where}: $: expected arrays and objects that are nested less deeply")) from None
    except (msgspec.DecodeError, UnicodeError) as error:
        raise FormatError(one_line(f"{where}: not JSON: {in_lines(str(error), content)}")) from None


def permitted(kind: type[Any], place: str) -> list[str]:
    """The words that are permitted at a place in a document."""
    nodes = list(plain(inspect.type_info(kind)))
    for name, item in re.findall(r"\.(\w+)|(\[)", place):
        if item:
            nodes = [inner for node in nodes if isinstance(node, inspect.ListType) for inner in plain(node.item_type)]
        else:
            fields = [field for node in nodes if isinstance(node, inspect.StructType) for field in node.fields]
            nodes = [inner for field in fields if field.name == name for inner in plain(field.type)]
    return [str(word) for node in nodes if isinstance(node, inspect.LiteralType) for word in node.values]


def plain(node: inspect.Type) -> Iterator[inspect.Type]:
    """What a type may be, without what is said about it."""
    if isinstance(node, inspect.Metadata):
        yield from plain(node.type)
    elif isinstance(node, inspect.UnionType):
        for choice in node.types:
            yield from plain(choice)
    else:
        yield node


def in_lines(problem: str, content: bytes) -> str:
    """A problem with its place, which is given in bytes, as a line and a column."""
    found = re.search(r"\(byte (\d+)\)", problem)
    if found is None:
        return problem
    before = content[: int(found[1])]
    line, column = before.count(b"\n") + 1, len(before) - before.rfind(b"\n")
    return f"{problem[: found.start()]}(line {line}, column {column})"


def read(path: Path, kind: type[T]) -> T:
    """Decode a file.

    Raises:
        FormatError: with the file, the place in it and what is expected there.
    """
    lines = list(pieces(path, whole=True))
    return decode(lines[0] if lines else b"", kind, str(path))


def pieces(path: Path, whole: bool = False) -> Iterator[bytes]:
    """The lines of a file one after another, or all of it at once; never more of it than a document may have.

    Raises:
        FormatError: if it cannot be read, or if a document in it is too large.
    """
    try:
        with path.open("rb") as file:
            while piece := (file.read if whole else file.readline)(MOST_BYTES + 1):
                if len(piece) > MOST_BYTES:
                    raise FormatError(f"{path}: $: expected at most {MOST_BYTES} bytes")
                yield piece
    except OSError as error:
        raise FormatError(one_line(f"{path}: {error.strerror}")) from None
    except ValueError as error:
        if isinstance(error, FormatError):
            raise
        raise FormatError(one_line(f"{path}: {error}")) from None


def write(path: Path, record: msgspec.Struct) -> None:
    """Write a record as readable JSON, without fields that hold their default."""
    write_whole(path, msgspec.json.format(msgspec.json.encode(record), indent=2) + b"\n")


def write_whole(path: Path, content: bytes) -> None:
    """Write a file: who reads it sees all of it, or what was there before, also if this is interrupted."""
    path.parent.mkdir(parents=True, exist_ok=True)
    partial = path.with_name(f"{path.name}.{os.getpid()}")
    partial.write_bytes(content)
    partial.replace(path)
