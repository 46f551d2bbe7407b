"""The display: from a trace, or from a game, how each body is shown in each display step.

Places are of the level's kind of numbers. Angles are in degrees to the left, and floats: trigonometry is for display
only. Not all that is shown is where it is: nothing of the display goes back into the simulation.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Set
from dataclasses import dataclass
from fractions import Fraction
from math import atan2, degrees
from typing import Any, Generic

from reference.formats.numbers import exact
from reference.recording import Recording, following, state_after
from reference.world import World
from spec.body import Body
from spec.number import N, zero_like
from spec.rules.display import Descent, DisplayRules, Shift, Swing
from spec.storeys import short_way

ROUND = 360
FALLING = ("fall", "jump")
"""The events from which on a body is shown falling (`reading/shown-falling`)."""

Bearing = Callable[[Any, Any], Any]


def angle_of(run: Any, rise: Any) -> float:
    """The angle of a direction, in degrees to the left of straight right."""
    return degrees(atan2(rise, run))


@dataclass(frozen=True)
class Speeds(Generic[N]):
    """The speeds of a display: the fall speed, in the unit that its reading needs, and degrees turned per second."""

    fall: N
    turn: N


@dataclass(frozen=True)
class Shown(Generic[N]):
    """How a body is shown: where its left border is, and at which angle.

    Attributes:
        since: the time since its fall began, while it is shown falling.
        turning: whether it is shown turning.
    """

    x: N
    y: N
    angle: Any
    since: N | None = None
    turning: bool = False


class Screen(Generic[N]):
    """What is shown of a game, display step by display step; a body that comes is shown where it is.

    `bearing` is the angle of a direction, of its run and its rise.
    """

    def __init__(self, rules: DisplayRules, speeds: Speeds[N], world: World[N], bearing: Bearing = angle_of) -> None:
        """Show a game at its start."""
        self.rules, self.speeds, self.bearing = rules, speeds, bearing
        self.shown: dict[str, Shown[N]] = {}
        self.show(world, frozenset(), zero_like(world.margin))

    def show(self, world: World[N], fallen: Set[str], time: N) -> Mapping[str, Shown[N]]:
        """Take a display step of a time; `fallen` are those whose fall has begun since the last one."""
        seen: dict[str, Shown[N]] = {}
        for body in supports_first(world):
            name = world.bodies[body].name
            seen[name] = self.seen(world, body, name in fallen, time, lag(world, body, seen))
        self.shown = seen
        return seen

    def seen(self, world: World[N], body: int, falls: bool, time: N, raised: N) -> Shown[N]:
        """How a body is shown after a display step; its support is shown raised by so much."""
        held = world.bodies[body]
        x, y = world.point(held.left)
        last = self.shown.get(held.name, Shown(x, y + raised, self.bearing(*direction_of(world, held))))
        descent = self.descended(last, y + raised, falls, time)
        swing = self.swung(last, self.bearing(*direction_of(world, held)), falls, time)
        shift = Shift(last.x, x)
        since = self.since(last, falls, time) if descent.falling else None
        across = self.rules.across.choose(shift).effect(shift)
        return Shown(across, descent.shown, swing.shown, since, swing.turning)

    def since(self, last: Shown[N], falls: bool, time: N) -> N | None:
        """The time since a body's fall began, after a display step; None if it is not falling."""
        if falls:
            return time
        return None if last.since is None else last.since + time

    def descended(self, last: Shown[N], target: N, falls: bool, time: N) -> Descent[N]:
        """How high a body is shown after a display step."""
        after = self.since(last, falls, time)
        by = zero_like(time) if after is None else self.rules.sinking(after - time, after, self.speeds.fall)
        descent = Descent(last.y, target, after is not None, by)
        return self.rules.vertical.choose(descent).effect(descent)  # type: ignore[no-any-return]

    def swung(self, last: Shown[N], angle: Any, falls: bool, time: N) -> Swing[Any]:
        """At which angle a body is shown after a display step."""
        target = last.angle + short_way(angle - last.angle, ROUND)
        swing = Swing(last.angle, target, falls or last.turning, self.speeds.turn * time)
        return self.rules.rotation.choose(swing).effect(swing)  # type: ignore[no-any-return]


def supports_first(world: World[Any]) -> list[int]:
    """All bodies, each after the one that it stands on."""

    def storeys(body: int) -> int:
        """How many bodies are below."""
        below, count = world.support(body), 0
        while below is not None:
            below, count = world.support(below), count + 1
        return count

    return sorted(world.handles(), key=storeys)


def lag(world: World[N], body: int, seen: Mapping[str, Shown[N]]) -> N:
    """How much higher than it is the support of a body is shown (`reading/shown-support`)."""
    support = world.support(body)
    if support is None:
        return zero_like(world.margin)
    below = world.bodies[support]
    return seen[below.name].y - world.point(below.left)[1]


def direction_of(world: World[N], held: Body[N]) -> tuple[N, N]:
    """How far it is across and up from the left border of a body to the right one."""
    (x, y), (far_x, far_y) = world.point(held.left), world.unrolled(held)
    return far_x - x, far_y - y


def frames(
    recording: Recording, rules: DisplayRules, speeds: Speeds[Fraction], parts: int = 1
) -> Iterator[Mapping[str, Shown[Fraction]]]:
    """How the bodies of a trace are shown: at its start, then each step in so many display steps.

    A step takes a tick, a drive its time. Who falls is told by the events of the trace.

    Raises:
        FormatError: as the lines of the trace do.
    """
    level = recording.level
    screen = Screen(rules, speeds, World(level))
    yield screen.shown
    for line in recording.lines:
        level = following(level, line)
        world = state_after(recording, level, line)
        fallen = {event.body for event in line.events or () if event.event in FALLING}
        time = (level.tick if line.drive is None else exact(line.drive.time, "$.drive.time")) / parts
        for part in range(parts):
            yield screen.show(world, fallen if part == 0 else frozenset(), time)
