"""Wrong solutions of chapter 6."""

import numpy as np

from slamlib.geometry.quaternion import conjugate, plus, product, rotation
from slamlib.tests.wrong_solutions import wrong


def _cross(a):
    return np.array([[0, -a[2], a[1]], [a[2], 0, -a[0]], [-a[1], a[0], 0]])


@wrong("6.2", "the sign of the rotation part: turning the frame is taken for turning the point")
def sign(pose, point):
    R = rotation(pose[3:])
    return np.hstack([-R.T, -_cross(R.T @ (point - pose[:3]))])


@wrong("6.2", "the rotation vector is taken in world axes")
def world_axes(pose, point):
    R = rotation(pose[3:])
    return np.hstack([-R.T, R.T @ _cross(point - pose[:3])])


@wrong("6.2", "R instead of its transpose")
def transposed(pose, point):
    R = rotation(pose[3:])
    return np.hstack([-R, _cross(R.T @ (point - pose[:3]))])


def _long_log(q):
    norm = np.sqrt(q[1:] @ q[1:])
    return 2 * np.arctan2(norm, q[0]) / norm * q[1:]


@wrong("6.3", "the four-quadrant arctangent goes the long way when w < 0")
def long_way(q0, q1, u):
    return plus(q0, u * _long_log(product(conjugate(q0), q1)))


@wrong("6.3", "linear interpolation of the numbers, then normalised: not at constant speed")
def chord(q0, q1, u):
    q = (1 - u) * q0 + u * q1 * np.sign(q0 @ q1)
    return q / np.sqrt(q @ q)
