"""The report's filter, corrected, with one correction by all numbers of a picture: the same result, sooner."""

from dataclasses import dataclass

import numpy as np

from slambook.report import update
from slambook.report.angles import rotation, wrapped
from slambook.report.filter import Memory
from slambook.report.observation import by_pose, by_vectors
from slamlib.manifolds import Array


@dataclass
class Together(Memory):
    """A Memory whose `correct` is (3.10) to (3.14): equal to number by number but for rounding (E25).

    Its correction has the corrected equations, whatever else is turned on. Many runs side by side are ten times as
    quick with it, because the covariance is touched once a picture.
    """

    def correct(self, seen: Array, names: list[int], R: Array) -> None:
        """As Memory.correct."""
        if not names:
            return
        points, m = self.points[..., [self.names.index(name) for name in names], :], len(names)
        difference = (seen - by_vectors(self.x[..., :6], points)).reshape(*seen.shape[:-2], 3 * m)
        H = self.jacobian(points, names)
        noise = np.zeros((*seen.shape[:-2], 3 * m, 3 * m))
        for i in range(m):
            at = slice(3 * i, 3 * i + 3)
            noise[..., at, at] = np.broadcast_to(R, (*seen.shape, 3))[..., i, :, :]
        self.x, self.P = update.batch(self.x, self.P, difference, H, noise)
        self.P = (self.P + self.P.swapaxes(-1, -2)) / 2
        self.x[..., 3:6] = wrapped(self.x[..., 3:6])

    def jacobian(self, points: Array, names: list[int]) -> Array:
        """(3.15), dense: derivative (..., 3m, 6 + 3L) of what is seen of these landmarks at points (..., m, 3)."""
        m, n = len(names), self.x.shape[-1]
        H = np.zeros((*self.x.shape[:-1], 3 * m, n))
        H[..., :6] = by_pose(self.x[..., :6], points).reshape(*self.x.shape[:-1], 3 * m, 6)
        turned = rotation(self.x[..., 3:6]).swapaxes(-1, -2)
        for i, name in enumerate(names):
            place = 6 + 3 * self.names.index(name)
            H[..., 3 * i : 3 * i + 3, place : place + 3] = turned
        return H
