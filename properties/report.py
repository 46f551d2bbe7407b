"""What a run of the check shows: the table for people, results.json for machines."""

from __future__ import annotations

import platform
from collections.abc import Sequence
from importlib.metadata import version
from pathlib import Path

from rich.console import Console
from rich.table import Table

from properties.evidence.sample import SEED
from properties.evidence.settle import Job, Settled, Showing
from properties.results import ClaimResult, Results
from reference.formats.files import write

COLOURS = {"proved": "green", "bounded": "cyan", "tested": "cyan", "refuted": "yellow", "unknown": "red"}


def environment() -> dict[str, str]:
    """What the run depended on."""
    packages = ("graphbody", "z3-solver", "hypothesis", "numpy", "msgspec")
    versions = {package: version(package) for package in packages}
    return {"python": platform.python_version(), "system": platform.system(), "seed": str(SEED), **versions}


def result_of(settled: Settled) -> ClaimResult:
    """A settled claim as it stands in results.json."""
    claim = settled.claim
    return ClaimResult(
        id=claim.id,
        family=claim.family,
        profile=claim.profile.name,
        premises=list(claim.premises),
        expected=claim.expected,
        verdict=settled.verdict,
        bodies=settled.bodies,
        cases=settled.cases,
        engine=settled.engine,
        seconds=round(settled.seconds, 3),
        witness=None if settled.witness is None else str(settled.witness),
    )


def write_results(settled: Sequence[Settled], path: Path) -> None:
    """Write results.json."""
    write(path, Results("graphbody/results@1", environment(), [result_of(one) for one in settled]))


def show_table(settled: Sequence[Settled], console: Console) -> None:
    """Print the table of claims: what is claimed, what was expected, what was shown, and how."""
    table = Table(box=None, header_style="bold", pad_edge=False)
    for heading, right in (
        ("claim", False),
        ("profile", False),
        ("expected", False),
        ("verdict", False),
        ("engine", False),
        ("bodies", True),
        ("cases", True),
        ("time", True),
    ):
        table.add_column(heading, justify="right" if right else "left", no_wrap=True)
    for one in settled:
        colour = COLOURS[one.verdict] if one.as_expected else "bold red"
        table.add_row(
            one.claim.id.removeprefix("claim/"),
            one.claim.profile.name,
            one.claim.expected.value,
            f"[{colour}]{one.verdict.value}[/]",
            one.engine,
            str(one.bodies) if one.bodies else ("any" if one.verdict == "proved" else ""),
            str(one.cases),
            f"{one.seconds:.1f} s",
        )
    console.print(table)


def show_effort(showings: dict[Job, Showing], console: Console) -> None:
    """Print what the random trials were like, and what the solver cost."""
    for job, showing in showings.items():
        if showing.shares:
            kind = "floats" if job[-1] == "True" else "exact numbers"
            shares = ", ".join(
                f"{name} {100 * share:.0f} % ({100 * low:.0f})" for name, (share, low) in showing.shares.items()
            )
            console.print(f"\n{showing.cases} random rows in {kind}, shares (and floors): {shares}", markup=False)
    solved = [showing.seconds for showing in showings.values() if showing.engine == "z3"]
    console.print(f"\n{len(solved)} explorations with z3: {sum(solved):.1f} s; evidence is shared between claims")


def show_surprises(settled: Sequence[Settled], console: Console) -> None:
    """Print, for each claim whose verdict is not the expected one, why."""
    for one in settled:
        if not one.as_expected:
            console.print(f"\n{one.claim.id}: expected {one.claim.expected}, got {one.verdict}", style="bold red")
            console.print(f"  {one.claim.sentence}", markup=False)
            for reason in one.reasons:
                console.print(f"  {reason}", markup=False)
            console.print(f"  again: graphbody check {one.claim.id}", markup=False)
