"""A mutant: something of the project with one change, which can be put in place and taken back."""

from __future__ import annotations

import ast
import importlib
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from pathlib import Path
from types import CodeType, FunctionType
from typing import Any

from properties.evidence.mutants.operators import OPERATORS, Operator, variants

ANNOTATIONS = importlib.import_module("__future__").annotations.compiler_flag


@dataclass(frozen=True)
class Mutant:
    """A change of one attribute of something.

    Attributes:
        subject: the ID of the rule, or the name of the function.
        change: what is changed.
        target, attribute, value: of what which attribute is changed, and to what.
        reached: the functions (`called`) of which one runs if what is changed plays a part.
        probe: of a function, its code with what is changed and what it is changed to told to `alike`.
    """

    subject: str
    change: str
    target: Any
    attribute: str
    value: Any
    reached: frozenset[str]
    probe: CodeType | None = None

    @property
    def name(self) -> str:
        """The name of the mutant; there is no other of that name."""
        return f"{self.subject}: {self.change}"

    @contextmanager
    def in_place(self) -> Iterator[None]:
        """Have the change in place, and then what was there before."""
        own = getattr(self.target, self.attribute)
        forget(self.target)
        object.__setattr__(self.target, self.attribute, self.value)
        try:
            yield
        finally:
            object.__setattr__(self.target, self.attribute, own)
            forget(self.target)


Compare = Callable[[Any, Any], None]
COMPARE: ContextVar[Compare] = ContextVar("compare")


def alike(own: Callable[[], Any], other: Callable[[], Any]) -> Any:
    """What an expression gives, which is compared with what it might be changed to."""
    value = own()
    COMPARE.get()(value, other())
    return value


def forget(target: Any) -> None:
    """Have nothing remembered that functions of the module of a function have returned: they may have called it."""
    if isinstance(target, FunctionType):
        for one in vars(importlib.import_module(target.__module__)).values():
            if hasattr(one, "cache_clear"):
                one.cache_clear()


def called(code: CodeType) -> str:
    """The name of a function, from its code: its package, its file and its name there."""
    return ".".join((*Path(code.co_filename).with_suffix("").parts[-2:], code.co_qualname))


def function_of(module: str, name: str) -> FunctionType:
    """A function or a method of a module, without what is wrapped around it."""
    found: Any = importlib.import_module(module)
    for part in name.split("."):
        found = vars(found)[part]
    found = found.fget if isinstance(found, property) else getattr(found, "__func__", getattr(found, "func", found))
    bare = getattr(found, "__wrapped__", found)
    assert isinstance(bare, FunctionType)
    return bare


def functions_in(tree: ast.Module) -> Iterator[tuple[str, ast.FunctionDef]]:
    """All functions and methods of a module, by name."""
    for node in tree.body:
        if isinstance(node, ast.FunctionDef):
            yield node.name, node
        if isinstance(node, ast.ClassDef):
            yield from ((f"{node.name}.{one.name}", one) for one in node.body if isinstance(one, ast.FunctionDef))


def code_of(module: str, definition: ast.FunctionDef) -> CodeType:
    """The code of a function that is defined as given, in a module."""
    bare = ast.FunctionDef(definition.name, definition.args, definition.body, [], definition.returns)
    namespace = dict(vars(importlib.import_module(module)))
    tree = ast.fix_missing_locations(ast.Module([bare], []))
    exec(compile(tree, f"<mutant of {module}>", "exec", ANNOTATIONS, dont_inherit=True), namespace)
    code: CodeType = namespace[definition.name].__code__
    return code


def mutants_of(module: str, *skipped: str, operators: Sequence[Operator] = OPERATORS) -> Iterator[Mutant]:
    """All mutants by some operators of the functions of a module, but of those skipped, each change once."""
    file = importlib.import_module(module).__file__
    assert file is not None
    for name, definition in functions_in(ast.parse(Path(file).read_text())):
        if name not in skipped:
            yield from mutants_of_function(module, name, definition, operators)


def mutants_of_function(
    module: str, name: str, definition: ast.FunctionDef, operators: Sequence[Operator]
) -> Iterator[Mutant]:
    """All mutants of a function; of those that read alike, one."""
    target, subject = function_of(module, name), f"{module.rpartition('.')[2]}.{name}"
    known = {ast.unparse(definition)}
    for variant in variants(definition, operators):
        if (text := ast.unparse(variant.function)) not in known:
            known.add(text)
            reached, code = frozenset({called(target.__code__)}), code_of(module, variant.function)
            probe = None if variant.probe is None else code_of(module, variant.probe)
            yield Mutant(subject, variant.change, target, "__code__", code, reached, probe)


def told_apart(mutants: list[Mutant]) -> dict[str, Mutant]:
    """Mutants by name; where the same is changed at several places of a function, they are numbered."""
    found: dict[str, Mutant] = {}
    for one in mutants:
        number = 2
        name = one.name
        while name in found:
            name, number = f"{one.name} ({number})", number + 1
        found[name] = one
    return found
