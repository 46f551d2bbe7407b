"""Numbers in files: exact ones as strings (`"3/2"`, `"-0.25"`), JSON numbers at their exact binary value."""

from __future__ import annotations

import re
from collections.abc import Iterable
from fractions import Fraction
from math import lcm
from typing import Annotated

from msgspec import Meta

from reference.world import LevelError

MOST_LONG = 400
MOST_DIGITS = 100
READABLE = 10**6
NUMBER = re.compile(r"[+-]?[0-9]+(/[0-9]+|\.[0-9]+)?")

Text = Annotated[
    str, Meta(extra_json_schema={"pattern": rf"^{NUMBER.pattern}$", "maxLength": MOST_LONG, "examples": ["3/2"]})
]
Number = Text | int | float


def exact(value: str | int | float, place: str) -> Fraction:
    """The exact value of a number in a file.

    Raises:
        LevelError: if it is no number, or has too many digits.
    """
    if isinstance(value, int) and abs(value) >= 10**MOST_LONG:
        raise LevelError(place, f"expected at most {MOST_LONG} digits")
    if isinstance(value, str):
        if len(value) > MOST_LONG:
            raise LevelError(place, f"expected at most {MOST_LONG} characters, got {len(value)}")
        if not NUMBER.fullmatch(value):
            raise LevelError(place, f'expected a number such as 2, "3/2" or "0.25", got {value!r}')
    try:
        return Fraction(value)
    except (ValueError, OverflowError, ZeroDivisionError):
        raise LevelError(place, f"expected a finite number, got {value!r}") from None


def number_text(value: Fraction | float) -> str | float:
    """A number as it stands in a file: exact ones as strings, floats as JSON numbers."""
    return str(value) if isinstance(value, Fraction) else value


def check_sums(numbers: Iterable[tuple[str, Iterable[Fraction]]]) -> None:
    """Refuse numbers, given with their places, of which the sums would not fit into a file again.

    Raises:
        LevelError: at the first that is too large or makes their least common denominator too large.
    """
    common, most = 1, 10**MOST_DIGITS
    for place, here in numbers:
        for number in here:
            above, below = number.as_integer_ratio()
            common = lcm(common, below)
            if abs(above) >= most * below:
                raise LevelError(place, f"expected numbers with at most {MOST_DIGITS} digits before the point")
            if common >= most:
                expected = f"expected numbers whose common denominator has at most {MOST_DIGITS} digits"
                raise LevelError(place, expected)


def readable(number: Fraction) -> str:
    """A number as a fraction, or as a decimal where that is shorter."""
    if number.denominator <= READABLE:
        return str(number)
    return repr(float(number)) if Fraction(float(number)) == number else f"about {float(number)!r}"
