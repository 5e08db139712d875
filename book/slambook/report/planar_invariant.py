"""Filters of slambook.invariant_ekf and slambook.error_coordinates on the drives on which FastSLAM is compared."""

import numpy as np

from slambook.invariant_ekf import RANGE_BEARING, InvariantEkf, exponential, logarithm
from slambook.report.planar import Data, PlanarScan
from slamlib.manifolds import Array

LAST = [1, 2, 0]  # heading last, as in the drives


class PlanarFilter:
    """One of these filters as `PlanarEkf` is: pose and landmarks from a start known exactly, with a first scan."""

    def __init__(self, data: Data, kind: type[InvariantEkf] = InvariantEkf) -> None:
        R, noise = exponential(data.truth[0, 2:], 2)[0], np.diag(data.look_std**2)
        self.filter = kind(R, data.truth[0, :2], np.zeros((3, 3)), RANGE_BEARING, noise)
        self.U = np.diag(data.motion_std[[2, 0, 1]] ** 2)
        for name, z in zip(data.scans[0].names, data.scans[0].z, strict=True):
            self.filter.initialize(int(name), z)

    def step(self, u: Array, scan: PlanarScan) -> None:
        """Odometry u (3,), then the measurements."""
        seen = {int(name): z for name, z in zip(scan.names, scan.z, strict=True)}
        self.filter.step(exponential(u[2:], 2)[0], u[:2], self.U, seen)

    def pose(self) -> tuple[Array, Array]:
        """Mean (3,) and covariance (3, 3) of x, y and heading."""
        mean = np.concatenate([self.filter.x[0], logarithm(self.filter.R)])
        return mean, self.filter.linear()[:3, :3][np.ix_(LAST, LAST)]

    def map(self) -> dict[int, tuple[Array, Array]]:
        """Mean (2,) and covariance (2, 2) of each landmark by its number."""
        P = self.filter.linear()
        return {
            i: (self.filter.x[row], P[self.filter.columns(i), self.filter.columns(i)])
            for i, row in self.filter.rows.items()
        }
