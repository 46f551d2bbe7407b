"""The claim of the benchmarks as CrossHair reads it: functions on integers, with `assert` as their contract.

CrossHair takes the assertions at the beginning as premises. The rules, and the row that they run on, are those of the
other benchmarks. Annotations are evaluated, not strings, since CrossHair takes the sizes of the tuples from them.
"""

from collections.abc import Callable
from typing import Any

from benchmarks.row import move, row_of
from spec.profiles import THESIS
from spec.rules.request import Ask


def at_least(least: int, *numbers: int) -> bool:
    """Whether all numbers are at least so much."""
    return all(number >= least for number in numbers)


def keeps_margin(
    margin: int, start: int, widths: tuple[int, ...], rooms: tuple[int, ...], asked: tuple[int, ...], lacking: int
) -> bool:
    """Whether all keep the margin when the first bodies move in turn. `lacking` is as in `claim.Numbers`."""
    row = row_of(margin, start, widths, rooms)
    row.margin = margin - lacking
    for character, distance in enumerate(asked):
        move(THESIS.rules, row, Ask(character, distance, len(widths) - 1))
    return all(row.keeps(margin))


def tick(bodies: int, characters: int, lacking: int) -> Callable[..., None]:
    """The claim for so many bodies and characters."""
    each: Any = tuple[(int,) * bodies]
    each_character: Any = tuple[(int,) * characters]

    def claim(margin: int, start: int, widths: each, rooms: each, asked: each_character) -> None:
        assert at_least(1, margin, *widths)
        assert at_least(0, start, *rooms, *asked)
        assert keeps_margin(margin, start, widths, rooms, asked, lacking)

    return claim
