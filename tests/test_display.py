"""The display: smooth falls and turns, and wrong rules of it caught by name."""

from dataclasses import replace
from fractions import Fraction
from functools import partial
from itertools import pairwise

import pytest

from properties.claims.display import CLAIMS
from properties.contracts import display
from properties.contracts.request import judged
from properties.engine.explore import explore
from properties.evidence.mutants.rules import effect_mutants, guard_mutants
from reference.display import Speeds, angle_of, frames
from reference.play import LIBRARY, library
from reference.recording import recording
from spec.display import DISPLAYS, REPAIRED_DISPLAY, THESIS_DISPLAY
from spec.rule import Family

SPEEDS = Speeds(Fraction(100), Fraction(900))


def shown(name, parts=1, rules=None):
    """How a scenario of the library is shown."""
    found = recording(LIBRARY / "scenarios" / f"{name}.json")
    return list(frames(found, rules or DISPLAYS[found.header.profile], SPEEDS, parts))


def wrong(family, rule, effect):
    """The rules of a display with one effect replaced by that of another rule of its family."""
    effects = {one.id: one.effect for one in getattr(THESIS_DISPLAY, family).rules}
    rules = tuple(
        replace(one, effect=effects[f"display/{effect}"]) if one.id == f"display/{rule}" else one
        for one in getattr(THESIS_DISPLAY, family).rules
    )
    return replace(THESIS_DISPLAY, **{family: Family(family, rules)})


def broken_by(rules):
    """The obligations that fail on wrong rules, by what they show first."""
    programs = (display.falls_are_smooth, display.falls_arrive, display.turns_are_smooth, display.falls_add_up)
    found = {}
    for program in programs:
        outcome = explore(lambda given, program=program: program(rules, given))
        if outcome.counterexample is not None:
            found[program.__name__] = outcome.counterexample.broken[0]
    return found


@pytest.mark.parametrize(
    ("family", "rule", "effect", "broken"),
    [
        ("vertical", "sinks", "lands", {"falls_are_smooth": "it is lowered by what it sinks, or less at the target"}),
        ("vertical", "lands", "sinks", {"falls_are_smooth": "it is not shown below its target"}),
        ("vertical", "stands", "sinks", {"falls_are_smooth": "it is not shown below its target"}),
        (
            "rotation",
            "turns-left",
            "turns-right",
            {"turns_are_smooth": "it comes nearer by the turning speed, or is there"},
        ),
        ("rotation", "turns-left", "turned", {"turns_are_smooth": "it comes nearer by the turning speed, or is there"}),
        ("rotation", "turned", "turns-left", {"turns_are_smooth": "it comes nearer by the turning speed, or is there"}),
        ("rotation", "upright", "turns-left", {"turns_are_smooth": "it is at its target"}),
    ],
)
def test_a_wrong_rule_of_the_display_is_caught_by_name(family, rule, effect, broken):
    found = broken_by(wrong(family, rule, effect))
    assert broken.items() <= found.items()


def changes():
    """Every guard of the display without or with the opposite of a conjunct, every effect replaced by another."""
    families = (THESIS_DISPLAY.vertical, THESIS_DISPLAY.across, THESIS_DISPLAY.rotation)
    guards = [mutant for family in families for rule in family.rules for mutant in guard_mutants(rule)]
    return [*guards, *(mutant for family in families for mutant in effect_mutants(family))]


@pytest.mark.parametrize("mutant", changes(), ids=lambda mutant: f"{mutant.subject} {mutant.change}")
def test_a_proof_notices_every_change_of_a_guard_or_an_effect(mutant):
    obligations = [(one, claim.profile) for claim in CLAIMS for one in claim.obligations]
    with mutant.in_place():
        outcomes = (explore(partial(judged, one.program, profile)) for one, profile in obligations)
        assert any(outcome.counterexample is not None for outcome in outcomes)


def test_two_rules_that_apply_are_caught():
    careless = tuple(
        replace(one, guard=one.guard[:1]) if one.id == "display/sinks" else one for one in THESIS_DISPLAY.vertical.rules
    )
    rules = replace(THESIS_DISPLAY, vertical=Family("vertical", careless))
    assert explore(lambda given: display.vertical_has_one(rules, given)).counterexample is not None


def test_a_fall_keeps_its_horizontal_place_sinks_faster_and_faster_and_ends_at_the_target():
    steps = shown("fall-onto-slopes", parts=4)
    right = [frame["Right"] for frame in steps[:4]]
    assert [one.x for one in right] == [12, 14, 14, 14]
    assert [one.y for one in right] == [2, Fraction(3, 2), Fraction(1, 2), 0]
    assert [one.since for one in right] == [None, Fraction(1, 200), Fraction(1, 100), None]


def test_bodies_that_fall_onto_slopes_turn_each_to_its_side_and_no_further_than_the_slope():
    steps = shown("fall-onto-slopes", parts=4)
    left, right = ([round(frame[name].angle, 9) for frame in steps] for name in ("Left", "Right"))
    slope = angle_of(Fraction(4), Fraction(3))
    assert right == sorted(right)
    assert left == sorted(left, reverse=True)
    assert (right[-1], left[-1]) == (pytest.approx(slope), pytest.approx(-slope))
    assert max(far - near for near, far in pairwise(right)) == pytest.approx(4.5)


def test_a_rider_is_shown_upon_its_support_that_falls():
    for frame in shown("rider-over-a-fall", parts=5):
        assert frame["Rider right"].y >= frame["Right"].y + 1 or frame["Rider right"].x >= frame["Right"].x + 1
        assert frame["Rider left"].y == frame["Left"].y + 1


def test_under_repaired_a_fall_is_shown_as_high_at_the_end_of_a_step_however_it_is_cut():
    ends = [shown("repaired-support-falls", parts)[-1] for parts in (1, 2, 3, 7)]
    assert len({frame["Box"].y for frame in ends}) == 1


def test_at_some_instant_of_a_fall_frames_matter_to_the_thesis_and_not_to_repaired():
    def sunk(rules, cuts):
        times = [Fraction(cut, 10) for cut in cuts]
        return sum(rules.sinking(before, after, 1) for before, after in zip([0, *times[:-1]], times, strict=True))

    cuts = ([10], [5, 10], [1, 4, 10])
    assert [sunk(REPAIRED_DISPLAY, cut) for cut in cuts] == [1, 1, 1]
    assert [sunk(THESIS_DISPLAY, cut) for cut in cuts] == [1, Fraction(3, 2), Fraction(3, 2)]


def test_a_body_that_comes_is_shown_where_it_is():
    steps = shown("bodies-come-and-go")
    came = [(before, after) for before, after in pairwise(steps) if after.keys() - before.keys()]
    assert came
    for before, after in came:
        for name in after.keys() - before.keys():
            assert after[name].since is None


@pytest.mark.slow
def test_the_display_of_every_scenario_never_goes_below_its_state():
    for path in library():
        found = recording(path)
        states = frames(found, DISPLAYS[found.header.profile], Speeds(Fraction(10**9), Fraction(10**9)))
        slow = frames(recording(path), DISPLAYS[found.header.profile], Speeds(Fraction(1), Fraction(1)))
        for real, smooth in zip(states, slow, strict=True):
            assert all(smooth[name].y >= real[name].y and smooth[name].x == real[name].x for name in real), path


def test_the_program_on_the_page_runs(monkeypatch, capsys):
    root = LIBRARY.parent
    monkeypatch.chdir(root)
    code = (root / "docs" / "display.md").read_text().split("```python\n")[1].split("```")[0]
    exec(compile(code, "display.md", "exec"), {})
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) == 1 + 5 * 4
    assert lines[-1] == "{'Left': ('34/5', '9/10', -37), 'Right': ('74/5', '3/5', 37)}"
