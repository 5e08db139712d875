"""Scaramuzza's two polynomials, as calibrations are published, and their conversion to the omnidirectional camera."""

from dataclasses import dataclass

import numpy as np
from numpy.polynomial import polynomial

from slamlib.analytic import arctan2, sqrt
from slamlib.errors import SlamlibError
from slamlib.manifolds import finite, numbers
from slamlib.models import model
from slamlib.sensors.omni import largest_angle, powers, radius

COEFFICIENTS = 12
MANY, FEW = 9, 6  # coefficients of a lens fitted to an exact inverse, and to a published approximation
SAMPLES = 501


@model(point=4, intrinsics=5, forward=COEFFICIENTS)
def project(point, intrinsics, forward):
    """Pixel of a homogeneous point, as published; not defined on the axis. Eq. (om-forward)."""
    x, y, z, _ = point
    xc, yc, c, d, e = intrinsics
    level, rho = sqrt(x * x + y * y), 0
    elevation = arctan2(z, level)
    for coefficient in forward[::-1]:
        rho = rho * elevation + coefficient
    u, v = x * rho / level, y * rho / level
    return np.array([u + e * v + xc, d * u + c * v + yc])


@model(measurement=2, unmeasured=1, intrinsics=5, backward=COEFFICIENTS)
def back_project(measurement, unmeasured, intrinsics, backward):
    """Homogeneous point of a pixel, as published; no derivative at the centre. Eq. (om-backward)."""
    xc, yc, c, d, e = intrinsics
    x, y = measurement[0] - xc, measurement[1] - yc
    u, v = (c * x - e * y) / (c - d * e), (y - d * x) / (c - d * e)
    r, z = sqrt(u * u + v * v), 0
    for coefficient in backward[::-1]:
        z = z * r + coefficient
    return np.array([*(np.array([u, v, z]) / sqrt(u * u + v * v + z * z)), *unmeasured])


@dataclass(frozen=True)
class Polynomials:
    """A lens of the omnidirectional camera, its inverse polynomial, the field's half angle [rad], and errors.

    errors [px], the largest within the field: "lens", from the polynomial that it was fitted to; "backward", of the
    inverse from the lens; "forward", of the published forward polynomial from the lens, where one was given.
    """

    lens: np.ndarray
    backward: np.ndarray
    angle: float
    errors: dict[str, float]


def polynomials(angle, *, backward=None, forward=None, terms=None, degree=10):
    """The lens of a published calibration, for angles up to `angle` [rad], and the inverse, fitted if not given.

    The lens is fitted to `backward` if that is given, else to `forward`, which seldom passes through zero on
    the axis: then with few `terms`. The inverse has powers up to `degree`. Raises SlamlibError for an invalid lens.
    Chapter omnidirectional, eq. (om-fit).
    """
    if not 0 < angle < np.pi:
        raise SlamlibError(f"the field's half angle should lie between 0 and pi, got {angle}")
    if backward is None and forward is None:
        raise SlamlibError("a published polynomial is needed: backward=[c0, 0, c2, ...] or forward=[a0, a1, ...]")
    field = np.linspace(0, angle, SAMPLES)
    seen, r = (field, _published(forward, field)) if backward is None else _reach(_coefficients(backward), angle)
    if not (np.diff(r) > 0).all():
        raise SlamlibError(f"forward: the radius does not grow all the way to {angle} rad from the axis")
    terms = terms or (FEW if backward is None else MANY)
    lens = _fit(seen, r, powers(terms), np.sqrt(r))  # the root of the radius: every pixel of the image counts the same
    if largest_angle(lens) < angle:
        raise SlamlibError(f"the fitted lens stops growing at {largest_angle(lens):.4f} rad, before {angle}")
    inverse = _inverse(lens, field, degree) if backward is None else _coefficients(backward)
    exact = radius(field, lens)
    errors = {"lens": radius(seen, lens) - r}
    errors["backward"] = radius(np.arctan2(exact, polynomial.polyval(exact, inverse)), lens) - exact
    if forward is not None:
        errors["forward"] = _published(forward, field) - exact
    return Polynomials(lens, inverse, float(angle), {n: float(np.abs(e).max()) for n, e in errors.items()})


def _coefficients(backward):
    c = numbers(backward, "polynomials", "backward")
    c = finite(c, (c.size,), "polynomials", "backward")
    if not (len(c) and c[0] > 0 and not c[1:2].any()):
        raise SlamlibError(
            f"backward: a lens that looks ahead has c0 > 0 and c1 = 0, got {c[:2].tolist()}; where the camera looks "
            "along its negative axis, as in Scaramuzza's toolbox, change the sign of every coefficient"
        )
    return c


def _published(forward, angles):
    a = numbers(forward, "polynomials", "forward")
    return polynomial.polyval(np.pi / 2 - angles, finite(a, (a.size,), "polynomials", "forward"))


def _reach(c, angle):
    """Angles and radii of the back-projecting polynomial, from the axis to `angle`."""
    end = c[0] / 100
    while np.arctan2(end, polynomial.polyval(end, c)) < angle:
        end = end * 1.02
        if end > 1e4 * c[0]:
            raise SlamlibError(f"backward: no radius is seen {angle} rad from the axis; give a smaller angle")
    r = np.linspace(0, end, SAMPLES)
    seen = np.arctan2(r, polynomial.polyval(r, c))
    if not (np.diff(seen) > 0).all():
        raise SlamlibError(f"backward: the angle does not grow all the way to {angle} rad from the axis")
    return seen, r


def _inverse(lens, angles, degree):
    """The back-projecting polynomial with the least-squares error, measured in the image."""
    seen, r = angles[1:], radius(angles[1:], lens)
    pixels = np.gradient(r, seen) * np.sin(seen) ** 2 / r  # of the image, per pixel of z
    chosen = np.array([0, *range(2, degree + 1)])
    inverse = np.zeros(degree + 1)
    inverse[chosen] = _fit(r, r * np.cos(seen) / np.sin(seen), chosen, pixels)
    return inverse


def _fit(x, y, chosen, weights):
    """Coefficients of the `chosen` powers, for the polynomial nearest to y(x)."""
    scale = np.max(x) ** chosen
    design = x[:, None] ** chosen / scale
    return np.linalg.lstsq(design * weights[:, None], y * weights, rcond=None)[0] / scale
