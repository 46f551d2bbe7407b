"""Where both profiles must end alike: requests on one string without ledges, all sizes and places arbitrary reals."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from properties.evidence.deeds import MOST_RULES
from properties.given import Given
from properties.worlds.rows import any_level
from reference.simulator import move
from reference.stepping import run
from reference.storeys import Place, StoreyWorld, Terrain
from reference.world import World
from spec.graph import Direction
from spec.number import zero_like
from spec.profiles import REPAIRED, Profile
from spec.storeys import Drive, Interval

ONE = Fraction(1)


def ground_floor(world: World[Any]) -> StoreyWorld[Any]:
    """A row on a line as the only storey there is."""
    zero = zero_like(world.margin)
    places = [
        Place(0, world.coordinate(held.left), world.width(body), None, held.pushes)
        for body, held in enumerate(world.bodies)
    ]
    return StoreyWorld(Terrain((), Interval(zero, world.rows[0].length)), world.margin, places)


def requests_end_alike(
    profile: Profile, given: Given, bodies: int, edges: int, closed: bool, mover: int, direction: Direction
) -> None:
    """A request ends with every body at the same place under a profile and under the repaired rules."""
    world = World(any_level(given, bodies, edges, closed))
    for body in world.handles():
        given.assume(world.width(body) > world.margin, "bodies are wider than the margin")
    asked = given.number("distance asked")
    storeys = ground_floor(world)
    drives = {body: Drive(ONE * direction if body == mover else ONE * 0) for body in world.handles()}
    after = world.copy()
    _, record = move(profile, after, mover, direction, asked, MOST_RULES)
    _, steps = run(REPAIRED.rules, storeys, drives, asked, MOST_RULES)
    for _, rule in (*record.fired, *steps.fired):
        given.saw(rule)
    for body in world.handles():
        same = after.coordinate(after.bodies[body].left) == storeys.places[body].left
        given.ensure(f"body {body} is at the same place", same)
