"""What is shown of the designs of a graphbody: where they agree, where not, what they cost, what a margin is for."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from itertools import product
from random import Random
from typing import Any

from properties.contracts.counts import row_in_contact
from properties.contracts.errata import RIGHT, Stage
from properties.contracts.strings import border_and_neighbour, check_steps, world_with
from properties.evidence.deeds import MOST_RULES
from properties.given import HAS_WIDTH, Given
from properties.worlds.rows import any_level, located, string_graph
from reference.designs import Cost, Crowd, Leading, Neighbour, by_border, by_centre, by_order, crowd_of
from reference.simulator import move
from reference.world import World
from spec.body import Body, EdgePosition, Level
from spec.conditions import IN_ORDER
from spec.designs import DESIGNS, ONE, ONE_CACHED, THREE, TWO, Design, Part
from spec.graph import Direction, Vertex, polyline
from spec.profiles import Profile
from spec.transform import mirror

ROWS, RINGS, ROUNDING = 60, 0.4, 1e-9
LINES, FEW = range(60), range(12)

PRINTED: dict[str, tuple[Cost, Cost]] = {
    "design/1ep": (Cost(1), Cost(0, 1, 1)),
    "design/1ep-cached": (Cost(1, 2), Cost(0, 0, 1)),
    "design/2ep": (Cost(1, 1), Cost(0, 0, 1)),
    "design/3ep": (Cost(1, 1), Cost(0, 0, 1)),
}
"""Table 4.2: what a collided movement of a body costs, and an edge position look-up."""


def designs_agree(
    profile: Profile,
    given: Given,
    bodies: int,
    edges: int,
    closed: bool,
    design: Design,
    mover: int,
    direction: Direction,
) -> None:
    """A request ends with every border at the same place under a design as under the rules of the profile."""
    level = any_level(given, bodies, edges, closed)
    start, asked = World(level), given.number("distance asked")
    crowd, after = crowd_of(design, profile, start), start.copy()
    crowd_moved, record = crowd.move(mover, direction, asked, MOST_RULES)
    moved, fired = move(profile, after, mover, direction, asked, MOST_RULES)
    for _, rule in (*record.fired, *fired.fired):
        given.saw(rule)
    given.ensure("it moves as far", crowd_moved == moved)
    for body in start.handles():
        for side in Direction:
            there = after.coordinate(after.bodies[body].border(side))
            given.ensure(
                "every border is at the same place", same_place(after, body, crowd.along(body, Part(side)), there)
            )


def centres_are_lawful(profile: Profile, given: Given, direction: Direction, closed: bool, last: bool) -> None:
    """To a centre that leads, any string keeps the laws of `spec.world.View`, with the gap and the wall of its borders.

    Where the centres are stands in the world as the front border of one body and the rear border of the next.
    """
    level, free = border_and_neighbour(given, closed, last), given.number("free space of the ring")
    world = world_with(level if direction is Direction.RIGHT else mirror(level), free)
    plain = world.facing(direction)
    at, half, other = plain.front(0), given.number("half the width"), given.number("half the width of the one ahead")
    between, end = plain.gap(at, 1), world.to_wall(0, direction)
    given.assume(half > 0, HAS_WIDTH)
    given.assume(between >= half, IN_ORDER.id)
    places = [{Part.CENTRE: at}, {Part.CENTRE: plain.rear(1)}]
    view: Any = Crowd(ONE, profile, world, [half, other], places, by_order).facing(direction).leading(0)
    room = None if end is None else end - half
    given.ensure("the gap is that of the borders", view.gap(at, 1) == between - half - other)
    given.ensure("the wall is that of the border", equal_or_none(view.to_wall(at), room))
    check_steps(given, view, at)
    check_sight_of(given, view, at, room)


def equal_or_none(one: Any, other: Any) -> Any:
    """Whether two numbers are equal, or both are missing."""
    return one is other if one is None or other is None else one == other


def check_sight_of(given: Given, view: Leading[Any], at: EdgePosition[Any], room: Any) -> None:
    """Promise where the next edge begins, where the wall is, and who is seen, by a centre."""
    reach, gap, onward, ahead = view.reach(at), view.gap(at, 1), view.beyond(at).onward, view.ahead(0, at)
    given.ensure("the end of level ground is no ledge", not view.beyond(at).ledge)
    if onward is None:
        given.ensure("where no edge follows, the wall is as far as it reaches", equal_or_none(room, reach))
        given.ensure("on the last edge a body ahead is seen", [ahead] == [1])
        return
    in_sight = bool(gap <= reach + view.reach(onward))
    given.ensure("on this edge and the next a body is seen", [ahead] == [1 if in_sight else None])
    if gap >= reach:
        given.ensure("the end of an edge is the beginning of the next", view.gap(onward, 1) == gap - reach)
    given.ensure(
        "the wall is nearer by the edge", equal_or_none(view.to_wall(onward), None if room is None else room - reach)
    )
    given.ensure("where an edge follows, the wall is further than that", room is None or room > reach)


def random_level(draw: Random, kind: Any, margin: Any, closed: bool) -> Level[Any]:
    """One to four bodies on a line or a ring of edges that are longer than the margin, in tenths."""

    def tenths(least: int, most: int) -> Any:
        return kind(draw.randrange(least, most)) / 10

    along, held = tenths(0, 20), []
    start = along
    for _ in range(draw.randrange(1, 5)):
        width = tenths(1, 20)
        held.append((along, along + width))
        along = along + width + margin + draw.choice((kind(0), tenths(0, 20)))
    lengths = [tenths(3, 30)]
    while sum(lengths) < along - start * closed:
        lengths.append(tenths(3, 30))
    round_ = [(left % sum(lengths), right % sum(lengths)) for left, right in held] if closed else held
    bodies = tuple(
        Body(chr(65 + i), located(lengths, left, closed), located(lengths, right, closed), kind(0), kind(1))
        for i, (left, right) in enumerate(round_)
    )
    return Level(string_graph(lengths, sum(lengths) if closed else None), margin, kind(1), bodies)


def designs_agree_on_random_rows(profile: Profile) -> int:
    """Of random requests on lines and rings, in exact numbers, each ends with every border at the same place."""
    draw = Random(43)
    for _ in range(ROWS):
        start = World(random_level(draw, Fraction, Fraction(1, 8), closed=draw.random() < RINGS))
        crowds, plain = [crowd_of(design, profile, start) for design in DESIGNS], start.copy()
        for _ in range(3):
            body, direction = draw.randrange(len(start.bodies)), draw.choice(list(Direction))
            asked = Fraction(draw.randrange(1, 50), 10)
            move(profile, plain, body, direction, asked, MOST_RULES)
            for crowd in crowds:
                crowd.move(body, direction, asked, MOST_RULES)
                for other, side in product(start.handles(), Direction):
                    there = plain.coordinate(plain.bodies[other].border(side))
                    same = same_place(plain, other, crowd.along(other, Part(side)), there)
                    assert same, f"{crowd.design.id}: body {other} of {start.bodies}, {body} asked {asked}"
    return ROWS


def same_place(world: World[Any], body: int, one: Any, other: Any) -> Any:
    """Whether two distances along the string of a body are one place; on a ring, once round is none."""
    row = world.row(body)
    if not row.closed:
        return one == other
    return (one == other) | (one - other == row.length) | (other - one == row.length)


COUNTED: dict[str, tuple[Cost, Cost]] = {**PRINTED, "design/3ep": (Cost(1, 2), Cost(0, 0, 1))}
"""What is claimed of the costs: those of table 4.2, but for the third position of 3EP, which moves too (A46)."""


def cost_of_a_move(profile: Profile, design: Design, bodies: int, pushed: int) -> Cost:
    """What it costs to move a body that pushes others, on one edge."""
    crowd = crowd_of(design, profile, row_in_contact(bodies, pushed))
    crowd.move(0, RIGHT, crowd.world.margin, MOST_RULES)
    return crowd.cost.moves


def cost_of_a_look_up(profile: Profile, design: Design, side: Part) -> Cost:
    """What it costs to look a border up."""
    crowd = crowd_of(design, profile, row_in_contact(1, 0))
    crowd.border(0, side)
    return crowd.cost


def designs_cost(profile: Profile) -> int:
    """A move of each body that moves costs what is claimed, and so does each look-up, in rows of any length."""
    cases = 0
    for design, (bodies, pushed) in product(DESIGNS, ((1, 0), (2, 0), (2, 1), (9, 4), (30, 29))):
        one, look_up = COUNTED[design.id]
        times = Cost(one.collided * (pushed + 1), one.uncollided * (pushed + 1))
        found = cost_of_a_move(profile, design, bodies, pushed)
        assert found == times, f"{design.id}: {pushed} of {bodies} pushed: {found}"
        for side in (Part.LEFT, Part.RIGHT):
            found = cost_of_a_look_up(profile, design, side)
            assert found == look_up, f"{design.id}: a look-up: {found}"
        cases += 1
    return cases


def three_cost_as_two(profile: Profile, given: Given, stage: Stage) -> None:
    """A move costs as much under 3EP as under 2EP."""
    held, asked = stage.set(any_level(given, bodies=1, edges=1, closed=False)), given.number("distance asked")
    given.assume(asked > 0, "it is asked for more than 0")
    stage.steps.append(("A", asked))
    crowds = [crowd_of(design, profile, held) for design in (TWO, THREE)]
    for crowd in crowds:
        crowd.move(0, RIGHT, asked, MOST_RULES)
    given.ensure("a move costs the same", crowds[0].cost.moves == crowds[1].cost.moves)


def ledges_are_left_alike(profile: Profile, given: Given, stage: Stage) -> None:
    """A body has left a ledge under 1EP when it has under 2EP."""
    one, asked = Fraction(1), given.number("distance asked")
    graph = polyline([Vertex(one * x, one * y) for x, y in ((0, 1), (4, 1), (4, 0), (8, 0))])
    body = Body("A", EdgePosition(0, one), EdgePosition(0, one * 3), one, one)
    held = stage.set(Level(graph, one / 8, one, (body,)))
    stage.steps.append(("A", asked))
    left = []
    for design in (ONE, TWO):
        crowd = crowd_of(design, profile, held)
        crowd.move(0, RIGHT, asked, MOST_RULES)
        left.append(crowd.has_left(0, RIGHT))
    given.ensure("it has left its ledge under both or neither", left[0] == left[1])


WAYS: tuple[tuple[Design, Neighbour], ...] = (
    *((design, by_order) for design in DESIGNS),
    *((design, by_border) for design in (TWO, THREE)),
    *((design, by_centre) for design in (ONE, ONE_CACHED)),
)
"""Designs, each with a way to find who is ahead: by the order, or among the positions that collide."""


@dataclass(frozen=True)
class Ends:
    """Where bodies are after some requests on a line, and how far neighbours came to overlap at most."""

    lefts: list[Any]
    overlap: Any


def play_line(profile: Profile, design: Design, neighbour: Neighbour, kind: Any, margin: Any, seed: int) -> Ends:
    """A few random requests on a random line; the same ones for the same seed."""
    draw = Random(seed)
    world = World(random_level(draw, kind, margin, closed=False))
    crowd, overlap = crowd_of(design, profile, world, neighbour), kind(0)
    for _ in range(6):
        body, direction = draw.randrange(len(world.bodies)), draw.choice(list(Direction))
        crowd.move(body, direction, kind(draw.randrange(1, 40)) / 10, MOST_RULES)
        for left, right in world.neighbours():
            overlap = max(overlap, crowd.along(left, Part.RIGHT) - crowd.along(right, Part.LEFT))
    return Ends([crowd.along(body, Part.LEFT) for body in world.handles()], overlap)


def margins_are_for_floats(profile: Profile) -> int:
    """Without a margin nobody overlaps in exact numbers, and all end alike; in floats, one who is looked for by a
    border is walked into, and one who is looked for by order or by a centre is overlapped by no more than rounding;
    with a margin nobody is.
    """
    alike = [play_line(profile, TWO, by_order, Fraction, Fraction(0), seed) for seed in FEW]
    for design, neighbour in WAYS:
        named = f"{design.id}, {neighbour.__name__.replace('_', ' ')}"
        exact = [play_line(profile, design, neighbour, Fraction, Fraction(0), seed) for seed in FEW]
        assert exact == alike, f"{named}: without a margin exact numbers end otherwise"
        assert not any(ends.overlap for ends in exact), f"{named}: without a margin exact numbers overlap"
        kept = max(play_line(profile, design, neighbour, float, 0.125, seed).overlap for seed in FEW)
        assert kept == 0, f"{named}: with a margin floats overlap by {kept}"
        found = max(play_line(profile, design, neighbour, float, 0.0, seed).overlap for seed in LINES)
        assert found > 0, f"{named}: without a margin nothing overlaps"
        assert (found > ROUNDING) == (neighbour is by_border), f"{named}: without a margin floats overlap by {found}"
    return (len(LINES) + 2 * len(FEW)) * len(WAYS)


@dataclass(frozen=True)
class WalkedInto:
    """Two bodies, two requests of the first one; where it meets the other after one, and where it ends."""

    a: tuple[float, float]
    b: tuple[float, float]
    asked: tuple[float, float]
    right: float
    left: float
    end: float


def walked_into(profile: Profile) -> WalkedInto:
    """An example in tenths of a 2EP body that, without a margin, is walked into."""
    a, b, asked = (0.0, 0.3), (0.4, 1.4), (0.7, 0.1)
    held = tuple(
        Body(name, EdgePosition(0, left), EdgePosition(0, right), 0.0, 1.0)
        for name, (left, right) in (("A", a), ("B", b))
    )
    crowd = crowd_of(TWO, profile, World(Level(string_graph([8.0], None), 0.0, 1.0, held)), by_border)
    crowd.move(0, RIGHT, asked[0], MOST_RULES)
    right, left = crowd.along(0, Part.RIGHT), crowd.along(1, Part.LEFT)
    crowd.move(0, RIGHT, asked[1], MOST_RULES)
    return WalkedInto(a, b, asked, right, left, crowd.along(0, Part.RIGHT))
