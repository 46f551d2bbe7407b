"""How many instants a step with several drives may have: as many as one likes, in worlds of four bodies."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import islice
from typing import Any

from properties.given import Given
from reference.storeys import Place, StoreyWorld, Terrain
from spec.profiles import SteppedProfile
from spec.rules.step import Moment, StepRules, step
from spec.storeys import Drive, Interval, Seat

HALVINGS = (1, 2, 4, 8, 16, 32, 64)
ONE = Fraction(1)
ENDS = Interval(ONE * -100, ONE * 100)
TIME = ONE * 6
DRIVES = {
    0: Drive(ONE * -1),
    1: Drive(ONE * -2),
    2: Drive(ONE * 3 / 2),
    3: Drive(ONE * -3, relative=False),
}


def bouncing(way: Any, along: Any) -> StoreyWorld[Any]:
    """Two walk to the left on the floor, the one behind faster. Above the slot between them, a body is driven to the
    right relative to what it stands on, and one in contact with it walks to the left.

    On the first, the body wishes to go right: the two are squeezed, stand, and come off it. On the second, it wishes to
    go left: both do, fast, and come off that. From where it comes off the second to where it comes off the first there
    is a `way`, on which it is so far `along`.
    """
    left = 3 * ONE - way + along
    places = (
        Place(0, way * 0, ONE * 2, None),
        Place(0, 6 * ONE - way, ONE * 2, None),
        Place(1, left, ONE * 2, 0),
        Place(1, left + 3, ONE * 2, 1),
    )
    return StoreyWorld(Terrain((), ENDS), ONE, places)


def driven(rules: StepRules, world: StoreyWorld[Any]) -> Iterator[Moment[Any]]:
    """The instants of such a world."""
    return step(rules, world, DRIVES, TIME)


def two_bounces_make_way(rules: StepRules, given: Given) -> None:
    """After two instants, all is as it was, but that the way is four times as long; as long as it is short."""
    way = given.number("way")
    given.assume((way > 0) & (way * 4 < 3), "the way is short")
    world = bouncing(way, way * 0)
    came = [[event.mark for event in moment.events] for moment in islice(driven(rules, world), 2)]
    given.ensure("it loses the one, then the other", came == [[Seat(2, 1, 0)], [Seat(2, 1, 1)]])
    given.ensure("they stand as they did", [world.support(body) for body in DRIVES] == [None, None, 0, 1])
    first, second, body, other = (world.span(held).left for held in DRIVES)
    given.ensure("the way is four times as long", second - first == 6 - way * 4)
    given.ensure("it is at its end", body == second - 3)
    given.ensure("they are in contact", other - body == 3)


def instants_have_no_bound(profile: SteppedProfile) -> int:
    """Four bodies without terrain have as many instants as one likes: four, and one for each time that a way of 1 has
    been halved.
    """
    ways = [ONE / 2**halvings for halvings in HALVINGS]
    found = [sum(1 for _ in driven(profile.rules, bouncing(way, way / 2))) for way in ways]
    assert found == [halvings + 4 for halvings in HALVINGS], f"{HALVINGS} halvings: {found} instants"
    return len(HALVINGS)
