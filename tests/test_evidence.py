"""The evidence itself: claims have floors, random trials are not tame, wrong rules are caught by name."""

import re
from dataclasses import replace
from pathlib import Path

import pytest

from properties.claims.catalogue import CLAIMS
from properties.claims.claim import Verdict
from properties.contracts.request import judged
from properties.engine.explore import explore
from properties.evidence import settle as settling
from properties.evidence.sample import FLOORS, ONE_RULE, campaign
from properties.evidence.witness import refute, write_witness
from properties.explain import everything
from properties.map.trails import NAMES
from reference.play import LIBRARY, play
from spec.conditions import ALONE, CONDITIONS, TWO_AT_MOST
from spec.guidelines import GUIDELINES, kept_by
from spec.models import MODELS
from spec.profiles import REPAIRED, THESIS
from spec.registry import rules_of, statements
from spec.rule import Family

PROVED, BOUNDED, TESTED, REFUTED = Verdict.PROVED, Verdict.BOUNDED, Verdict.TESTED, Verdict.REFUTED
STRENGTH = {PROVED: 3, REFUTED: 3, BOUNDED: 2, TESTED: 1, Verdict.UNKNOWN: 0}

FLOORS_OF_VERDICTS = {
    PROVED: """
        no-overlap order termination rigid-width on-graph at-most-asked direction bystanders as-far-as-possible
        closed-form determinism additive translation one-rule-applies leaves-only-beyond no-jump-leads-up
        mirror edge-split full-circle margins-over-time order-over-time world-is-lawful nearly-exact
        margin-nearly-kept step-nearly-exact step-nearly-exact-on-rings
        landing-keeps-width stays-in-wall near-jump-edges landing-position landing-position/overshoot
        long-edges-fit
        one-step-rule-applies contacts-do-not-close squeezed-bodies-stand speeds-are-wished
        one-velocity-rule-applies one-velocity-rule-applies/repaired speed-is-bounded speed-is-bounded/repaired
        friction-turns-nothing friction-turns-nothing/repaired resistance-only-resists resistance-only-resists/repaired
        rest-is-kept-by-friction rest-is-kept-by-friction/repaired velocities-ask-for-their-way
        coefficient-of-friction coefficient-of-friction/repaired minimum-stops minimum-stops/repaired
        velocity-after-a-move velocity-after-a-move/repaired
        tops-are-chosen drives-add-up step-furthest step-one-way step-instants-of-one rows-are-monotone
        instants-have-no-bound
        step-margin step-terrain step-support step-seat step-order step-motion step-not-raised step-bystanders
        step-progress step-squeezed step-one-key step-mirror step-split step-body-order step-riders
        one-display-rule-applies falls-are-smooth falls-arrive shown-upon-support turns-are-smooth centres-are-lawful
        no-falls-no-leaving no-collisions-no-pushing no-width-no-jumps
    """,
    BOUNDED: """
        proxy-on-level-ground whole-rows terrain plane-apart-of-two horizontal-alone
        supports-end never-raised height-kept
        supports-end/overshoot never-raised/overshoot height-kept/overshoot
        rest-up-to-the-coefficient rest-up-to-the-printed-slope way-without-friction way-without-friction/repaired
        drag-leaves-a-part drag-leaves-a-part/repaired drag-takes-by-the-way
        enough-for-the-plane enough-for-the-plane/overshoot enough-for-three enough-for-three/overshoot
        batches-end-alike batches-go-on step-instants whole-steps requests-end-alike
        designs-agree designs-agree-on-rings discrete-turns discrete-turns-are-steps discrete-turns-are-steps-of-more
        order-without-width order-without-width/no-falls trouble-is-gone/no-falls trouble-is-gone/no-collisions
        trouble-is-gone/no-width trouble-is-gone/no-collisions/no-falls trouble-is-gone/no-collisions/no-width
        trouble-is-gone/no-falls/no-width trouble-is-gone/overshoot/no-collisions trouble-is-gone/overshoot/no-width
        trouble-is-gone/overshoot/no-collisions/no-width
    """,
    TESTED: """
        rule-count invariants-judge step-invariants-judge storeys-are-measured long-rows-need-more losses-add-up
        queries-of-a-push queries-at-transitions long-strings walls-reached-exactly every-rule-fires
        step-out-of-reach differences-have-causes witnesses-mended
        no-energy-gained no-energy-gained/repaired stopping-way stopping-way/repaired invariants-at-any-velocity
        falls-end cuts-do-not-matter display-rules-fire circles-are-even nobody-drops-unseen
        designs-cost margins-are-for-floats
        cases-are-complete cases-are-complete/overshoot
    """,
    REFUTED: """
        no-overlap-on-short-edges pushing-on-short-edges split-anywhere additive-on-any-ring
        neighbours-not-twice loops-only-on-a-full-circle constant-speed-in-contact terrain/overshoot
        plane-apart-of-two/overshoot plane-margin plane-margin/overshoot horizontal horizontal/overshoot
        jump-clear-of-riders jump-clear-of-riders/overshoot what-leads-up-obstructs what-leads-up-obstructs/overshoot
        carried-clear carried-clear/overshoot no-short-pit no-short-pit-heights no-overhang-from-body no-tunnel
        no-fall-onto-middle no-sharp-ledge no-fall-off-body no-landing-does-not-fit
        rest-on-slopes friction-by-the-cosine printed-drag-by-the-way minimum-lets-begin
        no-higher-through-a-valley
        frames-do-not-matter nobody-is-shown-rising three-cost-as-two ledges-are-left-alike
        no-other-strings proxy-on-level-ground/overshoot proxy-on-slanted-falls proxy-on-tilted-landings
        order-without-width/overshoot
    """,
}


def test_no_claim_expects_less_than_its_floor_and_none_is_missing():
    floors = {f"claim/{name}": floor for floor, names in FLOORS_OF_VERDICTS.items() for name in names.split()}
    expected = {claim.id: claim.expected for claim in CLAIMS}
    assert expected.keys() == floors.keys()
    for name, floor in floors.items():
        assert STRENGTH[expected[name]] >= STRENGTH[floor], name
        assert (expected[name] is REFUTED) == (floor is REFUTED), name


def test_every_claim_has_evidence_and_known_premises():
    for claim in CLAIMS:
        assert claim.obligations or claim.counts or claim.erratum or claim.hunt or claim.sampled, claim.id
        assert set(claim.premises) <= {condition.id for condition in CONDITIONS}, claim.id
        if claim.expected is REFUTED:
            assert claim.erratum is not None or claim.hunt is not None, claim.id


def test_every_statement_has_its_own_speaking_id_a_sentence_and_a_source():
    for name, statement in everything().items():
        assert statement.id == name
        assert "/" in name
        assert statement.sentence.endswith(".")
        assert statement.source


def test_every_premise_is_assumed_by_a_claim_or_by_the_map():
    assumed = {premise for claim in CLAIMS for premise in claim.premises} | {ALONE.id, TWO_AT_MOST.id}
    assert {ALONE.id, TWO_AT_MOST.id} <= set(NAMES)
    assert assumed == {condition.id for condition in CONDITIONS}


@pytest.mark.parametrize("profile", [THESIS, REPAIRED], ids=["thesis", "repaired"])
@pytest.mark.slow
def test_the_proofs_for_any_number_of_bodies_make_every_rule_fire(profile):
    obligations = {
        o.id: o
        for claim in CLAIMS
        if claim.profile == profile and not claim.long
        for o in claim.obligations
        if o.bodies is None
    }
    fired = set()
    for obligation in obligations.values():
        fired |= explore(lambda given, o=obligation: judged(o.program, profile, given)).rules
    assert {rule.id for rule in rules_of(profile)} <= fired


@pytest.mark.parametrize("floats", [False, True])
def test_a_short_campaign_holds_and_is_not_tame(floats):
    result = campaign(THESIS, floats, examples=100)
    assert result.failures == {}
    assert result.tame == []
    assert set(FLOORS) <= set(result.shares)


@pytest.mark.slow
def test_a_campaign_names_each_property_that_fails_with_its_simplest_trial():
    without_limit = replace(THESIS, push_limit=lambda bodies: 1)
    careless = replace(
        THESIS.rules,
        clearance=Family(
            "clearance", tuple(replace(r, effect=lambda s: s.stride) for r in THESIS.rules.clearance.rules)
        ),
    )
    result = campaign(replace(without_limit, rules=careless), floats=False, examples=100)
    assert "invariant/no-overlap" in result.failures
    assert len(result.failures["invariant/no-overlap"].level.bodies) == 2


def test_a_family_with_a_hole_is_named():
    push = Family("push", THESIS.rules.push.rules[1:])
    result = campaign(replace(THESIS, rules=replace(THESIS.rules, push=push)), floats=False, examples=50)
    assert ONE_RULE in result.failures


@pytest.mark.parametrize("claim", [c for c in CLAIMS if c.erratum is not None and not c.long], ids=lambda c: c.id)
def test_a_refuted_claim_has_a_witness_that_the_simulator_replays(claim, tmp_path):
    found = refute(claim.profile, claim.erratum).counterexample
    assert found is not None
    path = write_witness(claim, found.values, None, tmp_path)
    playing = play(path)
    assert len(list(playing.steps)) == len(playing.scenario.steps) > 0


def test_the_witness_against_short_edges_ends_nearer_than_the_margin(tmp_path):
    claim = settling.by_id("claim/no-overlap-on-short-edges")
    path = write_witness(claim, refute(claim.profile, claim.erratum).counterexample.values, None, tmp_path)
    playing = play(path)
    game = playing.game
    assert game.world.clear(0, 1) >= game.world.margin
    list(playing.steps)
    assert game.world.clear(0, 1) < game.world.margin


def test_a_failed_piece_of_evidence_makes_its_claim_refuted():
    claim = settling.by_id("claim/no-overlap")
    showings = {job: settling.Showing("z3", 0.0, 1) for job in settling.jobs_of(claim)}
    assert settling.settle(claim, showings, Path("unused")).verdict is PROVED
    job = next(iter(showings))
    showings[job] = settling.Showing("z3", 0.0, 1, failures={"the margin is kept": "gap = 0"})
    assert settling.settle(claim, showings, Path("unused")).verdict is REFUTED


def test_a_proof_that_assumes_what_its_claim_does_not_list_settles_nothing():
    claim = settling.by_id("claim/no-overlap")
    showings = {job: settling.Showing("z3", 0.0, 1) for job in settling.jobs_of(claim)}
    bare = replace(claim, premises=("condition/one-string",))
    settled = settling.settle(bare, showings, Path("unused"))
    assert settled.verdict is Verdict.UNKNOWN
    assert "its proof assumes condition/edges-long, which it does not list" in settled.reasons


def test_the_default_push_limit_is_the_number_of_bodies():
    assert [THESIS.push_limit(bodies) for bodies in (1, 2, 7, 1000)] == [1, 2, 7, 1000]


def test_what_is_open_makes_its_claim_unknown():
    claim = settling.by_id("claim/order")
    showings = {job: settling.Showing("z3", 0.0, 1, open=("budget",)) for job in settling.jobs_of(claim)}
    assert settling.settle(claim, showings, Path("unused")).verdict is Verdict.UNKNOWN


def test_statements_have_unique_ids():
    assert len(statements()) == len({id(statement) for statement in statements().values()})


def test_every_rule_row_of_the_register_is_accounted_for():
    sources = " ".join(s.source for s in statements().values() if s.kind in ("rule", "model", "invariant"))
    rows = set(re.findall(r"R\d+", sources))
    assert {f"R{row}" for row in range(1, 36)} - rows == set()


@pytest.mark.parametrize("model", MODELS, ids=lambda model: model.id)
def test_a_model_is_seen_in_a_scenario(model):
    assert list(play(LIBRARY / "scenarios" / f"{model.scenario}.json").steps)


@pytest.mark.parametrize("seed", [1, *(pytest.param(seed, marks=pytest.mark.slow) for seed in (2, 3))])
@pytest.mark.parametrize("name", ["terrain/overshoot", "plane-margin", "horizontal/overshoot"])
def test_a_hunt_finds_a_witness_that_keeps_all_guidelines_whatever_the_seed(name, seed, tmp_path):
    claim = settling.by_id(f"claim/{name}")
    showing = settling.chase(claim.id, seed)
    assert showing.failures
    path = write_witness(claim, showing.values, showing.shape, tmp_path)
    playing = play(path)
    assert "uniform-size, vertical-falls, level-landings, long-grounds, single-layer" in playing.scenario.note
    assert set(kept_by(playing.game.world)) == {guideline.id for guideline in GUIDELINES}
    assert list(playing.steps)
