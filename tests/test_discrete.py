"""The discrete sibling: small turns by hand, and wrong rules caught by its invariants and by steps of `repaired`."""

from dataclasses import replace

import pytest

from properties.contracts import discrete
from spec import discrete as rules
from spec.discrete import DISCRETE_INVARIANTS, Spot, State, Turn, turn
from spec.graph import Direction
from spec.profiles import REPAIRED
from spec.rule import Family

LEFT, RIGHT = Direction


def state(ground, *spots):
    """A state of spots given as pairs."""
    return State(tuple(ground), tuple(Spot(*spot) for spot in spots))


def spots(after):
    """The spots of a state as pairs."""
    return [(spot.column, spot.storey) for spot in after.spots]


@pytest.mark.parametrize(
    ("before", "body", "direction", "after"),
    [
        (state([0, 0, 0], (0, 0)), 0, RIGHT, [(1, 0)]),
        (state([0, 0, 0], (0, 0)), 0, LEFT, [(0, 0)]),
        (state([0, 1], (0, 0)), 0, RIGHT, [(0, 0)]),
        (state([2, 0], (0, 2)), 0, RIGHT, [(1, 0)]),
        (state([0, 0, 0], (0, 0), (1, 0)), 0, RIGHT, [(1, 0), (2, 0)]),
        (state([0, 0], (0, 0), (1, 0)), 0, RIGHT, [(0, 0), (1, 0)]),
        (state([0, 0, 0], (0, 0), (0, 1)), 0, RIGHT, [(1, 0), (1, 1)]),
        (state([0, 0, 0], (0, 0), (0, 1)), 1, RIGHT, [(0, 0), (1, 0)]),
        (state([1, 1, 0], (0, 1), (1, 1), (1, 2)), 0, RIGHT, [(1, 1), (2, 0), (2, 1)]),
        (state([1, 0, 1], (0, 1), (1, 0)), 0, RIGHT, [(1, 1), (1, 0)]),
        (state([0, 0, 0], (0, 0), (2, 0)), 0, RIGHT, [(1, 0), (2, 0)]),
    ],
)
def test_a_turn_by_hand(before, body, direction, after):
    assert spots(turn(before, body, direction)) == after


def test_all_states_of_a_size_are_gone_through():
    """Of two columns of two heights, 4 grounds and 2 + 3 ways to put one or two alike bodies."""
    found = list(discrete.states(columns=2, bodies=2, heights=2))
    assert len(found) == len({(one.ground, one.spots) for one in found}) == 4 * (2 + 3)
    assert all(rules.supported(Turn(one, one, 0, RIGHT)) and rules.one_each(Turn(one, one, 0, RIGHT)) for one in found)


def with_effect(family, rule, other):
    """A family in which a rule has the effect of another."""
    effects = {one.id: one.effect for one in family.rules}
    changed = [replace(one, effect=effects[other]) if one.id == rule else one for one in family.rules]
    return Family(family.id, tuple(changed))


@pytest.mark.parametrize(
    ("name", "rule", "other", "invariant"),
    [
        ("ADVANCE", "discrete/blocked", "discrete/moves", "discrete/supported"),
        ("ADVANCE", "discrete/moves", "discrete/blocked", "discrete/as-asked"),
        ("DROP", "discrete/falls", "discrete/stands", "discrete/supported"),
    ],
)
def test_a_wrong_rule_is_caught_by_name_and_by_steps(monkeypatch, name, rule, other, invariant):
    monkeypatch.setattr(rules, name, with_effect(getattr(rules, name), rule, other))
    with pytest.raises(AssertionError, match=invariant):
        discrete.turns_keep_the_invariants(REPAIRED)
    with pytest.raises(AssertionError, match="a step ends otherwise"):
        discrete.turns_are_steps(REPAIRED)


def test_a_turn_in_which_riders_stay_behind_ends_otherwise_than_a_step():
    before = state([0, 0, 0], (0, 0), (0, 1))
    left_behind = state([0, 0, 0], (1, 0), (0, 0))
    assert discrete.ends_as_in_storeys(Turn(before, turn(before, 0, RIGHT), 0, RIGHT))
    assert not discrete.ends_as_in_storeys(Turn(before, left_behind, 0, RIGHT))


@pytest.mark.parametrize(
    ("invariant", "before", "after"),
    [
        ("one-each", [(0, 0), (1, 0)], [(1, 0), (1, 0)]),
        ("supported", [(0, 0)], [(1, 1)]),
        ("supported", [(0, 0)], [(3, 0)]),
        ("order", [(0, 0), (1, 0)], [(1, 0), (0, 0)]),
        ("one-vertex", [(0, 0)], [(2, 0)]),
        ("one-vertex", [(0, 0), (1, 0)], [(1, 1), (1, 0)]),
        ("as-asked", [(0, 0)], [(0, 0)]),
    ],
)
def test_an_invariant_notices_what_breaks_it(invariant, before, after):
    broken = Turn(state([0, 0, 0], *before), state([0, 0, 0], *after), 0, RIGHT)
    (found,) = (one for one in DISCRETE_INVARIANTS if one.id == f"discrete/{invariant}")
    assert not found.holds(broken)
    still = Turn(broken.before, turn(broken.before, 0, RIGHT), 0, RIGHT)
    assert found.holds(still)
