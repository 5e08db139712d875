"""Helpers for the tests of rendered rooms."""

import numpy as np
from slambook import rendering

from slamlib.geometry.pose import compose
from slamlib.landmarks.euc_point import EUC_POINT
from slamlib.rigs.setup import pose_of
from slamlib.sensors.omni import OMNI
from slamlib.sensors.pinhole import PINHOLE
from slamlib.sensors.sensor import Calibration

LOOKING = pose_of((0, 0, 0), (-90.0, 0.0, -90.0), "a camera that looks along x")
FISHEYE = {"intrinsics": [80, 60, 1, 0, 0], "lens": [48.0, 2.0]}  # 1.2 rad at 60 px: the image's corners see nothing


def pinhole(image=(160, 120), distortion=(-0.1, 0.01)):
    """A camera of 64 degrees."""
    u, v = image
    middle = [(u - 1) / 2, (v - 1) / 2]
    return Calibration(
        PINHOLE, np.eye(2), image=image, intrinsics=[*middle, 0.8 * u, 0.8 * u], distortion=list(distortion)
    )


def fisheye(limits=None):
    """A camera of 140 degrees, whose picture is a disc within its image."""
    return Calibration(OMNI, np.eye(2), image=(160, 120), limits=limits or {"angle": 1.2}, **FISHEYE)


def camera(position, euler=(0.0, 0.0, 0.0)):
    """Pose (7,) of a hand-held camera whose optical axis is the hand's x axis; euler [deg]."""
    return compose(pose_of(position, euler, "hand"), LOOKING)


def flat(grey, size=4):
    """A texture of one grey value."""
    return rendering.Texture(np.full((size, size), float(grey)))


def upright(center, width, height, texture, **more):
    """A quad perpendicular to x, as seen by a camera facing along x."""
    x, y, z = center
    corner = [x, y + width / 2, z + height / 2]
    return rendering.TexturedQuad(corner, [0, -width, 0], [0, 0, -height], texture, **more)


def pixels_of(calibration, pose, points):
    """Pixels (n, 2) of points (n, 3) of the world."""
    return calibration.project(EUC_POINT.to_frame(pose, np.asarray(points, float)))
