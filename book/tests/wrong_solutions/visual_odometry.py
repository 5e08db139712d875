"""Wrong solutions of chapter visual_odometry."""

import numpy as np

from book.tests.wrong_solutions import wrong
from slamlib.geometry.quaternion import rotation


def _weights(d_old, d_new, f, b, sigma):
    return 1 / ((f * b * sigma) ** 2 * (d_old**-4.0 + d_new**-4.0))


@wrong("visual_odometry.1", "the plain mean of what the points say")
def plain_mean(d_old, d_new, f, b, sigma):
    weight = _weights(d_old, d_new, f, b, sigma)
    return (f * b * (1 / d_old - 1 / d_new)).mean(), weight.sum() ** -0.5


@wrong("visual_odometry.1", "the motion of the points, not of the camera")
def backwards(d_old, d_new, f, b, sigma):
    weight = _weights(d_old, d_new, f, b, sigma)
    return (weight * f * b * (1 / d_new - 1 / d_old)).sum() / weight.sum(), weight.sum() ** -0.5


@wrong("visual_odometry.1", "takes the old disparities for exact, as PnP does")
def old_exact(d_old, d_new, f, b, sigma):
    weight = 1 / ((f * b * sigma) ** 2 * d_new**-4.0)
    return (weight * f * b * (1 / d_old - 1 / d_new)).sum() / weight.sum(), weight.sum() ** -0.5


@wrong("visual_odometry.1", "returns the variance")
def variance(d_old, d_new, f, b, sigma):
    weight = _weights(d_old, d_new, f, b, sigma)
    return (weight * f * b * (1 / d_old - 1 / d_new)).sum() / weight.sum(), 1 / weight.sum()


@wrong("visual_odometry.2", "an index of -1 reads the last entry")
def last_entry(old, left, right, new):
    return np.flatnonzero(right[old] == new[left])


@wrong("visual_odometry.2", "two ways that both end nowhere are taken for a cycle")
def nowhere(old, left, right, new):
    i = np.flatnonzero((old >= 0) & (left >= 0))
    return i[right[old[i]] == new[left[i]]]


@wrong("visual_odometry.2", "asks whether the old pair is matched, and not whether the left pictures are")
def left_not_asked(old, left, right, new):
    i = np.flatnonzero(old >= 0)
    one, other = right[old[i]], new[left[i]]
    return i[(one == other) & (one >= 0)]


@wrong("visual_odometry.2", "asks only that all four matches are there")
def all_there(old, left, right, new):
    i = np.flatnonzero((old >= 0) & (left >= 0))
    return i[(right[old[i]] >= 0) & (new[left[i]] >= 0)]


@wrong("visual_odometry.2", "returns a mask")
def mask(old, left, right, new):
    return (old >= 0) & (left >= 0) & (right[old] == new[left]) & (new[left] >= 0)


@wrong("visual_odometry.3", "takes PnP's answer for the control (E20)")
def not_inverted(R, t, extrinsics):
    m, M = extrinsics[:3], rotation(extrinsics[3:])
    turn = M @ R @ M.T
    return m + M @ t - turn @ m, turn


@wrong("visual_odometry.3", "transposes the rotation and changes the sign of the vector, without turning it")
def half_inverted(R, t, extrinsics):
    m, M = extrinsics[:3], rotation(extrinsics[3:])
    turn = M @ R.T @ M.T
    return m - M @ t - turn @ m, turn


@wrong("visual_odometry.3", "forgets that the camera is not the robot")
def without_extrinsics(R, t, extrinsics):
    return -R.T @ t, R.T


@wrong("visual_odometry.3", "turns the extrinsics' axes but forgets their lever arm")
def without_lever(R, t, extrinsics):
    M = rotation(extrinsics[3:])
    return -M @ R.T @ t, M @ R.T @ M.T
