"""Velocities on levels: what a tick asks of the graph, what the printed rules break, and what random numbers show.

Where a promise multiplies numbers that are all unknown, it is tested on exact ones: slopes are rational directions.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from fractions import Fraction
from random import Random
from typing import Any

from properties.contracts.contract import SEGMENT, Stretch, stand_in_for
from properties.contracts.errata import Stage
from properties.contracts.request import stand_in
from properties.contracts.ticks import NAMES, Segment, rear_of, where_it_is
from properties.contracts.velocities import GRAVITY, ONE, TICK, ZERO, any_material, any_velocity
from properties.given import Given, Infeasible
from properties.worlds.rows import string_graph
from reference.simulator import Fulfilled, Game
from reference.world import Facing, World
from spec.body import Body, EdgePosition, Level
from spec.graph import Direction, Vertex, polyline
from spec.invariants import OF_ONE_REQUEST, Deed
from spec.number import greater
from spec.profiles import OF_REQUESTS, AnyProfile, Profile
from spec.rules.request import Rules
from spec.rules.velocity import Material, Motion, Slope, VelocityRules, magnitude, signed, simulate_tick
from spec.rules.walk import Motion as Walking

SEED, CASES, MOST_TICKS = 20, 1_000, 40
SINE, COSINE = Fraction(3, 5), Fraction(4, 5)
TICKS_THROUGH = 3


def on_a_slope(material: Material[Any], velocity: Any, tick: Fraction = TICK) -> Level[Any]:
    """A body on a slope of 3-4-5 that leads down to the right, onto level ground."""
    graph = polyline([Vertex(ZERO, 6 * ONE), Vertex(8 * ONE, ZERO), Vertex(20 * ONE, ZERO)])
    body = box("A", 0, ONE, Motion(velocity, material, GRAVITY, ZERO))
    return Level(graph, ONE / 4, tick, (body,))


def box(name: str, edge: int, left: Fraction, motion: Motion[Any] | None) -> Body[Any]:
    """A box of width 1 on an edge."""
    return Body(name, EdgePosition(edge, left), EdgePosition(edge, left + 1), ZERO, ONE, motion=motion)


def velocity_after_a_tick(profile: Profile, stage: Stage, level: Level[Any]) -> Any:
    """The velocity of the only body after a tick, which is noted on the stage."""
    stage.set(level)
    stage.steps.append(None)
    game = Game(profile, level)
    game.tick(Direction.RIGHT)
    motion = game.world.bodies[0].motion
    assert motion is not None
    return motion.velocity


def rest_on_slopes(profile: Profile, given: Given, stage: Stage) -> None:
    """A body at rest stays there exactly if the tangent of its slope is at most the coefficient (P2)."""
    coefficient = given.number("coefficient of friction")
    after = velocity_after_a_tick(profile, stage, on_a_slope(any_material(friction=coefficient), ZERO))
    given.ensure("it rests up to the coefficient", bool(after == 0) == bool(coefficient * COSINE >= SINE))


def friction_by_the_cosine(profile: Profile, given: Given, stage: Stage) -> None:
    """Friction takes of a sliding body the coefficient times gravity times the cosine of the slope (P1)."""
    coefficient = given.number("coefficient of friction")
    after = velocity_after_a_tick(profile, stage, on_a_slope(any_material(friction=coefficient), ONE))
    expected = greater(ONE + GRAVITY * TICK * SINE - coefficient * (GRAVITY * TICK * COSINE), ZERO)
    given.ensure("friction is that of the normal force", after == expected)


def drag_by_the_way(profile: Profile, given: Given, stage: Stage) -> None:
    """Whatever drag takes of a velocity, it takes on the same way, whatever the tick (P10)."""
    drag = given.number("drag")
    given.assume(drag <= 1, "drag is a factor up to 1")
    ways = []
    for tick in (2 * TICK, TICK):
        level = on_a_slope(any_material(drag=drag), ONE, tick)
        level = replace(level, bodies=(box("A", 1, 2 * ONE, level.bodies[0].motion),))
        after = velocity_after_a_tick(profile, stage, level)
        ways.append(after * tick)
        stage.steps = stage.steps[:1]
    given.ensure("the way is the same if anything is taken", (drag == 1) | (ways[0] == ways[1]))


def minimum_lets_begin(profile: Profile, given: Given, stage: Stage) -> None:
    """On a slope without friction a body at rest begins to move, whatever its least speed (A35)."""
    slowest = given.number("least speed")
    after = velocity_after_a_tick(profile, stage, on_a_slope(any_material(friction=ZERO, slowest=slowest), ZERO))
    given.ensure("it moves", after > 0)


def no_higher_through_a_valley(profile: Profile, given: Given, stage: Stage) -> None:
    """A body that is let go on one side of a valley, without friction, comes no higher on the other."""
    graph = polyline([Vertex(ZERO, 6 * ONE), Vertex(8 * ONE, ZERO), Vertex(16 * ONE, 6 * ONE)])
    start = given.number("how far from the top it is let go")
    given.assume(start <= 9, "it begins on the slope")
    motion = Motion(ZERO, any_material(friction=ZERO), GRAVITY, ZERO)
    body = Body("A", EdgePosition(0, start), EdgePosition(0, start + 1), ZERO, ONE, motion=motion)
    level = Level(graph, ONE / 4, ONE / 2, (body,))
    game, length = Game(profile, level), stage.set(level).rows[0].length
    for _ in range(TICKS_THROUGH):
        game.tick(Direction.RIGHT)
        stage.steps.append(None)
    to_the_top = length - game.world.coordinate(game.world.bodies[0].right)
    given.ensure("it comes no higher", to_the_top >= start)


@dataclass(frozen=True)
class Asked:
    """A request as its first segment meets it."""

    body: str
    direction: Direction
    distance: Any


def any_movers(given: Given) -> Level[Any]:
    """Two characters on one edge, static or dynamic, of any velocity, or with none; the tick is the unit of time."""
    bodies = []
    for place, name in enumerate(NAMES[:2]):
        motion = None
        if given.flag(f"{name} moves of its own"):
            material = any_material(friction=ZERO) if given.flag(f"{name} is dynamic") else None
            force = ZERO if material is None else any_velocity(given, f"force on {name}")
            motion = Motion(any_velocity(given, f"velocity of {name}"), material, ZERO, force)
        bodies.append(replace(box(name, 0, Fraction(2 * place), motion), speed=ONE))
    return Level(string_graph([Fraction(9)], None), ONE / 4, ONE, tuple(bodies))


def velocities_ask_for_their_way(profile: Profile, given: Given) -> None:
    """A tick asks each body that moves of its own once, in its turn, for its new velocity times the tick, and no more.

    Of velocities a request sees the distance alone; so what holds of any request holds whatever the velocities are.
    The loop over the bodies is judged for two. No key is held, so nobody else is asked.
    """
    level, seen, ways = any_movers(given), list[Asked](), list[Any]()

    def segments(own: Rules, view: Facing[Any], body: int, motion: Walking[Any, Any], spare: Any) -> Segment:
        name = level.bodies[body].name
        if name in [one.body for one in seen]:
            given.ensure("nobody is asked twice", False)
            raise Infeasible
        seen.append(Asked(name, view.direction, motion.rest))
        given.ensure("for a distance", motion.rest >= 0)
        yield from ()
        went = given.number(f"moved by request {len(seen)}")
        ways.append(went * view.direction)
        stand_in_for(given, SEGMENT, Stretch(asked=motion.rest, moved=went))
        return Walking(motion.at, motion.rest - went, going=False)

    rules = replace(
        profile.rules, segment=segments, follow=stand_in("follow", rear_of), leave=stand_in("leave", where_it_is)
    )
    done = Game(replace(profile, rules=rules), level).tick(None)
    meant = {body.name: body.motion.velocity + body.motion.force for body in level.bodies if body.motion is not None}
    order = [name for name in profile.tick_order(NAMES[:2]) if name in meant]
    given.ensure("each is asked in its turn", order == [one.body for one in seen])
    names, moved = [one.body for one in done], [one.moved for one in done]
    given.ensure("the tick says what its requests did", [order, ways] == [names, moved])
    for one in seen:
        given.ensure("for its velocity times the tick", one.distance * one.direction == meant[one.body])


def directions(random: Random) -> Iterator[Slope[Fraction]]:
    """Random slopes of rational direction, to either side, less steep than 90 degrees."""
    while True:
        half = Fraction(random.randint(-11, 11), 12)
        square = half * half
        yield Slope((1 - square) / (1 + square), 2 * half / (1 + square))


def any_number(random: Random, most: int) -> Fraction:
    """A random number from 0 to a bound."""
    return Fraction(random.randint(0, 12 * most), random.randint(12, 24))


def any_dynamic(random: Random) -> Motion[Fraction]:
    """A random motion of a dynamic body."""
    material = Material(
        friction=any_number(random, 2),
        drag=Fraction(random.randint(1, 8), 8),
        damping=any_number(random, 3),
        slowest=any_number(random, 1) / 4,
        fastest=random.choice([None, any_number(random, 6) + 1]),
        mass=any_number(random, 4) + 1,
    )
    velocity, force = (any_number(random, 8) * random.choice([-1, 1]) for _ in range(2))
    return Motion(velocity, material, GRAVITY, random.choice([ZERO, force]))


def energy_is_not_gained(profile: AnyProfile) -> int:
    """In a tick on a slope, the energy of motion grows by no more than gravity and forces give on the way."""
    random = Random(SEED)
    slopes, rules, lost = directions(random), profile.velocity, 0
    for _ in range(CASES):
        before, slope, dt = any_dynamic(random), next(slopes), Fraction(1, random.randint(4, 60))
        after = simulate_tick(rules, before, slope, dt).velocity
        assert before.material is not None
        given = (slope.steepness * before.gravity + before.force / before.material.mass) * after * dt
        gained = (after * after - before.velocity * before.velocity) / 2 - given
        assert gained <= 0, f"{before} on {slope} gains {gained} in {dt}"
        lost += gained < 0
    assert lost > CASES // 2, f"only {lost} of {CASES} ticks lost any energy"
    return CASES


def sums_are_followed(profile: AnyProfile) -> int:
    """Without friction and drag, s = v0 T - a T^2 / 2 - a dt T / 2 after any number of ticks, also when it turns."""
    random = Random(SEED)
    slopes, turned = directions(random), 0
    for _ in range(CASES // 20):
        slope, dt, start = next(slopes), Fraction(1, random.randint(4, 60)), any_number(random, 8)
        motion, way, ticks = Motion(start, any_material(friction=ZERO), GRAVITY, ZERO), ZERO, random.randint(10, 60)
        for _ in range(ticks):
            motion = simulate_tick(profile.velocity, motion, slope, dt)
            way += motion.velocity * dt
        time, slowing = ticks * dt, GRAVITY * slope.rise
        expected = start * time - slowing * time * time / 2 - slowing * dt * time / 2
        assert way == expected, f"{start} on {slope}, {ticks} ticks of {dt}: {way} instead of {expected}"
        turned += motion.velocity < 0
    assert turned > CASES // 200, f"only {turned} turned"
    return CASES // 20


def stopping_ways(profile: AnyProfile) -> int:
    """On level ground, a body with v0 stops on v0^2 / (2 a) - v0 dt / 2, and at most a dt^2 / 8 more, with a = mu g."""
    random = Random(SEED)
    for _ in range(CASES // 10):
        friction, dt = any_number(random, 1) + Fraction(1, 8), Fraction(1, random.randint(4, 60))
        slowing, start, way = friction * GRAVITY, any_number(random, 8), ZERO
        motion = Motion(start, any_material(friction=friction), GRAVITY, ZERO)
        while motion.velocity:
            motion = simulate_tick(profile.velocity, motion, Slope(ONE, ZERO), dt)
            way += motion.velocity * dt
        part = start / (slowing * dt) % 1
        expected = start * start / (2 * slowing) - start * dt / 2 + slowing * dt * dt * part * (1 - part) / 2
        assert way == expected, f"{start}, friction {friction}, tick {dt}: {way} instead of {expected}"
    return CASES // 10


def drag_is_by_the_way(profile: AnyProfile) -> int:
    """What drag alone takes of a velocity is the damping times the way, after any number of ticks of any length."""
    random = Random(SEED)
    for _ in range(CASES // 10):
        damping, start, way = any_number(random, 4), any_number(random, 8), ZERO
        motion = Motion(start, any_material(friction=ZERO, damping=damping), GRAVITY, ZERO)
        for _ in range(random.randint(1, MOST_TICKS)):
            dt = Fraction(1, random.randint(4, 60))
            motion = simulate_tick(profile.velocity, motion, Slope(ONE, ZERO), dt)
            way += motion.velocity * dt
        assert start - motion.velocity == damping * way, f"{start}, damping {damping}: {motion.velocity} after {way}"
    return CASES // 10


def part_is_left(profile: AnyProfile) -> int:
    """What a tick does after gravity and forces takes of the velocity, whatever the drag; rest stays as it should."""
    random = Random(SEED)
    slopes = directions(random)
    for _ in range(CASES):
        before, slope, dt = any_dynamic(random), next(slopes), Fraction(1, random.randint(4, 60))
        assert before.material is not None
        gain = (slope.steepness * before.gravity + before.force / before.material.mass) * dt
        after = simulate_tick(profile.velocity, before, slope, dt).velocity
        pulled = before.velocity + gain
        assert magnitude(after) <= magnitude(pulled), f"{before} on {slope} in {dt}: {after}"
        assert after == signed(magnitude(after), pulled), f"{before} on {slope} in {dt} turns: {after}"
        resting = Motion(ZERO, any_material(friction=before.material.friction), GRAVITY, ZERO)
        stays = simulate_tick(profile.velocity, resting, slope, dt).velocity == 0
        assert stays == held_on(profile.velocity, slope, before.material.friction), f"{before.material} on {slope}"
    return CASES


def held_on(rules: VelocityRules, slope: Slope[Fraction], coefficient: Fraction) -> bool:
    """Whether a slope is one on which a body rests: mended, tan <= mu; as printed, sin <= mu / (1 + mu)."""
    if rules is OF_REQUESTS["thesis"].velocity:
        return magnitude(slope.rise) <= coefficient / (1 + coefficient)
    return magnitude(slope.rise) / slope.run <= coefficient


@dataclass
class Watched(Game[Fraction]):
    """A game of which every request is judged by the invariants."""

    judged: int = 0
    broken: list[str] = field(default_factory=list)

    def request(self, body: str, distance: Fraction) -> Fulfilled[Fraction]:
        """Request a body to move, and judge what came of it."""
        before = self.world.copy()
        done = super().request(body, distance)
        self.judged += 1
        limit, way = self.profile.push_limit(len(before.bodies)), Direction.LEFT if distance < 0 else Direction.RIGHT
        fired, went = len(done.fired), done.moved * way
        deed = Deed(before, self.world, self.handles[body], way, abs(distance), went, done.depth, limit, fired, ZERO)
        self.broken += [f"{one.id}: {body} by {distance}" for one in OF_ONE_REQUEST if not one.holds(deed)]
        return done


def any_slide(random: Random) -> Level[Fraction]:
    """A random row of bodies with any velocities and materials, on a hill of two slopes between level grounds."""
    heights = [(0, 0), (12, 0), (24, random.choice([-5, 5, 9])), (36, 0), (48, 0)]
    graph = polyline([Vertex(Fraction(x), Fraction(y)) for x, y in heights])
    world = World(Level(graph, ONE / 4, TICK, (box("A", 0, ZERO, None),)))
    row, along, bodies = world.rows[0], ZERO, []
    for name in NAMES:
        along += any_number(random, 12) + ONE / 4
        left, right = (place(row.offsets, at) for at in (along, along + 1))
        along += 1
        motion = random.choice([any_dynamic(random), replace(any_dynamic(random), material=None)])
        bodies.append(Body(name, left, right, ZERO, ONE, motion=motion))
    return Level(graph, ONE / 4, Fraction(1, random.randint(2, 20)), tuple(bodies))


def place(offsets: dict[int, Fraction], along: Fraction) -> EdgePosition[Fraction]:
    """The edge position so far along a string."""
    edge = max(edge for edge, offset in offsets.items() if offset <= along)
    return EdgePosition(edge, along - offsets[edge])


def invariants_hold_at_any_velocity(profile: Profile) -> int:
    """The requests of random ticks, of bodies with any velocities on slopes, keep every invariant of one request."""
    random, judged = Random(SEED), 0
    for _ in range(CASES // 20):
        game = Watched(profile, any_slide(random))
        for _ in range(3):
            game.tick(None)
        assert not game.broken, f"{game.broken[0]} on {game.level}"
        judged += game.judged
    return judged
