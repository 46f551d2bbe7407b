"""The mutants that are proved to say the same as what they were made of, on whatever it can be asked about.

Each is run beside its original on the same symbolic values, under premises that hold of every level.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from functools import partial
from types import SimpleNamespace
from typing import Any

from properties.contracts.steps import any_member
from properties.engine.explore import explore
from properties.evidence.mutants.mutant import Mutant
from properties.evidence.mutants.trial import SAME
from properties.given import HAS_LENGTH, HAS_WIDTH, Given
from reference.storeys import without
from reference.world import World
from spec.body import EdgePosition
from spec.graph import Direction, EdgeType
from spec.plane import Box, box, negated, terrain
from spec.profiles import REPAIRED
from spec.rules.event import Nearing, time_left
from spec.rules.row import forwards
from spec.rules.settle import Footing, Top, front_most, on_its_storey
from spec.rules.velocity import Bounded, Grip, at_the_bound, outruns_friction, slowed, too_fast
from spec.stepped import beside_wall, one_speed
from spec.storeys import Contact, Drive, Interval

FALLS_LEAD_DOWN = "a fall edge is not level"
KEYED = ("key", "velocity")
NOBODY_RISES = "a support was a storey below, and nobody has come up"


def promise_alike(given: Given, mutant: Mutant, ask: Callable[[], list[Any]]) -> None:
    """Promise that what is asked for is the same with a mutant in place."""
    own = ask()
    with mutant.in_place():
        other = ask()
    given.ensure("as many", len(own) == len(other))
    for one, twin in zip(own, other, strict=True):
        given.ensure("the same", one == twin)


def facts(one: Box[Any]) -> list[Any]:
    """What there is of a box."""
    return [one.left, one.right, one.bottom, one.top]


def any_box(given: Given, name: str) -> Box[Any]:
    """Any box of a body."""
    left, bottom = given.number(f"{name}: left"), given.number(f"{name}: bottom")
    return Box(left, left + given.number(f"{name}: width"), bottom, bottom + given.number(f"{name}: height"))


def boxes_of_bodies(mutant: Mutant, given: Given) -> None:
    """Any body on a line or on a ring; its right border is to the right, but where it is counted once round."""
    left, width, height = given.number("left"), given.number("width"), given.number("height")
    given.assume(width > 0, HAS_WIDTH)
    round_ = given.number("circumference") if given.flag("a ring") else None
    right = left + width
    if round_ is not None and given.flag("counted once round"):
        given.assume(width < round_, "a body is shorter than the ring")
        right = right - round_
    held = SimpleNamespace(left=left, right=right, height=height)
    graph = SimpleNamespace(circumference=round_)
    world = SimpleNamespace(bodies=[held], graph=graph, point=lambda place: (place, height))
    promise_alike(given, mutant, lambda: [fact for one in [box(world, 0)] if one is not None for fact in facts(one)])


def heights_of_bodies(mutant: Mutant, given: Given) -> None:
    """Any box of a body, and any box of terrain, which may go down for ever."""
    one, other = any_box(given, "a body"), any_box(given, "the other")
    if given.flag("it goes down for ever"):
        other = Box(other.left, other.right, None, other.top)
    promise_alike(given, mutant, lambda: [one.beside(other)])


def plain_truths(mutant: Mutant, given: Given) -> None:
    """Either truth."""
    truth = given.flag("a truth")
    promise_alike(given, mutant, lambda: [negated(truth)])


def level_edges(mutant: Mutant, given: Given) -> None:
    """Any edge; a fall edge leads down."""
    kind = EdgeType.GROUND if given.flag("ground") else EdgeType.FALL
    rise = given.number("up") - given.number("down")
    if kind is EdgeType.FALL:
        given.assume(rise < 0, FALLS_LEAD_DOWN)
    edge = SimpleNamespace(type=kind, rise=rise, left=0, length=given.number("length"), thickness=None)
    start = SimpleNamespace(x=given.number("x"), y=given.number("y"))
    world = SimpleNamespace(graph=SimpleNamespace(edges=[edge], vertices=[start]))
    promise_alike(given, mutant, lambda: [fact for one in terrain(world) for fact in facts(one)])


def speeds_in_a_row(mutant: Mutant, given: Given) -> None:
    """Any two members of a row."""
    row = [any_member(given, body) for body in (0, 1)]
    promise_alike(given, mutant, lambda: forwards(REPAIRED.rules.row, row, Direction.RIGHT))


def what_comes_nearer(mutant: Mutant, given: Given) -> None:
    """Anything that comes nearer, at some speed; in exact numbers it has not come too near yet."""
    nearing = Nearing(Contact(0, 1), given.number("room"), Fraction(2))
    promise_alike(given, mutant, lambda: [time_left(nearing)])


def riders_and_their_supports(mutant: Mutant, given: Given) -> None:
    """Any body on the ground, or on another: that may have come down, but nobody comes up."""
    support, storeys = 1 if given.flag("on another") else None, [given.number("storey"), given.number("storey below")]
    given.assume(storeys[1] <= storeys[0] - 1, NOBODY_RISES)
    world: Any = SimpleNamespace(support=lambda body: support, storey=lambda body: storeys[body])
    promise_alike(given, mutant, lambda: [bool(on_its_storey(world, 0))])


def pieces_and_walls(mutant: Mutant, given: Given) -> None:
    """Any piece of terrain, and any wall on it or beside it."""
    piece, wall = any_interval(given, "the piece"), any_interval(given, "the wall")
    promise_alike(given, mutant, lambda: [end for one in beside_wall(piece, wall) for end in (one.left, one.right)])


def pieces_and_cuts(mutant: Mutant, given: Given) -> None:
    """Any piece of terrain, and any other that is cut out of it."""
    piece, cut = any_interval(given, "the piece"), any_interval(given, "the cut")
    ask = partial(without, piece, cut.left, cut.right)
    promise_alike(given, mutant, lambda: [end for one in ask() for end in (one.left, one.right)])


def any_interval(given: Given, name: str) -> Interval[Any]:
    """Any interval that has a length."""
    left, length = given.number(f"{name}: left"), given.number(f"{name}: length")
    given.assume(length > 0, HAS_LENGTH)
    return Interval(left, left + length)


def keys_of_any_speed(mutant: Mutant, given: Given) -> None:
    """A character under any key, at any velocity, at any walls."""
    key, velocity = (given.number(f"{name} to the right") - given.number(f"{name} to the left") for name in KEYED)
    at_walls = {way: given.flag(f"a wall on the {way.name.lower()}") for way in Direction}
    one: Any = SimpleNamespace(
        drives={0: Drive(key, relative=False)},
        velocities={0: velocity},
        tolerance=0,
        contacts={},
        at_wall=lambda body, way: at_walls[way],
        wish=lambda body: key,
    )
    promise_alike(given, mutant, lambda: [bool(one_speed(one))])


def velocities_that_are_lessened(mutant: Mutant, given: Given) -> None:
    """Any velocity of which friction leaves something, and that is above the maximum: of no other the rules ask."""
    velocity = given.number("velocity to the right") - given.number("velocity to the left")
    grip, bounded = Grip(velocity, given.number("loss")), Bounded(velocity, velocity, given.number("maximum"))
    given.assume(bool(outruns_friction(grip)) and bool(too_fast(bounded)), "the rules apply")
    promise_alike(given, mutant, lambda: [slowed(grip), at_the_bound(bounded)])


def tops_over_which_nobody_moves(mutant: Mutant, given: Given) -> None:
    """Any two tops, or one that holds at both ends, which is there twice; nobody moves on them."""
    second = 1 if given.flag("one that holds at both ends") else 2
    tops = [Top(body, given.number(f"overlap {place}")) for place, body in enumerate((1, second))]
    footing: Footing[Any] = Footing(0, holds=False, ground=False, tops=tops, motion=tops[0].overlap * 0)
    promise_alike(given, mutant, lambda: [front_most(footing).support])


def places_on_a_ring(mutant: Mutant, given: Given) -> None:
    """Any two places on a ring, which bodies leave free but for some part of it."""
    near, far, length = given.number("near"), given.number("far"), given.number("length of the ring")
    free = given.number("free space of the ring")
    given.assume(free < length, "somebody is on the ring")
    row: Any = SimpleNamespace(closed=True, length=length, free=free)
    held: Any = SimpleNamespace(row_of_edge=[row], coordinate=lambda at: at.location)
    held.nearly_round = partial(World.nearly_round, held)
    places = EdgePosition(0, near), EdgePosition(0, far)
    promise_alike(given, mutant, lambda: [World.apart(held, *places)])


EQUAL: dict[str, Callable[[Mutant, Given], None]] = {
    "plane.Box.beside: False instead of True (2)": heights_of_bodies,
    "plane.negated: truth <= False instead of truth == False": plain_truths,
    "plane.box: right < left instead of circumference is not None and right < left": boxes_of_bodies,
    "plane.box: right <= left instead of right < left": boxes_of_bodies,
    "plane.terrain: edge.rise == 0 instead of edge.type is EdgeType.GROUND and edge.rise == 0": level_edges,
    "row.forwards: member.wish * direction instead of greater(member.wish * direction, zero_like(passed))": (
        speeds_in_a_row
    ),
    "settle.front_most: top.body <= best.body instead of top.body < best.body": tops_over_which_nobody_moves,
    "settle.on_its_storey: world.storey(support) >= world.storey(body) - 1 instead of world.storey(support) == "
    "world.storey(body) - 1": riders_and_their_supports,
    "stepped.beside_wall: wall.right < piece.left instead of wall.right <= piece.left": pieces_and_walls,
    "stepped.beside_wall: wall.left > piece.right instead of wall.left >= piece.right": pieces_and_walls,
    "stepped.one_speed: key > zero_like(key) instead of key >= zero_like(key)": keys_of_any_speed,
    "storeys.without: right < piece.left instead of right <= piece.left": pieces_and_cuts,
    "storeys.without: left > piece.right instead of left >= piece.right": pieces_and_cuts,
    "velocity.signed: like <= zero_like(like) instead of like < zero_like(like)": velocities_that_are_lessened,
    "world.World.apart: distance <= zero_like(distance) instead of distance < zero_like(distance)": places_on_a_ring,
    "event.time_left: nearing.room instead of greater(nearing.room, zero_like(nearing.room))": what_comes_nearer,
}


def proved_equal(name: str, mutant: Mutant) -> str | None:
    """That a mutant is proved to say the same, if it is."""
    program = EQUAL[name]
    said = f"{SAME} {program.__name__.replace('_', ' ')} are asked about"
    return said if explore(partial(program, mutant)).proved else None
