"""A pytest plugin beside nbval: what nbval ran is what the build shows, so that each notebook is executed once.

nbval runs every cell and compares it with what the notebook stores. Its outputs, pictures and all, are written where
`book.tools.notebooks.executed` looks for them; a notebook in which a cell failed, was left out or wrote on stderr is
not written, and the build runs it by itself and says what is wrong.
"""

from pathlib import Path
from typing import Any

import nbformat

from book.tools import layout, notebooks

_outputs: dict[Path, dict[int, list[Any]]] = {}


def pytest_runtest_teardown(item: Any) -> None:
    """Keep the outputs of a cell that nbval has run."""
    if hasattr(item, "test_outputs"):
        _outputs.setdefault(Path(item.path), {})[item.cell_num] = item.test_outputs


def pytest_sessionfinish() -> None:
    """Write the notebooks whose cells have all been run, in silence and without an error."""
    key = layout.digest(layout.package_files()) if _outputs else ""
    for file, found in _outputs.items():
        notebook = nbformat.read(file, as_version=4)
        cells = [cell for cell in notebook.cells if cell.cell_type == "code"]
        if len(found) < len(cells):
            continue
        for number, cell in enumerate(cells):
            cell.outputs = notebooks.merged([nbformat.from_dict(output) for output in found[number]])
            cell.execution_count = number + 1
        loud = [o for cell in cells for o in cell.outputs if o.output_type == "error" or o.get("name") == "stderr"]
        if not loud:
            notebooks.keep(file, notebook, key)
