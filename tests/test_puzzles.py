"""The puzzles: what they need, by going through all that the keys can lead to."""

from collections import deque
from dataclasses import replace
from fractions import Fraction

import pytest

from reference.formats.files import read
from reference.formats.level import LevelRecord, valid_level
from reference.plan import check_plan
from reference.play import LIBRARY, play
from reference.scene import Scene
from reference.stepping import StepGame
from spec.body import EdgePosition
from spec.graph import Direction
from spec.profiles import REPAIRED


def puzzle(name):
    """A level of the library."""
    return valid_level(read(LIBRARY / "levels" / f"{name}.json", LevelRecord), "$")


def fewest_keys(level):
    """The fewest ticks that solve a level under the repaired rules, or None if no keys do."""
    check_plan(level)
    game = StepGame(REPAIRED, level)
    seen, waiting = {tuple(game.storeys.places)}, deque([(game.storeys, 0)])
    while waiting:
        storeys, ticks = waiting.popleft()
        for direction in Direction:
            game.scene = Scene(storeys.copy())
            game.tick(direction)
            if game.world.solved():
                return ticks + 1
            places = tuple(game.storeys.places)
            if places not in seen:
                seen.add(places)
                waiting.append((game.storeys, ticks + 1))
    return None


def standing_at(body, edge, location):
    """A body elsewhere, on the ground."""
    left = EdgePosition(edge, Fraction(location))
    return replace(body, left=left, right=replace(left, location=left.location + 1))


@pytest.mark.parametrize(("level", "scenario"), [("huge-and-cute", "huge-and-cute-solved-repaired")])
def test_a_puzzle_is_solved_with_the_fewest_keys(level, scenario):
    ticks = len(list(play(LIBRARY / "scenarios" / f"{scenario}.json").steps))
    assert ticks == fewest_keys(puzzle(level))


def test_the_second_puzzle_is_solved_by_riding_and_filling():
    rides, fills = [], []
    playing = play(LIBRARY / "scenarios" / "ride-and-fill-solved.json")
    for step in playing.steps:
        moving = {name for one in step.happened for name in one.velocities}
        on_top = {body.name for body in step.bodies if body.left.edge >= len(playing.game.level.graph.edges)}
        rides.append({"Long box", "Cute"} <= moving and "Cute" in on_top)
        fills += [one.other for one in step.happened if one.rule == "settle/jump"]
    assert any(rides)
    assert fills == ["Crate"]
    assert playing.game.world.solved()


@pytest.mark.slow
def test_without_the_crate_no_keys_solve_the_second_puzzle():
    level = puzzle("ride-and-fill")
    assert fewest_keys(replace(level, bodies=level.bodies[:3])) is None


@pytest.mark.parametrize(("edge", "location"), [(0, "21/4"), (4, "1")])
def test_without_the_ride_no_keys_solve_the_second_puzzle(edge, location):
    level = puzzle("ride-and-fill")
    huge, box, cute, crate = level.bodies
    crate = standing_at(crate, 0, 7)
    assert fewest_keys(replace(level, bodies=(huge, box, standing_at(cute, edge, location), crate))) is None
