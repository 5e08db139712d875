"""Generated code beside sympy.lambdify and beside a hand-written loop: one landmark, a hundred, a thousand.

The model is an anchored point (anchor, direction, inverse distance) seen from a pose: its direction in the frame, with
Jacobians with respect to the pose (six) and the landmark (seven). All times are CPU times of one run on one machine;
only their ratios mean anything elsewhere.
"""

import argparse
import time
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
import sympy

from slamlib.codegen.trace import trace
from slamlib.geometry.pose import Pose
from slamlib.geometry.quaternion import rotation
from slamlib.models import model


@model(pose=Pose, landmark=7)
def to_frame(pose: Any, landmark: Any) -> Any:
    """Direction of an anchored point in a frame, up to scale; defined at infinity too."""
    anchor, direction, inverse_distance = landmark[:3], landmark[3:6], landmark[6]
    return rotation(pose[3:]).T @ (direction + inverse_distance * (anchor - pose[:3]))


def by_hand(pose: Any, landmark: Any) -> tuple[Any, Any, Any]:
    """The same with its Jacobians, as one would write it: for one landmark."""
    R = rotation.definition(pose[3:])
    seen = R.T @ (landmark[3:6] + landmark[6] * (landmark[:3] - pose[:3]))
    x, y, z = seen
    skew = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    by_pose = np.hstack([-landmark[6] * R.T, skew])
    by_landmark = np.hstack([landmark[6] * R.T, R.T, (R.T @ (landmark[:3] - pose[:3]))[:, None]])
    return seen, by_pose, by_landmark


def loop(pose: Any, landmarks: Any) -> list[Any]:
    """The hand-written code, landmark by landmark."""
    return [by_hand(pose, landmark) for landmark in landmarks]


def lambdified() -> Callable[..., Any]:
    """Value and Jacobians through sympy.lambdify with common sub-expressions, gathered into an array."""
    traced = trace(to_frame)
    entries = [*traced.value.ravel(), *(e for j in traced.tangent for e in j)]
    flat = [s for symbols in traced.symbols for s in symbols.ravel()]
    function = sympy.lambdify(flat, entries, "numpy", cse=True)
    return lambda pose, landmarks: np.array(np.broadcast_arrays(*function(*pose, *np.asarray(landmarks).T)))


def quickest(function: Callable[[], Any], seconds: float = 0.3) -> float:
    """Least CPU time of a call [s], over as many calls as fit."""
    function()  # the first call generates code
    best, end = np.inf, time.process_time() + seconds
    while time.process_time() < end:
        start = time.process_time_ns()
        function()
        best = min(best, (time.process_time_ns() - start) / 1e9)
    return best


def table(counts: tuple[int, ...] = (1, 100, 1000), seconds: float = 0.3) -> list[tuple[int, float, float, float]]:
    """For each number of landmarks: seconds of ours, of lambdify, of the loop."""
    rng = np.random.default_rng(5)
    pose, other = Pose.random(rng), lambdified()
    rows = []
    for n in counts:
        landmarks = rng.standard_normal((n, 7))
        given = landmarks[0] if n == 1 else landmarks
        ours = quickest(partial(to_frame.jac, pose, given), seconds)
        theirs = quickest(partial(other, pose, landmarks), seconds)
        hand = quickest(partial(loop, pose, landmarks), seconds)
        rows.append((n, ours, theirs, hand))
    return rows


def report(rows: list[tuple[int, float, float, float]]) -> str:
    """The table as text: microseconds of ours, and how many times longer the others take."""
    lines = ["landmarks   generated   lambdify   hand-written loop"]
    lines += [f"{n:9}   {a * 1e6:6.0f} us   {b / a:6.1f} x   {c / a:6.1f} x" for n, a, b, c in rows]
    return "\n".join(lines)


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=float, default=0.3, help="CPU time spent on each figure (default 0.3)")
    parser.add_argument("--landmarks", type=int, nargs="+", default=[1, 100, 1000], help="how many at once")
    options = parser.parse_args()
    print(report(table(tuple(options.landmarks), options.seconds)))


if __name__ == "__main__":
    main()
