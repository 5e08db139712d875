"""The same matches for the motion and for the map: the noise of the measurements as a part of the state (E21).

The control is a function of measurements, u = g(z_old, z_new), and both are used elsewhere: z_old has updated the map
one step before, z_new updates it now. With the noises n of both pairs as blocks of the belief nothing is used twice:

    measured    z = h(x, m) + n          n is a block with mean 0 and covariance R; no further noise
    moved       x' = f(x, u - G_old n_old - G_new n_new)   G: derivatives of the fit g
    initialized m = h^-1(x', z - n)

Updated with z_old, n_old has a mean, and is correlated with the state by -K R (K: the gain); after the motion x'
is correlated with n_new, so that cov(z_new) = H P H' + H C + C' H' + R with C = cov((x', m), n_new): the Kalman filter
with correlated noises, of which nothing needs to be written down. Then n_old is marginalized out.

The result is short. If all matches are of landmarks, the control adds nothing to the map and z_new: it is the
same as no control at all, one of infinite covariance, from which u is only where to linearize. If some are not, it is
the same as a control from those alone. vision.stereo.motion_source uses that; here is the proof, for small maps.
"""

import numpy as np

from slamlib.belief import Belief, Block
from slamlib.errors import SlamlibError
from slamlib.geometry.pose import ORIGIN, Pose
from slamlib.kalman.update import LinearizedMeasurement
from slamlib.landmarks.euc_point import EUC_POINT
from slamlib.manifolds import Array
from slamlib.motions import ODOMETRY
from slamlib.observation.points import initialize, observe
from slamlib.sensors.sensor import Calibration
from slamlib.vision.stereo.fitting import _linear
from slamlib.vision.stereo.odometry import control_axes, motion_between

# The share of R that is no state: where all matches are landmarks, the fit leaves six of their innovations at zero, and
# without noise of their own these have a covariance of zero but for errors of the second order.
APART = 0.03


class SharedNoise:
    """EKF-SLAM of stereo points with ids. belief: of pose, landmarks, and noises of the present pair."""

    def __init__(self, calibration: Calibration, extrinsics: Array = ORIGIN, pose: Array = ORIGIN) -> None:
        """pose (7,): of the robot in the first pair; it is known there, as the world's frame."""
        self.calibration, self.extrinsics = calibration, extrinsics
        self.belief = Belief()
        self.robot = self.belief.add(Pose, pose, np.zeros((6, 6)))
        self.landmarks: dict[int, Block] = {}
        self.ids, self.values = np.zeros(0, dtype=int), np.zeros((0, 3))
        self.noise: Block | None = None

    def step(self, ids: Array, values: Array, mapped: Array | None = None) -> None:
        """Measurements (n, 3) [px] of points with ids (n,): all move the robot; those `mapped` (n,) are landmarks too.

        Raises SlamlibError where no motion is found.
        """
        noise = self._noises(len(ids))
        if self.noise is not None:
            self._move(ids, values, self.noise, noise)
            self.belief.remove(self.noise)
        self.ids, self.values, self.noise = ids, values, noise
        seen = np.ones(len(ids), dtype=bool) if mapped is None else mapped
        known = np.array([number in self.landmarks for number in ids.tolist()], dtype=bool)
        self._update(np.flatnonzero(known), noise)
        for row in np.flatnonzero(seen & ~known).tolist():
            self._initialize(row, noise)

    def _noises(self, count: int) -> Block:
        return self.belief.add(3 * count, np.zeros(3 * count), np.kron(np.eye(count), self.calibration.noise))

    def _move(self, ids: Array, values: Array, before: Block, noise: Block) -> None:
        _, a, b = np.intersect1d(self.ids, ids, return_indices=True)
        found = motion_between(self.calibration, self.values[a], values[b], self.extrinsics)
        if found is None:
            raise SlamlibError(f"SharedNoise: no motion is found from {len(a)} common points; give it eight or more")
        a, b = a[found.inliers], b[found.inliers]
        by_old, by_new = derivatives(self.calibration, self.extrinsics, self.values[a], values[b], found.pose)
        axes = control_axes(found.pose)
        old, new = _spread(axes @ by_old, a, len(self.ids)), _spread(axes @ by_new, b, len(ids))
        control = found.control.value - old @ before.mean
        pose, J = ODOMETRY.step.jac(self.robot.mean, control, 1.0)
        given = [self.robot, before, noise]
        moved = self.belief.add(
            Pose, pose, np.zeros((6, 6)), given=given, jacobians=[J.state, -J.control @ old, -J.control @ new]
        )
        self.belief.remove(self.robot)
        self.robot = moved

    def _update(self, rows: Array, noise: Block) -> None:
        if not len(rows):
            return
        blocks = [self.landmarks[int(self.ids[row])] for row in rows]
        points = np.array([block.mean for block in blocks])
        seen = observe(EUC_POINT, self.calibration, self.robot.mean, self.extrinsics, points)
        z = self.values[rows] - seen.value - noise.mean.reshape(-1, 3)[rows]
        by = zip(seen.jacobians.robot, seen.jacobians.landmark, self._own(rows), strict=True)
        pairs = zip(blocks, by, z, strict=True)
        own = APART * self.calibration.noise
        self.belief.update_all(
            [LinearizedMeasurement([self.robot, block, noise], list(J), one, own) for block, J, one in pairs]
        )

    def _initialize(self, row: int, noise: Block) -> None:
        value = self.values[row] - noise.mean.reshape(-1, 3)[row]
        point, J = initialize(EUC_POINT, self.calibration, self.robot.mean, self.extrinsics, value)
        by_noise = -J.measurement @ self._own(np.array([row]))[0]
        self.landmarks[int(self.ids[row])] = self.belief.add(
            EUC_POINT.manifold, point, np.zeros((3, 3)), given=[self.robot, noise], jacobians=[J.robot, by_noise]
        )

    def _own(self, rows: Array) -> Array:
        """Jacobians (k, 3, 3 n) of each of the measurements `rows` by all noises: the identity at its own."""
        return _each(np.broadcast_to(np.eye(3), (len(rows), 3, 3)), rows, len(self.ids))


def _each(parts: Array, rows: Array, count: int) -> Array:
    """Matrices (k, m, 3) as (k, m, 3 count), each at the columns of its row."""
    wide = np.zeros((len(rows), parts.shape[1], count, 3))
    wide[np.arange(len(rows)), :, rows] = parts
    return wide.reshape(len(rows), parts.shape[1], 3 * count)


def _spread(parts: Array, rows: Array, count: int) -> Array:
    """Jacobians (k, m, 3) by different measurements as one (m, 3 count) by all of them."""
    return _each(parts, rows, count).sum(0)


def derivatives(
    calibration: Calibration, extrinsics: Array, old: Array, new: Array, pose: Array
) -> tuple[Array, Array]:
    """How much the fitted pose (6,) moves with each old and each new measurement: (n, 6, 3) and (n, 6, 3).

    To first order, as the covariance is: sum of G R G' over both is that of `fit`.
    """
    _, A, G, S = _linear(calibration, extrinsics, old, new, pose, old)
    weighted = A.swapaxes(-1, -2) @ np.linalg.inv(S)
    by_new = np.linalg.inv((weighted @ A).sum(0)) @ weighted
    return -by_new @ G, by_new
