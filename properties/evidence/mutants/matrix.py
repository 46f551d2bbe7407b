"""The matrix of mutants: how many mutants of each rule each claim catches; and the page that says so."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from itertools import count
from pathlib import Path

from rich.console import Console
from rich.table import Table

from properties.evidence.mutants.argued import CHANGES_NO_ANSWER
from properties.evidence.mutants.record import Record, by_construction, columns
from properties.evidence.mutants.trial import CRASHING, SAME

PAGE = Path("docs/mutants.md")


def subject_of(mutant: str) -> str:
    """What a mutant is one of: the ID of a rule, or the name of a function."""
    return mutant.partition(": ")[0]


def caught_by(record: Record, group: str, evidence: Iterable[str]) -> Counter[str]:
    """How many mutants of each rule of a group some evidence catches."""
    mine = set(evidence)
    rules = record.kills.get(group, {})
    return Counter(subject_of(name) for name, kills in rules.items() if any(kill.by in mine for kill in kills))


def cells(record: Record, group: str) -> tuple[list[str], dict[str, list[int]]]:
    """The claims of each column, and for each rule of a group how many of its mutants each column catches."""
    found = {", ".join(claims): caught_by(record, group, evidence) for evidence, claims in columns(record).items()}
    telling = {claims: counts for claims, counts in found.items() if counts}
    subjects = dict.fromkeys(map(subject_of, record.kills.get(group, {})))
    return list(telling), {subject: [counts[subject] for counts in telling.values()] for subject in subjects}


def untried(record: Record) -> list[str]:
    """The claims that rest on nothing that mutants are tried on, as hunts and levels of fixed shapes."""
    return [claim.removeprefix("claim/") for claim, evidence in record.claims.items() if not evidence]


def aside(record: Record, why: str) -> list[str]:
    """The mutants that are set aside for a reason that begins so, with what there is to say of each."""
    return [
        f"`{name}`: {said.removeprefix(why).lstrip(': ')}".removesuffix(": ")
        for name, said in record.equal.items()
        if said.startswith(why)
    ]


def tallies(record: Record) -> Iterator[str]:
    """How many mutants there are of each group, how many are caught, and what becomes of the others."""
    for group, table in record.kills.items():
        caught, reasons = sum(map(bool, table.values())), [record.equal[name] for name in table if name in record.equal]
        parts = [f"{sum(said.startswith(why) for said in reasons)} {told}" for why, told in ASIDE.items()]
        left = len(table) - caught - len(reasons)
        yield f"{group}: {len(table)} mutants, {caught} caught, {', '.join(parts)}, {left} survive"


def show_matrix(record: Record, console: Console) -> None:
    """Print the matrices, what their columns stand for, and what counts for nothing."""
    for group in MATRICES:
        heads, rows = cells(record, group)
        table = Table(box=None, pad_edge=False, padding=(0, 1, 0, 0), header_style="bold")
        table.add_column("mutants of", no_wrap=True)
        for number, _ in zip(count(1), heads, strict=False):
            table.add_column(str(number), justify="right", no_wrap=True)
        for subject, numbers in rows.items():
            table.add_row(subject, *(str(number) if number else "." for number in numbers))
        console.print(table)
        for number, head in zip(count(1), heads, strict=False):
            console.print(f"{number:>3}  {head}", markup=False, highlight=False)
    for title, lines in endings(record).items():
        console.print(f"\n{title}", markup=False, highlight=False)
        for line in lines:
            console.print(f"  {line}", markup=False, highlight=False, soft_wrap=True)


def endings(record: Record) -> Mapping[str, list[str]]:
    """What is said below the matrices."""
    return {
        "By construction, as far as mutants tell:": [
            f"{claim}: {why}" for claim, why in by_construction(record).items()
        ],
        "No mutants are tried on what these rest on:": [", ".join(untried(record))],
        "Of all mutants:": list(tallies(record)),
        "Survivors:": sorted(record.survivors()) or ["none"],
    }


def page_of(record: Record) -> str:
    """The page about the mutants."""
    lines = [HEAD]
    for group, title in MATRICES.items():
        heads, rows = cells(record, group)
        lines += [
            f"## {title}",
            "",
            f"| mutants of | {' | '.join(str(number) for number in range(1, len(heads) + 1))} |",
        ]
        lines.append(f"|---|{'--:|' * len(heads)}")
        lines += [
            f"| {subject} | {' | '.join(str(n) if n else '' for n in numbers)} |" for subject, numbers in rows.items()
        ]
        lines += ["", *(f"{number}. {head}" for number, head in enumerate(heads, 1)), ""]
    for title, said in endings(record).items():
        lines += [f"**{title}**", "", *(f"- {one}" for one in said), ""]
    for why, text in ASIDE.items():
        listed = aside(record, why)
        lines += [f"**{len(listed)} mutants {text}:**", "", *(f"- {one}" for one in listed), ""]
    return "\n".join(lines).rstrip() + "\n"


MATRICES = {
    "rules": "Rules of requests",
    "steps": "Rules of steps",
    "velocity": "Rules of velocity",
    "display": "Rules of the display",
}
ASIDE = {
    SAME: "are proved to change nothing",
    CHANGES_NO_ANSWER: "change no answer",
    CRASHING: "only crash, which counts as no kill",
}
"""How what is said of a mutant that is set aside begins, and what that means."""

HEAD = """# What the mutants show

Written by `make mutants-record`, checked by `make mutants`. [proofs.md](proofs.md) says what a mutant is.
A row is a rule or a function, a column the claims that rest on the same evidence; a number says how many mutants of the
row the evidence of the column catches. Counts, witnesses and random rows are tried only on what no obligation catches.
Not tried are the whole steps of fixed settings. Of the very many proofs about images, cuts and roundings,
those are tried that have few paths, and in each view up to the first that catches one.
What is by construction here may catch what was not tried.
"""
