"""Compare what slamlib computes here and in the page, number by number, and keep the table that the book shows."""

import csv
import io
import json
import subprocess
import sys
from typing import Any

import numpy as np

from book.tools import layout

PROGRAM = layout.BOOK / "live" / "parity.py"
TABLE = layout.BOOK / "appendices" / "parity.csv"
AGREEMENT = 1e-12
HEADER = ["what is computed", "numbers", "largest difference"]


def here() -> dict[str, Any]:
    """What this Python computes."""
    run = subprocess.run([sys.executable, str(PROGRAM)], capture_output=True, text=True, check=True, cwd=layout.ROOT)
    return json.loads(run.stdout)


def compare(ours: dict[str, Any], theirs: dict[str, Any]) -> tuple[list[list[str]], list[str]]:
    """Rows of the table, and what differs: a name, a count, or a number by more than 1e-12 of the largest."""
    rows, faults = [], []
    if set(ours["numbers"]) != set(theirs["numbers"]):
        faults.append(f"computed on one side only: {sorted(set(ours['numbers']) ^ set(theirs['numbers']))}")
    for name in sorted(set(ours["numbers"]) & set(theirs["numbers"])):
        a, b = np.array(ours["numbers"][name]), np.array(theirs["numbers"][name])
        if a.shape != b.shape or not (np.isfinite(a).all() and np.isfinite(b).all()):
            faults.append(f"{name}: {a.size} numbers here, {b.size} in the page, or not all of them finite")
            continue
        difference = float(np.max(np.abs(a - b)) / max(1.0, np.max(np.abs(a))))
        rows.append([name, str(a.size), f"{difference:.1e}" if difference else "0"])
        if difference > AGREEMENT:
            faults.append(f"{name}: differs by {difference:.1e}")
    return rows, faults


def stored() -> list[list[str]]:
    """The rows of the table in the book."""
    return list(csv.reader(TABLE.read_text("utf-8").splitlines()))[1:] if TABLE.is_file() else []


def stale(rows: list[list[str]]) -> bool:
    """True if the book's table is about other things than these rows; the differences vary with the machine."""
    return [r[:2] for r in rows] != [r[:2] for r in stored()]


def store(rows: list[list[str]]) -> None:
    """Write the table for the book."""
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows([HEADER, *rows])
    layout.write_whole(TABLE, text.getvalue().encode())
