"""`python -m benchmarks.page RESULTS PAGE`: print what `make bench` has measured, and write the page about it."""

from __future__ import annotations

import json
import os
import platform
import sys
from dataclasses import dataclass
from importlib.metadata import version
from itertools import pairwise
from pathlib import Path
from statistics import geometric_mean
from textwrap import fill
from typing import Any

from rich.console import Console
from rich.table import Table

from benchmarks.other import MOST_SECONDS
from benchmarks.rigid import ENOUGH
from benchmarks.steps import IN_BATCH, Pushed

AIM = 500
MOST_SECONDS_OF_CHECK = 20
CORES_OF_CHECK = 2
CLAIMS = {True: "one character", False: "all are characters"}
OURS = ("paths", "merged", "contract")
STEPPED = ("exact", "float", "one level", "batch", "Box2D")
PUSHING = ("exact", "float", "one level anew", "one level", "batch anew", "batch", "Box2D", "Box2D pushing")
OTHERS = ("Box2D", "Box2D pushing")
BATCH_AIM, FLOAT_AIM, LOG_AIM = 50, 0.5, 0.5


@dataclass(frozen=True)
class Measured:
    """A benchmark: what it was about, what it concluded, and the median of its seconds."""

    group: str
    about: dict[str, Any]
    seconds: float

    @property
    def one(self) -> bool:
        """Whether one character moves, not all bodies."""
        return bool(self.about["characters"] == 1)


@dataclass(frozen=True)
class Figures:
    """A table and what it shows."""

    title: str
    text: str
    header: tuple[str, ...]
    rows: list[tuple[str, ...]]

    def markdown(self) -> str:
        """The table and its text as a section of a page."""
        lines = [self.header, tuple("---" for _ in self.header), *self.rows]
        table = "\n".join(f"| {' | '.join(line)} |" for line in lines)
        return f"## {self.title}\n\n{fill(self.text, 120)}\n\n{table}\n"

    def show(self, console: Console) -> None:
        """Print the table."""
        table = Table(*self.header, title=self.title, title_justify="left")
        for row in self.rows:
            table.add_row(*row)
        console.print(table)


def read(path: Path) -> list[Measured]:
    """The benchmarks of a run."""
    found = json.loads(path.read_text())["benchmarks"]
    return [
        Measured(item["group"], item["extra_info"], item["extra_info"].get("seconds", item["stats"]["median"]))
        for item in found
    ]


def number(value: float) -> str:
    """A number with two digits that count."""
    return f"{value:.0f}" if value >= 10 else f"{value:.2g}"


Sizes = tuple[int, bool]


def sizes(measured: list[Measured], group: str, lacking: int) -> dict[Sizes, dict[str, Measured]]:
    """The benchmarks of a group by number of bodies and characters, and by way."""
    found: dict[Sizes, dict[str, Measured]] = {}
    for item in measured:
        if item.group == group and item.about["lacking"] == lacking:
            found.setdefault((item.about["bodies"], item.one), {})[item.about["way"]] = item
    return dict(sorted(found.items(), key=lambda entry: (not entry[0][1], entry[0][0])))


def beside(measured: list[Measured], lacking: int) -> list[tuple[str, ...]]:
    """A row for each size: what CrossHair concluded, and what each of our ways did beside it."""
    rows = []
    for (bodies, one), ways in sizes(measured, "beside", lacking).items():
        other = ways["crosshair"]
        ours = (f"{ways[way].about['verdict']}, {times(ways[way], other)}" for way in OURS)
        rows.append((CLAIMS[one], str(bodies), other.about["verdict"], *ours))
    return rows


def times(ours: Measured, other: Measured) -> str:
    """How many times faster than CrossHair, which may not have come to an end."""
    at_least = "at least " if other.about["verdict"] == "not confirmed" else ""
    return f"{at_least}×{number(other.seconds / ours.seconds)}"


def aimed(way: str, ours: Measured, other: Measured) -> str:
    """Whether a way is as much faster as is the aim."""
    reaches = "reaches" if other.seconds / ours.seconds >= AIM else "falls short of"
    return f"{way} {reaches} it ({times(ours, other)})"


def ratios(measured: list[Measured]) -> Figures:
    """How many times faster than CrossHair the claim is proved."""
    header = ("a tick of a row", "bodies", "CrossHair", *OURS)
    ways = sizes(measured, "beside", 0)[4, False]
    judged = ", ".join(aimed(way, ways[way], ways["crosshair"]) for way in OURS)
    text = f"The aim is ×{AIM} at 4 bodies that are all characters: {judged}."
    return Figures("How many times faster than CrossHair", text, header, beside(measured, 0))


def refutations(measured: list[Measured]) -> Figures:
    """How many times faster than CrossHair the wrong claim is refuted."""
    text = "The rules take the margin to be 1 less than what is claimed to be kept."
    header = ("a tick of a row", "bodies", "CrossHair", *OURS)
    return Figures("A claim that is off by one", text, header, beside(measured, 1))


def series(measured: list[Measured]) -> dict[tuple[str, bool], list[Measured]]:
    """The growing sizes of each way, of one character and of all."""
    found: dict[tuple[str, bool], list[Measured]] = {}
    for item in measured:
        if item.group == "growth":
            found.setdefault((item.about["way"], item.one), []).append(item)
    return found


def growth(measured: list[Measured]) -> Figures:
    """By what factor the time grows with each body."""
    rows = []
    for (way, one), items in series(measured).items():
        factors = [later.seconds / item.seconds for item, later in pairwise(items)]
        claimed = "any number of bodies and characters" if way == "contract" else CLAIMS[one]
        shown = " ".join(f"×{number(factor)}" for factor in factors)
        rows.append((way, claimed, f"2 to {items[-1].about['bodies']}", shown, f"×{number(geometric_mean(factors))}"))
    text = (
        "On real numbers. Each factor is that of one body more. The contract does not know how many there are: its "
        "factors show how steady the measurement is."
    )
    return Figures("How time grows with bodies", text, ("way", "a tick of a row", "bodies", "factors", "mean"), rows)


def effort(item: Measured) -> str:
    """Seconds and paths."""
    return f"{number(item.seconds)} s, {item.about['paths']} paths"


def seconds_beside(measured: list[Measured]) -> Figures:
    """The seconds behind the ratios."""
    header = ("a tick of a row", "bodies", "CrossHair", *OURS)
    rows = [
        (CLAIMS[one], str(bodies), *(effort(ways[way]) for way in ("crosshair", *OURS)))
        for (bodies, one), ways in sizes(measured, "beside", 0).items()
    ]
    return Figures("Seconds beside CrossHair", "On whole numbers, the claim that holds.", header, rows)


def seconds_of_growth(measured: list[Measured]) -> Figures:
    """The seconds behind the growth."""
    rows = []
    for (way, one), items in series(measured).items():
        claimed = "any number" if way == "contract" else CLAIMS[one]
        rows += [(way, claimed, str(item.about["bodies"]), effort(item), str(item.about["checks"])) for item in items]
    header = ("way", "a tick of a row", "bodies", "effort", "calls of the solver")
    return Figures("Seconds with more bodies", "On real numbers.", header, rows)


def obligations(measured: list[Measured]) -> Figures:
    """How fast the obligations of `make check` are proved."""
    (item,) = (item for item in measured if item.group == "obligations")
    count, share = item.about["obligations"], item.seconds / CORES_OF_CHECK
    within = "within" if share <= MOST_SECONDS_OF_CHECK else "more than"
    text = (
        f"All obligations of `make check`, each once, in one process. Shared evenly among {CORES_OF_CHECK} cores they "
        f"take {number(share)} s, {within} the {MOST_SECONDS_OF_CHECK} s that are the aim."
    )
    header = ("obligations", "proved", "a second", "seconds", "paths", "calls of the solver")
    values = (count, item.about["proved"], number(count / item.seconds), number(item.seconds))
    rows = [(*map(str, values), str(item.about["paths"]), str(item.about["checks"]))]
    return Figures("Obligations per second", text, header, rows)


def micro(item: Measured, bodies: int = 1) -> float:
    """Microseconds per step, or per step and body."""
    return item.seconds / item.about["steps"] / bodies * 1e6


def by_way(measured: list[Measured], group: str, *keys: str) -> dict[tuple[Any, ...], dict[str, Measured]]:
    """The benchmarks of a group by what they are about, and by way."""
    found: dict[tuple[Any, ...], dict[str, Measured]] = {}
    for item in measured:
        if item.group == group:
            found.setdefault(tuple(item.about[key] for key in keys), {})[item.about["way"]] = item
    return found


def faster(ways: dict[str, Measured], way: str, other: str) -> float:
    """How many times faster a way is than another."""
    return micro(ways[other]) / micro(ways[way])


def judged(scenes: list[dict[str, Measured]], way: str, other: str, least: float) -> str:
    """Whether a way is so many times as fast as another in all scenes, and how fast it is."""
    factors = [faster(ways, way, other) for ways in scenes]
    reached = sum(factor >= least for factor in factors)
    verdict = "reaches it in all" if reached == len(factors) else f"falls short of it in {len(factors) - reached}"
    return f"{way} {verdict} of {len(factors)} scenes (×{number(min(factors))} to ×{number(max(factors))})"


def steps_beside(measured: list[Measured]) -> Figures:
    """How long a step takes, beside Box2D."""
    scenes = by_way(measured, "steps", "kind", "bodies")
    rows = [
        (kind, str(bodies), *(number(micro(ways[way], bodies)) for way in PUSHING), str(ways["exact"].about["choices"]))
        for (kind, bodies), ways in scenes.items()
    ]
    text = (
        "Microseconds for each body and step. Where all is looked at *anew* in each tick, speeds change from tick to "
        "tick; else a level is looked at again only when something may come."
    )
    return Figures("Steps beside Box2D", text, ("scene", "bodies", *PUSHING, "choices of a rule"), rows)


def times_of_box2d(measured: list[Measured]) -> Figures:
    """How many times faster than Box2D, as it comes and where the bodies come as far as here."""
    scenes = by_way(measured, "steps", "kind", "bodies")
    aims = (("float", FLOAT_AIM), ("one level", FLOAT_AIM), ("batch anew", BATCH_AIM), ("batch", BATCH_AIM))
    rows = []
    for (kind, bodies), ways in scenes.items():
        factors = (f"×{number(faster(ways, way, other))}" for other in OTHERS for way, _ in aims)
        comes = (came(ways[other]) for other in ("Box2D", "Box2D iterating", "Box2D pushing"))
        rows.append((kind, str(bodies), *factors, *comes))
    several = list(scenes.values())
    told = (f"beside {other}, {', '.join(judged(several, way, other, aim) for way, aim in aims)}" for other in OTHERS)
    text = (
        f"How many times faster. The aim of a batch is ×{BATCH_AIM}, that in floats ×{FLOAT_AIM}, which is twice the "
        f"time: {'; '.join(told)}. How far the last body comes in Box2D is told as a part of what the first is "
        "driven; here it is all of it. As Box2D comes, the first box shares its speed with those that it pushes, and "
        "friction takes the rest; where it is *iterating*, its solver has more iterations, which do not mend that. "
        "Where it is *pushing*, nothing holds the first box back, all begin pressed together, and there are as many "
        "iterations for velocities as are told, from Unity's, each time doubled, up to those where it is iterating, "
        f"until the last box comes {ENOUGH:.0%} as far in {Pushed('row', 1).ticks} ticks (of 1,000 boxes "
        f"{Pushed('row', 1000).ticks})."
    )
    header = ("scene", "bodies", *(f"{way} / {other}" for other in OTHERS for way, _ in aims))
    return Figures("Times of Box2D", text, (*header, "comes", "comes iterating", "comes pushing"), rows)


def came(item: Measured) -> str:
    """How far the last body came, and with how many iterations."""
    return f"{item.about['come']:.0%} with {item.about['iterations']}"


def beside_others(measured: list[Measured]) -> Figures:
    """How long a step takes with more and more who stand by."""
    scenes = by_way(measured, "standing by", "standing_by")
    rows = [
        (f"{by:,}", *(number(micro(ways[way])) for way in STEPPED), str(ways["exact"].about["choices"]))
        for (by,), ways in scenes.items()
    ]
    counts = {ways[way].about["choices"] for ways in scenes.values() for way in ("exact", "float")}
    few, many = scenes[min(scenes)], scenes[max(scenes)]
    grown = ", ".join(f"{way} ×{number(micro(many[way]) / micro(few[way]))}" for way in STEPPED)
    text = (
        "Microseconds for each step of a row of ten. The aim is a cost independent of what is not touched. As counted, "
        f"the rules {'reach' if len(counts) == 1 else 'fall short of'} it; in time, the greatest scene takes, of what "
        f"the smallest does: {grown}. A batch steps all bodies of its levels."
    )
    header = ("standing by", *STEPPED, "choices of a rule")
    return Figures("Steps beside others who stand by", text, header, rows)


def closed_forms(measured: list[Measured]) -> Figures:
    """In how many steps of a batch there is a closed form."""
    (random,) = (item for item in measured if item.group == "random levels")
    pushed = min(item.about["share"] for item in measured if item.group != "random levels" and "share" in item.about)
    rows = [("rows and stacks", f"{pushed:.0%}"), ("random levels", f"{random.about['share']:.0%}")]
    text = (
        "All other steps of a batch go from event to event, or on as they do while none comes. Random levels are lines "
        "of up to eight bodies, with pits and riders, where any number of bodies is driven, to both sides. A batch of "
        "them takes "
        f"{number(micro(random))} microseconds a step."
    )
    return Figures("How often a batch has a closed form", text, ("levels", "steps with a closed form"), rows)


def logs(measured: list[Measured]) -> Figures:
    """How fast a log is validated whose steps have a closed form, beside the parser of Python."""
    found = by_way(measured, "logs", "bare")
    rows, shares = [], []
    for (bare,), ways in found.items():
        ours, other = ways["validate"], ways["json"]
        shares.append(micro(other) / micro(ours))
        name = "places of bodies only" if bare else "all that a line may say"
        rows.append((name, number(micro(ours)), number(micro(other)), f"×{number(shares[-1])}"))
    reaches = "reaches" if min(shares) >= LOG_AIM else "falls short of"
    text = (
        "Microseconds for each line of a log in floats, of 4,000 ticks in which a character pushes four boxes to the "
        f"right and to the left. The aim is ×{LOG_AIM} of the speed at which Python's json module parses its text: "
        f"validation {reaches} it. A log whose steps have no closed form is judged line by line, and takes much longer."
    )
    return Figures("Validation of a log in closed form", text, ("lines", "validate", "json", "times"), rows)


INTRODUCTION = """# Benchmarks

`make bench` writes this page. All of it is measured in one run, in seconds of the processor, without start-up; of three
rounds the median counts, of steps that of five; of CrossHair and of the obligations there is one round.

The claim is about a tick of a row on one level edge, between walls: all keep the margin. In a tick either the first
body is a character and moves, or all bodies are and move in turn, each at a speed of its own. The sizes of bodies, the
room between them and their speeds are arbitrary. The rules' own code runs on a small row
([tests/benchmarks/row.py](../tests/benchmarks/row.py)), the same for us and for CrossHair:

- **paths**: one run for each way in which the tick can go.
- **merged**: at the end of each body's move, one path goes on
  ([properties/engine/merge.py](../properties/engine/merge.py)).
- **contract**: one request of one body, its neighbour by contract. It is a proof for any number of bodies and ticks, by
  the induction in [proofs.md](proofs.md); the others prove the size at hand.
- **simulator**: paths too, but the reference simulator runs, with all that it looks up and records.
- **CrossHair**: the contract is an `assert` of a function on integers; it may explore all paths, for {most} s at most.

Steps of `repaired` are timed beside those of Box2D: rows in contact of which the first is driven, and stacks of which
the lowest is ([tests/benchmarks/steps.py](../tests/benchmarks/steps.py)):

- **exact**, **float**: the rules, from event to event, in fractions and in floats, on those whom the step can reach.
- **one level**, **batch**: the closed form ([reference/batch.py](../reference/batch.py)) of one level, and of as many
  as have {batch} bodies, in floats.
- **Box2D**: the same boxes, through its Python binding, with its settings in Unity; the first has its speed set in
  each tick. Where it is **pushing**, nothing holds the first back, and the solver has more iterations.
"""

ENDING = """## What the figures do not say

CrossHair runs any Python and searches for bugs; it was not made to prove. Its symbolic integers stand in for those of
Python at each operation, ours are made for sums and comparisons only. The claim is on one edge; with more edges there
is more to tell apart. The proofs of `make check` are of rows on any string with ledges, so they take longer than the
contract here. With one character there are few paths, and neither merging nor the contract gains much on them; a wrong
claim is broken on the first path, so merging only delays it. Figures of other runs differ by about a third.

Box2D solves forces, friction and momentum, of which a step here has none; what comes of it is not the same, as the last
columns of its table tell. Its boxes sleep where they rest, so in a long row all but the first ones cost little; pushed,
they do not. Its time grows with contacts, ours with bodies. It is a compiled program, called once a step;
the rules run in Python, each choice of one being a few calls, and tell who moved by which of them. Closed forms do not.

Measured with {versions}, on {cores} cores.
"""


def versions() -> str:
    """What the figures depend on."""
    packages = ("z3-solver", "crosshair-tool", "numpy", "box2d", "pytest-benchmark")
    return ", ".join([f"Python {platform.python_version()}", *(f"{name} {version(name)}" for name in packages)])


def page(figures: list[Figures]) -> str:
    """The page."""
    sections = [item.markdown() for item in figures]
    ending = ENDING.format(versions=versions(), cores=os.cpu_count())
    return "\n".join([INTRODUCTION.format(most=MOST_SECONDS, batch=IN_BATCH), *sections, ending])


def main(results: Path, target: Path) -> None:
    """Print the tables, and write the page."""
    measured = read(results)
    proofs = (ratios, refutations, growth, obligations)
    makers = (
        *proofs,
        steps_beside,
        times_of_box2d,
        beside_others,
        closed_forms,
        logs,
        seconds_beside,
        seconds_of_growth,
    )
    figures = [maker(measured) for maker in makers]
    for item in figures:
        item.show(Console())
    target.write_text(page(figures))


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
