"""The mutants that change no answer, with the reason of each: most are of the engine, and change how much work it does.

No solver can say of the engine what it does not change: it is the solver that is asked less, or more. Where work is
counted, a test notices; see `tests/test_engine.py`.
"""

from __future__ import annotations

CHANGES_NO_ANSWER = "changes no answer"

SCALED = "of one sign with its inverse; a comparison may be multiplied by what is greater than 0"
ARGUED = {
    "simulator.Game.request: distance <= zero instead of distance < zero": "by nothing, nobody moves either way",
    "batch.accumulate: rows <= MANY_ROWS instead of rows < MANY_ROWS": "few rows and many are swept to the same",
    "batch.ways: 1 + row.max(initial=-1) + row.max(initial=-1) instead of 1 + row.max(initial=-1)": "room to spare",
    "batch.several_speeds: 1 + level.max(initial=-1) + level.max(initial=-1) instead of 1 + level.max(initial=-1)": (
        "room to spare"
    ),
    "batch.sweep: far >= 0 instead of far > 0": "who goes nowhere is swept in vain",
    "explore.solver_for_reals: drop solver.set('random_seed', seed)": "the seed decides the work, and no answer",
    "explore.work_so_far: drop solver.check()": "what is counted is that of all solvers so far",
    "explore.Path.decide: self.met >= len(forks) instead of self.met == len(forks)": "it is never more",
    "simplest.solved: drop solver.set('rlimit', SEARCH_BUDGET)": "without a budget, an answer may take longer",
    "simplest.smallest: total < z3.Q(middle.numerator, middle.denominator, solver.ctx) instead of total <= "
    "z3.Q(middle.numerator, middle.denominator, solver.ctx)": "it is about as small as can be, by one halving less",
    "reals.known: exact.denominator <= 1 instead of exact.denominator == 1": "a denominator is at least 1",
    "reals.Symbolic.plus: sign >= 0 instead of sign > 0": "a sign is 1 or -1",
    "reals.Symbolic.compare: 1 * Fraction(first) instead of 1 / Fraction(first)": SCALED,
    "reals.Symbolic.compare: first <= -1 instead of first == -1": SCALED,
    "reals.Symbolic.compare: first >= -1 instead of first == -1": SCALED,
    "reals.Symbolic.compare: first <= 0 instead of first < 0": "a factor is not 0",
    "storeys.StoreyWorld.to_ledge: reach > round_ instead of reach >= round_": (
        "who is on ground all round sees it on for more than once round; else it ends before once round"
    ),
    "request.Seen.choose: drop self.given.saw(rule.id)": "which rules fire is noted, and no promise is about that",
    "designs.centres_are_lawful: world.copy().facing(direction) instead of world.facing(direction)": "it is only read",
    "physics.box: left + 1 * 0 instead of left + 1": "segments are stood in for, so nobody asks how wide a body is",
    "parting.who_is_beyond_is_as_fast: less <= 0 <= others.ahead instead of less <= 0 < others.ahead": (
        "where nothing is passed on in the whole row either, the two rows are given the same, and are alike"
    ),
    "reals.Symbolic.compare: relation <= '<' instead of relation == '<'": "no other relation comes before it",
}
