"""What is drawn, before and after it is projected: polylines, marks and words, each of one role."""

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from slamlib.manifolds import Array


@dataclass(frozen=True, eq=False)
class Layer:
    """Things in space of one role [m].

    lines (N, 3): polylines with a row of nan between; marks (M, 3); words at places (W, 3); ellipsoids: their means
    (K, 3) and their shapes (K, 3, 3), as covariances whose ellipsoid of one sigma is drawn.
    """

    role: str
    lines: Array = field(default_factory=lambda: np.zeros((0, 3)))
    marks: Array = field(default_factory=lambda: np.zeros((0, 3)))
    means: Array = field(default_factory=lambda: np.zeros((0, 3)))
    shapes: Array = field(default_factory=lambda: np.zeros((0, 3, 3)))
    places: Array = field(default_factory=lambda: np.zeros((0, 3)))
    words: tuple[str, ...] = ()


@dataclass(frozen=True, eq=False)
class Flat:
    """The same on the sheet: lines and shells (N, 2) with rows of nan, marks (M, 2), words at places (W, 2).

    Shells are the outlines of uncertainty, which are drawn more thinly than the things themselves.
    """

    role: str
    lines: Array = field(default_factory=lambda: np.zeros((0, 2)))
    shells: Array = field(default_factory=lambda: np.zeros((0, 2)))
    marks: Array = field(default_factory=lambda: np.zeros((0, 2)))
    places: Array = field(default_factory=lambda: np.zeros((0, 2)))
    words: tuple[str, ...] = ()


def strung(polylines: Iterable[Array], size: int) -> Array:
    """Polylines (n, size) as one array with a row of nan after each."""
    gap = np.full((1, size), np.nan)
    parts = [part for line in polylines for part in (np.asarray(line, dtype=float), gap)]
    return np.concatenate(parts[:-1]) if parts else np.zeros((0, size))


def lower(covariance: Array) -> Array:
    """The entries, row by row, of a lower triangular factor of a covariance, which may be singular."""
    values, vectors = np.linalg.eigh(covariance)
    upper: Any = np.linalg.qr((vectors * np.sqrt(values.clip(0))).T, mode="r")
    upper = np.where(np.diag(upper) < 0, -1.0, 1.0)[:, None] * upper  # signs that do not depend on the library
    return upper.T[np.tril_indices(len(covariance))]
