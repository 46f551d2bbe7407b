"""Invariants: what every request must keep, whatever the rules. They know worlds, not rules."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, Generic

from spec.graph import Direction
from spec.number import N, Truth, zero_like
from spec.world import State


@dataclass(frozen=True)
class Deed(Generic[N]):
    """One request and what came of it. `before` and `after` are the world at rest.

    Attributes:
        asked: the distance asked, at least 0; `moved` is what the request says it moved.
        depth: bodies in the longest chain of requests; `limit` is the push limit.
        fired: the number of rules that fired.
        tolerance: 0 on exact numbers; how far a float world may be off.
    """

    before: State[N]
    after: State[N]
    body: int
    direction: Direction
    asked: N
    moved: N
    depth: int
    limit: int
    fired: int
    tolerance: N


@dataclass(frozen=True)
class Invariant:
    """A property of every request: its sentence, its source, and the predicate that decides it."""

    id: str
    sentence: str
    source: str
    holds: Callable[[Deed[Any]], Truth]

    kind = "invariant"


def every(truths: Iterable[Truth]) -> Truth:
    """Whether all of them hold, without deciding one after another."""
    result: Any = True
    for truth in truths:
        result = result & truth
    return result  # type: ignore[no-any-return]


def equal(a: N, b: N, tolerance: N) -> Truth:
    """Whether two numbers differ by no more than the tolerance."""
    return (a - b <= tolerance) & (b - a <= tolerance)  # type: ignore[no-any-return]


def no_overlap(deed: Deed[N]) -> Truth:
    """Neighbours keep the margin."""
    after = deed.after
    return every(after.clear(*pair) >= after.margin - deed.tolerance for pair in after.neighbours())


def order_kept(deed: Deed[N]) -> Truth:
    """Every right neighbour is still on the right."""
    zero = zero_like(deed.asked) - deed.tolerance
    return every(deed.after.clear(*pair) >= zero for pair in deed.after.neighbours())


def terminates(deed: Deed[N]) -> Truth:
    """The chain keeps the push limit, and no body is in it twice."""
    return deed.depth <= min(deed.limit, len(deed.before.bodies_in_order()))


def rules_bounded(deed: Deed[N]) -> Truth:
    """The rules that fired keep the bound.

    Let n be the number of bodies, and e one more than that of edges, which is the most segments that a border
    makes on its way along the string (once round a ring at most). The mover makes e segments, and asks its
    neighbour once in each; the neighbour makes as many, and one more for each edge that it passes on to; so the
    k-th body makes k e, and all together n (n + 1) e / 2. A segment fires four rules; the request that it may
    make fires `follow/rear`, `leave/stay` and the walks of the rear border, which add no more than four a segment.
    """
    bodies, edges = len(deed.before.bodies_in_order()), len(deed.before.edge_lengths()) + 1
    return deed.fired <= 8 * edges * bodies * (bodies + 1) // 2


def rigid_width(deed: Deed[N]) -> Truth:
    """No body changes its width."""
    before, after = deed.before, deed.after
    return every(equal(before.width(body), after.width(body), deed.tolerance) for body in before.bodies_in_order())


def on_graph(deed: Deed[N]) -> Truth:
    """No border leaves its edge."""
    zero = zero_like(deed.asked) - deed.tolerance
    return every(slack >= zero for body in deed.after.bodies_in_order() for slack in deed.after.off_graph(body))


def at_most_asked(deed: Deed[N]) -> Truth:
    """The request moves no further than asked, and says how far."""
    went = deed.after.travel(deed.before, deed.body, deed.direction)
    return (deed.moved <= deed.asked + deed.tolerance) & equal(went, deed.moved, deed.tolerance)  # type: ignore[no-any-return]


def in_direction(deed: Deed[N]) -> Truth:
    """Nothing moves against the direction asked."""
    zero = zero_like(deed.asked) - deed.tolerance
    bodies = deed.before.bodies_in_order()
    went = [deed.after.travel(deed.before, body, deed.direction) for body in bodies]
    return every(distance >= zero for distance in [deed.moved, *went])


def chain(deed: Deed[N]) -> Iterator[tuple[int, int]]:
    """Each body of the row ahead of the mover with the one behind it, up to the mover or the row's end."""
    behind = deed.body
    for _ in deed.before.bodies_in_order():
        ahead = deed.before.beside(behind, deed.direction)
        if ahead is None or ahead == deed.body:
            return
        yield behind, ahead
        behind = ahead


def gap_ahead(state: State[N], behind: int, ahead: int, direction: Direction) -> N:
    """The clear distance between neighbours, of which one is ahead in a direction."""
    return state.clear(behind, ahead) if direction is Direction.RIGHT else state.clear(ahead, behind)


def bystanders_stay(deed: Deed[N]) -> Truth:
    """A body moves only if it is the mover, or if the body behind it moved and is in contact with it."""
    chained = list(chain(deed))
    still = set(deed.before.bodies_in_order()) - {deed.body} - {ahead for _, ahead in chained}
    return every(
        [
            *(is_still(deed, body) for body in still),
            *(is_still(deed, ahead) | in_contact(deed, behind, ahead) for behind, ahead in chained),
        ]
    )


def is_still(deed: Deed[N], body: int) -> Truth:
    """Whether a body is where it was."""
    return equal(deed.after.travel(deed.before, body, deed.direction), zero_like(deed.asked), deed.tolerance)


def in_contact(deed: Deed[N], behind: int, ahead: int) -> Truth:
    """Whether two neighbours end at the margin from each other."""
    gap = gap_ahead(deed.after, behind, ahead, deed.direction)
    return equal(gap, deed.after.margin, deed.tolerance)


def as_far_as_possible(deed: Deed[N]) -> Truth:
    """It moved all it was asked, or a row in contact reaches from it to a wall, the push limit or itself.

    A row that comes round to the mover stops at where the mover's rear border was when it asked.
    """
    row = [deed.body]
    row.extend(ahead for _, ahead in chain(deed))
    row = row[: deed.limit]
    beyond = deed.before.beside(row[-1], deed.direction)
    stopped = [in_contact(deed, behind, ahead) for behind, ahead in pairwise(row)]
    if beyond is None:
        end = deed.after.to_wall(row[-1], deed.direction)
        stopped.append(end is not None and end <= deed.tolerance)
    else:
        room = gap_ahead(deed.after, row[-1], beyond, deed.direction) - deed.after.margin
        stopped.append(room <= (deed.moved if beyond == deed.body else deed.moved * 0) + deed.tolerance)
    return equal(deed.moved, deed.asked, deed.tolerance) | every(stopped)  # type: ignore[no-any-return]


def full_circle_stands(deed: Deed[N]) -> Truth:
    """Neighbours on a ring are not all in contact, or nobody moves."""
    before = deed.before
    pairs = list(before.neighbours())
    if not before.closed or not pairs:
        return True
    room: Any = False
    for pair in pairs:
        room = room | (before.clear(*pair) > before.margin + deed.tolerance)
    still = every(is_still(deed, body) for body in before.bodies_in_order())
    return room | (still & (deed.moved <= deed.tolerance))  # type: ignore[no-any-return]


NO_OVERLAP = Invariant(
    "invariant/no-overlap",
    "After a request, neighbours are at least the collision margin apart.",
    "6.2.1; R24",
    no_overlap,
)
ORDER = Invariant(
    "invariant/order",
    "No request changes the order of bodies on their string of edges.",
    "4.2; R5, R24",
    order_kept,
)
TERMINATION = Invariant(
    "invariant/termination",
    "Pushing terminates: a chain of requests has at most as many bodies as the push limit, and no body twice.",
    "4.2; R6, R31, A5",
    terminates,
)
RULE_COUNT = Invariant(
    "invariant/rule-count",
    "The rules that fire in a request are at most eight times its bodies times the edges and one, times the bodies "
    "and one, halved.",
    "4.2; R6, R31",
    rules_bounded,
)
RIGID_WIDTH = Invariant(
    "invariant/rigid-width", "No request changes the width of a body.", "4.3.1; R8, A31", rigid_width
)
ON_GRAPH = Invariant(
    "invariant/on-graph",
    "Every border stays on an edge, between its ends.",
    "4.3.1, 6.1.1; R7, A32",
    on_graph,
)
AT_MOST_ASKED = Invariant(
    "invariant/at-most-asked",
    "A request moves its body by at most the distance asked, and returns the distance it moved it by.",
    "6.2.1; R17",
    at_most_asked,
)
DIRECTION = Invariant(
    "invariant/direction", "A request moves no body against its direction.", "6.2.1; R17, R20", in_direction
)
BYSTANDERS = Invariant(
    "invariant/bystanders",
    "A body that is not pushed does not move: only the mover moves, and whoever ends in contact ahead of it.",
    "4.2; R6, R20",
    bystanders_stay,
)
AS_FAR_AS_POSSIBLE = Invariant(
    "invariant/as-far-as-possible",
    "A request moves its body by all it was asked, unless a row in contact reaches from it to a wall, to the "
    "push limit or round to itself.",
    "6.2.1c; R20, R31",
    as_far_as_possible,
)
FULL_CIRCLE = Invariant(
    "invariant/full-circle",
    "On a ring on which every body is in contact with the next, a request ends, and moves nobody.",
    "4.2; R31, A5, A7",
    full_circle_stands,
)

OF_ONE_REQUEST: tuple[Invariant, ...] = (
    NO_OVERLAP,
    ORDER,
    TERMINATION,
    RULE_COUNT,
    RIGID_WIDTH,
    ON_GRAPH,
    AT_MOST_ASKED,
    DIRECTION,
    BYSTANDERS,
    AS_FAR_AS_POSSIBLE,
    FULL_CIRCLE,
)


@dataclass(frozen=True)
class Relation:
    """A property of several runs compared; `properties/evidence` runs them."""

    id: str
    sentence: str
    source: str

    kind = "invariant"


ADDITIVE = Relation(
    "invariant/additive",
    "Two requests, one after the other, do what one request of their sum does.",
    "6.2.1; R17",
)
MIRROR = Relation(
    "invariant/mirror",
    "The mirror image of a request does the mirror image of what the request does.",
    "6.1.1; A58",
)
EDGE_SPLIT = Relation("invariant/edge-split", "Splitting a ground edge in two changes no movement.", "6.2.1a; R18, A12")
TRANSLATION = Relation(
    "invariant/translation", "Moving the whole level in its plane changes no movement.", "6.1.1; R12"
)
DETERMINISM = Relation(
    "invariant/determinism", "The same level and the same requests give the same result.", "7.2; R17"
)

CLOSED_FORM = Relation(
    "invariant/closed-form",
    "A request moves its body by the distance asked, at most by all free space up to what stops the chain, and "
    "each body ahead by what that exceeds the free space before it.",
    "6.2.1c; R20, A6, A7",
)
MARGINS_OVER_TIME = Relation(
    "invariant/margins-over-time",
    "Any number of requests and ticks, one after another, leave neighbours at least the collision margin apart.",
    "1.1, 6.2.1; R1, R4, R24",
)
ORDER_OVER_TIME = Relation(
    "invariant/order-over-time",
    "Any number of requests and ticks, one after another, keep the order of bodies, their widths, and all borders on "
    "edges.",
    "1.1, 4.3.1; R1, R4, R7, R8",
)

RELATIONS: tuple[Relation, ...] = (
    ADDITIVE,
    MIRROR,
    EDGE_SPLIT,
    TRANSLATION,
    DETERMINISM,
    CLOSED_FORM,
    MARGINS_OVER_TIME,
    ORDER_OVER_TIME,
)
