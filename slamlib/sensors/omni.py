"""Omnidirectional camera: a lens of any field of view; its measurement is a pixel, its axes are right, down, front."""

import numpy as np
from numpy.polynomial import polynomial

from slamlib.analytic import arctan_ratio, norm_plus, sqrt, stumpff
from slamlib.errors import SingularPointError, SlamlibError
from slamlib.models import AtMost, model
from slamlib.models.implicit import Implicit
from slamlib.sensors.pinhole import root
from slamlib.sensors.sensor import Sensor
from slamlib.sensors.stages import BackProjection

TERMS = 11


@model(point=4)
def angles(point):
    """Angle from the optical axis [rad] of a homogeneous point, as a vector along the image's axes. Eq. (om-log)."""
    x, y, z, _ = point
    squared = x * x + y * y
    return 2 * arctan_ratio(squared, norm_plus(squared, z)) * point[:2]


@model(angles=2, lens=AtMost(TERMS))
def image(angles, lens):
    """Image of a direction [px] from the image's centre, before the affine part. Eq. (om-lens)."""
    squared, even, odd = angles @ angles, 0, 0
    for coefficient in lens[1::2][::-1]:
        even = (even + coefficient) * squared
    for coefficient in lens[2::2][::-1]:
        odd = (odd + coefficient) * squared
    return angles * (lens[0] + even + odd * sqrt(squared))


@model(angles=2, intrinsics=5, lens=AtMost(TERMS))
def pixel(angles, intrinsics, lens):
    """Pixel of a direction; intrinsics (xc, yc, c, d, e), [px, px, -, -, -]. Eq. (om-pixel)."""
    xc, yc, c, d, e = intrinsics
    u, v = image(angles, lens)
    return np.array([u + e * v + xc, d * u + c * v + yc])


@model(point=4, intrinsics=5, lens=AtMost(TERMS))
def project(point, intrinsics, lens):
    """Pixel of a homogeneous point, whose last number has no effect. Chapter omnidirectional, eq. (om-chain)."""
    return pixel(angles(point), intrinsics, lens)


@model(angles=2, unmeasured=1)
def ray(angles, unmeasured):
    """Homogeneous point (h, w) of a direction: |h| = 1, w inverse distance [1/m]. Eq. (om-exp)."""
    squared = angles @ angles
    return np.array([*(stumpff(1, squared) * angles), stumpff(0, squared), *unmeasured])


def powers(terms):
    """The powers of the angle in a lens with this number of coefficients: 1, 3, 4, 5, ... Eq. (om-lens)."""
    return np.array([1, *range(3, terms + 2)])[:terms]


def radius(angle, lens):
    """Radius in the image (...) [px] of an angle from the axis (...) [rad]. Eq. (om-radius)."""
    return polynomial.polyval(angle, _full(lens))


def _full(lens):
    coefficients = np.zeros(len(lens) + 2)
    coefficients[powers(len(lens))] = lens
    return coefficients


def largest_angle(lens):
    """The angle [rad] at which the radius stops growing, at most pi. Chapter omnidirectional, eq. (om-fold)."""
    roots = polynomial.polyroots(np.trim_zeros(polynomial.polyder(_full(lens)), "b"))
    real = roots.real[(np.abs(roots.imag) <= 1e-7 * np.abs(roots)) & (roots.real > 0)]
    return float(real.min(initial=np.pi))


def angle(radii, lens):
    """The angle (...) [rad] below the largest one whose image has a radius (...) [px]; nan if there is none."""
    coefficients, high = _full(lens), largest_angle(lens)
    slopes, goal = polynomial.polyder(coefficients), np.asarray(radii, dtype=float)
    low, high = np.zeros_like(goal), np.full_like(goal, high)
    lost, x = goal > polynomial.polyval(high, coefficients), np.minimum(goal / lens[0], high)
    found = root(lambda x: (polynomial.polyval(x, coefficients), polynomial.polyval(x, slopes)), goal, x, low, high)
    return np.where(lost, np.nan, found)


def _first_guess(measurement, intrinsics, lens):
    xc, yc, c, d, e = np.moveaxis(intrinsics, -1, 0)
    x, y = measurement[..., 0] - xc, measurement[..., 1] - yc
    plane = np.stack([c * x - e * y, y - d * x], -1) / (c - d * e)[..., None]
    length = np.sqrt((plane**2).sum(-1))
    found = angle(length, lens) if lens.ndim == 1 else np.vectorize(angle, signature="(),(k)->()")(length, lens)
    if np.isnan(found).any():
        lost = np.broadcast_to(measurement, plane.shape)[np.isnan(found)][0]
        raise SingularPointError(f"no ray gives the pixel {lost.tolist()}, beyond the lens's reach; mask such pixels")
    return plane * (found / np.where(length > 0, length, 1))[..., None]


back_project = BackProjection(Implicit("direction", pixel, unknown="angles", start=_first_guess), ray, size=2)


def visible(point, calibration):
    """Mask of the points inside the field of view, by their angle from the axis. Eq. (om-visible)."""
    x, y, z = np.moveaxis(point[..., :3], -1, 0)
    angle = np.arctan2(np.hypot(x, y), z)
    return (angle <= calibration.limits["angle"]) & (angle < np.pi)


def check(calibration):
    """Raise SlamlibError for invalid parameters; the default field of view is the largest possible."""
    intrinsics, lens = calibration.given["intrinsics"], calibration.given["lens"]
    if len(intrinsics) != 5 or not abs(intrinsics[2] - intrinsics[3] * intrinsics[4]) > 1e-6:
        raise SlamlibError(f"omniCam: intrinsics are (xc, yc, c, d, e), c - d e not zero; got {intrinsics.tolist()}")
    if not lens[0] > 0:
        raise SlamlibError(f"omniCam: the lens's first coefficient [px/rad] should be above zero, got {lens[0]}")
    largest = largest_angle(lens)
    calibration.limits.setdefault("angle", largest)
    if not 0 < calibration.limits["angle"] <= largest:
        raise SlamlibError(
            f"omniCam: the lens's radius stops growing at {largest:.4f} rad from the axis, before the field of view "
            f"ends, {calibration.limits['angle']} rad: give a smaller limit 'angle', or calibrate with points out there"
        )


PARAMETERS = ("intrinsics", "lens")
OMNI = Sensor("omniCam", project, back_project, PARAMETERS, visible, check, limits=("angle",), pixels=True)
