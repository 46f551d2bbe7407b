"""Property testing: every invariant on random rows, on exact numbers and on floats, with statistics.

The seed is fixed, so that a run can be repeated. The shares of requests that do something of interest are
counted, and a campaign whose inputs are too tame counts for nothing.
"""

from __future__ import annotations

import importlib
import pkgutil
import tempfile
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path
from typing import Any

from hypothesis import HealthCheck, Phase, given, seed, settings
from hypothesis.configuration import set_hypothesis_home_dir

import properties
import reference
import spec
from properties.evidence.deeds import do
from properties.evidence.monitor import ON_ONE_STRING, Monitor, Verdicts
from properties.evidence.relations import RELATIONS, world_of_floats
from properties.evidence.showing import Look, looks
from properties.strategies.rows import Trial, trials
from reference.simulator import Endless
from reference.world import World, world_of
from spec.invariants import OF_ONE_REQUEST, TERMINATION
from spec.profiles import Profile
from spec.rule import GuardError

FLOAT_TOLERANCE = 1e-9
SEED = 20200315
EXAMPLES = 400
ONE_RULE = "rules/one-applies"
FLOORS = {
    "pushes": 0.2,
    "meets a wall": 0.05,
    "crosses an edge": 0.2,
    "meets the push limit": 0.02,
    "on a ring": 0.2,
    "a row in contact": 0.2,
    "a border at a vertex": 0.2,
    "a full circle": 0.03,
    "ticks with a character": 0.3,
}


class Broken(AssertionError):
    """A property fails on a trial."""

    def __init__(self, property_id: str, trial: Trial) -> None:
        """Name the property and the trial."""
        super().__init__(f"{property_id} fails for {trial}")
        self.property_id = property_id
        self.trial = trial


@dataclass
class Campaign:
    """What a run of property tests showed: cases, shares of interest, the simplest failure of each property, looks."""

    cases: int = 0
    shares: Counter[str] = field(default_factory=Counter)
    failures: dict[str, Trial] = field(default_factory=dict)
    looks: set[Look] = field(default_factory=set)
    evaluations: Counter[str] = field(default_factory=Counter)

    @property
    def tame(self) -> list[str]:
        """The shares that do not reach their floor, and the contracts that were evaluated less than once a trial."""
        shares = [name for name, floor in FLOORS.items() if self.shares[name] < floor * self.cases]
        return shares + [one.id for one in ON_ONE_STRING if self.evaluations[one.id] < max(1, self.cases)]


def failing(profile: Profile, trial: Trial, world: World[Any], tolerance: Any, seen: Campaign) -> Iterator[str]:
    """The properties and contracts that fail on a trial, in exact numbers or floats; contracts come last."""
    asked = trial.asked + world.margin * 0
    try:
        deed, record = do(profile, world, trial.body, trial.direction, asked, tolerance)
        seen.shares.update(features(world, trial, {rule for _, rule in record.fired}))
        for mover in {body for body, _ in record.fired}:
            seen.looks |= looks(rule for body, rule in record.fired if body == mover)
        yield from (invariant.id for invariant in OF_ONE_REQUEST if not invariant.holds(deed))
        yield from (check.id for check in RELATIONS if not check.holds(profile, trial, world, tolerance))
        yield from monitored(profile, trial, world, tolerance, seen)
    except GuardError:
        yield ONE_RULE
    except Endless:
        yield TERMINATION.id


def monitored(profile: Profile, trial: Trial, world: World[Any], tolerance: Any, seen: Campaign) -> list[str]:
    """The clauses of contracts that fail in the calls of a trial; on a row no call may miss a requirement either."""
    verdicts = Verdicts()
    monitor = Monitor(profile, world.copy(), trial.direction, tolerance, ON_ONE_STRING, verdicts)
    monitor.run(trial.body, trial.asked + world.margin * 0)
    seen.evaluations.update(verdicts.evaluations)
    return list(dict.fromkeys([*verdicts.unmet, *verdicts.broken]))


def features(world: World[Any], trial: Trial, fired: set[str]) -> list[str]:
    """What of interest there is in a world, in a trial, and in the rules that fired."""
    rooms = [world.clear(*pair) - world.margin for pair in world.neighbours()]
    found = {
        "pushes": "push/request" in fired,
        "meets a wall": "walk/wall" in fired,
        "crosses an edge": "walk/onward" in fired,
        "meets the push limit": "push/limit" in fired,
        "on a ring": world.closed,
        "a row in contact": any(room <= FLOAT_TOLERANCE for room in rooms),
        "a border at a vertex": any(min(world.off_graph(body)) == 0 for body in world.bodies_in_order()),
        "a full circle": world.closed and bool(rooms) and all(room <= FLOAT_TOLERANCE for room in rooms),
        "ticks with a character": bool(trial.keys) and any(body.speed for body in world.bodies),
    }
    return [name for name, there in found.items() if there]


def fix_inputs() -> None:
    """Make the trials depend on the seed alone: Hypothesis also draws constants from all modules that are loaded."""
    set_hypothesis_home_dir(Path(tempfile.gettempdir()) / "graphbody-hypothesis")
    for package in (spec, reference, properties):
        for module in pkgutil.walk_packages(package.__path__, f"{package.__name__}."):
            importlib.import_module(module.name)


def campaign(profile: Profile, floats: bool, examples: int = EXAMPLES) -> Campaign:
    """Try every property on random trials; after a failure go on without the property that failed."""
    fix_inputs()
    result = Campaign()
    while (failure := first_failure(profile, floats, examples, result)) is not None:
        result.failures[failure.property_id] = failure.trial
    return result


def first_failure(profile: Profile, floats: bool, examples: int, result: Campaign) -> Broken | None:
    """Run the trials until a property fails that has not failed before; return its simplest failure."""
    result.cases, result.shares, result.evaluations = 0, Counter(), Counter()

    @seed(SEED)
    @settings(
        max_examples=examples,
        database=None,
        deadline=None,
        phases=(Phase.generate, Phase.shrink),
        suppress_health_check=list(HealthCheck),
        report_multiple_bugs=False,
        print_blob=False,
    )
    @given(trials())
    def every_property_holds(trial: Trial) -> None:
        world: World[Any] = world_of_floats(trial.level) if floats else world_of(trial.level)
        tolerance: Any = FLOAT_TOLERANCE if floats else Fraction(0)
        result.cases += 1
        for property_id in failing(profile, trial, world, tolerance, result):
            if property_id not in result.failures:
                raise Broken(property_id, trial)

    try:
        every_property_holds()
    except Broken as broken:
        return broken
    return None
