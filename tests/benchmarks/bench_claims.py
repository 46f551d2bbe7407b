"""What `make bench` times, in seconds of the processor; each round begins without the formulas of the one before."""

from functools import partial

import pytest

from benchmarks import claim
from benchmarks.claim import Numbers, verdict
from benchmarks.other import MOST_SECONDS, crosshair
from properties.claims.catalogue import CLAIMS
from properties.contracts.request import judged
from properties.engine.explore import explore
from properties.engine.reals import compared

ROUNDS = 3
WAYS = {
    "paths": claim.by_paths,
    "merged": claim.by_merging,
    "contract": lambda bodies, characters, numbers: claim.by_contract(numbers),
    "simulator": lambda bodies, characters, numbers: claim.by_simulator(bodies),
}
GROWTH = [
    *(("paths", bodies, 1) for bodies in range(2, 7)),
    *(("paths", bodies, bodies) for bodies in range(2, 5)),
    *(("merged", bodies, 1) for bodies in range(2, 7)),
    *(("merged", bodies, bodies) for bodies in range(2, 7)),
    *(("contract", bodies, bodies) for bodies in range(2, 7)),
    *(("simulator", bodies, 1) for bodies in range(2, 6)),
]
SIZES = [(bodies, characters) for bodies in (2, 3, 4) for characters in (1, bodies)]


def run(benchmark, way, bodies, characters, numbers):
    program = partial(WAYS[way], bodies, characters, numbers)
    outcome = benchmark.pedantic(program, setup=compared.cache_clear, rounds=ROUNDS)
    benchmark.extra_info.update(way=way, bodies=bodies, characters=characters, lacking=numbers.lacking)
    benchmark.extra_info.update(verdict=verdict(outcome), paths=outcome.paths, checks=outcome.checks)
    return verdict(outcome)


@pytest.mark.parametrize(("way", "bodies", "characters"), GROWTH)
def test_growth(benchmark, way, bodies, characters):
    benchmark.group = "growth"
    assert run(benchmark, way, bodies, characters, Numbers()) == "proved"


@pytest.mark.parametrize("lacking", [0, 1])
@pytest.mark.parametrize(("bodies", "characters"), SIZES)
@pytest.mark.parametrize("way", ["paths", "merged", "contract"])
def test_beside(benchmark, way, bodies, characters, lacking):
    benchmark.group = "beside"
    numbers = Numbers(whole=True, lacking=lacking)
    assert run(benchmark, way, bodies, characters, numbers) == ("refuted" if lacking else "proved")


@pytest.mark.parametrize("lacking", [0, 1])
@pytest.mark.parametrize(("bodies", "characters"), SIZES)
def test_beside_crosshair(benchmark, bodies, characters, lacking):
    benchmark.group = "beside"
    concluded = benchmark.pedantic(crosshair, args=(bodies, characters, lacking, MOST_SECONDS))
    benchmark.extra_info.update(way="crosshair", bodies=bodies, characters=characters, lacking=lacking, **concluded)
    assert concluded["verdict"] != ("confirmed" if lacking else "refuted")


def test_obligations(benchmark):
    claims = [claim for claim in CLAIMS if not claim.long]
    each = {
        (claim.profile.name, o.id): partial(judged, o.program, claim.profile)
        for claim in claims
        for o in claim.obligations
    }
    benchmark.group = "obligations"
    outcomes = benchmark.pedantic(lambda: [explore(program) for program in each.values()], setup=compared.cache_clear)
    benchmark.extra_info.update(obligations=len(outcomes), proved=sum(outcome.proved for outcome in outcomes))
    benchmark.extra_info.update(paths=sum(o.paths for o in outcomes), checks=sum(o.checks for o in outcomes))
    assert all(outcome.proved for outcome in outcomes)
