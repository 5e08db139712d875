"""Sub-pixel alignment of many patches in an image, vectorized: Gauss-Newton with a gain and an offset."""

import numpy as np

from slamlib.manifolds import Array, Image
from slamlib.vision.patches import bilinear

BOTH = np.eye(2)
ALONG_ROW = np.array([[1.0], [0.0]])
MOST = 0.6  # largest change of a patch's shape


def cut(image: Image, pixels: Array, size: int, shapes: Array | None = None) -> Array:
    """Patches (n, size, size) around pixels (n, 2), bilinear; positions outside the image repeat its border.

    shapes (n, 2, 2): linear maps of the patch's steps (right, down) into the image; None: the identity.
    """
    steps = np.arange(size) - (size - 1) / 2
    right, down = steps[None, None, :], steps[None, :, None]
    u, v = pixels.T[:, :, None, None]
    if shapes is None:
        u, v = u + right, v + down
    else:
        (a, b), (c, d) = shapes.transpose(1, 2, 0)[..., None, None]
        u, v = u + a * right + b * down, v + c * right + d * down
    return bilinear(image, u, v)


def align(
    image: Image, templates: Array, pixels: Array, axes: Array = BOTH, *, free: bool = False, rounds: int = 6
) -> tuple[Array, Array]:
    """Pixels (n, 2) near the given ones where templates (n, s + 2, s + 2) fit best, and correlations (n,) there.

    Each template T, without its margin of one, and the image patch I are normalized in mean and scale; the step d
    along the columns of `axes` (2, k) minimizes |I - T - grad T d|^2, and is subtracted from the pixel (inverse
    compositional, Baker and Matthews, 2004). A patch without structure stays where it was, with correlation 0.

    free: with any linear map of the patch's shape, for another viewing direction, and both axes. With a fixed shape the
    result is biased where the image patch is rotated, stretched or sheared, and the error stays as long as the view
    does; with a free shape it is not. Start near the solution: align with a fixed one before.
    """
    size, n = templates.shape[1] - 2, len(templates)
    right = (templates[:, 1:-1, 2:] - templates[:, 1:-1, :-2]) / 2
    down = (templates[:, 2:, 1:-1] - templates[:, :-2, 1:-1]) / 2
    T, length = _normal(templates[:, 1:-1, 1:-1].reshape(n, size**2))
    G = np.stack([right, down], axis=-1).reshape(*T.shape, 2) / length[:, None, None]
    steps = np.arange(size) - (size - 1) / 2
    x, y = (a.ravel() for a in np.meshgrid(steps, steps))
    by = _inverse(T, np.concatenate([G, G * x[:, None], G * y[:, None]], axis=2) if free else G @ axes)
    place, shape = np.array(pixels, dtype=float), np.tile(np.eye(2), (n, 1, 1)) if free else None
    for _ in range(rounds):
        found, _ = _normal(cut(image, place, size, shape).reshape(n, size**2))
        step = (by @ (found - T)[:, :, None])[:, :, 0]
        if shape is None:
            place = place - np.clip(step @ axes.T, -1, 1)
        else:
            change = np.eye(2) + np.clip(np.stack([step[:, 2:4], step[:, 4:]], axis=2), -0.2, 0.2)
            shape = shape @ np.linalg.inv(change)
            place = place - (shape @ np.clip(step[:, :2, None], -1, 1))[:, :, 0]
    found, _ = _normal(cut(image, place, size, shape).reshape(n, size**2))
    score = (found * T).sum(1)
    plausible = True if shape is None else np.abs(shape - np.eye(2)).max((1, 2), initial=0) < MOST
    return place, np.where(plausible, score, 0.0)


def _inverse(T: Array, J: Array) -> Array:
    """(J' J)^-1 J' (n, q, k), with the components along offset and gain of T (n, k) removed from J (n, k, q)."""
    J = J - J.mean(1, keepdims=True)
    J = J - T[:, :, None] * (T[:, None, :] @ J)
    transposed = J.swapaxes(1, 2)
    return np.linalg.inv(transposed @ J + 1e-9 * np.eye(J.shape[2])) @ transposed


def _normal(patches: Array) -> tuple[Array, Array]:
    """Rows (n, k) without their means and of length one, and the lengths (n,); of flat ones, zeros."""
    centred = patches - patches.mean(1, keepdims=True)
    length = np.sqrt((centred * centred).sum(1))
    safe = np.where(length > 1e-6, length, np.inf)
    return centred / safe[:, None], np.where(length > 1e-6, length, 1.0)
