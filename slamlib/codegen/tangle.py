"""The chapter is the source: a cell that starts with `%%tangle slamlib/...py` holds a formula module.

In a notebook, the magic compares the cell with the package and gives the reader the module's names. `make tangle` and
`make untangle` carry such cells into the package's files, and back.
"""

import difflib
import importlib
from pathlib import Path
from types import ModuleType
from typing import Any

import slamlib
from slamlib.errors import SlamlibError
from slamlib.models.in_memory import load

PACKAGE = Path(slamlib.__file__).parent


class DriftError(SlamlibError):
    """A chapter's cell and the package's file differ."""


def register(shell: Any) -> None:
    """Register the magic with an IPython shell, and let it define names there."""

    def tangle(line: str, cell: str) -> None:
        names, drift = run_cell(line.strip(), cell.rstrip("\n") + "\n")
        shell.user_ns.update(names)
        if drift is not None:
            raise drift
        print(f"this cell is {line.strip()}")

    shell.register_magic_function(tangle, "cell", "tangle")


def run_cell(path: str, cell: str) -> tuple[dict[str, Any], DriftError | None]:
    """The public names that the cell defines, and the drift if it is not the package's file.

    A cell that equals the file is the package's own module; an edited one runs by itself, compiled in memory,
    so that a reader can experiment.
    """
    committed = package_text(path)
    if committed == cell:
        return _public(importlib.import_module(path.removesuffix(".py").replace("/", "."))), None
    edited = load(cell, f"<edited {path}>")
    lines = difflib.unified_diff(committed.splitlines(), cell.splitlines(), path, "this cell", lineterm="", n=1)
    advice = "The edited cell has been run, and its names are yours to try. "
    advice += "To keep it: `make tangle`, then `make generate`."
    return _public(edited), DriftError("\n".join([f"this cell is not {path}:", *lines, advice]))


def package_text(path: str) -> str:
    """The text of a file of the package; empty if there is none."""
    file = PACKAGE.parent / path
    return file.read_text("utf-8") if file.is_file() else ""


def _public(loaded: ModuleType) -> dict[str, Any]:
    return {k: v for k, v in vars(loaded).items() if not k.startswith("_")}
