"""The size of the house, with a limit for each figure: lines, units, layers, and imports between units.

A *unit* is a module at the root of slamlib or a folder of it, with all that lies below, and slambook as a whole; what
is generated and what tests are no units, nor are slamlib's own `__init__` and `__main__`. An *arrow* leads from a unit
to one that a module of it imports when it is loaded: what a function imports when it is called does not count. A
*layer* is a step of the longest way along arrows; units that import each other count as one step. Blank lines, comments
and docstrings are lines too.
"""

import ast
import sys
from collections import defaultdict
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from book.tools import layout

BEYOND_THE_CORE = ("vision", "datasets", "cli")
LONGEST, SHORTEST = 250, 40
AT_THE_START = 34037  # slamlib, book/report and book/tools when the work on the layout began
LONG, ALL = f"files over {LONGEST} lines", "slamlib, slambook and book/tools"
LIMITS = {  # what no change may exceed; one that lowers a figure lowers its limit, until the goal is reached
    "slamlib, written by hand": 18002,
    "its core": 11350,
    "generated": 12959,
    ALL: 36400,
    LONG: 0,
    "units": 23,
    "layers": 12,
    "imports between units": 133,
}
GOALS = {
    "slamlib, written by hand": 17000,
    "its core": 11000,
    ALL: AT_THE_START - 3000,
    LONG: 0,
    "imports between units": 140,
}

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
        for imported in _imports(ast.parse(file.read_text("utf-8")), modules):
            if unit(name) and unit(imported) not in ("", "generated", unit(name)):
                found[unit(name)].add(unit(imported))
    return found


def _imports(tree: ast.Module, modules: dict[str, Path]) -> Iterable[str]:
    for node in tree.body:
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names if alias.name.split(".")[0] in ("slamlib", "slambook"))
        elif isinstance(node, ast.ImportFrom) and node.module and node.module.split(".")[0] in ("slamlib", "slambook"):
            whole = [f"{node.module}.{alias.name}" for alias in node.names]
            yield from (w if w in modules or f"{w}.__init__" in modules else node.module for w in whole)


def layers(found: Arrows) -> int:
    """The number of units on the longest way along arrows, of which a circle counts as one."""

    @cache
    def reached(start: str) -> frozenset[str]:
        seen, left = {start}, [start]
        while left:
            fresh = found.get(left.pop(), set()) - seen
            seen |= fresh
            left += fresh
        return frozenset(seen)

    @cache
    def height(name: str) -> int:
        circle = {other for other in reached(name) if name in reached(other)}
        below = {other for one in circle for other in found.get(one, set())} - circle
        return 1 + max((height(other) for other in below), default=0)

    return max(map(height, found), default=0)


def figures(root: Path = layout.ROOT) -> tuple[dict[str, int], list[str]]:
    """The figures by their names, and what to know of single files."""
    slamlib, slambook = Package.of(root / "slamlib").files, Package.of(root / "book" / "slambook").files
    core = [file for name, file in slamlib.items() if unit(name) not in BEYOND_THE_CORE]
    tools = sorted((root / "book" / "tools").rglob("*.py"))
    sizes = {file: lines([file]) for file in [*slamlib.values(), *slambook.values(), *tools]}
    long = [file for file, size in sizes.items() if size > LONGEST]
    short = [file for file, size in sizes.items() if size < SHORTEST and not file.name.startswith("__")]
    notes = [f"  {sizes[file]:>5}  {file.relative_to(root).as_posix()}" for file in [*long, *short]]
    found = arrows(slamlib | slambook)
    numbers = {
        "slamlib, written by hand": lines(slamlib.values()),
        "its core": lines(core),
        "generated": lines((root / "slamlib" / "generated").rglob("*.py")),
        ALL: sum(sizes.values()),
        LONG: len(long),
        f"files under {SHORTEST} lines": len(short),
        "units": len(found),
        "layers": layers(found),
        "imports between units": sum(map(len, found.values())),
    }
    return numbers, notes


def circles(found: Arrows) -> list[str]:
    """Pairs of units that import each other."""
    pairs: dict[str, list[str]] = defaultdict(list)
    for one, others in sorted(found.items()):
        pairs[one] += sorted(other for other in others if one < other and one in found.get(other, set()))
    return [f"  {one} and {other} import each other" for one, others in pairs.items() for other in others]


def main() -> int:
    """Print every figure with its limit, and the files that are long or short; 1 if a limit is broken."""
    numbers, notes = figures()
    broken = 0
    print(*notes, *circles(arrows(Package.of(layout.ROOT / "slamlib").files)), sep="\n")
    for name, number in numbers.items():
        limit = LIMITS.get(name)
        over = limit is not None and number > limit
        broken += over
        goal = f"  goal {GOALS[name]:>6}" if number > GOALS.get(name, number) else ""
        print(f"{name:<34} {number:>6}" + (f"  at most {limit:>6}" if limit is not None else "") + " !" * over + goal)
    print(f"sizes: {len(numbers)} figures, {broken} over their limit")
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
