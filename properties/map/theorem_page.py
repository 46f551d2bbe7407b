"""What the page says of the theorem table: each cell is a bounded proof or a witness."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from properties.claims.claim import Verdict
from properties.claims.enough import CLAIMS, ENOUGH
from properties.claims.repaired import CLAIMS as STEPS
from properties.map.linking import claim_link
from properties.map.part import Finding, Findings
from properties.map.sets import Names, maximal, minimal, suffices, sufficient
from properties.map.trails import CATALOGUES, CONDITIONS, GUIDELINE_IDS, NAMES
from spec.conditions import (
    ALONE,
    LEDGES_CLEAR,
    NOBODY_RIDES,
    ROOMY_GROUNDS,
    SHORT_REQUESTS,
    STOREYS_START,
    TWO_AT_MOST,
)
from spec.guidelines import GUIDELINES
from spec.mends import MENDS
from spec.plane import IN_PLANE
from spec.profiles import OVERSHOOT, REPAIRED, THESIS, Profile
from spec.registry import Statement

CODES = {one.id: f"G{number}" for number, one in enumerate(GUIDELINES, start=1)}
STATIC = frozenset(GUIDELINE_IDS)
BODIES: dict[str, Names] = {
    "one body": frozenset((ALONE.id, TWO_AT_MOST.id)),
    "two bodies": frozenset((TWO_AT_MOST.id,)),
    "up to three": frozenset(),
}
CAREFUL = frozenset(one.id for one in (SHORT_REQUESTS, NOBODY_RIDES, LEDGES_CLEAR))
BOTH = (THESIS, OVERSHOOT)


def entries_of(findings: Findings, profile: Profile) -> list[Finding]:
    """What is broken under a profile without mends, in all its domains."""
    own = [finding for job, finding in findings.items() if job.startswith(f"{profile.name}: ") and "shapes" in finding]
    return [entry for finding in own for entry in all_broken(finding)]


def conditions_of(entry: Finding) -> Names:
    """The conditions that a witness keeps."""
    return frozenset(entry["conditions"])


def insufficient(entries: Iterable[Finding], invariant: str | None = None) -> list[Names]:
    """The maximal sets of conditions with which an invariant, or any, is broken."""
    return maximal(conditions_of(entry) for entry in entries if invariant in (None, entry["invariant"]))


def size(entry: Finding) -> tuple[int, int]:
    """Fewest bodies, then fewest vertices."""
    level = entry["scenario"]["level"]
    return len(level["bodies"]), len(level["vertices"])


def against(entries: Iterable[Finding], kept: Names, invariant: str | None = None) -> Finding | None:
    """The smallest witness that keeps some conditions and breaks an invariant, or any; None if there is none."""
    found = [one for one in entries if kept <= conditions_of(one) and invariant in (None, one["invariant"])]
    return min(found, key=size) if found else None


def name(one: str) -> str:
    """The name of a guideline, a condition, a mend or an invariant on the page."""
    return CODES.get(one) or f"`{one.split('/', 1)[1]}`"


def listed(names: Iterable[str]) -> str:
    """Names in the order of the legend."""
    order = (*NAMES, *(mend.id for mend in MENDS))
    return ", ".join(name(one) for one in sorted(names, key=order.index)) or "nothing"


def link(entry: Finding, text: str) -> str:
    """A link to a witness, and its picture."""
    own = entry["scenario"]["name"]
    return f"[{text}](map/witnesses/{own}.json) ([picture](map/pictures/{own}.svg))"


def table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> list[str]:
    """A table in Markdown."""
    return [f"| {' | '.join(row)} |" for row in (head, ["---"] * len(head), *rows)]


def cell(entries: Sequence[Finding], kept: Names, invariant: str) -> tuple[str, list[Finding]]:
    """That an invariant holds with some conditions, or a witness."""
    witness = against(entries, kept, invariant)
    return ("bounded", []) if witness is None else (link(witness, "broken"), [witness])


Told = tuple[list[str], list[Finding]]
"""Lines of the page, and the witnesses that they link to."""


def what_they_imply(findings: Findings) -> Told:
    """Whether G1 to G5 imply the invariants, by the number of bodies."""
    rows, used = [], []
    for invariant in IN_PLANE:
        cells = [name(invariant.id)]
        for profile in BOTH:
            entries = entries_of(findings, profile)
            for bodies in BODIES.values():
                text, witnesses = cell(entries, STATIC | bodies, invariant.id)
                cells.append(text)
                used += witnesses
        rows.append(cells)
    head = ["with G1 to G5", *(f"{profile.name}: {bodies}" for profile in BOTH for bodies in BODIES)]
    return table(head, rows), used


def needed(findings: Findings, profile: Profile, more: Names) -> Told:
    """For each guideline the invariants that hold with all five and some conditions, and are broken without it."""
    entries, lines, used = entries_of(findings, profile), [], []
    held = [one.id for one in IN_PLANE if against(entries, STATIC | more, one.id) is None]
    for guideline in GUIDELINE_IDS:
        found = [(one, against(entries, (STATIC - {guideline}) | more, one)) for one in held]
        broken = [(one, witness) for one, witness in found if witness is not None]
        lost = ", ".join(link(witness, one.split("/", 1)[1]) for one, witness in broken)
        limit = "one body" if ALONE.id in more else "two bodies"
        nothing = f"adds nothing (bounded to {limit})"
        lines.append(f"  - {CODES[guideline]} {f'is needed for {lost}' if broken else nothing}")
        used += [witness for _, witness in broken]
    return lines, used


def without_each(findings: Findings) -> Told:
    """Which guidelines are needed: alone, and with further conditions."""
    lines: list[str] = []
    used: list[Finding] = []
    for profile in BOTH:
        for text, more in (("one body", BODIES["one body"]), (f"up to three bodies, and {listed(CAREFUL)}", CAREFUL)):
            told, witnesses = needed(findings, profile, more)
            lines += [f"- `{profile.name}`, {text}:", *told]
            used += witnesses
    return lines, used


def bound(chosen: Names) -> str:
    """Up to how many bodies a set has been shown to suffice: three have one width and long grounds (G1 to G5)."""
    if ALONE.id in chosen or TWO_AT_MOST.id in chosen:
        return "1" if ALONE.id in chosen else "2"
    long = chosen | ({GUIDELINE_IDS[3]} if ROOMY_GROUNDS.id in chosen else set()) >= STATIC
    return "3" if long else "2; with G1 to G5, 3"


def in_short(findings: Findings) -> list[str]:
    """Which levels are safe under which rules: all minimal sufficient sets of guidelines and conditions."""
    rows = [
        [f"`{profile.name}`", listed(one), f"bounded, to so many bodies: {bound(one)}"]
        for profile in BOTH
        for one in sufficient(NAMES, insufficient(entries_of(findings, profile)))
    ]
    proofs = [claim_link(claim.id) for claim in STEPS if claim.expected is Verdict.PROVED and claim.sampled]
    rows.append([f"`{REPAIRED.name}`", name(STOREYS_START.id), ", ".join(proofs)])
    return table(["rules", "safe are levels and requests that keep", "shown"], rows)


def all_sets(findings: Findings) -> Told:
    """All maximal insufficient sets of guidelines and conditions."""
    lines: list[str] = []
    used: list[Finding] = []
    for profile in BOTH:
        entries = entries_of(findings, profile)
        sets = insufficient(entries)
        lines += [f"Under `{profile.name}` these do not suffice, however much is kept of the rest:", ""]
        witnesses = [(one, against(entries, one)) for one in sets]
        rows = [
            [listed(set(NAMES) - one), name(witness["invariant"]), link(witness, "witness")]
            for one, witness in witnesses
            if witness is not None
        ]
        lines += [*table(["all but", "breaks", ""], rows), ""]
        used += [witness for _, witness in witnesses if witness is not None]
    return lines, used


def of_mends(findings: Findings) -> list[tuple[Names, Finding]]:
    """Each set of mends, with what was found under it."""
    found = [finding for job, finding in findings.items() if job.startswith("mends: ")]
    return [(frozenset(finding["mends"]), finding) for finding in found]


def all_broken(finding: Finding) -> list[Finding]:
    """All witnesses of a survey."""
    return [*finding["smallest"], *finding["broken"]]


def further(names: Iterable[str]) -> list[str]:
    """What is no guideline."""
    return [one for one in names if one not in STATIC]


def mends_in_lattice(findings: Findings) -> list[Names]:
    """The minimal sufficient sets of further conditions and mends, within the guidelines."""
    return minimal(
        mends | chosen | at_most(finding, chosen)
        for mends, finding in of_mends(findings)
        for chosen in sufficient(further(NAMES), insufficient(all_broken(finding)))
    )


def at_most(finding: Finding, chosen: Names) -> Names:
    """What must be said besides where no more than two bodies were looked at."""
    return frozenset() if finding["bodies"] > 2 or ALONE.id in chosen else frozenset((TWO_AT_MOST.id,))


def with_mends(findings: Findings) -> Told:
    """What is needed beyond the guidelines, under each set of mends, and what is broken at most."""
    surveys = of_mends(findings)
    enough = mends_in_lattice(findings)
    idle = {mend.id for mend in MENDS} - frozenset().union(*enough)
    lines = ["Within G1 to G5 these conditions and mends suffice together, and none can be left out:", ""]
    rows = [[listed(one), undone_by(one, surveys)] for one in enough]
    lines += [*table(["minimal sufficient sets of conditions and mends", "does not suffice with also"], rows), ""]
    lines += [f"In none of them: {listed(idle)}.", ""]
    lines += ["These do not suffice, however much is kept of the rest:", ""]
    broken, used = [], []
    universe = frozenset((*NAMES, *(mend.id for mend in MENDS)))
    for one in maximal(mends | conditions_of(entry) for mends, found in surveys for entry in all_broken(found)):
        entries = [entry for mends, found in surveys if mends == mends_of(one) for entry in all_broken(found)]
        witness = against(entries, one - mends_of(one))
        if witness is not None:
            broken.append([listed(universe - one), name(witness["invariant"]), link(witness, "witness")])
            used.append(witness)
    return [*lines, *table(["all but", "breaks", ""], broken)], used


def undone_by(chosen: Names, surveys: Sequence[tuple[Names, Finding]]) -> str:
    """The fewest mends more under which a sufficient set does not suffice."""
    own = mends_of(chosen)
    more = [
        mends - own
        for mends, finding in surveys
        if own < mends and not suffices(chosen - own, insufficient(all_broken(finding)))
    ]
    return "; or ".join(listed(one) for one in minimal(more)) or "no mend undoes it"


def mends_of(names: Names) -> Names:
    """The mends among names."""
    return names & {mend.id for mend in MENDS}


def catalogue(findings: Findings) -> Told:
    """Whether every broken invariant is a case of the catalogue."""
    lines: list[str] = []
    used: list[Finding] = []
    for profile in BOTH:
        for cases in CATALOGUES:
            found = [one for one in findings[f"{profile.name}: catalogue"]["broken"] if cases in one["conditions"]]
            links = ", ".join(link(one, one["invariant"].split("/", 1)[1]) for one in found)
            verdict = f"broken nevertheless: {links}" if found else "they imply all invariants (bounded)"
            lines.append(f"- `{profile.name}`, G1 to G5, and {cases}: {verdict}.")
            used += found
    return lines, used


def legend() -> Iterator[str]:
    """What the names stand for."""
    statements: tuple[Statement, ...] = (*GUIDELINES, *CONDITIONS, STOREYS_START, *MENDS)
    rows = [[name(one.id), one.sentence] for one in statements]
    yield from table(["name", "sentence"], rows)


def domain(findings: Findings) -> str:
    """How much was explored."""
    shapes = sum(finding.get("shapes", 0) for finding in findings.values())
    ways = sum(finding["trails"] for finding in findings.values())
    falling = sum(finding.get("falling", 0) for finding in findings.values())
    return (
        f"{ways} ways of a request through {shapes} shapes of levels were explored, with all sizes arbitrary. On "
        f"{falling} of them a body falls while every condition holds but those on the number of bodies."
    )


def claimed() -> list[str]:
    """The claims that say the same of the scenes of the hunts, and what is proved for any number of bodies."""
    links = ", ".join(claim_link(claim.id) for claim in CLAIMS)
    fits = claim_link("claim/long-edges-fit")
    return [
        f"That the guidelines suffice with {listed(one.id for one in ENOUGH)} is claimed too, of the scenes of the "
        f"hunts: {links}. That landings fit within the guidelines holds of any number of bodies: {fits}."
    ]


def sections(findings: Findings) -> list[tuple[list[str], Told]]:
    """The paragraphs of the section, each with what introduces it."""
    return [
        (INTRODUCTION, what_they_imply(findings)),
        (NEEDED, without_each(findings)),
        ([*SETS, "", *claimed()], all_sets(findings)),
        (MENDED, with_mends(findings)),
        (CATALOGUE, catalogue(findings)),
    ]


def section(findings: Findings) -> list[str]:
    """The section of the page."""
    lines = [*SHORT, "", *in_short(findings), "", *legend(), "", *ABOUT, domain(findings)]
    for introduction, (told, _) in sections(findings):
        lines += ["", *introduction, "", *told]
    return lines


def shown(findings: Findings) -> list[Finding]:
    """The witnesses to which the section links."""
    return [entry for _, (_, used) in sections(findings) for entry in used]


SHORT = """\
### In short

Who keeps all of a line of this table is safe in the plane: after a request, bodies are the margin apart, in no terrain,
not raised, and on ground, and whoever was asked has come no further than asked. None of a line can be left out.
The guidelines alone are not enough for two bodies under `thesis`, nor for one under `thesis/overshoot`.
""".splitlines()

ABOUT = """\
### What was explored

*Bounded* means here: no way of a request breaks it, whatever the sizes, in these levels.
- One or two bodies of any widths on one, two or three grounds of any lengths, each a body height higher or lower
  than the last, or joined to it. Where three bodies are spoken of: three of one width on one or two grounds no shorter.
- Where G2 is not kept: drops, steps and pits of half or twice a body height, or with slanted fall edges. Where G3 is
  not kept: a drop onto a slope. Where G5 is not kept: a floor one body height above three joined grounds.
- All bodies are of one height. Where G2 is kept and anything can be fallen from, they are anyhow, so that G1 is about
  widths.

The first body is asked to move to the right by any distance, and moves what is in its way. It, or what carries it,
stands on the leftmost ground or on the floor above. To the left all is alike: rules see a world only in the direction
of a motion, and `claim/mirror` shows it of a string. At the start margins and terrain are kept; borders may overhang
ledges and tops. This is about one request: what is assumed of a start must hold again before the next request. What is
said of level ground, `never-raised` and `height-kept`, is not asked of slopes.
""".splitlines()

INTRODUCTION = """\
### Do the guidelines imply the invariants?

They do not, as 6.2.2 says itself: "the following list cannot guarantee that there are no complications". This is what
they do guarantee, up to so many bodies.""".splitlines()

NEEDED = """\
### Which guideline is needed, and which adds nothing?

A guideline is needed for an invariant that holds with all five and is broken in a level that keeps the other four.
This is what "it removes a lot of the unwanted cases" (6.2.2) comes to.""".splitlines()

SETS = """\
### What suffices

"This requires further exploration" (6.2.2): all sets of guidelines and further conditions, for all invariants in the
plane at once. What suffices is in the first table; these are all maximal sets that do not.""".splitlines()

MENDED = """\
### What mended rules spare

Chapter 6.2.2 names changes of the rules; here are the ones that change one decision of `thesis`. Each set of them was
explored with one or two bodies of one width at a drop and at a pit of long grounds, and three at a drop; with
`landing-in-place` with no more than two. Files and pictures are played by the rules as printed, and `make check` plays
these witnesses by the mended ones.""".splitlines()

CATALOGUE = """\
### Is the catalogue of unsupported cases complete?

If so, G1 to G5 and none of the unsupported cases imply the invariants. It was looked for at a drop and at a pit, with
up to three bodies.""".splitlines()
