"""Monitors: the contracts, evaluated on what the simulator does, call by call.

A request is run by the rules as they are, each call of them watched: every request of the chain, every segment, every
walk of a rear border, every departure. What a body can do is computed on the world of that moment, by the recursion of
`Ahead.capacity` along the row: so each evaluation of an exact contract is also one of the lemma, on a whole row.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Generator
from dataclasses import dataclass, field, replace
from typing import Any

from properties.contracts.contract import (
    LEAVING,
    REAR,
    REQUEST,
    REQUEST_EXACT,
    SEGMENT,
    SEGMENT_EXACT,
    Ahead,
    Call,
    Contract,
    Parting,
    Stretch,
)
from properties.evidence.deeds import MOST_RULES
from reference.simulator import Record, fulfil, heard
from reference.world import Facing, World
from spec.body import EdgePosition
from spec.graph import Direction
from spec.profiles import Profile
from spec.rule import AnyRule, Chooser
from spec.rules.leave import Departure, Placement
from spec.rules.request import Ask, Rules, request
from spec.rules.walk import Motion, Step, Tow

ON_ANY_LEVEL = (REQUEST, SEGMENT, REAR, LEAVING)
ON_ONE_STRING = (*ON_ANY_LEVEL, REQUEST_EXACT, SEGMENT_EXACT)

Asking = Generator[Ask[Any, int], Any, Any]


@dataclass
class Verdicts:
    """What monitors found: how often each contract was evaluated, and which clauses did not hold.

    `unmet` are requirements that a call did not meet; its contract says nothing then, and is not evaluated.
    """

    evaluations: Counter[str] = field(default_factory=Counter)
    broken: list[str] = field(default_factory=list)
    unmet: list[str] = field(default_factory=list)

    def judge(self, contract: Contract, facts: Any) -> None:
        """Evaluate a contract on a call that meets its requirements."""
        unmet = [contract.name(clause) for clause in contract.requires if not clause.holds(facts)]
        self.unmet += unmet
        if not unmet:
            self.evaluations[contract.id] += 1
            self.broken += [contract.name(clause) for clause in contract.promises if not clause.holds(facts)]


@dataclass(frozen=True)
class Watched:
    """A family, each of whose decisions is shown to a watch: the facts, and what came of them."""

    family: Chooser
    watch: Callable[[Any, Any], None]
    prepare: Callable[[Any], Any] = lambda facts: facts

    def choose(self, facts: Any) -> AnyRule:
        """Return the rule that applies, watched."""
        rule = self.family.choose(facts)

        def effect(known: Any) -> Any:
            result = rule.effect(self.prepare(known))
            self.watch(known, result)
            return result

        return replace(rule, effect=effect)


def unwatched(facts: Any, result: Any) -> None:
    """Watch nothing."""


def listening(running: Asking, asks: list[Any]) -> Asking:
    """A program of the rules, the spare asks of each request that it makes noted."""
    answer = None
    while True:
        try:
            ask = running.send(answer)
        except StopIteration as end:
            return end.value
        asks.append(ask.spare)
        answer = yield ask


@dataclass(frozen=True)
class Monitor:
    """One request in a world, watched, and judged by some contracts."""

    profile: Profile
    world: World[Any]
    direction: Direction
    tolerance: Any
    contracts: tuple[Contract, ...]
    verdicts: Verdicts

    @property
    def view(self) -> Facing[Any]:
        """The world in the direction of the request."""
        return self.world.facing(self.direction)

    def judge(self, contract: Contract, facts: Any) -> None:
        """Judge a call by a contract, if it is one of those that are to be judged."""
        if contract in self.contracts:
            self.verdicts.judge(contract, facts)

    def run(self, body: int, distance: Any) -> Any:
        """Make the request; return the distance moved."""
        record = Record(body, MOST_RULES)
        own = heard(self.profile.rules, record)
        rules = replace(
            own,
            segment=self.segment,
            follow=Watched(own.follow, unwatched, self.watched_tow),
            leave=Watched(own.leave, self.parted),
        )
        start = Ask(body, distance, self.profile.push_limit(len(self.world.bodies)) - 1)
        return fulfil(start, lambda ask: self.request(rules, ask, first=ask is start), record)

    def request(self, rules: Rules, ask: Ask[Any, int], first: bool) -> Asking:
        """A request, judged in the end.

        On a ring the room of whoever stands behind the mover grows when the mover is placed: what the mover could do
        after that is not judged.
        """
        body, asks = ask.body, list[Any]()
        before, string = self.world.bodies[body], self.string(body)
        front = before.border(self.direction)
        ahead, other = self.ahead(body, front, ask.spare), self.world.beside(body, self.direction)
        moved = yield from listening(request(rules, self.view, body, ask.distance, ask.spare), asks)
        call = Call(asked=ask.distance, moved=moved, spare=ask.spare, asks=tuple(asks), tolerance=self.tolerance)
        if self.string(body) is string:
            now, round_ = self.world.bodies[body], first and self.world.row(body).closed
            later = self.ahead(body, now.border(self.direction), ask.spare)
            call = replace(
                call,
                **self.facts_ahead(ahead, front, other),
                borders=tuple(self.gone(before.border(side), now.border(side)) for side in Direction),
                capacity=ahead.capacity(),
                left=None if round_ else later.capacity(),
            )
        for contract in (REQUEST, REQUEST_EXACT):
            self.judge(contract, call)
        return moved

    def segment(self, rules: Rules, view: Facing[Any], body: int, motion: Motion[Any, Any], spare: int) -> Asking:
        """A segment, judged in the end."""
        asks = list[Any]()
        ahead, other = self.ahead(body, motion.at, spare), self.world.beside(body, self.direction)
        after = yield from listening(self.profile.rules.segment(rules, view, body, motion, spare), asks)
        stretch = replace(
            self.stretch(motion, after),
            **self.facts_ahead(ahead, motion.at, other),
            capacity=ahead.capacity(),
            left=self.ahead(body, after.at, spare).capacity(),
            spare=spare,
            asks=tuple(asks),
        )
        for contract in (SEGMENT, SEGMENT_EXACT):
            self.judge(contract, stretch)
        return after

    def watched_tow(self, tow: Tow[Any, Any]) -> Tow[Any, Any]:
        """The same tow, each walk of the rear border judged."""
        return replace(tow, walk=Watched(tow.walk, self.walked))

    def walked(self, step: Step[Any, Any], after: Motion[Any, Any]) -> None:
        """Judge a walk of a rear border."""
        zero = step.motion.rest * 0
        ahead = Ahead(self.world.margin, None, self.wall(step.motion.at), None, zero, pushes=False)
        self.judge(REAR, replace(self.stretch(step.motion, after), ahead=ahead))

    def parted(self, leaving: Departure[Any, Any], placed: Placement[Any, Any]) -> None:
        """Judge a departure."""
        self.judge(LEAVING, Parting(leaving, placed, self.tolerance))

    def stretch(self, before: Motion[Any, Any], after: Motion[Any, Any]) -> Stretch:
        """The facts of one segment or walk but what lies ahead."""
        view, reach = self.view, self.view.reach(before.at)
        behind = self.world.length_of(after.at.edge) - view.reach(after.at)
        walled = not view.beyond(before.at).ledge and reach >= reach * 0
        return Stretch(
            asked=before.rest,
            moved=before.rest - after.rest,
            borders=(self.gone(before.at, after.at),),
            going=after.going,
            length=self.world.length_of(before.at.edge),
            reach=reach,
            slack=(behind, view.reach(after.at)) if walled else (behind,),
            to_go=after.rest + behind,
            tolerance=self.tolerance,
        )

    def facts_ahead(self, before: Ahead, at: EdgePosition[Any], other: int | None) -> dict[str, Any]:
        """What lay ahead of a place, and how far the body there has been moved; nothing if it has left the string."""
        if other is None or before.gap is None:
            return {"ahead": before, "pushed": before.margin * 0}
        gap = self.gap(at, other)
        return {} if gap is None else {"ahead": before, "pushed": gap - before.gap}

    def ahead(self, body: int, at: EdgePosition[Any], spare: int) -> Ahead:
        """What lies ahead of a body whose front border is at a place: the recursion of its capacity."""
        other, neighbour = self.world.beside(body, self.direction), None
        if other is not None and spare > 0:
            neighbour = self.ahead(other, self.view.front(other), spare - 1).capacity()
        edges = tuple(self.world.edge_lengths())
        pushes = self.world.bodies[body].pushes
        return Ahead(self.world.margin, self.gap(at, other), self.wall(at), neighbour, spare, pushes, edges)

    def gap(self, at: EdgePosition[Any], other: int | None) -> Any | None:
        """The gap from a place to a body ahead, if there is one on the same string."""
        if other is None or self.string(other) is not self.world.row_of_edge[at.edge].edges:
            return None
        return self.view.gap(at, other)

    def string(self, body: int) -> list[int]:
        """The string of edges that a body is on."""
        return self.world.row(body).edges

    def wall(self, at: EdgePosition[Any]) -> Any | None:
        """The distance from a place to the wall in which its string ends, if it does."""
        row, right = self.world.row_of_edge[at.edge], self.direction is Direction.RIGHT
        last = self.view.tip(row.edges[-1 if right else 0], self.direction)
        if row.closed or self.view.beyond(last).ledge:
            return None
        return row.length - self.world.coordinate(at) if right else self.world.coordinate(at)

    def gone(self, start: EdgePosition[Any], end: EdgePosition[Any]) -> Any:
        """How far it is from one place to another ahead on the same string; less than once round a ring."""
        row = self.world.row_of_edge[start.edge]
        distance = (self.world.coordinate(end) - self.world.coordinate(start)) * self.direction
        return distance + row.length if row.closed and distance < distance * 0 - self.tolerance else distance
