"""What this specification does: its own rules of velocity in floats, its own simulator in exact numbers."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from importlib.metadata import version
from math import cos, radians, sin

from evaluation.cases import TICK, UNITY, Slide
from evaluation.tables import Engine
from properties.worlds.rows import located, string_graph
from reference.simulator import Fulfilled, Game, move
from reference.stepping import StepGame
from reference.world import World
from spec.body import Body, Level
from spec.graph import Direction
from spec.profiles import REPAIRED, THESIS
from spec.rules.velocity import Material, Motion, Slope, VelocityRules, simulate_tick

VERSION = version("graphbody")
PRINTED, MENDED = Engine("graphbody printed", VERSION), Engine("graphbody mended", VERSION)
IN_THESIS, IN_REPAIRED = Engine("graphbody thesis", VERSION), Engine("graphbody repaired", VERSION)
SCANNING = Engine("graphbody thesis, full scan", VERSION)
VELOCITY = {PRINTED: THESIS.velocity, MENDED: REPAIRED.velocity}

WIDTH, MARGIN, PITCH = Fraction(1), Fraction(1, 4), Fraction(5, 2)
"""Widths, the margin and the distance from box to box are those of the level pushing-boxes-20."""

CHARACTER_SPEED, EXACT_TICK = Fraction(25), Fraction(1, 50)


@dataclass(frozen=True)
class Prototype:
    """What the prototype may have done that the thesis does not print.

    Attributes:
        inset: how far each border is inside the body, if the vector between them is not normalised; 0 if it is.
        moves_first: whether a body moves by the velocity that it had before the tick.
        drag: the factor by which velocity is multiplied in each tick.
    """

    inset: float = 0
    moves_first: bool = False
    drag: float = 1


AS_PRINTED = Prototype()


def slope(degrees: float, prototype: Prototype) -> Slope[float]:
    """The ground under a body of width 1, as the vector between its borders has it."""
    size = 1 - 2 * prototype.inset
    return Slope(cos(radians(degrees)) * size, sin(radians(degrees)) * size)


def slide(
    rules: VelocityRules, run: Slide, ticks: int, gravity: float = UNITY, prototype: Prototype = AS_PRINTED
) -> list[float]:
    """Where a body is after each tick, along the ground, from where it was."""
    material = Material(friction=run.friction, drag=prototype.drag, damping=0.0, slowest=0.0, fastest=None, mass=1.0)
    motion, ground = Motion(float(run.speed), material, gravity, force=0.0), slope(run.degrees, prototype)
    place, places = 0.0, []
    for _ in range(ticks):
        before, motion = motion, simulate_tick(rules, motion, ground, TICK)
        place += (before if prototype.moves_first else motion).velocity * TICK
        places.append(place)
    return places


def rests(rules: VelocityRules, degrees: float, friction: float) -> bool:
    """Whether a body laid down at rest on a slope stays there."""
    return slide(rules, Slide(degrees, friction, 0), 1)[-1] == 0


def level(lefts: Sequence[Fraction], edges: Sequence[Fraction], speed: Fraction) -> Level[Fraction]:
    """A character and boxes on level ground, the character first."""
    lengths = list(edges)
    bodies = [
        Body(
            "Character" if place == 0 else f"Box {place}",
            located(lengths, left, closed=False),
            located(lengths, left + WIDTH, closed=False),
            speed if place == 0 else Fraction(0),
            WIDTH,
        )
        for place, left in enumerate(lefts)
    ]
    return Level(string_graph(lengths, None), MARGIN, EXACT_TICK, tuple(bodies))


def picking_up(boxes: int, edge: Fraction) -> Level[Fraction]:
    """A character that picks up one box after another, on edges of a length (7.1.1).

    Where it begins, boxes and the character are 3/2 apart: it is in contact with one box more every 5/4 that it goes.
    """
    room = (boxes + 1) * PITCH + 50
    edges = [edge] * int(-(-room // edge))
    return level([place * PITCH for place in range(boxes + 1)], edges, CHARACTER_SPEED)


def before_wall(boxes: int, speed: int) -> Level[Fraction]:
    """A character and boxes, each the margin and a quarter before the next, the last as far before a wall."""
    pitch = WIDTH + 2 * MARGIN
    return level([place * pitch for place in range(boxes + 1)], [(boxes + 1) * pitch], Fraction(speed))


def in_contact(boxes: int, speed: int) -> Level[Fraction]:
    """A character and boxes in contact, with much room ahead."""
    pitch = WIDTH + MARGIN
    return level([place * pitch for place in range(boxes + 1)], [(boxes + 1) * pitch + 100], Fraction(speed))


AnyGame = Game[Fraction] | StepGame[Fraction]


def games(start: Level[Fraction]) -> dict[Engine, AnyGame]:
    """A level, to be played under both profiles."""
    return {IN_THESIS: Game(THESIS, start), IN_REPAIRED: StepGame(REPAIRED, start)}


def pushed(game: AnyGame) -> Iterator[list[Fraction]]:
    """Where a character and the boxes before it are after each tick."""
    while True:
        tick(game)
        yield [game.world.point(body.left)[0] for body in game.world.bodies]


class Scanning(World[Fraction]):
    """A world that looks for a neighbour among all bodies, as the thesis has it, and counts those that it looks at."""

    looked_at = 0

    def beside(self, body: int, direction: Direction) -> int | None:
        """The nearest body on one side."""
        nearest, least = None, None
        for other in self.handles():
            self.looked_at += 1
            far = (self.coordinate(self.bodies[other].left) - self.coordinate(self.bodies[body].left)) * direction
            if far > 0 and (least is None or far < least):
                nearest, least = other, far
        return nearest


def after_a_second(boxes: int) -> Level[Fraction]:
    """The level in which a character has pushed boxes for a second, on one edge."""
    start = picking_up(boxes, Fraction(8 * (boxes + 20)))
    game = Game(THESIS, start)
    for _ in range(50):
        game.tick(Direction.RIGHT)
    return Level(start.graph, MARGIN, EXACT_TICK, tuple(game.world.bodies))


def tick(game: AnyGame) -> list[Fulfilled[Fraction]]:
    """A tick in which the key for the right is held."""
    return game.tick(Direction.RIGHT)


Step = Callable[[], tuple[int, int]]
"""A movement step: it says how many boxes were pushed, and at how much work."""


def steps(start: Level[Fraction]) -> dict[Engine, tuple[str, Step]]:
    """One movement step of the character of a level, once for each way to find neighbours; and what it counts."""
    ordered, scanning, at_once = World(start), Scanning(start), StepGame(REPAIRED, start)

    def by(world: World[Fraction]) -> int:
        _, record = move(THESIS, world, 0, Direction.RIGHT, CHARACTER_SPEED * EXACT_TICK)
        return record.depth - 1

    def together() -> tuple[int, int]:
        (all_of_it,) = tick(at_once)
        return all_of_it.depth - 1, all_of_it.work["choices"]

    return {
        IN_THESIS: ("queries", lambda: (by(ordered), ordered.work.queries)),
        SCANNING: ("bodies looked at", lambda: (by(scanning), scanning.looked_at)),
        IN_REPAIRED: ("choices", together),
    }
