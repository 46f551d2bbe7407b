"""The part of the map about unsupported cases: the smallest witness of each, and which guidelines prevent which."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from itertools import combinations
from typing import Any

from properties.map.case_search import ALL, BY_ID, GROUPS, RANK, Witness, best, from_json, look_through
from properties.map.linking import claim_link
from properties.map.part import Finding, Findings, Part
from properties.map.replay import Replay
from reference.world import World
from spec.case import Case
from spec.profiles import OVERSHOOT, THESIS, Profile
from spec.registry import statements
from spec.unsupported import CASES, OF_CHANGES, OF_LEVELS, PRINTED, LevelCase

BOTH = (THESIS, OVERSHOOT)
PROOFS = {(THESIS.name, "unsupported/landing-does-not-fit"): f", {claim_link('claim/long-edges-fit')}"}
"""What shows of any level that keeps all guidelines that a case does not happen, under a profile."""


def jobs() -> dict[str, Callable[[], Finding]]:
    """A search for each profile and each group of shapes."""
    return {
        f"{profile.name}, {group}": partial(look_through, profile.name, group) for profile in BOTH for group in GROUPS
    }


Chart = Mapping[str, Mapping[str, Sequence[Witness]]]
"""Under each profile the witnesses of each case, the simplest first."""


def chart(findings: Findings) -> Chart:
    """What was found, all groups of shapes together."""
    return {profile.name: {case.id: best(witnesses_of(findings, profile, case)) for case in CASES} for profile in BOTH}


def witnesses_of(findings: Findings, profile: Profile, case: Case) -> list[Witness]:
    """All witnesses that were found of a case under a profile."""
    return [from_json(one) for group in GROUPS for one in findings[f"{profile.name}, {group}"]["cases"][case.id]]


def that_keeps(found: Sequence[Witness], *guidelines: str) -> Witness | None:
    """The simplest witness whose level keeps some guidelines, if there is any."""
    return next((one for one in found if one.kept >= set(guidelines)), None)


def name_of(one: Witness, case: str) -> str:
    """The name of a witness: the case, the profile if it is not the first, and what its level keeps."""
    profile = one.scenario.get("profile", THESIS.name).removeprefix(THESIS.name).replace("/", "-")
    kept = "".join(rank for guideline, rank in RANK.items() if guideline in one.kept)
    return f"{case.removeprefix('unsupported/')}{profile}-{kept or 'G0'}"


def shown(found: Sequence[Witness]) -> list[Witness]:
    """The witnesses that the page shows of a case: the simplest, one that keeps all guidelines, else one for each."""
    chosen: list[Witness] = []
    for kept in ((), ALL, *((guideline,) for guideline in ALL)):
        one = that_keeps(found, *kept)
        if one is not None and that_keeps(chosen, *kept) is None:
            chosen.append(one)
    return chosen


def witnesses(findings: Findings) -> dict[str, Any]:
    """The scenarios that the page shows."""
    documents = {}
    for by_case in chart(findings).values():
        for case, found in by_case.items():
            for one in shown(found):
                documents[name_of(one, case)] = noted(one, case)
    for profile, group, number, scenario in uncatalogued(findings):
        documents[f"uncatalogued-{group}{profile}-{number}"] = scenario
    return documents


def noted(one: Witness, case: str) -> Any:
    """The scenario of a witness, with its name and a note."""
    name = name_of(one, case)
    kept = [rank for guideline, rank in RANK.items() if guideline in one.kept]
    note = f"{BY_ID[case].sentence} The level keeps {', '.join(kept) or 'no guideline'}."
    return {**one.scenario, "name": name, "note": note, "level": {**one.scenario["level"], "name": name}}


def uncatalogued(findings: Findings) -> Iterator[tuple[str, str, int, Any]]:
    """The scenarios in which an invariant is broken without a case."""
    for profile in BOTH:
        for group in GROUPS:
            scenarios = findings[f"{profile.name}, {group}"]["uncatalogued"]
            yield from ((profile.name.replace("/", "-"), group, number, one) for number, one in enumerate(scenarios))


def section(findings: Findings) -> list[str]:
    """The section of the page: what was looked through, the table of guidelines and cases, and case by case."""
    known = chart(findings)
    return [
        *introduction(findings),
        *(line for profile in BOTH for line in matrix(profile, known[profile.name])),
        *of_levels(known),
        *(line for case in CASES for line in entry(case, known)),
    ]


def introduction(findings: Findings) -> list[str]:
    """What was looked through, and whether anything was found that is none of the cases."""
    found = [findings[f"{profile.name}, {group}"] for profile in BOTH for group in GROUPS]
    shapes, paths = (sum(one[what] for one in found) for what in ("shapes", "paths"))
    lists = [
        f"- *{group}*: {(GROUPS[group].__doc__ or '').partition('.')[0].lower()} "
        f"({counted(findings[f'{THESIS.name}, {group}']['shapes'], 'shapes')})"
        for group in GROUPS
    ]
    strays = list(uncatalogued(findings))
    complete = (
        "In none of them is an invariant in the plane broken without one of these cases, `other-strings` not counted: "
        "the list of cases is complete for these shapes."
        if not strays
        else f"In {len(strays)} paths an invariant is broken and none of the cases has happened."
    )
    return [
        "A case is a predicate of a request (`graphbody explain U5`). Each was searched for in all levels of these "
        f"shapes, under both readings of the landing: {shapes} shapes and {paths} paths, with any lengths, widths, "
        "places, margin and distance. The first body is asked to move to the right; what it pushes is judged as well.",
        "",
        *lists,
        "",
        f"{complete} All ground is level here, so every witness keeps G3.",
    ]


def matrix(profile: Profile, by_case: Mapping[str, Sequence[Witness]]) -> list[str]:
    """The table of a profile: guideline by case, and which sets of guidelines prevent it."""
    safe = [case for case, found in by_case.items() if that_keeps(found, *ALL) is None]
    names, printed = ", ".join(f"`{case.removeprefix('unsupported/')}`" for case in safe), {one.id for one in PRINTED}
    return [
        "",
        f"### Which guidelines prevent which cases, under `{profile.name}` (E10)",
        "",
        f"Of {len(by_case)} cases, all five guidelines together prevent {len(safe)}: {names}. Of the {len(printed)} "
        f"that the thesis shows itself they prevent {len(printed & set(safe))}. A cell links to a small level that "
        "keeps the guideline and in which the case happens all the same; *prevented* means that there is none in all "
        "shapes above. The last column has the smallest sets of guidelines that prevent the case.",
        "",
        f"| case | {' | '.join(RANK.values())} | all five | prevented by |",
        f"|---|{'---|' * (len(RANK) + 2)}",
        *(row(profile, case, found) for case, found in by_case.items()),
    ]


def row(profile: Profile, case: str, found: Sequence[Witness]) -> str:
    """The row of a case."""
    name = case.removeprefix("unsupported/")
    cells = [cell(found, case, guideline) or "prevented" for guideline in ALL]
    last = cell(found, case, *ALL) or ("prevented" + PROOFS.get((profile.name, case), ""))
    return f"| [{name}](#{name}) | {' | '.join(cells)} | {last} | {preventing(found)} |"


def cell(found: Sequence[Witness], case: str, *guidelines: str) -> str:
    """A link to a witness that keeps some guidelines; empty if there is none."""
    one = that_keeps(shown(found), *guidelines)
    return "" if one is None else f"[happens](map/witnesses/{name_of(one, case)}.json)"


def preventing(found: Sequence[Witness]) -> str:
    """The smallest sets of guidelines that no witness keeps."""
    sets: list[frozenset[str]] = []
    for size in range(len(ALL) + 1):
        for chosen in map(frozenset, combinations(ALL, size)):
            if that_keeps(found, *chosen) is None and not any(smaller <= chosen for smaller in sets):
                sets.append(chosen)
    ranks = [" + ".join(rank for guideline, rank in RANK.items() if guideline in one) for one in sets]
    return " or ".join(ranks) or ("never happens" if not found else "none")


def of_levels(known: Chart) -> list[str]:
    """What is said of the cases that no request runs into; of a level, with the smallest witness whose level is one."""
    lines = ["", "### Cases that no request runs into", ""]
    lines += [f"- `{one.id}` ({one.source}): {one.sentence}{seen_in(one, known)}" for one in OF_LEVELS]
    return [*lines, *(f"- `{one.id}` ({one.source}): {one.sentence}" for one in OF_CHANGES)]


def seen_in(level_case: LevelCase, known: Chart) -> str:
    """The smallest witness on the page whose level is of an unsupported kind, if there is one."""
    shown_here = [(one, case) for by_case in known.values() for case, found in by_case.items() for one in shown(found)]
    for one, case in sorted(shown_here, key=lambda pair: pair[0].rank):
        if level_case.found(World(Replay.of(one.scenario).level)):
            return f" One is the level of [{name_of(one, case)}](map/witnesses/{name_of(one, case)}.json)."
    return ""


def entry(case: Case, known: Chart) -> list[str]:
    """A case: its sentence, its smallest witness with a picture, what that breaks, and what becomes of it repaired."""
    name = case.id.removeprefix("unsupported/")
    lines = ["", f'<a id="{name}"></a>', "", f"### {case.id}", "", f"{case.sentence} ({case.source})", ""]
    firsts = [that_keeps(known[profile.name][case.id]) for profile in BOTH]
    simplest = min((one for one in firsts if one is not None), key=lambda one: one.size, default=None)
    if simplest is None:
        return [*lines, "It does not happen in any of the shapes."]
    return [*lines, *told(case, simplest)]


def told(case: Case, one: Witness) -> list[str]:
    """What a witness shows."""
    replay, name = Replay.of(one.scenario), name_of(one, case.id)
    rule = statements()[replay.fault(case)]
    broken = ", ".join(f"`{name}`" for name in replay.broken) or "none in the plane"
    kept = ", ".join(rank for guideline, rank in RANK.items() if guideline in one.kept) or "none"
    return [
        f"- smallest witness: [{name}](map/witnesses/{name}.json), {counted(one.size[0], 'bodies')}, "
        f"{counted(one.size[1], 'grounds')}, "
        f"under `{replay.scenario.profile}`; it keeps {kept}",
        f"- broken: {broken}",
        f"- rule at fault: `{rule.id}`: {rule.sentence}",
        f"- under `repaired`: {replay.mended}",
        "",
        f"![{name}](map/pictures/{name}.svg)",
    ]


def counted(number: int, things: str) -> str:
    """A number of things."""
    return (
        f"{number} {things}"
        if number > 1
        else {"bodies": "one body", "grounds": "one ground", "shapes": "one shape"}[things]
    )


def broken(findings: Findings) -> Iterator[str]:
    """What does not hold when the witnesses are played again: each runs into its case and keeps its guidelines."""
    for by_case in chart(findings).values():
        for case, found in by_case.items():
            for one in shown(found):
                replay = Replay.of(one.scenario)
                if case not in replay.cases or one.kept != set(replay.kept):
                    yield f"{name_of(one, case)}: expected {case} to happen, and {sorted(one.kept)} to be kept"
    for _, group, number, _ in uncatalogued(findings):
        yield f"{group}, {number}: an invariant is broken without a case"


PART = Part("cases", "Unsupported cases", jobs, section, witnesses, broken)
