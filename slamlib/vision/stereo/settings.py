"""What the stereo front end may be told."""

from dataclasses import dataclass

from slamlib.errors import SlamlibError


@dataclass(frozen=True)
class StereoSettings:
    """Lengths in pixels.

    cells, each: of a grid (across, down), and the most features that a cell keeps, the strongest ones. least: strength
    of the weakest. detector: a name of slamlib.vision.stereo.detect.DETECTORS. border: of the picture, without
    features. rows: how far apart the rows of the two pictures may be. disparity: least and largest one. offset: added
    to each disparity, column of the right principal point minus that of the left one (Middlebury's doffs). distance:
    bits of 256 in which two descriptors may differ at most. ratio: the best match differs in less than this share of
    the bits of the second best. patch: side of the patches that measurements are refined with, odd; 0 does not refine.
    score: their least correlation. shift: the most that the refinement may move. region: half the side of the squares
    in which an odometry with a prediction looks for its matches.

    Of the front end alone. probability: with which a region contains the truth, if the filter is right. apart: from one
    landmark to the next in the picture. enough: with so many in view, none is begun. zoom: ratio of distances up to
    which one view serves; views: so many of a landmark are kept. longest: frames for which a landmark rests that was
    missed again and again. turns: a landmark is measured in one of so many frames, since its errors last (the template
    is the same), and a filter takes them for new ones; the other frames are left to an odometry (MOVING "correlated").
    """

    cells: tuple[int, int] = (12, 8)
    each: int = 5
    least: float = 200.0
    detector: str = "corners"
    border: int = 18
    rows: float = 1.5
    disparity: tuple[float, float] = (1.0, 120.0)
    offset: float = 0.0
    distance: int = 60
    ratio: float = 0.85
    patch: int = 11
    score: float = 0.85
    shift: float = 2.0
    region: float = 25.0
    probability: float = 0.999
    apart: float = 9.0
    enough: int = 60
    zoom: float = 1.3
    views: int = 4
    longest: int = 16
    turns: int = 1

    def __post_init__(self) -> None:
        least, largest = self.disparity
        if not 0 < least < largest:
            raise SlamlibError(f"StereoSettings: disparity is (least, largest), above zero, got {self.disparity}")
        if self.patch and (self.patch % 2 == 0 or self.patch < 5):
            raise SlamlibError(f"StereoSettings: patch is odd, 5 or more, or 0 for no refinement, got {self.patch}")
