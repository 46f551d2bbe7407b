"""Complications: unsupported cases that are not in the thesis, and were found by search (6.2.1, 6.2.2).

The thesis says that its guidelines "cannot guarantee that there are no complications"; these are some. Each is a
mechanism: what a body did, by which rule, and what it has run into by that.
"""

from __future__ import annotations

from typing import Any

from spec.case import (
    Case,
    Fired,
    all_but,
    in_overhang,
    in_terrain,
    landed,
    mover_in_body,
    mover_in_terrain,
    mover_near_body,
    nearer,
    overhanging,
    overlap,
    riders_of,
    some,
)
from spec.invariants import Deed, every
from spec.number import Truth, zero_like
from spec.plane import box, heights, horizontal_within, images, negated, terrain


def lands_near(deed: Deed[Any], fired: Fired) -> Truth:
    """It fell or jumped, and came down nearer to another body than the margin, though not into any."""
    return mover_near_body(deed) & negated(mover_in_body(deed)) if landed(fired) else False


def jumps_onto_a_ridden_top(deed: Deed[Any], fired: Fired) -> Truth:
    """It jumped onto a top on which another body stands, and into that body."""
    world: Any = deed.after
    others = [other for other in world.row(deed.body).order if other != deed.body]
    return nearer(world, [deed.body], others, zero_like(deed.asked)) if "leave/jump" in fired else False


def jumps_into_what_leads_up(deed: Deed[Any], fired: Fired) -> Truth:
    """It jumped into a body whose top is above the ledge."""
    before, after = deed.before, deed.after
    mine, level = box(after, deed.body), heights(before, deed.body)[0]
    if "leave/jump" not in fired or mine is None:
        return False
    others = [box(after, body) for body in all_but(after, [deed.body])]
    return some(overlap(mine, other) & (other.top > level) for other in others if other is not None)


def jumps_onto_the_middle(deed: Deed[Any], fired: Fired) -> Truth:
    """It jumped into a body that is no higher than the ledge and does not stand on the top that it jumped onto."""
    world: Any = deed.after
    level = heights(deed.before, deed.body)[0]
    beside = [other for other in all_but(world, world.row(deed.body).order) if heights(world, other)[0] < level]
    low = [other for other in beside if not bool(heights(world, other)[0] + world.bodies[other].height > level)]
    return nearer(world, [deed.body], low, zero_like(deed.asked)) if "leave/jump" in fired else False


def lands_in_terrain(deed: Deed[Any], fired: Fired) -> Truth:
    """It fell or jumped into terrain, though its width fits before the wall that ends its string."""
    return mover_in_terrain(deed) if landed(fired) and "fit/wall" not in fired else False


def lands_through_a_floor(deed: Deed[Any], fired: Fired) -> Truth:
    """It fell or jumped to under terrain over which it was, or into its underside."""
    world: Any = deed.after
    mine, level = box(world, deed.body), heights(deed.before, deed.body)[0]
    if not landed(fired) or mine is None or mine.bottom is None:
        return False
    return some(
        (mine.bottom < image.bottom) & (image.top <= level) & (mine.left < image.right) & (image.left < mine.right)
        for solid in terrain(world)
        for image in images(world, solid)
        if image.bottom is not None
    )


def riders_meet(deed: Deed[Any]) -> Truth:
    """Whether a rider of the mover is in terrain, or beside a body that is none of them, nearer than the margin."""
    carried = riders_of(deed)
    others = all_but(deed.after, [deed.body, *carried])
    near = nearer(deed.after, carried, others, deed.after.margin)
    return some([near, in_terrain(deed.after, carried)])


def carries_into(deed: Deed[Any], fired: Fired) -> Truth:
    """It walked, and carried a rider into something."""
    return False if landed(fired) else riders_meet(deed)


def falls_with_riders_into(deed: Deed[Any], fired: Fired) -> Truth:
    """It fell or jumped, and took a rider into something."""
    return riders_meet(deed) if landed(fired) else False


def lands_too_far(deed: Deed[Any], fired: Fired) -> Truth:
    """It fell or jumped further to the side than it was asked to move, or back."""
    return negated(horizontal_within(deed)) if landed(fired) else False


def overhangs_meet(deed: Deed[Any], fired: Fired) -> Truth:
    """In overhang, it is nearer than the margin to a body that overhangs from the other side."""
    world: Any = deed.after
    others = [other for other in all_but(world, [deed.body]) if world.row(other) is not world.row(deed.body)]
    meets = [
        overhanging(world, other, deed.direction.opposite) & nearer(world, [deed.body], [other], world.margin)
        for other in others
    ]
    return in_overhang(deed) & some(meets) if "leave/stay" in fired else False


def walks_into_other_strings(deed: Deed[Any], fired: Fired) -> Truth:
    """It neither fell nor jumped, and is nearer than the margin to a body on another string."""
    world: Any = deed.after
    others = [other for other in all_but(world, [deed.body]) if world.row(other) is not world.row(deed.body)]
    return False if landed(fired) else nearer(world, [deed.body], others, world.margin)


def out_of_sight(deed: Deed[Any], fired: Fired) -> Truth:
    """It neither fell nor jumped, and is nearer than the margin to a body on its own string, which it has not seen."""
    world: Any = deed.after
    others = [other for other in world.row(deed.body).order if other != deed.body]
    return False if landed(fired) else nearer(world, [deed.body], others, world.margin)


def stopped_from_above(deed: Deed[Any], fired: Fired) -> Truth:
    """It is blocked at a ledge by bodies that are all higher up than it is tall."""
    if "leave/blocked" not in fired:
        return False
    world: Any = deed.after
    view, zero = world.facing(deed.direction), zero_like(deed.asked)
    width, level = world.width(deed.body), heights(world, deed.body)[0]
    far = []
    for jump in view.jumps(deed.body, view.rear(deed.body)):
        top, near = jump.target.edge - world.statics, (jump.across >= zero) & (jump.across < width)
        above = top >= 0 and heights(world, top)[0] >= level + world.bodies[deed.body].height
        far.append(above | negated(near))
    return every(far)


FOUND: tuple[Case, ...] = (
    Case(
        "unsupported/lands-near",
        "A body falls or jumps to nearer to another than the margin, which the test of jump edges leaves out.",
        "6.2.1; R24, R25, E12",
        lands_near,
    ),
    Case(
        "unsupported/ridden-top",
        "A body jumps onto a top into another body that stands there.",
        "6.2.1, 6.2.2; R25, U9",
        jumps_onto_a_ridden_top,
    ),
    Case(
        "unsupported/leads-up",
        "A body jumps down into a body whose own jump edge leads up, and so was ignored.",
        "6.2.1; R25, A23",
        jumps_into_what_leads_up,
    ),
    Case(
        "unsupported/jump-onto-middle",
        "A body jumps onto a top, and into the middle of a body beside it.",
        "6.2.1, 6.6e; R25, U5",
        jumps_onto_the_middle,
    ),
    Case(
        "unsupported/lands-in-terrain",
        "A body falls or jumps to where terrain is beside or above it.",
        "6.2.1, 6.2.2; R21, R22, U4",
        lands_in_terrain,
    ),
    Case(
        "unsupported/through-floor",
        "A body falls or jumps through terrain to a layer below.",
        "6.2.1, 6.2.2; R15, R21, R22",
        lands_through_a_floor,
    ),
    Case(
        "unsupported/rider-carried",
        "A rider is carried into a body or terrain, or nearer to a body than the margin.",
        "4.4; A27, U9",
        carries_into,
    ),
    Case(
        "unsupported/rider-falls",
        "A rider goes with a support that falls or jumps, into a body or terrain, or nearer to a body than the margin.",
        "4.4; A28, U9",
        falls_with_riders_into,
    ),
    Case(
        "unsupported/lands-too-far",
        "A fall or a jump takes a body further to the side than it was asked to move, or back.",
        "1.2, 6.2.1; R17, R33, A15, A19",
        lands_too_far,
    ),
    Case(
        "unsupported/overhangs-meet",
        "Over a pit a body comes, in overhang, to one that overhangs from the other side.",
        "6.2.1d, 6.2.2; R21, U9",
        overhangs_meet,
    ),
    Case(
        "unsupported/walks-into-body",
        "A body walks to a body on another string, or nearer to it than the margin.",
        "6.2.2; U9, A12",
        walks_into_other_strings,
    ),
    Case(
        "unsupported/out-of-sight",
        "A body walks to nearer than the margin to one on its own string, beyond an edge that is shorter than that.",
        "6.2.1; R24, A12",
        out_of_sight,
    ),
    Case(
        "unsupported/stopped-from-above",
        "A body is blocked at a ledge by one that is too high up to be in its way.",
        "6.2.1; R25, A20",
        stopped_from_above,
    ),
)
