"""The engine must earn its trust: it finds what is wrong, proves what is right and admits what it cannot say."""

from dataclasses import replace
from fractions import Fraction
from itertools import count

import pytest
import z3

from properties.engine import explore as engine
from properties.engine.explore import Counterexample, Outcome, explore
from properties.engine.formulas import EngineError, conjunction, disjunction
from properties.engine.merge import merged
from properties.engine.rounded import Machine, Rounded
from properties.engine.simplest import smallest
from properties.engine.timed import Speed, Time, Ways
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


def test_a_part_that_is_merged_leaves_nothing_behind():
    def program(given):
        a = given.number("a")
        if a <= 4:
            (_,) = merged(given, lambda _: [a if a <= 3 else a * 0])
        given.ensure("it is small", a <= 4)

    def after(promise):
        def program(given):
            a = given.number("a")
            (_,) = merged(given, lambda _: [a if a > 5 else a * 0])
            given.ensure("it is so", promise(a))

        return program

    refuted = [program, after(lambda a: a > 5), after(lambda a: a <= 5)]
    assert all(explore(one).counterexample is not None for one in refuted)


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


def test_proved_is_what_holds_on_some_path_for_some_values_with_nothing_open():
    whole = Outcome(paths=1, promises=1, witness={})
    assert whole.proved
    refuted = {"counterexample": Counterexample((), {})}
    lacking = ({"paths": 0}, {"promises": 0}, {"witness": None}, {"open": ["?"]}, refuted)
    assert [replace(whole, **one).proved for one in lacking] == [False] * len(lacking)


def flags(given, many):
    """As many truth values as one likes, each of which is there or not."""
    return [given.flag(str(place)) for place in range(many)]


def test_every_path_is_run_once_and_the_rules_of_each_are_kept():
    def program(given):
        for place, there in enumerate(flags(given, 3)):
            given.saw(f"{place} {there}")
        given.ensure("something", True)

    outcome = explore(program)
    assert (outcome.paths, len(outcome.sequences), len(outcome.rules)) == (8, 8, 6)
    assert outcome.exhaustive
    assert outcome.resources > 0


@pytest.mark.parametrize(("budget", "done"), [(3, False), (4, True)])
def test_a_budget_of_paths_that_is_spent_is_told(budget, done, monkeypatch):
    runs = count(1)

    def program(given):
        assert next(runs) <= budget + 1, "it goes on; one more run is that of the witness"
        given.ensure("something", len(flags(given, 2)) == 2)

    monkeypatch.setattr(engine, "MOST_PATHS", budget)
    outcome = explore(program)
    assert (outcome.proved, outcome.paths) == (done, budget)
    assert bool(outcome.open) is not done


def test_a_program_that_draws_without_end_is_refused(monkeypatch):
    def program(given):
        drawn = 0
        while given.flag(str(drawn)):
            drawn += 1

    monkeypatch.setattr(engine, "MOST_DRAWN", 5)
    with pytest.raises(EngineError, match="may not end"):
        explore(program)


def test_as_many_truths_may_be_drawn_as_the_bound_says(monkeypatch):
    def program(given):
        drawn = [given.flag(str(number)) for number in range(5)]
        given.ensure("something", len(drawn) > 0)

    monkeypatch.setattr(engine, "MOST_DRAWN", 5)
    assert explore(program).paths == 2**5


def witnesses_made(monkeypatch, program):
    """How many witnesses an exploration makes."""
    made, real = [], engine.Exploration.witness

    def noted(self, path):
        made.append(path)
        return real(self, path)

    monkeypatch.setattr(engine.Exploration, "witness", noted)
    explore(program)
    return len(made)


def test_one_witness_is_made_of_many_paths(monkeypatch):
    def program(given):
        given.flag("a")
        given.ensure("something", given.number("b") >= 0)

    assert witnesses_made(monkeypatch, program) == 1


def test_no_witness_is_made_where_something_is_open(monkeypatch):
    def program(given):
        given.ensure("something", given.number("a") >= 0)

    monkeypatch.setattr(engine.Exploration, "possible", lambda self, *formulas: None)
    assert witnesses_made(monkeypatch, program) == 0


def test_the_solver_is_asked_no_more_than_it_has_to_be():
    def program(given):
        a = given.number("a")
        for bound in range(3):
            if a > bound:
                given.ensure("something", a > 0)
        given.ensure("something", a >= 0)

    assert explore(program).checks == 13


def test_a_path_ends_at_a_premise_that_cannot_hold_and_is_asked_about_it_once():
    def program(given):
        a, b = given.number("a"), given.number("b")
        least = a if a <= b else b
        given.assume(a < 5)
        given.assume(least > 1)
        given.assume((a if a <= 3 else b) <= 1)
        given.ensure("nothing comes here", a > a + 1)

    outcome = explore(program)
    assert (outcome.paths, outcome.checks) == (0, 13)


def test_of_no_formulas_all_hold_and_none_does():
    assert z3.is_true(conjunction())
    assert z3.is_false(disjunction())


def test_a_variable_counts_as_often_as_it_is_in_a_sum():
    def program(given):
        a, b = given.number("a"), given.number("b")
        given.assume((a <= 1) & (b <= 1))
        given.ensure("a and twice b", a + b + b <= 2)

    assert not explore(program).proved


def test_a_budget_that_is_too_small_leaves_it_open(monkeypatch):
    def program(given):
        numbers = [given.natural(str(place)) for place in range(4)]
        given.ensure("something", numbers[0] * 6 + numbers[1] * 10 + numbers[2] * 15 != numbers[3] * 30 + 1)

    monkeypatch.setattr(engine, "CHECK_BUDGET", 1)
    assert explore(program).open


def test_a_promise_before_a_program_gives_up_is_judged():
    def program(given):
        given.ensure("never", given.number("a") < 0)
        raise Infeasible

    assert explore(program).counterexample is not None


def test_premises_are_told_by_name_and_those_that_were_used():
    def program(given):
        a, b = given.number("a", "a counts"), given.number("b")
        given.assume(a > 2, "a is large")
        given.assume(b > 2, "b is large")
        given.ensure("a is not small", a > 1)

    outcome = explore(program)
    assert outcome.assumed == {"a counts", "b >= 0", "a is large", "b is large"}
    assert outcome.used == {"a is large"}


def test_a_natural_number_is_whole_and_at_least_nothing():
    def program(given):
        n = given.natural("n")
        given.ensure("at least 0", n >= 0)
        given.ensure("whole", (n <= 0) | (n >= 1))

    outcome = explore(program)
    assert outcome.proved
    assert outcome.assumed == {"n >= 0"}
    assert explore(lambda given: given.ensure("not 0", given.natural("n") > 0)).counterexample.values == {"n": 0}


def test_a_witness_that_breaks_a_promise_on_exact_numbers_is_refused():
    with pytest.raises(EngineError, match="does not keep"):
        explore(lambda given: given.ensure("not on exact numbers", not isinstance(given, Exact)))


def test_a_witness_of_which_nothing_is_promised_on_exact_numbers_is_refused():
    def program(given):
        if not isinstance(given, Exact):
            given.ensure("only of symbolic numbers", True)

    with pytest.raises(EngineError, match="does not keep"):
        explore(program)


def test_a_counterexample_that_breaks_a_premise_on_exact_numbers_is_refused():
    def program(given):
        given.assume(not isinstance(given, Exact))
        given.ensure("never", False)

    with pytest.raises(EngineError, match="breaks a premise"):
        explore(program)


def test_a_comparison_is_the_same_however_it_is_written():
    def program(given):
        a, b = given.number("a"), given.number("b")
        given.ensure("less", (a < b) == (b > a))
        given.ensure("at most", (a <= b) == (b >= a))
        given.ensure("doubled", (a * 2 < b * 2) == (a < b))
        given.ensure("turned", (a * -1 < b * -1) == (b < a))
        given.ensure("not equal", (a != b) == ((a < b) | (a > b)))
        given.ensure("shifted", (1 - a < 1 - b) == (a > b))

    outcome = explore(program)
    assert outcome.proved
    assert outcome.paths == 1


def test_a_quotient_by_a_known_number_is_less():
    def program(given):
        a = given.number("a")
        given.ensure("a third", a * 6 / 3 == a * 2)

    assert explore(program).proved


def test_a_comparison_of_known_numbers_is_a_plain_truth():
    def program(given):
        a = given.number("a")
        zero, one = a - a, a - a + 1
        plain = (zero < one, zero <= 0, zero == 0, one > 0, one >= 1, one != 0, a * 0 == 0)
        given.ensure("all hold", all(truth is True for truth in plain))
        contrary = (zero < 0, one <= 0, zero == 1, zero > 0, zero >= 1, one != 1)
        given.ensure("none holds", all(truth is False for truth in contrary))

    assert explore(program).proved


def test_truths_are_combined_with_plain_ones():
    def program(given):
        a = given.number("a")
        large = a > 1
        given.ensure("and", ((large & True) == large) & ((True & large) == large))
        given.ensure("and not", (large & False) is False)
        given.ensure("or", ((large | False) == large) & ((False | large) == large))
        given.ensure("or so", (large | True) is True)
        given.ensure("neither", ((large == True) == large) & ((large == False) == (a <= 1)))  # noqa: E712

    assert explore(program).proved


def test_branches_that_cannot_be_are_not_run():
    def program(given):
        a = given.number("a")
        given.ensure("something", True)
        if a > 3:
            given.ensure("larger still", bool(a > 2))
        else:
            given.ensure("smaller still", bool(a < 4) and bool(a < 5))
        given.ensure("not below 0", not (a < 0))

    outcome = explore(program)
    assert outcome.proved
    assert outcome.paths == 2


def test_sums_keep_what_is_known_of_both():
    def program(given):
        a, b = given.number("a"), given.number("b")
        given.ensure("sum", (a + 1) + (b + 2) == a + b + 3)
        given.ensure("difference", (a + 1) - (b + 2) == a - b - 1)
        given.ensure("of known and unknown", (1 - a) + (a - 1) == 0)

    assert explore(program).proved


def test_equality_of_truths_is_not_implication():
    def program(given):
        a = given.number("a")
        given.ensure("the larger implies the smaller, not the other way", (a > 2) == (a > 1))

    assert 1 < explore(program).counterexample.values["a"] <= 2


def test_a_watch_is_shown_what_was_judged_and_only_while_it_watches():
    def program(given):
        given.ensure("something", given.number("a") >= 0)

    shown = []
    with engine.watched_by(shown.append):
        outcome = explore(program)
    explore(program)
    (seen,) = shown
    assert seen.outcome is outcome
    assert len(seen.judged) == 1


def test_the_work_of_an_exploration_is_its_own():
    def program(given):
        given.ensure("something", given.number("a") + given.number("b") >= 0)

    explore(program)
    before = engine.work_so_far()
    outcome = explore(program)
    assert 0 < outcome.resources <= engine.work_so_far() - before


def test_counterexamples_are_on_the_coarsest_grid_and_small():
    def halves(given):
        a, b = given.number("a"), given.number("b")
        given.assume((a > 3) & (a < 4))
        given.ensure("never", b < a)

    assert explore(halves).counterexample.values == {"a": Fraction(7, 2), "b": Fraction(7, 2)}

    def quarters(given):
        a = given.number("a")
        given.ensure("nothing between", (a * 5 <= 11) | (a * 5 >= 12) | (a * 100 <= 222))

    assert explore(quarters).counterexample.values["a"] == Fraction(9, 4)


def test_a_counterexample_tells_the_truths_that_it_takes():
    outcome = explore(lambda given: given.ensure("never there", not given.flag("there")))
    assert outcome.counterexample.values == {"there": True}


def test_a_large_model_is_made_small_by_halving():
    number, solver = z3.Real("number"), z3.Solver()
    solver.add(z3.Or(*(number == size for size in (1000, 700, 300, 3))))
    solver.push()
    solver.add(number == 1000)
    assert solver.check() == z3.sat
    large = solver.model()
    solver.pop()
    assert smallest(solver, [number], large).eval(number).as_fraction() == 3


def test_premises_hold_on_every_path_and_are_judged_once():
    def program(given):
        a, b = given.number("a"), given.natural("b")
        given.assume(a <= 1, "a is small")
        given.ensure("it is still small", a <= 1)
        given.assume(b <= 1, "b is small")
        given.flag("a way")
        given.ensure("both are", (a >= 0) & (a <= 1) & (b >= 0) & (b <= 1))

    outcome = explore(program)
    assert outcome.proved
    assert (outcome.paths, outcome.checks) == (2, 7)
    assert outcome.assumed == outcome.used == {"a >= 0", "b >= 0", "a is small", "b is small"}


def made(program, **values):
    """What a program makes of known numbers; None if they break a premise."""
    try:
        return program(Machine(Exact(values)))
    except Infeasible:
        return None


def refuses(product):
    """Whether what is asked for is refused, since it is rounded in a way that is not known."""
    try:
        product()
    except TypeError as error:
        return "is rounded, in a way that is not known here" in str(error)
    return False


QUARTERS = [Fraction(number, 4) for number in range(10)]


@pytest.mark.parametrize(
    ("exact", "least", "most"),
    [(5, 4, 6), (Fraction(1, 2), Fraction(1, 4), Fraction(3, 2)), (0, 0, 0), (-1, -2, -Fraction(1, 4)), (-5, -6, -4)],
)
def test_what_is_held_is_off_by_a_rounding_at_most_and_has_the_sign_of_the_exact_result(exact, least, most):
    found = [made(lambda machine: machine.rounded(Fraction(exact)), **{"error 1": error}) for error in QUARTERS]
    held = {one.held for one in found if one is not None}
    assert held == {quarter for quarter in (exact + error - 1 for error in QUARTERS) if least <= quarter <= most}


def five_and_three(*errors):
    """Two numbers of a machine that makes errors."""
    machine = Machine(Exact({f"error {number}": error for number, error in enumerate(errors, 1)}))
    return machine, Rounded(machine, Fraction(5)), Rounded(machine, Fraction(3))


def test_the_same_sum_is_rounded_alike_and_nothing_added_is_not_rounded():
    machine, one, two = five_and_three(Fraction(3, 2), Fraction(1, 2))
    assert (one + two).held == Fraction(17, 2)
    assert (two + one) is (one + two)
    assert (one - two).held == Fraction(3, 2)
    assert one + two * 0 is one
    assert two * 0 + one is one
    assert one - two * 0 is one
    assert 0 + one is one
    assert (one - one).held == 0
    assert machine.errors == 2


def test_of_numbers_that_are_known_only_a_plain_0_is_nothing():
    for known in (Fraction(0), 1, -1):
        machine, one, _ = five_and_three(Fraction(3, 2), Fraction(3, 2))
        assert (one + known).held == 5 + known + Fraction(1, 2)
        assert (one - known).held == 5 - known + Fraction(1, 2)
        assert machine.errors == 2


def test_a_product_is_rounded_unless_it_changes_only_the_sign_or_the_exponent():
    machine, one, _ = five_and_three(Fraction(3, 2), Fraction(3, 2))
    assert one * 1 is one
    assert [((one * by).held, (one * by).nothing) for by in (-2, -1, 0, 2)] == [
        (-10, False),
        (-5, False),
        (0, True),
        (10, False),
    ]
    assert (one * 0 * 2).nothing
    assert machine.errors == 0
    half = Fraction(1, 2)
    assert (one * half).held == 3
    assert (one * 3).held == 15 + half
    assert machine.errors == 2


def test_a_quotient_is_rounded_before_it_is_divided():
    _, one, _ = five_and_three(Fraction(3, 2), Fraction(3, 2))
    assert one / 1 is one
    assert (one / Fraction(1, 2)).held == 11
    assert (one / 2).held == Fraction(11, 4)


def test_what_is_rounded_in_a_way_that_is_not_known_is_refused():
    _, one, two = five_and_three(1, 1, 1, 1)
    assert refuses(lambda: one * two)
    assert refuses(lambda: one / two)
    for known in (3, Fraction(1, 3)):
        assert not refuses(lambda by=known: one * by)
        assert not refuses(lambda by=known: one / by)


def test_numbers_of_a_machine_are_compared_as_they_are_held():
    _, one, two = five_and_three()
    for other in (two, 3, Fraction(3)):
        assert (one > other, one >= other, one < other, one <= other, one == other) == (True, True, False, False, False)
    assert (two < one, two <= one, two > one, two >= one, two == one) == (True, True, False, False, False)
    same = Rounded(one.machine, Fraction(5))
    assert (one > same, one >= same, one < same, one <= same, one == same) == (False, True, False, True, True)


ONE_WAY = Ways(due=Fraction(100), late=Fraction(20), gone=Fraction(90), astray=Fraction(3))
OTHER_WAY = Ways(due=Fraction(70), late=Fraction(7), gone=Fraction(64), astray=Fraction(1))


def test_ways_are_added_as_velocities_are_and_the_error_is_one_of_the_machine():
    assert ONE_WAY.minus(OTHER_WAY, Fraction(1, 2)) == Ways(30, 13, Fraction(53, 2), Fraction(5, 2))
    assert ONE_WAY.times(-1) == Ways(-100, -20, -90, -3)
    assert ONE_WAY.late_after == 7


def difference_of_speeds(machine):
    """The difference of two velocities that a machine holds."""
    one, other = (
        Speed(machine=machine, held=Fraction(held), ways=ways) for held, ways in ((9, ONE_WAY), (4, OTHER_WAY))
    )
    return one - other


def test_a_difference_of_velocities_goes_astray_by_a_rounding_at_most():
    found = {error: made(difference_of_speeds, **{"error 1": error}) for error in QUARTERS}
    assert [error for error, one in found.items() if one is None] == [Fraction(9, 4)]
    for error in QUARTERS[:-1]:
        assert found[error].held == 5
        assert found[error].ways == ONE_WAY.minus(OTHER_WAY, error - 1)


def test_the_way_that_a_velocity_goes_in_a_time_is_rounded():
    def way(machine):
        return Speed(machine=machine, held=Fraction(9), ways=ONE_WAY) * Time(Fraction(1))

    assert made(way, **{"error 1": Fraction(3, 2)}).held == 90 + Fraction(1, 2)


def test_in_the_time_for_a_way_a_velocity_goes_that_way_but_for_a_rounding():
    def time(machine):
        return Rounded(machine, 90 - Fraction(1, 2)) / Speed(machine=machine, held=Fraction(9), ways=ONE_WAY)

    found = {error: made(time, **{"error 1": error}) for error in QUARTERS}
    assert [error for error, one in found.items() if one is not None] == [Fraction(3, 2)]
    assert found[Fraction(3, 2)] == Time(90 - Fraction(1, 2))


def test_times_are_compared_by_their_signs():
    assert Time(Fraction(1)) * 0 <= Time(Fraction(0))
    assert Time(Fraction(-1)) <= Time(Fraction(0))
    assert not Time(Fraction(1)) <= Time(Fraction(0))
