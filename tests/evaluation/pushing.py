"""What a run says of bodies that push: figures 7.1 and 7.2, walls and constant speed (7.1.1, 7.2)."""

from __future__ import annotations

from statistics import correlation

from evaluation.cases import AT_WALL, BOX_TICKS_AT_WALL, BOXES_AT_WALL, TICK, TICKS, UNITY
from evaluation.finding import (
    BOX2D,
    REPAIRED,
    SCANNING,
    THESIS,
    Fact,
    Finding,
    Rows,
    Tables,
    digits,
    judged,
    least,
    most,
)
from evaluation.tables import Line, by, number
from spec import evaluated

SINGLE, SHORT = "one edge", "edges of 5/4"
NOT_COMPARED = "Not compared; the thesis does not do so either (7.1)."
SHAKEN = 10
"""A box that has gone back by so many millimetres, a hundredth of its width, has been shaken."""

RESTLESS, PASSED = 1, 1000
"""Millimetres to and fro of what is not at rest; the width of a box: one that deep in another has passed it."""


def of_run(tables: Tables, name: str, engine: str, run: str) -> list[Line]:
    """The lines of a table about a run of an engine."""
    return [line for line in tables[name].of(engine) if line["run"] == run]


def numbers(lines: list[Line], key: str) -> list[float]:
    """The numbers of a column."""
    return [number(line, key) for line in lines]


def linear_time(tables: Tables) -> Finding:
    """E4."""
    lines, timed = (of_run(tables, name, THESIS, SINGLE) for name in ("row", "times"))
    straight = correlation(numbers(timed, "boxes"), numbers(timed, "microseconds")) ** 2
    at_once = of_run(tables, "row", REPAIRED, SINGLE)
    return Finding(
        evaluated.LINEAR_TIME,
        judged(all(number(line, "work") == number(line, "boxes") + 1 for line in lines)),
        NOT_COMPARED,
        "Pushing k boxes on one edge takes k + 1 collision queries. `repaired` asks whomever a tick can reach, a few "
        f"times each: here it chooses a rule {least(at_once, 'work'):g} to {most(at_once, 'work'):g} times, more often "
        "where a box is met within the tick.",
        (
            "Figure 7.1 anew: a character picks up one box after another. Boxes pushed account for "
            f"{straight:.0%} of what differs in time between ticks on one edge (the square of the correlation).",
        ),
        figure=("row", "Figure 7.1: counted work, and time, of each movement step while boxes are picked up"),
    )


def spikes(tables: Tables) -> Finding:
    """E4, E13."""
    runs = {str(line["run"]): of_run(tables, "row", THESIS, str(line["run"])) for line in tables["row"].of(THESIS)}
    ratio = {run: max(number(line, "work") / (number(line, "boxes") + 1) for line in runs[run]) for run in runs}
    rows = ((run, f"{most(runs[run], 'work'):g}", f"{ratio[run]:.2f}") for run in runs)
    return Finding(
        evaluated.SPIKES,
        judged(ratio[SHORT] > 2 and ratio[SINGLE] == 1),
        NOT_COMPARED,
        "A body asks for its neighbour anew on each edge that it comes to (6.2.1). In ticks in which boxes pass on, "
        f"there are up to {ratio[SHORT]:.2f} times as many queries as bodies that move; on one edge exactly as "
        "many.",
        (
            "Bodies in contact are 5/4 apart here; on edges of that length all pass on in the same tick. The greatest "
            "number of queries in a tick, and the greatest in proportion to the bodies that move:",
        ),
        table=(("ground", "queries", "queries for each body"), *rows),
    )


def boxes_in_scene(tables: Tables) -> Finding:
    """E5."""
    scan, kept, at_once = (tables["scene"].of(engine) for engine in (SCANNING, THESIS, REPAIRED))
    square = all(number(one, "work") == (number(one, "pushed") + 1) * (number(one, "boxes") + 1) for one in scan)
    alone = all(number(one, "work") == number(one, "pushed") + 1 for one in kept)
    many = scan[-1]
    few = max((one for one in scan if one["boxes"] == one["pushed"]), key=lambda one: number(one, "boxes"))
    grows = number(many, "work") / number(few, "work")
    return Finding(
        evaluated.BOXES_IN_SCENE,
        judged(square and grows > 1),
        NOT_COMPARED,
        "A full scan, as in the thesis, looks at (k + 1)(n + 1) bodies if k of n boxes are pushed: at "
        f"{digits(grows)} times as many with {many['boxes']:g} boxes as with {few['boxes']:g}, at the same push. With "
        "neighbours kept in order, as here, it is k + 1 queries, whatever n is. `repaired` asks whomever the tick "
        f"can reach: at most {most(at_once, 'work'):g} choices of a rule, whatever n is.",
        (
            "Figure 7.2 anew: the movement step after one second, in which the character pushes 20 boxes if there "
            "are as many. It bends at 20, as in the thesis.",
        ),
        (
            Fact("E5", "full scan: (k + 1)(n + 1)", "so it is" if square else "not so", square),
            Fact("E5", "kept in order: independent of n", "k + 1" if alone else "not so", alone),
        ),
        (
            ("boxes n", "pushed k", "full scan: bodies", "in order: queries", "repaired: choices"),
            *rows_of(scan, kept, at_once),
        ),
        ("scene", "Figure 7.2: counted work, and time, of the same movement step with more boxes in the scene"),
    )


def rows_of(scan: list[Line], kept: list[Line], at_once: list[Line]) -> Rows:
    """The work of three ways, side by side."""
    columns = (
        numbers(scan, "boxes"),
        numbers(scan, "pushed"),
        *(numbers(one, "work") for one in (scan, kept, at_once)),
    )
    return tuple(tuple(f"{value:g}" for value in row) for row in zip(*columns, strict=True))


def into_wall(tables: Tables) -> Finding:
    """E6."""
    box = by(tables["wall"].of(BOX2D), "boxes", "friction", "speed")
    ours = [*tables["wall"].of(THESIS), *tables["wall"].of(REPAIRED)]
    still = all(line[key] == 0 for line in ours for key in ("back", "overlap", "drift", "shake"))
    shaken = [line for line in box.values() if number(line, "back") > SHAKEN]
    thrown = max(number(line, "back") for line in box.values() if number(line, "overlap") < PASSED)
    return Finding(
        evaluated.INTO_WALL,
        judged(len(shaken) == len(box) and still),
        f"In each of {len(box)} runs some box is thrown back by more than {SHAKEN} mm in all, by up to "
        f"{digits(thrown)} mm where all keep their order; boxes are pressed into one another, and come to rest slowly.",
        "Nobody ever goes back, is in another, or moves once the row stands: 0 mm in exact numbers, as in the thesis "
        "and `repaired`."
        if still
        else "Bodies move back, into one another, or on.",
        (
            "A character whose velocity is set in every tick pushes boxes into a wall. In mm, for boxes of 1 m: how "
            "far a box has gone **back** in all, and how **deep** two were in one another; in the last "
            f"{TICKS * TICK:g} of {BOX_TICKS_AT_WALL * TICK:g} s, how far one has **drifted**, and how much further "
            "one has gone **to and fro**. Of graphbodies all four are 0.",
            "A row of boxes is pressed together and springs apart again. Still going to and fro by more than "
            f"{RESTLESS} mm in the end: {named(box, 'shake', RESTLESS)}. Elsewhere boxes only drift, one way. "
            f"Thrown out of the row, or over another box: {named(box, 'overlap', PASSED)}.",
        ),
        facts_of_wall(box),
        rows_of_wall(box),
        ("wall", "How far boxes are thrown back that are pushed into a wall"),
    )


def named(box: dict[tuple[float, ...], Line], key: str, threshold: float) -> str:
    """The runs in which something reaches a threshold, or `none`."""
    return "; ".join(str(line["run"]) for line in box.values() if number(line, key) >= threshold) or "none"


def rows_of_wall(box: dict[tuple[float, ...], Line]) -> Rows:
    """What becomes of boxes at a wall."""
    header = ("friction", "m/s", "boxes", "back", "deep", "drifted", "to and fro")
    lines = (box[boxes, friction, speed] for friction, speed in AT_WALL for boxes in BOXES_AT_WALL)
    rows = (
        (
            *(f"{line[key]:g}" for key in ("friction", "speed", "boxes")),
            *(f"{line[key]:.1f}" for key in ("back", "overlap", "drift", "shake")),
        )
        for line in lines
    )
    return header, *rows


def facts_of_wall(box: dict[tuple[float, ...], Line]) -> tuple[Fact, ...]:
    """What was recorded of E6: how far apart the places of a box are in the last two seconds."""
    facts = []
    for boxes, recorded in ((5, 3), (20, 32)):
        lines = [box[boxes, friction, speed] for friction, speed in AT_WALL if friction]
        here = (
            f"at {one['speed']:g} m/s drift {one['drift']:.1f} mm, to and fro {one['shake']:.1f} mm" for one in lines
        )
        same = any(abs(number(one, "drift") - recorded) < 1 for one in lines)
        facts.append(Fact("E6", f"n = {boxes}: {recorded} mm of jitter", "drift " + "; ".join(here), same))
    return tuple(facts)


def constant_speed(tables: Tables) -> Finding:
    """E7."""
    box = tables["constant"].of(BOX2D)
    ours = [*tables["constant"].of(THESIS), *tables["constant"].of(REPAIRED)]
    loss = max(number(line, "speed") - number(line, "mean") for line in ours)
    rows = (
        (*(f"{number(line, key):g}" for key in ("boxes", "friction", "speed")), *told(line), f"{line['speed']:g}")
        for line in box
    )
    off = max(abs(number(line, "mean") - slowed(line)) for line in box)
    return Finding(
        evaluated.CONSTANT_SPEED,
        judged(loss == 0 and all(number(line, "mean") < number(line, "speed") for line in box)),
        "It moves at V - (n + 1) mu g dt when it pushes n boxes: what friction takes of all of them in a tick.",
        f"{loss:g} m/s are lost, in exact numbers, as in the thesis and `repaired`.",
        (
            "A character whose velocity V is set before every tick pushes n boxes on. Its mean speed over a second, "
            "in m/s:",
        ),
        (Fact("E7", "V - (n + 1) mu g dt", f"so it is, to {digits(off)} m/s", off <= 0.005),),
        (("boxes n", "mu", "V", BOX2D, "V - (n + 1) mu g dt", "graphbodies"), *rows),
    )


def told(line: Line) -> tuple[str, str]:
    """The speed of a box that pushes, and what it should be."""
    return f"{number(line, 'mean'):.4f}", f"{slowed(line):.4f}"


def slowed(line: Line) -> float:
    """The speed at which a rigid body pushes boxes, if friction slows all of them for one tick."""
    return number(line, "speed") - (number(line, "boxes") + 1) * number(line, "friction") * UNITY * TICK
