"""The page Rosetta: read its table, and write the page from it.

`python -m book.tools.rosetta` writes rosetta.md from rosetta.csv, both in book/sources; the words above
the tables stay.
"""

import csv
import re
from itertools import groupby
from typing import NamedTuple

from book.tools import layout
from slamlib.landmarks import LINES, POINTS
from slamlib.sensors import SENSORS, Sensor

TABLE = layout.BOOK / "sources" / "rosetta.csv"
PAGE = layout.BOOK / "sources" / "rosetta.md"
MARK = "% The tables below are generated: edit rosetta.csv, then run python -m book.tools.rosetta\n"
HEADER = ["group", "there", "kind", "what it is", "slamlib"]
NOT_YET, NOT_NEEDED = "not yet: ", "not needed: "
PAIRS = (
    "In space every sensor measures every point; lines are for sensors that project them. In the toolbox the "
    "omnidirectional camera knows `ahmPnt` and `eucPnt` only, and nothing measures an `fhmPnt`. A cell says how many "
    "numbers are measured, and how many are left to a prior; *no* is refused with an error. Generated from the types."
)
CHAPTER = re.compile(r"chapter (\w+)")


class Row(NamedTuple):
    """A name there, and where it lives: dotted paths, "chapter N", "not yet: path", "not needed: why"."""

    group: str
    name: str
    kind: str
    what: str
    target: str

    @property
    def places(self) -> list[str]:
        """The paths and chapters of the target, without the words before them; none where nothing is needed."""
        return [] if self.target.startswith(NOT_NEEDED) else self.target.removeprefix(NOT_YET).split("; ")


def rows() -> list[Row]:
    """The table; raises ValueError where it has another form."""
    found = list(csv.reader(TABLE.read_text("utf-8").splitlines()))
    if found[0] != HEADER or any(len(r) != len(HEADER) or not all(r) for r in found):
        raise ValueError(f"{TABLE.name} should have the columns {HEADER}, and no empty entry")
    return [Row(*r) for r in found[1:]]


def text() -> str:
    """The page: the words above the mark as they are, then a table for each group."""
    words = PAGE.read_text("utf-8").split(MARK)[0]
    tables = []
    for group, members in groupby(rows(), lambda row: row.group):
        lines = [f"| {_name(row)} | {_plain(row.what)} | {_target(row)} |" for row in members]
        head = ["", f"## {group}", "", "| there | what it is | here |", "|---|---|---|"]
        tables.append("\n".join([*head, *lines, ""]))
    types, *others = tables
    return "".join([words, MARK, types, pairs(), *others])


def pairs() -> str:
    """Which sensor measures which landmark, from the package's own types; the toolbox has none of the plane."""
    names = sorted(name for name, sensor in SENSORS.items() if not sensor.plane)
    lines = ["", "## Which pairs exist", "", PAIRS, ""]
    lines += [f"| landmark | {' | '.join(f'`{n}`' for n in names)} |", "|---" * (len(names) + 1) + "|"]
    for name in (kind.name for kind in POINTS.values() if not kind.plane):
        lines.append(f"| `{name}` | {' | '.join(_measured(SENSORS[n]) for n in names)} |")
    for name in LINES:
        cells = ["4 + 2" if SENSORS[n].project_line else "no" for n in names]
        lines.append(f"| `{name}` | {' | '.join(cells)} |")
    return "\n".join([*lines, ""])


def _measured(sensor: Sensor) -> str:
    """How many numbers a sensor measures of a point, and how many it leaves to a prior."""
    open_ones = sensor.back_project.arguments[1 : len(sensor.back_project.arguments) - len(sensor.parameters)]
    return f"{sensor.size} + {sum(a.size for a in open_ones)}"


def _name(row: Row) -> str:
    """A name of a program as code; what has no name there, an equation or an idea, in words."""
    return _plain(row.name) if row.kind == "idea" else f"`{row.name}`"


def _plain(words: str) -> str:
    return re.sub(r"([_*'\[\]<|])", r"\\\1", words)


def _target(row: Row) -> str:
    if not row.places:
        return f"*not needed*: {_plain(row.target.removeprefix(NOT_NEEDED))}"
    found = ((CHAPTER.fullmatch(place), place.removeprefix("slamlib.")) for place in row.places)
    shown = ", ".join(f"{{doc}}`../chapters/{match[1]}`" if match else f"`{name}`" for match, name in found)
    return f"*not yet* ({shown})" if row.target.startswith(NOT_YET) else shown


def main() -> int:
    """Write the page."""
    layout.write_whole(PAGE, text().encode())
    print(f"rosetta: {len(rows())} names in {PAGE.relative_to(layout.ROOT)}")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
