"""Lines on the paper, in points: cut at the edge of what is seen, thinned, and written as SVG path data."""

from collections.abc import Iterable
from typing import Any

import numpy as np

from slamlib.manifolds import Array

THIN = 0.05  # points: how far a thinned line may be from the vertices that it leaves out
CELL = 0.1  # points: successive vertices in one cell of this size are drawn as one
Box = tuple[float, float, float, float]  # left, top, right, bottom


def written(hundredths: int) -> str:
    """A length in hundredths of a point as the shortest decimal number."""
    whole, rest = divmod(abs(hundredths), 100)
    digits = f"{whole or ''}.{rest:02d}".rstrip("0") if rest else f"{whole}"
    return "-" + digits if hundredths < 0 else digits


def number(value: float) -> str:
    """A number to a hundredth, the same on every machine: ties are decided after the noise of the last bits is gone."""
    return written(int(hundredths(float(value))))


def hundredths(points: Any) -> Any:
    """Points as whole hundredths."""
    return np.floor(np.round(points * 100, 4) + 0.5).astype(np.int64)


def settled(points: Array) -> Array:
    """Points (2, N) to a hundredth: what is decided by comparing them is then decided alike on every machine."""
    return hundredths(points) / 100.0


def joined(numbers: Iterable[int]) -> str:
    """Numbers in hundredths, separated by as little as a path needs."""
    text = " ".join(map(written, numbers))
    return text.replace(" -", "-")


def polyline(points: Array, closed: bool = False) -> str:
    """Path data of a line through the points (2, N): an absolute start, then steps."""
    whole = hundredths(points)
    if closed and whole.shape[1] > 2 and np.array_equal(whole[:, 0], whole[:, -1]):
        whole = whole[:, :-1]
    if whole.shape[1] < 2:
        return ""
    steps = np.diff(whole, axis=1)
    steps = steps[:, np.any(steps != 0, axis=0)].T.ravel().tolist()
    return f"M{joined(whole[:, 0].tolist())}l{joined(steps or [0, 0])}{'z' if closed else ''}"


def dots(points: Array) -> str:
    """Path data of points (2, N): lines of no length, which round ends make visible; a repeated place once."""
    whole = hundredths(points)
    if not whole.shape[1]:
        return ""
    steps = np.diff(whole, axis=1)
    steps = steps[:, np.any(steps != 0, axis=0)].T.tolist()
    return f"M{joined(whole[:, 0].tolist())}h0" + "".join(f"m{joined(step)}h0" for step in steps)


def pieces(points: Array) -> list[Array]:
    """The runs of finite points of (k, N): a nan breaks a line."""
    good = np.all(np.isfinite(points), axis=0)
    edges = np.flatnonzero(np.diff(np.concatenate([[False], good, [False]]).astype(int)))
    return [points[:, a:b] for a, b in zip(edges[::2], edges[1::2], strict=True)]


def cut_line(points: Array, box: Box) -> list[Array]:
    """The parts of a line (2, N) that lie in the box; far vertices are replaced by points on its edge."""
    low, high = np.reshape(box[:2], (2, 1)), np.reshape(box[2:], (2, 1))
    if np.all((points >= low) & (points <= high)):
        return [points]
    start, step = points[:, :-1], np.diff(points, axis=1)
    flat = step == 0
    safe = np.where(flat, 1.0, step)
    enter, leave = (low - start) / safe, (high - start) / safe
    outside = flat & ((start < low) | (start > high))
    first = np.where(flat, 0.0, np.minimum(enter, leave)).max(axis=0).clip(0)
    last = np.where(flat, 1.0, np.maximum(enter, leave)).min(axis=0).clip(None, 1)
    seen = (first <= last) & ~outside.any(axis=0)
    found: list[list[Array]] = []
    for i in np.flatnonzero(seen):
        a, b = start[:, i] + first[i] * step[:, i], start[:, i] + last[i] * step[:, i]
        if first[i] > 0 or not found or not seen[i - 1] or last[i - 1] < 1:
            found.append([a])
        found[-1].append(b if last[i] < 1 else points[:, i + 1])
    return [np.array(part).T for part in found]


def cut_area(points: Array, box: Box) -> Array:
    """The polygon (2, N) cut at the box, one edge after the other (Sutherland and Hodgman)."""
    for axis, bound, sign in ((0, box[0], 1), (0, box[2], -1), (1, box[1], 1), (1, box[3], -1)):
        inside = sign * (points[axis] - bound)
        if points.shape[1] == 0 or np.all(inside >= 0):
            continue
        after = np.roll(points, -1, axis=1)
        next_inside = np.roll(inside, -1)
        crosses = (inside >= 0) != (next_inside >= 0)
        share = np.where(crosses, inside / np.where(crosses, inside - next_inside, 1.0), 0.0)
        both = np.stack([points, points + share * (after - points)], axis=2).reshape(2, -1)
        points = both[:, np.stack([inside >= 0, crosses], axis=1).ravel()]
    return points


def thinned(points: Array) -> Array:
    """The line (2, N) without vertices that nobody can see: it moves by less than 0.2 points."""
    if points.shape[1] < 3:
        return points
    cells = np.floor(points / CELL)
    keep = np.concatenate([[True], np.any(np.diff(cells, axis=1) != 0, axis=0)])
    keep[-1] = True
    points = points[:, keep]
    count = points.shape[1]
    keep = np.zeros(count, dtype=bool)
    keep[[0, -1]] = True
    while True:  # Douglas and Peucker, all stretches between the kept vertices at once
        kept = np.flatnonzero(keep)
        stretch = np.minimum(np.cumsum(keep) - 1, len(kept) - 2)
        squared = _from_segments(points, points[:, kept[stretch]], points[:, kept[stretch + 1]])
        farthest = np.maximum.reduceat(squared, kept[:-1])
        split = (squared == farthest[stretch]) & (squared > THIN**2) & ~keep
        if not split.any():
            return points[:, keep]
        keep |= split


def _from_segments(points: Array, start: Array, end: Array) -> Array:
    """Squared distances (N,) of points (2, N) from the segments between start and end (2, N)."""
    along = end - start
    length = np.sum(along**2, axis=0)
    share = np.clip(np.sum(along * (points - start), axis=0) / np.where(length > 0, length, 1.0), 0, 1)
    return np.sum((points - start - along * share) ** 2, axis=0)


def outline(points: Array, box: Box | None, closed: bool) -> str:
    """Path data of a line (2, N) with gaps, or of the areas that it encloses, as far as the box shows it."""
    parts: list[str] = []
    for piece in pieces(points):
        if closed:
            inside = cut_area(piece, box) if box else piece
            parts.append(polyline(thinned(settled(inside)), closed=True))
            continue
        for part in cut_line(piece, box) if box else [piece]:
            ring = part.shape[1] > 3 and np.array_equal(part[:, 0], part[:, -1])
            parts.append(polyline(thinned(settled(part)), closed=bool(ring)))
    return "".join(parts)
