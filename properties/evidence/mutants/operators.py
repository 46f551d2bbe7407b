"""The operators: how a function's source is changed, in one place at a time.

An operator takes a node of the syntax tree and gives what may stand in its place. The operators are the same for the
rules, the invariants and the engine; contracts are changed by those that drop, widen or negate.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator, Sequence
from copy import deepcopy
from dataclasses import dataclass

Operator = Callable[[ast.AST], Iterator[ast.AST]]

OTHER_BOUND: dict[type[ast.cmpop], tuple[type[ast.cmpop], ...]] = {
    ast.Lt: (ast.LtE,),
    ast.LtE: (ast.Lt,),
    ast.Gt: (ast.GtE,),
    ast.GtE: (ast.Gt,),
    ast.Eq: (ast.LtE, ast.GtE),
}
EXCHANGED = {"front": "rear", "rear": "front", "drop": "across", "across": "drop"}
SAME_KIND = {"other": "body", "rear": "front", "front": "rear"}
ALIKE = "__import__('properties.evidence.mutants.mutant', fromlist=['alike']).alike"
EXTREMES = ("lesser", "greater", "min", "max", "np.minimum", "np.maximum")
OF_FORM = ("strict", "model_completion", "som", "arith_lhs", "sort_sums")
"""Options of `zip` and of the solver: what is noticed, in which form the same is said, which questions are saved."""
LENGTHS = ("moved", "stride", "rest", "distance")
HANDED_ON = (
    "turn.motion.velocity",
    "touch.body",
    "bounded.velocity",
    "moved.velocity",
    "moved.actual",
    "descent.target",
    "swing.target",
    "shift.target",
)
"""Quantities that a rule returns as they are, or has something else hold."""
TWICE = ("yield Ask", "yield from rules", "rules.follow", "rules.leave", "view.place", "turns.append")
BOTH_SIDED = ("view", "leaving", "placement", "jump", "other", "best", "placed")
SEGMENT = "rules.segment(rules, view, body, motion, spare)"
DEPART = "depart(rules, view, body, motion.at, rear, tow.moved)"
BY_HAND: dict[str, tuple[str, ...]] = {
    SEGMENT: (
        "rules.segment(replace(rules, walk=rules.fit), view, body, motion, spare)",
        "rules.segment(rules, replace(view), body, motion, spare)",
        "rules.segment(rules, view, view.ahead(body, motion.at), motion, spare)",
        "rules.segment(rules, view, body, motion, spare + spare)",
        "rules.segment(rules, view, body, replace(motion, rest=motion.rest + motion.rest), spare)",
        "rules.segment(rules, view, body, replace(motion, rest=motion.rest * 0), spare)",
    ),
    "Tow(view, rules.walk, view.rear(body), distance - motion.rest)": (
        "Tow(replace(view), rules.walk, view.rear(body), distance - motion.rest)",
        "Tow(view, rules.fit, view.rear(body), distance - motion.rest)",
        "Tow(view, rules.walk, motion.at, distance - motion.rest)",
    ),
    "rules.follow.choose(tow).effect(tow)": ("view.rear(body)",),
    DEPART: (
        "depart(rules, view, body, view.front(body), rear, tow.moved)",
        "depart(rules, view, body, motion.at, view.rear(body), tow.moved)",
    ),
    "rules.leave.choose(leaving).effect(leaving)": ("Placement(motion.at, rear, tow.moved)",),
    "Placement(leaving.view.along(leaving.front, too_far), leaving.view.end(leaving.rear), leaving.moved + too_far)": (
        "Placement(leaving.view.along(leaving.front, too_far + too_far),"
        " leaving.view.along(leaving.rear, too_far + too_far), leaving.moved + too_far + too_far)",
    ),
    "walk=rules.walk": ("walk=rules.fit",),
    "fit=rules.fit": ("fit=rules.walk",),
    "landing=rules.landing": ("landing=rules.walk",),
    "near=near": ("near=near + near",),
    "lesser(motion.rest, reach)": (
        "lesser(motion.rest, reach) * motion.at.edge",
        "lesser(motion.rest, reach) * (1 - motion.at.edge)",
    ),
    "other is not None and asked is not None": (
        "other is not None and asked is not None and motion.at.edge",
        "other is not None and asked is not None and not motion.at.edge",
    ),
    "view.along(motion.at, motion.rest)": (
        "view.along(motion.at, motion.rest + view.margin)",
        "view.along(motion.at, motion.rest - view.margin)",
    ),
    "every((equal(went, call.moved, call.tolerance) for went in call.borders))": (
        "every(equal(went, call.moved, call.tolerance) for went in call.borders[:1])"
        " & (call.borders[-1] <= call.moved)",
    ),
    "self.spare > 0 and self.pushes": (
        "self.spare > 0 and self.pushes and (self.neighbour is None or self.neighbour < self.margin)",
    ),
    "Way(motion.rest, blocked=False)": ("Way(distance, blocked=False)", "Way(motion.rest * 0, blocked=False)"),
    "rules.way.choose(way).effect(way)": (
        "rules.way.choose(way).effect(way) + speed",
        "rules.way.choose(way).effect(way) - speed",
        "rules.way.choose(way).effect(way) if way.ahead is None else way.ahead",
    ),
    "member.pushes": ("member.pushes and not member.walls",),
    "Way(member.body, speed, direction in member.walls, found[-1] if found else None)": (
        "Way(member.body, speed + speed, direction in member.walls, found[-1] if found else None)",
    ),
    "not isinstance(mark, Contact) or (mark.left, mark.right) in pairs": (
        "isinstance(mark, Contact) and (mark.left, mark.right) in pairs",
        "True",
    ),
    "world.tops(body)": ("()",),
    "bool(world.grounded(body))": ("False",),
    "Seat(body, storey, top) not in lost": ("True",),
    "turn.own": ("turn.own + turn.passed",),
    "Change(rule.id, seat_of(world, body))": ("Change(rule.id, seat_of(world, 0))",),
    "reduce(lesser, sooner, left)": ("left", "left + left"),
    "not sooner": ("True", "False"),
    "event.after < left": ("event.after + event.after < left", "left < event.after + event.after"),
    "event.after <= after": ("True",),
    "greater(nearing.room, zero_like(nearing.room)) / nearing.speed": (
        "greater(nearing.room + nearing.room, zero_like(nearing.room)) / nearing.speed",
    ),
    "turn.passed": ("turn.own + turn.passed",),
    "bool(speeds[mark.left] >= speeds[mark.right])": ("True",),
    "bool(speeds[mark.body] * mark.direction >= zero_like(speeds[mark.body]))": ("True",),
    "urge.drive.speed + urge.carried": (
        "urge.drive.speed + (urge.carried if urge.drive.speed < urge.drive.speed * 0 else urge.carried + urge.carried)",
    ),
    "greater(member.wish * direction, zero_like(passed))": (
        "greater(member.wish * direction, member.wish * direction * -1)",
    ),
    "self.carries(other, body)": ("False", "True"),
    "place.left + distance": (
        "place.left + distance * place.storey",
        "place.left + (distance if distance < place.width else distance * 0)",
    ),
    "footing.tops[-1]": ("footing.tops[0]",),
    "footing.tops[0]": ("footing.tops[-1]",),
    "urge.drive.relative": ("urge.drive.relative and urge.carried >= urge.carried * 0",),
    "world.facing(direction)": ("world.copy().facing(direction)",),
    "Direction.LEFT if distance < zero else Direction.RIGHT": ("Direction.LEFT", "Direction.RIGHT"),
    "length if direction is Direction.RIGHT else zero_like(length)": (
        "length + length if direction is Direction.RIGHT else zero_like(length) - length",
    ),
    "self.world.put(body, left, right)": ("self.world.put(self.world.beside(body, self.direction), left, right)",),
    "walk_freely(tow.walk, tow.view, tow.rear, tow.moved).at": (
        "tow.view.along(tow.rear, tow.moved)",
        "tow.view.along(tow.rear, tow.moved + tow.view.margin)",
    ),
}
"""What stands for an expression, where something wrong is wanted that no operator makes."""
BY_HAND_NAMES = {"replace", "Placement"}


def other_bound(node: ast.AST) -> Iterator[ast.AST]:
    """`<` for `<=`, and the other way round; `<=` and `>=` for `==`, or `!=` where there is no order."""
    if isinstance(node, ast.Compare) and isinstance(node.ops[0], ast.Eq) and has_no_order(node.comparators[0]):
        yield ast.Compare(node.left, [ast.NotEq()], node.comparators)
    elif isinstance(node, ast.Compare):
        for place, own in enumerate(node.ops):
            for other in OTHER_BOUND.get(type(own), ()):
                yield ast.Compare(node.left, [*node.ops[:place], other(), *node.ops[place + 1 :]], node.comparators)


def has_no_order(value: ast.expr) -> bool:
    """Whether a value is an answer of the solver, a formula, or a list."""
    return isinstance(value, ast.List | ast.ListComp) or ast.unparse(value).startswith(("z3.", "formula_of("))


def fewer_terms(node: ast.AST) -> Iterator[ast.AST]:
    """A sum or a difference without its second term."""
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add | ast.Sub) and not of_sets(node):
        yield ast.BinOp(node.left, node.op, times_zero(node.right))


def other_term(node: ast.AST) -> Iterator[ast.AST]:
    """A sum or a difference with the other sign, and with its second term twice; a product for a quotient."""
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Div):
        yield ast.BinOp(node.left, ast.Mult(), node.right)
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add | ast.Sub) and not of_sets(node):
        flipped = ast.Sub() if isinstance(node.op, ast.Add) else ast.Add()
        yield ast.BinOp(node.left, flipped, node.right)
        yield ast.BinOp(node, node.op, node.right)


def exactly(operator: Operator) -> Operator:
    """An operator that leaves alone what a tolerance is added to or taken from: it is 0 on exact numbers."""

    def exact(node: ast.AST) -> Iterator[ast.AST]:
        if not (isinstance(node, ast.BinOp) and ast.unparse(node.right).endswith("tolerance")):
            yield from operator(node)

    return exact


def of_sets(node: ast.expr) -> bool:
    """Whether a sum or a difference is one of sets."""
    if isinstance(node, ast.BinOp):
        return of_sets(node.left) or of_sets(node.right)
    return isinstance(node, ast.Set | ast.SetComp)


def fewer_conjuncts(node: ast.AST) -> Iterator[ast.AST]:
    """A conjunction or a disjunction without one of its parts."""
    if isinstance(node, ast.BoolOp):
        for place in range(len(node.values)):
            rest = [*node.values[:place], *node.values[place + 1 :]]
            yield rest[0] if len(rest) == 1 else ast.BoolOp(node.op, rest)
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.BitAnd | ast.BitOr):
        yield node.left
        yield node.right


def opposite(node: ast.AST) -> Iterator[ast.AST]:
    """A truth for its opposite: a constant, a negation, or whether a value is another."""
    if isinstance(node, ast.Constant) and isinstance(node.value, bool):
        yield ast.Constant(not node.value)
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not):
        yield node.operand
    if isinstance(node, ast.Call) and ast.unparse(node.func) == "negated":
        yield node.args[0]
    if isinstance(node, ast.Compare) and isinstance(node.ops[0], ast.Is | ast.IsNot):
        turned = ast.IsNot() if isinstance(node.ops[0], ast.Is) else ast.Is()
        yield ast.Compare(node.left, [turned], node.comparators)


def one_of_two(node: ast.AST) -> Iterator[ast.AST]:
    """One of the two of which the lesser or the greater is taken."""
    if isinstance(node, ast.Call) and ast.unparse(node.func) in EXTREMES:
        yield from (argument for argument in node.args if not isinstance(argument, ast.Starred))


def no_effect(node: ast.AST) -> Iterator[ast.AST]:
    """A way of no length, no way to the end, and a statement that does nothing."""
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == "along":
        yield ast.Call(node.func, [node.args[0], times_zero(node.args[1])], [])
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == "end":
        yield node.args[0]
    if isinstance(node, ast.Call) and ast.unparse(node.func) == "walk_freely":
        yield ast.Call(node.func, [*node.args[:-1], times_zero(node.args[-1])], [])
    if isinstance(node, ast.Expr) and isinstance(node.value, ast.Call):
        yield ast.Pass()
    if isinstance(node, ast.Return) and isinstance(node.value, ast.Attribute) and node.value.attr in LENGTHS:
        yield ast.Return(times_zero(node.value))


def another_time(node: ast.AST) -> Iterator[ast.AST]:
    """What is asked, followed or taken in turn twice, and a loop that is gone through once at most."""
    value = node.value if isinstance(node, ast.Assign | ast.AnnAssign | ast.Expr) else None
    if value is not None and ast.unparse(value).lstrip("(").startswith(TWICE):
        assert isinstance(node, ast.stmt)
        yield ast.If(ast.Constant(True), [node, node], [])
    if isinstance(node, ast.While) and not any(isinstance(one, ast.Break | ast.Continue) for one in ast.walk(node)):
        yield ast.If(node.test, node.body, [])


def other_side(node: ast.AST) -> Iterator[ast.AST]:
    """One border for the other; how far a jump leads down for how far it leads across."""
    if isinstance(node, ast.Attribute) and node.attr in EXCHANGED and ast.unparse(node.value) in BOTH_SIDED:
        yield ast.Attribute(node.value, EXCHANGED[node.attr], node.ctx)


def other_argument(node: ast.AST) -> Iterator[ast.AST]:
    """A call with another value of the same kind for one of its arguments, or with a count that is one less."""
    if isinstance(node, ast.Call):
        for place, own in enumerate(node.args):
            if isinstance(own, ast.Name) and own.id in SAME_KIND:
                yield with_argument(node, place, ast.Name(SAME_KIND[own.id], ast.Load()))
            if isinstance(own, ast.Name) and own.id == "spare":
                yield with_argument(node, place, ast.BinOp(own, ast.Sub(), ast.Constant(1)))
    if isinstance(node, ast.keyword) and isinstance(node.value, ast.Name) and node.value.id == node.arg in SAME_KIND:
        yield ast.keyword(node.arg, ast.Name(SAME_KIND[node.arg], ast.Load()))


def with_argument(call: ast.Call, place: int, other: ast.expr) -> ast.Call:
    """A call with another argument at a place."""
    return ast.Call(call.func, [*call.args[:place], other, *call.args[place + 1 :]], call.keywords)


def other_length(node: ast.AST) -> Iterator[ast.AST]:
    """Nothing, and twice as much, for a length that is handed on by its name, and for what a rule hands on as it is;
    twice as much for a length that is returned.
    """
    if isinstance(node, ast.keyword) and node.arg in (*LENGTHS, "width") and isinstance(node.value, ast.Name):
        yield ast.keyword(node.arg, times_zero(node.value))
        yield ast.keyword(node.arg, ast.BinOp(node.value, ast.Add(), node.value))
    if isinstance(node, ast.Return) and isinstance(node.value, ast.Attribute) and node.value.attr in LENGTHS:
        yield ast.Return(ast.BinOp(node.value, ast.Add(), node.value))
    if isinstance(node, ast.Return) and node.value is not None and ast.unparse(node.value) in HANDED_ON:
        yield ast.Return(times_zero(node.value))
        yield ast.Return(ast.BinOp(node.value, ast.Add(), node.value))
    if isinstance(node, ast.keyword) and ast.unparse(node.value) in HANDED_ON:
        yield ast.keyword(node.arg, times_zero(node.value))
        yield ast.keyword(node.arg, ast.BinOp(node.value, ast.Add(), node.value))


def no_direction(node: ast.AST) -> Iterator[ast.AST]:
    """What is taken in a direction, whatever the direction: what is left is wrong to one side only."""
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Mult) and ast.unparse(node.right).endswith("direction"):
        yield node.left


def by_hand(node: ast.AST) -> Iterator[ast.AST]:
    """What is made by hand, for an expression or for an argument with its name."""
    if isinstance(node, ast.expr | ast.keyword):
        for other in BY_HAND.get(ast.unparse(node), ()):
            call = ast.parse(f"dict({other})", mode="eval").body
            assert isinstance(call, ast.Call)
            yield from (*call.args, *call.keywords)


WEAKENING: tuple[Operator, ...] = (other_bound, exactly(fewer_terms), fewer_conjuncts, opposite, no_effect, by_hand)
OPERATORS: tuple[Operator, ...] = (
    other_bound,
    fewer_terms,
    other_term,
    fewer_conjuncts,
    opposite,
    one_of_two,
    no_effect,
    another_time,
    other_side,
    other_argument,
    other_length,
    by_hand,
)


OF_RULES: tuple[Operator, ...] = (*OPERATORS, no_direction)
EXACT: tuple[Operator, ...] = tuple(map(exactly, OPERATORS))


def times_zero(term: ast.expr) -> ast.expr:
    """A term that is 0, of the same kind of number."""
    return ast.BinOp(term, ast.Mult(), ast.Constant(0))


def promised(function: ast.FunctionDef) -> set[int]:
    """The identities of nodes in what is ensured. True rules keep a promise, so of them a weaker one says the same;
    only a wrong rule tells.
    """
    calls = [one for one in ast.walk(function) if isinstance(one, ast.Call) and isinstance(one.func, ast.Attribute)]
    said = [argument for call in calls if ast.unparse(call.func) == "given.ensure" for argument in call.args]
    return {id(node) for root in said for node in ast.walk(root)}


def unread(function: ast.FunctionDef) -> set[int]:
    """The identities of nodes that decide nothing: annotations of variables, and options that decide no answer."""
    types = [one.annotation for one in ast.walk(function) if isinstance(one, ast.AnnAssign)]
    options = [one.value for one in ast.walk(function) if isinstance(one, ast.keyword) and one.arg in OF_FORM]
    return {id(node) for root in (*types, *options) for node in ast.walk(root)}


@dataclass(frozen=True)
class Variant:
    """A function with one change. `probe` is the function as it is, with both the old and the new expression told to
    `alike`, if it is an expression that is changed, has no effect of its own, and is not part of a promise.
    """

    change: str
    function: ast.FunctionDef
    probe: ast.FunctionDef | None


def variants(function: ast.FunctionDef, operators: Sequence[Operator]) -> Iterator[Variant]:
    """A function with one change, for each place and each operator that fits it."""
    nodes, known, passive = list(ast.walk(ast.Module(function.body, []))), names_in(function), unread(function)
    told_by_wrong_ones = promised(function)
    for place, node in enumerate(nodes):
        if id(node) in passive:
            continue
        for other in (other for operator in operators for other in operator(node)):
            if names_in(other) <= known | BY_HAND_NAMES:
                probing = None if id(node) in told_by_wrong_ones else probe(function, place, node, other)
                yield Variant(told(node, other), replaced(function, place, other), probing)


def probe(function: ast.FunctionDef, place: int, node: ast.AST, other: ast.AST) -> ast.FunctionDef | None:
    """The function with an expression and what may stand in its place told to `alike`."""
    effects = (ast.Yield, ast.YieldFrom, ast.NamedExpr, ast.Starred)
    if not isinstance(node, ast.expr) or any(isinstance(one, effects) for one in ast.walk(node)):
        return None
    both = f"{ALIKE}(lambda: {ast.unparse(node)}, lambda: {ast.unparse(other)})"
    return replaced(function, place, ast.parse(both, mode="eval").body)


def names_in(tree: ast.AST) -> set[str]:
    """The names that occur in a tree, those of arguments included."""
    nodes = list(ast.walk(tree))
    return {one.id for one in nodes if isinstance(one, ast.Name)} | {n.arg for n in nodes if isinstance(n, ast.arg)}


def told(node: ast.AST, other: ast.AST) -> str:
    """What a change is."""
    if isinstance(other, ast.Pass):
        return f"drop {ast.unparse(node)}"
    if isinstance(other, ast.If):
        return f"{'only once' if isinstance(node, ast.While) else 'twice'} {ast.unparse(node).splitlines()[0]}"
    return f"{ast.unparse(other)} instead of {ast.unparse(node)}"


def replaced(function: ast.FunctionDef, place: int, other: ast.AST) -> ast.FunctionDef:
    """A copy of a function with another node at a place of its body, counted as `ast.walk` does."""
    copied = deepcopy(function)
    target = list(ast.walk(ast.Module(copied.body, [])))[place]

    class Replace(ast.NodeTransformer):
        def visit(self, node: ast.AST) -> ast.AST:
            return deepcopy(other) if node is target else self.generic_visit(node)

    changed = Replace().generic_visit(copied)
    assert isinstance(changed, ast.FunctionDef)
    return ast.fix_missing_locations(changed)
