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


def _along(a, b, r, s):
    length = np.linalg.norm(b - a)
    ahead = (b - a) / length
    return length, ahead, np.array([-ahead[1], ahead[0]]), (length**2 + r**2 - s**2) / (2 * length)


@wrong("depth_stereo_range.5", "the right one first")
def right_first(a, b, r, s):
    _, ahead, left, x = _along(a, b, r, s)
    return a + x * ahead + np.sqrt(r**2 - x**2) * np.array([-left, left])


@wrong("depth_stereo_range.5", "in the axes of the way, not of the map")
def own_axes(a, b, r, s):
    _, _, _, x = _along(a, b, r, s)
    y = np.sqrt(r**2 - x**2)
    return a + np.array([[x, y], [x, -y]])


@wrong("depth_stereo_range.5", "the beacon is abeam of the middle, as if the ranges were equal")
def middle(a, b, r, s):
    length, ahead, left, _ = _along(a, b, r, s)
    y = np.sqrt(abs(r**2 - length**2 / 4))
    return a + length / 2 * ahead + y * np.array([left, -left])


@wrong("depth_stereo_range.5", "the ranges exchanged")
def ranges_exchanged(a, b, r, s):
    _, ahead, left, x = _along(a, b, s, r)
    return a + x * ahead + np.sqrt(abs(s**2 - x**2)) * np.array([left, -left])


@wrong("depth_stereo_range.1", "the needle points at the left camera")
def at_the_left(x, y, z, f, b, sigma):
    J = np.array([[1, 0, x / z], [0, 1, y / z], [0, 0, 1]])
    return sigma**2 * J @ np.diag([(z / f) ** 2, (z / f) ** 2, 2 * (z * z / f / b) ** 2]) @ J.T


@wrong("depth_stereo_range.1", "the disparity as right less left, the Jacobian as left less right")
def right_less_left(x, y, z, f, b, sigma):
    J = _jacobian(x, y, z, f, b)
    return sigma**2 * J @ np.array([[1, 0, -1], [0, 1, 0], [-1, 0, 2]]) @ J.T


@wrong("depth_stereo_range.1", "the Jacobian transposed")
def transposed(x, y, z, f, b, sigma):
    J = _jacobian(x, y, z, f, b)
    return sigma**2 * J.T @ np.array([[1, 0, 1], [0, 1, 0], [1, 0, 2]]) @ J


def _short(angle):
    return (angle + np.pi) % (2 * np.pi) - np.pi


@wrong("depth_stereo_range.2", "the second row of a batch, not its second column")
def second_row(measured, expected):
    z = np.array(measured) - expected
    z[1] = _short(z[1])
    return z


@wrong("depth_stereo_range.2", "the arcsine of the sine")
def by_the_sine(measured, expected):
    z = np.array(measured) - expected
    z[..., 1] = np.arcsin(np.sin(z[..., 1]))
    return z


@wrong("depth_stereo_range.2", "wraps both before it subtracts")
def before(measured, expected):
    z, e = np.array(measured), np.array(expected)
    z[..., 1], e[..., 1] = _short(z[..., 1]), _short(e[..., 1])
    return z - e


@wrong("depth_stereo_range.2", "expected less measured")
def the_other_way(measured, expected):
    z = np.array(expected) - measured
    z[..., 1] = _short(z[..., 1])
    return z


def _ray(u, v, intrinsics):
    u0, v0, au, av = intrinsics
    return np.stack([(u - u0) / au, (v - v0) / av, np.ones(len(u))], axis=-1)


@wrong("depth_stereo_range.3", "one focal length for both")
def one_focal_length(u, v, ranges, intrinsics):
    u0, v0, au, _ = intrinsics
    ray = _ray(u, v, (u0, v0, au, au))
    return ranges[:, None] * ray / np.linalg.norm(ray, axis=1, keepdims=True)


@wrong("depth_stereo_range.3", "the length of all rays together")
def all_rays(u, v, ranges, intrinsics):
    ray = _ray(u, v, intrinsics)
    return ranges[:, None] * ray / np.linalg.norm(ray)


@wrong("depth_stereo_range.3", "times the length of the ray")
def times_the_length(u, v, ranges, intrinsics):
    ray = _ray(u, v, intrinsics)
    return ranges[:, None] * ray * np.linalg.norm(ray, axis=1, keepdims=True)


@wrong("depth_stereo_range.3", "the squared length, without its root")
def squared_length(u, v, ranges, intrinsics):
    ray = _ray(u, v, intrinsics)
    return ranges[:, None] * ray / (ray**2).sum(1, keepdims=True)


@wrong("depth_stereo_range.3", "columns and rows exchanged in the point")
def exchanged_in_the_point(u, v, ranges, intrinsics):
    ray = _ray(u, v, intrinsics)[:, [1, 0, 2]]
    return ranges[:, None] * ray / np.linalg.norm(ray, axis=1, keepdims=True)


@wrong("depth_stereo_range.5", "the beacon is never behind a")
def never_behind(a, b, r, s):
    _, ahead, left, x = _along(a, b, r, s)
    return a + abs(x) * ahead + np.sqrt(r**2 - x**2) * np.array([left, -left])


@wrong("depth_stereo_range.5", "the upper one first")
def upper_first(a, b, r, s):
    _, ahead, left, x = _along(a, b, r, s)
    found = a + x * ahead + np.sqrt(r**2 - x**2) * np.array([left, -left])
    return found[np.argsort(-found[:, 1])]


@wrong("depth_stereo_range.5", "as seen from a")
def from_a(a, b, r, s):
    _, ahead, left, x = _along(a, b, r, s)
    return x * ahead + np.sqrt(r**2 - x**2) * np.array([left, -left])


@wrong("depth_stereo_range.5", "the same place twice")
def twice(a, b, r, s):
    _, ahead, left, x = _along(a, b, r, s)
    return a + x * ahead + np.sqrt(r**2 - x**2) * np.array([left, left])


@wrong("depth_stereo_range.5", "not divided by the length of the way")
def undivided(a, b, r, s):
    length, ahead, left, x = _along(a, b, r, s)
    x *= length
    return a + x * ahead + np.sqrt(abs(r**2 - x**2)) * np.array([left, -left])
