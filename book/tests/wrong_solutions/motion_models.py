"""Wrong solutions of chapter motion_models."""

import functools

import numpy as np

from book.tests.wrong_solutions import wrong
from slamlib.analytic import cos, sin, stumpff
from slamlib.geometry.pose import Pose, from_frame
from slamlib.geometry.quaternion import plus, product
from slamlib.models import model
from slamlib.motions import Motion


def _propagate(f, x, P, u, U):
    h = 1e-6
    F = np.stack([(f(x + h * e, u) - f(x - h * e, u)) / (2 * h) for e in np.eye(3)], -1)
    G = np.stack([(f(x, u + h * e) - f(x, u - h * e)) / (2 * h) for e in np.eye(2)], -1)
    return f(x, u), F @ P @ F.T + G @ U @ G.T


def _ahead(x, length, direction, turn):
    return x + np.array([length * np.cos(direction), length * np.sin(direction), turn])


def _arc(x, u):
    return _ahead(x, np.sinc(u[1] / 2 / np.pi) * u[0], x[2] + u[1] / 2, u[1])


wrong("motion_models.1", "drives straight ahead, then turns")(
    functools.partial(_propagate, lambda x, u: _ahead(x, u[0], x[2], u[1]))
)
wrong("motion_models.1", "takes the arc's length for the chord's")(
    functools.partial(_propagate, lambda x, u: _ahead(x, u[0], x[2] + u[1] / 2, u[1]))
)
wrong("motion_models.1", "forgets the noise of the control")(lambda x, P, u, U: _propagate(_arc, x, P, u, 0 * U))
wrong("motion_models.1", "of P only the variances")(lambda x, P, *uU: _propagate(_arc, x, np.diag(np.diag(P)), *uU))
wrong("motion_models.1", "of U only the variances")(lambda x, P, u, U: _propagate(_arc, x, P, u, np.diag(np.diag(U))))
wrong("motion_models.1", "points the chord along the last heading")(
    functools.partial(_propagate, lambda x, u: _ahead(x, np.sinc(u[1] / 2 / np.pi) * u[0], x[2] + u[1], u[1]))
)
wrong("motion_models.1", "turns the other way")(
    functools.partial(_propagate, lambda x, u: _arc(x, np.array([u[0], -u[1]])))
)
wrong("motion_models.1", "the noise of the control is added to heading and way as if both were numbers of the pose")(
    lambda x, P, u, U: (_arc(x, u), _propagate(_arc, x, P, u, 0 * U)[1] + np.diag([U[0, 0], U[0, 0], U[1, 1]]))
)


@wrong("motion_models.1", "divides by the turn, which may be zero")
def divides(x, P, u, U):
    mean, found = _propagate(_arc, x, P, u, U)
    with np.errstate(invalid="ignore"):
        return mean * np.divide(u[1], u[1]), found


@wrong("motion_models.1", "straight on below a hundredth of a radian")
def straight_when_small(x, P, u, U):
    return _propagate(lambda y, w: _ahead(y, w[0], y[2], w[1]) if abs(w[1]) < 0.01 else _arc(y, w), x, P, u, U)


wrong("motion_models.2", "the transposed Jacobian, as published")(lambda F, P, Q: F.T @ P @ F + Q)
wrong("motion_models.2", "forgets Q")(lambda F, P, Q: F @ P @ F.T)
wrong("motion_models.2", "of Q only the variances")(lambda F, P, Q: F @ P @ F.T + np.diag(np.diag(Q)))
wrong("motion_models.2", "standard deviations for the variances of Q")(lambda F, P, Q: F @ P @ F.T + np.sqrt(Q))


wrong("motion_models.2", "multiplies entry by entry")(lambda F, P, Q: F * P * F.T + Q)
wrong("motion_models.2", "moves the new noise, too")(lambda F, P, Q: F @ (P + Q) @ F.T)
wrong("motion_models.2", "only adds")(lambda F, P, Q: P + Q)
wrong("motion_models.2", "the inverse for the transpose")(lambda F, P, Q: F @ P @ np.linalg.inv(F) + Q)


@wrong("motion_models.2", "multiplies on one side only")
def one_side(F, P, Q):
    half = F @ P
    return (half + half.T) / 2 + Q


@wrong("motion_models.4", "counts the turn of a step as if it came before the step's move")
def turn_first(length, sigma, steps):
    k = np.arange(1, steps + 1)
    both = length * k.sum()
    return sigma**2 * np.array([[length**2 * (k**2).sum(), both], [both, steps]])


@wrong(
    "motion_models.4",
    "a turn moves the robot sideways in the next step only, so that the error grows with the root of n",
)
def no_memory(length, sigma, steps):
    both = length * (steps - 1)
    return sigma**2 * np.array([[length**2 * (steps - 1), both], [both, steps]])


@wrong("motion_models.4", "the variances are right, but the two errors are taken for independent")
def independent(length, sigma, steps):
    k = np.arange(steps)
    return sigma**2 * np.diag([length**2 * (k**2).sum(), steps])


@wrong("motion_models.4", "adds standard deviations instead of variances")
def standard_deviations(length, sigma, steps):
    k = np.arange(steps)
    a = np.array([length * k.sum(), steps])
    return sigma**2 * np.outer(a, a)


def _drive(length, sigma, steps):
    k = np.arange(steps)
    both = length * k.sum()
    return sigma**2 * np.array([[length**2 * (k**2).sum(), both], [both, steps]])


@wrong("motion_models.4", "the limit of very many steps")
def limit(length, sigma, steps):
    both = length * steps**2 / 2
    return sigma**2 * np.array([[length**2 * steps**3 / 3, both], [both, steps]])


wrong("motion_models.4", "the heading first")(lambda *given: _drive(*given)[::-1, ::-1])
wrong("motion_models.4", "the standard deviation for the variance")(lambda a, sigma, n: _drive(a, sigma, n) / sigma)
wrong("motion_models.4", "left is negative")(lambda *given: _drive(*given) * np.array([[1, -1], [-1, 1]]))


@model(state=Pose, control=2, dt=(), returns=Pose)
def ahead_then_turn(state, control, dt):
    """The whole way straight ahead, then the whole turn."""
    zero = 0 * dt
    ahead = np.array([control[0] * dt, zero, zero])
    return np.concatenate([from_frame(state, ahead), plus(state[3:], np.array([zero, zero, control[1] * dt]))])


@model(state=Pose, control=2, dt=(), returns=Pose)
def in_the_world(state, control, dt):
    """An arc about the world's vertical axis through the world's x, whatever the robot's heading."""
    zero, half = 0 * dt, control[1] * dt / 2
    chord = control[0] * dt * stumpff(1, half * half)
    moved = np.array([chord * cos(half), chord * sin(half), zero])
    return np.concatenate([state[:3] + moved, plus(state[3:], np.array([zero, zero, 2 * half]))])


@model(state=Pose, control=2, dt=(), returns=Pose)
def half_a_second(state, control, dt):
    """The arc's chord for half a second, however long the step is."""
    zero, half = 0 * dt, control[1] * dt / 2
    chord = control[0] * stumpff(1, half * half) / 2
    moved = np.array([chord * cos(half), chord * sin(half), zero])
    return np.concatenate([from_frame(state, moved), plus(state[3:], np.array([zero, zero, 2 * half]))])


@model(state=Pose, control=2, dt=(), returns=Pose)
def arc(state, control, dt):
    """Right."""
    zero, half = 0 * dt, control[1] * dt / 2
    chord = control[0] * dt * stumpff(1, half * half)
    moved = np.array([chord * cos(half), chord * sin(half), zero])
    return np.concatenate([from_frame(state, moved), plus(state[3:], np.array([zero, zero, 2 * half]))])


@model(state=Pose, control=2, dt=(), returns=Pose)
def last_heading(state, control, dt):
    """The chord along the last heading."""
    zero, turn = 0 * dt, control[1] * dt
    chord = control[0] * dt * stumpff(1, turn * turn / 4)
    moved = np.array([chord * cos(turn), chord * sin(turn), zero])
    return np.concatenate([from_frame(state, moved), plus(state[3:], np.array([zero, zero, turn]))])


@model(state=Pose, control=2, dt=(), returns=Pose)
def about_the_worlds_vertical(state, control, dt):
    """The right arc, but a turn about the world's vertical."""
    zero, half = 0 * dt, control[1] * dt / 2
    turned = product(np.array([cos(half), zero, zero, sin(half)]), state[3:])
    return np.concatenate([arc.definition(state, control, dt)[:3], turned])


@model(state=Pose, control=2, dt=(), returns=Pose)
def degrees(state, control, dt):
    """Makes radians of degrees (22/7 is near enough), which a setup has done already."""
    return arc.definition(state, np.array([control[0], control[1] * 11 / 630]), dt)


wrong("motion_models.5", "a model, not yet a Motion")(arc)
wrong("motion_models.5", "the chord along the last heading")(Motion("unicycle", Pose, 2, last_heading, angles=(1,)))
wrong("motion_models.5", "about the world's vertical")(
    Motion("unicycle", Pose, 2, about_the_worlds_vertical, angles=(1,))
)
wrong("motion_models.5", "degrees, twice")(Motion("unicycle", Pose, 2, degrees, angles=(1,)))
wrong("motion_models.5", "drives straight ahead, then turns")(Motion("unicycle", Pose, 2, ahead_then_turn, angles=(1,)))
wrong("motion_models.5", "moves along the world's axes")(Motion("unicycle", Pose, 2, in_the_world, angles=(1,)))
wrong("motion_models.5", "takes the yaw rate of a setup for radians")(Motion("unicycle", Pose, 2, arc, angles=()))
wrong("motion_models.5", "moves as far in any time")(Motion("unicycle", Pose, 2, half_a_second, angles=(1,)))
