"""All that a step may do where numbers are known nearly: one outcome, or several near a boundary of a guard.

A request of one body is run once for each way its ties can be broken. What a neighbour does when it is asked is found
first, in the same manner; so ties of different bodies are not multiplied, and outcomes that are as good as equal are
one. The exact outcome is always the first.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import islice, permutations, product
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


class Open(Exception):
    """A question that must be answered first."""

    def __init__(self, question: Question) -> None:
        super().__init__(question)
        self.question = question


@dataclass(frozen=True)
class Asking:
    """A family that breaks ties anew for every situation it is asked about."""

    family: Chooser

    def choose(self, facts: Any) -> AnyRule:
        """Return the rule that applies."""
        TIES.get().anew()
        return self.family.choose(facts)


@dataclass
class Ways:
    """The worlds that requests may lead to under a profile, by their numbers."""

    profile: Profile
    tolerance: Fraction
    worlds: list[World[Any]] = field(default_factory=list)
    known: dict[Question, list[Outcome]] = field(default_factory=dict)

    def begin(self, level: Level[Fraction]) -> list[int]:
        """The worlds of a level: one for each order of the bodies, where some of them are in the same place.

        Raises:
            TooManyWays: if there are too many.
        """
        with_ties(Ties(Fraction(0), Choices()))
        first = World(with_numbers(level, Near, Fraction))
        self.worlds.extend(islice(self.orders(first), MOST_OUTCOMES + 1))
        if len(self.worlds) > MOST_OUTCOMES:
            raise TooManyWays(f"more than {MOST_OUTCOMES} orders")
        return list(range(len(self.worlds)))

    def orders(self, world: World[Any]) -> Iterator[World[Any]]:
        """A world with the bodies of each string in every order that their places allow."""
        choices = [list(orders_in(world, row.order, self.tolerance)) for row in world.rows]
        for orders in product(*choices):
            other = world.copy()
            for row, order in zip(other.rows, orders, strict=True):
                row.order = list(order)
                other.settle(row)
            yield other

    def of(self, question: Question) -> list[Outcome]:
        """The outcomes of a request: first that of its neighbours, if they are asked."""
        waiting = [question]
        while waiting:
            try:
                self.known[waiting[-1]] = self.outcomes(waiting[-1])
                waiting.pop()
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
        rules, view = self.profile.rules.through(Asking), world.facing(question.direction)
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
        """What is known of a neighbour's request."""
        if question not in self.known:
            raise Open(question)
        return self.known[question]

    def alike(self, world: World[Any], other: World[Any], difference: Fraction) -> bool:
        """Whether two worlds are as good as equal, and so is what led to them but for a difference in distance."""
        return abs(difference) <= self.tolerance and all(
            one is two or (near(one.left, two.left, self.tolerance) and near(one.right, two.right, self.tolerance))
            for one, two in zip(world.bodies, other.bodies, strict=True)
        )

    def one_after_another(
        self, level: Level[Fraction], asked: Sequence[tuple[int, Direction, Fraction]]
    ) -> list[World[Any]]:
        """The worlds that requests may lead to, one made after another.

        Raises:
            TooManyWays: if there are too many.
        """
        spare = self.profile.push_limit(len(level.bodies)) - 1
        reached = self.begin(level)
        for body, direction, distance in asked:
            before, reached = reached, []
            for world in before:
                self.add(self.of(Question(world, direction, body, distance, spare)), reached)
        return [self.worlds[number] for number in reached]

    def add(self, outcomes: Sequence[Outcome], reached: list[int]) -> None:
        """Add the worlds of outcomes to those reached, without those that are as good as one of them.

        Raises:
            TooManyWays: if they become too many.
        """
        for number in (outcome.world for outcome in outcomes):
            if not any(self.alike(self.worlds[number], self.worlds[other], Fraction(0)) for other in reached):
                reached.append(number)
        if len(reached) > MOST_OUTCOMES:
            raise TooManyWays(f"more than {MOST_OUTCOMES} outcomes")


def with_ties(ties: Ties) -> None:
    """Let ties be broken so from now on."""
    TIES.set(ties)


def orders_in(world: World[Any], order: list[int], tolerance: Fraction) -> Iterator[tuple[int, ...]]:
    """The orders of bodies on a string in which those with their left borders in the same place may change places."""
    along = {body: world.coordinate(world.bodies[body].left).value for body in order}
    groups: list[list[int]] = []
    for body in order:
        if groups and abs(along[groups[-1][-1]] - along[body]) <= tolerance:
            groups[-1].append(body)
        else:
            groups.append([body])
    for parts in product(*(permutations(group) for group in groups)):
        yield tuple(body for part in parts for body in part)


def near(one: EdgePosition[Near], two: EdgePosition[Near], tolerance: Fraction) -> bool:
    """Whether two positions on one edge are as good as equal."""
    return one.edge == two.edge and abs(one.location.value - two.location.value) <= tolerance
