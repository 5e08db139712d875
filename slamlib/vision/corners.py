"""Corner detection: the structure tensor, and the best corner of a rectangle. Chapter active_search.

A patch with gradients g (2,), observed again with noise, is matched with the least-squares covariance sigma^2 S^-1,
S = sum of g g'. Its larger axis is sigma^2 over S's smaller eigenvalue, which is therefore the quality of a corner
(Shi and Tomasi, 1994, who derive it from tracking), in grey levels^2 per pixel^2.
"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from slamlib.errors import ShapeError
from slamlib.manifolds import Array, Image, read_only
from slamlib.vision.patches import as_floats, grey, top

# With noise of two grey levels in both images a match of this quality has a standard deviation of 0.1 px in its worst
# direction, 2 sigma^2 / 0.1^2. On photographs (benchmarks/images.py), from this quality on 98 % or more of all searches
# find the right position, and no wrong match is accepted; with noise of four grey levels, 95 % at half the quality,
# 64 % at a tenth.
QUALITY = 800.0
EDGE = 20.0


def _bell(width: float, reach: float) -> tuple[Array, Array]:
    """A Gaussian of peak 1, up to `reach` widths [px], and where its values are."""
    x = np.arange(-np.ceil(reach * width), np.ceil(reach * width) + 1)
    return np.exp(-(x**2) / (2 * width**2)), x


_SMOOTH, _OFFSETS = _bell(1.0, 4.0)  # before a gradient is taken
_SLOPE = _OFFSETS * _SMOOTH
_SMOOTH, _SLOPE = _SMOOTH / _SMOOTH.sum(), _SLOPE / (_SLOPE * _OFFSETS).sum()
# The weights are 1 in the middle and less around it, over the 11 pixels of a patch: so S is a lower bound of the
# patch's own sum, and sigma^2 S^-1 an upper bound of its covariance.
_WINDOW, _ = _bell(2.0, 2.5)
SUPPORT = len(_SMOOTH) // 2 + len(_WINDOW) // 2  # pixels that the structure tensor needs on every side


@dataclass(frozen=True, eq=False)
class Corner:
    """A pixel (2,), and its quality: the smaller eigenvalue of the structure tensor there."""

    pixel: Array
    quality: float


def structure_tensor(image: Image) -> Array:
    """Sums (3, h - 2 SUPPORT, w - 2 SUPPORT) of gu gu, gu gv, gv gv around the pixels whose support is in the image.

    In (grey level / px)^2, of gradients g of the smoothed image (h, w). Raises ShapeError, SlamlibError.
    """
    pixels = as_floats(grey(image, "structure_tensor"), "structure_tensor")
    if min(pixels.shape) <= 2 * SUPPORT:
        raise ShapeError(f"structure_tensor: an image has more than {2 * SUPPORT} px a side, got {pixels.shape}")
    gu, gv = _filtered(pixels, _SMOOTH, _SLOPE), _filtered(pixels, _SLOPE, _SMOOTH)
    return _filtered(np.stack([gu * gu, gu * gv, gv * gv]), _WINDOW, _WINDOW)


def eigenvalues(tensor: Array) -> tuple[Array, Array]:
    """The smaller and the larger eigenvalue (...) of the symmetric matrices [[a, b], [b, c]], given as (3, ...)."""
    a, b, c = tensor
    middle, radius = (a + c) / 2, np.hypot((a - c) / 2, b)
    return np.maximum(middle - radius, 0), middle + radius


def strength(image: Image) -> Array:
    """Quality (h, w) of every pixel of an image: the smaller eigenvalue, 0 where the image ends within its support."""
    smaller, _ = eigenvalues(structure_tensor(image))
    return np.pad(smaller, SUPPORT)


def best_corner(
    image: Image, rectangle: tuple[int, int, int, int], quality: float = QUALITY, edge: float = EDGE, border: int = 0
) -> Corner | None:
    """The best corner among the pixels image[v0:v1, u0:u1] of a rectangle (u0, v0, u1, v1), to a fraction of a pixel.

    It is a local maximum of the strength, at least of this quality, its larger eigenvalue not above `edge` times the
    smaller (on an edge a patch slides), `border` pixels or more from the image's border. None where there is none. Its
    sub-pixel part need not be exact: the landmark is whatever is observed at this pixel.
    """
    array, margin = grey(image, "best_corner"), SUPPORT + 1
    u0, v0, u1, v1 = rectangle
    keep = max(border, margin)
    u0, v0 = max(u0, keep), max(v0, keep)
    u1, v1 = min(u1, array.shape[1] - keep), min(v1, array.shape[0] - keep)
    if u0 >= u1 or v0 >= v1:
        return None
    smaller, larger = eigenvalues(structure_tensor(array[v0 - margin : v1 + margin, u0 - margin : u1 + margin]))
    inner = smaller[1:-1, 1:-1]
    highest = np.maximum(np.maximum(smaller[:-2], smaller[1:-1]), smaller[2:])
    highest = np.maximum(np.maximum(highest[:, :-2], highest[:, 1:-1]), highest[:, 2:])
    good = (inner >= highest) & (inner >= max(quality, np.finfo(float).tiny)) & (larger[1:-1, 1:-1] <= edge * inner)
    if not good.any():
        return None
    row, column = divmod(int(np.argmax(np.where(good, inner, -1))), inner.shape[1])
    pixel = np.array([u0 + column, v0 + row]) + top(smaller[row : row + 3, column : column + 3])
    return Corner(pixel, float(inner[row, column]))


def _filtered(stack: Array, down: Array, across: Array) -> Array:
    """Images (..., h, w) correlated with a column and with a row of weights, where these lie within the image."""
    by_rows, by_columns = _banded(tuple(down), stack.shape[-2]), _banded(tuple(across), stack.shape[-1])
    return by_rows @ stack @ by_columns.T


@lru_cache(maxsize=64)  # the cells of a grid have a few sizes, which come again in every image
def _banded(weights: tuple[float, ...], length: int) -> Array:
    """The matrix (length - n + 1, length) of a filter with n weights: for pieces of an image, BLAS is the quickest."""
    padded = np.zeros(2 * length - len(weights))
    padded[length - len(weights) : length] = weights
    rows = np.lib.stride_tricks.sliding_window_view(padded, length)[::-1]
    return read_only(np.ascontiguousarray(rows))  # BLAS wants a copy
