"""Rounding: what the tolerance of the validator rests on, and that correct rows in floats are within it."""

import random
from dataclasses import replace
from fractions import Fraction
from functools import partial

import numpy as np
import pytest

from properties.claims.rounding import NEARLY
from properties.conformance.judge import Finding, expect, judge
from properties.contracts import floats, rounding
from properties.contracts.request import judged
from properties.engine.explore import explore
from properties.engine.rounded import Machine, Rounded
from properties.given import Exact
from properties.worlds.rows import string_graph
from reference.rounding import ROUNDINGS, UNIT_ROUNDOFF, largest, tolerance
from reference.simulator import move
from reference.world import World
from spec.body import Body, EdgePosition, Level
from spec.graph import Direction
from spec.profiles import THESIS
from spec.rule import Family
from spec.rules.clearance import CLEARANCE
from spec.rules.push import PUSH
from spec.transform import with_numbers

RIGHT, LEFT = Direction.RIGHT, Direction.LEFT
FLOATS = {"float64": float, "float32": lambda number: np.float32(float(number))}


def with_effect(family, rule, effect):
    """The family with another effect of one rule."""
    return Family(family.id, tuple(replace(one, effect=effect) if one.id == rule else one for one in family.rules))


def on_the_last_edge(profile, **more):
    """What the exploration of a segment on the last edge shows."""
    return explore(partial(judged, partial(last_edge, **more), profile))


def last_edge(profile, given, **more):
    rounding.segment_is_nearly_exact(profile, given, closed=False, direction=RIGHT, last=True, **more)


def test_a_segment_is_off_by_so_many_roundings_and_not_by_half_as_many():
    assert on_the_last_edge(THESIS).proved
    fewer = on_the_last_edge(THESIS, within=4)
    assert fewer.counterexample is not None


@pytest.mark.parametrize(
    ("family", "of", "rule", "effect"),
    [
        ("push", PUSH, "push/request", lambda want: want.stride),
        ("clearance", CLEARANCE, "clearance/margin", lambda sight: sight.gap),
    ],
)
def test_a_wrong_rule_is_off_by_more(family, of, rule, effect):
    wrong = replace(THESIS.rules, **{family: with_effect(of, rule, effect)})
    assert on_the_last_edge(replace(THESIS, rules=wrong)).counterexample is not None


def test_what_a_request_says_is_rounded():
    (says,) = [one for one in NEARLY if "request" in one.id]
    assert explore(partial(judged, says.program, THESIS)).proved
    less = partial(rounding.request_says_nearly_what_it_does, within=1)
    assert explore(partial(judged, less, THESIS)).counterexample is not None


def test_the_same_sum_is_rounded_alike_and_nothing_added_is_not_rounded():
    machine = Machine(Exact({"error 1": Fraction(3, 2), "error 2": Fraction(1, 2)}))
    one, two = Rounded(machine, Fraction(5)), Rounded(machine, Fraction(3))
    assert (one + two).held == Fraction(17, 2)
    assert (two + one) is (one + two)
    assert (one - two).held == Fraction(3, 2)
    assert one + two * 0 is one
    assert (one - one).nothing
    assert one * 1 is one
    assert (one * -2).held == -10
    assert machine.errors == 2
    for factor in (3, Fraction(1, 3), two):
        with pytest.raises(TypeError, match="is rounded, in a way that is not known here"):
            one * factor


def random_row(rng, bodies, edges, number):
    """A row of bodies on edges of odd lengths, in contact here and there; its numbers are floats of a kind."""
    margin, place, held = Fraction(1, 100), Fraction(1), []
    for _ in range(bodies):
        width = Fraction(rng.randint(300, 900), 1000)
        held.append((place, place + width))
        place += width + margin + rng.choice((0, 0, Fraction(rng.randint(1, 999), 700)))
    length = place + 40
    lengths = [Fraction(float(number(length / edges))) for _ in range(edges)]

    def at(along):
        edge = min(int(along / lengths[0]), edges - 1)
        return EdgePosition(edge, along - lengths[0] * edge)

    placed = [Body(str(i), at(left), at(right), Fraction(0), margin) for i, (left, right) in enumerate(held)]
    level = Level(string_graph(lengths, None), margin, Fraction(1), tuple(placed))
    return with_numbers(level, lambda value: Fraction(float(number(value))), lambda slope: slope)


@pytest.mark.parametrize("numbers", FLOATS)
@pytest.mark.parametrize(("bodies", "edges"), [(3, 1), (30, 4), (300, 1), (1000, 7)])
@pytest.mark.parametrize("direction", Direction)
def test_long_rows_in_floats_are_within_the_tolerance(numbers, bodies, edges, direction):
    rng = random.Random(f"{numbers} {bodies} {edges} {direction}")
    number = FLOATS[numbers]
    level = random_row(rng, bodies, edges, number)
    mover = 0 if direction is RIGHT else bodies - 1
    distance = number(rng.randint(1000, 30000) / 1000)
    world = World(with_numbers(level, number, lambda slope: slope))
    move(THESIS, world, mover, direction, distance)
    asked = ((mover, direction, Fraction(float(distance))),)
    expected = expect(THESIS, World(level), asked)
    (record,) = expected.records
    assert record.depth > 1
    most = UNIT_ROUNDOFF[numbers] * largest(level) * ROUNDINGS * floats.walks(record)
    for one, two in zip(expected.world.bodies, world.bodies, strict=True):
        for a, b in ((one.left, two.left), (one.right, two.right)):
            along = expected.world.coordinate(EdgePosition(b.edge, Fraction(float(b.location))))
            assert abs(expected.world.coordinate(a) - along) <= most


def test_an_unlucky_row_conforms_with_the_tolerance_of_its_walks_and_not_with_that_of_one():
    level, distance = floats.unlucky_row(60)
    world = World(with_numbers(level, float, float))
    move(THESIS, world, 0, RIGHT, float(distance))
    seen = World(with_numbers(replace(level, bodies=tuple(world.bodies)), Fraction, lambda slope: slope))
    asked = ((0, RIGHT, distance),)
    (record,) = expect(THESIS, World(level), asked).records
    enough = tolerance("float64", level, distance, walks=floats.walks(record))
    assert judge(THESIS, World(level), asked, seen, enough).finding is Finding.AGREES
    assert judge(THESIS, World(level), asked, seen, tolerance("float64", level, distance)).finding is not Finding.AGREES
