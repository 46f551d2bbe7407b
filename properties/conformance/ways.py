"""All that a step may do where numbers are known nearly: one outcome, or several near a boundary of a guard.

A request of one body is run once for each way its ties can be broken. What a neighbour does when it is asked is found
first, in the same manner; so ties of different bodies are not multiplied, and outcomes that are as good as equal are
one. The exact outcome is always the first.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from properties.engine.ties import TIES, Choices, Near, Ties, TooManyWays, every_way, value_of
from reference.world import World
from spec.body import EdgePosition, Level
from spec.graph import Direction
from spec.profiles import Profile
from spec.rule import AnyRule, Chooser
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
    """The worlds that requests may lead to under a profile; world 0 is the level's."""

    profile: Profile
    tolerance: Fraction
    worlds: list[World[Any]] = field(default_factory=list)
    known: dict[Question, list[Outcome]] = field(default_factory=dict)

    def begin(self, level: Level[Fraction]) -> int:
        """The number of the world of a level, as if its numbers were known nearly."""
        with_ties(Ties(Fraction(0), Choices()))
        self.worlds.append(World(with_numbers(level, Near, Fraction)))
        return len(self.worlds) - 1

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
        for world, moved in every_way(lambda choices: self.run(question, choices), MOST_WAYS):
            if not any(self.alike(world, self.worlds[one.world], moved - one.moved) for one in found):
                self.worlds.append(world)
                found.append(Outcome(len(self.worlds) - 1, moved))
        return found

    def run(self, question: Question, choices: Choices) -> tuple[World[Any], Fraction]:
        """Run a request with ties broken in one way; its neighbours do what is known of them."""
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

    def one_after_another(self, start: int, asked: Sequence[tuple[int, Direction, Fraction]]) -> list[World[Any]]:
        """The worlds that requests may lead to, one made after another."""
        spare = self.profile.push_limit(len(self.worlds[start].bodies)) - 1
        reached = [start]
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


def near(one: EdgePosition[Near], two: EdgePosition[Near], tolerance: Fraction) -> bool:
    """Whether two positions on one edge are as good as equal."""
    return one.edge == two.edge and abs(one.location.value - two.location.value) <= tolerance
