"""Steps that look only at those whom they can reach: what they count, what they leave behind, and what goes wrong with
a reach that is too short.
"""

from collections import Counter
from dataclasses import replace
from fractions import Fraction
from random import Random

import pytest
from evaluation import graphbodies

from properties.contracts.reach import rows_add_no_speed, wishes_add_one_drive
from properties.contracts.request import judged
from properties.engine.explore import explore
from properties.evidence.comparisons import rest_does_not_count
from properties.evidence.sample_steps import course_of
from properties.strategies.storeys import outing
from properties.worlds.changes import in_floats
from reference.play import library, play
from reference.scene import Reach, Scene
from reference.stepping import StepGame, run_in_reach
from reference.storeys import Place, StoreyWorld, Terrain
from spec.graph import Direction
from spec.profiles import REPAIRED
from spec.rule import Family
from spec.storeys import Drive, Interval

ONE, LONG, STILL = Fraction(1), Fraction(10**5), Drive(Fraction(0))
WALK = Drive(ONE, relative=False)
WORLDS = range(200, 330)
QUESTIONS = ("storeys", "row", "storey", "support", "pushes", "neighbours", "gap", "to_wall", "to_loss", "holds")


def touched():
    """Two stacks on a ledge above a pit, and a row on the floor: the first body walks against a stack."""
    ledge = [Place(1, Fraction(left), ONE, None) for left in (0, 2, 4)]
    riders = [Place(2, Fraction(left), ONE, support) for left, support in ((2, 1), (4, 2))]
    return [*ledge, *riders, *(Place(0, Fraction(left), ONE, None) for left in (7, 9))]


def scene_with(bystanders):
    """What is touched, and others who stand far away, on the floor and on each other, all in one row."""
    terrain = Terrain(((Interval(Fraction(0), Fraction(6)),),), Interval(Fraction(0), Fraction(10**6)))
    places = touched()
    for number in range(bystanders // 2):
        places.append(Place(0, Fraction(40 + 2 * number), ONE, None))
        places.append(Place(1, Fraction(40 + 2 * number), ONE, len(places) - 1))
    return Scene(StoreyWorld(terrain, ONE / 8, places))


def counted(monkeypatch, bystanders):
    """Who is reached by a long walk, how many rules are chosen, and how often the world is asked what."""
    scene, asked = scene_with(bystanders), Counter()
    with monkeypatch.context() as patch:
        for name in QUESTIONS:
            patch.setattr(StoreyWorld, name, noting(asked, name, getattr(StoreyWorld, name)))
        moments, record = run_in_reach(REPAIRED.rules, scene, {0: WALK}, Fraction(6))
    return set(moments[0].velocities), record.chosen, asked


def noting(asked, name, question):
    """A question that is counted each time it is asked."""

    def noted(*given):
        asked[name] += 1
        return question(*given)

    return noted


def test_a_step_costs_the_same_whoever_stands_by(monkeypatch):
    few, some, many = (counted(monkeypatch, bystanders) for bystanders in (10, 1_000, 10_000))
    assert few == some == many
    reached, chosen, asked = many
    assert {0, 1, 2, 3, 4, 5} <= reached <= set(range(7))
    assert chosen > 0
    assert all(asked[name] for name in QUESTIONS)


def played(boxes):
    """What ticks and a request take in a game with so many boxes in a row, a unit apart."""
    game = StepGame(REPAIRED, graphbodies.level([Fraction(2 * place) for place in range(boxes + 1)], [LONG], ONE))
    moves = [*game.tick(Direction.RIGHT), *game.tick(None), game.request("Box 3", Fraction(5, 2))]
    assert game.shown is None
    return moves


def test_a_game_costs_the_same_whoever_stands_by():
    few, many = map(played, (10, 10_000))
    assert few == many
    assert [move.moved for move in many] == [ONE / 50, Fraction(5, 2)]
    assert many[-1].depth == 4


class Whole(Reach):
    """Everybody is in reach."""

    def __init__(self, scene, driven, duration):
        self.ways = {body: {} for body in range(len(scene.world.places))}


def told(path, floats):
    """What came of each step of a scenario, but for the work that it took."""
    return [
        (one.bodies, one.pressed, one.happened, [replace(move, work={}) for move in one.moves])
        for one in play(path, floats).steps
    ]


@pytest.mark.parametrize("floats", [False, True])
def test_scenarios_are_told_as_if_all_were_in_reach(monkeypatch, floats):
    paths = [path for path in library() if isinstance(play(path).game, StepGame)]
    found = [told(path, floats) for path in paths]
    monkeypatch.setattr("reference.stepping.Reach", Whole)
    assert [told(path, floats) for path in paths] == found


@pytest.mark.parametrize("seed", range(10))
def test_a_scene_after_steps_is_as_one_made_anew(seed):
    random = Random(seed)
    for number in range(12):
        trial = outing(random.randrange(2**30), 2 + number, number % 4)
        world = in_floats(trial.world()) if number % 2 else trial.world()
        scene = Scene(world)
        for _ in range(3):
            body, speed = random.randrange(len(world.places)) if world.places else None, random.choice((-2, -1, 1, 2))
            kind = type(world.margin)
            driven = {} if body is None else {body: Drive(kind(speed), random.random() < 0.5)}
            run_in_reach(REPAIRED.rules, scene, driven, kind(trial.duration) / 4)
            fresh = Scene(StoreyWorld(world.terrain, world.margin, world.places))
            assert {storey: row for storey, row in world.rows.items() if row} == fresh.world.rows
            assert {body: some for body, some in scene.riders.items() if some} == fresh.riders
            assert scene.unheld == fresh.unheld


def half(scene, driven, duration):
    """Half as far as the fastest is driven."""
    return max((abs(drive.speed) for drive in driven.values()), default=0) * duration / 2 + scene.margin * 0


def test_who_is_out_of_reach_does_not_matter():
    assert all(map(holds, WORLDS))


TOO_SHORT = {
    "nobody is carried": (Scene, "note", lambda self, body: None),
    "nobody comes down": (Reach, "come_down", lambda self, body, beside: None),
    "others come down only to those right under them": (
        Reach,
        "come_down",
        lambda self, body, beside, right=Reach.come_down: right(self, body, self.scene.world.margin),
    ),
    "nobody loses the ground": (Reach, "stays", lambda self, body: self.scene.world.support(body) is None),
    "who is pushed is not": (Reach, "push", lambda self, body, direction, far: self.ways.setdefault(body, {})),
}


@pytest.mark.parametrize("fault", TOO_SHORT, ids=str)
def test_a_reach_that_is_too_short_is_caught(monkeypatch, fault):
    monkeypatch.setattr(*TOO_SHORT[fault])
    assert not all(map(holds, WORLDS))


def test_a_reach_of_half_the_way_is_caught(monkeypatch):
    monkeypatch.setattr("reference.scene.most_moved", half)
    assert not all(map(holds, WORLDS))


def holds(number):
    """Whether those out of reach do not matter in the world of a number, where one or two are driven."""
    random, trial = Random(number), outing(number, 2 + number % 8, number % 4)
    if not trial.places:
        return True
    driven = random.sample(range(len(trial.places)), min(len(trial.places), 2))
    drives = tuple(drive if body in driven else STILL for body, drive in enumerate(trial.drives))
    trial = replace(trial, drives=drives, duration=trial.duration / random.choice((1, 2)))
    try:
        return rest_does_not_count(REPAIRED.rules, trial, course_of(REPAIRED.rules, trial, floats=bool(number % 2)))
    except KeyError:
        return False


def with_effect(field, rule_id, effect):
    """The rules with another effect of one of them."""
    family = getattr(REPAIRED.rules, field)
    rules = tuple(replace(rule, effect=effect) if rule.id == rule_id else rule for rule in family.rules)
    return replace(REPAIRED.rules, **{field: Family(family.id, rules)})


def test_rules_by_which_drives_add_up_to_more_are_refuted():
    faster = with_effect("wish", "wish/carried", lambda urge: urge.drive.speed + urge.carried * 2)
    assert refuted(wishes_add_one_drive, faster)
    for rule, field in (("row/passes-on", "relay"), ("way/slower", "way"), ("row/pushed", "forward")):
        faster = with_effect(field, rule, lambda one: (one.passed if hasattr(one, "passed") else one.speed) * 2)
        assert refuted(lambda rules, given: rows_add_no_speed(rules, given, Direction.RIGHT), faster), rule


def refuted(program, rules):
    """Whether an obligation has a counterexample under some rules."""
    profile = replace(REPAIRED, rules=rules)
    return explore(lambda given: judged(lambda p, g: program(p.rules, g), profile, given)).counterexample is not None
