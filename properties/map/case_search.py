"""The search for unsupported cases: through all shapes, with as many guidelines kept as can be.

Each shape is gone through once, without any guideline assumed. At the end of each path is asked which cases can happen
there, and with which guidelines kept. So a cell of the table is a witness that keeps the guideline, or says that there
is none in all shapes.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import partial
from itertools import combinations
from typing import Any

import msgspec

from properties.evidence.collect import Asker, Marks, Place, Places, can_vary, collect, possible
from properties.evidence.deeds import do
from properties.evidence.hunt import MOVER, RIGHT, start_in_order
from properties.evidence.witness import step_record
from properties.given import Exact, Given
from properties.map import case_shapes
from properties.map.part import Finding
from properties.worlds.scenes import Shape, scene
from reference.formats.level import level_record
from reference.formats.scenario import ScenarioRecord
from reference.world import World
from spec.case import parts_of, ran_into, some
from spec.guidelines import GUIDELINES, kept_by
from spec.plane import IN_PLANE, negated
from spec.profiles import OF_REQUESTS, Profile
from spec.unsupported import CASES, GENERAL

GROUPS: dict[str, Callable[[], list[Shape]]] = {
    "steps": case_shapes.steps,
    "platforms": case_shapes.platforms,
    "crowds": case_shapes.crowds,
    "overhangs": case_shapes.overhangs,
    "storeys": case_shapes.storeys,
    "short edges": case_shapes.short_edges,
}
UNCATALOGUED = "an invariant is broken, and no case has happened"
CANDIDATES = 3
RANK = {guideline.id: f"G{rank}" for rank, guideline in enumerate(GUIDELINES, start=1)}
ALL = tuple(RANK)
BY_ID = {case.id: case for case in CASES}


def program(profile: Profile, shape: Shape, given: Given) -> Marks:
    """Ask the first body of any scene of a shape to move right: which cases happen, and which guidelines are kept."""
    level, asked = scene(given, shape, guided=False)
    world = World(level)
    start_in_order(given, world)
    deed, record = do(profile, world, MOVER, RIGHT, asked, asked * 0)
    parts = parts_of(deed, record.fired, [(ask.body, ask.distance, ask.moved) for ask in record.asks])
    cases = {case.id: ran_into(case, parts) for case in CASES}
    broken: Any = some(negated(invariant.holds(deed)) for invariant in IN_PLANE)
    known = some(truth for name, truth in cases.items() if name != GENERAL)
    kept = {guideline.id: guideline.kept(world) for guideline in GUIDELINES}
    return {**cases, **kept, UNCATALOGUED: broken & negated(known)}


@dataclass(frozen=True)
class Witness:
    """A scenario in which a case happens: the size of its shape, its numbers in brief, and what its level keeps."""

    size: tuple[int, ...]
    numbers: tuple[int, Fraction]
    kept: frozenset[str]
    scenario: Any

    @property
    def rank(self) -> Any:
        """Fewest bodies, then fewest edges, then simplest numbers."""
        return self.size, self.numbers

    def serves(self, other: Witness) -> bool:
        """Whether it is simpler than another, and keeps what that keeps."""
        return self.rank < other.rank and self.kept >= other.kept


def best(witnesses: Sequence[Witness]) -> list[Witness]:
    """Those that no other one serves for, the simplest first; of equals the first."""
    found: list[Witness] = []
    for one in sorted(witnesses, key=lambda one: one.rank):
        if not any(other.kept >= one.kept for other in found):
            found.append(one)
    return found


@dataclass
class Search:
    """A search through shapes under a profile, and what it has found so far, case by case."""

    profile: Profile
    paths: int = 0
    shapes: int = 0
    found: dict[str, list[Witness]] = field(default_factory=lambda: {case.id: [] for case in CASES})
    uncatalogued: list[Any] = field(default_factory=list)

    def go_through(self, shape: Shape) -> None:
        """Look at every path of a shape."""
        places = collect(partial(program, self.profile, shape))
        self.shapes, self.paths = self.shapes + 1, self.paths + len(places.found)
        for place in places.found:
            asker = places.asker(place)
            for name in possible(place, BY_ID):
                if asker.can(name):
                    self.look(places, asker, shape, name)
            if asker.can(UNCATALOGUED):
                self.uncatalogued.append(self.witness(shape, places.values(place, UNCATALOGUED)).scenario)

    def look(self, places: Places, asker: Asker, shape: Shape, case: str) -> None:
        """Find witnesses of a case at a place, with as many guidelines kept as can be."""
        for kept in keepable(asker.place):
            if self.wanted(case, kept, shape) and asker.can(case, *kept):
                self.found[case].append(self.witness(shape, places.values(asker.place, case, *kept)))

    def wanted(self, case: str, kept: frozenset[str], shape: Shape) -> bool:
        """Whether there is not enough yet that keeps as much: one of a smaller shape, or a few of this size."""
        enough = [one.size for one in self.found[case] if one.kept >= kept]
        return not any(size < shape.size for size in enough) and len(enough) < CANDIDATES

    def witness(self, shape: Shape, values: Mapping[str, Fraction | bool]) -> Witness:
        """The scenario of some values."""
        level, asked = scene(Exact(values), shape, guided=False)
        numbers = [Fraction(value) for value in values.values()]
        record = ScenarioRecord(
            format="graphbody/scenario@1",
            name="witness",
            level=level_record(level, "witness"),
            profile=self.profile.name,
            steps=[step_record((level.bodies[MOVER].name, asked))],
        )
        simple = max(number.denominator for number in numbers), sum(numbers, Fraction(0))
        return Witness(
            shape.size, simple, frozenset(kept_by(World(level))), msgspec.json.decode(msgspec.json.encode(record))
        )


def keepable(place: Place) -> Iterator[frozenset[str]]:
    """The sets of guidelines that may be kept at a place, the largest first: with all that are kept there anyway."""
    open_ = [name for name in possible(place, RANK) if can_vary(place, name)]
    always = frozenset(possible(place, RANK)) - frozenset(open_)
    for size in range(len(open_), -1, -1):
        for some_of_them in combinations(open_, size):
            yield always | frozenset(some_of_them)


def look_through(profile: str, group: str) -> Finding:
    """Go through a group of shapes under a profile."""
    search = Search(OF_REQUESTS[profile])
    shapes = sorted(GROUPS[group](), key=lambda shape: shape.size)
    for shape in shapes:
        search.go_through(shape)
    return {
        "shapes": search.shapes,
        "paths": search.paths,
        "bodies": max(shape.size[0] for shape in shapes),
        "uncatalogued": search.uncatalogued,
        "cases": {name: [as_json(one) for one in best(found)] for name, found in search.found.items()},
    }


def as_json(one: Witness) -> Any:
    """A witness as plain data."""
    above, below = one.numbers[1].as_integer_ratio()
    numbers, kept = [one.numbers[0], above, below], [name for name in ALL if name in one.kept]
    return {"size": list(one.size), "numbers": numbers, "kept": kept, "scenario": one.scenario}


def from_json(found: Any) -> Witness:
    """A witness from plain data."""
    denominator, above, below = found["numbers"]
    numbers = denominator, Fraction(above, below)
    return Witness(tuple(found["size"]), numbers, frozenset(found["kept"]), found["scenario"])
