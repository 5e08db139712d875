"""Run every check, quick ones first, and report at the end how each went; a stage that runs nothing has failed.

After a stage that failed the others are left out (`--keep-going` runs them): what they would say can wait.
"""

import argparse
import re
import resource
import subprocess
import sys
import time
from collections.abc import Iterable
from dataclasses import dataclass

from book.tools import layout, notebooks
from book.tools.browser import SKIPPED

PYTHON = [sys.executable, "-m"]
FAILURES = ("FAILED", "NOTHING")
LIVE_MINUTES = "2"  # after which no further cell is run live in `make test`; `make test-all` runs them all


@dataclass(frozen=True)
class Stage:
    """A command, and the pattern of the line that counts what it did: the first group must be at least one."""

    name: str
    command: list[str]
    count: str
    unit: str
    always: bool = True  # False: only where it is named


@dataclass(frozen=True)
class Result:
    """How a stage went."""

    stage: Stage
    status: str
    number: int
    seconds: float
    processor: float = 0.0

    def __str__(self) -> str:
        counted = f"{self.stage.name:<10} {self.status:<8} {self.number:>5} {self.stage.unit:<28}"
        return f"{counted} {self.seconds:6.0f} s {self.processor / 60:6.1f} CPU min"


def stages(every: bool = False) -> list[Stage]:
    """The checks, quick ones first; every: all pages in the browser, changed or not."""
    parallel = ["-n", "2", "--dist", "loadscope"]
    site = [*PYTHON, "pytest", "-q", "-rs", "book/tests/site"]
    chromium = [*site, "-n", "2", "--maxschedchunk", "1"]
    pages, minutes = (["--every-page"], []) if every else ([], ["--minutes", LIVE_MINUTES])
    typed = [
        f"-p{name}" for name in ("slamlib", "slambook", "book.tools", "book.experiments", "book.live", "benchmarks")
    ]
    files = [str(f.relative_to(layout.ROOT)) for f in layout.notebooks()]
    return [
        Stage("lint", [*PYTHON, "ruff", "check", "--output-format", "concise"], r"All checks (p)assed", "clean tree"),
        Stage("format", [*PYTHON, "ruff", "format", "--check"], r"(\d+) files? already formatted", "files"),
        Stage("types", [*PYTHON, "mypy", *typed], r"in (\d+) source files", "files"),
        Stage("generated", [*PYTHON, "slamlib.codegen", "--check"], r"generated code: (\d+) models", "models, current"),
        Stage("tangled", [*PYTHON, "book.tools.tangle", "--check"], r"tangled cells: (\d+)", "cells, as in slamlib"),
        Stage("sizes", [*PYTHON, "book.tools.sizes"], r"sizes: (\d+) figures", "figures, printed"),
        Stage("stored", [*PYTHON, "book.tools.notebooks", "check"], r"notebooks: (\d+)", "notebooks, text only"),
        Stage("core", [*PYTHON, "pytest", "-q", "-m", "core", *parallel], r"(\d+) passed", "tests of the core", False),
        Stage("pytest", [*PYTHON, "pytest", "-q", "-rs", *parallel], r"(\d+) passed", "tests"),
        Stage("nbval", [*PYTHON, *notebooks.NBVAL, *parallel, *files], r"(\d+) passed", "cells as stored"),
        Stage("book", [*PYTHON, "book.tools.build"], r"running (\d+) notebooks", "notebooks in the book"),
        Stage("oracles", [*PYTHON, "book.tools.oracles"], r"(\d+) passed", "tests beside other programs", every),
        Stage("platforms", [*PYTHON, "book.tools.platforms"], r"platforms: (\d+) of", "platforms for the lock", every),
        Stage("site", [*PYTHON, "book.tools.site"], r"site: (\d+) pages", "pages, links resolve"),
        Stage("shares", [*PYTHON, "book.tools.shares"], r"shares: (\d+) chapters", "chapters, shares printed"),
        Stage("browser", [*chromium, "-k", "test_pages and not axe", *pages], r"(\d+) passed", "views of pages"),
        Stage("axe", [*chromium, "-k", "test_pages and axe", *pages], r"(\d+) passed", "pages, nothing serious"),
        Stage(
            "readers",
            [*site, *parallel, "-k", "not test_pages and not test_the_cells", *pages],
            r"(\d+) passed",
            "readers' ways",
        ),
        Stage(
            "live", [*chromium, "-k", "test_the_cells", *pages, *minutes], r"(\d+) passed", "pages run live, or begun"
        ),
    ]


def run(stage: Stage) -> Result:
    """Run one stage with its output shown, and judge it."""
    print(f"\n=== {stage.name}: {' '.join(stage.command[2:])}", flush=True)
    start, worked = time.perf_counter(), _processor()
    text = []
    with subprocess.Popen(
        stage.command,
        cwd=layout.ROOT,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        stdin=subprocess.DEVNULL,
        text=True,
    ) as process:
        assert process.stdout is not None
        for line in process.stdout:
            print(line, end="", flush=True)
            text.append(line)
    status, number = judge(stage, process.returncode, "".join(text))
    return Result(stage, status, number, time.perf_counter() - start, _processor() - worked)


def _processor() -> float:
    """Seconds of processor time that the ended children have used, with all that they waited for."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def judge(stage: Stage, code: int, text: str) -> tuple[str, int]:
    """What became of a stage, and how much it counted: passed only if it succeeded and counted something."""
    found = re.findall(stage.count, text)
    number = sum(int(n) if n.isdigit() else 1 for n in found)
    if code == SKIPPED:
        return "skipped", number
    if code == 0 and not number:
        return "NOTHING", 0
    return "ok" if code == 0 else "FAILED", number


def summary(results: list[Result], left_out: Iterable[Stage] = ()) -> int:
    """Print a line for each stage and the totals; exit status 0 if none failed or ran nothing."""
    print("\n=== summary")
    for result in results:
        print(result)
    for stage in left_out:
        print(f"{stage.name:<10} left out")
    failed = [r for r in results if r.status in FAILURES]
    skipped = [r for r in results if r.status == "skipped"]
    if skipped:
        print("skipped: a browser is needed for the last stages: apt-get install chromium, or set BOOK_BROWSER")
    seconds, processor = (sum(getattr(r, name) for r in results) / 60 for name in ("seconds", "processor"))
    print(f"{seconds:.0f} minutes, {processor:.0f} CPU minutes")
    print(f"stages: {len(results) - len(failed) - len(skipped)} passed, {len(failed)} failed, {len(skipped)} skipped")
    return 1 if failed or not results else 0


def main(arguments: list[str] | None = None) -> int:
    """Run all stages, or those that are named, up to the first that fails."""
    names = ", ".join(stage.name for stage in stages())
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "stage", nargs="*", help=f"of {names} (default: all but core, which is a part of pytest, oracles and platforms)"
    )
    parser.add_argument("--all", action="store_true", help="look at all pages and run their live cells, changed or not")
    parser.add_argument("--keep-going", action="store_true", help="run the other stages after one that failed, too")
    options = parser.parse_args(arguments)
    known, wanted = stages(options.all), options.stage
    for name in set(wanted) - {stage.name for stage in known}:
        parser.error(f"no stage is called {name}: there are {names}")
    chosen = [stage for stage in known if (stage.name in wanted if wanted else stage.always)]
    results: list[Result] = []
    while len(results) < len(chosen) and (options.keep_going or not any(r.status in FAILURES for r in results)):
        results.append(run(chosen[len(results)]))
    return summary(results, chosen[len(results) :])


if __name__ == "__main__":
    sys.exit(main())
