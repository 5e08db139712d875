"""Calibrations in plain text: rows such as "fx 500", "width 640", "k1 -0.3"; or "fx fy cx cy [k1 k2 p1 p2 [k3]]".

The same names are read from JSON, TOML and YAML; and a camera matrix alone, of 3 x 3 numbers, or in one of 4 x 4.
"""

import re
from functools import partial
from pathlib import Path
from typing import Any

from slamlib.datasets.dataset import METADATA, CalibrationReader, Cameras
from slamlib.datasets.formats.opencv import DISTORTION, model_of, size_of
from slamlib.datasets.lens import Lens, focals_and_centre, lens_of
from slamlib.datasets.lens_models import FISHEYE, RADIAL
from slamlib.errors import SlamlibError
from slamlib.plain_data.entries import Entries, Numbers, named_values
from slamlib.plain_data.parsing import named, value_of
from slamlib.plain_data.rows import decimal_comma

PINHOLE = ("fx",), ("fy",), ("cx", "ppx"), ("cy", "ppy")
COEFFICIENTS = ("k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6")


def _fits(text: str) -> bool:
    return bool(_matrix(text) or _rows_of_names(text) or _maps(text))


def _read(path: Path, text: str) -> Cameras:
    matrix, rows, maps = _matrix(text), _rows_of_names(text), _maps(text)
    if matrix:
        return {None: lambda: lens_of(*focals_and_centre(matrix))}
    if rows:
        return {None: partial(_lens, Entries(named(rows)))}
    others = {name: value for name, value in named_values(text).items() if not {"", name} & maps.keys()}
    Entries(others).close(METADATA)
    cameras: Cameras = {n: partial(_lens, Entries(data, name)) for n, (name, data) in enumerate(maps.items())}
    return cameras if len(cameras) > 1 else {None: cameras[0]}


def _lens(entries: Entries) -> Lens:
    fx, fy, cx, cy = (entries.number(*names) for names in PINHOLE)
    model, given = model_of(entries), entries.numbers(*DISTORTION, needed=False)
    names = COEFFICIENTS if model != FISHEYE else ("k1", "k2", "k3", "k4")
    if model == RADIAL and "k4" in entries and not any(name in entries for name in ("p1", "p2", "k5", "k6")):
        raise SlamlibError(
            "k4 is there, and neither p1, p2 nor k5, k6: are k1 to k4 a fisheye's? Then say so (model fisheye); if "
            "not, write p1 0 and p2 0 beside them"
        )
    coefficients = given or tuple(entries.number(name, default=0.0) for name in names)
    size = size_of(entries)
    entries.close(METADATA)
    return lens_of(fx, fy, cx, cy, image=size, model=model, distortion=coefficients)


def _rows(text: str) -> list[list[str]]:
    """The words of rows; a number with a decimal comma is a word, and no number."""
    lines = [re.sub(r"[:=\[\]]", " ", line.partition("#")[0]) for line in text.splitlines()]
    between = [r"[;\s]+" if decimal_comma(line) else r"[,;\s]+" for line in lines]
    rows = [[word for word in re.split(*both) if word] for both in zip(between, lines, strict=True)]
    return [row for row in rows if row]


def _rows_of_names(text: str) -> list[tuple[str, Any]]:
    """Names and values of rows that have both, fx among them, or of one row of four, eight or nine numbers."""
    rows = _rows(text)
    if len(rows) == 1 and len(rows[0]) in (4, 8, 9):
        values = [*map(value_of, rows[0])]
        is_row = all(isinstance(value, int | float) for value in values)  # not "{fx: 500, fy: 501, cx: 320, cy: 240}"
        return list(zip((*(names[0] for names in PINHOLE), *COEFFICIENTS), values, strict=False)) if is_row else []
    if any(len(row) != 2 for row in rows) or "fx" not in [row[0].lower() for row in rows]:
        return []
    return [(name.lower(), value_of(word)) for name, word in rows]


def _matrix(text: str) -> Numbers | None:
    """The numbers of a 3 x 3 matrix, or of a 4 x 4 one that is one inside; None of a text of another kind."""
    rows = [list(map(value_of, row)) for row in _rows(text)]
    if not all(isinstance(number, int | float) for row in rows for number in row):
        return None
    flat = tuple(float(number) for row in rows for number in row)
    if [*map(len, rows)] == [4] * 4 and flat[3::4] == flat[12:] == (0, 0, 0, 1):
        return flat[0:3] + flat[4:7] + flat[8:11]
    in_one_row = len(flat) == 9 and flat[3] == flat[6] == flat[7] == 0
    return flat if [*map(len, rows)] == [3] * 3 or (len(rows) == 1 and in_one_row) else None


def _maps(text: str) -> dict[str, dict[str, Any]]:
    """The maps with fx and fy, by their names: that of the whole text (''), or those in it."""
    data = named_values(text)
    return {"": data} if _is_lens(data) else {name: value for name, value in data.items() if _is_lens(value)}


def _is_lens(value: Any) -> bool:
    return isinstance(value, dict) and {"fx", "fy"} <= value.keys()


CALIBRATION = CalibrationReader("plain text", _fits, _read)
