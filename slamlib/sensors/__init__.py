"""Sensor models, one file for each type. Tangled from chapters pinhole, omnidirectional and depth_stereo_range.

A new one is one more file that ends with its `Sensor(...)`, as `range_bearing` does; `slamlib.checks.check_sensor` says
what is missing. Chapter your_own_model.
"""

from slamlib.registry import Registry
from slamlib.sensors.sensor import Calibration, Sensor

__all__ = ["SENSORS", "Calibration", "Sensor", "sensor"]

SENSORS = Registry(__name__, Sensor, "sensor")


def sensor(name: str) -> Sensor:
    """The type of sensor of this name, as the toolbox spells it: 'pinHole', 'omniCam', ..."""
    return SENSORS[name]
