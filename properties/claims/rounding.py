"""The claims about rounded arithmetic: what the tolerance of the validator rests on."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from typing import Any

from properties.claims.claim import Claim, Count, Obligation, Verdict
from properties.claims.string import name_of
from properties.contracts import floats, rounded_steps, rounding
from properties.worlds.storeys import Member, Setting
from spec.conditions import EDGES_LONG, IN_ORDER, ONE_STRING
from spec.graph import Direction
from spec.profiles import REPAIRED, THESIS
from spec.rounding import MARGIN_NEARLY_KEPT, NEARLY_EXACT, STEP_NEARLY_EXACT
from spec.storeys import AtWall, Contact, Drive, Mark, Seat

STRING, ORDERED, LONG = ONE_STRING.id, IN_ORDER.id, EDGES_LONG.id


def of_border(program: Callable[..., None], closed: bool, direction: Direction, last: bool) -> Obligation:
    """An obligation on any border on any string, moving in a direction, on the last edge or before it."""

    def of_profile(profile: Any, given: Any) -> None:
        program(profile, given, closed, direction, last)

    shape, where = "ring" if closed else "line", "last edge" if last else "an edge follows"
    name = f"{name_of(program)} ({shape}, {direction.name.lower()}, {where})"
    return Obligation(name, of_profile, (STRING, ORDERED, LONG))


PARTS = (rounding.segment_is_nearly_exact, rounding.walk_is_nearly_exact)
NEARLY = (
    Obligation(name_of(rounding.request_says_nearly_what_it_does), rounding.request_says_nearly_what_it_does),
    *(
        of_border(program, closed, direction, last)
        for program in PARTS
        for closed in (False, True)
        for direction in Direction
        for last in (True, False)
    ),
)


def of_push(direction: Direction) -> Obligation:
    """An obligation on whoever pushes on one edge, in a direction."""

    def of_profile(profile: Any, given: Any) -> None:
        rounding.push_keeps_the_margin_nearly(profile, given, direction)

    name = f"{name_of(rounding.push_keeps_the_margin_nearly)} ({direction.name.lower()})"
    return Obligation(name, of_profile, (STRING, ORDERED))


PUSHES = tuple(map(of_push, Direction))
STILL = Drive(Fraction(0))
PAIR = Setting("two", (Member(0, STILL), Member(0, STILL)))
WALL = Setting("one and a wall", (Member(0, STILL),), (1,))
RIDER = Setting("one on another", (Member(0, STILL), Member(1, STILL, 0)))
LEDGE = Setting("one on ground", (Member(1, STILL),), (1,))


def of_instant(setting: Setting, kind: type[Mark], way: Direction | None = None) -> Obligation:
    """An obligation on what comes of a kind to those that a setting has, whatever else is in the world."""

    def of_profile(profile: Any, given: Any) -> None:
        rounded_steps.errors_spread_so(profile, given, setting, kind, way)

    said = setting.name if way is None else f"{setting.name}, {way.name.lower()}"
    return Obligation(f"{name_of(rounded_steps.errors_spread_so)} ({said})", of_profile)


def on_a_ring(setting: Setting) -> Setting:
    """The same setting on a ring."""
    return replace(setting, name=f"{setting.name} on a ring", ring=True)


ROUND: tuple[tuple[Setting, type[Mark]], ...] = ((PAIR, Contact), (WALL, AtWall), (LEDGE, Seat))
INSTANTS = (
    *(of_instant(one, kind) for one, kind in (*ROUND, (RIDER, Seat))),
    Obligation(name_of(rounded_steps.first_comes_nearly_first), rounded_steps.first_comes_nearly_first),
)
ON_RINGS = (
    *(of_instant(on_a_ring(one), kind) for one, kind in ROUND),
    *(of_instant(on_a_ring(RIDER), Seat, way) for way in Direction),
)


def counted(name: str, about: str, sentence: str, source: str, program: Callable[[Any], int]) -> Claim:
    """A claim on rows in floats."""
    count = Count(name_of(program), program)
    return Claim(f"claim/{name}", "rounding", sentence, source, about, THESIS, (), Verdict.TESTED, counts=(count,))


CLAIMS: tuple[Claim, ...] = (
    Claim(
        "claim/nearly-exact",
        "rounding",
        NEARLY_EXACT.sentence,
        NEARLY_EXACT.source,
        NEARLY_EXACT.id,
        THESIS,
        (STRING, ORDERED, LONG),
        Verdict.PROVED,
        NEARLY,
        long=True,
    ),
    Claim(
        "claim/margin-nearly-kept",
        "rounding",
        MARGIN_NEARLY_KEPT.sentence,
        MARGIN_NEARLY_KEPT.source,
        MARGIN_NEARLY_KEPT.id,
        THESIS,
        (STRING, ORDERED),
        Verdict.PROVED,
        PUSHES,
    ),
    Claim(
        "claim/step-nearly-exact",
        "rounding",
        STEP_NEARLY_EXACT.sentence,
        STEP_NEARLY_EXACT.source,
        STEP_NEARLY_EXACT.id,
        REPAIRED,
        (),
        Verdict.PROVED,
        INSTANTS,
    ),
    Claim(
        "claim/step-nearly-exact-on-rings",
        "rounding",
        "What `invariant/step-nearly-exact` says holds on a ring of two that meet, of who comes to a wall, and of who "
        "loses a support, with 6 roundings, 3, and 12: a place that comes round is rounded once more.",
        STEP_NEARLY_EXACT.source,
        STEP_NEARLY_EXACT.id,
        REPAIRED,
        (),
        Verdict.PROVED,
        ON_RINGS,
        long=True,
    ),
    counted(
        "long-rows-need-more",
        NEARLY_EXACT.id,
        "However many roundings one allows a request, a row that is long enough is off by more, but by fewer than 16 "
        "for each walk.",
        "4.2; R6, R20",
        floats.long_rows_need_more,
    ),
    counted(
        "losses-add-up",
        "clearance/too-near",
        "A box that is pushed a little, again and again, comes nearer than the margin by more than one request is off: "
        "towards a body nearer than the margin nothing is free, and nothing is put right.",
        "6.2.1; R24, A10",
        floats.losses_add_up,
    ),
)
