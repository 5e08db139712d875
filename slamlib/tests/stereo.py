"""Helpers for the tests of the stereo front end."""

import numpy as np
import pytest
from slambook import kitti_street
from slambook.stereo_films import LENS

from slamlib.geometry.pose import ORIGIN, compose, inverse
from slamlib.landmarks.euc_point import EUC_POINT
from slamlib.sensors.sensor import Calibration
from slamlib.sensors.stereo import STEREO

MOUNT = compose(np.array([0.1, -0.05, 0.2, 1, 0, 0, 0]), np.array([0, 0, 0, 0.5, -0.5, 0.5, -0.5]))


def calibration(std=0.2, image=(320, 240)):
    """Two cameras as those of the room, 12 cm apart; std of each number, or its covariance (3, 3)."""
    noise = np.diag(np.broadcast_to(std, (3,)) ** 2.0) if np.ndim(std) < 2 else std
    return Calibration(STEREO, noise, image=image, intrinsics=LENS["intrinsics"], baseline=[0.12])


def points_seen(rng, count, extrinsics=ORIGIN):
    """Points (n, 3) of the robot's frame, one to five metres in front of a camera of `calibration`."""
    depth = rng.uniform(1.2, 5.0, count)
    rays = np.stack([rng.uniform(-0.45, 0.45, count), rng.uniform(-0.3, 0.3, count), np.ones(count)], axis=1)
    homogeneous = np.concatenate([rays * depth[:, None], np.ones((count, 1))], axis=1)
    return EUC_POINT.to_frame(inverse(extrinsics), homogeneous[:, :3])[:, :3]


def seen_from(points, robot, extrinsics=ORIGIN):
    """Exact measurements (n, 3) of points of the world from a robot's pose (7,)."""
    return calibration(0.2).project(EUC_POINT.to_frame(compose(robot, extrinsics), points))


def kitti(count=51):
    """As slambook.kitti_street.pairs; skips where the street is not at hand."""
    if kitti_street.found() is None:
        pytest.skip("KITTI's street is not at hand")
    return kitti_street.pairs(count)
