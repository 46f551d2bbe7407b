"""What the rules may ask of a world: a level and its bodies, seen in one direction of motion.

A rule never sees an index, a length of a list or a direction: left and right are one text.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any, Generic, Protocol, TypeVar

from spec.graph import Direction
from spec.number import N, Number

B = TypeVar("B")
P = TypeVar("P")
N_co = TypeVar("N_co", bound=Number, covariant=True)


@dataclass(frozen=True)
class Beyond(Generic[P]):
    """What lies beyond the end of an edge: the beginning of the next ground edge, or a ledge, or a wall."""

    onward: P | None
    ledge: bool


@dataclass(frozen=True)
class Jump(Generic[N, P]):
    """A jump edge from a ledge to a top, or from the corner of a top to a top or a ledge (4.4, 6.1.3; R15).

    Attributes:
        target: its far end, as a position on the edge there.
        across: its horizontal extent in the direction of the motion; `drop` is how far it leads down.
        free: whether a body may stand at its far end; only said of ledges (A54).
    """

    target: P
    across: N
    drop: N
    free: bool


class View(Protocol[N, B, P]):
    """A world seen in the direction of a motion. `B` names a body, `P` is a position of a border.

    Laws that every world keeps (checked of the reference world, assumed in proofs):
    `reach(end(p)) = 0`; `reach(along(p, x)) = reach(p) - x` for `0 <= x <= reach(p)`;
    `beyond(p).onward` is the same place as `end(p)`, named on the next edge; moving by `x` lessens every `gap` by
    `x`; `ahead` is the nearest other body ahead, and is seen exactly if its facing border lies on this edge
    or the next.
    """

    @property
    def margin(self) -> N:
        """The collision margin, greater than 0 (6.2.1, R24)."""

    def front(self, body: B, /) -> P:
        """The border that leads the motion (4.3.1, R8)."""

    def rear(self, body: B, /) -> P:
        """The border that follows (4.3.1, R8)."""

    def reach(self, at: P, /) -> N:
        """Distance to the end of the edge, at least 0."""

    def along(self, at: P, distance: N, /) -> P:
        """The position `distance` ahead on the same edge; `distance <= reach(at)`."""

    def end(self, at: P, /) -> P:
        """The end of the edge."""

    def beyond(self, at: P, /) -> Beyond[P]:
        """What follows the edge, looked up by (vertex, direction, type) (6.1.3; R14, R16)."""

    def ahead(self, body: B, front: P, /) -> B | None:
        """The nearest other body ahead of `front` on this edge or the next, or None (6.2.1, A12)."""

    def gap(self, front: P, other: B, /) -> N:
        """Distance along the graph from `front` to the facing border of `other` (4.3.2, A31)."""

    def pushes(self, body: B, /) -> bool:
        """Whether the body may push others (1.1, A39)."""

    def width(self, body: B, /) -> N:
        """Distance along the graph between the borders (4.3.2, A31)."""

    def foot(self, at: P, /) -> P | None:
        """The beginning of the ground edge after the fall edge at the end of this edge, or None (6.2.1d)."""

    def jumps(self, body: B, at: P, /) -> Sequence[Jump[N, P]]:
        """The jump edges at the end of this edge that another body or ledge gives to `body` (6.1.3; R15, A22)."""

    def across(self, start: P, end: P, /) -> N:
        """Horizontal distance from one position to another, in the direction of the motion."""

    def place(self, body: B, front: P, rear: P, /) -> None:
        """Put the borders of `body` where the motion has taken them."""


class State(Protocol[N_co]):
    """A world at rest, as the invariants see it: bodies in order, by their places in it, and no rules."""

    @property
    def margin(self) -> N_co:
        """The collision margin."""

    @property
    def closed(self) -> bool:
        """Whether the string of edges is a ring."""

    def edge_lengths(self) -> Sequence[N_co]:
        """The lengths of all ground edges."""

    def bodies_in_order(self) -> Sequence[int]:
        """All bodies, from left to right; on a ring, once round."""

    def beside(self, body: int, direction: Direction, /) -> int | None:
        """The neighbour on one side, or None."""

    def neighbours(self) -> Iterable[tuple[int, int]]:
        """Each body with its right neighbour; on a ring the last with the first, if they are two."""

    def clear(self, left: int, right: int, /) -> N_co:
        """Signed distance from the right border of `left` to the left border of its right neighbour."""

    def width(self, body: int, /) -> N_co:
        """Distance along the graph between the borders (4.3.2, A11, A31)."""

    def off_graph(self, body: int, /) -> Iterable[N_co]:
        """For each border, its location and its distance to the end of its edge: all at least 0 (R7)."""

    def to_wall(self, body: int, direction: Direction, /) -> N_co | None:
        """Distance from the leading border to the end of the string; None on a ring."""

    def travel(self, before: Any, body: int, direction: Direction, /) -> N_co:
        """How far a body has come in a direction since `before`, a state of the same world.

        On a ring, less than once round.
        """
