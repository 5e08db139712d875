"""The correction, one number after another, (5.30) to (5.32); to compare, all at once, (3.11) to (3.14)."""

import numpy as np

from slamlib.manifolds import Array


def whitened(R: Array, *rows: Array) -> tuple[Array, ...]:
    """Variances (..., 3) and rows (..., 3, n) of independent numbers: L^-1 rows, with R = L L'."""
    L = np.linalg.cholesky(R)
    return (np.ones(R.shape[:-1]), *(np.linalg.solve(L, row) for row in rows))


def diagonal_only(R: Array, *rows: Array) -> tuple[Array, ...]:
    """(5.27), as printed: R_jj, whatever stands beside the diagonal (E17)."""
    return (np.diagonal(R, axis1=-2, axis2=-1), *rows)


def running(difference: Array, h: Array, moved: Array) -> Array:
    """(5.31) corrected: what is left of z - h(x) after the corrections so far, which moved the state."""
    return difference - (h * moved).sum(-1)


def batch(x: Array, P: Array, difference: Array, H: Array, R: Array) -> tuple[Array, Array]:
    """(3.11) to (3.14): one correction by all m numbers. difference (..., m), H (..., m, n), R (..., m, m)."""
    HP = H @ P
    K = np.linalg.solve(HP @ H.swapaxes(-1, -2) + R, HP).swapaxes(-1, -2)
    return x + (K @ difference[..., None])[..., 0], P - K @ HP
