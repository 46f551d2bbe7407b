"""The claims about the display: smooth falls and rotations, and circular interpolation."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from properties.claims.claim import Claim, Count, Erratum, Obligation, Verdict
from properties.claims.string import name_of
from properties.contracts import display
from properties.given import Given
from spec.display import DISPLAYS, SHOWN_FALLING, SHOWN_SUPPORT, SINKING, SINKING_REPAIRED
from spec.profiles import REPAIRED, THESIS, AnyProfile
from spec.rules.display import DisplayRules

Program = Callable[[DisplayRules, Given], None]


def of_display(program: Program) -> Obligation:
    """An obligation on the rules of a display step, for any body."""

    def of_profile(profile: AnyProfile, given: Given) -> None:
        program(DISPLAYS[profile.name], given)

    return Obligation(name_of(program), of_profile)


def proved(name: str, about: str, sentence: str, source: str, *programs: Program) -> Claim:
    """A claim about any display steps, proved by obligations that assume nothing of a level."""
    obligations = tuple(map(of_display, programs))
    return Claim(f"claim/{name}", "display", sentence, source, about, THESIS, (), Verdict.PROVED, obligations)


def counted(
    name: str, about: str, sentence: str, source: str, program: Callable[[Any], int], profile: AnyProfile = THESIS
) -> Claim:
    """A claim that is tested on many numbers."""
    counts = (Count(name_of(program), program),)
    return Claim(f"claim/{name}", "display", sentence, source, about, profile, (), Verdict.TESTED, counts=counts)


def refuted(name: str, about: str, sentence: str, source: str, erratum: Erratum) -> Claim:
    """A claim that is expected to be refuted by a witness."""
    return Claim(f"claim/{name}", "errata", sentence, source, about, THESIS, (), Verdict.REFUTED, erratum=erratum)


CLAIMS: tuple[Claim, ...] = (
    proved(
        "one-display-rule-applies",
        "display",
        "Within each family that a display step chooses from, exactly one rule applies in every situation.",
        "6.4; R29",
        display.vertical_has_one,
        display.across_has_one,
        display.rotation_has_one,
    ),
    proved(
        "falls-are-smooth",
        "display/sinks",
        "In any number of display steps, a body is never shown below its target, is raised at most to it, and sinks "
        "by no more than its sinking; horizontally it is shown where it is.",
        "6.4.1, 1.2; R29, R33",
        display.falls_are_smooth,
        display.places_are_at_once,
    ),
    proved(
        "falls-arrive",
        "display/lands",
        "A body that is shown falling to a target that stays is at it after the first display step after which its "
        "sinkings add up to its height above it.",
        "6.4.1; R29",
        display.falls_add_up,
        display.falls_arrive,
    ),
    counted(
        "falls-end",
        "display/lands",
        "A fall of height h is shown in the least n display steps for which n (n + 1) / 2 times the tick times the "
        "fall speed is h or more.",
        "6.4.1; R29, A44",
        display.falls_end,
    ),
    counted(
        "cuts-do-not-matter",
        SINKING_REPAIRED.id,
        "How far a body has sunk after a time does not depend on how that time is cut into display steps.",
        "6.4.1; R29, A44",
        display.cuts_do_not_matter,
        REPAIRED,
    ),
    refuted(
        "frames-do-not-matter",
        SINKING.id,
        "A fall is shown as fast, whether a tick is one display step or two.",
        "6.4.1; R29, A44",
        display.frames_do_not_matter,
    ),
    refuted(
        "nobody-is-shown-rising",
        SHOWN_SUPPORT.id,
        "A body that does not rise is not shown rising, though the top that it steps onto be shown falling still.",
        "6.4.1; R29, R33",
        display.nobody_is_shown_rising,
    ),
    proved(
        "shown-upon-support",
        "reading/shown-support",
        "A body is never shown inside the one that it stands on, and one that falls with its support stays upon it.",
        "6.1.2, 6.4.1; R12, R29",
        display.riders_stay_on_top,
    ),
    proved(
        "turns-are-smooth",
        "display/turns-left",
        "A body that is shown turning comes nearer to its target by the turning speed and never goes past it; it is "
        "there after the first display step after which its turnings add up to the way.",
        "6.4.2; O10, R35",
        display.turns_are_smooth,
        display.turns_add_up,
    ),
    counted(
        "display-rules-fire",
        "display",
        "Every rule of the display is needed to show a scenario of the library in which bodies fall onto slopes.",
        "6.4; R29, O10",
        display.every_display_rule_fires,
    ),
    counted(
        "nobody-drops-unseen",
        SHOWN_FALLING.id,
        "On storeys nobody is lowered on the screen but by sinking: whoever comes down is told to fall or to jump, or "
        "stands on one who is.",
        "6.4.1, 1.2; R29, R33, O10",
        display.nobody_drops_unseen,
        REPAIRED,
    ),
    counted(
        "circles-are-even",
        "model/interpolation",
        "Interpolated circularly, the distance from the origin changes evenly. Between points as far from it, and "
        "only there, what moves evenly is shown moving evenly; it goes further than the chord that the graph measures.",
        "6.1.2; R13, A43",
        display.circles_are_even,
    ),
)
