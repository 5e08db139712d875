"""Small errors in Python source: which there are, where they are, and what the source is with one of them.

A sign, a transpose, a comparison, a constant, a term less. The rest of the file stays as it is, byte by byte. Messages,
annotations and decorators are left alone: no formula depends on them.
"""

import ast
import bisect
import re
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

SKIPPED = {"__repr__", "__str__", "__all__", "DIGESTS", "SHAPES", "strict", "repr"}  # what no result depends on
SWAPPED: dict[type[ast.AST], tuple[str, str]] = {
    ast.Add: ("+", "-"),
    ast.Sub: ("-", "+"),
    ast.Lt: ("<", "<="),
    ast.LtE: ("<=", "<"),
    ast.Gt: (">", ">="),
    ast.GtE: (">=", ">"),
    ast.Eq: ("==", "!="),
    ast.NotEq: ("!=", "=="),
    ast.Is: ("is", "is not"),
    ast.IsNot: ("is not", "is"),
    ast.In: ("in", "not in"),
    ast.NotIn: ("not in", "in"),
    ast.And: ("and", "or"),
    ast.Or: ("or", "and"),
}
TERMS = (ast.Add, ast.Sub, ast.Mult, ast.Div, ast.MatMult)


@dataclass(frozen=True)
class Mutant:
    """One error: the bytes from start to stop of a file become `text`."""

    file: str
    formula: str  # the function it is in, with its class
    line: int
    kind: str
    start: int
    stop: int
    text: bytes = field(repr=False)
    before: str  # the whole lines concerned, with single spaces
    after: str
    short: str  # the innermost expression, before and after

    def __str__(self) -> str:
        return f"{self.file}:{self.line} {self.kind}: {self.short}"

    @property
    def key(self) -> tuple[str, str, str, str]:
        """What a row of mutants.toml names it by, wherever in the file its lines have moved."""
        return self.file, self.formula, self.before, self.after

    def applied(self, source: bytes) -> bytes:
        """The source with the error."""
        return source[: self.start] + self.text + source[self.stop :]


class _Finder:
    """Walks over a module and collects its mutants."""

    def __init__(self, file: str, source: bytes) -> None:
        self.file, self.source = file, source
        self.found: dict[tuple[int, int, bytes], Mutant] = {}
        self.starts = np.cumsum([0, *map(len, source.splitlines(keepends=True))]).tolist()
        self.walk(ast.parse(source), "")

    def span(self, node: ast.AST) -> tuple[int, int]:
        """Where a node's text starts and stops."""
        at: Any = node
        return self.starts[at.lineno - 1] + at.col_offset, self.starts[at.end_lineno - 1] + at.end_col_offset

    def walk(self, node: ast.AST, formula: str) -> None:
        """Collect the mutants of a node and of all below, but for annotations, decorators and messages."""
        names = {getattr(node, "name", None), getattr(node, "arg", None)}
        names |= {target.id for target in getattr(node, "targets", []) if isinstance(target, ast.Name)}
        if isinstance(node, ast.Raise | ast.JoinedStr) or names & SKIPPED:
            return
        if isinstance(node, ast.FunctionDef | ast.ClassDef):
            formula = f"{formula}.{node.name}".lstrip(".")
        for kind, start, stop, text in self.errors(node):
            self.add(node, formula, kind, start, stop, text)
        for part, value in ast.iter_fields(node):
            if part not in ("annotation", "returns", "decorator_list"):
                for child in value if isinstance(value, list) else [value]:
                    if isinstance(child, ast.AST):
                        self.walk(child, formula)

    def errors(self, node: ast.AST) -> Iterable[tuple[str, int, int, bytes]]:
        """The errors that one node allows: their kind, and which bytes become which."""
        if isinstance(node, ast.AugAssign):
            yield from self.swapped("sign", node.op, node.target, node.value)
        elif isinstance(node, ast.BinOp) and isinstance(node.op, TERMS):
            start, stop = self.span(node)
            if isinstance(node.op, ast.Add | ast.Sub):
                yield from self.swapped("sign", node.op, node.left, node.right)
            else:
                yield "sign", start, start, b"-"
            minus = b"-" if isinstance(node.op, ast.Sub) else b""
            yield "dropped", start, stop, b"(" + self.source[slice(*self.span(node.left))] + b")"
            if not (isinstance(node.left, ast.BinOp) and isinstance(node.left.op, type(node.op))):
                yield "dropped", start, stop, minus + b"(" + self.source[slice(*self.span(node.right))] + b")"
        elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
            start, _ = self.span(node)
            yield "sign", start, start + 1, b""
        elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not):
            start, _ = self.span(node)
            yield "comparison", start, start + len("not "), b""
        elif isinstance(node, ast.Attribute) and node.attr == "T":
            _, stop = self.span(node)
            yield "transpose", stop - len(".T"), stop, b""
        elif isinstance(node, ast.Compare) and len(node.ops) == 1:
            yield from self.swapped("comparison", node.ops[0], node.left, node.comparators[0])
        elif isinstance(node, ast.BoolOp):
            yield from self.swapped("comparison", node.op, node.values[0], node.values[1])
        elif isinstance(node, ast.Constant) and isinstance(node.value, bool | int | float):
            value = not node.value if isinstance(node.value, bool) else node.value + 1
            yield "constant", *self.span(node), repr(value).encode()

    def swapped(self, kind: str, op: ast.AST, left: ast.AST, right: ast.AST) -> Iterable[tuple[str, int, int, bytes]]:
        """Another operator between two expressions."""
        if type(op) in SWAPPED:
            before, after = (text.encode() for text in SWAPPED[type(op)])
            (_, start), (stop, _) = self.span(left), self.span(right)
            gap = re.sub(rb"#[^\n]*", lambda comment: b" " * len(comment[0]), self.source[start:stop])
            place = start + gap.index(before)
            yield kind, place, place + len(before), after

    def add(self, node: ast.AST, formula: str, kind: str, start: int, stop: int, text: bytes) -> None:
        """Keep a mutant, with the texts that show it."""
        row = bisect.bisect_right(self.starts, start) - 1
        spans = (self.starts[row], self.starts[bisect.bisect_left(self.starts, max(stop, start + 1))]), self.span(node)
        before, old = (_plain(self.source[first:last]) for first, last in spans)
        after, new = (_plain(self.source[first:start] + text + self.source[stop:last]) for first, last in spans)
        self.found[start, stop, text] = Mutant(
            self.file, formula, row + 1, kind, start, stop, text, before, after, f"{old} -> {new}"
        )


def _plain(text: bytes) -> str:
    return " ".join(text.decode().split())


def mutants(root: Path, file: str) -> list[Mutant]:
    """All mutants of one file."""
    return list(_Finder(file, (root / file).read_bytes()).found.values())


def differs(root: Path, mutant: Mutant) -> bool:
    """Whether a mutant is Python, and another program than the source."""
    source = (root / mutant.file).read_bytes()
    try:
        return ast.dump(ast.parse(mutant.applied(source))) != ast.dump(ast.parse(source))
    except SyntaxError:
        return False
