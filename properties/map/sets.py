"""Sets of conditions: the maximal that do not suffice, the minimal that do, and how the two determine each other.

Which sets of conditions do not suffice is closed downward. So it is known by its maximal members, and a set suffices
exactly if it has a member outside each of them: the minimal such sets are the minimal hitting sets of what these leave
out (Reiter 1987). The maximal ones are found as MARCO finds them (Liffiton et al. 2016), in
`properties.engine.survey`.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

Names = frozenset[str]


def maximal(sets: Iterable[Names]) -> list[Names]:
    """Those that are not part of another, each once, in their order."""
    all_of_them = list(dict.fromkeys(sets))
    return [one for one in all_of_them if not any(one < other for other in all_of_them)]


def minimal(sets: Iterable[Names]) -> list[Names]:
    """Those of which no other is a part, each once, in their order."""
    all_of_them = list(dict.fromkeys(sets))
    return [one for one in all_of_them if not any(other < one for other in all_of_them)]


def sufficient(names: Sequence[str], insufficient: Sequence[Names]) -> list[Names]:
    """The minimal sets of names that are part of none of the insufficient ones, the smallest first.

    There is none if all names together do not suffice.
    """
    found: list[Names] = [frozenset()]
    for one in insufficient:
        left_out = [name for name in names if name not in one]
        hit = [chosen for chosen in found if not chosen <= one]
        found = minimal([*hit, *(chosen | {name} for chosen in found if chosen <= one for name in left_out)])
    return sorted(found, key=lambda chosen: (len(chosen), [names.index(name) for name in names if name in chosen]))


def suffices(chosen: Iterable[str], insufficient: Iterable[Names]) -> bool:
    """Whether a set of names is part of none of the insufficient ones."""
    own = frozenset(chosen)
    return not any(own <= one for one in insufficient)
