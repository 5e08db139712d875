"""Whether two pictures are a rectified pair, the left one first: asked of the pictures themselves."""

from dataclasses import dataclass, replace

import numpy as np

from slamlib.errors import SlamlibError
from slamlib.manifolds import Image
from slamlib.vision.stereo.detect import detect
from slamlib.vision.stereo.matching import distances, mutual
from slamlib.vision.stereo.settings import StereoSettings

ROWS = 0.1  # of the picture's height: matches are sought so far up and down
ENOUGH = 12  # matches, for a judgement


@dataclass(frozen=True)
class Survey:
    """Of matches found without regard to rows: how many; median of |v_left - v_right| [px], and the share with a
    disparity of zero or less."""

    matches: int
    rows: float
    negative: float


def survey(image: Image, settings: StereoSettings | None = None) -> Survey:
    """What the features of a pair (2, h, w) say of it."""
    s = replace(settings or StereoSettings(), ratio=0.75)
    left, right = (detect(picture, s) for picture in image)
    apart = left.pixels[:, None] - right.pixels[None]
    near = (np.abs(apart[..., 1]) <= ROWS * image.shape[1]) & (np.abs(apart[..., 0]) <= s.disparity[1])
    cost = np.where(near, distances(left.descriptors, right.descriptors), np.inf)
    rows = mutual(cost, largest=s.distance, ratio=s.ratio)
    found = apart[rows[:, 0], rows[:, 1]]
    if len(found) < ENOUGH:
        return Survey(len(found), np.nan, np.nan)
    return Survey(len(found), float(np.median(np.abs(found[:, 1]))), float((found[:, 0] + s.offset <= 0).mean()))


def check_pair(image: Image, name: str, settings: StereoSettings | None = None) -> Survey:
    """Survey a pair. Raises SlamlibError if left and right are exchanged, or rows do not correspond.

    A pair with too few matches for a judgement passes: it may be dark.
    """
    s = settings or StereoSettings()
    found = survey(image, s)
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
