"""A row of bodies on one level edge, on which the rules' own code runs.

Its numbers are whatever it is given: symbolic reals, symbolic whole numbers, fractions, or integers of CrossHair.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from spec.rules.request import Ask, Rules, request
from spec.world import Beyond


@dataclass
class Row:
    """A view (`spec.world.View`) of bodies on one level edge, to the right. A border is at its place from the left."""

    margin: Any
    wall: Any
    lefts: list[Any]
    rights: list[Any]

    def copy(self) -> Row:
        return Row(self.margin, self.wall, list(self.lefts), list(self.rights))

    def shifts(self, before: Row) -> list[Any]:
        """How far each border has moved since another state, from left to right."""
        borders = zip([*self.lefts, *self.rights], [*before.lefts, *before.rights], strict=True)
        return [now - then for now, then in borders]

    def shift(self, shifts: Sequence[Any]) -> None:
        """Move each border."""
        moved = [border + shift for border, shift in zip([*self.lefts, *self.rights], shifts, strict=True)]
        self.lefts, self.rights = moved[: len(self.lefts)], moved[len(self.lefts) :]

    def keeps(self, margin: Any) -> list[Any]:
        """Of each two neighbours, whether they keep a margin."""
        return [left - right >= margin for right, left in zip(self.rights[:-1], self.lefts[1:], strict=True)]

    def front(self, body: int) -> Any:
        return self.rights[body]

    def rear(self, body: int) -> Any:
        return self.lefts[body]

    def reach(self, at: Any) -> Any:
        return self.wall - at

    def along(self, at: Any, distance: Any) -> Any:
        return at + distance

    def end(self, at: Any) -> Any:
        return self.wall

    def beyond(self, at: Any) -> Beyond[Any]:
        return Beyond(None, ledge=False)

    def ahead(self, body: int, front: Any) -> int | None:
        return body + 1 if body + 1 < len(self.lefts) else None

    def gap(self, front: Any, other: int) -> Any:
        return self.lefts[other] - front

    def pushes(self, body: int) -> bool:
        return True

    def width(self, body: int) -> Any:
        return self.rights[body] - self.lefts[body]

    def foot(self, at: Any) -> None:
        return None

    def jumps(self, body: int, at: Any) -> Sequence[Any]:
        return ()

    def across(self, start: Any, end: Any) -> Any:
        return end - start

    def place(self, body: int, front: Any, rear: Any) -> None:
        self.lefts[body], self.rights[body] = rear, front


def row_of(margin: Any, start: Any, widths: Sequence[Any], rooms: Sequence[Any]) -> Row:
    """A row from left to right; `rooms` is what is after each body beyond the margin, at the end up to the wall."""
    lefts, rights, along = [], [], start
    for width, room in zip(widths, rooms, strict=True):
        lefts.append(along)
        rights.append(along + width)
        along = along + width + margin + room
    return Row(margin, along - margin, lefts, rights)


def fulfil(rules: Rules, row: Row, ask: Ask[Any, int], answer: Callable[[Ask[Any, int]], Any]) -> Any:
    """Run a request, whose own requests are answered; return the distance moved."""
    running, granted = request(rules, row, ask.body, ask.distance, ask.spare), None
    while True:
        try:
            granted = answer(running.send(granted))
        except StopIteration as end:
            return end.value


def move(rules: Rules, row: Row, ask: Ask[Any, int]) -> Any:
    """Run a request, and those that it makes, one inside the other."""
    return fulfil(rules, row, ask, lambda further: move(rules, row, further))
