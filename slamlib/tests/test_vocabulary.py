"""The field's words: no identifier that vocabulary.csv replaces, and no public class name that two modules share."""

import ast
import csv
import json
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
FOLDERS = ("slamlib", "book", "benchmarks")
# Words that are ordinary English where figures are drawn: the look of a mark, the part of a line that is in sight, the
# ends of an axis or an arrow, the gap between an arrow and its text.
DRAWING = ("book/live/standin/", "book/slambook/figures/", "book/tests/test_figures")
ORDINARY = {"look", "looks", "sight", "ends", "gap"}


def rows() -> list[dict[str, str]]:
    with (ROOT / "vocabulary.csv").open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


REPLACED = {word: row["term"] for row in rows() for word in row["identifiers"].split()}


def files(suffix: str) -> list[Path]:
    found = (path for folder in FOLDERS for path in sorted((ROOT / folder).rglob(f"*{suffix}")))
    made = {"generated", "_build"}
    return [path for path in found if not made & set(path.parts)]


def cells(path: Path) -> Iterator[str]:
    """Code of a notebook's cells, with IPython's own lines left out."""
    for cell in json.loads(path.read_text("utf-8"))["cells"]:
        if cell["cell_type"] == "code":
            text = "".join(cell["source"])
            yield re.sub(r"(?m)^\s*[%!].*$", "pass", text) if not text.startswith("%%") else text.partition("\n")[2]


def names(tree: ast.AST) -> Iterator[tuple[str, int]]:
    """Names of definitions, classes, attributes, arguments and keywords, with their lines."""
    for node in ast.walk(tree):
        if isinstance(node, ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef):
            yield node.name, node.lineno
        if isinstance(node, ast.ClassDef):
            fields = (x.target for x in node.body if isinstance(x, ast.AnnAssign))
            yield from ((x.id, x.lineno) for x in fields if isinstance(x, ast.Name))
        if isinstance(node, ast.Attribute):
            yield node.attr, node.lineno
        if isinstance(node, ast.arg | ast.keyword) and node.arg:
            yield node.arg, node.lineno


@pytest.mark.parametrize("path", files(".py") + files(".ipynb"), ids=lambda path: path.relative_to(ROOT).as_posix())
def test_no_replaced_identifier(path: Path) -> None:
    texts = cells(path) if path.suffix == ".ipynb" else [path.read_text("utf-8")]
    free = ORDINARY if path.relative_to(ROOT).as_posix().startswith(DRAWING) else set()
    found = {name for text in texts for name, _ in names(ast.parse(text)) if name in REPLACED} - free
    assert not found, "; ".join(f"{name} is now: {REPLACED[name]}" for name in sorted(found))


def test_every_class_has_a_name_of_its_own() -> None:
    homes: dict[str, list[str]] = {}
    for path in sorted([*(ROOT / "slamlib").rglob("*.py"), *(ROOT / "book/slambook").rglob("*.py")]):
        if {"tests", "generated"} & set(path.parts):
            continue
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
                homes.setdefault(node.name, []).append(path.relative_to(ROOT).as_posix())
    assert {name: where for name, where in homes.items() if len(where) > 1} == {}


# Ordinary English for a difference from a mean, and for going round, is no private word.
PLAIN = {"active_search": ["deviations"], "gaussians": ["deviations", "deviation"], "kalman_filter": ["deviations"]}
PLAIN["monocular"] = ["on the way round", "its place"]


@pytest.mark.parametrize("path", sorted((ROOT / "book/chapters").glob("*.ipynb")), ids=lambda path: path.stem)
def test_no_replaced_phrase(path: Path) -> None:
    """In the prose of a chapter, outside code."""
    cells = json.loads(path.read_text("utf-8"))["cells"]
    prose = "\n".join("".join(cell["source"]) for cell in cells if cell["cell_type"] == "markdown")
    prose = re.sub(r"(?s)```sh\n.*?```|`[^`\n]+`", "", prose)
    found = {(row["term"], m[0]) for row in rows() if row["phrases"] for m in re.finditer(row["phrases"], prose)}
    assert sorted(hit for hit in found if hit[1] not in PLAIN.get(path.stem, [])) == []


def test_every_term_is_in_the_glossary() -> None:
    defined = re.findall(r"(?m)^(\S.*)\n  ", (ROOT / "book/appendices/glossary.md").read_text("utf-8"))
    assert len(defined) == len(set(defined))
    assert {row["term"] for row in rows()} - set(defined) == set()


def test_the_list_is_in_order() -> None:
    assert all(row["term"] for row in rows())
    words = [word for row in rows() for word in row["identifiers"].split()]
    assert len(words) == len(set(words))
    assert all(word.isidentifier() for word in words)
    for row in rows():
        re.compile(row["phrases"])
