"""Run notebooks and store their text outputs; keep images and volatile metadata out of the repository.

`python -m book.tools.notebooks run [FILES]` runs notebooks in place (all of _toc.yml by default); `check` says which
are not in the stored form.
"""

import argparse
import hashlib
import json
import os
import re
import sys
import time
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path
from typing import Any

import nbformat
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError

from book.tools import layout

EXECUTED = layout.BUILD / "executed"
IMAGES = ("image/png", "image/jpeg", "image/svg+xml", "application/pdf", "application/vnd.jupyter.widget-view+json")
NBVAL = ["pytest", "--nbval", "--nbval-current-env", "--nbval-sanitize-with", "book/tools/nbval.cfg", "-q"]
NBVAL += ["-p", "book.tools.notebooks"]  # this module is a plugin of pytest too: what nbval runs is kept for the build
HIDDEN = {  # what JupyterLab folds, for the tags that fold it in the page
    "hide-input": ("source_hidden",),
    "hide-output": ("outputs_hidden",),
    "solution": ("source_hidden", "outputs_hidden"),
}
NOTEBOOK = re.compile(r'"([\w/]+\.ipynb)"')  # the name of one in a cell's code
FIGURE = "nbval-ignore-output"  # cells whose output is a picture, or a time: shown in the book, not compared


class BrokenNotebook(Exception):
    """A notebook that does not run to its end in silence."""


def execute(file: Path) -> Any:
    """The notebook with the outputs of a fresh run; raises BrokenNotebook for an error or anything on stderr."""
    notebook = nbformat.read(file, as_version=4)
    client = NotebookClient(
        notebook,
        timeout=600,
        kernel_name="python3",
        resources={"metadata": {"path": str(file.parent)}},
        store_widget_state=False,
        extra_arguments=["--IPKernelApp.log_level=ERROR"],  # the kernel warns of TCP, here on this machine only
    )
    try:
        client.execute()
    except CellExecutionError as error:
        raise BrokenNotebook(f"{file.name}: a cell failed\n{error}") from None
    for number, cell in enumerate(notebook.cells):
        if cell.cell_type == "code":
            cell.outputs = merged(cell.outputs)
        noise = [o["text"] for o in cell.get("outputs", []) if o.get("name") == "stderr"]
        if noise:
            raise BrokenNotebook(f"{file.name}: cell {number} wrote on stderr: {noise[0][:400]}")
    return notebook


def normalise(notebook: Any) -> Any:
    """The stored form: text outputs, counts 1..n, no images, no volatile metadata; folds that JupyterLab knows, too."""
    notebook.metadata = nbformat.from_dict(
        {
            "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
            "language_info": {"name": "python"},
        }
    )
    count = 0
    for cell in notebook.cells:
        for key in ("execution", "ExecuteTime", "collapsed", "jupyter", "scrolled", "trusted"):
            cell.metadata.pop(key, None)
        if cell.cell_type == "code":
            count += 1
            cell.execution_count = count
            tags = cell.metadata.get("tags", [])
            if hidden := {flag: True for tag in tags for flag in HIDDEN.get(tag, ())}:
                cell.metadata["jupyter"] = hidden
            cell.outputs = [_stored(o, count, FIGURE in tags) for o in merged(cell.outputs)]
    return notebook


def merged(outputs: list[Any]) -> list[Any]:
    """Consecutive pieces of one stream as one piece."""
    merged: list[Any] = []
    for output in outputs:
        if merged and output.output_type == "stream" == merged[-1].output_type and output.name == merged[-1].name:
            merged[-1].text += output.text
        else:
            merged.append(output)
    return merged


def _stored(output: Any, count: int, figure: bool) -> Any:
    if "data" in output:
        kept = {k: v for k, v in output.data.items() if k not in IMAGES and not (figure and k == "text/html")}
        output.data = nbformat.from_dict(kept)
        output.metadata = nbformat.from_dict({})
    if output.output_type == "execute_result":
        output.execution_count = count
    return output


def text(notebook: Any) -> str:
    """The notebook as the repository stores it."""
    return nbformat.writes(notebook, version=4, indent=1, ensure_ascii=False).rstrip("\n") + "\n"


def executed(file: Path, key: str) -> tuple[Path, bool]:
    """A copy of the notebook with all outputs, which are from the cache if code, package and lock are unchanged."""
    cached = _cached(file, key)
    if not cached.is_file():
        return keep(file, execute(file), key), False
    notebook, ran = (nbformat.read(f, as_version=4) for f in (file, cached))
    for cell, kept in zip(code_cells(notebook), code_cells(ran), strict=True):
        cell.outputs, cell.execution_count = kept.outputs, kept.execution_count
    return keep(file, notebook, key), True


def code_cells(notebook: Any) -> list[Any]:
    """The cells that run."""
    return [cell for cell in notebook.cells if cell.cell_type == "code"]


def keep(file: Path, executed: Any, key: str) -> Path:
    """Write the executed copy of a notebook into the cache, in place of older ones; where it is."""
    cached = _cached(file, key)
    layout.write_whole(cached, nbformat.writes(executed).encode())
    for old in EXECUTED.glob(f"{file.stem}.*.ipynb"):
        if old != cached:
            old.unlink()
    return cached


def _cached(file: Path, key: str) -> Path:
    """Where the executed copy is: named by the notebook's code and tags, not its words, and by what it runs on."""
    own = hashlib.sha256(json.dumps(_code(file)).encode()).hexdigest()[:20]
    return EXECUTED / f"{file.stem}.{own}.{key}.ipynb"


def _code(file: Path) -> list[tuple[str, list[str]]]:
    """Code and tags of a notebook, and of those whose cells it runs: the landing page shows a chapter's run."""
    code = [(cell.source, cell.metadata.get("tags", [])) for cell in code_cells(nbformat.read(file, as_version=4))]
    others = [file.parent / name for source, _ in code for name in NOTEBOOK.findall(source)]
    return code + [pair for other in others if other.is_file() for pair in _code(other)]


def each(files: list[Path], action: Any) -> list[tuple[Path, Any]]:
    """Do `action` for each file, two at a time, with a line of progress each; raises the first failure at the end."""
    results, failures = [], []

    def timed(file: Path) -> tuple[float, Any]:
        start = time.perf_counter()
        result = action(file)
        return time.perf_counter() - start, result

    with ThreadPoolExecutor(max_workers=min(2, os.cpu_count() or 1)) as pool:
        began = {pool.submit(timed, f): f for f in files}
        for number, future in enumerate(as_completed(began), start=1):
            file = began[future]
            try:
                seconds, result = future.result()
            except BrokenNotebook as error:
                failures.append(error)
                print(f"  [{number}/{len(files)}] {file.stem:<36} FAILED", flush=True)
                continue
            note = " (cached)" if isinstance(result, tuple) and result[1] else ""
            print(f"  [{number}/{len(files)}] {file.stem:<36} {seconds:6.1f} s{note}", flush=True)
            results.append((file, result))
    if failures:
        raise BrokenNotebook("\n".join(map(str, failures)))
    return results


_outputs: dict[Path, dict[int, list[Any]]] = {}  # of the cells that nbval has run


def pytest_runtest_teardown(item: Any) -> None:
    """Keep the outputs of a cell that nbval has run, pictures and all, so that each notebook is executed once."""
    if hasattr(item, "test_outputs"):
        _outputs.setdefault(Path(item.path), {})[item.cell_num] = item.test_outputs


def pytest_sessionfinish() -> None:
    """Write the notebooks whose cells have all been run, without an error or a warning, where `executed` searches.

    The build runs the others by itself, and reports what is wrong.
    """
    key = layout.digest(layout.package_files()) if _outputs else ""
    for file, found in _outputs.items():
        notebook = nbformat.read(file, as_version=4)
        cells = code_cells(notebook)
        if len(found) < len(cells):
            continue
        for number, cell in enumerate(cells):
            cell.outputs = merged([nbformat.from_dict(output) for output in found[number]])
            cell.execution_count = number + 1
        loud = [o for cell in cells for o in cell.outputs if o.output_type == "error" or o.get("name") == "stderr"]
        if not loud:
            keep(file, notebook, key)


def unstored(files: list[Path]) -> list[Path]:
    """The notebooks that are not in the stored form: images, counts, metadata, or none of its cells with an output."""
    found = []
    for file in files:
        notebook = nbformat.read(file, as_version=4)
        cells = code_cells(notebook)
        never_run = bool(cells) and not any(cell.outputs for cell in cells)
        if never_run or file.read_text("utf-8") != text(normalise(notebook)):
            found.append(file)
    return found


def main(arguments: list[str] | None = None) -> int:
    """Exit status 0 if all is well."""
    parser = argparse.ArgumentParser(prog="python -m book.tools.notebooks", description=__doc__.split("\n")[0])
    parser.add_argument("action", choices=["run", "check"], help="run in place, or check the stored form")
    parser.add_argument("files", nargs="*", type=Path, help="notebooks (default: all of _toc.yml)")
    options = parser.parse_args(arguments)
    files = [f.resolve() for f in options.files] or layout.notebooks()
    if options.action == "run":
        try:
            each(files, lambda file: layout.write_whole(file, text(normalise(execute(file))).encode()))
        except BrokenNotebook as error:
            print(error, file=sys.stderr)
            return 1
    wrong = unstored(files)
    for file in wrong:
        print(f"{file.relative_to(layout.ROOT)}: not in the stored form; run `make notebooks`", file=sys.stderr)
    print(f"notebooks: {len(files)} in the book, {len(wrong)} not in the stored form")
    return 1 if wrong or not files else 0


if __name__ == "__main__":
    sys.exit(main())
