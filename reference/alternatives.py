"""Games under other readings (`spec/alternatives.py`): of the world, of the level, of the tick.

Each is the game of the thesis with one method changed, of the view, of the world or of the game.
"""

from __future__ import annotations

from collections.abc import Callable, Generator
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from reference.simulator import Fulfilled, Game
from reference.world import Facing, LevelError, World
from spec.alternatives import ALTERNATIVES, Alternative
from spec.body import Body, EdgePosition, Level
from spec.graph import Direction, EdgeType, Graph, rational_root
from spec.number import N, greater, lesser, zero_like
from spec.otherwise import ByTheFront, Instead
from spec.plane import Box, box, boxes, carriers, terrain
from spec.rule import AnyRule, Chooser, Family
from spec.rules.leave import LEAVE, Departure, Placement
from spec.rules.request import Ask, Rules, request
from spec.rules.walk import WALK, walk_freely
from spec.transform import with_borders
from spec.world import Jump

Requests = Generator[Ask[Any, int], Any, Any]

# Views


class SameEdge(Facing[N]):
    """Only bodies on the same edge are seen."""

    def ahead(self, body: int, front: EdgePosition[N]) -> int | None:
        """The neighbour in this direction, if it is on this edge."""
        other = self.world.beside(body, self.direction)
        return None if other is None or self.gap(front, other) > self.reach(front) else other


class WholeString(Facing[N]):
    """All bodies of the string are seen."""

    def ahead(self, body: int, front: EdgePosition[N]) -> int | None:
        """The neighbour in this direction."""
        return self.world.beside(body, self.direction)


class WithMargins(Facing[N]):
    """A width counts the margin on either side."""

    def width(self, body: int) -> N:
        """The distance between the borders, and two margins."""
        return self.world.width(body) + self.world.margin * 2


class Euclidean(Facing[Any]):
    """A width is measured in the plane."""

    def width(self, body: int) -> Any:
        """The distance of the borders in the plane.

        Raises:
            ValueError: if it is irrational.
        """
        held = self.world.bodies[body]
        (x, y), (far_x, far_y) = self.world.point(held.left), self.world.unrolled(held)
        distance = rational_root(Fraction((far_x - x) * (far_x - x) + (far_y - y) * (far_y - y)))
        if distance is None:
            raise ValueError(f"expected a rational distance between the borders of {held.name}")
        return distance


class FarCorner(Facing[N]):
    """Jump edges are measured to the far corner."""

    def jump(self, edge: int, target: EdgePosition[N], free: bool) -> Jump[N, EdgePosition[N]]:
        """The jump edge, across to the end of the target's edge."""
        found = super().jump(edge, target, free)
        return replace(found, across=found.across + self.across(target, self.end(target)))


class Unsigned(Facing[N]):
    """Jump edges are as long to either side."""

    def jump(self, edge: int, target: EdgePosition[N], free: bool) -> Jump[N, EdgePosition[N]]:
        """The jump edge, across without its sign."""
        found = super().jump(edge, target, free)
        return replace(found, across=greater(found.across, zero_like(found.across) - found.across))


class Intervals(Facing[N]):
    """Jump edges are measured to the nearest point of the top."""

    def jump(self, edge: int, target: EdgePosition[N], free: bool) -> Jump[N, EdgePosition[N]]:
        """The jump edge; across is 0 where the target's edge is under or above its beginning."""
        found = super().jump(edge, target, free)
        far = found.across + self.across(target, self.end(target))
        covers = found.across < zero_like(far) and far > zero_like(far)
        return replace(found, across=zero_like(far)) if covers else found


class OwnCorners(Facing[N]):
    """Own corners count as jump edges."""

    def jumps(self, body: int, at: EdgePosition[N]) -> list[Jump[N, EdgePosition[N]]]:
        """The jump edges to all tops, whosever they are."""
        support = self.world.support(body)
        own = {body, support} | set(self.riders(body))
        tops = [self.tip(self.world.statics + one, self.direction.opposite) for one in own if one is not None]
        return super().jumps(body, at) + [self.jump(at.edge, top, free=True) for top in tops]


class FixedAtStart(Facing[N]):
    """Jump edges are those of the level's start."""

    def jump(self, edge: int, target: EdgePosition[N], free: bool) -> Jump[N, EdgePosition[N]]:
        """The jump edge between the same edges at the start."""
        found = Facing(World(self.world.level), self.direction).jump(edge, target, free)
        return replace(found, target=target)


class OnlyFromTheLedge(Facing[N]):
    """No jump edge leads from a top to a ledge."""

    def ledges(self) -> Any:
        """None."""
        return iter(())


# Worlds


class Clamped(World[N]):
    """A border in overhang is at the end of its edge."""

    def point(self, at: EdgePosition[N]) -> tuple[N, N]:
        """Where a position is in the plane, never beyond its edge."""
        length = self.length_of(at.edge)
        return super().point(replace(at, location=lesser(greater(at.location, zero_like(length)), length)))


class AlongNormal(World[N]):
    """Tops are along the normal of the ground."""

    def point(self, at: EdgePosition[N]) -> tuple[N, N]:
        """Where a position is in the plane; across a bend, as in the thesis."""
        if at.edge < self.statics:
            return super().point(at)
        held = self.bodies[at.edge - self.statics]
        edge = self.base(held.left.edge)
        if not self.straight(held) or edge is None:
            return super().point(at)
        x, y = self.point(replace(held.left, location=held.left.location + at.location))
        ground = self.graph.edges[edge]
        return x - ground.rise * held.height, y + ground.run * held.height

    def base(self, edge: int) -> int | None:
        """The static edge below an edge, or None if something on the way stands across a bend."""
        while edge >= self.statics:
            held = self.bodies[edge - self.statics]
            if not self.straight(held):
                return None
            edge = held.left.edge
        return edge


class BordersOnly(World[N]):
    """A body presses only buttons on the edges of its borders."""

    def pressed(self, button: EdgePosition[N]) -> bool:
        """Whether a character whose border is on the button's edge stands on it."""
        seen = self.copy()
        for body in self.handles():
            held = self.bodies[body]
            if button.edge not in (held.left.edge, held.right.edge):
                seen.bodies[body] = replace(held, speed=zero_like(held.speed))
        return World.pressed(seen, button)


class Sliding(World[N]):
    """Riders stay where they are while their support moves along its string."""

    def put(self, body: int, left: EdgePosition[N], right: EdgePosition[N]) -> None:
        """Put a body, and its riders where they were in the plane."""
        before = self.copy()
        super().put(body, left, right)
        if self.row(body).edges == before.row(body).edges:
            for rider in self.row_of_edge[self.statics + body].order:
                self.shift(rider, self.travel(before, body, Direction.LEFT))

    def shift(self, rider: int, by: N) -> None:
        """Move a body along the top it stands on; what rides on it goes with it."""
        held = with_borders(self.bodies[rider], lambda at: replace(at, location=at.location + by))
        World.put(self, rider, held.left, held.right)


class Colliding(Sliding[N]):
    """Riders are carried as far as there is room for them in the plane."""

    def put(self, body: int, left: EdgePosition[N], right: EdgePosition[N]) -> None:
        """Put a body, and hold back the riders that would come nearer to others than they may."""
        before = self.copy()
        World.put(self, body, left, right)
        if self.row(body).edges != before.row(body).edges:
            return
        waiting = [(body, self.travel(before, body, Direction.RIGHT))]
        while waiting:
            carrier, moved = waiting.pop()
            for rider in list(self.row_of_edge[self.statics + carrier].order):
                carried = room(before, self, rider, moved)
                self.shift(rider, carried - moved)
                waiting.append((rider, carried))


def room(before: World[Any], after: World[Any], rider: int, moved: Any) -> Any:
    """How far a rider can be carried by a signed distance, from where it was, among the others where they are."""
    start = box(before, rider)
    if start is None:
        return moved
    others = [(one, after.margin) for body, one in boxes(after).items() if body != rider]
    solids = [(solid, zero_like(moved)) for solid in terrain(after)]
    rooms = [room_beside(start, one, margin, moved) for one, margin in [*others, *solids]]
    return min([moved, *rooms]) if moved >= 0 else max([moved, *rooms])


def room_beside(one: Box[N], other: Box[N], margin: N, moved: N) -> N:
    """How much of a signed distance a box can move until another is a margin ahead of it."""
    zero = zero_like(moved)
    ahead = other.left - one.right if moved >= zero else one.left - other.right
    if ahead < zero or not one.beside(other):
        return moved
    free = greater(ahead - margin, zero)
    return lesser(free, moved) if moved >= zero else greater(zero - free, moved)


class Dropping(World[N]):
    """Riders drop where their support has left its string."""

    def put(self, body: int, left: EdgePosition[N], right: EdgePosition[N]) -> None:
        """Put a body; if it left its string, its riders come down there."""
        old, row = self.bodies[body], self.row(body)
        super().put(body, left, right)
        if self.row(body).edges == row.edges:
            return
        for rider in list(self.row_of_edge[self.statics + body].order):
            held = self.bodies[rider]
            World.put(self, rider, self.below(old, held.left), self.below(old, held.right))

    def below(self, old: Body[N], at: EdgePosition[N]) -> EdgePosition[N]:
        """The place on a string that is under a place on the top of a body that stood there."""
        zero = zero_like(at.location)
        view = self.facing(Direction.RIGHT if at.location >= zero else Direction.LEFT)
        motion = walk_freely(WALK, view, old.left, greater(at.location, zero - at.location))
        return view.along(motion.at, motion.rest)


# Levels


def as_given(level: Level[Any]) -> Level[Any]:
    """The level itself."""
    return level


def first_edges(level: Level[Any]) -> Level[Any]:
    """The level with a vertex of its own for each ground edge that is not the first to leave its vertex."""
    vertices, edges = list(level.graph.vertices), list(level.graph.edges)
    for (vertex, direction, edge_type), found in level.graph.table.items():
        for later in found[1:] if edge_type is EdgeType.GROUND else ():
            vertices.append(vertices[vertex])
            own = len(vertices) - 1
            one = edges[later]
            edges[later] = replace(one, left=own) if direction is Direction.RIGHT else replace(one, right=own)
    return replace(level, graph=Graph(tuple(vertices), tuple(edges), level.graph.circumference))


def by_world_axes(level: Level[Any]) -> Level[Any]:
    """The level with the ends of each edge, and the borders on it, from left to right in the world."""
    edges = level.graph.edges
    turned = [e if e.run >= 0 else replace(e, left=e.right, right=e.left, run=-e.run, rise=-e.rise) for e in edges]

    def seen(at: EdgePosition[Any]) -> EdgePosition[Any]:
        back = at.edge < len(edges) and edges[at.edge].run < 0
        return replace(at, location=edges[at.edge].length - at.location) if back else at

    def ordered(body: Body[Any]) -> Body[Any]:
        left, right = seen(body.left), seen(body.right)
        back = body.left.edge < len(edges) and edges[body.left.edge].run < 0
        return replace(body, left=right, right=left) if back else replace(body, left=left, right=right)

    graph = Graph(level.graph.vertices, tuple(turned), level.graph.circumference)
    return replace(level, graph=graph, bodies=tuple(ordered(body) for body in level.bodies))


def steep_from_45(level: Level[Any]) -> Level[Any]:
    """The level with every edge steeper than 45 degrees a fall edge.

    Raises:
        LevelError: if a body stands on one.
    """
    graph = level.graph
    edges = [replace(e, type=EdgeType.FALL) if abs(e.rise) > abs(e.run) else e for e in graph.edges]
    for i, body in enumerate(level.bodies):
        for at in (body.left, body.right):
            if at.edge < len(edges) and edges[at.edge].type is EdgeType.FALL:
                raise LevelError(f"$.bodies[{i}]", f"edge {at.edge} is steeper than 45 degrees: expected a ground edge")
    return replace(level, graph=Graph(graph.vertices, tuple(edges), graph.circumference))


# Games


@dataclass
class OtherGame(Game[Any]):
    """A level being played under another reading."""

    reading: Variant | None = None

    @property
    def variant(self) -> Variant:
        """The reading under which it is played."""
        assert self.reading is not None
        return self.reading

    def laid_out(self) -> World[Any]:
        """The world of the level, as the reading has it."""
        return self.variant.world(self.level)

    def asked(self, rules: Rules, view: Facing[Any], body: int, distance: Any, spare: int) -> Requests:
        """Carry out one request of a chain, as the reading has it."""
        seen = self.variant.view(view.world, view.direction)
        return self.variant.alternative.request(rules, seen, body, distance, spare)

    def tick(self, direction: Direction | None) -> list[Fulfilled[Any]]:
        """One tick with one key held, as the reading has it, or none."""
        return super().tick(None) if direction is None else self.held(direction)

    def held(self, direction: Direction) -> list[Fulfilled[Any]]:
        """One tick with one key held."""
        return super().tick(direction)

    def characters(self) -> list[Body[Any]]:
        """The characters in their order."""
        return [body for body in self.level.bodies if body.speed]


@dataclass(frozen=True)
class ByBothEnds(ByTheFront):
    """The family `leave` of a body that leaves its edge when each border is beyond an end."""

    def choose(self, leaving: Departure[Any, Any]) -> AnyRule:
        """Return the rule for its front border if the rear one is beyond the other end, else that of the thesis."""
        back = Facing(self.view.world, self.view.direction.opposite)
        if back.reach(leaving.rear) >= zero_like(leaving.moved):
            return self.rules.leave.choose(leaving)
        return super().choose(leaving)


class AnyEnds(OtherGame):
    """Borders may be beyond different ends."""

    def asked(self, rules: Rules, view: Facing[Any], body: int, distance: Any, spare: int) -> Requests:
        """Carry out a request with the other family `leave`."""
        leave = ByBothEnds(rules, view, body, only_jumps=False)
        return request(replace(rules, leave=leave), view, body, distance, spare)


class FallsOff(OtherGame):
    """A body falls off a top."""

    def asked(self, rules: Rules, view: Facing[Any], body: int, distance: Any, spare: int) -> Requests:
        """Carry out a request; where the thesis blocks it at a corner, the body comes down beside its support."""

        def fall_off(leaving: Departure[Any, Any]) -> Placement[Any, Any]:
            support = view.world.support(body)
            assert support is not None
            rear = walk_freely(leaving.walk, view, view.front(support), view.margin).at
            motion = walk_freely(leaving.walk, view, rear, leaving.width)
            return Placement(leaving.fit.choose(motion).effect((view, motion)), rear, leaving.moved)

        leave = Instead(rules.leave, ("leave/nowhere",), fall_off)
        return request(replace(rules, leave=leave), view, body, distance, spare)


class NothingMoves(OtherGame):
    """A request that reaches the push limit is refused."""

    def request(self, body: str, distance: Any) -> Fulfilled[Any]:
        """Request a body to move, and take all back if the limit was reached."""
        before = self.world.copy()
        done = super().request(body, distance)
        if all(rule != "push/limit" for _, rule in done.fired):
            return done
        self.world.become(before)
        return replace(done, moved=zero_like(distance))


@dataclass(frozen=True)
class RoundTo(Facing[Any]):
    """The mover is not seen: it goes round itself."""

    mover: int = 0

    def ahead(self, body: int, front: EdgePosition[Any]) -> int | None:
        """The neighbour in sight, unless that is the mover."""
        other = super().ahead(body, front)
        return None if other == self.mover else other


class Rotates(OtherGame):
    """A ring that is pushed goes round."""

    mover = 0

    def request(self, body: str, distance: Any) -> Fulfilled[Any]:
        """Request a body to move, and note that it is the first."""
        self.mover = self.handles[body]
        return super().request(body, distance)

    def asked(self, rules: Rules, view: Facing[Any], body: int, distance: Any, spare: int) -> Requests:
        """Carry out a request of a chain, to which the mover is not in the way."""
        return request(rules, RoundTo(view.world, view.direction, self.mover), body, distance, spare)


@dataclass(frozen=True)
class Counted:
    """The family `push` under a count of requests."""

    family: Chooser
    game: RequestsPerTick

    def choose(self, want: Any) -> AnyRule:
        """Return the rule for as many requests as are left, and count the one that it makes."""
        rule = self.family.choose(replace(want, spare=self.game.spare))
        self.game.spare -= rule.id == "push/request"
        return rule


class RequestsPerTick(OtherGame):
    """The push limit counts all requests of a tick, or of a request on its own."""

    spare = 0
    in_tick = False

    def held(self, direction: Direction) -> list[Fulfilled[Any]]:
        """One tick, with one count for all."""
        self.in_tick, self.spare = True, len(self.handles) - 1
        done = super().held(direction)
        self.in_tick = False
        return done

    def request(self, body: str, distance: Any) -> Fulfilled[Any]:
        """Request a body to move."""
        self.spare = self.spare if self.in_tick else len(self.handles) - 1
        return super().request(body, distance)

    def asked(self, rules: Rules, view: Facing[Any], body: int, distance: Any, spare: int) -> Requests:
        """Carry out a request of a chain under the count."""
        return request(replace(rules, push=Counted(rules.push, self)), view, body, distance, spare)


ONLY_STAYS = Family("leave", tuple(replace(rule, guard=()) for rule in LEAVE.rules if rule.id == "leave/stay"))


class StaysPushedOff(OtherGame):
    """A body that others push off its ledge does not fall for that."""

    mover = 0

    def request(self, body: str, distance: Any) -> Fulfilled[Any]:
        """Request a body to move, and note that it is the first."""
        self.mover = self.handles[body]
        return super().request(body, distance)

    def asked(self, rules: Rules, view: Facing[Any], body: int, distance: Any, spare: int) -> Requests:
        """Carry out a request of a chain; only the mover leaves its edge."""
        rules = rules if body == self.mover else replace(rules, leave=ONLY_STAYS)
        return request(rules, view, body, distance, spare)


class InOwnTurn(StaysPushedOff):
    """It falls in its own turn: a tick asks boxes too, for nothing."""

    def held(self, direction: Direction) -> list[Fulfilled[Any]]:
        """One tick, in which every body has a turn."""
        return [self.request(body.name, self.per_tick(body.speed) * direction) for body in self.level.bodies]


class Simultaneous(OtherGame):
    """All characters move from one state."""

    def held(self, direction: Direction) -> list[Fulfilled[Any]]:
        """One tick: each character moves in a world of its own, and all ends are put together."""
        start, done, ends = self.world.copy(), [], []
        for body in self.characters():
            done.append(self.request(body.name, self.per_tick(body.speed) * direction))
            ends.append((self.handles[body.name], self.world))
            self.world = start.copy()
        places = {other: end.bodies[other] for _, end in ends for other in self.changed(start, end)}
        places |= {mover: end.bodies[mover] for mover, end in ends}
        for body_, held in places.items():
            self.world.put(body_, held.left, held.right)
        return done

    def changed(self, start: World[Any], end: World[Any]) -> list[int]:
        """The bodies that are not where they were."""
        return [body for body in start.handles() if start.bodies[body] != end.bodies[body]]


class PushersSpeed(OtherGame):
    """What is pushed goes on as fast as what pushed it."""

    def __post_init__(self) -> None:
        """Begin with the characters' own velocities."""
        super().__post_init__()
        self.speeds = {body.name: body.speed for body in self.level.bodies}

    def held(self, direction: Direction) -> list[Fulfilled[Any]]:
        """One tick: whoever has a velocity has a turn, and gives it to whom it pushes."""
        done = []
        for body in self.level.bodies:
            if self.speeds[body.name]:
                done.append(self.request(body.name, self.per_tick(self.speeds[body.name]) * direction))
                pushed = {name for name, _ in done[-1].fired} - {one.name for one in self.characters()}
                self.speeds |= dict.fromkeys(pushed, self.speeds[body.name])
        return done


class OncePerTick(OtherGame):
    """Whoever has been moved has had its turn."""

    def held(self, direction: Direction) -> list[Fulfilled[Any]]:
        """One tick, without the turns of characters that others have moved in it."""
        start, done = self.world.copy(), []
        for body in self.characters():
            handle = self.handles[body.name]
            if self.world.bodies[handle] == start.bodies[handle]:
                done.append(self.request(body.name, self.per_tick(body.speed) * direction))
        return done


class MovedCounts(OtherGame):
    """What others moved a character counts as its own."""

    def held(self, direction: Direction) -> list[Fulfilled[Any]]:
        """One tick, in which a character is asked for what is left of its distance."""
        start, done = self.world.copy(), []
        for body in self.characters():
            handle, distance = self.handles[body.name], self.per_tick(body.speed)
            if self.world.row(handle).edges == start.row(handle).edges:
                distance = greater(distance - self.world.travel(start, handle, direction), zero_like(distance))
            done.append(self.request(body.name, distance * direction))
        return done


class InThePlane(OtherGame):
    """A character that rides keeps its speed in the plane."""

    def held(self, direction: Direction) -> list[Fulfilled[Any]]:
        """One tick, from the ground up: a rider is asked for what its supports have not moved it."""
        start, done = self.world.copy(), []
        for body in sorted(self.characters(), key=lambda body: len(carriers(start, self.handles[body.name]))):
            handle = self.handles[body.name]
            came = self.left_of(self.world, handle) - self.left_of(start, handle)
            done.append(self.request(body.name, self.per_tick(body.speed) * direction - came))
        return done

    def left_of(self, world: World[Any], body: int) -> Any:
        """How far to the right the left border of a body is."""
        return world.point(world.bodies[body].left)[0]


@dataclass(frozen=True)
class Variant:
    """What computes an alternative: its view, its world, its level and its game; those of the thesis if not named."""

    alternative: Alternative
    view: type[Facing[Any]] = Facing
    world: type[World[Any]] = World
    game: type[OtherGame] = OtherGame
    level: Callable[[Level[Any]], Level[Any]] = as_given

    def play(self, level: Level[Any]) -> OtherGame:
        """The game of a level."""
        return self.game(self.alternative.profile, self.level(level), reading=self)


OTHERWISE: dict[str, dict[str, Any]] = {
    "at-the-limit/nothing-moves": {"game": NothingMoves},
    "short-circle/rotates": {"game": Rotates},
    "push-limit/requests-per-tick": {"game": RequestsPerTick},
    "width/with-margins": {"view": WithMargins},
    "width/euclidean": {"view": Euclidean},
    "sight/same-edge": {"view": SameEdge},
    "sight/whole-string": {"view": WholeString},
    "occupied/borders": {"world": BordersOnly},
    "unique-edge/first": {"level": first_edges},
    "left-to-right/world-axes": {"level": by_world_axes},
    "steep-edges/45-degrees": {"level": steep_from_45},
    "both-in-overhang/any-ends": {"game": AnyEnds},
    "horizontal-distance/far-corner": {"view": FarCorner},
    "horizontal-distance/unsigned": {"view": Unsigned},
    "horizontal-distance/intervals": {"view": Intervals},
    "own-corners/included": {"view": OwnCorners},
    "live-jump-edges/fixed": {"view": FixedAtStart},
    "end-of-a-top/falls": {"game": FallsOff},
    "carried/slides": {"world": Sliding},
    "carried/with-collisions": {"world": Colliding},
    "support-falls/drops": {"world": Dropping},
    "top-corners/normal": {"world": AlongNormal},
    "top-to-ledge/only-from-the-ledge": {"view": OnlyFromTheLedge},
    "position-in-overhang/clamped": {"world": Clamped},
    "tick-order/simultaneous": {"game": Simultaneous},
    "kept-speed/pushers": {"game": PushersSpeed},
    "touching-characters/once": {"game": OncePerTick},
    "touching-characters/counts": {"game": MovedCounts},
    "when-pushed-off/own-turn": {"game": InOwnTurn},
    "when-pushed-off/never": {"game": StaysPushedOff},
    "rider-speed/in-the-plane": {"game": InThePlane},
}

VARIANTS: dict[str, Variant] = {
    one.id: Variant(one, **OTHERWISE.get(one.id.removeprefix("reading/"), {})) for one in ALTERNATIVES
}
