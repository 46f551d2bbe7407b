"""Guidelines (6.2.2): what the thesis asks of levels, each as the demands that it makes of their places."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from spec.demand import Demand, Element, Place, all_met
from spec.graph import Edge, EdgeType, Graph
from spec.number import Truth


@dataclass(frozen=True)
class Size:
    """How wide and how high some bodies are."""

    bodies: tuple[int, ...]
    width: Any
    height: Any

    @property
    def places(self) -> tuple[Place, ...]:
        """The bodies as places."""
        return tuple(Place(Element.BODY, body) for body in self.bodies)


@dataclass(frozen=True)
class Guideline:
    """A guideline: its sentence, its source, and what it demands of a graph and of the sizes of bodies."""

    id: str
    sentence: str
    source: str
    demands: Callable[[Graph[Any], Sequence[Size]], Iterator[Demand]]

    kind = "guideline"

    def kept(self, world: Any) -> Truth:
        """Whether a world keeps it."""
        return all_met(self.demands(world.graph, sizes_of(world)))


def sizes_of(world: Any) -> list[Size]:
    """The size of each body."""
    return [Size((body,), world.width(body), world.bodies[body].height) for body in world.handles()]


def edges_of(graph: Graph[Any], edge_type: EdgeType) -> Iterator[tuple[Place, Edge[Any]]]:
    """The static edges of a type, with their places."""
    for index, edge in enumerate(graph.edges):
        if edge.type is edge_type:
            yield Place(Element.EDGE, index), edge


def one_size(graph: Graph[Any], sizes: Sequence[Size]) -> Iterator[Demand]:
    """All bodies have the width and the height of the first."""
    for size in sizes:
        first = sizes[0]
        met = (size.width == first.width) & (size.height == first.height)
        numbers = (size.width, size.height, first.width, first.height)
        seen, mend = "is {0} wide and {1} high, not {2} and {3} as {others}", "make it {2} wide and {3} high"
        for place in size.places:
            yield Demand(place, met, seen, mend, numbers, first.places[:1])


def falls_are_steps(graph: Graph[Any], sizes: Sequence[Size]) -> Iterator[Demand]:
    """Every fall edge is vertical, and as high as a body."""
    for place, edge in edges_of(graph, EdgeType.FALL):
        slants = (edge.run * edge.length,)
        yield Demand(place, edge.run == 0, "goes {0} to the right", "put one end straight above the other", slants)
        for size in sizes:
            met, numbers = edge.length == size.height, (edge.length, size.height)
            yield Demand(
                place, met, "is {0} long, not {1}, the height of {others}", "make it {1} high", numbers, size.places
            )


def falls_end_level(graph: Graph[Any], sizes: Sequence[Size]) -> Iterator[Demand]:
    """At the lower end of a fall edge there is ground, or the next fall edge; and every ground edge there is level."""
    feet = {edge.right if edge.rise < 0 else edge.left: place for place, edge in edges_of(graph, EdgeType.FALL)}
    ends = [vertex for edge in graph.edges for vertex in (edge.left, edge.right)]
    for foot, place in feet.items():
        if ends.count(foot) == 1:
            yield Demand(place, False, "ends at no ground", "let it end at level ground")
    for place, edge in edges_of(graph, EdgeType.GROUND):
        for foot in {edge.left, edge.right} & feet.keys():
            rises = (edge.rise * edge.length,)
            seen, mend = "rises by {0}, and {others} ends at it", "make it level"
            yield Demand(place, edge.rise == 0, seen, mend, rises, (feet[foot],))


def grounds_are_long(graph: Graph[Any], sizes: Sequence[Size]) -> Iterator[Demand]:
    """Every ground edge is at least as long as every body is wide."""
    for place, edge in edges_of(graph, EdgeType.GROUND):
        for size in sizes:
            met, numbers = edge.length >= size.width, (edge.length, size.width)
            seen, mend = "is {0} long, less than {1}, the width of {others}", "make it at least {1} long"
            yield Demand(place, met, seen, mend, numbers, size.places)


def one_layer(graph: Graph[Any], sizes: Sequence[Size]) -> Iterator[Demand]:
    """The edges join the vertices from left to right, once."""
    line = "lay all edges end to end, from the first vertex to the last"
    first_from: dict[int, Place] = {}
    for index, edge in enumerate(graph.edges):
        place = Place(Element.EDGE, index)
        following = (edge.left + 1) % len(graph.vertices)
        seen = "joins vertex {0} to vertex {1}, not to the next, {2}"
        yield Demand(place, edge.right == following, seen, line, (edge.left, edge.right, following))
        known = first_from.setdefault(edge.left, place)
        yield Demand(place, known is place, "begins where {others} begins", line, others=(known,))
    for vertex in range(max(first_from, default=0)):
        seen = "has no edge to the right, though others have that are after it"
        yield Demand(Place(Element.VERTEX, vertex), vertex in first_from, seen, line)


SINGLE_LAYER = Guideline("guideline/single-layer", "There is a single layer of static edges.", "6.2.2; G5", one_layer)

GUIDELINES: tuple[Guideline, ...] = (
    Guideline("guideline/uniform-size", "All bodies have one size.", "6.2.2; G1", one_size),
    Guideline(
        "guideline/vertical-falls", "Fall edges are vertical and one body height tall.", "6.2.2; G2", falls_are_steps
    ),
    Guideline("guideline/level-landings", "Fall edges end only in level ground edges.", "6.2.2; G3", falls_end_level),
    Guideline("guideline/long-grounds", "Ground edges are at least one body long.", "6.2.2; G4", grounds_are_long),
    SINGLE_LAYER,
)


def kept_by(world: Any) -> list[str]:
    """The IDs of the guidelines that a world keeps."""
    return [guideline.id for guideline in GUIDELINES if guideline.kept(world)]
