"""The theorem table: sets of conditions against brute force, surveys that find what is known, wrong mends noticed."""

import pickle
import re
from functools import partial
from itertools import combinations
from random import Random

import pytest
import z3

from properties.engine.explore import solver_for_reals
from properties.engine.survey import breaches, can_hold, firsts, largest
from properties.map.sets import maximal, minimal, suffices, sufficient
from properties.map.terrains import ONE, ZERO, Shape, in_guidelines, of_three, with_platforms, with_tilted_landings
from properties.map.theorem import DROP, PART, PIT, contradicted, surveyed, two_at_a_drop
from properties.map.theorem_page import bound
from properties.map.trails import CATALOGUES, GUIDELINE_IDS, NAMES, first_uncatalogued, trails
from properties.worlds.scenes import Stand
from spec.conditions import ALONE, LEDGES_CLEAR, ROOMY_GROUNDS, SHORT_REQUESTS, TWO_AT_MOST
from spec.mends import LOOK_AT_LANDING, MARGIN_IN_JUMP_TEST, Mend, landing, mended
from spec.plane import HORIZONTAL, PLANE_MARGIN, TERRAIN
from spec.profiles import OVERSHOOT, THESIS

TOY = ("a", "b", "c", "d", "e")
BELOW_A_DROP = Shape(DROP, (Stand(edge=0), Stand(edge=1)), sizes=True)
ALONE_AT_A_PIT = Shape(PIT, (Stand(edge=0),), sizes=True)


def all_sets(names):
    return [frozenset(chosen) for count in range(len(names) + 1) for chosen in combinations(names, count)]


@pytest.mark.parametrize("seed", range(20))
def test_sufficient_sets_are_those_of_brute_force(seed):
    random = Random(seed)
    insufficient = maximal(frozenset(random.sample(TOY, random.randrange(5))) for _ in range(4))
    enough = [one for one in all_sets(TOY) if not any(one <= other for other in insufficient)]
    assert set(sufficient(TOY, insufficient)) == set(minimal(enough))
    assert all(suffices(one, insufficient) == (one in enough) for one in all_sets(TOY))


def test_nothing_suffices_where_all_do_not_and_nothing_is_needed_where_nothing_is_broken():
    assert sufficient(TOY, [frozenset(TOY)]) == []
    assert sufficient(TOY, []) == [frozenset()]


def test_the_breaches_of_a_shape_are_those_of_brute_force():
    found = trails([BELOW_A_DROP], THESIS)
    names = (ALONE.id, LEDGES_CLEAR.id, SHORT_REQUESTS.id, ROOMY_GROUNDS.id)
    known = [one.conditions for one in breaches(found, names)[PLANE_MARGIN.id]]
    compatible = [one for one in all_sets(names) if breached(found, one)]
    assert set(known) == set(maximal(compatible))


@pytest.mark.parametrize("hint", [0, 1, 2])
def test_which_set_is_grown_does_not_depend_on_the_model_that_the_solver_starts_from(hint):
    number, solver = z3.Real("number"), solver_for_reals()
    conditions = {"small": number < 1, "large": number > 2, "positive": number > 0}
    assert can_hold(solver, [list(conditions.values())[hint]])
    assert largest(solver, conditions) == {"small", "positive"}


def breached(found, names):
    return any(one.promise == PLANE_MARGIN.id for one in firsts(found, tuple(names)))


def test_a_known_defect_is_found_and_replays():
    finding = surveyed(THESIS, (), lambda: [BELOW_A_DROP], "known")
    entry = next(one for one in finding["broken"] if one["invariant"] == PLANE_MARGIN.id)
    assert set(NAMES) - set(entry["conditions"]) == {ALONE.id, LEDGES_CLEAR.id}
    assert list(contradicted(entry, THESIS)) == []
    assert finding["falling"] > 0


def test_a_witness_that_does_not_hold_is_told():
    finding = surveyed(THESIS, (), lambda: [BELOW_A_DROP], "known")
    entry = finding["broken"][0]
    assert "expected it to break" in next(contradicted({**entry, "invariant": TERRAIN.id}, THESIS))
    assert "expected it to keep condition/alone" in next(contradicted({**entry, "conditions": [ALONE.id]}, THESIS))


def test_a_mend_removes_what_it_is_for_and_the_margin_is_kept_below_a_drop():
    assert PLANE_MARGIN.id in breaches(trails([BELOW_A_DROP], THESIS), NAMES)
    for mend in (MARGIN_IN_JUMP_TEST, LOOK_AT_LANDING):
        assert PLANE_MARGIN.id not in breaches(trails([BELOW_A_DROP], mended(THESIS, [mend])), NAMES)


def test_a_wrong_mend_is_noticed():
    def beyond(leaving, near_end):
        return leaving.view.along(near_end, leaving.moved)

    wrong = Mend("mend/wrong", "A body lands as far on as it has moved.", "6.2.1d; A15", partial(landing, beyond))
    found = breaches(trails([ALONE_AT_A_PIT], mended(THESIS, [wrong])), NAMES)
    assert TERRAIN.id in found
    assert TERRAIN.id not in breaches(trails([ALONE_AT_A_PIT], THESIS), NAMES)


def test_overshoot_enters_the_far_wall_of_a_pit_and_short_requests_with_roomy_grounds_prevent_it():
    known = [one.conditions for one in breaches(trails([ALONE_AT_A_PIT], OVERSHOOT), NAMES)[TERRAIN.id]]
    assert not suffices({*NAMES} - {SHORT_REQUESTS.id}, known)
    assert not suffices({*NAMES} - {ROOMY_GROUNDS.id}, known)
    assert suffices({SHORT_REQUESTS.id, ROOMY_GROUNDS.id}, known)


def test_the_smallest_witness_within_the_guidelines_has_two_bodies():
    shapes = two_at_a_drop()
    found = firsts(trails(shapes, THESIS), GUIDELINE_IDS)
    sizes = {one.promise: len(shapes[one.trail.place].stands) for one in found}
    assert sizes[HORIZONTAL.id] == sizes[PLANE_MARGIN.id] == 2
    assert TERRAIN.id not in sizes


def test_a_platform_hides_who_walks_under_it_and_breaks_only_the_single_layer():
    tunnel = next(shape for shape in with_platforms(1) if shape.platform)
    (breach,) = breaches(trails([tunnel], THESIS), NAMES)[TERRAIN.id]
    assert {*NAMES} - breach.conditions == {"guideline/single-layer"}


def test_three_bodies_of_which_two_are_told_apart_by_nothing_are_looked_at_once():
    shapes = of_three([DROP])
    assert len(shapes) == len({shape.stands for shape in shapes})
    assert all(len(shape.stands) == 3 and shape.sizes for shape in shapes)


def test_shapes_keep_what_they_say():
    for shape in in_guidelines(1, 2):
        assert not shape.tilt
        assert set(shape.steps) <= {ZERO, ONE, -ONE}
    assert all(shape.tilt for shape in with_tilted_landings(1))


def test_the_page_links_to_the_witnesses_that_are_written_and_they_hold():
    survey = surveyed(THESIS, (), lambda: [BELOW_A_DROP], "small")
    complete = {"profile": "thesis", "mends": [], "trails": 0, "broken": []}
    findings = {job: complete if "catalogue" in job else survey for job in PART.jobs()}
    page = "\n".join(PART.section(findings))
    assert set(re.findall(r"map/witnesses/(.*?)\.json", page)) == set(PART.witnesses(findings))
    assert list(PART.broken(findings)) == []


def test_a_set_of_conditions_is_bounded_to_the_bodies_for_which_it_was_looked_at():
    guidelines = {name for name in NAMES if name.startswith("guideline/")}
    assert bound(frozenset({ALONE.id})) == "1"
    assert bound(frozenset(guidelines)) == "3"
    assert bound(frozenset({*guidelines, TWO_AT_MOST.id})) == "2"
    assert bound(frozenset(guidelines - {"guideline/uniform-size"})).startswith("2;")


def test_what_no_case_tells_is_missed_in_the_catalogue(monkeypatch):
    monkeypatch.setitem(CATALOGUES, "nothing at all", ())
    found = trails([BELOW_A_DROP], THESIS, catalogue=True)
    assert {one.promise for one in first_uncatalogued(found, "nothing at all")} == {PLANE_MARGIN.id, HORIZONTAL.id}
    assert first_uncatalogued(found, "no case happened but U9") == []


def test_jobs_can_be_sent_to_processes():
    for name, job in PART.jobs().items():
        assert pickle.loads(pickle.dumps(job)).func is job.func, name
