"""How robots move: odometry, constant velocity, and the report's composition. Tangled from chapter 7."""

from slamlib.errors import UnknownNameError
from slamlib.motions.constant_velocity import CONSTANT_VELOCITY
from slamlib.motions.motion import Motion
from slamlib.motions.odometry import ODOMETRY

__all__ = ["CONSTANT_VELOCITY", "ODOMETRY", "Motion", "motion"]

_MOTIONS = {m.name: m for m in (ODOMETRY, CONSTANT_VELOCITY)}


def motion(name: str) -> Motion:
    """The motion of a name, as the seeds' toolbox spells it: 'odometry', 'constVel'."""
    if name not in _MOTIONS:
        raise UnknownNameError.of("motion", name, _MOTIONS)
    return _MOTIONS[name]
