"""What two eyes see: features of a rectified pair, each with its disparity."""

from dataclasses import dataclass

import numpy as np

from slamlib.datasets.pairs import checked
from slamlib.manifolds import Array, Image, Indices, Mask
from slamlib.sensors.sensor import Calibration
from slamlib.vision.stereo.detect import Keypoints, StereoSettings, detect
from slamlib.vision.stereo.matching import circular_matches, hamming_distances, mutual_nearest, row_mask
from slamlib.vision.stereo.refine import ALONG_ROW, align, align_shape, cut


@dataclass(frozen=True, eq=False)
class StereoFeatures:
    """A pair (2, h, w); all that was detected in each picture; and what was matched from left to right, n features.

    values (n, 3): (u, v, disparity) [px]. rows (n, 2): which of `left` and `right` each one is.
    """

    image: Image
    left: Keypoints
    right: Keypoints
    rows: Indices
    values: Array

    def __len__(self) -> int:
        return len(self.values)

    def descriptors(self, side: int) -> Image:
        """Descriptors (n, 32) of the features in the left picture (0) or the right one (1)."""
        found = (self.left, self.right)[side].descriptors[self.rows[:, side]]
        return found

    @property
    def strengths(self) -> Array:
        """(n,) of the features' corners in the left picture."""
        found: Array = self.left.strengths[self.rows[:, 0]]
        return found


class StereoFeatureExtractor:
    """Looks at pairs, and at each of them only once: odometry and the filter's front end may share them."""

    def __init__(self, calibration: Calibration, settings: StereoSettings | None = None) -> None:
        self.calibration, self.settings = calibration, settings or StereoSettings()
        self.last: StereoFeatures | None = None

    def extract(self, image: Image | None) -> StereoFeatures:
        """The features of a pair (2, h, w). Raises SlamlibError for what is none."""
        if self.last is None or self.last.image is not image:
            self.last = extract_features(checked(image, self.calibration), self.settings)
        return self.last


def extract_features(image: Image, settings: StereoSettings) -> StereoFeatures:
    """Detect in both pictures, match in both directions along the rows, and refine the disparities."""
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
    """Disparities (n,) at pixels (n, 2) of the left picture, near the guess (n,), and the mask of those to believe."""
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
    """Values (n, 3) where templates (n, patch + 2, patch + 2) fit best near those given, and the mask of the good ones.

    free: whether a template may change its shape. From one pair to the next it hardly does, and a fixed one is more
    precise; seen from elsewhere it does, and a fixed one is pulled aside.
    """
    s = settings
    pixels, score = align(image[0], templates, values[:, :2])
    if free:
        pixels, score = align_shape(image[0], templates, pixels)
    good = (score >= s.score) & (np.abs(pixels - values[:, :2]).max(1, initial=0) <= s.shift)
    d, seen = refine_disparities(image, pixels, values[:, 2], s)
    return np.column_stack([pixels, d]), good & seen


def track_features(
    old: StereoFeatures, new: StereoFeatures, settings: StereoSettings, allowed: Mask | None = None
) -> tuple[Indices, Array]:
    """Pairs (k, 2) of old and new features that close the cycle, and their new values (k, 3), refined.

    allowed (n, m): which may match at all, where a prediction says so.
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
    """Mask (n, m) of values (m, .) whose pixel is at most `radius` [px] from an expected one (n, .); nan: nowhere."""
    mask: Mask = np.abs(expected[:, None, :2] - values[None, :, :2]).max(-1) <= radius
    return mask
