"""Rounding: how far what is computed in floats may be from what the rules do in exact numbers.

A rounding is the largest error of one sum: the unit roundoff, times the largest number in sight.
"""

from __future__ import annotations

from spec.invariants import Relation

NEARLY_EXACT = Relation(
    "invariant/nearly-exact",
    "In rounded arithmetic a request on one string puts every border as near to where exact numbers put it as 16 "
    "roundings for each time that a border walks along an edge, however many bodies are pushed.",
    "4.2, 6.2.1; R6, R20, R24",
)
MARGIN_NEARLY_KEPT = Relation(
    "invariant/margin-nearly-kept",
    "In rounded arithmetic, on one edge, whoever pushes comes no nearer to the next body than the margin less 5 "
    "roundings; or, where it was nearer than the margin before, than that less 2; however many bodies are pushed.",
    "4.2, 6.2.1; R6, R24, A10",
)
STEP_NEARLY_EXACT = Relation(
    "invariant/step-nearly-exact",
    "In rounded arithmetic, what comes next in a step of `repaired` is early or late by no more than makes up, at the "
    "speed at which the room lessens, for what its bodies are off already and 5 roundings; or than what came before. "
    "Until then nobody is off by more than it was and 2. Room that is not as little is used up to within 9. So it is "
    "on lines, where whoever is over ground is so by more than it is off, at any velocities, for any number of bodies.",
    "6.2.1; R18, R24",
)
OF_ROUNDING: tuple[Relation, ...] = (NEARLY_EXACT, MARGIN_NEARLY_KEPT, STEP_NEARLY_EXACT)
