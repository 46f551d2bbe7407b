"""How many instants a step with several drives may have: counted, in towers that make many."""

from __future__ import annotations

from fractions import Fraction

from reference.storeys import Place, StoreyWorld, Terrain
from spec.profiles import SteppedProfile
from spec.rules.step import step
from spec.storeys import Drive, Interval

MARGIN, SLOWER = Fraction(1, 1024), 16
STILL = Drive(Fraction(0))
SIZES = range(2, 7)
BEYOND = (11, 11, 10)

Tower = tuple[StoreyWorld[Fraction], dict[int, Drive[Fraction]], Fraction]


def tower(carriers: int, boxes: int, riders: int) -> Tower:
    """A tower without terrain, who drives whom, and for how long.

    Carriers as wide as more than half of the line stand one on another. Each is driven against the one that carries
    it, and much slower: so it turns once more often than that, and goes nearly from end to end each time. On the
    topmost one are boxes in contact. Above these are narrow riders that stand still in the plane: each time a box
    passes below a rider, that rider loses a support.
    """
    rider = MARGIN * 2
    way = boxes - MARGIN - (riders + 1) * rider * 2
    wide = boxes + way
    places = [Place(storey, Fraction(0), wide, storey - 1 if storey else None) for storey in range(carriers)]
    places += [Place(carriers, Fraction(left), 1 - MARGIN, carriers - 1) for left in range(boxes)]
    lefts = [way + MARGIN + one * rider * 2 for one in range(riders)]
    places += [Place(carriers + 1, left, rider, carriers + int(left)) for left in lefts]
    drives = [Drive(Fraction((-1) ** storey, SLOWER**storey)) for storey in range(carriers)]
    drives += [STILL] * boxes + [Drive(Fraction(0), relative=False)] * riders
    world = StoreyWorld(Terrain((), Interval(Fraction(0), wide + way)), MARGIN, places)
    return world, dict(enumerate(drives)), way * SLOWER**carriers


def instants_of(profile: SteppedProfile, made: Tower) -> int:
    """How many instants a step has."""
    world, drives, duration = made
    return sum(1 for _ in step(profile.rules, world, drives, duration))


def instants_grow_as_a_cube(profile: SteppedProfile) -> int:
    """A tower of N carriers, N boxes and N riders has N³ - N² + N + 1 instants."""
    for size in SIZES:
        instants = instants_of(profile, tower(size, size, size))
        assert instants == size**3 - size**2 + size + 1, f"{size} carriers, boxes and riders: {instants} instants"
    return len(SIZES)


def instants_exceed_the_square(profile: SteppedProfile) -> int:
    """A tower of 32 bodies and no terrain has more than 33 times 33 instants: that bound is one for few bodies."""
    bodies, instants = sum(BEYOND), instants_of(profile, tower(*BEYOND))
    assert instants > (bodies + 1) * (bodies + 1), f"{bodies} bodies: {instants} instants"
    return 1
