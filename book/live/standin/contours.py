"""Where a function on a grid passes a level: marching squares on the whole grid at once."""

import numpy as np

from slamlib.manifolds import Array, Indices

# Corners of a cell, counter-clockwise: 0 (row, column), 1 (row, column + 1), 2 (row + 1, column + 1), 3 (row + 1,
# column); edge k leads from corner k to corner k + 1. For each set of corners that are inside (a sum of 2**corner):
# from which edge to which the boundary runs, the inside on its left.
_WAYS: dict[int, tuple[tuple[int, int], ...]] = {
    1: ((0, 3),),
    2: ((1, 0),),
    3: ((1, 3),),
    4: ((2, 1),),
    5: ((0, 3), (2, 1)),
    6: ((2, 0),),
    7: ((2, 3),),
    8: ((3, 2),),
    9: ((0, 2),),
    10: ((1, 0), (3, 2)),
    11: ((1, 2),),
    12: ((3, 1),),
    13: ((0, 1),),
    14: ((3, 0),),
}
_JOINED = {5: ((0, 1), (2, 3)), 10: ((1, 2), (3, 0))}  # saddles whose middle is inside


def contour_lines(x: Array, y: Array, values: Array, level: float) -> list[Array]:
    """Lines (2, N) along which values (rows, columns) equal the level; those that close end where they begin.

    x and y are the grid's coordinates, (rows, columns) each; values above the level lie on the left. nan is below.
    """
    values = np.where(np.isnan(values), -np.inf, values)
    start, end = _steps(values, level)
    following = dict(zip(start.tolist(), end.tolist(), strict=True))
    reached = set(end.tolist())
    firsts = [e for e in following if e not in reached] + list(following)  # open lines from their start
    lines = []
    for first in firsts:
        edges = [first]
        while edges[-1] in following:
            edges.append(following.pop(edges[-1]))
        if len(edges) > 1:
            lines.append(_crossings(np.array(edges), x, y, values, level))
    return lines


def regions(x: Array, y: Array, values: Array, level: float) -> list[Array]:
    """Rings (2, N) around all where values >= level; a ring within a ring is a hole. Arguments as for contour_lines."""
    values = np.pad(np.where(np.isnan(values), -np.inf, values), 1, constant_values=-np.inf)
    return contour_lines(np.pad(x, 1, mode="edge"), np.pad(y, 1, mode="edge"), values, level)


def _steps(values: Array, level: float) -> tuple[Indices, Indices]:
    """For each piece of boundary, the edges of the grid that it enters and leaves by."""
    inside = values >= level
    corners = inside[:-1, :-1], inside[:-1, 1:], inside[1:, 1:], inside[1:, :-1]
    kind = sum(2**k * corner.astype(int) for k, corner in enumerate(corners))
    with np.errstate(invalid="ignore"):
        middle = (values[:-1, :-1] + values[:-1, 1:] + values[1:, 1:] + values[1:, :-1]) / 4 >= level
    starts, ends = [np.empty(0, int)], [np.empty(0, int)]
    for number, ways in _WAYS.items():
        for chosen, turns in ((~middle, ways), (middle, _JOINED.get(number, ways))):
            row, column = np.nonzero((kind == number) & chosen)
            edges = _edges(row, column, inside.shape[1])
            for a, b in turns:
                starts.append(edges[a])
                ends.append(edges[b])
    return np.concatenate(starts), np.concatenate(ends)


def _edges(row: Indices, column: Indices, columns: int) -> tuple[Indices, ...]:
    """Numbers of a cell's four edges: twice the index of the edge's first corner, one more for those along a column."""
    corner = row * columns + column
    return 2 * corner, 2 * (corner + 1) + 1, 2 * (corner + columns), 2 * corner + 1


def _crossings(edges: Indices, x: Array, y: Array, values: Array, level: float) -> Array:
    """The points (2, N) on the grid's edges where the level is reached, by linear interpolation."""
    a = edges // 2
    b = a + np.where(edges % 2, values.shape[1], 1)
    flat = values.ravel()
    low, high = flat[a], flat[b]
    whole = np.isfinite(low) & np.isfinite(high)
    with np.errstate(invalid="ignore", divide="ignore"):
        share = np.where(whole, (level - low) / np.where(whole, high - low, 1.0), np.isfinite(high))
    return np.stack([c.ravel()[a] + share * (c.ravel()[b] - c.ravel()[a]) for c in (x, y)])
