"""Other readings: each is a statement, a small change, and ends otherwise than the thesis where the map says so."""

from copy import deepcopy

import pytest

from properties.alternatives.agree import agreement
from properties.alternatives.answers import scene_of
from properties.alternatives.compare import broken_by, outcome
from properties.alternatives.scenes import asked, requests, scenes, stepped_level
from properties.explain import explain, find, of_row
from properties.map.assembly import read_findings
from properties.map.readings import PART, PROVED_ALIKE, THESIS, UNPLAYED, unsettled
from properties.worlds.scenes import Stand
from reference.alternatives import OTHERWISE, VARIANTS
from spec.alternatives import ALTERNATIVES
from spec.otherwise import Instead, Noted, Seen
from spec.profiles import THESIS as PROFILE
from spec.readings import LANDING_OVERSHOOT, READINGS
from spec.rules.leave import LEAVE
from spec.rules.request import FAMILIES, request

IDS = [one.id for one in ALTERNATIVES]
KINDS = ("view", "world", "game", "level")


@pytest.fixture(scope="module")
def findings():
    return read_findings(PART)


@pytest.mark.parametrize("one", ALTERNATIVES, ids=IDS)
def test_each_alternative_is_another_answer_to_a_reading(one):
    assert one.of in [reading.id for reading in READINGS]
    assert one.id.startswith(f"{one.of}/")
    assert f"  alternative: {one.id}: {one.sentence}" in list(explain(find(one.of)))
    assert one in of_row(one.source.partition("; ")[2].split(", ")[0])


@pytest.mark.parametrize("one", ALTERNATIVES, ids=IDS)
def test_each_alternative_is_small(one):
    variant = VARIANTS[one.id]
    changed = [name for name in FAMILIES if getattr(one.profile.rules, name) is not getattr(PROFILE.rules, name)]
    changed += [
        name for name in ("push_limit", "tick_order") if getattr(one.profile, name) is not getattr(PROFILE, name)
    ]
    changed += ["landing"] if one.profile.rules.landing is LANDING_OVERSHOOT.choice else []
    changed += ["request"] if one.request is not request else []
    changed += list(OTHERWISE.get(one.id.removeprefix("reading/"), {}))
    assert 1 <= len(changed) <= (2 if one.id == "reading/width/with-margins" else 1)
    assert variant.alternative is one


def test_what_is_computed_otherwise_is_an_alternative():
    assert {f"reading/{name}" for name in OTHERWISE} <= set(IDS)
    assert {kind for changes in OTHERWISE.values() for kind in changes} == set(KINDS)


def test_every_alternative_has_been_played(findings):
    assert set(findings) == set(PART.jobs()) == {THESIS, *IDS, *(f"alike/{name}" for name in PROVED_ALIKE)}
    untold = [name for name in IDS if findings[name]["differs"] is None]
    assert set(untold) <= set(PROVED_ALIKE)
    assert not any(unsettled(findings, name) for name in PROVED_ALIKE)


def test_what_was_found_comes_again(findings):
    assert list(PART.broken(findings)) == []


@pytest.mark.parametrize("spoil", ["thesis", "other", "broken", "alike", "missing"])
def test_a_wrong_finding_is_told(findings, spoil):
    wrong = deepcopy(dict(findings))
    name = "reading/landing-position/overshoot"
    if spoil in ("thesis", "other"):
        next(iter(wrong[name]["differs"][spoil]["bodies"].values()))["on"] = "nothing"
    elif spoil == "broken":
        wrong[name]["broken"]["invariant/never-raised"] = wrong[name]["differs"]["scene"]
    elif spoil == "alike":
        wrong["alike/reading/one-fall/any-number"]["unsettled"] = ["differ"]
    else:
        del wrong[name]
    assert list(PART.broken(wrong))


def test_the_section_tells_of_every_alternative_and_its_links_lead_somewhere(findings):
    lines = PART.section(findings)
    text = "\n".join(lines)
    assert all(f"alternatives.md#{name.replace('/', '-')}" in text for name in IDS)
    assert all(f"| {row.row} | {row.other} |" in text for row in UNPLAYED)
    linked = {part.partition(".json)")[0] for part in text.split("(map/witnesses/")[1:]}
    assert linked == set(PART.witnesses(findings))


def test_scenes_come_the_smallest_first_and_can_be_written():
    sizes, judged = zip(*((scene.size, scene.judged) for scene in scenes()), strict=True)
    assert list(sizes) == sorted(sizes)
    assert any(judged)


def falling():
    """A body that is asked to go 2 beyond a ledge."""
    level = stepped_level((1, 0), (3, 5), [(Stand(edge=0), 1, 2)])
    return next(iter(asked(level, requests(4))))


def test_outcomes_tell_where_bodies_are_and_what_stops_an_answer(findings):
    landed, played = outcome(falling(), None)
    assert landed[0] == (((3, 0), (5, 0)), None)
    assert list(broken_by(falling(), played)) == []
    further, _ = outcome(falling(), "reading/landing-position/overshoot")
    assert further[0] == (((5, 0), (7, 0)), None)


def test_families_that_look_otherwise():
    rule = LEAVE.rules[0]

    class Only:
        def choose(self, facts):
            return rule if facts == "seen" else None

    assert Seen(Only(), lambda _: "seen").choose("as it is").id == rule.id
    assert Instead(Only(), (rule.id,), lambda _: "other").choose("seen").effect("any") == "other"
    assert Instead(Only(), ("another",), lambda _: "other").choose("seen") is rule
    noted = Noted(Only())
    assert noted.choose("seen") is rule
    assert not noted.left


def test_scenes_are_read_back_from_their_documents(findings):
    shown = findings["reading/landing-position/overshoot"]["shown"]
    number, one = next(iter(shown.items()))
    assert outcome(scene_of(one["scenario"]), None)[0] == outcome(scenes()[int(number)], None)[0]


def test_every_row_about_behaviour_is_accounted_for():
    rows = {f"A{number}" for number in [*range(1, 32), 38, 41, 42, 43, 48, *range(52, 60)]}
    told = [one.source.partition("; ")[2] for one in ALTERNATIVES] + [one.row for one in UNPLAYED]
    assert rows == {row for source in told for row in source.split(", ") if row.startswith("A")}


def test_readings_that_differ_are_not_found_alike():
    assert any(
        problem.startswith("differ") for problem in agreement("reading/landing-position/overshoot", 1, 2)["unsettled"]
    )
    assert not agreement("reading/one-fall/any-number", 1, 2)["unsettled"]
