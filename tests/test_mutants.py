"""Mutants: a wrong rule, contract, invariant or engine is caught by name, and what catches it is not lost unnoticed."""

import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from functools import partial
from pathlib import Path

import pytest

from properties.contracts.judging import bank, broken
from properties.engine.explore import explore
from properties.evidence.mutants.contracts import (
    OBLIGATIONS,
    PREMISES,
    failure,
    leniency,
    of_obligations,
    said_otherwise,
)
from properties.evidence.mutants.equal import EQUAL, boxes_of_bodies, proved_equal
from properties.evidence.mutants.invariants import of_invariants
from properties.evidence.mutants.mutant import Mutant
from properties.evidence.mutants.outings import kills_by_storeys
from properties.evidence.mutants.record import Record, read_record, write_record
from properties.evidence.mutants.rules import chapters_of, families_of, of_rules, of_steps
from properties.evidence.mutants.run import BANK, GROUPS, Found, all_of, complaints, job_of, lost
from properties.evidence.mutants.stepped import kill_of_judge, of_judges, steps
from properties.evidence.mutants.trial import (
    Kill,
    attempt,
    crash_of,
    facts_of,
    interface,
    miscounted,
    no_change,
    programs,
    replayed,
    view_of,
)
from properties.evidence.sources import sources
from properties.evidence.store import Store
from spec.plane import IN_PLANE
from spec.profiles import REPAIRED, THESIS
from spec.registry import rules_of
from spec.stepped import OF_ONE_STEP

MARGIN = "request/segment-keeps-margin"
TOO_NEAR = "clearance.up_to_margin: sight.gap - sight.margin * 0 instead of sight.gap - sight.margin"
KEPT = "contract/segment-exact: keeps the margin"


def mutant_of(mutants: dict[str, Mutant], *parts: str) -> Mutant:
    """The first mutant whose name has some parts."""
    return next(one for name, one in mutants.items() if all(part in name for part in parts))


def margin_kill() -> Kill:
    """What catches a clearance that leaves out the margin."""
    with of_rules()[TOO_NEAR].in_place():
        found = attempt(MARGIN)
    assert found is not None
    return found


@pytest.mark.parametrize(("profile", "mutants"), [(THESIS, of_rules), (REPAIRED, of_steps)])
def test_there_are_mutants_of_every_guard_and_effect_and_of_every_chapter(profile, mutants):
    names = list(mutants())
    assert [rule for family in families_of(profile.rules) for rule in family.rules] == rules_of(profile)
    for rule in rules_of(profile):
        for conjunct in rule.guard:
            assert {f"{rule.id}: {way} {conjunct.__name__}" for way in ("drop", "negate")} <= set(names)
    chapters = {chapter.rpartition(".")[2] for chapter in chapters_of(profile.rules)}
    assert {name.partition(".")[0] for name in names if "/" not in name.partition(":")[0]} == chapters


def test_there_are_mutants_of_every_chapter_of_obligations():
    assert {f"properties.contracts.{name.partition('/')[0]}" for name in programs()} <= set(OBLIGATIONS)


def test_there_are_mutants_of_the_readings():
    assert any(name.startswith("reading/push-limit: ") for name in of_rules())


@pytest.mark.parametrize("mutants", [*GROUPS.values()])
def test_a_mutant_is_put_in_place_and_taken_back(mutants):
    for one in list(mutants().values())[::20]:
        own = getattr(one.target, one.attribute)
        with one.in_place():
            assert getattr(one.target, one.attribute) is one.value
        assert getattr(one.target, one.attribute) is own


def test_a_wrong_rule_is_caught_by_the_obligation_that_it_breaks_at_values_that_replay():
    kill = margin_kill()
    assert kill.broken == (KEPT,)
    assert replayed(MARGIN, kill.values) == ()
    with of_rules()[TOO_NEAR].in_place():
        assert replayed(MARGIN, kill.values) == (KEPT,)


def test_a_contract_that_promises_less_is_caught_by_the_promise_that_is_gone():
    weaker = mutant_of(of_obligations(), "segment_keeps_margin: drop promise")
    assert said_otherwise(weaker, of_rules()[TOO_NEAR], margin_kill()) == ()
    with weaker.in_place():
        said = complaints({}, "rules", TOO_NEAR, [margin_kill_of_the_true_contract()])
    assert said == [f"{MARGIN}: {KEPT}: no longer catches {TOO_NEAR}"]


def margin_kill_of_the_true_contract() -> Kill:
    """Values at which the margin is not kept: as many as are not 0."""
    values = {"margin": "1", "front: distance to the end of the edge": "2", "gap": "2", "distance left": "2"}
    return Kill(
        MARGIN, (KEPT,), values | {"a body is ahead": True, "an edge follows": True, "length of the next edge": "1"}
    )


def test_a_contract_that_assumes_more_is_caught_though_it_still_holds():
    narrower = mutant_of(of_obligations(), "segment_keeps_margin: False instead of True")
    found = failure(narrower, [MARGIN], {MARGIN: interface(MARGIN)})
    assert found == Kill(MARGIN, (PREMISES,))


def test_a_promise_that_is_weaker_is_told_by_values_that_are_searched_for():
    bounces = "bounces/two-bounces-make-way (repaired)"
    weaker = mutant_of(of_obligations(), "two_bounces_make_way: other - box >= 3")
    wrong = mutant_of(of_steps(), "row.what_is_passed: turn.own + turn.passed")
    assert attempt(bounces) is None
    with wrong.in_place():
        kill = attempt(bounces)
    found = leniency(weaker, [(wrong.name, kill)])
    assert (found.by, found.on) == (bounces, wrong.name)
    assert complaints({}, "obligations", weaker.name, [found]) == []
    said = complaints({}, "obligations", weaker.name, [replace(found, values={}, broken=())])
    assert said == [f"{bounces}: says the same of {wrong.name} without {weaker.name}"]
    assert leniency(mutant_of(of_obligations(), "two_bounces_make_way: drop given.ensure"), []) is None


def test_every_rule_of_steps_has_a_mutant_for_one_body_only():
    for rule in rules_of(REPAIRED):
        assert any(name.startswith(f"{rule.id}: ") and name.endswith(" for the first body") for name in of_steps())


def test_a_view_that_shows_a_world_as_it_is_is_told_by_a_rule_that_is_wrong_to_one_side():
    own = mutant_of(of_obligations(), "images.from_behind: False instead of True")
    wrong = mutant_of(of_steps(), "step.lasting: speeds[mark.body] instead of")
    with wrong.in_place():
        kill = attempt("images/records-look-alike (from behind) (repaired)")
    assert kill.broken == ("the same is left",)
    assert said_otherwise(own, wrong, kill) == ()


def test_of_very_many_obligations_one_in_a_view_is_enough():
    many = "images/worlds-look-alike (two, from behind) (repaired)"
    assert view_of(many) == view_of(many.replace("two", "one on another"))
    assert view_of(many) != view_of(many.replace("from behind", "in another order"))
    assert view_of("stretches/stretches-keep-apart (two)") != view_of("stretches/stretches-keep-apart (alone)")


def test_an_invariant_that_lets_something_pass_is_caught_by_a_deed():
    careless = mutant_of(of_invariants(), "no_overlap: after.margin - deed.tolerance * 0")
    with careless.in_place():
        (wrong,) = miscounted(BANK)
    assert "no-overlap" in wrong
    assert miscounted(BANK) == ()


def test_every_invariant_is_broken_by_some_deed_of_the_bank_and_kept_by_another():
    blamed = {name for one in bank() for name in broken(one)}
    judged = {judge.id.removeprefix("invariant/") for one in bank() for judge in one.judges}
    assert blamed == judged
    assert {one.id.removeprefix("invariant/") for one in IN_PLANE} <= judged


WRONG_ENGINE = """
from properties.evidence.mutants.engine import failed_tests, of_engine
told = "explore.Path.judge: drop self.exploration.refute"
mutant = next(one for name, one in of_engine().items() if name.startswith(told))
assert failed_tests("test_a_false_promise_is_refuted_by_simple_exact_values") == ()
with mutant.in_place():
    print(*failed_tests("test_a_promise_made_before_a_premise_is_judged_without_it"))
"""


def test_a_wrong_engine_is_caught_by_one_of_its_tests():
    done = subprocess.run([sys.executable, "-c", WRONG_ENGINE], capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["test_a_promise_made_before_a_premise_is_judged_without_it"]


def calls_of(name: str) -> dict[str, frozenset[str]]:
    """The functions that an obligation runs."""
    return {name: facts_of(name).calls}


def test_a_change_that_changes_nothing_is_proved_to():
    same = mutant_of(
        of_rules(), "request.segment: asked is not None instead of other is not None and asked is not None"
    )
    other = mutant_of(of_rules(), "push.enough_room: want.stride < want.room")
    calls = calls_of("request/segment-keeps-its-contract")
    assert no_change(same, calls) is not None
    assert no_change(other, calls) is None


def test_a_change_that_only_crashes_is_no_kill_and_is_told():
    crash = mutant_of(of_invariants(), "chain: ahead == deed.body instead of")
    with crash.in_place():
        assert miscounted(BANK) == ()
    assert crash_of(crash, {}) is None


def test_a_record_is_read_as_it_was_written(tmp_path):
    record = Record(
        {"claim/a": ("b",)}, {"b": ("c >= 0",)}, {"rules": {"d": (Kill("b", ("e",), {"c": "1/2"}, "f"),)}}, {"g": "h"}
    )
    write_record(record, tmp_path / "record")
    assert read_record(tmp_path / "record") == record
    assert read_record(tmp_path / "none") == Record({}, {})


@pytest.mark.slow
def test_the_record_is_about_what_there_is(monkeypatch):
    record = read_record()
    name = next(iter(record.kills["rules"]))
    short = replace(
        record, kills={**record.kills, "rules": {k: v for k, v in record.kills["rules"].items() if k != name}}
    )
    few = next(iter(programs()))
    monkeypatch.setattr("properties.evidence.mutants.run.tried_again", lambda record: iter(()))
    assert list(lost(short)) == [f"{name}: a mutant that is not recorded"]
    (wrong,) = lost(replace(record, premises={**record.premises, few: ()}))
    assert wrong.startswith(f"{few}: assumes ")


def test_a_wrong_rule_of_a_step_is_caught_by_name_in_a_world_in_which_it_fails_again():
    late = mutant_of(of_steps(), "event.time_left: ", "* nearing.speed")
    with late.in_place():
        kill = next(kills_by_storeys())
    assert kill.by.startswith("storeys: ")
    assert complaints({}, "steps", late.name, [kill]) == []
    assert complaints({}, "steps", late.name, [replace(kill, broken=("invariant/another",))]) != []


def test_an_invariant_of_steps_that_lets_something_pass_is_caught_by_a_step_of_the_bank():
    careless = mutant_of(of_judges(), "is_held: storey instead of not storey")
    kill = kill_of_judge(careless)
    assert kill is not None
    assert complaints({}, "stepped", careless.name, [kill]) == []
    assert complaints({}, "stepped", careless.name, [replace(kill, broken=("another",))]) != []


def test_every_invariant_of_steps_is_broken_by_some_step_of_the_bank_and_kept_by_another():
    told = {name for one in steps().values() for name in one.breaks.split()}
    assert {f"invariant/step-{name}" for name in told} == {one.id for one in OF_ONE_STEP}
    assert any(not one.breaks for one in steps().values())


def test_what_is_the_same_is_proved_to_be_and_what_is_not_is_not():
    names = {name: mutant for mutants in GROUPS.values() for name, mutant in mutants().items()}
    assert all(proved_equal(name, names[name]) is not None for name in EQUAL)
    other = mutant_of(names, "plane.box: circumference is not None instead of circumference is not None and right")
    assert explore(partial(boxes_of_bodies, other)).counterexample is not None


def test_a_record_goes_on_where_it_stopped(tmp_path):
    store, work = Store(tmp_path, sources(), Found), {job_of("rules", "a"): found_nothing}
    done = []
    with ThreadPoolExecutor(1) as executor:
        for _ in range(2):
            found = all_of(executor, store, "rules", work, lambda what, some, total: done.append(some))
            assert found == [Found((), "a reason")]
    assert done == [0, 1, 1]


def found_nothing() -> Found:
    """What a mutant may be found to be."""
    return Found((), "a reason")


def test_there_is_a_page_of_the_record():
    from properties.evidence.mutants.matrix import PAGE, page_of

    assert Path(PAGE).read_text() == page_of(read_record())
