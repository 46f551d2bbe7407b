"""Mutants: the rules' own source, changed in one place by fixed operators. Each must be caught by name.

A mutant is caught if a piece of evidence fails on it: an obligation with a counterexample that replays on exact
numbers, a property test or a count. A crash or an undecided obligation catches nothing. This module imports no
rules, so that a fresh process can put a mutated chapter in place before anything else does.
"""

from __future__ import annotations

import ast
import importlib
import sys
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from contextlib import AbstractContextManager, nullcontext
from copy import deepcopy
from dataclasses import dataclass
from multiprocessing import get_context
from os import cpu_count
from pathlib import Path
from types import ModuleType

CHAPTERS = ("clearance", "push", "walk", "leave", "request")
EXCHANGED = {"front": "rear", "rear": "front", "drop": "across", "across": "drop"}
BOTH_SIDED = ("view", "leaving", "placement", "jump", "best")
RULES = Path(__file__).parents[2] / "spec" / "rules"
WEAKER: dict[type[ast.cmpop], type[ast.cmpop]] = {
    ast.Lt: ast.LtE,
    ast.LtE: ast.Lt,
    ast.Gt: ast.GtE,
    ast.GtE: ast.Gt,
}


@dataclass(frozen=True)
class Mutant:
    """A chapter of the rules with one change; `change` says which."""

    chapter: str
    change: str
    source: str


@dataclass(frozen=True)
class Fate:
    """What became of a mutant: what caught it, or None and why nothing did."""

    mutant: Mutant
    caught_by: str | None
    trouble: str = ""

    @property
    def by_proof(self) -> bool:
        """Whether an obligation caught it; what else does is named as a count or a sample."""
        return self.caught_by is not None and not self.caught_by.startswith(("count: ", "sample: "))


def keyword(call: ast.Call, name: str) -> ast.keyword:
    """A keyword argument of a call."""
    return next(argument for argument in call.keywords if argument.arg == name)


def calls_of(tree: ast.AST, name: str) -> list[ast.Call]:
    """All calls of a function by its plain name."""
    calls = (node for node in ast.walk(tree) if isinstance(node, ast.Call))
    return [call for call in calls if isinstance(call.func, ast.Name) and call.func.id == name]


def guard_changes(tree: ast.Module) -> Iterator[str]:
    """Drop, then negate, each conjunct of each guard."""
    for rule in calls_of(tree, "Rule"):
        name, guard = ast.unparse(keyword(rule, "id").value), keyword(rule, "guard").value
        assert isinstance(guard, ast.Tuple)
        conjuncts = list(guard.elts)
        for i, conjunct in enumerate(conjuncts):
            guard.elts = conjuncts[:i] + conjuncts[i + 1 :]
            yield f"{name}: drop {ast.unparse(conjunct)}"
            negated = ast.parse(f"lambda facts: not {ast.unparse(conjunct)}(facts)", mode="eval").body
            guard.elts = [*conjuncts[:i], negated, *conjuncts[i + 1 :]]
            yield f"{name}: negate {ast.unparse(conjunct)}"
        guard.elts = conjuncts


def effect_changes(tree: ast.Module) -> Iterator[str]:
    """Give each rule each other effect of its family."""
    for family in calls_of(tree, "Family"):
        effects = [keyword(rule, "effect") for rule in calls_of(family, "Rule")]
        names = list(dict.fromkeys(ast.unparse(effect.value) for effect in effects))
        for rule in calls_of(family, "Rule"):
            effect = keyword(rule, "effect")
            own = effect.value
            for other in names:
                if other != ast.unparse(own):
                    effect.value = ast.Name(other)
                    yield f"{ast.unparse(keyword(rule, 'id').value)}: {other} instead of {ast.unparse(own)}"
            effect.value = own


def expression_changes(tree: ast.Module) -> Iterator[str]:
    """Change each comparison, sum, truth value, choice of the lesser and effect on the world in a function."""
    for function in (node for node in tree.body if isinstance(node, ast.FunctionDef)):
        for node in ast.walk(function):
            for change in changes_of(node):
                yield f"{function.name}: {change}"


def changes_of(node: ast.AST) -> Iterator[str]:
    """Change one node, each way in turn, and put it back."""
    before = ast.unparse(node)
    if isinstance(node, ast.Compare) and type(node.ops[0]) in WEAKER:
        yield from replaced(node, "ops", [[WEAKER[type(node.ops[0])]()]], before)
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add | ast.Sub):
        flipped = ast.Sub() if isinstance(node.op, ast.Add) else ast.Add()
        yield from replaced(node, "op", [flipped], before)
        yield from replaced(node, "right", [ast.parse(f"({ast.unparse(node.right)}) * 0", mode="eval").body], before)
    if isinstance(node, ast.Constant) and isinstance(node.value, bool):
        yield from replaced(node, "value", [not node.value], before)
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "lesser":
        yield from replaced(node, "args", [node.args[:1] * 2, node.args[1:] * 2], before)
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == "along":
        at, distance = node.args
        nothing = ast.parse(f"({ast.unparse(distance)}) * 0", mode="eval").body
        yield from replaced(node, "args", [[at, nothing]], before)
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "walk_freely":
        shorter = ast.parse(f"({ast.unparse(node.args[-1])}) * 0", mode="eval").body
        yield from replaced(node, "args", [[*node.args[:-1], shorter]], before)
    if isinstance(node, ast.Attribute) and node.attr in EXCHANGED and ast.unparse(node.value) in BOTH_SIDED:
        yield from replaced(node, "attr", [EXCHANGED[node.attr]], before)
    if isinstance(node, ast.Expr) and isinstance(node.value, ast.Call):
        yield from replaced(node, "value", [ast.Constant(None)], before)


def replaced(node: ast.AST, attribute: str, values: list[object], before: str) -> Iterator[str]:
    """Give an attribute of a node each value in turn, then its own again."""
    own = getattr(node, attribute)
    for value in values:
        setattr(node, attribute, value)
        yield f"{ast.unparse(node)} instead of {before}"
    setattr(node, attribute, own)


def mutants() -> list[Mutant]:
    """All mutants of all chapters."""
    found = []
    for chapter in CHAPTERS:
        tree = ast.parse((RULES / f"{chapter}.py").read_text())
        for changes in (guard_changes, effect_changes, expression_changes):
            for change in changes(tree):
                found.append(Mutant(chapter, change, ast.unparse(ast.fix_missing_locations(deepcopy(tree)))))
    return found


def put_in_place(mutant: Mutant) -> None:
    """Make a mutated chapter the one that everything imports."""
    package, name = importlib.import_module("spec.rules"), f"spec.rules.{mutant.chapter}"
    assert name not in sys.modules, f"{name} is imported already"
    module = ModuleType(name)
    sys.modules[name] = module
    exec(compile(mutant.source, f"<mutant of {name}>", "exec"), module.__dict__)
    setattr(package, mutant.chapter, module)


def try_out(mutant: Mutant, export: Path | None = None) -> Fate:
    """Run the evidence on a mutant, in a process of its own, up to the first that fails.

    With `export`, what an obligation explored that fails is written to that file, in SMT-LIB 2.
    """
    try:
        put_in_place(mutant)
        from properties.evidence.settle import first_failure

        with nullcontext() if export is None else broken_recorded(export):
            return Fate(mutant, first_failure())
    except Exception as error:
        return Fate(mutant, None, f"crash: {type(error).__name__}: {error}")


def broken_recorded(path: Path) -> AbstractContextManager[None]:
    """Write what was explored up to a counterexample to a file."""
    from properties.engine.explore import watched_by
    from properties.evidence.export import Recorder

    return watched_by(Recorder(path.parent, path.stem, only_broken=True))


def fates(export: Path | None = None) -> Iterator[Fate]:
    """Try all mutants, side by side."""
    context = get_context("forkserver")
    context.set_forkserver_preload(["z3", "hypothesis", "msgspec", "numpy", "properties.evidence.mutate"])
    with ProcessPoolExecutor(cpu_count(), mp_context=context, max_tasks_per_child=1) as pool:
        changes = mutants()
        files = [None if export is None else file_of(export, number, one) for number, one in enumerate(changes, 1)]
        yield from pool.map(try_out, changes, files)


def file_of(directory: Path, number: int, mutant: Mutant) -> Path:
    """The file for the obligation that a mutant fails."""
    return directory / f"mutant-{number:03}-{mutant.chapter}.smt2"
