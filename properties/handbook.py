"""The reference in docs/: a page for each kind of statement, with an entry for each ID, made from the registry.

Rules are shown where they fire, refuted claims by their witnesses. Verdicts are those of the last run of the check.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from inspect import cleandoc, getmodule
from itertools import groupby
from pathlib import Path
from shutil import copyfile, rmtree

from properties.claims.claim import Claim
from properties.designs_page import with_costs
from properties.evidence.files import RESULTS, RESULTS_LONG
from properties.evidence.sources import sources
from properties.explain import Fact, Firing, everything, facts, firings, witness_of
from properties.pages import with_tables
from properties.results import ClaimResult, Results
from properties.slides import with_numbers
from reference.draw import strip
from reference.formats.files import FormatError, read
from reference.recording import recording
from spec.registry import Statement
from spec.rule import Rule


@dataclass(frozen=True)
class Page:
    """A page of the reference: its file, its title, what it is about, and the kinds of statement on it."""

    file: str
    title: str
    about: str
    kinds: tuple[str, ...]


PAGES = (
    Page("profiles.md", "Profiles", "Which rules hold together, and what they are about.", ("profile",)),
    Page("rules.md", "Rules", "What a body does, decision by decision.", ("rule",)),
    Page("invariants.md", "Invariants", "What every request is to keep, whatever the rules.", ("invariant",)),
    Page("claims.md", "Claims", "What is claimed of the rules, and what a run of the check showed.", ("claim",)),
    Page("readings.md", "Readings", "Where the thesis leaves a question open: the answer taken here.", ("reading",)),
    Page(
        "levels.md",
        "Conditions, guidelines, unsupported cases",
        "What claims assume of a level and of a start, what the thesis advises, and what it says it cannot do.",
        ("condition", "guideline", "unsupported"),
    ),
    Page("differences.md", "Differences", "Why `repaired` ends otherwise than `thesis`.", ("difference",)),
    Page("designs.md", "Designs", "How else bodies could be represented.", ("design",)),
    Page(
        "evaluated.md",
        "Evaluated",
        "What the thesis found of its prototype, and what a run here shows.",
        ("evaluation",),
    ),
    Page("errata.md", "Errata", "What is wrong with the rules as printed, and what mends it.", ("erratum",)),
    Page("mends.md", "Mends", "Changes of one decision each of the rules as printed.", ("mend",)),
    Page("alternatives.md", "Alternatives", "What else the thesis could mean.", ("alternative",)),
    Page("features.md", "Features", "What a profile can do without.", ("feature",)),
    Page("models.md", "Models", "What the level, the graph and time are.", ("model",)),
)


class NoEvidence(Exception):
    """The check has not been run, or not the whole of it, or there is no place to write to."""


def slug(name: str) -> str:
    """An ID as an anchor, and as the name of a file."""
    return name.replace("/", "-")


def page_of(statement: Statement) -> Page:
    """The page that a statement is on."""
    return next(page for page in PAGES if statement.kind in page.kinds)


def link(statement: Statement) -> str:
    """A link to a statement's entry, from any page."""
    return f"[{statement.id}]({page_of(statement).file}#{slug(statement.id)})"


def results() -> dict[str, ClaimResult]:
    """What the last runs of the check showed, by claim.

    Raises:
        NoEvidence: if a run is missing, or is about other sources.
    """
    try:
        runs = {path: read(path, Results) for path in (RESULTS, RESULTS_LONG)}
    except FormatError as error:
        raise NoEvidence(f"{error}; run `make check` and `make check-long` first") from None
    stale = [path for path, run in runs.items() if run.sources != sources()]
    if stale:
        raise NoEvidence(f"{stale[0]} is stale, it is about other sources; run `make check` and `make check-long`")
    found = {result.id: result for run in runs.values() for result in run.claims}
    missing = [name for name, one in everything().items() if isinstance(one, Claim) and name not in found]
    if missing:
        raise NoEvidence(f"{missing[0]} is in no results; run `make check` and `make check-long` first")
    return found


def write_handbook(docs: Path) -> int:
    """Write all pages anew with their pictures and witnesses; return the number of entries.

    Raises:
        NoEvidence: if a run of the check is missing.
    """
    shown, table, to = results(), everything(), docs / "reference"
    contents = to / "README.md"
    if to.exists() and not (contents.is_file() and MADE in contents.read_text()):
        raise NoEvidence(f"{to}: expected nothing, or a reference that this command has made")
    rmtree(to, ignore_errors=True)
    for directory in (to / "pictures", to / "witnesses"):
        directory.mkdir(parents=True)
    for page in PAGES:
        entries = [one for one in table.values() if one.kind in page.kinds]
        lines = [f"# {page.title}", "", page.about, "", MADE, ""]
        for chapter, some in groupby(entries, chapter_of):
            lines += [chapter, ""] if chapter else []
            for one in some:
                lines += entry(one, shown, to)
        (to / page.file).write_text("\n".join(lines) + "\n")
    (to / "README.md").write_text("\n".join(index(table)) + "\n")
    formats = docs / "formats.md"
    formats.write_text(with_tables(formats.read_text()))
    physics = docs / "physics.md"
    physics.write_text(with_numbers(physics.read_text()))
    designs = docs / "designs.md"
    designs.write_text(with_costs(designs.read_text()))
    return len(table)


MADE = "Made from the registry by `make docs`; the code is normative."


def chapter_of(one: Statement) -> str:
    """What the chapter of a rule says of itself; empty for what has no chapter."""
    module = getmodule(one.effect) if isinstance(one, Rule) else None
    return "" if module is None else cleandoc(module.__doc__ or "")


def index(table: dict[str, Statement]) -> Iterator[str]:
    """The contents: for each page what is on it, and every ID with its sentence."""
    yield from ("# Reference", "", "Every statement of the specification, by its ID.", MADE)
    for page in PAGES:
        yield from ("", f"## [{page.title}]({page.file})", "", page.about, "", "| ID | says |", "|---|---|")
        for one in table.values():
            if one.kind in page.kinds:
                yield f"| {link(one)} | {one.sentence} |"


def entry(one: Statement, shown: dict[str, ClaimResult], to: Path) -> Iterator[str]:
    """The entry of a statement: heading, sentence, verdict, facts, picture."""
    yield from (f'<a id="{slug(one.id)}"></a>', "", f"## {one.id}", "", one.sentence, "")
    if isinstance(one, Claim):
        yield f"- **verdict: {verdict(shown[one.id])}**"
    for fact in facts(one):
        yield f"- {fact.label}: " + (f"`{fact.text}`" if fact.code else linked(fact))
    yield from ("", *picture(one, shown, to))


def verdict(result: ClaimResult) -> str:
    """A verdict in words."""
    bounded = f", up to {result.bodies} bodies" if result.bodies is not None else ""
    return f"{result.verdict}{bounded} (by {result.engine})"


def linked(fact: Fact) -> str:
    """The text of a fact, with a link if it begins with an ID."""
    name, colon, rest = fact.text.partition(":")
    known = everything().get(name)
    return fact.text if known is None else f"{link(known)}{colon}{rest}"


def picture(one: Statement, shown: dict[str, ClaimResult], to: Path) -> Iterator[str]:
    """The picture of a rule where it fires, or of a claim by its witness."""
    if isinstance(one, Rule) and one.id in firings():
        found = firings()[one.id]
        drawn, name = strip(recording(found.path), found.step - 1, found.step), picture_of(found)
        text = f"{one.id} in {found.path.stem}"
    elif isinstance(one, Claim) and shown[one.id].witness is not None:
        copyfile(witness_of(one), to / "witnesses" / witness_of(one).name)
        drawn, name = strip(recording(witness_of(one)), 0), f"{slug(one.id)}.svg"
        text = f"the witness against {one.id}"
    else:
        return
    (to / "pictures" / name).write_text(drawn)
    yield from (f"![{text}](pictures/{name})", "")


def picture_of(found: Firing) -> str:
    """The name of the picture of a step; rules that fire in the same one share it."""
    return f"{found.path.stem}-{found.step}.svg"
