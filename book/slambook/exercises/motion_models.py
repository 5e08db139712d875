"""Checks of the chapter: motion models."""

import numpy as np

from slambook.exercises.kit import Candidate, Rng, cases, covariance, exercise, given, holds, is_finite, parts, same
from slamlib.geometry.pose import ORIGIN, Pose, compose
from slamlib.geometry.quaternion import exponential, rotation
from slamlib.manifolds import Array
from slamlib.models.numerical import differences
from slamlib.motions import Motion
from slamlib.motions.odometry import step
from slamlib.records.inputs import World
from slamlib.rigs.setup import Rig, RobotSetup, SensorSetup
from slamlib.simulation import simulate


@exercise("motion_models.1", "driving an arc", seed=72)
def arc(candidate: Candidate, rng: Rng) -> None:
    """Mean against fine integration, covariance against differences of the candidate's own mean; smooth at zero."""
    P, U = np.array([[0.2, 0.05, 0.02], [0.05, 0.1, 0.03], [0.02, 0.03, 0.05]]), np.array([[0.03, 0.01], [0.01, 0.02]])
    shapes, none = {"the mean": (3,), "the covariance": (3, 3)}, np.zeros((3, 3))
    turns = (0.3, -1.2, 3.0, 0.0, 1e-9, 7e-5)
    asked = [(np.round(rng.standard_normal(3), 1), [1.5, turn], P, U) for turn in turns]
    for x, control, *_ in cases(asked, "x {}, u {}, P {}, U {}"):
        u, turn = np.array(control), control[1]
        returned = parts(candidate(x, P, u, U), dict.fromkeys(shapes))
        holds(all(map(is_finite, returned)), "finite numbers, also at no turn", "found nan or infinity")
        mean, found = parts(returned, shapes)
        headings = x[2] + turn * (np.arange(20000) + 0.5) / 20000
        there = x[:2] + u[0] * np.array([np.cos(headings).mean(), np.sin(headings).mean()])
        same(mean[:2], there, "ends where fine steps along the circle end", tolerance=1e-7)
        same(mean[2], x[2] + turn, "turns by the turn")
        covariance(found, 3)
        F = differences(lambda at, u=u: candidate(at, P, u, U)[0], x)
        G = differences(lambda at, x=x: candidate(x, P, at, U)[0], u)
        by_pose, by_control = candidate(x, P, u, 0 * U)[1], candidate(x, none, u, U)[1]
        same(by_pose, F @ P @ F.T, "a perfect control, U = 0: the error moves with the mean", tolerance=1e-6)
        same(by_control, G @ U @ G.T, "a known pose, P = 0: the control's error moves it", tolerance=1e-6)
        same(found, F @ P @ F.T + G @ U @ G.T, "independent errors add their covariances", tolerance=1e-6)


@exercise("motion_models.2", "propagating a covariance", seed=73)
def propagate(candidate: Candidate, rng: Rng) -> None:
    """Heading error becomes sideways position error; and the covariance of samples agrees."""
    ahead, P, none = np.array([[1.0, 0, 0], [0, 1, 2], [0, 0, 1]]), np.diag([0, 0, 0.01]), np.zeros((3, 3))
    given(f"two metres along x, F {_row(ahead)}, with P {_row(P)} and Q 0")
    sideways = covariance(candidate(ahead, P, none), 3)[1, 1]
    what = "an uncertain heading makes the position uncertain sideways"
    holds(sideways > 0.03, what, f"found {sideways:.4g} m^2")
    for _ in range(3):
        F, root = np.round(rng.standard_normal((2, 3, 3)), 1)
        noise = np.round(rng.uniform(0.1, 1, (3, 3)), 1)
        P, Q = root @ root.T, noise @ noise.T
        given(f"F {_row(F)}, P 0, Q {_row(Q)}")
        same(candidate(F, none, Q), Q, "without an error before, Q is all there is")
        given(f"F {_row(F)}, P {_row(P)}, Q {_row(Q)}")
        samples = rng.standard_normal((20000, 3)) @ root.T @ F.T + rng.standard_normal((20000, 3)) @ noise.T
        found = covariance(candidate(F, P, Q), 3)
        scale = np.abs(found).max()
        same(found / scale, np.cov(samples.T) / scale, "agrees with the spread of 20000 samples", tolerance=0.06)
    given("")


def _row(matrix: Array) -> str:
    """A matrix of few digits in one line, to be typed."""
    return str(np.round(matrix, 2).tolist())


@exercise("motion_models.4", "driving straight ahead with an uncertain heading")
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


@exercise("motion_models.5", "a motion of your own: the unicycle", seed=76)
def unicycle(candidate: Candidate, rng: Rng) -> None:
    """Against fine steps along the arc in the robot's own plane; smooth at zero; a robot of a rig drives by it."""
    kind = "a function: put it into Motion(...)" if callable(candidate) else type(candidate).__name__
    holds(isinstance(candidate, Motion), "is a Motion", f"got {kind}")
    holds(candidate.control == 2, "its control has two numbers", f"it says {candidate.control}")
    holds(candidate.angles == (1,), "the second number of the control is an angle", f"it says {candidate.angles}")
    asked = [(*drive, Pose.random(rng)) for drive in ((0.4, 0.5), (-2.0, 0.3), (0.0, 0.5), (1e-9, 1.0))]
    for yaw_rate, dt, state in cases(asked, "1.5 m/s, {:g} rad/s, for {:g} s, from the pose {}"):
        control = np.array([1.5, yaw_rate])
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
