"""Wrong solutions of chapter lines."""

import numpy as np

from book.tests.wrong_solutions import wrong


@wrong("lines.1", "the sign of the moment")
def opposite_moment(first, second):
    a, b = first[:3], second[:3]
    return np.concatenate([second[3] * a - first[3] * b, np.cross(a, b)])


@wrong("lines.1", "the offsets exchanged")
def exchanged(first, second):
    a, b = first[:3], second[:3]
    return np.concatenate([second[3] * b - first[3] * a, np.cross(a, b)])


@wrong("lines.1", "through a point, so that parallel planes give noise or nothing")
def through_a_point(first, second):
    v = np.cross(first[:3], second[:3])
    p = np.linalg.lstsq(np.stack([first[:3], second[:3]]), -np.array([first[3], second[3]]), rcond=None)[0]
    return np.concatenate([np.cross(p, v), v])


@wrong("lines.2", "moves the anchor and forgets the moment")
def only_the_anchor(landmark, P, anchor):
    J = np.diag([0.0] * 3 + [1.0] * 6)
    return np.concatenate([anchor, landmark[3:]]), J @ P @ J.T


def _moved(landmark, anchor):
    x, n, v = landmark[:3], landmark[3:6], landmark[6:]
    return np.concatenate([anchor, n + np.cross(x - anchor, v), v])


@wrong("lines.2", "moves the mean and leaves the covariance")
def covariance_left(landmark, P, anchor):
    return _moved(landmark, anchor), P


@wrong("lines.2", "drops the old anchor's uncertainty")
def without_the_anchors(landmark, P, anchor):
    d = landmark[:3] - anchor
    J = np.diag([0.0] * 3 + [1.0] * 6)
    J[3:6, 6:] = [[0, -d[2], d[1]], [d[2], 0, -d[0]], [-d[1], d[0], 0]]
    return _moved(landmark, anchor), J @ P @ J.T


@wrong("lines.2", "the anchor's Jacobian with the wrong sign")
def wrong_sign(landmark, P, anchor):
    d, v = landmark[:3] - anchor, landmark[6:]
    J = np.diag([0.0] * 3 + [1.0] * 6)
    J[3:6, 6:] = [[0, -d[2], d[1]], [d[2], 0, -d[0]], [-d[1], d[0], 0]]
    J[3:6, :3] = [[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]]
    return _moved(landmark, anchor), J @ P @ J.T


@wrong("lines.3", "as published: the focal lengths exchanged")
def exchanged_focal_lengths(intrinsics, n):
    u, v, fu, fv = intrinsics
    return np.array([fu * n[0], fv * n[1], fu * fv * n[2] - fv * u * n[0] - fu * v * n[1]])


@wrong("lines.3", "the camera matrix itself, as for a point")
def as_a_point(intrinsics, n):
    u, v, fu, fv = intrinsics
    return np.array([[fu, 0, u], [0, fv, v], [0, 0, 1]]) @ n


@wrong("lines.3", "the centre is that of an image of 640 by 480 pixels")
def centre_of_the_image(intrinsics, n):
    _, _, fu, fv = intrinsics
    return np.array([fv * n[0], fu * n[1], fu * fv * n[2] - 320 * fv * n[0] - 240 * fu * n[1]])


@wrong("lines.3", "K_L for a unit focal length")
def unit_length(intrinsics, n):
    u, v, fu, fv = intrinsics
    return np.array([n[0] / fu, n[1] / fv, n[2] - u * n[0] - v * n[1]])


@wrong("lines.1", "the direction reversed, the moment not")
def direction_reversed(first, second):
    a, b = first[:3], second[:3]
    return np.concatenate([first[3] * b - second[3] * a, np.cross(b, a)])


@wrong("lines.1", "a sum for a difference")
def moments_added(first, second):
    a, b = first[:3], second[:3]
    return np.concatenate([first[3] * b + second[3] * a, np.cross(a, b)])


@wrong("lines.1", "divided by the length of v, also where it is zero")
def unit_direction(first, second):
    a, b = first[:3], second[:3]
    with np.errstate(all="ignore"):
        return np.concatenate([first[3] * b - second[3] * a, np.cross(a, b)]) / np.linalg.norm(np.cross(a, b))


@wrong("lines.1", "v of unit length, and n as it was")
def unit_direction_only(first, second):
    a, b = first[:3], second[:3]
    v = np.cross(a, b)
    return np.concatenate([first[3] * b - second[3] * a, v / max(np.linalg.norm(v), 1e-12)])


@wrong("lines.1", "nothing for parallel planes")
def nothing_when_parallel(first, second):
    a, b = first[:3], second[:3]
    v = np.cross(a, b)
    return np.concatenate([first[3] * b - second[3] * a, v]) * (np.linalg.norm(v) > 1e-9)


def _by_landmark(landmark, anchor):
    d, v = landmark[:3] - anchor, landmark[6:]
    J = np.diag([0.0] * 3 + [1.0] * 6)
    J[3:6, 6:] = [[0, -d[2], d[1]], [d[2], 0, -d[0]], [-d[1], d[0], 0]]
    J[3:6, :3] = [[0, v[2], -v[1]], [-v[2], 0, v[0]], [v[1], -v[0], 0]]
    return J


@wrong("lines.2", "the moment moved the wrong way")
def moment_the_wrong_way(landmark, P, anchor):
    J, moved = _by_landmark(landmark, anchor), _moved(landmark, anchor)
    moved[3:6] = 2 * landmark[3:6] - moved[3:6]
    return moved, J @ P @ J.T


@wrong("lines.2", "the new anchor as uncertain as the old one")
def anchor_still_uncertain(landmark, P, anchor):
    J = _by_landmark(landmark, anchor)
    J[:3, :3] = np.eye(3)
    return _moved(landmark, anchor), J @ P @ J.T


@wrong("lines.2", "the direction's part with the wrong sign")
def direction_wrong_sign(landmark, P, anchor):
    J = _by_landmark(landmark, anchor)
    J[3:6, 6:] *= -1
    return _moved(landmark, anchor), J @ P @ J.T


@wrong("lines.2", "without the direction's part")
def without_direction(landmark, P, anchor):
    J = _by_landmark(landmark, anchor)
    J[3:6, 6:] = 0
    return _moved(landmark, anchor), J @ P @ J.T


@wrong("lines.2", "without the correlation of moment and direction")
def uncorrelated(landmark, P, anchor):
    J = _by_landmark(landmark, anchor)
    found = J @ P @ J.T
    found[3:6, 6:] = found[6:, 3:6] = 0
    return _moved(landmark, anchor), found


@wrong("lines.2", "the Jacobian transposed")
def transposed(landmark, P, anchor):
    J = _by_landmark(landmark, anchor)
    return _moved(landmark, anchor), J.T @ P @ J


@wrong("lines.3", "the transposed camera matrix")
def transposed_matrix(intrinsics, n):
    u, v, fu, fv = intrinsics
    return np.array([[fu, 0, u], [0, fv, v], [0, 0, 1]]).T @ n


@wrong("lines.3", "the inverse, not transposed")
def inverse_matrix(intrinsics, n):
    u, v, fu, fv = intrinsics
    return np.linalg.inv([[fu, 0, u], [0, fv, v], [0, 0, 1]]) @ n


@wrong("lines.3", "the principal point with the wrong sign")
def wrong_sign_of_centre(intrinsics, n):
    u, v, fu, fv = intrinsics
    return np.array([fv * n[0], fu * n[1], fu * fv * n[2] + fv * u * n[0] + fu * v * n[1]])


@wrong("lines.3", "the focal lengths exchanged in the third number only")
def exchanged_in_the_third(intrinsics, n):
    u, v, fu, fv = intrinsics
    return np.array([fv * n[0], fu * n[1], fu * fv * n[2] - fu * u * n[0] - fv * v * n[1]])


@wrong("lines.3", "one focal length for both, their mean")
def mean_focal_length(intrinsics, n):
    u, v, fu, fv = intrinsics
    return np.array([n[0], n[1], (fu + fv) / 2 * n[2] - u * n[0] - v * n[1]])
