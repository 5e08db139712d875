"""Models of lenses as calibration tools have them: a table, by the name of each, of where its image of a ray is.

A ray (x, y, z) has the image (a, b) on a plane at distance 1, and so the pixel (u0 + au a, v0 + av b). What a lens
cannot see has no image: nan. Sources: OpenCV's documentation (camera calibration, fisheye); Kannala and Brandt (2006);
Devernay and Faugeras (2001); Mei and Rives (2007); Khomutenko and others (2016); Usenko and others (2018); Fitzgibbon
(2001); COLMAP's camera models.
"""

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from slamlib.manifolds import Array
from slamlib.plain_data.entries import Numbers

Plane = tuple[Array, Array]
RADIAL, FISHEYE, FOV, UNIFIED = "radial-tangential", "equidistant", "fov", "unified"
DOUBLE_SPHERE, EXTENDED, DIVISION, THIN_PRISM = "double-sphere", "extended-unified", "division", "thin-prism-fisheye"


@dataclass(frozen=True)
class LensModel:
    """image(x, y, z, k): the images of rays, arrays alike, by the coefficients k (their number), zeros at the end.

    own(k): slamlib's type of sensor with such a lens and its coefficients, or None if no type can represent the lens.
    limits: of the first coefficients, by their names, least and largest.
    """

    coefficients: int
    image: Callable[[Array, Array, Array, Numbers], Plane]
    own: Callable[[Numbers], tuple[str, Numbers] | None] = field(default=lambda k: None)
    limits: dict[str, tuple[float, float]] = field(default_factory=dict)


def _bent(a: Array, b: Array, k: Numbers) -> Plane:
    """OpenCV's distortion of points of the plane: k1 k2 p1 p2 k3 k4 k5 k6, thin prism s1 to s4, tilt tau_x, tau_y."""
    k1, k2, p1, p2, k3, k4, k5, k6, s1, s2, s3, s4, tau_x, tau_y = (*k, *(0.0,) * (14 - len(k)))
    r2 = a * a + b * b
    radial = (1 + r2 * (k1 + r2 * (k2 + r2 * k3))) / (1 + r2 * (k4 + r2 * (k5 + r2 * k6)))
    bent = (
        a * radial + 2 * p1 * a * b + p2 * (r2 + 2 * a * a) + r2 * (s1 + s2 * r2),
        b * radial + p1 * (r2 + 2 * b * b) + 2 * p2 * a * b + r2 * (s3 + s4 * r2),
    )
    return _tilted(*bent, tau_x, tau_y) if tau_x or tau_y else bent


def _tilted(a: Array, b: Array, tau_x: float, tau_y: float) -> Plane:
    """The image on a sensor that is turned about x, and then about y."""
    (cx, sx), (cy, sy) = ((np.cos(tau), np.sin(tau)) for tau in (tau_x, tau_y))
    turn = np.array([[cy, 0, -sy], [0, 1, 0], [sy, 0, cy]]) @ np.array([[1, 0, 0], [0, cx, sx], [0, -sx, cx]])
    onto = np.array([[turn[2, 2], 0, -turn[0, 2]], [0, turn[2, 2], -turn[1, 2]], [0, 0, 1]]) @ turn
    x, y, z = (row[0] * a + row[1] * b + row[2] for row in onto)
    return x / z, y / z


def _seen(z: Array) -> Array:
    """A denominator: nan where it is not above zero."""
    return np.where(z > 0, z, np.nan)


def _radial_tangential(x: Array, y: Array, z: Array, k: Numbers) -> Plane:
    return _bent(x / _seen(z), y / _seen(z), k)


def _by_angle(x: Array, y: Array, z: Array, k: Numbers) -> tuple[Array, Array, Array]:
    """The direction of the image's point from the centre, its length the angle from the axis, and its square."""
    across = np.hypot(x, y)
    angle = np.arctan2(across, z)
    scale = np.divide(angle, across, out=np.ones_like(angle), where=across > 0)
    return x * scale, y * scale, angle * angle


def _equidistant(x: Array, y: Array, z: Array, k: Numbers) -> Plane:
    a, b, t2 = _by_angle(x, y, z, k)
    k1, k2, k3, k4 = k
    radial = 1 + t2 * (k1 + t2 * (k2 + t2 * (k3 + t2 * k4)))
    return a * radial, b * radial


def _thin_prism(x: Array, y: Array, z: Array, k: Numbers) -> Plane:
    a, b, t2 = _by_angle(x, y, z, k)
    k1, k2, p1, p2, k3, k4, s_x, s_y = k
    radial = 1 + t2 * (k1 + t2 * (k2 + t2 * (k3 + t2 * k4)))
    return (
        a * radial + 2 * p1 * a * b + p2 * (t2 + 2 * a * a) + s_x * t2,
        b * radial + p1 * (t2 + 2 * b * b) + 2 * p2 * a * b + s_y * t2,
    )


def _fov(x: Array, y: Array, z: Array, k: Numbers) -> Plane:
    """The radius is the angle of the ray with a nearer centre, in units of omega; omega = 0 is no distortion."""
    (omega,) = k
    radius = np.hypot(x, y) / _seen(z)
    bent = np.arctan(radius * 2 * np.tan(omega / 2)) / omega if omega else radius
    scale = np.divide(bent, radius, out=np.ones_like(radius), where=radius > 0) / z
    return x * scale, y * scale


def _unified(x: Array, y: Array, z: Array, k: Numbers) -> Plane:
    """Onto the unit sphere, from xi above its centre onto the plane, and distorted there."""
    xi, *bending = k
    depth = _seen(z + xi * np.sqrt(x * x + y * y + z * z))
    return _bent(x / depth, y / depth, tuple(bending))


def _double_sphere(x: Array, y: Array, z: Array, k: Numbers) -> Plane:
    xi, alpha = k
    shifted = z + xi * np.sqrt(x * x + y * y + z * z)
    depth = _seen(alpha * np.sqrt(x * x + y * y + shifted * shifted) + (1 - alpha) * shifted)
    return x / depth, y / depth


def _extended_unified(x: Array, y: Array, z: Array, k: Numbers) -> Plane:
    alpha, beta = k
    depth = _seen(alpha * np.sqrt(beta * (x * x + y * y) + z * z) + (1 - alpha) * z)
    return x / depth, y / depth


def _division(x: Array, y: Array, z: Array, k: Numbers) -> Plane:
    """The inverse of (a, b) / (1 + k (a^2 + b^2)), its branch through the centre."""
    depth = _seen(z) + np.sqrt(z * z - 4 * k[0] * (x * x + y * y))
    return 2 * x / depth, 2 * y / depth


def _own_lens(k: Numbers) -> tuple[str, Numbers] | None:
    """Radial coefficients alone, as most files have, are a pin-hole's; a prism and a tilt are nobody's."""
    k1, k2, p1, p2, k3, *more = (*k, *(0.0,) * (14 - len(k)))
    if any(more[3:]):
        return None
    if any(more):
        return "brownConrady", (k1, k2, p1, p2, k3, *more[:3])
    if p1 or p2:
        return "brownConrady", (k1, k2, p1, p2, k3) if k3 else (k1, k2, p1, p2)
    found: Numbers = (k1, k2, k3)
    while found and not found[-1]:
        found = found[:-1]
    return "pinHole", found


MODELS = {
    RADIAL: LensModel(14, _radial_tangential, _own_lens),
    FISHEYE: LensModel(4, _equidistant, lambda k: ("fisheye", k)),
    FOV: LensModel(1, _fov, limits={"omega": (0, np.pi)}),
    # xi, and then k1 k2 p1 p2 k3; calibrations of wide lenses have found xi of 0.5 to 5
    UNIFIED: LensModel(6, _unified, lambda k: ("unified", k), {"xi": (0, 20)}),
    DOUBLE_SPHERE: LensModel(2, _double_sphere, lambda k: ("doubleSphere", k), {"xi": (-1, 1), "alpha": (0, 1)}),
    EXTENDED: LensModel(2, _extended_unified, lambda k: ("extendedUnified", k), {"alpha": (0, 1), "beta": (0, np.inf)}),
    DIVISION: LensModel(1, _division),
    THIN_PRISM: LensModel(8, _thin_prism),  # k1 k2 p1 p2 k3 k4 s_x s_y
}

# As files call them, in the form in which entries.alike compares; a pin-hole alone says nothing of its distortion.
WORDS = {
    **dict.fromkeys(("radialtangential", "radtan", "radtan5", "plumbbob", "rationalpolynomial", "brown"), RADIAL),
    **dict.fromkeys(("brownconrady", "thinprism", "opencv"), RADIAL),
    **dict.fromkeys(("equidistant", "equi", "fisheye", "kannalabrandt", "kannalabrandt4", "kb4"), FISHEYE),
    **dict.fromkeys(("opencvfisheye", "fisheyeopencv"), FISHEYE),
    **dict.fromkeys(("fov", "atan"), FOV),
    **dict.fromkeys(("unified", "omni", "omnidir", "omnidirectional", "mei", "ucm"), UNIFIED),
    **dict.fromkeys(("doublesphere", "ds"), DOUBLE_SPHERE),
    **dict.fromkeys(("extendedunified", "eucm"), EXTENDED),
    "division": DIVISION,
}
UNDISTORTED = ("none", "pinhole", "perspective", "nodistortion")
