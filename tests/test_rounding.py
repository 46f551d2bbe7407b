"""Rounding: what the tolerance of the validator rests on, and that correct rows in floats are within it."""

import json
import random
from dataclasses import replace
from fractions import Fraction
from functools import partial
from itertools import pairwise
from pathlib import Path
from random import Random

import msgspec
import numpy as np
import pytest

from properties.claims.rounding import INSTANTS, NEARLY, ON_RINGS, PAIR
from properties.comparison.levels import any_level
from properties.conformance.judge import Finding, displaced, expect, judge
from properties.conformance.spread import ON_A_LINE, roundings_of, spread
from properties.conformance.stepping import OfSteps
from properties.conformance.validate import OfRequests, validate
from properties.conformance.walks import most_walks
from properties.contracts import floats, rounded_steps, rounding
from properties.contracts.request import judged
from properties.engine.explore import explore
from properties.engine.rounded import Machine, Rounded
from properties.given import Exact
from properties.strategies.storeys import outing
from properties.worlds.changes import in_floats
from properties.worlds.rows import located, string_graph
from reference.formats.level import level_record
from reference.play import play
from reference.recording import header_of, lines_of
from reference.rounding import ROUNDINGS, UNIT_ROUNDOFF, largest, rounding as rounding_of, tolerance
from reference.simulator import move
from reference.stepping import run
from reference.storeys import Place, StoreyWorld, Terrain
from reference.world import World
from spec.body import Body, EdgePosition, Level
from spec.graph import Direction
from spec.profiles import REPAIRED, THESIS
from spec.rule import Family
from spec.rules.clearance import CLEARANCE
from spec.rules.event import CONTACT
from spec.rules.push import PUSH
from spec.rules.step import Instant
from spec.storeys import Contact, Drive, Interval, short_way
from spec.transform import with_numbers

RIGHT = Direction.RIGHT
DOCS = Path(__file__).parents[1] / "docs"
FLOATS = {"float64": float, "float32": lambda number: np.float32(float(number))}


def with_effect(family, rule, effect):
    """The family with another effect of one rule."""
    return Family(family.id, tuple(replace(one, effect=effect) if one.id == rule else one for one in family.rules))


def on_the_last_edge(profile, **more):
    """What the exploration of a segment on the last edge shows."""
    return explore(partial(judged, partial(last_edge, **more), profile))


def last_edge(profile, given, **more):
    rounding.segment_is_nearly_exact(profile, given, closed=False, direction=RIGHT, last=True, **more)


def test_a_segment_is_off_by_so_many_roundings_and_not_by_half_as_many():
    assert on_the_last_edge(THESIS).proved
    fewer = on_the_last_edge(THESIS, within=4)
    assert fewer.counterexample is not None


@pytest.mark.parametrize(
    ("family", "of", "rule", "effect"),
    [
        ("push", PUSH, "push/request", lambda want: want.stride),
        ("clearance", CLEARANCE, "clearance/margin", lambda sight: sight.gap),
    ],
)
def test_a_wrong_rule_is_off_by_more(family, of, rule, effect):
    wrong = replace(THESIS.rules, **{family: with_effect(of, rule, effect)})
    assert on_the_last_edge(replace(THESIS, rules=wrong)).counterexample is not None


def test_what_a_request_says_is_rounded():
    (says,) = [one for one in NEARLY if "request" in one.id]
    assert explore(partial(judged, says.program, THESIS)).proved
    less = partial(rounding.request_says_nearly_what_it_does, within=1)
    assert explore(partial(judged, less, THESIS)).counterexample is not None


def test_a_push_on_one_edge_loses_5_roundings_of_the_margin_and_2_more_each_time():
    for direction in Direction:
        push = partial(rounding.push_keeps_the_margin_nearly, direction=direction)
        assert explore(partial(judged, push, THESIS)).proved
        for fewer in ({"apart": 4}, {"nearer": 1}):
            assert explore(partial(judged, partial(push, **fewer), THESIS)).counterexample is not None


@pytest.mark.parametrize("instant", [*INSTANTS, ON_RINGS[1]], ids=lambda one: one.id)
def test_errors_spread_from_instant_to_instant_at_any_velocities(instant):
    assert explore(partial(judged, instant.program, REPAIRED)).proved


def two_that_meet(profile, given, **more):
    rounded_steps.errors_spread_so(profile, given, PAIR, Contact, **more)


@pytest.mark.parametrize("name", ["stretch", "room", "meeting"])
def test_fewer_roundings_are_too_few(name):
    fewer = replace(ON_A_LINE, **{name: getattr(ON_A_LINE, name) - 1})
    assert explore(partial(two_that_meet, REPAIRED, roundings=fewer)).counterexample is not None


def test_a_wrong_rule_of_events_is_late_by_more():
    wrong = replace(REPAIRED.rules, contact=with_effect(CONTACT, "event/contact", later))
    shown = explore(partial(judged, two_that_meet, replace(REPAIRED, rules=wrong)))
    assert shown.counterexample is not None


def test_a_machine_that_takes_the_last_instant_for_the_next_is_late(monkeypatch):
    monkeypatch.setattr(rounded_steps, "next_instant", lambda coming, left: Instant(left, (), last=True))
    assert explore(partial(judged, rounded_steps.first_comes_nearly_first, REPAIRED)).counterexample is not None


def later(nearing):
    return (nearing.room + nearing.room) / nearing.speed


def run_twice(world, drives, duration):
    """A step in floats, and one of the very same numbers in exact ones: both worlds, and both courses."""
    exact = exactly(world)
    right, _ = run(REPAIRED.rules, exact, drives, Fraction(duration))
    floating = {body: replace(one, speed=float(one.speed)) for body, one in drives.items()}
    nearly, _ = run(REPAIRED.rules, world, floating, duration)
    return exact, right, nearly


def exactly(world):
    """The storeys that a world of floats has, in exact numbers."""

    def interval(one):
        return Interval(Fraction(one.left), Fraction(one.right))

    ground, places = world.terrain, []
    solid = tuple(tuple(interval(one) for one in storey) for storey in ground.solid)
    ends, round_ = ground.ends, ground.circumference
    terrain = Terrain(solid, ends and interval(ends), None if round_ is None else Fraction(round_))
    places = [replace(one, left=Fraction(one.left), width=Fraction(one.width)) for one in world.places]
    return StoreyWorld(terrain, Fraction(world.margin), places)


def off(one, two):
    """How far bodies are from where they are in exact numbers."""
    round_ = one.terrain.circumference
    return max(abs(short_way(Fraction(b.left) - a.left, round_)) for a, b in zip(one.places, two.places, strict=True))


def marks(moments):
    """What came, instant by instant."""
    return [sorted(str(event.mark) for event in moment.events) for moment in moments if moment.events]


def test_a_rider_that_slowly_leaves_a_fast_carrier_is_off_by_many_roundings_and_within_the_spread():
    slow, fast, duration = 0.01, 1000.0, 0.05
    rider = 3.1 - 1.1 - 0.125 + slow * duration * 0.4
    places = [Place(0, 3.1, 1.3, None), Place(1, rider, 1.1, 0)]
    world = StoreyWorld(Terrain((), Interval(0.0, 64.0)), 0.125, places)
    drives = {0: Drive(Fraction(fast), relative=False), 1: Drive(Fraction(-slow))}
    exact, moments, _ = run_twice(world, drives, duration)
    roundings = off(exact, world) / (64 * UNIT_ROUNDOFF["float64"])
    most = spread(moments, ON_A_LINE, UNIT_ROUNDOFF["float64"], Fraction(64), 1).off
    assert ROUNDINGS * len(moments) < 2000 < roundings < most / (64 * UNIT_ROUNDOFF["float64"])


def test_random_steps_in_floats_are_within_the_spread():
    compared = 0
    for seed in range(100):
        made, rng = outing(seed, 6, 3), random.Random(seed)
        if not made.places:
            continue
        world, parts = in_floats(made.world()), (1, Fraction(7, 9), Fraction(1, 50))
        speeds = {body: Fraction(float(one.speed * rng.choice(parts))) for body, one in made.drives_by_body.items()}
        drives = {body: replace(one, speed=speeds[body]) for body, one in made.drives_by_body.items()}
        duration = float(made.duration)
        exact, moments, nearly = run_twice(world, drives, duration)
        seats = [[(one.storey, one.support) for one in held.places] for held in (exact, world)]
        if seats[0] != seats[1] or marks(moments) != marks(nearly):
            continue
        ends, round_ = exact.terrain.ends, exact.terrain.circumference
        size = max(ends.right if ends else round_, 1)
        most = spread(moments, roundings_of(ends is None), UNIT_ROUNDOFF["float64"], size, len(speeds)).off
        assert off(exact, world) <= most, seed
        compared += 1
    assert compared > 60


def test_the_same_sum_is_rounded_alike_and_nothing_added_is_not_rounded():
    machine = Machine(Exact({"error 1": Fraction(3, 2), "error 2": Fraction(1, 2)}))
    one, two = Rounded(machine, Fraction(5)), Rounded(machine, Fraction(3))
    assert (one + two).held == Fraction(17, 2)
    assert (two + one) is (one + two)
    assert (one - two).held == Fraction(3, 2)
    assert one + two * 0 is one
    assert (one - one).nothing
    assert one * 1 is one
    assert (one * -2).held == -10
    assert machine.errors == 2
    with pytest.raises(TypeError, match="is rounded, in a way that is not known here"):
        one * two
    with pytest.raises(TypeError, match="is rounded, in a way that is not known here"):
        one / two


def random_row(rng, bodies, edges, number):
    """A row of bodies on edges of odd lengths, in contact here and there; its numbers are floats of a kind."""
    margin, place, held = Fraction(1, 100), Fraction(1), []
    for _ in range(bodies):
        width = Fraction(rng.randint(300, 900), 1000)
        held.append((place, place + width))
        place += width + margin + rng.choice((0, 0, Fraction(rng.randint(1, 999), 700)))
    length = place + 40
    lengths = [Fraction(float(number(length / edges))) for _ in range(edges)]

    def at(along):
        edge = min(int(along / lengths[0]), edges - 1)
        return EdgePosition(edge, along - lengths[0] * edge)

    placed = [Body(str(i), at(left), at(right), Fraction(0), margin) for i, (left, right) in enumerate(held)]
    level = Level(string_graph(lengths, None), margin, Fraction(1), tuple(placed))
    return with_numbers(level, lambda value: Fraction(float(number(value))), lambda slope: slope)


@pytest.mark.parametrize("numbers", FLOATS)
@pytest.mark.parametrize(("bodies", "edges"), [(3, 1), (30, 4), (300, 1), (1000, 7)])
@pytest.mark.parametrize("direction", Direction)
def test_long_rows_in_floats_are_within_the_tolerance(numbers, bodies, edges, direction):
    rng = random.Random(f"{numbers} {bodies} {edges} {direction}")
    number = FLOATS[numbers]
    level = random_row(rng, bodies, edges, number)
    mover = 0 if direction is RIGHT else bodies - 1
    distance = number(rng.randint(1000, 30000) / 1000)
    world = World(with_numbers(level, number, lambda slope: slope))
    move(THESIS, world, mover, direction, distance)
    asked = ((mover, direction, Fraction(float(distance))),)
    expected = expect(THESIS, World(level), asked)
    (record,) = expected.records
    assert record.depth > 1
    most = UNIT_ROUNDOFF[numbers] * largest(level) * ROUNDINGS * record.walks
    for one, two in zip(expected.world.bodies, world.bodies, strict=True):
        for a, b in ((one.left, two.left), (one.right, two.right)):
            along = expected.world.coordinate(EdgePosition(b.edge, Fraction(float(b.location))))
            assert abs(expected.world.coordinate(a) - along) <= most


def test_the_pages_say_how_many_roundings_there_are():
    formats, proofs = (" ".join((DOCS / name).read_text().split()) for name in ("formats.md", "proofs.md"))
    level = Level(string_graph([Fraction(100)], None), Fraction(1), Fraction(1), ())
    one, many = (float(tolerance("float64", level, walks=walks)) for walks in (2, 200))
    assert f"it makes {one:.0e} for one body on one edge, with its two borders, and {many:.0e} for a hundred" in formats
    within = f"{rounding.OF_A_SEGMENT} roundings on a line, {rounding.OF_A_SEGMENT_ON_A_RING} on a ring"
    assert f"`segment_is_nearly_exact`: each clause of `segment-exact` holds to within {within}" in proofs
    assert f"the margin less {rounding.OF_A_MARGIN} roundings; or" in proofs
    assert f"late by no more than what its bodies are off and {ON_A_LINE.room}, divided by the speed" in proofs
    assert f"nobody is off by more than before and {ON_A_LINE.stretch}." in proofs
    assert f"only the first holds of lateness, and the room is used up to within {ON_A_LINE.meeting}." in proofs


def test_an_unlucky_row_conforms_with_the_tolerance_of_its_walks_and_not_with_that_of_one():
    level, distance = floats.unlucky_row(60)
    world = World(with_numbers(level, float, float))
    move(THESIS, world, 0, RIGHT, float(distance))
    seen = World(with_numbers(replace(level, bodies=tuple(world.bodies)), Fraction, lambda slope: slope))
    asked = ((0, RIGHT, distance),)
    (record,) = expect(THESIS, World(level), asked).records
    enough = tolerance("float64", level, distance, walks=record.walks)
    assert judge(THESIS, World(level), asked, seen, enough).finding is Finding.AGREES
    assert judge(THESIS, World(level), asked, seen, tolerance("float64", level, distance)).finding is not Finding.AGREES


def row_that_ends_at_vertices(bodies):
    """An unlucky row in which each front border ends at a vertex, and the distance of the request."""
    level, distance = floats.unlucky_row(bodies)
    room = level.bodies[1].left.location - level.bodies[0].right.location - level.margin
    ends = [one.right.location + distance - room * place for place, one in enumerate(level.bodies)]
    lengths = [end - begin for begin, end in pairwise([Fraction(0), *ends, ends[-1] + 1])]
    return replace(level, graph=string_graph(lengths, None)), distance


def test_where_borders_end_at_vertices_floats_walk_much_more_often_and_no_more_than_is_counted():
    level, distance = row_that_ends_at_vertices(32)
    exact, in_float64 = World(level), World(with_numbers(level, float, float))
    most = most_walks(exact, (0, RIGHT, distance), 32)
    (_, one), (_, other) = (move(THESIS, world, 0, RIGHT, distance) for world in (exact, in_float64))
    assert one.walks * 4 < other.walks <= most


@pytest.mark.parametrize(("asked", "most"), [(1, 2), (2, 3), (2 - 2**-40, 3), (4, 4), (5 - 2**-40, 8), (6, 8)])
def test_what_a_request_nearly_reaches_is_counted(asked, most):
    """A stands 2 before a vertex, and has 5 free before B; A passes it with both borders, and asks B for each walk."""
    borders = ((Fraction(0), Fraction(1)), (Fraction(7), Fraction(8)))
    held = (Body("A", *(EdgePosition(0, at) for at in borders[0]), Fraction(0), Fraction(1)),)
    held += (Body("B", *(EdgePosition(1, at - 3) for at in borders[1]), Fraction(0), Fraction(1)),)
    level = Level(string_graph([Fraction(3), Fraction(20)], None), Fraction(1), Fraction(1), held)
    assert most_walks(World(level), (0, RIGHT, Fraction(asked)), 2) == most


TIED = 2.0**-46


def tied_row(rng):
    """A row on a line or round a ring, in float64: many are in contact, or nearly, and end at vertices, or nearly."""
    fine, margin = rng.choice((2**3, 2**20, 2**44)), rng.randint(1, 4) / 8
    distance, along, held, cuts = rng.randint(1, 8 * fine) / fine, 0.0, [], set()
    way = distance
    for _ in range(rng.randint(1, 8)):
        end = along + rng.randint(fine // 4, 2 * fine) / fine
        held.append((along, end))
        cuts |= {at + rng.choice((0, 0, TIED, -TIED)) for at in (along + way, end, end + way) if rng.random() < 0.4}
        room = rng.choice((0, 0, 0, rng.random(), TIED))
        along, way = end + margin + room, max(0, way - room)
    last = held[-1][1] + rng.choice((margin, 2, distance + 2))
    ends = sorted({Fraction(0), Fraction(last), *(Fraction(cut) for cut in cuts if 0 < cut < last)})
    lengths, closed = [end - begin for begin, end in pairwise(ends)], rng.random() < 0.3
    placed = [tuple(located(lengths, Fraction(at), closed) for at in borders) for borders in held]
    bodies = tuple(Body(str(i), *borders, Fraction(0), Fraction(1)) for i, borders in enumerate(placed))
    graph = string_graph(lengths, ends[-1] if closed else None)
    level = Level(graph, Fraction(margin), Fraction(1), bodies)
    return with_numbers(level, lambda value: Fraction(float(value)), lambda slope: slope), Fraction(distance)


def test_tied_rows_walk_no_more_often_in_floats_than_is_counted_and_are_within_ten_roundings_a_walk():
    for seed in range(300):
        rng = Random(seed)
        level, distance = tied_row(rng)
        request = (rng.randrange(len(level.bodies)), rng.choice(list(Direction)), distance)
        exact, in_float64 = World(level), World(with_numbers(level, float, float))
        most = most_walks(exact, request, len(level.bodies))
        records = [move(THESIS, world, *request)[1] for world in (exact, in_float64)]
        assert all(record.walks <= most for record in records), seed
        allowed = rounding_of("float64", level, distance) * 10 * most
        seen = World(with_numbers(replace(level, bodies=tuple(in_float64.bodies)), Fraction, lambda slope: slope))
        assert not [*displaced(exact.bodies, seen, allowed)], seed


def report_on(path, scenario):
    """What is found of the trace of a scenario that was played in floats."""
    path.write_text(json.dumps(scenario))
    playing = play(path, True)
    records = [header_of(playing, True), *lines_of(playing)]
    path.write_bytes(b"\n".join(msgspec.json.encode(record) for record in records) + b"\n")
    return validate(path)


def body(name, left, right, **more):
    """A body of a scenario, on edge 0 or on a top."""
    on = {"top": more.pop("top")} if "top" in more else {"edge": 0}
    return {"name": name, "left": {**on, "location": left}, "right": {**on, "location": right}, **more}


def an_unlucky_push():
    level, distance = floats.unlucky_row(60)
    borders = [(float(one.left.location), float(one.right.location)) for one in level.bodies]
    held = [body(str(i), left, right) for i, (left, right) in enumerate(borders)]
    vertices = [[0, 0], [float(level.graph.edges[0].length), 0]]
    return level.margin, vertices, held, "thesis", {"request": {"body": "0", "distance": float(distance)}}


def a_slow_leave():
    held = [body("C", 3.25, 4.5, speed=1), body("R", -1.1, 0.01, top="C")]
    step = {"drive": {"speeds": {"C": 14.7, "R": -0.01}, "time": 3}}
    return Fraction(1, 64), [[0, 0], [64, 0]], held, "repaired", step


def a_squeeze_by_a_rounding():
    """What B is carried by, and its own drive, are the opposite of C's drive in floats, and a last place less in exact
    numbers. So C wishes nothing, and is pushed by D; or it wishes to the left, and is squeezed.
    """
    held = [body("A", 10, 20, speed=1), body("B", 0.5, 9.5, top="A")]
    held += [body("C", 4 + 1 / 64, 5 + 1 / 64, top="B"), body("D", 3, 4, top="B")]
    step = {"drive": {"speeds": {"A": 0.1, "B": 0.3, "C": -0.4, "D": 0.5}, "time": 2}}
    return Fraction(1, 64), [[0, 0], [64, 0]], held, "repaired", step


def scenario_of(made):
    margin, vertices, held, profile, step = made
    level = {"format": "graphbody/level@1", "name": "l", "margin": str(margin), "vertices": vertices, "bodies": held}
    return {"format": "graphbody/scenario@1", "name": "s", "profile": profile, "level": level, "steps": [step]}


def test_a_wish_that_is_nothing_in_floats_only_may_squeeze_or_not(tmp_path):
    report = report_on(tmp_path / "s.json", scenario_of(a_squeeze_by_a_rounding()))
    assert report.found == {Finding.ONE_OF_SEVERAL: 1}


def two_ties_of_the_same_two_values():
    """Twice the same: P pushes Q, with R on top, off the end of F. Then R is just the margin from P, which does not
    hold it; in floats one R is a little nearer, and one is not.
    """
    held = []
    for name, left in (("1", 1.46875), ("2", 29.46875)):
        held += [body(f"F{name}", left, left + 3), body(f"P{name}", 0.5, 1.5, top=f"F{name}")]
        held += [body(f"Q{name}", 1.515625, 2.515625, top=f"F{name}"), body(f"R{name}", 0, 1, top=f"Q{name}")]
    step = {"drive": {"speeds": {"P1": 0.7, "P2": 0.7 * 0.7}, "time": 4}}
    return Fraction(1, 64), [[0, 0], [64, 0]], held, "repaired", step


def test_each_body_may_find_its_support_as_it_is_rounded(tmp_path):
    report = report_on(tmp_path / "s.json", scenario_of(two_ties_of_the_same_two_values()))
    assert report.found == {Finding.ONE_OF_SEVERAL: 1}


SPEEDS = (
    (0.1, 0.2, 0.3, 0.4, -0.4, -0.3, 0.7, 1.1),
    (1000.1, 0.1, 0.01, -0.01, 1, 3.3, -7.7),
    (1e-6, 1, -1e-6, 1000.1, 0.3, -1e-3),
)
"""For carriers and riders; slow ones on fast ones; tiny ones beside large ones."""


def awkward(seed):
    """A random level of storeys, in which drives are no floats but nearly."""
    rng = Random(seed)
    record = level_record(any_level(rng), "l")
    speeds, steps = rng.choice(SPEEDS), []
    for _ in range(3):
        driven = {held.name: rng.choice(speeds) for held in record.bodies if rng.random() < 0.6}
        fastest = max((abs(speed) for speed in driven.values()), default=1)
        times = rng.choice((0.3, 1.7, 5.1)) * rng.choice((1, 1 / max(1, fastest)))
        steps += [{"drive": {"speeds": driven, "time": times}}] if driven else []
    level = json.loads(msgspec.json.encode(record))
    return {"format": "graphbody/scenario@1", "name": "s", "profile": "repaired", "level": level, "steps": steps}


def test_random_logs_in_floats_conform_and_those_off_by_more_than_the_tolerance_do_not(tmp_path, monkeypatch):
    tolerances, judge_ = [], OfSteps.judge
    monkeypatch.setattr(OfSteps, "judge", lambda self, *step: tolerances.append(step[-1]) or judge_(self, *step))
    path, changed = tmp_path / "s.json", 0
    for seed in range(24):
        scenario = awkward(seed)
        if not scenario["steps"]:
            continue
        tolerances.clear()
        report = report_on(path, scenario)
        assert report.conforms, seed
        lines = path.read_bytes().splitlines()
        last = json.loads(lines[-1])
        for border in ("left", "right"):
            last["bodies"][0][border]["location"] += float(4 * max([*tolerances, Fraction(1, 2**40)]))
        path.write_bytes(b"\n".join([*lines[:-1], json.dumps(last).encode()]))
        wrong = validate(path)
        assert not wrong.conforms, seed
        changed += 1
    assert changed > 16


@pytest.mark.parametrize("made", [an_unlucky_push, a_slow_leave])
def test_what_the_reference_does_in_floats_conforms_where_a_fixed_tolerance_would_say_it_does_not(
    made, tmp_path, monkeypatch
):
    scenario = scenario_of(made())
    assert report_on(tmp_path / "s.json", scenario).conforms
    for referee in (OfRequests, OfSteps):
        monkeypatch.setattr(referee, "walks", lambda self, step: 1)
    monkeypatch.setattr(OfSteps, "within", lambda self, outcome, asked, tolerance: tolerance)
    assert not report_on(tmp_path / "s.json", scenario).conforms
