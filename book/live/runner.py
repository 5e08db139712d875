"""Runs the cells of a page: one namespace, results as messages, errors that point to the reader's line.

The worker gives `send(kind, text)`, which shows something in the page, and `fetch(name)`, which returns a file's bytes.
"""

import ast
import importlib
import importlib.abc
import importlib.util
import io
import json
import linecache
import re
import sys
import time
import traceback
import zipfile
from pathlib import Path
from typing import Any

LIMIT = 100_000  # characters that one cell may print: a page with more of them does not scroll any more
PACKAGES = "/packages"
STAND_IN = "standin"  # the folder beside this file that is imported under the name matplotlib
MAGIC = re.compile(r"^%(\w+)[ \t]*(.*)$", re.MULTILINE)
SHOWN = ("_repr_html_", "_repr_svg_", "_repr_latex_", "_repr_markdown_")


class Runner:
    """The page's interpreter: what the cells have defined, and the figures whose sliders ask for new frames."""

    def __init__(self, send: Any, fetch: Any, later: dict[str, str]) -> None:
        self.send = send
        self.figures: dict[str, Any] = {}
        self.user_ns: dict[str, Any] = {"__name__": "__main__", "get_ipython": lambda: self}
        self.magics: dict[str, Any] = {"load_ext": self.load_extension}
        sys.meta_path.insert(0, StandIn(Path(__file__).with_name(STAND_IN)))
        sys.meta_path.append(Later(fetch, later))

    def run(self, code: str, cell: str, limit: int | None = None) -> bool:
        """Run a cell named `cell`; what it shows is sent, of texts `limit` characters at most; False if it failed."""
        code = MAGIC.sub(lambda m: f"get_ipython().run_line_magic({m[1]!r}, {m[2].strip()!r})", code)
        if code.startswith("%%"):
            first, _, body = code.partition("\n")
            name, _, line = first[2:].partition(" ")
            code = f"get_ipython().run_cell_magic({name!r}, {line.strip()!r}, {body!r})"
        linecache.cache[cell] = (len(code), None, code.splitlines(keepends=True), cell)
        out, err = (Printer(self.send, kind, LIMIT if limit is None else limit) for kind in ("stdout", "stderr"))
        before = sys.stdout, sys.stderr
        sys.stdout, sys.stderr = out, err
        try:
            tree = ast.parse(code, cell)
            last: Any = tree.body.pop() if _ends_in_a_value(tree, code) else None
            exec(compile(tree, cell, "exec"), self.user_ns)
            value = eval(compile(ast.Expression(last.value), cell, "eval"), self.user_ns) if last else None
            self.show(value, cell, out)
            for figure in _open_figures():
                if figure is not value:
                    self.show(figure, cell, out)
            return True
        except BaseException as error:
            out.flush()
            self.send("error", json.dumps(described(error, cell)))
            return False
        finally:
            out.close()
            err.close()
            sys.stdout, sys.stderr = before

    def show(self, value: Any, cell: str, out: "Printer") -> None:
        """Send a cell's value in the richest form it has, and always as text."""
        if value is None:
            return
        out.flush()
        shown = {"text": repr(value)[:LIMIT]}
        if hasattr(value, "frame"):
            self.figures[cell] = value
            shown["slider"] = json.dumps(
                {
                    "key": cell,
                    "label": value.label,
                    "last": len(value.values) - 1,
                    "start": value.start,
                    "steps": value.steps,
                    "names": value.names,
                    "button": value.button,
                    "frame": value.frame(value.start),
                }
            )
        else:
            for name in SHOWN:
                made = getattr(value, name)() if hasattr(type(value), name) else None
                if made is not None:
                    shown[name[6:-1]] = made
                    break
        self.send("value", json.dumps(shown))

    def register_magic_function(self, function: Any, kind: str, name: str) -> None:
        """What an extension calls to make a magic known, as in IPython."""
        self.magics[name] = function

    def run_line_magic(self, name: str, *arguments: str) -> None:
        """Run a magic; raises NameError for one that nobody has registered."""
        if name not in self.magics:
            raise NameError(f"the magic {name!r} is not known in the page")
        self.magics[name](*arguments)

    run_cell_magic = run_line_magic

    def load_extension(self, module: str) -> None:
        """%load_ext: the module registers its magics."""
        importlib.import_module(module).load_ipython_extension(self)

    def frame(self, key: str, position: float) -> str:
        """The frame of a figure at a place of its slider, as JSON: value, SVG, note."""
        return json.dumps(self.figures[key].frame(position))


class Printer(io.TextIOBase):
    """What a cell prints, sent in pieces; the middle of something endless is left out."""

    def __init__(self, send: Any, kind: str, limit: int) -> None:
        self.forward, self.kind, self.limit = send, kind, limit
        self.waiting: list[str] = []
        self.sent, self.dropped, self.last = 0, 0, time.monotonic()

    def write(self, text: str) -> int:
        """Keep the text for the next piece."""
        room = max(0, self.limit - self.sent)
        self.waiting.append(text[:room])
        self.sent += min(room, len(text))
        self.dropped += max(0, len(text) - room)
        if time.monotonic() - self.last > 0.1:
            self.flush()
        return len(text)

    def flush(self) -> None:
        """Send what waits."""
        if any(self.waiting):
            self.forward(self.kind, "".join(self.waiting))
        self.waiting.clear()
        self.last = time.monotonic()

    def close(self) -> None:
        """Send the rest, and say how much was left out."""
        self.flush()
        if self.dropped:
            self.forward("stderr", f"\n[{self.dropped:,} more characters were printed; they are not shown]\n")
            self.dropped = 0
        super().close()


class Later(importlib.abc.MetaPathFinder):
    """Fetches a large package when it is imported for the first time."""

    def __init__(self, fetch: Any, later: dict[str, str]) -> None:
        self.fetch, self.later = fetch, dict(later)

    def find_spec(self, name: str, path: Any = None, target: Any = None) -> Any:
        """The module, from the archive that has it."""
        archive = self.later.get(name)
        if archive is None:
            return None
        self.later = {n: a for n, a in self.later.items() if a != archive}
        with zipfile.ZipFile(io.BytesIO(self.fetch(archive))) as packed:
            packed.extractall(PACKAGES)
        sys.path.append(PACKAGES)
        importlib.invalidate_caches()
        return importlib.util.find_spec(name)


class StandIn(importlib.abc.MetaPathFinder):
    """Imports a folder under the name matplotlib."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def find_spec(self, name: str, path: Any = None, target: Any = None) -> Any:
        """matplotlib and its parts, as far as the folder has them; raises ModuleNotFoundError for other parts."""
        package, _, part = name.partition(".")
        if package != "matplotlib":
            return None
        if not part:
            start, inside = self.folder / "__init__.py", [str(self.folder)]
            return importlib.util.spec_from_file_location(name, start, submodule_search_locations=inside)
        file = self.folder / f"{part}.py"
        if not file.is_file():
            said = f"the page's matplotlib is a small stand-in: it has matplotlib.pyplot, and no {name}"
            raise ModuleNotFoundError(said, name=name)
        return importlib.util.spec_from_file_location(name, file)


def described(error: BaseException, cell: str) -> dict[str, Any]:
    """An error as the reader needs it: the steps through the page's cells, the last one, and the line in this cell."""
    chain = [traceback.extract_tb(e.__traceback__) for e in (error.__cause__, error) if e is not None]
    line = next((step.lineno for steps in chain for step in reversed(steps) if step.filename == cell), None)
    own = [step for step in chain[-1] if _is_cell(step)]
    if isinstance(error, SyntaxError) and error.filename == cell:
        line = error.lineno
    if hasattr(error, "_render_traceback_"):  # IPython's way for an error to say how it wants to be shown
        text = "\n".join(error._render_traceback_())
    else:
        shown = own + [step for step in chain[-1][-1:] if own and not _is_cell(step)]
        head = ["Traceback (most recent call last):\n", *traceback.format_list(shown)] if shown else []
        text = "".join([*head, *traceback.format_exception_only(error)])
    return {"line": line, "name": type(error).__name__, "text": text}


def _open_figures() -> list[Any]:
    """Figures that the cell has made and not handed on: shown at its end, as a notebook does."""
    shown = getattr(sys.modules.get("matplotlib.pyplot"), "shown", list)
    return list(shown())


def _is_cell(step: traceback.FrameSummary) -> bool:
    return step.filename.startswith("cell ")


def _ends_in_a_value(tree: ast.Module, code: str) -> bool:
    return bool(tree.body) and isinstance(tree.body[-1], ast.Expr) and not code.rstrip().endswith(";")
