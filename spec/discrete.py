"""The discrete sibling: bodies stand on the vertices of a graph, in stacks, and move by one vertex a turn (4.1.2, O13).

The vertices are the storeys of columns: in each column they begin on the ground, which is so many storeys high. Nothing
is measured: where two bodies cannot be on one vertex, no width and no margin is needed.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

from spec.graph import Direction
from spec.number import Truth
from spec.rule import AnyFamily, AnyRule, Family, Rule


@dataclass(frozen=True)
class Representation:
    """Another way to represent bodies: its sentence and its source."""

    id: str
    sentence: str
    source: str

    kind = "design"


DISCRETE = Representation(
    "discrete/vertices",
    "A body is on a vertex, one storey of one column, on the ground of the column or on the top of another body; in a "
    "turn one body is asked to move by one vertex.",
    "4.1.2, 8.0.1; O13",
)


@dataclass(frozen=True)
class Spot:
    """A vertex: a column, counted from the left, and a storey, counted from the lowest ground."""

    column: int
    storey: int


@dataclass(frozen=True)
class State:
    """The height of the ground in each column, in storeys, and the spot of each body."""

    ground: tuple[int, ...]
    spots: tuple[Spot, ...]

    def solid(self, spot: Spot) -> bool:
        """Whether it is terrain there, or beyond the ends of the level, which are walls."""
        return not 0 <= spot.column < len(self.ground) or spot.storey < self.ground[spot.column]

    def body_at(self, spot: Spot) -> int | None:
        """The body on a vertex."""
        return self.spots.index(spot) if spot in self.spots else None


@dataclass(frozen=True)
class Front:
    """Whether it is solid ahead of the foremost body of a row."""

    solid: bool


def shut(front: Front) -> Truth:
    """It is solid ahead of the row."""
    return front.solid


def open_(front: Front) -> Truth:
    """It is not solid ahead of the row."""
    return not front.solid


def by_none(front: Front) -> int:
    """They stay on their vertices."""
    return 0


def by_one(front: Front) -> int:
    """They move by one vertex."""
    return 1


ADVANCE: AnyFamily = Family(
    "advance",
    (
        Rule(
            id="discrete/blocked",
            sentence="A row ahead of which it is solid does not move: nobody steps up.",
            source="4.1.2, 6.2.1b; O13, R19",
            guard=(shut,),
            effect=by_none,
        ),
        Rule(
            id="discrete/moves",
            sentence="Else the body that is asked, all before it on its storey without a vertex between them, and all "
            "that are stacked on these, move by one vertex.",
            source="4.1.2, 8.0.1, 4.2; O13, R6",
            guard=(open_,),
            effect=by_one,
        ),
    ),
)


@dataclass(frozen=True)
class Foot:
    """Whether there is ground or a body right below a body."""

    held: bool


def held_up(foot: Foot) -> Truth:
    """There is ground or a body below."""
    return foot.held


def in_the_air(foot: Foot) -> Truth:
    """There is neither ground nor a body below."""
    return not foot.held


DROP: AnyFamily = Family(
    "drop",
    (
        Rule(
            id="discrete/stands",
            sentence="A body over ground or over a body stands there.",
            source="4.1.2, 8.0.1; O13",
            guard=(held_up,),
            effect=by_none,
        ),
        Rule(
            id="discrete/falls",
            sentence="A body over neither falls by a storey, and looks again; the lowest ones first.",
            source="4.1.2, 8.0.1; O13, R21",
            guard=(in_the_air,),
            effect=by_one,
        ),
    ),
)

DISCRETE_RULES: tuple[AnyRule, ...] = (*ADVANCE.rules, *DROP.rules)


def row(state: State, body: int, direction: Direction) -> list[int]:
    """A body and those before it on its storey, one right behind the other."""
    found, spot = [body], state.spots[body]
    while (ahead := state.body_at(spot := Spot(spot.column + direction, spot.storey))) is not None:
        found.append(ahead)
    return found


def turn(state: State, body: int, direction: Direction) -> State:
    """Ask a body to move by one vertex; return the state after that, and after all falls."""
    pushed = [state.spots[one] for one in row(state, body, direction)]
    front = Front(state.solid(Spot(pushed[-1].column + direction, pushed[-1].storey)))
    by = direction * ADVANCE.choose(front).effect(front)
    columns = {spot.column for spot in pushed}
    moved = [
        replace(spot, column=spot.column + by) if spot.column in columns and spot.storey >= pushed[0].storey else spot
        for spot in state.spots
    ]
    return settled(replace(state, spots=tuple(moved)))


def settled(state: State) -> State:
    """Let all fall, the lowest ones first."""
    for body in sorted(range(len(state.spots)), key=lambda body: state.spots[body].storey):
        while by := dropped(state, state.spots[body]):
            spots = list(state.spots)
            spots[body] = Spot(spots[body].column, spots[body].storey - by)
            state = replace(state, spots=tuple(spots))
    return state


def dropped(state: State, spot: Spot) -> int:
    """By how many storeys a body falls before it looks again: one or none."""
    below = Spot(spot.column, spot.storey - 1)
    foot = Foot(state.solid(below) or state.body_at(below) is not None)
    by: int = DROP.choose(foot).effect(foot)
    return by


@dataclass(frozen=True)
class Turn:
    """A turn, and what came of it."""

    before: State
    after: State
    body: int
    direction: Direction


@dataclass(frozen=True)
class TurnInvariant:
    """A property of every turn: its sentence, its source, and the predicate that decides it."""

    id: str
    sentence: str
    source: str
    holds: Callable[[Turn], bool]

    kind = "invariant"


def one_each(turn: Turn) -> bool:
    """No two spots are the same."""
    return len(set(turn.after.spots)) == len(turn.after.spots)


def supported(turn: Turn) -> bool:
    """Below each spot it is solid, or a body stands there, and no spot is solid."""
    after = turn.after
    below = [Spot(spot.column, spot.storey - 1) for spot in after.spots]
    return all(map(after.solid, set(below) - set(after.spots))) and not any(map(after.solid, after.spots))


def order_kept(turn: Turn) -> bool:
    """Of any two that were and are on one storey, the same one is on the left."""
    pairs = list(zip(turn.before.spots, turn.after.spots, strict=True))
    return not any(
        one.storey == other.storey
        and now.storey == then.storey
        and one.column < other.column
        and now.column > then.column
        for one, now in pairs
        for other, then in pairs
    )


def one_vertex(turn: Turn) -> bool:
    """Who moves does so by one vertex in the direction, and nobody comes higher."""
    by = (0, turn.direction)
    return all(
        now.column - then.column in by and now.storey <= then.storey
        for then, now in zip(turn.before.spots, turn.after.spots, strict=True)
    )


def as_asked(turn: Turn) -> bool:
    """The body moves, unless a row of bodies from it on ends at something solid."""
    spot = turn.before.spots[turn.body]
    ahead = Spot(spot.column + turn.direction, spot.storey)
    while ahead in turn.before.spots:
        ahead = Spot(ahead.column + turn.direction, ahead.storey)
    return (turn.after.spots[turn.body].column != spot.column) != turn.before.solid(ahead)


DISCRETE_INVARIANTS: tuple[TurnInvariant, ...] = (
    TurnInvariant("discrete/one-each", "No two bodies are on one vertex.", "4.1.2; O13", one_each),
    TurnInvariant(
        "discrete/supported", "Every body stands on ground or on a body, and outside terrain.", "8.0.1; O13", supported
    ),
    TurnInvariant("discrete/order", "Two bodies that stay on one storey keep their order.", "4.1.2; O13", order_kept),
    TurnInvariant(
        "discrete/one-vertex", "Nobody moves by more than one vertex, or rises.", "4.1.2, 6.2.1; O13, R32", one_vertex
    ),
    TurnInvariant(
        "discrete/as-asked", "The body that is asked moves unless its row ends at a wall.", "4.2; O13, R6", as_asked
    ),
)
