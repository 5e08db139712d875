"""Calibrations in plain text: rows such as "fx 500", "width 640", "k1 -0.3"; or "fx fy cx cy [k1 k2 p1 p2 [k3]]"."""

import re
from functools import partial
from pathlib import Path

from slamlib.datasets.dataset import CalibrationReader, Cameras
from slamlib.datasets.lens import Lens
from slamlib.plain_data.fields import OneOf

ORDER = ("fx", "fy", "cx", "cy", "k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6")
NAMES = (*ORDER, "width", "height")


def _fits(text: str) -> bool:
    """Whether the text has only names with numbers, fx among them, or one row of four, eight or nine numbers."""
    rows = _rows(text)
    if len(rows) == 1 and len(rows[0]) in (4, 8, 9):
        return True
    return bool(rows) and all(len(row) == 2 for row in rows) and "fx" in [row[0].lower() for row in rows]


def _read(path: Path, text: str) -> Cameras:
    return {None: partial(_lens, _rows(text))}


def _lens(rows: list[list[str]]) -> Lens:
    named = dict(zip(ORDER, rows[0], strict=False)) if len(rows) == 1 else {name.lower(): n for name, n in rows}
    for name in named:
        OneOf(NAMES).check(name, "name")
    given = {name: float(value) for name, value in named.items()}
    size = (given["width"], given["height"]) if {"width", "height"} <= given.keys() else None
    coefficients = tuple(given.get(name, 0.0) for name in ORDER[4:])
    return Lens((given["cx"], given["cy"], given["fx"], given["fy"]), size, distortion=coefficients)


def _rows(text: str) -> list[list[str]]:
    lines = (re.sub(r"[:=,;]", " ", line.partition("#")[0]).split() for line in text.splitlines())
    return [line for line in lines if line]


CALIBRATION = CalibrationReader("plain text", _fits, _read)
