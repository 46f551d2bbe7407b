"""The diagnosis of a divergence: the rule that was to apply, what of its guard held, and what mistake looks like it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from fractions import Fraction
from itertools import islice
from typing import Any

from properties.conformance.judge import Difference, Expected, Finding, Judgement, displaced, expect
from properties.conformance.log import Step
from reference.formats.numbers import readable
from reference.formats.scenario import ScenarioRecord
from reference.recording import events_of
from reference.simulator import Endless
from spec.profiles import OF_REQUESTS, Profile
from spec.rule import AnyRule, Chooser, Family, GuardError

MOST_TRIALS, MOST_WORK = 200, 100_000


@dataclass(frozen=True)
class Conjunct:
    """A conjunct of a guard in the situation at hand."""

    name: str
    meaning: str
    holds: bool


@dataclass(frozen=True)
class Decision:
    """A choice among the rules of a family: the number of the choice in the step, what was chosen, and from what."""

    number: int
    rule: AnyRule
    family: Family[Any, Any]


@dataclass(frozen=True)
class Diagnosis:
    """What can be said of a divergence.

    Attributes:
        difference: the first field that differs, of the body that was to move first.
        decision: the choice that the log seems to have made differently, or else the most telling for that body.
        guards: the guards of all rules among which the choice was.
        instead: the rule of the same family with which the log would be right, if there is one.
        profiles: other profiles under which the log would be right.
        story: what the rules make happen in the step, in words.
    """

    difference: Difference
    decision: Decision | None
    guards: dict[str, tuple[Conjunct, ...]]
    instead: AnyRule | None
    profiles: tuple[str, ...]
    story: tuple[str, ...]


@dataclass
class Notebook:
    """The decisions of a step, in order.

    Attributes:
        forced: a rule to be taken at one of them, whatever the guards say.
        guarded: a decision of which the guards are to be noted, rule by rule.
    """

    forced: tuple[int, AnyRule] | None = None
    guarded: int | None = None
    decisions: list[Decision] = field(default_factory=list)
    guards: dict[str, tuple[Conjunct, ...]] = field(default_factory=dict)


@dataclass(frozen=True)
class Noted:
    """A family whose decisions are written into a notebook."""

    family: Family[Any, Any]
    notebook: Notebook

    def choose(self, facts: Any) -> AnyRule:
        """Return the rule that applies, or the one that is forced."""
        notebook, rule = self.notebook, self.family.choose(facts)
        number = len(notebook.decisions)
        notebook.decisions.append(Decision(number, rule, self.family))
        if notebook.guarded == number:
            notebook.guards.update({one.id: tuple(conjuncts(one, facts)) for one in self.family.rules})
        forced = notebook.forced
        return forced[1] if forced is not None and forced[0] == number else rule


def conjuncts(rule: AnyRule, facts: Any) -> Iterator[Conjunct]:
    """The conjuncts of a rule's guard, each judged on its own."""
    for conjunct in rule.guard:
        yield Conjunct(conjunct.__name__, (conjunct.__doc__ or "").partition("\n")[0], bool(conjunct(facts)))


def noted(profile: Profile, notebook: Notebook) -> Profile:
    """A profile whose decisions are written into a notebook."""

    def wrap(family: Chooser) -> Chooser:
        assert isinstance(family, Family)
        return Noted(family, notebook)

    return replace(profile, rules=profile.rules.through(wrap))


def diagnose(profile: Profile, step: Step, judgement: Judgement, tolerance: Fraction) -> Diagnosis:
    """Diagnose a step that diverges."""
    difference = first_difference(judgement, step)
    notebook = Notebook()
    expected = expect(noted(profile, notebook), step.before, step.asked)
    of_body = decisions_for(expected, notebook, difference.body)
    most = MOST_TRIALS + 4 * len(notebook.decisions)

    def as_seen(other: Profile) -> bool:
        try:
            instead = expect(other, step.before, step.asked, most)
            return not any(displaced(instead.world.bodies, step.after, tolerance))
        except (AssertionError, GuardError, Endless):
            return False

    trials = min(MOST_TRIALS, MOST_WORK // max(1, len(notebook.decisions)))
    culprit = as_if(profile, of_body, as_seen, trials)
    asker = decisions_for(expected, notebook, asker_of(expected, difference.body))
    decision, instead = culprit if culprit is not None else (most_telling(of_body, asker), None)
    profiles = tuple(name for name, other in OF_REQUESTS.items() if other is not profile and as_seen(other))
    guards = {} if decision is None else guards_at(profile, step, decision)
    return Diagnosis(difference, decision, guards, instead, profiles, tuple(story(profile, expected)))


def guards_at(profile: Profile, step: Step, decision: Decision) -> dict[str, tuple[Conjunct, ...]]:
    """The guards of all rules among which a decision was."""
    notebook = Notebook(guarded=decision.number)
    expect(noted(profile, notebook), step.before, step.asked)
    return notebook.guards


def as_if(
    profile: Profile, decisions: list[Decision], as_seen: Callable[[Profile], bool], most: int
) -> tuple[Decision, AnyRule] | None:
    """The last decision, and the other rule for it, with which the log would be right."""
    trials = ((decision, rule) for decision in reversed(decisions) for rule in decision.family.rules)
    for decision, rule in islice(trials, most):
        if rule is not decision.rule and as_seen(noted(profile, Notebook((decision.number, rule)))):
            return decision, rule
    return None


def most_telling(decisions: list[Decision], asker: list[Decision]) -> Decision | None:
    """The last decision by which something happened to the body, or else to who asked it, or else the last of all."""
    for some in (decisions, asker):
        telling = [decision for decision in some if decision.rule.event is not None]
        if telling:
            return telling[-1]
    return decisions[-1] if decisions else None


def asker_of(expected: Expected, name: str) -> str:
    """Who asked a body to move; the empty name if nobody did."""
    bodies = expected.world.bodies
    asks = [ask for record in expected.records for ask in record.asks if bodies[ask.body].name == name]
    return bodies[asks[-1].asker].name if asks else ""


def story(profile: Profile, expected: Expected) -> Iterator[str]:
    """Who asks whom for what, and what happens to whom by which rule."""
    bodies, events = expected.world.bodies, events_of(profile)
    for record in expected.records:
        for ask in record.asks:
            who, whom = bodies[ask.asker].name, bodies[ask.body].name
            yield f"{who} asks {whom} for {readable(ask.distance)}, {whom} moves {readable(ask.moved)}"
        for body, rule in record.fired:
            if rule in events:
                yield f"{bodies[body].name}: {events[rule]} ({rule})"


def first_difference(judgement: Judgement, step: Step) -> Difference:
    """The difference of the body that was asked first, or of one that it asked, and so on."""
    fired = [body for record in judgement.expected.records for body, _ in record.fired]
    order = {step.after.bodies[body].name: place for place, body in reversed(list(enumerate(fired)))}
    return min(judgement.differences, key=lambda difference: order.get(difference.body, len(fired)))


def decisions_for(expected: Expected, notebook: Notebook, name: str) -> list[Decision]:
    """The decisions that were made for a body; there is one for each rule that fired."""
    fired = [body for record in expected.records for body, _ in record.fired]
    bodies = expected.world.bodies
    pairs = zip(fired, notebook.decisions, strict=True)
    return [decision for body, decision in pairs if bodies[body].name == name]


@dataclass(frozen=True)
class Trouble:
    """The first step of a log that diverges, or is ambiguous, and all that can be said of it.

    Attributes:
        diagnosis: which rule, where bodies move one after another.
        story: what happened by the rules, where they move all at once.
        rounded: whether it is in exact numbers, and would be right to within the roundings of floats.
    """

    step: Step
    finding: Finding
    differences: tuple[Difference, ...]
    diagnosis: Diagnosis | None
    scenario: ScenarioRecord | None
    rounded: bool = False
    story: tuple[str, ...] = ()
