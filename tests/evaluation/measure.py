"""All that a run measures, as tables: once of graphbodies, once of Box2D, once of both beside each other."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import partial
from itertools import islice, pairwise, product
from typing import Any

from evaluation import graphbodies
from evaluation.cases import (
    AT_WALL,
    BOX_TICKS_AT_WALL,
    BOX_TICKS_OF_PUSHING,
    BOXES_AT_WALL,
    BOXES_IN_ROW,
    BOXES_PUSHED,
    FITTED,
    FLAT,
    FREE,
    IN_SCENE,
    LAID_DOWN,
    PUSHING,
    RUBBING,
    SHOWN,
    STEEPNESS_BY,
    TICK,
    TICKS,
    TICKS_AT_WALL,
    TICKS_OF_PUSHING,
    TICKS_ON_FLAT,
    UNITY,
    Slide,
)
from evaluation.graphbodies import IN_REPAIRED, IN_THESIS, MENDED, PRINTED, VELOCITY
from evaluation.gravity import GUESSES, fit
from evaluation.tables import Engine, Line, Table, joined

Slider = Callable[[Slide, int], Sequence[float]]

NOTED, NOTED_ON_FLAT = 5, 10
"""Every how many ticks a place is noted."""

IN_A_SECOND = round(1 / TICK)

EDGES = {"one edge": Fraction(250), "edges of 8": Fraction(8), "edges of 5/4": Fraction(5, 4)}
"""On the last, boxes in contact all pass on to the next edge in the same tick."""


def sliders() -> Iterator[tuple[Engine, float, Slider]]:
    """Graphbodies that slide, with gravity."""
    for engine, gravity in ((PRINTED, UNITY), (PRINTED, FITTED), (MENDED, UNITY)):
        yield engine, gravity, partial(graphbodies.slide, VELOCITY[engine], gravity=gravity)


def about(engine: Engine, run: Slide, **values: str | float) -> Line:
    """A line about a slide."""
    return engine.line(run.name, degrees=run.degrees, friction=run.friction, speed=run.speed, **values)


def on_slopes(engine: Engine, gravity: float, slider: Slider) -> Table:
    """Where a body is, time and again, on slopes without friction (figure 6.10)."""
    return Table("slope", [track(engine, gravity, slider, run, NOTED, TICKS) for run in FREE])


def on_flat(engine: Engine, gravity: float, slider: Slider) -> Table:
    """Where a body is, time and again, on the flat (figure 6.11)."""
    return Table("flat", [track(engine, gravity, slider, run, NOTED_ON_FLAT, TICKS_ON_FLAT // 2) for run in SHOWN])


def track(engine: Engine, gravity: float, slider: Slider, run: Slide, every: int, ticks: int) -> Line:
    """Where a body is after every so many ticks."""
    places = slider(run, ticks)
    noted = {f"{tick * TICK:.1f}": places[tick - 1] for tick in range(every, ticks + 1, every)}
    return about(engine, run, gravity=gravity, **noted)


def ends(engine: Engine, slider: Slider) -> Table:
    """Where a body is in the end: on slopes with friction after two seconds, on the flat when it has stopped."""
    runs = [*((run, TICKS) for run in RUBBING), *((run, TICKS_ON_FLAT) for run in FLAT)]
    return Table("ends", [about(engine, run, end=slider(run, ticks)[-1]) for run, ticks in runs])


def holds(engine: Engine, rests: Callable[[float, float], bool]) -> Table:
    """The steepest slope on which a body at rest stays at rest (E3)."""
    lines = []
    for friction in LAID_DOWN:
        low, high = 0, round(90 / STEEPNESS_BY)
        while high - low > 1:
            middle = (low + high) // 2
            low, high = (middle, high) if rests(middle * STEEPNESS_BY, friction) else (low, middle)
        lines.append(engine.line(f"at rest, friction {friction:g}", friction=friction, degrees=low * STEEPNESS_BY))
    return Table("rest", lines)


def at_wall(
    engine: Engine, boxes: int, friction: float, speed: float, ticks: int, places: Iterator[Sequence[Any]]
) -> Line:
    """What becomes of boxes that are pushed into a wall (E6), in millimetres if a unit is 1 m.

    How far any body has gone back in all, how deep two were in one another (by a width, if one has passed the other),
    and of the last two seconds how far any body has drifted, and how much further it has gone to and fro.
    """
    rows = list(islice(places, ticks))
    ways = list(zip(*rows, strict=True))
    back = max(sum(max(before - after, 0) for before, after in pairwise(way)) for way in ways)
    overlap = max(1 - (right - left) for row in rows for left, right in pairwise(row))
    late = [way[-TICKS:] for way in ways]
    drift = max(abs(way[-1] - way[0]) for way in late)
    shake = max(sum(abs(b - a) for a, b in pairwise(way)) - abs(way[-1] - way[0]) for way in late)
    values = {"back": back, "overlap": min(max(overlap, 0), 1), "drift": drift, "shake": shake}
    in_millimetres = {name: 1000 * float(value) for name, value in values.items()}
    run = f"{boxes} boxes into a wall, friction {friction:g}, {speed:g} m/s"
    return engine.line(run, boxes=boxes, friction=friction, speed=speed, **in_millimetres)


def pushing(
    engine: Engine, boxes: int, friction: float, speed: float, ticks: int, places: Iterator[Sequence[Any]]
) -> Line:
    """The mean speed, over a second, of a character whose velocity is set in every tick (E7)."""
    way = [row[0] for row in islice(places, ticks)]
    found = float((way[-1] - way[-1 - IN_A_SECOND]) / IN_A_SECOND) / TICK
    run = f"{boxes} boxes pushed on, friction {friction:g}, {speed:g} m/s"
    return engine.line(run, boxes=boxes, friction=friction, speed=speed, mean=found)


def of_graphbodies() -> Iterator[Table]:
    """All that is measured of graphbodies."""
    for engine, gravity, slider in sliders():
        yield on_slopes(engine, gravity, slider)
        if gravity == UNITY:
            yield on_flat(engine, gravity, slider)
            yield ends(engine, slider)
    for engine, rules in VELOCITY.items():
        yield holds(engine, partial(graphbodies.rests, rules))
    yield Table("wall", list(lines_at_wall(BOXES_AT_WALL)))
    yield Table("constant", list(lines_of_pushing()))
    yield Table("row", list(lines_of_row()))
    yield Table("scene", list(lines_of_scene(IN_SCENE)))


def lines_at_wall(numbers: Iterable[int]) -> Iterator[Line]:
    """Graphbodies that are pushed into a wall."""
    for boxes, (friction, speed) in product(numbers, AT_WALL):
        for engine, game in graphbodies.games(graphbodies.before_wall(boxes, speed)).items():
            yield at_wall(engine, boxes, friction, speed, TICKS_AT_WALL, graphbodies.pushed(game))


def lines_of_pushing() -> Iterator[Line]:
    """Graphbodies that are pushed on; they have no friction while a character pushes them."""
    for boxes, (friction, speed) in product(BOXES_PUSHED, PUSHING):
        for engine, game in graphbodies.games(graphbodies.in_contact(boxes, speed)).items():
            yield pushing(engine, boxes, friction, speed, TICKS_OF_PUSHING, graphbodies.pushed(game))


def lines_of_row() -> Iterator[Line]:
    """The work of each tick while a character picks up boxes (figure 7.1)."""
    for name, edge in EDGES.items():
        for engine, game in graphbodies.games(graphbodies.picking_up(BOXES_IN_ROW, edge)).items():
            counted = COUNTED[engine]
            for tick in range(1, TICKS + 1):
                (move,) = graphbodies.tick(game)
                work = {"boxes": move.depth - 1, "work": move.work[counted]}
                yield engine.line(name, counted=counted, seconds=tick * TICK, **work)


COUNTED = {IN_THESIS: "queries", IN_REPAIRED: "choices"}
"""What is counted as work: collision queries, or choices of a rule."""


def lines_of_scene(numbers: Iterable[int]) -> Iterator[Line]:
    """The work of the movement step after a second (figure 7.2)."""
    for boxes in numbers:
        start, name = graphbodies.after_a_second(boxes), f"{boxes} boxes in the scene"
        for engine, (counted, step) in graphbodies.steps(start).items():
            pushed, work = step()
            yield engine.line(name, counted=counted, boxes=boxes, pushed=pushed, work=work)


def of_box2d() -> Iterator[Table]:
    """All that is measured of Box2D."""
    from evaluation import rigid

    yield on_slopes(rigid.BOX2D, UNITY, rigid.slide)
    yield on_flat(rigid.BOX2D, UNITY, rigid.slide)
    yield ends(rigid.BOX2D, rigid.slide)
    yield holds(rigid.BOX2D, rigid.rests)
    yield Table("wall", list(lines_of_boxes_at_wall()))
    yield Table("constant", list(lines_of_boxes_pushed()))


def lines_of_boxes_at_wall() -> Iterator[Line]:
    """Boxes of Box2D that are pushed into a wall."""
    from evaluation.rigid import BOX2D, pushed

    for boxes, (friction, speed) in product(BOXES_AT_WALL, AT_WALL):
        places = pushed(boxes, friction, speed, wall=True)
        yield at_wall(BOX2D, boxes, friction, speed, BOX_TICKS_AT_WALL, places)


def lines_of_boxes_pushed() -> Iterator[Line]:
    """Boxes of Box2D that are pushed on."""
    from evaluation.rigid import BOX2D, pushed

    for boxes, (friction, speed) in product(BOXES_PUSHED, PUSHING):
        places = pushed(boxes, friction, speed, wall=False)
        yield pushing(BOX2D, boxes, friction, speed, BOX_TICKS_OF_PUSHING, places)


def compared() -> Iterator[tuple[Slide, int, bool]]:
    """What is compared tick by tick: runs, for how many ticks, and whether the box may turn."""
    yield from ((run, TICKS, True) for run in FREE)
    yield from ((run, TICKS, turning) for run in RUBBING for turning in (True, False))
    yield from ((run, TICKS_ON_FLAT, True) for run in FLAT)


def beside(run: Slide, ticks: int, turning: bool) -> Iterator[Line]:
    """How far graphbodies are from a box of Box2D, at most."""
    from evaluation.rigid import Settings, slide

    box = slide(run, ticks, Settings(turning=turning))
    for engine, gravity, slider in sliders():
        if gravity == UNITY or run in FREE:
            furthest = max(abs(a - b) for a, b in zip(slider(run, ticks), box, strict=True))
            yield about(engine, run, gravity=gravity, turning=turning, furthest=furthest)


def of_both() -> Iterator[Table]:
    """How far graphbodies are from the boxes of Box2D, at most, and which gravity would fit best."""
    from evaluation.rigid import BOX2D, Settings, slide

    lines = [line for run, ticks, turning in compared() for line in beside(run, ticks, turning)]
    yield Table("differences", lines)
    lines = []
    for guess, run in product(GUESSES, FREE):
        settings = Settings(**guess.settings)
        found = fit(guess, run, slide(replace(run, friction=guess.rubbing), guess.ticks, settings))
        errors = {f"error at {gravity:g}": found.error(gravity) for gravity in (UNITY, FITTED)}
        values = {"best": found.best, "error": found.error(found.best), **errors}
        lines.append(about(BOX2D, run, guess=guess.name, **values))
    yield Table("gravity", lines)


def measured() -> list[Table]:
    """All tables of a run but that of times."""
    return joined([*of_graphbodies(), *of_box2d(), *of_both()])
