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


OF_GRAPHS: tuple[Model, ...] = (
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
        "model/velocity-first",
        "In a tick each body that moves of its own, in its turn, finds its velocity, then its distance, which is the "
        "new velocity times the tick, and then moves by that.",
        "5.2; R10",
        "physics-slope-printed",
    ),
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

OF_STOREYS: tuple[Model, ...] = (
    Model(
        "model/storeys",
        "All bodies have one height, that of a storey. All ground is level, at whole multiples of it above the "
        "lowest, which is the closed floor, the ground of storey 0. Terrain is solid in whole storeys: ground at "
        "multiple m has it on the storeys below m, on all of them, or on as many as its thickness says.",
        "6.2.2; G1, G2, G3, U8",
        "repaired-scraped-off",
    ),
    Model(
        "model/place",
        "A body is on one storey, from a left border to a right one, at a distance, its width, that never changes and "
        "is greater than the margin. It has one support: the ground of its storey, or the top of a body one storey "
        "below.",
        "4.3.1, 4.4; R8, A29",
        "repaired-ride",
    ),
    Model(
        "model/solid",
        "What is solid on a storey is a wall to the bodies on it, and ground to those on the storey above; above the "
        "floor there is no other ground. On a line both ends of the level are walls on every storey; on a cylinder "
        "there are no ends, and places are counted modulo the circumference. No wall is thinner than the margin.",
        "6.2.1b, 6.1.3; R19, A42, A58",
        "repaired-exact-pit",
    ),
    Model(
        "model/holds",
        "The ground holds a body while the two overlap by more than 0. A body holds one that is a storey above it "
        "while the two overlap, or the gap between their borders is less than the margin; at a gap of the margin it "
        "holds no more.",
        "6.2.1d, 7.2; R21, A14, U5, U7",
        "repaired-slot",
    ),
    Model(
        "model/neighbours",
        "Neighbours are two bodies next to each other on one storey with no wall between them. On a cylinder the last "
        "and the first are next to each other, so that each of two bodies is the other's neighbour on both sides; a "
        "body alone is not its own.",
        "6.2.1, 4.2; R34, A12, E11",
        "repaired-thin-wall",
    ),
    Model(
        "model/drive",
        "For the length of a step each body has a drive, a velocity. Of a character that is driven, even at 0, it is "
        "meant in the plane, of a box that is driven relative to its support; of any other it is 0 relative to its "
        "support. A tick with a key held drives every character at its speed in the key's direction; a request to move "
        "by d drives its body at unit speed in the direction of d, for a time of |d|.",
        "1.1, 6.2.1; R1, R4, R17, A52, A53",
        "repaired-walks-on-mover",
    ),
    Model(
        "model/step",
        "A step takes a time, at least 0, and goes so. (1) All bodies whose support does not hold settle "
        "(model/settling). (2) Each two neighbours whose gap is not greater than the margin are recorded as in "
        "contact, and each body whose distance to a wall is 0 as at that wall. (3) Velocities are found "
        "(model/velocities). (4) Of the events that come if all go on so (event/...), and of the end of the step, the "
        "earliest is the next instant; all bodies move with their velocities up to it. (5) All events of that instant "
        "are recorded, records that are over are dropped (model/records), and whoever lost its support settles; if "
        "anybody has, what (2) says is recorded too. (6) If time is left, it goes on with (3). So the last instant has "
        "its events and its settling too, and a step of no time only settles and records. Events of one instant may be "
        "told in any order.",
        "6.2.1, 5.2; R5, R10, R23, A1",
        "repaired-fills-pit",
    ),
    Model(
        "model/velocities",
        "Velocities are found storey by storey upwards, so that what carries has its velocity before what it carries. "
        "On a storey they are found row by row: a row is a longest chain of neighbours that are recorded as in "
        "contact, maybe of one body.",
        "4.4, 6.1.2; R12, A27",
        "repaired-ride",
    ),
    Model(
        "model/row",
        "In a row, first each body has its wish (wish/...). The part of it to the right, at least 0, is passed on "
        "from left to right: each body's speed to the right is its own or a greater one that the body on its left "
        "passes to it (row/own, row/pushed), and it passes its speed on, or 0 (row/passes-on, row/passes-nothing). "
        "Likewise to the left, from right to left. A body with speeds greater than 0 both ways is squeezed "
        "(row/squeezed), so is all of a row that closes on itself (row/ring): from here on their wish is 0, they pass "
        "nothing on, and there is a wall to them on both sides. With that, wishes are passed on once more, and nobody "
        "is judged squeezed again. At last, for each direction, from the front-most body backwards, each speed is cut "
        "to that of the body in contact ahead, or to 0 at a wall (way/...); the speed ahead that counts is the one in "
        "that direction, at least 0. The velocity is the speed to the right less the speed to the left.",
        "4.2, 6.2.1c; R6, R20, A2, A3, A53",
        "repaired-squeezed-passes-nothing",
    ),
    Model(
        "model/records",
        "A contact that is recorded lasts until two neighbours part: until time passes in which the right one moves "
        "faster to the right than the left one, or they have settled on different storeys; two that fall together "
        "stay in contact. A body at a wall is there until time passes in which it moves away, or it changes its "
        "storey. While they last, no event between the two comes. Records are made anew in each step; what touches "
        "when bodies have settled is recorded without an event, so that a falling body may close a row round a ring.",
        "6.2.1c; R20, R24, R31",
        "repaired-closes-a-ring",
    ),
    Model(
        "model/settling",
        "Settling looks at the bodies once, lowest storey first, so that a rider looks after what carries it. A body "
        "that has lost its support, or whose support is no longer one storey below it, looks for another by the rules "
        "settle/...: ground first, then a top, and where there is none it falls and looks again from the storey "
        "below. A support that it has moved off at this instant does not count, be it ground or a top; one that has "
        "fallen counts where it is again one storey below. On a cylinder a top that would hold it on both its sides "
        "counts on both. Its motion is its velocity less that of the support it lost, both as they were up to now; at "
        "the beginning of a step it is 0. Settling takes no time. Whoever falls between others is nowhere nearer to "
        "them than the margin: one that was would hold it (model/holds).",
        "6.2.1d, 6.2.1e; R21, R22, R23, A4, A28, A48, P8",
        "repaired-support-falls",
    ),
    Model(
        "model/positions",
        "In files, the borders of a body on a top are that far from its left corner, on a cylinder the way round on "
        "which the middles of the two are nearer; of a body on the ground they are edge positions on the first string "
        "of ground edges under it, from left to right; on a cylinder on that one of them whose left end comes first "
        "from place 0 on. Beyond the ends both overhang. At a vertex between two edges a left border is at the "
        "beginning of the right edge, a right border at the end of the left one. A rider's support is named by the top "
        "that it is on. How far a body has moved is told in the plane; of a contact the left one of the two is told.",
        "4.3.1, 6.1.1; R7, R11, A56, A57",
        "repaired-front-most",
    ),
)

MODELS: tuple[Model, ...] = (*OF_GRAPHS, *OF_STOREYS)
