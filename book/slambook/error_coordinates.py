"""Filters beside the right-invariant EKF: the same state and data, but other errors, Jacobians or updates.

They keep the covariance of phi and of the errors of positions themselves, delta_k = x_k - x_hat_k. A rotation of the
world moves these by phi^ x_k, so Jacobians hold positions, and H at one estimate is blind to another motion of the
world than H at the next: that is how an ordinary EKF learns what it cannot know (chapter ekf_slam). Three remedies; and
an update that is iterated, which is none.
"""

from collections.abc import Mapping

import numpy as np

from slambook.invariant_ekf import InvariantEkf, PointSensor, axes, exponential, levers, recoordinated
from slamlib.manifolds import Array


class OrdinaryEkf(InvariantEkf):
    """The EKF of the textbooks: P is the covariance of (phi, delta_0, delta_1, ...)."""

    def predict(self, turn: Array, shift: Array, U: Array) -> None:
        """x_0 + R t: the position's error takes its lever from the rotation's, F; what the map has in error stays."""
        before, was, k = self.R, self.robot()[1], self.m + self.d
        self.move(turn, shift)
        F, G = np.eye(k), np.zeros((k, k))
        F[self.m :, : self.m] = levers((self.robot()[1] - was)[None])
        G[: self.m, : self.m], G[self.m :, self.m :] = axes(before), before
        P = self.P.copy()
        P[:k] = F @ P[:k]
        P[:, :k] = P[:, :k] @ F.T
        P[:k, :k] += G @ U @ G.T
        self.P = P

    def robot(self) -> tuple[Array, Array]:
        """Rotation and position of the robot at which Jacobians are taken: the estimate."""
        return self.R, self.x[0]

    def landmark(self, i: int) -> Array:
        """Position of landmark i at which Jacobians are taken: the estimate."""
        return self.x[self.rows[i]]

    def predicted(self, i: int) -> tuple[Array, Array]:
        """Measurement (d,) of landmark i, and its Jacobian (d, size) with respect to (phi, delta_0, delta_1, ...)."""
        return super().predicted(i)[0], self.jacobian(i, *self.robot(), self.landmark(i))

    def jacobian(self, i: int, R: Array, position: Array, landmark: Array) -> Array:
        """Of y = R' (x_i - x_0): dy = R' (delta_i - delta_0 - phi^ (x_i - x_0)), and so a column for phi."""
        arm = landmark - position
        A = self.sensor.project(R.T @ arm)[1] @ R.T
        H = np.zeros((self.d, len(self.P)))
        H[:, : self.m], H[:, self.m : self.m + self.d], H[:, self.columns(i)] = -A @ levers(arm[None]), -A, A
        return H

    def retract(self, xi: Array) -> None:
        """The rotation is turned; positions are added to."""
        self.R, self.x = exponential(xi[: self.m], self.d)[0] @ self.R, self.x + xi[self.m :].reshape(self.x.shape)

    def by_robot(self, point: Array) -> Array:
        """Derivative (d, m + d) of a new landmark's error: delta_0, and the lever of the robot's rotation."""
        return np.hstack([levers((point - self.robot()[1])[None]), np.eye(self.d)])

    def invariant(self) -> Array:
        """Covariance of xi, at the estimate."""
        return recoordinated(self.P, -levers(self.x))

    def linear(self) -> Array:
        """Covariance of (phi, delta_0, delta_1, ...)."""
        return self.P


class TransportEkf(OrdinaryEkf):
    """The ordinary EKF, and after each update the covariance carried from the old means to the new: slamlib's "world".

    T P T' with T N(before) = N(after), where the columns of N are the motions of the world: errors phi^ x_k of the old
    means become those of the new ones. P is then what the covariance of xi is in these coordinates; the means are those
    of the right-invariant EKF but for the second order of the update, a sum in the place of the exponential.
    """

    def update(self, seen: Mapping[int, Array]) -> None:
        """As of the ordinary filter, and T P T'."""
        before = self.x
        super().update(seen)
        self.P = recoordinated(self.P, levers(self.x) - levers(before))


class FirstEstimatesEkf(OrdinaryEkf):
    """All Jacobians at one point each: landmarks where they were initialized, the robot where it was predicted.

    Huang, Mourikis and Roumeliotis (2008, 2010): all H are blind to the same N, which F carries on.
    """

    def __init__(self, R: Array, position: Array, covariance: Array, sensor: PointSensor, noise: Array) -> None:
        """As of the other filters."""
        super().__init__(R, position, covariance, sensor, noise)
        self.first_robot, self.first = (R, position), dict[int, Array]()

    def move(self, turn: Array, shift: Array) -> None:
        """As of the ordinary filter; where it leads is the robot's first estimate."""
        super().move(turn, shift)
        self.first_robot = self.R, self.x[0]

    def initialize(self, i: int, z: Array) -> None:
        """As of the ordinary filter; where it is put is the landmark's first estimate."""
        super().initialize(i, z)
        self.first[i] = self.x[-1]

    def robot(self) -> tuple[Array, Array]:
        """Rotation and position of the robot as it was predicted."""
        return self.first_robot

    def landmark(self, i: int) -> Array:
        """Position of landmark i as it was initialized."""
        return self.first[i]


class Fej2Ekf(FirstEstimatesEkf):
    """FEJ2: first estimates, without the rows of the measurements that feel their error.

    The innovation is H delta + noise with the best H, at the estimates. Written as (H_first + dH) delta + noise, dH is
    what first estimates leave out. With U' dH = 0, the left null space of dH, rows U' H_first are left: fewer, blind to
    the same N, and as good as the best. Of dH the robot's columns alone are taken; the landmarks', too, would leave no
    rows. Noise is whitened before. Chen, Yang, Geneva and Huang (2022), "FEJ2: A Consistent Visual-Inertial State
    Estimator Design".
    """

    NEGLIGIBLE = 1e-9  # of the largest singular value of H: a first estimate that is still the best one

    def linearized(self, seen: Mapping[int, Array]) -> tuple[Array, Array, Array]:
        """As of the other filters, combined."""
        nu, H, noise = super().linearized(seen)
        best = np.concatenate([self.jacobian(i, self.R, self.x[0], self.x[self.rows[i]]) for i in seen])
        root, k = np.linalg.cholesky(noise), self.m + self.d
        nu, H, best = (np.linalg.solve(root, part) for part in (nu, H, best))
        directions, sizes, _ = np.linalg.svd(best[:, :k] - H[:, :k])
        rank = int((sizes > self.NEGLIGIBLE * np.linalg.norm(H, 2)).sum())
        U = directions[:, rank:]
        return U.T @ nu, U.T @ H, np.eye(len(nu) - rank)


class IteratedEkf(OrdinaryEkf):
    """The ordinary EKF, whose tangents of a frame's measurements are taken again where prior and measurements meet.

    Gauss-Newton on |delta|_P^2 + |nu(delta)|_R^2, with |e|_R^2 = e' R^-1 e: each step is the EKF's update with H and nu
    at the last delta, and nu + H delta in the place of nu. A step that makes the sum larger is halved. delta = P w, for
    some w, so the sum needs no inverse of P. In space, rotations are composed to first order. Bell and Cathey, "The
    iterated Kalman filter update as a Gauss-Newton method" (1993).
    """

    STEPS, SMALL = 50, 1e-6  # [m, rad]

    def update(self, seen: Mapping[int, Array]) -> None:
        """All measurements of landmarks of the map, at once."""
        prior, P, w = (self.R, self.x), self.P, np.zeros(len(self.P))

        def at(w: Array) -> tuple[float, Array, Array, Array]:
            self.R, self.x = prior
            self.retract(P @ w)
            nu, H, noise = self.linearized(seen)
            return float(w @ P @ w + nu @ np.linalg.solve(noise, nu)), nu, H, noise

        cost, nu, H, noise = at(w)
        for _ in range(self.STEPS):
            step = H.T @ np.linalg.solve(H @ P @ H.T + noise, nu + H @ P @ w) - w
            tried = at(w + step)
            while tried[0] > cost and np.abs(P @ step).max() > self.SMALL:
                step = step / 2
                tried = at(w + step)
            w, (cost, nu, H, noise) = w + step, tried
            if np.abs(P @ step).max() < self.SMALL:
                break
        self.P = P - P @ H.T @ np.linalg.solve(H @ P @ H.T + noise, H @ P)
