"""Contracts: every clause is proved of the rules, and monitored on what they do; a wrong rule breaks one by name."""

from collections import Counter
from dataclasses import replace
from fractions import Fraction
from functools import partial

import pytest

from properties.claims.catalogue import CLAIMS
from properties.claims.claim import Verdict
from properties.contracts import lemma, strings, ticks
from properties.contracts.contract import (
    LEAVING,
    REAR,
    REQUEST,
    REQUEST_EXACT,
    SEGMENT,
    SEGMENT_EXACT,
    Call,
    Clause,
    Stretch,
)
from properties.contracts.request import judged
from properties.engine.explore import Exploration, explore
from properties.evidence import sample, settle as settling
from properties.evidence.deeds import do
from properties.evidence.monitor import ON_ANY_LEVEL, ON_ONE_STRING, Monitor, Verdicts
from properties.evidence.sample import ROWS as RANDOM_ROWS, Campaign, campaign, failing, monitored
from properties.strategies.rows import Trial
from properties.worlds.rows import located, string_graph
from reference.simulator import Game, move
from reference.world import Facing, World
from spec.body import Body, Level
from spec.graph import Direction
from spec.invariants import FULL_CIRCLE
from spec.profiles import THESIS
from spec.rule import Family
from spec.rules.leave import Placement
from spec.rules.push import Way
from spec.rules.request import segment
from spec.rules.walk import Motion
from spec.transform import in_floats, split

ONE, MARGIN = Fraction(1), Fraction(1, 4)
RIGHT = Direction.RIGHT
CHAPTERS = ("request/", "lemma/", "leaving/", "ticks/")
CONTRACTS = {one.id: one for one in ON_ONE_STRING}


def row(lengths, lefts, closed=False):
    """A world of bodies one wide on a string of edges."""
    lengths = [Fraction(length) for length in lengths]
    borders = [tuple(located(lengths, Fraction(at), closed) for at in (left, left + 1)) for left in lefts]
    bodies = tuple(Body(chr(65 + i), left, right, ONE, ONE) for i, (left, right) in enumerate(borders))
    return World(Level(string_graph(lengths, sum(lengths) if closed else None), MARGIN, ONE, bodies))


ROWS = (row([8], [0, 2, 4]), row([3, 2, 9], [0, Fraction(5, 4), 5]), row([4, 5], [0, 2, 5], closed=True))


def watched(profile, worlds=ROWS, tolerance=Fraction(0), contracts=ON_ONE_STRING):
    """What monitors find in requests of the first body of some worlds, short and long."""
    verdicts = Verdicts()
    for world in worlds:
        for distance in (Fraction(1, 2), Fraction(5)):
            monitor = Monitor(profile, world.copy(), RIGHT, tolerance, contracts, verdicts)
            monitor.run(0, distance + world.margin * 0)
    return verdicts


def changed(family, rule, **change):
    """The thesis' rules with one rule of a family changed."""
    own = getattr(THESIS.rules, family)
    rules = tuple(replace(one, **change) if one.id == rule else one for one in own.rules)
    return replace(THESIS, rules=replace(THESIS.rules, **{family: Family(family, rules)}))


class Noted(Exploration):
    """An exploration that notes the names of promises, and does not judge them: that is for the check."""

    def new_path(self):
        path = super().new_path()
        ensure = path.ensure

        def noted(name, promise):
            PROMISED[self.program.args[0]].add(name)
            ensure(name, promise)

        path.ensure, path.judge = noted, lambda: None
        return path


PROMISED = {}


def contracts_in(names):
    """The IDs of the contracts of which some names are clauses."""
    return {name.partition(": ")[0] for name in names if name.startswith("contract/")}


@pytest.mark.slow
def test_every_clause_is_promised_and_none_stands_in_that_the_claim_does_not_prove():
    claims = [claim for claim in CLAIMS if claim.profile is THESIS]
    obligations = {one.id: one for claim in claims for one in claim.obligations if one.id.startswith(CHAPTERS)}
    assumed = {}
    for name, obligation in obligations.items():
        PROMISED[obligation.program] = set()
        assumed[name] = Noted(partial(judged, obligation.program, THESIS)).run().assumed
        promised = PROMISED[obligation.program]
        assert contracts_in(promised | assumed[name]) == set(obligation.contracts), name
    required = {one.name(clause) for one in CONTRACTS.values() for clause in one.requires}
    for claim in claims:
        ours = [one for one in claim.obligations if one.id in obligations]
        promised = set().union(*(PROMISED[obligations[one.id].program] for one in ours))
        stood_in = {name for one in ours for name in assumed[one.id] - required if name.startswith("contract/")}
        assert stood_in <= promised, claim.id
    everywhere = set().union(*PROMISED.values())
    assert {one.name(clause) for one in CONTRACTS.values() for clause in one.promises} <= everywhere


def test_contracts_have_a_measure_or_say_why_there_is_none():
    for contract in CONTRACTS.values():
        assert contract.measure.sentence
        assert (contract.measure.falls is None) == (contract is LEAVING)


@pytest.mark.parametrize("floats", [False, True])
def test_the_rules_keep_all_contracts_and_each_is_evaluated(floats):
    worlds = [World(in_floats(world.level)) for world in ROWS] if floats else ROWS
    verdicts = watched(THESIS, worlds, 1e-9 if floats else Fraction(0))
    assert (verdicts.broken, verdicts.unmet) == ([], [])
    assert set(verdicts.evaluations) == set(CONTRACTS)
    assert min(verdicts.evaluations.values()) > 0


@pytest.mark.parametrize("limit", [1, 2])
def test_the_contracts_hold_at_any_push_limit_and_for_a_body_that_may_not_push(limit):
    worlds = [world.copy() for world in ROWS]
    worlds[0].bodies[1] = replace(worlds[0].bodies[1], pushes=False)
    verdicts = watched(replace(THESIS, push_limit=lambda bodies: limit), worlds)
    assert (verdicts.broken, verdicts.unmet) == ([], [])


def test_every_request_of_a_chain_is_evaluated():
    verdicts = Verdicts()
    Monitor(THESIS, ROWS[0].copy(), RIGHT, Fraction(0), ON_ONE_STRING, verdicts).run(0, Fraction(5))
    assert verdicts.evaluations[REQUEST.id] == verdicts.evaluations[LEAVING.id] == 3


def blocked_at_the_stride(answer):
    """Walk into whoever has stopped."""
    return Way(answer.stride, blocked=True)


def says_it_moved(step):
    """Stay, and say that the way was walked."""
    return Motion(step.motion.at, step.motion.rest - step.way.distance, going=False)


def moved_twice(leaving):
    """Stay, and say that it was twice as far."""
    return Placement(leaving.front, leaving.rear, leaving.moved * 2)


def without_end(rules, view, body, motion, spare):
    """A segment that hands on as many spare asks as it has."""
    running, answer = segment(rules, view, body, motion, spare), None
    while True:
        try:
            ask = running.send(answer)
        except StopIteration as end:
            return end.value
        answer = yield replace(ask, spare=spare)


WRONG = {
    "asks for more than is missing": (REQUEST_EXACT, changed("push", "push/request", effect=lambda want: want.stride)),
    "asks nobody": (SEGMENT_EXACT, changed("push", "push/request", effect=lambda want: None)),
    "goes on into who has stopped": (SEGMENT, changed("contact", "contact/stop", effect=blocked_at_the_stride)),
    "goes nearer than the margin": (SEGMENT_EXACT, changed("clearance", "clearance/margin", effect=lambda s: s.gap)),
    "does not walk": (SEGMENT, changed("walk", "walk/along", effect=says_it_moved)),
    "does not walk its rear": (REAR, changed("walk", "walk/along", effect=says_it_moved)),
    "leaves its rear behind": (REQUEST, changed("follow", "follow/rear", effect=lambda tow: tow.rear)),
    "says more than it moved": (LEAVING, changed("leave", "leave/stay", effect=moved_twice)),
    "hands on all spare asks": (SEGMENT, replace(THESIS, rules=replace(THESIS.rules, segment=without_end))),
}


@pytest.mark.parametrize("fault", WRONG)
def test_a_wrong_rule_breaks_a_contract_by_name(fault):
    contract, profile = WRONG[fault]
    broken = watched(profile).broken
    assert any(name.startswith(f"{contract.id}: ") for name in broken), broken


def test_a_clause_that_is_wrong_breaks_too():
    never = replace(SEGMENT, ensures=(Clause("does what no segment does", lambda call: False),))
    verdicts = Verdicts()
    verdicts.judge(never, Stretch(asked=ONE, moved=ONE))
    assert verdicts.broken == ["contract/segment: does what no segment does"]


def test_a_call_that_misses_a_requirement_is_not_evaluated():
    verdicts = Verdicts()
    verdicts.judge(REQUEST, Call(asked=-ONE, moved=ONE))
    assert verdicts.unmet == ["contract/request: asks for a distance of at least 0"]
    assert verdicts.evaluations == Counter()
    assert verdicts.broken == []


def test_the_capacity_on_a_world_is_that_of_the_closed_form():
    world = ROWS[1]
    ahead = Monitor(THESIS, world, RIGHT, Fraction(0), (), Verdicts()).ahead(0, world.bodies[0].right, 2)
    moved, _ = move(THESIS, world.copy(), 0, RIGHT, Fraction(100))
    assert ahead.capacity() == moved == 14 - 3 - 2 * MARGIN


def test_a_trial_names_the_contract_that_a_wrong_rule_breaks_and_counts_what_was_evaluated():
    world, seen = ROWS[0], Campaign(RANDOM_ROWS)
    trial = Trial(world.level, 0, RIGHT, Fraction(5), (RIGHT,))
    assert list(failing(THESIS, trial, False, seen)) == []
    assert set(seen.evaluations) == set(CONTRACTS)
    _, profile = WRONG["goes nearer than the margin"]
    failed = list(failing(profile, trial, False, seen))
    assert "contract/segment-exact: keeps the margin" in failed
    assert {"invariant/no-overlap", "invariant/margins-over-time"} <= set(failed)
    _, profile = WRONG["leaves its rear behind"]
    assert "invariant/order-over-time" in failing(profile, trial, False, seen)


def test_on_a_row_a_requirement_that_is_not_met_is_a_failure():
    near = row([8], [0, Fraction(9, 8)])
    trial = Trial(near.level, 0, RIGHT, Fraction(1))
    unmet = monitored(THESIS, trial, near, Fraction(0), Campaign(RANDOM_ROWS))
    assert "contract/request-exact: neighbours are the margin apart" in unmet


@pytest.mark.parametrize("limit", [1, 2, 3])
def test_on_a_full_circle_nobody_moves_and_the_chain_ends_at_the_push_limit(limit):
    full = row([2, Fraction(7, 4)], [0, Fraction(5, 4), Fraction(5, 2)], closed=True)
    profile = replace(THESIS, push_limit=lambda bodies: limit)
    deed, record = do(profile, full, 1, RIGHT, Fraction(1), Fraction(0))
    assert (deed.moved, record.depth) == (0, limit)
    assert "push/limit" in {rule for _, rule in record.fired}
    assert FULL_CIRCLE.holds(deed)
    assert not FULL_CIRCLE.holds(replace(deed, moved=Fraction(1, 8)))


def test_a_campaign_that_never_evaluates_a_contract_counts_for_nothing(monkeypatch):
    assert set(CONTRACTS) <= set(Campaign(RANDOM_ROWS).tame)
    result = Campaign(RANDOM_ROWS, cases=9, evaluations=Counter(dict.fromkeys(CONTRACTS, 9)))
    assert not set(CONTRACTS) & set(result.tame)
    monkeypatch.setattr(sample, "ON_ONE_STRING", ON_ANY_LEVEL)
    assert REQUEST_EXACT.id not in campaign(THESIS, floats=False, examples=20).evaluations


def test_a_contract_that_breaks_on_a_random_row_refutes_the_claims_that_rest_on_it():
    claim, other = settling.by_id("claim/no-overlap"), settling.by_id("claim/rule-count")
    failure = f"{SEGMENT.id}: passes nobody"
    assert settling.concerns(claim, failure)
    assert not settling.concerns(other, failure)
    showings = {job: settling.Showing("z3", 0.0, 1) for job in settling.jobs_of(claim)}
    rows = next(job for job in showings if job[0] == "sample")
    showings[rows] = settling.Showing("hypothesis", 0.0, 1, failures={failure: "a trial"})
    assert settling.verdict_of(claim, list(showings.values()))[0] is Verdict.REFUTED


def outcome_of(program, **more):
    """What an exploration of an obligation on worlds shows."""
    return explore(partial(judged, partial(program, **more), THESIS))


@pytest.mark.parametrize("closed", [False, True])
def test_a_mirror_image_that_is_not_one_is_found(monkeypatch, closed):
    monkeypatch.setattr(strings, "mirror", lambda level: level)
    outcome = outcome_of(strings.mirror_image_is_alike, closed=closed, one_edge=False)
    assert "the same coordinate" in outcome.counterexample.broken


@pytest.mark.parametrize("cut", [1, 2])
def test_a_split_that_loses_a_piece_is_found(monkeypatch, cut):
    monkeypatch.setattr(strings, "split", split_from_behind)
    outcome = outcome_of(strings.split_is_alike, closed=False, one_edge=False, cut=cut)
    assert outcome.proved, "cutting elsewhere changes nothing"
    monkeypatch.setattr(strings, "split", shortened)
    outcome = outcome_of(strings.split_is_alike, closed=False, one_edge=False, cut=cut)
    assert "the same length" in outcome.counterexample.broken


def split_from_behind(level, edge, at, vertex):
    """A split as far from the right end of the edge."""
    return split(level, edge, level.graph.edges[edge].length - at, vertex)


def shortened(level, edge, at, vertex):
    """A split that halves the left part."""
    parts = split(level, edge, at, vertex)
    edges = [replace(one, length=at * Fraction(1, 2)) if i == edge else one for i, one in enumerate(parts.graph.edges)]
    return replace(parts, graph=replace(parts.graph, edges=tuple(edges)))


@pytest.mark.parametrize(
    ("method", "wrong", "broken"),
    [
        ("along", lambda own: lambda view, at, by: own(view, at, by * 2), "it lessens the gap"),
        ("end", lambda own: lambda view, at: view.along(at, view.world.margin), "the end of the edge is reached"),
        ("ahead", lambda own: lambda view, body, at: None, "on this edge and the next a body is seen"),
        ("place", lambda own: lambda view, body, front, rear: own(view, 1, rear, front), "no other body has moved"),
    ],
)
def test_a_world_that_breaks_a_law_is_found(monkeypatch, method, wrong, broken):
    monkeypatch.setattr(Facing, method, wrong(getattr(Facing, method)))
    outcome = outcome_of(strings.laws_hold, closed=False, last=False, direction=RIGHT)
    assert broken in outcome.counterexample.broken


def test_a_pair_of_which_one_may_pass_the_other_is_found(monkeypatch):
    monkeypatch.setattr(lemma, "REQUEST", replace(REQUEST, ensures=REQUEST.ensures[:2]))
    outcome = explore(lambda given: lemma.neighbours_stay_in_order(THESIS.rules, given))
    assert outcome.counterexample is not None


def test_a_full_circle_that_turns_is_found():
    rules = changed("push", "push/limit", effect=lambda want: want.stride).rules
    limitless = replace(rules, contact=changed("contact", "contact/stop", effect=blocked_at_the_stride).rules.contact)
    outcome = explore(lambda given: judged(lambda p, g: lemma.full_circle_stands(p.rules, g), of(limitless), given))
    assert "it does not move" in outcome.counterexample.broken


def of(rules):
    """The profile thesis, with other rules."""
    return replace(THESIS, rules=rules)


def test_a_tick_that_moves_characters_in_no_order_of_the_reading_or_boxes_is_found(monkeypatch):
    for order in (lambda names: names[::-1], lambda names: names[:1]):
        backwards = replace(THESIS, tick_order=lambda names, order=order: order(list(names)))
        assert outcome_of_tick(backwards).proved, "the reading says the order"
    monkeypatch.setattr(Game, "per_tick", lambda game, speed: speed * 2)
    assert "by its speed times the tick" in outcome_of_tick(THESIS).counterexample.broken
    monkeypatch.setattr(Game, "per_tick", lambda game, speed: speed * -1)
    assert "in the direction of the key" in outcome_of_tick(THESIS).counterexample.broken


def outcome_of_tick(profile):
    """What an exploration of a tick shows."""
    return explore(partial(judged, ticks.tick_is_its_requests, profile))
