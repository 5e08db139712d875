"""Search for a template in the ellipse of its prediction, all pixels at once. Chapter active_search, steps 2d to 2g.

The manual scans the rectangle of +-3 sigma. The ellipse z' S^-1 z <= limit is what the filter's gate would accept:
for two numbers with correlation r, the share pi / 4 sqrt(1 - r^2) of the rectangle around it.
"""

from dataclasses import dataclass

import numpy as np

from slamlib.errors import CovarianceError, SlamlibError
from slamlib.manifolds import Array, Image, Indices, Mask, finite
from slamlib.slam.data_association.gates import gate
from slamlib.vision.patches import ROUNDING, as_floats, centred, cut, grey, top


@dataclass(frozen=True, eq=False)
class Match:
    """A match of a template: pixel (2,), its ZNCC there, and the best ZNCC elsewhere in the ellipse.

    The score is that of the nearest whole pixel. second is -1 if the ellipse is within the best one's neighbourhood.
    """

    pixel: Array
    score: float
    second: float

    @property
    def ratio(self) -> float:
        """Score of the second-best by that of the best, 0 to 1: near 1 the match is ambiguous."""
        return max(self.second, 0.0) / self.score if self.score > 0 else 1.0


@dataclass(frozen=True, eq=False)
class Scores:
    """ZNCC at the pixels of a rectangle, values (rows, columns), and the mask `inside` of those that may be chosen.

    `corner` (u, v) is the pixel [0, 0]. The other pixels surround them, for sub-pixel positions.
    """

    corner: tuple[int, int]
    values: Array
    inside: Array

    def best(self, neighbourhood: int) -> Match:
        """The highest score inside, sub-pixel; the second-best is more than `neighbourhood` pixels away."""
        allowed, width = np.where(self.inside, self.values, -2.0), neighbourhood
        row, column = divmod(int(allowed.argmax()), allowed.shape[1])
        score = float(allowed[row, column])
        allowed[max(row - width, 0) : row + width + 1, max(column - width, 0) : column + width + 1] = -2
        pixel = np.array([column, row]) + self.corner + top(self._around(row, column))
        return Match(pixel, score, max(float(allowed.max()), -1.0))

    def _around(self, row: int, column: int) -> Array:
        """The 3 x 3 values around a pixel, nan beyond the rectangle."""
        above, left = max(row - 1, 0), max(column - 1, 0)
        known = self.values[above : row + 2, left : column + 2]
        around = np.full((3, 3), np.nan)
        down, across = above - row + 1, left - column + 1
        around[down : down + known.shape[0], across : across + known.shape[1]] = known
        return around


def search(image: Image, template: Array, centre: Array, S: Array, probability: float = 0.99) -> Match | None:
    """The best match of a template (h, w), odd sizes, predicted at `centre` (2,) with covariance S (2, 2) [px^2].

    Searched: the pixels nearest to positions with z' S^-1 z below the chi-square quantile of `probability`, with their
    whole window in the image; None if there is none. Raises ShapeError, CovarianceError, SlamlibError.
    """
    scores = score_map(image, template, centre, S, probability)
    return None if scores is None else scores.best(max(template.shape) // 2)


def score_map(image: Image, template: Array, centre: Array, S: Array, probability: float = 0.99) -> Scores | None:
    """All the scores that `search` chooses from."""
    array, patch = grey(image, "search"), as_floats(grey(template, "search"), "search")
    if patch.shape[0] % 2 == 0 or patch.shape[1] % 2 == 0:
        raise SlamlibError(f"search: a template has a pixel in its centre, odd sizes; got {patch.shape}")
    region = ellipse(array.shape, patch.shape, centre, S, gate(probability, 2))
    if region is None:
        return None
    (u, v), mask = region
    half_v, half_u = (n // 2 for n in patch.shape)
    # One pixel more on every side, where the image has it: the best pixel needs its neighbours.
    left, above = min(u - half_u, 1), min(v - half_v, 1)
    right = min(array.shape[1] - u - mask.shape[1] - half_u, 1)
    below = min(array.shape[0] - v - mask.shape[0] - half_v, 1)
    inside = np.zeros((above + mask.shape[0] + below, left + mask.shape[1] + right), bool)
    inside[above : above + mask.shape[0], left : left + mask.shape[1]] = mask
    u, v, (rows, columns) = u - left, v - above, inside.shape
    piece = array[v - half_v : v + rows + half_v, u - half_u : u + columns + half_u]
    return Scores((u, v), correlate(as_floats(piece, "search"), patch), inside)


def register(image: Image, template: Array, start: Array, steps: int = 10) -> Array | None:
    """The pixel (2,) where a template, of odd size, fits best: Gauss-Newton steps from a match's pixel.

    Least squares, gain * template(x + d) + bias = image(pixel + x): errors are 1.5 to 2 times smaller than those of a
    correlation's paraboloid (benchmarks/images.py). None where it moves by more than a pixel, or leaves the image.
    """
    patch, start = as_floats(grey(template, "register"), "register"), finite(start, (2,), "register", "start")
    down, across = np.gradient(patch)
    columns = [x.ravel() for x in (across, down, centred(patch)[0], np.ones(patch.shape))]
    inverse, pixel = np.linalg.pinv(np.stack(columns, axis=1)), start.copy()
    for _ in range(steps):
        seen = cut(image, pixel, len(patch))
        if seen is None:
            return None
        u, v, gain, _ = inverse @ seen.ravel()
        if gain <= 0:
            return None
        step = np.array([u, v]) / gain
        pixel -= step
        if np.abs(pixel - start).max() > 1:
            return None
        if np.abs(step).max() < 0.005:
            break
    return pixel


def ellipse(
    image: tuple[int, ...], size: tuple[int, ...], centre: Array, S: Array, limit: float
) -> tuple[tuple[int, int], Mask] | None:
    """The pixels nearest to positions with z' S^-1 z <= limit, if their window `size` (h, w) is in the image (h, w).

    As the pixel (u, v) of the upper left corner, and a mask (rows, columns) from there; None if there is none. An
    ellipse between four pixels contains those nearest to it. Raises CovarianceError where S is not positive definite.
    """
    (x, y), S, limit = finite(centre, (2,), "search", "centre"), finite(S, (2, 2), "search", "S"), min(limit, 1e18)
    (a, b), (_, c) = S.tolist()
    if not (a * c - b * b > 0 and a > 0 and abs(b - S[1, 0]) <= 1e-9 * np.sqrt(a * c)):
        raise CovarianceError(f"search: S should be symmetric and positive definite, got {S.tolist()}")
    down = np.sqrt(limit * c)
    v0, v1 = _whole(y - down, y + down, size[0] // 2, image[0])
    if v1 < v0:
        return None
    rows = np.arange(int(v0), int(v1) + 1) - y
    # A row's pixels extend half a pixel up and down: the height in this range where the ellipse is widest counts.
    widest, low, high = b * np.sqrt(limit / a), np.maximum(rows - 0.5, -down), np.minimum(rows + 0.5, down)
    right = _end(np.clip(widest, low, high), b / c, limit, c, a - b * b / c)
    left = -_end(-np.clip(-widest, low, high), b / c, limit, c, a - b * b / c)
    first, last = _whole(x + left, x + right, size[1] // 2, image[1])
    u0, u1 = int(first.min()), int(last.max())
    columns = np.arange(u0, u1 + 1)
    mask = (columns >= first[:, None]) & (columns <= last[:, None])
    return ((u0, int(v0)), mask) if mask.any() else None


def _end(y: Array, lean: float, limit: float, c: float, rest: float) -> Array:
    """Right end of the ellipse at heights y: the conditional mean, and the remainder of the limit."""
    return lean * y + np.sqrt(np.maximum(limit - y * y / c, 0) * rest)


def _whole(low: Array, high: Array, half: int, length: int) -> tuple[Indices, Indices]:
    """First and last of the pixels nearest to positions from low to high, `half` pixels from the image borders."""
    first, last = np.maximum(np.ceil(low - 0.5), half), np.minimum(np.floor(high + 0.5), length - 1 - half)
    return first.astype(int), last.astype(int)


def correlate(piece: Array, patch: Array) -> Array:
    """ZNCC of a patch (h, w) with every window of a piece of an image (rows + h - 1, columns + w - 1).

    One matrix product gives the products of each row of the patch with each row of each window, which are then summed
    over the rows. The windows' sums come from the integral image. 0 where there is no texture.
    """
    # Near zero there is no cancellation; integer grey levels stay integers, and their sums exact.
    piece = piece - np.rint(piece.mean())
    (h, w), (deviation, power_of_patch) = patch.shape, centred(patch)
    rows, columns = piece.shape[0] - h + 1, piece.shape[1] - w + 1
    strips = np.lib.stride_tricks.sliding_window_view(piece, w, axis=1).reshape(-1, w)
    products = (deviation @ strips.T).reshape(h, len(piece), columns)
    product = sum(products[k, k : k + rows] for k in range(h))
    power = _sums(piece * piece, h, w) - _sums(piece, h, w) ** 2 / patch.size
    power = power * (power > ROUNDING * (piece * piece).sum()) * power_of_patch
    score: Array = product / np.sqrt(np.where(power > 0, power, np.inf))
    return np.clip(score, -1, 1)


def _sums(piece: Array, h: int, w: int) -> Array:
    """Sums over all windows (h, w), from the integral image."""
    integral = np.zeros((piece.shape[0] + 1, piece.shape[1] + 1))
    piece.cumsum(0).cumsum(1, out=integral[1:, 1:])
    return integral[h:, w:] - integral[:-h, w:] - integral[h:, :-w] + integral[:-h, :-w]
