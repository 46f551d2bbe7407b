"""The search for requests that go wrong in one level: which bodies, which distances, how many, and what is judged.

What a request does changes where a border meets a vertex, or a border of another body, or comes as near to one as the
margin. So the distances tried are those, and one between each two of them, the shortest first.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from itertools import islice, pairwise
from typing import Any

from properties.evidence.deeds import do
from reference.simulator import Endless
from reference.world import World
from spec.body import Body
from spec.graph import Direction, Graph
from spec.invariants import Deed
from spec.plane import IN_PLANE
from spec.profiles import Profile
from spec.unsupported import CASES

MOST_REQUESTS, MOST_WORK, MOST_JUDGED = 1_500, 100_000, 20_000
MOST_DISTANCES, LEAST_DISTANCES = 60, 6
LONGEST = 2

Steps = tuple[tuple[str, Fraction], ...]
Range = tuple[Fraction, Fraction]


@dataclass(frozen=True)
class Wrong:
    """Requests after which something is broken that held before: its IDs, and between where all that moved."""

    steps: Steps
    broken: tuple[str, ...]
    reach: Range


@dataclass(frozen=True)
class Some:
    """A world of which only some bodies are judged, with its graph or a part of it; in all else it is that world."""

    world: World[Fraction]
    judged: Sequence[int]
    graph: Graph[Fraction]

    def handles(self) -> Sequence[int]:
        """The bodies that are judged."""
        return self.judged

    def __getattr__(self, name: str) -> Any:
        return getattr(self.world, name)


@dataclass(frozen=True)
class State:
    """A world after some requests, and between where each body is."""

    world: World[Fraction]
    steps: Steps
    ranges: list[Range]


def range_of(world: World[Fraction], body: int) -> Range:
    """Between where in the plane a body is; on a cylinder maybe beyond once round."""
    held, round_ = world.bodies[body], world.graph.circumference
    left, right = (world.point(at)[0] for at in (held.left, held.right))
    return left, right + round_ if round_ is not None and right < left else right


@dataclass
class Search:
    """What a search has found so far; work is counted in bodies and edges looked at, and in rules fired.

    Requests after which too much is to be judged are left out.
    """

    profile: Profile
    wrongs: list[Wrong] = field(default_factory=list)
    requests: int = 0
    work: int = 0
    left_out: int = 0

    @property
    def spent(self) -> bool:
        """Whether nothing more is to be tried."""
        return self.requests >= MOST_REQUESTS or self.work >= MOST_WORK

    def ask(self, state: State, body: int, distance: Fraction) -> State | None:
        """Make a request; the state after it, or None if nothing moves or if it goes wrong, which is noted."""
        world, direction = state.world, Direction.RIGHT if distance > 0 else Direction.LEFT
        try:
            deed, record = do(self.profile, world, body, direction, abs(distance), Fraction(0))
        except Endless:
            self.left_out += 1
            return None
        after: Any = deed.after
        moved = moved_in(world, after)
        ranges = list(state.ranges)
        for one in moved:
            ranges[one] = range_of(after, one)
        reach = hull([both[one] for both in (state.ranges, ranges) for one in moved])
        judged: list[int] = [one for one in after.handles() if one in moved or near(ranges[one], reach, world)]
        to_judge = len(judged) * (len(judged) + len(world.graph.edges))
        self.work += len(record.fired) + len(ranges) // 2 + min(to_judge, MOST_JUDGED)
        self.left_out += to_judge > MOST_JUDGED
        self.requests += to_judge <= MOST_JUDGED
        if not moved or to_judge > MOST_JUDGED:
            return None
        fired = frozenset(rule for who, rule in record.fired if who == body)
        broken = tuple(name for name in broken_by(deed, fired, judged) if name not in self.profile.not_asked)
        steps = (*state.steps, (world.bodies[body].name, distance))
        if broken:
            self.wrongs.append(Wrong(steps, broken, reach))
        return None if broken else State(after, steps, ranges)


def moved_in(before: World[Fraction], after: World[Fraction]) -> set[int]:
    """The bodies that a request has put elsewhere, and those that ride on them."""
    put = {
        body
        for body, (then, now) in enumerate(zip(before.bodies, after.bodies, strict=True))
        if now is not then and now != then
    }
    return put | {rider for body in put for rider in after.facing(Direction.RIGHT).riders(body)}


def hull(ranges: Iterable[Range]) -> Range:
    """The range from the beginning of the first to the end of the last; none is at 0."""
    known = list(ranges)
    zero = Fraction(0)
    return min((left for left, _ in known), default=zero), max((right for _, right in known), default=zero)


def near(one: Range, other: Range, world: World[Fraction]) -> bool:
    """Whether two ranges are nearer to each other than the margin; on a cylinder also the other way round."""
    (left, right), (start, end), margin = one, other, world.margin
    return any(left + by - margin < end and start - margin < right + by for by in shifts(world))


def shifts(world: World[Fraction]) -> tuple[Fraction, ...]:
    """By how much the images of a body are shifted: on a cylinder once round to either side."""
    zero, round_ = Fraction(0), world.graph.circumference
    return (zero,) if round_ is None else (zero, round_, -round_)


def broken_by(deed: Deed[Fraction], fired: frozenset[str], judged: list[int]) -> Iterator[str]:
    """The IDs of what a request breaks: unsupported cases, and what is promised of the plane."""
    worlds: Any = (deed.before, deed.after)
    before, after = (Some(world, judged, world.graph) for world in worlds)
    seen: Deed[Fraction] = replace(deed, before=before, after=after)
    yield from (case.id for case in CASES if case.happened(seen, fired))
    yield from (one.id for one in IN_PLANE if not one.holds(seen))


def search(profile: Profile, world: World[Fraction], order: Sequence[int]) -> Search:
    """Try requests, of the bodies in this order: first each alone, then two one after another."""
    found = Search(profile)
    states = [State(world, (), [range_of(world, body) for body in world.handles()])]
    for length in range(1, LONGEST + 1):
        known: set[tuple[Body[Fraction], ...]] = set()
        following: list[State] = []
        for state in states:
            for body, distance in requests_of(state, order):
                if found.spent:
                    return found
                after = found.ask(state, body, distance)
                if length < LONGEST and after is not None and tuple(after.world.bodies) not in known:
                    known.add(tuple(after.world.bodies))
                    following.append(after)
        states = following
    return found


def requests_of(state: State, order: Sequence[int]) -> Iterator[tuple[int, Fraction]]:
    """The requests that are tried of a state: bodies with signed distances."""
    many = max(LEAST_DISTANCES, min(MOST_DISTANCES, MOST_REQUESTS // (4 * max(1, len(order)))))
    places = critical(state)
    for body in order:
        for direction in Direction:
            ahead = distances(state.ranges[body], places, direction, many)
            yield from ((body, distance * direction) for distance in islice(ahead, many))


def critical(state: State) -> list[Fraction]:
    """Where a border meets a vertex or a body, or comes as near to one as the margin; on a cylinder on either side."""
    world = state.world
    places = {vertex.x for vertex in world.graph.vertices}
    for left, right in state.ranges:
        places |= {left, right, left - world.margin, right + world.margin}
    return sorted({place + by for place in places for by in shifts(world)})


def distances(own: Range, places: list[Fraction], direction: Direction, many: int) -> list[Fraction]:
    """The distances at which what a body does may change, and one between each two, the shortest first."""
    ahead: set[Fraction] = set()
    for border in own:
        if direction is Direction.RIGHT:
            first = bisect_right(places, border)
            ahead |= {place - border for place in places[first : first + many]}
        else:
            last = bisect_left(places, border)
            ahead |= {border - place for place in places[max(0, last - many) : last]}
    meets = sorted(ahead)
    between = [(one + other) / 2 for one, other in pairwise([Fraction(0), *meets])]
    beyond = own[1] - own[0] + (meets[-1] if meets else 0)
    return sorted([*meets, *between, beyond])
