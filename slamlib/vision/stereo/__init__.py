"""Two cameras side by side: features of rectified pairs, motion between them, and a front end for the filter.

A pair is one array (2, h, w): the left picture, then the right one, of type uint8. Both are rectified: a point of the
world lies in the same row of both, and the disparity d = u_left - u_right is focal length times baseline by depth. What
is measured is (u, v, d) [px] of the left picture, as slamlib.sensors.stereo defines it. Chapter 21.
"""

from slamlib.datasets.pairs import pair
from slamlib.vision.stereo.detect import StereoSettings
from slamlib.vision.stereo.features import Eyes, Observed
from slamlib.vision.stereo.front_end import StereoSearch
from slamlib.vision.stereo.geometry import joined, paired, triangulate
from slamlib.vision.stereo.matching import circular, mutual
from slamlib.vision.stereo.motion_source import MOVING, Moving
from slamlib.vision.stereo.odometry import Motion, Tracks, VisualOdometry, motion_between

__all__ = [
    "MOVING",
    "Eyes",
    "Motion",
    "Moving",
    "Observed",
    "StereoSearch",
    "StereoSettings",
    "Tracks",
    "VisualOdometry",
    "circular",
    "joined",
    "motion_between",
    "mutual",
    "pair",
    "paired",
    "triangulate",
]
