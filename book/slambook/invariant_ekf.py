"""SLAM by the right-invariant EKF: robot and landmarks are one element X of a group, and the error is X X_hat^-1.

In the plane (d = 2, a rotation is m = 1 number) and in space (d = 3, m = 3) by the same lines. The state is a rotation,
the robot's position and the landmarks, X = (R, x_0, x_1, ..., x_n) of the group SE_(1+n)(d), with the product

    (A, a_0, ..., a_n) (R, x_0, ..., x_n) = (A R, A x_0 + a_0, ..., A x_n + a_n).

Error: xi = (phi, xi_0, ..., xi_n) with X = exp(xi) X_hat. The exponential turns everything by E = exp(phi^), and shifts
position k by V xi_k, where V is the integral of exp(s phi^) over s from 0 to 1.

Prediction: the robot moves in its own frame, f(X) = (R T, x_0 + R t, x_1, ..., x_n), so f(A X) = A f(X) for each A,
which is more than the group affine property asks for. An error is the same after the step as before, exactly: F is the
identity. Noise in the robot's frame, w of its turn and v of its shift, turns R by R w, and shifts x_0 by R v. What has
not turned about the origin together with R is in error the other way: xi_k = [k = 0] R v - (R w)^ x_k. That matrix is
the adjoint of X, and all of the map has a share in the noise of a turn.

Measurement: of y = R' (x_i - x_0) alone. Of exp(xi) X_hat it is R_hat' E' (E d + V (xi_i - xi_0)), with d = x_i - x_0
of X_hat: to first order y_hat + R_hat' (xi_i - xi_0). There is no column for phi, and nothing is learned of a motion of
the world, which is the same phi, or the same xi_k for all k, whatever the estimate.

Update: X <- exp(K innovation) X. Initialization: x = x_0 + R y, whose error is xi_0 + R dy.

Barrau and Bonnabel, "An EKF-SLAM algorithm with consistency properties" (2015), and "The invariant extended Kalman
filter as a stable observer" (2017). In terms of errors of positions, delta_k = xi_k + phi^ x_k.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from slamlib.analytic import stumpff
from slamlib.manifolds import Array

# phi^ = sum_j phi_j GENERATORS[d][j], for the axes about which there is a rotation.
GENERATORS: dict[int, Array] = {
    2: np.array([[[0.0, -1], [1, 0]]]),
    3: np.cross(np.eye(3)[:, None], np.eye(3)).swapaxes(1, 2),
}


def exponential(phi: Array, d: int) -> tuple[Array, Array]:
    """E = exp(phi^), and V, the integral of exp(s phi^) over s from 0 to 1; (d, d), of a rotation phi (m,) [rad]."""
    W, square = np.tensordot(phi, GENERATORS[d], 1), float(phi @ phi)
    one, two, three = (stumpff(order, square) for order in (1, 2, 3))
    return np.eye(d) + one * W + two * W @ W, np.eye(d) + two * W + three * W @ W


def logarithm(E: Array) -> Array:
    """Rotation phi (m,) [rad], of less than half a turn, with exp(phi^) = E (d, d)."""
    sine = np.einsum("jab,ab->j", GENERATORS[len(E)], E) / 2
    size = np.linalg.norm(sine)
    angle = np.arctan2(size, (np.trace(E) - len(E) + 2) / 2)
    return np.asarray(sine * (angle / size if size else 1.0), dtype=float)


def levers(x: Array) -> Array:
    """How a rotation about the origin moves points (k, d): L (k d, m) with L phi = (phi^ x_1, ..., phi^ x_k)."""
    return np.einsum("jab,kb->kaj", GENERATORS[x.shape[1]], x).reshape(x.size, -1)


def axes(R: Array) -> Array:
    """From a rotation vector in the robot's frame to the same in the world's, (m, m): R in space, 1 in the plane."""
    G = GENERATORS[len(R)]
    return np.asarray(np.einsum("iab,jab->ij", G, R @ G @ R.T) / 2, dtype=float)


@dataclass(frozen=True)
class PointSensor:
    """A sensor of points in the robot's frame. project: y (d,) to the measurement (d,) and its Jacobian; locate: back.

    angles: which of the numbers of a measurement are the same after a whole turn.
    """

    project: Callable[[Array], tuple[Array, Array]]
    locate: Callable[[Array], Array]
    angles: tuple[int, ...] = ()

    def innovation(self, measured: Array, predicted: Array) -> Array:
        """Measured minus predicted (d,), angles by the shorter way."""
        nu = measured - predicted
        for k in self.angles:
            nu[k] = (nu[k] + np.pi) % (2 * np.pi) - np.pi
        return nu


def _bearing(y: Array) -> tuple[Array, Array]:
    r, turn = np.hypot(*y), y @ GENERATORS[2][0].T
    return np.array([r, np.arctan2(y[1], y[0])]), np.stack([y / r, turn / r**2])


def _bearings(y: Array) -> tuple[Array, Array]:
    r, level, (a, b, c) = np.linalg.norm(y), np.hypot(y[0], y[1]), y
    z = np.array([r, np.arctan2(b, a), np.arctan2(-c, level)])
    yaw, pitch = np.array([-b, a, 0]) / level**2, np.array([a * c / level, b * c / level, -level]) / r**2
    return z, np.stack([y / r, yaw, pitch])


def _at_bearings(z: Array) -> Array:
    (yaw, pitch), level = z[1:], z[0] * np.cos(z[2])
    return np.array([level * np.cos(yaw), level * np.sin(yaw), -z[0] * np.sin(pitch)])


# Range [m] and bearing [rad] in the plane; range, yaw to the left and pitch downwards in space; the position itself.
RANGE_BEARING = PointSensor(_bearing, lambda z: z[0] * np.array([np.cos(z[1]), np.sin(z[1])]), (1,))
RANGE_YAW_PITCH = PointSensor(_bearings, _at_bearings, (1,))
RELATIVE_POSITION = PointSensor(lambda y: (y, np.eye(len(y))), lambda z: z)


class InvariantEkf:
    """The filter of this file: R (d, d); x (1 + n, d), robot first [m]; P, covariance of (phi, xi_0, xi_1, ...)."""

    def __init__(self, R: Array, position: Array, covariance: Array, sensor: PointSensor, noise: Array) -> None:
        """covariance (m + d, m + d): of the robot's own (phi, xi_0); noise (d, d): of one measurement."""
        self.R, self.x, self.P = R, position[None], covariance
        self.sensor, self.noise = sensor, noise
        self.rows: dict[int, int] = {}  # of x, by the landmark's number
        self.d, self.m = len(position), len(covariance) - len(position)

    def predict(self, turn: Array, shift: Array, U: Array) -> None:
        """A step: turn (d, d), shift (d,) [m], U (m + d, m + d) of their noise (w, v), all in the robot's frame."""
        before, m, d = self.R, self.m, self.d
        self.move(turn, shift)
        G = np.zeros((len(self.P), m + d))
        G[:m, :m], G[m : m + d, m:] = axes(before), before
        G[m:, :m] = -levers(self.x) @ axes(before)
        self.P = self.P + G @ U @ G.T

    def move(self, turn: Array, shift: Array) -> None:
        """The mean of a step."""
        self.x = np.concatenate([self.x[:1] + self.R @ shift, self.x[1:]])
        self.R = self.R @ turn

    def columns(self, i: int) -> slice:
        """Where the covariance has landmark i."""
        start = self.m + self.d * self.rows[i]
        return slice(start, start + self.d)

    def predicted(self, i: int) -> tuple[Array, Array]:
        """Measurement (d,) of landmark i, and its Jacobian (d, size) with respect to xi."""
        z, by_y = self.sensor.project(self.R.T @ (self.x[self.rows[i]] - self.x[0]))
        H = np.zeros((self.d, len(self.P)))
        H[:, self.m : self.m + self.d], H[:, self.columns(i)] = -by_y @ self.R.T, by_y @ self.R.T
        return z, H

    def linearized(self, seen: Mapping[int, Array]) -> tuple[Array, Array, Array]:
        """Innovations (k,), Jacobian (k, size) and noise (k, k) of all measurements (d,) by the landmarks' numbers."""
        pairs = [(self.predicted(i), z) for i, z in seen.items()]
        nu = np.concatenate([self.sensor.innovation(z, expected) for (expected, _), z in pairs])
        noise = np.asarray(np.kron(np.eye(len(pairs)), self.noise), dtype=float)
        return nu, np.concatenate([H for (_, H), _ in pairs]), noise

    def update(self, seen: Mapping[int, Array]) -> None:
        """All measurements of landmarks of the map, at once."""
        nu, H, noise = self.linearized(seen)
        S = H @ self.P @ H.T + noise
        K = np.linalg.solve(S, H @ self.P).T
        self.retract(K @ nu)
        self.P = self.P - K @ S @ K.T

    def retract(self, xi: Array) -> None:
        """X <- exp(xi) X: everything is turned about the origin, and shifted."""
        E, V = exponential(xi[: self.m], self.d)
        self.R, self.x = E @ self.R, self.x @ E.T + xi[self.m :].reshape(self.x.shape) @ V.T

    def initialize(self, i: int, z: Array) -> None:
        """Landmark i where it is measured; what its error shares with the robot's is in the rows of `by_robot`."""
        y = self.sensor.locate(z)
        by_z = self.R @ np.linalg.inv(self.sensor.project(y)[1])
        self.rows[i], self.x = len(self.x), np.concatenate([self.x, self.x[:1] + self.R @ y])
        by_robot = self.by_robot(self.x[-1])
        shared = by_robot @ self.P[: self.m + self.d]
        own = shared[:, : self.m + self.d] @ by_robot.T + by_z @ self.noise @ by_z.T
        self.P = np.block([[self.P, shared.T], [shared, own]])

    def by_robot(self, point: Array) -> Array:
        """Derivative (d, m + d) of a new landmark's error with respect to the robot's: xi_0 itself."""
        return np.eye(self.d, self.m + self.d, self.m)

    def step(self, turn: Array, shift: Array, U: Array, seen: Mapping[int, Array]) -> None:
        """A step, and what was seen after it: landmarks of the map update it, the others are initialized."""
        self.predict(turn, shift, U)
        known = {i: z for i, z in seen.items() if i in self.rows}
        if known:
            self.update(known)
        for i in seen.keys() - known.keys():
            self.initialize(i, seen[i])

    def invariant(self) -> Array:
        """Covariance of xi."""
        return self.P

    def linear(self) -> Array:
        """Covariance of (phi, delta_0, delta_1, ...), delta_k = xi_k + phi^ x_k: the errors of positions themselves."""
        return recoordinated(self.P, levers(self.x))


def recoordinated(P: Array, L: Array) -> Array:
    """T P T' of T = [[I, 0], [L, I]]: L (k d, m) times phi is added to the errors of positions."""
    m, added = L.shape[1], L @ P[: L.shape[1]]
    P = P.copy()
    P[m:] += added
    P[:, m:] += P[:, :m] @ L.T
    return P


def squared_errors(filter: InvariantEkf, R: Array, position: Array) -> tuple[float, float]:
    """NEES of the robot, whose truth is R (d, d) and position (d,): in the linear error, and in log(X X_hat^-1)."""
    E, k = R @ filter.R.T, filter.m + filter.d
    phi = logarithm(E)
    V = exponential(phi, filter.d)[1]
    linear = np.concatenate([phi, position - filter.x[0]])
    xi = np.concatenate([phi, np.linalg.solve(V, position - E @ filter.x[0])])
    pairs = (linear, filter.linear()), (xi, filter.invariant())
    found = [float(e @ np.linalg.solve(P[:k, :k], e)) for e, P in pairs]
    return found[0], found[1]
