"""The claims about one string of ground edges, under the profile `thesis`."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from properties.claims.claim import Claim, Count, Erratum, Obligation, Verdict
from properties.contracts import counts, errata, families, judging, leaving, lemma, request, rows, strings, ticks
from properties.contracts.contract import (
    LEAVING,
    REAR,
    REQUEST,
    REQUEST_EXACT,
    SEGMENT,
    SEGMENT_EXACT,
    Contract,
)
from properties.given import Given
from spec.conditions import EDGES_LONG, FREE_SPACE, HALF_ROUND, HALVES_LONG, IN_ORDER, MARGINS_KEPT, ONE_STRING
from spec.graph import Direction
from spec.invariants import (
    ADDITIVE,
    AS_FAR_AS_POSSIBLE,
    AT_MOST_ASKED,
    BYSTANDERS,
    CLOSED_FORM,
    DETERMINISM,
    DIRECTION,
    EDGE_SPLIT,
    FULL_CIRCLE,
    MARGINS_OVER_TIME,
    MIRROR,
    NO_OVERLAP,
    ON_GRAPH,
    ORDER,
    ORDER_OVER_TIME,
    RIGID_WIDTH,
    RULE_COUNT,
    TERMINATION,
    TRANSLATION,
    Invariant,
    Relation,
)
from spec.profiles import THESIS, AnyProfile, Profile

PROVED, BOUNDED, TESTED, REFUTED = Verdict.PROVED, Verdict.BOUNDED, Verdict.TESTED, Verdict.REFUTED


ORDERED, KEPT, LONG, FREE = IN_ORDER.id, MARGINS_KEPT.id, EDGES_LONG.id, FREE_SPACE.id
HALF, HALVES, STRING = HALF_ROUND.id, HALVES_LONG.id, ONE_STRING.id
ON_EXACT = (REQUEST_EXACT, SEGMENT, SEGMENT_EXACT)


def of_rules(program: Callable[[Any, Given], None], *needs: str, contracts: tuple[Contract, ...] = ()) -> Obligation:
    """An obligation on the rules, for any number of bodies and edges."""

    def of_profile(profile: AnyProfile, given: Given) -> None:
        program(profile.rules, given)

    return Obligation(name_of(program), of_profile, needs, contracts=tuple(one.id for one in contracts))


def name_of(program: Callable[..., object]) -> str:
    """The ID of an obligation: the chapter, then what it shows."""
    return f"{program.__module__.rpartition('.')[2]}/{program.__name__.replace('_', '-')}"


def of_strings(program: Callable[..., None], closed: bool, *needs: str, **more: Any) -> Obligation:
    """An obligation on strings of any number of edges and bodies, all but the ones it speaks of summed up."""

    def of_profile(profile: Profile, given: Given) -> None:
        program(profile, given, closed=closed, **more)

    extra = "".join(
        f", {name.replace('_', ' ')} {getattr(value, 'name', value)}" for name, value in more.items()
    ).lower()
    return Obligation(f"{name_of(program)} ({'ring' if closed else 'line'}{extra})", of_profile, (STRING, *needs))


def of_rows(
    program: Callable[..., None],
    bodies: int,
    edges: int,
    closed: bool,
    *needs: str,
    **more: Any,
) -> Obligation:
    """An obligation on whole strings of a fixed size."""
    shape = "ring" if closed else "line"
    extra = "".join(f", {getattr(value, 'name', value)}" for value in more.values()).lower()

    def of_profile(profile: Profile, given: Given) -> None:
        program(profile, given, bodies=bodies, edges=edges, closed=closed, **more)

    name = f"rows/{program.__name__.replace('_', '-')} ({bodies} on a {shape} of {edges}{extra})"
    return Obligation(name, of_profile, (STRING, *needs), shape, bodies)


ONE_RULE = tuple(
    of_rules(program)
    for program in (
        families.clearance_has_one,
        families.push_has_one,
        families.contact_has_one,
        families.walk_has_one,
        families.fit_has_one,
    )
)
SEGMENT_KEEPS = of_rules(request.segment_keeps_its_contract, ORDERED, contracts=(REQUEST, SEGMENT))
KEEPS_MARGIN = of_rules(request.segment_keeps_margin, KEPT, LONG, contracts=(REQUEST, SEGMENT_EXACT))
EXACT = of_rules(request.segment_exact, STRING, KEPT, LONG, contracts=(REQUEST, REQUEST_EXACT, SEGMENT_EXACT))
IS_SEGMENTS = of_rules(request.request_is_its_segments, ORDERED, contracts=(REQUEST, SEGMENT, LEAVING))
REAR_WALKS = of_rules(request.rear_walks_on, ORDERED, contracts=(REAR, SEGMENT))
REAR_FOLLOWS = of_rules(request.rear_follows_by_the_same, ORDERED, contracts=(REAR,))
FUNCTION = of_rules(request.segment_is_a_function, ORDERED, contracts=(REQUEST, SEGMENT))
LEAVES = of_rules(leaving.leaving_keeps_its_contract, contracts=(LEAVING,))
IN_A_ROW = of_rules(request.segments_in_a_row, ORDERED, contracts=(SEGMENT,))
KEEPS = of_rules(request.request_keeps_its_contract, ORDERED, contracts=(REQUEST, SEGMENT))
EXACT_IN_A_ROW = of_rules(request.exact_segments_in_a_row, STRING, KEPT, LONG, contracts=ON_EXACT)
KEEPS_EXACT = of_rules(request.request_exact, STRING, KEPT, LONG, contracts=ON_EXACT)
TWO_ARE_ONE = of_rules(lemma.two_requests_are_one, KEPT, LONG, FREE, contracts=(REQUEST, REQUEST_EXACT))
IN_ORDER_AGAIN = of_rules(lemma.neighbours_stay_in_order, ORDERED, contracts=(REQUEST,))
APART_AGAIN = of_rules(lemma.neighbours_stay_apart, KEPT, LONG, contracts=(REQUEST_EXACT,))
AS_WIDE = of_rules(lemma.width_is_kept, contracts=(REQUEST,))
CIRCLE = of_rules(lemma.full_circle_stands, KEPT, LONG, contracts=(REQUEST, REQUEST_EXACT, SEGMENT_EXACT))
TICK = Obligation(name_of(ticks.tick_is_its_requests), ticks.tick_is_its_requests, contracts=(REQUEST.id, SEGMENT.id))
WHOLE_REQUEST = (*ONE_RULE, SEGMENT_KEEPS, IN_A_ROW, IS_SEGMENTS, KEEPS, REAR_WALKS, REAR_FOLLOWS, LEAVES)
EXACT_REQUEST = (*WHOLE_REQUEST, EXACT, EXACT_IN_A_ROW, KEEPS_EXACT)

LINE_AND_RING = (False, True)
ALIKE = tuple((closed, one_edge) for closed in LINE_AND_RING for one_edge in (True, False))
SUMS = tuple(of_strings(strings.lay_out_sums_up, closed, one_edge=one_edge) for closed, one_edge in ALIKE)
MIRRORED = tuple(of_strings(strings.mirror_image_is_alike, closed, one_edge=one_edge) for closed, one_edge in ALIKE)
SPLIT = tuple(
    of_strings(strings.split_is_alike, closed, HALVES, one_edge=one_edge, cut=cut)
    for closed, one_edge in ALIKE
    for cut in range(3 if one_edge else 5)
)
LAWS = tuple(
    of_strings(strings.laws_hold, closed, ORDERED, direction=direction, last=last)
    for closed in LINE_AND_RING
    for last in (False, True)
    for direction in Direction
)

WHOLE_ROWS = (
    *(
        of_rows(rows.rows_keep_the_invariants, bodies, edges, closed, KEPT, LONG, direction=direction, mover=mover)
        for bodies, edges, closed in ((2, 2, False), (2, 1, True), (3, 1, False))
        for direction in (Direction if bodies == 2 and not closed else (Direction.RIGHT,))
        for mover in range(bodies)
    ),
    *(
        of_rows(program, *size, KEPT, LONG)
        for program in (rows.neighbours_are_lawful, rows.mirror_has_the_same_facts)
        for size in ((4, 1, True), (3, 2, False))
    ),
)
TRANSLATED = Obligation("rows/translation-keeps-extents", rows.translation_keeps_extents)


def holds(
    about: Invariant | Relation,
    family: str,
    premises: tuple[str, ...],
    *obligations: Obligation,
    expected: Verdict = PROVED,
) -> Claim:
    """The claim that an invariant holds under the premises."""
    name = about.id.removeprefix("invariant/")
    return Claim(
        id=f"claim/{name}",
        family=family,
        sentence=about.sentence,
        source=about.source,
        about=about.id,
        profile=THESIS,
        premises=(STRING, *premises),
        expected=expected,
        obligations=obligations,
        sampled="rows",
    )


def refuted(
    name: str, about: str, sentence: str, source: str, premises: tuple[str, ...], erratum: Erratum, long: bool = False
) -> Claim:
    """A claim that is expected to be refuted by a witness."""
    assumed = (STRING, *premises)
    return Claim(
        f"claim/{name}", "errata", sentence, source, about, THESIS, assumed, REFUTED, erratum=erratum, long=long
    )


def counted(name: str, about: str, sentence: str, source: str, program: Callable[[Profile], int]) -> Claim:
    """A claim on counted work, tested on many rows exactly."""
    count = Count(f"counts/{program.__name__.replace('_', '-')}", program)
    return Claim(f"claim/{name}", "work", sentence, source, about, THESIS, (), TESTED, counts=(count,))


CLAIMS: tuple[Claim, ...] = (
    holds(NO_OVERLAP, "safety", (KEPT, LONG), *WHOLE_REQUEST, KEEPS_MARGIN),
    holds(ORDER, "safety", (ORDERED,), *WHOLE_REQUEST),
    holds(TERMINATION, "termination", (ORDERED,), *WHOLE_REQUEST),
    holds(RULE_COUNT, "termination", (ORDERED, HALF), expected=TESTED),
    holds(RIGID_WIDTH, "safety", (ORDERED,), *WHOLE_REQUEST),
    holds(ON_GRAPH, "safety", (ORDERED,), *WHOLE_REQUEST),
    holds(AT_MOST_ASKED, "movement", (ORDERED, HALF), *WHOLE_REQUEST),
    holds(DIRECTION, "movement", (ORDERED, HALF), *WHOLE_REQUEST),
    holds(BYSTANDERS, "movement", (KEPT, LONG, HALF), *EXACT_REQUEST),
    holds(AS_FAR_AS_POSSIBLE, "movement", (KEPT, LONG), *EXACT_REQUEST),
    holds(CLOSED_FORM, "movement", (KEPT, LONG, HALF), *EXACT_REQUEST),
    holds(FULL_CIRCLE, "termination", (KEPT, LONG), *EXACT_REQUEST, CIRCLE),
    holds(MARGINS_OVER_TIME, "safety", (KEPT, LONG), *EXACT_REQUEST, APART_AGAIN, TICK),
    holds(ORDER_OVER_TIME, "safety", (ORDERED,), *WHOLE_REQUEST, IN_ORDER_AGAIN, AS_WIDE, TICK),
    holds(DETERMINISM, "movement", (ORDERED,), *WHOLE_REQUEST, FUNCTION),
    holds(ADDITIVE, "relations", (KEPT, LONG, FREE), *EXACT_REQUEST, TWO_ARE_ONE),
    holds(MIRROR, "relations", (KEPT, LONG, HALF), *EXACT_REQUEST, *SUMS, *MIRRORED),
    holds(EDGE_SPLIT, "relations", (KEPT, LONG, HALVES, HALF), *EXACT_REQUEST, *SUMS, *SPLIT),
    holds(TRANSLATION, "relations", (ORDERED, HALF), *WHOLE_REQUEST, TRANSLATED),
    Claim(
        id="claim/one-rule-applies",
        family="rules",
        sentence="Within each family, exactly one rule applies in every situation.",
        source="6.2.1; R5",
        about="rules",
        profile=THESIS,
        premises=(),
        expected=PROVED,
        obligations=ONE_RULE,
    ),
    Claim(
        id="claim/world-is-lawful",
        family="reference",
        sentence="The reference world keeps the laws that the contracts take for granted of a world.",
        source="4.3.1, 6.1.3; R7, R14",
        about="world",
        profile=THESIS,
        premises=(STRING, ORDERED),
        expected=PROVED,
        obligations=(*SUMS, *LAWS),
    ),
    Claim(
        id="claim/whole-rows",
        family="reference",
        sentence="Requests of whole small rows, run without contracts from beginning to end, keep every invariant.",
        source="6.2.1; R5, R20",
        about="invariants",
        profile=THESIS,
        premises=(STRING, KEPT, LONG),
        expected=BOUNDED,
        obligations=WHOLE_ROWS,
    ),
    counted(
        "queries-of-a-push",
        "push",
        "Pushing k bodies on one edge costs k + 1 collision queries, whatever else is in the level.",
        "7.1.1, 6.2.1; E4, E5, O5",
        counts.queries_of_a_push,
    ),
    counted(
        "queries-at-transitions",
        "clearance",
        "A request looks once on each edge that its front border moves on, so the edge after it is looked at twice.",
        "6.2.1, 7.1.1; E13",
        counts.queries_at_transitions,
    ),
    counted(
        "long-strings",
        "walk",
        "A request goes over as many edges, and a chain over as many bodies, as there are.",
        "6.2.1a, 4.2; R6, R18",
        counts.long_strings,
    ),
    counted(
        "walls-reached-exactly",
        "walk/wall",
        "A body that meets a wall stands exactly at the end of its edge, in floats too.",
        "6.2.1b; R19",
        counts.walls_are_reached,
    ),
    counted(
        "every-rule-fires",
        "rules",
        "Every rule fires in a scenario of the library.",
        "6.2.1; R5",
        counts.every_rule_fires,
    ),
    counted(
        "invariants-judge",
        "invariants",
        "Of each deed of a bank of right and wrong ones, each invariant says what is to be said of it.",
        "6.2.1; R5, R24",
        judging.invariants_judge,
    ),
    refuted(
        "no-overlap-on-short-edges",
        NO_OVERLAP.id,
        "The margin is kept however short the edges are.",
        "6.2.1; A12",
        (KEPT,),
        errata.margin_with_short_edges,
        long=True,
    ),
    refuted(
        "pushing-on-short-edges",
        AS_FAR_AS_POSSIBLE.id,
        "Whoever moves is pushed in contact, and the mover moves as far as possible, however short the edges are.",
        "6.2.1; A12",
        (KEPT,),
        errata.pushes_with_short_edges,
        long=True,
    ),
    refuted(
        "split-anywhere",
        EDGE_SPLIT.id,
        "Splitting an edge changes no movement, wherever it is split.",
        "6.2.1a; A12",
        (KEPT, LONG),
        errata.split_anywhere,
        long=True,
    ),
    refuted(
        "additive-on-any-ring",
        ADDITIVE.id,
        "On a ring, two requests do what one of their sum does, whatever the distance.",
        "4.2; A7",
        (KEPT, LONG),
        errata.additive_on_any_ring,
    ),
    refuted(
        "neighbours-not-twice",
        "push",
        "The list of left and right neighbours does not contain a body twice.",
        "4.2; E11",
        (KEPT, LONG),
        errata.neighbours_are_two,
    ),
    refuted(
        "loops-only-on-a-full-circle",
        "push/limit",
        "A chain of requests comes round to its mover only on a circle fully filled with bodies.",
        "4.2; E11, R31",
        (KEPT, LONG),
        errata.loops_only_on_a_full_circle,
    ),
    refuted(
        "constant-speed-in-contact",
        "reading/touching-characters",
        "Two characters under one key move at constant speed, also while they touch.",
        "1.1; R1, A53",
        (KEPT, LONG),
        errata.one_step_a_tick,
    ),
)
