"""Do the tests notice a wrong formula? Small errors, drawn by seed and put into a copy of the code, one at a time.

A *mutant* is the code with one small error: another sign, no transpose, another comparison, another constant, a term
less. The fast tests of its own module have to fail (the mutant is *killed*). One that *survives* either shows what no
test asserts, or computes the same as before: then it stands in mutants.toml with the reason. The working tree is only
read. Formulas are drawn first and mutants among those of each, so that long formulas don't take all.

Of the generated code, the tests against drift and of equality to the definition are left out: they notice everything,
but say nothing about whether a formula is right.
"""

import argparse
import difflib
import os
import queue
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import tomllib
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path

import numpy as np

from book.tools import layout
from book.tools.mutations import Mutant, differs, mutants

COPIED = ("pyproject.toml", "slamlib", "book/slambook", "book/chapters/data")
NO_TESTS = 5  # pytest's exit status


class Subject:
    """A folder and its table: for each area its modules with their tests, what is left out, the known equivalents."""

    def __init__(self, root: Path, table: Path) -> None:
        self.root, self.table = root, table
        data = tomllib.loads(table.read_text("utf-8"))
        tests = Path(data["tests"])
        self.areas: dict[str, dict[str, tuple[str, ...]]] = {
            area: {file: tuple((tests / name).as_posix() for name in names) for file, names in modules.items()}
            for area, modules in data["areas"].items()
        }
        self.files = {file: names for modules in self.areas.values() for file, names in modules.items()}
        self.left_out = [(tests / name).as_posix() for name in data.get("left_out", [])]
        self.equivalents: dict[tuple[str, ...], str] = {
            (row["file"], row["formula"], row["before"], row["after"]): row["reason"]
            for row in data.get("equivalent", [])
        }


SUBJECT = Subject(layout.ROOT, Path(__file__).with_suffix(".toml"))


def draw(subject: Subject, area: str, seed: int, count: int) -> list[Mutant]:
    """So many mutants of an area: formulas in random order, one of each, then another of each, as often as needed."""
    rng = np.random.default_rng([seed, sum(area.encode())])
    formulas: dict[tuple[str, str], list[Mutant]] = {}
    for file in subject.areas[area]:
        for mutant in mutants(subject.root, file):
            formulas.setdefault((file, mutant.formula), []).append(mutant)
    drawn: list[Mutant] = []
    while len(drawn) < count and any(formulas.values()):
        groups = list(formulas.values())
        for i in rng.permutation(len(groups)):
            while groups[i] and len(drawn) < count:
                mutant = groups[i].pop(rng.integers(len(groups[i])))
                if differs(subject.root, mutant):
                    drawn.append(mutant)
                    break
    return drawn


def stale(subject: Subject) -> list[str]:
    """The known equivalents that no error in the present source gives, and those without a reason."""
    rows = subject.equivalents
    files = {key[0] for key in rows}
    keys = {file: {m.key for m in mutants(subject.root, file)} for file in files if (subject.root / file).is_file()}
    lost = [f"{key[0]}: {key[1]}: {key[2]} -> {key[3]}" for key in rows if key not in keys.get(key[0], set())]
    return [*lost, *(f"{key[0]}: {key[2]}: no reason" for key, why in rows.items() if not why.strip())]


def run_tests(subject: Subject, folder: Path, tests: Sequence[str], limit: float | None = None) -> tuple[bool, str]:
    """Whether the tests pass in a copy, and what pytest printed; a run over the limit (s) is ended, and failed.

    Without the installed plugins: to import them takes longer than many a test.
    """
    command = [sys.executable, "-m", "pytest", "-x", "-q", "-p", "no:cacheprovider", *tests]
    command += [argument for test in subject.left_out for argument in ("--deselect", test)]
    paths = os.pathsep.join([str(folder), str(folder / "book")])
    environment = {**os.environ, "PYTHONPATH": paths, "PYTHONDONTWRITEBYTECODE": "1" if limit else ""}
    environment["PYTEST_DISABLE_PLUGIN_AUTOLOAD"] = "1"
    with tempfile.TemporaryFile("w+") as printed:
        run = subprocess.Popen(command, cwd=folder, env=environment, stdout=printed, stderr=printed, process_group=0)
        try:
            code = run.wait(limit)
        except subprocess.TimeoutExpired:
            return False, f"no result after {limit:.0f} s"
        finally:
            if run.poll() is None:  # with what the tests have started
                os.killpg(run.pid, signal.SIGKILL)
                run.wait()
        printed.seek(0)
        text = printed.read()
    if code == NO_TESTS:
        raise SystemExit(f"mutants: no test is left of {', '.join(tests)}")
    return code == 0, text


def copy(subject: Subject, folder: Path) -> None:
    """Copy all that the tests need."""
    for name in COPIED:
        source, target = subject.root / name, folder / name
        target.parent.mkdir(parents=True, exist_ok=True)
        if source.is_dir():
            shutil.copytree(source, target, ignore=shutil.ignore_patterns("__pycache__"))
        elif source.is_file():
            shutil.copyfile(source, target)


class Runner:
    """Copies in which mutants are tested, one in each at a time."""

    def __init__(self, subject: Subject, folders: Sequence[Path], tests: Sequence[str]) -> None:
        """Copy all that is needed; the tests have to pass there first, which also says how long they take."""
        first, *others = folders
        copy(subject, first)
        start = time.monotonic()
        passed, printed = run_tests(subject, first, tests)
        if not passed:
            raise SystemExit(f"mutants: the tests fail without any error put in; repair them first\n{printed}")
        self.limit = 60 + 2 * (time.monotonic() - start)
        self.subject, self.folders = subject, queue.SimpleQueue[Path]()
        for folder in folders:
            self.folders.put(folder)
        for folder in others:
            shutil.copytree(first, folder)  # with the bytecode

    def killed(self, mutant: Mutant) -> str:
        """By which test, or why else, a mutant is killed; '' if it survives."""
        folder, tests = self.folders.get(), self.subject.files[mutant.file]
        file = folder / mutant.file
        source = file.read_bytes()
        try:
            for old in (file.parent / "__pycache__").glob(f"{file.stem}.*"):
                old.unlink()  # Python tells by size and second whether it is still the source's
            file.write_bytes(mutant.applied(source))
            passed, printed = run_tests(self.subject, folder, tests, self.limit)
        finally:
            file.write_bytes(source)
            self.folders.put(folder)
        names = [line.split(" - ")[0] for line in printed.splitlines() if line.startswith(("FAILED", "ERROR"))]
        return "" if passed else f"killed, {next(iter(names), printed.strip()[-80:])}"

    def survivors(self, numbered: Sequence[tuple[int, Mutant]], jobs: int) -> list[Mutant]:
        """Test all mutants, and print a line for each."""
        with ThreadPoolExecutor(jobs) as pool:
            try:
                left, runs = [], {pool.submit(self.killed, mutant): (i, mutant) for i, mutant in numbered}
                for done, run in enumerate(as_completed(runs), 1):
                    (i, mutant), by = runs[run], run.result()
                    print(f"{done}/{len(runs)} #{i} {mutant}: {by or 'SURVIVED'}", flush=True)
                    left += [] if by else [mutant]
            except BaseException:
                pool.shutdown(cancel_futures=True)
                raise
        return left


def main(argv: Sequence[str] | None = None, subject: Subject = SUBJECT) -> int:
    """Draw, test and print; 1 if a mutant survives that is not known to be equivalent, or a known one is stale."""
    parser = argparse.ArgumentParser(prog="python -m book.tools.mutants", description=__doc__.split("\n")[0])
    parser.add_argument("--area", action="append", choices=list(subject.areas), help="default: all")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--count", type=int, default=40, help="mutants of each area")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--only", action="append", help="number of a mutant, or a part of its name; with its diff")
    parser.add_argument("--list", action="store_true", help="print the mutants, test none")
    options = parser.parse_args(argv)
    if lost := stale(subject):
        print(*lost, sep="\n")
        print(f"mutants: {len(lost)} rows of {subject.table.name} are stale: correct them or take them out")
        return 1
    areas = options.area or list(subject.areas)
    drawn = [mutant for area in areas for mutant in draw(subject, area, options.seed, options.count)]
    numbered = list(enumerate(drawn, 1))
    if options.only:
        numbered = [
            (i, m) for i, m in numbered if any(w == str(i) if w.isdigit() else w in str(m) for w in options.only)
        ]
        print(*(diff(subject, mutant) for _, mutant in numbered), sep="\n")
    if options.list:
        print(*(f"{i} {mutant}" for i, mutant in numbered), sep="\n")
        return 0
    with tempfile.TemporaryDirectory() as folder:
        tests = sorted({test for _, mutant in numbered for test in subject.files[mutant.file]})
        runner = Runner(subject, [Path(folder, str(i)) for i in range(options.jobs)], tests)
        left = runner.survivors(numbered, options.jobs)
    new = [mutant for mutant in left if mutant.key not in subject.equivalents]
    for mutant in new:
        print(f"\nsurvived: {mutant}", diff(subject, mutant), sep="\n")
    print(f"mutants: {len(numbered)} drawn, {len(numbered) - len(left)} killed, {len(left)} survived, "
          f"of which {len(left) - len(new)} are known to be equivalent")  # fmt: skip
    return 1 if new else 0


def diff(subject: Subject, mutant: Mutant) -> str:
    """The lines that an error changes, in their surroundings."""
    source = (subject.root / mutant.file).read_bytes()
    old, new = source.decode().splitlines(), mutant.applied(source).decode().splitlines()
    title = f"{mutant.formula}: {mutant.kind}"
    return "\n".join(difflib.unified_diff(old, new, mutant.file, title, n=2, lineterm=""))


if __name__ == "__main__":
    sys.exit(main())
