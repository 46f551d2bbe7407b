"""What docs/designs.md has from the code: what each design costs, and what happens without a margin."""

from __future__ import annotations

from collections.abc import Callable

from properties.contracts.designs import PRINTED, cost_of_a_look_up, cost_of_a_move, walked_into
from properties.pages import with_part
from reference.designs import Cost
from spec.designs import DESIGNS, Design, Part
from spec.profiles import THESIS

BEGIN = "<!-- costs: counted -->\n"
END = "<!-- costs: end -->\n"


def with_costs(page: str) -> str:
    """A page with the table and the example between its two marks made anew."""
    return with_part(page, BEGIN, f"\n{table()}\n{example()}\n", END)


def table() -> str:
    """Table 4.2, each row as printed and as counted."""
    rows: tuple[tuple[str, Callable[[Design], Cost]], ...] = (
        ("a move, as printed", lambda design: PRINTED[design.id][0]),
        ("a move, as counted", lambda design: cost_of_a_move(THESIS, design, bodies=1, pushed=0)),
        ("a look-up, as printed", lambda design: PRINTED[design.id][1]),
        ("a look-up, as counted", lambda design: cost_of_a_look_up(THESIS, design, Part.LEFT)),
    )
    names = " | ".join(f"`{design.id}`" for design in DESIGNS)
    lines = [f"| | {names} |", "|---|" + "---|" * len(DESIGNS)]
    lines += [f"| {name} | {' | '.join(str(cost(design)) for design in DESIGNS)} |" for name, cost in rows]
    return "\n".join(lines) + "\n"


def example() -> str:
    """Two bodies in floats without a margin, one of which walks into the other."""
    walk = walked_into(THESIS)
    (left, right), (b_left, b_right), (first, second) = walk.a, walk.b, walk.asked
    return (
        f"In floats, without a margin: A is from {left} to {right}, B from {b_left} to {b_right}. A is\n"
        f"asked {first}, and pushes B. Now A's right border is at {walk.right}, and B's left border at\n{walk.left}. "
        f"A is asked {second} more, looks for borders ahead of its own, sees none, and ends with\nits right border at "
        f"{walk.end}."
    )
