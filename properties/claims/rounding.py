"""The claims about rounded arithmetic: what the tolerance of the validator rests on."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from properties.claims.claim import Claim, Count, Obligation, Verdict
from properties.claims.string import name_of
from properties.contracts import floats, rounding
from spec.conditions import EDGES_LONG, IN_ORDER, ONE_STRING
from spec.graph import Direction
from spec.profiles import THESIS
from spec.rounding import NEARLY_EXACT

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
