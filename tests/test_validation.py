"""Validation: what conforms is said to conform; of what does not, the first step is found and explained."""

import json
import tracemalloc
from collections import Counter
from dataclasses import replace
from fractions import Fraction

import msgspec
import pytest
from command import graphbody
from hypothesis import HealthCheck, given, settings, strategies as st

from properties.conformance import validate as validation
from properties.conformance.judge import Finding, judge
from properties.conformance.log import tolerance_of
from properties.conformance.validate import validate
from properties.conformance.ways import Ways, near
from properties.engine.ties import TIES, Near, Ties, TooManyWays, every_way
from properties.strategies.rows import multiples, trials
from properties.strategies.scenes import levels_with_ledges
from reference.formats.files import FormatError
from reference.formats.level import BodyRecord, LevelRecord, Position, level_of
from reference.formats.trace import HeaderRecord, LineRecord
from reference.play import LIBRARY, library, play
from reference.recording import header_of, lines_of
from reference.simulator import Game, move
from reference.world import World, standing
from spec.graph import Direction
from spec.profiles import OVERSHOOT, THESIS, Profile
from spec.rule import Family, GuardError, Rule
from spec.rules.clearance import CLEARANCE
from spec.rules.leave import LEAVE, land_at, stay
from spec.rules.push import CONTACT, PUSH, nothing, the_stride
from spec.rules.walk import WALK, stop_after
from spec.transform import in_floats, with_borders, with_numbers

SCENARIOS = LIBRARY / "scenarios"
QUICK = settings(
    max_examples=150, deadline=None, derandomize=True, database=None, suppress_health_check=list(HealthCheck)
)


def trace_of(scenario, floats=False, profile=None):
    """The records of the trace of a scenario, played by a faulty profile if one is given."""
    playing = play(scenario, floats)
    if profile is not None:
        playing.game.profile = profile
    return [header_of(playing, floats), *lines_of(playing)]


def written(path, records):
    """A trace file of records."""
    path.write_bytes(b"\n".join(msgspec.json.encode(record) for record in records) + b"\n")
    return path


def bare(record):
    """A line as a foreign program may log it: what was asked, and where the bodies are."""
    return LineRecord(request=record.request, tick=record.tick, bodies=record.bodies)


@pytest.mark.parametrize("floats", [False, True], ids=["exact", "floats"])
@pytest.mark.parametrize("path", library(), ids=lambda path: path.stem)
def test_the_trace_of_every_scenario_conforms(path, floats, tmp_path):
    report = validate(written(tmp_path / "trace.jsonl", trace_of(path, floats)))
    assert report.conforms
    assert report.found.total() == report.found[Finding.AGREES]


def test_what_a_feature_makes_meaningless_is_not_told_of_without_it(tmp_path, monkeypatch):
    trace = written(tmp_path / "trace.jsonl", trace_of(SCENARIOS / "feature-no-collisions.json"))
    assert validate(trace).broken == {}
    monkeypatch.setattr(Profile, "not_asked", frozenset())
    assert validate(trace).broken.keys() == {"invariant/no-overlap", "invariant/plane-apart", "invariant/plane-margin"}


@pytest.mark.parametrize("name", ["push-into-wall", "figure-1-2-fall-edge", "figure-6-1-position-lookup"])
def test_floats_on_a_grid_conform_to_the_bit(name, tmp_path):
    header, *lines = trace_of(SCENARIOS / f"{name}.json", floats=True)
    on_grid = msgspec.structs.replace(header, grid="1/64", numbers="float32")
    assert validate(written(tmp_path / "trace.jsonl", [on_grid, *lines])).conforms
    last = lines[-1].bodies[0]
    off = msgspec.structs.replace(last, left=msgspec.structs.replace(last.left, location=last.left.location + 1 / 64))
    changed = msgspec.structs.replace(lines[-1], bodies=[off, *lines[-1].bodies[1:]])
    assert not validate(written(tmp_path / "trace.jsonl", [on_grid, *lines[:-1], changed])).conforms
    with pytest.raises(FormatError, match=r":1: \$\.level\.vertices\[\d\]: expected a multiple of 16, below"):
        validate(written(tmp_path / "trace.jsonl", [msgspec.structs.replace(on_grid, grid="16"), *lines]))


def test_a_vertex_has_two_names_and_either_is_accepted(tmp_path):
    level = LevelRecord(
        "graphbody/level@1",
        "vertex",
        [("0", "0"), ("4", "0"), ("8", "0")],
        [BodyRecord("A", Position("1", edge=0), Position("2", edge=0))],
    )
    header = HeaderRecord("graphbody/trace@1", "vertex", "thesis", "exact", level)
    for right in (Position("4", edge=0), Position("0", edge=1)):
        line = {"request": {"body": "A", "distance": "2"}}
        line["bodies"] = [{"name": "A", "left": Position("3", edge=0), "right": right}]
        record = msgspec.convert(msgspec.to_builtins(line), LineRecord)
        assert validate(written(tmp_path / "trace.jsonl", [header, record])).conforms


# Games in floats on levels off any grid: errors add up from step to step, and every step is judged from its own state.

SCALES = st.sampled_from([Fraction(4, 5), Fraction(2, 3), Fraction(8, 7), Fraction(1000, 3)])
WISHES = st.lists(
    st.tuples(st.integers(0, 5), st.one_of(multiples(8, 1), multiples(8, 12)), st.sampled_from((1, -1))),
    min_size=1,
    max_size=12,
)
FLOATS = HeaderRecord("graphbody/trace@1", "floats", "thesis", "float64", None)


def scaled(level, scale):
    """The level at another scale."""
    return with_numbers(level, lambda number: number * scale, lambda slope: slope)


def exactly(level, world):
    """The state of a float world as it would stand in a log."""

    def exact(at):
        return replace(at, location=Fraction(at.location))

    pairs = zip(world.bodies, level.bodies, strict=True)
    placed = [replace(with_borders(now, exact), speed=body.speed, height=body.height) for now, body in pairs]
    return standing(replace(level, bodies=tuple(placed)))


def judged_games(profile, level, wishes):
    """Play a game in floats; yield the judgement of each step, what was seen, and the tolerance."""
    binary, before = Game(profile, in_floats(level)), World(level)
    for number, distance, sign in wishes:
        body = number % len(level.bodies)
        wish = float(distance * sign)
        binary.request(level.bodies[body].name, wish)
        seen = exactly(level, binary.world)
        asked = ((body, Direction.LEFT if wish < 0 else Direction.RIGHT, abs(Fraction(wish))),)
        tolerance = tolerance_of(FLOATS, level, asked)
        yield judge(profile, before, asked, seen, tolerance), seen, tolerance
        before = seen


@QUICK
@given(levels_with_ledges(), SCALES, WISHES, st.sampled_from([THESIS, OVERSHOOT]))
def test_games_in_floats_on_levels_with_ledges_conform(level, scale, wishes, profile):
    scaled_wishes = [(body, distance * scale, sign) for body, distance, sign in wishes]
    for judgement, _, _ in judged_games(profile, scaled(level, scale), scaled_wishes):
        assert judgement.finding in (Finding.AGREES, Finding.ONE_OF_SEVERAL)


@QUICK
@given(trials(), SCALES, WISHES)
def test_games_in_floats_on_rows_conform(trial, scale, wishes):
    level = scaled(trial.level, scale)
    first = (trial.body, trial.asked, trial.direction)
    scaled_wishes = [(body, distance * scale, sign) for body, distance, sign in [first, *wishes]]
    for judgement, _, _ in judged_games(THESIS, level, scaled_wishes):
        assert judgement.finding is Finding.AGREES


def test_near_a_ledge_both_outcomes_are_allowed_and_further_away_one(tmp_path):
    fell = [{"name": "A", "left": {"edge": 2, "location": 0.0}, "right": {"edge": 2, "location": 1.0}}]
    for end, allowed in ((4.0, True), (4.0 + 1e-15, True), (4.0 - 1e-15, True), (4.0 - 1e-6, False)):
        level = {
            "format": "graphbody/level@1",
            "name": "ledge",
            "vertices": [[0, 1], [4, 1], [4, 0], [9, 0]],
            "bodies": [{"name": "A", "left": {"edge": 0, "location": 1}, "right": {"edge": 0, "location": 2}}],
        }
        header = {"format": "graphbody/trace@1", "name": "l", "profile": "thesis", "numbers": "float64", "level": level}
        stays = [{"name": "A", "left": {"edge": 0, "location": end}, "right": {"edge": 0, "location": end + 1}}]
        for bodies in (stays, fell):
            line = {"request": {"body": "A", "distance": end - 1}, "bodies": bodies}
            report = validate(written(tmp_path / "trace.jsonl", [header, line]))
            assert report.conforms == (allowed or bodies is stays)
            assert report.found[Finding.DIVERGES] == (not report.conforms)


def every_outcome_at_once(profile, level, asked, tolerance):
    """The outcomes of a request if its ties are not taken body by body, but all together."""
    body, direction, distance = asked

    def run(choices):
        TIES.set(Ties(Fraction(0), choices))
        world = World(with_numbers(level, Near, Fraction))
        TIES.set(Ties(tolerance, choices))
        rules = replace(profile, rules=profile.rules.through(Anew))
        try:
            move(rules, world, body, direction, Near(distance))
        except GuardError:
            return None
        return world

    return [world for world in every_way(run, 3000) if world is not None]


class Anew:
    """A family that breaks ties anew for every situation."""

    def __init__(self, family):
        self.family = family

    def choose(self, facts):
        TIES.get().anew()
        return self.family.choose(facts)


def alike(one, two, tolerance):
    pairs = list(zip(one.bodies, two.bodies, strict=True))
    return all(near(a.left, b.left, tolerance) and near(a.right, b.right, tolerance) for a, b in pairs)


def test_ties_taken_body_by_body_give_the_outcomes_of_all_ties_together():
    seen = Counter()

    @QUICK
    @given(levels_with_ledges(), st.integers(0, 4), multiples(8, 4), st.sampled_from(Direction))
    def compare(level, number, distance, direction):
        tolerance = Fraction(1, 1000)
        asked = (number % len(level.bodies), direction, distance)
        try:
            naive = every_outcome_at_once(THESIS, level, asked, tolerance)
        except TooManyWays:
            seen["too many"] += 1
            return
        merged = Ways(THESIS, tolerance).one_after_another(level, [asked])
        assert all(any(alike(one, two, 9 * tolerance) for two, _ in merged) for one in naive)
        assert all(any(alike(one, two, 9 * tolerance) for one in naive) for two, _ in merged)
        seen["compared"] += 1
        seen["several"] += len(merged) > 1

    compare()
    print(dict(seen))
    assert seen["compared"] >= 100
    assert seen["several"] >= 10


def test_a_row_of_twelve_in_contact_has_few_ways():
    bodies = [
        BodyRecord(f"{i}", Position(f"{11 * i}/10", edge=0), Position(f"{11 * i + 10}/10", edge=0)) for i in range(12)
    ]
    level = level_of(LevelRecord("graphbody/level@1", "row", [("0", "0"), ("40", "0")], bodies, margin="1/10"))
    ways = Ways(THESIS, Fraction(1, 10**9))
    assert len(ways.one_after_another(level, [(0, Direction.RIGHT, Fraction(1, 2))])) == 1
    assert len(ways.worlds) <= 3 * len(bodies)


# Faulty implementations: each has one rule that is wrong, and is found out by a scenario of the library.


def with_effect(family, rule, effect):
    """The family with another effect of one rule."""
    return Family(family.id, tuple(replace(one, effect=effect) if one.id == rule else one for one in family.rules))


def gap(sight):
    return sight.gap


def through_the_wall(step):
    rest = step.motion.rest
    return stop_after(rest, step.view.along(step.motion.at, rest), step.motion)


def no_landing(leaving):
    return land_at(leaving, leaving.near[0].target)


FAULTS = {
    "never falls": ("leave", Family("leave", (Rule("leave/stay", "", "", (), stay),)), {"leave/fall"}),
    "walks through walls": ("walk", with_effect(WALK, "walk/wall", through_the_wall), {"walk/wall"}),
    "keeps no margin": ("clearance", with_effect(CLEARANCE, "clearance/margin", gap), {"contact/stop", "walk/wall"}),
    "pushes nobody": ("push", with_effect(PUSH, "push/request", nothing), {"push/request", "push/none", "walk/along"}),
    "walks through bodies": ("contact", with_effect(CONTACT, "contact/stop", the_stride), {"contact/stop"}),
    "takes any jump": ("leave", with_effect(LEAVE, "leave/jump", no_landing), {"leave/jump"}),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_a_faulty_implementation_is_found_out(fault, tmp_path):
    field, family, culprits = FAULTS[fault]
    faulty = replace(THESIS, rules=replace(THESIS.rules, **{field: family}))
    for path in library():
        if play(path).scenario.profile != "thesis":
            continue
        try:
            header, *lines = trace_of(path, profile=faulty)
        except (AssertionError, GuardError, KeyError):
            continue
        report = validate(written(tmp_path / "trace.jsonl", [header, *map(bare, lines)]))
        if report.first is not None and report.first.diagnosis is not None:
            diagnosis = report.first.diagnosis
            if diagnosis.decision is not None and diagnosis.decision.rule.id in culprits:
                return
    pytest.fail(f"an implementation that {fault} is not found out")


# What a line says beside where the bodies are.


@pytest.mark.parametrize(
    ("scenario", "field", "value"),
    [
        ("push-into-wall", "moves", lambda line: [{**line["moves"][0], "moved": "1"}]),
        ("push-into-wall", "moves", lambda line: [{**line["moves"][0], "asked": "1"}]),
        ("push-into-wall", "moves", lambda line: [{**line["moves"][0], "fired": line["moves"][0]["fired"][1:]}]),
        ("push-into-wall", "moves", lambda line: []),
        ("push-into-wall", "events", lambda line: [{"body": "Box 1", "event": "fall", "rule": "leave/fall"}]),
        ("figure-6-1-position-lookup", "supports", lambda line: {}),
        ("huge-and-cute-solved", "pressed", lambda line: [not pressed for pressed in line["pressed"]]),
        ("huge-and-cute-solved", "pressed", lambda line: []),
        ("huge-and-cute-solved", "solved", lambda line: not line["solved"]),
    ],
)
def test_whatever_else_a_line_says_must_be_so(scenario, field, value, tmp_path):
    header, *lines = map(msgspec.to_builtins, trace_of(SCENARIOS / f"{scenario}.json"))
    lines[0][field] = value(lines[0])
    report = validate(written(tmp_path / "trace.jsonl", [header, *lines]))
    assert not report.conforms
    assert report.first.step.number == 2
    assert report.first.diagnosis is None
    assert report.found[Finding.DIVERGES] == 1


def test_of_a_divergence_the_smallest_scenario_in_simple_numbers_is_kept(tmp_path):
    header = trace_of(SCENARIOS / "push-into-wall.json", floats=True)[0]
    far = [(f"{100 + 2 * i}", f"{101 + 2 * i}") for i in range(9)]
    bodies = [BodyRecord(f"at {a}", Position(a, edge=2), Position(b, edge=2)) for a, b in far]
    level = msgspec.structs.replace(header.level, bodies=[*header.level.bodies[:3], *bodies], margin="1/10")
    vertices = [*header.level.vertices[:3], ("400", "0")]
    level = msgspec.structs.replace(level, vertices=vertices)
    header = msgspec.structs.replace(header, level=level)
    game = Game(THESIS, in_floats(level_of(level)))
    game.request("Character", 1.2)
    state = [
        {
            "name": body.name,
            "left": {"edge": body.left.edge, "location": body.left.location},
            "right": {"edge": body.right.edge, "location": body.right.location},
        }
        for body in game.world.bodies
    ]
    first = {"request": {"body": "Character", "distance": 1.2}, "bodies": state}
    second = {"request": {"body": "Character", "distance": 0.3}, "bodies": state}
    report = validate(written(tmp_path / "trace.jsonl", [header, first, second]))
    assert report.first.step.number == 3
    scenario = report.first.scenario
    assert [body.name for body in scenario.level.bodies] == ["Character", "Box 1"]
    assert {body.left.location for body in scenario.level.bodies} == {"2", "7/2"}


# What reviews found.


def trace_on(level, *lines, numbers="exact"):
    """A trace of lines on a level, given as they stand in files."""
    header = {"format": "graphbody/trace@1", "name": "t", "profile": "thesis", "numbers": numbers}
    return [header | {"level": {"format": "graphbody/level@1", "name": "l"} | level}, *lines]


def body(name, left, right, edge=0):
    """A body's place on one edge."""
    return {"name": name, "left": {"edge": edge, "location": left}, "right": {"edge": edge, "location": right}}


TWO_EDGES = {"vertices": [[0, 0], [4, 0], [8, 0]], "bodies": [body("A", 1, 2)]}
RING = {"vertices": [[0, 0]], "circumference": 8, "bodies": [body("A", 0, 1)]}


@pytest.mark.parametrize(("level", "asked", "seen"), [(TWO_EDGES, 5, (6, 7)), (RING, 2, (10, 11))])
def test_a_location_beyond_its_edge_is_not_the_next_edge(level, asked, seen, tmp_path):
    line = {"request": {"body": "A", "distance": asked}, "bodies": [body("A", *seen)]}
    assert not validate(written(tmp_path / "trace.jsonl", trace_on(level, line))).conforms


def test_a_long_request_does_not_switch_the_judge_off(tmp_path):
    line = {"request": {"body": "A", "distance": 1e8}, "bodies": [body("A", 3, 4)]}
    level = {"vertices": [[0, 0], [10, 0]], "bodies": [body("A", 0, 1)]}
    assert not validate(written(tmp_path / "trace.jsonl", trace_on(level, line, numbers="float32"))).conforms


def test_bodies_in_contact_in_floats_may_be_in_the_header_and_a_step_from_there_can_be_replayed(tmp_path):
    level = {"vertices": [[0, 0], [3, 0]], "margin": 0.05, "bodies": [body("a", 0.1, 1.1), body("b", 1.15, 2.15)]}
    line = {"request": {"body": "a", "distance": 1}, "bodies": [body("a", 0.1, 1.1), body("b", 1.15, 2.15)]}
    report = validate(written(tmp_path / "trace.jsonl", trace_on(level, line, numbers="float64")))
    assert report.first.step.number == 2
    level_of(report.first.scenario.level)
    assert "a asks b for 1, b moves 0.8500000000000001" in report.first.diagnosis.story


def test_of_a_tie_too_the_moves_are_judged(tmp_path):
    level = {"vertices": [[0, 1], [4, 1], [4, 0], [9, 0]], "bodies": [body("A", 1, 2)]}
    fell = {"request": {"body": "A", "distance": 3}, "bodies": [body("A", 0, 1, edge=2)]}
    for moved, conforms in ((3, True), (999, False)):
        line = fell | {"moves": [{"body": "A", "asked": 3, "moved": moved}]}
        report = validate(written(tmp_path / "trace.jsonl", trace_on(level, line, numbers="float64")))
        assert report.conforms == conforms
        assert report.found[Finding.ONE_OF_SEVERAL] == conforms


def test_many_bodies_in_one_place_are_ambiguous_and_not_counted_through(tmp_path):
    level = {"vertices": [[0, 0], [40, 0]], "bodies": [body(f"{i}", 2 * i, 2 * i + 1) for i in range(12)]}
    pile = {"request": {"body": "0", "distance": 0}, "bodies": [body(f"{i}", 1, 2) for i in range(12)]}
    report = validate(written(tmp_path / "trace.jsonl", trace_on(level, pile, pile)))
    assert report.found == {Finding.DIVERGES: 1, Finding.AGREES: 1}
    other = pile | {"bodies": [body("0", 3, 4), *pile["bodies"][1:]]}
    report = validate(written(tmp_path / "trace.jsonl", trace_on(level, pile, other)))
    assert report.found == {Finding.DIVERGES: 1, Finding.AMBIGUOUS: 1}


def test_rules_are_not_judged_where_the_order_of_bodies_is_not_known(tmp_path):
    level = {
        "vertices": [[0, 1], [0.5, 1], [0.5, 2], [2.625, 2], [2.625, 0], [3.125, 0]],
        "margin": 0.125,
        "bodies": [
            body("A", 0, 1, edge=2),
            {"name": "B", "left": {"top": "A", "location": 0}, "right": {"top": "A", "location": 1}},
            body("C", 1.125, 2.125, edge=2),
        ],
    }
    steps = [{"request": {"body": "C", "distance": -3}}, {"request": {"body": "B", "distance": 1}}]
    scenario = {"format": "graphbody/scenario@1", "name": "s", "steps": steps}
    scenario["level"] = {"format": "graphbody/level@1", "name": "l"} | level
    (tmp_path / "scenario.json").write_text(json.dumps(scenario))
    records = trace_of(tmp_path / "scenario.json")
    assert records[1].bodies[1].left == records[1].bodies[2].left, "C has jumped right into B"
    assert validate(written(tmp_path / "trace.jsonl", records)).conforms


def test_one_wrong_number_in_a_long_row_in_contact_is_found_with_counted_work(tmp_path):
    count = 60
    pairs = [(f"{8 * i + 1}/10", f"{8 * i + 8}/10") for i in range(count)]
    bodies = [BodyRecord(f"{i}", Position(a, edge=0), Position(b, edge=0)) for i, (a, b) in enumerate(pairs)]
    level = level_of(LevelRecord("graphbody/level@1", "row", [(0, 0), (100, 0)], bodies, margin="1/10"))
    game = Game(THESIS, in_floats(level))
    game.request("0", 1.3)
    seen = exactly(level, game.world)
    ways = Ways(THESIS, tolerance_of(FLOATS, level, ()))
    reached = ways.one_after_another(seen.level, [(0, Direction.RIGHT, Fraction(1.3))])
    assert len(reached) == 1
    assert ways.decisions < 150 * count


def test_a_number_off_the_grid_is_a_divergence_and_the_rest_is_judged(tmp_path):
    header, *lines = trace_of(SCENARIOS / "free-path.json", floats=True)
    on_grid = msgspec.structs.replace(header, grid="1/64")
    held = lines[0].bodies[0]
    off = msgspec.structs.replace(held, left=msgspec.structs.replace(held.left, location=held.left.location + 1e-12))
    changed = msgspec.structs.replace(lines[0], bodies=[off, *lines[0].bodies[1:]])
    report = validate(written(tmp_path / "trace.jsonl", [on_grid, changed, *lines[1:]]))
    assert report.found.total() == len(lines)
    assert report.first.step.number == 2


def test_exact_logs_that_are_floats_are_told_so(tmp_path):
    level = {"vertices": [[0, 0], [10, 0]], "bodies": [body("A", 0.1, 1.1)]}
    line = {"request": {"body": "A", "distance": 0.7}, "bodies": [body("A", 0.1 + 0.7, 1.1 + 0.7)]}
    report = validate(written(tmp_path / "trace.jsonl", trace_on(level, line)))
    assert report.conforms or report.first.rounded


def test_a_slope_raises_bodies_and_breaks_no_invariant(tmp_path):
    assert validate(written(tmp_path / "trace.jsonl", trace_of(SCENARIOS / "hill.json"))).broken == {}


# The command line.


def test_what_cannot_be_written_is_one_line_and_the_other_traces_are_judged(tmp_path):
    good = trace_of(SCENARIOS / "push-into-wall.json")
    written(tmp_path / "good.jsonl", good)
    written(tmp_path / "diverges.jsonl", [good[0], *good[2:]])
    (tmp_path / "build").write_text("")
    header, *lines = good
    wrong = [msgspec.structs.replace(line, step=None) for line in lines[1:]]
    written(tmp_path / "diverges.jsonl", [header, *map(bare, wrong)])
    done = graphbody("validate", "diverges.jsonl", "good.jsonl", cwd=tmp_path)
    assert done.returncode == 2
    assert done.stderr == "graphbody: build/divergences/diverges-line-2.json: Not a directory\n"
    assert "good.jsonl: conforms" in done.stdout


def test_one_bad_trace_does_not_stop_the_others_and_the_worst_is_the_exit_status(tmp_path):
    good = trace_of(SCENARIOS / "push-into-wall.json")
    written(tmp_path / "good.jsonl", good)
    written(tmp_path / "diverges.jsonl", [good[0], *good[2:]])
    (tmp_path / "cut.jsonl").write_bytes((tmp_path / "good.jsonl").read_bytes()[:-40])
    done = graphbody("validate", "cut.jsonl", "good.jsonl", cwd=tmp_path)
    assert done.returncode == 2
    assert "good.jsonl: conforms to thesis; 7 steps (agrees: 7)" in done.stdout
    assert done.stderr.startswith("graphbody: cut.jsonl:8: not JSON: ")
    assert not (tmp_path / "build").exists()


def test_a_divergence_is_told_with_place_rule_guard_and_a_replay_that_works(tmp_path):
    header, *lines = trace_of(SCENARIOS / "push-into-wall.json")
    last = lines[2].bodies[3]
    inside = msgspec.structs.replace(last, right=Position("17/2", edge=2), left=Position("15/2", edge=2))
    lines[2] = bare(msgspec.structs.replace(lines[2], bodies=[*lines[2].bodies[:3], inside]))
    written(tmp_path / "trace.jsonl", [header, *lines])
    done = graphbody("validate", "trace.jsonl", cwd=tmp_path)
    assert done.returncode == 1
    assert "line 4, step 3, Character asked 10: diverges" in done.stdout
    assert "Box 3 right: expected 8 on edge 2, seen 17/2 on edge 2" in done.stdout
    assert "rule expected: walk/wall" in done.stdout
    assert "true   no_ledge_follows" in done.stdout
    replay = done.stdout.partition("graphbody simulate ")[2].splitlines()[0]
    assert graphbody("simulate", replay, cwd=tmp_path).returncode == 0
    record = json.loads(graphbody("validate", "--json", "trace.jsonl", cwd=tmp_path).stdout)
    assert record["format"] == "graphbody/validation@1"
    assert (record["first"]["line"], record["first"]["body"], record["first"]["field"]) == (4, "Box 3", "left")


def test_a_state_that_no_body_can_be_in_is_neither_a_divergence_nor_a_bad_file(tmp_path):
    header, *lines = map(msgspec.to_builtins, trace_of(SCENARIOS / "push-into-wall.json"))
    lines[1]["bodies"][0]["left"]["location"] = lines[1]["bodies"][0]["right"]["location"]
    report = validate(written(tmp_path / "trace.jsonl", [header, *lines]))
    assert not report.conforms
    assert report.invalid.endswith(
        "trace.jsonl:3: $.bodies[0]: expected the left border to be left of the right border"
    )
    assert report.found.total() == 1


def test_a_failure_of_the_validator_is_told_apart(tmp_path, monkeypatch):
    path = written(tmp_path / "trace.jsonl", trace_of(SCENARIOS / "push-into-wall.json"))
    monkeypatch.setattr(validation, "judge", lambda *_: 1 / 0)
    with pytest.raises(validation.Crash, match="internal error, please report it: ZeroDivisionError"):
        validate(path)


def test_memory_does_not_grow_with_the_log(tmp_path):
    header, line, *_ = trace_of(SCENARIOS / "free-path.json")
    still = bare(line)
    rest = msgspec.structs.replace(still, request=msgspec.structs.replace(still.request, distance="0"))
    peaks = []
    for times in (10, 100, 700):
        path = written(tmp_path / "trace.jsonl", [header, still, *[rest] * times])
        tracemalloc.start()
        assert validate(path).conforms
        peaks.append(tracemalloc.get_traced_memory()[1])
        tracemalloc.stop()
    assert peaks[2] < 1.5 * peaks[1]
