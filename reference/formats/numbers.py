"""Numbers in files: exact ones as strings (`"3/2"`, `"-0.25"`), JSON numbers at their exact binary value."""

from __future__ import annotations

import re
from collections.abc import Iterable
from fractions import Fraction
from math import lcm
from typing import Annotated

from msgspec import Meta

from reference.formats.files import MOST_CHARACTERS
from reference.world import NumberError

MOST_DENOMINATOR = 10**1000
NUMBER = re.compile(r"[+-]?[0-9]+(/[0-9]+|\.[0-9]+)?")

Text = Annotated[
    str, Meta(extra_json_schema={"pattern": rf"^{NUMBER.pattern}$", "maxLength": MOST_CHARACTERS, "examples": ["3/2"]})
]
Number = Text | int | float


def exact(value: str | int | float, place: str) -> Fraction:
    """The exact value of a number in a file.

    Raises:
        NumberError: if it is no number, or has too many digits.
    """
    if isinstance(value, int) and abs(value) >= 10**MOST_CHARACTERS:
        raise NumberError(place, f"expected at most {MOST_CHARACTERS} digits")
    if isinstance(value, str):
        if len(value) > MOST_CHARACTERS:
            raise NumberError(place, f"expected at most {MOST_CHARACTERS} characters, got {len(value)}")
        if not NUMBER.fullmatch(value):
            raise NumberError(place, f'expected a number such as 2, "3/2" or "0.25", got {value!r}')
    try:
        return Fraction(value)
    except (ValueError, OverflowError, ZeroDivisionError):
        raise NumberError(place, f"expected a finite number, got {value!r}") from None


def number_text(value: Fraction | float) -> str | float:
    """A number as it stands in a file: exact ones as strings, floats as JSON numbers."""
    return str(value) if isinstance(value, Fraction) else value


def check_denominators(numbers: Iterable[tuple[str, Fraction]]) -> None:
    """Refuse numbers, each with its place, of which the sums would have denominators without bound.

    Raises:
        NumberError: at the first that makes their least common denominator too large.
    """
    common = 1
    for place, number in numbers:
        common = lcm(common, number.denominator)
        if common > MOST_DENOMINATOR:
            raise NumberError(place, "expected numbers whose common denominator has at most 1000 digits")
