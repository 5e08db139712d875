"""Checks of the page: the report's filter, audited."""

import numpy as np

from slambook.exercises import Candidate, Rng, exercise
from slambook.exercises.kit import array_of, between, cases, covariance, given, holds, parts, same
from slamlib.geometry import euler
from slamlib.manifolds import Array
from slamlib.models.numerical import differences
from slamlib.motions.euler_composition import compose


@exercise("report_audited.1", "the control's angles and the robot's", seed=221)
def noise_rows(candidate: Candidate, rng: Rng) -> None:
    """It is the derivative of slamlib's composition at rest; upright it is the identity."""
    for i in cases(range(8)):
        angles = rng.uniform(-1, 1, 3) * np.radians([180, 70, 180]) * (i > 0)
        given(f"yaw, pitch, roll = {np.round(np.degrees(angles), 1)} degrees")
        found = array_of(candidate(*map(float, angles)), (3, 3), "B")

        def turned(control: Array, angles: Array = angles) -> Array:
            new = compose(np.concatenate([np.zeros(3), angles]), np.concatenate([np.zeros(3), control]))[3:]
            return np.asarray((new - angles + np.pi) % (2 * np.pi) - np.pi)

        what = "a small control turns the angles by B times its own" if i else "upright, B is the identity"
        same(found, differences(turned, np.zeros(3)), what, tolerance=1e-6)


@exercise("report_audited.2", "the lost appendix", seed=222)
def appendix(candidate: Candidate, rng: Rng) -> None:
    """The value undoes the placing of a point; both Jacobians agree with differences of the reader's own value."""
    shapes = {"z": (3,), "the derivative w.r.t. the pose": (3, 6), "the derivative w.r.t. the point": (3, 3)}
    for _ in range(6):
        pose = np.concatenate([rng.uniform(-3, 3, 3), rng.uniform(-1, 1, 3) * [3, 1.2, 3]])
        point = rng.uniform(-5, 5, 3)
        z, by_pose, by_point = parts(candidate(pose, point), shapes)
        same(pose[:3] + euler.to_rotation(pose[:2:-1]) @ z, point, "the point is where the robot sees it")
        both = np.concatenate([pose, point])
        own = differences(lambda at: parts(candidate(at[:6], at[6:]), shapes)[0], both)
        what = "the derivatives agree with differences of your own z"
        same(np.column_stack([by_pose, by_point]), own, what, tolerance=1e-6)


@exercise("report_audited.3", "innovations as a matrix", seed=223)
def innovations(candidate: Candidate, rng: Rng) -> None:
    """Its trace is the mean NIS; it is that of any other coordinates; it finds correlations that NIS does not."""
    for n, m in cases(((1, 3), (5, 2), (40, 3)), "{} innovations of {} numbers"):
        roots = rng.standard_normal((n, m, m)) + 2 * np.eye(m)
        S, nu = roots @ roots.swapaxes(1, 2), rng.standard_normal((n, m))
        found = covariance(candidate(nu, S), m, "the matrix")
        nis = np.einsum("ni,nij,nj->n", nu, np.linalg.inv(S), nu).mean()
        same(np.trace(found), nis, "its trace is the mean of NIS")
        scale = rng.uniform(0.1, 10, m)
        other = array_of(candidate(nu * scale, S * np.outer(scale, scale)), (m, m), "the matrix")
        what = "its eigenvalues do not depend on the units"
        same(np.linalg.eigvalsh(other), np.linalg.eigvalsh(found), what)
    # Innovations of a known covariance, which the filter uses, or of which it uses the diagonal. Eigenvalues
    # of a sample of four thousand are within 0.15 of 1 by far (their standard deviation is about 0.03).
    R = np.array([[4, 1.8, 0], [1.8, 1, 0.1], [0, 0.1, 0.5]])
    nu = rng.standard_normal((4000, 3)) @ np.linalg.cholesky(R).T
    right, wrong = (
        np.linalg.eigvalsh(array_of(candidate(nu, np.tile(C, (4000, 1, 1))), (3, 3), "the matrix"))
        for C in (R, np.diag(np.diag(R)))
    )
    between(right, 0.85, 1.15, "it is the identity if the filter is right")
    what = "it is not if the filter knows the variances alone"
    holds(wrong.max() > 1.5 and wrong.min() < 0.5, what, f"found the eigenvalues {np.round(wrong, 2)}")
