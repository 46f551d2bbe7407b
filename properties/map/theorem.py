"""The theorem table: which guidelines, further conditions and mended rules imply the invariants in the plane."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import partial
from itertools import combinations
from typing import Any

import msgspec

from properties.engine.survey import Breach, breaches, firsts
from properties.evidence.deeds import do
from properties.evidence.witness import step_record
from properties.given import Exact
from properties.map.part import Finding, Findings, Part
from properties.map.terrains import (
    MOVER,
    ONE,
    RIGHT,
    ZERO,
    Shape,
    any_level,
    in_guidelines,
    of_three,
    on,
    outlines,
    with_other_falls,
    with_platforms,
    with_tilted_landings,
)
from properties.map.theorem_page import section, shown
from properties.map.trails import (
    CATALOGUES,
    GUIDELINE_IDS,
    NAMES,
    at_start,
    falling,
    first_uncatalogued,
    replayed,
    trails,
)
from reference.formats.level import level_record, valid_level
from reference.formats.numbers import exact
from reference.formats.scenario import ScenarioRecord
from reference.world import World
from spec.mends import LANDING_IN_PLACE, MENDS, Mend, mended
from spec.plane import IN_PLANE
from spec.profiles import OF_REQUESTS, OVERSHOOT, THESIS, Profile

DROP, PIT = (-ONE,), (-ONE, ONE)


def of_two() -> list[Shape]:
    """One or two bodies of any widths on up to three grounds of any lengths, which keep G2, G3 and G5."""
    return in_guidelines(bodies=2, edges=3)


def of_three_bodies() -> list[Shape]:
    """Three bodies of one width on one or two long grounds."""
    return of_three(list(outlines((ZERO, ONE, -ONE), 2)))


def off_guidelines() -> list[Shape]:
    """One or two bodies of any widths on grounds of any lengths, where one of G2, G3 and G5 is broken."""
    return [*with_other_falls(2), *with_tilted_landings(2), *with_platforms(2)]


def two_at_a_drop() -> list[Shape]:
    """One or two bodies of one width at a drop or a pit of long grounds."""
    return [*on(DROP, 2, sizes=True), *on(PIT, 2, sizes=True)]


def three_at_a_drop() -> list[Shape]:
    """The same, and three bodies at a drop."""
    return [*two_at_a_drop(), *of_three([DROP])]


DOMAINS: dict[str, Callable[[], list[Shape]]] = {
    "two bodies": of_two,
    "three bodies": of_three_bodies,
    "off the guidelines": off_guidelines,
}


def surveyed(profile: Profile, mends: Sequence[Mend], domain: Callable[[], list[Shape]], name: str) -> Finding:
    """What can be broken in a domain, with which conditions at most, and the smallest witness within the guidelines."""
    rules, shapes = mended(profile, mends), domain()
    found = trails(shapes, rules)
    broken = [breach for known in breaches(found, NAMES).values() for breach in known]
    return {
        "profile": profile.name,
        "mends": [mend.id for mend in mends],
        "bodies": max(len(shape.stands) for shape in shapes),
        "shapes": len(shapes),
        "trails": len(found),
        "falling": falling(found),
        "smallest": told(firsts(found, GUIDELINE_IDS), shapes, profile, mends, f"{name}-smallest"),
        "broken": told(broken, shapes, profile, mends, name),
    }


def told(
    found: Sequence[Breach], shapes: Sequence[Shape], profile: Profile, mends: Sequence[Mend], name: str
) -> list[Finding]:
    """Breaches as data, each with a scenario that has been replayed on exact numbers."""
    return [
        breach_told(breach, shapes[breach.trail.place], profile, mends, f"{name}-{number}")
        for number, breach in enumerate(found, start=1)
    ]


def breach_told(breach: Breach, shape: Shape, profile: Profile, mends: Sequence[Mend], name: str) -> Finding:
    """What is broken, what is kept, and the scenario."""
    values, rules = breach.values(), mended(profile, mends)
    replayed(breach, shape, values, rules)
    level, asked = any_level(Exact(values), shape)
    kept, _ = facts(World(level), asked, rules)
    under = f" under {', '.join(mend.id for mend in mends)}; a file is played by the rules as printed" if mends else ""
    scenario = ScenarioRecord(
        format="graphbody/scenario@1",
        name=name,
        note=f"A witness against {breach.promise}{under}. It keeps {', '.join(kept) or 'no condition'}.",
        level=level_record(level, name),
        profile=profile.name,
        steps=[step_record((level.bodies[MOVER].name, asked))],
    )
    conditions = sorted(breach.conditions)
    return {"invariant": breach.promise, "conditions": conditions, "scenario": msgspec.to_builtins(scenario)}


def facts(world: World[Fraction], asked: Fraction, rules: Profile) -> tuple[list[str], set[str]]:
    """Which guidelines and conditions hold at a start, and which invariants the request breaks, in exact numbers."""
    kept = [name for name, holds in at_start(world, asked).items() if holds]
    deed, _ = do(rules, world, MOVER, RIGHT, asked, ZERO)
    return kept, {one.id for one in IN_PLANE if not one.holds(deed)}


def catalogued(profile: Profile, name: str) -> Finding:
    """What is broken within the guidelines though nothing happened that a catalogue of cases has."""
    shapes = three_at_a_drop()
    found = trails(shapes, profile, catalogue=True)
    missed = [breach for catalogue in CATALOGUES for breach in first_uncatalogued(found, catalogue)]
    return {
        "profile": profile.name,
        "mends": [],
        "trails": len(found),
        "broken": told(missed, shapes, profile, (), name),
    }


def sets_of_mends() -> Iterator[tuple[Mend, ...]]:
    """All sets of mends, the smallest first."""
    for count in range(len(MENDS) + 1):
        yield from combinations(MENDS, count)


def short(profile: Profile) -> str:
    """A profile's name in the name of a file."""
    return profile.name.rsplit("/", maxsplit=1)[-1]


def jobs() -> Mapping[str, Callable[[], Finding]]:
    """One survey for each profile and domain, one for each set of mends, one of the catalogue for each profile."""
    found: dict[str, Callable[[], Finding]] = {}
    for profile in (THESIS, OVERSHOOT):
        for domain, shapes in DOMAINS.items():
            name = f"theorem-{short(profile)}-{domain.replace(' ', '-')}"
            found[f"{profile.name}: {domain}"] = partial(surveyed, profile, (), shapes, name)
        found[f"{profile.name}: catalogue"] = partial(catalogued, profile, f"theorem-{short(profile)}-uncatalogued")
    for number, mends in enumerate(sets_of_mends()):
        job = " + ".join(mend.id for mend in mends) or "no mend"
        shapes = two_at_a_drop if LANDING_IN_PLACE in mends else three_at_a_drop
        found[f"mends: {job}"] = partial(surveyed, THESIS, mends, shapes, f"theorem-mends-{number}")
    return found


def witnesses(findings: Findings) -> Mapping[str, Any]:
    """The scenarios that the section shows."""
    return {entry["scenario"]["name"]: entry["scenario"] for entry in shown(findings)}


def broken(findings: Findings) -> Iterator[str]:
    """Each witness that, on exact numbers, does not keep its conditions or does not break its invariant."""
    by_id = {mend.id: mend for mend in MENDS}
    for finding in findings.values():
        rules = mended(OF_REQUESTS[finding["profile"]], [by_id[name] for name in finding["mends"]])
        for entry in [*finding.get("smallest", []), *finding["broken"]]:
            yield from contradicted(entry, rules)


def contradicted(entry: Finding, rules: Profile) -> Iterator[str]:
    """What of a witness is not as it is told."""
    scenario = msgspec.convert(entry["scenario"], ScenarioRecord)
    assert not isinstance(scenario.level, str), "the level of a witness is written out"
    request = scenario.steps[0].request
    assert request is not None, "a witness is one request"
    level = valid_level(scenario.level, "$.level")
    kept, breaks = facts(World(level), exact(request.distance, "$.steps[0].request.distance"), rules)
    if entry["invariant"] not in breaks:
        yield f"{scenario.name}: expected it to break {entry['invariant']}, got {sorted(breaks)}"
    if missing := sorted(set(entry["conditions"]) - {*kept, *CATALOGUES}):
        yield f"{scenario.name}: expected it to keep {', '.join(missing)}"


PART = Part("theorem", "Which conditions suffice", jobs, section, witnesses, broken)
