"""An account of a validation: as text for people, as one JSON line per log for programs."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from shlex import quote

import msgspec

from properties.conformance.diagnosis import Conjunct, Diagnosis, Trouble
from properties.conformance.judge import Finding
from properties.conformance.record import ConjunctRecord, TroubleRecord, ValidationRecord
from properties.conformance.validate import Report
from properties.evidence.files import BUILD
from reference.formats.files import FormatError, one_line, write
from reference.formats.trace import LineRecord
from spec.registry import statements

MOST_LINES, MOST_LETTERS = 12, 100
DIVERGENCES = BUILD / "divergences"


def write_divergence(report: Report) -> Path | None:
    """Write the scenario of the first step that diverges; return its path, or None if there is none.

    Raises:
        FormatError: if it cannot be written.
    """
    if report.unread is not None or report.first is None or report.first.scenario is None:
        return None
    name = "-".join((*(part for part in report.path.parts[-2:-1] if part.strip("./")), report.path.stem))[:MOST_LETTERS]
    path = DIVERGENCES / f"{name}-line-{report.first.step.number}.json"
    try:
        write(path, report.first.scenario)
    except OSError as error:
        raise FormatError(one_line(f"{path}: {error.strerror}")) from None
    return path


def json_line(report: Report, replay: Path | None) -> str:
    """A report as one line of JSON."""
    return msgspec.json.encode(record_of(report, replay)).decode()


def record_of(report: Report, replay: Path | None) -> ValidationRecord:
    """A report as a record."""
    found = report.found
    return ValidationRecord(
        format="graphbody/validation@1",
        log=str(report.path),
        profile=report.profile,
        conforms=report.conforms,
        agrees=found[Finding.AGREES],
        one_of_several=found[Finding.ONE_OF_SEVERAL],
        ambiguous=found[Finding.AMBIGUOUS],
        diverges=found[Finding.DIVERGES],
        first=None if report.first is None else trouble_record(report.first, replay),
        broken={invariant: breach.line for invariant, breach in report.broken.items()},
        invalid=report.invalid,
        unread=report.unread,
    )


def trouble_record(trouble: Trouble, replay: Path | None) -> TroubleRecord:
    """The first step that diverges, as a record."""
    diagnosis = trouble.diagnosis
    difference = trouble.differences[0] if diagnosis is None else diagnosis.difference
    decision = None if diagnosis is None else diagnosis.decision
    instead = None if diagnosis is None or diagnosis.instead is None else diagnosis.instead.id
    guards = {} if diagnosis is None else diagnosis.guards
    return TroubleRecord(
        line=trouble.step.number,
        finding=trouble.finding.value,
        body=difference.body,
        field=difference.field,
        expected=difference.expected,
        seen=difference.seen,
        rule=None if decision is None else decision.rule.id,
        guard=[] if decision is None else guard_record(guards[decision.rule.id]),
        instead=instead,
        instead_guard=[] if instead is None else guard_record(guards[instead]),
        profiles=[] if diagnosis is None else list(diagnosis.profiles),
        scenario=trouble.scenario,
        replay=None if replay is None else f"graphbody simulate {quote(str(replay))}",
    )


def guard_record(guard: tuple[Conjunct, ...]) -> list[ConjunctRecord]:
    """The conjuncts of a guard as records."""
    return [ConjunctRecord(conjunct.name, conjunct.holds) for conjunct in guard]


def account(report: Report, replay: Path | None) -> Iterator[str]:
    """A report as lines of text."""
    counts = ", ".join(f"{finding.value}: {report.found[finding]}" for finding in Finding if report.found[finding])
    verdict = "conforms to" if report.conforms else "does not conform to"
    yield f"{report.path}: {verdict} {report.profile}; {report.found.total()} steps ({counts or 'none'})"
    if report.invalid is not None:
        yield f"  invalid state, the rest is not judged: {report.invalid}"
    if report.unread is not None:
        yield "  the rest is not judged"
    if report.first is not None:
        yield from account_of_trouble(report.first)
    if replay is not None:
        yield f"  replay what the rules do: graphbody simulate {quote(str(replay))}"
    for invariant, breach in report.broken.items():
        so = f"; so do the rules of {report.profile}, it is no fault of the trace" if breach.allowed else ""
        yield f"  line {breach.line} breaks {invariant}{so}: {statements()[invariant].sentence}"


def account_of_trouble(trouble: Trouble) -> Iterator[str]:
    """The first step that diverges as lines of text."""
    number = trouble.step.number
    yield f"  line {number}, step {number - 1}, {what_was_asked(trouble.step.line)}: {trouble.finding.value}"
    diagnosis = trouble.diagnosis
    first = trouble.differences[0] if diagnosis is None else diagnosis.difference
    yield f"  {first}"
    for difference in trouble.differences:
        if difference is not first:
            yield f"  {difference}"
    if trouble.rounded:
        yield "  in float64 this would be within the tolerance: are the numbers of the trace really exact?"
    yield from account_of_story(trouble.story if diagnosis is None else diagnosis.story)
    if diagnosis is not None:
        yield from account_of_diagnosis(diagnosis)


def account_of_story(story: tuple[str, ...]) -> Iterator[str]:
    """What the rules do in a step, as lines of text."""
    yield from (f"  by the rules: {line}" for line in story[:MOST_LINES])
    if len(story) > MOST_LINES:
        yield f"  by the rules: and {len(story) - MOST_LINES} more"


def what_was_asked(line: LineRecord) -> str:
    """What a line asks for, in words."""
    if line.request is not None:
        return f"{line.request.body} asked {line.request.distance}"
    if line.drive is not None:
        return f"{', '.join(line.drive.speeds) or 'nobody'} driven for {line.drive.time}"
    if line.add is not None:
        return f"{line.add.name} comes"
    if line.remove is not None:
        return f"{line.remove.body} goes"
    assert line.tick is not None
    return f"key {line.tick.key}"


def account_of_diagnosis(diagnosis: Diagnosis) -> Iterator[str]:
    """Rules, and their guards, as lines of text."""
    decision, instead = diagnosis.decision, diagnosis.instead
    if decision is None:
        yield f"  no rule was to move {diagnosis.difference.body}: nothing was asked of it"
    else:
        yield f"  rule expected: {decision.rule.id}: {decision.rule.sentence}"
        yield from guard_lines(diagnosis.guards[decision.rule.id])
    if decision is not None and instead is not None:
        yield f"  as seen if it were: {instead.id}: {instead.sentence}"
        yield from guard_lines(diagnosis.guards[instead.id])
    for profile in diagnosis.profiles:
        yield f"  as seen under profile {profile}"


def guard_lines(guard: tuple[Conjunct, ...]) -> Iterator[str]:
    """The conjuncts of a guard as lines of text."""
    for conjunct in guard:
        yield f"    {'true ' if conjunct.holds else 'FALSE'}  {conjunct.name}: {conjunct.meaning}"
