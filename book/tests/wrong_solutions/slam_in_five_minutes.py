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
    return np.pad(P, (0, 2)) + np.pad(corner, (len(P), 0))


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
