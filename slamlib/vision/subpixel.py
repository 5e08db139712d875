"""Where between the pixels the highest of some scores lies. Chapter 19."""

import numpy as np

from slamlib.manifolds import Array

# Least squares through the nine values at (u, v) = (-1..1, -1..1), row by row: slopes by u and v, second derivatives.
_U, _V = np.tile([-1.0, 0, 1], 3), np.repeat([-1.0, 0, 1], 3)
_FIT = np.linalg.pinv(np.stack([np.ones(9), _U, _V, _U**2 / 2, _U * _V, _V**2 / 2], axis=1))[1:]


def top(around: Array) -> Array:
    """Where the paraboloid through 3 x 3 scores is highest, (u, v) from the middle, the largest of them.

    With its cross term: a slanted ridge needs it. Where a score is missing (nan), or the top is none or beyond the
    nine, the parabolas along u and v.
    """
    if not np.isnan(around).any():
        gu, gv, a, b, c = (_FIT @ around.ravel()).tolist()
        det = a * c - b * b
        if a < 0 and det > 0:
            found = np.array([b * gv - c * gu, b * gu - a * gv]) / det
            if (np.abs(found) <= 1).all():
                return found
    return np.array([parabola(*around[1].tolist()), parabola(*around[:, 1].tolist())])


def parabola(left: float, centre: float, right: float) -> float:
    """Abscissa of the top of the parabola through (-1, left), (0, centre), (1, right); 0 if the centre is not above."""
    bend = left - 2 * centre + right
    return (left - right) / (2 * bend) if bend < 0 and centre >= max(left, right) else 0.0
