"""The engine must earn its trust: it finds what is wrong, proves what is right and admits what it cannot say."""

from fractions import Fraction

import pytest

from properties.engine import explore as engine
from properties.engine.explore import EngineError, explore
from properties.engine.merge import merged
from properties.given import Exact, Infeasible


def leave_branches_out(monkeypatch):
    """Make the explorer forget the other branch of every fork."""
    real = engine.Path.decide

    def forgetful(self, formula):
        branch = real(self, formula)
        self.exploration.forks[-1].other_open = False
        return branch

    monkeypatch.setattr(engine.Path, "decide", forgetful)


def test_a_true_promise_is_proved_on_every_path():
    def program(given):
        a, b = given.number("a"), given.number("b")
        smaller = a if a <= b else b
        given.ensure("the smaller is neither larger", (smaller <= a) & (smaller <= b))

    outcome = explore(program)
    assert outcome.proved
    assert outcome.paths == 2


def test_a_false_promise_is_refuted_by_simple_exact_values():
    def program(given):
        a, b = given.number("a"), given.number("b")
        given.assume(a > b)
        given.ensure("b is not 0", b > 0)

    outcome = explore(program)
    assert outcome.counterexample.values == {"a": 1, "b": 0}


def test_a_promise_made_before_a_premise_is_judged_without_it():
    def program(given):
        a = given.number("a")
        given.ensure("a is small", a < 1)
        given.assume(a < 1)

    assert explore(program).counterexample is not None


def test_a_promise_broken_on_one_path_only_is_found():
    def program(given):
        a = given.number("a")
        if (a > 3) & (a < 4):
            given.ensure("never here", False)
        given.ensure("always", True)

    assert 3 < explore(program).counterexample.values["a"] < 4


def test_premises_that_cannot_hold_prove_nothing():
    def program(given):
        a = given.number("a")
        given.assume(a < 0)
        given.ensure("anything", False)

    outcome = explore(program)
    assert not outcome.proved
    assert outcome.counterexample is None


def test_a_program_without_promises_proves_nothing():
    assert not explore(lambda given: given.assume(given.number("a") > 0)).proved


def test_a_program_that_is_not_the_same_when_repeated_is_refused():
    runs = iter(range(10))

    def program(given):
        a = given.number("a")
        if a > next(runs):
            given.ensure("something", True)

    with pytest.raises(EngineError, match="another fork"):
        explore(program)


def test_a_counterexample_that_does_not_replay_on_exact_numbers_is_refused():
    def program(given):
        given.ensure("only symbolic values break this", isinstance(given, Exact))

    with pytest.raises(EngineError, match="does not replay"):
        explore(program)


def test_paths_that_leave_values_out_are_noticed(monkeypatch):
    def program(given):
        a = given.number("a")
        given.ensure("something", (a > 1) | (a <= 1))
        if a > 1:
            given.ensure("more", True)

    leave_branches_out(monkeypatch)
    with pytest.raises(EngineError, match="do not cover"):
        explore(program)


def test_an_answer_of_unknown_proves_nothing_and_prunes_nothing(monkeypatch):
    def program(given):
        a = given.number("a")
        if a > 1:
            given.ensure("hard to say", a > 0)
        given.ensure("easy", True)

    monkeypatch.setattr(engine.Exploration, "possible", lambda self, *formulas: None)
    monkeypatch.setattr(engine.Exploration, "check_coverage", lambda self: None)
    outcome = explore(program)
    assert not outcome.proved
    assert outcome.paths == 2


def test_equality_of_symbolic_numbers_is_a_formula_and_not_structural():
    def program(given):
        a, b = given.number("a"), given.number("b")
        given.assume(a + b == 2)
        given.assume(a == b)
        given.ensure("both are 1", (a == 1) & (b + 0 == 1))

    assert explore(program).proved


def test_floats_are_taken_at_their_exact_binary_value():
    tenth = Fraction(1, 10)

    def program(given):
        a = given.number("a")
        given.assume(a == 0.1)
        given.ensure("a tenth is not the float", (a < tenth) | (a > tenth))

    assert explore(program).proved


def test_a_product_of_unknown_numbers_is_refused():
    with pytest.raises(TypeError, match="not linear"):
        explore(lambda given: given.ensure("square", given.number("a") * given.number("b") >= 0))


def test_known_values_stop_where_a_premise_fails():
    with pytest.raises(Infeasible):
        Exact({"a": 1}).assume(False)


def smaller_and_larger(given):
    a, b = given.number("a"), given.number("b")
    return merged(given, lambda _: [a, b] if a <= b else [b, a])


def test_merged_paths_go_on_as_one():
    def program(given):
        smaller, larger = smaller_and_larger(given)
        given.ensure("in order", smaller <= larger)
        given.ensure("the same sum", smaller + larger == given.number("a") + given.number("b"))

    outcome = explore(program)
    assert outcome.proved
    assert outcome.paths == 3


def test_a_false_promise_of_merged_numbers_is_refuted_by_exact_values():
    def program(given):
        smaller, _ = smaller_and_larger(given)
        given.ensure("the smaller is a", smaller == given.number("a"))

    assert explore(program).counterexample.values["a"] > 0


def test_two_merges_on_one_path_are_not_taken_for_each_other():
    def program(given):
        a = given.number("a")
        (first,) = merged(given, lambda _: [a if a <= 1 else a - 1])
        (second,) = merged(given, lambda _: [a if a <= 2 else a - 2])
        given.ensure("the first is not the second", first == second)

    assert explore(program).counterexample is not None


@pytest.mark.parametrize("goes_on", [True, False])
def test_what_is_merged_within_a_part_keeps_its_definition(goes_on):
    def program(given):
        a, b = given.number("a"), given.number("b")

        def part(inner):
            if b <= 1:
                return [a]
            (nearer,) = merged(inner, lambda _: [a if a <= 5 else a * 0])
            return [nearer + 1]

        (number,) = merged(given, part)
        if goes_on and b > 2:
            given.ensure("at most 6", number <= 6)
        given.ensure("at most 6, or b is at most 1", (number <= 6) | (b <= 1))

    assert explore(program).proved


def test_a_broken_promise_within_a_part_is_found():
    def program(given):
        a = given.number("a")

        def part(inner):
            if a > 1:
                inner.ensure("at most 2", a <= 2)
            return [a]

        merged(given, part)

    assert explore(program).counterexample.values["a"] > 2


def test_a_part_that_assumes_something_is_refused():
    def program(given):
        a = given.number("a")

        def part(inner):
            inner.assume(a > 1)
            return [a]

        merged(given, part)

    with pytest.raises(EngineError, match="assumes"):
        explore(program)


def test_a_part_whose_paths_leave_values_out_is_noticed(monkeypatch):
    leave_branches_out(monkeypatch)
    with pytest.raises(EngineError, match="of a part do not cover"):
        explore(smaller_and_larger)
