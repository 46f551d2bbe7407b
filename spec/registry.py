"""The registry: every statement of the spec under its ID, put together from the chapters."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import chain
from typing import Protocol

from spec.alternatives import ALTERNATIVES
from spec.conditions import CONDITIONS
from spec.designs import DESIGNS
from spec.differences import DIFFERENCES
from spec.discrete import DISCRETE, DISCRETE_INVARIANTS, DISCRETE_RULES
from spec.display import DISPLAY_RULES, OF_DISPLAY
from spec.errata import ERRATA
from spec.evaluated import EVALUATED
from spec.features import FEATURES, PLANE_ORDER
from spec.guidelines import GUIDELINES
from spec.invariants import OF_ONE_REQUEST, RELATIONS
from spec.mends import MENDS
from spec.models import MODELS, OF_GRAPHS, OF_STOREYS as MODELS_OF_STOREYS
from spec.plane import IN_PLANE
from spec.profiles import PROFILES, AnyProfile
from spec.readings import OF_STOREYS, READINGS
from spec.rounding import OF_ROUNDING
from spec.rule import AnyRule, Chooser, Family
from spec.rules.request import FAMILIES, Rules
from spec.rules.step import STEP_FAMILIES
from spec.rules.velocity import VELOCITY_FAMILIES
from spec.stepped import OF_ONE_STEP, STEP_RELATIONS
from spec.unsupported import CASES, OF_CHANGES, OF_LEVELS


class Statement(Protocol):
    """Whatever has an ID: it says one thing, in one sentence, from a source."""

    @property
    def id(self) -> str:
        """The immutable ID, as in `push/request`."""

    @property
    def kind(self) -> str:
        """What it is: a rule, an invariant, a condition, a reading or a claim."""

    @property
    def sentence(self) -> str:
        """The normative sentence."""

    @property
    def source(self) -> str:
        """Sections of the thesis; rows of its register."""


def rules_of(profile: AnyProfile) -> list[AnyRule]:
    """The rules of movement of a profile, chapter by chapter."""
    names = FAMILIES if isinstance(profile.rules, Rules) else STEP_FAMILIES
    return rules_in(getattr(profile.rules, name) for name in names)


def velocity_rules_of(profile: AnyProfile) -> list[AnyRule]:
    """The rules of velocity of a profile."""
    return rules_in(getattr(profile.velocity, name) for name in VELOCITY_FAMILIES)


def rules_in(families: Iterable[Chooser]) -> list[AnyRule]:
    """The rules of some families."""
    return [rule for family in families if isinstance(family, Family) for rule in family.rules]


def text_of(profile: AnyProfile) -> list[Statement]:
    """All that one must know to implement a profile, in the order in which to read it: models, rules, readings."""
    if isinstance(profile.rules, Rules):
        readings = [one for one in READINGS if one not in OF_STOREYS]
        return [*OF_GRAPHS, *rules_of(profile), *velocity_rules_of(profile), *readings]
    return [*MODELS_OF_STOREYS, *rules_of(profile), *velocity_rules_of(profile), *OF_STOREYS]


def statements() -> dict[str, Statement]:
    """Every statement of the spec by its ID.

    Raises:
        ValueError: if two statements have the same ID.
    """
    of_profiles = [rule for one in PROFILES.values() for rule in (*rules_of(one), *velocity_rules_of(one))]
    rules = {rule.id: rule for rule in of_profiles}.values()
    chapters: tuple[Iterable[Statement], ...] = (
        PROFILES.values(),
        rules,
        MODELS,
        OF_ONE_REQUEST,
        RELATIONS,
        OF_ROUNDING,
        IN_PLANE,
        OF_ONE_STEP,
        STEP_RELATIONS,
        CONDITIONS,
        GUIDELINES,
        READINGS,
        CASES,
        OF_LEVELS,
        OF_CHANGES,
        DISPLAY_RULES,
        OF_DISPLAY,
        DESIGNS,
        (DISCRETE,),
        DISCRETE_RULES,
        DISCRETE_INVARIANTS,
        DIFFERENCES,
        ERRATA,
        MENDS,
        ALTERNATIVES,
        FEATURES,
        (PLANE_ORDER,),
        EVALUATED,
    )
    table: dict[str, Statement] = {}
    for statement in chain.from_iterable(chapters):
        if table.setdefault(statement.id, statement) is not statement:
            raise ValueError(f"two statements have the ID {statement.id}")
    return table
