"""An exploration as a script in SMT-LIB 2, for any solver to decide.

What is asserted is that a promise is broken on a path, under the literals of that path; or, if the exploration came to
its end, that the paths and what premises cut off leave some values out. So a script is `unsat` exactly if the
explored program keeps its promises; no path that the explorer left out as infeasible is taken on trust. An exploration
that stopped at a counterexample is `sat`, by a broken promise alone.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, field

import z3

from properties.engine.explore import Exploration
from properties.engine.simplest import Drawn


@dataclass
class Script:
    """Lines written so far. What is said twice is defined once: paths share the definitions of where they have come."""

    renamed: list[tuple[z3.ExprRef, z3.ExprRef]]
    lines: list[str] = field(default_factory=list)
    names: dict[str, str] = field(default_factory=dict)
    atoms: dict[int, str] = field(default_factory=dict)

    def term(self, formula: z3.BoolRef) -> str:
        """A formula as Z3 writes it, on one line, with names that every solver reads."""
        return " ".join(z3.substitute(formula, *self.renamed).sexpr().split())

    def name(self, prefix: str, text: str) -> str:
        """The name of what a text says, which is defined where it is said first."""
        if text not in self.names:
            self.names[text] = f"{prefix}{len(self.names)}"
            self.lines.append(f"(define-fun {self.names[text]} () Bool {text})")
        return self.names[text]

    def literal(self, formula: z3.BoolRef) -> str:
        """A literal, by the name of its atom. The exploration holds the formulas, so that their IDs stay theirs."""
        if z3.is_not(formula):
            return f"(not {self.literal(formula.arg(0))})"
        known = self.atoms.get(formula.get_id())
        if known is None:
            known = self.atoms[formula.get_id()] = self.name("atom", self.term(formula))
        return known

    def place(self, literals: Iterable[z3.BoolRef]) -> str:
        """The name of where some literals lead."""
        here = "true"
        for literal in literals:
            here = self.name("place", f"(and {here} {self.literal(literal)})")
        return here


def any_of(texts: Iterable[str]) -> str:
    """That one of some formulas holds."""
    parts = list(dict.fromkeys(texts))
    return f"(or {' '.join(parts)})" if len(parts) > 1 else next(iter(parts), "false")


def renaming(drawn: Drawn) -> list[tuple[z3.ExprRef, z3.ExprRef]]:
    """Each variable drawn, and the same under a name of its own that needs no quotes and is no reserved word."""
    variables = [*drawn.numbers.values(), *drawn.naturals.values(), *drawn.flags.values()]
    plain = [re.sub(r"[^A-Za-z0-9]+", "_", str(variable)) for variable in variables]
    return [(v, z3.Const(f"v{i}_{name}", v.sort())) for i, (v, name) in enumerate(zip(variables, plain, strict=True))]


def status_of(exploration: Exploration) -> str:
    """What a solver is expected to answer."""
    outcome = exploration.outcome
    if outcome.counterexample is not None:
        return "sat"
    return "unknown" if outcome.open else "unsat"


def script_of(exploration: Exploration, about: str) -> str:
    """The script of an exploration that is over; `about` says of what, without any bar."""
    assert not exploration.definitions, "an exploration that merges is not exported"
    script, status = Script(renaming(exploration.drawn)), status_of(exploration)
    broken = [
        script.name("broken", f"(and {script.place(judged.literals)} {any_of(map(script.literal, judged.denials))})")
        for judged in exploration.judged
    ]
    left_out = [] if status == "sat" else [f"(not {any_of(map(script.place, exploration.covered))})"]
    head = [
        "(set-info :smt-lib-version 2.6)",
        f"(set-info :source |{about}|)",
        f"(set-info :status {status})",
        "(set-logic QF_LIRA)",
        *(f"(declare-const {new} {new.sort()})" for _, new in script.renamed),
        *(f"(assert {script.term(sign)})" for sign in exploration.drawn.signs()),
    ]
    tail = [f"(assert {any_of([*broken, *left_out])})", "(check-sat)", "(exit)"]
    return "\n".join([*head, *script.lines, *tail, ""])
