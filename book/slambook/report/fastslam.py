"""FastSLAM in the plane: particles for the path, for each landmark a small Kalman filter.

Given the path, what is known of one landmark says nothing of another. So a particle, which is one path, needs no joint
covariance: 2 numbers and a 2 by 2 matrix for each landmark. FastSLAM 1.0 (Montemerlo et al. 2002) samples paths from
the odometry and weights them by the measurements; 2.0 (Montemerlo et al. 2003) samples them from odometry and
measurements together. When few particles hold most of the weight they are resampled, and a path that is not drawn
loses its map.
"""

import numpy as np

from slambook.report.angles import wrapped
from slambook.report.planar import Data, PlanarScan, moved, placed, seen, seen_by_point
from slamlib.errors import SlamlibError
from slamlib.manifolds import Array, Indices


class FastSlam:
    """FastSLAM 1.0: N particles side by side.

    Poses (N, 3), means (N, L, 2) and covariances (N, L, 2, 2) of landmarks, log weights.
    known (L,): the landmarks seen so far, the same for every particle (known data association). parents: for each step
    (N,), of which particle each descends; effective: number of particles that the weights are worth, for each step.
    """

    def __init__(self, data: Data, particles: int, rng: np.random.Generator, share: float = 0.5) -> None:
        """share: particles are drawn again when the effective number falls below this share of them; 0: never."""
        if particles < 1 or not 0 <= share <= 1:
            raise SlamlibError(f"FastSlam: one particle or more, and a share of 0 to 1; got {particles} and {share}")
        n, landmarks = particles, len(data.points)
        self._rng, self._least = rng, share * n
        self._motion_std, self._R = data.motion_std, np.diag(data.look_std**2)
        self.poses = np.tile(data.truth[0], (n, 1))
        self.means, self.covariances = np.zeros((n, landmarks, 2)), np.zeros((n, landmarks, 2, 2))
        self.known = np.zeros(landmarks, dtype=bool)
        self.log_weights = np.full(n, -np.log(n))
        self.parents: list[Indices] = []
        self.effective: list[float] = []
        self._initialize(data.scans[0])

    def step(self, u: Array, scan: PlanarScan) -> None:
        """Odometry u (3,), then the measurements; resamples first if the last step left few effective particles."""
        parents: Indices = np.arange(len(self.poses))
        if self.effective and self.effective[-1] < self._least:
            parents = systematic(self.weights, self._rng)
            self.poses, self.means = self.poses[parents], self.means[parents]
            self.covariances = self.covariances[parents]
            self.log_weights = np.full(len(parents), -np.log(len(parents)))
        self.parents.append(parents)
        old = self.known[scan.names]
        logs = self.log_weights + self._move_and_update(u, PlanarScan(scan.names[old], scan.z[old]))
        logs -= logs.max()
        self.log_weights = logs - np.log(np.exp(logs).sum())
        self._initialize(PlanarScan(scan.names[~old], scan.z[~old]))
        self.effective.append(float(1 / (self.weights**2).sum()))

    @property
    def weights(self) -> Array:
        """Weights (N,), of sum 1."""
        return np.exp(self.log_weights)

    def _move_and_update(self, u: Array, scan: PlanarScan) -> Array:
        """Poses are drawn from the motion; returns the log likelihoods (N,) of known landmarks' measurements there."""
        noise = self._motion_std * self._rng.standard_normal(self.poses.shape)
        self.poses = moved(self.poses, u + noise)
        H, innovation, inverse, determinant = self._predicted(self.poses, scan)
        self._update(scan.names, H, innovation, inverse)
        white = (inverse @ innovation[..., None])[..., 0]
        return -((innovation * white).sum(-1) + np.log(determinant)).sum(-1) / 2  # but for a constant

    def _predicted(self, poses: Array, scan: PlanarScan) -> tuple[Array, Array, Array, Array]:
        """From given poses: H (N, m, 2, 2) w.r.t. landmarks, innovations (N, m, 2), inverses and determinants of S."""
        means = self.means[:, scan.names]
        H = seen_by_point(poses, means)
        innovation = scan.z - seen(poses, means)
        innovation[..., 1] = wrapped(innovation[..., 1])
        return H, innovation, *_inverse(H @ self.covariances[:, scan.names] @ H.swapaxes(-1, -2) + self._R)

    def _update(self, names: Indices, H: Array, innovation: Array, inverse: Array) -> None:
        """Each landmark's Kalman filter, in each particle."""
        C = self.covariances[:, names]
        CH = C @ H.swapaxes(-1, -2)
        self.means[:, names] += (CH @ inverse @ innovation[..., None])[..., 0]
        self.covariances[:, names] = C - CH @ inverse @ CH.swapaxes(-1, -2)

    def _initialize(self, scan: PlanarScan) -> None:
        """New landmarks: every particle puts them where it sees them; the weights stay."""
        m = placed(self.poses, scan.z)
        by_z, _ = _inverse(seen_by_point(self.poses, m))
        self.means[:, scan.names] = m
        self.covariances[:, scan.names] = by_z @ self._R @ by_z.swapaxes(-1, -2)
        self.known[scan.names] = True

    def pose(self) -> tuple[Array, Array]:
        """Mean (3,) and covariance (3, 3) of the particles' poses."""
        away = self.poses - self.poses[np.argmax(self.log_weights)]
        away[:, 2] = wrapped(away[:, 2])
        mean, covariance = _moments(away, self.weights)
        return self.poses[np.argmax(self.log_weights)] + mean, covariance

    def map(self) -> dict[int, tuple[Array, Array]]:
        """Mean (2,) and covariance (2, 2) of each landmark by its number: that of the mixture of all particles'."""
        found = {}
        for name in np.flatnonzero(self.known):
            mean, spread = _moments(self.means[:, name], self.weights)
            found[int(name)] = mean, spread + np.tensordot(self.weights, self.covariances[:, name], 1)
        return found

    def ancestors(self) -> Array:
        """Of how many particles of each step (n,) today's particles descend: 1 where all share one history."""
        line: Indices = np.arange(len(self.poses))
        found = []
        for parents in reversed(self.parents):
            found.append(len(np.unique(line)))
            line = parents[line]
        return np.array(found[::-1])


class FastSlam2(FastSlam):
    """FastSLAM 2.0: poses are drawn from what odometry and measurements say together."""

    def _move_and_update(self, u: Array, scan: PlanarScan) -> Array:
        """Poses are drawn from the proposal; returns log p(z | path so far) (N,), whatever pose was drawn."""
        mean, covariance, density = self.proposal(u, scan)
        noise = self._rng.standard_normal(mean.shape)
        self.poses = mean + (np.linalg.cholesky(covariance) @ noise[..., None])[..., 0]
        self._update(scan.names, *self._predicted(self.poses, scan)[:3])
        return density

    def proposal(self, u: Array, scan: PlanarScan) -> tuple[Array, Array, Array]:
        """Gaussian of the new pose for each particle, means (N, 3) and covariances (N, 3, 3), and log p(z) (N,).

        All is linear about the pose that odometry u (3,) predicts. Information adds up, that of the odometry and of
        each known landmark; log p(z) leaves out a constant. The motion's noise must not be zero.
        """
        mean = moved(self.poses, u)
        H, innovation, inverse, determinant = self._predicted(mean, scan)
        J = np.concatenate([-H, np.broadcast_to([[0.0], [-1.0]], (*H.shape[:-1], 1))], -1)  # w.r.t. the pose
        JW = J.swapaxes(-1, -2) @ inverse
        c, s = np.cos(self.poses[:, 2]), np.sin(self.poses[:, 2])
        G = np.zeros((len(mean), 3, 3))
        G[:, 0, 0], G[:, 0, 1], G[:, 1, 0], G[:, 1, 1], G[:, 2, 2] = c, -s, s, c, 1
        own = G / self._motion_std**2 @ G.swapaxes(-1, -2)
        information = own + (JW @ J).sum(1)
        b = (JW @ innovation[..., None]).sum(1)
        covariance = np.linalg.inv(information)
        white = (inverse @ innovation[..., None])[..., 0]
        square = (innovation * white).sum((-1, -2)) - (b * (covariance @ b)).sum((-1, -2))
        size = np.log(determinant).sum(-1) + np.log(np.linalg.det(information))  # and log det of the motion's
        return mean + (covariance @ b)[..., 0], covariance, -(square + size) / 2


def systematic(weights: Array, rng: np.random.Generator) -> Indices:
    """Numbers (N,) of the particles drawn: each floor or ceiling of N times its weight, by one random number."""
    n = len(weights)
    stops = np.cumsum(weights)
    return np.minimum(np.searchsorted(stops / stops[-1], (np.arange(n) + rng.random()) / n, side="right"), n - 1)


def _inverse(matrix: Array) -> tuple[Array, Array]:
    """Inverses and determinants of matrices (..., 2, 2)."""
    (a, b), (c, d) = np.moveaxis(matrix, (-2, -1), (0, 1))
    determinant = a * d - b * c
    rows = (d, -b), (-c, a)
    return np.stack([np.stack(row, -1) for row in rows], -2) / determinant[..., None, None], determinant


def _moments(values: Array, weights: Array) -> tuple[Array, Array]:
    """Mean (k,) and covariance (k, k) of weighted values (N, k)."""
    mean = weights @ values
    away = values - mean
    return mean, (weights * away.T) @ away
