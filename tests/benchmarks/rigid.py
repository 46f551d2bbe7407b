"""The scenes of the bench of steps in Box2D, with its settings in Unity; boxes do not turn, as bodies do not here.

Whoever rests may sleep.
"""

from __future__ import annotations

from typing import Any

from Box2D import b2_linearSlop, b2_polygonRadius, b2FixtureDef, b2PolygonShape, b2World
from evaluation.cases import UNITY
from evaluation.rigid import AT_REST, DEEP, HALF, UNITY_SETTINGS

from benchmarks.steps import FAR, SPEED, TICK, Prepared, Pushed

FRICTION = 0.4
"""That of Unity, where none is given."""
APART, PRESSED = 1 + 2 * AT_REST, 1 + 2 * b2_polygonRadius - b2_linearSlop
"""From middle to middle of two boxes that just do not touch, and of two that have been pressed together."""
TIMES_ITERATED = 64
"""So many times as many iterations as in Unity are the most."""
ENOUGH = 0.9
"""What part of the way of the first box the last one is to come."""


def boxes(scene: Pushed, along: float, pushing: bool) -> tuple[Any, list[Any]]:
    """A world with a scene, its boxes so far along from each other, and those that are pushed.

    If the first is `pushing`, nothing holds it back: it is a kinematic body.
    """
    world = b2World(gravity=(0, -UNITY), doSleep=True)
    floor = b2PolygonShape(vertices=[(-FAR, -DEEP), (FAR, -DEEP), (FAR, 0), (-FAR, 0)])
    world.CreateStaticBody(fixtures=b2FixtureDef(shape=floor, friction=FRICTION))
    ways = (along, 0.0) if scene.kind == "row" else (0.0, 1 + AT_REST)
    create = [world.CreateKinematicBody if pushing else world.CreateDynamicBody]
    create += [world.CreateDynamicBody] * (scene.bodies - 1)
    bodies = [box(one, place * ways[0], place * ways[1]) for place, one in enumerate(create)]
    for place in range(scene.standing_by):
        box(world.CreateDynamicBody, float(scene.beyond) + 2 * place, 0)
    return world, bodies


def box(create: Any, along: float, up: float) -> Any:
    """A box whose middle is so far along the floor, and so far above that of a box on the floor."""
    fixture = b2FixtureDef(shape=b2PolygonShape(box=(HALF, HALF)), density=1, friction=FRICTION, restitution=0)
    return create(position=(along, HALF + AT_REST + up), fixedRotation=True, fixtures=fixture)


def in_box2d(scene: Pushed, times: int = 1) -> Prepared:
    """The scene; the first box is given its speed in each tick, and slows down when it pushes.

    There are so many times as many iterations as in Unity.
    """
    return prepared(scene, *boxes(scene, APART, pushing=False), times)


def pushing_in_box2d(scene: Pushed) -> Prepared:
    """The scene; nothing holds the first box back, boxes are pressed together, and there are as many iterations, each
    time twice as many as before, as it takes until the last one comes with it, or as there may be.
    """
    times = 1
    while times < TIMES_ITERATED and not comes_along(scene, times):
        times *= 2
    return prepared(scene, *boxes(scene, PRESSED, pushing=True), times)


def comes_along(scene: Pushed, times: int) -> bool:
    """Whether the last box comes with the first."""
    tried = prepared(scene, *boxes(scene, PRESSED, pushing=True), times)
    tried.program()
    return tried.come() >= ENOUGH * float(SPEED * TICK) * tried.ticks


def prepared(scene: Pushed, world: Any, bodies: list[Any], times: int) -> Prepared:
    """A program that lets the boxes move for some ticks, with so many times as many iterations as in Unity."""
    velocities, positions = (times * count for count in UNITY_SETTINGS.iterations)
    start = bodies[-1].position[0]

    def program() -> None:
        for _ in range(scene.ticks):
            bodies[0].linearVelocity = (float(SPEED), bodies[0].linearVelocity[1])
            world.Step(float(TICK), velocities, positions)

    return Prepared(
        program,
        scene.ticks,
        lambda: {"contacts": world.contactCount, "iterations": velocities},
        lambda: float(bodies[-1].position[0] - start),
    )
