"""Which features belong together: in both directions, along rows, and round the cycle of two pairs. Chapter 21.

And whether two pictures are a rectified pair, the left one first: asked of the pictures themselves.
"""

from dataclasses import dataclass

import numpy as np

from slamlib.errors import SlamlibError
from slamlib.manifolds import Array, Image, Indices, Mask
from slamlib.vision.stereo.detect import StereoSettings, detect

ROWS = 0.1  # of the picture's height: matches are sought so far up and down
ENOUGH = 12  # matches, for a judgement


def hamming_distances(one: Image, other: Image) -> Array:
    """Bits (n, m) in which descriptors (n, 32) and (m, 32) differ.

    With bits as signs, a' b is the number of equal bits less that of different ones: one product of matrices.
    """
    a, b = (np.unpackbits(d, axis=1).astype(np.float32) * 2 - 1 for d in (one, other))
    differ: Array = (a.shape[1] - a @ b.T) / 2
    return differ.astype(float)


def mutual_nearest(cost: Array, *, largest: float, ratio: float = 1.0) -> Indices:
    """Pairs (k, 2) of rows and columns of costs (n, m), each the other's best; inf is not allowed to match.

    A best cost of more than `largest`, or not below `ratio` times the second best of its row or its column, is none.
    """
    if not cost.size:
        return np.zeros((0, 2), dtype=int)
    best = cost.argmin(1)
    rows = np.arange(len(cost))
    back = cost.argmin(0)[best] == rows
    least = cost[rows, best]
    second = np.minimum(_second(cost), _second(cost.T)[best])
    good = back & (least <= largest) & ((least < ratio * second) | (ratio >= 1))
    return np.stack([rows[good], best[good]], axis=1)


def _second(cost: Array) -> Array:
    """Second least cost of each row (n,), inf where there is none."""
    if cost.shape[1] < 2:
        return np.full(len(cost), np.inf)
    least: Array = np.partition(cost, 1, axis=1)[:, 1]
    return least


def row_mask(left: Array, right: Array, rows: float, disparity: tuple[float, float]) -> Mask:
    """Mask (n, m) of the pixels (n, 2) and (m, 2) that may show one point: in one row, with a disparity that may be."""
    apart = np.abs(left[:, None, 1] - right[None, :, 1])
    d = left[:, None, 0] - right[None, :, 0]
    mask = (apart <= rows) & (d >= disparity[0]) & (d <= disparity[1])
    return mask


def circular_matches(lefts: Indices, rights: Indices) -> Indices:
    """Pairs (k, 2) of old and new stereo features that both pictures agree on.

    lefts, rights (., 2): pairs of (old, new) as matched in the left pictures, and in the right ones. A feature of a
    pair is matched from left to right already, so that old left, new left, new right, old right closes the cycle of
    the report's figure 5.1 exactly if both say the same.
    """
    said = set(map(tuple, rights.tolist()))
    rows = [i for i, match in enumerate(map(tuple, lefts.tolist())) if match in said]
    closed: Indices = lefts[rows]
    return closed


@dataclass(frozen=True)
class Survey:
    """Of matches found without regard to rows: how many; median of |v_left - v_right| [px], and the share with a
    disparity of zero or less."""

    matches: int
    rows: float
    negative: float


def check_pair(image: Image, name: str, settings: StereoSettings | None = None) -> Survey:
    """Survey a pair (2, h, w). Raises SlamlibError if left and right are exchanged, or rows do not correspond.

    A pair with too few matches for a judgement passes: it may be dark.
    """
    s = settings or StereoSettings()
    left, right = (detect(picture, s) for picture in image)
    apart = left.pixels[:, None] - right.pixels[None]
    near = (np.abs(apart[..., 1]) <= ROWS * image.shape[1]) & (np.abs(apart[..., 0]) <= s.disparity[1])
    cost = np.where(near, hamming_distances(left.descriptors, right.descriptors), np.inf)
    rows = mutual_nearest(cost, largest=s.distance, ratio=0.75)
    match = apart[rows[:, 0], rows[:, 1]]
    if len(match) < ENOUGH:
        return Survey(len(match), np.nan, np.nan)
    negative = float((match[:, 0] + s.offset <= 0).mean())
    found = Survey(len(match), float(np.median(np.abs(match[:, 1]))), negative)
    if found.negative > 0.5:
        raise SlamlibError(
            f"{name}: {found.negative:.0%} of {found.matches} matches have a negative disparity (the right picture "
            "shows them further right): left and right are exchanged; give --left and --right the other way round"
        )
    if found.rows > s.rows:
        raise SlamlibError(
            f"{name}: the rows of a point in the two pictures differ by {found.rows:.1f} px (median of {found.matches} "
            f"matches), and {s.rows} are allowed: the pair is not rectified. Rectify it with --rectify and a "
            "calibration of both lenses with their places, or give the pictures that are rectified"
        )
    return found
