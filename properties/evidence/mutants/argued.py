"""The mutants that change nothing that counts, by an argument of a line each, because no solver was asked; and those
that nothing notices, though something might.
"""

from __future__ import annotations

CHANGES_NO_ANSWER = "changes no answer"
FEWER_QUESTIONS = "the last model only saves a question; a branch that cannot be would be run in vain, and be noticed"

ARGUED = {
    "plane.Box.beside: False instead of True (2)": "a box that asks is that of a body, and has a bottom",
    "plane.negated: truth <= False instead of truth == False": "of two truths, only False is at most False",
    "plane.box: right < left instead of circumference is not None and right < left": "on a line, left borders are left",
    "plane.box: right <= left instead of right < left": "bodies have a width",
    "plane.terrain: edge.rise == 0 instead of edge.type is EdgeType.GROUND and edge.rise == 0": "no fall edge is level",
    "request.drive: ask.body >= NEIGHBOUR instead of ask.body == NEIGHBOUR": (
        "there are two bodies, and the name of the other comes before"
    ),
    "explore.solver_for_reals: drop solver.set('rlimit', CHECK_BUDGET)": "without a budget, an answer may take longer",
    "explore.solver_for_reals: drop solver.set('random_seed', seed)": "the seed decides the work, and no answer",
    "explore.work_so_far: drop solver.check()": "what is counted is that of all solvers so far",
    "explore.Exploration.run_path: path.promises and (not self.outcome.open) instead of self.outcome.witness is None "
    "and path.promises and (not self.outcome.open)": "a witness is made for each path, and one is enough",
    "explore.Exploration.run_path: self.outcome.witness is None and path.promises instead of self.outcome.witness is "
    "None and path.promises and (not self.outcome.open)": "where something is open, nothing is proved, witness or not",
    "explore.Path.flag: len(self.exploration.drawn.flags) >= MOST_DRAWN instead of len(self.exploration.drawn.flags) > "
    "MOST_DRAWN": "a bound of one less is a bound",
    "explore.Path.decide: self.met >= len(forks) instead of self.met == len(forks)": "it is never more",
    "explore.Path.note: z3.is_true(self.model.eval(literal, model_completion=True)) instead of not "
    "z3.is_true(self.model.eval(literal, model_completion=True))": FEWER_QUESTIONS,
    "explore.Path.note: self.model is not None instead of self.model is not None and (not "
    "z3.is_true(self.model.eval(literal, model_completion=True)))": FEWER_QUESTIONS,
    "simplest.simplest_values: drop solver.set('rlimit', SEARCH_BUDGET)": "without a budget, an answer may take longer",
    "simplest.smallest: total < z3.Q(middle.numerator, middle.denominator, solver.ctx) instead of total <= "
    "z3.Q(middle.numerator, middle.denominator, solver.ctx)": "it is about as small as can be, by one halving less",
    "reals.Symbolic.plus: sign >= 0 instead of sign > 0": "a sign is 1 or -1",
    "reals.Symbolic.compare: scale <= 0 instead of scale < 0": "a scale is not 0",
    "reals.Symbolic.compare: relation <= '<' instead of relation == '<'": "no other relation comes before it",
}
