"""The display put together: its readings, and the rules of a display step under each profile."""

from __future__ import annotations

from spec.profiles import PROFILES, SteppedProfile
from spec.readings import Reading, reading
from spec.rule import AnyRule
from spec.rules.display import (
    ACROSS,
    ROTATION,
    VERTICAL,
    DisplayRules,
    Sinking,
    by_the_time_fallen,
    by_the_way_fallen,
)

SINKING: Reading[Sinking] = Reading(
    id="reading/sinking",
    sentence="In each display step, one for each tick, a body that is shown falling sinks by the time since its fall "
    "began, times the fall speed.",
    source="6.4.1; R29, A44",
    others="one display step for each frame, under which a fall is the faster the more frames there are",
    choice=by_the_time_fallen,
)

SINKING_REPAIRED: Reading[Sinking] = Reading(
    id="reading/repaired/sinking",
    sentence="A body that is shown falling has sunk by the square of the time since its fall began, times the fall "
    "speed, however that time is cut into display steps.",
    source="6.4.1; R29, A44",
    others="by the time, in each display step",
    choice=by_the_way_fallen,
)

SHOWN_FALLING = reading(
    "shown-falling",
    "A body is shown falling and turning from each fall and each jump on, of whatever height, until it is "
    "shown at its target.",
    "6.4.1, 6.4.2; R29, O10",
    "for ever, so that one that never fell is at its target at once; not from jumps",
)

SHOWN_SUPPORT = reading(
    "shown-support",
    "The target of a body on a top is on that top as it is shown, so that a rider is shown falling with its "
    "support, and nobody is shown inside the body it stands on.",
    "6.1.2, 6.4.1; R12, R29",
    "on the top as it is simulated, under which a body that steps onto one that is still shown falling is shown "
    "inside it; as it is, it is shown rising (claim/nobody-is-shown-rising)",
)

SHOWN_ARC = reading(
    "circular-length",
    "On a circular level the length of an edge is that of its chord, as the graph measures it; what is shown "
    "goes along the arc, and is faster by as much as the arc is longer.",
    "6.1.2; R13, A43",
    "the length of the arc",
)

OF_DISPLAY: tuple[Reading[object], ...] = (SINKING, SINKING_REPAIRED, SHOWN_FALLING, SHOWN_SUPPORT, SHOWN_ARC)

THESIS_DISPLAY = DisplayRules(VERTICAL, ACROSS, ROTATION, SINKING.choice)
REPAIRED_DISPLAY = DisplayRules(VERTICAL, ACROSS, ROTATION, SINKING_REPAIRED.choice)

DISPLAYS: dict[str, DisplayRules] = {
    name: REPAIRED_DISPLAY if isinstance(profile, SteppedProfile) else THESIS_DISPLAY
    for name, profile in PROFILES.items()
}
"""The rules of a display step, by the name of the profile."""

DISPLAY_RULES: tuple[AnyRule, ...] = (*VERTICAL.rules, *ACROSS.rules, *ROTATION.rules)
