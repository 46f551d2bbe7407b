"""What a result is about: the sources and the packages that it depends on, as one hash."""

from __future__ import annotations

import platform
from collections.abc import Iterator
from hashlib import sha256
from importlib.metadata import version
from pathlib import Path

import properties
import reference
import spec

PACKAGES = ("z3-solver", "hypothesis", "numpy", "msgspec")
KINDS = (".py", ".json")


def source_files() -> Iterator[Path]:
    """All code of the three packages, and all levels and scenarios, in a fixed order."""
    for package in (spec, reference, properties):
        for root in package.__path__:
            yield from (path for path in sorted(Path(root).rglob("*")) if path.suffix in KINDS)


def sources() -> str:
    """The hash of all sources as they are now, of Python and of the packages whose versions may decide a result."""
    pins = [f"python {platform.python_version()}", *(f"{package} {version(package)}" for package in PACKAGES)]
    parts = [pin.encode() for pin in pins]
    for path in source_files():
        parts += [path.name.encode(), path.read_bytes()]
    return sha256(b"".join(sha256(part).digest() for part in parts)).hexdigest()
