"""What `make bench` times of steps: those of the rules beside those of Box2D, in seconds of the processor."""

import json

import pytest

from benchmarks.logs import log_of
from benchmarks.rigid import TIMES_ITERATED, in_box2d, pushing_in_box2d
from benchmarks.steps import IN_BATCH, SPEED, TICK, Pushed, at_once, by_events, of_random_levels
from properties.conformance.validate import validate

ROUNDS = 5
WAYS = {
    "exact": lambda scene: by_events(scene, floats=False),
    "float": lambda scene: by_events(scene, floats=True),
    "one level": lambda scene: at_once(scene, 1),
    "batch": lambda scene: at_once(scene, IN_BATCH),
    "Box2D": in_box2d,
}
WAYS_TO_PUSH = {
    **WAYS,
    "one level anew": lambda scene: at_once(scene, 1, anew=True),
    "batch anew": lambda scene: at_once(scene, IN_BATCH, anew=True),
    "Box2D iterating": lambda scene: in_box2d(scene, TIMES_ITERATED),
    "Box2D pushing": pushing_in_box2d,
}
SCENES = [*(("row", bodies) for bodies in (1, 10, 100, 1000)), *(("stack", bodies) for bodies in (1, 10, 100))]
STANDING_BY = (0, 100, 1_000, 10_000)
LEVELS = 500
TIMES = 16
READ = {
    "validate": validate,
    "json": lambda path: [json.loads(line) for line in path.read_text().splitlines()],
}


def run(benchmark, prepared, **about):
    prepared.program()
    benchmark.pedantic(prepared.program, rounds=ROUNDS)
    benchmark.extra_info.update(about, steps=prepared.steps, **prepared.counted())
    return prepared.come()


@pytest.mark.parametrize("way", WAYS_TO_PUSH)
@pytest.mark.parametrize(("kind", "bodies"), SCENES)
def test_steps(benchmark, way, kind, bodies):
    benchmark.group = "steps"
    prepared = WAYS_TO_PUSH[way](Pushed(kind, bodies))
    driven = float(SPEED * TICK) * prepared.ticks * (ROUNDS + 1)
    come = run(benchmark, prepared, way=way, kind=kind, bodies=bodies)
    benchmark.extra_info["come"] = come / driven
    assert way.startswith("Box2D") or come == pytest.approx(driven)


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("standing_by", STANDING_BY)
def test_standing_by(benchmark, way, standing_by):
    benchmark.group = "standing by"
    run(benchmark, WAYS[way](Pushed("row", 10, standing_by)), way=way, standing_by=standing_by)


def test_random_levels(benchmark):
    benchmark.group = "random levels"
    run(benchmark, of_random_levels(LEVELS))


@pytest.mark.parametrize("way", READ)
@pytest.mark.parametrize("bare", [False, True])
def test_logs(benchmark, way, bare, tmp_path):
    benchmark.group = "logs"
    path, lines = log_of(tmp_path, TIMES, bare)
    READ[way](path)
    benchmark.pedantic(READ[way], args=(path,), rounds=ROUNDS)
    benchmark.extra_info.update(way=way, bare=bare, steps=lines)
