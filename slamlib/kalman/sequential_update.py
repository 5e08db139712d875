"""A series of corrections: each at the means that those before it left, and one product with the covariance for all.

After some corrections the covariance is P - W'W, where W holds the rows that each of them took away (chapter 2). The
next one needs a few rows of that, which are quickly computed of P and W; the whole of it is needed only at the end, and
one product of many rows costs far less than many products of two rows.
"""

import numpy as np

from slamlib.errors import NonFiniteError
from slamlib.kalman import linalg
from slamlib.kalman.state import Layout
from slamlib.kalman.update import Correction
from slamlib.manifolds import Array, Indices

_ROWS = 32  # of W that there is room for at first


class Series:
    """Corrections in progress; made by Belief.series."""

    def __init__(self, covariance: Array, layout: Layout) -> None:
        """covariance (n, n): corrected in place by `finish`."""
        self._P, self._layout = covariance, layout
        self._store, self._count = np.empty((_ROWS, len(covariance))), 0  # W is its first rows

    def correct(self, columns: Indices, H: Array, innovation: Array, R: Array, gate: float = np.inf) -> Correction:
        """As Belief.correct_rows, at the present means; changes nothing unless its nis is below the gate.

        columns (k,), H (d, k), innovation (d,), R (d, d). Raises CovarianceError, NonFiniteError.
        """
        taken = self._store[: self._count]
        HP = H @ self._P.take(columns, axis=0)
        if self._count:
            HP -= (H @ taken.take(columns, axis=1).T) @ taken
        half = HP.take(columns, axis=1) @ H.T / 2
        S = half + half.T + R
        factor = linalg.cholesky(S, "correct", "the innovation covariance")
        white = linalg.solve_lower(factor, np.concatenate([HP, innovation[:, None]], axis=1))
        W, z = white[:, :-1], white[:, -1]
        nis = float(z @ z)
        if nis < gate:
            self._move(z @ W)
            self._take(W)
        return Correction(innovation, S, nis)

    def _take(self, rows: Array) -> None:
        """More rows of W, in a store that doubles when it is full."""
        end = self._count + len(rows)
        while end > len(self._store):
            self._store = np.concatenate([self._store, np.empty_like(self._store)])
        self._store[self._count : end], self._count = rows, end

    def _move(self, step: Array) -> None:
        if not np.isfinite(step).all():
            raise NonFiniteError("correct: the step overflows; choose units in which the numbers are smaller")
        self._layout.move(*self._layout.moved(step))

    def finish(self) -> None:
        """The covariance becomes that of the present means, which stay as they are."""
        if self._count:
            linalg.subtract_square(self._P, self._store[: self._count])
            self._count = 0
