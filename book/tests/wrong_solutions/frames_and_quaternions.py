"""Wrong solutions of chapter frames_and_quaternions."""

import numpy as np

from book.tests.wrong_solutions import wrong
from slamlib.geometry.pose import to_frame
from slamlib.geometry.quaternion import conjugate, exponential, minus, plus, product, rotation


def _cross(a):
    return np.array([[0, -a[2], a[1]], [a[2], 0, -a[0]], [-a[1], a[0], 0]])


@wrong("frames_and_quaternions.2", "the sign of the rotation part: turning the frame is taken for turning the point")
def sign(pose, point):
    return np.hstack([-rotation(pose[3:]).T, -_cross(to_frame(pose, point))])


@wrong("frames_and_quaternions.2", "the rotation vector is taken in world axes")
def world_axes(pose, point):
    return rotation(pose[3:]).T @ np.hstack([-np.eye(3), _cross(point - pose[:3])])


@wrong("frames_and_quaternions.2", "R instead of its transpose")
def transposed(pose, point):
    return np.hstack([-rotation(pose[3:]), _cross(to_frame(pose, point))])


@wrong("frames_and_quaternions.3", "the four-quadrant arctangent goes the long way when w < 0")
def long_way(q0, q1, u):
    w, *vec = product(conjugate(q0), q1)
    norm = np.linalg.norm(vec)
    return plus(q0, u * 2 * np.arctan2(norm, w) / norm * np.array(vec))


@wrong("frames_and_quaternions.3", "linear interpolation of the numbers, then normalised: not at constant speed")
def chord(q0, q1, u):
    q = (1 - u) * q0 + u * q1 * np.sign(q0 @ q1)
    return q / np.sqrt(q @ q)


@wrong("frames_and_quaternions.3", "the rotation vector, which is in the first frame's axes, is applied in the world's")
def in_world_axes(q0, q1, u):
    return product(exponential(u * minus(q1, q0)), q0)


@wrong("frames_and_quaternions.3", "the textbook's quotient of sines: 0 / 0 where the orientations are the same")
def zero_by_zero(q0, q1, u):
    q1 = q1 * np.sign(q0 @ q1)
    angle = np.arccos(min(q0 @ q1, 1.0))
    with np.errstate(invalid="ignore"):
        return (np.sin((1 - u) * angle) * q0 + np.sin(u * angle) * q1) / np.sin(angle)


@wrong("frames_and_quaternions.3", "linear where the two are close: not at constant speed")
def chord_if_close(q0, q1, u):
    return chord(q0, q1, u) if abs(q0 @ q1) > 0.95 else zero_by_zero(q0, q1, u)


@wrong("frames_and_quaternions.3", "linear where the two are close, and not normalised")
def not_unit_if_close(q0, q1, u):
    return (1 - u) * q0 + u * q1 * np.sign(q0 @ q1) if abs(q0 @ q1) > 0.9995 else zero_by_zero(q0, q1, u)


@wrong("frames_and_quaternions.3", "0 / 0 where the orientations are the same, but not the quaternions")
def zero_by_zero_at_the_opposite(q0, q1, u):
    return q0.copy() if q0 @ q1 > 0.999999 else zero_by_zero(q0, q1, u)


for why, angle in {
    "the error's factor one half is forgotten": lambda share, distance: share,
    "the error is taken as a share of the distance, not of the motion": lambda share, distance: np.sqrt(2 * share),
    "a far point moves more, so it is taken to allow less": lambda share, distance: 2 * share / distance,
    "in degrees": lambda share, distance: np.degrees(2 * share),
}.items():
    wrong("frames_and_quaternions.4", why)(angle)


@wrong("frames_and_quaternions.5", "R instead of its transpose")
def into_the_world(pose, P):
    T = np.block([[np.eye(3), np.zeros((3, 3))], [np.zeros((3, 3)), rotation(pose[3:])]])
    return T @ P @ T.T


@wrong("frames_and_quaternions.5", "only the rotation's own block is turned, its correlation with the position is not")
def own_block_only(pose, P):
    R, P = rotation(pose[3:]), P.copy()
    P[3:, 3:] = R.T @ P[3:, 3:] @ R
    P[:3, 3:] = P[3:, :3] = 0
    return P


@wrong("frames_and_quaternions.5", "the position is turned as well, but its axes are the same in both conventions")
def both_turned(pose, P):
    T = np.kron(np.eye(2), rotation(pose[3:]).T)
    return T @ P @ T.T


@wrong("frames_and_quaternions.5", "a rotation vector is a rotation vector")
def unchanged(pose, P):
    return P.copy()
