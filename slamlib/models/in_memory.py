"""Generated code that is in no file: modules of a text, functions where some numbers are known; which is affine."""

import ast
import inspect
import linecache
import math
import operator
from collections.abc import Callable, Sequence
from types import ModuleType
from typing import Any

import numpy as np

from slamlib.models.argument import Argument

Generated = Callable[..., tuple[Any, ...]]  # numbers of each argument -> entries, of floats or of arrays
Shapes = Sequence[tuple[int, ...]]


def load(text: str, name: str) -> ModuleType:
    """Make a module of this text, which is kept under the name, so that tracebacks and `show` can print it."""
    linecache.cache[name] = (len(text), None, text.splitlines(keepends=True), name)
    module = ModuleType("in_memory")
    module.__file__ = name
    exec(compile(text, name, "exec"), module.__dict__)
    return module


def for_fewer(
    whole: Generated, arguments: list[Argument], fewer: list[Argument], shapes: Shapes, kept: Shapes
) -> Generated:
    """The generated function of `arguments`, which fills arrays of `shapes`, adapted to the shorter lists `fewer`.

    A lens may have eight coefficients, and most have two; the missing ones are zero. Products with a missing one are
    left out of the function, and so are the derivatives w.r.t. it; what remains, arrays of the shapes `kept`, is the
    same arithmetic.
    """
    lengths = {b.name: b.size for b in fewer}
    zeros = {f"{a.name}{i}": 0.0 for a in arguments for i in range(lengths[a.name], a.size)}
    entries, start = [], 0
    for all_of, left in zip(shapes, kept, strict=True):
        places = np.arange(start, start + math.prod(all_of)).reshape(all_of)
        entries += places[tuple(map(slice, left))].ravel().tolist()
        start += places.size
    return _without(whole, lengths, zeros, entries)


def where_first(whole: Generated, arguments: list[Argument], first: Sequence[float], shapes: Shapes) -> Generated:
    """The generated Jacobian w.r.t. the first of the arguments where that is `first`: a function of the others.

    whole: the function of value and Jacobians, which fills arrays of `shapes`.
    """
    (known, *others), (value, by, *_) = arguments, shapes
    lengths, start = {argument.name: argument.size for argument in others}, math.prod(value)
    numbers = {f"{known.name}{i}": float(number) for i, number in enumerate(first)}
    return _without(whole, lengths, numbers, list(range(start, start + math.prod(by))))


def is_affine(function: Generated, size: int) -> bool:
    """Whether all entries of a generated function of one argument are constants plus multiples of its numbers."""
    try:
        function([_AFFINE] * size)
    except (TypeError, AttributeError):  # the latter from NumPy's functions of objects
        return False
    return True


class _Affine:
    """Any number that is affine in the arguments: sums and multiples are, too; what else is done is a TypeError."""

    __array_ufunc__ = None

    def __neg__(self) -> "_Affine":
        return self

    def __add__(self, other: object) -> "_Affine":
        return self

    def __mul__(self, other: object) -> "_Affine":
        return NotImplemented if isinstance(other, _Affine) else self

    __radd__ = __sub__ = __rsub__ = __add__
    __rmul__ = __truediv__ = __mul__


_AFFINE = _Affine()


def _without(function: Generated, lengths: dict[str, int], known: dict[str, float], kept: list[int]) -> Generated:
    """The function of arguments of these lengths, without the `known` numbers; only the entries `kept`."""
    definition: Any = ast.parse(inspect.getsource(function)).body[0]
    definition.args.args = [argument for argument in definition.args.args if argument.arg in lengths]
    *lines, result = definition.body
    fold, body = _Fold(known), []
    for line in lines:
        fold.visit(line)
        target = line.targets[0] if isinstance(line, ast.Assign) else None
        if isinstance(target, ast.Tuple):  # the numbers of an argument: pose0, pose1, ... = pose
            if line.value.id not in lengths:
                continue
            target.elts = target.elts[: lengths[line.value.id]]
        if isinstance(target, ast.Name) and isinstance(line.value, ast.Constant | ast.Name):
            fold.known[target.id] = line.value
        else:
            body.append(line)
    result.value.elts = [fold.visit(result.value.elts[i]) for i in kept]
    definition.body = [*_needed(body, result), result]
    namespace = dict(function.__globals__)
    exec(compile(ast.unparse(definition), f"<{function.__name__} for fewer coefficients>", "exec"), namespace)
    return namespace[function.__name__]


def _needed(lines: list[ast.stmt], result: ast.stmt) -> list[ast.stmt]:
    """The lines that the result depends on."""
    used, needed = _names(result), []
    for line in reversed(lines):
        single = isinstance(line, ast.Assign) and isinstance(line.targets[0], ast.Name)
        if not single or line.targets[0].id in used:  # type: ignore[attr-defined]
            used |= _names(line)
            needed.append(line)
    return needed[::-1]


def _names(node: ast.AST) -> set[str]:
    return {n.id for n in ast.walk(node) if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Load)}


_ARITHMETIC = {ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul, ast.Div: operator.truediv}


class _Fold(ast.NodeTransformer):
    """Computes what is known, and leaves out zeros in sums, ones in products, and what is multiplied by zero."""

    def __init__(self, known: dict[str, float]) -> None:
        self.known: dict[str, ast.expr] = {name: _number(value) for name, value in known.items()}

    def visit_Name(self, node: ast.Name) -> ast.expr:
        return self.known.get(node.id, node) if isinstance(node.ctx, ast.Load) else node

    def visit_UnaryOp(self, node: ast.UnaryOp) -> ast.expr:
        self.generic_visit(node)
        return _number(ast.literal_eval(node)) if isinstance(node.operand, ast.Constant) else node

    def visit_BinOp(self, node: ast.BinOp) -> ast.expr:
        self.generic_visit(node)
        left, right = (side.value if isinstance(side, ast.Constant) else None for side in (node.left, node.right))
        if right == 0 and isinstance(node.op, ast.Div):
            return node  # singular, which the kernel reports with the place
        if left is not None and right is not None:
            return _number(_ARITHMETIC[type(node.op)](left, right))
        if isinstance(node.op, ast.Mult | ast.Div):
            if left == 0 or right == 0:
                return ast.Constant(0)
            return node.left if right == 1 else node.right if left == 1 and isinstance(node.op, ast.Mult) else node
        if right == 0:
            return node.left
        if left == 0:
            return node.right if isinstance(node.op, ast.Add) else ast.UnaryOp(ast.USub(), node.right)
        return node


def _number(value: float) -> ast.Constant:
    """A whole number is an int: of those a kernel knows that they are the same in each call."""
    return ast.Constant(int(value) if value == int(value) else value)
