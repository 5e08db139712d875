"""What the toolbox's manual has for patches and slamlib.vision has not: zoom and roll, ssd, census (section 6.1.2)."""

import numpy as np

from slamlib.manifolds import Array
from slamlib.vision.patches import as_pair


def similarity(zoom: float, roll: float) -> Array:
    """The map (3, 3) of a patch that is seen `zoom` times larger and rotated by `roll` [rad]."""
    c, s = np.cos(roll) / zoom, np.sin(roll) / zoom
    return np.array([[c, s, 0], [-s, c, 0], [0, 0, 1.0]])


def ssd(a: Array, b: Array) -> Array:
    """Root of the mean squared difference (...) of patches (..., h, w), in grey levels: 0 for equal ones.

    The name is that of the sum of squared differences, whose order it keeps; the toolbox's has the same scale.
    """
    first, second = as_pair(a, b, "ssd")
    return np.sqrt(((first - second) ** 2).mean((-2, -1)))


def census(a: Array, b: Array) -> Array:
    """Share (...) of the pixels of patches (..., h, w) that are brighter than the centre in both, or in none.

    1 for equal patches; invariant to monotonically increasing changes of the grey levels. Zabih and Woodfill (1994).
    """
    first, second = as_pair(a, b, "census")
    brighter = [x > x[..., x.shape[-2] // 2, None, x.shape[-1] // 2, None] for x in (first, second)]
    return (brighter[0] == brighter[1]).mean((-2, -1))
