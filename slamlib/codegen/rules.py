"""The writing rules of a model's definition, checked on its source; each message names the rule and the line."""

import ast
import inspect
import textwrap
from collections.abc import Callable
from typing import Any

from slamlib.errors import WritingRuleError

_ASSEMBLY = {
    "array", "asarray", "concatenate", "stack", "hstack", "vstack", "block", "newaxis",
    "cross", "dot", "outer", "eye", "zeros", "ones", "diag", "trace", "sum",
}  # fmt: skip
_IN_PLACE = "no in-place write: build the array at once, with np.array or np.concatenate"
_SMOOTH = {"sin", "cos", "sqrt", "arctan2", "arcsin", "arccos", "arctan", "exp", "log", "tan"}


def violation(node: ast.AST) -> str | None:
    """The writing rule that a node of a definition breaks, if any, and what to write instead."""
    match node:
        case ast.If() | ast.IfExp() | ast.While() | ast.Compare() | ast.BoolOp() | ast.Match() | ast.Assert():
            return (
                "no branch or comparison on values: a model is one formula (slamlib.analytic has functions smooth at 0)"
            )
        case ast.AugAssign():
            return _IN_PLACE
        case ast.Assign(targets=targets) if any(isinstance(t, ast.Subscript) for t in targets):
            return _IN_PLACE
        case ast.Constant(value=float() | complex()):
            return "no decimal literal: write integers and ratios, x / 2 for 0.5 * x"
        case ast.BinOp(left=ast.Constant(value=int()), op=ast.Div(), right=ast.Constant(value=int())):
            return "no ratio of two plain integers, which Python rounds to a decimal: write x / 2 for 1 / 2 * x"
        case ast.Attribute(value=ast.Name(id="math" | "np" | "numpy" as module), attr=name):
            if module == "math" or name in _SMOOTH:
                return (
                    f"no {module}.{name}: it cannot work on symbols; use sin, cos, sqrt, exp, log, arctan2 from "
                    "slamlib.analytic"
                )
            if name not in _ASSEMBLY:
                return f"no {module}.{name}: NumPy may only assemble arrays ({', '.join(sorted(_ASSEMBLY))})"
    return None


def check_rules(function: Callable[..., Any]) -> None:
    """Raise WritingRuleError at the first place where the function's source breaks a rule."""
    try:
        lines, first = inspect.getsourcelines(function)
        definition = ast.parse(textwrap.dedent("".join(lines))).body[0]
    except (OSError, TypeError, SyntaxError):
        return  # typed where no source is kept: tracing still finds what cannot be traced
    for statement in definition.body:  # type: ignore[attr-defined]
        for node in ast.walk(statement):
            if message := violation(node):
                line = node.lineno  # type: ignore[attr-defined]
                raise broken(function, first + line - 1, lines[line - 1], message)


def broken(function: Callable[..., Any], line: int, text: str, message: str) -> WritingRuleError:
    """The error for one broken rule."""
    name = getattr(function, "__name__", "model")
    return WritingRuleError(f"{name}, line {line}: {text.strip()}\n  rule: {message}")
