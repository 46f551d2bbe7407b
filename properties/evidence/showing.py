"""What a piece of evidence showed, as plain data that can be stored."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from fractions import Fraction

from properties.worlds.scenes import Shape

Job = tuple[str, ...]
"""What was run: the kind of evidence, then what it is about."""

Look = tuple[str, ...]
"""The rules by which one body looks ahead once and walks: from the one of clearance to the one of walk, in order."""

Texts = dict[str, str | bool]
"""Values by name; numbers are exact, as text."""


@dataclass(frozen=True)
class Showing:
    """What one piece of evidence showed.

    Attributes:
        failures: what failed, each with what shows it; empty if everything held.
        open: what could not be decided.
        cases: paths of a proof, examples of a test, worlds of a count.
        values: those that refute a claim.
        shares: of random trials, the share that has a feature of interest, and its floor.
        promises: how many promises were judged.
        exhaustive: whether the paths were found to cover all values.
        used, unused: the premises on which the answers of the solver rest, and those without which they stand.
        witness: values that satisfy all premises on a path on which a promise was judged.
        looks: those that a path of a proof, or a random trial, went through.
        resources: the solver's work, as it counts it, for each of its seeds.
        evaluations: how often the monitors of random trials evaluated each contract.
    """

    engine: str
    seconds: float
    cases: int
    failures: dict[str, str] = field(default_factory=dict)
    open: tuple[str, ...] = ()
    rules: frozenset[str] = frozenset()
    values: Texts | None = None
    shares: dict[str, tuple[float, float]] = field(default_factory=dict)
    shape: Shape | None = None
    promises: int = 0
    exhaustive: bool = False
    used: tuple[str, ...] = ()
    unused: tuple[str, ...] = ()
    witness: Texts | None = None
    looks: frozenset[Look] = frozenset()
    resources: tuple[int, ...] = ()
    evaluations: dict[str, int] = field(default_factory=dict)

    @property
    def spread(self) -> float | None:
        """By how much the work differs between seeds, as a share of their mean; None if there is but one."""
        if len(self.resources) < 2:
            return None
        return (max(self.resources) - min(self.resources)) * len(self.resources) / sum(self.resources)


def texts(values: Mapping[str, Fraction | bool]) -> Texts:
    """Exact values as text."""
    return {name: value if isinstance(value, bool) else str(value) for name, value in values.items()}


def looks(fired: Iterable[str]) -> frozenset[Look]:
    """The looks in what one body did, in order; what it does besides, as towing its rear, is not in one."""
    found: set[Look] = set()
    look: Look = ()
    for rule in fired:
        look = (rule,) if rule.startswith("clearance/") else (*look, rule) if look else ()
        if look and rule.startswith("walk/"):
            found.add(look)
            look = ()
    return frozenset(found)
