"""How long movement steps take: the only thing here that is not the same in every run."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import product
from time import process_time_ns
from typing import TypeVar

from evaluation import graphbodies
from evaluation.cases import BOXES_IN_ROW, IN_SCENE, TICK, TICKS
from evaluation.graphbodies import IN_THESIS
from evaluation.measure import EDGES
from evaluation.tables import Engine, Line, Table

TIMED = 9
"""How often what is timed is run; the least time counts, with which nothing else has interfered."""

Done = TypeVar("Done")


def times() -> Table:
    """How long movement steps take, in microseconds of the processor: the least of some runs (figures 7.1 and 7.2)."""
    lines = [*times_of_row(), *times_of_scene()]
    return Table("times", lines)


def times_of_row() -> Iterator[Line]:
    """The time of each tick while a character picks up boxes, one after another."""
    for name in ("one edge", "edges of 5/4"):
        start = graphbodies.picking_up(BOXES_IN_ROW, EDGES[name])
        played = [times_of_ticks(graphbodies.games(start)[IN_THESIS]) for _ in range(TIMED)]
        for tick, found in enumerate(zip(*played, strict=True), start=1):
            boxes = found[0][0]
            yield IN_THESIS.line(name, seconds=tick * TICK, boxes=boxes, microseconds=min(time for _, time in found))


def times_of_ticks(game: graphbodies.AnyGame) -> list[tuple[int, float]]:
    """For each tick how many boxes are pushed, and how long it takes."""
    return [timed(lambda: graphbodies.tick(game)[0].depth - 1) for _ in range(TICKS)]


def times_of_scene() -> Iterator[Line]:
    """The time of the movement step after a second, with more and more boxes in the scene."""
    starts = {boxes: graphbodies.after_a_second(boxes) for boxes in IN_SCENE}
    least: dict[tuple[int, Engine], float] = {}
    for _, (boxes, start) in product(range(TIMED), starts.items()):
        for engine, (_, step) in graphbodies.steps(start).items():
            _, time = timed(step)
            least[boxes, engine] = min(time, least.get((boxes, engine), time))
    for (boxes, engine), time in least.items():
        yield engine.line("boxes in the scene", seconds=1, boxes=boxes, microseconds=time)


def timed(step: Callable[[], Done]) -> tuple[Done, float]:
    """What a step returns, and how long it takes in microseconds."""
    before = process_time_ns()
    done = step()
    return done, (process_time_ns() - before) / 1000
