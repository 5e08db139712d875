"""Which features belong together: in both directions, along rows, and round the cycle of two pairs. Chapter 21."""

import numpy as np

from slamlib.manifolds import Array, Image, Indices, Mask


def distances(one: Image, other: Image) -> Array:
    """Bits (n, m) in which descriptors (n, 32) and (m, 32) differ.

    With bits as signs, a' b is the number of equal bits less that of different ones: one product of matrices.
    """
    a, b = (np.unpackbits(d, axis=1).astype(np.float32) * 2 - 1 for d in (one, other))
    differ: Array = (a.shape[1] - a @ b.T) / 2
    return differ.astype(float)


def mutual(cost: Array, *, largest: float, ratio: float = 1.0) -> Indices:
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


def along_rows(left: Array, right: Array, rows: float, disparity: tuple[float, float]) -> Mask:
    """Mask (n, m) of the pixels (n, 2) and (m, 2) that may show one point: in one row, with a disparity that may be."""
    apart = np.abs(left[:, None, 1] - right[None, :, 1])
    d = left[:, None, 0] - right[None, :, 0]
    mask = (apart <= rows) & (d >= disparity[0]) & (d <= disparity[1])
    return mask


def circular(lefts: Indices, rights: Indices) -> Indices:
    """Pairs (k, 2) of old and new stereo features that both pictures agree on.

    lefts, rights (., 2): pairs of (old, new) as matched in the left pictures, and in the right ones. A feature of a
    pair is matched from left to right already, so that old left, new left, new right, old right closes the cycle of
    the report's figure 5.1 exactly if both say the same.
    """
    said = set(map(tuple, rights.tolist()))
    rows = [i for i, match in enumerate(map(tuple, lefts.tolist())) if match in said]
    closed: Indices = lefts[rows]
    return closed
