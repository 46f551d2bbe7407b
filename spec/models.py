"""Models: what the level, the graph and time are, where the thesis describes it; each seen at work in a scenario."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Model:
    """A part of the model: its sentence, its source, and the scenario of the library that shows it."""

    id: str
    sentence: str
    source: str
    scenario: str

    kind = "model"


MODELS: tuple[Model, ...] = (
    Model(
        "model/one-key",
        "In a tick with a key held, each character is asked to move in the key's direction by its speed times the "
        "tick; one that is blocked stops while the others go on.",
        "1.1; R1",
        "one-character-at-wall",
    ),
    Model(
        "model/edge-types",
        "Edges are ground edges, which bodies move on, fall edges, which they fall down, and jump edges, which are "
        "found when they are needed.",
        "1.2, 4.4; R2",
        "figure-1-2-fall-edge",
    ),
    Model("model/tick", "Time goes in ticks of a fixed length, 20 ms by default.", "5.2, 2.2; R4", "pushing-boxes-5"),
    Model(
        "model/tops",
        "Each body has two top corners, straight above its borders by its height, and between them a dynamic edge that "
        "bodies stand on; the top of body N is dynamic edge N, its corners are dynamic vertices 2N and 2N + 1.",
        "4.4, 6.1.1, 6.1.3; R9, R11, A30",
        "figure-4-4-dynamic-graph",
    ),
    Model(
        "model/world-position",
        "The place of a body in the plane is found through the chain of its supports down to a static edge.",
        "6.1.2; R12",
        "figure-6-1-position-lookup",
    ),
    Model(
        "model/interpolation",
        "Positions between two points are interpolated linearly; on a circular level by rotating from one to the other "
        "about the origin, the distance from it changing linearly.",
        "6.1.2; R13",
        "stack-at-the-seam",
    ),
    Model(
        "model/look-up",
        "What follows an edge is looked up by (vertex, direction, type), which gives a list.",
        "6.1.3; R14",
        "free-path",
    ),
    Model(
        "model/jump-edges",
        "Jump edges lead from a ledge to the top of a body, from a top to the top of another body, and from a top to a "
        "ledge.",
        "4.4, 6.1.3; R15, A54",
        "figure-4-4-dynamic-graph",
    ),
    Model("model/ledge", "A ledge is the top vertex of a fall edge.", "6.1.3; R16", "figure-6-3d-unobstructed-ledge"),
    Model(
        "model/creator",
        "A list of vertices is connected from left to right, and each edge is ground or a fall edge by its steepness; "
        "a level may also name its edges.",
        "6.1.3; R30, A42, U8",
        "stairs",
    ),
)
