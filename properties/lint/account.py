"""An account of a lint: as text for people, as one JSON document for programs, and its scenarios as files."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from shlex import quote
from textwrap import wrap

from properties.evidence.files import BUILD
from properties.lint.findings import Finding, Found, Linted, under
from properties.lint.record import FindingRecord, LintRecord, WrongRecord
from properties.lint.search import Wrong
from reference.formats.files import FormatError, one_line, write
from reference.formats.level import level_record
from reference.formats.numbers import number_text
from reference.formats.scenario import RequestRecord, ScenarioRecord, StepRecord
from spec.conditions import PLANE_START
from spec.guidelines import GUIDELINES
from spec.profiles import REPAIRED, Profile
from spec.registry import statements

COLUMNS, MOST_TOLD, MOST_LETTERS = 80, 40, 80
LINTS = BUILD / "lint"


def record_of(linted: Linted, found: Found, directory: Path = LINTS) -> LintRecord:
    """What was found as a record, with its scenarios numbered as they will be written."""
    wrongs = list(dict.fromkeys([*(one.wrong for one in found.findings if one.wrong is not None), *found.others]))
    records = {wrong: wrong_record(linted, wrong, number, directory) for number, wrong in enumerate(wrongs, start=1)}
    refused = found.storeys
    return LintRecord(
        format="graphbody/lint@1",
        file=str(linted.file),
        profile=linted.profile.name,
        findings=[finding_record(one, records) for one in found.findings],
        wrong=[records[one] for one in found.others],
        requests=0 if found.searched is None else found.searched.requests,
        all_tried=found.searched is not None and not (found.searched.spent or found.searched.left_out),
        storeys=None if refused is None else f"{under(linted.where, refused.place)}: {refused.problem}",
    )


def finding_record(one: Finding, records: dict[Wrong, WrongRecord]) -> FindingRecord:
    """A finding as a record."""
    return FindingRecord(
        place=one.place,
        what=one.what,
        statement=one.statement.id,
        sentence=one.statement.sentence,
        seen=one.seen,
        mend=one.mend,
        wrong=None if one.wrong is None else records[one.wrong],
    )


def wrong_record(linted: Linted, wrong: Wrong, number: int, directory: Path) -> WrongRecord:
    """Requests that go wrong, as a scenario of this level."""
    name = f"{linted.record.name[:MOST_LETTERS]}-{number}"
    scenario = ScenarioRecord(
        format="graphbody/scenario@1",
        name=name,
        note=f"Goes wrong: {'; '.join(statements()[one].sentence for one in wrong.broken)}",
        level=level_record(linted.level, linted.record.name),
        profile=linted.profile.name,
        steps=[StepRecord(request=RequestRecord(body, number_text(distance))) for body, distance in wrong.steps],
    )
    return WrongRecord(list(wrong.broken), scenario, f"graphbody simulate {quote(str(path_of(directory, scenario)))}")


def path_of(directory: Path, scenario: ScenarioRecord) -> Path:
    """Where a scenario is written."""
    return directory / f"{''.join(char if char.isalnum() or char in '-_' else '-' for char in scenario.name)}.json"


def write_scenarios(record: LintRecord, directory: Path = LINTS) -> None:
    """Write the scenarios in which something goes wrong.

    Raises:
        FormatError: if one cannot be written.
    """
    wrongs = [*(one.wrong for one in record.findings if one.wrong is not None), *record.wrong]
    for path, scenario in {path_of(directory, wrong.scenario): wrong.scenario for wrong in wrongs}.items():
        try:
            write(path, scenario)
        except OSError as error:
            raise FormatError(one_line(f"{path}: {error.strerror}")) from None


def anything(record: LintRecord) -> bool:
    """Whether anything was found."""
    return bool(record.findings or record.wrong)


def account(linted: Linted, record: LintRecord) -> Iterator[str]:
    """What was found as lines of text."""
    yield from text(f"{linted.file}: under {record.profile}, {verdict(linted, record)}", 0)
    told: dict[str, int] = {}
    for number, one in enumerate(record.findings[:MOST_TOLD], start=1):
        yield ""
        yield from text(f"{number}. {one.place}, {one.what}: {one.statement}", 0)
        yield from text(f"{one.sentence} {f'It {one.seen}.' if one.mend else one.seen}", 3)
        if one.wrong is not None and one.wrong.replay in told:
            yield f"   What goes wrong: see {told[one.wrong.replay]}."
        elif one.wrong is not None:
            told[one.wrong.replay] = number
            yield from wrong_lines(one.wrong)
        yield from text(f"To mend it, {one.mend}.", 3) if one.mend else ()
    if len(record.findings) > MOST_TOLD:
        yield f"\nand {len(record.findings) - MOST_TOLD} more, which --json tells"
    yield from other_lines(record)
    yield from closing(linted, record)


def verdict(linted: Linted, record: LintRecord) -> str:
    """What was found, in a few words."""
    many = len(record.findings)
    if not isinstance(linted.profile, Profile):
        return "this is no level of storeys" if many else "this is a level of storeys"
    return f"{many} {'place' if many == 1 else 'places'} to mend" if many else "all guidelines are kept"


def text(line: str, indent: int) -> list[str]:
    """A line as one or more of at most 80 columns."""
    rest = " " * (indent or 3)
    return wrap(line, COLUMNS, initial_indent=" " * indent, subsequent_indent=rest, break_on_hyphens=False) or [""]


def wrong_lines(wrong: WrongRecord) -> Iterator[str]:
    """What goes wrong, and how to see it."""
    requests = [step.request for step in wrong.scenario.steps if step.request is not None]
    asked = ", then ".join(f"{request.body!r} by {request.distance}" for request in requests)
    yield from text(f"What goes wrong: ask {asked}.", 3)
    for name in wrong.broken:
        yield from text(f"{name}: {statements()[name].sentence}", 5)
    yield f"     {wrong.replay}"


def other_lines(record: LintRecord) -> Iterator[str]:
    """What goes wrong elsewhere, or though all guidelines are kept."""
    if record.wrong:
        kept = {one.id for one in GUIDELINES}.isdisjoint(one.statement for one in record.findings)
        yield ""
        yield "It keeps all guidelines, yet:" if kept else "And elsewhere:"
        yield from (line for one in record.wrong for line in wrong_lines(one))


def closing(linted: Linted, record: LintRecord) -> Iterator[str]:
    """What was searched, and whether the level is one for `repaired`."""
    yield ""
    if isinstance(linted.profile, Profile):
        yield from text(searched(record), 0)
    if record.profile != REPAIRED.name:
        fits = record.storeys is None
        line = "this is a level of storeys, as it needs." if fits else f"it needs a level of storeys: {record.storeys}"
        yield from text(f"For repaired {line}", 0)


def searched(record: LintRecord) -> str:
    """What was searched, in words."""
    if any(one.statement == PLANE_START.id for one in record.findings):
        return "No request was tried: first mend how the bodies stand at the start."
    ends = "up to two in a row" if record.all_tried else "as many as the budget allows"
    return f"{record.requests} requests were tried, of each body in both directions, {ends}."
