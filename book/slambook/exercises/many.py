"""Checks of the chapter: many sensors, many robots."""

import numpy as np
from numpy.typing import ArrayLike

from slambook.exercises import Candidate, Rng, exercise
from slambook.exercises.kit import array_of, cases, covariance, holds, parts, random_covariance, same
from slamlib.geometry.pose import Pose, from_frame, to_frame
from slamlib.geometry.quaternion import exponential, rotation
from slamlib.manifolds import Array
from slamlib.models.numerical import differences


@exercise("many.1", "the effect of robot and extrinsics on a point", seed=181)
def two_jacobians(candidate: Candidate, rng: Rng) -> None:
    """Against differences; and opposite changes of robot and extrinsics must not move the point."""
    for _ in range(3):
        r, s = (exponential(rng.uniform(-2, 2, 3)) for _ in range(2))
        p, t, q = rng.uniform(-3, 3, 3), rng.uniform(-1, 1, 3), rng.uniform(1, 5, 3)
        robot, camera, R, S = np.concatenate([p, r]), np.concatenate([t, s]), rotation(r), rotation(s)
        shapes = {"the derivative w.r.t. the robot": (3, 6), "the derivative w.r.t. the extrinsics": (3, 6)}
        by_robot, by_extrinsics = parts(candidate(R, t, S, q), shapes)
        inside = from_frame(camera, q)
        moved = differences(lambda f, camera=camera, at=inside: to_frame(Pose.plus(camera, f), at), np.zeros(6))
        same(by_extrinsics, moved, "the derivative w.r.t. the extrinsics", tolerance=1e-6)
        world = from_frame(robot, inside)
        moved = differences(lambda e, robot=robot, at=world: to_frame(Pose.plus(robot, e), at), np.zeros(6))
        same(by_robot, rotation(s).T @ moved, "the derivative w.r.t. the robot", tolerance=1e-6)
        tau, alpha = rng.standard_normal((2, 3))
        own, other = np.concatenate([-R @ tau, -alpha]), np.concatenate([tau + np.cross(alpha, t), S.T @ alpha])
        what = "opposite changes of robot and extrinsics leave the camera, and the point in it, unchanged"
        same(by_robot @ own + by_extrinsics @ other, np.zeros(3), what)


def _motion(moved: ArrayLike, turned: ArrayLike) -> Array:
    """Transform (4, 4) of a displacement [m] and a rotation vector [rad]."""
    U = np.eye(4)
    U[:3, :3], U[:3, 3] = rotation(exponential(turned)), moved
    return U


@exercise("many.2", "what a motion cannot show", seed=182)
def blind(candidate: Candidate, rng: Rng) -> None:
    """Every direction commutes with every step; orthonormal; and as many as the motion leaves."""
    ahead, up = np.array([0.3, 0.0, 0.0]), np.array([0.0, 0.0, 1.0])
    left_turn, right_turn, spot = _motion(ahead, 0.2 * up), _motion(ahead, -0.2 * up), _motion(0 * up, 0.4 * up)
    tilt = _motion(rng.standard_normal(3), rng.standard_normal(3))
    motions = (
        ("standing still", [np.eye(4)] * 3, 6),
        ("straight ahead", [_motion(ahead, 0 * up)] * 3, 4),
        ("a circle so wide that it seems straight", [_motion(ahead, 1e-5 * up)] * 4, 2),
        ("turning on the spot", [spot] * 3, 2),
        ("a figure of eight", [left_turn, right_turn], 1),
        ("up and down in the plane, then tilted", [left_turn, _motion(ahead, [0.0, 0.3, 0.1])], 0),
    )
    for name, steps, left in cases(motions, "{}"):
        for frame in (np.eye(4), tilt):  # the answer must not depend on how the robot's axes lie
            turned = np.array([frame @ U @ np.linalg.inv(frame) for U in steps])
            found = array_of(candidate(turned), (6, left), f"{name}: the directions")
            same(found.T @ found, np.eye(left), "the directions are orthonormal", tolerance=1e-7)
            for U in turned:
                for tau, alpha in zip(found[:3].T, found[3:].T, strict=True):
                    twist = np.zeros((4, 4))
                    twist[:3, :3], twist[:3, 3] = np.cross(alpha, np.eye(3)).T, tau
                    same(twist @ U, U @ twist, "each direction commutes with each step", tolerance=1e-7)


@exercise("many.3", "which way round", seed=183)
def extrinsics(candidate: Candidate, rng: Rng) -> None:
    """A point that the inertial sensor places is placed by the cameras where the given matrices say."""
    for _ in range(3):
        T_cam_imu = _motion(rng.uniform(-1, 1, 3), rng.uniform(-2, 2, 3))
        T_cn_cnm1 = _motion(rng.uniform(-1, 1, 3), rng.uniform(-1, 1, 3))
        shapes = {"the first camera's pose": (4, 4), "the second camera's pose": (4, 4)}
        first, second = parts(candidate(T_cam_imu, T_cn_cnm1), shapes)
        point = np.append(rng.uniform(-5, 5, 3), 1.0)  # in the axes of the inertial sensor
        what = "the {0} camera's pose takes what the {0} camera sees to the inertial sensor's axes"
        same(first @ T_cam_imu @ point, point, what.format("first"))
        same(second @ T_cn_cnm1 @ T_cam_imu @ point, point, what.format("second"))
        centre = T_cam_imu @ first[:, 3]
        same(centre, [0, 0, 0, 1], "the first camera's place, seen by that camera, is where the camera is")


@exercise("many.4", "fusion without double counting", seed=184)
def hear(candidate: Candidate, rng: Rng) -> None:
    """Never overconfident, whatever the correlation of own and received estimate; and never worse than before."""
    random = random_covariance(rng, 2, 0.1), random_covariance(rng, 2, 0.1)
    pairs = random, (np.array([[1.0, 0.6], [0.6, 0.5]]), np.diag([0.3, 0.8])), (np.eye(2), np.eye(2))
    for own, told in cases(pairs, "the own covariance {} and the received one {}"):
        w, claimed = parts(candidate(own, told), {"the weight": (), "the covariance": (2, 2)})
        holds(0 <= w <= 1, "the weight lies between 0 and 1", f"found {w:.4g}")
        P = covariance(claimed, 2)
        gains = [w * P @ np.linalg.inv(own), (1 - w) * P @ np.linalg.inv(told)]
        same(gains[0] + gains[1], np.eye(2), "the two opinions are averaged", tolerance=1e-6)
        G, L, M = np.hstack(gains), np.linalg.cholesky(own), np.linalg.cholesky(told)
        turns = (rotation(exponential(np.array([0, 0, a])))[:2, :2] for a in (0.5, 2.0, 4.0))
        for K in [np.eye(2), -np.eye(2), np.zeros((2, 2)), *turns]:
            C = L @ K @ M.T
            actual = G @ np.block([[own, C], [C.T, told]]) @ G.T
            least = float(np.linalg.eigvalsh(P - actual)[0])
            what = "it claims no more than is true, whatever the correlation"
            holds(least > -1e-9, what, f"one direction's variance is larger by {-least:.3g}")
        holds(np.trace(P) <= 1.001 * min(map(np.trace, (own, told))), "it is no worse than the better of the two")
        others = [np.linalg.inv(v * np.linalg.inv(own) + (1 - v) * np.linalg.inv(told)) for v in np.linspace(0, 1, 101)]
        least = min(float(np.trace(other)) for other in others)
        what = "no other weight gives a smaller trace, to a thousandth"
        holds(np.trace(P) <= 1.001 * least, what, f"found {np.trace(P):.5g}, possible {least:.5g}")
