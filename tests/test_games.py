"""Whole games on random levels with ledges: what holds after every request, whatever came before."""

from collections import Counter
from fractions import Fraction

import pytest
from hypothesis import HealthCheck, settings, strategies as st
from hypothesis.stateful import (
    RuleBasedStateMachine,
    initialize,
    invariant,
    precondition,
    rule,
    run_state_machine_as_test,
)

from properties.evidence.monitor import ON_ANY_LEVEL, Monitor, Verdicts
from properties.strategies.rows import multiples
from properties.strategies.scenes import levels_with_ledges
from reference.simulator import Game
from spec.graph import Direction
from spec.invariants import Deed
from spec.plane import heights, supports_end
from spec.profiles import OVERSHOOT, THESIS
from spec.transform import in_floats

FLOORS = {
    "falls": 0.01,
    "jumps": 0.005,
    "is blocked at a ledge": 0.01,
    "rides": 0.05,
    "pushes": 0.03,
    "meets a wall": 0.05,
}
SEEN: Counter[str] = Counter()
EVALUATIONS: Counter[str] = Counter()
DISTANCES = st.one_of(st.sampled_from([Fraction(n) for n in (1, 2, 3, 5)]), multiples(8, 1), multiples(8, 12))


class AnyGame(RuleBasedStateMachine):
    """A game under one profile, played in exact numbers and, beside it, in floats on a dyadic grid."""

    profile = THESIS

    @initialize(level=levels_with_ledges())
    def start(self, level):
        self.level = level
        self.game, self.binary = Game(self.profile, level), Game(self.profile, in_floats(level))
        self.widths = [self.game.world.width(body) for body in self.game.world.handles()]

    @precondition(lambda self: hasattr(self, "level"))
    @rule(data=st.data(), distance=DISTANCES, sign=st.sampled_from((-1, 1)))
    def request(self, data, distance, sign):
        name = data.draw(st.sampled_from([body.name for body in self.level.bodies]))
        before = self.game.world.copy()
        self.watch(name, distance, Direction(sign))
        event = self.game.request(name, distance * sign)
        binary = self.binary.request(name, float(distance * sign))
        self.count(event, before)
        assert event.fired == binary.fired, "floats on a dyadic grid take the same rules"
        assert event.moved == binary.moved, "and move as far"
        assert 0 <= event.moved * sign <= distance, "at most what was asked, in its direction"
        for body in before.handles():
            assert heights(self.game.world, body) <= heights(before, body), "nobody is raised"

    @precondition(lambda self: hasattr(self, "level"))
    @rule(direction=st.sampled_from(Direction))
    def tick(self, direction):
        before = self.game.world.copy()
        for event in self.game.tick(direction):
            self.count(event, before)
        self.binary.tick(direction)

    def watch(self, name, distance, direction):
        """Run the same request on a copy of the game's world, each call of the rules judged by its contract."""
        verdicts = Verdicts()
        world = self.game.world.copy()
        Monitor(self.profile, world, direction, Fraction(0), ON_ANY_LEVEL, verdicts).run(
            self.game.handles[name], distance
        )
        assert verdicts.broken == []
        EVALUATIONS.update(verdicts.evaluations)

    def count(self, event, before):
        fired = {rule for _, rule in event.fired}
        SEEN["requests"] += 1
        SEEN["falls"] += "leave/fall" in fired
        SEEN["jumps"] += "leave/jump" in fired
        SEEN["is blocked at a ledge"] += bool({"leave/blocked", "leave/nowhere"} & fired)
        SEEN["pushes"] += "push/request" in fired
        SEEN["meets a wall"] += "walk/wall" in fired
        SEEN["rides"] += any(before.support(body) is not None for body in before.handles())

    @precondition(lambda self: hasattr(self, "level"))
    @invariant()
    def everybody_keeps_its_width_and_stands_on_the_ground_in_the_end(self):
        world = self.game.world
        assert [world.width(body) for body in world.handles()] == self.widths
        assert supports_end(deed_of(world))
        assert [body.left.location for body in world.bodies] == [b.left.location for b in self.binary.world.bodies]

    @precondition(lambda self: hasattr(self, "level"))
    @invariant()
    def a_body_with_both_borders_beyond_its_edge_has_left_it(self):
        world = self.game.world
        for direction in Direction:
            view = world.facing(direction)
            assert all(view.reach(view.rear(body)) >= 0 for body in world.handles())


def deed_of(world):
    """A deed in which nothing happened."""
    zero = Fraction(0)
    return Deed(world, world, 0, Direction.RIGHT, zero, zero, 1, 1, 0, zero)


class AnyGameOvershoot(AnyGame):
    profile = OVERSHOOT


@pytest.mark.parametrize("machine", [AnyGame, AnyGameOvershoot])
def test_any_game(machine):
    SEEN.clear()
    EVALUATIONS.clear()
    run_state_machine_as_test(
        machine,
        settings=settings(
            max_examples=100,
            stateful_step_count=15,
            deadline=None,
            derandomize=True,
            database=None,
            suppress_health_check=list(HealthCheck),
        ),
    )
    shares = {name: SEEN[name] / SEEN["requests"] for name in FLOORS}
    print(f"{SEEN['requests']} requests: {shares}")
    assert {name for name, floor in FLOORS.items() if shares[name] < floor} == set()
    print(f"evaluations of contracts: {dict(EVALUATIONS)}")
    assert {contract.id for contract in ON_ANY_LEVEL if EVALUATIONS[contract.id] < 500} == set()
