"""Wrong solutions of chapter frames_and_quaternions."""

import numpy as np

from book.tests.wrong_solutions import wrong
from slamlib.geometry.pose import from_frame, to_frame
from slamlib.geometry.quaternion import conjugate, exponential, minus, plus, product, rotation


def _cross(a):
    return np.array([[0, -a[2], a[1]], [a[2], 0, -a[0]], [-a[1], a[0], 0]])


def _carried(F, G, point, turn_F=1.0, turn_G=1.0, world=False):
    """The right answer, but for signs of the turns and axes of the displacement of F."""
    C_F, C_G, found = rotation(F[3:]), rotation(G[3:]), to_frame(G, from_frame(F, point))
    shift = np.eye(3) if world else C_G.T
    by_F = np.hstack([shift, -turn_F * C_G.T @ C_F @ _cross(point)])
    return found, by_F, np.hstack([-C_G.T, turn_G * _cross(found)])


@wrong("frames_and_quaternions.2", "every sign of a turn flipped: turning the frame is taken for turning the point")
def signs(F, G, point):
    return _carried(F, G, point, turn_F=-1.0, turn_G=-1.0)


@wrong("frames_and_quaternions.2", "the sign of one turn")
def sign(F, G, point):
    return _carried(F, G, point, turn_G=-1.0)


@wrong("frames_and_quaternions.2", "the displacement of F is taken as what G sees of it")
def displacement_unturned(F, G, point):
    return _carried(F, G, point, world=True)


@wrong("frames_and_quaternions.2", "the rotation vector of F is taken in world axes")
def world_axes(F, G, point):
    found, by_F, by_G = _carried(F, G, point)
    by_F[:, 3:] = -rotation(G[3:]).T @ _cross(rotation(F[3:]) @ point)
    return found, by_F, by_G


@wrong("frames_and_quaternions.2", "the point in F stands in the bracket of G")
def bracket_of_the_other(F, G, point):
    found, by_F, by_G = _carried(F, G, point)
    by_G[:, 3:] = _cross(point)
    return found, by_F, by_G


@wrong("frames_and_quaternions.2", "F and G exchanged")
def exchanged(F, G, point):
    found, by_G, by_F = _carried(G, F, point)
    return found, by_F, by_G


@wrong("frames_and_quaternions.2", "C instead of its transpose")
def transposed(F, G, point):
    found, by_F, by_G = _carried(F, G, point)
    C = rotation(G[3:])
    return found, C @ C @ by_F, np.hstack([-C, by_G[:, 3:]])


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


@wrong("frames_and_quaternions.3", "a threshold freezes small turns, here up to 1.1 degrees")
def frozen_if_close(q0, q1, u):
    return q0.copy() if abs(q0 @ q1) > np.cos(0.01) else zero_by_zero(q0, q1, u)


@wrong("frames_and_quaternions.3", "a threshold freezes tiny turns, here up to 1e-7 rad")
def frozen_if_very_close(q0, q1, u):
    return q0.copy() if np.linalg.norm(minus(q1, q0)) < 1e-7 else plus(q0, u * minus(q1, q0))


@wrong("frames_and_quaternions.3", "0 / 0 where the orientations are the same, but not the quaternions")
def zero_by_zero_at_the_opposite(q0, q1, u):
    return q0.copy() if q0 @ q1 > 0.999999 else zero_by_zero(q0, q1, u)


@wrong("frames_and_quaternions.3", "the sine's argument is the whole turn, of which quaternions have half")
def whole_turn(q0, q1, u):
    q1 = q1 if q0 @ q1 >= 0 else -q1
    angle = np.linalg.norm(minus(q1, q0))
    if angle < 1e-9:
        return q0.copy()
    return (np.sin((1 - u) * angle) * q0 + np.sin(u * angle) * q1) / np.sin(angle)


@wrong("frames_and_quaternions.3", "the sign is never turned: the long way where the numbers point apart")
def never_turned(q0, q1, u):
    angle = np.arccos(np.clip(q0 @ q1, -1, 1))
    if min(angle, np.pi - angle) < 1e-6:
        return q0.copy()
    return (np.sin((1 - u) * angle) * q0 + np.sin(u * angle) * q1) / np.sin(angle)


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


@wrong("frames_and_quaternions.5", "the displacement's arm is added, as in an adjoint")
def adjoint_instead(pose, P):
    C = rotation(pose[3:])
    T = np.block([[np.eye(3), -_cross(pose[:3])], [np.zeros((3, 3)), C.T]])
    return T @ P @ T.T


@wrong("frames_and_quaternions.5", "T P T instead of T P T'")
def one_side(pose, P):
    T = np.block([[np.eye(3), np.zeros((3, 3))], [np.zeros((3, 3)), rotation(pose[3:]).T]])
    return T @ P @ T


@wrong("frames_and_quaternions.5", "a rotation vector is a rotation vector")
def unchanged(pose, P):
    return P.copy()
