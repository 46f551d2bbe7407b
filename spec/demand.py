"""Demands: what a guideline or a condition asks at one place of a level, and whether that is met there."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from enum import Enum
from typing import Any

from spec.invariants import every
from spec.number import Truth


class Element(Enum):
    """What a level is made of. Ground edges are also counted without the fall edges between them."""

    EDGE = "edge"
    GROUND = "ground edge"
    VERTEX = "vertex"
    BODY = "body"


@dataclass(frozen=True)
class Place:
    """A place in a level: one of its elements, by its number, counted from 0."""

    element: Element
    number: int


@dataclass(frozen=True)
class Demand:
    """What is asked at a place, with the words for where it is not met.

    Attributes:
        met: whether it is met; not decided yet on symbolic numbers.
        seen: what is there; `{0}`, `{1}` and so on are the numbers, `{others}` are the other places that it is about.
        mend: what would meet it, in the same way.
    """

    place: Place
    met: Truth
    seen: str
    mend: str
    numbers: tuple[Any, ...] = ()
    others: tuple[Place, ...] = ()


def all_met(demands: Iterable[Demand]) -> Truth:
    """Whether all are met, without deciding one after another."""
    return every(demand.met for demand in demands)


def breaches(demands: Iterable[Demand]) -> list[Demand]:
    """Those that are not met, in exact numbers or in floats."""
    return [demand for demand in demands if not demand.met]
