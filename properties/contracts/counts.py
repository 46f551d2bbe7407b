"""Counted work, exactly: no clock is read."""

from __future__ import annotations

from fractions import Fraction
from itertools import product

from properties.worlds.rows import located, string_graph
from reference.play import library, play
from reference.row import Row
from reference.simulator import move
from spec.body import Body, EdgePosition
from spec.graph import Direction
from spec.profiles import Profile
from spec.registry import rules_of

ONE, MARGIN = Fraction(1), Fraction(1, 8)


def row_in_contact(bodies: int, pushed: int) -> Row[Fraction]:
    """On one long edge, a mover and `pushed` bodies in contact with it; far away, all the other bodies."""
    lefts = [i * (ONE + MARGIN) + (0 if i <= pushed else bodies) for i in range(bodies)]
    held = [Body(str(i), EdgePosition(0, left), EdgePosition(0, left + 1), ONE) for i, left in enumerate(lefts)]
    return Row(string_graph([Fraction(4 * bodies)], None), MARGIN, held, closed=False)


def queries_of_a_push(profile: Profile) -> int:
    """Pushing k of n bodies on one edge costs k + 1 queries, for all k < n in a range."""
    cases = [(bodies, pushed) for bodies in (1, 2, 5, 20, 60, 200) for pushed in (0, 1, 3, 10, 50) if pushed < bodies]
    for bodies, pushed in cases:
        row = row_in_contact(bodies, pushed)
        move(profile, row, 0, Direction.RIGHT, MARGIN)
        assert row.work.queries == pushed + 1, f"{pushed} of {bodies} pushed: {row.work.queries} queries"
    return len(cases)


def queries_at_transitions(profile: Profile) -> int:
    """A body that passes over t vertices looks t + 1 times, and looks up each edge after the first twice."""
    cases = list(product(range(8), (1, 3)))
    for passed, width in cases:
        lengths = [ONE] * (passed + width + 2)
        held = [Body("A", located(lengths, ONE / 4, False), located(lengths, width + ONE / 4, False), ONE)]
        row = Row(string_graph(lengths, None), MARGIN, held, closed=False)
        move(profile, row, 0, Direction.RIGHT, Fraction(passed))
        assert row.work.queries == passed + 1, f"{passed} vertices passed: {row.work.queries} queries"
    return len(cases)


def walls_are_reached(profile: Profile) -> int:
    """In floats too, a body that meets a wall stands exactly at the end of its edge, wherever it came from."""
    cases = [(places / 10, length / 10) for length in range(21, 80) for places in range(length - 20)]
    for left, length in cases:
        held = [Body("A", EdgePosition(0, left), EdgePosition(0, left + 1), 1.0)]
        row = Row(string_graph([length], None), 0.125, held, closed=False)
        move(profile, row, 0, Direction.RIGHT, 2 * length)
        assert row.bodies[0].right.location == length, f"from {left} on {length}: {row.bodies[0].right}"
    return len(cases)


def every_rule_fires(profile: Profile) -> int:
    """The scenarios of the library, played, fire every rule of the profile."""
    fired: set[str] = set()
    for path in library():
        _, _, played = play(path)
        fired.update(rule for step in played for event in step.events for _, rule in event.fired)
    missing = {rule.id for rule in rules_of(profile)} - fired
    assert not missing, f"no scenario fires {', '.join(sorted(missing))}"
    return len(library())
