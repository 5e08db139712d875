"""Small drawings in the plane: robots, frames, and Gaussians as ellipses. `ax` is matplotlib's, or one like it."""

from typing import Any

import numpy as np

from slambook.figures.colors import colors
from slamlib.errors import SlamlibError
from slamlib.kalman.chi_square import chi2_quantile
from slamlib.kalman.linalg import covariance as positive
from slamlib.manifolds import Array, finite


def ellipse(
    mean: Array, covariance: Array, *, probability: float | None = None, sigmas: float | None = None, points: int = 73
) -> Array:
    """Outline (2, points) of the ellipse that holds a share `probability` of a Gaussian in the plane, or of k sigmas.

    mean (2,), covariance (2, 2). The default is the 95 % ellipse. A line (singular covariance) is drawn as one.
    Raises SlamlibError, ShapeError, NonFiniteError, CovarianceError.
    """
    mean, covariance = finite(mean, (2,), "ellipse", "mean"), finite(covariance, (2, 2), "ellipse", "covariance")
    covariance = positive(covariance, 2, "ellipse", "covariance")
    if probability is not None and sigmas is not None:
        raise SlamlibError("ellipse: give a probability or a number of sigmas, not both")
    share = 0.95 if probability is None else probability
    radius = float(np.sqrt(chi2_quantile(share, 2)) if sigmas is None else sigmas)
    values, vectors = np.linalg.eigh(covariance)
    angle = np.linspace(0, 2 * np.pi, points)
    circle = np.array([np.cos(angle), np.sin(angle)])
    return mean[:, None] + radius * vectors @ (np.sqrt(np.maximum(values, 0))[:, None] * circle)


def draw_ellipse(ax: Any, mean: Array, covariance: Array, **style: Any) -> None:
    """Draw the outline; `probability` or `sigmas` as for ellipse, the rest as for plot.

    color: as for plot; without it the next of `colors.CYCLE`. The ellipses of maps have those of `scene.roles`.
    """
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
        ax.text(x + 1.3 * dx, y + 1.3 * dy, letter, color=color, ha="center", va="center")
    if label:
        ax.text(*(np.array([x, y]) - 0.25 * axes.sum(-1)), label, ha="center", va="center")
