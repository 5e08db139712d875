"""Small drawings in space: a frame, an ellipsoid."""

from typing import Any

import numpy as np

from slamlib.drawing.colors import colors
from slamlib.drawing.gaussians import radius_of
from slamlib.linalg import covariance as positive
from slamlib.linalg import finite
from slamlib.spaces import Array

AXES = (("x", colors.red), ("y", colors.green), ("z", colors.blue))


def draw_axes3d(ax: Any, pose: Array, *, size: float = 1.0, label: str = "", **style: Any) -> None:
    """The axes of a frame, red x, green y and blue z with their letters, and its name at the origin.

    pose (7,): position [m] and unit quaternion, x y z | w x y z, of the frame in the world. size [m].
    """
    from slamlib.geometry.quaternion import rotation

    pose = finite(pose, (7,), "draw_axes3d", "pose")
    origin = pose[:3]
    for column, (letter, color) in zip(rotation(pose[3:]).T, AXES, strict=True):
        tip = origin + size * column
        ax.plot(*np.stack([origin, tip], axis=1), color=color, **style)
        ax.text(*(origin + 1.15 * size * column), letter, color=color, ha="center", va="center")
    if label:
        ax.text(*(origin - 0.2 * size * rotation(pose[3:]).sum(-1)), label, ha="center", va="center")


def draw_ellipsoid(
    ax: Any,
    mean: Array,
    covariance: Array,
    *,
    probability: float | None = None,
    sigmas: float | None = None,
    **style: Any,
) -> None:
    """The three principal ellipses of the ellipsoid that holds a share `probability` of a Gaussian, or of k sigmas.

    mean (3,), covariance (3, 3); the default is the 95 % ellipsoid. The rest as for plot; `label` names it once.
    Raises ShapeError, NonFiniteError, CovarianceError.
    """
    mean = finite(mean, (3,), "draw_ellipsoid", "mean")
    covariance = finite(covariance, (3, 3), "draw_ellipsoid", "covariance")
    values, vectors = np.linalg.eigh(positive(covariance, 3, "draw_ellipsoid", "covariance"))
    half_axes = radius_of("draw_ellipsoid", 3, probability, sigmas) * vectors * np.sqrt(np.maximum(values, 0))
    turn = np.linspace(0, 2 * np.pi, 73)
    color = style.pop("color", colors.blue)
    for one, other in ((0, 1), (1, 2), (2, 0)):
        ring = mean[:, None] + half_axes[:, [one, other]] @ np.array([np.cos(turn), np.sin(turn)])
        ax.plot(*ring, color=color, **{"lw": 1.2, **style})
        style.pop("label", None)
