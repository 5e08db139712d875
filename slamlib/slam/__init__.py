"""The whole filter: options, entities, what points and lines have of their own, and the step from frame to frame."""

from slamlib.slam.filter import Report, Slam
from slamlib.slam.options import Options

__all__ = ["Options", "Report", "Slam"]
