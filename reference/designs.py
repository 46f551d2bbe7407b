"""Strings of bodies that are held by a design: moved by it, and its work counted (4.3; E9).

A crowd knows the strings and the order of bodies from a world, and where bodies are from what the design stores.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any, Generic

from reference.simulator import Record, fulfil, heard
from reference.world import Facing, World
from spec.body import EdgePosition
from spec.designs import Design, Part, border, request
from spec.graph import Direction
from spec.number import N, lesser, zero_like
from spec.profiles import Profile
from spec.rules.request import Ask
from spec.rules.walk import walk_freely
from spec.world import Beyond


@dataclass
class Cost:
    """A number of collided moves M_C, uncollided moves M and look-ups L."""

    collided: int = 0
    uncollided: int = 0
    look_ups: int = 0

    @property
    def moves(self) -> Cost:
        """The same without look-ups, which table 4.2 leaves out of moves."""
        return Cost(self.collided, self.uncollided)

    def __str__(self) -> str:
        """A sum, as table 4.2 has it."""
        terms = (("M_C", self.collided), ("M", self.uncollided), ("L", self.look_ups))
        return " + ".join(name if count == 1 else f"{count} {name}" for name, count in terms if count) or "0"


@dataclass
class Crowd(Generic[N]):
    """The bodies of a level, held by a design.

    Attributes:
        world: the strings, and the order of bodies on them, which no motion changes.
        halves: half the width of each body; `places` is what the design stores of it.
        neighbour: who finds the one ahead of a body.
        cost: what has been done since it was set anew.
    """

    design: Design
    profile: Profile
    world: World[N]
    halves: list[N]
    places: list[dict[Part, EdgePosition[N]]]
    neighbour: Neighbour
    cost: Cost = field(default_factory=Cost)

    def facing(self, direction: Direction) -> Crossing[N]:
        """This crowd as a motion in one direction sees it."""
        return Crossing(self, direction)

    def move(self, body: int, direction: Direction, distance: N, most: int | None = None) -> tuple[N, Record]:
        """Request a body to move by `distance >= 0`; return the distance moved and the record.

        Raises:
            Endless: if more than `most` rules fire.
        """
        record = Record(body, most)
        rules, held = heard(self.profile.rules, record), self.facing(direction)

        def begin(ask: Ask[N, int]) -> Generator[Ask[N, int], N, N]:
            return request(self.design, rules, held, ask.body, ask.distance, ask.spare)

        limit = self.profile.push_limit(len(self.places))
        return fulfil(Ask(body, distance, limit - 1), begin, record), record

    def border(self, body: int, side: Part) -> EdgePosition[N]:
        """Where a border of a body is."""
        return border(self.design, self.facing(Direction.RIGHT), body, side)

    def along(self, body: int, side: Part) -> N:
        """How far along its string a border is; on a ring, once round."""
        row, along = self.world.row(body), self.world.coordinate(self.border(body, side))
        return along - row.length if row.closed and along >= row.length else along

    def has_left(self, body: int, direction: Direction) -> bool:
        """Whether a body has left its edge: all positions that it stands on are beyond the end."""
        view, parts = self.world.facing(direction), self.design.stands_on(direction)
        return all(view.reach(self.places[body][part]) < zero_like(self.world.margin) for part in parts)


def crowd_of(design: Design, profile: Profile, world: World[N], neighbour: Neighbour | None = None) -> Crowd[N]:
    """The bodies of a world, held by a design; who is ahead is known by the order, if not said otherwise."""
    halves: list[N] = [world.width(body) / like(2, world.margin) for body in world.handles()]
    crowd = Crowd(design, profile, world, halves, [], neighbour or by_order)
    for body, held in enumerate(world.bodies):
        centre = crowd.facing(Direction.RIGHT).freely(held.left, halves[body], Direction.RIGHT)
        every = {Part.LEFT: held.left, Part.CENTRE: centre, Part.RIGHT: held.right}
        crowd.places.append({part: every[part] for part in design.stored})
    crowd.cost = Cost()
    return crowd


def like(number: int, other: N) -> Any:
    """A whole number, of the kind of another number where that is a float."""
    return number if isinstance(other, float) else Fraction(number)


Neighbour = Callable[["Crossing[Any]", int, EdgePosition[Any]], int | None]
"""Who is ahead of a body whose leader is at a position."""


def by_order(crossing: Crossing[Any], body: int, at: EdgePosition[Any]) -> int | None:
    """The next body in the order of the string."""
    return crossing.crowd.world.beside(body, crossing.direction)


def by_border(crossing: Crossing[Any], body: int, at: EdgePosition[Any]) -> int | None:
    """The nearest body whose facing border is at the position or ahead of it."""
    return nearest(crossing, body, at, Part(-crossing.direction))


def by_centre(crossing: Crossing[Any], body: int, at: EdgePosition[Any]) -> int | None:
    """The nearest body whose centre is at the position or ahead of it."""
    return nearest(crossing, body, at, Part.CENTRE)


def nearest(crossing: Crossing[Any], body: int, at: EdgePosition[Any], part: Part) -> int | None:
    """The body, other than one, of which a position is the nearest at a position or ahead of it, on one line."""
    crowd, start = crossing.crowd, crossing.crowd.world.coordinate(at)
    away = {
        other: (crowd.world.coordinate(places[part]) - start) * crossing.direction
        for other, places in enumerate(crowd.places)
        if other != body
    }
    ahead = {other: distance for other, distance in away.items() if distance >= zero_like(distance)}
    return min(ahead, key=lambda other: ahead[other], default=None)


@dataclass(frozen=True)
class Crossing(Generic[N]):
    """A crowd as a motion in one direction sees it (`spec.designs.Held`)."""

    crowd: Crowd[N]
    direction: Direction

    def at(self, body: int, part: Part) -> EdgePosition[N]:
        """A position that is stored."""
        self.crowd.cost.look_ups += 1
        return self.crowd.places[body][part]

    def leading(self, body: int) -> Leading[N]:
        """The world as the leader of a body sees it."""
        self.crowd.cost.collided += 1
        plain = self.crowd.world.facing(self.direction)
        led_by_centre = self.crowd.design.leader(self.direction) is Part.CENTRE
        return Leading(self, plain, self.crowd.halves[body] if led_by_centre else None)

    def freely(self, at: EdgePosition[N], distance: N, towards: Direction) -> EdgePosition[N]:
        """Where an uncollided move ends."""
        self.crowd.cost.uncollided += 1
        return walk_freely(self.crowd.profile.rules.walk, self.crowd.world.facing(towards), at, distance).at

    def half(self, body: int) -> N:
        """Half the width of a body."""
        half: N = self.crowd.halves[body]
        return half

    def put(self, body: int, places: Mapping[Part, EdgePosition[N]]) -> None:
        """Store where a body is."""
        self.crowd.places[body] = dict(places)


@dataclass(frozen=True)
class Leading(Generic[N]):
    """A string as the leader of a body sees it (`spec.world.View`): a border, or a centre to which all is wider.

    `half` is by how much wider: half the width of the body that the centre leads, or None.
    """

    crossing: Crossing[N]
    plain: Facing[N]
    half: N | None

    @property
    def margin(self) -> N:
        """The collision margin."""
        return self.plain.margin

    def reach(self, at: EdgePosition[N]) -> N:
        """Distance to the end of the edge, or to the wall if that is nearer."""
        room = self.to_wall(at)
        return self.plain.reach(at) if room is None else lesser(self.plain.reach(at), room)

    def to_wall(self, at: EdgePosition[N]) -> N | None:
        """How far the centre may go for the wall at the end of the string, if there is one and a centre leads."""
        row, towards = self.plain.world.row_of_edge[at.edge], self.plain.direction
        last = row.edges[-1 if towards is Direction.RIGHT else 0]
        if self.half is None or row.closed or self.plain.beyond(self.plain.tip(last, towards)).ledge:
            return None
        along = self.plain.world.coordinate(at)
        return (row.length - along if towards is Direction.RIGHT else along) - self.half

    def along(self, at: EdgePosition[N], distance: N) -> EdgePosition[N]:
        """The position `distance` ahead on the same edge."""
        return self.plain.along(at, distance)

    def end(self, at: EdgePosition[N]) -> EdgePosition[N]:
        """The end of the edge, or the place at the wall."""
        return self.plain.end(at) if self.to_wall(at) is None else self.along(at, self.reach(at))

    def beyond(self, at: EdgePosition[N]) -> Beyond[EdgePosition[N]]:
        """What follows: nothing, where the wall is nearer than the end of the edge."""
        room = self.to_wall(at)
        return self.plain.beyond(at) if room is None or room > self.plain.reach(at) else Beyond(None, ledge=False)

    def ahead(self, body: int, front: EdgePosition[N]) -> int | None:
        """The neighbour, if it is on this edge or the next."""
        other = self.crossing.crowd.neighbour(self.crossing, body, front)
        following = self.plain.beyond(front).onward
        if other is None or following is None:
            return other
        in_sight = self.plain.reach(front) + self.plain.world.length_of(following.edge)
        return other if self.gap(front, other) <= in_sight else None

    def gap(self, front: EdgePosition[N], other: int) -> N:
        """Distance to the facing border of a neighbour, from where this body's own is."""
        crowd, world, facing = self.crossing.crowd, self.plain.world, Part(-self.plain.direction)
        stored = facing in crowd.places[other]
        there = crowd.places[other][facing if stored else Part.CENTRE]
        distance = (world.coordinate(there) - world.coordinate(front)) * self.plain.direction
        row = world.row_of_edge[there.edge]
        if row.closed and distance < zero_like(distance):
            distance = distance + row.length
        before = zero_like(distance) if self.half is None else self.half
        return distance - before if stored else distance - before - crowd.halves[other]

    def pushes(self, body: int) -> bool:
        """Whether the body may push others."""
        return self.plain.pushes(body)
