"""All that a step may do where numbers are known nearly: one outcome, or several near a boundary of a guard.

A request of one body is run once for each way its ties can be broken. What a neighbour does when it is asked is found
first, in the same manner; so ties of different bodies are not multiplied, and outcomes that are as good as equal are
one. The exact outcome is always the first.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import partial
from itertools import permutations, product
from math import factorial, prod
from typing import Any

from properties.engine.ties import TIES, Choices, Near, Ties, TooManyWays, every_way, value_of
from reference.world import World
from spec.body import EdgePosition, Level
from spec.graph import Direction
from spec.profiles import Profile
from spec.rule import AnyRule, Chooser, GuardError
from spec.rules.request import Ask, request
from spec.transform import with_numbers

MOST_WAYS = 500
MOST_OUTCOMES = 64
MOST_DECISIONS = 50_000


@dataclass(frozen=True)
class Outcome:
    """A world after a request, by its number, and how far the body moved."""

    world: int
    moved: Fraction


@dataclass(frozen=True)
class Question:
    """A request that is to be answered: in which world, by its number, and of whom."""

    world: int
    direction: Direction
    body: int
    distance: Fraction
    spare: int

    @property
    def but_distance(self) -> Question:
        """The same for no distance."""
        return replace(self, distance=Fraction(0))


class Open(Exception):
    """A question that must be answered first."""

    def __init__(self, question: Question) -> None:
        super().__init__(question)
        self.question = question


@dataclass(frozen=True)
class Asking:
    """A family that breaks ties anew for every situation it is asked about, so often as a step may."""

    family: Chooser
    ways: Ways

    def choose(self, facts: Any) -> AnyRule:
        """Return the rule that applies."""
        TIES.get().anew()
        self.ways.spend()
        return self.family.choose(facts)


@dataclass
class Ways:
    """The worlds that requests may lead to under a profile, by their numbers."""

    profile: Profile
    tolerance: Fraction
    worlds: list[World[Any]] = field(default_factory=list)
    known: dict[Question, list[Outcome]] = field(default_factory=dict)
    asked: dict[Question, list[Question]] = field(default_factory=dict)
    decisions: int = 0

    def spend(self) -> None:
        """Count a decision.

        Raises:
            TooManyWays: if there have been too many.
        """
        self.decisions += 1
        if self.decisions > MOST_DECISIONS:
            raise TooManyWays(f"more than {MOST_DECISIONS} decisions")

    def begin(self, level: Level[Fraction]) -> list[int]:
        """The worlds of a level: one for each order of the bodies, where some of them are in the same place.

        Raises:
            TooManyWays: if there are too many.
        """
        with_ties(Ties(Fraction(0), Choices()))
        first = World(with_numbers(level, Near, Fraction))
        groups = [list(together(first, row.order, self.tolerance)) for row in first.rows]
        if prod(factorial(len(group)) for some in groups for group in some) > MOST_OUTCOMES:
            raise TooManyWays(f"more than {MOST_OUTCOMES} orders")
        for orders in product(*(list(orders_of(some)) for some in groups)):
            world = first.copy()
            for row, order in zip(first.rows, orders, strict=True):
                if order != row.order:
                    world.reorder(row, order)
            self.worlds.append(world)
        return list(range(len(self.worlds)))

    def of(self, question: Question) -> list[Outcome]:
        """The outcomes of a request: first that of its neighbours, if they are asked."""
        waiting = [question]
        while waiting:
            try:
                self.known[waiting[-1]] = self.outcomes(waiting[-1])
                done = waiting.pop()
                self.asked.setdefault(done.but_distance, []).append(done)
            except Open as first:
                waiting.append(first.question)
        return self.known[question]

    def outcomes(self, question: Question) -> list[Outcome]:
        """The outcomes of a request whose neighbours' are known.

        Raises:
            Open: if one of them is not.
            TooManyWays: if there are too many.
        """
        found: list[Outcome] = []
        for way in every_way(lambda choices: self.run(question, choices), MOST_WAYS):
            if way is None:
                continue
            world, moved = way
            if not any(self.alike(world, self.worlds[one.world], moved - one.moved) for one in found):
                self.worlds.append(world)
                found.append(Outcome(len(self.worlds) - 1, moved))
        return found

    def run(self, question: Question, choices: Choices) -> tuple[World[Any], Fraction] | None:
        """Run a request with ties broken in one way; its neighbours do what is known of them.

        None if ties are broken so that they contradict each other: then not exactly one rule applies.
        """
        with_ties(Ties(self.tolerance, choices))
        at, world = question.world, self.worlds[question.world].copy()
        rules, view = self.profile.rules.through(partial(Asking, ways=self)), world.facing(question.direction)
        running = request(rules, view, question.body, Near(question.distance), question.spare)
        answer: Any = None
        while True:
            try:
                ask: Ask[Any, int] = running.send(answer)
            except StopIteration as end:
                return world, end.value.value
            except GuardError:
                return None
            outcomes = self.answers(Question(at, question.direction, ask.body, value_of(ask.distance), ask.spare))
            outcome = outcomes[choices.choose(len(outcomes))]
            at, answer = outcome.world, Near(outcome.moved)
            world.become(self.worlds[at])

    def answers(self, question: Question) -> list[Outcome]:
        """What is known of a neighbour's request, or of one that is as good as the same.

        Raises:
            Open: if nothing is.
        """
        for other in self.asked.get(question.but_distance, ()):
            if abs(other.distance - question.distance) <= self.tolerance:
                return self.known[other]
        raise Open(question)

    def alike(self, world: World[Any], other: World[Any], difference: Fraction) -> bool:
        """Whether two worlds are as good as equal, and so is what led to them but for a difference in distance."""
        return abs(difference) <= self.tolerance and all(
            one is two or (near(one.left, two.left, self.tolerance) and near(one.right, two.right, self.tolerance))
            for one, two in zip(world.bodies, other.bodies, strict=True)
        )

    def one_after_another(
        self, level: Level[Fraction], asked: Sequence[tuple[int, Direction, Fraction]]
    ) -> list[tuple[World[Any], tuple[Fraction, ...]]]:
        """The worlds that requests may lead to, one made after another, and how far each request then moved its body.

        Raises:
            TooManyWays: if there are too many.
        """
        spare = self.profile.push_limit(len(level.bodies)) - 1
        reached: list[tuple[int, tuple[Fraction, ...]]] = [(world, ()) for world in self.begin(level)]
        for body, direction, distance in asked:
            before, reached = reached, []
            for world, moved in before:
                self.add(self.of(Question(world, direction, body, distance, spare)), moved, direction, reached)
        return [(self.worlds[number], moved) for number, moved in reached]

    def add(
        self,
        outcomes: Sequence[Outcome],
        moved: tuple[Fraction, ...],
        direction: Direction,
        reached: list[tuple[int, tuple[Fraction, ...]]],
    ) -> None:
        """Add the worlds of outcomes to those reached, without those that are as good as one of them.

        Raises:
            TooManyWays: if they become too many.
        """
        for outcome in outcomes:
            world = self.worlds[outcome.world]
            if not any(self.alike(world, self.worlds[other], Fraction(0)) for other, _ in reached):
                reached.append((outcome.world, (*moved, outcome.moved * direction)))
        if len(reached) > MOST_OUTCOMES:
            raise TooManyWays(f"more than {MOST_OUTCOMES} outcomes")


def with_ties(ties: Ties) -> None:
    """Let ties be broken so from now on."""
    TIES.set(ties)


def together(world: World[Any], order: list[int], tolerance: Fraction) -> Iterator[list[int]]:
    """The bodies of a string, in groups whose left borders are in the same place."""
    along = {body: world.coordinate(world.bodies[body].left).value for body in order}
    group: list[int] = []
    for body in order:
        if group and along[body] - along[group[-1]] > tolerance:
            yield group
            group = []
        group.append(body)
    if group:
        yield group


def orders_of(groups: list[list[int]]) -> Iterator[list[int]]:
    """The orders of bodies on a string in which those of a group may change places."""
    for parts in product(*(permutations(group) for group in groups)):
        yield [body for part in parts for body in part]


def near(one: EdgePosition[Near], two: EdgePosition[Near], tolerance: Fraction) -> bool:
    """Whether two positions on one edge are as good as equal."""
    return one.edge == two.edge and abs(one.location.value - two.location.value) <= tolerance
