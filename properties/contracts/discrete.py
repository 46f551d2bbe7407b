"""What is shown of the discrete sibling: all of it up to a size, by going through all states."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import combinations_with_replacement, groupby, product

from properties.evidence.deeds import MOST_RULES
from reference.stepping import run
from reference.storeys import Place, StoreyWorld, Terrain
from spec.discrete import DISCRETE_INVARIANTS, Spot, State, Turn, turn
from spec.graph import Direction
from spec.profiles import REPAIRED, AnyProfile
from spec.storeys import Drive, Interval

WIDTH, MARGIN = Fraction(1), Fraction(1, 8)
PITCH = WIDTH + MARGIN
"""How far apart columns are in a world of storeys: bodies in columns side by side are the margin apart."""


def states(columns: int, bodies: int, heights: int) -> Iterator[State]:
    """All states of so many columns, with one to so many bodies, and ground below a height; bodies are alike."""
    for ground in product(range(heights), repeat=columns):
        for count in range(1, bodies + 1):
            for chosen in combinations_with_replacement(range(columns), count):
                spots = (
                    Spot(column, ground[column] + level)
                    for column, stack in groupby(chosen)
                    for level, _ in enumerate(stack)
                )
                yield State(ground, tuple(spots))


def turns(columns: int, bodies: int, heights: int) -> Iterator[Turn]:
    """All turns of all states of a size."""
    for state in states(columns, bodies, heights):
        for body, direction in product(range(len(state.spots)), Direction):
            yield Turn(state, turn(state, body, direction), body, direction)


def turns_keep_the_invariants(profile: AnyProfile) -> int:
    """All turns of up to three bodies on up to four columns, with ground of up to two storeys, keep all invariants."""
    cases = list(turns(columns=4, bodies=3, heights=3))
    for one, invariant in product(cases, DISCRETE_INVARIANTS):
        assert invariant.holds(one), f"{invariant.id}: {one}"
    return len(cases)


def as_storeys(state: State) -> StoreyWorld[Fraction]:
    """A state as a world of storeys: columns the width of a body and the margin apart, walls right beside them."""
    end = PITCH * len(state.ground) - MARGIN
    solid = tuple(tuple(walls(state, storey, end)) for storey in range(max(state.ground)))
    below = [state.body_at(Spot(spot.column, spot.storey - 1)) for spot in state.spots]
    places = [
        Place(spot.storey, PITCH * spot.column, WIDTH, support)
        for spot, support in zip(state.spots, below, strict=True)
    ]
    return StoreyWorld(Terrain(solid, Interval(end * 0, end)), MARGIN, places)


def walls(state: State, storey: int, end: Fraction) -> Iterator[Interval[Fraction]]:
    """What is solid on a storey: from one margin before its first column to the beginning of the one after its last."""
    for solid, run_ in groupby(range(len(state.ground)), key=lambda column: state.ground[column] > storey):
        columns = list(run_)
        if solid:
            left, right = PITCH * columns[0] - MARGIN, PITCH * (columns[-1] + 1)
            yield Interval(max(left, end * 0), min(right, end))


def ends_as_in_storeys(one: Turn) -> bool:
    """Whether a turn ends as a step of `repaired` does in which the body is driven to the next column."""
    world = as_storeys(one.before)
    drives = {body: Drive(PITCH * 0) for body in range(len(one.before.spots))}
    drives[one.body] = Drive(PITCH * one.direction, relative=False)
    run(REPAIRED.rules, world, drives, WIDTH, MOST_RULES)
    ends = [(place.left, place.storey) for place in world.places]
    return ends == [(PITCH * spot.column, spot.storey) for spot in one.after.spots]


def turns_are_steps(profile: AnyProfile) -> int:
    """All turns of up to three bodies on up to three columns, with ground of one storey, end as steps do."""
    return compared(columns=3, bodies=3, heights=2)


def more_turns_are_steps(profile: AnyProfile) -> int:
    """All turns of up to four bodies on up to four columns, with ground of up to two storeys, end as steps do."""
    return compared(columns=4, bodies=4, heights=3)


def compared(columns: int, bodies: int, heights: int) -> int:
    """Compare all turns of a size with steps."""
    cases = list(turns(columns, bodies, heights))
    for one in cases:
        assert ends_as_in_storeys(one), f"a step ends otherwise: {one}"
    return len(cases)
