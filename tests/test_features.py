"""Profiles without falls, collisions or width, and what the map says of them."""

import json
from dataclasses import replace
from fractions import Fraction

import pytest
from command import graphbody

from properties.claims.features import LEFT, WITH_RIDERS, promises_of
from properties.contracts import families, features
from properties.contracts.request import judged
from properties.engine.explore import explore
from properties.evidence.features import broken_in, record_of, witnesses
from properties.map.features import PART
from reference.formats.files import FormatError
from reference.play import LIBRARY, play
from spec.features import COLLISIONS, FALLS, FEATURES, WIDTH, plane_order
from spec.graph import Direction
from spec.invariants import Deed
from spec.plane import IN_PLANE
from spec.profiles import PROFILES, THESIS, WITHOUT, without
from spec.registry import rules_of, statements
from spec.rules.leave import LEAVE
from spec.unsupported import PRINTED


def played(name):
    """The scenario of a feature, played: the game at its end, and the rules that fired."""
    playing = play(LIBRARY / "scenarios" / f"{name}.json")
    steps = list(playing.steps)
    return playing.game, {rule for step in steps for move in step.moves for _, rule in move.fired}


def test_without_falls_a_ledge_is_a_wall():
    game, fired = played("feature-no-falls")
    assert {"walk/at-ledge", "walk/beyond-ledge"} <= fired
    assert not fired & {"leave/fall", "leave/jump", "walk/overhang"}
    assert [body.right.location for body in game.world.bodies] == [Fraction(299, 100), 4]


def test_without_collisions_a_body_walks_through_others_and_falls_into_them():
    game, fired = played("feature-no-collisions")
    assert "clearance/free" in fired
    assert "leave/fall" in fired
    assert game.world.bodies[0].left.edge == game.world.bodies[2].left.edge


def test_without_width_bodies_change_their_order_if_they_keep_their_position_in_a_fall():
    game, _ = played("feature-no-width")
    left = {body.name: game.world.point(body.left)[0] for body in game.world.bodies}
    assert left == {"A": 5, "B": Fraction(9, 2)}


def test_a_body_with_a_width_is_refused_where_bodies_have_none_and_the_other_way_round(tmp_path):
    text = (LIBRARY / "scenarios" / "feature-no-width.json").read_text()
    (tmp_path / "wide.json").write_text(text.replace("thesis/overshoot/no-width", "thesis"))
    with pytest.raises(FormatError, match=r"\$\.level\.bodies\[0\]: expected the left border to be left"):
        play(tmp_path / "wide.json")
    text = (LIBRARY / "scenarios" / "feature-no-collisions.json").read_text()
    (tmp_path / "point.json").write_text(text.replace("thesis/no-collisions", "thesis/no-width"))
    with pytest.raises(FormatError, match=r"\$\.level\.bodies\[0\]: expected both borders at one place"):
        play(tmp_path / "point.json")


def test_points_that_roundings_have_given_a_width_are_points(tmp_path):
    places = {"A": {"edge": 2, "location": 0}, "B": {"edge": 2, "location": 0.5}}
    held = [{"name": name, "left": at, "right": at} for name, at in places.items()]
    level = {
        "format": "graphbody/level@1",
        "name": "l",
        "vertices": [[0, 0], [1, 0], [1, 2], [2, 2]],
        "margin": "1/8",
        "bodies": held,
    }
    steps = [{"request": {"body": "A", "distance": distance}} for distance in ("1/3", 4)]
    scenario = {"format": "graphbody/scenario@1", "name": "s", "profile": "thesis/no-width", "level": level}
    (tmp_path / "s.json").write_text(json.dumps({**scenario, "steps": steps}))
    trace = graphbody("simulate", "s.json", "--floats", "--json", cwd=tmp_path).stdout
    (tmp_path / "t.jsonl").write_text(trace)
    last = json.loads(trace.splitlines()[-1])
    assert last["bodies"][0]["left"] != last["bodies"][0]["right"]
    assert graphbody("validate", "t.jsonl", cwd=tmp_path).returncode == 0
    for border in ("left", "right"):
        last["bodies"][0][border]["location"] = 0.75
    (tmp_path / "t.jsonl").write_text("\n".join([*trace.splitlines()[:-1], json.dumps(last)]))
    done = graphbody("validate", "t.jsonl", cwd=tmp_path)
    assert (done.returncode, done.stderr) == (1, "")


def test_a_state_that_no_rule_is_about_is_named(tmp_path):
    """A is said to be wholly beyond a ledge, which is a wall without falls."""
    held = [{"name": "A", "left": {"edge": 2, "location": 0}, "right": {"edge": 2, "location": 1}}]
    vertices = [[0, 0], [1, 0], [1, 2], [3, 2]]
    level = {"format": "graphbody/level@1", "name": "l", "vertices": vertices, "margin": "1/8", "bodies": held}
    steps = [{"request": {"body": "A", "distance": -1}}] * 2
    scenario = {"format": "graphbody/scenario@1", "name": "s", "profile": "thesis/no-falls", "level": level}
    (tmp_path / "s.json").write_text(json.dumps({**scenario, "steps": steps}))
    header, first, second = graphbody("simulate", "s.json", "--json", cwd=tmp_path).stdout.splitlines()
    beyond = json.loads(first)
    for border, location in (("left", -2), ("right", -1)):
        beyond["bodies"][0][border]["location"] = location
    (tmp_path / "t.jsonl").write_text("\n".join([header, json.dumps(beyond), second]))
    done = graphbody("validate", "t.jsonl", cwd=tmp_path)
    assert (done.returncode, done.stderr) == (1, "")
    assert "t.jsonl:2: $.bodies: no rule says what comes of it, leave: no rule applies" in done.stdout


def test_every_feature_can_be_taken_away_and_so_can_each_pair():
    dropped = {tuple(sorted(feature.name for feature in one.without)) for one in WITHOUT.values()}
    pairs = {("collisions", "falls"), ("collisions", "width"), ("falls", "width")}
    assert dropped == {(feature.name,) for feature in FEATURES} | pairs
    assert WITHOUT.keys() <= PROFILES.keys()
    assert LEFT.keys() == WITHOUT.keys()
    assert WITH_RIDERS.keys() <= WITHOUT.keys()


def test_what_is_not_asked_is_there_to_be_asked():
    known = statements().keys()
    for feature in FEATURES:
        assert feature.not_asked <= known
    assert set(promises_of(THESIS)) == {one.id for one in (*PRINTED, *IN_PLANE)}
    assert "invariant/plane-apart" not in promises_of(without(THESIS, COLLISIONS))


def test_the_rules_that_are_left_are_those_of_the_thesis_but_for_few():
    thesis = {rule.id for rule in rules_of(THESIS)}
    new = {one.name: {rule.id for rule in rules_of(without(THESIS, one))} - thesis for one in FEATURES}
    assert new == {"collisions": {"clearance/free"}, "falls": {"walk/at-ledge", "walk/beyond-ledge"}, "width": set()}


def failed(program, profile):
    """Whether a promise of an obligation fails under a profile."""
    return explore(lambda given: judged(lambda of, g: program(of.rules, g), profile, given)).counterexample is not None


def test_wrong_rules_are_caught():
    no_falls, no_collisions = WITHOUT["thesis/no-falls"], WITHOUT["thesis/no-collisions"]
    assert not failed(features.ledges_are_walls, no_falls)
    assert failed(features.ledges_are_walls, THESIS)
    assert not failed(families.walk_has_one, no_falls)
    walls = replace(no_falls.rules.walk, rules=no_falls.rules.walk.rules[:-1])
    assert failed(families.walk_has_one, replace(no_falls, rules=replace(no_falls.rules, walk=walls)))
    assert not failed(features.nobody_is_in_the_way, no_collisions)
    assert failed(features.nobody_is_in_the_way, THESIS)
    assert failed(features.points_are_not_obstructed, WITHOUT["thesis/no-falls"])
    assert not failed(features.points_are_not_obstructed, replace(no_falls, rules=replace(no_falls.rules, leave=LEAVE)))


def test_a_witness_breaks_what_it_is_to_and_the_part_says_so_if_not():
    profile = WITHOUT["thesis/overshoot/no-width"]
    found = witnesses(profile, False, ["invariant/plane-order"])
    record = record_of(profile, found["invariant/plane-order"], "order")
    assert "invariant/plane-order" in broken_in(record)
    findings = {name: [] for name in PART.jobs()}
    complaints = list(PART.broken(findings))
    assert "thesis/no-width: expected a witness against unsupported/tunnel" in complaints
    assert len(complaints) == sum(map(len, (*LEFT.values(), *WITH_RIDERS.values())))


@pytest.mark.parametrize(
    ("places", "kept"), [(((0, 1), (1, 1)), True), (((0, 1), (2, 1)), False), (((1, 1), (0, 2)), True)]
)
def test_order_is_kept_if_nobody_comes_beyond_another(places, kept):
    game, _ = played("feature-no-width")
    worlds = []
    for xs in places:
        world = game.world.copy()
        for body, x in enumerate(xs):
            world.bodies[body] = replace(world.bodies[body], left=replace(world.bodies[body].left, edge=2, location=x))
        worlds.append(world)
    assert bool(plane_order(Deed(*worlds, 0, Direction.RIGHT, 0, 0, 1, 1, 0, 0))) == kept


def test_features_are_told_apart():
    assert [feature.name for feature in (FALLS, COLLISIONS, WIDTH)] == ["falls", "collisions", "width"]
