"""Write the package's formula modules from the chapters' cells that begin with %%tangle, or carry them back.

`python -m book.tools.tangle` writes the files, `--back` carries an editor's change of a file into its chapter's cell,
and `--check` compares. In a notebook the magic of slamlib.codegen.tangle runs such a cell.
"""

import argparse
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import nbformat

from book.tools import layout, notebooks
from slamlib.codegen import tangle
from slamlib.errors import SlamlibError
from slamlib.models import FORMULA_PARTS

MAGIC = "%%tangle "


def cells(book: Path) -> Iterator[tuple[Path, Any, str, str, Any]]:
    """Every tangled cell of the book: notebook, its content, path of the module, its text, and the cell."""
    for file in sorted(book.rglob("*.ipynb")):
        if any(part.startswith((".", "_")) for part in file.relative_to(book).parts):
            continue
        content = nbformat.read(file, as_version=4)
        for cell in content.cells:
            if cell.cell_type == "code" and cell.source.startswith(MAGIC):
                first, _, text = cell.source.partition("\n")
                yield file, content, first.removeprefix(MAGIC).strip(), text.rstrip("\n") + "\n", cell


def formula_modules() -> set[str]:
    """Files of the package that define a model, as 'slamlib/geometry/pose.py'."""
    files = (f for part in FORMULA_PARTS for f in (tangle.PACKAGE / part).glob("*.py"))
    return {f.relative_to(tangle.PACKAGE.parent).as_posix() for f in files if "\n@model(" in f.read_text("utf-8")}


def check(book: Path) -> list[str]:
    """What is missing, written twice or different between the chapters and the package."""
    found: dict[str, str] = {}
    problems = []
    for notebook, _, path, text, _ in cells(book):
        if path in found:
            problems.append(f"{path}: written twice, in {found[path]} and in {notebook.name}; keep one cell")
        found[path] = notebook.name
        if tangle.package_text(path) != text:
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
        if tangle.package_text(path) != text:
            layout.write_whole(tangle.PACKAGE.parent / path, text.encode())
            print(f"wrote {path}")
            changed += 1
    return changed


def back(book: Path) -> int:
    """Copy the package's files into the chapters' cells; returns how many changed."""
    changed = {}
    for notebook, content, path, text, cell in cells(book):
        own = tangle.package_text(path)
        if own and own != text:
            cell.source = f"{MAGIC}{path}\n{own}".rstrip("\n")
            changed[notebook] = content
    for notebook, content in changed.items():
        layout.write_whole(notebook, notebooks.text(content).encode())
        print(f"updated {notebook.name}")
    return len(changed)


def main(arguments: list[str] | None = None) -> int:
    """Return exit status 0 if chapters and package agree afterwards."""
    parser = argparse.ArgumentParser(prog="python -m book.tools.tangle", description=__doc__.split("\n")[0])
    group = parser.add_mutually_exclusive_group()
    what = "write nothing; compare the chapters' cells with the package"
    group.add_argument("--check", action="store_true", help=what)
    group.add_argument("--back", action="store_true", help="carry changed package files back into the chapters")
    parser.add_argument("--book", type=Path, default=layout.BOOK, help="folder of the notebooks")
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
