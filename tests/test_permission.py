"""Who may not push: to it, whatever is ahead is a wall, one that moves if it moves (A39)."""

from fractions import Fraction

import pytest

from reference.formats.level import BodyRecord, LevelRecord, Position, level_of
from reference.stepping import StepGame
from spec.profiles import REPAIRED

MARGIN = Fraction(1, 8)


def row(sign, *bodies):
    """A game on a line of 40; each body is (name, how far its rear border is ahead of the end, whether it may push)."""
    records = []
    for name, rear, pushes in bodies:
        left = Fraction(rear) if sign > 0 else 40 - Fraction(rear) - 1
        places = Position(str(left), edge=0), Position(str(left + 1), edge=0)
        records.append(BodyRecord(name, *places, speed="1", pushes=pushes))
    level = LevelRecord("graphbody/level@1", "row", [("0", "0"), ("40", "0")], records, margin=str(MARGIN))
    return StepGame(REPAIRED, level_of(level))


def driven(game, sign, time, **speeds):
    """How far each body comes forwards in a time, by its name, and who was in contact with whom."""
    before = [place.left for place in game.storeys.places]
    game.drive({name: Fraction(speed) * sign for name, speed in speeds.items()}, Fraction(time))
    after = [place.left for place in game.storeys.places]
    ways = {name: (now - then) * sign for name, then, now in zip(game.names, before, after, strict=True)}
    return ways, {frozenset((one.body, one.other)) for one in game.happened if one.rule == "event/contact"}


@pytest.fixture(params=(1, -1), ids=("right", "left"))
def sign(request):
    return request.param


def test_what_stands_stops_it(sign):
    ways, met = driven(row(sign, ("A", 0, False), ("B", 2, True)), sign, 5, A=1)
    assert ways == {"A": 1 - MARGIN, "B": 0}
    assert met == {frozenset("AB")}


def test_behind_what_moves_it_goes_as_fast_as_that(sign):
    ways, met = driven(row(sign, ("A", 0, False), ("B", 2, True)), sign, 5, A=3, B=1)
    assert ways == {"A": 5 + 1 - MARGIN, "B": 5}
    assert met == {frozenset("AB")}


def test_behind_what_is_pushed_ahead_of_it_it_goes_as_fast_as_that(sign):
    ways, _ = driven(row(sign, ("A", 0, False), ("B", 2, True), ("C", 4, True)), sign, 5, A=3, B=1)
    assert ways == {"A": 6 - MARGIN, "B": 5, "C": 5 - 1 + MARGIN}


def test_what_is_faster_ahead_leaves_it(sign):
    ways, met = driven(row(sign, ("A", 0, False), ("B", 1 + MARGIN, True)), sign, 5, A=1, B=3)
    assert ways == {"A": 5, "B": 15}
    assert met == set()


def test_pushed_from_behind_it_passes_nothing_on(sign):
    ways, _ = driven(row(sign, ("P", 0, True), ("A", 2, False), ("B", 4, True)), sign, 9, P=1)
    assert ways == {"P": 2 - 2 * MARGIN, "A": 1 - MARGIN, "B": 0}


def test_pushed_from_behind_it_follows_what_moves_and_so_does_its_pusher(sign):
    start = ("P", 0, True), ("A", 1 + MARGIN, False), ("B", 2 + 2 * MARGIN, True)
    ways, _ = driven(row(sign, *start), sign, 5, P=3, B=1)
    assert ways == {"P": 5, "A": 5, "B": 5}


def test_who_may_push_would_push_it_on(sign):
    start = ("P", 0, True), ("A", 1 + MARGIN, True), ("B", 2 + 2 * MARGIN, True)
    ways, _ = driven(row(sign, *start), sign, 5, P=3, B=1)
    assert ways == {"P": 15, "A": 15, "B": 15}


def test_what_comes_towards_it_pushes_it_back(sign):
    ways, _ = driven(row(sign, ("A", 5, False), ("B", 7, True)), sign, 3, B=-1)
    assert ways == {"A": -2 - MARGIN, "B": -3}


def test_walking_against_what_pushes_it_back_it_stalls_both(sign):
    ways, _ = driven(row(sign, ("A", 5, False), ("B", 6 + MARGIN, True)), sign, 3, A=1, B=-2)
    assert ways["A"] == ways["B"] == 0
