"""Counted work, exactly: no clock is read."""

from __future__ import annotations

from fractions import Fraction
from itertools import product
from typing import Any

from properties.evidence.deeds import MOST_RULES
from properties.worlds.rows import located, string_graph
from reference.play import library, play
from reference.simulator import move
from reference.world import World
from spec.body import Body, EdgePosition, Level
from spec.graph import Direction
from spec.profiles import PROFILES, Profile
from spec.registry import rules_of, velocity_rules_of

ONE, MARGIN = Fraction(1), Fraction(1, 8)


def line(lengths: list[Any], margin: Any, bodies: list[Body[Any]]) -> World[Any]:
    """A world of bodies on a line of edges."""
    return World(Level(string_graph(lengths, None), margin, margin, tuple(bodies)))


def row_in_contact(bodies: int, pushed: int) -> World[Fraction]:
    """On one long edge, a mover and `pushed` bodies in contact with it; far away, all the other bodies."""
    lefts = [i * (ONE + MARGIN) + (0 if i <= pushed else bodies) for i in range(bodies)]
    held = [Body(str(i), EdgePosition(0, left), EdgePosition(0, left + 1), ONE, ONE) for i, left in enumerate(lefts)]
    return line([Fraction(4 * bodies)], MARGIN, held)


def queries_of_a_push(profile: Profile) -> int:
    """Pushing k of n bodies on one edge costs k + 1 queries, for all k < n in a range."""
    cases = [(bodies, pushed) for bodies in (1, 2, 5, 20, 60, 200) for pushed in (0, 1, 3, 10, 50) if pushed < bodies]
    for bodies, pushed in cases:
        world = row_in_contact(bodies, pushed)
        move(profile, world, 0, Direction.RIGHT, MARGIN, MOST_RULES)
        assert world.work.queries == pushed + 1, f"{pushed} of {bodies} pushed: {world.work.queries} queries"
    return len(cases)


def queries_at_transitions(profile: Profile) -> int:
    """A body of which each border passes over t vertices looks t + 1 times, and makes 2 t transitions."""
    cases = list(product(range(8), (1, 3)))
    for passed, width in cases:
        lengths = [ONE] * (passed + width + 2)
        held = [Body("A", located(lengths, ONE / 4, False), located(lengths, width + ONE / 4, False), ONE, ONE)]
        world = line(lengths, MARGIN, held)
        _, record = move(profile, world, 0, Direction.RIGHT, Fraction(passed), MOST_RULES)
        assert world.work.queries == passed + 1, f"{passed} vertices passed: {world.work.queries} queries"
        assert record.transitions == 2 * passed, f"{passed} vertices passed: {record.transitions} transitions"
    return len(cases)


def full_ring(bodies: int) -> World[Fraction]:
    """A ring of edges with a body on each, all in contact."""
    lengths = [ONE + MARGIN] * bodies
    held = tuple(Body(str(i), EdgePosition(i, ONE * 0), EdgePosition(i, ONE), ONE, ONE) for i in range(bodies))
    return World(Level(string_graph(lengths, bodies * lengths[0]), MARGIN, MARGIN, held))


def long_strings(profile: Profile) -> int:
    """A body goes over a thousand edges; a push goes through a thousand bodies, and round a ring to each once."""
    many = 1000
    held = [Body("A", EdgePosition(0, ONE / 4), EdgePosition(2, ONE / 4), ONE, ONE)]
    world = line([ONE] * (many + 8), MARGIN, held)
    moved, _ = move(profile, world, 0, Direction.RIGHT, Fraction(many), MOST_RULES)
    borders = (world.bodies[0].left.edge, world.bodies[0].right.edge)
    assert (moved, borders) == (many, (many, many + 2)), f"moved {moved} to edges {borders}"
    pushed = row_in_contact(many, many)
    moved, record = move(profile, pushed, 0, Direction.RIGHT, ONE, MOST_RULES)
    assert (moved, record.depth) == (1, many), f"moved {moved} with a chain of {record.depth}"
    moved, record = move(profile, full_ring(5), 0, Direction.RIGHT, ONE, MOST_RULES)
    assert (moved, record.depth) == (0, 5), f"moved {moved} with a chain of {record.depth} on a ring of 5"
    return 3


def walls_are_reached(profile: Profile) -> int:
    """In floats too, a body that meets a wall stands exactly at the end of its edge, wherever it came from."""
    cases = [(places / 10, length / 10) for length in range(21, 80) for places in range(length - 20)]
    for left, length in cases:
        held = [Body("A", EdgePosition(0, left), EdgePosition(0, left + 1), 1.0, 1.0)]
        world = line([length], 0.125, held)
        move(profile, world, 0, Direction.RIGHT, 2 * length, MOST_RULES)
        assert world.bodies[0].right.location == length, f"from {left} on {length}: {world.bodies[0].right}"
    return len(cases)


def every_rule_fires(profile: Profile) -> int:
    """The scenarios of the library, played, fire every rule of every profile."""
    fired: set[str] = set()
    for path in library():
        playing = play(path)
        playing.game.most = MOST_RULES
        fired.update(rule for step in playing.steps for move in step.moves for _, rule in move.fired)
    missing = {rule.id for one in PROFILES.values() for rule in (*rules_of(one), *velocity_rules_of(one))} - fired
    assert not missing, f"no scenario fires {', '.join(sorted(missing))}"
    return len(library())
