"""The contracts: what a call of the rules requires, what it ensures, and the measure by which it ends.

A contract is a value, and its clauses are predicates of plain facts of one call. So the very same clauses are assumed
where a contract stands in for a call in a proof, promised by the obligations that prove them, and evaluated by the
monitors on what the simulator does. A fact that whoever states it cannot know is None; no clause judges it then.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

from properties.given import Given
from spec.conditions import EDGES_LONG, IN_ORDER, MARGINS_KEPT
from spec.invariants import equal, every
from spec.number import Truth, lesser
from spec.rules.leave import Departure, Placement


@dataclass(frozen=True)
class Ahead:
    """What lies ahead of a body: all that decides how far it can move.

    Attributes:
        gap: from its front border to the body ahead, or None if there is none.
        wall: from its front border to the wall, or None if there is none.
        neighbour: the capacity of the body ahead, when that one has a spare ask less; None if there is no bound.
        spare: how many further bodies may be asked; `pushes` is whether this one may push.
        edges: the lengths of the edges ahead that are known.
    """

    margin: Any
    gap: Any | None
    wall: Any | None
    neighbour: Any | None
    spare: Any
    pushes: bool = True
    edges: tuple[Any, ...] = ()

    @property
    def room(self) -> Any:
        """What is free up to the body ahead."""
        assert self.gap is not None
        return self.gap - self.margin

    def capacity(self) -> Any | None:
        """How far the body can move: to the wall, and to the body ahead when that has moved its most; or no bound."""
        if self.gap is None:
            return self.wall
        to_contact = self.room
        if self.spare > 0 and self.pushes:
            if self.neighbour is None:
                return self.wall
            to_contact = to_contact + self.neighbour
        return to_contact if self.wall is None else lesser(to_contact, self.wall)

    def after(self, moved: Any, pushed: Any) -> Ahead:
        """What lies ahead when the body has moved, and has pushed the one ahead: by its contract that can move less."""
        gap = None if self.gap is None else self.gap + pushed - moved
        wall = None if self.wall is None else self.wall - moved
        neighbour = None if self.neighbour is None else self.neighbour - pushed
        return replace(self, gap=gap, wall=wall, neighbour=neighbour)


@dataclass(frozen=True, kw_only=True)
class Call:
    """A request of a body, or one segment of its motion, and what came of it.

    Attributes:
        asked: the distance to move by; `moved` is what it moved by.
        ahead: what lay ahead of it before, and `pushed` how far the body ahead was moved.
        borders: how far each border went, as far as that is known.
        capacity: how far the body could move before, or None if there is no bound; `left` is the same after it.
        asks: the spare asks of each request that it made; `spare` are its own.
        tolerance: 0 on exact numbers; how far floats may be off.
    """

    asked: Any
    moved: Any
    ahead: Ahead | None = None
    pushed: Any = 0
    borders: tuple[Any, ...] = ()
    capacity: Any | None = None
    left: Any | None = None
    spare: Any = 0
    asks: tuple[Any, ...] = ()
    tolerance: Any = 0

    @property
    def gap_after(self) -> Any | None:
        """The gap to the body ahead in the end, or None if there is none."""
        return None if self.ahead is None or self.ahead.gap is None else self.ahead.gap + self.pushed - self.moved


@dataclass(frozen=True, kw_only=True)
class Stretch(Call):
    """One segment of a motion, or one walk of a rear border: what there is of its edge, and whether it goes on.

    Attributes:
        length: that of the edge; `reach` is the distance to the end of it, before.
        slack: for the border in the end, its location and its distance to the end of the edge, where no ledge is.
        to_go: what is left to go from the beginning of the edge, in the end.
    """

    going: bool = False
    length: Any | None = None
    reach: Any | None = None
    slack: tuple[Any, ...] = ()
    to_go: Any | None = None


@dataclass(frozen=True)
class Parting:
    """A body at the end of its move, and where it was placed."""

    leaving: Departure[Any, Any]
    placed: Placement[Any, Any]
    tolerance: Any = 0


@dataclass(frozen=True)
class Clause:
    """Something that is to hold of the facts of a call; `premise` is the ID of the condition that says so of a row."""

    sentence: str
    holds: Callable[[Any], Truth]
    premise: str = ""


@dataclass(frozen=True)
class Measure:
    """What falls, so that calls end; where nothing goes on, `falls` is None, and the sentence says why."""

    sentence: str
    falls: Callable[[Any], Truth] | None


@dataclass(frozen=True)
class Contract:
    """What is to hold before a call, what holds after it, and why it ends."""

    id: str
    sentence: str
    requires: tuple[Clause, ...]
    ensures: tuple[Clause, ...]
    measure: Measure

    @property
    def promises(self) -> tuple[Clause, ...]:
        """What a call is to show: what the contract ensures, and that the measure falls."""
        falls = self.measure.falls
        return self.ensures if falls is None else (*self.ensures, Clause(self.measure.sentence, falls))

    def name(self, clause: Clause) -> str:
        """A clause as a promise that may be broken."""
        return f"{self.id}: {clause.sentence}"


def forwards(call: Call) -> Truth:
    """The distance asked is at least 0."""
    return call.asked >= call.asked * 0 - call.tolerance  # type: ignore[no-any-return]


def in_order(call: Call) -> Truth:
    """The body ahead is ahead."""
    gap = None if call.ahead is None else call.ahead.gap
    return gap is None or gap >= gap * 0 - call.tolerance


def at_margin(call: Call) -> Truth:
    """The body ahead is the margin away, or further."""
    if call.ahead is None or call.ahead.gap is None:
        return True
    return call.ahead.gap >= call.ahead.margin - call.tolerance  # type: ignore[no-any-return]


def on_long_edges(call: Call) -> Truth:
    """No edge ahead is shorter than the margin."""
    return call.ahead is None or every(length >= call.ahead.margin for length in call.ahead.edges)


def at_most_asked(call: Call) -> Truth:
    """It moves by 0 or more, and by what was asked or less."""
    return (call.moved >= call.moved * 0 - call.tolerance) & (call.moved <= call.asked + call.tolerance)  # type: ignore[no-any-return]


def borders_go_along(call: Call) -> Truth:
    """Each border goes as far as it is said."""
    return every(equal(went, call.moved, call.tolerance) for went in call.borders)


def passes_nobody(call: Call) -> Truth:
    """The body ahead is still ahead."""
    return call.gap_after is None or call.gap_after >= call.moved * 0 - call.tolerance


def asks_fewer(call: Call) -> Truth:
    """Whoever it asks has one spare ask less."""
    return every((spare >= 0) & (spare == call.spare - 1) for spare in call.asks)


def within_capacity(call: Call) -> Truth:
    """It moves no further than it can."""
    return call.capacity is None or call.moved <= call.capacity + call.tolerance


def as_far_as_possible(call: Call) -> Truth:
    """It moves by what was asked, or as far as it can."""
    all_asked = equal(call.moved, call.asked, call.tolerance)
    return all_asked if call.capacity is None else all_asked | equal(call.moved, call.capacity, call.tolerance)


def pushes_the_excess(call: Call) -> Truth:
    """The body ahead moves by what the move exceeds the room, else it stays."""
    if call.ahead is None or call.ahead.gap is None:
        return equal(call.pushed, call.moved * 0, call.tolerance)
    excess, least = call.moved - call.ahead.room, call.moved * 0 - call.tolerance
    stays, goes = equal(call.pushed, call.moved * 0, call.tolerance), equal(call.pushed, excess, call.tolerance)
    return (stays | goes) & (call.pushed >= least) & (call.pushed >= excess - call.tolerance)  # type: ignore[no-any-return]


def margin_kept(call: Call) -> Truth:
    """The body ahead is the margin away, or further, in the end."""
    if call.ahead is None or call.gap_after is None:
        return True
    return call.gap_after >= call.ahead.margin - call.tolerance  # type: ignore[no-any-return]


def capacity_spent(call: Call) -> Truth:
    """How far the body can move is less by what it moved."""
    if call.capacity is None or call.left is None:
        return True
    return equal(call.left, call.capacity - call.moved, call.tolerance)


def on_its_edge(stretch: Stretch) -> Truth:
    """The border is between the ends of its edge."""
    return every(slack >= stretch.moved * 0 - stretch.tolerance for slack in stretch.slack)


def on_from_the_end(stretch: Stretch) -> Truth:
    """It goes on only from the end of its edge."""
    return not stretch.going or stretch.reach is None or equal(stretch.moved, stretch.reach, stretch.tolerance)


def done_unless_going(stretch: Stretch) -> Truth:
    """It goes on, or it has moved as far as possible."""
    return stretch.going or as_far_as_possible(stretch)


def nothing_left(stretch: Stretch) -> Truth:
    """It goes on, or nothing is left."""
    return stretch.going or equal(stretch.moved, stretch.asked, stretch.tolerance)


def string_goes_on(stretch: Stretch) -> Truth:
    """There is string as far as it is to go."""
    wall = None if stretch.ahead is None else stretch.ahead.wall
    return wall is None or stretch.asked <= wall + stretch.tolerance


def asks_once(stretch: Stretch) -> Truth:
    """It makes one request at most."""
    return len(stretch.asks) <= 1


def to_go_falls(stretch: Stretch) -> Truth:
    """What is left to go, from the beginning of its edge, falls by the edge, which has a length."""
    if not stretch.going or stretch.to_go is None or stretch.length is None:
        return True
    before = stretch.asked + stretch.length - stretch.reach
    return every([stretch.length > 0, equal(stretch.to_go, before - stretch.length, stretch.tolerance)])


def moves_on_by_less(parting: Parting) -> Truth:
    """It has moved by as much as before, or by less, and not back."""
    moved, before = parting.placed.moved, parting.leaving.moved
    return (moved <= before + parting.tolerance) & (moved >= before * 0 - parting.tolerance)  # type: ignore[no-any-return]


def stays_if_on_edge(parting: Parting) -> Truth:
    """It stays exactly where it is, unless its rear border is beyond the end of its edge."""
    leaving, placed = parting.leaving, parting.placed
    beyond = leaving.view.reach(leaving.rear) < leaving.moved * 0 - parting.tolerance
    stays = placed.front is leaving.front and placed.rear is leaving.rear
    return beyond | every([stays, equal(placed.moved, leaving.moved, parting.tolerance)])  # type: ignore[no-any-return]


def cut_back_alike(parting: Parting) -> Truth:
    """What is cut off the distance is cut off both borders, and the rear one is at the end of its edge then."""
    leaving, placed, view = parting.leaving, parting.placed, parting.leaving.view
    cut = leaving.moved - placed.moved
    borders = ((placed.front, leaving.front), (placed.rear, leaving.rear))
    alike = every(equal(view.reach(now) - view.reach(then), cut, parting.tolerance) for now, then in borders)
    at_end = equal(view.reach(placed.rear), cut * 0, parting.tolerance)
    return equal(cut, cut * 0, parting.tolerance) | (alike & at_end)  # type: ignore[no-any-return]


FORWARDS = Clause("asks for a distance of at least 0", forwards)
ORDERED = Clause("neighbours are in order", in_order, IN_ORDER.id)
APART = Clause("neighbours are the margin apart", at_margin, MARGINS_KEPT.id)
LONG = Clause("no edge is shorter than the margin", on_long_edges, EDGES_LONG.id)
AT_MOST = Clause("moves by 0 to what was asked", at_most_asked)
ALONG = Clause("each border goes as far as it says", borders_go_along)
PASSES_NOBODY = Clause("passes nobody", passes_nobody)
WITHIN = Clause("moves no further than it can", within_capacity)
EXCESS = Clause("moves the body ahead by what it exceeds the room, and no further", pushes_the_excess)
MARGIN = Clause("keeps the margin", margin_kept)
SPENT = Clause("can move less by what it moved", capacity_spent)
ONWARD = Clause("goes on only from the end of its edge", on_from_the_end)
ON_EDGE = Clause("ends on its edge, or in overhang", on_its_edge)
AS_FAR = Clause("moved at most as far as before, and not back", moves_on_by_less)
FALLS = "what is left to go, from the beginning of its edge, falls by the edge whenever it goes on"

REQUEST = Contract(
    "contract/request",
    "A request moves a body by some of the distance asked, and changes no order.",
    requires=(FORWARDS, ORDERED),
    ensures=(AT_MOST, ALONG, PASSES_NOBODY),
    measure=Measure("the spare asks fall by one with each request that it makes", asks_fewer),
)
REQUEST_EXACT = Contract(
    "contract/request-exact",
    "On one string, a request moves its body as far as it can, and each body ahead by what exceeds the room.",
    requires=(FORWARDS, APART, LONG),
    ensures=(WITHIN, Clause("moves by what was asked, or as far as it can", as_far_as_possible), EXCESS, MARGIN, SPENT),
    measure=REQUEST.measure,
)
SEGMENT = Contract(
    "contract/segment",
    "A segment moves a front border on one edge, after one request of the body ahead at most.",
    requires=(FORWARDS, ORDERED),
    ensures=(
        AT_MOST,
        ALONG,
        PASSES_NOBODY,
        ON_EDGE,
        ONWARD,
        Clause("asks once at most", asks_once),
        Clause("hands on one spare ask less", asks_fewer),
    ),
    measure=Measure(FALLS, to_go_falls),
)
SEGMENT_EXACT = Contract(
    "contract/segment-exact",
    "On one string, a segment moves as far as possible or is on its way there; what it moves is what it can move less.",
    requires=(FORWARDS, APART, LONG),
    ensures=(WITHIN, Clause("goes on, or has moved as far as possible", done_unless_going), EXCESS, MARGIN, SPENT),
    measure=SEGMENT.measure,
)
REAR = Contract(
    "contract/rear",
    "A walk of a rear border leaves nothing out, on a string that goes on as far as it is towed.",
    requires=(FORWARDS, Clause("the string goes on as far as the rear is towed", string_goes_on)),
    ensures=(AT_MOST, ALONG, Clause("stops only when nothing is left", nothing_left), ONWARD),
    measure=Measure(FALLS, to_go_falls),
)
LEAVING = Contract(
    "contract/leaving",
    "A body stays where its move has led it, unless both borders are beyond the end of its edge.",
    requires=(),
    ensures=(
        AS_FAR,
        Clause("stays where it is with a border on its edge", stays_if_on_edge),
        Clause("what is cut off the distance is cut off both borders, up to the ledge", cut_back_alike),
    ),
    measure=Measure("it neither asks nor goes on: it is chosen once in a request", None),
)

CONTRACTS = (REQUEST, REQUEST_EXACT, SEGMENT, SEGMENT_EXACT, REAR, LEAVING)


def assume_required(given: Given, contract: Contract, facts: Any) -> None:
    """Assume of a call what its contract requires; the premises bear the IDs of the conditions that say so of a row."""
    for clause in contract.requires:
        given.assume(clause.holds(facts), clause.premise or contract.name(clause))


def stand_in_for(given: Given, contract: Contract, facts: Any, clauses: Sequence[Clause] = ()) -> None:
    """Assume what a contract ensures, or some clauses of it, of a call that it stands in for."""
    for clause in clauses or contract.ensures:
        given.assume(clause.holds(facts), contract.name(clause))


def promise(given: Given, contract: Contract, facts: Any, clauses: Sequence[Clause] = ()) -> None:
    """Promise what a contract does of a call, or some clauses of it."""
    for clause in clauses or contract.promises:
        given.ensure(contract.name(clause), clause.holds(facts))
