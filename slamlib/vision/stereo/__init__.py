"""Two cameras side by side: features of rectified pairs, motion between them, and a front end for the filter.

A pair is one array (2, h, w): the left picture, then the right one, of type uint8. Both are rectified: a point of the
world lies in the same row of both, and the disparity d = u_left - u_right is focal length times baseline by depth. The
measurement is (u, v, d) [px] of the left picture, as slamlib.sensors.stereo defines it. Chapter visual_odometry.
"""

from slamlib.datasets.pictures import pair
from slamlib.vision.stereo.detect import StereoSettings
from slamlib.vision.stereo.features import StereoFeatureExtractor, StereoFeatures, circular_matches, mutual_nearest
from slamlib.vision.stereo.fitting import triangulate
from slamlib.vision.stereo.motion_source import MOTION_SOURCES, StereoMotionSource
from slamlib.vision.stereo.odometry import RelativeMotion, VisualOdometry, motion_between
from slamlib.vision.stereo.stereo_search import StereoSearch

__all__ = [
    "MOTION_SOURCES",
    "RelativeMotion",
    "StereoFeatureExtractor",
    "StereoFeatures",
    "StereoMotionSource",
    "StereoSearch",
    "StereoSettings",
    "VisualOdometry",
    "circular_matches",
    "motion_between",
    "mutual_nearest",
    "pair",
    "triangulate",
]
