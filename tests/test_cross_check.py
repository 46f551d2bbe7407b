"""The second solver: what is exported is what was explored, cvc5 answers as Z3 did, and a difference is told."""

import re
import subprocess
import sys
from functools import partial
from pathlib import Path

import pytest
import z3

from properties.contracts.request import judged
from properties.engine.explore import Exploration, explore, watched_by
from properties.engine.smtlib import script_of
from properties.evidence import settle as settling
from properties.evidence.cross import NoExport, answers, decide
from properties.evidence.export import Recorder, Unwritable, exported, list_export, numbered, prepare, stem_of
from properties.evidence.files import LISTED
from properties.evidence.hunt import in_order
from properties.evidence.mutants.run import write_broken
from spec.profiles import THESIS

QUICK = ("claim/one-rule-applies", "claim/neighbours-not-twice", "claim/terrain/overshoot")
GRAPHBODY = str(Path(sys.executable).parent / "graphbody")
SIMPLE_SYMBOL = re.compile(r"[A-Za-z][A-Za-z0-9_]*")


def explored(program):
    """An exploration of a program, from its beginning to its end."""
    exploration = Exploration(program)
    exploration.run()
    return exploration


def answer(text, tmp_path):
    """What cvc5 answers to a script."""
    path = tmp_path / "script.smt2"
    path.write_text(text)
    return decide(False, path)


def both_answers(exploration, tmp_path):
    """What cvc5 and Z3, which reads the text anew, answer to the script of an exploration."""
    text = script_of(exploration, "a test")
    solver = z3.Solver()
    solver.from_string(text)
    return answer(text, tmp_path), str(solver.check())


@pytest.fixture(scope="module")
def export(tmp_path_factory):
    """An export of quick claims: proofs, a witness, and a hunt that finds one."""
    directory = tmp_path_factory.mktemp("smtlib") / "export"
    prepare(directory)
    jobs = {job: task for name in QUICK for job, task in settling.jobs_of(settling.by_id(name)).items()}
    jobs = {job: task for job, task in jobs.items() if job[0] in ("prove", "refute", "hunt")}
    showings = {job: task() for job, task in exported(directory, jobs).items()}
    return directory, showings, list_export(directory, showings, seed=0)


@pytest.fixture
def copy(export, tmp_path):
    """A copy of the export, to be doctored."""
    for path in export[0].iterdir():
        (tmp_path / path.name).write_text(path.read_text())
    return tmp_path


def test_there_is_a_file_for_each_obligation_and_each_shape_of_a_hunt(export):
    directory, showings, number = export
    files = {path.name for path in directory.glob("*.smt2")}
    hunt = settling.by_id("claim/terrain/overshoot").hunt
    shape = showings["hunt", "claim/terrain/overshoot", "seed 0"].shape
    shapes = in_order(hunt, 0).index(shape) + 1
    assert shapes > 1
    assert len(files) == number == len(showings) - 1 + shapes
    for job in showings:
        name = stem_of(job)
        assert f"{numbered(name, 1) if job[0] == 'hunt' else name}.smt2" in files


def test_cvc5_answers_every_file_as_z3_did(export):
    found = list(answers(export[0]))
    assert len(found) == export[2]
    assert all(one.agreed for one in found), [str(one) for one in found if not one.agreed]
    assert {one.answered for one in found} == {"sat", "unsat"}


def test_every_name_declared_is_a_simple_symbol(export):
    for path in export[0].glob("*.smt2"):
        for name in re.findall(r"\((?:declare-const|define-fun) (\S+)", path.read_text()):
            assert SIMPLE_SYMBOL.fullmatch(name), name


def test_names_that_smtlib_does_not_know_are_exported_all_the_same(tmp_path):
    def program(given):
        a, b = given.number("b's reach, |let|"), given.number("b's reach: |let|")
        n, flag = given.natural("not"), given.flag("and (so) on;")
        given.assume((a + n > b) & (b >= 1))
        if flag:
            given.ensure("the sum is more than 1", a + n > 1)

    assert both_answers(explored(program), tmp_path) == ("unsat", "unsat")


def test_a_broken_promise_is_sat_for_both_solvers(tmp_path):
    def program(given):
        a, n = given.number("a"), given.natural("n")
        given.assume(a < n)
        given.ensure("there is one whole number above a", n <= 1)

    assert both_answers(explored(program), tmp_path) == ("sat", "sat")


def test_a_promise_made_before_a_premise_is_exported_without_it(tmp_path):
    def program(given):
        a = given.number("a")
        given.ensure("a is small", a < 1)
        given.assume(a < 1)

    assert both_answers(explored(program), tmp_path) == ("sat", "sat")


def test_values_that_the_paths_leave_out_are_found_by_the_second_solver(tmp_path, monkeypatch):
    def program(given):
        a = given.number("a")
        given.ensure("something", (a > 1) | (a <= 1))
        if a > 1:
            given.ensure("more", True)

    monkeypatch.setattr(Exploration, "turn", lambda self: False)
    monkeypatch.setattr(Exploration, "check_coverage", lambda self: None)
    exploration = explored(program)
    assert exploration.outcome.proved
    assert both_answers(exploration, tmp_path) == ("sat", "sat")


def test_a_branch_that_is_wrongly_held_to_be_infeasible_is_found_by_the_second_solver(tmp_path, monkeypatch):
    def program(given):
        a = given.number("a")
        given.ensure("a is not 2", not bool(a == 2))

    monkeypatch.setattr(Exploration, "possible", lambda self, *formulas: False)
    monkeypatch.setattr(Exploration, "check_coverage", lambda self: None)
    exploration = explored(program)
    assert exploration.outcome.counterexample is None
    assert both_answers(exploration, tmp_path) == ("sat", "sat")


def test_a_wrong_promise_of_the_rules_is_exported_as_sat(tmp_path):
    def wrong(profile, given):
        obligation = next(o for o in settling.by_id("claim/no-overlap").obligations if "margin" in o.id)
        obligation.program(profile, given)
        given.ensure("nobody has a margin", given.number("margin") <= 0)

    with watched_by(Recorder(tmp_path, "wrong")):
        assert explore(partial(judged, wrong, THESIS)).counterexample is not None
    assert decide(False, tmp_path / "wrong.smt2") == "sat"


def test_a_doctored_file_is_told(copy):
    path = min(copy.glob("prove-*.smt2"))
    path.write_text(re.sub(r"\(assert \(or .*\)", "(assert true)", path.read_text()))
    differing = [one for one in answers(copy) if not one.agreed]
    assert [str(one) for one in differing] == [f"{path}: listed as unsat, states unsat, cvc5 answers sat"]


def test_a_doctored_status_is_told_too(copy):
    path = min(copy.glob("prove-*.smt2"))
    path.write_text(
        re.sub(r"\(assert \(or .*\)", "(assert true)", path.read_text()).replace(":status unsat", ":status sat")
    )
    differing = [one for one in answers(copy) if not one.agreed]
    assert [str(one) for one in differing] == [f"{path}: listed as unsat, states sat, cvc5 answers sat"]


def test_a_file_too_few_or_too_many_or_that_is_no_script_is_told(copy):
    gone, broken, *_ = sorted(copy.glob("prove-*.smt2"))
    gone.unlink()
    broken.write_text("(set-info :status unsat)\n(assert (and))\n(check-sat)\n")
    (copy / "surplus.smt2").write_text("(set-info :status sat)\n(check-sat)\n")
    told = {one.path.name: str(one) for one in answers(copy) if not one.agreed}
    assert told.keys() == {gone.name, broken.name, "surplus.smt2"}
    assert "not there" in told[gone.name]
    assert "cvc5 answers" in told[broken.name]
    assert "not one of the obligations" in told["surplus.smt2"]


def test_a_solver_that_does_not_know_does_not_agree(copy, monkeypatch):
    monkeypatch.setattr("properties.evidence.cross.BUDGET", 1)
    path = max(copy.glob("*.smt2"), key=lambda one: one.stat().st_size)
    assert decide(False, path).startswith("unknown")


def test_proofs_are_written_beside_what_is_unsat_and_are_checked_steps(copy):
    path = min(copy.glob("prove-*.smt2"))
    assert decide(True, path) == "unsat"
    proof = path.with_suffix(".cpc").read_text()
    assert proof.startswith("(declare-const")
    assert proof.count("(") == proof.count(")")
    assert "(step" in proof
    assert ":rule trust" not in proof


def test_of_a_mutant_the_obligation_that_fails_is_exported_and_sat(tmp_path):
    write_broken(tmp_path, "mutant", "push/none: drop enough_room", "families/push-has-one")
    write_broken(tmp_path, "none", "push/none: drop enough_room", "families/clearance-has-one")
    path = tmp_path / "mutant.smt2"
    assert list(tmp_path.iterdir()) == [path]
    assert decide(False, path) == "sat"


def test_only_a_directory_with_nothing_in_it_is_exported_to(tmp_path):
    prepare(tmp_path / "new")
    (tmp_path / "new" / "other.smt2").write_text("")
    with pytest.raises(Unwritable):
        prepare(tmp_path / "new")
    with pytest.raises(NoExport, match=LISTED):
        list(answers(tmp_path / "new"))


def test_the_command_exports_decides_and_fails_on_a_difference(tmp_path):
    def graphbody(*arguments):
        return subprocess.run([GRAPHBODY, *arguments], cwd=tmp_path, capture_output=True, text=True, check=False)

    assert graphbody("check", "neighbours-not-twice", "--export", "out").returncode == 0
    done = graphbody("cross-check", "out")
    assert done.stdout == "out: 1 obligations, 1 files; cvc5 answers 0 unsat, 1 sat, 0 unknown; 0 differ\n"
    assert done.returncode == 0
    (tmp_path / "out" / "refute-neighbours-not-twice.smt2").unlink()
    assert graphbody("cross-check", "out").returncode == 1
    for refused in (("check", "neighbours-not-twice", "--export", "out"), ("cross-check", "nowhere")):
        done = graphbody(*refused)
        assert (done.returncode, done.stdout, len(done.stderr.splitlines())) == (2, "", 1)
