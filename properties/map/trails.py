"""Trails: each way that a request can go in a shape, with what holds at its start and what it breaks, as formulas.

The rules are explored once, with no guideline assumed; which conditions exclude what is broken is asked afterwards.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from typing import Any

import z3

from properties.contracts.request import judged
from properties.engine.explore import EngineError, Exploration, Path, Program, solver_for_reals
from properties.engine.reals import formula_of
from properties.engine.simplest import Drawn, simplest_values
from properties.evidence.deeds import do
from properties.given import Exact, Given
from properties.map.terrains import MOVER, RIGHT, Shape, any_level
from reference.world import World
from spec.case import parts_of, ran_into, some
from spec.conditions import (
    ALONE,
    LEDGES_CLEAR,
    NOBODY_RIDES,
    PLANE_START,
    ROOMY_GROUNDS,
    SHORT_REQUESTS,
    TWO_AT_MOST,
)
from spec.guidelines import GUIDELINES
from spec.invariants import Invariant
from spec.number import Truth
from spec.plane import HEIGHT_KEPT, IN_PLANE, NEVER_RAISED, negated
from spec.profiles import Profile
from spec.unsupported import CASES

CONDITIONS = (SHORT_REQUESTS, ROOMY_GROUNDS, NOBODY_RIDES, LEDGES_CLEAR, TWO_AT_MOST, ALONE)
GUIDELINE_IDS = tuple(one.id for one in GUIDELINES)
NAMES = (*GUIDELINE_IDS, *(one.id for one in CONDITIONS))
CATALOGUES = {
    "no case happened": CASES,
    "no case happened but U9": tuple(case for case in CASES if case.id != "unsupported/other-strings"),
}
"""The catalogue of cases; and without the one that says of any two strings what the invariants say."""


def at_start(world: Any, asked: Any) -> dict[str, Truth]:
    """Which guidelines and conditions hold at the start."""
    kept: dict[str, Truth] = {one.id: one.kept(world) for one in GUIDELINES}
    return kept | {one.id: one.holds(world, asked) for one in CONDITIONS}


def judged_in(shape: Shape) -> tuple[Invariant, ...]:
    """The invariants that speak of a shape: what is said of level ground is not asked on a slope."""
    return tuple(one for one in IN_PLANE if not shape.tilt or one not in (NEVER_RAISED, HEIGHT_KEPT))


Starts = dict[object, dict[str, Truth]]
"""What holds at a start, by the order of its bodies: over level ground it depends on nothing else of a path."""


def order_of(world: World[Any]) -> object:
    """Who is beside whom, and which edges borders are on."""
    edges = tuple((body.left.edge, body.right.edge) for body in world.bodies)
    return edges, tuple(tuple(row.order) for row in world.rows)


def request_in(shape: Shape, catalogue: bool, starts: Starts, profile: Profile, given: Given) -> None:
    """Ask the first body of any level of a shape to move to the right; say what held before and what holds after."""
    level, asked = any_level(given, shape)
    world = World(level)
    start = {} if shape.tilt else starts.setdefault(order_of(world), {})
    if not start:
        start.update({PLANE_START.id: PLANE_START.holds(world, asked), **at_start(world, asked)})
    given.assume(start[PLANE_START.id], PLANE_START.id)
    for name in NAMES:
        given.ensure(name, start[name])
    deed, record = do(profile, world, MOVER, RIGHT, asked, asked * 0)
    for _, rule in record.fired:
        given.saw(rule)
    for invariant in judged_in(shape):
        given.ensure(invariant.id, invariant.holds(deed))
    if catalogue:
        parts = parts_of(deed, record.fired, [(ask.body, ask.distance, ask.moved) for ask in record.asks])
        for name, cases in CATALOGUES.items():
            given.ensure(name, negated(some(ran_into(case, parts) for case in cases)))


@dataclass(frozen=True)
class Trail:
    """One path of the rules: the literals that lead along it, and all that is said on it, as formulas by name."""

    shape: Shape
    drawn: Drawn
    literals: Sequence[z3.BoolRef]
    said: Mapping[str, z3.BoolRef]
    fired: frozenset[str]

    @property
    def denials(self) -> dict[str, z3.BoolRef]:
        """For each promise that is not plainly kept on this trail, that it is broken."""
        promises = {name: said for name, said in self.said.items() if name not in (*NAMES, *CATALOGUES)}
        return {name: z3.Not(said) for name, said in promises.items() if not z3.is_true(said)}


class Following(Path):
    """A path that writes down what is said on it, and judges nothing."""

    def __init__(self, exploration: Exploration) -> None:
        """Start with nothing said."""
        super().__init__(exploration)
        self.said: dict[str, z3.BoolRef] = {}

    def ensure(self, name: str, promise: Truth) -> None:
        """Write down what is said."""
        self.said[name] = formula_of(promise)
        self.promises += 1


class Survey(Exploration):
    """An exploration that keeps every path on which something was said."""

    def __init__(self, program: Program) -> None:
        """Nothing is kept yet."""
        super().__init__(program)
        self.kept: list[Following] = []

    def new_path(self) -> Path:
        """A path that writes down what is said on it."""
        self.kept.append(Following(self))
        return self.kept[-1]

    def witness(self, path: Path) -> None:
        """Whether premises can be met is asked of each trail."""


def trails(shape: Shape, profile: Profile, catalogue: bool = False) -> list[Trail]:
    """Every way that a request can go in a shape.

    Raises:
        EngineError: if the exploration is not exhaustive.
    """
    survey = Survey(partial(judged, partial(request_in, shape, catalogue, {}), profile))
    outcome = survey.run()
    if not outcome.exhaustive:
        raise EngineError(f"{shape}: {outcome.open}")
    return [
        Trail(shape, survey.drawn, path.literals, path.said, frozenset(path.fired)) for path in survey.kept if path.said
    ]


@dataclass(frozen=True)
class Breach:
    """What is broken although some conditions hold, and the trail on which it is."""

    conditions: frozenset[str]
    invariant: str
    trail: Trail


def can_hold(solver: z3.Solver, formulas: Sequence[z3.BoolRef]) -> bool:
    """Whether formulas can hold together with what a solver knows.

    Raises:
        EngineError: if the solver does not know.
    """
    answer = solver.check(*formulas)
    if answer == z3.unknown:
        raise EngineError(f"the solver does not know: {solver.reason_unknown()}")
    return bool(answer == z3.sat)


def largest(solver: z3.Solver, conditions: Mapping[str, z3.BoolRef]) -> frozenset[str]:
    """A set of conditions that can hold together with what a solver knows, and to which none can be added.

    The solver has just found a model.
    """
    model = solver.model()
    held = {name for name, formula in conditions.items() if z3.is_true(model.eval(formula, model_completion=True))}
    for name in conditions:
        if name not in held and can_hold(solver, [conditions[one] for one in (*held, name)]):
            held.add(name)
    return frozenset(held)


def within(sets: Sequence[frozenset[str]], one: frozenset[str]) -> bool:
    """Whether a set is part of one of several."""
    return any(one <= other for other in sets)


def breaches(found: Sequence[Trail], names: Sequence[str] = NAMES) -> dict[str, list[Breach]]:
    """For each invariant the maximal sets of conditions with which it can be broken, each on its smallest trail.

    On each trail only such sets are asked for as are not part of one that is known, until there are no more.
    """
    result: dict[str, list[Breach]] = {}
    for trail in sorted(found, key=lambda one: one.shape.size):
        solver = solver_on(trail, ())
        if not can_hold(solver, [z3.Or(z3.BoolVal(False), *trail.denials.values())]):
            continue
        for invariant, denial in trail.denials.items():
            solver.push()
            solver.add(denial)
            result[invariant] = extended(result.get(invariant, []), invariant, trail, solver, names)
            solver.pop()
    return {invariant: known for invariant, known in result.items() if known}


def extended(
    known: list[Breach], invariant: str, trail: Trail, solver: z3.Solver, names: Sequence[str]
) -> list[Breach]:
    """The known maximal sets, and those of one trail on which a solver knows that an invariant is broken."""
    conditions = {name: trail.said[name] for name in names}
    for breach in known:
        solver.add(beyond(breach.conditions, conditions))
    while can_hold(solver, []):
        breach = Breach(largest(solver, conditions), invariant, trail)
        known = [*(one for one in known if not one.conditions <= breach.conditions), breach]
        solver.add(beyond(breach.conditions, conditions))
    return known


def beyond(held: frozenset[str], conditions: Mapping[str, z3.BoolRef]) -> z3.BoolRef:
    """Some condition outside a set holds."""
    return z3.Or(z3.BoolVal(False), *(formula for name, formula in conditions.items() if name not in held))


def falling(found: Sequence[Trail]) -> int:
    """The trails on which a body falls and all that can be assumed holds, for any number of bodies: what suffices is
    not so because nothing happens.
    """
    names = [name for name in NAMES if name not in (TWO_AT_MOST.id, ALONE.id)]
    return sum("leave/fall" in trail.fired and can_hold(solver_on(trail, names), []) for trail in found)


def solver_on(trail: Trail, names: Sequence[str]) -> z3.Solver:
    """A solver that knows what leads along a trail, and that all that is named holds."""
    solver = solver_for_reals()
    solver.add(*trail.drawn.signs(), *trail.literals, *(trail.said[name] for name in names))
    return solver


def first_within(found: Sequence[Trail]) -> list[Breach]:
    """For each invariant that can be broken though all guidelines hold, the smallest trail on which it is."""
    return firsts(found, GUIDELINE_IDS)


def first_uncatalogued(found: Sequence[Trail], catalogue: str) -> list[Breach]:
    """The same, though no case of a catalogue happened."""
    return firsts(found, (*GUIDELINE_IDS, catalogue))


def firsts(found: Sequence[Trail], names: Sequence[str]) -> list[Breach]:
    """For each invariant that can be broken though all that is named holds, the smallest trail on which it is."""
    result: dict[str, Breach] = {}
    for trail in sorted(found, key=lambda one: one.shape.size):
        solver = solver_on(trail, names)
        for invariant, denial in trail.denials.items():
            if invariant not in result and can_hold(solver, [denial]):
                result[invariant] = Breach(frozenset(names), invariant, trail)
    return [result[name] for name in sorted(result)]


def witness(breach: Breach) -> dict[str, Fraction | bool]:
    """The simplest values on the trail of a breach that keep its conditions and break its invariant."""
    trail = breach.trail
    kept = [trail.said[name] for name in sorted(breach.conditions)]
    return simplest_values(trail.drawn, [*trail.literals, *kept, trail.denials[breach.invariant]])


def replayed(breach: Breach, values: Mapping[str, Fraction | bool], profile: Profile) -> None:
    """Run the values of a breach on exact numbers: its conditions hold, and its invariant is broken.

    Raises:
        EngineError: if it is not so.
    """
    exact, catalogue = Exact(values), any(name in CATALOGUES for name in breach.conditions)
    judged(partial(request_in, breach.trail.shape, catalogue, {}), profile, exact)
    if breach.invariant not in exact.broken or breach.conditions & set(exact.broken):
        raise EngineError(f"{breach.invariant}: the witness does not replay on exact numbers: {values}")
