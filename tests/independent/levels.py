"""Random scenarios of `repaired`: small levels on a coarse grid, so that exact fits and equal times are frequent."""

from dataclasses import replace
from fractions import Fraction
from itertools import pairwise
from random import Random
from typing import Any

from independent.model import Body, Span, Terrain, World, overlap

GRIDS = [(Fraction(1, 4), Fraction(1, 4)), (Fraction(1, 8), Fraction(1, 4)), (Fraction(1, 2), Fraction(1, 4))]
"""Margins, each with the grid of all places and widths."""
SPEEDS = [Fraction(1, 2), Fraction(1), Fraction(1), Fraction(2), Fraction(3)]

HEIGHTS = [Fraction(1), Fraction(1), Fraction(1), Fraction(1, 2), Fraction(5, 4)]
"""The height of all bodies of a level, and of its storeys."""

Piece = tuple[Fraction, Fraction, int, int | None]
"""Ground from left to right, at a storey, solid for so many storeys down; None is all the way."""


def scenario(random: Random, name: str) -> dict[str, Any]:
    """Return a scenario of a few steps. The reference may refuse it."""
    margin, grid = random.choice(GRIDS)
    height = random.choice(HEIGHTS)
    circumference = grid * random.randint(12, 40) if random.random() < 0.4 else None
    length = circumference or grid * random.randint(24, 56)
    ground = profile(random, length, grid)
    pieces = [*ground, *platforms(random, ground, length, grid)]
    shift = grid * random.choice([0, 1, 7, 15, -5])
    level = {
        "format": "graphbody/level@1",
        "name": name,
        "margin": str(margin),
        "tick": str(random.choice([Fraction(1, 4), Fraction(1, 2), Fraction(1)])),
        **graph(pieces, circumference, height, shift),
    }
    if circumference is not None:
        level["circumference"] = str(circumference)
    level["bodies"] = [{**body, "height": str(height)} for body in bodies(random, level, grid, height)]
    steps = [step(random, level["bodies"], grid) for _ in range(random.randint(1, 5))]
    head = {"format": "graphbody/scenario@1", "name": name, "profile": "repaired"}
    return {**head, "level": level, "steps": steps}


# Terrain


def profile(random: Random, length: Fraction, grid: Fraction) -> list[Piece]:
    """Return pits and steps: ground from end to end, solid all the way down."""
    cuts = sorted(
        {grid * random.randint(1, int(length / grid) - 1) for _ in range(random.choice([0, 1, 2, 2, 3, 4, 5]))}
    )
    borders = [Fraction(0), *cuts, length]
    return [(left, right, random.choice([0, 0, 1, 1, 2]), None) for left, right in pairwise(borders)]


def platforms(random: Random, ground: list[Piece], length: Fraction, grid: Fraction) -> list[Piece]:
    """Return platforms that are a storey or two thick, clear of the ground and each on a storey of its own."""
    result: list[Piece] = []
    for _ in range(random.choice([0, 0, 0, 1, 1, 2])):
        cells = int(length / grid)
        start = random.randint(0, cells - 4)
        end = random.randint(start + 1, min(cells, start + 12))
        thick = random.choice([1, 1, 2])
        storey = random.randint(thick + 1, 4)
        under = [piece[2] for piece in ground if overlap((grid * start, grid * end), piece[:2]) > 0]
        if max(under) < storey and storey not in [piece[2] for piece in result]:
            result.append((grid * start, grid * end, storey, thick))
    return result


def graph(pieces: list[Piece], circumference: Fraction | None, height: Fraction, shift: Fraction) -> dict[str, Any]:
    """Return the vertices and the edges that pieces of ground make, with a fall edge down from each open end."""
    drops = [drop for piece in pieces for drop in drops_of(piece, pieces, circumference)]
    corners = {(x, low) for x, _, low, _ in drops}
    vertices: dict[tuple[Fraction, int], int] = {}

    def vertex(x: Fraction, storey: int) -> int:
        around = x if circumference is None else x % circumference
        return vertices.setdefault((around, storey), len(vertices))

    edges: list[dict[str, Any]] = []
    for left, right, storey, thick in sorted(pieces, key=lambda piece: piece[:3]):
        cuts = sorted({left, right, *(x for x, low in corners if low == storey and left < x < right)})
        for start, end in pairwise(cuts):
            edge: dict[str, Any] = {"left": vertex(start, storey), "right": vertex(end, storey), "type": "ground"}
            edges.append(edge if thick is None else {**edge, "thickness": str(thick * height)})
    for x, high, low, side in drops:
        ends = (vertex(x, high), vertex(x, low)) if side > 0 else (vertex(x, low), vertex(x, high))
        edges.append({"left": ends[0], "right": ends[1], "type": "fall"})
    return {"vertices": [[str(x + shift), str(storey * height)] for x, storey in vertices], "edges": edges}


def drops_of(piece: Piece, pieces: list[Piece], circumference: Fraction | None) -> list[tuple[Fraction, int, int, int]]:
    """Return where one drops from the ends of a piece: the place, the upper and the lower storey, and the side."""
    result = []
    for x, side in ((piece[0], -1), (piece[1], 1)):
        beside = [other for other in pieces if reaches(other, x, side, circumference)]
        level_or_wall = any(
            other[2] >= piece[2] and (other[3] is None or other[2] - other[3] <= piece[2]) for other in beside
        )
        lower = [other[2] for other in beside if other[2] < piece[2]]
        if lower and not level_or_wall:
            result.append((x, piece[2], max(lower), side))
    return result


def reaches(piece: Piece, x: Fraction, side: int, circumference: Fraction | None) -> bool:
    """Return whether a piece lies beside a place, on its right (1) or left (-1)."""
    places = [x] if circumference is None else [x, x - circumference, x + circumference]
    return any(piece[0] <= at < piece[1] if side > 0 else piece[0] < at <= piece[1] for at in places)


# Bodies


def bodies(random: Random, level: dict[str, Any], grid: Fraction, height: Fraction) -> list[dict[str, Any]]:
    """Return bodies in places that are free: on the ground, in stacks, some hanging over."""
    world = World(Terrain(level, height), Fraction(level["margin"]), [])
    wanted = random.randint(2, 8)
    for number in range(wanted):
        for _ in range(6 if world.bodies else 100):
            body = a_body(random, world, f"B{number}", grid)
            if body is not None and is_free(world, body):
                world.bodies.append(body)
                break
    order = list(range(len(world.bodies)))
    random.shuffle(order)
    return [body_record(world, world.bodies[i]) for i in order]


def a_body(random: Random, world: World, name: str, grid: Fraction) -> Body | None:
    """Return a body on some ground or some top, on the grid; None if it would be too wide."""
    width = max(world.margin + grid, grid * random.choice([2, 3, 4, 4, 4, 5, 6, 8, 12]))
    speed = random.choice(SPEEDS) if random.random() < 0.55 else Fraction(0)
    new = Body(name, Fraction(0), width, 0, None, speed, random.random() < 0.85)
    if world.bodies and random.random() < 0.45:
        support = random.randrange(len(world.bodies))
        span, storey = (world.bodies[support].left, world.bodies[support].right), world.bodies[support].storey + 1
    else:
        edge = random.choice(world.terrain.edges)
        support, span, storey = None, edge.span, edge.storey
    around = world.terrain.circumference
    if around is not None and width + world.margin > around:
        return None
    left = span[0] + grid * random.randint(-int(width / grid), int((span[1] - span[0]) / grid))
    return replace(new, left=left if around is None else left % around, storey=storey, support=support)


def is_free(world: World, body: Body) -> bool:
    """Return whether a body has a support, is in no wall, and keeps the margin to others."""
    trial = World(world.terrain, world.margin, [*world.bodies, body])
    span = (body.left, body.right)
    others = [near for other in world.bodies if other.storey == body.storey for near in copies(world.terrain, other)]
    return (
        trial.holds(len(world.bodies), body.support)
        and all(overlap(wall, span) <= 0 for wall in world.terrain.walls(body.storey))
        and all(overlap(other, span) <= -world.margin for other in others)
    )


def copies(terrain: Terrain, body: Body) -> list[Span]:
    """Return where a body is, on a cylinder as often as another may meet it."""
    return list(terrain.copies([(body.left, body.right)]))


def body_record(world: World, body: Body) -> dict[str, Any]:
    """Return a body as it stands in a level."""
    place = world.place(body)
    sides = {side: {**place[side], "location": str(place[side]["location"])} for side in ("left", "right")}
    record: dict[str, Any] = {"name": body.name, **sides}
    if body.speed != 0:
        record["speed"] = str(body.speed)
    return record if body.pushes else {**record, "pushes": False}


# Steps


def step(random: Random, given: list[dict[str, Any]], grid: Fraction) -> dict[str, Any]:
    """Return a step: a request, some ticks, or several bodies driven at once."""
    kind = random.random()
    if kind < 0.35:
        distance = random.choice([-1, 1]) * grid * random.choice([0, *range(1, 40)])
        return {"request": {"body": random.choice(given)["name"], "distance": str(distance)}}
    if kind < 0.5:
        return {"tick": {"key": random.choice(["left", "right"]), "times": random.randint(1, 6)}}
    driven = random.sample(given, random.randint(1, len(given)))
    speeds = {body["name"]: str(random.choice([-1, 1]) * random.choice([Fraction(0), *SPEEDS])) for body in driven}
    return {"drive": {"speeds": speeds, "time": str(grid * random.randint(0, 24))}}
