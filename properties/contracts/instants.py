"""What is shown of an instant of a step: what is so stays recorded, and what was lost is not looked at again.

Whatever is recorded too little comes again at once, with no time passed: in exact numbers that is an instant too many,
in floats, where a rest may be too small to change a place, it may be one without end.
"""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

from properties.contracts.stretches import any_marks, any_way
from properties.given import Given
from properties.worlds.storeys import Setting, any_world
from spec.graph import Direction
from spec.rules.settle import footing_of
from spec.rules.step import StepRules, go_on, lasting, settled, touching
from spec.storeys import AtWall, Contact, Seat

TOPS = (1, 2)


def what_has_not_parted_stays_recorded(rules: StepRules, given: Given) -> None:
    """Two in contact, and a body at a wall, are recorded until they have parted: also if nothing between them moves. A
    lost support is forgotten.
    """
    ways, seat = {body: any_way(given, body) for body in (0, 1)}, Seat(0, 1, None)
    pair, walls = Contact(0, 1), [AtWall(0, 1, direction) for direction in Direction]
    left = lasting(ways, {pair, *walls, seat})
    if ways[1] - ways[0] <= 0:
        given.ensure("a contact stays until the two have parted", pair in left)
    for wall in walls:
        if ways[0] * wall.direction >= 0:
            given.ensure("a wall stays until the body has left it", wall in left)
    given.ensure("what was lost is forgotten", seat not in left)


def no_time_changes_nothing(rules: StepRules, given: Given, setting: Setting) -> None:
    """At an instant that comes at once nobody has parted yet, at whatever speeds."""
    world = any_world(given, setting)
    speeds, marks = {body: any_way(given, body) for body in setting.drives}, any_marks(given, world)
    given.ensure("all that was recorded still is", marks <= go_on(world, speeds, world.margin * 0, marks))


def neighbours_stay_in_contact(rules: StepRules, given: Given) -> None:
    """When bodies have changed their storeys, those still neighbours are in contact if they were, also if a rounding
    has brought them apart, or if they touch now; others are not. Whoever is at a wall stays so.
    """
    pair, wall = Contact(0, 1), AtWall(0, 0, Direction.RIGHT)
    still, before = given.flag("they are still neighbours"), given.flag("their contact is recorded")
    apart = given.number("how much further apart they are than the margin")
    world: Any = SimpleNamespace(
        margin=apart * 0,
        neighbours=lambda: [(0, 1)] if still else [(1, 0)],
        gap=lambda left, right: apart,
        storeys=lambda: [],
    )
    kept, touches = settled(world, {pair, wall} if before else {wall}), bool(apart <= 0)
    given.ensure("a contact stays exactly of those still neighbours", (pair in kept) == (still and (before or touches)))
    given.ensure("whoever is at a wall stays so", wall in kept)


def what_touches_is_recorded_when_settled(rules: StepRules, given: Given, setting: Setting) -> None:
    """When bodies have settled, all that touches is recorded, and what was lost."""
    world, lost = any_world(given, setting), Seat(0, 1, None)
    recorded = settled(world, any_marks(given, world) | {lost})
    given.ensure("what touches is recorded, and what was lost", touching(world) | {lost} <= recorded)


def what_was_lost_is_not_looked_at(rules: StepRules, given: Given) -> None:
    """Whoever is held looks at nothing else. Else it looks at the ground, if it has not lost that; and where there is
    none, at the tops that it has not lost. What was lost is none, whatever distances say: in floats, it may be near.
    """
    ground, tops = given.flag("over ground"), [top for top in TOPS if given.flag(f"{top} would hold it")]
    seats = {seat: f"it has lost {seat.support or 'the ground'}" for seat in (Seat(0, 1, top) for top in (None, *TOPS))}
    lost = {seat for seat, name in seats.items() if given.flag(name)}
    world: Any = SimpleNamespace(
        storey=lambda body: 1,
        grounded=lambda body: ground,
        tops=lambda body: tops,
        overlap=lambda body, below: given.number(f"over {below}"),
    )
    holds, motion = given.flag("its support holds it"), given.number("motion")
    found = footing_of(world, 0, holds, motion, lost)
    left = ground and Seat(0, 1, None) not in lost
    beside = [] if left else [top for top in tops if Seat(0, 1, top) not in lost]
    given.ensure("it is held if it is", found.holds == holds)
    given.ensure("it looks at ground that it has not lost", found.ground == (left and not holds))
    given.ensure(
        "it looks at tops that it has not lost", [top.body for top in found.tops] == (beside if not holds else [])
    )
