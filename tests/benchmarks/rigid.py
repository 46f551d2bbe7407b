"""The scenes of the bench of steps in Box2D, with its settings in Unity; boxes do not turn, as bodies do not here.

Whoever rests may sleep.
"""

from __future__ import annotations

from typing import Any

from Box2D import b2FixtureDef, b2PolygonShape, b2World
from evaluation.cases import UNITY
from evaluation.rigid import AT_REST, DEEP, HALF, UNITY_SETTINGS

from benchmarks.steps import FAR, SPEED, TICK, Prepared, Pushed

FRICTION = 0.4
"""That of Unity, where none is given."""
APART = 1 + 2 * AT_REST


def box(world: Any, along: float, up: float) -> Any:
    """A box whose middle is so far along the floor, and so far above that of a box on the floor."""
    fixture = b2FixtureDef(shape=b2PolygonShape(box=(HALF, HALF)), density=1, friction=FRICTION, restitution=0)
    return world.CreateDynamicBody(position=(along, HALF + AT_REST + up), fixedRotation=True, fixtures=fixture)


def in_box2d(scene: Pushed) -> Prepared:
    """The scene; the first box is given its speed in each tick."""
    world = b2World(gravity=(0, -UNITY), doSleep=True)
    floor = b2PolygonShape(vertices=[(-FAR, -DEEP), (FAR, -DEEP), (FAR, 0), (-FAR, 0)])
    world.CreateStaticBody(fixtures=b2FixtureDef(shape=floor, friction=FRICTION))
    along, up = (APART, 0.0) if scene.kind == "row" else (0.0, 1 + AT_REST)
    bodies = [box(world, place * along, place * up) for place in range(scene.bodies)]
    for place in range(scene.standing_by):
        box(world, float(scene.beyond) + 2 * place, 0)
    start = bodies[-1].position[0]

    def program() -> None:
        for _ in range(scene.ticks):
            bodies[0].linearVelocity = (float(SPEED), bodies[0].linearVelocity[1])
            world.Step(float(TICK), *UNITY_SETTINGS.iterations)

    return Prepared(
        program,
        scene.ticks,
        lambda: {"contacts": world.contactCount},
        lambda: float(bodies[-1].position[0] - start),
    )
