"""The format of a validation: what was found in one trace."""

from __future__ import annotations

from typing import Annotated, Literal

from reference.formats.files import Record, says
from reference.formats.scenario import ScenarioRecord


class ConjunctRecord(Record, frozen=True):
    """A conjunct of a guard, and whether it held."""

    name: Annotated[str, says("the conjunct's name")]
    holds: Annotated[bool, says("whether it held in the situation of the step")]


class TroubleRecord(Record, frozen=True, kw_only=True):
    """The first step that diverges: where, what was expected and seen, by which rule, and what replays it."""

    line: Annotated[int, says("the line of the trace; the header is line 1")]
    finding: Annotated[str, says("`diverges` or `ambiguous`")]
    body: Annotated[str, says("the body, or empty if it is about the whole level")]
    field: Annotated[str, says("what of it differs")]
    expected: Annotated[str, says("what the rules give")]
    seen: Annotated[str, says("what the trace says")]
    rule: Annotated[str | None, says("the ID of the rule that was to apply")] = None
    guard: Annotated[list[ConjunctRecord], says("its guard")] = []  # noqa: RUF012 (a struct copies it)
    instead: Annotated[str | None, says("the ID of a rule with which the trace would be right")] = None
    instead_guard: Annotated[list[ConjunctRecord], says("the guard of that rule")] = []  # noqa: RUF012
    profiles: Annotated[list[str], says("other profiles under which the step would be right")] = []  # noqa: RUF012
    scenario: Annotated[ScenarioRecord | None, says("a smallest scenario that shows what the rules do")] = None
    replay: Annotated[str | None, says("the command that plays that scenario")] = None


class ValidationRecord(Record, frozen=True, kw_only=True):
    """What was found in one trace: how many steps were found to be what, and the first that diverges."""

    format: Annotated[Literal["graphbody/validation@1"], says("what the line is, and the version of its format")]
    log: Annotated[str, says("the file of the trace")]
    profile: Annotated[str, says("the profile under whose rules it was judged")]
    conforms: Annotated[bool, says("whether every step is one that the rules allow")]
    agrees: Annotated[int, says("how many steps are what the rules give")]
    one_of_several: Annotated[int, says("how many are one of several outcomes that the rules allow near a boundary")]
    ambiguous: Annotated[int, says("how many have more possible outcomes than were looked at")]
    diverges: Annotated[int, says("how many are not what the rules allow")]
    first: Annotated[TroubleRecord | None, says("the first step that diverges, or else the first ambiguous one")] = None
    broken: Annotated[dict[str, int], says("for each invariant that the states break, the first line that does")] = {}  # noqa: RUF012
    unread: Annotated[str | None, says("what is wrong with a line at which the reading ended")] = None
    invalid: Annotated[str | None, says("the line and the place of a state that no body can be in")] = None
