"""Motion models: odometry, constant velocity, the report's composition; odometry and the unicycle in the plane.

Tangled from chapter motion_models.
"""

from slamlib.motions.constant_velocity import CONSTANT_VELOCITY
from slamlib.motions.motion import Motion
from slamlib.motions.odometry import ODOMETRY
from slamlib.registry import Registry

__all__ = ["CONSTANT_VELOCITY", "MOTIONS", "ODOMETRY", "Motion", "motion"]

MOTIONS = Registry(__name__, Motion, "motion")


def motion(name: str) -> Motion:
    """The motion of this name, as the toolbox spells it: 'odometry', 'constVel'."""
    return MOTIONS[name]
