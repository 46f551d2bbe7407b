"""Where landings fit: on an edge that is at least as long as the body is wide (6.2.2; E10, G1, G4, U11)."""

from __future__ import annotations

from properties.contracts.leaving import leaves
from properties.given import Given
from properties.worlds.window import Spot
from spec.conditions import GUIDELINES
from spec.rules.request import Rules


def long_edges_fit(rules: Rules, given: Given) -> None:
    """A body that comes down at the near end of an edge no shorter than it is wide stands on that edge alone.

    Within the guidelines ground is as long (G4), and so are tops, for bodies have one width (G1).
    """
    rule, leaving, placed = leaves(rules, given)
    for end in (leaving.foot, *(jump.target for jump in leaving.near)):
        if isinstance(end, Spot):
            given.assume(end.length >= leaving.width, GUIDELINES.id)
            given.assume(end.reach == end.length, "a near end is an end of its edge")
    if rule in ("leave/fall", "leave/jump"):
        given.ensure("the front border is on no later edge than the rear border", placed.front.edge <= placed.rear.edge)
        given.ensure("it is not beyond its end", placed.front.reach >= 0)
