"""Checks of the chapter: motion models."""

from functools import partial
from typing import Any

import numpy as np

from slamlib.data.records import World
from slamlib.data.setup import Rig, RobotSetup, SensorSetup
from slamlib.exercises import exercise
from slamlib.exercises.properties import array_of, covariance, differences, holds, pair, same
from slamlib.geometry.pose import Pose
from slamlib.geometry.quaternion import exponential, rotation
from slamlib.manifolds import Array
from slamlib.motions import Motion
from slamlib.motions.odometry import step
from slamlib.simulation import simulate

RETURNS = "a mean and a covariance"


@exercise("motion_models.2", "driving an arc")
def arc(candidate: Any) -> None:
    """Mean against fine integration, covariance against differences of the candidate's own mean; smooth at zero."""
    rng = np.random.default_rng(72)
    P, U = np.diag([0.2, 0.1, 0.05]), np.diag([0.03, 0.02])
    for turn in (0.0, 1e-9, 1e-4, 0.3, -1.2, 3.0):
        x, u = rng.standard_normal(3), np.array([1.5, turn])
        mean, found = pair(candidate(x, P, u, U), RETURNS)
        headings = x[2] + turn * (np.arange(20000) + 0.5) / 20000
        there = x[:2] + u[0] * np.array([np.cos(headings).mean(), np.sin(headings).mean()])
        same(array_of(mean, (3,), "the mean")[:2], there, "ends where fine steps along the circle end", tolerance=1e-7)
        same(np.asarray(mean)[2], x[2] + turn, "turns by the turn")
        covariance(found, 3, "the covariance")
        J = differences(lambda both: pair(candidate(both[:3], P, both[3:], U), RETURNS)[0], np.concatenate([x, u]))
        F, G = J[:, :3], J[:, 3:]
        same(found, F @ P @ F.T + G @ U @ G.T, "the covariance moves with the mean's own Jacobians", tolerance=1e-6)


@exercise("motion_models.3", "propagating a covariance")
def propagate(candidate: Any) -> None:
    """Heading error becomes sideways position error; and the covariance of samples agrees."""
    F = np.array([[1.0, 0, 0], [0, 1, 2], [0, 0, 1]])  # drove two metres along x
    found = covariance(candidate(F, np.diag([0, 0, 0.01]), np.zeros((3, 3))), 3, "the covariance")
    holds(
        found[1, 1] > 0.03, "an uncertain heading makes the position uncertain sideways", f"found {found[1, 1]:.4g} m^2"
    )
    rng = np.random.default_rng(73)
    for _ in range(3):
        F, root = rng.standard_normal((3, 3)), rng.standard_normal((3, 3))
        Q = np.diag(rng.uniform(0.1, 1, 3))
        samples = rng.standard_normal((20000, 3)) @ root.T @ F.T + rng.standard_normal((20000, 3)) @ np.sqrt(Q)
        found = covariance(candidate(F, root @ root.T, Q), 3, "the covariance")
        scale = np.abs(found).max()
        same(found / scale, np.cov(samples.T) / scale, "agrees with the spread of 20000 samples", tolerance=0.06)


@exercise("motion_models.5", "driving straight ahead with an uncertain heading")
def straight_drive(candidate: Any) -> None:
    """Against the book's own prediction, step by step in six dimensions."""
    pick = np.ix_([1, 5], [1, 5])
    for length, sigma, steps in ((0.5, 0.02, 1), (0.5, 0.02, 2), (2.0, 0.01, 7), (0.25, 0.03, 40)):
        pose, P, U = np.array([0, 0, 0, 1.0, 0, 0, 0]), np.zeros((6, 6)), np.zeros((6, 6))
        U[5, 5] = sigma**2
        for _ in range(steps):
            pose, J = step.jac(pose, np.array([length, 0, 0, 0, 0, 0]), 1.0)
            P = J.state @ P @ J.state.T + J.control @ U @ J.control.T
        given = f"{steps} steps of {length:g} m with {sigma:g} rad, in units of sigma squared"
        found = covariance(candidate(length, sigma, steps), 2, "the covariance") / sigma**2
        expected = P[pick] / sigma**2
        same(found[1, 1], expected[1, 1], "the variance of the heading", given=given)
        same(found[0, 0], expected[0, 0], "the variance of the sideways position", given=given)
        same(found[0, 1], expected[0, 1], "their covariance", given=given)


def _moved(motion: Motion, state: Array, origin: Array, control: Array) -> Array:
    """Tangent vector (6,) at `origin` of where a control leads in half a second."""
    step: Array = Pose.minus(motion.step(state, control, 0.5), origin)
    return step


@exercise("motion_models.6", "a motion of your own: the unicycle")
def unicycle(candidate: Any) -> None:
    """Against fine steps along the arc in the robot's own plane; smooth at zero; a robot of a rig drives by it."""
    holds(isinstance(candidate, Motion), "is a Motion", f"got {type(candidate).__name__}")
    holds(candidate.control == 2, "its control has two numbers", f"it says {candidate.control}")
    holds(candidate.angles == (1,), "the second number of the control is an angle", f"it says {candidate.angles}")
    rng = np.random.default_rng(76)
    for yaw_rate in (0.0, 1e-9, 0.4, -2.0):
        state, control, dt = Pose.random(rng), np.array([1.5, yaw_rate]), 0.5
        moved, J = candidate.step.jac(state, control, dt)
        turns = yaw_rate * dt * (np.arange(20000) + 0.5) / 20000
        along = 1.5 * dt * np.array([np.cos(turns).mean(), np.sin(turns).mean(), 0])
        given = f"speed 1.5 m/s, yaw rate {yaw_rate:g} rad/s, for 0.5 s"
        place = state[:3] + rotation(state[3:]) @ along
        same(moved[:3], place, "ends where fine steps along the arc end", tolerance=1e-8, given=given)
        turned = rotation(state[3:]) @ rotation(exponential(np.array([0, 0, yaw_rate * dt])))
        same(rotation(moved[3:]), turned, "turns about its own vertical axis", tolerance=1e-12, given=given)
        by = differences(partial(_moved, candidate, state, moved), control)
        same(J.control, by, "the Jacobian by the control", tolerance=1e-5, given=given)
    rig = Rig((RobotSetup(motion=candidate, control=(1.0, 90.0)),), (SensorSetup(),))
    run = list(simulate(rig, World(), frames=40, dt=0.1, rng=rng))
    same(
        run[-1][1].robots[0][:3],
        np.zeros(3),
        "four seconds at 90 degrees a second come back to the start",
        tolerance=1e-9,
    )
