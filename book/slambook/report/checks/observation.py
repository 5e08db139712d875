"""Checks of the observation: (5.24) to (5.30)."""

import numpy as np

from slambook.report import observation, scenes
from slambook.report.filter import Memory
from slambook.report.findings import Findings, at_least, at_most, check, near, ran, refused, statistics
from slambook.report.switches import Equations
from slamlib.manifolds import Array
from slamlib.models.numerical import differences


def _poses_and_points(seed: int) -> tuple[Array, Array]:
    rng = np.random.default_rng(seed)
    return rng.uniform(-1, 1, (100, 6)), rng.uniform(-5, 5, (100, 4, 3))


@check("E11", "(5.24)-(5.25)", "landmark as a 4x4 matrix with a zero block", "z = R'(m - t)")
def matrices() -> Findings:
    pose, points = _poses_and_points(11)
    M = np.zeros((4, 4))
    M[:3, 3], M[3, 3] = points[0, 0], 1
    same = np.abs(observation.by_matrices(pose, points) - observation.by_vectors(pose, points)).max()
    yield at_most("as printed minus R'(m - t), 400 points", same, 1e-12)
    yield near("rank of the 4x4 matrix", np.linalg.matrix_rank(M), 1, 0)
    yield near("its determinant", np.linalg.det(M), 0, 0)
    yield near("multiplications of T^-1 M, in those of T^-1 m", 4**3 / 4**2, 4, 0)


@check(
    "E12",
    "(5.26)",
    "diag(sigma_x, sigma_y, sigma_y), 'Each value represent the variance'",
    "the third is z's; squares, if the letters are deviations; full for stereo",
)
def squares() -> Findings:
    run, right = ran("gentle", "E12"), ran("gentle")
    R = scenes.stereo(700.0, 0.3, 0.5)(Equations(), np.array([10.0, -2, -0.5]))  # ahead, left, up
    depth, side, height = np.sqrt(np.diag(R))
    yield near("effective deviation over sigma, sigma 0.1", 0.1**-0.5, 3.2, 0.05)
    yield near("effective deviation over sigma, sigma 0.02", 0.02**-0.5, 7.07, 0.05)
    yield near("effective deviation over sigma, sigma 2", 2**-0.5, 0.71, 0.005)
    yield near("error of the position, gentle [m]", run.position, 0.053, 0.012)
    yield near("NEES/6, gentle", run.ratio, 0.40, 0.08)
    yield near("stereo at 10 m, 2 m aside, 0.5 m below: side [m]", side, 0.063, 0.001)
    yield near("height [m]", height, 0.018, 0.0005)
    yield near("depth [m]", depth, 0.337, 0.001)
    yield near("|correlation| of side and depth", abs(R[0, 1]) / depth / side, 1.0, 0.01)
    yield statistics(("gentle", run), ("right", right))


@check("E13", "(5.27)", "last factor of the mixed term by x_i", "by the pose: dh/dx, 1 by 6")
def mixed_term() -> Findings:
    rng = np.random.default_rng(13)
    root, h = rng.standard_normal((9, 9)), rng.standard_normal(9)
    P = root @ root.T
    ours = observation.scalar_variance(h[:6], h[6:], P[:6, :6], P[6:, :6], P[6:, 6:])
    yield at_most("corrected (5.27) minus h P h', relative", float(abs(ours / (h @ P @ h) - 1)), 1e-12)
    yield near("as printed, (1x3)(3x6)(3x1): NumPy refuses", refused("E13"), 1, 0)


@check("E14", "5.3.4", "full S of size 6 + 3L", "S is 3m by 3m, K is 6 + 3L by 3m")
def size_of_S() -> Findings:
    L, m = 100, 20
    H = np.zeros((3 * m, 6 + 3 * L))
    S = H @ np.eye(6 + 3 * L) @ H.T
    yield near("rows of S, L = 100, m = 20", len(S), 60, 0)
    yield near("rows of the report's", 6 + 3 * L, 306, 0)
    yield near("its inverse costs times as many operations", ((6 + 3 * L) / len(S)) ** 3, 130, 3)
    yield "read: 5.3.4, 'a full matrix of size 6 + 3L x 6 + 3L'"


@check(
    "E15",
    "(5.28)-(5.30)",
    "m_i, then y_i; blocks drawn for landmarks 1, 2, 3",
    "row i has its block at its landmark's column",
)
def columns() -> Findings:
    run, right = ran("gentle", "E15"), ran("gentle")
    yield at_most("(5.30) minus P h'/S, relative", _gain_off(), 1e-12)
    yield at_least("NEES/6 with the drawing's columns for other landmarks, gentle", run.ratio, 2.5)
    yield statistics(("gentle", run), ("right", right)) + "; read: m_i in (5.28), y_i in (5.29), (5.30)"


def _gain_off() -> float:
    """One landmark, updated component by component: the last update against the textbook's gain."""
    rng = np.random.default_rng(30)
    root = rng.standard_normal((12, 12))
    filter = Memory(rng.uniform(-1, 1, (1, 12)), (root @ root.T)[None], [0, 1])
    x, P, h, R, innovation = filter.x[0].copy(), filter.P[0].copy(), rng.standard_normal(9), 0.3, 0.7
    at = [*range(6), 9, 10, 11]
    before = filter.x.copy(), filter.P.copy()
    filter.one_number(*before, at, h[None, :6], h[None, 6:], np.array([innovation]), np.array([R]))
    K = P[:, at] @ h / (h @ P[np.ix_(at, at)] @ h + R)
    return float(np.abs((filter.x[0] - x) / innovation - K).max() / np.abs(K).max())


@check("E27", "appendix A", "the code of the Jacobians is lost", "H_x = [-R', (dR/da)'d], H_m = R'")
def jacobians() -> Findings:
    pose, points = _poses_and_points(27)
    by_pose = observation.by_pose(pose, points) - differences(observation.by_vectors, pose, points)
    yield at_most("H_x minus differences, 400 points", np.abs(by_pose).max(), 1e-7)


@check("E23", "(5.33)", "x composed with z", "as it says: m = t + R z, J_x = [I, F14..F36 with z for u], J_z = R")
def inverse() -> Findings:
    pose, points = _poses_and_points(23)
    there_and_back = observation.by_vectors(pose, observation.placed(pose, points)) - points
    J = observation.placed_by_pose(pose, points) - differences(observation.placed, pose, points)
    yield at_most("placed and observed again, 400 points [m]", np.abs(there_and_back).max(), 1e-13)
    yield at_most("J_x minus differences", np.abs(J).max(), 1e-7)
