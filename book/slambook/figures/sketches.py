"""Small drawings, in the plane and in space: robots, frames, maps, and Gaussians as ellipses and ellipsoids."""

from typing import Any

import numpy as np

from slambook.figures.colors import colors
from slamlib.errors import SlamlibError
from slamlib.evaluation.consistency import chi2_quantile
from slamlib.kalman.linalg import covariance as positive
from slamlib.kalman.linalg import finite
from slamlib.manifolds import Array

AXES = (("x", colors.red), ("y", colors.green), ("z", colors.blue))


def ellipse(
    mean: Array, covariance: Array, *, probability: float | None = None, sigmas: float | None = None, points: int = 73
) -> Array:
    """Outline (2, points) of the ellipse that holds a share `probability` of a Gaussian in the plane, or of k sigmas.

    mean (2,), covariance (2, 2). The default is the 95 % ellipse. A line (singular covariance) is drawn as one.
    Raises ShapeError, NonFiniteError, CovarianceError.
    """
    mean, covariance = finite(mean, (2,), "ellipse", "mean"), finite(covariance, (2, 2), "ellipse", "covariance")
    covariance = positive(covariance, 2, "ellipse", "covariance")
    radius = radius_of("ellipse", 2, probability, sigmas)
    values, vectors = np.linalg.eigh(covariance)
    angle = np.linspace(0, 2 * np.pi, points)
    circle = np.array([np.cos(angle), np.sin(angle)])
    return mean[:, None] + radius * vectors @ (np.sqrt(np.maximum(values, 0))[:, None] * circle)


def radius_of(function: str, dimensions: int, probability: float | None, sigmas: float | None) -> float:
    """How many sigmas away the boundary is that holds a share of a Gaussian, 95 % by default; raises SlamlibError."""
    if probability is not None and sigmas is not None:
        raise SlamlibError(f"{function}: give a probability or a number of sigmas, not both")
    share = 0.95 if probability is None else probability
    return float(np.sqrt(chi2_quantile(share, dimensions)) if sigmas is None else sigmas)


def draw_ellipse(ax: Any, mean: Array, covariance: Array, **style: Any) -> None:
    """Draw the outline; `probability` or `sigmas` as for ellipse, the rest as for plot."""
    size = {k: style.pop(k) for k in ("probability", "sigmas") if k in style}
    ax.plot(*ellipse(mean, covariance, **size), **style)


def draw_robot(ax: Any, pose: Array, *, size: float = 0.4, color: str = colors.blue, **style: Any) -> None:
    """A triangle at the pose (x, y, heading) [m, rad] that points along the heading."""
    x, y, heading = pose
    corners = size * np.array([[1.0, 0.0], [-0.6, 0.55], [-0.6, -0.55], [1.0, 0.0]])
    turn = np.array([[np.cos(heading), -np.sin(heading)], [np.sin(heading), np.cos(heading)]])
    ax.plot(*(turn @ corners.T + np.array([[x], [y]])), color=color, **style)


def draw_frame(ax: Any, pose: Array, *, size: float = 1.0, label: str = "", **style: Any) -> None:
    """The axes of a frame in the plane, red x and green y, with its name; pose (x, y, heading) [m, rad], size [m]."""
    x, y, heading = pose
    axes = size * np.array([[np.cos(heading), -np.sin(heading)], [np.sin(heading), np.cos(heading)]])
    for (dx, dy), color, letter in zip(axes.T, (colors.red, colors.green), "xy", strict=True):
        ax.plot([x, x + dx], [y, y + dy], color=color, **style)
        ax.text(x + 1.15 * dx, y + 1.15 * dy, letter, color=color, ha="center", va="center")
    if label:
        ax.text(*(np.array([x, y]) - 0.25 * axes.sum(-1)), label, ha="center", va="center")


def draw_map(
    ax: Any,
    landmarks: Array,
    covariances: Array | None = None,
    *,
    truth: Array | None = None,
    path: Array | None = None,
    pose: Array | None = None,
    pose_covariance: Array | None = None,
    color: str = colors.blue,
) -> None:
    """What a filter believes of the plane, with its 95 % ellipses, over what is true.

    landmarks (N, 2) and covariances (N, 2, 2); truth (M, 2): crosses; path (T, 2): where the robot went;
    pose (x, y, heading) and the covariance (2, 2) or (3, 3) of its first numbers. Metres and radians.
    """
    if truth is not None:
        ax.plot(*np.asarray(truth).T, ls="", marker="+", ms=8, color=colors.grey, label="true landmarks")
    if path is not None:
        ax.plot(*np.asarray(path)[:, :2].T, color=colors.grey, lw=1.2, label="true path")
    landmarks = np.asarray(landmarks, dtype=float).reshape(-1, 2)
    ax.plot(*landmarks.T, ls="", marker=".", color=color)
    for mean, covariance in zip(landmarks, [] if covariances is None else covariances, strict=covariances is not None):
        draw_ellipse(ax, mean, covariance, color=color, lw=1.2)
    if pose is not None:
        draw_robot(ax, pose, color=color)
        if pose_covariance is not None:
            draw_ellipse(ax, pose[:2], np.asarray(pose_covariance)[:2, :2], color=color, lw=1.2)


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
