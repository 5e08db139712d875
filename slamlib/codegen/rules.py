"""The writing rules of a model's definition, checked on its source; each message names the rule and the line."""

import ast
import inspect
import textwrap
from collections.abc import Callable, Iterator
from typing import Any

from slamlib.errors import WritingRuleError

_ASSEMBLY = {
    "array", "asarray", "concatenate", "stack", "hstack", "vstack", "block", "newaxis",
    "cross", "dot", "outer", "eye", "zeros", "ones", "diag", "trace", "sum",
}  # fmt: skip
_FUNCTIONS = {"sin", "cos", "sqrt", "arctan2"}


def violations(tree: ast.AST) -> Iterator[tuple[ast.AST, str]]:
    """Each place that breaks a rule, with the rule and what to write instead."""
    for node in ast.walk(tree):
        for test in _RULES:
            message = test(node)
            if message:
                yield node, message


def _no_branches(node: ast.AST) -> str | None:
    if isinstance(node, ast.If | ast.IfExp | ast.While | ast.Compare | ast.BoolOp | ast.Match | ast.Assert):
        return "no branch or comparison on values: a model is one formula (slamlib.analytic has functions smooth at 0)"
    return None


def _no_writes(node: ast.AST) -> str | None:
    targets = node.targets if isinstance(node, ast.Assign) else [node.target] if isinstance(node, ast.AugAssign) else []
    if isinstance(node, ast.AugAssign) or any(isinstance(t, ast.Subscript) for t in targets):
        return "no in-place write: build the array at once, with np.array or np.concatenate"
    return None


def _no_decimals(node: ast.AST) -> str | None:
    if isinstance(node, ast.Constant) and isinstance(node.value, float | complex):
        return "no decimal literal: write integers and ratios, x / 2 for 0.5 * x"
    if (
        isinstance(node, ast.BinOp)
        and isinstance(node.op, ast.Div)
        and _is_integer(node.left)
        and _is_integer(node.right)
    ):
        return "no ratio of two plain integers, which Python rounds to a decimal: write x / 2 for 1 / 2 * x"
    return None


def _is_integer(node: ast.AST) -> bool:
    return isinstance(node, ast.Constant) and isinstance(node.value, int)


def _only_assembly(node: ast.AST) -> str | None:
    if not (isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name)):
        return None
    module, name = node.value.id, node.attr
    if module == "math" or (
        module in ("np", "numpy") and name in _FUNCTIONS | {"arcsin", "arccos", "arctan", "exp", "log", "tan"}
    ):
        return f"no {module}.{name}: it cannot work on symbols; use sin, cos, sqrt, arctan2 from slamlib.analytic"
    if module in ("np", "numpy") and name not in _ASSEMBLY:
        return f"no {module}.{name}: NumPy may only assemble arrays ({', '.join(sorted(_ASSEMBLY))})"
    return None


_RULES: list[Callable[[Any], str | None]] = [_no_branches, _no_writes, _no_decimals, _only_assembly]


def check_rules(function: Callable[..., Any]) -> None:
    """Raise WritingRuleError at the first place where the function's source breaks a rule."""
    try:
        lines, first = inspect.getsourcelines(function)
        definition = ast.parse(textwrap.dedent("".join(lines))).body[0]
    except (OSError, TypeError, SyntaxError):
        return  # typed where no source is kept: tracing still finds what cannot be traced
    for statement in definition.body:  # type: ignore[attr-defined]
        for node, message in violations(statement):
            raise broken(function, first + node.lineno - 1, lines[node.lineno - 1], message)  # type: ignore[attr-defined]


def broken(function: Callable[..., Any], line: int, text: str, message: str) -> WritingRuleError:
    """The error for one broken rule."""
    name = getattr(function, "__name__", "model")
    return WritingRuleError(f"{name}, line {line}: {text.strip()}\n  rule: {message}")
