"""How many instants a step with several drives may have: as many as one likes, in worlds of four bodies.

The world is that of the scenario `repaired-bounces` after its first step. Two walk to the left on the floor, the one
behind faster. Above the slot between them, a box is driven to the right relative to what it stands on, and one in
contact with it walks to the left. On the first, the box wishes to go right: the two are squeezed, stand, and come off
it. On the second, it wishes to go left: both do, fast, and come off that. From where it comes off the second to where
it comes off the first there is a way.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import islice
from typing import Any

from properties.given import Given
from properties.worlds import slot
from reference.storeys import StoreyWorld
from spec.graph import Direction
from spec.profiles import SteppedProfile
from spec.rules.step import Moment, StepRules, step
from spec.storeys import Seat

QUARTERINGS = (1, 2, 4, 8, 16, 32)
FIRST, SECOND, BOX, OTHER = range(4)


def bouncing(way: Any) -> StoreyWorld[Any]:
    """The world at the start, with any way from bounce to bounce."""
    world = slot.start().world.copy()
    less = world.to_loss(BOX, Direction.RIGHT) - way
    for body in (SECOND, BOX, OTHER):
        world.advance(body, less)
    return world


def driven(rules: StepRules, world: StoreyWorld[Any]) -> Iterator[Moment[Any]]:
    """The instants of such a world."""
    return step(rules, world, slot.start().drives, slot.start().duration)


def two_bounces_make_way(rules: StepRules, given: Given) -> None:
    """After two instants, all is as it was, but that the way is four times as long; as long as it is short."""
    way = given.number("way")
    given.assume((way > 0) & (way * 4 < 3), "the way is short")
    world = bouncing(way)
    came = [[event.mark for event in moment.events] for moment in islice(driven(rules, world), 2)]
    given.ensure("it loses the one, then the other", came == [[Seat(BOX, 1, FIRST)], [Seat(BOX, 1, SECOND)]])
    given.ensure("they stand as they did", [world.support(body) for body in slot.start().drives] == [None, None, 0, 1])
    first, second, box, other = (world.span(held).left for held in slot.start().drives)
    given.ensure("the way is four times as long", second - first == 6 - way * 4)
    given.ensure("it is at its end", box == second - 3)
    given.ensure("they are in contact", other - box == 3)


def instants_have_no_bound(profile: SteppedProfile) -> int:
    """Four bodies without terrain have as many instants as one likes: four, and two for each time that a way of 1 has
    been quartered.
    """
    found = [sum(1 for _ in driven(profile.rules, bouncing(Fraction(1, 4**number)))) for number in QUARTERINGS]
    assert found == [number * 2 + 4 for number in QUARTERINGS], f"{QUARTERINGS} quarterings: {found} instants"
    return len(QUARTERINGS)
