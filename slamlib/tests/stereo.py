"""Helpers for the tests of the stereo front end."""

from pathlib import Path

import numpy as np
import pytest

from slamlib.geometry.pose import compose, inverse
from slamlib.images.pictures import read_image
from slamlib.images.stereo import joined, pair, paired
from slamlib.images.stereo.geometry import ORIGIN
from slamlib.landmarks.euc_point import EUC_POINT
from slamlib.sensors.sensor import Calibration
from slamlib.sensors.stereo import STEREO
from slamlib.simulation import rooms
from slamlib.trajectories import read_trajectory

KITTI = Path(__file__).resolve().parents[3] / "shared" / "data" / "stereo_kitti_a"
LENS = {"intrinsics": (159.5, 119.5, 260.0, 260.0), "distortion": (0.0,)}
MOUNT = compose(np.array([0.1, -0.05, 0.2, 1, 0, 0, 0]), np.array([0, 0, 0, 0.5, -0.5, 0.5, -0.5]))


def calibration(std=0.2, image=(320, 240)):
    """Two cameras as those of the room, 12 cm apart; std of each number, or its covariance (3, 3)."""
    noise = np.diag(np.broadcast_to(std, (3,)) ** 2.0) if np.ndim(std) < 2 else std
    return Calibration(STEREO, noise, image=image, intrinsics=LENS["intrinsics"], baseline=[0.12])


def points_seen(rng, count, mount=ORIGIN):
    """Points (n, 3) of the robot's frame, one to five metres in front of a camera of `calibration`."""
    depth = rng.uniform(1.2, 5.0, count)
    rays = np.stack([rng.uniform(-0.45, 0.45, count), rng.uniform(-0.3, 0.3, count), np.ones(count)], axis=1)
    homogeneous = np.concatenate([rays * depth[:, None], np.ones((count, 1))], axis=1)
    return EUC_POINT.to_frame(inverse(mount), homogeneous[:, :3])[:, :3]


def seen_from(points, robot, mount=ORIGIN):
    """Exact measurements (n, 3) of points of the world from a robot's pose (7,)."""
    return calibration(0.2).project(EUC_POINT.to_frame(compose(robot, mount), points))


def stereo_film(frames, path="sideways", seed=1, std=0.1):
    """The rig with its one stereo sensor, frames with pairs and truths, and the film; seed: of textures and noise."""
    way = rooms.path(path)
    rig = rooms.hand_held(way, baseline=0.12, image=(320.0, 240.0), parameters=LENS)
    made = rooms.film(rooms.default_room(seed=seed), rig, way, frames=frames, rng=np.random.default_rng(seed))
    return joined(rig, std if np.ndim(std) else (std,) * 3), [(paired(frame), truth) for frame, truth in made], made


def kitti(count=51):
    """Calibration, pairs and true trajectory of a KITTI excerpt; skips where it is not at hand."""
    if not KITTI.is_dir():
        pytest.skip("the KITTI excerpt stereo_kitti_a is not at hand")
    lens = np.loadtxt(KITTI / "calib.txt")
    f, u, v, b = lens[0, 0], lens[0, 2], lens[0, 6], -lens[1, 3] / lens[1, 0]
    made = Calibration(STEREO, 0.2**2 * np.eye(3), image=(1226, 370), intrinsics=[u, v, f, f], baseline=[b])
    names = [f"{i:06d}.png" for i in range(count)]
    pairs = [pair(read_image(KITTI / "image_l" / n), read_image(KITTI / "image_r" / n)) for n in names]
    truth = read_trajectory(KITTI / "poses.txt", times=0.1 * np.arange(51))
    return made, pairs, truth[np.arange(count)]
