"""The mutants that change nothing, by an argument of a line each, because no solver was asked."""

from __future__ import annotations

ARGUED = {
    "plane.Box.beside: False instead of True (2)": "a box that asks is that of a body, and has a bottom",
    "plane.negated: truth <= False instead of truth == False": "of two truths, only False is at most False",
    "plane.box: right < left instead of circumference is not None and right < left": "on a line, left borders are left",
    "plane.box: right <= left instead of right < left": "bodies have a width",
    "plane.terrain: edge.rise == 0 instead of edge.type is EdgeType.GROUND and edge.rise == 0": "no fall edge is level",
    "plane.carriers: (below := world.support(chain[-1])) is not None instead of len(chain) <= len(world.bodies) and "
    "(below := world.support(chain[-1])) is not None": "supports end on the ground, which `supports-end` judges",
}
