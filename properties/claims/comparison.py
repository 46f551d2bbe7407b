"""The claims that compare the profile `repaired` with `thesis`."""

from __future__ import annotations

from collections.abc import Callable

from properties.claims.claim import Claim, Count, Verdict
from properties.claims.string import KEPT, LONG, STRING, of_rows
from properties.comparison import campaign
from properties.contracts import alike
from properties.evidence import mended
from spec.graph import Direction
from spec.profiles import REPAIRED, THESIS, AnyProfile

SCENARIOS = 3_000


def differences_have_causes(profile: AnyProfile) -> int:
    """Each random scenario ends alike, or differs by a known cause; plain ones end alike."""
    tally = campaign.part(campaign.SEED, SCENARIOS)
    assert not tally.unexplained, f"without a cause: {tally.unexplained[0]}"
    assert not tally.tame, f"too few: {tally.tame[0]}"
    return tally.scenarios


def counted(name: str, about: str, sentence: str, source: str, program: Callable[[AnyProfile], int]) -> Claim:
    """A claim about what was counted under both profiles."""
    counts = (Count(name, program),)
    return Claim(f"claim/{name}", "comparison", sentence, source, about, REPAIRED, (), Verdict.TESTED, counts=counts)


CLAIMS: tuple[Claim, ...] = (
    Claim(
        id="claim/requests-end-alike",
        family="comparison",
        sentence="On a line without ledges, a request ends with every body at the same place under `repaired` as under "
        "`thesis`, if bodies are wider than the margin.",
        source="6.2.1a to c; R18, R19, R20, R24",
        about="model/step",
        profile=THESIS,
        premises=(STRING, KEPT, LONG),
        expected=Verdict.BOUNDED,
        obligations=tuple(
            of_rows(alike.requests_end_alike, bodies, edges, False, KEPT, LONG, mover=mover, direction=direction)
            for bodies, edges in ((1, 2), (2, 1), (3, 1))
            for mover in range(bodies)
            for direction in (Direction if bodies < 3 else (Direction.RIGHT,))
        ),
        long=True,
    ),
    counted(
        "differences-have-causes",
        "model/step",
        "Where a step ends otherwise under `repaired` than under `thesis`, one of the known differences is the cause; "
        "a request without riders, changes of support, overhang, short edges or a chain round a ring ends alike.",
        "6.2.1; R5, R17",
        differences_have_causes,
    ),
    counted(
        "witnesses-mended",
        "profile/repaired",
        "Every witness against what `thesis` does, and every scenario of an unsupported case, keeps under `repaired` "
        "what it broke, if its level is one of storeys.",
        "6.2.2, 6.6, 7.2; U1, U2, U3, U4, U5, U6, U7, U9",
        mended.witnesses_mended,
    ),
)
