"""Formulas of the solver: joined, told and asked without what its Python layer does to each argument of a call.

There each argument is converted, although what is joined here are formulas already; that was half of the work of an
exploration.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import z3


class EngineError(Exception):
    """The engine cannot vouch for its own run."""


def references(formulas: Sequence[z3.BoolRef]) -> Any:
    """The solver's own references to formulas."""
    return (z3.Ast * len(formulas))(*(formula.ast for formula in formulas))


def identity_of(formula: z3.BoolRef) -> int:
    """What equal formulas have in common as long as one of them is held."""
    return int(formula.ast.value)


def joined(join: Callable[..., Any], formulas: Sequence[z3.BoolRef]) -> z3.BoolRef:
    """Formulas of one context, of which there is at least one, joined."""
    context = formulas[0].ctx
    return z3.BoolRef(join(context.ref(), len(formulas), references(formulas)), context)


def conjunction(*formulas: z3.BoolRef) -> z3.BoolRef:
    """All of them hold."""
    return joined(z3.Z3_mk_and, formulas) if formulas else z3.BoolVal(True)


def disjunction(*formulas: z3.BoolRef) -> z3.BoolRef:
    """One of them holds."""
    return joined(z3.Z3_mk_or, formulas) if formulas else z3.BoolVal(False)


def opposite(formula: z3.BoolRef) -> z3.BoolRef:
    """It does not hold."""
    return z3.BoolRef(z3.Z3_mk_not(formula.ctx.ref(), formula.ast), formula.ctx)


def tell(solver: z3.Solver, *formulas: z3.BoolRef) -> None:
    """Let a solver know that formulas hold."""
    for formula in formulas:
        z3.Z3_solver_assert(solver.ctx.ref(), solver.solver, formula.ast)


def core_of(solver: z3.Solver) -> set[int]:
    """The identities of formulas that a solver was asked about, and that cannot hold together."""
    core, reference = solver.unsat_core(), solver.ctx.ref()
    return {int(z3.Z3_ast_vector_get(reference, core.vector, place).value) for place in range(len(core))}


def holds_in(model: z3.ModelRef, formula: z3.BoolRef) -> bool:
    """Whether a formula holds in a model."""
    return bool(z3.is_true(model.eval(formula, model_completion=True)))


def ask(solver: z3.Solver, formulas: Any) -> z3.CheckSatResult:
    """Whether formulas, given by their references, can hold together with what a solver knows."""
    answer = z3.Z3_solver_check_assumptions(solver.ctx.ref(), solver.solver, len(formulas), formulas)
    return z3.CheckSatResult(answer)
