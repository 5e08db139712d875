"""What a linearization leaves out of a predicted measurement: half of the errors' second-order term, and its variance.

h(x + e) = h + H e + e' H2 e / 2. Of Gaussian errors e of covariance P the last term has the mean tr(H2 P) / 2, and two
of them, of the numbers i and j of a measurement, the covariance tr(H2_i P H2_j P) / 2: the Gaussian second-order filter
(Athans, Wishner and Bertolini, IEEE TAC 13(5), 1968). It matters where two factors are uncertain together: an inverse
distance, and where the sensor is.

H2 is the difference of the Jacobians at neighbouring points. These are generated, for every pair of a sensor and a
parametrization; a model of second derivatives for each would be as many again, and each twenty times as long.
"""

from collections.abc import Callable

import numpy as np

from slamlib.entities import RigSensor
from slamlib.entities.landmark import landmark_means
from slamlib.geometry.pose import Pose, compose
from slamlib.manifolds import Array
from slamlib.observation.family import AnyFamily, PredictedBatch, product

STEP = 1e-5  # [m, rad, ...] to both sides: what is cut off is of its square, and rounding 1e-11 of the Jacobian


def second_derivatives(family: AnyFamily, sensor: RigSensor, expected: PredictedBatch, measured: Array) -> Array:
    """H2 (n, d, k, k) of n predicted measurements, w.r.t. the rows `expected.columns`, at the present means.

    measured (n, m): for families whose innovation depends on it. The difference of a Jacobian along one direction is
    that of neighbouring charts: two small rotations do not commute, and what this adds is antisymmetric. So the
    symmetric part is the second derivative. Zero where a neighbour cannot be measured.
    """
    robot, kind, means = sensor.robot, expected.landmarks[0].kind, landmark_means(expected.landmarks)
    n, k, own = len(means), expected.columns.shape[1], kind.manifold.dof
    steps = STEP * np.concatenate([np.eye(k), -np.eye(k)])
    ends = np.cumsum([len(robot.columns), k - own - len(robot.columns), own])
    by_robot, by_extrinsics, by_landmark = np.split(steps, ends[:-1], axis=1)

    states = robot.motion.manifold.plus(robot.block.mean, _padded(by_robot, robot.motion.manifold.dof))
    extrinsics = Pose.plus(sensor.extrinsics, _padded(by_extrinsics, Pose.dof))
    camera, J = compose.jac(robot.motion.pose(states), extrinsics)
    both = J.outer if sensor.block is None else np.concatenate([J.outer, J.inner], axis=-1)
    by = robot.motion.by_state(both, states)[:, None]
    there = kind.manifold.plus(means, by_landmark[:, None])
    inner, _, found = family.observe(kind, sensor.calibration, camera[:, None], there)
    rows = np.concatenate([product(found.camera, by), found.landmark], axis=-1)

    flat = rows.reshape(-1, *rows.shape[2:])
    values = np.tile(measured, (len(steps), 1))
    H = family.residual(sensor, inner.reshape(len(flat), -1), flat, values, expected.options).H
    H = H.reshape(2, k, n, -1, k)
    differences = np.moveaxis((H[0] - H[1]) / (2 * STEP), 0, 2)  # (n, d, along, k)
    return np.asarray((differences + differences.swapaxes(-1, -2)) / 2)


def variance(H2: Array, covariance: Array) -> Array:
    """Covariances (n, d, d) of e' H2 e / 2 of Gaussian errors with covariances (n, k, k): tr(H2_i P H2_j P) / 2."""
    HP = H2 @ covariance[:, None]
    half = np.einsum("niab,njba->nij", HP, HP) / 4
    return np.asarray(half + half.swapaxes(-1, -2))


def variance_left_out(family: AnyFamily, sensor: RigSensor, expected: PredictedBatch, covariance: Array) -> Array:
    """What the linearization leaves out of n predicted measurements, as noise (n, d, d); covariance (n, k, k)."""
    return variance(second_derivatives(family, sensor, expected, expected.value), covariance)


# What a filter takes into account of the second order, by the option's name.
SECOND_ORDER: dict[str, Callable[[AnyFamily, RigSensor, PredictedBatch, Array], Array]] = {
    "variance": variance_left_out,
}


def _padded(steps: Array, width: int) -> Array:
    return np.pad(steps, ((0, 0), (0, width - steps.shape[1])))
