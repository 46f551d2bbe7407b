"""Defects of the thesis, replayed under the repaired rules: what is promised of the plane holds after every step."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path

from msgspec.structs import replace

from reference.formats.level import LevelRecord
from reference.formats.scenario import ScenarioRecord
from reference.play import LIBRARY, Played, read_playable, set_up, steps
from reference.world import World
from spec.graph import Direction
from spec.invariants import Deed
from spec.plane import NEVER_RAISED, PLANE_MARGIN, SUPPORTS_END, TERRAIN
from spec.profiles import REPAIRED, AnyProfile

ZERO = Fraction(0)
STOPS = {"way/wall", "way/slower", "row/squeezed", "row/ring"}

SHOWN: dict[str, str] = {
    "figure-6-6a-short-pit": "U1",
    "figure-6-6a-short-pit-in-one-step": "U1",
    "figure-6-6b-short-pit-with-heights": "U2",
    "figure-6-6c-short-pit-on-body": "U3",
    "repaired-tunnel": "U4",
    "repaired-fall-onto-the-middle": "U5",
    "fall-off-a-body": "U7",
    "box-on-top-is-not-seen": "U9",
    "difference-other-string": "U9",
    "landing-does-not-fit": "U11",
    "far-ledge-not-free": "A54",
    "rider-carried-into-wall": "A27",
    "two-riders-on-one-top": "A27",
    "rider-over-a-fall": "A28",
    "rider-with-own-speed": "A52",
    "touching-characters": "A53",
    "touching-characters-to-the-left": "A53",
    "edges-below-margin": "A12",
    "edges-below-margin-from-the-right": "A12",
    "ring-of-two": "E11",
    "difference-stopped-before": "U2",
    "lands-near": "R24",
    "lands-too-far": "A19",
    "ridden-top": "A23",
    "lands-in-terrain": "A16",
    "stopped-from-above": "A20",
    "overshoot-into-wall": "A15",
}
"""Scenarios in which the thesis breaks something, and the row that says so."""

OUTSIDE: dict[str, str] = {
    "figure-6-6d-tunnel": "the tunnel is lower than a storey: repaired-tunnel shows the case",
    "figure-6-6e-falling-on-the-middle": "platforms are half a storey thick: repaired-fall-onto-the-middle shows it",
    "figure-6-6f-sharp-ledge": "its fall edge slants: on storeys no box is under the tip of a ledge of its height",
    "figure-6-6f-sharp-ledge-in-front": "the same",
    "through-floor": "its layer is a quarter of a storey thick",
    "blocked-by-tall-bodies": "its bodies have several heights",
    "smallest-drop": "its bodies have several heights",
}
"""Scenarios of such cases whose levels are not levels of storeys, and why."""


def replayed(path: Path) -> int:
    """Play a scenario under the repaired rules; return the number of its steps.

    Raises:
        AssertionError: if a step breaks what is promised.
        LevelError: if its level is not one of storeys.
    """
    return replayed_from(*read_playable(path))


def replayed_from(scenario: ScenarioRecord, level: LevelRecord) -> int:
    """The same of a scenario at hand, and its level."""
    game = set_up(replace(scenario, profile=REPAIRED.name), level, floats=False)
    before = game.world
    number = 0
    for number, step in enumerate(steps(game, scenario.steps, False, Path(scenario.name)), start=1):
        broken = [*broken_in_plane(before, game.world), *broken_by(step)]
        assert not broken, f"{scenario.name}, step {number}: {', '.join(broken)}"
        before = game.world
    return number


def broken_in_plane(before: World[Fraction], after: World[Fraction]) -> Iterator[str]:
    """What a step breaks in the plane."""
    deed = Deed(before, after, 0, Direction.RIGHT, ZERO, ZERO, 1, 1, 0, ZERO)
    return (one.id for one in (PLANE_MARGIN, TERRAIN, SUPPORTS_END, NEVER_RAISED) if not one.holds(deed))


def broken_by(step: Played[Fraction]) -> Iterator[str]:
    """Who did not move exactly as far as asked, though neither a wall nor a body in its row stopped it."""
    stopped = {body for move in step.moves for body, rule in move.fired if rule in STOPS}
    for move in step.moves:
        if abs(move.moved) > abs(move.asked) or (move.moved != move.asked and move.body not in stopped):
            yield f"{move.body} is asked for {move.asked} and moves {move.moved}"


def witnesses_mended(profile: AnyProfile) -> int:
    """Every scenario in which the thesis breaks something keeps its promises under the repaired rules."""
    for name in SHOWN:
        assert replayed(LIBRARY / "scenarios" / f"{name}.json"), f"{name} has no steps"
    return len(SHOWN)
