"""The page docs/evaluation.md: thesis, engine and this specification side by side, from the tables of a run."""

from __future__ import annotations

from collections.abc import Iterator
from textwrap import fill

from evaluation.finding import Fact, Finding, Tables
from evaluation.findings import findings
from evaluation.tables import Line

INTRODUCTION = """# Evaluation

What the thesis says of its prototype beside rigid bodies, and of its cost, measured anew. `make evaluation` runs it all
and writes this page. Sections 6.3.3, 7.1.1 and 7.2 compare with Unity, whose 2D physics is Box2D. Here it is Box2D by
its Python package, with the settings of Unity: gravity 9.81, ticks of 20 ms, 8 and 3 iterations, no bounce.
Graphbodies are this specification's own: the rules of velocity as printed in figure 6.7 and as mended, and the profiles
`thesis` and `repaired`. Boxes are 1 m wide and high. They never sleep, and start at the height at which Box2D lets them
rest.

A statement is **confirmed** if it is so here, **refuted** if it is not, and **explained** if it is so for another
reason than it seems to be. `graphbody explain E1` finds the statements of a row. Every number is computed from the data
in [evaluation](evaluation), of which each line names what was run, by which engine, and by which version of it.
"""

ENDING = """## What the figures do not say

The text of the thesis does not say its inclinations, speeds, coefficients and numbers of boxes, nor the sizes of its
bodies; its figures were not measured. Unity's engine is a changed Box2D, and was not run. Times are those of one run on
one machine, in microseconds of the processor, the least of some; everything else is the same in every run on the same
machine. A computer that rounds otherwise may throw boxes otherwise.
"""


def page(tables: Tables) -> str:
    """The page."""
    found = findings(tables)
    return "\n".join(
        [INTRODUCTION, *summary(found), *(line for one in found for line in section(one)), *ending(tables)]
    )


def summary(found: list[Finding]) -> Iterator[str]:
    """Thesis, engine and specification side by side."""
    yield from table(
        ("", "the thesis says", "Box2D", "this specification", "verdict"),
        *((link(one), one.statement.sentence, one.engine, one.spec, f"**{one.judgement.value}**") for one in found),
    )


def link(one: Finding) -> str:
    """A link to the section of a finding."""
    return f"[{one.statement.id.partition('/')[2]}](#{one.statement.section})"


def table(*rows: tuple[str, ...]) -> Iterator[str]:
    """A table, its header first."""
    header, *others = rows
    for row in (header, tuple("---" for _ in header), *others):
        yield f"| {' | '.join(row)} |"
    yield ""


def section(one: Finding) -> Iterator[str]:
    """All about one statement."""
    statement = one.statement
    yield from (f'<a id="{statement.section}"></a>', "", f"## {statement.id}", "")
    yield from (wrapped(f"{statement.sentence} ({statement.source})"), "")
    yield from (f"- **verdict: {one.judgement.value}**", item(f"Box2D: {one.engine}"))
    yield from (item(f"this specification: {one.spec}"), "")
    for paragraph in one.text:
        yield from (wrapped(paragraph), "")
    if one.table:
        yield from table(*one.table)
    if one.figure is not None:
        name, says = one.figure
        yield from (f"![{says}](evaluation/{name}.svg)", "")
    if one.facts:
        yield from table(("row", "recorded before this run", "here", ""), *(fact_row(one) for one in one.facts))


def fact_row(fact: Fact) -> tuple[str, ...]:
    """A recorded fact beside that of this run."""
    return (fact.row, fact.recorded, fact.here, "the same" if fact.same else "**differs**")


def wrapped(text: str) -> str:
    """A paragraph in lines."""
    return fill(text, 120, break_long_words=False, break_on_hyphens=False)


def item(text: str) -> str:
    """An item of a list in lines."""
    return fill(text, 120, initial_indent="- ", subsequent_indent="  ", break_long_words=False, break_on_hyphens=False)


def ending(tables: Tables) -> Iterator[str]:
    """What the figures do not say, and what was run."""
    lines: list[Line] = [line for one in tables.values() for line in one.lines]
    versions = {str(line["engine"]).partition(" ")[0]: str(line["version"]) for line in lines}
    yield ENDING
    yield "Measured with " + " and ".join(f"{engine} {version}" for engine, version in sorted(versions.items())) + "."
    yield ""
