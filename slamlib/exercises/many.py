"""Checks of the chapter: many sensors, many robots."""

from functools import partial
from typing import Any

import numpy as np

from slamlib.exercises import exercise
from slamlib.exercises.properties import array_of, covariance, holds, jacobian_matches, pair, same
from slamlib.manifolds import Array


def _cross(v: Array) -> Array:
    x, y, z = v
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def _turn(v: Any) -> Array:
    """Rotation matrix (3, 3) of a rotation vector [rad]."""
    v = np.asarray(v, dtype=float)
    angle = float(np.linalg.norm(v))
    if angle == 0:
        return np.eye(3)
    K = _cross(v / angle)
    turned: Array = np.eye(3) + np.sin(angle) * K + (1 - np.cos(angle)) * K @ K
    return turned


def _motion(moved: Any, turned: Any) -> Array:
    U = np.eye(4)
    U[:3, :3], U[:3, 3] = _turn(turned), moved
    return U


def _seen(R: Array, S: Array, p: Array, t: Array, world: Array, e: Array, f: Array) -> Array:
    """A point of the world in the camera, of a robot (p, R) off by e and a extrinsics (t, S) off by f."""
    robot, extrinsics = R @ _turn(e[3:]), S @ _turn(f[3:])
    inside: Array = extrinsics.T @ (robot.T @ (world - p - e[:3]) - t - f[:3])
    return inside


@exercise("many.1", "what robot and mount do to a point")
def two_jacobians(candidate: Any) -> None:
    """Against differences; and what robot and mount can trade must leave the point where it is."""
    rng, zero = np.random.default_rng(181), np.zeros(6)
    for _ in range(3):
        R, S = _turn(rng.uniform(-2, 2, 3)), _turn(rng.uniform(-2, 2, 3))
        p, t, q = rng.uniform(-3, 3, 3), rng.uniform(-1, 1, 3), rng.uniform(1, 5, 3)
        by_robot, by_mount = pair(candidate(R, t, S, q), "two arrays: the derivatives by the robot and by the mount")
        by_robot, by_mount = array_of(by_robot, (3, 6), "by the robot"), array_of(by_mount, (3, 6), "by the mount")

        moved = partial(_seen, R, S, p, t, p + R @ (t + S @ q))
        jacobian_matches(by_mount, partial(moved, zero), zero, "the derivative by the mount")
        jacobian_matches(by_robot, partial(moved, f=zero), zero, "the derivative by the robot")
        tau, alpha = rng.standard_normal((2, 3))
        robot, extrinsics = np.concatenate([-R @ tau, -alpha]), np.concatenate([tau + np.cross(alpha, t), S.T @ alpha])
        what = "a robot and a mount that move against each other leave the camera, and the point in it, in place"
        same(by_robot @ robot + by_mount @ extrinsics, np.zeros(3), what)


@exercise("many.2", "what a motion cannot show")
def blind(candidate: Any) -> None:
    """Every direction commutes with every step; orthonormal; and as many as the motion leaves."""
    rng = np.random.default_rng(182)
    ahead, up = np.array([0.3, 0.0, 0.0]), np.array([0.0, 0.0, 1.0])
    tilt = _motion(rng.standard_normal(3), rng.standard_normal(3))
    for name, steps, left in (
        ("standing still", [np.eye(4)] * 3, 6),
        ("straight ahead", [_motion(ahead, 0 * up)] * 3, 4),
        ("a circle", [_motion(ahead, 0.2 * up)] * 4, 2),
        ("turning on the spot", [_motion(0 * up, 0.4 * up)] * 3, 2),
        ("a figure of eight", [_motion(ahead, 0.2 * up), _motion(ahead, -0.2 * up)], 1),
        ("up and down in the plane, then tilted", [_motion(ahead, 0.2 * up), _motion(ahead, [0.0, 0.3, 0.1])], 0),
    ):
        for frame in (np.eye(4), tilt):  # the answer must not depend on how the robot's axes lie
            motions = np.array([frame @ U @ np.linalg.inv(frame) for U in steps])
            found = array_of(candidate(motions), (6, left), f"{name}: the directions")
            same(found.T @ found, np.eye(left), "the directions are orthonormal", given=name, tolerance=1e-7)
            for U in motions:
                for tau, alpha in zip(found[:3].T, found[3:].T, strict=True):
                    twist = np.zeros((4, 4))
                    twist[:3, :3], twist[:3, 3] = _cross(alpha), tau
                    same(twist @ U, U @ twist, "each direction commutes with each step", given=name, tolerance=1e-7)


@exercise("many.3", "which way round")
def extrinsics(candidate: Any) -> None:
    """A point that the inertial sensor places is placed by the cameras where the given matrices say."""
    rng = np.random.default_rng(183)
    for _ in range(3):
        T_cam_imu = _motion(rng.uniform(-1, 1, 3), rng.uniform(-2, 2, 3))
        T_cn_cnm1 = _motion(rng.uniform(-1, 1, 3), rng.uniform(-1, 1, 3))
        first, second = pair(candidate(T_cam_imu, T_cn_cnm1), "two arrays: the poses of the two cameras")
        first, second = array_of(first, (4, 4), "the first pose"), array_of(second, (4, 4), "the second pose")
        point = np.append(rng.uniform(-5, 5, 3), 1.0)  # in the axes of the inertial sensor
        what = "the first camera's pose takes what the first camera sees to the inertial sensor's axes"
        same(first @ (T_cam_imu @ point), point, what)
        what = "the second camera's pose takes what the second camera sees to the inertial sensor's axes"
        same(second @ (T_cn_cnm1 @ T_cam_imu @ point), point, what)
        centre = T_cam_imu @ first[:, 3]
        same(centre, [0, 0, 0, 1], "the first camera's place, seen by that camera, is where the camera is")


@exercise("many.4", "hearing without believing twice")
def hear(candidate: Any) -> None:
    """Never too sure, whatever the correlation of what was known and what was told; and never worse than before."""
    rng = np.random.default_rng(184)
    for own, told in ((_random(rng), _random(rng)), (np.diag([1.0, 0.1]), np.diag([0.1, 1.0])), (np.eye(2),) * 2):
        given = f"own variances {np.diag(own).round(3).tolist()}, told {np.diag(told).round(3).tolist()}"
        weight, claimed = pair(candidate(own, told), "a weight and a covariance")
        w = float(array_of(weight, (), "the weight"))
        holds(0 <= w <= 1, "the weight lies between 0 and 1", f"found {w:.4g} for {given}")
        P = covariance(claimed, 2, "the covariance")
        gains = [w * P @ np.linalg.inv(own), (1 - w) * P @ np.linalg.inv(told)]
        same(gains[0] + gains[1], np.eye(2), "the two opinions are averaged", given=given, tolerance=1e-6)
        G, L, M = np.hstack(gains), np.linalg.cholesky(own), np.linalg.cholesky(told)
        for K in [np.eye(2), -np.eye(2), np.zeros((2, 2)), *(_turn([0, 0, a])[:2, :2] for a in (0.5, 2, 4))]:
            C = L @ K @ M.T
            actual = G @ np.block([[own, C], [C.T, told]]) @ G.T
            least = float(np.linalg.eigvalsh(P - actual)[0])
            what = "it claims no more than is true, whatever the correlation"
            holds(least > -1e-9, what, f"one direction's variance is larger by {-least:.3g} for {given}")
        best = min(np.trace(own), np.trace(told))
        holds(np.trace(P) <= best * (1 + 1e-6), "it is no worse than the better of the two", f"not for {given}")
        others = [np.linalg.inv(v * np.linalg.inv(own) + (1 - v) * np.linalg.inv(told)) for v in np.linspace(0, 1, 101)]
        least = min(float(np.trace(other)) for other in others)
        what = "no other weight gives a smaller trace, to a thousandth"
        holds(np.trace(P) <= 1.001 * least, what, f"found {np.trace(P):.5g}, possible {least:.5g} for {given}")


def _random(rng: np.random.Generator) -> Array:
    A = rng.standard_normal((2, 2))
    return array_of(A @ A.T + 0.1 * np.eye(2), (2, 2), "P")
