"""Scenes: many bodies on storeys, of which a step looks at no more than those that it can reach."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterable, Iterator, Mapping
from functools import cached_property
from itertools import pairwise
from typing import Generic

from reference.storeys import StoreyWorld, around
from spec.graph import Direction
from spec.number import N, greater, zero_like
from spec.storeys import Drive, once_round


class Scene(Generic[N]):
    """A world of storeys, who stands on whom in it, and who is not held by what it stands on.

    Attributes:
        world: all bodies; each row in the order of left borders, on a ring once round from 0.
        riders: who stands on a body.
        unheld: the bodies whose supports do not hold them.
    """

    def __init__(self, world: StoreyWorld[N]) -> None:
        """Look once at every body."""
        self.world = world
        self.riders: dict[int, set[int]] = {}
        self.unheld: set[int] = set()
        for body in range(len(world.places)):
            self.note(body)

    def note(self, body: int) -> None:
        """Note what a body stands on, and whether that holds it."""
        support = self.world.support(body)
        if support is not None:
            self.riders.setdefault(support, set()).add(body)
        if not self.world.holds(body):
            self.unheld.add(body)

    def forget(self, body: int) -> None:
        """Forget what a body stands on."""
        support = self.world.support(body)
        if support is not None:
            self.riders[support].remove(body)
        self.unheld.discard(body)

    def take_out(self, bodies: Iterable[int]) -> StoreyWorld[N]:
        """A world of some bodies, at the same places; until they are put back they are in no row of the scene."""
        part = self.world.part(bodies)
        for storey in part.storeys():
            for body in part.row(storey):
                del self.world.rows[storey][self.place_in_row(body)]
                self.forget(body)
        return part

    def put_back(self, part: StoreyWorld[N]) -> None:
        """Put the bodies of a part into their rows, where they are now."""
        for storey in part.storeys():
            for body in part.row(storey):
                self.world.rows.setdefault(storey, []).insert(self.place_in_row(body), body)
                self.note(body)

    def left(self, body: int) -> N:
        """Where a body begins."""
        return self.world.places[body].left

    def right(self, body: int) -> N:
        """Where a body ends."""
        return self.world.places[body].right

    def place_in_row(self, body: int) -> int:
        """How many bodies of its storey are on the left of a body."""
        return bisect_left(self.world.rows.get(self.world.storey(body), ()), self.left(body), key=self.left)

    def ahead(self, body: int, direction: Direction) -> int | None:
        """The next body on a storey, if there is another; on a ring also the one beyond the seam."""
        row = self.world.rows[self.world.storey(body)]
        place = self.place_in_row(body) + direction
        if self.world.circumference is not None:
            return row[place % len(row)] if len(row) > 1 else None
        return row[place] if 0 <= place < len(row) else None

    def gap(self, body: int, ahead: int, direction: Direction) -> N:
        """The distance from a body to the next one in a direction."""
        return self.world.gap(body, ahead) if direction is Direction.RIGHT else self.world.gap(ahead, body)

    def between(self, storey: int, left: N, right: N) -> Iterator[int]:
        """The bodies of a storey of which some part is between two places."""
        row, round_ = self.world.rows[storey], self.world.circumference
        if round_ is not None and right - left >= round_:
            yield from row
            return
        start = left if round_ is None else once_round(left, round_)
        for by in [zero_like(left)] if round_ is None else around(round_):
            first = bisect_left(row, start + by, key=self.right)
            yield from row[first : bisect_right(row, start + right - left + by, key=self.left)]


class Reach(Generic[N]):
    """Who may move in a step, or be met by one who does, and no fewer.

    Why nobody else matters. At no time is anybody on a storey faster than one drive on each storey up to it, added up.
    So nobody moves further than `most`. A body that stays on the ground all the time, and that nobody can come down to,
    keeps its place in the row: it is pushed from behind only, no further than its neighbour there may move, less the
    room between them. Any other body may move as far as anybody. Whoever may lose its support can come to stand, or
    come down, wherever those are now that could meet it when both have moved. Who stands on a body may move with it.

    Attributes:
        most: how far anybody may move, and more than any rounding besides.
        ways: how far each body may move to each side; who is not in it stays, and is met by nobody.
        looked: on each storey, between which places it was last looked who is there that one may come down to.
    """

    def __init__(self, scene: Scene[N], driven: Mapping[int, Drive[N]], duration: N) -> None:
        """Find those whom drives for a time may reach."""
        self.scene, self.most = scene, most_moved(scene.world, driven, duration)
        self.anywhere = dict.fromkeys(Direction, self.most)
        self.ways: dict[int, dict[Direction, N]] = {}
        self.looked: dict[int, tuple[N, N]] = {}
        self.steadily: dict[int, bool] = {}
        self.waiting: list[int] = []
        for body, drive in driven.items():
            self.drive(body, drive)
        for body in scene.unheld:
            self.free(body)
        while self.waiting:
            self.go_on(self.waiting.pop())

    def drive(self, body: int, drive: Drive[N]) -> None:
        """Let a body move of its own."""
        self.ways.setdefault(body, {})
        for direction in Direction:
            if drive.speed * direction > zero_like(drive.speed) or not self.stays(body):
                self.push(body, direction, self.most)

    def push(self, body: int, direction: Direction, far: N) -> None:
        """Let a body be moved so far, unless that is less than nothing, or no more than is known."""
        if far < zero_like(far):
            return
        if not self.stays(body):
            self.free(body)
        elif direction not in self.ways.setdefault(body, {}) or far > self.ways[body][direction]:
            self.ways[body][direction] = far
            self.waiting.append(body)

    def free(self, body: int) -> None:
        """Let a body move as far as anybody, to both sides."""
        if self.ways.get(body) is not self.anywhere:
            self.ways[body] = self.anywhere
            self.waiting.append(body)

    def go_on(self, body: int) -> None:
        """Go on to those whom a body may meet, carry or come down to."""
        for direction, far in list(self.ways[body].items()):
            ahead = self.scene.ahead(body, direction)
            if ahead is not None:
                room = self.scene.gap(body, ahead, direction) - self.scene.world.margin
                self.push(ahead, direction, far - greater(room, zero_like(room)))
        for rider in self.scene.riders.get(body, ()):
            self.free(rider)
        if not self.stays(body):
            self.come_down(body, self.most * 2 + self.scene.world.margin)

    def come_down(self, body: int, beside: N) -> None:
        """Let a body come down to all who are under it, or no further beside that."""
        left, right = self.scene.left(body) - beside, self.scene.right(body) + beside
        storey = self.lower.get(self.scene.world.storey(body))
        while storey is not None and not self.has_looked(storey, left, right):
            self.looked[storey] = left, right
            for below in self.scene.between(storey, left, right):
                self.free(below)
            storey = self.lower.get(storey)

    def has_looked(self, storey: int, left: N, right: N) -> bool:
        """Whether it is known who is on a storey, and on all below, between two places."""
        if storey not in self.looked:
            return False
        last_left, last_right = self.looked[storey]
        return bool(last_left <= left) and bool(right <= last_right)

    @cached_property
    def lower(self) -> dict[int, int]:
        """For each storey on which bodies stand, the next one below it."""
        return {upper: lower for lower, upper in pairwise(self.scene.world.storeys())}

    def stays(self, body: int) -> bool:
        """Whether a body is on ground that it does not lose, however far it moves."""
        if body not in self.steadily:
            rooms = (self.scene.world.to_loss(body, direction) for direction in Direction)
            on_ground = self.scene.world.support(body) is None
            self.steadily[body] = on_ground and all(room is None or room > self.most for room in rooms)
        return self.steadily[body]


def most_moved(world: StoreyWorld[N], driven: Mapping[int, Drive[N]], duration: N) -> N:
    """How far anybody may move in a step at most, with a margin more than any roundings.

    Whoever is carried has the speed of its support, and its own; so on each storey at most one drive is added.
    """
    speeds = sorted((greater(drive.speed, drive.speed * -1) for drive in driven.values()), reverse=True)
    most = zero_like(duration)
    for speed in speeds[: 1 + max(map(world.storey, driven), default=0)]:
        most = most + speed
    return most * duration + world.margin
