"""The complete EKF-SLAM filter: options, entities, data association, measurement update and map management."""

from slamlib.slam.filter import Report, Slam
from slamlib.slam.options import Options

__all__ = ["Options", "Report", "Slam"]
