"""The command line: exit status, one line for bad input, quick help."""

import json
import subprocess
import sys
from pathlib import Path

import pytest
from command import graphbody

GRAPHBODY = str(Path(sys.executable).parent / "graphbody")
SCENARIO = str(Path(__file__).parents[1] / "reference" / "scenarios" / "push-into-wall.json")


def started(*arguments, cwd):
    """Start the command, as it is installed, in a directory."""
    return subprocess.run([GRAPHBODY, *arguments], cwd=cwd, capture_output=True, text=True, check=False)


def test_one_claim_is_checked_and_nothing_else_is_written(tmp_path):
    done = started("check", "neighbours-not-twice", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert "refuted" in done.stdout
    assert not (tmp_path / "build" / "results.json").exists()
    replay = started("simulate", "build/witnesses/neighbours-not-twice.json", cwd=tmp_path)
    assert replay.returncode == 0, replay.stderr


def test_simulate_prints_what_fired_and_where_everybody_is(tmp_path):
    done = graphbody("simulate", SCENARIO, cwd=tmp_path)
    assert done.returncode == 0
    assert "contact/stop" in done.stdout


@pytest.mark.parametrize("floats", [(), ("--floats",)])
def test_simulate_writes_a_trace(tmp_path, floats):
    done = graphbody("simulate", SCENARIO, "--json", *floats, cwd=tmp_path)
    header, *steps = [json.loads(line) for line in done.stdout.splitlines()]
    assert header["format"] == "graphbody/trace@1"
    assert [step["step"] for step in steps] == list(range(1, len(steps) + 1))
    assert {"body": "Box 3", "event": "wall", "rule": "walk/wall"} in [
        event for step in steps for event in step["events"]
    ]
    kind = float if floats else str
    assert isinstance(steps[0]["bodies"][0]["left"]["location"], kind)


@pytest.mark.parametrize(
    ("arguments", "line"),
    [
        (("explain", "push/requst"), "did you mean push/request"),
        (("check", "push/request"), "is a rule, not a claim"),
        (("check", "no-such-claim"), "no statement has the ID"),
        (("simulate", "missing.json"), "missing.json: No such file"),
        (("simulate", "."), "Is a directory"),
    ],
)
def test_bad_input_is_one_line_and_exit_status_two(tmp_path, arguments, line):
    done = graphbody(*arguments, cwd=tmp_path)
    assert done.returncode == 2
    assert line in done.stderr
    assert len(done.stderr.strip().splitlines()) == 1
    assert done.stdout == ""
    assert list(tmp_path.iterdir()) == []


def test_a_file_where_results_are_to_go_is_refused_before_anything_runs(tmp_path):
    (tmp_path / "build").write_text("")
    done = graphbody("check", "neighbours-not-twice", cwd=tmp_path)
    assert done.returncode == 2
    assert done.stderr == "graphbody: build: expected a directory, to write results to\n"


def test_everything_listed_can_be_explained(tmp_path):
    from properties.explain import everything, explain
    from spec.profiles import PROFILES
    from spec.registry import rules_of

    listed = json.loads(graphbody("list", "--json", cwd=tmp_path).stdout)
    assert {entry["id"] for entry in listed} == everything().keys()
    moving = {rule.id for profile in PROFILES.values() for rule in rules_of(profile)}
    for statement in everything().values():
        lines = list(explain(statement))
        assert len(lines) >= 3
        assert statement.id not in moving or any("graphbody simulate" in line for line in lines)


def test_all_that_is_to_be_proved_can_be_explained():
    from properties.claims.catalogue import CLAIMS
    from properties.explain import explain, find

    for claim in CLAIMS:
        for obligation in claim.obligations:
            found = find(obligation.id)
            assert found.sentence
            assert f"  shows: {claim.id}: {claim.sentence}" in list(explain(found))


def test_a_row_of_the_register_is_explained_by_the_statements_that_have_it_as_their_source(tmp_path):
    done = graphbody("explain", "R22", cwd=tmp_path)
    assert done.returncode == 0
    assert "leave/jump  (rule)" in done.stdout
    assert graphbody("explain", "R99", cwd=tmp_path).returncode == 2


def test_help_does_not_load_the_solver(tmp_path):
    code = (
        "import properties.cli, sys; print([m for m in ('z3', 'hypothesis', 'numpy', 'msgspec') if m in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, cwd=tmp_path)
    assert done.stdout.strip() == "[]"
