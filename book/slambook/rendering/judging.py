"""Patches, correlation and corners of images, written independently of slamlib.vision: they judge what is rendered."""

import numpy as np

from slamlib.manifolds import Array, Image


def patches(image: Image, pixels: Array, half: int = 6) -> Array:
    """Bilinear patches (n, 13 * 13) of an image round pixels (n, 2)."""
    steps = np.arange(-half, half + 1)
    places = pixels[:, None] + np.stack(np.meshgrid(steps, steps), -1).reshape(-1, 2)
    low = np.floor(places).astype(int)
    (x, y), (p, q) = np.moveaxis(low, -1, 0), np.moveaxis(places - low, -1, 0)
    upper, lower = (image[y + i, x] * (1 - p) + image[y + i, x + 1] * p for i in (0, 1))
    return upper * (1 - q) + lower * q


def zncc(one: Array, other: Array) -> Array:
    """Correlation (n,) of patches (n, k)."""
    a, b = (p - p.mean(1, keepdims=True) for p in (one.astype(float), other.astype(float)))
    return (a * b).sum(1) / np.sqrt((a * a).sum(1) * (b * b).sum(1))


def strong_corners(image: Image, count: int = 200, apart: int = 7, border: int = 10) -> Array:
    """Shi-Tomasi corners (n, 2): local maxima of the smaller eigenvalue over 7 x 7 windows, the strongest first."""
    down, right = np.gradient(np.asarray(image, float))
    xx, xy, yy = (_sums(p) for p in (right * right, right * down, down * down))
    least = (xx + yy) / 2 - np.sqrt(((xx - yy) / 2) ** 2 + xy**2)
    least[:border], least[-border:], least[:, :border], least[:, -border:] = 0, 0, 0, 0
    found = []
    for _ in range(count):
        v, u = np.unravel_index(np.argmax(least), least.shape)
        if least[v, u] < 300:
            break
        found.append((u, v))
        least[max(0, v - apart) : v + apart + 1, max(0, u - apart) : u + apart + 1] = 0
    return np.array(found, float)


def _sums(values: Array, half: int = 3) -> Array:
    """Sums over windows, by cumulative sums."""
    size = 2 * half + 1
    total = np.pad(values, half)
    for axis in (0, 1):
        total = np.cumsum(np.pad(total, [(1, 0) if i == axis else (0, 0) for i in (0, 1)]), axis)
        total = np.take(total, np.arange(size, total.shape[axis]), axis) - np.take(
            total, np.arange(total.shape[axis] - size), axis
        )
    return total
