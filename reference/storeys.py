"""The storeys of a level at one moment: solid intervals, and the bodies on them in order.

A body's handle is its place in the level's list of bodies. On a ring places are counted once round.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Generic

from spec.graph import Direction
from spec.number import N, Truth, greater, lesser, zero_like
from spec.storeys import Interval, once_round


@dataclass(frozen=True)
class Terrain(Generic[N]):
    """What is solid: for each storey, intervals from left to right with room between them.

    The floor is closed. Nothing is solid on storeys that are not listed. On a line both ends are walls, as high as one
    likes; on a ring there are none.
    """

    solid: tuple[tuple[Interval[N], ...], ...]
    ends: Interval[N] | None
    circumference: N | None = None

    def ground(self, storey: int) -> list[Interval[N]]:
        """The ground of a storey above the floor: what is solid below it, and not on it too.

        Where a wall goes on upwards there is no ground, not even for a body that a rounding has put into it.
        """
        pieces = list(self.on(storey - 1))
        for wall in self.on(storey):
            for by in [zero_like(wall.left)] if self.circumference is None else around(self.circumference):
                pieces = [left for piece in pieces for left in without(piece, wall.left + by, wall.right + by)]
        return pieces

    def on(self, storey: int) -> tuple[Interval[N], ...]:
        """What is solid on a storey."""
        return self.solid[storey] if storey < len(self.solid) else ()


@dataclass(frozen=True)
class Place(Generic[N]):
    """Where a body is: its storey, its left border, its width, the body that it stands on (None: the ground)."""

    storey: int
    left: N
    width: N
    support: int | None
    pushes: bool = True

    @property
    def right(self) -> N:
        """Its right border."""
        return self.left + self.width


class StoreyWorld(Generic[N]):
    """A world of storeys (`spec.storeys.Survey`). It is changed by advancing and letting down bodies.

    `known` is the ground of storeys that has been asked for.
    """

    def __init__(self, terrain: Terrain[N], margin: N, places: Sequence[Place[N]]) -> None:
        """Put the bodies in order, storey by storey."""
        self.terrain, self.margin, self.places = terrain, margin, list(places)
        self.rows: dict[int, list[int]] = {}
        self.known: dict[int, list[Interval[N]]] = {}
        for body, place in enumerate(places):
            self.rows.setdefault(place.storey, []).append(body)
        for storey in self.rows:
            self.order(storey)

    def order(self, storey: int) -> None:
        """Put the bodies of a storey in order."""
        self.rows[storey].sort(key=lambda body: self.places[body].left)

    def copy(self) -> StoreyWorld[N]:
        """An independent copy; the terrain is shared."""
        other = StoreyWorld(self.terrain, self.margin, ())
        other.places, other.rows = list(self.places), {storey: list(row) for storey, row in self.rows.items()}
        return other

    @property
    def circumference(self) -> N | None:
        """Once round a ring."""
        return self.terrain.circumference

    @property
    def ends(self) -> Interval[N] | None:
        """What lies between the walls at both ends of a line."""
        return self.terrain.ends

    def solid(self, storey: int) -> Sequence[Interval[N]]:
        """The terrain of a storey."""
        return self.terrain.on(storey)

    def span(self, body: int) -> Interval[N]:
        """Where a body is, from border to border."""
        return Interval(self.places[body].left, self.places[body].right)

    def part(self, bodies: Iterable[int]) -> StoreyWorld[N]:
        """The same world as if there were only some of its bodies: where they move in one, they move in the other."""
        other = StoreyWorld(self.terrain, self.margin, ())
        other.places, other.known = self.places, self.known
        for body in bodies:
            other.rows.setdefault(self.places[body].storey, []).append(body)
        for storey in other.rows:
            other.order(storey)
        return other

    def with_place(self, place: Place[N]) -> StoreyWorld[N]:
        """The same with one body more, the last."""
        return StoreyWorld(self.terrain, self.margin, [*self.places, place])

    def without(self, body: int) -> StoreyWorld[N]:
        """The same without a body; those that stood on it have lost their support, and later ones count one less."""
        supports = {other: other - (other > body) for other in range(len(self.places)) if other != body}
        rest = [place for other, place in enumerate(self.places) if other != body]
        kept = [replace(place, support=supports.get(-1 if place.support is None else place.support)) for place in rest]
        return StoreyWorld(self.terrain, self.margin, kept)

    def storeys(self) -> Sequence[int]:
        """The storeys on which bodies stand, the lowest first."""
        return sorted(storey for storey, row in self.rows.items() if row)

    def row(self, storey: int) -> Sequence[int]:
        """The bodies on a storey from left to right."""
        return tuple(self.rows[storey])

    def storey(self, body: int) -> int:
        """The storey of a body."""
        return self.places[body].storey

    def support(self, body: int) -> int | None:
        """The body on whose top a body stands."""
        return self.places[body].support

    def pushes(self, body: int) -> bool:
        """Whether the body may push others."""
        return self.places[body].pushes

    def neighbours(self) -> Iterator[tuple[int, int]]:
        """Each body with the next one on its right, if no wall is between them."""
        for row in map(self.row, self.storeys()):
            for left, right in zip(row, [*row[1:], *row[:1]], strict=True):
                follows = self.terrain.circumference is not None or right is not row[0]
                if follows and left != right and self.free_between(left, right):
                    yield left, right

    def at_one_place(self) -> Iterator[tuple[int, int]]:
        """Bodies on one storey whose left borders are at one place: on a ring no gap tells that they overlap."""
        for row in self.rows.values():
            for left, right in pairwise(row):
                if self.places[left].left == self.places[right].left:
                    yield left, right

    def free_between(self, left: int, right: int) -> bool:
        """Whether no wall is between two bodies."""
        wall = self.to_wall(left, Direction.RIGHT)
        return wall is None or bool(wall >= self.gap(left, right))

    def gap(self, left: int, right: int) -> N:
        """Distance from the right border of a body to the left border of its right neighbour."""
        return self.round(self.places[right].left - self.places[left].left) - self.places[left].width

    def round(self, distance: N) -> N:
        """A distance to the right; on a ring the one that is greater than 0 and at most once round."""
        circumference = self.terrain.circumference
        if circumference is None or distance > zero_like(distance):
            return distance
        return distance + circumference

    def to_wall(self, body: int, direction: Direction) -> N | None:
        """Distance from a body's border to the nearest wall on that side."""
        found = None
        for room in self.rooms(self.places[body], direction):
            found = room if found is None else lesser(found, room)
        return found

    def rooms(self, place: Place[N], direction: Direction) -> Iterator[N]:
        """Distances to the walls on one side."""
        ends = self.terrain.ends
        if ends is not None:
            yield ends.right - place.right if direction is Direction.RIGHT else place.left - ends.left
        for solid in self.terrain.on(place.storey):
            if direction is Direction.RIGHT:
                away, size = self.round(solid.left - place.left), place.width
            else:
                away, size = self.round(place.left - solid.left), solid.right - solid.left
            if away > zero_like(away):
                yield away - size

    def to_loss(self, body: int, direction: Direction) -> N | None:
        """How far a body can move relative to its support until that no longer holds it."""
        place = self.places[body]
        if place.support is None:
            return self.to_ledge(place, direction) if place.storey else None
        offset, below, round_ = self.offset(body, place.support), self.places[place.support], self.terrain.circumference
        if round_ is not None and place.width + below.width + self.margin * 2 > round_:
            return None
        beyond = below.width - offset if direction is Direction.RIGHT else offset + place.width
        return beyond + self.margin

    def to_ledge(self, place: Place[N], direction: Direction) -> N | None:
        """How far a body on the ground can move until it is over none, across gaps that it does not fit into."""
        start = zero_like(place.left) if direction is Direction.RIGHT else place.width * -1
        reach, round_ = start, self.terrain.circumference
        for ground in sorted(self.grounds(place, direction), key=lambda ground: ground.left):
            if ground.left < reach + place.width:
                reach = greater(reach, ground.right)
        return None if round_ is not None and reach >= round_ else reach - start

    def grounds(self, place: Place[N], direction: Direction) -> Iterator[Interval[N]]:
        """The grounds of a storey seen from a body's left border in a direction; on a ring as far as twice round.

        A body that goes nearly once round has its front border nearly twice round.
        """
        if place.storey not in self.known:
            self.known[place.storey] = self.terrain.ground(place.storey)
        yield from self.seen(place, self.known[place.storey], direction)

    def seen(self, place: Place[N], pieces: Sequence[Interval[N]], direction: Direction) -> Iterator[Interval[N]]:
        """Intervals seen from a body's left border in a direction; on a ring as far as twice round."""
        round_ = self.terrain.circumference
        for solid in pieces:
            left, right = solid.left - place.left, solid.right - place.left
            for by in [zero_like(left)] if round_ is None else [round_ * rounds for rounds in (-2, -1, 0, 1, 2)]:
                near, far = left + by, right + by
                yield Interval(near, far) if direction is Direction.RIGHT else Interval(far * -1, near * -1)

    def offset(self, body: int, below: int) -> N:
        """How far the left border of a body is to the right of that of another; on a ring, where they are over each
        other, or the way round on which their middles are nearer.
        """
        place, other, round_ = self.places[body], self.places[below], self.terrain.circumference
        offset = place.left - other.left
        if round_ is None:
            return offset
        between_middles = offset * 2 + place.width - other.width
        if between_middles > round_:
            return offset - round_
        return offset + round_ if between_middles < round_ * -1 else offset

    def holds(self, body: int) -> Truth:
        """Whether a body's support holds it."""
        support = self.places[body].support
        if support is None:
            return self.grounded(body)
        on_its_storey = self.places[support].storey == self.places[body].storey - 1
        return on_its_storey and self.carries(support, body)

    def carries(self, below: int, body: int) -> Truth:
        """Whether the top of a body holds one that stands a storey above it: no slot of a margin's width is between."""
        return self.overlap(body, below) + self.margin > zero_like(self.margin)

    def grounded(self, body: int) -> Truth:
        """Whether a body is over the ground of its storey."""
        place = self.places[body]
        zero = zero_like(place.left)
        return not place.storey or any(
            ground.left < place.width and ground.right > zero for ground in self.grounds(place, Direction.RIGHT)
        )

    def tops(self, body: int) -> Sequence[int]:
        """The bodies one storey below whose tops would hold a body, from left to right.

        One that would hold a body on both its sides, round a ring, is there twice.
        """
        below = [other for other in self.rows.get(self.places[body].storey - 1, ()) if self.carries(other, body)]
        held = [(offset, other) for other in below for offset in self.offsets(body, other)]
        return [other for _, other in sorted(held, key=lambda one: one[0] * -1)]

    def offsets(self, body: int, below: int) -> Iterator[N]:
        """The offset of a body that another holds; on a ring also that the other way round, if it is held there too."""
        offset, round_ = self.offset(body, below), self.terrain.circumference
        yield offset
        for other in [] if round_ is None else [offset - round_, offset + round_]:
            if self.overlap_at(other, body, below) + self.margin > zero_like(offset):
                yield other

    def overlap(self, body: int, below: int) -> N:
        """How much of a body is over another; less than 0 beside it."""
        return self.overlap_at(self.offset(body, below), body, below)

    def overlap_at(self, offset: N, body: int, below: int) -> N:
        """How much of a body is over another if its left border is so far to the right of that of the other."""
        width = self.places[below].width
        return lesser(offset + self.places[body].width, width) - greater(offset, zero_like(offset))

    def advance(self, body: int, distance: N) -> None:
        """Move a body by a signed distance."""
        place, round_ = self.places[body], self.terrain.circumference
        left = place.left + distance
        left = left if round_ is None else once_round(left, round_)
        self.places[body] = Place(place.storey, left, place.width, place.support, place.pushes)

    def in_terrain(self, body: int) -> bool:
        """Whether a body is where it is solid."""
        place = self.places[body]
        zero = zero_like(place.left)
        solid = self.seen(place, self.terrain.on(place.storey), Direction.RIGHT)
        return any(piece.left < place.width and piece.right > zero for piece in solid)

    def stand(self, body: int, support: int | None) -> None:
        """Give a body another support on its storey."""
        self.places[body] = replace(self.places[body], support=support)

    def drop(self, body: int) -> None:
        """Let a body down by a storey, where it has its place in the order."""
        place = self.places[body]
        self.rows[place.storey].remove(body)
        self.places[body] = replace(place, storey=place.storey - 1, support=None)
        self.rows.setdefault(place.storey - 1, []).append(body)
        self.order(place.storey - 1)


def around(circumference: N) -> list[N]:
    """Once round back, not at all, and once round on."""
    return [circumference * rounds for rounds in (-1, 0, 1)]


def without(piece: Interval[N], left: N, right: N) -> Iterator[Interval[N]]:
    """What is left of an interval when another is cut out of it."""
    if right <= piece.left or left >= piece.right:
        yield piece
        return
    if left > piece.left:
        yield Interval(piece.left, left)
    if right < piece.right:
        yield Interval(right, piece.right)
