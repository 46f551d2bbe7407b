"""The profile `repaired` as a second program, written from `graphbody explain profile/repaired` and docs/formats.md.

It shares no line with the specification or the reference, and whoever wrote it had read neither. Its numbers are
fractions, its only input is a scenario as it stands in a file, and its only output is what a trace says of each step.
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import pairwise
from math import ceil
from typing import Any

Span = tuple[Fraction, Fraction]
"""A stretch from left to right, in units of length."""

Contact = tuple[int, int]
"""The indexes of two bodies that touch, the left one first."""

ZERO = Fraction(0)


@dataclass
class Body:
    """A body: `left` is where its left border is, `support` the index of the body that it is on, None for the ground.

    `speed`, in units of length per second, is more than 0 for a character; `moved` is its way since the step began.
    """

    name: str
    left: Fraction
    width: Fraction
    storey: int
    support: int | None
    speed: Fraction
    pushes: bool
    moved: Fraction = ZERO

    @property
    def right(self) -> Fraction:
        """Where its right border is."""
        return self.left + self.width


@dataclass(frozen=True)
class Drive:
    """What is asked for a step: who is driven how fast, for how many seconds."""

    speeds: dict[int, Fraction]
    time: Fraction


@dataclass(frozen=True)
class Event:
    """What happened to a body, `time` seconds after the step began; `other` is the second body in it, if any."""

    time: Fraction
    rule: str
    body: str
    other: str | None = None


@dataclass(frozen=True)
class GroundEdge:
    """A level edge with ground: its number in the level, its borders, its storey, and the vertices at its ends."""

    number: int
    span: Span
    storey: int
    ends: tuple[int, int]


@dataclass(frozen=True)
class Outcome:
    """What a trace says of a step: moves, places and supports as they stand there, and the events."""

    moves: list[dict[str, Any]]
    bodies: list[dict[str, Any]]
    supports: dict[str, str]
    events: list[Event]


def merged(spans: Iterable[Span]) -> list[Span]:
    """Return the same stretches, from left to right, with those that touch or overlap as one."""
    result: list[Span] = []
    for left, right in sorted(spans):
        if result and left <= result[-1][1]:
            result[-1] = (result[-1][0], max(right, result[-1][1]))
        else:
            result.append((left, right))
    return result


def overlap(first: Span, second: Span) -> Fraction:
    """Return by how much two stretches overlap; less than 0 is the gap between them."""
    return min(first[1], second[1]) - max(first[0], second[0])


class Terrain:
    """What never moves: walls and ground of each storey, and the edges that places are told by."""

    def __init__(self, level: dict[str, Any], height: Fraction) -> None:
        self.points = [(Fraction(x), Fraction(y)) for x, y in level["vertices"]]
        around = level.get("circumference")
        self.circumference = None if around is None else Fraction(around)
        self.height = height
        self.floor = min(y for _, y in self.points)
        self.edges: list[GroundEdge] = []
        self.solid: dict[int, list[Span]] = {}
        for number, edge in enumerate(level.get("edges") or self.joined()):
            self.add(number, edge)
        self.solid = {storey: merged(self.copies(spans)) for storey, spans in self.solid.items()}

    def joined(self) -> list[dict[str, Any]]:
        """Return the edges of a level that names none: each vertex joined to the next, and round a cylinder."""
        count = len(self.points)
        last = count if self.circumference is not None else count - 1
        return [{"left": number, "right": (number + 1) % count} for number in range(last)]

    def add(self, number: int, edge: dict[str, Any]) -> None:
        """Take in an edge, if it is ground, and what is solid under it."""
        (left, y), (right, other_y) = self.points[edge["left"]], self.points[edge["right"]]
        if y != other_y:
            return
        if self.circumference is not None:
            right = left + ((right - left) % self.circumference or self.circumference)
        storey = int((y - self.floor) / self.height)
        self.edges.append(GroundEdge(number, (left, right), storey, (edge["left"], edge["right"])))
        thickness = edge.get("thickness")
        deep = storey if thickness is None else min(storey, int(Fraction(thickness) / self.height))
        for below in range(storey - deep, storey):
            self.solid.setdefault(below, []).append((left, right))

    def copies(self, spans: Iterable[Span]) -> Iterator[Span]:
        """Yield stretches, on a cylinder as often as a body with its left border in the first round can meet them."""
        around = self.circumference
        if around is None:
            yield from spans
        else:
            yield from ((left + k * around, right + k * around) for left, right in spans for k in range(-6, 7))

    def ends(self) -> Span:
        """Return the left-most and the right-most place of a vertex: on a line, the ends of the level."""
        return min(x for x, _ in self.points), max(x for x, _ in self.points)

    def walls(self, storey: int) -> list[Span]:
        """Return what no body on a storey can enter."""
        solid = self.solid.get(storey, [])
        if self.circumference is not None:
            return solid
        left, right = self.ends()
        return merged([(left - 1, left), *solid, (right, right + 1)])

    def ground(self, storey: int) -> list[Span]:
        """Return what a body on a storey can stand on, other bodies apart."""
        if storey == 0:
            left, right = self.ends()
            rounds = 7 * (self.circumference or ZERO)
            return [(left - rounds, right + rounds)]
        return self.solid.get(storey - 1, [])

    def strings(self, storey: int) -> list[list[GroundEdge]]:
        """Return the ground edges of a storey, those that are joined in one string, from left to right."""
        edges = [edge for edge in self.edges if edge.storey == storey]
        after = {edge.ends[0]: edge for edge in edges}
        targets = {edge.ends[1] for edge in edges}
        result = []
        for first in [edge for edge in edges if edge.ends[0] not in targets] or edges[:1]:
            string = [first]
            while (following := after.get(string[-1].ends[1])) is not None and following is not first:
                string.append(following)
            result.append(string)
        return result


def positions(terrain: Terrain, body: Body) -> tuple[dict[str, Any], dict[str, Any]]:
    """Return the edge positions of a body on the ground, on the first string of edges under it."""
    found, around = [], terrain.circumference
    begins = {edge.number: edge.span[0] if around is None else edge.span[0] % around for edge in terrain.edges}
    for string in sorted(terrain.strings(body.storey), key=lambda edges: begins[edges[0].number]):
        for laid in laid_out(terrain, string):
            if overlap((laid[0][1][0], laid[-1][1][1]), (body.left, body.right)) > 0:
                found.append(laid)
    laid = found[0]
    left = next((edge for edge in laid if body.left < edge[1][1]), laid[-1])
    right = next((edge for edge in reversed(laid) if body.right > edge[1][0]), laid[0])
    return (
        {"edge": left[0], "location": body.left - left[1][0]},
        {"edge": right[0], "location": body.right - right[1][0]},
    )


def laid_out(terrain: Terrain, string: list[GroundEdge]) -> Iterator[list[tuple[int, Span]]]:
    """Yield a string as numbers and borders of edges that go on to the right, also over the seam of a cylinder."""
    x, once = string[0].span[0], []
    for edge in string:
        length = edge.span[1] - edge.span[0]
        once.append((edge.number, (x, x + length)))
        x += length
    around = terrain.circumference
    if around is None:
        yield once
        return
    rounds = [
        [(number, (left + k * around, right + k * around)) for number, (left, right) in once] for k in range(-5, 6)
    ]
    if x - once[0][1][0] == around:
        yield [edge for one in rounds for edge in one]
    else:
        yield from rounds


@dataclass
class World:
    """A level as it is played: its terrain, its bodies, and what is recorded as in contact or at a wall.

    `walls` holds the indexes of bodies at a wall, each with 1 for a wall on its right and -1 for one on its left.
    """

    terrain: Terrain
    margin: Fraction
    bodies: list[Body]
    contacts: set[Contact] = field(default_factory=set)
    walls: set[tuple[int, int]] = field(default_factory=set)
    velocities: list[Fraction] = field(default_factory=list)
    events: list[Event] = field(default_factory=list)

    def play(self, drive: Drive) -> None:
        """Play a step: settle, record, then go from event to event until the time is up."""
        self.events, self.velocities = [], [ZERO] * len(self.bodies)
        for body in self.bodies:
            body.moved = ZERO
        now = ZERO
        self.settle({i for i in range(len(self.bodies)) if not self.holds(i, self.bodies[i].support)}, now)
        self.record()
        while now < drive.time:
            self.find_velocities(drive)
            coming = list(self.coming())
            time = min([drive.time - now, *(left for left, _, _, _ in coming)])
            now += time
            self.move(time)
            self.settle(self.happen([event for event in coming if event[0] == time], now), now)

    # Who stands where

    def on(self, storey: int) -> list[int]:
        """Return the indexes of the bodies on a storey, from left to right."""
        there = [i for i, body in enumerate(self.bodies) if body.storey == storey]
        return sorted(there, key=lambda i: self.bodies[i].left)

    def support_spans(self, i: int, support: int | None) -> list[Span]:
        """Return the stretches that hold a body on a storey as long as it overlaps them by more than 0."""
        if support is None:
            return self.terrain.ground(self.bodies[i].storey)
        top = self.bodies[support]
        return merged(self.terrain.copies([(top.left - self.margin, top.right + self.margin)]))

    def holds(self, i: int, support: int | None) -> bool:
        """Return whether a support, if it is one storey below, holds a body."""
        body = self.bodies[i]
        return any(overlap(span, (body.left, body.right)) > 0 for span in self.support_spans(i, support))

    def neighbours(self, storey: int) -> Iterator[tuple[int, int, Fraction]]:
        """Yield the neighbours on a storey, the left one first, each two with the gap between them."""
        row, around = self.on(storey), self.terrain.circumference
        pairs = list(pairwise(row))
        if around is not None and len(row) > 1:
            pairs.append((row[-1], row[0]))
        for i, j in pairs:
            start, end = self.bodies[i].right, self.bodies[j].left
            if end < start and around is not None:
                end += around * ceil((start - end) / around)
            if all(overlap(wall, (start, end)) <= 0 for wall in self.terrain.walls(storey)):
                yield i, j, end - start

    def wall_distance(self, i: int, way: int) -> Fraction | None:
        """Return how far it is from a body to the next wall one way, None if there is none."""
        body = self.bodies[i]
        spans = self.terrain.walls(body.storey)
        if way > 0:
            return min((wall[0] - body.right for wall in spans if wall[0] >= body.right), default=None)
        return min((body.left - wall[1] for wall in spans if wall[1] <= body.left), default=None)

    def record(self) -> None:
        """Record anew who is in contact, and who is at a wall."""
        storeys = {body.storey for body in self.bodies}
        self.contacts = {(i, j) for s in storeys for i, j, gap in self.neighbours(s) if gap <= self.margin}
        self.walls = {(i, way) for i in range(len(self.bodies)) for way in (-1, 1) if self.wall_distance(i, way) == 0}

    # Velocities

    def find_velocities(self, drive: Drive) -> None:
        """Find how fast each body is, storey by storey upwards, row by row."""
        for storey in sorted({body.storey for body in self.bodies}):
            for row, closed in self.rows(storey):
                wishes = [self.wish(i, drive) for i in row]
                for i, velocity in zip(row, self.row_velocities(row, wishes, closed), strict=True):
                    self.velocities[i] = velocity

    def rows(self, storey: int) -> Iterator[tuple[list[int], bool]]:
        """Yield the longest chains of bodies in contact on a storey, and whether they close on themselves."""
        after = {i: j for i, j, _ in self.neighbours(storey) if (i, j) in self.contacts}
        left = self.on(storey)
        behind = set(after.values())
        for first in [i for i in left if i not in behind] or left[:1]:
            row = [first]
            while (following := after.get(row[-1])) is not None and following != first:
                row.append(following)
            yield row, first in behind

    def wish(self, i: int, drive: Drive) -> Fraction:
        """Return the velocity that a body wishes."""
        body, own = self.bodies[i], drive.speeds.get(i)
        if body.speed > 0 and own is not None:
            return own
        return (own or ZERO) + self.support_velocity(i)

    def support_velocity(self, i: int) -> Fraction:
        """Return the velocity of what a body stands on."""
        support = self.bodies[i].support
        return ZERO if support is None else self.velocities[support]

    def row_velocities(self, row: list[int], wishes: list[Fraction], closed: bool) -> list[Fraction]:
        """Return the velocities in a row, from its wishes."""
        if closed:
            return [ZERO] * len(row)
        pushes = [self.bodies[i].pushes for i in row]
        to_right, to_left = both_ways(wishes, pushes)
        squeezed = [right > 0 and left > 0 for right, left in zip(to_right, to_left, strict=True)]
        wishes = [ZERO if stuck else wish for wish, stuck in zip(wishes, squeezed, strict=True)]
        pushes = [may and not stuck for may, stuck in zip(pushes, squeezed, strict=True)]
        to_right, to_left = both_ways(wishes, pushes)
        to_right = cut(to_right, [stuck or (i, 1) in self.walls for i, stuck in zip(row, squeezed, strict=True)])
        shut_left = [stuck or (i, -1) in self.walls for i, stuck in zip(row, squeezed, strict=True)]
        to_left = cut(to_left[::-1], shut_left[::-1])[::-1]
        return [right - left for right, left in zip(to_right, to_left, strict=True)]

    # Events

    def coming(self) -> Iterator[tuple[Fraction, str, int, int]]:
        """Yield what comes: in how much time, by which rule, to whom, and the other body or the side of the wall."""
        for storey in {body.storey for body in self.bodies}:
            for i, j, gap in self.neighbours(storey):
                nearer = self.velocities[i] - self.velocities[j]
                if nearer > 0 and (i, j) not in self.contacts:
                    yield (gap - self.margin) / nearer, "event/contact", i, j
        for i, velocity in enumerate(self.velocities):
            way = 1 if velocity > 0 else -1
            if velocity != 0 and (i, way) not in self.walls and (room := self.wall_distance(i, way)) is not None:
                yield room / abs(velocity), "event/wall", i, way
            if (loss := self.until_lost(i)) is not None:
                yield loss, "event/support-lost", i, 0

    def until_lost(self, i: int) -> Fraction | None:
        """Return after how much time a body loses its support, None if it never does."""
        body = self.bodies[i]
        velocity = self.velocities[i] - self.support_velocity(i)
        spans = self.support_spans(i, body.support)
        left = body.left
        if velocity < 0:
            spans, left = [(-end, -start) for start, end in reversed(spans)], -body.right
        if velocity == 0:
            return None
        starts = [start for start, _ in spans[1:]]
        for (_, end), start in zip(spans, [*starts, None], strict=True):
            endless = start is None and self.terrain.circumference is None
            if end > left and (endless or (start is not None and start - end >= body.width)):
                return (end - left) / abs(velocity)
        return None

    def happen(self, coming: list[tuple[Fraction, str, int, int]], now: Fraction) -> set[int]:
        """Record the events of an instant; return who has lost its support."""
        lost = set()
        for _, rule, i, other in coming:
            partner = None
            if rule == "event/contact":
                self.contacts.add((i, other))
                partner = other
            elif rule == "event/wall":
                self.walls.add((i, other))
            else:
                lost.add(i)
                partner = self.bodies[i].support
            self.tell(now, rule, i, partner)
        return lost

    def tell(self, now: Fraction, rule: str, i: int, other: int | None = None) -> None:
        """Write down an event."""
        self.events.append(Event(now, rule, self.bodies[i].name, None if other is None else self.bodies[other].name))

    def move(self, time: Fraction) -> None:
        """Let time pass: move all bodies, and forget who is no longer in contact or at a wall."""
        if time == 0:
            return
        for body, velocity in zip(self.bodies, self.velocities, strict=True):
            body.left += velocity * time
            body.moved += velocity * time
            if self.terrain.circumference is not None:
                body.left %= self.terrain.circumference
        self.contacts = {(i, j) for i, j in self.contacts if self.velocities[j] <= self.velocities[i]}
        self.walls = {(i, way) for i, way in self.walls if self.velocities[i] * way >= 0}

    # Settling

    def settle(self, lost: set[int], now: Fraction) -> None:
        """Let all bodies that lost their support find another, lowest storey first; then record anew what touches."""
        settled = False
        for i in sorted(range(len(self.bodies)), key=lambda i: self.bodies[i].storey):
            body = self.bodies[i]
            fallen = body.support is not None and self.bodies[body.support].storey != body.storey - 1
            if i in lost or fallen:
                motion = self.velocities[i] - self.support_velocity(i)
                self.find_support(i, motion, body.support if i in lost else None, now)
                settled = True
        if settled:
            self.record()

    def find_support(self, i: int, motion: Fraction, lost: int | None, now: Fraction) -> None:
        """Let a body stand on the ground or a top of its storey, or else fall by a storey and look again."""
        body = self.bodies[i]
        while not self.holds(i, None):
            tops = [j for j in self.on(body.storey - 1) if j != lost and self.holds(i, j)]
            if tops:
                body.support = max(tops, key=lambda j: self.preference(i, j, motion))
                self.tell(now, "settle/jump", i, body.support)
                return
            body.storey -= 1
            self.walls = {wall for wall in self.walls if wall[0] != i}
            self.tell(now, "settle/fall", i)
        body.support = None
        self.tell(now, "settle/ground", i)

    def preference(self, i: int, j: int, motion: Fraction) -> tuple[Fraction, int]:
        """Return what is greatest for the top that a body is to stand on, of those that hold it."""
        body, top, way = self.bodies[i], self.bodies[j], 1 if motion > 0 else -1
        lefts = self.lefts_holding(body, top)
        if motion != 0:
            return max(left * way for left in lefts), -j
        return max(overlap((left, left + top.width), (body.left, body.right)) for left in lefts), -j

    def lefts_holding(self, body: Body, top: Body) -> list[Fraction]:
        """Return where the copies of a top begin that hold a body: on a cylinder there may be one on each side."""
        near = (body.left - self.margin, body.right + self.margin)
        copies = self.terrain.copies([(top.left, top.right)])
        return [copy[0] for copy in copies if overlap(copy, near) > 0]

    # What a trace says

    def place(self, body: Body) -> dict[str, Any]:
        """Return where a body is, as a trace says it."""
        if body.support is None:
            left, right = positions(self.terrain, body)
        else:
            top = self.bodies[body.support]
            from_corner = self.from_corner(body, top)
            left = {"top": top.name, "location": from_corner}
            right = {"top": top.name, "location": from_corner + body.width}
        return {"name": body.name, "left": left, "right": right}

    def from_corner(self, body: Body, top: Body) -> Fraction:
        """Return how far the left border of a body is to the right of the left corner of a top.

        On a cylinder it is counted the way round on which their middles are nearer, of equals to the right.
        """
        offset, around = body.left - top.left, self.terrain.circumference
        if around is None:
            return offset
        most = (top.width - body.width + around) / 2
        return most - (most - offset) % around

    def supports(self) -> dict[str, str]:
        """Return who stands on whose top."""
        return {body.name: self.bodies[body.support].name for body in self.bodies if body.support is not None}


def both_ways(wishes: list[Fraction], pushes: list[bool]) -> tuple[list[Fraction], list[Fraction]]:
    """Return the speeds to the right and to the left in a row, as they are passed on."""
    to_right = passed_on([max(wish, ZERO) for wish in wishes], pushes)
    to_left = passed_on([max(-wish, ZERO) for wish in reversed(wishes)], pushes[::-1])
    return to_right, to_left[::-1]


def passed_on(wishes: list[Fraction], pushes: list[bool]) -> list[Fraction]:
    """Return the speeds in a row, from the rear to the front, each its own or a greater one from behind."""
    speeds, passed = [], ZERO
    for wish, may in zip(wishes, pushes, strict=True):
        speeds.append(max(wish, passed))
        passed = speeds[-1] if may else ZERO
    return speeds


def cut(speeds: list[Fraction], at_wall: list[bool]) -> list[Fraction]:
    """Return speeds of a row, given from the rear to the front, cut to what walls and the bodies ahead let them."""
    result: list[Fraction] = []
    for speed, wall in zip(reversed(speeds), reversed(at_wall), strict=True):
        free = ZERO if wall else speed
        result.append(min(free, result[-1]) if result else free)
    return result[::-1]


def read_world(level: dict[str, Any]) -> World:
    """Return a level as it starts."""
    terrain = Terrain(level, Fraction(level["bodies"][0].get("height", 1)))
    index = {body["name"]: i for i, body in enumerate(level["bodies"])}
    bodies = [read_body(terrain, level["bodies"], index, i) for i in range(len(index))]
    return World(terrain, Fraction(level.get("margin", "1/100")), bodies)


def read_body(terrain: Terrain, given: list[dict[str, Any]], index: dict[str, int], i: int) -> Body:
    """Return a body where it starts."""
    body, around = given[i], terrain.circumference
    (left, storey), (right, _) = (border(terrain, given, index, body[side]) for side in ("left", "right"))
    width = right - left if around is None else (right - left) % around
    support = index.get(body["left"].get("top") or "")
    start = left if around is None else left % around
    return Body(
        body["name"], start, width, storey, support, Fraction(body.get("speed", 0)), bool(body.get("pushes", True))
    )


def border(
    terrain: Terrain, given: list[dict[str, Any]], index: dict[str, int], at: dict[str, Any]
) -> tuple[Fraction, int]:
    """Return where an edge position is, and on which storey what is there stands."""
    location = Fraction(at["location"])
    if at.get("top") is not None:
        start, storey = border(terrain, given, index, given[index[at["top"]]]["left"])
        return start + location, storey + 1
    edge = next(edge for edge in terrain.edges if edge.number == at["edge"])
    return edge.span[0] + location, edge.storey


def drives(level: dict[str, Any], step: dict[str, Any]) -> list[Drive]:
    """Return what a step of a scenario asks: ticks are as many steps as they are times."""
    index = {body["name"]: i for i, body in enumerate(level["bodies"])}
    if (request := step.get("request")) is not None:
        distance = Fraction(request["distance"])
        return [Drive({index[request["body"]]: Fraction((distance > 0) - (distance < 0))}, abs(distance))]
    if (drive := step.get("drive")) is not None:
        return [
            Drive({index[name]: Fraction(speed) for name, speed in drive["speeds"].items()}, Fraction(drive["time"]))
        ]
    sign = 1 if step["tick"]["key"] == "right" else -1
    speeds = {i: sign * Fraction(body.get("speed", 0)) for i, body in enumerate(level["bodies"])}
    one = Drive({i: speed for i, speed in speeds.items() if speed != 0}, Fraction(level.get("tick", "1/50")))
    return [one] * step["tick"].get("times", 1)


def simulate(scenario: dict[str, Any]) -> list[Outcome]:
    """Return what comes of a scenario that has its level in it: one outcome for each request, tick and drive."""
    level = scenario["level"]
    world, result = read_world(level), []
    for step in scenario["steps"]:
        for drive in drives(level, step):
            world.play(drive)
            moves = [
                {"body": world.bodies[i].name, "asked": speed * drive.time, "moved": world.bodies[i].moved}
                for i, speed in drive.speeds.items()
            ]
            places = [world.place(body) for body in world.bodies]
            result.append(Outcome(moves, places, world.supports(), world.events))
    return result
