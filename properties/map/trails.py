"""What is surveyed for the theorem table: a request in any level of a shape, what holds before it and what after it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import partial
from typing import Any

from properties.contracts.request import judged
from properties.engine.formulas import EngineError
from properties.engine.survey import Breach, Trail, firsts, surveyed
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


def trails(shapes: Sequence[Shape], profile: Profile, catalogue: bool = False) -> list[Trail]:
    """Every way that a request can go in some shapes, which are looked at from the smallest on."""
    conditions = frozenset((*NAMES, *CATALOGUES))
    return [
        trail
        for place, shape in sorted(enumerate(shapes), key=lambda one: one[1].size)
        for trail in surveyed(partial(judged, partial(request_in, shape, catalogue, {}), profile), conditions, place)
    ]


def falling(found: Sequence[Trail]) -> int:
    """The trails on which a body falls and all that can be assumed holds, for any number of bodies: what suffices is
    not so because nothing happens.
    """
    names = [name for name in NAMES if name not in (TWO_AT_MOST.id, ALONE.id)]
    return sum("leave/fall" in trail.fired and trail.can_keep(names) for trail in found)


def first_uncatalogued(found: Sequence[Trail], catalogue: str) -> list[Breach]:
    """For each invariant that is broken within the guidelines though no case happened, the smallest trail."""
    return firsts(found, (*GUIDELINE_IDS, catalogue))


def replayed(breach: Breach, shape: Shape, values: Mapping[str, Fraction | bool], profile: Profile) -> None:
    """Run the values of a breach on exact numbers: its conditions hold, and its promise is broken.

    Raises:
        EngineError: if it is not so.
    """
    exact, catalogue = Exact(values), any(name in CATALOGUES for name in breach.conditions)
    judged(partial(request_in, shape, catalogue, {}), profile, exact)
    if breach.promise not in exact.broken or breach.conditions & set(exact.broken):
        raise EngineError(f"{breach.promise}: the witness does not replay on exact numbers: {values}")
