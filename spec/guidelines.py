"""Guidelines (6.2.2): what the thesis asks of levels, each a predicate of a world."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from spec.graph import EdgeType
from spec.invariants import every
from spec.number import Truth


@dataclass(frozen=True)
class Guideline:
    """A guideline: its sentence, its source, and whether a world keeps it."""

    id: str
    sentence: str
    source: str
    kept: Callable[[Any], Truth]

    kind = "guideline"


def edges_of(world: Any, edge_type: EdgeType) -> list[Any]:
    """The static edges of a type."""
    return [edge for edge in world.graph.edges if edge.type is edge_type]


def one_size(world: Any) -> Truth:
    """All bodies have the width and the height of the first."""
    sizes = [(world.width(body), world.bodies[body].height) for body in world.handles()]
    return every((width == sizes[0][0]) & (height == sizes[0][1]) for width, height in sizes)


def falls_are_steps(world: Any) -> Truth:
    """Every fall edge is vertical, and as high as a body."""
    heights = [body.height for body in world.bodies]
    falls = edges_of(world, EdgeType.FALL)
    return every(edge.run == 0 and edge.length == height for edge in falls for height in heights)


def falls_end_level(world: Any) -> Truth:
    """Every ground edge at the lower end of a fall edge is level."""
    graph = world.graph
    feet = {edge.right if edge.rise < 0 else edge.left for edge in edges_of(world, EdgeType.FALL)}
    grounds = [edge for edge in edges_of(world, EdgeType.GROUND) if edge.left in feet or edge.right in feet]
    return every(edge.rise == 0 for edge in grounds) if graph.edges else True


def grounds_are_long(world: Any) -> Truth:
    """Every ground edge is at least as long as every body is wide."""
    widths = [world.width(body) for body in world.handles()]
    return every(edge.length >= width for edge in edges_of(world, EdgeType.GROUND) for width in widths)


def one_layer(world: Any) -> Truth:
    """The edges join the vertices from left to right, once."""
    edges = sorted(world.graph.edges, key=lambda edge: edge.left)
    count = len(world.graph.vertices)
    return all(edge.left == place and edge.right == (place + 1) % count for place, edge in enumerate(edges))


GUIDELINES: tuple[Guideline, ...] = (
    Guideline("guideline/uniform-size", "All bodies have one size.", "6.2.2; G1", one_size),
    Guideline(
        "guideline/vertical-falls", "Fall edges are vertical and one body height tall.", "6.2.2; G2", falls_are_steps
    ),
    Guideline("guideline/level-landings", "Fall edges end only in level ground edges.", "6.2.2; G3", falls_end_level),
    Guideline("guideline/long-grounds", "Ground edges are at least one body long.", "6.2.2; G4", grounds_are_long),
    Guideline("guideline/single-layer", "There is a single layer of static edges.", "6.2.2; G5", one_layer),
)


def kept_by(world: Any) -> list[str]:
    """The IDs of the guidelines that a world keeps."""
    return [guideline.id for guideline in GUIDELINES if guideline.kept(world)]
