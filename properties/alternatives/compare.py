"""What each reading makes of the scenes: the smallest on which it differs from the thesis, and what it breaks."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cache
from typing import Any

from properties.alternatives.scenes import Scene, scenes
from reference.alternatives import VARIANTS
from reference.simulator import Endless, Fulfilled, Game
from reference.world import LevelError, World
from spec.body import EdgePosition
from spec.graph import Direction
from spec.invariants import AT_MOST_ASKED, DIRECTION, NO_OVERLAP, ON_GRAPH, ORDER, RIGID_WIDTH, Deed, Invariant
from spec.plane import HORIZONTAL, IN_PLANE
from spec.profiles import THESIS
from spec.rule import GuardError

ON_STRINGS: tuple[Invariant, ...] = (ORDER, NO_OVERLAP, RIGID_WIDTH, ON_GRAPH, AT_MOST_ASKED, DIRECTION)
OF_A_MOVER = (AT_MOST_ASKED, HORIZONTAL)
"""What is not judged of a tick, which has several movers."""

MOST_RULES = 20_000
FAILS = "fails"
Answer = tuple[Any, ...]
"""Where all bodies are, on what, and which buttons are pressed; or why that cannot be said."""


@dataclass(frozen=True)
class Run:
    """A scene played under a reading: the world before and after, the last step, and what came of it."""

    game: Game[Any]
    before: World[Any]
    moves: list[Fulfilled[Any]]


def game_of(scene: Scene, reading: str | None) -> Game[Any]:
    """The game of a scene under an alternative, by its ID, or under the thesis."""
    if reading is None:
        return Game(THESIS, scene.level, MOST_RULES)
    game = VARIANTS[reading].play(scene.level)
    game.most = MOST_RULES
    return game


def run(scene: Scene, reading: str | None) -> Run:
    """Play a scene; `before` is the world before its last step."""
    game, before, moves = game_of(scene, reading), None, []
    for step in scene.steps:
        before = game.world.copy()
        moves = game.tick(step) if isinstance(step, Direction) else [game.request(*step)]
    return Run(game, before or game.world.copy(), moves)


def place(world: World[Any], at: EdgePosition[Any]) -> tuple[Any, Any]:
    """Where a position is in the plane, on a cylinder once round."""
    x, y = world.point(at)
    circumference = world.graph.circumference
    return (x if circumference is None else x % circumference), y


def places(world: World[Any]) -> Answer:
    """Where all bodies are in the plane, on what each stands, and which buttons are pressed."""
    held = [(place(world, body.left), place(world, body.right)) for body in world.bodies]
    supports = [world.support(body) for body in world.handles()]
    return *zip(held, supports, strict=True), tuple(world.pressed(button) for button in world.level.buttons)


def outcome(scene: Scene, reading: str | None) -> tuple[Answer, Run | None]:
    """What comes of a scene: where all are; or that it fails, is refused, or not to be said in rational numbers."""
    try:
        played = run(scene, reading)
        return places(played.game.world), played
    except (Endless, GuardError, AssertionError) as error:
        return (FAILS, type(error).__name__), None
    except LevelError as error:
        return ("refused", str(error)), None
    except ValueError as error:
        return ("undecided", str(error)), None


@cache
def of_thesis(number: int) -> tuple[Answer, frozenset[str]]:
    """What the thesis makes of a scene, by its number, and which invariants it breaks there."""
    answer, played = outcome(scenes()[number], None)
    return answer, frozenset(broken_by(scenes()[number], played))


def broken_by(scene: Scene, played: Run | None) -> Iterator[str]:
    """The invariants that a run of one step breaks, in a scene that keeps the guidelines."""
    if played is None or not scene.judged:
        return
    deed, ticked = deed_of(scene, played), isinstance(scene.steps[0], Direction)
    for invariant in (*ON_STRINGS, *IN_PLANE) if scene.plain else IN_PLANE:
        if not (ticked and invariant in OF_A_MOVER) and not invariant.holds(deed):
            yield invariant.id


def deed_of(scene: Scene, played: Run) -> Deed[Any]:
    """A run as the invariants see it; a tick counts as a deed of its first body."""
    step = scene.steps[-1]
    direction = step if isinstance(step, Direction) else Direction.RIGHT
    distance = 0 if isinstance(step, Direction) else step[1]
    moved = played.moves[0].moved if played.moves else 0
    bodies = len(scene.level.bodies)
    return Deed(played.before, played.game.world, 0, direction, distance, moved, 1, bodies, 1, 0)


@dataclass
class Comparison:
    """An alternative beside the thesis, over all scenes.

    Attributes:
        differs: the number of the smallest scene on which it differs, if any.
        differing: on how many of the judged scenes it differs.
        broken: for each invariant that it breaks, the number of the smallest scene.
            `fails` stands among them for a step in which not exactly one rule applies, or which does not end.
        undecided: how many scenes it refuses, or says nothing of.
    """

    differs: int | None = None
    differing: int = 0
    undecided: int = 0
    broken: dict[str, int] = field(default_factory=dict)


def compared(reading: str | None) -> Comparison:
    """Play scenes under an alternative, or under the thesis, beside the thesis: all until they differ, then the judged.

    Where the outcome is that of the thesis, so are the invariants.
    """
    found = Comparison()
    for number, scene in enumerate(scenes()):
        if found.differs is not None and not scene.judged:
            continue
        answer, broken = of_thesis(number)
        other, played = outcome(scene, reading)
        if other[0] in ("refused", "undecided") and other[0] != answer[0]:
            found.undecided += 1
            continue
        if other != answer:
            found.differing += scene.judged
            found.differs = number if found.differs is None else found.differs
            broken = frozenset({FAILS} if other[0] == FAILS else broken_by(scene, played))
        for name in broken:
            found.broken.setdefault(name, number)
    return found


@cache
def broken_by_thesis() -> dict[str, int]:
    """For each invariant that the thesis breaks, the number of the smallest scene."""
    found: dict[str, int] = {}
    for number, scene in enumerate(scenes()):
        for name in of_thesis(number)[1] if scene.judged else ():
            found.setdefault(name, number)
    return found
