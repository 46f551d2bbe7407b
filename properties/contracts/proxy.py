"""What the test of jump edges stands for: whether the landing is free (6.2.1; E12, P9).

The thesis compares the horizontal distance of a jump edge with the width, as "a good proxy". On level ground at the
foot of a vertical fall edge, that is to be exact; on slanted fall edges and tilted ground it is not.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from properties.contracts.errata import RIGHT, Stage
from properties.evidence.deeds import do
from properties.given import HAS_WIDTH, Given
from properties.worlds.scenes import ONE, fall_edge, ground_edge
from reference.world import World
from spec.body import Body, EdgePosition, Level
from spec.case import Fired, mover_in_body
from spec.graph import Edge, EdgeType, Graph, Vertex
from spec.invariants import Deed
from spec.number import Truth
from spec.plane import negated
from spec.profiles import Profile

DOWN = Fraction(12, 5)
"""How high a fall edge of 5-12-13 is that leads one unit to the side."""


def falls_only_where_free(deed: Deed[Any], fired: Fired) -> Truth:
    """Who falls comes down in nobody; who jumps from the ground onto a body at the foot would have fallen into it."""
    if "leave/fall" in fired:
        return negated(mover_in_body(deed))
    return would_not_fit(deed) if "leave/jump" in fired else True


def would_not_fit(deed: Deed[Any]) -> Truth:
    """Whether the body jumped onto begins less than the mover's width from the foot, if it stands there, on its string.

    Distances are those along the graph, as widths are.
    """
    before: Any = deed.before
    after: Any = deed.after
    view, below = before.facing(deed.direction), after.support(deed.body)
    foot = view.foot(view.rear(deed.body))
    if foot is None or below is None or after.row_of_edge[foot.edge] is not after.row(below):
        return True
    return bool(after.facing(deed.direction).gap(foot, below) < before.width(deed.body))


def a_ledge_and_a_box(given: Given, stage: Stage, drop: Fraction, fall: Edge[Any], below: Edge[Any]) -> World[Any]:
    """A body at a ledge, and one on the ground at the foot of a fall edge; both grounds of any length."""
    margin, upper = given.number("margin"), given.number("length of the upper ground")
    given.assume(margin > 0, "the margin is positive")
    far = upper + fall.length * fall.run
    end = Vertex(far + below.length * below.run, below.length * below.rise)
    vertices = (Vertex(margin * 0, drop), Vertex(upper, drop), Vertex(far, margin * 0), end)
    graph = Graph(vertices, (ground_edge(0, 1, upper), fall, below))
    bodies = []
    for name, edge, length in (("A", 0, upper), ("B", 2, below.length)):
        left, width = given.number(f"left of {name}"), given.number(f"width of {name}")
        given.assume(width > margin, HAS_WIDTH)
        given.assume(left + width <= length, "bodies stand on the ground")
        bodies.append(Body(name, EdgePosition(edge, left), EdgePosition(edge, left + width), Fraction(0), height=ONE))
    return stage.set(Level(graph, margin, ONE, tuple(bodies)))


def judge(profile: Profile, given: Given, stage: Stage, world: World[Any]) -> None:
    """Ask the body at the ledge to move, and promise that the test of jump edges is right."""
    asked = given.number("distance asked")
    stage.steps.append(("A", asked))
    deed, record = do(profile, world, 0, RIGHT, asked, asked * 0)
    fired = frozenset(rule for body, rule in record.fired if body == 0)
    given.ensure("the landing is free just where a body falls", falls_only_where_free(deed, fired))


def proxy_on_slanted_falls(profile: Profile, given: Given, stage: Stage) -> None:
    """A body falls down a slanted fall edge only where the landing is free."""
    slanted = Edge(1, 2, EdgeType.FALL, Fraction(13, 5), run=Fraction(5, 13), rise=Fraction(-12, 13))
    below = ground_edge(2, 3, given.number("length of the lower ground"))
    judge(profile, given, stage, a_ledge_and_a_box(given, stage, DOWN, slanted, below))


def proxy_on_tilted_landings(profile: Profile, given: Given, stage: Stage) -> None:
    """A body jumps onto one on tilted ground only where it would not have had room beside it."""
    length = given.number("length of the lower ground")
    tilted = Edge(2, 3, EdgeType.GROUND, length, run=Fraction(4, 5), rise=Fraction(-3, 5))
    judge(profile, given, stage, a_ledge_and_a_box(given, stage, ONE, fall_edge(1, 2, True, ONE), tilted))
