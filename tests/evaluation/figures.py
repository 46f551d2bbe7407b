"""The figures of docs/evaluation.md, drawn from the tables of a run: the same tables make the same files."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any

import matplotlib as mpl
from matplotlib.figure import Figure

from evaluation.cases import AT_WALL, BOXES_AT_WALL, FITTED, FREE, SHOWN_FRICTION, SHOWN_SPEED, UNITY
from evaluation.finding import BOX2D, MENDED, PRINTED, REPAIRED, SCANNING, THESIS, Tables
from evaluation.gravity import GUESSES
from evaluation.tables import Line, number

STYLE = {
    "svg.hashsalt": "graphbody",
    "svg.fonttype": "none",
    "font.size": 8,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.titlesize": 8,
    "legend.frameon": False,
    "lines.linewidth": 1,
}
RIGID = {"color": "0.75", "linewidth": 4, "solid_capstyle": "round"}
OURS = {"color": "tab:blue", "linestyle": "-"}
OTHER = {"color": "tab:red", "linestyle": ":"}
NEVER = {"color": "tab:green", "linestyle": "--"}
WIDTH = 8
POINTS = "offset points"


def track(line: Line) -> tuple[list[float], list[float]]:
    """Instants and places of a track, its start included."""
    instants = [key for key in line if key[:1].isdigit()]
    return [0.0, *map(float, instants)], [0.0, *(number(line, key) for key in instants)]


def tracks(axes: Any, lines: Iterable[Line], style: dict[str, Any], label: str) -> None:
    """Draw tracks in one style, with one entry in the legend."""
    for count, line in enumerate(lines):
        axes.plot(*track(line), **style, label=label if count == 0 else None)


def slope(tables: Tables) -> Figure:
    """Figure 6.10, and how far graphbodies are from the box."""
    figure = Figure((WIDTH, 7), layout="constrained")
    grid = figure.add_gridspec(3, 3)
    slopes = sorted({run.degrees for run in FREE})
    for place, degrees in enumerate(slopes):
        axes = figure.add_subplot(grid[place // 3, place % 3])
        for engine, gravity, style in ((BOX2D, UNITY, RIGID), (PRINTED, UNITY, OURS), (PRINTED, FITTED, OTHER)):
            tracks(axes, slides(tables, engine, gravity, degrees), style, f"{engine}, g = {gravity:g}")
        axes.set_title(f"{degrees:g} degrees")
    figure.legend(*axes.get_legend_handles_labels(), loc="outside upper center", ncols=3)
    below = figure.add_subplot(grid[2, :])
    for degrees in slopes:
        (box, *_), (own, *_), (fitted, *_) = (
            slides(tables, *which, degrees) for which in ((BOX2D, UNITY), (PRINTED, UNITY), (PRINTED, FITTED))
        )
        for line, style in ((own, OURS), (fitted, OTHER)):
            below.plot(track(box)[0], [a - b for a, b in zip(track(line)[1], track(box)[1], strict=True)], **style)
        below.annotate(
            f"{degrees:g}°", (2, track(fitted)[1][-1] - track(box)[1][-1]), xytext=(3, -2), textcoords=POINTS
        )
    below.set_title("how far from the box, in metres: with g = 9.81 all on one line")
    figure.supxlabel("seconds")
    figure.supylabel("metres up the slope")
    return figure


def slides(tables: Tables, engine: str, gravity: float, degrees: float) -> list[Line]:
    """The tracks of an engine on one slope."""
    lines = tables["slope"].of(engine)
    return [line for line in lines if line["gravity"] == gravity and line["degrees"] == degrees]


def flat(tables: Tables) -> Figure:
    """Figure 6.11."""
    figure = Figure((WIDTH, 3.2), layout="constrained")
    panels = figure.subplots(1, 2)
    of_frictions, of_speeds = ("speed", SHOWN_SPEED), ("friction", SHOWN_FRICTION)
    for axes, (key, value) in zip(panels, (of_frictions, of_speeds), strict=True):
        lines = [line for line in tables["flat"].lines if line[key] == value]
        for engine, style in ((BOX2D, RIGID), (PRINTED, OURS), (MENDED, NEVER)):
            tracks(axes, [line for line in lines if line["engine"] == engine], style, engine)
        axes.set_xlabel("seconds")
    panels[0].set_title(f"(a) {SHOWN_SPEED} m/s, coefficients 0.1 (farthest) to 0.8")
    panels[1].set_title(f"(b) coefficient {SHOWN_FRICTION}, 1 to 10 m/s (farthest)")
    panels[0].set_ylabel("metres")
    panels[0].legend()
    return figure


def gravity(tables: Tables) -> Figure:
    """What gravity fits best under each guess, as far as that is near."""
    figure = Figure((WIDTH, 4), layout="constrained")
    axes = figure.subplots()
    for place, guess in enumerate(GUESSES):
        found = [number(line, "best") for line in tables["gravity"].lines if line["guess"] == guess.name]
        axes.plot([min(found), max(found)], [place, place], color="tab:blue", linewidth=3, solid_capstyle="butt")
        axes.plot(found, [place] * len(found), "|", color="black")
    for value in (UNITY, FITTED):
        axes.axvline(value, color="tab:red", linestyle=":", zorder=0)
    axes.set_yticks(range(len(GUESSES)), [guess.name for guess in GUESSES])
    axes.invert_yaxis()
    axes.set_xlim(9.4, 10.6)
    axes.set_xticks([9.4, 9.6, UNITY, FITTED, 10.2, 10.4, 10.6])
    axes.set_xlabel("gravity that fits best, in each run; what lies beyond is cut off")
    return figure


def row(tables: Tables) -> Figure:
    """Figure 7.1."""
    figure = Figure((WIDTH, 3.2), layout="constrained")
    counts, times = figure.subplots(1, 2)
    for run, style in (("edges of 5/4", OTHER), ("edges of 8", NEVER), ("one edge", OURS)):
        for axes, table, key in ((counts, "row", "work"), (times, "times", "microseconds")):
            own = [line for line in tables[table].of(THESIS) if line["run"] == run]
            axes.plot(*columns(own, "seconds", key), **style, label=run)
    counts.set_ylabel("collision queries in a tick")
    times.set_ylabel("microseconds for a tick")
    counts.legend()
    for axes in (counts, times):
        axes.set_xlabel("seconds")
    return figure


def scene(tables: Tables) -> Figure:
    """Figure 7.2."""
    figure = Figure((WIDTH, 3.2), layout="constrained")
    counts, times = figure.subplots(1, 2)
    full, at_once, kept = "full scan: bodies looked at", "repaired: choices of a rule", "in order: collision queries"
    for engine, style, label in ((SCANNING, OTHER, full), (REPAIRED, NEVER, at_once), (THESIS, OURS, kept)):
        timed = [line for line in tables["times"].of(engine) if line["run"] == "boxes in the scene"]
        for axes, lines, key in ((counts, tables["scene"].of(engine), "work"), (times, timed, "microseconds")):
            axes.plot(*columns(lines, "boxes", key), **style, label=label)
    counts.set_ylabel("work of the step after a second")
    times.set_ylabel("microseconds for it")
    counts.legend()
    for axes in (counts, times):
        axes.set_xlabel("boxes in the scene")
        axes.axvline(20, color="0.8", linestyle=":", zorder=0)
    return figure


def columns(lines: list[Line], *keys: str) -> list[list[float]]:
    """Columns of numbers."""
    return [[number(line, key) for line in lines] for key in keys]


def wall(tables: Tables) -> Figure:
    """How far boxes are thrown back at a wall."""
    figure = Figure((WIDTH, 2.8), layout="constrained")
    axes = figure.subplots()
    for (friction, speed), style in zip(AT_WALL, ("--", ":", "-."), strict=True):
        own = [line for line in tables["wall"].of(BOX2D) if (line["friction"], line["speed"]) == (friction, speed)]
        label = f"{BOX2D}, mu {friction:g}, {speed:g} m/s"
        axes.plot(*columns(own, "boxes", "back"), "o", linestyle=style, color="tab:red", markersize=3, label=label)
    axes.plot(*columns(tables["wall"].of(REPAIRED), "boxes", "back"), **OURS, label="graphbodies")
    axes.set_yscale("symlog", linthresh=10)
    axes.set_yticks([0, 10, 100, 1000, 10000], ["0", "10", "100", "1000", "10000"])
    axes.set_xlabel("boxes pushed into a wall")
    axes.set_ylabel("mm gone back in all")
    axes.set_xticks(BOXES_AT_WALL)
    axes.legend()
    return figure


FIGURES = {"slope": slope, "flat": flat, "gravity": gravity, "row": row, "scene": scene, "wall": wall}


METADATA = {"svg": {"Date": None, "Creator": None}, "png": {}}


def draw(tables: Tables, directory: Path, ending: str = "svg") -> None:
    """Draw all figures."""
    with mpl.rc_context({**mpl.rcParamsDefault, **STYLE}):
        for name, figure in FIGURES.items():
            figure(tables).savefig(directory / f"{name}.{ending}", dpi=120, metadata=METADATA[ending])
