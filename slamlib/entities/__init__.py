"""What the filter estimates: robots, sensors and landmarks as blocks of one belief, and where these are linearized."""

from slamlib.entities.landmark import Landmark
from slamlib.entities.rig import RigSensor, Robot
from slamlib.entities.state import State

__all__ = ["Landmark", "RigSensor", "Robot", "State"]
