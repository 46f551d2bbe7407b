"""A witness of the map, played again in exact numbers: what it breaks, by which rule, what it has run into."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

import msgspec

from properties.evidence.deeds import do
from properties.evidence.mended import replayed_from
from reference.formats.level import LevelRecord, valid_level
from reference.formats.numbers import exact
from reference.formats.scenario import ScenarioRecord, StepRecord
from reference.simulator import Record
from reference.world import LevelError, World, world_of
from spec.body import Level
from spec.case import Case, Part, parts_of, ran_into
from spec.graph import Direction
from spec.guidelines import kept_by
from spec.invariants import Deed
from spec.plane import HORIZONTAL, IN_PLANE
from spec.profiles import OF_REQUESTS
from spec.unsupported import CASES

ZERO = Fraction(0)
AT_FAULT = ("leave/fall", "leave/jump", "leave/blocked", "leave/nowhere")


@dataclass(frozen=True)
class Done:
    """One request of a witness: what came of it, and the rules that fired, body by body."""

    deed: Deed[Fraction]
    record: Record

    @property
    def parts(self) -> list[Part]:
        """The request as each of its bodies has fulfilled it."""
        asks = [(ask.body, ask.distance, ask.moved) for ask in self.record.asks]
        return parts_of(self.deed, self.record.fired, asks)

    @property
    def broken(self) -> list[str]:
        """The invariants in the plane that it breaks; round a ring, borders tell how far one came only up to half."""
        before: Any = self.deed.before
        round_ = before.graph.circumference
        far = round_ is not None and self.deed.asked * 2 > round_
        return [one.id for one in IN_PLANE if not (far and one is HORIZONTAL) and not one.holds(self.deed)]

    @property
    def cases(self) -> list[str]:
        """The cases that one of its bodies has run into."""
        return [case.id for case in CASES if ran_into(case, self.parts)]

    def fault(self, case: Case) -> str:
        """The rule by which a body ran into a case: how it left its edge, or else the last by which its front walked.

        Raises:
            ValueError: if no body did.
        """
        for deed, fired in self.parts:
            if case.happened(deed, fired):
                own = [rule for body, rule in self.record.fired if body == deed.body]
                left = [rule for rule in AT_FAULT if rule in fired]
                return left[0] if left else [rule for rule in own[: own.index("follow/rear")] if "walk/" in rule][-1]
        raise ValueError(f"no body has run into {case.id}")


@dataclass(frozen=True)
class Replay:
    """A witness: a scenario, its level, and its requests played one after another."""

    scenario: ScenarioRecord
    record: LevelRecord

    @classmethod
    def of(cls, scenario: Any) -> Replay:
        """Of the JSON of a scenario that has its level in it."""
        read = msgspec.convert(scenario, ScenarioRecord)
        assert isinstance(read.level, LevelRecord)
        return cls(read, read.level)

    @cached_property
    def level(self) -> Level[Fraction]:
        """The level in exact numbers."""
        return valid_level(self.record, "$.level")

    @cached_property
    def done(self) -> tuple[Done, ...]:
        """All requests."""
        return tuple(self.play())

    def play(self) -> Iterator[Done]:
        """Play request by request; a tick is the requests of its characters."""
        world, profile = world_of(self.level), OF_REQUESTS[self.scenario.profile]
        for step in self.scenario.steps:
            for body, distance in self.requests(step):
                direction = Direction.RIGHT if distance >= 0 else Direction.LEFT
                deed, record = do(profile, world, body, direction, abs(distance), ZERO)
                yield Done(deed, record)
                world = deed.after  # type: ignore[assignment]

    def requests(self, step: StepRecord) -> Iterator[tuple[int, Fraction]]:
        """Who is asked for how much, to the right, in a step; who slides in a tick is not among them."""
        names = {body.name: handle for handle, body in enumerate(self.level.bodies)}
        if step.request is not None:
            yield names[step.request.body], exact(step.request.distance, "$")
        if step.tick is not None and step.tick.key in ("left", "right"):
            for body in list(self.level.bodies) * step.tick.times:
                if body.speed:
                    yield names[body.name], body.speed * self.level.tick * Direction[step.tick.key.upper()]

    @property
    def kept(self) -> tuple[str, ...]:
        """The guidelines that the level keeps."""
        return tuple(kept_by(World(self.level)))

    @property
    def broken(self) -> list[str]:
        """The invariants in the plane that some request breaks."""
        found = {name for done in self.done for name in done.broken}
        return [one.id for one in IN_PLANE if one.id in found]

    @property
    def cases(self) -> list[str]:
        """The cases that some request runs into."""
        found = {name for done in self.done for name in done.cases}
        return [case.id for case in CASES if case.id in found]

    def fault(self, case: Case) -> str:
        """The rule by which the first request that does runs into a case."""
        return next(done.fault(case) for done in self.done if case.id in done.cases)

    @cached_property
    def mended(self) -> str:
        """What becomes of it under the repaired rules: kept, or why its level is none of storeys, or what is broken."""
        try:
            replayed_from(self.scenario, self.record)
        except LevelError as error:
            return f"not of storeys: {error.problem}"
        except AssertionError as error:
            return f"broken: {error}"
        return "kept"
