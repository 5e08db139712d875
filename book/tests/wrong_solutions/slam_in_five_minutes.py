"""Wrong solutions of chapter slam_in_five_minutes."""

import numpy as np

from book.tests.wrong_solutions import wrong

wrong("slam_in_five_minutes.1", "three variances and no correlations")(lambda r, z: np.diag([r, r + z, r + z]))
wrong("slam_in_five_minutes.1", "the landmarks are as certain as the ranges: the robot's error is not passed on")(
    lambda var_r, var_z: np.diag([var_r, var_z, var_z])
)
wrong("slam_in_five_minutes.1", "each landmark correlated with the robot, but not with the other one")(
    lambda r, z: np.array([[r, r, r], [r, r + z, 0], [r, 0, r + z]])
)


@wrong("slam_in_five_minutes.1", "standard deviations for variances")
def sigmas(var_r, var_z):
    return np.full((3, 3), var_r**0.5) + np.diag([0, var_z**0.5, var_z**0.5])


def _uncorrelated(P, corner):
    return np.pad(P, (0, len(corner))) + np.pad(corner, (len(P), 0))


wrong("slam_in_five_minutes.2", "the landmark is added without correlations")(
    lambda P, G_r, G_z, R: _uncorrelated(P, G_r @ P[:3, :3] @ G_r.T + G_z @ R @ G_z.T)
)
wrong("slam_in_five_minutes.2", "only the measurement's noise: the robot's error is forgotten")(
    lambda P, G_r, G_z, R: _uncorrelated(P, G_z @ R @ G_z.T)
)
wrong("slam_in_five_minutes.2", "a new landmark begins with covariance zero (E19)")(lambda P, *_: np.pad(P, (0, 2)))


@wrong("slam_in_five_minutes.2", "the measurement's covariance without the derivative of the landmark by it")
def noise_as_measured(P, G_r, G_z, R):
    row = G_r @ P[:3]
    return np.block([[P, row.T], [row, G_r @ P[:3, :3] @ G_r.T + R]])


@wrong("slam_in_five_minutes.2", "correlated with the robot only, not with the other landmarks (E18)")
def robot_only(P, G_r, G_z, R):
    row = np.zeros((2, len(P)))
    row[:, :3] = G_r @ P[:3, :3]
    return np.block([[P, row.T], [row, G_r @ P[:3, :3] @ G_r.T + G_z @ R @ G_z.T]])


@wrong("slam_in_five_minutes.2", "of R only the variances")
def variances(P, G_r, G_z, R):
    row = G_r @ P[:3]
    return np.block([[P, row.T], [row, row[:, :3] @ G_r.T + G_z * np.diag(R) @ G_z.T]])


@wrong("slam_in_five_minutes.3", "the robot's block only, as in PythonRobotics issue 972")
def block_only(P, F, Q):
    P = P.copy()
    P[:3, :3] = F @ P[:3, :3] @ F.T + Q
    return P


@wrong("slam_in_five_minutes.3", "the rows but not the columns")
def rows_only(P, F, Q):
    P = P.copy()
    P[:3, :3] = F @ P[:3, :3] @ F.T + Q
    P[:3, 3:] = F @ P[:3, 3:]
    return P


def _predicted(P, F, noise):
    T = np.eye(len(P))
    T[:3, :3] = F
    return T @ P @ T.T + np.pad(noise, (0, len(P) - len(noise)))


wrong("slam_in_five_minutes.3", "noise on everything, landmarks too (E09)")(
    lambda P, F, Q: _predicted(P, F, 0.1 * np.eye(len(P)))
)
wrong("slam_in_five_minutes.3", "of Q only the variances")(lambda P, F, Q: _predicted(P, F, np.diag(np.diag(Q))))


wrong("slam_in_five_minutes.1", "every covariance with the opposite sign: ranges point away from the robot")(
    lambda r, z: np.array([[r, -r, -r], [-r, r + z, r], [-r, r, r + z]])
)
wrong("slam_in_five_minutes.1", "correlations for covariances")(
    lambda r, z: np.array([[r, 1, 1], [1, r + z, r / (r + z)], [1, r / (r + z), r + z]])
)
wrong("slam_in_five_minutes.1", "one error of the sensor for both ranges")(
    lambda r, z: np.array([[r, r, r], [r, r + z, r + z], [r, r + z, r + z]])
)
wrong("slam_in_five_minutes.1", "the robot last")(
    lambda r, z: np.array([[r + z, r, r], [r, r + z, r], [r, r, r]], dtype=float)
)
wrong("slam_in_five_minutes.1", "the sensor makes the landmark more certain than the robot")(
    lambda r, z: np.full((3, 3), r) - np.diag([0, z, z])
)


def _added(P, row, corner):
    return np.block([[P, row.T], [row, corner]])


wrong("slam_in_five_minutes.2", "the derivative by the measurement on the wrong sides")(
    lambda P, G_r, G_z, R: _added(P, G_r @ P[:3], G_r @ P[:3, :3] @ G_r.T + G_z.T @ R @ G_z)
)
wrong("slam_in_five_minutes.2", "the robot's covariance is left out of the landmark's block")(
    lambda P, G_r, G_z, R: _added(P, G_r @ P[:3], G_r @ G_r.T + G_z @ R @ G_z.T)
)
wrong("slam_in_five_minutes.2", "only the robot's error: the sensor is perfect")(
    lambda P, G_r, G_z, R: _added(P, G_r @ P[:3], G_r @ P[:3, :3] @ G_r.T)
)
wrong("slam_in_five_minutes.2", "the rows below, and zeros in the columns beside")(
    lambda P, G_r, G_z, R: np.block(
        [[P, np.zeros((len(P), 2))], [G_r @ P[:3], G_r @ P[:3, :3] @ G_r.T + G_z @ R @ G_z.T]]
    )
)
wrong("slam_in_five_minutes.2", "the correlations of landmarks are copied from the position's, and not turned")(
    lambda P, G_r, G_z, R: _added(P, P[:2], G_r @ P[:3, :3] @ G_r.T + G_z @ R @ G_z.T)
)

wrong("slam_in_five_minutes.3", "the transposed derivative")(lambda P, F, Q: _predicted(P, F.T, Q))
wrong("slam_in_five_minutes.3", "Q is forgotten")(lambda P, F, Q: _predicted(P, F, 0 * Q))
wrong("slam_in_five_minutes.3", "Q is moved along: added before the motion")(
    lambda P, F, Q: _predicted(P + np.pad(Q, (0, len(P) - 3)), F, 0 * Q)
)
wrong("slam_in_five_minutes.3", "the errors stay as they are, and only Q is added")(
    lambda P, F, Q: P + np.pad(Q, (0, len(P) - 3))
)
wrong("slam_in_five_minutes.3", "the correlations are dropped: the landmarks did not move")(
    lambda P, F, Q: _uncorrelated(F @ P[:3, :3] @ F.T + Q, P[3:, 3:])
)


@wrong("slam_in_five_minutes.3", "the robot's block once more after its rows and columns")
def moved_twice(P, F, Q):
    P = P.copy()
    P[:3, :3] = F @ P[:3, :3] @ F.T + Q
    P[:3] = F @ P[:3]
    P[:, :3] = P[:, :3] @ F.T
    return P
