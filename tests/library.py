"""Scenarios of the library, as worlds of storeys."""

from fractions import Fraction

from reference.formats.level import valid_level
from reference.formats.scenario import read_scenario
from reference.plan import plan_of
from reference.play import LIBRARY
from reference.stepping import of_step
from spec.storeys import Drive


def first_step(name):
    """The world of a scenario of one step: where it starts, the drives of all its bodies, and how long they last."""
    scenario, record = read_scenario(LIBRARY / "scenarios" / f"{name}.json")
    level = valid_level(record, "$.level")
    world, (driven, duration) = plan_of(level).start(), of_step(level, *scenario.steps)
    return world, dict.fromkeys(range(len(world.places)), Drive(Fraction(0))) | driven, duration
