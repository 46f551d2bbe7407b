"""How many instants a step with several drives may have: counted, in worlds that make as many as one likes."""

from __future__ import annotations

from fractions import Fraction

from reference.storeys import Place, StoreyWorld, Terrain
from spec.profiles import SteppedProfile
from spec.rules.step import step
from spec.storeys import Drive, Interval

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


def bouncing(halvings: int) -> StoreyWorld[Fraction]:
    """Two walk to the left on the floor, the one behind faster. Above the slot between them, a body is driven to the
    right relative to what it stands on, and one in contact with it walks to the left.

    On the first, the body wishes to go right: the two are squeezed, stand, and come off it. On the second, it wishes to
    go left: both do, fast, and come off that. The way from one to the other doubles each time; at the start it is 1,
    halved so many times.
    """
    zone = ONE / 2**halvings
    places = (
        Place(0, ONE * 0, ONE * 2, None),
        Place(0, ONE * 6 - zone, ONE * 2, None),
        Place(1, ONE * 3 - zone / 2, ONE * 2, 0),
        Place(1, ONE * 6 - zone / 2, ONE * 2, 1),
    )
    return StoreyWorld(Terrain((), ENDS), ONE, places)


def instants_have_no_bound(profile: SteppedProfile) -> int:
    """Four bodies without terrain have as many instants as one likes: four, and one for each halving."""
    for halvings in HALVINGS:
        instants = sum(1 for _ in step(profile.rules, bouncing(halvings), DRIVES, TIME))
        assert instants == halvings + 4, f"{halvings} halvings: {instants} instants"
    return len(HALVINGS)
