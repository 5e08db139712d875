"""Points observed by a camera on a robot, with all Jacobians: a batch beside one point after another.

An anchored homogeneous point (seven numbers) is seen by a pin-hole camera with distortion that a robot carries:
pixel, and Jacobians w.r.t. the robot (six), extrinsics (six), point (seven), intrinsics (four) and distortion.
Times are CPU times of one run with one BLAS thread, the least of many; "scaled" they are those of a machine that takes
0.36 ms for the bare product W'W by which the covariance of 600 states is updated when 20 points are seen.
"""

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # read when NumPy loads

import argparse
import cProfile
import io
import pstats
import time
from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

import numpy as np

from slamlib.geometry import quaternion
from slamlib.geometry.pose import compose
from slamlib.landmarks.ahm_point import AHM_POINT
from slamlib.observation.points import observe
from slamlib.sensors.pinhole import PINHOLE
from slamlib.sensors.sensor import Calibration

YARDSTICK = 0.36e-3  # s of the yardstick on the machine whose targets these are: 2 us and 0.48 us a point
COMPILED = {1000: 0.12e-6}  # s a point on that machine: C++ that SymForce generated, no Python around it
ROBOT = np.array([0.3, -0.2, 0.1, 0.8, 0.0, 0.0, 0.6])
MOUNT = np.array([0.1, 0.0, 0.2, 0.5, -0.5, 0.5, -0.5])  # the optical axis is the robot's x axis


def camera() -> Calibration:
    """640 x 480 pixels, 60 degrees or so, a little distortion."""
    return Calibration(PINHOLE, np.eye(2), image=(640, 480), intrinsics=[320, 240, 500, 500], distortion=[-0.2, 0.03])


def points(n: int) -> Any:
    """Anchored points (n, 7) in the camera's view."""
    rng, eye = np.random.default_rng(n), compose(ROBOT, MOUNT)
    rays = np.concatenate([rng.uniform(-0.4, 0.4, (n, 2)), np.ones((n, 1))], axis=1)
    directions = rays @ quaternion.rotation(eye[3:]).T
    anchors = eye[:3] + 0.05 * rng.standard_normal((n, 3))
    return np.concatenate([anchors, directions, rng.uniform(0.01, 0.5, (n, 1))], axis=1)


def by_hand(calibration: Calibration, robot: Any, extrinsics: Any, landmark: Any) -> tuple[Any, ...]:
    """One point, with its Jacobians w.r.t. robot, extrinsics and point (on the tangent space), written by hand."""
    r, m = quaternion.rotation.definition(robot[3:]), quaternion.rotation.definition(extrinsics[3:])
    R, t = r @ m, robot[:3] + r @ extrinsics[:3]
    world = landmark[3:6] + landmark[6] * (landmark[:3] - t)
    x, y, z = h = R.T @ world
    u0, v0, au, av = calibration.given["intrinsics"]
    k1, k2 = calibration.given["distortion"]
    p, q = x / z, y / z
    s = p * p + q * q
    f, slope = 1 + s * (k1 + s * k2), 2 * (k1 + 2 * s * k2)
    lens = np.array([[f + slope * p * p, slope * p * q], [slope * p * q, f + slope * q * q]])
    J = np.diag([au, av]) @ lens @ np.array([[1, 0, -p], [0, 1, -q]]) / z
    by_t = -landmark[6] * J @ R.T
    by_turn = J @ skew(h)
    in_robot = r.T @ world  # the turn of the robot moves the camera too
    by_robot = np.hstack([by_t, J @ m.T @ skew(in_robot) + by_t @ -r @ skew(extrinsics[:3])])
    by_extrinsics = np.hstack([by_t @ r, by_turn])
    by_landmark = np.hstack([-by_t, J @ R.T, (J @ R.T @ (landmark[:3] - t))[:, None]])
    return np.array([u0 + au * f * p, v0 + av * f * q]), by_robot, by_extrinsics, by_landmark


def skew(v: Any) -> Any:
    """The matrix of the cross product v x."""
    x, y, z = v
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def yardstick() -> Callable[[], Any]:
    """P -= W'W for 600 states and 40 measured numbers: BLAS on one triangle, or NumPy where SciPy is not installed."""
    W, P = np.random.default_rng(1).standard_normal((40, 600)), np.eye(600)
    try:
        from scipy.linalg.blas import dsyrk
    except ImportError:
        return lambda: np.subtract(P, W.T @ W, out=P)
    return lambda: dsyrk(-1.0, W.T, 1.0, P.T, overwrite_c=1)


def quickest(functions: Mapping[str, Callable[[], Any]], seconds: float) -> dict[str, float]:
    """Least CPU time of a call of each [s], taking turns, so that a change of the machine's pace meets all alike."""
    best = dict.fromkeys(functions, np.inf)
    end = time.process_time() + seconds
    while time.process_time() < end:
        for name, function in functions.items():
            for _ in range(5):
                start = time.process_time_ns()
                function()
                best[name] = min(best[name], (time.process_time_ns() - start) / 1e9)
    return best


def agree(calibration: Calibration, landmarks: Any) -> None:
    """Raise AssertionError unless the batch, the loop and the code by hand give the same."""
    batch = observe(AHM_POINT, calibration, ROBOT, MOUNT, landmarks)
    assert batch.visible.all()
    for i, landmark in enumerate(landmarks):
        value, *jacobians = by_hand(calibration, ROBOT, MOUNT, landmark)
        assert np.allclose(batch.value[i], value, rtol=0, atol=1e-9)
        for name, jacobian in zip(("robot", "extrinsics", "landmark"), jacobians, strict=True):
            assert np.allclose(getattr(batch.jacobians, name)[i], jacobian, rtol=0, atol=1e-8), name
        one = observe(AHM_POINT, calibration, ROBOT, MOUNT, landmark)
        assert all(np.allclose(a[i], b, rtol=0, atol=1e-8) for a, b in zip(batch.jacobians, one.jacobians, strict=True))


def table(counts: tuple[int, ...] = (100, 1000), seconds: float = 1.0) -> tuple[float, dict[int, dict[str, float]]]:
    """Seconds of the yardstick, and for each number of points seconds a point of each way."""
    calibration, rows, unit = camera(), {}, np.inf
    for n in counts:
        landmarks = points(n)
        agree(calibration, landmarks[:20])
        least = quickest(
            {
                "yardstick": yardstick(),
                "a batch": partial(observe, AHM_POINT, calibration, ROBOT, MOUNT, landmarks),
                "one by one": partial(observe, AHM_POINT, calibration, ROBOT, MOUNT, landmarks[0]),
                "by hand": partial(by_hand, calibration, ROBOT, MOUNT, landmarks[0]),
            },
            seconds,
        )
        unit = min(unit, least.pop("yardstick"))
        rows[n] = {**least, "a batch": least["a batch"] / n}
    return unit, rows


def report(unit: float, rows: dict[int, dict[str, float]]) -> str:
    """The table as text: microseconds a point, the same scaled to the target's machine, and the ratios."""
    lines = [f"bare product {unit * 1e3:.3f} ms", "points   a batch    scaled    one by one      by hand"]
    for n, row in rows.items():
        a, b, c = row["a batch"], row["one by one"], row["by hand"]
        scaled = a * YARDSTICK / unit
        lines.append(f"{n:6}   {a * 1e6:4.2f} us   {scaled * 1e6:4.2f} us   {b / a:8.0f} x   {c / a:8.0f} x")
        if n in COMPILED:
            lines.append(f"{'':6}   {scaled / COMPILED[n]:.1f} times what C++ generated by SymForce takes, scaled")
    return "\n".join(lines)


def profile(n: int, calls: int = 300, lines: int = 14) -> str:
    """Where the time of a batch of n points goes: microseconds a call, function by function (profiling slows all)."""
    landmarks, calibration, profiler = points(n), camera(), cProfile.Profile()
    observe(AHM_POINT, calibration, ROBOT, MOUNT, landmarks)
    profiler.enable()
    for _ in range(calls):
        observe(AHM_POINT, calibration, ROBOT, MOUNT, landmarks)
    profiler.disable()
    stats = pstats.Stats(profiler, stream=io.StringIO()).stats  # type: ignore[attr-defined]
    own = sorted(((v[2], k) for k, v in stats.items()), reverse=True)[:lines]
    return "\n".join(f"{t / calls * 1e6:7.1f} us  {os.path.basename(file)} {name}" for t, (file, _, name) in own)


def main() -> None:
    """Print the table and the profile."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=float, default=1.0, help="CPU time spent on each row (default 1)")
    parser.add_argument("--points", type=int, nargs="+", default=[100, 1000], help="how many at once")
    parser.add_argument("--profiled", type=int, nargs="*", help="of how many to show the profile (default: of each)")
    parser.add_argument("--lines", type=int, default=14, help="lines of a profile (default 14)")
    options = parser.parse_args()
    print(report(*table(tuple(options.points), options.seconds)))
    for n in options.points if options.profiled is None else options.profiled:
        print(f"\n{n} points, in the profiler (which slows all):\n{profile(n, lines=options.lines)}")


if __name__ == "__main__":
    main()
