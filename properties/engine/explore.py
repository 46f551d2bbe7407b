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
from itertools import count
from typing import Any

import z3

from properties.engine.formulas import ask, conjunction, disjunction, opposite, tell
from properties.engine.reals import DECIDE, Symbolic, SymbolicTruth, formula_of
from properties.engine.simplest import Drawn, simplest_values
from properties.given import Exact, Given, Infeasible
from spec.number import Truth

CHECK_BUDGET = 20_000_000
MOST_PATHS = 4_000
MOST_DRAWN = 100

Program = Callable[[Given], None]


class EngineError(Exception):
    """The engine cannot vouch for its own run."""


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
        resources: the work of the solver, as it counts it, without what it took to make the witness simple.
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
    """A decision of a run, and whether its other branch is still to be taken."""

    formula: z3.BoolRef
    branch: bool
    other_open: bool


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
        self.forks: list[Fork] = []
        self.drawn = Drawn()
        self.covered: list[list[z3.BoolRef]] = []
        self.judged: list[Judged] = []
        self.outcome = Outcome()
        self.names = count()
        self.merges: dict[tuple[int, ...], Merge] = {}
        self.definitions: list[z3.BoolRef] = []

    def run(self) -> Outcome:
        """Explore every path, or up to the first counterexample."""
        with suppress(Refuted):
            self.explore_all()
        return self.outcome

    def explore_all(self) -> None:
        """Explore every path."""
        self.run_path()
        while self.turn():
            self.run_path()
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
            self.forks.pop()
        if self.forks and self.outcome.paths >= MOST_PATHS:
            self.outcome.open.append(f"more than {MOST_PATHS} paths")
            return False
        if self.forks:
            last = self.forks.pop()
            self.forks.append(Fork(last.formula, not last.branch, other_open=False))
        return bool(self.forks)

    def run_path(self) -> None:
        """Run the program once, along the branches chosen so far."""
        path = self.new_path()
        self.premises = self.premises_so_far()
        token = DECIDE.set(path.decide)
        self.solver.push()
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
            self.solver.pop()
            DECIDE.reset(token)
        if path.met < len(self.forks):
            raise EngineError("a replay met fewer forks than the run it repeats")
        self.covered.append(path.literals)

    def possible(self, *formulas: z3.BoolRef) -> bool | None:
        """Whether formulas can hold on the path so far; None if the solver does not know."""
        self.outcome.checks += 1
        answer = ask(self.solver, *formulas, *self.premises.values())
        if answer == z3.unsat:
            core = {premise.get_id() for premise in self.solver.unsat_core()}
            self.outcome.used |= {name for name, premise in self.premises.items() if premise.get_id() in core}
        return None if answer == z3.unknown else bool(answer == z3.sat)

    def premise(self, name: str, formula: z3.BoolRef) -> None:
        """Let a formula hold on the path from here on, as long as the solver is told the name as well."""
        self.outcome.assumed.add(name)
        known = self.premises.setdefault(name, z3.Bool(f"premise: {name}"))
        tell(self.solver, disjunction(opposite(known), formula))

    def witness(self, path: Path) -> dict[str, Fraction | bool] | None:
        """Simple values that satisfy all premises of this path, and on exact numbers keep all its promises."""
        if self.solver.check(*self.premises.values()) != z3.sat:
            return None
        values = simplest_values(self.drawn, [*self.definitions, *path.literals])
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
        """Start at the root."""
        self.exploration = exploration
        self.met = 0
        self.literals: list[z3.BoolRef] = []
        self.decided: dict[int, bool] = {}
        self.model: z3.ModelRef | None = None
        self.promised: list[tuple[str, z3.BoolRef]] = []
        self.merges = 0
        self.promises = 0
        self.fired: list[str] = []

    def number(self, name: str, premise: str = "") -> Symbolic:
        """A symbolic real, at least 0."""
        self.exploration.drawn.number(name)
        number = Symbolic.of(name)
        self.exploration.premise(premise or f"{name} >= 0", formula_of(number >= 0))
        return number

    def natural(self, name: str) -> Symbolic:
        """A symbolic whole number, at least 0."""
        term = self.exploration.drawn.natural(name)
        self.exploration.premise(f"{name} >= 0", term >= 0)
        return Symbolic.of(name, whole=True)

    def flag(self, name: str) -> bool:
        """Either truth value, each on paths of its own."""
        if len(self.exploration.drawn.flags) > MOST_DRAWN:
            raise EngineError(f"more than {MOST_DRAWN} truth values are drawn: the program may not end")
        return bool(SymbolicTruth(self.exploration.drawn.flag(name)))

    def take(self, literal: z3.BoolRef) -> None:
        """Go on where a literal holds."""
        tell(self.exploration.solver, literal)
        self.note(literal)

    def note(self, literal: z3.BoolRef) -> None:
        """Take note of what holds from here on; the last model may not know."""
        self.literals.append(literal)
        if self.model is not None and not z3.is_true(self.model.eval(literal, model_completion=True)):
            self.model = None

    def define(self, definitions: list[z3.BoolRef]) -> None:
        """Go on with variables that are defined; they mean nothing to the last model."""
        tell(self.exploration.solver, *definitions)
        self.merges += 1
        self.model = None

    def may_hold(self, formula: z3.BoolRef) -> bool:
        """Whether a formula can hold here, for all the solver knows; the last model may show it at once."""
        if self.model is not None and z3.is_true(self.model.eval(formula, model_completion=True)):
            return True
        answer = self.exploration.possible(formula)
        if answer:
            self.model = self.exploration.solver.model()
        return answer is not False

    def decide(self, formula: z3.BoolRef) -> bool:
        """The branch of this run at a fork. What was decided before on this path is decided.

        Equal formulas have one identity in the solver as long as one of them is held, as those of all forks are.
        """
        known = self.decided.get(formula.get_id())
        if known is not None:
            return known
        forks = self.exploration.forks
        if self.met == len(forks):
            holds = self.may_hold(formula)
            forks.append(Fork(formula, holds, other_open=holds and self.may_hold(opposite(formula))))
        fork = forks[self.met]
        if fork.formula.get_id() != formula.get_id():
            raise EngineError("a replay met another fork than the run it repeats")
        self.met += 1
        self.take(fork.formula if fork.branch else opposite(fork.formula))
        self.decided[fork.formula.get_id()] = fork.branch
        return fork.branch

    def assume(self, premise: Truth, name: str = "a premise without a name") -> None:
        """Cut off what does not satisfy the premise; what was promised before is judged without it.

        Up to the last fork that is replayed, the run before has shown that it can be satisfied.
        """
        self.judge()
        formula = formula_of(premise)
        self.exploration.covered.append([*self.literals, opposite(formula)])
        self.exploration.premise(name, formula)
        self.note(formula)
        replayed = self.met < len(self.exploration.forks)
        if not replayed and self.exploration.possible() is False:
            raise Infeasible

    def ensure(self, name: str, promise: Truth) -> None:
        """Take a promise to be judged on this path, or on all into which it forks from here."""
        self.promised.append((name, opposite(formula_of(promise))))
        self.promises += 1
        self.exploration.outcome.promises += 1

    def judge(self) -> None:
        """Judge what was promised since the last time: all at once, and one by one if that fails."""
        promised, self.promised = self.promised, []
        if not promised:
            return
        denials = [denial for _, denial in promised]
        self.exploration.judged.append(Judged(list(self.literals), denials))
        if self.exploration.possible(disjunction(*denials)) is False:
            return
        for name, denial in promised:
            broken = self.exploration.possible(denial)
            if broken is None:
                self.exploration.outcome.open.append(f"{name}: the solver does not know")
            if broken:
                self.exploration.refute(self.literals, name, denial)

    def saw(self, rule: str) -> None:
        """Note that a rule fired on a feasible path."""
        self.fired.append(rule)
        self.exploration.outcome.rules.add(rule)


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
