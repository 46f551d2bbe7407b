"""The explorer: it re-runs a program once per feasible path and judges its promises on each.

Its honesty is checked as it goes: a replay must meet the same forks; a solver that answers `unknown` prunes
nothing and proves nothing; the paths, with what premises cut off, must cover all values; at least one path
must be feasible; every counterexample is run again on exact numbers before it is believed. Budgets are
counted work, never seconds.

Premises have names. Each answer that something cannot be has a core: the premises it rests on. What is in no core is
not needed: without it, the same exploration shows the same.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from contextvars import ContextVar
from dataclasses import dataclass, field
from fractions import Fraction
from functools import lru_cache
from itertools import count
from typing import Any

import z3

from properties.engine.formulas import (
    EngineError,
    ask,
    conjunction,
    core_of,
    disjunction,
    holds_in,
    identity_of,
    opposite,
    references,
    tell,
)
from properties.engine.reals import DECIDE, Symbolic, SymbolicTruth, formula_of
from properties.engine.simplest import Drawn, simplest_values, some_values
from properties.given import Exact, Given, Infeasible
from spec.number import Truth

CHECK_BUDGET = 20_000_000
MOST_PATHS = 4_000
MOST_DRAWN = 100

Program = Callable[[Given], None]
TRUE = conjunction()


class Refuted(Exception):
    """A promise is broken: the exploration is over."""


@dataclass(frozen=True)
class Counterexample:
    """Promises that are broken, and the exact values that break them."""

    broken: tuple[str, ...]
    values: dict[str, Fraction | bool]


@dataclass
class Outcome:
    """What an exploration showed: paths, promises judged, solver calls, rules that fired, and what is open.

    Attributes:
        exhaustive: whether the paths, with what premises cut off, were found to cover all values.
        assumed: the names of all premises.
        used: of these, the ones in the core of some answer of the solver.
        sequences: for each path, the rules in the order in which they fired.
        witness: values that satisfy all premises of a path on which a promise was judged.
        resources: the work of the solver, as it counts it, without what it took to find the witness.
    """

    paths: int = 0
    promises: int = 0
    checks: int = 0
    exhaustive: bool = False
    rules: set[str] = field(default_factory=set)
    open: list[str] = field(default_factory=list)
    counterexample: Counterexample | None = None
    assumed: set[str] = field(default_factory=set)
    used: set[str] = field(default_factory=set)
    sequences: set[tuple[str, ...]] = field(default_factory=set)
    witness: dict[str, Fraction | bool] | None = None
    resources: int = 0

    @property
    def proved(self) -> bool:
        """Whether every promise holds on every path, and there was something to judge."""
        held = self.counterexample is None and not self.open
        return held and self.paths > 0 and self.promises > 0 and self.witness is not None


@dataclass
class Fork:
    """A decision of a run: what held before it, the branch taken, whether the other one is still to be taken, and
    values on that, if some are known.
    """

    before: list[z3.BoolRef]
    formula: z3.BoolRef
    branch: bool
    other_open: bool
    elsewhere: z3.ModelRef | None = None

    @property
    def literals(self) -> list[z3.BoolRef]:
        """What holds on the branch taken."""
        return [*self.before, self.formula if self.branch else opposite(self.formula)]


@dataclass(frozen=True)
class Merge:
    """What a part returned, how that is defined, and the path that met it; held, so that it keeps its identity."""

    met: tuple[z3.BoolRef, ...]
    numbers: list[Any]
    definitions: list[z3.BoolRef]


@dataclass(frozen=True)
class Judged:
    """What was promised on a path, denied, and the literals under which it was judged."""

    literals: list[z3.BoolRef]
    denials: list[z3.BoolRef]


def solver_for_reals(seed: int = 0) -> z3.Solver:
    """A solver for linear arithmetic with a budget of counted work; the seed is that of its heuristics."""
    solver = z3.SolverFor("QF_LIRA")
    solver.set("rlimit", CHECK_BUDGET)
    if seed:
        solver.set("random_seed", seed)
    return solver


def work_so_far() -> int:
    """The work of all solvers of this process since it began, as they count it."""
    solver = z3.Solver()
    solver.check()
    return int(solver.statistics().get_key_value("rlimit count"))


class Exploration:
    """One depth-first exploration of a program."""

    def __init__(self, program: Program, seed: int = 0) -> None:
        """Prepare to explore; `run` does it."""
        self.program = program
        self.solver = solver_for_reals(seed)
        self.premises: dict[str, z3.BoolRef] = {}
        self.asked: Any = None
        self.forks: list[Fork] = []
        self.model: z3.ModelRef | None = None
        self.drawn = Drawn()
        self.covered: list[list[z3.BoolRef]] = []
        self.judged: list[Judged] = []
        self.outcome = Outcome()
        self.names = count()
        self.merges: dict[tuple[Any, ...], Merge] = {}
        self.definitions: list[z3.BoolRef] = []

    def run(self) -> Outcome:
        """Explore every path, or up to the first counterexample."""
        with suppress(Refuted):
            self.explore_all()
        return self.outcome

    def explore_all(self) -> None:
        """Explore every path."""
        self.solver.push()
        try:
            self.run_path()
            while self.turn():
                self.run_path()
        finally:
            self.solver.pop(len(self.forks) + 1)
        if not self.outcome.open:
            self.check_coverage()

    def premises_so_far(self) -> dict[str, z3.BoolRef]:
        """The premises under which every path begins, by name: none."""
        return {}

    def new_path(self) -> Path:
        """A path that has met nothing yet."""
        return Path(self)

    def turn(self) -> bool:
        """Turn to the next branch not yet taken; False if there is none or the budget of paths is spent."""
        while self.forks and not self.forks[-1].other_open:
            self.leave()
        if self.forks and self.outcome.paths >= MOST_PATHS:
            self.outcome.open.append(f"more than {MOST_PATHS} paths")
            return False
        if self.forks:
            last = self.leave()
            self.fork(Fork(last.before, last.formula, not last.branch, other_open=False))
            self.model = last.elsewhere
        return bool(self.forks)

    def leave(self) -> Fork:
        """Go back to before the last fork."""
        self.solver.pop()
        return self.forks.pop()

    def fork(self, fork: Fork) -> list[z3.BoolRef]:
        """Take a branch; what the solver is told from here on is forgotten when it is left. Return what holds."""
        self.forks.append(fork)
        self.solver.push()
        literals = fork.literals
        tell(self.solver, literals[-1])
        return literals

    def run_path(self) -> None:
        """Run the program once, along the branches chosen so far."""
        path = self.new_path()
        self.premises, self.asked = self.premises_so_far(), None
        token = DECIDE.set(path.decide)
        try:
            self.program(path)
            self.outcome.paths += 1
            self.outcome.sequences.add(tuple(path.fired))
            path.judge()
            if self.outcome.witness is None and path.promises and not self.outcome.open:
                self.outcome.witness = self.witness(path)
        except Infeasible:
            path.judge()
        finally:
            DECIDE.reset(token)
        if path.met < len(self.forks):
            raise EngineError("a replay met fewer forks than the run it repeats")
        self.covered.append(path.literals)

    def possible(self, formula: z3.BoolRef = TRUE) -> bool | None:
        """Whether a formula can hold on the path so far; None if the solver does not know."""
        self.outcome.checks += 1
        if self.asked is None:
            self.asked = references([formula, *self.premises.values()])
        self.asked[0] = formula.ast
        answer = ask(self.solver, self.asked)
        if answer == z3.unsat:
            core = core_of(self.solver)
            self.outcome.used |= {name for name, premise in self.premises.items() if identity_of(premise) in core}
        return None if answer == z3.unknown else bool(answer == z3.sat)

    def premise(self, name: str, truth: Truth) -> None:
        """Let a truth hold on the path from here on, as long as the solver is told the name as well."""
        self.note(name)
        tell(self.solver, disjunction(opposite(self.premises[name]), formula_of(truth)))

    def note(self, name: str) -> None:
        """Take note of a premise."""
        if name not in self.premises:
            self.premises[name] = premise_of(name)
            self.asked = None
            self.outcome.assumed.add(name)

    def witness(self, path: Path) -> dict[str, Fraction | bool] | None:
        """Values that satisfy all premises of this path, and on exact numbers keep all its promises."""
        if self.solver.check(*self.premises.values()) != z3.sat:
            return None
        values = some_values(self.drawn, [*self.definitions, *path.literals])
        exact = self.replay("the witness of the premises", values)
        if exact.broken or not exact.promises:
            raise EngineError(f"the witness of the premises does not keep the promises on exact numbers: {values}")
        return values

    def replay(self, what: str, values: dict[str, Fraction | bool]) -> Exact:
        """Run the program on exact numbers, which must not break a premise before they break a promise."""
        exact = Exact(values)
        try:
            self.program(exact)
        except Infeasible:
            if not exact.broken:
                raise EngineError(f"{what} breaks a premise: {values}") from None
        return exact

    def refute(self, place: list[z3.BoolRef], promise: str, denial: z3.BoolRef) -> None:
        """Find simple values at a place that break a promise, and believe them when they do so on exact numbers."""
        values = simplest_values(self.drawn, [*self.definitions, *place, denial])
        exact = self.replay(f"{promise}: the counterexample", values)
        if promise not in exact.broken:
            raise EngineError(f"{promise}: the counterexample does not replay on exact numbers: {values}")
        self.outcome.counterexample = Counterexample(tuple(exact.broken), values)
        raise Refuted

    @property
    def places(self) -> list[z3.BoolRef]:
        """Where the paths were, and what premises cut off, each as one formula."""
        return [conjunction(*literals) for literals in self.covered]

    def check_coverage(self) -> None:
        """Make sure that the paths, with what premises cut off, leave no values out."""
        solver = solver_for_reals()
        if solver.check(opposite(disjunction(*self.places)), *self.drawn.signs(), *self.definitions) != z3.unsat:
            raise EngineError("the paths explored do not cover all values")
        self.outcome.exhaustive = True


class Path:
    """One run of the program: a `Given` whose values are symbolic."""

    def __init__(self, exploration: Exploration) -> None:
        """Start at the root. Up to the last fork that is held, all has been told and judged before."""
        self.exploration = exploration
        self.met = 0
        self.literals = exploration.forks[-1].literals if exploration.forks else []
        self.decided: dict[int, bool] = {}
        self.model = exploration.model
        self.promised: list[tuple[str, Truth]] = []
        self.merges = 0
        self.promises = 0
        self.fired: list[str] = []

    @property
    def branches(self) -> Iterator[tuple[int, bool]]:
        """The forks met so far, and the branches taken."""
        return ((identity_of(fork.formula), fork.branch) for fork in self.exploration.forks[: self.met])

    @property
    def replayed(self) -> bool:
        """Whether a fork is still ahead that is held."""
        return self.met < len(self.exploration.forks)

    def number(self, name: str, premise: str = "") -> Symbolic:
        """A symbolic real, at least 0."""
        self.exploration.drawn.number(name)
        number = Symbolic.of(name)
        self.tell(premise or f"{name} >= 0", number)
        return number

    def natural(self, name: str) -> Symbolic:
        """A symbolic whole number, at least 0."""
        self.exploration.drawn.natural(name)
        number = Symbolic.of(name, whole=True)
        self.tell(f"{name} >= 0", number)
        return number

    def tell(self, premise: str, number: Symbolic) -> None:
        """Let a number be at least 0."""
        if self.replayed:
            self.exploration.note(premise)
        else:
            self.exploration.premise(premise, number >= 0)

    def flag(self, name: str) -> bool:
        """Either truth value, each on paths of its own."""
        if len(self.exploration.drawn.flags) > MOST_DRAWN:
            raise EngineError(f"more than {MOST_DRAWN} truth values are drawn: the program may not end")
        return bool(SymbolicTruth(self.exploration.drawn.flag(name)))

    def define(self, definitions: list[z3.BoolRef]) -> None:
        """Go on with variables that are defined; they mean nothing to the last model."""
        self.merges += 1
        if not self.replayed:
            tell(self.exploration.solver, *definitions)
            self.model = None

    def shown(self, formula: z3.BoolRef) -> bool | None:
        """Whether a formula holds in the last model; None if there is none."""
        return None if self.model is None else holds_in(self.model, formula)

    def may_hold(self, formula: z3.BoolRef) -> bool:
        """Whether a formula can hold here, for all the solver knows; if so, there is a model of it if it found one."""
        answer = self.exploration.possible(formula)
        self.model = self.exploration.solver.model() if answer else None
        return answer is not False

    def forked(self, formula: z3.BoolRef) -> Fork:
        """A new fork. Nothing is asked about a branch on which the last model is."""
        shown, model = self.shown(formula), self.model
        holds = shown or self.may_hold(formula)
        if not holds:
            self.model = model
        if shown is False:
            return Fork(self.literals, formula, holds, other_open=holds, elsewhere=model)
        other_open = holds and self.exploration.possible(opposite(formula)) is not False
        return Fork(self.literals, formula, holds, other_open)

    def decide(self, formula: z3.BoolRef) -> bool:
        """The branch of this run at a fork. What was decided before on this path is decided.

        Equal formulas have one identity in the solver as long as one of them is held, as those of all forks are.
        """
        identity = identity_of(formula)
        known = self.decided.get(identity)
        if known is not None:
            return known
        forks = self.exploration.forks
        if self.met == len(forks):
            self.literals = self.exploration.fork(self.forked(formula))
        fork = forks[self.met]
        if identity_of(fork.formula) != identity:
            raise EngineError("a replay met another fork than the run it repeats")
        self.met += 1
        self.decided[identity] = fork.branch
        return fork.branch

    def assume(self, premise: Truth, name: str = "a premise without a name") -> None:
        """Cut off what does not satisfy the premise; what was promised before is judged without it."""
        self.judge()
        if self.replayed:
            self.exploration.note(name)
            return
        formula = formula_of(premise)
        self.exploration.covered.append([*self.literals, opposite(formula)])
        self.exploration.premise(name, premise)
        self.literals = [*self.literals, formula]
        if not self.shown(formula):
            self.model = None
            if self.exploration.possible() is False:
                raise Infeasible

    def ensure(self, name: str, promise: Truth) -> None:
        """Take a promise to be judged on this path, or on all into which it forks from here."""
        self.promised.append((name, promise))
        self.promises += 1
        self.exploration.outcome.promises += 1

    def judge(self) -> None:
        """Judge what was promised since the last time: all at once, and one by one if that fails."""
        promised, self.promised = self.promised, []
        if not promised or self.replayed:
            return
        denials = [opposite(formula_of(promise)) for _, promise in promised]
        self.exploration.judged.append(Judged(list(self.literals), denials))
        if self.exploration.possible(disjunction(*denials)) is False:
            return
        for (name, _), denial in zip(promised, denials, strict=True):
            broken = self.exploration.possible(denial)
            if broken is None:
                self.exploration.outcome.open.append(f"{name}: the solver does not know")
            if broken:
                self.exploration.refute(self.literals, name, denial)

    def saw(self, rule: str) -> None:
        """Note that a rule fired on a feasible path."""
        self.fired.append(rule)
        self.exploration.outcome.rules.add(rule)


@lru_cache(maxsize=10_000)
def premise_of(name: str) -> z3.BoolRef:
    """The literal by which the solver knows a premise."""
    return z3.Bool(f"premise: {name}")


Watch = Callable[[Exploration], None]
WATCH: ContextVar[Watch | None] = ContextVar("watch", default=None)


@contextmanager
def watched_by(watch: Watch) -> Iterator[None]:
    """Show a watch every exploration when it is over."""
    token = WATCH.set(watch)
    try:
        yield
    finally:
        WATCH.reset(token)


def explore(program: Program, seed: int = 0) -> Outcome:
    """Judge the promises of a program for all values it may be given."""
    before = work_so_far()
    exploration = Exploration(program, seed)
    outcome = exploration.run()
    outcome.resources = work_so_far() - before
    watch = WATCH.get()
    if watch is not None:
        watch(exploration)
    return outcome
