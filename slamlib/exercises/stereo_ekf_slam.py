"""Checks of the chapter: stereo 6-D EKF-SLAM, finished."""

from typing import Any

import numpy as np

from slamlib.exercises import exercise
from slamlib.exercises.properties import Rejected, array_of, covariance, differences, holds, jacobian_matches, same
from slamlib.geometry import euler
from slamlib.manifolds import Array
from slamlib.motions.euler_composition import compose


@exercise("stereo_ekf_slam.1", "the control's angles and the robot's")
def noise_rows(candidate: Any) -> None:
    """It is the derivative of slamlib's composition at rest; upright it is the identity."""
    rng = np.random.default_rng(221)
    for i in range(8):
        angles = rng.uniform(-1, 1, 3) * np.radians([180, 70, 180]) * (i > 0)
        given = f"yaw, pitch, roll = {np.round(np.degrees(angles), 1)} degrees"
        found = array_of(candidate(*map(float, angles)), (3, 3), "B")

        def turned(control: Array, angles: Array = angles) -> Array:
            new = compose(np.concatenate([np.zeros(3), angles]), np.concatenate([np.zeros(3), control]))[3:]
            return (new - angles + np.pi) % (2 * np.pi) - np.pi

        what = "a small control turns the angles by B times its own" if i else "upright, B is the identity"
        same(found, differences(turned, np.zeros(3)), what, given=given, tolerance=1e-6)


@exercise("stereo_ekf_slam.2", "the lost appendix")
def appendix(candidate: Any) -> None:
    """The value undoes the placing of a point; both Jacobians agree with differences of the reader's own value."""
    rng = np.random.default_rng(222)
    for _ in range(6):
        pose = np.concatenate([rng.uniform(-3, 3, 3), rng.uniform(-1, 1, 3) * [3, 1.2, 3]])
        point = rng.uniform(-5, 5, 3)
        z, by_pose, by_point = _three(candidate(pose, point))
        R = euler.to_rotation(pose[:2:-1])
        same(pose[:3] + R @ z, point, "the point is where the robot sees it")

        def value(both: Array) -> Array:
            return _three(candidate(both[:6], both[6:]))[0]

        whole, at = np.column_stack([by_pose, by_point]), np.concatenate([pose, point])
        jacobian_matches(whole, value, at, "the derivatives agree with differences of your own z", tolerance=1e-6)


def _three(found: Any) -> tuple[Array, Array, Array]:
    if not isinstance(found, tuple | list) or len(found) != 3:
        raise Rejected("your function should return z, the derivative by the pose, and that by the point")
    return (
        array_of(found[0], (3,), "z"),
        array_of(found[1], (3, 6), "the derivative by the pose"),
        array_of(found[2], (3, 3), "the derivative by the point"),
    )


@exercise("stereo_ekf_slam.3", "innovations as a matrix")
def innovations(candidate: Any) -> None:
    """Its trace is the mean NIS; it is that of any other coordinates; it finds correlations that NIS does not."""
    rng = np.random.default_rng(223)
    for n, m in ((1, 3), (5, 2), (40, 3)):
        given = f"{n} innovations of {m} numbers"
        roots = rng.standard_normal((n, m, m)) + 2 * np.eye(m)
        S, nu = roots @ roots.swapaxes(1, 2), rng.standard_normal((n, m))
        found = covariance(candidate(nu, S), m, "the matrix")
        nis = np.einsum("ni,nij,nj->n", nu, np.linalg.inv(S), nu).mean()
        same(np.trace(found), nis, "its trace is the mean of NIS", given=given)
        scale = rng.uniform(0.1, 10, m)
        other = array_of(candidate(nu * scale, S * np.outer(scale, scale)), (m, m), "the matrix")
        what = "its eigenvalues do not depend on the units"
        same(np.linalg.eigvalsh(other), np.linalg.eigvalsh(found), what, given=given)
    _sees(candidate, rng)


def _sees(candidate: Any, rng: np.random.Generator) -> None:
    """Four thousand innovations of a known covariance, which the filter believes, or of which it believes the diagonal.

    Eigenvalues of the sample are within 0.15 of 1 by far (their standard deviation is about 0.03).
    """
    R = np.array([[4, 1.8, 0], [1.8, 1, 0.1], [0, 0.1, 0.5]])
    nu = rng.standard_normal((4000, 3)) @ np.linalg.cholesky(R).T
    right, wrong = (
        np.linalg.eigvalsh(array_of(candidate(nu, np.tile(C, (4000, 1, 1))), (3, 3), "the matrix"))
        for C in (R, np.diag(np.diag(R)))
    )
    what = "it is the identity if the filter is right"
    holds(np.abs(right - 1).max() < 0.15, what, f"found the eigenvalues {np.round(right, 2)}")
    what = "it is not if the filter knows the variances alone"
    holds(wrong.max() > 1.5 and wrong.min() < 0.5, what, f"found the eigenvalues {np.round(wrong, 2)}")
