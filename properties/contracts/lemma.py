"""From the contract of a request to whole rows: what it leaves behind, what two requests do, a full circle.

Each obligation takes one body, or one pair of neighbours, of any row; all else is what the contract says of it.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from properties.contracts.contract import (
    ALONG,
    REQUEST,
    REQUEST_EXACT,
    SEGMENT_EXACT,
    Ahead,
    Call,
    Contract,
    promise,
    stand_in_for,
)
from properties.contracts.request import any_ahead, run_segment
from properties.given import Given
from properties.worlds.window import Capacity, lonely_window
from spec.conditions import FREE_SPACE, IN_ORDER, MARGINS_KEPT
from spec.invariants import every
from spec.rules.request import Rules


def answered(given: Given, name: str, asked: Any, ahead: Ahead) -> Call:
    """What a request does by its contract, with something ahead."""
    moved, pushed = given.number(f"moved by {name}"), given.number(f"pushed by {name}")
    call = Call(asked=asked, moved=moved, ahead=ahead, pushed=pushed, capacity=ahead.capacity())
    for contract in (REQUEST, REQUEST_EXACT):
        stand_in_for(given, contract, call)
    return call


def two_requests_are_one(rules: Rules, given: Given) -> None:
    """By the contract: a request for a + b moves body and neighbour as a request for a, then one for b.

    `regained` is what the first request gives the end of a chain that has come round to its mover; it is 0 but on
    a ring, and there the claim's premise is that both distances together fit into the free space.
    """
    a, b, ahead = given.number("first distance"), given.number("second distance"), any_ahead(given)
    both, first = answered(given, "both", a + b, ahead), answered(given, "the first", a, ahead)
    later = ahead.after(first.moved, first.pushed)
    if ahead.neighbour is not None and given.flag("on a ring"):
        regained = given.number("regained on a ring")
        given.assume((regained == 0) | (both.moved == a + b), FREE_SPACE.id)
        later = replace(later, neighbour=later.neighbour + regained)
    second = answered(given, "the second", b, later)
    given.ensure("the body moves as far", first.moved + second.moved == both.moved)
    given.ensure("the neighbour moves as far", first.pushed + second.pushed == both.pushed)


def gap_after(given: Given, contract: Contract, ahead: Ahead) -> Any:
    """The gap of any two neighbours after any request of a row, by a contract.

    The one behind moves by a request that keeps the contract, or not at all. The one ahead is moved by that request
    alone. Where it is the mover of the whole chain, it moves on by itself when the chain has come to rest: the gap to
    it only grows then.
    """
    if not given.flag("the one behind moves"):
        return ahead.gap
    call = any_call(given, contract, ahead)
    return ahead.gap + call.pushed - call.moved


def any_call(given: Given, contract: Contract, ahead: Ahead) -> Call:
    """Any request that keeps a contract; its neighbour can move by anything."""
    spare, able = given.natural("bodies that may be asked"), given.number("capacity of the neighbour")
    ahead = replace(ahead, spare=spare, pushes=given.flag("it may push"), neighbour=able)
    asked, moved, pushed = given.number("distance asked"), given.number("moved"), given.number("pushed")
    call = Call(asked=asked, moved=moved, ahead=ahead, pushed=pushed, capacity=ahead.capacity())
    stand_in_for(given, contract, call)
    return call


def pair(given: Given, condition: str) -> Ahead:
    """Any two neighbours, in order; the premise is the one of a condition."""
    margin = given.number("margin")
    return Ahead(margin, given.number("gap", condition), None, None, margin * 0)


def neighbours_stay_in_order(rules: Rules, given: Given) -> None:
    """Any two neighbours, after any request: they are in order again, as the next request requires."""
    ahead = pair(given, IN_ORDER.id)
    asked = given.number("distance asked next")
    later = replace(ahead, gap=gap_after(given, REQUEST, ahead))
    promise(given, REQUEST, Call(asked=asked, moved=asked, ahead=later), REQUEST.requires)


def neighbours_stay_apart(rules: Rules, given: Given) -> None:
    """Any two neighbours, after any request: they are the margin apart again, as the next request requires."""
    ahead = pair(given, IN_ORDER.id)
    given.assume(ahead.gap >= ahead.margin, MARGINS_KEPT.id)
    asked = given.number("distance asked next")
    later = replace(ahead, gap=gap_after(given, REQUEST_EXACT, ahead))
    promise(given, REQUEST_EXACT, Call(asked=asked, moved=asked, ahead=later), REQUEST_EXACT.requires)


def width_is_kept(rules: Rules, given: Given) -> None:
    """Any body, after any request of it: its borders are as far apart as before."""
    asked, moved = given.number("distance asked"), given.number("moved")
    left, right, before = given.number("moved the left"), given.number("moved the right"), given.number("width")
    stand_in_for(given, REQUEST, Call(asked=asked, moved=moved, borders=(left, right)), [ALONG])
    given.ensure("the width is kept", before + right - left == before)


def full_circle_stands(rules: Rules, given: Given) -> None:
    """Where the body ahead is in contact and cannot move, this body does not move, and cannot either.

    So by induction on the spare asks nobody moves on a ring on which all are in contact; with no spare ask, the body
    ahead counts as a wall. The chain goes on to the push limit: only a body that may not push ends it earlier.
    """
    seen = replace(lonely_window(given, ledges=False), neighbour=True, may_push=given.flag("the body may push"))
    given.assume(seen.next_length is not None, "a ring goes on beyond every edge")
    seen = replace(seen, gap_before=seen.margin)
    stretch, _ = run_segment(rules, given, seen, SEGMENT_EXACT, Capacity(seen.margin * 0, None))
    given.ensure("it does not move", stretch.moved == 0)
    given.ensure("it can move by nothing", every(can == 0 for can in (stretch.capacity, stretch.left)))
    if not stretch.going and seen.may_push and not stretch.asks:
        given.ensure("the chain ends at the push limit", (stretch.spare <= 0) | (stretch.asked <= 0))
