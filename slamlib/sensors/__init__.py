"""Sensor models, one file for each type. Tangled from chapters pinhole, omnidirectional and depth_stereo_range."""

from slamlib.registry import Registry
from slamlib.sensors.sensor import Calibration, Sensor

__all__ = ["SENSORS", "Calibration", "Sensor", "sensor"]

SENSORS = Registry(__name__, Sensor, "sensor")


def sensor(name: str) -> Sensor:
    """The type of sensor of this name, as the toolbox spells it: 'pinHole', 'omniCam', ..."""
    return SENSORS[name]
