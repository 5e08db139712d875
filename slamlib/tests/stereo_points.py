"""Identified stereo points without pictures, and the ways to move a filter among them, for Monte Carlo experiments."""

import numpy as np

from slamlib.geometry.pose import ORIGIN, Pose
from slamlib.motions import ODOMETRY
from slamlib.records.inputs import Control, Features, Frame, Scan
from slamlib.rigs.setup import RobotSetup, SensorSetup
from slamlib.slam import Options, Slam
from slamlib.tests.shared_noise import SharedNoise
from slamlib.tests.stereo import LENS, MOUNT, calibration, points_seen, seen_from
from slamlib.vision.stereo import motion_between

STILL = Control(np.zeros(6), np.zeros((6, 6)))
EVERYTHING = Options(
    points="eucPnt", updates=1000, max_new_first=1000, max_new=1000, reproject=False, gate=1.0, margin=0.0
)
VELOCITY = {"motion": "constVel", "control_std": (0.02,) * 3 + (1.0,) * 3, "velocity_std": (0.05,) * 3 + (3.0,) * 3}


def true_path(steps):
    """Poses (steps, 7), some 3 cm and half a degree apart."""
    poses = [ORIGIN]
    for k in range(steps - 1):
        shift = [0.02 * np.sin(k / 7), 0.03 * np.cos(k / 9), 0.005]
        turn = [0.004 * np.sin(k / 5), 0.006 * np.cos(k / 6), 0.008 * np.sin(k / 8)]
        poses.append(ODOMETRY.step(poses[-1], np.array(shift + turn), 1.0))
    return np.array(poses)


def simulate(rng, steps, count, std):
    """Ids (n,) and measurements (n, 3) of the points in view at each step, with white noise."""
    made, points, seen = calibration(std), points_seen(rng, count, MOUNT), []
    for pose in true_path(steps):
        exact = seen_from(points, pose, MOUNT)
        values = exact + rng.normal(0, std, exact.shape)
        inside = made.inside(exact, 5.0) & made.inside(values)
        seen.append((1 + np.flatnonzero(inside), values[inside]))
    return seen


def as_control(std, old, new, used):
    """The motion (as a control) between two steps' measurements, from the new ones that the mask has."""
    (before, first), (now, second) = old, (new[0][used], new[1][used])
    _, a, b = np.intersect1d(before, now, return_indices=True)
    return motion_between(calibration(std), first[a], second[b], MOUNT).control


def filtered(data, std, control, mapped=lambda ids: ids > 0, **robot):
    """Poses and covariances of the filter; control(step, old, new) of each step but the first."""
    sensor = SensorSetup(
        type="stereo",
        position=tuple(MOUNT[:3]),
        image=(320, 240),
        std=(std,) * 3,
        parameters={"intrinsics": LENS["intrinsics"], "baseline": (0.12,)},
    )
    slam = Slam(RobotSetup(**robot), sensor, options=EVERYTHING)
    for k, (ids, values) in enumerate(data):
        moved = control(k, data[k - 1], data[k]) if k else (None if robot else STILL)
        keep = mapped(ids)
        scan = Scan({"points": Features(ids[keep], values[keep])})
        slam.step(Frame(k + 1, float(k > 0), (moved,), (scan,)))
        yield slam.robots[0].pose.copy(), slam.belief.covariance(slam.robots[0].block)[:6, :6]


def shared(data, std, mapped=lambda ids: ids > 0):
    """The same of the filter with the noises in its state."""
    slam = SharedNoise(calibration(std), MOUNT)
    for ids, values in data:
        slam.step(ids, values, mapped(ids))
        yield slam.robot.mean.copy(), slam.belief.covariance(slam.robot)


def even(ids):
    """Mask of every other point."""
    return ids % 2 == 0


# Each way takes the data and the standard deviation. E21 is "twice": all matches move the robot and update the map.
WAYS = {
    "twice": lambda d, s: filtered(d, s, lambda k, old, new: as_control(s, old, new, new[0] > 0)),
    "covariance-intersection": lambda d, s: WAYS["twice"](d, np.sqrt(2) * s),  # all variances doubled
    "nothing told": lambda d, s: filtered(d, s, lambda k, old, new: hardly(as_control(s, old, new, new[0] > 0))),
    "constant-velocity": lambda d, s: filtered(d, s, lambda k, old, new: None, **VELOCITY),
    "split-features": lambda d, s: filtered(d, s, lambda k, old, new: as_control(s, old, new, ~even(new[0])), even),
    "split-features, each pair once": lambda d, s: filtered(
        d, s, lambda k, old, new: as_control(s, old, new, ~even(new[0]) & ((new[0] // 2 + k) % 2 == 0)), even
    ),
    "correlated": shared,
    "correlated, half of it mapped": lambda d, s: shared(d, s, even),
}


def hardly(control):
    """The control, with a covariance so large that it has almost no weight."""
    return Control(control.value, 1e5 * control.covariance)


def run(name, data, std):
    """Errors (steps - 1, 6) and covariances (steps - 1, 6, 6) after the first step."""
    poses, covariances = zip(*WAYS[name](data, std), strict=True)
    errors = [Pose.minus(true, pose) for true, pose in zip(true_path(len(data)), poses, strict=True)]
    return np.array(errors[1:]), np.array(covariances[1:])
