"""The filter from frame to frame: `filter` has the steps, which are predict, project, select, match, gate, update,
convert, delete and initialize; the other files do them."""

from slamlib.slam.filter import Slam
from slamlib.slam.map_management import StepReport
from slamlib.slam.options import Options

__all__ = ["Options", "Slam", "StepReport"]
