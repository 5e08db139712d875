"""Run every check, one after the other, and say at the end how each went; a stage that runs nothing has failed."""

import argparse
import os
import re
import subprocess
import sys
import time
from collections.abc import Iterable
from dataclasses import dataclass, field

from book.tools import layout, notebooks

PYTHON = [sys.executable, "-m"]
SKIPPED = 77


@dataclass(frozen=True)
class Stage:
    """A command, and the pattern of the line that counts what it did: the first group must be at least one."""

    name: str
    command: list[str]
    count: str
    unit: str
    environment: dict[str, str] = field(default_factory=dict)


@dataclass(frozen=True)
class Result:
    """How a stage went."""

    stage: Stage
    status: str
    number: int
    seconds: float

    def __str__(self) -> str:
        return f"{self.stage.name:<10} {self.status:<8} {self.number:>5} {self.stage.unit:<28} {self.seconds:6.1f} s"


def stages() -> list[Stage]:
    """The checks, quick ones first."""
    parallel = ["-n", "2", "--dist", "loadscope"]
    files = [str(f.relative_to(layout.ROOT)) for f in layout.notebooks()]
    return [
        Stage("lint", [*PYTHON, "ruff", "check", "--output-format", "concise"], r"All checks (p)assed", "clean tree"),
        Stage("format", [*PYTHON, "ruff", "format", "--check"], r"(\d+) files? already formatted", "files"),
        Stage(
            "types",
            [
                *PYTHON,
                "mypy",
                *(f"-p{name}" for name in ("slamlib", "slambook", "book.tools", "book.live", "benchmarks")),
            ],
            r"in (\d+) source files",
            "files",
        ),
        Stage("generated", [*PYTHON, "slamlib.codegen", "--check"], r"generated code: (\d+) models", "models, current"),
        Stage(
            "tangled", [*PYTHON, "slamlib.codegen.tangle", "--check"], r"tangled cells: (\d+)", "cells, as in slamlib"
        ),
        Stage("stored", [*PYTHON, "book.tools.notebooks", "check"], r"notebooks: (\d+)", "notebooks, text only"),
        Stage("pytest", [*PYTHON, "pytest", "-q", "-rs", *parallel], r"(\d+) passed", "tests"),
        Stage("nbval", [*PYTHON, *notebooks.NBVAL, *parallel, *files], r"(\d+) passed", "cells as stored"),
        Stage("book", [*PYTHON, "book.tools.build"], r"running (\d+) notebooks", "notebooks in the book"),
        Stage("site", [*PYTHON, "book.tools.site"], r"site: (\d+) pages", "pages, links resolve"),
        Stage("browser", [*PYTHON, "book.tools.browser"], r"browser: (\d+) pages", "pages in Chromium"),
        Stage("axe", [*PYTHON, "book.tools.accessibility"], r"axe: (\d+) pages", "pages, nothing serious"),
        Stage("live", [*PYTHON, "book.tools.live_check"], r"live: (\d+) cells", "cells run in the page"),
    ]


def run(stage: Stage) -> Result:
    """Run one stage with its output shown, and judge it."""
    print(f"\n=== {stage.name}: {' '.join(stage.command[2:])}", flush=True)
    start = time.perf_counter()
    text = []
    with subprocess.Popen(
        stage.command,
        cwd=layout.ROOT,
        env={**os.environ, **stage.environment},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        stdin=subprocess.DEVNULL,
        text=True,
    ) as process:
        assert process.stdout is not None
        for line in process.stdout:
            print(line, end="", flush=True)
            text.append(line)
    return judge(stage, process.returncode, "".join(text), time.perf_counter() - start)


def judge(stage: Stage, code: int, text: str, seconds: float) -> Result:
    """Passed only if the command succeeded and counted something."""
    found = re.findall(stage.count, text)
    number = sum(int(n) if n.isdigit() else 1 for n in found)
    if code == SKIPPED:
        return Result(stage, "skipped", number, seconds)
    if code == 0 and not number:
        return Result(stage, "NOTHING", 0, seconds)
    return Result(stage, "ok" if code == 0 else "FAILED", number, seconds)


def summary(results: Iterable[Result]) -> int:
    """Print a line for each stage and the totals; exit status 0 if none failed or ran nothing."""
    results = list(results)
    print("\n=== summary")
    for result in results:
        print(result)
    failed = [r for r in results if r.status in ("FAILED", "NOTHING")]
    skipped = [r for r in results if r.status == "skipped"]
    if skipped:
        print("skipped: a browser is needed for the last stages: apt-get install chromium, or set BOOK_BROWSER")
    print(f"stages: {len(results) - len(failed) - len(skipped)} passed, {len(failed)} failed, {len(skipped)} skipped")
    return 1 if failed or not results else 0


def main(arguments: list[str] | None = None) -> int:
    """Run all stages, or those that are named, whatever happens to each."""
    known = stages()
    names = ", ".join(stage.name for stage in known)
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("stage", nargs="*", help=f"of {names} (default: all)")
    wanted = parser.parse_args(arguments).stage
    for name in set(wanted) - {stage.name for stage in known}:
        parser.error(f"no stage is called {name}: there are {names}")
    return summary([run(stage) for stage in known if not wanted or stage.name in wanted])


if __name__ == "__main__":
    sys.exit(main())
