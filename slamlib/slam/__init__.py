"""The complete EKF-SLAM filter: options, entities, data association, measurement update and map management."""

from slamlib.slam.filter import Slam
from slamlib.slam.map_management import Report
from slamlib.slam.options import Options

__all__ = ["Options", "Report", "Slam"]
