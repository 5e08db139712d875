"""Wrong solutions of page report_audited."""

import numpy as np

from book.tests.wrong_solutions import wrong


def _rates(yaw, pitch, roll):
    (sp, sr), (cp, cr) = np.sin([pitch, roll]), np.cos([pitch, roll])
    return np.array([[-sp, 0, 1], [cp * sr, cr, 0], [cp * cr, -sr, 0]])


@wrong("report_audited.1", "the identity, as the report prints (E08)")
def identity(yaw, pitch, roll):
    return np.eye(3)


@wrong("report_audited.1", "forgets that the control's own rates are ordered yaw, pitch, roll")
def body_rates(yaw, pitch, roll):
    return np.linalg.inv(_rates(yaw, pitch, roll))


@wrong("report_audited.1", "body rates from angle rates, the other way round")
def inverted(yaw, pitch, roll):
    return _rates(0, 0, 0).T @ _rates(yaw, pitch, roll)


@wrong("report_audited.1", "cosine of the pitch missing in the denominator")
def without_cosine(yaw, pitch, roll):
    sr, cr, sp = np.sin(roll), np.cos(roll), np.sin(pitch)
    return np.array([[cr, sr, 0], [-sr, cr, 0], [cr * sp, sr * sp, 1]])


def _rotation(pose):
    (cy, cp, cr), (sy, sp, sr) = np.cos(pose[3:]), np.sin(pose[3:])
    Rz = np.array([[cy, -sy, 0], [sy, cy, 0], [0, 0, 1]])
    Ry = np.array([[cp, 0, sp], [0, 1, 0], [-sp, 0, cp]])
    Rx = np.array([[1, 0, 0], [0, cr, -sr], [0, sr, cr]])
    # the derivative of a turn is the turn by a quarter more, without the axis
    Dz, Dy, Dx = (np.array(m) for m in (
        [[-sy, -cy, 0], [cy, -sy, 0], [0, 0, 0]],
        [[-sp, 0, cp], [0, 0, 0], [-cp, 0, -sp]],
        [[0, 0, 0], [0, -sr, -cr], [0, cr, -sr]],
    ))  # fmt: skip
    return Rz @ Ry @ Rx, (Dz @ Ry @ Rx, Rz @ Dy @ Rx, Rz @ Ry @ Dx)


def _observed(pose, point):
    R, derivatives = _rotation(pose)
    d = point - pose[:3]
    return R.T @ d, np.column_stack([-R.T, *(D.T @ d for D in derivatives)]), R.T


@wrong("report_audited.2", "-R instead of -R' for the position")
def not_transposed(pose, point):
    z, by_pose, by_point = _observed(pose, point)
    return z, np.column_stack([-by_point.T, by_pose[:, 3:]]), by_point


@wrong("report_audited.2", "F14 to F36 of (5.20), which are derivatives of R u and not of R' d")
def of_the_motion(pose, point):
    z, by_pose, by_point = _observed(pose, point)
    _, derivatives = _rotation(pose)
    d = point - pose[:3]
    return z, np.column_stack([by_pose[:, :3], *(D @ d for D in derivatives)]), by_point


@wrong("report_audited.2", "roll before yaw in the columns")
def other_order(pose, point):
    z, by_pose, by_point = _observed(pose, point)
    return z, by_pose[:, [0, 1, 2, 5, 4, 3]], by_point


@wrong("report_audited.2", "the derivative by the point is minus that by the position: the sign is lost")
def same_sign(pose, point):
    z, by_pose, by_point = _observed(pose, point)
    return z, by_pose, -by_point


@wrong("report_audited.3", "divides each number by its own standard deviation: sees variances alone")
def by_deviations(nu, S):
    w = nu / np.sqrt(np.diagonal(S, axis1=1, axis2=2))
    return w.T @ w / len(nu)


@wrong("report_audited.3", "does not divide by the number of innovations")
def summed(nu, S):
    w = np.linalg.solve(np.linalg.cholesky(S), nu[:, :, None])[:, :, 0]
    return w.T @ w


@wrong("report_audited.3", "the diagonal alone: as NIS, number by number")
def diagonal(nu, S):
    w = np.linalg.solve(np.linalg.cholesky(S), nu[:, :, None])[:, :, 0]
    return np.diag((w**2).mean(0))


@wrong("report_audited.3", "whitens twice, by S itself")
def twice(nu, S):
    w = np.linalg.solve(S, nu[:, :, None])[:, :, 0]
    return w.T @ w / len(nu)


@wrong("report_audited.3", "the covariance about the mean: a bias is not seen")
def about_the_mean(nu, S):
    w = np.linalg.solve(np.linalg.cholesky(S), nu[:, :, None])[:, :, 0]
    away = w - w.mean(0)
    return away.T @ away / len(nu)
