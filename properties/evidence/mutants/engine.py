"""The mutants of the engine: each must make one of the engine's own tests fail.

A test fails if an assertion of it does, or if the engine itself says that it cannot vouch for its run. A test that
crashes otherwise, or does not end, catches nothing.
"""

from __future__ import annotations

import contextlib
import io
from functools import cache
from pathlib import Path
from typing import Any

from properties.evidence.mutants.mutant import Mutant, mutants_of, told_apart
from properties.evidence.mutants.trial import CRASHING, DoesNotEnd, ended

ENGINE = (
    "properties.engine.explore",
    "properties.engine.formulas",
    "properties.engine.reals",
    "properties.engine.rounded",
    "properties.engine.simplest",
    "properties.engine.timed",
)
TESTS = Path("tests/test_engine.py")
TELLING = ("AssertionError", "EngineError", "Failed")


@cache
def of_engine() -> dict[str, Mutant]:
    """All mutants of the engine, by name."""
    return told_apart([mutant for module in ENGINE for mutant in mutants_of(module)])


class Failures:
    """A plugin of pytest that notes the tests that fail, and by which exception."""

    def __init__(self) -> None:
        self.found: dict[str, str] = {}

    def pytest_runtest_makereport(self, item: Any, call: Any) -> None:
        """Note a test that fails; one that tells is enough."""
        if call.excinfo is not None:
            self.found[item.name] = call.excinfo.typename
            if call.excinfo.typename in TELLING:
                item.session.shouldfail = "a test tells"


def failed_tests(*chosen: str) -> tuple[str, ...]:
    """The first of the engine's tests that fails by what it says, of those chosen, or of all."""
    return tuple(name for name, kind in outcomes(*chosen).items() if kind in TELLING)


def crashing_tests(mutant: Mutant) -> str | None:
    """That a test crashes with a mutant in place."""
    with mutant.in_place():
        crashed = [f"{CRASHING}: {name}, {kind}" for name, kind in outcomes().items()]
    return crashed[0] if crashed else None


def outcomes(*chosen: str) -> dict[str, str]:
    """The tests that fail, of those chosen, or of all if none are, each by which exception."""
    import pytest

    failures = Failures()
    tests = [f"{TESTS}::{name}" for name in chosen] or [str(TESTS)]
    quietly = contextlib.redirect_stdout(io.StringIO())
    with quietly, contextlib.redirect_stderr(io.StringIO()), contextlib.suppress(DoesNotEnd), ended():
        status = pytest.main([*tests, "-q", "-p", "no:cacheprovider", "-p", "no:xdist", "--tb=no"], plugins=[failures])
        if status is pytest.ExitCode.INTERRUPTED:
            failures.found["the tests"] = "they do not end"
    return failures.found
