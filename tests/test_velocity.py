"""Velocities: wrong rules are caught by name, ticks compose with movement, files and logs have velocities."""

import json
from dataclasses import replace
from fractions import Fraction
from functools import partial
from itertools import pairwise
from pathlib import Path

import msgspec
import pytest
from independent.levels import scenario as scenario_of

from properties.claims.claim import Verdict
from properties.claims.velocity import CLAIMS
from properties.conformance.judge import Finding
from properties.conformance.validate import validate
from properties.contracts import physics
from properties.contracts.physics import GRAVITY, on_a_slope
from properties.contracts.request import judged
from properties.contracts.velocities import any_material
from properties.engine.explore import explore
from properties.evidence.mended import broken_in_plane
from properties.slides import with_numbers
from reference.formats.files import FormatError
from reference.formats.level import LevelRecord, level_of, level_record
from reference.itf import text
from reference.play import LIBRARY, play
from reference.recording import header_of, lines_of, recording
from reference.simulator import Game
from reference.world import LevelError, World
from spec.graph import Direction, Vertex, polyline
from spec.profiles import MENDED, MENDED_VELOCITY, OF_REQUESTS, PRINTED, REPAIRED, THESIS
from spec.registry import velocity_rules_of
from spec.rule import Family
from spec.rules.velocity import (
    Motion,
    Slope,
    at_the_bound,
    by_a_factor,
    gains,
    magnitude,
    normal_printed,
    signed,
    simulate_tick,
    standing,
    stopped,
)
from spec.slope import slope_under
from spec.transform import in_floats, mirror

ONE, ZERO, TICK = Fraction(1), Fraction(0), Fraction(1, 50)


def with_effect(rules, name, rule_id, effect):
    """The rules with another effect of one of them."""
    family = getattr(rules, name)
    changed = tuple(replace(rule, effect=effect) if rule.id == rule_id else rule for rule in family.rules)
    assert changed != family.rules
    return replace(rules, **{name: Family(family.id, changed)})


def with_guard(rules, name, rule_id, guard):
    """The rules with another guard of one of them."""
    family = getattr(rules, name)
    changed = tuple(replace(rule, guard=guard) if rule.id == rule_id else rule for rule in family.rules)
    return replace(rules, **{name: Family(family.id, changed)})


def broken_by(rules, claim):
    """The promises that a claim's obligations see broken under other rules of velocity."""
    profile, found = replace(THESIS if claim.profile is THESIS else REPAIRED, velocity=rules), set()
    for obligation in claim.obligations:
        counterexample = explore(partial(judged, obligation.program, profile)).counterexample
        found |= set() if counterexample is None else set(counterexample.broken)
    for count in claim.counts:
        try:
            count.program(profile)
        except AssertionError:
            found.add(count.id)
    return found


def through_zero(grip):
    """Friction that goes on beyond rest."""
    return grip.velocity - signed(grip.loss, grip.velocity)


WRONG = {
    "friction pushes": (PRINTED, "friction", "velocity/friction-slows", lambda grip: grip.velocity + grip.loss),
    "friction turns round": (PRINTED, "friction", "velocity/friction-holds", through_zero),
    "friction never holds": (MENDED, "friction", "velocity/friction-holds", lambda grip: grip.velocity),
    "friction forgets the direction": (
        PRINTED,
        "friction",
        "velocity/friction-slows",
        lambda grip: magnitude(grip.velocity) - grip.loss,
    ),
    "a maximum forgets the direction": (PRINTED, "fastest", "velocity/maximum", lambda bounded: bounded.bound),
    "no maximum": (PRINTED, "fastest", "velocity/maximum", lambda bounded: bounded.velocity),
    "a maximum twice as great": (
        PRINTED,
        "fastest",
        "velocity/maximum",
        lambda bounded: signed(bounded.bound * 2, bounded.velocity),
    ),
    "the minimum as a velocity": (PRINTED, "slowest", "velocity/minimum-printed", at_the_bound),
    "what begins stands": (MENDED, "slowest", "velocity/begins", standing),
    "gravity uphill": (PRINTED, "pull", "velocity/gravity", lambda pull: pull.velocity - pull.gain),
    "gravity twice": (PRINTED, "pull", "velocity/gravity", lambda pull: gains(pull) + pull.gain),
    "a printed normal force": (MENDED, "normal", "velocity/normal", normal_printed),
    "a normal force of all gravity": (
        PRINTED,
        "normal",
        "velocity/normal-printed",
        lambda weight: weight.gravity,
    ),
    "a printed drag": (MENDED, "drag", "velocity/drag", by_a_factor),
    "drag as a part lost": (
        PRINTED,
        "drag",
        "velocity/drag-printed",
        lambda dragged: dragged.velocity - dragged.velocity * dragged.material.drag * 2,
    ),
    "static bodies stop": (PRINTED, "body", "velocity/static", lambda turn: turn.motion.velocity * 0),
    "friction takes all": (PRINTED, "friction", "velocity/friction-slows", stopped),
}

CAUGHT_BY = {
    "friction pushes": "resistance-only-resists",
    "friction turns round": "friction-turns-nothing",
    "friction never holds": "rest-is-kept-by-friction/repaired",
    "friction forgets the direction": "friction-turns-nothing",
    "a maximum forgets the direction": "resistance-only-resists",
    "no maximum": "speed-is-bounded",
    "a maximum twice as great": "speed-is-bounded",
    "the minimum as a velocity": "resistance-only-resists",
    "what begins stands": "rest-is-kept-by-friction/repaired",
    "gravity uphill": "way-without-friction",
    "gravity twice": "way-without-friction",
    "a printed normal force": "rest-up-to-the-coefficient",
    "a normal force of all gravity": "rest-up-to-the-printed-slope",
    "a printed drag": "drag-takes-by-the-way",
    "drag as a part lost": "drag-leaves-a-part",
    "static bodies stop": "speed-is-bounded",
    "friction takes all": "friction-turns-nothing",
}


@pytest.mark.parametrize("name", WRONG)
def test_a_wrong_rule_is_caught(name):
    rules, family, rule_id, effect = WRONG[name]
    claim = next(one for one in CLAIMS if one.id == f"claim/{CAUGHT_BY[name]}")
    assert broken_by(with_effect(rules, family, rule_id, effect), claim)


def test_a_wrong_order_of_forces_is_caught():
    turned = with_effect(PRINTED, "body", "velocity/dynamic", lambda turn: turn.motion.velocity)
    assert broken_by(turned, next(one for one in CLAIMS if one.id == "claim/way-without-friction"))


def test_energy_gained_is_caught():
    twice = with_effect(PRINTED, "pull", "velocity/gravity", lambda pull: gains(pull) + pull.gain)
    assert broken_by(twice, next(one for one in CLAIMS if one.id == "claim/no-energy-gained"))


def test_a_gap_and_an_overlap_of_guards_are_caught():
    claim = next(one for one in CLAIMS if one.id == "claim/one-velocity-rule-applies")
    assert broken_by(with_guard(PRINTED, "friction", "velocity/friction-holds", ()), claim)
    assert broken_by(replace(PRINTED, fastest=Family("fastest", PRINTED.fastest.rules[:1])), claim)


@pytest.mark.parametrize("profile", [THESIS, REPAIRED], ids=lambda profile: profile.name)
def test_the_proofs_make_every_rule_of_velocity_fire(profile):
    obligations = {o.id: o for claim in CLAIMS if claim.profile == profile for o in claim.obligations}
    fired = set()
    for obligation in obligations.values():
        if obligation.shape is None:
            fired |= explore(partial(judged, obligation.program, profile)).rules
    assert {rule.id for rule in velocity_rules_of(profile)} - fired == set()


def test_a_claim_with_numbers_of_a_list_is_not_called_proved():
    for claim in CLAIMS:
        if any(obligation.shape is not None for obligation in claim.obligations):
            assert claim.expected is Verdict.BOUNDED, claim.id


def mean_height(corners, left, right):
    """The mean height of a string of corners between two coordinates along it, by its area."""
    along, points = ZERO, []
    for (x, y), (x2, y2) in pairwise(corners):
        length = physics.polyline([Vertex(x, y), Vertex(x2, y2)]).edges[0].length
        low, high = max(left, along), min(right, along + length)
        if low < high:
            points.append((high - low) * (y + (y2 - y) * ((low + high) / 2 - along) / length))
        along += length
    return sum(points) / (right - left)


@pytest.mark.parametrize("left", [Fraction(1), Fraction(19, 2), Fraction(47, 5), Fraction(11)])
def test_the_slope_is_how_fast_the_mean_height_of_the_ground_changes(left):
    corners = [(ZERO, 6 * ONE), (8 * ONE, ZERO), (20 * ONE, 5 * ONE)]
    graph = polyline([Vertex(*corner) for corner in corners])
    row = World(replace(on_a_slope(any_material(), ZERO), graph=graph)).rows[0]
    borders = [physics.place(row.offsets, at) for at in (left, left + 1)]
    body = replace(physics.box("A", 0, ONE, None), left=borders[0], right=borders[1])
    level = replace(on_a_slope(any_material(), ZERO), graph=graph, bodies=(body,))
    slope, near = slope_under(World(level), 0), Fraction(1, 100)
    above, below = (mean_height(corners, left + by, left + 1 + by) for by in (near, -near))
    assert slope.rise == (above - below) / (2 * near)
    assert slope.run * slope.run + slope.rise * slope.rise <= 1


def test_a_body_over_a_bump_has_the_slope_from_border_to_border_and_the_friction_under_both():
    corners = [(0, 0), (2, 0), (4, Fraction(3, 2)), (6, Fraction(3, 2))]
    graph = polyline([Vertex(Fraction(x), Fraction(y)) for x, y in corners])
    edges = tuple(replace(edge, friction=Fraction(n)) for n, edge in enumerate(graph.edges))
    body = replace(physics.box("A", 0, ONE, None), right=replace(physics.box("A", 2, ZERO, None).right, location=ONE))
    level = replace(on_a_slope(any_material(), ZERO), graph=replace(graph, edges=edges), bodies=(body,))
    width = Fraction(9, 2)
    assert slope_under(World(level), 0) == Slope(4 / width, Fraction(3, 2) / width, ONE)


def test_a_top_has_the_slope_of_the_ground_below_and_no_friction_of_its_own():
    level = on_a_slope(any_material(), ZERO)
    edges = tuple(replace(edge, friction=ONE / 2) for edge in level.graph.edges)
    rider = physics.box("B", 2, ONE / 4, None)
    world = World(replace(level, graph=replace(level.graph, edges=edges), bodies=(*level.bodies, rider)))
    assert slope_under(world, 0) == Slope(Fraction(4, 5), Fraction(-3, 5), ONE / 2)
    assert slope_under(world, 1) == Slope(Fraction(4, 5), Fraction(-3, 5), None)


def energy_along(tick):
    """The energy of a body without friction, tick by tick, as it comes down a slope onto level ground."""
    corners = [(ZERO, 6 * ONE), (8 * ONE, ZERO), (20 * ONE, ZERO)]
    level = on_a_slope(any_material(friction=ZERO), 4 * ONE, tick)
    game = Game(MENDED_VELOCITY, replace(level, bodies=(physics.box("A", 0, Fraction(8), level.bodies[0].motion),)))
    while game.world.bodies[0].left.edge == 0:
        body = game.world.bodies[0]
        left, right = (game.world.coordinate(at) for at in (body.left, body.right))
        yield body.motion.velocity**2 / 2 + GRAVITY * mean_height(corners, left, right)
        game.tick(None)


def test_on_one_slope_no_energy_is_gained_but_over_a_vertex_it_may_be():
    energies = list(energy_along(Fraction(1, 10)))
    gained = [after - before for before, after in pairwise(energies)]
    assert gained[0] == -Fraction(9, 50)
    assert max(gained) > Fraction(1, 2)
    fine = list(energy_along(Fraction(1, 1000)))
    assert max(after - before for before, after in pairwise(fine)) < Fraction(1, 1000)


def ticks_of(rules, material, start, tick, count):
    """The velocity and the way after some ticks on level ground."""
    motion, way = Motion(start, material, GRAVITY, ZERO), ZERO
    for _ in range(count):
        motion = simulate_tick(rules, motion, Slope(ONE, ZERO), tick)
        way += motion.velocity * tick
    return motion.velocity, way


def test_printed_drag_depends_on_the_tick_and_damping_only_nearly():
    material = any_material(friction=ZERO, drag=Fraction(9, 10), damping=ONE)
    printed = [ticks_of(PRINTED, material, ONE, Fraction(1, n), n)[0] for n in (10, 20)]
    mended = [ticks_of(MENDED, material, ONE, Fraction(1, n), n) for n in (10, 20)]
    assert printed[1] == printed[0] ** 2
    assert mended[0][0] != mended[1][0]
    assert [velocity + way for velocity, way in mended] == [1, 1]


def test_a_body_is_stopped_by_a_wall_and_goes_on_as_printed():
    def velocities_at_the_end(profile):
        level = on_a_slope(any_material(friction=ZERO), 4 * ONE)
        game = Game(profile, replace(level, bodies=(physics.box("A", 1, Fraction(21, 2), level.bodies[0].motion),)))
        for _ in range(10):
            game.tick(None)
        assert game.world.to_wall(0, Direction.RIGHT) == 0
        return game.world.bodies[0].motion.velocity

    assert velocities_at_the_end(THESIS) == 4
    assert velocities_at_the_end(MENDED_VELOCITY) == 0


def test_a_body_up_a_slope_comes_down_again_slower():
    level = on_a_slope(any_material(friction=Fraction(1, 4)), -4 * ONE)
    game, velocities_seen = Game(MENDED_VELOCITY, level), []
    for _ in range(120):
        game.tick(None)
        velocities_seen.append(game.world.bodies[0].motion.velocity)
    assert velocities_seen[0] < 0 < velocities_seen[-1]
    assert game.world.bodies[0].left.location > 1


@pytest.mark.parametrize("profile", [THESIS, MENDED_VELOCITY], ids=lambda profile: profile.name)
def test_the_mirror_image_slides_as_the_mirror_image(profile):
    level = physics.any_slide(physics.Random(4))
    games = [Game(profile, level), Game(profile, mirror(level))]
    for _ in range(10):
        for game in games:
            game.tick(None)
    one, two = (game.world for game in games)
    assert [body.motion.velocity for body in one.bodies] == [-body.motion.velocity for body in two.bodies]
    assert [one.to_wall(body, Direction.RIGHT) for body in one.handles()] == [
        two.to_wall(body, Direction.LEFT) for body in two.handles()
    ]


def test_floats_follow_the_exact_velocities():
    level = on_a_slope(any_material(friction=Fraction(1, 4)), -4 * ONE)
    games = [Game(MENDED_VELOCITY, level), Game(MENDED_VELOCITY, in_floats(level))]
    for _ in range(100):
        for game in games:
            game.tick(None)
    exact, binary = (game.world.bodies[0] for game in games)
    assert float(exact.motion.velocity) == pytest.approx(binary.motion.velocity, abs=1e-12)
    assert float(exact.left.location) == pytest.approx(binary.left.location, abs=1e-12)


def states(name):
    """The bodies after each step of a scenario of the library, by name."""
    playing = play(LIBRARY / "scenarios" / f"{name}.json")
    return [{body.name: body for body in step.bodies} for step in playing.steps]


def test_under_repaired_a_rider_slides_relative_to_what_carries_it():
    first, *_, last = states("repaired-slide")
    assert first["Rider"].motion.velocity == 3 - Fraction(1, 8)
    assert last["Rider"].motion.velocity == 0
    carried = [state["Wide"].left.location for state in states("repaired-slide")]
    assert carried[39] > carried[0]


def test_under_repaired_a_box_slides_over_a_ledge_and_keeps_its_velocity():
    slid = states("repaired-slide")
    fell = next(i for i, state in enumerate(slid) if state["Low"].left.edge == 2)
    assert slid[fell]["Low"].motion.velocity > 0
    assert slid[-1]["Low"].motion.velocity == 0


def record(**changes):
    """A level with one box of given fields."""
    body = {"name": "A", "left": {"edge": 0, "location": "0"}, "right": {"edge": 0, "location": "1"}, **changes}
    level = {"format": "graphbody/level@1", "name": "one", "vertices": [["0", "0"], ["9", "0"]], "bodies": [body]}
    return msgspec.convert(level, LevelRecord)


@pytest.mark.parametrize(
    ("changes", "expected"),
    [
        ({"velocity": "1", "speed": "1"}, r"\$\.bodies\[0\]\.velocity: expected none: a character"),
        ({"material": {}, "speed": "1"}, r"\$\.bodies\[0\]\.material: expected none: a character"),
        ({"velocity": "much"}, r"\$\.bodies\[0\]\.velocity: expected a number"),
        ({"material": {"drag": "5/4"}}, r"\$\.bodies\[0\]\.material\.drag: expected 0 to 1, got 5/4"),
        ({"material": {"friction": "-1"}}, r"material\.friction: expected 0 or more, got -1"),
        ({"material": {"damping": "-1"}}, r"material\.damping: expected 0 or more, got -1"),
        ({"material": {"gravity": "-1"}}, r"material\.gravity: expected 0 or more, got -1"),
        ({"material": {"mass": "0"}}, r"material\.mass: expected a number greater than 0, got 0"),
        ({"material": {"fastest": "-1"}}, r"material\.fastest: expected 0 or more, got -1"),
        ({"material": {"force": "x"}}, r"material\.force: expected a number"),
    ],
)
def test_a_body_that_can_not_move_so_is_refused_with_its_place(changes, expected):
    with pytest.raises(LevelError, match=expected):
        level_of(record(**changes))


@pytest.mark.parametrize(
    "changes",
    [
        {},
        {"velocity": "-3/2"},
        {"material": {"fastest": "2"}},
        {"velocity": "1", "material": {"friction": "1/3", "mass": "2", "force": "-1"}},
    ],
)
def test_a_level_with_motions_can_be_written_and_read_again(changes):
    level = level_of(record(**changes))
    assert level_of(level_record(level, "one")) == level


def trace(name, floats=False):
    """The records of the trace of a scenario of the library."""
    playing = play(LIBRARY / "scenarios" / f"{name}.json", floats)
    return [header_of(playing, floats), *lines_of(playing)]


def test_velocities_are_in_the_traces_for_apalache(tmp_path):
    shown = json.loads("".join(text(recording(LIBRARY / "scenarios" / "physics-brakes.json"))))
    assert "velocities" in shown["vars"]
    (name, value), _ = shown["states"][0]["velocities"]["#map"]
    assert (name, value["num"]["#bigint"], value["den"]["#bigint"]) == ("Plain", "-1", "1")


def report(tmp_path, records):
    """What the validator says of a trace of records."""
    path = tmp_path / "trace.jsonl"
    path.write_bytes(b"\n".join(msgspec.json.encode(one) for one in records) + b"\n")
    return validate(path)


def with_velocity(line, velocity):
    """A line in which the first body has another velocity."""
    first, *others = line.bodies
    return msgspec.structs.replace(line, bodies=[msgspec.structs.replace(first, velocity=velocity), *others])


@pytest.mark.parametrize("name", ["physics-brakes", "repaired-slide"])
def test_a_wrong_velocity_diverges_and_is_told(name, tmp_path):
    header, first, *lines = trace(name)
    body = next(one for one in first.bodies if one.velocity is not None)
    bodies = [msgspec.structs.replace(one, velocity="7/8") if one is body else one for one in first.bodies]
    found = report(tmp_path, [header, msgspec.structs.replace(first, bodies=bodies), *lines])
    assert found.found[Finding.DIVERGES] >= 1
    assert found.first.step.number == 2
    (difference,) = found.first.differences
    assert (difference.body, difference.field, difference.seen) == (body.name, "velocity", "7/8")


def test_a_step_is_judged_from_the_velocities_of_the_log_itself(tmp_path):
    header, first, second, *_ = trace("physics-brakes")
    assert report(tmp_path, [header, first, second]).conforms
    found = report(tmp_path, [header, with_velocity(first, "-2"), second])
    assert found.found[Finding.DIVERGES] == 2


@pytest.mark.parametrize("profile", ["thesis", "thesis/mended-velocity", "repaired"])
@pytest.mark.parametrize(("velocity", "minimum"), [("0.6", "0.3"), ("0.8", "0.2"), ("0.9", "0.3")])
def test_in_floats_the_minimum_itself_may_be_missed(velocity, minimum, profile, tmp_path):
    material = {"friction": "0.3", "gravity": "10", "slowest": minimum}
    level = msgspec.to_builtins(record(velocity=velocity, material=material)) | {"tick": "0.1"}
    scenario = {"format": "graphbody/scenario@1", "name": "minimum", "level": level, "profile": profile}
    path = tmp_path / "minimum.json"
    path.write_bytes(msgspec.json.encode(scenario | {"steps": [{"tick": {"key": "none", "times": 8}}]}))
    playing = play(path, floats=True)
    header, *lines = [header_of(playing, floats=True), *lines_of(playing)]
    assert report(tmp_path, [header, *lines]).conforms
    assert not report(tmp_path, [header, with_velocity(lines[0], 0.05), *lines[1:]]).conforms


def test_a_log_without_velocities_is_refused_where_bodies_have_some(tmp_path):
    header, first = trace("physics-brakes")[:2]
    found = report(tmp_path, [header, with_velocity(first, None)])
    assert "$.bodies[0].velocity: expected the velocity of 'Plain', which moves of its own" in found.invalid
    header, first = trace("one-edge")[:2]
    found = report(tmp_path, [header, with_velocity(first, "1")])
    assert "expected none" in found.invalid


def test_rules_of_velocity_that_did_not_fire_diverge(tmp_path):
    header, first = trace("physics-brakes")[:2]
    move = first.moves[0]
    fired = [(body, rule.replace("friction-slows", "friction-holds")) for body, rule in move.fired]
    moves = [msgspec.structs.replace(move, fired=fired), *first.moves[1:]]
    found = report(tmp_path, [header, msgspec.structs.replace(first, moves=moves)])
    assert "velocity/friction-holds" in found.first.differences[0].seen


def test_the_numbers_on_the_page_are_those_of_the_rules():
    page = (Path(__file__).parents[1] / "docs" / "physics.md").read_text()
    assert with_numbers(page) == page, "run `make docs`"


def test_each_profile_has_the_rules_of_velocity_that_it_says():
    assert OF_REQUESTS["thesis/overshoot"].velocity is THESIS.velocity is PRINTED
    assert MENDED_VELOCITY.velocity is REPAIRED.velocity is MENDED


def test_numbers_that_grow_beyond_what_files_hold_are_refused_in_time_and_floats_are_not(tmp_path):
    level = msgspec.to_builtins(record(velocity="1", material={"damping": "1/3"}))
    scenario = {"format": "graphbody/scenario@1", "name": "long", "level": level, "profile": "thesis/mended-velocity"}
    path = tmp_path / "long.json"
    path.write_bytes(msgspec.json.encode({**scenario, "steps": [{"tick": {"key": "none", "times": 1000}}]}))
    with pytest.raises(FormatError, match=r"\$\.steps\[0\]: tick \d+: 'A': expected numbers whose common denominator"):
        list(play(path).steps)
    assert len(list(play(path, floats=True).steps)) == 1000


@pytest.mark.parametrize("seed", range(8))
@pytest.mark.parametrize("profile", [THESIS, MENDED_VELOCITY], ids=lambda profile: profile.name)
def test_float_traces_of_random_slides_conform(profile, seed, tmp_path):
    level = level_record(physics.any_slide(physics.Random(seed)), "slides")
    scenario = {"format": "graphbody/scenario@1", "name": "slides", "level": msgspec.to_builtins(level)}
    steps = [{"tick": {"key": "none", "times": 12}}]
    path = tmp_path / "slides.json"
    path.write_bytes(msgspec.json.encode({**scenario, "profile": profile.name, "steps": steps}))
    playing = play(path, floats=True)
    found = report(tmp_path, [header_of(playing, floats=True), *lines_of(playing)])
    assert found.conforms
    assert found.found.total() == 12


def slides_on_storeys(seed):
    """A random scenario of `repaired` in which boxes slide, and characters walk."""
    random = physics.Random(seed)
    given = scenario_of(random, f"slides {seed}")
    for body in given["level"]["bodies"]:
        if Fraction(body.get("speed", "0")) == 0:
            body["velocity"] = str(Fraction(random.randint(-12, 12), 4))
            friction, damping = Fraction(random.randint(0, 4), 8), random.choice(["0", "1", "2"])
            if random.random() < 0.7:
                body["material"] = {"gravity": "8", "friction": str(friction), "damping": damping}
    keys = ("left", "right", "none")
    return {**given, "steps": [{"tick": {"key": random.choice(keys), "times": 4}} for _ in range(3)]}


@pytest.mark.parametrize("floats", [False, True], ids=["exact", "floats"])
@pytest.mark.parametrize("seed", [*range(10), *(pytest.param(seed, marks=pytest.mark.slow) for seed in range(10, 30))])
def test_slides_on_random_storeys_keep_bodies_apart_and_conform(seed, floats, tmp_path):
    path = tmp_path / "slides.json"
    path.write_bytes(msgspec.json.encode(slides_on_storeys(seed)))
    try:
        playing = play(path, floats)
    except FormatError:
        pytest.skip("no level of storeys")
    before = playing.game.world
    for _ in playing.steps:
        assert floats or list(broken_in_plane(before, playing.game.world)) == []
        before = playing.game.world
    again = play(path, floats)
    found = report(tmp_path, [header_of(again, floats), *lines_of(again)])
    assert found.conforms, found.first


def figure_6_7(velocity, steepness, coefficient, gravity, dt):
    """The lines of figure 6.7, in the order in which they are printed."""
    velocity += steepness * gravity * dt
    friction = (1 - abs(steepness)) * coefficient * gravity
    sign = 1 if velocity >= 0 else -1
    return max(abs(velocity) - friction * dt, 0) * sign


def test_the_printed_rules_are_those_of_the_figure():
    random = physics.Random(6)
    slopes = physics.directions(random)
    for _ in range(500):
        slope, dt = next(slopes), Fraction(1, random.randint(4, 60))
        velocity, coefficient = physics.any_number(random, 8) * random.choice([-1, 1]), physics.any_number(random, 2)
        motion = Motion(velocity, any_material(friction=coefficient), GRAVITY, ZERO)
        expected = figure_6_7(velocity, slope.steepness, coefficient, GRAVITY, dt)
        assert simulate_tick(PRINTED, motion, slope, dt).velocity == expected


def test_mass_matters_for_a_force_only():
    for mass in (ONE, 3 * ONE):
        material = replace(any_material(friction=ONE / 4), mass=mass)
        pulled, pushed = (Motion(ONE, material, GRAVITY, force) for force in (ZERO, 6 * ONE))
        first, second = (simulate_tick(MENDED, one, Slope(ONE, ZERO), TICK).velocity for one in (pulled, pushed))
        assert first == 1 - GRAVITY / 4 * TICK
        assert second - first == 6 / mass * TICK
