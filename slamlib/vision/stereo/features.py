"""Stereo features: matched in both directions along rows, with disparities, and tracked. Chapter visual_odometry.

Also a check, by the images themselves, that two of them are a rectified pair, the left one first.
"""

from dataclasses import dataclass

import numpy as np

from slamlib.datasets.pictures import checked
from slamlib.errors import SlamlibError
from slamlib.manifolds import Array, Image, Indices, Mask
from slamlib.sensors.sensor import Calibration
from slamlib.vision.stereo.detect import Keypoints, StereoSettings, detect
from slamlib.vision.stereo.refine import ALONG_ROW, align, cut

ROWS = 0.1  # of the image's height: largest difference of the rows of a match
ENOUGH = 12  # least number of matches for a check


def hamming_distances(one: Image, other: Image) -> Array:
    """Bits (n, m) in which descriptors (n, 32) and (m, 32) differ.

    With bits as signs, a' b is the number of equal bits minus that of different ones: one matrix product.
    """
    a, b = (np.unpackbits(d, axis=1).astype(np.float32) * 2 - 1 for d in (one, other))
    differ: Array = (a.shape[1] - a @ b.T) / 2
    return differ.astype(float)


def mutual_nearest(cost: Array, *, largest: float, ratio: float = 1.0) -> Indices:
    """Pairs (k, 2) of rows and columns of costs (n, m), each the other's best; inf excludes a match.

    A best cost above `largest`, or not below `ratio` times the second best of its row or column, is no match.
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
    return np.partition(cost, 1, axis=1)[:, 1]


def row_mask(left: Array, right: Array, rows: float, disparity: tuple[float, float]) -> Mask:
    """Mask (n, m) of the pixels (n, 2) and (m, 2) that may show one point: in one row, with an allowed disparity."""
    apart = np.abs(left[:, None, 1] - right[None, :, 1])
    d = left[:, None, 0] - right[None, :, 0]
    return (apart <= rows) & (d >= disparity[0]) & (d <= disparity[1])


def circular_matches(lefts: Indices, rights: Indices) -> Indices:
    """Pairs (k, 2) of old and new stereo features matched consistently in both images.

    lefts, rights (., 2): pairs of (old, new) as matched in the left images, and in the right ones. A feature of a
    pair is already matched from left to right, so old left, new left, new right, old right closes the cycle of the
    report's figure 5.1 exactly if both pairs are the same.
    """
    return lefts[np.isin(lefts @ (1, 1j), rights @ (1, 1j))]  # each match as one number


@dataclass(frozen=True, eq=False)
class StereoFeatures:
    """A pair (2, h, w), the keypoints of each image, and the n features matched from left to right.

    values (n, 3): (u, v, disparity) [px]. rows (n, 2): indices of each one in `left` and `right`.
    """

    image: Image
    left: Keypoints
    right: Keypoints
    rows: Indices
    values: Array

    def __len__(self) -> int:
        return len(self.values)

    def descriptors(self, side: int) -> Image:
        """Descriptors (n, 32) of the features in the left image (0) or the right one (1)."""
        return (self.left, self.right)[side].descriptors[self.rows[:, side]]

    @property
    def strengths(self) -> Array:
        """Strengths (n,) of the features' corners in the left image."""
        return self.left.strengths[self.rows[:, 0]]


class StereoFeatureExtractor:
    """Extracts the features of each pair only once: odometry and the filter's front end may share it."""

    def __init__(self, calibration: Calibration, settings: StereoSettings | None = None) -> None:
        self.calibration, self.settings = calibration, settings or StereoSettings()
        self.last: StereoFeatures | None = None

    def extract(self, image: Image | None) -> StereoFeatures:
        """The features of a pair (2, h, w). Raises SlamlibError for anything else."""
        if self.last is None or self.last.image is not image:
            self.last = extract_features(checked(image, self.calibration), self.settings)
        return self.last


def extract_features(image: Image, settings: StereoSettings) -> StereoFeatures:
    """Detect in both images, match in both directions along the rows, and refine the disparities."""
    s, (left, right) = settings, (detect(picture, settings) for picture in image)
    cost = hamming_distances(left.descriptors, right.descriptors)
    least, largest = (bound - s.offset for bound in s.disparity)
    cost = np.where(row_mask(left.pixels, right.pixels, s.rows, (least, largest)), cost, np.inf)
    rows = mutual_nearest(cost, largest=s.distance, ratio=s.ratio)
    pixels = left.pixels[rows[:, 0]]
    d = pixels[:, 0] - right.pixels[rows[:, 1], 0] + s.offset
    d, good = refine_disparities(image, pixels, d, s)
    return StereoFeatures(image, left, right, rows[good], np.column_stack([pixels, d])[good])


def refine_disparities(image: Image, pixels: Array, guess: Array, settings: StereoSettings) -> tuple[Array, Mask]:
    """Disparities (n,) at pixels (n, 2) of the left image, near the guess (n,), and the mask (n,) of the accepted."""
    s, (left, right) = settings, image
    if not s.patch or not len(pixels):
        return guess, np.ones(len(pixels), dtype=bool)
    start = pixels - (guess - s.offset)[:, None] * [1, 0]
    place, score = align(right, cut(left, pixels, s.patch + 2), start, ALONG_ROW)
    d = pixels[:, 0] - place[:, 0] + s.offset
    good = (score >= s.score) & (np.abs(d - guess) <= s.shift) & (d >= s.disparity[0]) & (d <= s.disparity[1])
    return d, good


def refine_by_templates(
    image: Image, templates: Array, values: Array, settings: StereoSettings, *, free: bool
) -> tuple[Array, Mask]:
    """Values (n, 3) where templates (n, patch + 2, patch + 2) fit best near those given, and the mask of the accepted.

    free: whether a template may change its shape. From one pair to the next it hardly does, and a fixed one is more
    precise; from another viewpoint it does, and a fixed one is biased.
    """
    s = settings
    pixels, score = align(image[0], templates, values[:, :2])
    if free:
        pixels, score = align(image[0], templates, pixels, free=True, rounds=5)
    good = (score >= s.score) & (np.abs(pixels - values[:, :2]).max(1, initial=0) <= s.shift)
    d, seen = refine_disparities(image, pixels, values[:, 2], s)
    return np.column_stack([pixels, d]), good & seen


def track_features(
    old: StereoFeatures, new: StereoFeatures, settings: StereoSettings, allowed: Mask | None = None
) -> tuple[Indices, Array]:
    """Pairs (k, 2) of old and new features that close the cycle, and their new values (k, 3), refined.

    allowed (n, m): mask of the possible matches, by a prediction.
    """
    s = settings
    sides = []
    for side in (0, 1):
        cost = hamming_distances(old.descriptors(side), new.descriptors(side))
        cost = cost if allowed is None else np.where(allowed, cost, np.inf)
        sides.append(mutual_nearest(cost, largest=s.distance, ratio=s.ratio))
    pairs = circular_matches(*sides)
    values = new.values[pairs[:, 1]]
    if not s.patch or not len(pairs):
        return pairs, values
    templates = cut(old.image[0], old.values[pairs[:, 0], :2], s.patch + 2)
    refined, good = refine_by_templates(new.image, templates, values, s, free=False)
    return pairs[good], refined[good]


def within_region(expected: Array, values: Array, radius: float) -> Mask:
    """Mask (n, m) of values (m, .) whose pixel is at most `radius` [px] from a predicted one (n, .); nan: none."""
    return np.abs(expected[:, None, :2] - values[None, :, :2]).max(-1) <= radius


def check_pair(image: Image, name: str, settings: StereoSettings | None = None) -> None:
    """Match a pair (2, h, w). Raises SlamlibError if left and right are exchanged, or rows do not correspond.

    A pair with too few matches for a check passes: it may be dark.
    """
    s = settings or StereoSettings()
    left, right = (detect(picture, s) for picture in image)
    apart = left.pixels[:, None] - right.pixels[None]
    near = (np.abs(apart[..., 1]) <= ROWS * image.shape[1]) & (np.abs(apart[..., 0]) <= s.disparity[1])
    cost = np.where(near, hamming_distances(left.descriptors, right.descriptors), np.inf)
    rows = mutual_nearest(cost, largest=s.distance, ratio=0.75)
    match = apart[rows[:, 0], rows[:, 1]]
    if len(match) < ENOUGH:
        return
    negative, apart_rows = (match[:, 0] + s.offset <= 0).mean(), np.median(np.abs(match[:, 1]))
    if negative > 0.5:
        raise SlamlibError(
            f"{name}: {negative:.0%} of {len(match)} matches have a negative disparity (in the right image "
            "they are further right): left and right are exchanged; give --left and --right the other way round"
        )
    if apart_rows > s.rows:
        raise SlamlibError(
            f"{name}: the rows of a point in the two pictures differ by {apart_rows:.1f} px (median of {len(match)} "
            f"matches), and {s.rows} are allowed: the pair is not rectified. Rectify it with --rectify and a "
            "calibration of both lenses with their extrinsics, or give the rectified images"
        )
