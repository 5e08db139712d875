"""Wrong solutions of chapter depth_stereo_range."""

import numpy as np

from book.tests.wrong_solutions import wrong


def _jacobian(x, y, z, f, b):
    return z / f * np.array([[1, 0, -x / b], [0, 1, -y / b], [0, 0, -z / b]])


@wrong("depth_stereo_range.1", "takes the column and the disparity for independent")
def independent(x, y, z, f, b, sigma):
    J = _jacobian(x, y, z, f, b)
    return sigma**2 * J @ np.diag([1, 1, 2]) @ J.T


@wrong("depth_stereo_range.1", "the diagonal alone")
def diagonal(x, y, z, f, b, sigma):
    J = _jacobian(x, y, z, f, b)
    return np.diag(np.diag(sigma**2 * J @ np.array([[1, 0, 1], [0, 1, 0], [1, 0, 2]]) @ J.T))


@wrong("depth_stereo_range.1", "the disparity is as noisy as one column")
def one_column(x, y, z, f, b, sigma):
    J = _jacobian(x, y, z, f, b)
    return sigma**2 * J @ np.array([[1, 0, 1], [0, 1, 0], [1, 0, 1]]) @ J.T


@wrong("depth_stereo_range.1", "a deviation where the variance belongs")
def sigma_alone(x, y, z, f, b, sigma):
    J = _jacobian(x, y, z, f, b)
    return sigma * J @ np.array([[1, 0, 1], [0, 1, 0], [1, 0, 2]]) @ J.T


@wrong("depth_stereo_range.2", "no wrapping")
def plain(measured, expected):
    return np.asarray(measured) - expected


@wrong("depth_stereo_range.2", "one turn at most")
def one_turn(measured, expected):
    z = np.array(measured) - expected
    z[..., 1] = np.where(z[..., 1] > np.pi, z[..., 1] - 2 * np.pi, z[..., 1])
    z[..., 1] = np.where(z[..., 1] < -np.pi, z[..., 1] + 2 * np.pi, z[..., 1])
    return z


@wrong("depth_stereo_range.2", "wraps the range too")
def all_three(measured, expected):
    z = np.asarray(measured) - expected
    return z - 2 * np.pi * np.round(z / (2 * np.pi))


@wrong("depth_stereo_range.2", "wraps the pitch too")
def both_angles(measured, expected):
    z = np.asarray(measured) - expected
    return z - 2 * np.pi * np.round(z / (2 * np.pi)) * [0, 1, 1]


@wrong("depth_stereo_range.2", "wraps to [0, 2 pi)")
def positive(measured, expected):
    z = np.array(measured) - expected
    z[..., 1] = z[..., 1] % (2 * np.pi)
    return z


@wrong("depth_stereo_range.3", "takes the range for the depth, as published")
def range_for_depth(u, v, ranges, intrinsics):
    u0, v0, au, av = intrinsics
    return ranges[:, None] * np.stack([(u - u0) / au, (v - v0) / av, np.ones(len(u))], axis=-1)


@wrong("depth_stereo_range.3", "columns and rows exchanged in the length of the ray")
def exchanged(u, v, ranges, intrinsics):
    u0, v0, au, av = intrinsics
    length = np.sqrt(1 + ((v - u0) / au) ** 2 + ((u - v0) / av) ** 2)
    return (ranges / length)[:, None] * np.stack([(u - u0) / au, (v - v0) / av, np.ones(len(u))], axis=-1)


@wrong("depth_stereo_range.3", "depth by the horizontal angle alone")
def horizontal(u, v, ranges, intrinsics):
    u0, v0, au, av = intrinsics
    a, b = (u - u0) / au, (v - v0) / av
    return (ranges / np.sqrt(1 + a**2))[:, None] * np.stack([a, b, np.ones(len(u))], axis=-1)
