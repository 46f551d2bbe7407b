"""The part of the map about features: whether the trouble is gone without falls, collisions or width (8; E8, E15)."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import partial
from typing import Any

import msgspec

from properties.claims.features import LEFT, MOST_BODIES, MOST_EDGES, WITH_RIDERS, gone, names, order_id, promises_of
from properties.evidence.features import broken_in, record_of, shapes_of, witnesses
from properties.map.part import Finding, Findings, Part
from reference.formats.scenario import ScenarioRecord
from spec.features import PLANE_ORDER
from spec.profiles import WITHOUT

ABOUT = f"""\
Chapter 8 says that falls, collisions and width together make the difficult cases (E8). Each column switches off one
of them or two. *Gone* is a claim: the case does not happen, or the invariant holds, in all {{flat}} shapes of up to
{MOST_BODIES} bodies and {MOST_EDGES} ground edges, or a platform over the second of them, on which nobody stands on
another at the start. *Fails* is a witness. Where a cell is empty the question means nothing."""
RIDDEN = "Where bodies stand on bodies at the start, for which they need a width, this goes wrong as well:"


def jobs() -> Mapping[str, Callable[[], Finding]]:
    """For each profile the smallest witnesses of what is left, and of what goes wrong with riders."""
    flat = {name: partial(job, name, False) for name in LEFT}
    return flat | {f"{name}, riders": partial(job, name, True) for name in WITH_RIDERS}


def job(profile: str, riders: bool) -> Finding:
    """The witnesses of a profile, each with what it breaks; one that serves for several is there once."""
    table = WITH_RIDERS if riders else LEFT
    found = witnesses(WITHOUT[profile], riders, sorted(table[profile]))
    scenarios: list[Any] = []
    for witness in {id(one): one for one in found.values()}.values():
        name = f"features-{profile.replace('/', '-')}{'-riders' if riders else ''}-{len(scenarios) + 1}"
        broken = [key for key, one in found.items() if one is witness]
        record = record_of(WITHOUT[profile], witness, name)
        scenarios.append({"breaks": broken, "scenario": msgspec.to_builtins(record)})
    return scenarios


def section(findings: Findings) -> list[str]:
    """A table: what is asked against what is switched off."""
    profiles = [WITHOUT[name] for name in LEFT]
    lines = [ABOUT.format(flat=len(shapes_of(riders=False))), ""]
    lines += [f"| | {' | '.join(f'no {names(one)}' + landing(one.name) for one in profiles)} |"]
    lines += ["|---" * (len(profiles) + 1) + "|"]
    asked = list(dict.fromkeys(name for profile in profiles for name in promises_of(profile)))
    for name in asked:
        cells = [cell(findings, profile.name, name) for profile in profiles]
        lines.append(f"| [{name}]({page(name)}) | {' | '.join(cells)} |")
    return [*lines, "", *riders(findings), *order()]


def page(name: str) -> str:
    """The entry of a statement."""
    file = "levels.md" if name.startswith("unsupported/") else "invariants.md"
    return f"reference/{file}#{name.replace('/', '-')}"


def landing(profile: str) -> str:
    """What distinguishes a profile with the other landing."""
    return " (overshoot)" if profile.startswith("thesis/overshoot/") else ""


def cell(findings: Findings, profile: str, name: str) -> str:
    """What became of a question under a profile: a witness, a claim, or nothing."""
    for one in findings[profile]:
        if name in one["breaks"]:
            return linked(one)
    if name not in promises_of(WITHOUT[profile]):
        return ""
    claim = order_id(WITHOUT[profile]) if name == PLANE_ORDER.id else gone(WITHOUT[profile]).id
    return f"[gone](reference/claims.md#{claim.replace('/', '-')})"


def linked(one: Any) -> str:
    """A witness as a link, with its picture."""
    name = one["scenario"]["name"]
    return f"[fails](map/witnesses/{name}.json) ([picture](map/pictures/{name}.svg))"


def riders(findings: Findings) -> Iterator[str]:
    """What goes wrong where bodies stand on bodies at the start."""
    yield from (RIDDEN, "")
    for profile in WITH_RIDERS:
        for one in findings[f"{profile}, riders"]:
            broken = ", ".join(f"[{name}]({page(name)})" for name in one["breaks"])
            yield f"- no {names(WITHOUT[profile])}{landing(profile)}: {broken}: {linked(one)}"
    yield ""


def order() -> Iterator[str]:
    """What becomes of the order of bodies without width."""
    claim = "reference/claims.md#claim-order-without-width"
    yield f"Bodies without width keep their order (E15) if they land at the foot of a fall: [bounded]({claim})."
    yield f"If they keep their horizontal position, they do not: [refuted]({claim}-overshoot)."


def scenarios_of(findings: Findings) -> Mapping[str, Any]:
    """All witnesses, by name."""
    return {one["scenario"]["name"]: one["scenario"] for some in findings.values() for one in some}


def broken(findings: Findings) -> Iterator[str]:
    """Witnesses that do not break what they are to, and what is left to fail and has none."""
    for name in jobs():
        table = WITH_RIDERS if name.endswith(", riders") else LEFT
        missing = set(table[name.removesuffix(", riders")])
        for one in findings.get(name, ()):
            scenario = msgspec.convert(one["scenario"], ScenarioRecord)
            seen = broken_in(scenario)
            yield from (f"{scenario.name}: expected {key} to be broken" for key in one["breaks"] if key not in seen)
            missing.difference_update(one["breaks"])
        yield from (f"{name}: expected a witness against {key}" for key in sorted(missing))


PART = Part("features", "Without falls, collisions or width", jobs, section, scenarios_of, broken)
