"""Command line: write slamlib/generated, or check that it is current."""

import argparse
import difflib
import os
import subprocess
import sys
import tempfile
from collections.abc import Collection
from pathlib import Path

import numpy as np
import sympy

import slamlib
from slamlib.codegen.emit import module
from slamlib.codegen.proof import random_arguments
from slamlib.errors import entry
from slamlib.models import FORMULA_PARTS, Model
from slamlib.models.in_memory import load
from slamlib.models.numerical import scaled_differences
from slamlib.plain_data.files import write_whole
from slamlib.registry import modules_of

PACKAGE = Path(slamlib.__file__).parent
TARGET = PACKAGE / "generated"
HEADER = '"""Generated code: made by `make generate` from the models of the package, never edited by hand."""\n'


def models() -> dict[str, list[Model]]:
    """The models of each formula module, by the module's path in the package: 'geometry/pose.py'."""
    found: dict[str, list[Model]] = {}
    for part in FORMULA_PARTS:
        for loaded in modules_of(f"slamlib.{part}"):
            own = [v for v in vars(loaded).values() if isinstance(v, Model) and v.module == loaded.__name__]
            if own:
                found[f"{part}/{loaded.__name__.split('.')[-1]}.py"] = own
    return found


def generate(only: Collection[str] = ()) -> dict[str, str]:
    """Text of every generated file, or of the modules `only`, by its path below slamlib/generated."""
    files = {"__init__.py": HEADER}
    known = models()
    for path, own in {path: entry("module with models", path, known) for path in only or known}.items():
        print(f"  {path}: {len(own)} models", file=sys.stderr)
        files[f"{path.split('/')[0]}/__init__.py"] = HEADER
        files[path] = module(own, f"slamlib/{path}")
    return files


def write(target: Path, only: Collection[str] = ()) -> int:
    """Write all generated files, each atomically, and remove those without a source file.

    only: the modules to write, as 'landmarks/ahm_point.py'; then nothing is removed.
    """
    files = generate(only)
    for path, text in files.items():
        file = target / path
        file.parent.mkdir(parents=True, exist_ok=True)
        write_whole(file, text)
    for left_over in set() if only else texts(target).keys() - files.keys():
        (target / left_over).unlink()
    return len(files)


def texts(folder: Path) -> dict[str, str]:
    """Text of every file in a folder, by its relative path."""
    return {f.relative_to(folder).as_posix(): f.read_text("utf-8") for f in folder.rglob("*.py")}


def check() -> list[str]:
    """Differences between slamlib/generated and what two fresh runs generate."""
    one, two = generated_twice()
    committed = texts(TARGET)
    found = (_problem(path, committed.get(path), one.get(path), two.get(path)) for path in sorted(one | committed))
    return [problem for problem in found if problem]


def generated_twice() -> tuple[dict[str, str], dict[str, str]]:
    """Texts of all generated files by two fresh runs, under two hash seeds. Raises SystemExit where one fails."""
    with tempfile.TemporaryDirectory() as scratch:
        folders = [Path(scratch) / seed for seed in ("1", "2")]
        paths = [str(PACKAGE.parent), *filter(None, sys.path)]
        runs = [
            subprocess.Popen(
                [sys.executable, "-m", "slamlib.codegen", "--into", str(folder)],
                env={**os.environ, "PYTHONHASHSEED": folder.name, "PYTHONPATH": os.pathsep.join(paths)},
                stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
            )
            for folder in folders
        ]  # fmt: skip
        for run in runs:
            errors = run.communicate()[1]
            if run.returncode:
                raise SystemExit(errors)
        return texts(folders[0]), texts(folders[1])


def _problem(path: str, committed: str | None, one: str | None, two: str | None) -> str | None:
    """What is wrong with a file's committed text, as two runs generate it; None if it is current.

    Current is the same text, or under another sympy version the same numbers to 1e-12.
    """
    if one != two:
        return f"{path}: the text depends on the hash seed\n{_diff(path, one or '', two or '')}"
    if one is None:
        return f"{path}: no model stands behind it; run `make generate`"
    if committed is None:
        return f"{path}: missing; run `make generate`"
    if committed == one:
        return None
    if f"(sympy {sympy.__version__})" in committed or path.endswith("__init__.py"):
        return f"{path}: not what the models give; run `make generate`\n{_diff(path, committed, one)}"
    old, new = load(committed, f"<committed {path}>"), load(one, f"<generated {path}>")
    if old.DIGESTS != new.DIGESTS:
        return f"{path}: the definitions have changed; run `make generate`"
    rng = np.random.default_rng(1)
    for model in models()[path]:
        arguments = [[float(x) for x in np.ravel(a)] for a in random_arguments(model, rng)]
        for name in (n for n in vars(new) if n in (model.name, f"{model.name}_jac")):
            a, b = (np.array(getattr(m, name)(*arguments)) for m in (old, new))
            if a.shape != b.shape or (scaled_differences(a, b) > 1e-12).any():
                return f"{path}: {name} gives other numbers than the models; run `make generate`"
    return None


def _diff(path: str, old: str, new: str) -> str:
    lines = difflib.unified_diff(
        old.splitlines(), new.splitlines(), f"committed/{path}", f"generated/{path}", lineterm="", n=2
    )
    return "\n".join(list(lines)[:60])


def main(arguments: list[str] | None = None) -> int:
    """Return exit status 0 if all is written, or current."""
    what = "Generate NumPy code from the models of slamlib."
    parser = argparse.ArgumentParser(prog="python -m slamlib.codegen", description=what)
    what = "write nothing; compare slamlib/generated with what the models give"
    parser.add_argument("--check", action="store_true", help=what)
    parser.add_argument("--into", type=Path, default=TARGET, help="folder to write into (default: slamlib/generated)")
    parser.add_argument("only", nargs="*", help="write only these modules, such as landmarks/ahm_point.py")
    options = parser.parse_args(arguments)
    if not options.check:
        print(f"generated {write(options.into, options.only)} files in {options.into}")
        return 0
    problems = check()
    for problem in problems:
        print(problem, file=sys.stderr)
    count = sum(map(len, models().values()))
    print(f"generated code: {count} models in {len(texts(TARGET))} files, {len(problems)} out of date")
    return 1 if problems or not count else 0


if __name__ == "__main__":
    sys.exit(main())
