"""The contract of leaving an edge: who falls, who jumps where, who is blocked; proved of the rules' own code."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from properties.contracts.contract import LEAVING, Parting, promise
from properties.contracts.request import seen_by
from properties.given import Given
from properties.worlds.window import ME, Spot, Window, lonely_window, spot
from spec.number import Truth, greater, lesser
from spec.plane import negated
from spec.rules.leave import Departure, Placement
from spec.rules.request import Rules, depart
from spec.rules.walk import Motion
from spec.world import Jump


def any_jump(given: Given, name: str) -> Jump[Any, Spot]:
    """Any jump edge that leads ahead, up or down."""
    drop = given.number(f"{name}: down") - given.number(f"{name}: up")
    free = given.flag(f"{name}: its far end is free")
    return Jump(spot(given, name), given.number(f"{name}: across"), drop, free)


def any_departure(rules: Rules, given: Given) -> tuple[Window, Departure[Any, Spot]]:
    """Any body after its move: its rear border on its edge or beyond a ledge; up to two near jump edges."""
    seen = lonely_window(given, ledges=True)
    rear, moved, width = seen.start, given.number("distance moved"), given.number("width")
    given.assume(moved + rear.reach >= 0, "the rear border was on its edge before")
    front = replace(seen.along(rear, width), edge=rear.edge + 1)
    jumps = [any_jump(given, name) for name in ("first jump", "second jump") if given.flag(f"there is a {name}")]
    seen = replace(seen, jump_edges=tuple(jumps))
    leaving = Departure(
        seen,
        walk=seen_by(given, rules).walk,
        fit=seen_by(given, rules).fit,
        landing=rules.landing,
        front=front,
        rear=rear,
        moved=moved,
        width=width,
        near=tuple(jumps),
        foot=spot(given, "foot") if given.flag("a fall edge begins there") else None,
    )
    return seen, leaving


def leaves(rules: Rules, given: Given) -> tuple[str, Departure[Any, Spot], Placement[Any, Spot]]:
    """What becomes of any departure, by which rule."""
    _, leaving = any_departure(rules, given)
    rule = seen_by(given, rules).leave.choose(leaving)
    return rule.id, leaving, rule.effect(leaving)


def leaving_keeps_its_contract(rules: Rules, given: Given) -> None:
    """A body that stays keeps its place; one that is blocked ends with its rear border at the ledge, and says so."""
    rule, leaving, placed = leaves(rules, given)
    promise(given, LEAVING, Parting(leaving, placed))
    if rule in ("leave/blocked", "leave/nowhere"):
        given.ensure(
            "the rear border is at the ledge", (placed.rear.reach == 0) & (placed.rear.edge <= leaving.rear.edge)
        )
        cut_back = placed.moved == leaving.moved + leaving.rear.reach
        given.ensure("it has moved less by what was beyond the ledge", cut_back)
    if rule in ("leave/fall", "leave/jump"):
        given.ensure("falls and jumps cut nothing off the distance", placed.moved >= leaving.moved)


def jumps_lead_down_least(rules: Rules, given: Given) -> None:
    """A body falls only where no jump edge is near; it jumps to a free end that does not lead up, and down least."""
    rule, leaving, placed = leaves(rules, given)
    if landed_at(placed, leaving.foot):
        given.ensure("nothing obstructs the fall", not leaving.near)
    if rule == "leave/fall":
        given.ensure("it lands at the foot", landed_at(placed, leaving.foot))
    if rule == "leave/jump":
        chosen = [jump for jump in leaving.near if landed_at(placed, jump.target)]
        given.ensure("it lands at the end of a jump edge", bool(chosen))
        for jump in chosen:
            given.ensure("the jump does not lead up, and its end is free", (jump.drop >= 0) & jump.free)
            for place, other in enumerate(leaving.near):
                earlier = place < next(i for i, one in enumerate(leaving.near) if one is jump)
                longer = other.across > jump.across if earlier else other.across >= jump.across
                shorter = (other.drop > jump.drop) | ((other.drop >= jump.drop) & longer)
                better = "no other that may be used leads down less, or as little and is shorter or earlier"
                given.ensure(better, negated(may_be_used(other)) | shorter)
    if rule == "leave/blocked":
        for jump in leaving.near:
            given.ensure("no near jump edge may be used", negated(may_be_used(jump)))


def may_be_used(jump: Jump[Any, Spot]) -> Truth:
    """Whether a jump edge does not lead up, and its far end is free."""
    return jump.drop >= 0 if jump.free else False


def landed_at(placed: Placement[Any, Spot], near_end: Spot | None) -> bool:
    """Whether the rear border came down at a near end or beyond it, on its edge."""
    return near_end is not None and placed.rear.length is near_end.length


def landing_keeps_width(rules: Rules, given: Given) -> None:
    """After a fall or a jump the front border is a width ahead of the rear border, along the graph or into a wall."""
    rule, leaving, placed = leaves(rules, given)
    if rule in ("leave/fall", "leave/jump"):
        walked = placed.front.travelled - placed.rear.travelled
        given.ensure("the width is kept", walked == leaving.width)


def fit_places_the_whole_width(rules: Rules, given: Given) -> None:
    """What is left of a width is placed on from where its walk has ended: in the wall, if anything is left."""
    seen = lonely_window(given, ledges=True)
    motion = Motion(seen.start, rest=given.number("width left"))
    front = seen_by(given, rules).fit.choose(motion).effect((seen, motion))
    given.ensure("the whole width is placed", front.travelled == motion.rest)


def lands_at_the_near_end(rules: Rules, given: Given) -> None:
    """The rear border comes down exactly at the foot, or at the near corner."""
    rule, leaving, placed = leaves(rules, given)
    ends = [leaving.foot, *(jump.target for jump in leaving.near)]
    if rule in ("leave/fall", "leave/jump"):
        given.ensure("the rear border is at a near end", any(placed.rear is end for end in ends))


def lands_as_far_beyond(rules: Rules, given: Given) -> None:
    """The rear border keeps its horizontal position, as far beyond the near end as there is ground.

    If it was not yet beyond it, as is possible of a jump, it comes down at the near end.
    """
    rule, leaving, placed = leaves(rules, given)
    ends = [leaving.foot, *(jump.target for jump in leaving.near)]
    if rule in ("leave/fall", "leave/jump"):
        (end,) = [end for end in ends if landed_at(placed, end) and end is not None]
        across = leaving.rear.reach * -1 - sum(jump.across for jump in leaving.near if jump.target is end)
        beyond = lesser(greater(across, across * 0), end.reach)
        given.ensure("the rear border keeps its position", placed.rear.travelled == end.travelled + beyond)


def near_jumps_are_as_short(rules: Rules, given: Given) -> None:
    """A jump edge is near if the rear border is beyond the ledge and its horizontal extent is from 0 to the width."""
    width, jump = given.number("width"), any_jump(given, "jump")
    jump = replace(jump, across=jump.across - given.number("jump: back"))
    foot = spot(given, "foot")
    seen = replace(lonely_window(given, ledges=True), body_width=width, jump_edges=(jump,), below=foot)
    moved, front = given.number("distance moved"), spot(given, "front after the move")
    own = seen_by(given, rules)
    leaving = depart(own, seen, ME, front, seen.start, moved)
    gone = seen.start.reach < 0
    near = (jump.across >= 0) & (jump.across < width) & gone
    given.ensure("a near jump edge is found, and no other", near == (len(leaving.near) == 1))
    given.ensure("the fall edge is found", gone == (leaving.foot is foot))
    theirs = leaving.walk is own.walk and leaving.fit is own.fit and leaving.landing is own.landing
    given.ensure("it lands by these rules", theirs)
    same = leaving.front is front and leaving.rear is seen.start
    given.ensure("it leaves from where it is", same & (leaving.moved == moved) & (leaving.width == width))
