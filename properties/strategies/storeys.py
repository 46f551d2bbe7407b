"""Random storeys: pits, tunnels and platforms, lines and rings, bodies in contact and on top of each other.

Worlds are made from a number by a generator of its own, which is many times as quick as drawing each of their sizes.
So what Hypothesis makes simple of a failure is how many bodies and storeys there are.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction
from random import Random

from hypothesis import strategies as st

from properties.strategies.rows import GRIDS
from reference.storeys import Place, StoreyWorld, Terrain
from spec.stepped import margins_kept, outside_terrain
from spec.storeys import Drive, Interval, once_round

ZERO, ONE = Fraction(0), Fraction(1)
WIDTHS = (ONE, ONE, ONE, ONE / 2, 2 * ONE, 3 * ONE)
SPEEDS = tuple(Fraction(speed) for speed in (1, -1, 2, -2, 3, -3))
MOST_BODIES, MOST_STOREYS, SEEDS, TRIES = 8, 3, 2**20, 8


@dataclass(frozen=True)
class Outing:
    """A world of storeys, and a step in it.

    Attributes:
        drives: one for each body.
        part: how long it is until the step may be split.
        order: the bodies in another order.
    """

    terrain: Terrain[Fraction]
    margin: Fraction
    places: tuple[Place[Fraction], ...]
    drives: tuple[Drive[Fraction], ...]
    duration: Fraction
    part: Fraction
    order: tuple[int, ...]

    def world(self) -> StoreyWorld[Fraction]:
        """The world at the beginning."""
        return StoreyWorld(self.terrain, self.margin, self.places)

    @property
    def drives_by_body(self) -> dict[int, Drive[Fraction]]:
        """The drives by the handles of the bodies."""
        return dict(enumerate(self.drives))


@dataclass(frozen=True)
class Maker:
    """Makes worlds, with all sizes on a grid. On one of tenths floats are not exact."""

    random: Random
    grid: int

    def size(self, most: int, least: int = 0) -> Fraction:
        """A multiple of one part of the grid, from so many parts up to a whole number."""
        return Fraction(self.random.randint(least, most * self.grid), self.grid)

    def solids(self, length: Fraction) -> list[Interval[Fraction]]:
        """The terrain of a storey: intervals with room between them."""
        found, along = [], self.size(3)
        while along < length:
            end = min(along + self.size(4, least=1), length)
            found.append(Interval(along, end))
            along = end + self.size(3, least=1)
        return found

    def terrain(self, storeys: int) -> Terrain[Fraction]:
        """A line or a ring of so many storeys above the floor."""
        length = Fraction(self.random.randint(6, 16))
        solid = [self.solids(length) for _ in range(storeys)]
        if self.random.random() < 0.7:
            return Terrain(tuple(map(tuple, solid)), Interval(ZERO, length))
        for storey in solid:
            if len(storey) > 1 and storey[-1].right == storey[0].left + length:
                storey.pop()
        return Terrain(tuple(map(tuple, solid)), None, length)

    def anywhere(self, terrain: Terrain[Fraction], margin: Fraction, placed: list[Place[Fraction]]) -> Place[Fraction]:
        """A body anywhere; often beside another, or partly above it."""
        width, pushes = self.random.choice(WIDTHS), self.random.random() < 0.9
        storey, left = self.random.randint(0, len(terrain.solid) + 1), self.size(16)
        near, how = self.random.choice(placed) if placed else None, self.random.random()
        if near is not None and how < 0.3:
            storey, left = near.storey, near.right + margin
        elif near is not None and how < 0.5:
            storey, left = near.storey + 1, near.left + self.size(3) - width
        round_ = terrain.circumference
        return Place(storey, left if round_ is None else once_round(left, round_), width, None, pushes)

    def placed(self, terrain: Terrain[Fraction], margin: Fraction, bodies: int) -> list[Place[Fraction]]:
        """Up to so many bodies, each where it is free and held."""
        found: list[Place[Fraction]] = []
        for _ in range(bodies):
            tries = (seated(terrain, margin, found, self.anywhere(terrain, margin, found)) for _ in range(TRIES))
            found += [place for place in tries if place is not None][:1]
        return found

    def full_ring(self, margin: Fraction, bodies: int) -> tuple[Terrain[Fraction], list[Place[Fraction]]]:
        """A ring without terrain that bodies in contact fill."""
        along, found = ZERO, []
        for _ in range(bodies):
            width = self.random.choice(WIDTHS)
            found.append(Place(0, along, width, None))
            along += width + margin
        return Terrain((), None, along), found

    def exact_fit(self, margin: Fraction, bodies: int) -> tuple[Terrain[Fraction], list[Place[Fraction]]]:
        """A full ring, but for one of two or more that is still above its place, or near."""
        terrain, (*rest, last) = self.full_ring(margin, max(bodies, 2))
        assert terrain.circumference is not None
        left = once_round(last.left + self.size(2) - ONE, terrain.circumference)
        place = seated(terrain, margin, rest, replace(last, storey=1, left=left))
        return terrain, rest if place is None else [*rest, place]

    def tower(self, margin: Fraction) -> tuple[Terrain[Fraction], list[Place[Fraction]]]:
        """A ring with a body on one that is on another, so wide that what it comes down to may hold it at both ends."""
        high, beside = (self.random.choice(WIDTHS) for _ in range(2))
        low = high + self.size(2, least=1)
        round_ = low + beside + margin * 4
        wide = round_ - high - margin * self.random.choice((2, 2, 3))
        terrain, shift, found = Terrain((), None, round_), self.size(3), list[Place[Fraction]]()
        on_low = (low - high) * self.random.randint(0, 4) / 4
        stand = (0, ZERO, low), (0, low + margin * 2, beside), (1, on_low, high), (2, on_low, wide)
        for storey, left, width in stand:
            place = Place(storey, once_round(left + shift, round_), width, None)
            held = seated(terrain, margin, found, place)
            found += [] if held is None else [held]
        return terrain, found

    def drives(self, bodies: int) -> list[Drive[Fraction]]:
        """What drives so many bodies: one key, one of them alone, or each its own drive."""
        kind, one, still = self.random.random(), self.drive(), Drive(ZERO)
        if kind < 0.2:
            key = Drive(one.speed, relative=False)
            return [key if self.random.random() < 0.6 else still for _ in range(bodies)]
        if kind < 0.35:
            alone = self.random.randrange(bodies)
            return [one if body == alone else still for body in range(bodies)]
        return [self.drive() if self.random.random() < 0.75 else still for _ in range(bodies)]

    def drive(self) -> Drive[Fraction]:
        """Any speed, in the plane or relative to what carries the body."""
        return Drive(self.random.choice(SPEEDS), self.random.random() < 0.5)


def seated(
    terrain: Terrain[Fraction], margin: Fraction, placed: list[Place[Fraction]], place: Place[Fraction]
) -> Place[Fraction] | None:
    """A place with what holds a body there, or None if it is not free or not held."""
    if terrain.circumference is not None and place.width + margin > terrain.circumference:
        return None
    world, body = StoreyWorld(terrain, margin, [*placed, place]), len(placed)
    if not (margins_kept(world, ZERO) and outside_terrain(world, ZERO)):
        return None
    if world.grounded(body):
        return place
    return next((replace(place, support=top) for top in world.tops(body)), None)


def outing(seed: int, bodies: int, storeys: int) -> Outing:
    """The world of a number, with up to so many bodies, and a step in it."""
    random = Random(seed)
    maker = Maker(random, random.choice(GRIDS))
    terrain, margin = maker.terrain(storeys), Fraction(random.choice((1, 2, 4)), 2 * maker.grid)
    placed = maker.placed(terrain, margin, bodies)
    kind = random.random()
    if kind < 0.06:
        terrain, placed = maker.full_ring(margin, bodies)
    elif kind < 0.09:
        terrain, placed = maker.exact_fit(margin, bodies)
    elif kind < 0.12:
        terrain, placed = maker.tower(margin)
    drives, duration = maker.drives(len(placed)) if placed else [], maker.size(random.choice((1, 6)))
    part, order = duration * random.randint(0, 8) / 8, random.sample(range(len(placed)), len(placed))
    return Outing(terrain, margin, tuple(placed), tuple(drives), duration, part, tuple(order))


def outings() -> st.SearchStrategy[Outing]:
    """A valid world and a step: several bodies driven, to either side, at several speeds, riders too."""
    numbers = st.integers(0, SEEDS), st.integers(1, MOST_BODIES), st.integers(0, MOST_STOREYS)
    return st.builds(outing, *numbers).filter(lambda made: bool(made.places))
