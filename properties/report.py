"""What a run of the check shows: the table and the ledgers for people, results.json for machines."""

from __future__ import annotations

import platform
from collections.abc import Iterator, Sequence
from importlib.metadata import version
from pathlib import Path

from rich.console import Console
from rich.table import Table

from properties.evidence.ledger import MOST_SPREAD, evidence, feasible_looks, proofs_of, spread_of, tried_looks
from properties.evidence.sample import SEED
from properties.evidence.settle import Settled
from properties.evidence.showing import Job, Showing, Texts
from properties.evidence.sources import PACKAGES
from properties.results import ClaimResult, Ledger, Results
from reference.formats.files import write

COLOURS = {"proved": "green", "bounded": "cyan", "tested": "cyan", "refuted": "yellow", "unknown": "red"}


def environment() -> dict[str, str]:
    """What the run depended on."""
    versions = {package: version(package) for package in ("graphbody", *PACKAGES)}
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
        ledger=settled.ledger,
        evidence=[" ".join(job) for job in settled.jobs],
    )


def write_results(settled: Sequence[Settled], showings: dict[Job, Showing], sources: str, path: Path) -> None:
    """Write results.json, about these sources."""
    jobs = dict.fromkeys(job for one in settled for job in one.jobs)
    claims, shown = [result_of(one) for one in settled], [evidence(job, showings) for job in jobs]
    write(path, Results("graphbody/results@1", sources, environment(), claims, shown))


def ledger_lines(settled: Settled, showings: dict[Job, Showing]) -> Iterator[str]:
    """The ledger of a claim, as lines of text."""
    claim, own = settled.claim, settled.ledger
    yield f"{claim.id}: {settled.verdict}, by {settled.engine}; z3 {version('z3-solver')}"
    yield f"  conditions used: {listed(own.used)}"
    yield f"  conditions assumed, and not needed: {listed(own.unused)}"
    yield f"  conditions that no proof states: {listed(own.unstated)}"
    if claim.obligations:
        cover = "exhaustive" if own.exhaustive else "NOT exhaustive"
        yield f"  {own.paths} feasible paths, {cover}; {own.promises} promises judged"
        yield f"  rules fired: {listed(own.rules)}"
        yield from look_lines(settled, showings)
        yield from monitor_lines(own)
        yield f"  work of the solver: {own.resources}{differing(own.spread)}"
    yield f"  mutants: {mutant_line(own)}"
    for job in proofs_of(claim):
        yield from proof_lines(job, showings)


def mutant_line(own: Ledger) -> str:
    """How many mutants the evidence catches, as it is recorded."""
    if own.mutants is None:
        return "none are tried on what it rests on"
    found = f"its evidence catches {own.mutants}"
    return (
        f"{found}; of its own it catches none: by construction, as far as mutants tell"
        if own.by_construction
        else found
    )


def look_lines(settled: Settled, showings: dict[Job, Showing]) -> Iterator[str]:
    """How many of the looks on the paths of the proofs the random rows took, and which they did not."""
    own, claim = settled.ledger, settled.claim
    if own.looks and own.tried is not None:
        share = 100 * own.tried / own.looks
        yield f"  random rows took {own.tried} of {own.looks} looks (sequences from clearance to walk), {share:.0f} %"
        for look in sorted(feasible_looks(claim, showings) - tried_looks(claim, showings)):
            yield f"    not taken: {' '.join(look)}"


def monitor_lines(own: Ledger) -> Iterator[str]:
    """How often monitors evaluated the contracts that the proofs rest on."""
    if own.monitors:
        counts = ", ".join(f"{contract} {count}" for contract, count in own.monitors.items())
        yield f"  monitors of random rows evaluated: {counts}"


def proof_lines(job: Job, showings: dict[Job, Showing]) -> Iterator[str]:
    """What the proof of an obligation rests on."""
    one, again = showings[job], spread_of(job, showings)
    work = f"{one.resources[0] if one.resources else 0}{differing(again.spread if again else None)}"
    cover = "exhaustive" if one.exhaustive else "NOT exhaustive"
    yield f"  {job[2]}: {one.cases} paths, {cover}; {one.promises} promises; work {work}"
    yield f"    used: {listed(one.used)}"
    yield f"    not needed: {listed(one.unused)}"
    yield f"    all premises hold for: {'NO VALUES' if one.witness is None else valued(one.witness)}"


def listed(names: Sequence[str]) -> str:
    """Names in a row, or a dash."""
    return ", ".join(names) or "-"


def valued(values: Texts) -> str:
    """Values that are not 0 and not false, by name."""
    telling = {name: value for name, value in values.items() if value not in (False, "0")}
    return ", ".join(name if value is True else f"{name} = {value}" for name, value in telling.items()) or "all are 0"


def differing(spread: float | None) -> str:
    """By how much the work differs between seeds, if it was measured; a finding if that is much."""
    finding = "" if spread is None or spread < MOST_SPREAD else f", FINDING: {100 * MOST_SPREAD:.0f} % or more"
    return "" if spread is None else f", differs by {100 * spread:.0f} % between seeds{finding}"


def show_ledgers(settled: Sequence[Settled], showings: dict[Job, Showing], console: Console) -> None:
    """Print the ledger of each claim."""
    for one in settled:
        console.print()
        for line in ledger_lines(one, showings):
            console.print(line, markup=False, highlight=False, soft_wrap=True)


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
    spreads = [(showing.spread, job[2]) for job, showing in showings.items() if showing.spread is not None]
    if spreads:
        most, where = max(spreads)
        console.print(f"\n{len(spreads)} proofs with several seeds; most{differing(most)}: {where}", markup=False)
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
