"""Results as a table: HTML in a page and in a notebook, aligned text elsewhere, from the same rows.

    table(
        {"50 runs": "", "error [m]": ".2f", "inside": ".0%"},
        ["two laps", ("EKF", 0.31, decisive(0.42)), ("right-invariant", 0.29, 0.95)],
        note="inside: share of the steps whose average is in its 95 % band",
    )

The text is what a test of the notebook compares; in it a decisive cell ends in an asterisk.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from html import escape
from typing import Any

from slamlib.errors import SlamlibError


@dataclass(frozen=True)
class Cell:
    """A cell as it is written."""

    words: str
    decisive: bool

    @property
    def text(self) -> str:
        """Its words, with an asterisk if it is decisive."""
        return self.words + "*" * self.decisive

    @property
    def html(self) -> str:
        """Its words, strong if it is decisive."""
        return f"<strong>{escape(self.words)}</strong>" if self.decisive else escape(self.words)


@dataclass(frozen=True)
class Decisive:
    """A value that decides what the table is about: see decisive."""

    value: Any


class Table:
    """Rows under columns: see table."""

    def __init__(self, columns: Mapping[str, str], rows: Iterable[Any], note: str) -> None:
        self.columns, self.note = dict(columns), note
        self.rows = [row if isinstance(row, str) else self._written(row) for row in rows]
        if not any(isinstance(row, list) for row in self.rows):
            raise SlamlibError("table: there are no rows")

    def _written(self, row: Any) -> list[Cell]:
        row = list(row)
        if len(row) != len(self.columns):
            raise SlamlibError(f"table: {len(self.columns)} columns, but a row of {len(row)}: {row!r}")
        return [_cell(value, form) for value, form in zip(row, self.columns.values(), strict=True)]

    def __repr__(self) -> str:
        lines: list[str | list[str]] = [list(self.columns)]
        lines += [row if isinstance(row, str) else [cell.text for cell in row] for row in self.rows]
        widths = [max(map(len, column)) for column in zip(*(x for x in lines if isinstance(x, list)), strict=True)]
        places = [f"{'>' if form else '<'}{width}" for form, width in zip(self.columns.values(), widths, strict=True)]
        lines += [self.note] if self.note else []
        return "\n".join(
            line if isinstance(line, str) else "  ".join(map(format, line, places)).rstrip() for line in lines
        )

    def _repr_html_(self) -> str:
        sides = [' class="number"' * bool(form) for form in self.columns.values()]
        head = "".join(
            f'<th scope="col"{side}>{escape(name)}</th>' if name else "<td></td>"
            for name, side in zip(self.columns, sides, strict=True)
        )
        body = "".join(f"<tr>{self._row(row, sides)}</tr>" for row in self.rows)
        note = f"<caption>{escape(self.note)}</caption>" if self.note else ""
        return f'<table class="results">{note}<thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>'

    def _row(self, row: str | list[Cell], sides: list[str]) -> str:
        if isinstance(row, str):
            return f'<th scope="rowgroup" colspan="{len(sides)}">{escape(row)}</th>'
        first, *others = row
        cells = "".join(f"<td{side}>{cell.html}</td>" for side, cell in zip(sides[1:], others, strict=True))
        return f'<th scope="row"{sides[0]}>{first.html}</th>{cells}'


def table(columns: Mapping[str, str], rows: Iterable[Any], note: str = "") -> Table:
    """A table of results, shown as the last value of a cell.

    columns: their names, with units, and how to format what stands below them, as in format(value, ".2f"); "" for
    words, which stand on the left. rows: as many values each, the first says what the row is; a string stands as
    it is, None is a dash. A string in place of a row is a heading for those below. note: what the columns mean, below
    them. Raises SlamlibError.
    """
    return Table(columns, rows, note)


def decisive(value: Any, is_so: bool = True) -> Any:
    """The value, marked in its table: the one that the text is about, or those of which a condition holds."""
    return Decisive(value) if is_so else value


def _cell(value: Any, form: str) -> Cell:
    marked = isinstance(value, Decisive)
    value = value.value if isinstance(value, Decisive) else value
    words = "-" if value is None else value if isinstance(value, str) else format(value, form)
    return Cell(words, marked)
