"""Checks of the chapter: SLAM in five minutes."""

from typing import Any

import numpy as np

from slamlib.exercises import exercise
from slamlib.exercises.properties import covariance, same


@exercise("slam_in_five_minutes.1", "one robot, two landmarks")
def two_landmarks(candidate: Any) -> None:
    """What the covariance must say of the differences: they hold the ranges' errors and nothing of the robot's."""
    for var_r, var_z in ((0.25, 0.01), (0.01, 0.04), (4.0, 4.0)):
        given = f"var_r = {var_r}, var_z = {var_z}"
        P = covariance(candidate(var_r, var_z), 3, "the covariance")
        same(P[0, 0], var_r, "the robot is as uncertain as it was", given=given)
        D = np.array([[-1.0, 1, 0], [-1, 0, 1]])  # from the robot to each landmark
        same(np.diag(D @ P @ D.T), [var_z, var_z], "robot to landmark: as uncertain as the range", given=given)
        same(D @ P[0], [0.0, 0.0], "the ranges' errors do not depend on the robot's", given=given)
        apart = D[1] - D[0]
        same(apart @ P @ apart, 2 * var_z, "landmark to landmark: the robot's error cancels", given=given)


@exercise("slam_in_five_minutes.2", "a new landmark in the map")
def add_landmark(candidate: Any) -> None:
    """Against the transformation of all errors at once: old ones, and the measurement's."""
    rng = np.random.default_rng(2)
    for others in (0, 2, 4):
        n = 3 + others
        root = rng.standard_normal((n, n))
        P, R = root @ root.T, np.diag([0.3, 0.2])
        G_r, G_z = rng.standard_normal((2, 3)), rng.standard_normal((2, 2))
        found = covariance(candidate(P, G_r, G_z, R), n + 2, "the new covariance")
        T = np.zeros((n + 2, n + 2))  # (old errors, measurement's error) -> (old errors, landmark's error)
        T[:n, :n], T[n:, :3], T[n:, n:] = np.eye(n), G_r, G_z
        joint = np.zeros((n + 2, n + 2))
        joint[:n, :n], joint[n:, n:] = P, R
        same(found[:n, :n], P, "the old state is as it was")
        same(found[n:, n:], (T @ joint @ T.T)[n:, n:], "the landmark inherits the robot's error")
        same(found, T @ joint @ T.T, "and is correlated with all that the robot is correlated with")


@exercise("slam_in_five_minutes.3", "moving a robot with a map")
def predict(candidate: Any) -> None:
    """The joint covariance is that of the moved errors, and a rigid motion keeps what is known relatively."""
    rng = np.random.default_rng(3)
    for others in (0, 2, 4):
        n = 3 + others
        root, F = rng.standard_normal((n, n)), rng.standard_normal((3, 3))
        P, Q = root @ root.T, np.diag([0.1, 0.2, 0.05])
        found = covariance(candidate(P, F, Q), n, "the covariance")
        T = np.eye(n)
        T[:3, :3] = F
        expected = T @ P @ T.T
        expected[:3, :3] += Q
        same(found[3:, 3:], P[3:, 3:], "the map does not move")
        same(found[:3, 3:], F @ P[:3, 3:], "the robot's correlations move with the robot")
        same(found, expected, "the joint covariance is that of the moved errors")
