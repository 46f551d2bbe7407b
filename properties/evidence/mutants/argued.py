"""The mutants that change nothing that counts, by an argument of a line each, because no solver was asked; and those
that nothing notices, though something might.
"""

from __future__ import annotations

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

OPEN = frozenset(
    {
        "request.request_is_its_segments: drop given.ensure('it walks by these rules', tow.walk is stand_ins.walk)",
        "request.request_is_its_segments: drop given.ensure('each segment is of this body, by these rules', own is "
        "stand_ins and view is seen and (body == ME))",
        "request.request_is_its_segments: drop given.ensure('it leaves from where the front went', leaving.front is "
        "rounds[-1].at)",
        "request.request_is_its_segments: drop given.ensure('it leaves from where the rear was towed', leaving.rear is "
        "rear_goes)",
        "request.request_is_its_segments: view.along(motion.at, went * 0) instead of view.along(motion.at, went)",
        "request.rear_walks_on: True instead of False",
        "request.rear_follows_by_the_same: drop given.ensure('the rear ends where its walks went', ends is "
        "rounds[-1].at)",
        "request.rear_follows_by_the_same: drop given.ensure('its way is open as far as it goes', step.way.distance == "
        "step.motion.rest)",
        "request.segment_is_a_function: drop given.ensure('the same distance', one.rest == two.rest)",
        "request.segment_is_a_function: drop given.ensure('the same border', (one.at.travelled == two.at.travelled) & "
        "(one.at.reach == two.at.reach))",
        "request.segment_is_a_function: drop given.ensure('the same requests', len(first.asks) == len(again.asks))",
        "lemma.two_requests_are_one: regained == 0 instead of (regained == 0) | (both.moved == a + b)",
        "lemma.two_requests_are_one: later.neighbour + regained * 0 instead of later.neighbour + regained",
        "lemma.gap_after: ahead.gap + pushed + by_itself * 0 instead of ahead.gap + pushed + by_itself",
        "lemma.gap_after: pushed >= 0 instead of pushed == 0",
        "lemma.full_circle_stands: drop given.ensure('the body ahead does not move', stretch.pushed == 0)",
        "leaving.jumps_lead_down_least: drop given.ensure('nothing obstructs the fall', not leaving.near)",
        "leaving.jumps_lead_down_least: other.drop >= jump.drop instead of other.drop == jump.drop",
        "leaving.near_jumps_are_as_short: drop given.ensure('it leaves from where it is', same & (leaving.moved == "
        "moved) & (leaving.width == width))",
        "window.capacity: seen.gap_before + neighbour * 0 instead of seen.gap_before + neighbour",
        "window.capacity: wall is not None instead of seen.neighbour and wall is not None",
    }
)
"""The mutants of obligations that no wrong rule and no wrong contract tells from the true one, though they are not
proved to be the same. They do not fail the build, and count as nothing that is caught; a new one fails it.
"""
UNNOTICED = "open: nothing notices it"
