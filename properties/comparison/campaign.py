"""Comparing the two profiles over many scenarios: how many differ, and by which causes.

A scenario is a random level in some state, and one request or tick. The state after it is that of the thesis, as long
as bodies are apart there and outside terrain.
"""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor, as_completed
from dataclasses import dataclass, field
from fractions import Fraction
from multiprocessing import get_context
from random import Random

from properties.comparison.both import Asked, Both, Pair
from properties.comparison.causes import causes_of, round_a_ring
from properties.comparison.levels import any_level
from spec.body import Level
from spec.conditions import EDGES_LONG

SEED = 20200315
STEPS = 8
A_PART = 1_000
FLOORS = {
    "requests": 0.5,
    "ticks": 0.15,
    "falls": 0.03,
    "jumps": 0.02,
    "rides": 0.2,
    "pushes": 0.05,
    "on a ring": 0.1,
    "plain": 0.1,
}


@dataclass
class Tally:
    """What a comparison has counted.

    Attributes:
        shares: the scenarios in which something of interest happens.
        differ: the scenarios that end differently.
        causes: for each cause the scenarios in which it is at work; alone: those in which no other is.
        unexplained: the scenarios that differ without a cause, or that differ though they are plain.
    """

    scenarios: int = 0
    differ: int = 0
    shares: Counter[str] = field(default_factory=Counter)
    causes: Counter[str] = field(default_factory=Counter)
    alone: Counter[str] = field(default_factory=Counter)
    unexplained: list[str] = field(default_factory=list)

    def add(self, other: Tally) -> None:
        """Add what another has counted."""
        self.scenarios, self.differ = self.scenarios + other.scenarios, self.differ + other.differ
        self.shares.update(other.shares)
        self.causes.update(other.causes)
        self.alone.update(other.alone)
        self.unexplained += other.unexplained

    @property
    def tame(self) -> list[str]:
        """The shares that do not reach their floor."""
        return [name for name, floor in FLOORS.items() if self.shares[name] < floor * self.scenarios]

    def note(self, both: Both, seed: int) -> None:
        """Count a scenario of the part with a seed."""
        self.scenarios += 1
        self.shares.update(name for name, there in features(both).items() if there)
        if not both.differing:
            return
        found = [one.id for one in causes_of(both)]
        self.differ += 1
        self.causes.update(found)
        self.alone.update(found if len(found) == 1 else ())
        if not found or plain(both):
            self.unexplained.append(f"scenario {self.scenarios} of the part with seed {seed}: {both.asked}")


def features(both: Both) -> dict[str, bool]:
    """What of interest happens in a scenario."""
    return {
        "requests": both.asked.body is not None,
        "ticks": both.asked.body is None,
        "falls": bool(both.fired("leave/fall")),
        "jumps": bool(both.fired("leave/jump")),
        "rides": both.rides,
        "pushes": bool(both.fired("push/request")),
        "on a ring": both.before.graph.circumference is not None,
        "plain": plain(both),
    }


def plain(both: Both) -> bool:
    """Whether both profiles must end alike.

    One body is asked; nobody rides, overhangs, or changes its support under either; no request comes round a ring; no
    edge is shorter than the margin.
    """
    still = not (both.changed or both.left or both.fired("leave/blocked", "leave/nowhere"))
    level_headed = both.asked.body is not None and not both.rides and not overhangs(both)
    return still and level_headed and not round_a_ring(both) and bool(EDGES_LONG.holds(both.before, Fraction(0)))


def overhangs(both: Both) -> bool:
    """Whether a border is beyond the end of its edge, before or after."""
    worlds = (both.before, both.after)
    return any(distance < 0 for world in worlds for body in both.handles for distance in world.off_graph(body))


def part(seed: int, scenarios: int) -> Tally:
    """Compare the profiles over some scenarios; the same for the same seed."""
    random, tally = Random(seed), Tally()
    while tally.scenarios < scenarios:
        level = any_level(random)
        pair = Pair(level)
        for _ in range(min(STEPS, scenarios - tally.scenarios)):
            both = pair.step(any_asked(random, level))
            tally.note(both, seed)
            if not both.legal:
                break
    return tally


def any_asked(random: Random, level: Level[Fraction]) -> Asked:
    """A request of any body, or a tick if there are characters."""
    sign = random.choice((1, -1))
    if random.random() < 0.3 and any(body.speed for body in level.bodies):
        return Asked(None, Fraction(sign))
    distance = random.choice((Fraction(random.randint(1, 12), 8), Fraction(random.choice((1, 2, 3, 5)))))
    return Asked(random.randrange(len(level.bodies)), distance * sign)


def campaign(scenarios: int, seed: int, progress: Callable[[int], None]) -> Tally:
    """Compare the profiles over many scenarios, part by part; `progress` is told how many are done."""
    parts = [(seed + i, min(A_PART, scenarios - done)) for i, done in enumerate(range(0, scenarios, A_PART))]
    tally = Tally()
    with ProcessPoolExecutor(os.cpu_count(), get_context("forkserver")) as pool:
        for future in as_completed([pool.submit(part, *one) for one in parts]):
            tally.add(future.result())
            progress(tally.scenarios)
    return tally


def told(tally: Tally) -> list[str]:
    """What a comparison has counted, as lines."""
    same = tally.scenarios - tally.differ
    lines = [f"{tally.scenarios} scenarios, {same} end alike, {tally.differ} differ"]
    for name, floor in FLOORS.items():
        lines.append(f"  {name:<10} {tally.shares[name] / tally.scenarios:6.1%}  (at least {floor:.0%})")
    lines.append("causes, in how many scenarios each is at work, and alone:")
    lines += [f"  {name:<28} {count:>7} {tally.alone[name]:>7}" for name, count in tally.causes.most_common()]
    lines += [f"without a cause: {one}" for one in tally.unexplained]
    return lines + [f"too few: {one}" for one in tally.tame]
