"""The claims about what is left of the trouble without falls, collisions or width (8, 8.0.1; E8, E15)."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from properties.claims.claim import Claim, Hunt, Verdict
from properties.claims.string import of_rules
from properties.contracts import families, features
from properties.given import Given
from spec.conditions import GUIDELINES, NOBODY_RIDES, PLANE_START
from spec.features import COLLISIONS, FALLS, PLANE_ORDER, WIDTH, Feature
from spec.invariants import Deed, every
from spec.number import Truth
from spec.plane import IN_PLANE, negated
from spec.profiles import WITHOUT, Profile
from spec.rules.request import Rules
from spec.unsupported import PRINTED

Promise = Callable[[Deed[Any], frozenset[str]], Truth]
MOST_BODIES, MOST_EDGES = 2, 3
IN_TUNNELS = frozenset({"unsupported/tunnel", "unsupported/other-strings", "invariant/terrain"})
NEAR = frozenset({"invariant/plane-margin"})
LANDS_IN_PITS = frozenset(
    {"unsupported/short-pit", "unsupported/short-pit-heights", "unsupported/landing-does-not-fit"}
)

LEFT: dict[str, frozenset[str]] = {
    "thesis/no-falls": IN_TUNNELS | NEAR | {"invariant/plane-apart"},
    "thesis/no-collisions": IN_TUNNELS | LANDS_IN_PITS,
    "thesis/no-width": IN_TUNNELS | NEAR,
    "thesis/no-collisions/no-falls": IN_TUNNELS,
    "thesis/no-collisions/no-width": IN_TUNNELS,
    "thesis/no-falls/no-width": IN_TUNNELS | NEAR,
    "thesis/overshoot/no-collisions": IN_TUNNELS | LANDS_IN_PITS,
    "thesis/overshoot/no-width": IN_TUNNELS | NEAR | {PLANE_ORDER.id},
    "thesis/overshoot/no-collisions/no-width": IN_TUNNELS,
}
"""For each profile that does without features, what goes wrong nevertheless; the map has a witness for each."""

FROM_BODIES = frozenset({"unsupported/fall-off-body", "unsupported/overhang-from-body", "unsupported/sharp-ledge"})
WITH_RIDERS: dict[str, frozenset[str]] = {
    "thesis/no-falls": IN_TUNNELS,
    "thesis/no-collisions": FROM_BODIES,
}
"""What goes wrong where bodies stand on bodies at the start; of all else there nothing is claimed."""


def promises_of(profile: Profile) -> dict[str, Promise]:
    """What is asked of a profile, by ID: that no case happens, and what is promised of the plane."""
    asked: dict[str, Promise] = {case.id: partial(never, case.happened) for case in PRINTED}
    in_order = [PLANE_ORDER] if WIDTH in profile.without and COLLISIONS not in profile.without else []
    asked.update({invariant.id: partial(always, invariant.holds) for invariant in [*IN_PLANE, *in_order]})
    return {name: promise for name, promise in asked.items() if name not in profile.not_asked}


def never(happened: Promise, deed: Deed[Any], fired: frozenset[str]) -> Truth:
    """The promise that a case does not happen."""
    return negated(happened(deed, fired))


def always(holds: Callable[[Deed[Any]], Truth], deed: Deed[Any], fired: frozenset[str]) -> Truth:
    """The promise that an invariant holds, whatever fired."""
    return holds(deed)


def all_kept(profile: Profile) -> Promise:
    """The promise of all that is not left to go wrong. Of order there is a claim of its own, about a single layer."""
    left = LEFT[profile.name] | {PLANE_ORDER.id}
    promises = [one for name, one in promises_of(profile).items() if name not in left]

    def promise(deed: Deed[Any], fired: frozenset[str]) -> Truth:
        return every(one(deed, fired) for one in promises)

    return promise


def names(profile: Profile) -> str:
    """The features that a profile does without, as words."""
    return " and ".join(feature.name for feature in profile.without)


def gone(profile: Profile) -> Claim:
    """The claim that without some features nothing goes wrong but what is left."""
    left = ", ".join(sorted(LEFT[profile.name]))
    name = profile.name.removeprefix("thesis/")
    hunt = Hunt(
        f"features/{name}",
        all_kept(profile),
        guided=False,
        most_bodies=MOST_BODIES,
        most_edges=MOST_EDGES,
        riders=False,
        points=WIDTH in profile.without,
    )
    return Claim(
        f"claim/trouble-is-gone/{name}",
        "features",
        f"Without {names(profile)}, nothing fails of the unsupported cases and in the plane but {left}.",
        "8, 8.0.1; E8",
        profile.without[0].id,
        profile,
        (PLANE_START.id, NOBODY_RIDES.id),
        Verdict.BOUNDED,
        hunt=hunt,
        long=True,
    )


def immediate(name: str, feature: Feature, sentence: str, *programs: Callable[[Rules, Given], None]) -> Claim:
    """A claim about the rules that are left without a feature, proved of the rules themselves."""
    return Claim(
        f"claim/{name}",
        "features",
        sentence,
        "8.0.1; E8",
        feature.id,
        WITHOUT[f"thesis/no-{feature.name}"],
        (),
        Verdict.PROVED,
        tuple(of_rules(program) for program in programs),
    )


def order_id(profile: Profile) -> str:
    """The ID of the claim that bodies without width do not change their order under a profile."""
    suffix = profile.name.removeprefix("thesis").removesuffix("/no-width")
    return f"claim/order-without-width{suffix}"


def order(profile: Profile, expected: Verdict) -> Claim:
    """The claim that bodies without width do not change their order."""
    hunt = Hunt(
        "plane-order",
        lambda deed, fired: PLANE_ORDER.holds(deed),
        guided=True,
        most_bodies=MOST_BODIES,
        most_edges=MOST_EDGES,
        least_bodies=2,
        points=True,
    )
    return Claim(
        order_id(profile),
        "features",
        "Bodies without width do not change their order.",
        "8.0.1; E15, A15, A19",
        PLANE_ORDER.id,
        profile,
        (PLANE_START.id, GUIDELINES.id),
        expected,
        hunt=hunt,
        long=expected is Verdict.BOUNDED,
    )


CLAIMS: tuple[Claim, ...] = (
    immediate(
        "no-falls-no-leaving",
        FALLS,
        "Without falls a border does not go beyond the end of its string, and exactly one rule says how it walks.",
        families.walk_has_one,
        features.ledges_are_walls,
    ),
    immediate(
        "no-collisions-no-pushing",
        COLLISIONS,
        "Without collisions every stride is free, nobody is asked to make room, and exactly one rule says so.",
        families.clearance_has_one,
        features.nobody_is_in_the_way,
    ),
    immediate(
        "no-width-no-jumps",
        WIDTH,
        "Without width nothing obstructs a ledge, and every landing fits.",
        features.points_are_not_obstructed,
    ),
    order(WITHOUT["thesis/no-width"], Verdict.BOUNDED),
    order(WITHOUT["thesis/no-falls/no-width"], Verdict.BOUNDED),
    order(WITHOUT["thesis/overshoot/no-width"], Verdict.REFUTED),
    *(gone(profile) for profile in WITHOUT.values() if profile.name in LEFT),
)
