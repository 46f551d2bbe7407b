"""The mutants of the rules: their guards, their effects, their functions, and the readings of the profiles."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import fields
from functools import cache
from typing import Any

from properties.evidence.mutants.mutant import Mutant, called, mutants_of, told_apart
from properties.evidence.mutants.operators import OF_RULES
from spec.display import DISPLAYS
from spec.profiles import OVERSHOOT, REPAIRED, THESIS
from spec.readings import LANDING, LANDING_OVERSHOOT, PUSH_LIMIT, TICK_ORDER, as_listed, number_of_bodies
from spec.rule import AnyFamily, AnyRule, Family

PUT_TOGETHER = ("Rules.through", "StepRules.through", "StepRules.row", "VelocityRules.through", "DisplayRules.through")


Effect = Callable[[Any], Any]


def families_of(*records: Any) -> list[AnyFamily]:
    """The families that records of rules list, each once."""
    listed = (getattr(record, one.name) for record in records for one in fields(record))
    return list({id(one): one for one in listed if isinstance(one, Family)}.values())


def chapters_of(*records: Any) -> list[str]:
    """The modules in which the rules of some records are written, and those that put them together."""
    rules = [rule for family in families_of(*records) for rule in family.rules]
    own = [function.__module__ for rule in rules for function in (*rule.guard, rule.effect)]
    return list(dict.fromkeys([*own, *(type(record).__module__ for record in records)]))


def reached_by(rule: AnyRule) -> frozenset[str]:
    """The functions of which one runs where a family with this rule chooses."""
    return frozenset(called(function.__code__) for function in (*rule.guard, rule.effect))


def negated(conjunct: Callable[[Any], Any]) -> Callable[[Any], bool]:
    """The opposite of a conjunct."""
    return lambda facts: not conjunct(facts)


def guard_mutants(rule: AnyRule) -> Iterator[Mutant]:
    """A rule without, and with the opposite of, each conjunct of its guard."""
    for place, conjunct in enumerate(rule.guard):
        before, after, name = rule.guard[:place], rule.guard[place + 1 :], conjunct.__name__
        yield Mutant(rule.id, f"drop {name}", rule, "guard", (*before, *after), reached_by(rule))
        turned = (*before, negated(conjunct), *after)
        yield Mutant(rule.id, f"negate {name}", rule, "guard", turned, reached_by(rule))


def effect_mutants(family: AnyFamily) -> Iterator[Mutant]:
    """Each rule of a family with each other effect of the family."""
    effects = list(dict.fromkeys(rule.effect for rule in family.rules))
    for rule in family.rules:
        for other in effects:
            if other is not rule.effect:
                change = f"{other.__name__} instead of {rule.effect.__name__}"
                yield Mutant(rule.id, change, rule, "effect", other, reached_by(rule))


def mutants_for_one(family: AnyFamily) -> Iterator[Mutant]:
    """Each rule of a family, for the first body only with another effect of the family, or with its own twice."""
    effects = [rule.effect for rule in family.rules]
    for place, rule in enumerate(family.rules):
        others = [one for one in (*effects[place:], *effects[:place]) if one is not rule.effect]
        other = others[0] if others else twice(rule.effect)
        change = f"{(others or effects)[0].__name__} {'' if others else 'twice '}for the first body"
        yield Mutant(rule.id, change, rule, "effect", for_the_first(other, rule.effect), reached_by(rule))


def twice(effect: Effect) -> Effect:
    """An effect that gives twice as much."""
    return lambda facts: effect(facts) + effect(facts)


def for_the_first(other: Effect, own: Effect) -> Effect:
    """An effect that is another one for the first body."""
    return lambda facts: other(facts) if facts.body == 0 else own(facts)


def one_less(bodies: int) -> int:
    """A push limit of one body less than there are."""
    return bodies - 1


def one_more(bodies: int) -> int:
    """A push limit of one body more than there are (A8)."""
    return bodies + 1


def last_first(names: Sequence[str]) -> Sequence[str]:
    """The level's order of bodies, reversed."""
    return names[::-1]


def reading_mutants() -> Iterator[Mutant]:
    """Each profile with another reading of each question that it decides."""
    for profile, own, other in ((THESIS, LANDING, LANDING_OVERSHOOT), (OVERSHOOT, LANDING_OVERSHOOT, LANDING)):
        change = f"{other.choice.__name__} instead of {own.choice.__name__}"
        reached = frozenset({called(own.choice.__code__)})
        yield Mutant(f"{own.id} ({profile.name})", change, profile.rules, "landing", other.choice, reached)
    limit, order = frozenset({called(number_of_bodies.__code__)}), frozenset({called(as_listed.__code__)})
    for push_limit in (one_less, one_more):
        yield Mutant(PUSH_LIMIT.id, push_limit.__name__, THESIS, "push_limit", push_limit, limit)
    yield Mutant(TICK_ORDER.id, last_first.__name__, THESIS, "tick_order", last_first, order)


@cache
def of_rules() -> dict[str, Mutant]:
    """All mutants of the rules and of the readings, by name."""
    return told_apart([*reading_mutants(), *rule_mutants(THESIS.rules)])


@cache
def of_steps() -> dict[str, Mutant]:
    """All mutants of the rules of steps, by name."""
    for_one = (mutant for family in families_of(REPAIRED.rules) for mutant in mutants_for_one(family))
    return told_apart([*rule_mutants(REPAIRED.rules), *for_one])


@cache
def of_velocities() -> dict[str, Mutant]:
    """All mutants of the rules of velocity, as printed and as mended, by name."""
    return told_apart(list(rule_mutants(THESIS.velocity, REPAIRED.velocity)))


@cache
def of_displays() -> dict[str, Mutant]:
    """All mutants of the rules of a display step, by name."""
    return told_apart(list(rule_mutants(*DISPLAYS.values())))


def rule_mutants(*records: Any) -> Iterator[Mutant]:
    """All mutants of the guards and the effects of some records of rules, and of the functions of their modules."""
    for family in families_of(*records):
        for rule in family.rules:
            yield from guard_mutants(rule)
        yield from effect_mutants(family)
    for chapter in chapters_of(*records):
        yield from mutants_of(chapter, *PUT_TOGETHER, operators=OF_RULES)
