"""An environment that has just what is said: the wheel, NumPy, and the packages of the extras that are named.

The packages are not fetched: each is linked from the environment in which the tests run.
"""

import os
import re
import subprocess
import sys
import tomllib
import venv
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from importlib.metadata import Distribution, distribution
from pathlib import Path

from packaging.requirements import Requirement

from book.tools import layout

QUIET = ["--quiet", "--disable-pip-version-check", "--no-deps", "--no-index", "--no-compile"]
# What must not reach the environment from the one in which the tests run.
FOREIGN = ("PYTHONPATH", "MYPYPATH", "PYTHONHOME", "VIRTUAL_ENV", "COVERAGE_PROCESS_START", "SLAMLIB_DATA")


@cache
def extras() -> dict[str, list[Requirement]]:
    """The extras of pyproject.toml, with what each asks for; an extra made of others asks for what they do."""
    project = tomllib.loads((layout.ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    listed = {name: list(map(Requirement, texts)) for name, texts in project["optional-dependencies"].items()}

    def whole(name: str) -> Iterator[Requirement]:
        for requirement in listed[name]:
            own = requirement.name == project["name"]
            yield from (one for other in sorted(requirement.extras) for one in whole(other)) if own else [requirement]

    return {name: list(whole(name)) for name in listed}


def distributions(requirements: Iterable[Requirement]) -> dict[str, Distribution]:
    """What is installed of them, with all that they depend on; raises PackageNotFoundError for what is not here."""
    found: dict[str, Distribution] = {}
    left, known = list(requirements), set()
    while left:
        requirement = left.pop()
        if str(requirement) in known:
            continue
        known.add(str(requirement))
        one = found[re.sub(r"[-_.]+", "-", requirement.name).lower()] = distribution(requirement.name)
        for text in one.requires or []:
            child = Requirement(text)
            if child.marker is None or any(child.marker.evaluate({"extra": e}) for e in ("", *requirement.extras)):
                left.append(child)
    return found


def link(folder: Path, requirements: Iterable[Requirement]) -> Path:
    """Link the installed packages, and nothing else, into a folder that Python can import from."""
    found = distributions(requirements)
    folder.mkdir(parents=True, exist_ok=True)
    for one in found.values():
        for top in {file.parts[0] for file in one.files or []} - {"..", "__pycache__"}:
            if not (folder / top).is_symlink():  # a namespace that two packages share is linked once
                (folder / top).symlink_to(Path(str(one.locate_file(top))).resolve())
    return folder


@dataclass(frozen=True)
class Environment:
    """A folder with an environment: `python`, its `packages`, its `bin`; extras lie in folders beside the packages."""

    folder: Path

    @classmethod
    def made(cls, folder: Path, wheel: Path) -> "Environment":
        """A new environment with the wheel, and NumPy beside it."""
        venv.create(folder, symlinks=os.name != "nt")
        new = cls(folder)
        command = [sys.executable, "-m", "pip", "--python", str(new.python), "install", *QUIET, str(wheel)]
        subprocess.run(command, check=True)
        link(new.packages, [Requirement("numpy")])
        return new

    @property
    def python(self) -> Path:
        """The interpreter."""
        return next(f for f in (self.folder / "bin" / "python", self.folder / "Scripts" / "python.exe") if f.exists())

    @property
    def packages(self) -> Path:
        """The folder of its packages."""
        return next(self.folder.rglob("site-packages"))

    def run(
        self, *command: str | Path, extras_named: Sequence[str] = (), cwd: Path | None = None, **variables: str
    ) -> "subprocess.CompletedProcess[str]":
        """Run a command where no checkout is, with the packages of these extras, and its own `bin` before all others.

        Raises KeyError for an extra that pyproject.toml does not have.
        """
        clean = {name: value for name, value in os.environ.items() if name not in FOREIGN}
        clean["PATH"] = os.pathsep.join([str(self.python.parent), clean.get("PATH", os.defpath)])
        if extras_named:
            folder = self.folder / "extras" / "-".join(sorted(extras_named))
            if not folder.is_dir():
                link(folder, [one for name in extras_named for one in extras()[name]])
            clean["PYTHONPATH"] = str(folder)
        where = self.packages.parent if cwd is None else cwd
        return subprocess.run(command, capture_output=True, text=True, cwd=where, env=clean | variables)
