"""The page of notation: each letter once, in use where it is said to be, and names of the package that are there."""

import ast
import json
import re
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from book.tools import layout

sys.path.append(str(layout.BOOK / "_ext"))
import api_reference

CHAPTERS = sorted((layout.BOOK / "chapters").glob("*.ipynb"))
MATH = re.compile(r"\$\$(.+?\$\$(?: \([\w-]+\))?)|(?<!\$)\$([^$\n]+?)\$(?!\$)", re.DOTALL)
WORD = re.compile(r"\$\$.*|\\(?:text|mathrm|operatorname|mathcal|mathbf)\s*(?:\{[^{}]*\}|\w)|\\(?:begin|end)\{\w+\}")


def tables() -> dict[str, list[list[str]]]:
    """The rows of the page's tables, by their headings."""
    found: dict[str, list[list[str]]] = {}
    for part in (layout.BOOK / "appendices" / "notation.md").read_text("utf-8").split("\n## ")[1:]:
        lines = [line for line in part.splitlines() if line.startswith("|")]
        found[part.partition("\n")[0]] = [[cell.strip() for cell in line[1:-1].split(" |")] for line in lines[2:]]
    return found


TABLES = tables()


def formulas(chapter: Path) -> str:
    """What a chapter's text sets as mathematics."""
    cells = json.loads(chapter.read_text("utf-8"))["cells"]
    text = "\n".join("".join(cell["source"]) for cell in cells if cell["cell_type"] == "markdown")
    return "\n".join(next(filter(None, groups)) for groups in MATH.findall(text))


FORMULAS = {chapter.stem: formulas(chapter) for chapter in CHAPTERS}


def chapter_of(label: str) -> str:
    (home,) = (name for name, text in FORMULAS.items() if re.search(rf"\$\$ \({label}\)", text))
    return home


def uses(chapter: str, letter: str) -> bool:
    """Whether a letter, which may be a Greek one, stands by itself in a formula of the chapter."""
    text = WORD.sub(" ", FORMULAS[chapter])
    return (
        re.search(
            re.escape(letter) + r"(?![A-Za-z])" if letter[0] == "\\" else rf"(?<![A-Za-z\\]){letter}(?![A-Za-z])", text
        )
        is not None
    )


def test_no_letter_and_no_sign_is_listed_twice():
    listed = [row[0] for name in ("Letters", "Signs") for row in TABLES[name]]
    assert len(listed) > 60
    assert len(listed) == len(set(listed))
    assert all(re.fullmatch(r"\$(\\?[A-Za-z]+)\$", row[0]) for row in TABLES["Letters"])
    second = [(row[0], row[1]) for row in TABLES["Second meanings"]]
    assert len(second) == len(set(second))


@pytest.mark.parametrize("row", TABLES["Letters"] + TABLES["Signs"], ids=lambda row: row[0])
def test_a_symbol_is_used_where_it_is_said_to_be_defined(row):
    symbol = row[0].strip("$")
    defined = re.findall(r"\{eq\}`([\w-]+)`", " ".join(row))
    assert defined
    for chapter in map(chapter_of, defined):
        if row in TABLES["Letters"]:
            assert uses(chapter, symbol), chapter
        else:
            assert re.sub(r"[\s;]|\\,", "", symbol) in re.sub(r"[\s;]|\\,", "", FORMULAS[chapter]), chapter


@pytest.mark.parametrize("row", TABLES["Second meanings"], ids=lambda row: f"{row[0]} {row[1]}")
def test_a_second_meaning_is_of_a_letter_that_these_chapters_use(row):
    letter, chapters = row[0].strip("$"), re.findall(r"\{doc\}`\.\./chapters/(\w+)`", row[3])
    assert chapters
    assert [name for name in chapters if not uses(name, letter)] == []


def test_the_names_of_the_package_are_there_once():
    rows = TABLES["Letters"] + TABLES["Signs"]
    found = {name for row in rows for name in re.findall(r"`(\w+(?:\.\w+)*)`", " ".join(row[-2:]))}
    known = set(names())
    ours = [name for name in found if re.match("[A-Z][a-z]+[.A-Z][a-z]+", name) or re.match(r"[a-z_]+\.", name)]
    toolbox = {name for row in TABLES["Letters"] for name in re.findall(r"`([^`]+)`", row[-1])}
    ours = [name for name in ours if name not in toolbox]
    assert len(ours) > 35
    for name in ours:
        assert sum(full.endswith(f".{name}") for full in known) == 1, name


def names() -> Iterator[str]:
    """All that is public in slamlib, with its fields and methods, by full names."""
    folders = [f.name for f in (layout.ROOT / "slamlib").iterdir() if (f / "__init__.py").is_file()]
    for package in ["slamlib", *(f"slamlib.{name}" for name in folders if name not in ("tests", "generated"))]:
        for module in api_reference.modules(package):
            yield module.name
            for name, node in module.public().items():
                yield f"{module.name}.{name}"
                for inner in getattr(node, "body", []):
                    if isinstance(inner, ast.FunctionDef):
                        yield f"{module.name}.{name}.{inner.name}"
                    elif isinstance(inner, ast.AnnAssign):
                        yield f"{module.name}.{name}.{ast.unparse(inner.target)}"


WORDS = {  # words that name one letter where they stand right before it, as in "gain $K$"
    "rotation": r"C \delta",
    "gain": "K",
    "innovation": r"\nu",
    "measurement": "z y s",
    "control": "u",
    "noise": "R Q v w",
    "covariance": r"P Q R U S E N \Omega X A B c",
    "orientation": "q C",
    "quaternion": "q",
}
EXCEPTIONS = 71  # chapters in the table of second meanings: a limit that no change may exceed


def test_second_meanings_grow_no_more():
    assert sum(row[3].count("{doc}") for row in TABLES["Second meanings"]) <= EXCEPTIONS


@pytest.mark.parametrize("chapter", CHAPTERS, ids=lambda path: path.stem)
def test_a_word_that_names_a_letter_stands_before_no_other(chapter):
    cells = json.loads(chapter.read_text("utf-8"))["cells"]
    text = "\n".join("".join(cell["source"]) for cell in cells if cell["cell_type"] == "markdown")
    listed = {row[0].strip("$") for row in TABLES["Letters"]}
    pairs = re.findall(rf"\b({'|'.join(WORDS)}) (?:matrix )?\$(\\?[A-Za-z]+)(?:_\w|_\{{[^}}]*\}}|')?\$", text)
    assert [(w, x) for w, x in pairs if x in listed and x not in WORDS[w].split()] == []
