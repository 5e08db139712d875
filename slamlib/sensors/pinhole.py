"""The pin-hole camera with radial distortion: measures a pixel (u, v); axes right, down, front."""

from functools import lru_cache

import numpy as np

from slamlib.analytic import sqrt
from slamlib.errors import SingularPointError, SlamlibError
from slamlib.models import AtMost, model
from slamlib.models.implicit import Implicit
from slamlib.sensors.sensor import Sensor
from slamlib.sensors.stages import BackProjection


@model(ideal=2, distortion=AtMost(8))
def distort(ideal, distortion):
    """Distort an ideal point of the plane z = 1. Chapter pinhole, eq. (ph-distort)."""
    squared, stretch = ideal @ ideal, 0
    for coefficient in distortion[::-1]:
        stretch = (stretch + coefficient) * squared
    return ideal + ideal * stretch


@model(ideal=2, intrinsics=4, distortion=AtMost(8))
def pixel(ideal, intrinsics, distortion):
    """Pixel of an ideal point; intrinsics (u0, v0, au, av) [px]. Chapter pinhole, eq. (ph-pixel)."""
    return intrinsics[:2] + intrinsics[2:] * distort(ideal, distortion)


@model(point=4, intrinsics=4, distortion=AtMost(8))
def project(point, intrinsics, distortion):
    """Pixel of a homogeneous point (h, w), whose w has no effect. Chapter pinhole, eq. (ph-chain)."""
    return pixel(point[:2] / point[2], intrinsics, distortion)


@model(ideal=2, unmeasured=1)
def ray(ideal, unmeasured):
    """Unit ray and inverse distance [1/m] behind an ideal point. Chapter pinhole, eq. (ph-ray)."""
    length = sqrt(1 + ideal @ ideal)
    return np.concatenate([ideal / length, np.array([1 / length]), unmeasured])


@model(line=6, intrinsics=4)
def project_line(line, intrinsics):
    """Image line (3,) of a line (n, v), without distortion. Chapter pinhole, eq. (ph-line)."""
    (a, b, c), (u0, v0, au, av) = line[:3], intrinsics
    return np.array([av * a, au * b, au * av * c - av * u0 * a - au * v0 * b])


def _stretch(radius, coefficients):
    total = 0 * radius
    for coefficient in np.moveaxis(coefficients, -1, 0)[::-1]:
        total = (total + coefficient) * radius**2
    return total


def _slopes(distortion):
    return distortion * np.arange(3, 3 + 2 * distortion.shape[-1], 2)


def distort_radius(radius, distortion):
    """Radius (...) in the distorted plane of one in the ideal plane. Chapter pinhole, eq. (ph-radius)."""
    radius = np.asarray(radius, dtype=float)
    return radius * (1 + _stretch(radius, np.asarray(distortion, dtype=float)))


@lru_cache
def _fold(slopes):
    inverse_squares = np.roots([1, *slopes])
    real = np.abs(inverse_squares.imag) <= 1e-7 * np.abs(inverse_squares)
    largest = inverse_squares.real[real].max(initial=0)
    return 1 / np.sqrt(largest) if largest > 0 else np.inf


def fold_radius(distortion):
    """Ideal radius (...) where distortion (..., n) folds back, or inf. Chapter pinhole, eq. (ph-fold)."""
    slopes = _slopes(np.asarray(distortion, dtype=float))
    folds = np.empty(slopes.shape[:-1])
    for item in np.ndindex(folds.shape):
        folds[item] = _fold(tuple(slopes[item].tolist()))
    return folds


def root(function, goal, x, low, high):
    """Solve function(x) = goal, for an increasing function and its slope, by bounded Newton steps from x."""
    for _ in range(100):
        value, slope = function(x)
        excess = value - goal
        low, high = np.where(excess < 0, x, low), np.where(excess > 0, x, high)
        newton = x - excess / np.where(slope > 0, slope, 1)
        short = (slope > 0) & (np.abs(newton - x) <= (high - low) / 2)
        before, x = x, np.where(short, newton, (low + high) / 2)
        if (np.abs(x - before) <= 1e-15 * x).all():
            break
    return x


def undistort_radius(radius, distortion):
    """Ideal radius (...) below the fold of a distorted one, nan if there is none. Eq. (ph-newton)."""
    goal, distortion = np.asarray(radius, dtype=float), np.asarray(distortion, dtype=float)
    slopes, fold = _slopes(distortion), fold_radius(distortion) + 0 * goal
    low, high = 0 * goal, np.where(np.isinf(fold), 1, fold)
    while (short := np.isinf(fold) & (distort_radius(high, distortion) < goal)).any():
        high = np.where(short, 2 * high, high)
    lost, x = goal > distort_radius(high, distortion), np.minimum(goal, high)
    found = root(lambda x: (distort_radius(x, distortion), 1 + _stretch(x, slopes)), goal, x, low, high)
    return np.where(lost, np.nan, found)


def _first_guess(measurement, intrinsics, distortion):
    distorted = (measurement - intrinsics[..., :2]) / intrinsics[..., 2:]
    radius = np.sqrt((distorted**2).sum(-1))
    found = undistort_radius(radius, distortion)
    if np.isnan(found).any():
        lost = np.broadcast_to(measurement, (*found.shape, 2))[np.isnan(found)][0]
        where = f"no ray gives the pixel {lost.tolist()}: it lies beyond the fold of the distortion"
        raise SingularPointError(f"{where}; mask such pixels")
    return distorted * (found / np.where(radius > 0, radius, 1))[..., None]


ideal_point = Implicit("ideal_point", pixel, unknown="ideal", start=_first_guess)
back_project = BackProjection(ideal_point, ray, size=2)


@lru_cache
def _limit(calibration):
    fold = float(fold_radius(calibration.given["distortion"]))
    return min(fold, calibration.limits.get("radius", np.inf))


def visible(point, calibration):
    """Mask of the points in front, below the fold, and below limits["radius"] if it is given."""
    x, y, z = (point[..., i] for i in range(3))
    ahead = z > 0
    return ahead & (np.sqrt(x**2 + y**2) < _limit(calibration) * np.where(ahead, z, 1))


def check(calibration):
    """Raise SlamlibError for invalid intrinsics, and for an image that the lens cannot fill."""
    k, distortion = calibration.given["intrinsics"], calibration.given["distortion"]
    if len(k) != 4 or not (k[2:] > 0).all():
        wanted = "intrinsics are (u0, v0, au, av) with au, av > 0"
        raise SlamlibError(f"pinHole: {wanted}, got {k.tolist()}")
    fold = float(fold_radius(distortion))
    if calibration.image is None or fold == np.inf or "radius" in calibration.limits:
        return
    corner = np.maximum(np.abs(k[:2]), np.abs(calibration.image - k[:2])) / k[2:]
    farthest, reached = np.hypot(*corner), float(distort_radius(fold, distortion))
    if farthest > reached:
        raise SlamlibError(
            f"pinHole: the distortion folds back at {np.degrees(np.arctan(fold)):.1f} degrees off "
            f"the axis, inside the image: a corner is at radius {farthest:.3g}, and nothing comes "
            f"out beyond {reached:.3g}. Calibrate with points near the border, or say how far the "
            "calibration holds, as the tangent of an angle: limits={'radius': ...}"
        )


PARAMETERS = ("intrinsics", "distortion")
MODELS = project, back_project
PINHOLE = Sensor("pinHole", *MODELS, PARAMETERS, visible, check, project_line, limits=("radius",), pixels=True)
