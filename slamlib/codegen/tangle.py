"""The chapter is the source: a cell that starts with `%%tangle slamlib/...py` holds a formula module.

In a notebook, the magic compares the cell with the package and gives the reader the module's names. On the command
line, `python -m slamlib.codegen.tangle` writes the package's files from the chapters, `--back` carries an editor's
change of a file into its chapter's cell, and `--check` compares.
"""

import argparse
import difflib
import importlib
import json
import sys
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType
from typing import Any

import slamlib
from slamlib.data.files import write_whole
from slamlib.errors import SlamlibError
from slamlib.model import FORMULA_PARTS
from slamlib.modeling.in_memory import load

PACKAGE = Path(slamlib.__file__).parent
MAGIC = "%%tangle "


class DriftError(SlamlibError):
    """A chapter's cell and the package's file differ."""


def register(shell: Any) -> None:
    """Register the magic with an IPython shell, and let it define names there."""

    def tangle(line: str, cell: str) -> None:
        names, drift = run_cell(line.strip(), cell.rstrip("\n") + "\n")
        shell.user_ns.update(names)
        if drift is not None:
            raise drift
        print(f"{line.strip()}: {len(cell.splitlines())} lines, the same in slamlib")

    shell.register_magic_function(tangle, "cell", "tangle")


def run_cell(path: str, cell: str) -> tuple[dict[str, Any], DriftError | None]:
    """The public names that the cell defines, and the drift if it is not the package's file.

    A cell that equals the file is the package's own module; an edited one runs by itself, compiled in memory,
    so that a reader can experiment.
    """
    committed = _package_text(path)
    if committed == cell:
        return _public(importlib.import_module(path.removesuffix(".py").replace("/", "."))), None
    edited = load(cell, f"<edited {path}>")
    lines = difflib.unified_diff(committed.splitlines(), cell.splitlines(), path, "this cell", lineterm="", n=1)
    advice = "The edited cell has been run, and its names are yours to try. "
    advice += "To keep it: `make tangle`, then `make generate`."
    return _public(edited), DriftError("\n".join([f"this cell is not {path}:", *lines, advice]))


def _package_text(path: str) -> str:
    """The text of a file of the package; empty if there is none."""
    file = PACKAGE.parent / path
    return file.read_text("utf-8") if file.is_file() else ""


def _public(loaded: ModuleType) -> dict[str, Any]:
    return {k: v for k, v in vars(loaded).items() if not k.startswith("_")}


def cells(book: Path) -> Iterator[tuple[Path, dict[str, Any], str, str, dict[str, Any]]]:
    """Every tangled cell of the book: notebook, its content, path of the module, its text, and the cell."""
    for notebook in sorted(book.rglob("*.ipynb")):
        if any(part.startswith((".", "_")) for part in notebook.relative_to(book).parts):
            continue
        content = json.loads(notebook.read_text("utf-8"))
        for cell in content["cells"]:
            source = "".join(cell["source"])
            if cell["cell_type"] == "code" and source.startswith(MAGIC):
                first, _, text = source.partition("\n")
                yield notebook, content, first.removeprefix(MAGIC).strip(), text.rstrip("\n") + "\n", cell


def formula_modules() -> set[str]:
    """Files of the package that define a model, as 'slamlib/geometry/pose.py'."""
    files = (f for part in FORMULA_PARTS for f in (PACKAGE / part).glob("*.py"))
    return {f.relative_to(PACKAGE.parent).as_posix() for f in files if "\n@model(" in f.read_text("utf-8")}


def check(book: Path) -> list[str]:
    """What is missing, written twice or different between the chapters and the package."""
    found: dict[str, str] = {}
    problems = []
    for notebook, _, path, text, _ in cells(book):
        if path in found:
            problems.append(f"{path}: written twice, in {found[path]} and in {notebook.name}; keep one cell")
        found[path] = notebook.name
        if _package_text(path) != text:
            problems.append(f"{path}: differs from its cell in {notebook.name}; run `make tangle` or `make untangle`")
    problems += [
        f"{path}: no chapter derives it; a formula module is tangled from one cell"
        for path in formula_modules() - found.keys()
    ]
    return problems


def write(book: Path) -> int:
    """Write the package's files from the chapters; returns how many changed."""
    changed = 0
    for _, _, path, text, _ in cells(book):
        if not path.startswith("slamlib/") or ".." in path:
            raise SlamlibError(f"%%tangle {path}: a cell may only write below slamlib/")
        if _package_text(path) != text:
            file = PACKAGE.parent / path
            file.parent.mkdir(parents=True, exist_ok=True)
            write_whole(file, text)
            print(f"wrote {path}")
            changed += 1
    return changed


def back(book: Path) -> int:
    """Copy the package's files into the chapters' cells; returns how many changed."""
    changed = {}
    for notebook, content, path, text, cell in cells(book):
        own = _package_text(path)
        if own and own != text:
            cell["source"] = f"{MAGIC}{path}\n{own}".rstrip("\n").splitlines(keepends=True)
            changed[notebook] = content
    for notebook, content in changed.items():
        write_whole(notebook, json.dumps(content, indent=1, ensure_ascii=False) + "\n")
        print(f"updated {notebook.name}")
    return len(changed)


def main(arguments: list[str] | None = None) -> int:
    """Return exit status 0 if chapters and package agree afterwards."""
    parser = argparse.ArgumentParser(prog="python -m slamlib.codegen.tangle", description=__doc__.split("\n")[0])
    group = parser.add_mutually_exclusive_group()
    what = "write nothing; compare the chapters' cells with the package"
    group.add_argument("--check", action="store_true", help=what)
    group.add_argument("--back", action="store_true", help="carry changed package files back into the chapters")
    parser.add_argument("--book", type=Path, default=PACKAGE.parent / "book", help="folder of the notebooks")
    options = parser.parse_args(arguments)
    if options.back or not options.check:
        print(f"{(back if options.back else write)(options.book)} files changed")
    problems = check(options.book)
    for problem in problems:
        print(problem, file=sys.stderr)
    count = sum(1 for _ in cells(options.book))
    print(f"tangled cells: {count} in the book, {len(formula_modules())} formula modules, {len(problems)} problems")
    return 1 if problems or not count else 0


if __name__ == "__main__":
    sys.exit(main())
