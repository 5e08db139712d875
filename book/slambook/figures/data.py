"""What a caller hands over to be drawn: checked, as arrays of floats."""

from typing import Any

import numpy as np

from slamlib.errors import NonFiniteError, ShapeError, SlamlibError
from slamlib.manifolds import Array

LARGEST = 1e300  # greater numbers overflow when limits are computed from them


def numbers(function: str, name: str, values: Any) -> Array:
    """Numbers as floats; nan is a gap. Raises SlamlibError for what is no real number, NonFiniteError for infinity."""
    given = np.asarray(values)
    if given.dtype.kind not in "buif" and given.size:
        raise SlamlibError(f"{function}: {name} should be real numbers, not {given.dtype}")
    found = given.astype(float)
    beyond = np.abs(found) > LARGEST
    if np.any(beyond):
        at = tuple(int(i) for i in np.argwhere(beyond)[0])
        raise NonFiniteError(
            f"{function}: {name}[{', '.join(map(str, at))}] is {found[at]:g}: leave it out, or put nan for a gap"
        )
    return found


def row_of(function: str, name: str, values: Any) -> Array:
    """Numbers as one row; a single one is a row of one. Raises ShapeError too."""
    found = np.atleast_1d(numbers(function, name, values))
    if found.ndim != 1:
        raise ShapeError(f"{function}: {name} should be one row of numbers, but has shape {found.shape}")
    return found


def rows_of(function: str, **values: Any) -> list[Array]:
    """Rows of numbers of one length; a single number goes with each of the others'. Raises ShapeError too."""
    rows = [row_of(function, name, value) for name, value in values.items()]
    lengths = {len(row) for row in rows if len(row) != 1}
    if len(lengths) > 1:
        given = ", ".join(f"{name} {len(row)}" for name, row in zip(values, rows, strict=True))
        raise ShapeError(f"{function}: these should have the same length: {given}")
    length = lengths.pop() if lengths else 1
    return [np.broadcast_to(row, (length,)) for row in rows]
