"""EKF-SLAM in the plane on slamlib's belief: what FastSLAM is compared with."""

import numpy as np

from slambook.report.angles import wrapped
from slambook.report.planar import Data, PlanarScan, moved, moved_by, placed, seen, seen_by_point
from slamlib.belief import Belief, Block, LinearizedMeasurement
from slamlib.manifolds import Array


class PlanarEkf:
    """Pose and landmarks in one Gaussian. It starts at a pose known exactly, with a first scan.

    U (3, 3): covariance of the odometry's noise; it may be changed from step to step.
    """

    def __init__(self, data: Data) -> None:
        self.U, self._R = np.diag(data.motion_std**2), np.diag(data.look_std**2)
        self.belief, self.landmarks = Belief(), dict[int, Block]()
        self._pose = self.belief.add(3, data.truth[0], np.zeros((3, 3)))
        self._initialize(data.scans[0])

    def step(self, u: Array, scan: PlanarScan) -> None:
        """Odometry u (3,), then the measurements."""
        x = self._pose.mean
        F, G = moved_by(x, u)
        self.belief.predict(self._pose, moved(x, u), F, G @ self.U @ G.T)
        known = [self._observed(self.landmarks[n], z) for n, z in zip(scan.names, scan.z, strict=True) if n in self]
        if known:
            self.belief.update_all(known)
        self._initialize(scan)

    def __contains__(self, name: int) -> bool:
        return name in self.landmarks

    def _observed(self, point: Block, z: Array) -> LinearizedMeasurement:
        pose, m = self._pose.mean, point.mean[None]
        innovation = z - seen(pose, m)[0]
        innovation[1] = wrapped(innovation[1])
        by_point = seen_by_point(pose, m)[0]
        by_pose = np.column_stack([-by_point, [0, -1]])
        return LinearizedMeasurement([self._pose, point], [by_pose, by_point], innovation, self._R)

    def _initialize(self, scan: PlanarScan) -> None:
        """Landmarks that are seen for the first time: `placed`, and its derivatives."""
        pose = self._pose.mean
        for name, z in zip(scan.names, scan.z, strict=True):
            if name not in self:
                m = placed(pose, z[None])
                by_z = np.linalg.inv(seen_by_point(pose, m)[0])
                by_pose = np.column_stack([np.eye(2), by_z[:, 1]])  # a turn of the robot is a turn of the bearing
                own = by_z @ self._R @ by_z.T
                self.landmarks[int(name)] = self.belief.add(2, m[0], own, given=[self._pose], jacobians=[by_pose])

    def pose(self) -> tuple[Array, Array]:
        """Mean (3,) and covariance (3, 3)."""
        return self._pose.mean, self.belief.covariance(self._pose)

    def map(self) -> dict[int, tuple[Array, Array]]:
        """Mean (2,) and covariance (2, 2) of each landmark by its number."""
        return {name: (b.mean, self.belief.covariance(b)) for name, b in self.landmarks.items()}
