"""Random games on levels with ledges: whenever an invariant in the plane breaks, one of the cases has happened."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from fractions import Fraction

from hypothesis import HealthCheck, Phase, given, seed, settings, strategies as st

from properties.evidence.deeds import do
from properties.evidence.sample import SEED, fix_inputs
from properties.map.replay import Done
from properties.strategies.rows import multiples
from properties.strategies.scenes import levels_with_ledges
from reference.world import World
from spec.body import Level
from spec.conditions import PLANE_START
from spec.graph import Direction
from spec.profiles import Profile
from spec.unsupported import GENERAL

EXAMPLES, LEAST_BROKEN, LEAST_CASES = 1_000, 20, 6
ZERO = Fraction(0)

Asked = tuple[int, Fraction, Direction]
"""A body, by its place in the level's list counted on from the last to the first, a distance and a direction."""


def requests() -> st.SearchStrategy[list[Asked]]:
    """One request or several, long and short ones."""
    distances = st.one_of(st.sampled_from([Fraction(n) for n in (1, 2, 3, 5)]), multiples(8, 1), multiples(8, 12))
    return st.lists(st.tuples(st.integers(0, 4), distances, st.sampled_from(Direction)), min_size=1, max_size=8)


def played(profile: Profile, level: Level[Fraction], asked: Sequence[Asked]) -> Iterator[Done]:
    """The requests of a game, as long as each begins in order."""
    world: World[Fraction] = World(level)
    for body, distance, direction in asked:
        if not PLANE_START.holds(world, ZERO):
            return
        deed, record = do(profile, world, body % len(level.bodies), direction, distance, ZERO)
        yield Done(deed, record)
        world = deed.after  # type: ignore[assignment]


def cases_are_complete(profile: Profile) -> int:
    """Whenever a request breaks an invariant in the plane, one of the cases has happened that say how."""
    fix_inputs()
    seen: Counter[str] = Counter()

    @seed(SEED)
    @settings(
        max_examples=EXAMPLES,
        database=None,
        deadline=None,
        phases=(Phase.generate, Phase.shrink),
        suppress_health_check=list(HealthCheck),
        print_blob=False,
    )
    @given(levels_with_ledges(), requests())
    def every_break_has_a_case(level: Level[Fraction], asked: list[Asked]) -> None:
        for number, done in enumerate(played(profile, level, asked), start=1):
            cases = [name for name in done.cases if name != GENERAL]
            assert cases or not done.broken, f"{done.broken} by request {number} of {asked} in {level}"
            seen.update(["requests", *(["broken", *cases] if done.broken else [])])

    every_break_has_a_case()
    assert seen["broken"] >= LEAST_BROKEN, f"only {seen['broken']} requests break anything"
    assert len(seen) - 2 >= LEAST_CASES, f"only {len(seen) - 2} cases are seen"
    return seen["requests"]
