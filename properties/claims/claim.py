"""What a claim is, and what can be shown for it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum
from typing import Any

from properties.contracts.errata import Stage
from properties.given import Given
from spec.conditions import Condition
from spec.invariants import Deed
from spec.number import Truth
from spec.profiles import AnyProfile


class Verdict(StrEnum):
    """What a run showed, from the strongest to the weakest; a refuted claim is settled, by a witness."""

    PROVED = "proved"
    BOUNDED = "bounded"
    TESTED = "tested"
    REFUTED = "refuted"
    UNKNOWN = "unknown"


@dataclass(frozen=True)
class Obligation:
    """Something to be proved for all values, under a profile.

    Attributes:
        needs: the IDs of the conditions it assumes, which a claim must list that rests on it.
        shape: None if it speaks of any number of bodies and edges; else the kind of string it is about.
        bodies: the number of bodies on such a string, or None for any.
        contracts: the IDs of the contracts of which it promises a clause, or lets one stand in for a call.
    """

    id: str
    program: Callable[[Any, Given], None]
    needs: tuple[str, ...] = ()
    shape: str | None = None
    bodies: int | None = None
    contracts: tuple[str, ...] = ()


@dataclass(frozen=True)
class Count:
    """An exact count over many worlds: a function that returns the number of cases, or raises AssertionError.

    `bodies` is up to how many bodies it goes through all worlds that there are, if it does.
    """

    id: str
    program: Callable[[Any], int]
    bodies: int | None = None


@dataclass(frozen=True)
class Hunt:
    """A promise about one request in any small scene; a witness against it is hunted, the smallest shapes first.

    Attributes:
        promise: of a deed and the rules that fired for its mover.
        guided: whether the scenes keep the guidelines G1 to G5.
        least_bodies, most_bodies, most_edges: the sizes of the scenes.
        premises: the conditions that hold at the start besides.
        riders: whether there are scenes in which a body stands on another.
        points: whether the bodies have no width; then nobody stands on another.
    """

    id: str
    promise: Callable[[Deed[Any], frozenset[str]], Truth]
    guided: bool
    most_bodies: int
    most_edges: int
    least_bodies: int = 1
    premises: tuple[Condition, ...] = ()
    riders: bool = True
    points: bool = False


Erratum = Callable[[Any, Given, Stage], None]


@dataclass(frozen=True)
class Claim:
    """A claim, what it is about, what is expected of it, and what is to show it.

    Attributes:
        about: the ID of the invariant or rule family.
        premises: the IDs of the conditions it assumes.
        obligations: what is to be proved; all of them, for the claim to be proved.
        sampled: the random worlds on which the property `about` is also tested, `rows` or `storeys`.
        counts: exact counts that are to come out.
        hunt: what is promised of all small scenes with ledges.
        long: whether it takes too long to be settled at every check.
        erratum: for a claim that is expected to be refuted, the promise that a witness breaks.
    """

    id: str
    family: str
    sentence: str
    source: str
    about: str
    profile: AnyProfile
    premises: tuple[str, ...]
    expected: Verdict
    obligations: tuple[Obligation, ...] = ()
    sampled: str | None = None
    counts: tuple[Count, ...] = ()
    erratum: Erratum | None = None
    hunt: Hunt | None = None
    long: bool = False

    kind = "claim"

    @property
    def contracts(self) -> list[str]:
        """The IDs of the contracts that its proofs rest on."""
        return sorted({contract for obligation in self.obligations for contract in obligation.contracts})
