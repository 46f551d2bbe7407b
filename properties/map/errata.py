"""The part of the map about errata: what each defect of the printed rules breaks, and what becomes of it mended."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from typing import Any

import msgspec

from properties.claims.claim import Verdict
from properties.handbook import slug
from properties.map.linking import claim_link, claim_of
from properties.map.part import Finding, Findings, Part
from properties.map.replay import Replay
from reference.play import LIBRARY, play, read_playable
from spec.errata import ERRATA, Erratum

HELD = (Verdict.PROVED, Verdict.BOUNDED, Verdict.TESTED)
REFUSED = "not of storeys"


def jobs() -> dict[str, Any]:
    """Nothing is searched for: the witnesses are scenarios of the library."""
    return {}


@cache
def replay_of(erratum: Erratum) -> Replay:
    """The witness of an erratum, to be played again."""
    scenario, level = read_playable(LIBRARY / "scenarios" / f"{erratum.witness}.json")
    return Replay(msgspec.structs.replace(scenario, level=level), level)


def fired_in(erratum: Erratum) -> set[str]:
    """The rules that fire in the witness of an erratum."""
    played = play(LIBRARY / "scenarios" / f"{erratum.witness}.json")
    return {rule for step in played.steps for move in step.moves for _, rule in move.fired}


def witnesses(findings: Findings) -> Mapping[str, Finding]:
    """The scenarios in which the errata are seen, each with its level."""
    return {f"erratum-{one.witness}": msgspec.to_builtins(replay_of(one).scenario) for one in ERRATA}


def section(findings: Findings) -> list[str]:
    """The section of the page: the errata that are mended, and those that are kept."""
    mended = [one for one in ERRATA if one.mended]
    kept = [one for one in ERRATA if not one.mended]
    refused = sum(replay_of(one).mended.startswith(REFUSED) for one in mended)
    return [
        f"{len(mended)} defects of the rules as printed, each with a witness. The witness is played under the printed "
        f"rules and under `repaired`: of {len(mended) - refused} witnesses `repaired` keeps what was broken, and of "
        f"{refused} it refuses the level, with the place, for it is none of storeys. Claims are linked with the "
        "verdict that `make check` or `make check-long` holds them to.",
        *(line for one in mended for line in entry(one)),
        "",
        "### Kept on purpose",
        "",
        "| erratum | what is wrong, and why it stays | source | seen in |",
        "|---|---|---|---|",
        *(f"| `{one.id}` | {one.sentence} | {one.source} | {witness_link(one)} |" for one in kept),
    ]


def entry(one: Erratum) -> Iterator[str]:
    """An erratum: printed rules, witness, mended rules, and what shows that these mend it."""
    replay, name = replay_of(one), f"erratum-{one.witness}"
    seen = [*(f"`{case}`" for case in replay.cases), *(f"`{invariant}`" for invariant in replay.broken)]
    yield from ("", f'<a id="{slug(one.id)}"></a>', "", f"### {one.id}", "", f"{one.sentence} ({one.source})", "")
    yield f"- printed: {listed(one.printed)}"
    yield f"- witness: {witness_link(one)}, under `{replay.scenario.profile}`" + (
        f"; it shows {', '.join(seen)}" if seen else ""
    )
    if one.refuted:
        yield f"- refutes: {', '.join(claim_link(name) for name in one.refuted)}"
    yield f"- mended: {listed(one.mended)}"
    yield f"- the witness under `repaired`: {replay.mended}"
    yield f"- the mend rests on: {', '.join(claim_link(name) for name in one.evidence)}"
    yield from ("", f"![{name}](map/pictures/{name}.svg)")


def listed(names: Iterable[str]) -> str:
    """Some IDs, as code."""
    return ", ".join(f"`{name}`" for name in names)


def witness_link(one: Erratum) -> str:
    """A link to a witness."""
    return f"[{one.witness}](map/witnesses/erratum-{one.witness}.json)"


def broken(findings: Findings) -> Iterator[str]:
    """What does not hold: the printed rules fire in the witness, the mend keeps it, claims are as they must be."""
    for one in ERRATA:
        replay = replay_of(one)
        if not fired_in(one) & set(one.printed) and any(not name.startswith("reading/") for name in one.printed):
            yield f"{one.id}: expected one of {listed(one.printed)} to fire in {one.witness}"
        if one.mended and replay.mended != "kept" and not replay.mended.startswith(REFUSED):
            yield f"{one.id}: {one.witness} under `repaired`: {replay.mended}"
        wrong = [name for name in one.refuted if claim_of(name).expected is not Verdict.REFUTED]
        wrong += [name for name in one.evidence if claim_of(name).expected not in HELD]
        yield from (f"{one.id}: {name} is expected to be {claim_of(name).expected}" for name in wrong)


PART = Part("errata", "Errata", jobs, section, witnesses, broken)
