"""The size of the house: lines, units, layers, imports and circles of them. It is printed, and decides nothing.

A *unit* is a module at the root of slamlib or a folder of it, with all that lies below, and slambook as a whole; what
is generated and what tests are no units, nor are slamlib's own `__init__` and `__main__`. An *arrow* leads from a unit
to one that a module of it imports when it is loaded: what a function imports when it is called does not count. A
*layer* is a step of the longest way along arrows; units that import each other count as one step. A *circle* is a set
of files each of which leads to every other one by imports, of which all count here: inside a function, and those for
types alone. Blank lines, comments and docstrings are lines too.
"""

import ast
import re
import sys
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from book.tools import layout

BEYOND_THE_CORE = ("vision", "datasets", "cli")
BESIDE = ("book/tools", "book/experiments", "benchmarks")
ANY = re.compile(r"\bAny\b")

Arrows = dict[str, set[str]]


@dataclass(frozen=True)
class Package:
    """A package's modules, by their dotted names."""

    files: dict[str, Path]

    @classmethod
    def of(cls, folder: Path) -> "Package":
        """All modules below a folder, but for tests and generated ones."""
        found = {}
        for file in sorted(folder.rglob("*.py")):
            parts = file.relative_to(folder.parent).with_suffix("").parts
            if parts[1] not in ("tests", "generated"):
                found[".".join(parts)] = file
        return cls(found)


def unit(module: str) -> str:
    """The unit that a module belongs to: 'slam' for slamlib.slam.filter, '' for slamlib itself."""
    package, *parts = module.split(".")
    return package if package != "slamlib" else "" if parts[:1] in ([], ["__init__"], ["__main__"]) else parts[0]


def lines(files: Iterable[Path]) -> int:
    """Their number of lines."""
    return sum(file.read_bytes().count(b"\n") for file in files)


def arrows(modules: dict[str, Path]) -> Arrows:
    """Which units each unit imports; those without an import are in it too."""
    found: Arrows = {unit(name): set() for name in modules if unit(name)}
    for name, file in modules.items():
        for imported in _imports(ast.parse(file.read_text("utf-8")).body, modules):
            if unit(name) and unit(imported) not in ("", "generated", unit(name)):
                found[unit(name)].add(unit(imported))
    return found


def _imports(nodes: Iterable[ast.AST], modules: dict[str, Path]) -> Iterable[str]:
    for node in nodes:
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names if alias.name.split(".")[0] in ("slamlib", "slambook"))
        elif isinstance(node, ast.ImportFrom) and node.module and node.module.split(".")[0] in ("slamlib", "slambook"):
            whole = [f"{node.module}.{alias.name}" for alias in node.names]
            yield from (w if w in modules or f"{w}.__init__" in modules else node.module for w in whole)


def files_imported(modules: dict[str, Path]) -> Arrows:
    """Which modules each module imports, wherever in it; a package's name stands for its __init__."""

    def module(name: str) -> str:
        return name if name in modules else f"{name}.__init__"

    found = {}
    for name, file in modules.items():
        everywhere = ast.walk(ast.parse(file.read_text("utf-8")))
        found[name] = {module(imported) for imported in _imports(everywhere, modules)} & (set(modules) - {name})
    return found


def circles(found: Arrows) -> list[list[str]]:
    """The sets of those that reach each other along arrows, each in order, the largest first."""
    reached = {name: _reached(name, found) for name in found}
    sets = {tuple(sorted(o for o in reached[name] if name in reached[o])) for name in found}
    return sorted((list(names) for names in sets if len(names) > 1), key=lambda names: (-len(names), names))


def _reached(start: str, found: Arrows) -> set[str]:
    seen, left = {start}, [start]
    while left:
        fresh = found.get(left.pop(), set()) - seen
        seen |= fresh
        left += fresh
    return seen


def layers(found: Arrows) -> int:
    """The number of units on the longest way along arrows, of which a circle counts as one."""
    circle_of = {name: set(names) for names in circles(found) for name in names}

    @cache
    def height(name: str) -> int:
        circle = circle_of.get(name, {name})
        below = {other for one in circle for other in found.get(one, set())} - circle
        return 1 + max((height(other) for other in below), default=0)

    return max(map(height, found), default=0)


def figures(root: Path = layout.ROOT) -> tuple[dict[str, int], list[str]]:
    """The figures by their names, and a line for each circle."""
    slamlib, slambook = Package.of(root / "slamlib").files, Package.of(root / "book" / "slambook").files
    core = [file for name, file in slamlib.items() if unit(name) not in BEYOND_THE_CORE]
    found, round_trips = arrows(slamlib | slambook), circles(files_imported(slamlib | slambook))
    between = circles(arrows(slamlib))
    numbers = {
        "slamlib, written by hand": lines(slamlib.values()),
        "its core": lines(core),
        "generated": lines((root / "slamlib" / "generated").rglob("*.py")),
        "slambook": lines(slambook.values()),
        **{name: lines((root / name).rglob("*.py")) for name in BESIDE},
        "the word Any in slamlib": sum(len(ANY.findall(file.read_text("utf-8"))) for file in slamlib.values()),
        "units": len(found),
        "layers": layers(found),
        "imports between units": sum(map(len, found.values())),
        "circles among files": len(round_trips),
    }
    notes = [f"  units that import each other: {', '.join(names)}" for names in between]
    return numbers, notes + [f"  circle of {len(names)} files: {', '.join(names)}" for names in round_trips]


def main() -> int:
    """Print every figure, and the units and files that import each other."""
    numbers, notes = figures()
    print(*notes, sep="\n")
    for name, number in numbers.items():
        print(f"{name:<34} {number:>6}")
    print(f"sizes: {len(numbers)} figures")
    return 0


if __name__ == "__main__":
    sys.exit(main())
