"""Wrong solutions of chapter many."""

import numpy as np

from book.tests.wrong_solutions import wrong


def _cross(v):
    x, y, z = v
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])


@wrong("many.1", "forgets the lever arm: a robot that turns also carries its camera")
def no_lever(R, t, S, q):
    robot = np.hstack([-(R @ S).T, S.T @ _cross(S @ q)])
    return robot, np.hstack([-S.T, _cross(q)])


@wrong("many.1", "takes the extrinsics' displacement in the camera's axes")
def in_camera_axes(R, t, S, q):
    robot = np.hstack([-(R @ S).T, S.T @ _cross(t + S @ q)])
    return robot, np.hstack([-np.eye(3), _cross(q)])


@wrong("many.1", "the extrinsics turn about the robot's axes, not their own")
def outer_turn(R, t, S, q):
    robot = np.hstack([-(R @ S).T, S.T @ _cross(t + S @ q)])
    return robot, np.hstack([-S.T, S.T @ _cross(S @ q)])


@wrong("many.1", "moves the point instead of the camera: the sign")
def sign(R, t, S, q):
    robot, extrinsics = in_camera_axes(R, t, S, q)
    return -robot, -np.hstack([-S.T, extrinsics[:, 3:]])


def _null(rows, least=1e-9, relative=False):
    values, vectors = np.linalg.svd(rows)[1:]
    return vectors[np.sum(values > least * (values[0] if relative else 1.0)) :].T


def _rows(motions, sign=1.0, coupled=True):
    parts = []
    for U in motions:
        R, u = U[:3, :3], U[:3, 3]
        parts.append(np.hstack([R - np.eye(3), sign * coupled * _cross(u)]))
        parts.append(np.hstack([np.zeros((3, 3)), R - np.eye(3)]))
    return np.concatenate(parts)


wrong("many.2", "rotation and translation are looked at separately")(lambda U: _null(_rows(U, coupled=False)))
wrong("many.2", "the sign of the coupling is wrong")(lambda U: _null(_rows(U, sign=-1.0)))
wrong("many.2", "the first step is as good as all")(lambda U: _null(_rows(U[:1])))
wrong("many.2", "one step hides what the other hides: adds them up")(lambda U: _null(sum(_rows([step]) for step in U)))
wrong("many.2", "a threshold for which a wide circle is straight")(lambda U: _null(_rows(U), 1e-3))
wrong("many.2", "a threshold relative to what rounding leaves")(lambda U: _null(_rows(U), relative=True))


@wrong("many.3", "takes the file's matrices for poses, as in okvis 38")
def as_they_are(T_cam_imu, T_cn_cnm1):
    return T_cam_imu, T_cn_cnm1 @ T_cam_imu


@wrong("many.3", "inverts each, and multiplies in the old order")
def old_order(T_cam_imu, T_cn_cnm1):
    first = np.linalg.inv(T_cam_imu)
    return first, np.linalg.inv(T_cn_cnm1) @ first


@wrong("many.3", "inverts the first only: the other is said to be relative")
def first_only(T_cam_imu, T_cn_cnm1):
    first = np.linalg.inv(T_cam_imu)
    return first, first @ T_cn_cnm1


@wrong("many.3", "transposes the rotation and keeps the translation")
def half(T_cam_imu, T_cn_cnm1):
    def turned(T):
        out = T.copy()
        out[:3, :3] = T[:3, :3].T
        return out

    return turned(T_cam_imu), turned(T_cam_imu) @ turned(T_cn_cnm1)


@wrong("many.4", "adds the information, as if the two were independent")
def independent(own, told):
    return 0.5, np.linalg.inv(np.linalg.inv(own) + np.linalg.inv(told))


@wrong("many.4", "the plain average of the two covariances, halved once")
def mean(own, told):
    return 0.5, (own + told) / 4


@wrong("many.4", "always half and half")
def half_and_half(own, told):
    return 0.5, np.linalg.inv((np.linalg.inv(own) + np.linalg.inv(told)) / 2)


@wrong("many.4", "listens to the better one only")
def better_one(own, told):
    return (1.0, own) if np.trace(own) < np.trace(told) else (0.0, told)


def _smallest(own, told, size):
    A, B = np.linalg.inv(own), np.linalg.inv(told)
    w = min(np.linspace(0, 1, 1001), key=lambda v: size(np.linalg.inv(v * A + (1 - v) * B)))
    return w, np.linalg.inv(w * A + (1 - w) * B)


for size, why in (
    (np.sum, "the sum of all entries for the trace"),
    (np.linalg.det, "the smallest determinant instead of the smallest trace"),
    (lambda P: np.linalg.eigvalsh(P)[-1], "the smallest of the largest eigenvalues"),
):
    wrong("many.4", why)(lambda own, told, size=size: _smallest(own, told, size))
