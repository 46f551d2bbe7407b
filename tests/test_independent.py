"""A second program, written from the texts of `repaired` alone, says of random levels what the reference says."""

from fractions import Fraction

import pytest
from independent.__main__ import compared
from independent.comparing import by_reference, difference

from spec.registry import statements
from spec.rules.settle import Found

LEVELS = 200
PARTS = 8
TRIES = 80


@pytest.mark.parametrize("part", range(PARTS))
def test_the_second_program_agrees(part):
    levels = [compared(seed) for seed in range(part, LEVELS, PARTS)]
    assert [one for one in levels if one.difference is not None] == []
    assert sum(one.refused is None for one in levels) > 0.8 * len(levels)


def body(name, edge, left, right, **more):
    borders = {"left": {**edge, "location": left}, "right": {**edge, "location": right}}
    return {"name": name, **borders, **more}


def differs(folder, level, step):
    level = {"format": "graphbody/level@1", "name": "given", "margin": "1/8", **level}
    head = {"format": "graphbody/scenario@1", "name": "given", "profile": "repaired"}
    scenario = {**head, "level": level, "steps": [step]}
    return difference(by_reference(scenario, folder / "given.json"), scenario)


@pytest.mark.parametrize("names", ["XYSA", "YXSA"])
@pytest.mark.parametrize("numerator", [1, 2, 3])
def test_over_no_top_the_nearest_holds(names, numerator, tmp_path):
    """S walks into a pit of its width. Its rider A, carried into the slot between X and Y, is over neither."""
    bodies = {
        "X": body("X", {"edge": 0}, "69/8", "77/8"),
        "Y": body("Y", {"edge": 4}, "1/4", "5/4"),
        "S": body("S", {"edge": 0}, "39/4", "41/4", speed="1"),
        "A": body("A", {"top": "S"}, f"{numerator - 12}/32", f"{numerator + 20}/32"),
    }
    vertices = [["0", "1"], ["10", "1"], ["10", "0"], ["21/2", "0"], ["21/2", "1"], ["20", "1"]]
    level = {"vertices": vertices, "bodies": [bodies[name] for name in names]}
    assert differs(tmp_path, level, {"request": {"body": "S", "distance": "1"}}) is None


@pytest.mark.parametrize("shift", range(0, 40, 5))
def test_who_is_held_at_both_ends_takes_the_front_most_wherever_the_ring_is_cut_open(shift, tmp_path):
    """D steps off C over A and B, which is as far behind it as ahead."""

    def on_the_floor(name, *borders):
        return body(name, {"edge": 0}, *(str((Fraction(border) + Fraction(shift, 8)) % 5) for border in borders))

    bodies = [
        on_the_floor("A", "5/2", "7/2"),
        on_the_floor("B", "1/8", "15/8"),
        body("C", {"top": "B"}, "3/8", "13/8"),
        body("D", {"top": "C"}, "1", "4", speed="1"),
    ]
    level = {"margin": "1/4", "circumference": "5", "vertices": [["0", "0"]], "bodies": bodies}
    assert differs(tmp_path, level, {"request": {"body": "D", "distance": "1"}}) is None


def test_places_beyond_the_circumference_are_places_on_the_cylinder(tmp_path):
    """B walks round to a wall that stands at 6 on a cylinder of 17/4."""
    points = [(15, 1), (24, 1), (24, 2), (25, 2), (25, 0), (15, 0)]
    ends = [(0, 1, "ground"), (2, 3, "ground"), (4, 5, "ground"), (5, 0, "fall"), (1, 2, "fall"), (3, 4, "fall")]
    level = {
        "vertices": [[f"{x}/4", str(y)] for x, y in points],
        "edges": [{"left": left, "right": right, "type": kind} for left, right, kind in ends],
        "bodies": [body("B", {"edge": 0}, "1", "3/2", speed="1")],
        "circumference": "17/4",
    }
    assert differs(tmp_path, level, {"request": {"body": "B", "distance": "2"}}) is None


@pytest.mark.parametrize(
    ("rule", "other"),
    [
        ("row/squeezed", "row/one-way"),
        ("row/passes-nothing", "row/passes-on"),
        ("row/pushed", "row/own"),
        ("wish/plane", "wish/carried"),
    ],
)
def test_a_rule_that_does_what_another_does_is_seen(rule, other, monkeypatch):
    table = statements()
    monkeypatch.setitem(vars(table[rule]), "effect", table[other].effect)
    assert any(compared(seed).difference for seed in range(TRIES))


def test_a_body_on_the_other_top_is_seen(monkeypatch):
    def rear_most(footing):
        top = footing.tops[0] if footing.motion > 0 else footing.tops[-1]
        return Found(stands=True, support=top.body)

    monkeypatch.setitem(vars(statements()["settle/jump"]), "effect", rear_most)
    assert any(compared(seed).difference for seed in range(TRIES))
