"""What measures: a file for each type of sensor. Tangled from chapters pinhole to depth_stereo_range."""

from slamlib.modeling.registry import Registry
from slamlib.sensors.sensor import Calibration, Sensor

__all__ = ["SENSORS", "Calibration", "Sensor", "sensor"]

SENSORS = Registry(__name__, Sensor, "sensor")


def sensor(name: str) -> Sensor:
    """The type of sensor of a name, as the seeds' toolbox spells it: 'pinHole', 'omniCam', ..."""
    return SENSORS[name]
