"""Image patches, the score that compares them (ZNCC), and its peak. Chapter active_search.

The manual's pix2patch and zncc (section 6.1.2); its other scores are in slambook.patch_maps.
"""

import numpy as np

from slamlib.errors import NonFiniteError, ShapeError, SlamlibError
from slamlib.manifolds import Array, Image, finite, read_only

ROUNDING = 1e-12  # share of the sum of squares that may be rounding: less variation than that is no texture


def grey(image: Image, function: str) -> Array:
    """The image (h, w) as an array of real numbers, not copied; raises ShapeError for colour, SlamlibError."""
    array = np.asarray(image)
    if array.ndim == 3 and array.shape[2] in (2, 3, 4):
        advice = "average its channels, or read it as grey"
        raise ShapeError(f"{function}: the image has {array.shape[2]} channels, shape {array.shape}; {advice}")
    if array.ndim != 2 or not array.size:
        raise ShapeError(f"{function}: a grey image has shape (h, w), got {array.shape}")
    if array.dtype.kind not in "uif":
        raise SlamlibError(f"{function}: an image holds numbers, uint8 or floats, got {array.dtype}")
    return array


def as_floats(piece: Array, function: str) -> Array:
    """A piece of an image as floats; raises NonFiniteError."""
    floats = piece.astype(float)
    if piece.dtype.kind == "f" and not np.isfinite(floats).all():
        raise NonFiniteError(f"{function}: the image holds nan or infinity in the pixels used; fill such pixels")
    return floats


def cut(image: Image, pixel: Array, size: int) -> Array | None:
    """The size x size patch around a pixel (2,), floats, bilinear between pixels; None where the image ends within it.

    Raises SlamlibError for an even size, ShapeError for a colour image.
    """
    array, centre = grey(image, "cut"), finite(pixel, (2,), "cut", "pixel")
    half = half_size(size, "cut")
    (u, v), (a, b) = np.floor(centre).astype(int), centre - np.floor(centre)
    last = np.ceil(centre).astype(int) + half
    if u < half or v < half or last[0] >= array.shape[1] or last[1] >= array.shape[0]:
        return None
    piece = as_floats(array[v - half : last[1] + 1, u - half : last[0] + 1], "cut")
    across = piece[:, :size] if a == 0 else (1 - a) * piece[:, :-1] + a * piece[:, 1:]
    return read_only(across[:size] if b == 0 else (1 - b) * across[:-1] + b * across[1:])


def sample(pixels: Array, places: Array) -> Array:
    """Grey levels (...) at positions (..., 2) [px] of an image (h, w), bilinear between pixels, nan outside of it."""
    array = as_floats(pixels, "sample")
    inside = np.all((places >= 0) & (places <= np.array(array.shape[::-1]) - 1), axis=-1)
    u, v = np.moveaxis(np.where(inside[..., None], places, 0), -1, 0)
    return np.where(inside, bilinear(array, u, v), np.nan)


def bilinear(image: Image, u: Array, v: Array) -> Array:
    """Grey levels (...) at u, v (...) [px] of an image (h, w), between its pixels; outside, its border is repeated."""
    h, w = image.shape
    i, j = np.floor(v).astype(np.intp), np.floor(u).astype(np.intp)
    q, p = v - i, u - j
    below, right = (np.minimum(np.maximum(x + 1, 0), n - 1) for x, n in ((i, h), (j, w)))
    i, j = (np.minimum(np.maximum(x, 0), n - 1) for x, n in ((i, h), (j, w)))
    flat = image.reshape(-1)
    upper: Array = flat[i * w + j] * (1 - p) + flat[i * w + right] * p
    lower = flat[below * w + j] * (1 - p) + flat[below * w + right] * p
    return upper * (1 - q) + lower * q


def half_size(size: int, function: str) -> int:
    """Pixels to either side of a patch's centre; raises SlamlibError for sizes that are not odd, or below 3."""
    if size != int(size) or size < 3 or size % 2 == 0:
        raise SlamlibError(f"{function}: a patch has a pixel in its centre, so its size is odd, such as 11; got {size}")
    return int(size) // 2


def as_pair(a: Array, b: Array, function: str) -> tuple[Array, Array]:
    """Two patches, or stacks (..., h, w) whose leading axes agree, as floats."""
    first, second = (np.asarray(x, dtype=float) for x in (a, b))
    if first.ndim < 2 or first.shape[-2:] != second.shape[-2:]:
        raise ShapeError(f"{function}: patches (..., h, w) of one size, got shapes {first.shape} and {second.shape}")
    return first, second


def centred(patches: Array) -> tuple[Array, Array]:
    """Patches (..., h, w) minus their means, and the sums (...) of the squares; zeros where that is but rounding."""
    deviation = patches - patches.mean((-2, -1), keepdims=True)
    power = (deviation**2).sum((-2, -1))
    textured = power > ROUNDING * (patches**2).sum((-2, -1))
    return deviation * textured[..., None, None], power * textured


def zncc(a: Array, b: Array) -> Array:
    """Zero-mean normalized cross-correlation (...) of patches (..., h, w): in [-1, 1], 0 where one has no texture.

    The cosine between the two patches minus their means: invariant to a positive gain and an offset. Equal to
    (n SIJ - SI SJ) / sqrt((n SII - SI^2) (n SJJ - SJ^2)), without its cancellation. Raises ShapeError.
    """
    (first, power_a), (second, power_b) = (centred(x) for x in as_pair(a, b, "zncc"))
    product, power = (first * second).sum((-2, -1)), np.sqrt(power_a) * np.sqrt(power_b)
    return np.clip(np.where(power > 0, product / np.where(power > 0, power, 1), 0), -1, 1)


# Least squares through the nine values at (u, v) = (-1..1, -1..1), row by row: first and second derivatives.
_U, _V = np.tile([-1.0, 0, 1], 3), np.repeat([-1.0, 0, 1], 3)
_FIT = np.linalg.pinv(np.stack([np.ones(9), _U, _V, _U**2 / 2, _U * _V, _V**2 / 2], axis=1))[1:]


def top(around: Array) -> Array:
    """Maximum (2,) of the paraboloid fitted to 3 x 3 scores, (u, v) [px] from the middle, which is the largest of them.

    With the cross term, which a slanted ridge needs. Where a score is missing (nan), or the maximum does not exist or
    is outside of the nine, the parabolas along u and v.
    """
    if not np.isnan(around).any():
        gu, gv, a, b, c = (_FIT @ around.ravel()).tolist()
        det = a * c - b * b
        if a < 0 and det > 0:
            found = np.array([b * gv - c * gu, b * gu - a * gv]) / det
            if (np.abs(found) <= 1).all():
                return found
    return parabola(*np.stack([around[1], around[:, 1]], axis=1))


def parabola(left: Array, centre: Array, right: Array) -> Array:
    """Abscissas (...) of tops of parabolas through (-1, left), (0, centre), (1, right); 0 if a centre is not above."""
    bend = left - 2 * centre + right
    above = (bend < 0) & (centre >= np.maximum(left, right))
    return np.where(above, (left - right) / np.where(above, 2 * bend, 1), 0)
