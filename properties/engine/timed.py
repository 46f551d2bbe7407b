"""Velocities and times as a machine holds them, where neither is known.

What is looked at is a while, from an instant to the next one. A product of two unknown numbers is not linear. So a time
is known by the ways that it makes of velocities, and a velocity by the ways that it makes of times: how far it leads
in the while as it should be, in the time by which the while begins late, and in the time that the machine takes for it.
Ways are added as velocities are. A velocity is off by what it is made of; that too is a way, in the machine's time.

It knows nothing of bodies.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from properties.engine.rounded import Machine, Rounded

A_QUOTIENT = "a quotient, multiplied again, is off by a rounding"


@dataclass(frozen=True)
class Ways:
    """How far a velocity leads: in the while as it is `due`; in the time by which that begins `late`; in the machine's
    time, in which it has `gone` so far, and `astray` of that, since the machine's velocity is off.
    """

    due: Any
    late: Any
    gone: Any
    astray: Any

    def minus(self, other: Ways, error: Any) -> Ways:
        """Those of a difference of velocities, which is rounded."""
        gone, astray = self.gone - other.gone + error, self.astray - other.astray + error
        return Ways(self.due - other.due, self.late - other.late, gone, astray)

    def times(self, sign: int) -> Ways:
        """Those of the velocity times 1, 0 or -1."""
        return Ways(self.due * sign, self.late * sign, self.gone * sign, self.astray * sign)

    @property
    def late_after(self) -> Any:
        """How far it leads in the time by which the while ends late."""
        return self.gone - self.astray - self.due + self.late


@dataclass(frozen=True)
class Time:
    """How long the machine takes for the while; `held` has its sign."""

    held: Any

    def __mul__(self, other: int) -> Time:
        return Time(self.held * other)

    def __le__(self, other: Time) -> Any:
        return self.held <= other.held


@dataclass(frozen=True, eq=False, kw_only=True)
class Speed(Rounded):
    """A velocity, of which the machine holds what is known by its ways."""

    ways: Ways

    def __sub__(self, other: Any) -> Speed:
        error = error_of(self.machine)
        return Speed(machine=self.machine, held=self.held - other.held, ways=self.ways.minus(other.ways, error))

    def __mul__(self, other: Any) -> Any:
        """Its way in a time, which is rounded; or the velocity times 1, 0 or -1."""
        if isinstance(other, Time):
            return self.machine.rounded(self.ways.gone)
        return Speed(machine=self.machine, held=self.held * int(other), ways=self.ways.times(int(other)))

    def __rtruediv__(self, way: Rounded) -> Time:
        """The time in which it goes a way."""
        quotient = self.machine.rounded(way.held)
        self.machine.given.assume(quotient.held == self.ways.gone, A_QUOTIENT)
        return Time(way.held)


def error_of(machine: Machine) -> Any:
    """The error of one more sum."""
    machine.errors += 1
    error = machine.given.number(f"error {machine.errors}") - 1
    machine.given.assume(error <= 1, "an error is at most a rounding")
    return error
