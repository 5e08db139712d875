"""The pin-hole camera with a lens in OpenCV's model: tangential and rational distortion; axes right, down, front."""

from functools import lru_cache

import numpy as np
from numpy.polynomial import Polynomial

from slamlib.errors import SingularPointError, SlamlibError
from slamlib.models import AtMost, model
from slamlib.models.implicit import Implicit
from slamlib.sensors.pinhole import project_line, ray
from slamlib.sensors.sensor import Sensor
from slamlib.sensors.stages import BackProjection


@model(ideal=2, distortion=AtMost(8))
def distort(ideal, distortion):
    """Distort an ideal point by k1 k2 p1 p2 k3 k4 k5 k6, OpenCV's order. Chapter pinhole, eq. (ph-brown)."""
    k1, k2, p1, p2, k3, k4, k5, k6 = distortion
    squared, lean = ideal @ ideal, np.array([p2, p1])
    over = 1 + (k1 + (k2 + k3 * squared) * squared) * squared
    under = 1 + (k4 + (k5 + k6 * squared) * squared) * squared
    return (over / under + 2 * (lean @ ideal)) * ideal + squared * lean


@model(ideal=2, intrinsics=4, distortion=AtMost(8))
def pixel(ideal, intrinsics, distortion):
    """Pixel of an ideal point; intrinsics (u0, v0, au, av) [px]. Chapter pinhole, eq. (ph-pixel)."""
    return intrinsics[:2] + intrinsics[2:] * distort(ideal, distortion)


@model(point=4, intrinsics=4, distortion=AtMost(8))
def project(point, intrinsics, distortion):
    """Pixel of a homogeneous point (h, w), whose w has no effect. Chapter pinhole, eq. (ph-chain)."""
    return pixel(point[:2] / point[2], intrinsics, distortion)


@lru_cache
def _fold(k1=0.0, k2=0.0, p1=0.0, p2=0.0, k3=0.0, k4=0.0, k5=0.0, k6=0.0):
    over, under = Polynomial([1, 0, k1, 0, k2, 0, k3]), Polynomial([1, 0, k4, 0, k5, 0, k6])
    radius = Polynomial([0, 1])
    lean = 6 * np.hypot(p1, p2) * radius * under
    slope = over * under + radius * (over.deriv() * under - over * under.deriv())
    inverses = np.concatenate([np.roots(each.coef) for each in (under, over - lean, slope - lean * under)])
    real = np.abs(inverses.imag) <= 1e-7 * np.abs(inverses)
    largest = inverses.real[real].max(initial=0)
    return 1 / largest if largest > 0 else np.inf


def fold_radius(distortion):
    """Ideal radius (...) up to which distortion (..., n) is one-to-one, or inf. Eq. (ph-brown-fold)."""
    distortion = np.asarray(distortion, dtype=float)
    folds = np.empty(distortion.shape[:-1])
    for item in np.ndindex(folds.shape):
        folds[item] = _fold(*distortion[item].tolist())
    return folds


def undistort(distorted, distortion):
    """Ideal points (..., 2) below the fold of distorted ones, nan where there is none. Eq. (ph-brown-newton)."""
    goal, distortion = np.asarray(distorted, dtype=float), np.asarray(distortion, dtype=float)
    fold = fold_radius(distortion)
    x = np.zeros(np.broadcast_shapes(goal.shape, (*fold.shape, 2)))
    close = 1e-14 * (1 + _length(goal))
    for _ in range(100):
        value, jacobians = distort.jac(x, distortion)
        error, before = goal - value, x
        step, open_ones = _newton(jacobians.ideal, error), _length(error) > close
        for _ in range(40):
            if not open_ones.any():
                break
            trial = before + step
            inside = _length(trial) < fold
            trial = np.where(inside[..., None], trial, before)
            better = open_ones & inside & (_length(goal - distort(trial, distortion)) < _length(error))
            x, open_ones, step = np.where(better[..., None], trial, x), open_ones & ~better, step / 2
        if (x == before).all():
            break
    return np.where((_length(error) > 1e5 * close)[..., None], np.nan, x)


def _length(vectors):
    return np.hypot(vectors[..., 0], vectors[..., 1])


def _newton(jacobian, error):
    (a, b), (c, d) = np.moveaxis(jacobian, (-2, -1), (0, 1))
    x, y = error[..., 0], error[..., 1]
    return np.stack([d * x - b * y, a * y - c * x], -1) / (a * d - b * c)[..., None]


def _first_guess(measurement, intrinsics, distortion):
    found = undistort((measurement - intrinsics[..., :2]) / intrinsics[..., 2:], distortion)
    lost = np.isnan(found[..., 0])
    if lost.any():
        first = np.broadcast_to(measurement, found.shape)[lost][0]
        where = f"no ray gives the pixel {first.tolist()}: it lies beyond the fold of the distortion"
        raise SingularPointError(f"{where}; mask such pixels")
    return found


ideal_point = Implicit("ideal_point", pixel, unknown="ideal", start=_first_guess)
back_project = BackProjection(ideal_point, ray, size=2)


def visible(point, calibration):
    """Mask of the points in front, below the fold, and below limits["radius"] if it is given."""
    x, y, z = (point[..., i] for i in range(3))
    ahead = z > 0
    return ahead & (np.sqrt(x**2 + y**2) < calibration.limits["radius"] * np.where(ahead, z, 1))


def check(calibration):
    """Raise SlamlibError for invalid parameters, and for an image that the lens cannot fill; the limit is the fold."""
    k, distortion = calibration.given["intrinsics"], calibration.given["distortion"]
    if len(k) != 4 or not (k[2:] > 0).all():
        raise SlamlibError(f"brownConrady: intrinsics are (u0, v0, au, av) with au, av > 0, got {k.tolist()}")
    if len(distortion) not in (4, 5, 8):
        raise SlamlibError(
            "brownConrady: distortion is k1 k2 p1 p2, then k3, then k4 k5 k6, in OpenCV's order: 4, 5 or 8 numbers, "
            f"got {len(distortion)}; a lens with radial coefficients alone is a pinHole"
        )
    fold, is_fenced = float(fold_radius(distortion)), "radius" in calibration.limits
    calibration.limits["radius"] = min(fold, calibration.limits.get("radius", np.inf))
    if calibration.image is None or is_fenced:
        return
    side = np.linspace(0, 1, 17)
    pixels = np.stack(np.meshgrid(side, side), -1) * calibration.image
    lost = np.isnan(undistort((pixels - k[:2]) / k[2:], distortion)).any(-1)
    if lost.any():
        raise SlamlibError(
            f"brownConrady: the distortion folds back at {np.degrees(np.arctan(fold)):.1f} degrees off "
            f"the axis, inside the image: no ray gives the pixel {pixels[lost][0].tolist()}. Calibrate with points "
            "near the border, or say how far the calibration holds, as the tangent of an angle: limits={'radius': ...}"
        )


PARAMETERS = ("intrinsics", "distortion")
MODELS = project, back_project
BROWN = Sensor("brownConrady", *MODELS, PARAMETERS, visible, check, project_line, limits=("radius",), pixels=True)
