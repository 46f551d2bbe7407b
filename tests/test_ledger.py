"""The ledger tells what a proof rests on; what was shown is stored, and never taken for what it is not."""

import json
from concurrent.futures import Executor, Future, ProcessPoolExecutor
from dataclasses import replace
from fractions import Fraction
from functools import partial
from multiprocessing import get_context

import msgspec
import pytest

from properties.claims.claim import Obligation
from properties.contracts.contract import REAR, SEGMENT
from properties.contracts.request import judged
from properties.engine.explore import explore
from properties.evidence import settle as settling, store as storing
from properties.evidence.ledger import MOST_SPREAD, ledger
from properties.evidence.showing import Showing, looks
from properties.evidence.sources import source_files, sources
from properties.evidence.store import Store
from properties.explain import last_run
from properties.handbook import NoEvidence, results
from properties.report import monitor_lines, write_results
from properties.results import Results
from properties.worlds.scenes import Platform, Shape, Stand
from reference.formats.files import read
from spec.conditions import EDGES_LONG, IN_ORDER
from spec.profiles import THESIS

SHORT = ("families/clearance-has-one", "request/rear-walks-on", "request/segment-keeps-margin")


class Here(Executor):
    """An executor that runs each job when it is submitted, and is interrupted after some."""

    def __init__(self, most=1000):
        self.most = most

    def submit(self, function, /, *arguments, **named):
        if not self.most:
            raise KeyboardInterrupt
        self.most -= 1
        future = Future()
        future.set_result(function(*arguments, **named))
        return future


@pytest.fixture
def store(tmp_path):
    """An empty store of what is shown of the current sources."""
    return Store(tmp_path / "jobs", sources(), Showing)


def shown_as(number):
    """A job that shows something."""
    return Showing("counting", 0.0, number)


def jobs(count=4):
    """Some jobs that take no time."""
    return {("count", "thesis", f"counts/{number}"): partial(shown_as, number) for number in range(count)}


def never():
    """A job that must not be run."""
    raise AssertionError("it is run again")


def ignored(done, total):
    """Progress that nobody watches."""


def test_a_core_names_the_premise_that_is_needed_and_not_the_one_that_is_not():
    def program(given):
        a, b = given.number("a"), given.number("b")
        given.assume(a > 1, "a is large")
        given.assume(b > 1, "b is large")
        given.ensure("a is not small", a > 0)

    outcome = explore(program)
    assert outcome.proved
    assert outcome.used == {"a is large"}
    assert outcome.assumed == {"a is large", "b is large", "a >= 0", "b >= 0"}


def test_a_premise_that_only_cuts_off_a_branch_is_used():
    def program(given):
        a = given.number("a")
        given.assume(a > 1, "a is large")
        if a < 1:
            given.ensure("never here", False)
        given.ensure("always", True)

    assert "a is large" in explore(program).used


def test_what_is_in_no_core_can_be_left_out_and_what_is_in_one_cannot():
    def program(given, premises):
        a, b = given.number("a"), given.number("b")
        for name, holds in {"a is large": a > 1, "b is larger": b > a, "b is small": b < 9}.items():
            if name in premises:
                given.assume(holds, name)
        given.ensure("b is not small", b > 1)

    used = explore(partial(program, premises=("a is large", "b is larger", "b is small"))).used
    assert used == {"a is large", "b is larger"}
    assert explore(partial(program, premises=used)).proved
    for premise in used:
        assert explore(partial(program, premises=used - {premise})).counterexample is not None


def test_the_witness_of_the_premises_satisfies_them_on_exact_numbers():
    def program(given):
        a, b = given.number("a"), given.number("b")
        given.assume((a > 2) & (a + b < 3), "there is little room")
        if given.flag("something"):
            given.ensure("a is large", a > 1)

    witness = explore(program).witness
    assert 2 < witness["a"] < 3 - witness["b"]
    assert witness["something"] is True


@pytest.mark.parametrize("late", [False, True])
def test_an_obligation_whose_premises_no_values_satisfy_is_found(monkeypatch, late):
    def vacuous(profile, given):
        a = given.number("a")
        if late:
            given.ensure("before the premises", a >= 0)
        given.assume(a < 0, "no number is so")
        given.ensure("anything", False)

    obligation = Obligation("vacuous", vacuous)
    claim = replace(settling.by_id("claim/one-rule-applies"), obligations=(obligation,))
    monkeypatch.setattr(settling, "CLAIMS", (claim,))
    assert settling.prove(claim.id, "vacuous").open == (settling.VACUOUS,)


def test_a_promise_is_not_held_by_paths_that_premises_cut_off_later():
    def program(given):
        a = given.number("a")
        if a > 1:
            given.ensure("something", a > 0)
            given.assume(a < 1, "no number is so")

    outcome = explore(program)
    assert outcome.paths == 1
    assert outcome.witness is None
    assert not outcome.proved


def test_a_proof_that_uses_a_condition_which_it_does_not_declare_is_open():
    claim = settling.by_id("claim/no-overlap")
    obligation = next(one for one in claim.obligations if one.id == "request/segment-keeps-margin")
    assert settling.undeclared(obligation, [EDGES_LONG.id, IN_ORDER.id, "bodies have a width"]) == []
    (reason,) = settling.undeclared(replace(obligation, needs=()), [EDGES_LONG.id])
    assert EDGES_LONG.id in reason


def test_a_look_is_what_a_body_does_from_a_clearance_to_the_walk_after_it():
    fired = (
        "clearance/nobody push/none contact/open walk/onward clearance/margin push/request contact/stop walk/blocked "
        "follow/rear walk/along leave/stay"
    )
    assert looks(fired.split()) == {
        ("clearance/nobody", "push/none", "contact/open", "walk/onward"),
        ("clearance/margin", "push/request", "contact/stop", "walk/blocked"),
    }
    assert looks(["walk/along"]) == frozenset()


def test_the_ledger_says_what_was_used_what_was_not_and_what_no_proof_states():
    claim = settling.by_id("claim/no-overlap")
    one = Showing("z3", 0.0, 2, exhaustive=True, used=("condition/in-order", "a law"), resources=(7,))
    showings = dict.fromkeys(settling.jobs_of(claim), one)
    first = next(iter(showings))
    showings[first] = replace(one, unused=("condition/edges-long",), looks=frozenset({("a",), ("b",)}))
    rows = Showing("hypothesis", 0.0, 9, looks=frozenset({("b",), ("c",)}), evaluations={SEGMENT.id: 4, "other": 5})
    showings["sample", "thesis", "True"], showings["sample", "thesis", "False"] = rows, replace(rows, looks=frozenset())
    found = ledger(claim, showings)
    assert (found.used, found.unused) == (["condition/in-order"], ["condition/edges-long"])
    assert found.unstated == ["condition/one-string", "condition/margins-kept"]
    assert (found.looks, found.tried, found.exhaustive, found.spread) == (2, 1, True, None)
    assert list(found.monitors) == claim.contracts
    assert (found.monitors[SEGMENT.id], found.monitors[REAR.id]) == (8, 0)
    (line,) = monitor_lines(found)
    assert "contract/segment 8" in line


@pytest.mark.parametrize("name", SHORT)
def test_the_work_on_a_short_obligation_hardly_depends_on_the_seed_of_the_solver(name):
    obligation = next(o for o in settling.by_id("claim/no-overlap").obligations if o.id == name)
    work = tuple(explore(partial(judged, obligation.program, THESIS), seed).resources for seed in (0, 1, 2, 3))
    assert min(work) > 0
    assert Showing("z3", 0.0, 1, resources=work).spread < MOST_SPREAD


def test_an_interrupted_run_goes_on_where_it_was(store):
    with pytest.raises(KeyboardInterrupt):
        settling.run(jobs(), Here(most=3), store, ignored)
    assert len(store.current(jobs())) == 3
    told = []
    again = Here()
    showings = settling.run(jobs(), again, store, lambda done, total: told.append((done, total)))
    assert [one.cases for one in showings.values()] == [0, 1, 2, 3]
    assert again.most == 999
    assert told == [(3, 4), (4, 4)]


def test_jobs_run_in_other_processes_too(store):
    claim = settling.by_id("claim/stays-in-wall")
    with ProcessPoolExecutor(1, get_context("forkserver")) as pool:
        showings = settling.run(settling.jobs_of(claim), pool, store, ignored)
    (showing,) = showings.values()
    assert showing.used == ("distance left >= 0", "how far inside the wall >= 0")
    assert settling.run(dict.fromkeys(showings, never), Here(), store, ignored) == showings


def test_what_is_about_other_sources_is_not_used(store):
    settling.run(jobs(), Here(), store, ignored)
    later = replace(store, sources="other sources")
    assert later.current(jobs()) == {}
    with pytest.raises(AssertionError, match="run again"):
        settling.run(dict.fromkeys(jobs(), never), Here(), later, ignored)


def test_what_was_shown_while_the_sources_changed_is_not_kept(store, monkeypatch):
    monkeypatch.setattr(storing, "sources", lambda: "other sources")
    settling.run(jobs(), Here(), store, ignored)
    assert store.current(jobs()) == {}


def test_a_file_that_is_cut_off_is_no_result(store):
    settling.run(jobs(1), Here(), store, ignored)
    (job,) = jobs(1)
    store.path(job).write_bytes(store.path(job).read_bytes()[:-5])
    assert store.get(job) is None


def test_a_result_is_the_same_after_it_was_stored(store):
    shape = Shape((Fraction(1), Fraction(1, 3)), (Stand(edge=0), Stand(top=0)), Platform(Fraction(2), Fraction(1, 2)))
    showing = Showing(
        "z3",
        0.5,
        3,
        {"a promise": "a = 1"},
        rules=frozenset({"push/none", "push/limit"}),
        values={"a": "1/3", "b": True},
        shares={"pushes": (0.5, 0.2)},
        shape=shape,
        looks=frozenset({("clearance/margin", "walk/along")}),
        resources=(1, 2),
        evaluations={"contract/segment": 3},
    )
    store.put(("hunt", "claim/x", "seed 0"), showing)
    assert store.get(("hunt", "claim/x", "seed 0")) == showing
    assert store.get(("hunt", "claim/x", "seed 1")) is None


def test_the_hash_is_of_all_code_and_of_all_levels(tmp_path, monkeypatch):
    found = {path.name for path in source_files()}
    assert {"push.py", "world.py", "settle.py", "huge-and-cute.json"} <= found
    before = sources()
    (tmp_path / "more.py").write_text("")
    monkeypatch.setattr("spec.__path__", [*__import__("spec").__path__, str(tmp_path)])
    assert sources() != before


@pytest.fixture
def checked(tmp_path, monkeypatch):
    """A directory in which one claim was checked, whose results stand for those of both runs."""
    monkeypatch.chdir(tmp_path)
    claim = settling.by_id("claim/stays-in-wall")
    showings = settling.run(settling.jobs_of(claim), Here(), Store(tmp_path / "jobs", sources(), Showing), ignored)
    settled = settling.settle(claim, showings, tmp_path)
    for name in ("results.json", "results-long.json"):
        write_results([settled], showings, sources(), tmp_path / "build" / name)
    return claim, tmp_path / "build" / "results.json"


def test_results_say_what_they_are_about_and_what_they_rest_on(checked):
    claim, path = checked
    run = read(path, Results)
    assert run.sources == sources()
    (result,), (proof,) = run.claims, run.evidence
    assert result.evidence == [proof.job]
    assert result.ledger.exhaustive
    assert result.ledger.paths == proof.cases
    assert proof.premises_hold["how far inside the wall"] == "0"
    assert list(last_run(claim)) == ["proved, by z3"]


def test_stale_results_are_not_shown(checked):
    claim, path = checked
    run = json.loads(path.read_text())
    path.write_bytes(msgspec.json.encode({**run, "sources": "other sources"}))
    (line,) = last_run(claim)
    assert line.startswith("stale")
    with pytest.raises(NoEvidence, match="stale"):
        results()
