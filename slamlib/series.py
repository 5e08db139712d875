"""A series of corrections: each at the means that those before it left, and one product with the covariance for all.

After some corrections the covariance is P - W'W, where W holds the rows that each of them took away (chapter 2). The
next one needs a few rows of that, which are quickly computed of P and W; the whole of it is needed only at the end, and
one product of many rows costs far less than many products of two rows.
"""

import numpy as np

from slamlib import linalg
from slamlib.blocks import Layout
from slamlib.correction import Correction
from slamlib.errors import NonFiniteError
from slamlib.spaces import Array


class Series:
    """Corrections in progress; made by Belief.series."""

    def __init__(self, covariance: Array, layout: Layout) -> None:
        """covariance (n, n): corrected in place by `finish`. Means of vectors become views of one array that moves."""
        self._P, self._layout = covariance, layout
        self._taken = np.zeros((0, len(covariance)))
        self._flat = layout.flat()
        layout.share(self._flat)

    def correct(self, columns: Array, H: Array, innovation: Array, R: Array, gate: float = np.inf) -> Correction:
        """As Belief.correct_rows, at the present means; changes nothing unless its nis is below the gate.

        columns (k,), H (d, k), innovation (d,), R (d, d). Raises CovarianceError, NonFiniteError.
        """
        taken = self._taken
        HP = H @ self._P[columns] - (H @ taken[:, columns].T) @ taken
        half = HP[:, columns] @ H.T / 2
        S = half + half.T + R
        factor = linalg.cholesky(S, "correct", "the innovation covariance")
        white = linalg.solve_lower(factor, np.concatenate([HP, innovation[:, None]], axis=1))
        W, z = white[:, :-1], white[:, -1]
        nis = float(z @ z)
        if nis < gate:
            self._move(z @ W)
            self._taken = np.concatenate([taken, W])
        return Correction(innovation, S, nis)

    def _move(self, step: Array) -> None:
        if not np.isfinite(step).all():
            raise NonFiniteError("correct: the step overflows; choose units in which the numbers are smaller")
        self._flat += step[self._layout.rows]
        for block in self._layout.points:
            block.mean = linalg.frozen(block.space.plus(block.mean, step[block.slice]))

    def finish(self) -> None:
        """The covariance becomes that of the present means, which stay as they are."""
        self._flat.flags.writeable = False
        if len(self._taken):
            linalg.subtract_square(self._P, self._taken)
            self._taken = self._taken[:0]
