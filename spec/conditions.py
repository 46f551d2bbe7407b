"""Conditions: the premises of claims, each a predicate of a world at its start and of the distance asked."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import combinations
from typing import Any

from spec.demand import Demand, Element, Place, all_met
from spec.graph import Direction, EdgeType
from spec.guidelines import GUIDELINES as ALL_GUIDELINES
from spec.invariants import every
from spec.number import N, Truth, zero_like
from spec.plane import boxes, images, terrain
from spec.stepped import all_held, margins_kept as storeys_apart, outside_terrain as outside_solids
from spec.world import State


@dataclass(frozen=True)
class Condition:
    """A premise: its sentence, its source, and the predicate that decides it."""

    id: str
    sentence: str
    source: str
    holds: Callable[[State[Any], Any], Truth]

    kind = "condition"


def in_order(start: State[N], asked: N) -> Truth:
    """No right border is beyond the left border of its right neighbour."""
    return every(start.clear(*pair) >= zero_like(start.margin) for pair in start.neighbours())


def margins_kept(start: State[N], asked: N) -> Truth:
    """Neighbours are at least the margin apart."""
    return every(start.clear(*pair) >= start.margin for pair in start.neighbours())


def edges_long(start: State[N], asked: N) -> Truth:
    """No edge is shorter than the margin."""
    return all_met(lengths_demanded(start))


def lengths_demanded(start: State[N]) -> Iterator[Demand]:
    """Every ground edge is at least as long as the margin."""
    for index, length in enumerate(start.edge_lengths()):
        numbers = (length, start.margin)
        seen, mend = "is {0} long, shorter than the margin, {1}", "make it at least {1} long"
        yield Demand(Place(Element.GROUND, index), length >= start.margin, seen, mend, numbers)


def fits_into_the_ring(start: State[N], asked: N) -> Truth:
    """On a ring, the distance is at most the room that two bodies or more leave between them beyond the margins."""
    return not start.closed or len(start.bodies_in_order()) < 2 or asked <= room_between(start)


def room_between(start: State[N]) -> N:
    """All room between neighbours, beyond the margins."""
    room = zero_like(start.margin)
    for pair in start.neighbours():
        room = room + start.clear(*pair) - start.margin
    return room


def at_most_half_round(start: State[N], asked: N) -> Truth:
    """A body alone on a ring is asked for at most half of it."""
    if not start.closed or len(start.bodies_in_order()) > 1:
        return True
    round_ = zero_like(asked)
    for length in start.edge_lengths():
        round_ = round_ + length
    return asked * 2 <= round_


def halves_long(start: State[N], asked: N) -> Truth:
    """Every edge is at least two margins long, so that its halves are no shorter than one."""
    return every(length >= start.margin * 2 for length in start.edge_lengths())


def one_string(start: Any, asked: Any) -> Truth:
    """There is one string, and no ledge on it."""
    return all(edge.type is EdgeType.GROUND for edge in start.graph.edges) and len(start.rows) == 1 + len(start.bodies)


def plane_start(start: Any, asked: Any) -> Truth:
    """Margins and terrain are kept."""
    return every([margins_kept(start, asked), all_met(clearances_demanded(start))])


def clearances_demanded(start: Any) -> Iterator[Demand]:
    """In the plane, bodies beside each other are the margin apart, and no body is in terrain."""
    zero, held = zero_like(start.margin), boxes(start)
    for (one, mine), (other, theirs) in combinations(held.items(), 2):
        met = every(mine.clear_of(image, start.margin) for image in images(start, theirs))
        seen, mend = "is nearer to {others} than the margin, {0}", "put them at least {0} apart"
        yield Demand(Place(Element.BODY, other), met, seen, mend, (start.margin,), (Place(Element.BODY, one),))
    solids = list(zip(level_grounds(start), terrain(start), strict=True))
    for body, mine in held.items():
        for place, solid in solids:
            met = every(mine.clear_of(image, zero) for image in images(start, solid))
            seen, mend = "is in the terrain under {others}", "put it beside that, or above"
            yield Demand(Place(Element.BODY, body), met, seen, mend, (), (place,))


def level_grounds(start: Any) -> Iterator[Place]:
    """The level ground edges, under which terrain is solid."""
    for index, edge in enumerate(start.graph.edges):
        if edge.type is EdgeType.GROUND and edge.rise == 0:
            yield Place(Element.EDGE, index)


def nobody_rides(start: Any, asked: Any) -> Truth:
    """Nobody has a support but the ground."""
    return all(start.support(body) is None for body in start.handles())


def guidelines(start: Any, asked: Any) -> Truth:
    """All five hold."""
    return every(guideline.kept(start) for guideline in ALL_GUIDELINES)


def short_requests(start: Any, asked: Any) -> Truth:
    """The distance is at most every width and the margin."""
    return every(asked <= start.width(body) + start.margin for body in start.handles())


def alone(start: Any, asked: Any) -> Truth:
    """There is one body."""
    return len(start.bodies) == 1


def two_at_most(start: Any, asked: Any) -> Truth:
    """There are one or two bodies."""
    return len(start.bodies) <= 2


def roomy_grounds(start: Any, asked: Any) -> Truth:
    """Every ground edge has room for twice the body and the margin."""
    widths = [start.width(body) for body in start.handles()]
    return every(length >= (width + start.margin) * 2 for length in start.edge_lengths() for width in widths)


def ledges_clear(start: Any, asked: Any) -> Truth:
    """For each ledge and each two bodies, the second is not where the first could come down."""
    return every(
        out_of_the_way(start, direction, ledge, other, start.width(body) + start.margin + asked)
        for direction in Direction
        for ledge in start.facing(direction.opposite).ledges()
        for body in start.handles()
        for other in start.handles()
        if body != other and start.row(other) is not start.row_of_edge[ledge.edge]
    )


def out_of_the_way(start: Any, direction: Direction, ledge: Any, body: int, distance: Any) -> Truth:
    """A body is behind a ledge, seen in a direction, or at least so far beyond it."""
    edge, held = start.point(ledge)[0], start.bodies[body]
    near, far = (start.point(held.border(side))[0] for side in (direction.opposite, direction))
    beyond = (near - edge) * direction >= distance
    behind = (far - edge) * direction <= distance * 0
    return beyond | behind  # type: ignore[no-any-return]


def walls_thick(start: Any, asked: Any) -> Truth:
    """All terrain on a storey on which bodies stand, or below, is as thick as the margin."""
    storeys = range(max(start.storeys()) + 1)
    return every(wall.right - wall.left >= start.margin for storey in storeys for wall in start.solid(storey))


def storeys_start(start: Any, asked: Any) -> Truth:
    """Margins, terrain and supports are kept."""
    zero = zero_like(start.margin)
    return every([storeys_apart(start, zero), outside_solids(start, zero), all_held(start, zero)])


IN_ORDER = Condition("condition/in-order", "At the start no two bodies overlap.", "6.2.1; A10", in_order)
MARGINS_KEPT = Condition(
    "condition/margins-kept",
    "At the start, neighbours are at least the collision margin apart.",
    "6.2.1; R24, A10",
    margins_kept,
)
EDGES_LONG = Condition(
    "condition/edges-long",
    "No ground edge is shorter than the collision margin: else a body could be nearer than the margin and out of "
    "sight, beyond the next edge.",
    "6.2.1; A12",
    edges_long,
)
FREE_SPACE = Condition(
    "condition/free-space",
    "On a ring of two bodies or more, the distance asked does not exceed the free space.",
    "4.2; A7",
    fits_into_the_ring,
)
HALF_ROUND = Condition(
    "condition/half-round",
    "A body alone on a ring is asked for at most half a round: borders tell how far it came only once round.",
    "4.2; A7",
    at_most_half_round,
)
HALVES_LONG = Condition(
    "condition/halves-long",
    "An edge is split into two that are no shorter than the collision margin.",
    "6.2.1; A12",
    halves_long,
)
ONE_STRING = Condition(
    "condition/one-string",
    "The level is one string of ground edges, a line between two walls or a ring.",
    "2.2, 4.2, 6.2.1a to c; R5, R19",
    one_string,
)
PLANE_START = Condition(
    "condition/plane-start",
    "At the start, bodies beside each other are at least the margin apart, on their strings and in the plane, and "
    "outside all terrain.",
    "6.2.1, 6.2.2; R24, U9",
    plane_start,
)
NOBODY_RIDES = Condition(
    "condition/nobody-rides",
    "At the start nobody stands on another.",
    "4.4, 8.0.1; A27, A28, E8",
    nobody_rides,
)
GUIDELINES = Condition(
    "condition/guidelines",
    "The level keeps all five guidelines.",
    "6.2.2; G1, G2, G3, G4, G5",
    guidelines,
)
STOREYS_START = Condition(
    "condition/storeys-start",
    "At the start, bodies on one storey are at least the margin apart or have terrain between them, all are outside "
    "terrain, and each is held by the support that it names.",
    "6.2.1, 6.2.2; R24, U9",
    storeys_start,
)
WALLS_THICK = Condition(
    "condition/walls-thick",
    "No terrain is thinner than the margin, so that two bodies beside a wall are not nearer to each other than that.",
    "6.2.1; R24, U9",
    walls_thick,
)

SHORT_REQUESTS = Condition(
    "condition/short-requests",
    "The distance asked is at most any body's width and the margin, so that of a row one leaves a ledge at a time.",
    "6.2.1; A4, A48, A55",
    short_requests,
)
ALONE = Condition("condition/alone", "There is one body.", "8; O13", alone)
TWO_AT_MOST = Condition("condition/two-at-most", "There are at most two bodies.", "8", two_at_most)
ROOMY_GROUNDS = Condition(
    "condition/roomy-grounds",
    "Every ground edge is at least two bodies and two margins long.",
    "6.2.2; G4, A15, A16, U11",
    roomy_grounds,
)
LEDGES_CLEAR = Condition(
    "condition/ledges-clear",
    "Beyond every ledge, for a body's width, the margin and the distance asked, nobody stands on another string of "
    "edges, at whatever height.",
    "6.2.1, 6.2.2; R25, U5, U9",
    ledges_clear,
)

CONDITIONS: tuple[Condition, ...] = (
    IN_ORDER,
    MARGINS_KEPT,
    EDGES_LONG,
    FREE_SPACE,
    HALF_ROUND,
    HALVES_LONG,
    ONE_STRING,
    PLANE_START,
    NOBODY_RIDES,
    GUIDELINES,
    STOREYS_START,
    WALLS_THICK,
    SHORT_REQUESTS,
    ALONE,
    TWO_AT_MOST,
    ROOMY_GROUNDS,
    LEDGES_CLEAR,
)
