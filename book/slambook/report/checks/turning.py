"""Checks of the angles: (5.7), (5.11) to (5.18)."""

from math import inf

import numpy as np

from slambook.report import angles
from slambook.report.findings import AuditFigure, Findings, at_least, at_most, check, near, ran, statistics
from slamlib.geometry import euler
from slamlib.manifolds import Array


def _deg(*values: float) -> Array:
    return np.radians(np.array(values, dtype=float))


def _added_off(before: Array, turn: Array) -> float:
    """Difference of the sum of the angles from the composition [degrees]."""
    right = angles.composed(before, turn, angles.extracted)
    return float(np.degrees(angles.apart(angles.added(before, turn, angles.extracted), right)))


def _worst_of_a_turn(pitch: float, roll: float) -> float:
    """Largest error [degrees] over a full turn, in steps of one degree."""
    right = wrong = _deg(0, pitch, roll)
    worst = 0.0
    for _ in range(360):
        right = angles.composed(right, _deg(1, 0, 0), angles.extracted)
        wrong = angles.added(wrong, _deg(1, 0, 0), angles.extracted)
        worst = max(worst, float(np.degrees(angles.apart(right, wrong))))
    return worst


@check("E04", "(5.11)-(5.13)", "angles are added", "R = R(before) R(u), then its angles")
def added() -> Findings:
    a, a_right = ran("gentle", "E04"), ran("gentle")
    b, b_right = ran("hard", "E04"), ran("hard")
    mean, b_mean = ran("gentle", "E04 mean"), ran("hard", "E04 mean")
    half = "the largest error, at half a turn: after the full turn it is zero again"
    yield near("one step, 40/5/3, yaw 2 [deg]", _added_off(_deg(40, 5, 3), _deg(2, 0, 0)), 0.20, 0.005)
    yield near("one step, pitch 10, roll 10, yaw 5 [deg]", _added_off(_deg(0, 10, 10), _deg(5, 0, 0)), 1.23, 0.005)
    yield near("one step, pitch 30, yaw 10 [deg]", _added_off(_deg(0, 30, 0), _deg(10, 0, 0)), 5.2, 0.05)
    yield near("round in 360 steps, pitch 5, roll 2 [deg]", _worst_of_a_turn(5, 2), 10.8, 0.05, remark=half)
    yield near("round in 360 steps, pitch 10, roll 5 [deg]", _worst_of_a_turn(10, 5), 22.3, 0.05)
    yield near("round in 360 steps, pitch 20, roll 10 [deg]", _worst_of_a_turn(20, 10), 44.5, 0.05)
    yield near("NEES/6, gentle", a.ratio, 5.75, 1.5)
    yield near("error of the attitude, times that of the right filter, gentle", a.rotation / a_right.rotation, 3.3, 0.6)
    yield near(
        "NEES/6, gentle, in the mean alone", mean.ratio, 1.3, 0.3, remark="with the derivatives of the composition"
    )
    yield near("NEES/6, hard, in the mean alone", b_mean.ratio, 1300, 500)
    yield near("NEES/6, hard", b.ratio, 5505, 1500)
    yield near("error of the attitude, hard [deg]", b.rotation, 23.6, 5)
    yield statistics(("gentle", a), ("right", a_right), ("hard", b), ("right", b_right))


@check("E05", "(5.15), (5.18)", "yaw from R32, R33; roll from R21, R11", "exchanged")
def exchanged() -> Findings:
    def error(*given: float) -> float:
        back = angles.as_printed(angles.rotation(_deg(*given)))
        return float(np.degrees(angles.apart(back, _deg(*given))))

    rng = np.random.default_rng(5)
    any_angles = rng.uniform((-3, -1.5, -3), (3, 1.5, 3), (1000, 3))
    round_trip = np.abs(angles.wrapped(angles.without_branch(angles.rotation(any_angles)) - any_angles)).max()
    run, right = ran("hard", "E05"), ran("hard")
    yield near("yaw 10 comes back off by [deg]", error(10, 0, 0), 14.1, 0.05)
    yield near("30, 5, 2 comes back off by [deg]", error(30, 5, 2), 41.1, 0.05)
    yield near("yaw 90 comes back off by [deg]", error(90, 0, 0), 120, 0.05)
    yield at_most("exchanged: a thousand attitudes come back", round_trip, 1e-12)
    yield at_least("NEES/6, hard", run.ratio, 2000)
    yield near("error of the attitude, hard [deg]", run.rotation, 47, 20)
    yield statistics(("hard", run), ("right", right))


@check("E06", "(5.15)-(5.18)", "no degenerate case", "a branch at pitch 90 degrees, or quaternions")
def degenerate() -> Findings:
    camera = angles.rotation(_deg(0, 91, 0))  # heading about the axis that a camera has downwards
    read = np.degrees(angles.without_branch(camera))
    steep = angles.rotation(np.array([[0.4, np.pi / 2, 0.9]]))
    lost = np.degrees(angles.apart(angles.extracted(steep), np.array([[0.4, np.pi / 2, 0.9]])))[0]
    body, optical = ran("upright"), ran("optical")
    spike = optical.nees.mean(0).reshape(-1)[[14, 44]] / 6
    passing = "at that step alone; in the band again at the next, since a map holds the pose"
    yield near("heading 91: yaw read, size [deg]", abs(read[0]), 180, 1e-6)
    yield near("heading 91: pitch read [deg]", read[1], 89, 1e-6)
    yield near("1/cos of pitch 80", 1 / np.cos(np.radians(80)), 5.76, 0.01)
    yield near("1/cos of pitch 89", 1 / np.cos(np.radians(89)), 57.3, 0.1)
    yield at_most("with the branch: pitch 90 comes back off by [deg]", float(lost), 1e-5)
    yield near("NEES/6, heading as yaw", body.ratio, 1.0, 0.25)
    yield AuditFigure("NEES/6 when the heading, as pitch, is 90", float(spike.min()), 3.0, inf, passing)
    yield statistics(("heading as yaw", body), ("as pitch", optical))


@check(
    "E28", "2.1, (5.7)", "yaw, pitch, roll about z, y, x; world = first camera frame", "as it says; use a body frame"
)
def convention() -> Findings:
    any_angles = np.random.default_rng(28).uniform(-3, 3, (1000, 3))
    R = angles.rotation(any_angles)
    (cy, cp, cr), (sy, sp, sr) = np.cos(any_angles.T), np.sin(any_angles.T)
    one, no = np.ones_like(cy), np.zeros_like(cy)
    Rz = np.array([[cy, -sy, no], [sy, cy, no], [no, no, one]]).transpose(2, 0, 1)
    Ry = np.array([[cp, no, sp], [no, one, no], [-sp, no, cp]]).transpose(2, 0, 1)
    Rx = np.array([[one, no, no], [no, cr, -sr], [no, sr, cr]]).transpose(2, 0, 1)
    yield at_most("(5.7) minus Rz Ry Rx, a thousand attitudes", np.abs(R - Rz @ Ry @ Rx).max(), 1e-14)
    yield at_most("its determinant minus 1", np.abs(np.linalg.det(R) - 1).max(), 1e-13)
    yield at_most("minus the toolbox's convention", np.abs(R - euler.to_rotation(any_angles[:, ::-1])).max(), 1e-14)
    yield "read: 2.1, the world begins where the first frames are obtained"
    yield "in those axes the heading is the pitch (E06)"
