"""Helpers for the tests of rendered rooms."""

import numpy as np

from slamlib.geometry.pose import compose
from slamlib.landmarks.euc_point import EUC_POINT
from slamlib.rig import pose_of
from slamlib.sensors.omni import OMNI
from slamlib.sensors.pinhole import PINHOLE
from slamlib.sensors.sensor import Calibration
from slamlib.simulation import rooms

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
    """Pose (7,) of a camera in a hand, which looks along the hand's x axis; euler [deg]."""
    return compose(pose_of(position, euler, "hand"), LOOKING)


def flat(grey, size=4):
    """A texture of one grey value."""
    return rooms.Texture(np.full((size, size), float(grey)))


def upright(center, width, height, texture, **more):
    """A quad that stands across x, seen by one who looks along x."""
    x, y, z = center
    corner = [x, y + width / 2, z + height / 2]
    return rooms.TexturedQuad(corner, [0, -width, 0], [0, 0, -height], texture, **more)


def pixels_of(calibration, pose, points):
    """Pixels (n, 2) of points (n, 3) of the world."""
    return calibration.project(EUC_POINT.to_frame(pose, np.asarray(points, float)))


def patches(image, pixels, half=6):
    """Bilinear patches (n, 13 * 13) of an image round pixels (n, 2), written independently of slamlib.images."""
    steps = np.arange(-half, half + 1)
    places = pixels[:, None] + np.stack(np.meshgrid(steps, steps), -1).reshape(-1, 2)
    low = np.floor(places).astype(int)
    (x, y), (p, q) = np.moveaxis(low, -1, 0), np.moveaxis(places - low, -1, 0)
    upper, lower = (image[y + i, x] * (1 - p) + image[y + i, x + 1] * p for i in (0, 1))
    return upper * (1 - q) + lower * q


def zncc(one, other):
    """Correlation (n,) of patches (n, k)."""
    a, b = (p - p.mean(1, keepdims=True) for p in (one.astype(float), other.astype(float)))
    return (a * b).sum(1) / np.sqrt((a * a).sum(1) * (b * b).sum(1))


def strong_corners(image, count=200, apart=7, border=10):
    """Shi-Tomasi corners (n, 2): local maxima of the smaller eigenvalue over 7 x 7 windows, the strongest first."""
    down, right = np.gradient(np.asarray(image, float))
    xx, xy, yy = (_sums(p) for p in (right * right, right * down, down * down))
    least = (xx + yy) / 2 - np.sqrt(((xx - yy) / 2) ** 2 + xy**2)
    least[:border], least[-border:], least[:, :border], least[:, -border:] = 0, 0, 0, 0
    found = []
    for _ in range(count):
        v, u = np.unravel_index(np.argmax(least), least.shape)
        if least[v, u] < 300:
            break
        found.append((u, v))
        least[max(0, v - apart) : v + apart + 1, max(0, u - apart) : u + apart + 1] = 0
    return np.array(found, float)


def _sums(values, half=3):
    """Sums over windows, by cumulative sums."""
    size = 2 * half + 1
    total = np.pad(values, half)
    for axis in (0, 1):
        total = np.cumsum(np.pad(total, [(1, 0) if i == axis else (0, 0) for i in (0, 1)]), axis)
        total = np.take(total, np.arange(size, total.shape[axis]), axis) - np.take(
            total, np.arange(total.shape[axis] - size), axis
        )
    return total
