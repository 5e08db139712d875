"""Checks of the prediction: (3.15), (5.19) to (5.23)."""

import numpy as np

from slambook.report import motion, observation, scenes
from slambook.report.angles import rotation
from slambook.report.findings import (
    Findings,
    at_least,
    at_most,
    check,
    near,
    ran,
    refused,
    statistics,
)
from slambook.report.runs import DOF
from slamlib.manifolds import Array
from slamlib.models.numerical import differences

SMALL, LARGE = (0.08, 0.9), (0.5, 10.0)  # m and degrees of yaw a step: a slow motion and a fast one


def _control(length: float, yaw: float) -> Array:
    return np.array([length, 0, 0, np.radians(yaw), 0, 0])


def _change_of_H(length: float, yaw: float) -> float:
    """Relative change of H from the old state to the predicted one, median over points 5 to 20 m ahead [percent]."""
    points = np.random.default_rng(1).uniform((5, -10, -2), (20, 10, 2), (200, 3))
    old = np.zeros(6)
    H, wrong = (observation.by_pose(pose, points) for pose in (scenes.after(old, _control(length, yaw)), old))
    sizes = np.linalg.norm(wrong - H, 2, axis=(-2, -1)) / np.linalg.norm(H, 2, axis=(-2, -1))
    return float(100 * np.median(sizes))


def _change_of_F(length: float, yaw: float) -> float:
    """Relative change of F14 to F36 from the old state to the predicted one [percent]."""
    old, u = np.zeros(6), _control(length, yaw)
    F, wrong = (motion.by_angles(pose[3:], u[:3]) for pose in (old, scenes.after(old, u)))
    return float(100 * np.linalg.norm(wrong - F, 2) / np.linalg.norm(F, 2))


def _norm_minus_identity(block: Array) -> float:
    return float(np.linalg.norm(block - np.eye(3), 2))


def _at(yaw: float, pitch: float, roll: float) -> Array:
    return np.radians([0.0, 0, 0, yaw, pitch, roll])


@check("E01", "(3.15)", "H at the corrected state of the step before", "H at the predicted state")
def place_of_H() -> Findings:
    a, b, b_right = ran("gentle", "E01"), ran("hard", "E01"), ran("hard")
    yield near("H off, 0.08 m and 0.9 degrees [%]", _change_of_H(*SMALL), 1.7, 0.3)
    yield near("H off, 0.5 m and 10 degrees [%]", _change_of_H(*LARGE), 17, 2)
    yield near("NEES/6, gentle", a.ratio, 1.08, 0.25)
    yield near("NEES/6, hard", b.ratio, 1.65, 0.3)
    yield statistics(("gentle", a), ("hard", b), ("right", b_right))


@check("E02", "5.2.4", "F at the predicted state", "F at the corrected state of the step before")
def place_of_F() -> Findings:
    a, b, b_right = ran("gentle", "E02"), ran("hard", "E02"), ran("hard")
    yield near("F14 to F36 off, 0.08 m and 0.9 degrees [%]", _change_of_F(*SMALL), 1.57, 0.05)
    yield near("F14 to F36 off, 0.5 m and 10 degrees [%]", _change_of_F(*LARGE), 17.4, 0.5)
    yield near("NEES/6, gentle", a.ratio, 1.06, 0.25)
    yield near("NEES/6, hard", b.ratio, 2.31, 0.8)
    yield at_least("the same over that of the right filter", b.ratio / b_right.ratio, 1.4)
    yield statistics(("gentle", a), ("hard", b), ("right", b_right)) + "; F and df/du at the predicted state"


@check("E03", "1.2, (3.8), (3.15)", "u_k leads from k to k+1; u_k in (3.8); u_{k-1} in (3.15)", "x_k = f(x_{k-1}, u_k)")
def index_of_u() -> Findings:
    wrong, right = ran("uneven", "E03"), ran("uneven")
    yield at_least("NEES/6, a robot that starts and stops", wrong.ratio, 2.0)
    yield near("the same with u_k", right.ratio, 1.0, 0.25)
    yield statistics(("uneven", wrong), ("right", right)) + "; read: all three conventions, where the table says"


@check("E07", "(5.20), rows 4-6", "[0 I]", "the derivative of the composed angles by the old ones")
def angle_rows() -> Findings:
    def error(at: Array, *turn: float) -> float:
        return _norm_minus_identity(motion.exact_by_pose(at, np.radians([0.0, 0, 0, *turn])))

    norm = "spectral norm, 5 degrees of yaw"
    run, right = ran("hard", "E07"), ran("hard")
    orientation, u = np.random.default_rng(20).uniform(-1, 1, (2, 100, 3))
    off = motion.by_angles(orientation, u) - differences(
        lambda o, u: (rotation(o) @ u[..., None])[..., 0], orientation, u
    )
    yield near("|A - I|, level, yaw 5", error(_at(0, 0, 0), 5, 0, 0), 0.087, 0.001)
    yield near("|A - I|, 40/20/10, yaw 5", error(_at(40, 20, 10), 5, 0, 0), 0.103, 0.001, remark=norm)
    yield near("|A - I|, pitch 80, yaw 5", error(_at(0, 80, 0), 5, 0, 0), 3.27, 0.01, remark=norm)
    yield near("|A - I|, pitch 80, pitch 5", error(_at(0, 80, 0), 0, 5, 0), 1.41, 0.01)
    yield at_most("F14 to F36 as printed minus differences", np.abs(off).max(), 1e-8)
    yield near("NEES/6, hard", run.ratio, 1.6, 0.35)
    yield statistics(("hard", run), ("right", right))


@check("E08", "(5.21), angle block", "identity", "the derivative of the composed angles by the control's")
def control_rows() -> Findings:
    def error(pitch: float, roll: float) -> float:
        return _norm_minus_identity(motion.exact_by_control(_at(0, pitch, roll), np.zeros(6)))

    cp, sp, cr, sr = *(f(0.7) for f in (np.cos, np.sin)), *(f(0.3) for f in (np.cos, np.sin))
    stated = np.array([[cr / cp, sr / cp, 0], [-sr, cr, 0], [cr * sp / cp, sr * sp / cp, 1]])
    B = motion.exact_by_control(np.array([0, 0, 0, 0.2, 0.7, 0.3]), np.zeros(6))
    a, b, both, right = ran("gentle", "E08"), ran("hard", "E08"), ran("hard", "E07", "E08"), ran("hard")
    norm = "spectral norm"
    yield at_most("B minus E(a)^-1 E(0)", np.abs(B - stated).max(), 1e-12)
    yield near("|B - I|, pitch 5, roll 3", error(5, 3), 0.10, 0.005)
    yield near("|B - I|, pitch 20, roll 10", error(20, 10), 0.412, 0.001, remark=norm)
    yield near("|B - I|, pitch 45, roll 10", error(45, 10), 1.10, 0.005)
    yield near("|B - I|, pitch 80, roll 0", error(80, 0), 7.40, 0.01, remark=norm)
    yield near("NEES/6, gentle", a.ratio, 1.11, 0.25)
    yield near("NEES/6, hard", b.ratio, 12, 4)
    yield near("NEES/6, hard, with E07", both.ratio, 34, 12)
    yield near("error of the attitude, times the right one, with E07", both.rotation / right.rotation, 5, 1)
    yield statistics(("gentle", a), ("hard", b), ("with E07", both), ("right", right))


@check("E09", "(5.22)", "Q = f_u U f_u', added to F P F'; U is never given", "Q belongs to the pose's 6 by 6 block")
def place_of_Q() -> Findings:
    yield near("Q 6 by 6 added to a state of 18: NumPy refuses", refused("E09"), 1, 0)
    yield (
        "read: 5.2.4: df/du is 'zero for the landmarks', so their rows of Q are; 'U being a matrix with of "
        "established uncertainty from the beginning', and no number"
    )


@check("E10", "(5.23), first block", "f_x P_xx f_x'", "f_x P_xx f_x' + Q, as (3.9) has it; the other blocks are right")
def missing_Q() -> Findings:
    wrong, right = ran("gentle", "E10"), ran("gentle")
    size = np.abs(wrong.claimed).max()
    yield at_most("P_xx after 60 steps, largest entry", size, 0.0)
    yield near("error of the position [m]", wrong.position, 0.43, 0.1)
    yield near("error of the attitude [deg]", wrong.rotation, 5.7, 0.6)
    yield near("with Q: position [m]", right.position, 0.028, 0.004)
    yield near("with Q: attitude [deg]", right.rotation, 0.37, 0.08)
    yield at_least("NEES/6 (P is singular)", wrong.ratio, float(DOF) * 1e6)
    yield statistics(("gentle", wrong), ("right", right))
