"""Ellipses of Gaussian uncertainty."""

from typing import Any

import numpy as np

from slamlib.errors import ShapeError, SlamlibError
from slamlib.evaluation import chi2_quantile
from slamlib.spaces import Array


def ellipse(
    mean: Array, covariance: Array, *, probability: float | None = None, sigmas: float | None = None, points: int = 73
) -> Array:
    """Outline (2, points) of the ellipse that holds a share `probability` of a Gaussian in the plane, or of k sigmas.

    mean (2,), covariance (2, 2). The default is the 95 % ellipse. A line (singular covariance) is drawn as one.
    """
    mean, covariance = np.asarray(mean, dtype=float), np.asarray(covariance, dtype=float)
    if mean.shape != (2,) or covariance.shape != (2, 2):
        raise ShapeError(f"ellipse: mean (2,) and covariance (2, 2) expected, got {mean.shape} and {covariance.shape}")
    if probability is not None and sigmas is not None:
        raise SlamlibError("ellipse: give a probability or a number of sigmas, not both")
    radius = sigmas if sigmas is not None else np.sqrt(chi2_quantile(probability or 0.95, 2))
    values, vectors = np.linalg.eigh(covariance)
    angle = np.linspace(0, 2 * np.pi, points)
    circle = np.array([np.cos(angle), np.sin(angle)])
    return mean[:, None] + radius * vectors @ (np.sqrt(np.maximum(values, 0))[:, None] * circle)


def draw_ellipse(ax: Any, mean: Array, covariance: Array, **style: Any) -> None:
    """Draw the outline; `probability` or `sigmas` as for ellipse, the rest as for matplotlib's plot."""
    size = {k: style.pop(k) for k in ("probability", "sigmas") if k in style}
    ax.plot(*ellipse(mean, covariance, **size), **style)
