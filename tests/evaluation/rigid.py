"""Box2D: what rigid bodies do, with the settings of Unity's 2D physics where they are not the thing that is tried.

Boxes are one unit wide and high, and of density 1. A ground is one polygon. Bodies never sleep, so that what rests does
so because of the solver. Between shapes at rest Box2D leaves three times its slop: boxes start at that height.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import cos, radians, sin
from typing import Any

import Box2D
from Box2D import b2EdgeShape, b2FixtureDef, b2PolygonShape, b2World

from evaluation.cases import TICK, UNITY, Slide
from evaluation.tables import Engine

BOX2D = Engine("Box2D", Box2D.__version__)
HALF = 0.5
AT_REST = 3 * Box2D.b2_linearSlop
FAR, DEEP = 500, 5


@dataclass(frozen=True)
class Settings:
    """How the engine is set up; what is left out is as in Unity.

    Attributes:
        iterations: of the solver, for velocities and for positions.
        turning: whether boxes may turn.
        ground: `polygon`, `edge`, or `chain` for edges of one unit, one after another.
        above: how far above its height at rest a box begins.
        heading: the direction in which a box is set off, in degrees from the ground.
        damping: the linear drag.
    """

    iterations: tuple[int, int] = (8, 3)
    turning: bool = True
    ground: str = "polygon"
    above: float = 0
    heading: float = 0
    damping: float = 0


UNITY_SETTINGS = Settings()


@dataclass(frozen=True)
class Frame:
    """The directions along a ground and up from it."""

    degrees: float

    def point(self, along: float, up: float) -> tuple[float, float]:
        """A place in the plane."""
        c, s = cos(radians(self.degrees)), sin(radians(self.degrees))
        return along * c - up * s, along * s + up * c

    def along(self, point: Any) -> float:
        """How far along the ground a place is."""
        return float(point[0] * cos(radians(self.degrees)) + point[1] * sin(radians(self.degrees)))


def shapes(frame: Frame, settings: Settings) -> list[Any]:
    """The shapes of a ground."""
    if settings.ground == "polygon":
        corners = [(-FAR, -DEEP), (FAR, -DEEP), (FAR, 0), (-FAR, 0)]
        return [b2PolygonShape(vertices=[frame.point(*corner) for corner in corners])]
    step = 1 if settings.ground == "chain" else 2 * FAR
    ends = range(-FAR, FAR, step)
    return [b2EdgeShape(vertices=[frame.point(end, 0), frame.point(end + step, 0)]) for end in ends]


def ground(degrees: float, friction: float, settings: Settings) -> Any:
    """A world with a ground."""
    world = b2World(gravity=(0, -UNITY), doSleep=False)
    fixtures = [b2FixtureDef(shape=shape, friction=friction) for shape in shapes(Frame(degrees), settings)]
    world.CreateStaticBody(fixtures=fixtures)
    return world


def box(world: Any, degrees: float, along: float, friction: float, settings: Settings) -> Any:
    """A box on the ground of a world; coefficients mix to their geometric mean, here of two that are the same."""
    shape = b2PolygonShape(box=(HALF, HALF))
    return world.CreateDynamicBody(
        position=Frame(degrees).point(along, HALF + AT_REST + settings.above),
        angle=radians(degrees),
        fixedRotation=not settings.turning,
        linearDamping=settings.damping,
        fixtures=b2FixtureDef(shape=shape, density=1, friction=friction, restitution=0),
    )


def slide(run: Slide, ticks: int, settings: Settings = UNITY_SETTINGS) -> list[float]:
    """Where a box is after each tick, along the ground, from where it was."""
    world = ground(run.degrees, run.friction, settings)
    body, frame = box(world, run.degrees, 0, run.friction, settings), Frame(run.degrees)
    heading = radians(settings.heading)
    body.linearVelocity = frame.point(run.speed * cos(heading), run.speed * sin(heading))
    places, start = [], frame.along(body.position)
    for _ in range(ticks):
        world.Step(TICK, *settings.iterations)
        places.append(frame.along(body.position) - start)
    return places


def rests(degrees: float, friction: float) -> bool:
    """Whether a box laid down at rest on a slope moves by less than a hundredth of its width in two seconds."""
    return abs(slide(Slide(degrees, friction, 0), 100)[-1]) < HALF / 50


def pushed(boxes: int, friction: float, speed: float, wall: bool) -> Iterator[list[float]]:
    """Where a character and the boxes before it are after each tick; its velocity is set in every tick.

    Between two bodies there is a quarter of a unit, and as much before a wall; without a wall, a little.
    """
    world, apart = ground(0, friction, UNITY_SETTINGS), 1.25 if wall else 1 + 2 * AT_REST
    bodies = [box(world, 0, place * apart, friction, UNITY_SETTINGS) for place in range(boxes + 1)]
    if wall:
        near = boxes * apart + HALF + 0.25
        solid = b2PolygonShape(vertices=[(near, 0), (near + DEEP, 0), (near + DEEP, DEEP), (near, DEEP)])
        world.CreateStaticBody(fixtures=b2FixtureDef(shape=solid, friction=friction))
    while True:
        bodies[0].linearVelocity = (speed, bodies[0].linearVelocity[1])
        world.Step(TICK, *UNITY_SETTINGS.iterations)
        yield [float(body.position[0]) for body in bodies]
