"""Checks of the chapter: motion models."""

import numpy as np

from slambook.exercises.kit import Candidate, Rng, cases, covariance, exercise, holds, parts, same
from slamlib.geometry.pose import ORIGIN, Pose, compose
from slamlib.geometry.quaternion import exponential, rotation
from slamlib.models.numerical import differences
from slamlib.motions import Motion
from slamlib.motions.odometry import step
from slamlib.records.inputs import World
from slamlib.rigs.setup import Rig, RobotSetup, SensorSetup
from slamlib.simulation import simulate


@exercise("motion_models.2", "driving an arc", seed=72)
def arc(candidate: Candidate, rng: Rng) -> None:
    """Mean against fine integration, covariance against differences of the candidate's own mean; smooth at zero."""
    P, U = np.array([[0.2, 0.05, 0.02], [0.05, 0.1, 0.03], [0.02, 0.03, 0.05]]), np.array([[0.03, 0.01], [0.01, 0.02]])
    for turn in cases((0.0, 1e-9, 7e-5, 0.3, -1.2, 3.0), "a turn of {} rad"):
        x, u = rng.standard_normal(3), np.array([1.5, turn])
        mean, found = parts(candidate(x, P, u, U), {"the mean": (3,), "the covariance": (3, 3)})
        headings = x[2] + turn * (np.arange(20000) + 0.5) / 20000
        there = x[:2] + u[0] * np.array([np.cos(headings).mean(), np.sin(headings).mean()])
        same(mean[:2], there, "ends where fine steps along the circle end", tolerance=1e-7)
        same(mean[2], x[2] + turn, "turns by the turn")
        covariance(found, 3)
        F = differences(lambda at, u=u: candidate(at, P, u, U)[0], x)
        G = differences(lambda at, x=x: candidate(x, P, at, U)[0], u)
        same(found, F @ P @ F.T + G @ U @ G.T, "the covariance moves with the mean's own Jacobians", tolerance=1e-6)


@exercise("motion_models.3", "propagating a covariance", seed=73)
def propagate(candidate: Candidate, rng: Rng) -> None:
    """Heading error becomes sideways position error; and the covariance of samples agrees."""
    F = np.array([[1.0, 0, 0], [0, 1, 2], [0, 0, 1]])  # drove two metres along x
    sideways = covariance(candidate(F, np.diag([0, 0, 0.01]), np.zeros((3, 3))), 3)[1, 1]
    holds(sideways > 0.03, "an uncertain heading makes the position uncertain sideways", f"found {sideways:.4g} m^2")
    for _ in range(3):
        F, root, noise = rng.standard_normal((3, 3)), rng.standard_normal((3, 3)), rng.uniform(0.1, 1, (3, 3))
        Q = noise @ noise.T
        same(candidate(F, np.zeros((3, 3)), Q), Q, "without an error before, Q is all there is")
        samples = rng.standard_normal((20000, 3)) @ root.T @ F.T + rng.standard_normal((20000, 3)) @ noise.T
        found = covariance(candidate(F, root @ root.T, Q), 3)
        scale = np.abs(found).max()
        same(found / scale, np.cov(samples.T) / scale, "agrees with the spread of 20000 samples", tolerance=0.06)


@exercise("motion_models.5", "driving straight ahead with an uncertain heading")
def straight_drive(candidate: Candidate) -> None:
    """Against the book's own prediction, step by step in six dimensions."""
    drives = (1, 0.5, 0.02), (2, 0.5, 0.02), (7, 2.0, 0.01), (40, 0.25, 0.03)
    for steps, length, sigma in cases(drives, "{} steps of {:g} m with {:g} rad, in units of sigma squared"):
        pose, P, U = ORIGIN, np.zeros((6, 6)), np.zeros((6, 6))
        U[5, 5] = sigma**2
        for _ in range(steps):
            pose, J = step.jac(pose, np.array([length, 0, 0, 0, 0, 0]), 1.0)
            P = J.state @ P @ J.state.T + J.control @ U @ J.control.T
        found = covariance(candidate(length, sigma, steps), 2) / sigma**2
        expected = P[np.ix_([1, 5], [1, 5])] / sigma**2
        same(found[1, 1], expected[1, 1], "the variance of the heading")
        same(found[0, 0], expected[0, 0], "the variance of the sideways position")
        same(found[0, 1], expected[0, 1], "their covariance")


@exercise("motion_models.6", "a motion of your own: the unicycle", seed=76)
def unicycle(candidate: Candidate, rng: Rng) -> None:
    """Against fine steps along the arc in the robot's own plane; smooth at zero; a robot of a rig drives by it."""
    holds(isinstance(candidate, Motion), "is a Motion", f"got {type(candidate).__name__}")
    holds(candidate.control == 2, "its control has two numbers", f"it says {candidate.control}")
    holds(candidate.angles == (1,), "the second number of the control is an angle", f"it says {candidate.angles}")
    for yaw_rate, dt in cases(((0.0, 0.5), (1e-9, 1), (0.4, 0.5), (-2.0, 0.3)), "1.5 m/s, {:g} rad/s, for {:g} s"):
        state, control = Pose.random(rng), np.array([1.5, yaw_rate])
        moved, J = candidate.step.jac(state, control, dt)
        turns = yaw_rate * dt * (np.arange(20000) + 0.5) / 20000
        along = 1.5 * dt * np.array([np.cos(turns).mean(), np.sin(turns).mean(), 0])
        there = compose(state, np.concatenate([along, exponential(np.array([0, 0, yaw_rate * dt]))]))
        same(moved[:3], there[:3], "ends where fine steps along the arc end", tolerance=1e-8)
        same(rotation(moved[3:]), rotation(there[3:]), "turns about its own vertical axis", tolerance=1e-12)
        by = differences(lambda u, x=state, t=dt, to=moved: Pose.minus(candidate.step(x, u, t), to), control)
        same(J.control, by, "the Jacobian by the control", tolerance=1e-5)
    rig = Rig((RobotSetup(motion=candidate, control=(1.0, 90.0)),), (SensorSetup(),))
    end = list(simulate(rig, World(), frames=40, dt=0.1, rng=rng))[-1][1].robots[0][:3]
    same(end, np.zeros(3), "four seconds at 90 degrees a second come back to the start", tolerance=1e-9)
