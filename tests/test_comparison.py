"""The profiles `thesis` and `repaired`, side by side."""

from pathlib import Path

import pytest

from properties.claims.catalogue import CLAIMS
from properties.claims.claim import Verdict
from properties.comparison.both import Pair
from properties.comparison.campaign import SEED, part
from properties.comparison.causes import CAUSES, causes_of
from properties.evidence.files import file_name
from properties.evidence.mended import OUTSIDE, SHOWN, broken_in_plane, replayed
from reference.formats.level import valid_level
from reference.play import LIBRARY, play, read_playable
from reference.world import LevelError
from spec.differences import DIFFERENCES


def compared(name):
    """The steps of a scenario under both profiles, as long as the thesis leaves a state to go on from."""
    scenario, level = read_playable(LIBRARY / "scenarios" / f"{name}.json")
    pair = Pair(valid_level(level, "$"))
    for step in scenario.steps:
        for asked in pair.all_asked(step):
            both = pair.step(asked)
            yield both
            if not both.legal:
                return


def test_each_known_difference_has_a_cause_to_tell_it_by():
    assert tuple(CAUSES) == DIFFERENCES


@pytest.mark.parametrize("difference", DIFFERENCES, ids=lambda one: one.id)
def test_each_known_difference_is_seen_in_its_scenario(difference):
    assert any(difference in causes_of(both) for both in compared(difference.scenario))


def test_random_scenarios_end_alike_or_differ_by_a_known_cause():
    tally = part(SEED, 1_000)
    assert tally.unexplained == []
    assert tally.tame == []
    assert tally.differ > 100


def test_a_comparison_is_the_same_for_the_same_seed():
    assert part(7, 100) == part(7, 100)


def test_a_difference_without_a_cause_is_reported(monkeypatch):
    for cause in list(CAUSES):
        monkeypatch.delitem(CAUSES, cause)
    tally = part(SEED, 200)
    assert len(tally.unexplained) == tally.differ > 0


WITNESSES = sorted((Path(__file__).parents[1] / "docs" / "reference" / "witnesses").glob("*.json"))
WIDTH, STEPS = "expected a width greater than the margin", "expected a multiple of"
SLOPE = "to be level, got one that rises"
REFUSED = {
    "additive-on-any-ring": WIDTH,
    "constant-speed-in-contact": WIDTH,
    "loops-only-on-a-full-circle": WIDTH,
    "neighbours-not-twice": WIDTH,
    "no-overlap-on-short-edges": WIDTH,
    "pushing-on-short-edges": WIDTH,
    "split-anywhere": WIDTH,
    "three-cost-as-two": WIDTH,
    "no-fall-onto-middle": STEPS,
    "no-sharp-ledge": STEPS,
    "no-tunnel": STEPS,
    "rest-on-slopes": SLOPE,
    "friction-by-the-cosine": SLOPE,
    "printed-drag-by-the-way": SLOPE,
    "minimum-lets-begin": SLOPE,
    "no-higher-through-a-valley": SLOPE,
    "proxy-on-slanted-falls": STEPS,
    "proxy-on-tilted-landings": "to be level",
    "order-without-width-overshoot": "left of the right border",
}


def test_all_witnesses_against_the_thesis_are_there():
    refuted = {file_name(claim.id) for claim in CLAIMS if claim.expected is Verdict.REFUTED}
    assert {path.stem for path in WITNESSES} == refuted
    assert refuted > REFUSED.keys()


@pytest.mark.parametrize("path", WITNESSES, ids=lambda path: path.stem)
def test_a_witness_against_the_thesis_breaks_nothing_under_the_repaired_rules(path):
    if path.stem in REFUSED:
        with pytest.raises(LevelError, match=REFUSED[path.stem]):
            replayed(path)
    else:
        assert replayed(path) == 1


@pytest.mark.parametrize("name", SHOWN)
def test_a_scenario_of_a_defect_breaks_nothing_under_the_repaired_rules(name):
    assert replayed(LIBRARY / "scenarios" / f"{name}.json") >= 1


@pytest.mark.parametrize("name", OUTSIDE)
def test_the_other_scenarios_of_a_defect_are_refused(name):
    with pytest.raises(LevelError, match=r"\$\.level\..*expected"):
        replayed(LIBRARY / "scenarios" / f"{name}.json")


def test_a_replay_says_what_a_step_breaks():
    """The thesis' own step, told to the judge of the replay."""
    playing = play(LIBRARY / "scenarios" / "difference-other-string.json")
    before = playing.game.world.copy()
    list(playing.steps)
    assert list(broken_in_plane(before, playing.game.world)) == ["invariant/plane-margin"]
