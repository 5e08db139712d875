"""Wrong solutions of chapter 0."""

import numpy as np

from slamlib.tests.wrong_solutions import wrong


@wrong("0.2", "the landmark is added without correlations")
def independent(P, G_r, G_z, R):
    zero = np.zeros((2, len(P)))
    return np.block([[P, zero.T], [zero, G_r @ P[:3, :3] @ G_r.T + G_z @ R @ G_z.T]])


@wrong("0.2", "only the measurement's noise: the robot's error is forgotten (E19)")
def certain_robot(P, G_r, G_z, R):
    row = G_r @ P[:3]
    return np.block([[P, row.T], [row, G_r @ P[:3, :3] @ G_r.T + 0.5 * G_z @ R @ G_z.T]])


@wrong("0.2", "correlated with the robot only, not with the other landmarks (E18)")
def robot_only(P, G_r, G_z, R):
    row = np.zeros((2, len(P)))
    row[:, :3] = G_r @ P[:3, :3]
    return np.block([[P, row.T], [row, G_r @ P[:3, :3] @ G_r.T + G_z @ R @ G_z.T]])


@wrong("0.3", "the robot's block only, as in PythonRobotics issue 972")
def block_only(P, F, Q):
    P = P.copy()
    P[:3, :3] = F @ P[:3, :3] @ F.T + Q
    return P


@wrong("0.3", "the rows but not the columns")
def rows_only(P, F, Q):
    P = P.copy()
    P[:3, :3] = F @ P[:3, :3] @ F.T + Q
    P[:3, 3:] = F @ P[:3, 3:]
    return P


@wrong("0.3", "noise on everything, landmarks too (E09)")
def noise_everywhere(P, F, Q):
    T = np.eye(len(P))
    T[:3, :3] = F
    return T @ P @ T.T + 0.1 * np.eye(len(P))
