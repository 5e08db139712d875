"""Wrong solutions of chapter slam_in_five_minutes."""

import numpy as np

from book.tests.wrong_solutions import wrong


@wrong("slam_in_five_minutes.1", "three variances and no correlations")
def three_variances(var_r, var_z):
    return np.diag([var_r, var_r + var_z, var_r + var_z])


@wrong("slam_in_five_minutes.1", "the landmarks are as certain as the ranges: the robot's error is not passed on")
def ranges_only(var_r, var_z):
    return np.diag([var_r, var_z, var_z])


@wrong("slam_in_five_minutes.1", "each landmark correlated with the robot, but not with the other one")
def not_with_each_other(var_r, var_z):
    return np.array([[var_r, var_r, var_r], [var_r, var_r + var_z, 0], [var_r, 0, var_r + var_z]])


@wrong("slam_in_five_minutes.1", "standard deviations for variances")
def sigmas(var_r, var_z):
    return np.full((3, 3), var_r**0.5) + np.diag([0, var_z**0.5, var_z**0.5])


@wrong("slam_in_five_minutes.2", "the landmark is added without correlations")
def independent(P, G_r, G_z, R):
    zero = np.zeros((2, len(P)))
    return np.block([[P, zero.T], [zero, G_r @ P[:3, :3] @ G_r.T + G_z @ R @ G_z.T]])


@wrong("slam_in_five_minutes.2", "only the measurement's noise: the robot's error is forgotten")
def certain_robot(P, G_r, G_z, R):
    zero = np.zeros((2, len(P)))
    return np.block([[P, zero.T], [zero, G_z @ R @ G_z.T]])


@wrong("slam_in_five_minutes.2", "a new landmark begins with covariance zero (E19)")
def certain_landmark(P, G_r, G_z, R):
    zero = np.zeros((2, len(P)))
    return np.block([[P, zero.T], [zero, np.zeros((2, 2))]])


@wrong("slam_in_five_minutes.2", "the measurement's covariance without the derivative of the landmark by it")
def noise_as_measured(P, G_r, G_z, R):
    row = G_r @ P[:3]
    return np.block([[P, row.T], [row, G_r @ P[:3, :3] @ G_r.T + R]])


@wrong("slam_in_five_minutes.2", "correlated with the robot only, not with the other landmarks (E18)")
def robot_only(P, G_r, G_z, R):
    row = np.zeros((2, len(P)))
    row[:, :3] = G_r @ P[:3, :3]
    return np.block([[P, row.T], [row, G_r @ P[:3, :3] @ G_r.T + G_z @ R @ G_z.T]])


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


@wrong("slam_in_five_minutes.3", "noise on everything, landmarks too (E09)")
def noise_everywhere(P, F, Q):
    T = np.eye(len(P))
    T[:3, :3] = F
    return T @ P @ T.T + 0.1 * np.eye(len(P))
