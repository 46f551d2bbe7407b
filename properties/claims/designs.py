"""The claims about the designs of a graphbody (4.3): where they agree, what they cost, what a margin is for."""

from __future__ import annotations

from collections.abc import Callable

from properties.claims.claim import Claim, Count, Erratum, Obligation, Verdict
from properties.claims.string import KEPT, LONG, ORDERED, STRING, name_of, of_rows, of_strings
from properties.contracts import designs, discrete
from spec.designs import DESIGNS, ONE, THREE, Design
from spec.discrete import DISCRETE
from spec.graph import Direction
from spec.profiles import REPAIRED, THESIS, AnyProfile, Profile

PREMISES = (STRING, KEPT, LONG)


def alike(design: Design, bodies: int, edges: int, closed: bool, mover: int) -> Obligation:
    """A design moves bodies to the right as the rules do, on strings of a size."""
    more = {"design": design, "mover": mover, "direction": Direction.RIGHT}
    return of_rows(designs.designs_agree, bodies, edges, closed, KEPT, LONG, **more)


def counted(name: str, about: str, sentence: str, source: str, program: Callable[[Profile], int]) -> Claim:
    """A claim that is tested by counting."""
    counts = (Count(name_of(program), program),)
    return Claim(f"claim/{name}", "designs", sentence, source, about, THESIS, (), Verdict.TESTED, counts=counts)


def refuted(name: str, about: str, sentence: str, source: str, premises: tuple[str, ...], erratum: Erratum) -> Claim:
    """A claim that is expected to be refuted by a witness."""
    return Claim(f"claim/{name}", "errata", sentence, source, about, THESIS, premises, Verdict.REFUTED, erratum=erratum)


def enumerated(
    name: str, about: str, sentence: str, program: Callable[[AnyProfile], int], bodies: int, long: bool = False
) -> Claim:
    """A claim about the discrete sibling: all its turns up to a size are gone through."""
    counts = (Count(name_of(program), program, bodies),)
    source = "4.1.2, 8.0.1; O13"
    return Claim(
        f"claim/{name}", "designs", sentence, source, about, REPAIRED, (), Verdict.BOUNDED, counts=counts, long=long
    )


CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="claim/designs-agree",
        family="designs",
        sentence="On a string without ledges, every design moves every border to the same place.",
        source="4.3.2; E9",
        about="design",
        profile=THESIS,
        premises=PREMISES,
        expected=Verdict.BOUNDED,
        obligations=tuple(
            alike(design, bodies, edges, False, mover)
            for design in DESIGNS
            for bodies, edges in ((1, 2), (2, 1), (3, 1))
            for mover in range(bodies)
        ),
        counts=(Count("designs/random-rows", designs.designs_agree_on_random_rows),),
    ),
    Claim(
        id="claim/designs-agree-on-rings",
        family="designs",
        sentence="On a ring, and over a vertex while it pushes, every design moves every border to the same place.",
        source="4.3.2; E9",
        about="design",
        profile=THESIS,
        premises=PREMISES,
        expected=Verdict.BOUNDED,
        obligations=tuple(
            alike(design, 2, edges, closed, mover)
            for design in DESIGNS
            for edges, closed in ((2, False), (1, True))
            for mover in range(2)
        ),
        long=True,
    ),
    Claim(
        id="claim/centres-are-lawful",
        family="designs",
        sentence="To a centre that leads, a string of any number of edges and bodies keeps the laws that a request "
        "takes for granted, with gaps and walls as far as they are from the borders.",
        source="4.3.2; E9, R7, R14",
        about=ONE.id,
        profile=THESIS,
        premises=(STRING, ORDERED),
        expected=Verdict.PROVED,
        obligations=tuple(
            of_strings(designs.centres_are_lawful, closed, ORDERED, direction=direction, last=last)
            for closed in (False, True)
            for last in (False, True)
            for direction in Direction
        ),
    ),
    counted(
        "designs-cost",
        "design",
        "A move costs M_C under 1EP, M_C + 2 M under 1EP cached and under 3EP, M_C + M under 2EP, for each body that "
        "moves; a look-up of a border costs M + L under 1EP and L under the others.",
        "4.3.2; E9, A46",
        designs.designs_cost,
    ),
    refuted(
        "three-cost-as-two",
        THREE.id,
        "A move costs as much under 3EP as under 2EP.",
        "4.3.2; E9, A46",
        PREMISES,
        designs.three_cost_as_two,
    ),
    refuted(
        "ledges-are-left-alike",
        ONE.id,
        "A body leaves a ledge under 1EP when it does under 2EP.",
        "4.3.2, 6.2.1d; E9, A14",
        (),
        designs.ledges_are_left_alike,
    ),
    counted(
        "margins-are-for-floats",
        "design",
        "Without a margin no bodies overlap in exact numbers, whatever the design. In floats, who looks for borders "
        "ahead walks into others, as 2EP and 3EP may; who looks for centres, as 1EP does, or knows the order of "
        "bodies, overlaps them by rounding alone. With a margin nobody does.",
        "4.3.2, 6.2.1; E14, A46, R24",
        designs.margins_are_for_floats,
    ),
    enumerated(
        "discrete-turns",
        "discrete",
        "In the discrete sibling bodies are one on each vertex and stand on something, keep their order, move by one "
        "vertex, and the one that is asked moves unless its row ends at a wall.",
        discrete.turns_keep_the_invariants,
        bodies=3,
    ),
    enumerated(
        "discrete-turns-are-steps",
        DISCRETE.id,
        "A turn ends as a step of `repaired` does in which the body is driven to the next column; columns are as wide "
        "as a body and the margin.",
        discrete.turns_are_steps,
        bodies=3,
    ),
    enumerated(
        "discrete-turns-are-steps-of-more",
        DISCRETE.id,
        "Turns of more bodies, on more columns and higher ground, end as steps of `repaired` do.",
        discrete.more_turns_are_steps,
        bodies=4,
        long=True,
    ),
)
