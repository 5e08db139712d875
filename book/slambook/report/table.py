"""The audit as a table that folds: a line for each number of the list, its figures inside."""

from collections import Counter
from html import escape
from typing import Any

Rows = list[dict[str, Any]]


class AuditTable:
    """Rows of chapters/data/audit.json (`make audit ARGS=--store` writes it), to be shown in a page."""

    def __init__(self, rows: Rows) -> None:
        self.rows = rows

    def __repr__(self) -> str:
        counts = Counter(row["verdict"] for row in self.rows)
        return f"Audit of {len(self.rows)} numbers: " + ", ".join(f"{n} {name}" for name, n in counts.items())

    def _repr_html_(self) -> str:
        return "".join(map(_line, self.rows))


def _line(row: dict[str, Any]) -> str:
    """One number: folded, what is said; open, what is right, the figures and the note."""
    head = f"<b>{row['number']}</b> {escape(row['where'])}: {escape(row['says'])}"
    body = f"<p>Right: {escape(row['right'])}.</p>{_figures(row['figures'])}"
    note = f"<p>{escape(row['note'])}</p>" if row["note"] else ""
    return f"<details><summary>{head}</summary>{body}{note}</details>"


def _figures(figures: Rows) -> str:
    if not figures:
        return ""
    rows = "".join(
        f"<tr><td>{escape(f['what'])}</td><td>{f['measured']}</td><td>{escape(f['remark'])}</td></tr>" for f in figures
    )
    head = "<tr><th>figure</th><th>measured</th><th>remark</th></tr>"
    return f'<div style="overflow-x:auto"><table>{head}{rows}</table></div>'
