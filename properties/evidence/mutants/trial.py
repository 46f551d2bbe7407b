"""Trying a mutant: which evidence fails while it is in place, with exact values that show it.

An obligation on rules fails if it has a counterexample that replays on exact numbers. It has none if it crashes, or if
it is not decided.
"""

from __future__ import annotations

import contextlib
import signal
from collections.abc import Callable, Iterable, Iterator, Mapping
from cProfile import Profile
from dataclasses import dataclass, field, replace
from functools import cache, partial
from types import CodeType, FrameType
from typing import Any

from properties.claims.catalogue import CLAIMS
from properties.claims.claim import Claim, Count, Erratum, Obligation
from properties.contracts.errata import Stage
from properties.contracts.request import judged
from properties.engine.explore import Exploration, Program, explore, watched_by
from properties.engine.formulas import EngineError
from properties.evidence.mutants.mutant import COMPARE, Mutant, called
from properties.evidence.sample import campaign
from properties.evidence.showing import Texts, texts
from properties.given import Exact, Given, Infeasible
from reference.formats.files import FormatError
from reference.simulator import Endless
from spec.profiles import THESIS
from spec.rule import GuardError

SAME = "the same, proved wherever"
CRASHING = "makes its evidence crash"
EXAMPLES, ROWS = 100, "rows: random"
MANY, FEW, SOME = ("images/worlds", "images/settling", "cuts/what-comes", "rounding/", "rounded_steps/"), 64, 160
"""Obligations that are made on many settings: to try all wrong rules on all of them would take hours. The rules are
tried on those of some paths, the world of storeys on those of few, and that is so many.
"""
LONG = frozenset({"differences-have-causes"})
SLOW = frozenset(
    {
        "images/worlds-look-alike (one on another on a ring, from behind)",
        "rounding/segment-is-nearly-exact (ring, left, an edge follows)",
        "rounding/segment-is-nearly-exact (ring, right, an edge follows)",
    }
)
"""The obligations that take longest; others run the same functions."""
LISTED = frozenset({"coefficients", "slopes", "drags"})
"""The shapes that are no worlds: some numbers are those of a list, and all others are any."""
KEPT = "what the witness broke is kept"
SECONDS, MORE_SECONDS = 6, 30
"""After how many seconds of the processor what is tried on a mutant does not end; and after how many a count, or what
is explored of the true rules, which may be slowed down by others.
"""


class DoesNotEnd(KeyboardInterrupt):
    """What is tried goes on and on; of tests, only an interrupt stops all."""


CRASHES = (
    DoesNotEnd,
    EngineError,
    TypeError,
    AttributeError,
    ValueError,
    ArithmeticError,
    LookupError,
    RecursionError,
    NameError,
    AssertionError,
)


@dataclass(frozen=True)
class Kill:
    """What catches a mutant: a piece of evidence, what fails of it, and at which exact values, if there are any.

    `on` is the mutant of the rules or of the contracts that is in place beside it, if there is one.
    """

    by: str
    broken: tuple[str, ...]
    values: Texts = field(default_factory=dict)
    on: str = ""


@dataclass(frozen=True)
class Facts:
    """The functions that an obligation runs, the names of what it assumes and draws, and the number of its paths."""

    calls: frozenset[str]
    premises: tuple[str, ...]
    paths: int


@contextlib.contextmanager
def ended(seconds: int = SECONDS) -> Iterator[None]:
    """Stop what does not end, after some seconds of the processor; what is stopped counts as nothing.

    Each second it is stopped again: an exception in what tidies up is ignored.
    """

    def stop(number: int, frame: FrameType | None) -> None:
        raise DoesNotEnd

    before = signal.signal(signal.SIGVTALRM, stop)
    signal.setitimer(signal.ITIMER_VIRTUAL, seconds, 1)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        signal.signal(signal.SIGVTALRM, before)


def is_tried(obligation: Obligation) -> bool:
    """Whether mutants are tried on an obligation: it is about no world of fixed shape, and not one of the slowest."""
    return (obligation.shape is None or obligation.shape in LISTED) and obligation.id not in SLOW


def name_of(claim: Claim, obligation: Obligation) -> str:
    """The name of an obligation under the profile of a claim."""
    return obligation.id if claim.profile.name == "thesis" else f"{obligation.id} ({claim.profile.name})"


@cache
def programs() -> dict[str, Program]:
    """The obligations on which mutants are tried, by name."""
    return {
        name_of(claim, obligation): partial(judged, obligation.program, claim.profile)
        for claim in CLAIMS
        for obligation in claim.obligations
        if is_tried(obligation)
    }


def facts_of(name: str) -> Facts:
    """What an obligation runs, assumes and draws, and how many paths it has."""
    with Profile(builtins=False) as profile:
        exploration = explored(name, MORE_SECONDS)
    codes = (entry.code for entry in profile.getstats())
    calls = frozenset(called(code) for code in codes if isinstance(code, CodeType))
    return Facts(calls, said_by(exploration), exploration.outcome.paths)


def explored(name: str, seconds: int = SECONDS) -> Exploration:
    """Explore an obligation up to a counterexample, unless that does not end."""
    seen: list[Exploration] = []
    with ended(seconds), watched_by(seen.append):
        explore(programs()[name])
    return seen[0]


def said_by(exploration: Exploration) -> tuple[str, ...]:
    """The names of all that was assumed and drawn, the signs of numbers included."""
    return told((*exploration.outcome.assumed, *exploration.drawn.flags))


def interface(name: str) -> tuple[str, ...]:
    """The names of all that an obligation assumes and draws."""
    return said_by(explored(name, MORE_SECONDS))


def attempt(name: str) -> Kill | None:
    """What an obligation finds, if it fails."""
    try:
        found = explored(name).outcome.counterexample
    except CRASHES:
        return None
    return None if found is None else Kill(name, told(found.broken), texts(found.values))


def told(broken: Iterable[str]) -> tuple[str, ...]:
    """Promises that are broken, each once."""
    return tuple(sorted(set(broken)))


def replayed(name: str, values: Texts) -> tuple[str, ...] | None:
    """The promises of an obligation that exact values break, up to a premise that they break; None if it crashes."""
    exact = Exact(values)
    try:
        with ended():
            programs()[name](exact)
    except Infeasible:
        pass
    except CRASHES:
        return None
    return told(exact.broken)


def kills_by_proofs(mutant: Mutant, calls: Mapping[str, frozenset[str]]) -> Iterator[Kill]:
    """The obligations that fail on a mutant in place, of those that it plays a part in; of many alike, the first."""
    found: set[str] = set()
    for name, functions in calls.items():
        if view_of(name) not in found and functions & mutant.reached and (kill := attempt(name)) is not None:
            found.add(view_of(name))
            yield kill


def view_of(name: str) -> str:
    """The name of an obligation; of one of very many, without the setting that is seen in a view."""
    chapter, _, said = name.partition(" (")
    return f"{chapter} ({said.rpartition(', ')[2]}" if name.startswith(MANY) else name


def crash_of(mutant: Mutant, calls: Mapping[str, frozenset[str]]) -> str | None:
    """That an obligation crashes with a mutant in place: it catches nothing, but it does not pass either."""
    for name in (name for name, functions in calls.items() if functions & mutant.reached):
        with mutant.in_place():
            try:
                explored(name)
            except CRASHES as error:
                return f"{CRASHING}: {name}, {type(error).__name__}"
    return None


def no_change(mutant: Mutant, calls: Mapping[str, frozenset[str]]) -> str | None:
    """That what is changed gives the same as before wherever an obligation meets it, if that is proved."""
    mine = [name for name, functions in calls.items() if functions & mutant.reached]
    if mutant.probe is None or not mine or not all(same_in(mutant, name) for name in mine):
        return None
    return f"{SAME} {', '.join(mine)} meet it"


def same_in(mutant: Mutant, name: str) -> bool:
    """Whether what is changed is proved to give the same in an obligation."""

    def program(given: Given) -> None:
        COMPARE.set(lambda own, other: given.ensure("the same", own is other or own == other))
        programs()[name](given)

    probing = replace(mutant, value=mutant.probe)
    with probing.in_place():
        try:
            return explore(program).proved
        except CRASHES:
            return False


@cache
def counts() -> dict[str, Callable[[], int]]:
    """The exact counts, by name."""
    return {f"count: {c.id}": partial(c.program, claim.profile) for claim in CLAIMS for c in counted(claim)}


def counted(claim: Claim) -> tuple[Count, ...]:
    """The exact counts of a claim on which mutants are tried: those of random scenarios take too long."""
    return tuple(one for one in claim.counts if one.id not in LONG)


def miscounted(name: str) -> tuple[str, ...]:
    """What a count finds wrong."""
    try:
        with ended(MORE_SECONDS):
            counts()[name]()
    except (AssertionError, GuardError, Endless, FormatError) as error:
        return (str(error),)
    except CRASHES:
        return ()
    return ()


def count_crash(mutant: Mutant, name: str) -> str | None:
    """That a count crashes with a mutant in place."""
    with mutant.in_place():
        try:
            counts()[name]()
        except CRASHES as error:
            return f"{CRASHING}: {name}, {type(error).__name__}"
    return None


@cache
def errata() -> dict[str, Program]:
    """The promises that a witness breaks, by name."""
    return {
        f"witness: {claim.id}": partial(on_a_stage, claim.erratum, claim.profile)
        for claim in CLAIMS
        if claim.erratum is not None and not claim.long
    }


def on_a_stage(erratum: Erratum, profile: Any, given: Given) -> None:
    """Run what is refuted, on a stage of its own."""
    erratum(profile, given, Stage())


def witness_of(name: str) -> Texts:
    """Values that refute a claim."""
    found = explore(errata()[name]).counterexample
    assert found is not None
    return texts(found.values)


def unrefuted(name: str, values: Texts) -> tuple[str, ...]:
    """What a witness does not break any more."""
    exact = Exact(values)
    try:
        errata()[name](exact)
    except (Infeasible, GuardError, Endless, *CRASHES):
        return ()
    return () if exact.broken else (KEPT,)


def kills_by_counts(claims: Iterable[Claim]) -> Iterator[Kill]:
    """The counts of some claims that fail on a mutant in place."""
    for name in (f"count: {one.id}" for claim in claims for one in counted(claim)):
        if wrong := miscounted(name):
            yield Kill(name, wrong)


def kills_by_witnesses(witnesses: Mapping[str, Texts]) -> Iterator[Kill]:
    """The witnesses that are none any more with a mutant in place."""
    for name, values in witnesses.items():
        if kept := unrefuted(name, values):
            yield Kill(name, kept, values)


def rows_broken() -> tuple[str, ...]:
    """The properties that fail on random rows."""
    try:
        return tuple(sorted(campaign(THESIS, floats=False, examples=EXAMPLES).failures))
    except CRASHES:
        return ()


def kills_by_rows() -> Iterator[Kill]:
    """What fails on random rows with a mutant in place."""
    if broken := rows_broken():
        yield Kill(ROWS, broken)
