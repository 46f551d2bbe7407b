"""The part of the map about readings: where two of them differ, where they cannot, and what each of them keeps."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any

import msgspec

from properties.map.part import Finding, Findings, Part
from spec.alternatives import ALTERNATIVES, Alternative

THESIS, FAILS, PAGE = "thesis", "fails", "alternatives.md"


@dataclass(frozen=True)
class Unplayed:
    """A row of which another reading is not played, and why."""

    row: str
    other: str
    status: str
    reason: str


NO_DIFFERENCE, NOT_THERE = "never differs, by argument", "not played"

UNPLAYED: tuple[Unplayed, ...] = (
    Unplayed("A1", "characters first", NO_DIFFERENCE, "Only characters have a turn in a tick, in the level's order."),
    Unplayed(
        "A13",
        "a body is met at its borders only",
        NO_DIFFERENCE,
        "Of a body ahead, the border that faces the motion is met first, whichever edges lie between its borders.",
    ),
    Unplayed(
        "A17, A38",
        "velocity is lost, or cut down, by a fall or a block",
        NO_DIFFERENCE,
        "A tick sets the velocity of every character anew, and boxes have none: no move reads what is left of one.",
    ),
    Unplayed(
        "A23",
        "two supports at once",
        NOT_THERE,
        "A body is held by two borders on one string: a state has one support.",
    ),
    Unplayed(
        "A29",
        "the width of a rider on two tops changes",
        NOT_THERE,
        "Its borders would be on two strings, between which a state has no distance.",
    ),
    Unplayed("A41", "a fork", NOT_THERE, "A request does not say which of two edges to take."),
    Unplayed(
        "A42",
        "a fall edge seen from below is no wall",
        NOT_THERE,
        "No other rule for it is in the text; a body that climbs it would be raised.",
    ),
    Unplayed(
        "A43",
        "the length of an arc",
        NOT_THERE,
        "Edges are straight here; an arc has no rational length beside its chord.",
    ),
)

PROVED_ALIKE = {
    "reading/one-fall/any-number": (2, 3),
    "reading/sight/whole-string": (2, 3),
    "reading/vertex-names/next-edge": (2, 2),
}
"""The alternatives that are held beside the thesis on scenes of any sizes, up to so many bodies and edges."""


def jobs() -> Mapping[str, Callable[[], Finding]]:
    """What the thesis does with all scenes, what each alternative does, and which never differ."""
    found: dict[str, Callable[[], Finding]] = {THESIS: partial(finding, None)}
    found |= {one.id: partial(finding, one.id) for one in ALTERNATIVES}
    return found | {f"alike/{name}": partial(alike, name, *size) for name, size in PROVED_ALIKE.items()}


def alike(reading: str, bodies: int, edges: int) -> Finding:
    """What the explorer says of an alternative beside the thesis."""
    from properties.alternatives.agree import agreement

    return agreement(reading, bodies, edges)


def finding(reading: str | None) -> Finding:
    """An alternative beside the thesis, with the scenes that show it, but for those that the thesis shows alike."""
    from properties.alternatives.compare import broken_by_thesis, compared
    from properties.alternatives.scenes import scenes

    found = compared(reading)
    shown = {*found.broken.values()} | ({found.differs} if found.differs is not None else set())
    shown -= set() if reading is None else set(broken_by_thesis().values())
    return {
        "scenes": len(scenes()),
        "judged": sum(scene.judged for scene in scenes()),
        "plain": sum(scene.judged and scene.plain for scene in scenes()),
        "differing": found.differing,
        "undecided": found.undecided,
        "differs": None if found.differs is None else difference(found.differs, reading),
        "broken": dict(sorted(found.broken.items())),
        "shown": {str(number): shown_scene(number) for number in sorted(shown)},
    }


def difference(number: int, reading: str | None) -> dict[str, Any]:
    """A scene, and where bodies end in it under the thesis and under the alternative."""
    from properties.alternatives.answers import answer
    from properties.alternatives.scenes import scenes

    scene = scenes()[number]
    return {"scene": number, "thesis": answer(scene, None), "other": answer(scene, reading)}


def shown_scene(number: int) -> dict[str, Any]:
    """A scene as a document, with its size."""
    from properties.alternatives.answers import document
    from properties.alternatives.scenes import scenes

    scene = scenes()[number]
    bodies, edges, steps, _ = scene.size
    record = document(scene, witness_name(number))
    return {"bodies": bodies, "edges": edges, "steps": steps, "scenario": msgspec.to_builtins(record)}


def witness_name(number: int | str) -> str:
    """The name of the file of a scene."""
    return f"reading-scene-{number}"


def played(findings: Findings) -> dict[str, Alternative]:
    """The alternatives of which there are findings."""
    return {one.id: one for one in ALTERNATIVES if one.id in findings}


def all_shown(findings: Findings) -> dict[str, Any]:
    """All scenes that are shown, by their numbers."""
    return {number: scene for name in (THESIS, *played(findings)) for number, scene in findings[name]["shown"].items()}


def refused(findings: Findings) -> set[str]:
    """The numbers of scenes that the thesis refuses, so that nothing can be drawn of them."""
    differences = [findings[name]["differs"] for name in played(findings)]
    return {str(one["scene"]) for one in differences if one is not None and "refused" in one["thesis"]}


def witnesses(findings: Findings) -> Mapping[str, Any]:
    """The scenes to which the section links, as scenarios under the thesis."""
    said = "\n".join(section(findings))
    scenes = {witness_name(number): scene["scenario"] for number, scene in all_shown(findings).items()}
    return {name: scenario for name, scenario in scenes.items() if f"/{name}.json" in said}


def broken(findings: Findings) -> Iterator[str]:
    """Plays every scene that is shown again, under the thesis and under its alternative, in fractions."""
    from properties.alternatives.answers import replayed

    expected, shown = set(jobs()), all_shown(findings)
    yield from (f"{name}: expected a finding; run `make map`" for name in sorted(expected ^ set(findings)))
    for name in (THESIS, *played(findings)):
        yield from replayed(None if name == THESIS else name, findings[name], shown)
    yield from (f"{name}: expected readings that never differ" for name in PROVED_ALIKE if unsettled(findings, name))


def unsettled(findings: Findings, name: str) -> bool:
    """Whether it was not shown that an alternative never differs."""
    return bool(findings[f"alike/{name}"]["unsettled"])


def section(findings: Findings) -> list[str]:
    """What is said of readings: the headline, where they differ, where not, what they keep, what is not played."""
    return [
        *headline(findings),
        "",
        "### Where two readings differ",
        "",
        *differences(findings),
        "",
        "### Where none was found, or none can be played",
        "",
        *agreements(findings),
        "",
        "### What each reading keeps",
        "",
        *matrix(findings),
    ]


def invariants() -> list[str]:
    """The IDs of the invariants that are judged: of strings without ledges, and in the plane."""
    from properties.alternatives.compare import ON_STRINGS
    from spec.plane import IN_PLANE

    return [one.id for one in (*ON_STRINGS, *IN_PLANE)]


def headline(findings: Findings) -> Iterator[str]:
    """Which invariants hold under every reading, and what else is to be known of the tables."""
    thesis, others = findings[THESIS], played(findings)
    kept = [name for name in invariants() if all(name not in findings[one]["broken"] for one in (THESIS, *others))]
    told = [one for one in others if findings[one]["differs"] is not None]
    yield "Where the thesis leaves a question open, `thesis` takes one answer. Here others stand beside it, each a"
    yield "small change of the rules or of the world. All are played on the same scenes: small levels in whole numbers,"
    yield f"from one body on one edge to three bodies on two, {thesis['scenes']} in all, the smallest first: fewest"
    yield "bodies, then edges, then steps, then the least numbers. A difference that is shown is the smallest of these."
    yield ""
    yield f"- {len(told)} of {len(others)} other readings end in other places on some scene."
    yield f"- **Invariants that hold under every reading: {listed(kept)}.**"
    yield f"  This is *tested*, no proof: in {thesis['judged']} scenes of one step that keep all guidelines."
    yield "  Those of these invariants that stand before plane-apart in the table are about one string: they are judged"
    yield f"  in {thesis['plain']} scenes without ledges and riders."
    yield f"- `thesis` itself breaks {listed(list(thesis['broken']))} there."
    yield "- It keeps these, which others break: " + "; ".join(lost(findings)) + "."


def lost(findings: Findings) -> Iterator[str]:
    """Each invariant that the thesis keeps and others break, with these readings."""
    for name in invariants():
        by = [entry(one, PAGE) for one in played(findings) if name in findings[one]["broken"]]
        if by and name not in findings[THESIS]["broken"]:
            yield f"{entry(name, 'invariants.md')} (by {', '.join(by)})"


def listed(names: list[str]) -> str:
    """Invariants with links, in a sentence."""
    links = [entry(name, "invariants.md") for name in names]
    return "none" if not links else links[0] if len(links) == 1 else ", ".join(links[:-1]) + " and " + links[-1]


def entry(name: str, page: str) -> str:
    """A link to the entry of a statement in the reference."""
    return f"[{name.partition('/')[2]}](reference/{page}#{name.replace('/', '-')})"


def scene_link(number: int | str, text: str) -> str:
    """A link to the file of a scene."""
    return f"[{text}](map/witnesses/{witness_name(number)}.json)"


def differences(findings: Findings) -> Iterator[str]:
    """A row for each alternative that differs: the smallest scene, and where bodies end in it."""
    yield "Pictures show what `thesis` does. Only bodies that end in different places are named, from border to border."
    yield ""
    yield "| row | other reading | smallest difference | `thesis` | the other |"
    yield "|---|---|---|---|---|"
    for name, one in played(findings).items():
        found = findings[name]["differs"]
        if found is not None:
            ends = [ending(found[which], found) for which in ("thesis", "other")]
            yield f"| {told(one)} | {difference_link(found['scene'], findings)} | {' | '.join(ends)} |"


def told(one: Alternative) -> str:
    """The rows of an alternative and what it says, as two cells of a table."""
    return f"{rows_of(one)} | {one.sentence} ({entry(one.id, PAGE)})"


def difference_link(number: int, findings: Findings) -> str:
    """The size of a scene, with its file and its picture; the thesis refuses some, of which there are none."""
    scene = all_shown(findings)[str(number)]
    if str(number) in refused(findings):
        return size_of(scene)
    return f"{scene_link(number, size_of(scene))} ([picture](map/pictures/{witness_name(number)}.svg))"


def rows_of(one: Alternative) -> str:
    """The rows of the register that an alternative is about."""
    return ", ".join(part for part in one.source.partition("; ")[2].split(", ") if part.startswith("A"))


def size_of(scene: Mapping[str, Any]) -> str:
    """How large a scene is, in words."""
    counts = ((scene["bodies"], "body", "bodies"), (scene["edges"], "edge", "edges"), (scene["steps"], "step", "steps"))
    return ", ".join(f"{count} {name if count == 1 else names}" for count, name, names in counts)


def ending(ended: Mapping[str, Any], found: Mapping[str, Any]) -> str:
    """Where those bodies end that end in different places, from border to border in the plane."""
    if "bodies" not in ended:
        return "; ".join(f"{what}: {why}" for what, why in ended.items())
    other = [found[which].get("bodies", {}) for which in ("thesis", "other")]
    different = [name for name in ended["bodies"] if other[0].get(name) != other[1].get(name)]
    said = [f"{name} {where(ended['bodies'][name])}" for name in different]
    if other[0] and other[1] and found["thesis"]["pressed"] != found["other"]["pressed"]:
        said.append("the button is pressed" if all(ended["pressed"]) else "the button is not pressed")
    return "; ".join(said)


def where(body: Mapping[str, Any]) -> str:
    """A body's borders in the plane, and what it stands on if that is a body."""
    (x, y), (far_x, far_y) = body["plane"]
    return f"({x}, {y}) to ({far_x}, {far_y})" + ("" if body["on"] == "ground" else f" on {body['on']}")


def agreements(findings: Findings) -> Iterator[str]:
    """The alternatives that never differ, or that are not played, each with what that rests on."""
    yield "| row | other reading | | why |"
    yield "|---|---|---|---|"
    of = {one.id: one for one in ALTERNATIVES}
    for name in PROVED_ALIKE:
        found = findings[f"alike/{name}"]
        verdict = "unknown" if unsettled(findings, name) else "never differs: *bounded*"
        sizes = (
            f"up to {found['bodies']} bodies and {found['edges']} edges of any sizes, no edge shorter than the margin"
        )
        yield f"| {told(of[name])} | {verdict} | {sizes}; {found['paths']} paths |"
    for name, one in played(findings).items():
        if findings[name]["differs"] is None and name not in PROVED_ALIKE:
            yield f"| {told(one)} | unknown | no difference found in {findings[name]['scenes']} scenes |"
    for row in UNPLAYED:
        yield f"| {row.row} | {row.other} | {row.status} | {row.reason} |"


def matrix(findings: Findings) -> Iterator[str]:
    """Which invariants each reading breaks, and in how small a scene; those that are as the thesis in a list."""
    names, judged = invariants(), findings[THESIS]["judged"]
    alike = [one for one in played(findings) if breaks(findings, one) == breaks(findings, THESIS)]
    yield "`2 on 1` says: the smallest scene in which the invariant is broken has 2 bodies on 1 edge. An empty cell"
    yield "means that it held in all scenes in which it is judged (*tested*). *Differs* counts the scenes, of"
    yield f"{judged}, that end in other places than under `thesis`."
    yield ""
    yield f"| reading | differs | {' | '.join(entry(name, 'invariants.md') for name in names)} |"
    yield "|---" * (len(names) + 2) + "|"
    for one in (THESIS, *(name for name in played(findings) if name not in alike)):
        cells = [cell(findings, one, name) for name in names]
        label = "`thesis`" if one == THESIS else entry(one, PAGE)
        yield f"| {label} | {findings[one]['differing']} | {' | '.join(cells)} |"
    counted = [f"{entry(one, PAGE)} ({findings[one]['differing']})" for one in alike]
    yield from ("", f"These break what `thesis` breaks, in scenes as small: {', '.join(counted)}.")
    yield f"These keep what `thesis` breaks: {'; '.join(mended(findings))}."
    yield f"Scenes that these refuse, or on which they have no rational answer, are left out: {left_out(findings)}."
    failing = [entry(one, PAGE) for one in played(findings) if FAILS in findings[one]["broken"]]
    if failing:
        yield f"On some scene these have no rule that applies, or do not end: {', '.join(failing)}."


def left_out(findings: Findings) -> str:
    """The readings that refuse a scene, or have no rational answer, with the number of these scenes."""
    counts = {one: findings[one]["undecided"] for one in played(findings)}
    return ", ".join(f"{entry(one, PAGE)} ({count})" for one, count in counts.items() if count)


def mended(findings: Findings) -> Iterator[str]:
    """The readings that keep an invariant which the thesis breaks, each with these invariants."""
    for one in played(findings):
        kept = [name for name in findings[THESIS]["broken"] if name not in findings[one]["broken"]]
        if kept:
            yield f"{entry(one, PAGE)}: {listed(kept)}"


def breaks(findings: Findings, one: str) -> dict[str, str]:
    """The invariants that a reading breaks, each with the bodies and edges of the smallest scene."""
    shown = all_shown(findings)
    scenes = {name: shown[str(number)] for name, number in findings[one]["broken"].items()}
    return {name: f"{scene['bodies']} on {scene['edges']}" for name, scene in scenes.items()}


def cell(findings: Findings, one: str, invariant: str) -> str:
    """How many bodies and edges it takes to break an invariant, with the scene; empty if it holds."""
    number = findings[one]["broken"].get(invariant)
    return "" if number is None else scene_link(number, breaks(findings, one)[invariant])


PART = Part("readings", "Readings: what else the thesis could mean", jobs, section, witnesses, broken)
