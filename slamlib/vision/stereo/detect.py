"""Corners spread over an image, with binary descriptors. Chapter visual_odometry.

The descriptor is ORB's pattern of 256 comparisons, upright and of one scale: BRIEF (Calonder and others, 2010) with the
pairs that ORB (Rublee and others, 2011) chose. The two cameras of a rig have the same orientation and scale, so
that ORB's invariance to these costs accuracy without benefit; `python -m benchmarks.stereo` measures it.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from typing import Annotated, Any

import numpy as np

from slamlib.datasets.pictures import opencv
from slamlib.errors import SlamlibError, entry
from slamlib.manifolds import Array, Image
from slamlib.plain_data.fields import Count, Finite, Magnitude, Positive, Range, Share, Whole, check
from slamlib.vision.patches import parabola

Cells = Annotated[int, Range(gt=0, le=10_000)]
WINDOW = 5  # px, of the structure tensor, whose smaller eigenvalue is the strength of a corner


@dataclass(frozen=True)
class StereoSettings:
    """Settings of the stereo front end; lengths in pixels.

    cells, per_cell: of a grid (across, down), and most features per cell, the strongest (2, 5, 12: ATE 155, 173, 184 mm
    on a street, 6.3, 4.6, 4.7 mm with a waved rig). min_strength: least strength of a feature. detector: a name of
    DETECTORS. border: of the image, without features. rows: largest difference of the rows of a match. disparity: least
    and largest one. offset: added to each disparity, column of the right principal point minus that of the left one
    (Middlebury's doffs). distance: largest Hamming distance of two descriptors of 256 bits. ratio: the best one is
    below this share of the second best. patch: side of the patches that measurements are refined with, odd; 0 does not
    refine. score: their least correlation. shift: largest displacement by the refinement. region: half the side of the
    squares in which an odometry with a prediction searches for its matches.

    Of the front end alone. probability: that a region contains the true measurement, if the filter is consistent.
    min_separation: from one landmark to the next in the image. max_in_view: with so many in view, none is initialized.
    zoom: largest ratio of distances for one view; views: largest number of views of a landmark. max_backoff: most
    frames for which a missed landmark is skipped. update_interval: a landmark is measured in one of so many frames,
    since its errors are correlated over time (the template is the same), and the filter assumes them independent; the
    other frames are left to an odometry (MOTION_SOURCES "correlated").
    """

    cells: tuple[Cells, Cells] = (12, 8)
    per_cell: Whole = 5
    min_strength: Magnitude = 200.0
    detector: str = "corners"
    border: Annotated[int, Range(ge=0, le=10_000, unit="px")] = 18
    rows: Magnitude = 1.5
    disparity: tuple[Positive, Positive] = (1.0, 120.0)
    offset: Finite = 0.0
    distance: Annotated[int, Range(ge=0, le=256)] = 60
    ratio: Annotated[float, Range(gt=0, le=1)] = 0.85
    patch: Annotated[int, Range(ge=0, le=101)] = 11
    score: Share = 0.85
    shift: Positive = 2.0
    region: Positive = 25.0
    probability: Annotated[float, Range(gt=0, lt=1)] = 0.999
    min_separation: Magnitude = 9.0
    max_in_view: Count = 60
    zoom: Annotated[float, Range(ge=1, le=1000)] = 1.3
    views: Whole = 4
    max_backoff: Count = 16
    update_interval: Whole = 1

    def __post_init__(self) -> None:
        check(self)
        least, largest = self.disparity
        if not least < largest:
            raise SlamlibError(f"StereoSettings: disparity is (least, largest), above zero, got {self.disparity}")
        entry("detector", self.detector, DETECTORS)
        if self.patch and (self.patch % 2 == 0 or self.patch < 5):
            raise SlamlibError(f"StereoSettings: patch is odd, 5 or more, or 0 for no refinement, got {self.patch}")


@dataclass(frozen=True, eq=False)
class Keypoints:
    """Pixels (n, 2), their strengths (n,), and descriptors (n, 32): 256 bits each."""

    pixels: Array
    strengths: Array
    descriptors: Image

    def __len__(self) -> int:
        return len(self.pixels)


def detect(image: Image, settings: StereoSettings | None = None) -> Keypoints:
    """The strongest features of each cell of the grid, sub-pixel. Raises SlamlibError without OpenCV."""
    s = settings or StereoSettings()
    return DETECTORS[s.detector](image, s)


def spread(pixels: Array, strengths: Array, size: tuple[int, int], cells: tuple[int, int], per_cell: int) -> Array:
    """Rows of the `per_cell` strongest pixels (n, 2) of each cell of an image (w, h), strongest first."""
    order = np.argsort(-strengths, kind="stable")
    place = np.clip((pixels[order] * cells / size).astype(int), 0, np.subtract(cells, 1))
    cell = place[:, 1] * cells[0] + place[:, 0]
    together = np.argsort(cell, kind="stable")  # by cell, strongest first within each
    start = np.searchsorted(cell[together], cell[together])
    return order[np.sort(together[np.arange(len(cell)) - start < per_cell])]


def _corners(image: Image, s: StereoSettings) -> Keypoints:
    """Local maxima of the structure tensor's smaller eigenvalue, with an upright descriptor."""
    cv2 = opencv("to find features")
    # In OpenCV's scale the eigenvalue is four times the mean over the window; here it is the sum [grey^2/px^2].
    strength = cv2.cornerMinEigenVal(image.astype(np.float32), WINDOW) * (WINDOW**2 / 4)
    peak = (strength >= cv2.dilate(strength, np.ones((7, 7), np.uint8))) & (strength >= s.min_strength)
    peak[: s.border], peak[-s.border :], peak[:, : s.border], peak[:, -s.border :] = False, False, False, False
    v, u = np.nonzero(peak)
    rows = spread(np.stack([u, v], 1), strength[v, u], image.shape[::-1], s.cells, s.per_cell)
    u, v = u[rows], v[rows]
    across, down = (
        parabola(strength[v - i, u - j], strength[v, u], strength[v + i, u + j]) for i, j in ((0, 1), (1, 0))
    )
    pixels = np.stack([u + across, v + down], axis=1)
    points = [cv2.KeyPoint(u, v, 31.0, 0.0, 0.0, 0, i) for i, (u, v) in enumerate(pixels.tolist())]
    kept, descriptors = _describer(s.border - 2).compute(image, points)
    kept_rows = np.array([k.class_id for k in kept], dtype=int)
    bits = np.zeros((0, 32), np.uint8) if descriptors is None else descriptors
    return Keypoints(pixels[kept_rows], strength[v, u][kept_rows], bits)


@lru_cache
def _describer(border: int) -> Any:
    return opencv("to describe features").ORB_create(nlevels=1, edgeThreshold=border)


DETECTORS: dict[str, Callable[[Array, StereoSettings], Keypoints]] = {"corners": _corners}
