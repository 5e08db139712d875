"""Generated code that is in no file: of readers' models, of storage Jacobians, and for fewer coefficients."""

import ast
import inspect
import linecache
import math
from collections.abc import Callable
from types import ModuleType, SimpleNamespace
from typing import TYPE_CHECKING, Any

import numpy as np

from slamlib.errors import SlamlibError

if TYPE_CHECKING:
    from slamlib.model import Model


def compile_in_memory(model: "Model", *, by_storage: bool = False) -> Any:
    """Compile a module with the model's generated functions.

    by_storage: with the derivatives w.r.t. stored numbers instead. Raises SlamlibError without sympy.
    """
    try:
        from slamlib.codegen.emit import module  # and so sympy, which a filter does without
    except ModuleNotFoundError as error:
        what = "its derivatives by stored numbers are not kept in" if by_storage else "it is not part of"
        raise SlamlibError(
            f"{model.name}: {what} slamlib but generated at the first use, which needs sympy: "
            "pip install 'slamlib[book]'"
        ) from error
    text = module([model], f"{model.module}.{model.name}", by_storage=by_storage)
    code = load(text, f"<generated from {model.module}.{model.name} {abs(hash(text)):x}>")
    code.TEXT = text
    return code


def load(text: str, name: str) -> Any:
    """Make a module of this text, which is kept under the name, so that tracebacks and `show` can print it."""
    linecache.cache[name] = (len(text), None, text.splitlines(keepends=True), name)
    module = ModuleType("in_memory")
    module.__file__ = name
    exec(compile(text, name, "exec"), module.__dict__)
    return module


def for_fewer(whole: "Model", short: "Model", generated: Any) -> Any:
    """Adapt the functions in `generated`, made for the model `whole`, to `short`, whose lists are shorter.

    A lens may have eight coefficients, and most have two; the missing ones are zero. Products with a missing one are
    left out of the generated function, and so are the derivatives w.r.t. it; what remains is the same arithmetic.
    """
    pairs = list(zip(whole.arguments, short.arguments, strict=True))
    lengths = {b.name: b.size for b in short.arguments}
    zeros = {f"{a.name}{i}" for a, b in pairs for i in range(b.size, a.size)}
    shape, functions = generated.SHAPES[whole.name], {}
    for kind in ("", "_jac", "_storage_jac"):
        if (function := getattr(generated, whole.name + kind, None)) is None:
            continue
        kept, start = [], 0
        for all_of, left in zip(whole.shapes(kind, shape), short.shapes(kind, shape), strict=True):
            entries = np.arange(start, start + math.prod(all_of)).reshape(all_of)
            kept += entries[tuple(map(slice, left))].ravel().tolist()
            start += entries.size
        functions[whole.name + kind] = _without(function, lengths, zeros, kept)
    return SimpleNamespace(SHAPES=generated.SHAPES, **functions)


def _without(
    function: Callable[..., Any], lengths: dict[str, int], zeros: set[str], kept: list[int]
) -> Callable[..., Any]:
    """The function for arguments of these lengths, without the numbers named in `zeros`; only the entries `kept`."""
    definition: Any = ast.parse(inspect.getsource(function)).body[0]
    *lines, result = definition.body
    fold, body = _Fold(zeros), []
    for line in lines:
        fold.visit(line)
        target = line.targets[0] if isinstance(line, ast.Assign) else None
        if isinstance(target, ast.Tuple):  # the numbers of an argument: pose0, pose1, ... = pose
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


class _Fold(ast.NodeTransformer):
    """Leaves out what is multiplied by zero, and the zeros in sums."""

    def __init__(self, zeros: set[str]) -> None:
        self.known: dict[str, ast.expr] = {name: ast.Constant(0) for name in zeros}

    def visit_Name(self, node: ast.Name) -> ast.expr:
        return self.known.get(node.id, node) if isinstance(node.ctx, ast.Load) else node

    def visit_UnaryOp(self, node: ast.UnaryOp) -> ast.expr:
        self.generic_visit(node)
        return node.operand if _is_zero(node.operand) else node

    def visit_BinOp(self, node: ast.BinOp) -> ast.expr:
        self.generic_visit(node)
        left, right = _is_zero(node.left), _is_zero(node.right)
        if isinstance(node.op, ast.Mult | ast.Div):
            return ast.Constant(0) if left or right else node
        if right:
            return node.left
        if left:
            return node.right if isinstance(node.op, ast.Add) else ast.UnaryOp(ast.USub(), node.right)
        return node


def _is_zero(node: ast.expr) -> bool:
    return isinstance(node, ast.Constant) and node.value == 0
