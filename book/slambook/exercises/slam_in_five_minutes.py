"""Checks of the chapter: SLAM in five minutes."""

import numpy as np

from slambook.exercises.kit import Candidate, Rng, array_of, cases, covariance, exercise, random_covariance, same


@exercise("slam_in_five_minutes.1", "one robot, two landmarks")
def two_landmarks(candidate: Candidate) -> None:
    """What the covariance must say of the differences: they hold the ranges' errors and nothing of the robot's."""
    D = np.array([[-1.0, 1, 0], [-1, 0, 1]])  # from the robot to each landmark
    for var_r, var_z in cases(((0.25, 0.01), (0.01, 0.04), (4.0, 4.0)), "var_r = {}, var_z = {}"):
        P = array_of(candidate(var_r, var_z), (3, 3), "the covariance")
        same(P[0, 0], var_r, "the robot is as uncertain as it was")
        same(D @ P[0], [0.0, 0.0], "the ranges' errors do not depend on the robot's")
        same(np.diag(D @ P @ D.T), [var_z, var_z], "robot to landmark: as uncertain as the range")
        apart = D[1] - D[0]
        same(apart @ P @ apart, 2 * var_z, "landmark to landmark: the robot's error cancels")
        covariance(P, 3)


@exercise("slam_in_five_minutes.2", "a new landmark in the map", seed=2)
def add_landmark(candidate: Candidate, rng: Rng) -> None:
    """Against the transformation of all errors at once: old ones, and the measurement's."""
    for n in cases((5, 7, 3), "a state of {} numbers, three of them the pose's"):
        P, R = random_covariance(rng, n), random_covariance(rng, 2)
        G_r, G_z = rng.standard_normal((2, 3)), rng.standard_normal((2, 2))
        found = array_of(candidate(P, G_r, G_z, R), (n + 2, n + 2), "the new covariance")
        T, joint = np.eye(n + 2), np.zeros((n + 2, n + 2))
        T[n:, :3], T[n:, n:] = G_r, G_z  # (old errors, measurement's error) -> (old errors, landmark's error)
        joint[:n, :n], joint[n:, n:] = P, R
        expected = T @ joint @ T.T
        same(found[:n, :n], P, "the old state is as it was")
        same(found[n:, :3], expected[n:, :3], "the landmark shares the robot's error")
        same(found[n:, 3:n], expected[n:, 3:n], "and is correlated with all that the robot is correlated with")
        same(found[:n, n:], found[n:, :n].T, "its columns hold the same numbers as its rows")
        same(found[n:, n:], expected[n:, n:], "its own block has the robot's error and the measurement's")
        covariance(found, n + 2, "the new covariance")


@exercise("slam_in_five_minutes.3", "moving a robot with a map", seed=3)
def predict(candidate: Candidate, rng: Rng) -> None:
    """Block by block against the covariance of the moved errors, first where there are landmarks."""
    for n in cases((5, 7, 3), "a state of {} numbers, three of them the pose's"):
        P, F, Q = random_covariance(rng, n), rng.standard_normal((3, 3)), random_covariance(rng, 3)
        found = array_of(candidate(P, F, Q), (n, n), "the covariance")
        same(found[3:, 3:], P[3:, 3:], "the map does not move")
        same(found[:3, 3:], F @ P[:3, 3:], "the robot's correlations move with the robot")
        same(found[3:, :3], found[:3, 3:].T, "the columns of the pose hold the same numbers as its rows")
        same(found[:3, :3], F @ P[:3, :3] @ F.T + Q, "the robot's own block is moved on both sides, and Q added once")
        covariance(found, n)
