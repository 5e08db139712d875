"""The package's own checks of a landmark, a sensor or a motion, for those in the package and for a reader's own.

    from slamlib.checks import check_landmark, check_motion, check_sensor
    check_landmark(MY_POINT)

Each prints a line for every property that holds, and raises CheckError with all that do not: which property, which
definition, which argument, where, and by how much. Chapter your_own_model uses them; the package's tests run them on
every type.
"""

from slamlib.checks.jacobian import check_jacobian
from slamlib.checks.judge import CheckError, Finding, Judge
from slamlib.checks.landmarks import line_properties, point_properties
from slamlib.checks.line_pairs import line_pair_properties
from slamlib.checks.motions import motion_properties
from slamlib.checks.pairs import DEFINED, pair_properties
from slamlib.checks.sensors import sensor_properties
from slamlib.errors import SlamlibError
from slamlib.landmarks.parametrization import LineLandmark, PointLandmark
from slamlib.motions import Motion
from slamlib.sensors.sensor import Calibration

__all__ = ["CheckError", "Finding", "check_jacobian", "check_landmark", "check_motion", "check_pair", "check_sensor"]


def check_landmark(kind: PointLandmark | LineLandmark, *, silent: bool = False, seed: int = 0) -> None:
    """Check a parametrization of points or lines: print the properties that hold, raise CheckError with the others."""
    judge = Judge(getattr(kind, "name", "?"), seed)
    if isinstance(kind, PointLandmark):
        point_properties(judge, kind)
    elif isinstance(kind, LineLandmark):
        line_properties(judge, kind)
    else:
        raise SlamlibError(f"check_landmark: give a PointLandmark or a LineLandmark, not {type(kind).__name__}")
    judge.conclude(silent)


def check_sensor(calibration: Calibration, *, silent: bool = False, seed: int = 0) -> None:
    """Check a sensor with one calibration: print the properties that hold, raise CheckError with the others."""
    if not isinstance(calibration, Calibration):
        raise SlamlibError(
            "check_sensor: a sensor is checked with its calibration: give Calibration(SENSOR, noise, parameter=...), "
            f"not {type(calibration).__name__}"
        )
    judge = Judge(calibration.sensor.name, seed)
    sensor_properties(judge, calibration)
    judge.conclude(silent)


def check_motion(motion: Motion, *, silent: bool = False, seed: int = 0) -> None:
    """Check a motion: print the properties that hold, raise CheckError with the others."""
    if not isinstance(motion, Motion):
        raise SlamlibError(f"check_motion: give a Motion, not {type(motion).__name__}")
    judge = Judge(motion.name, seed)
    motion_properties(judge, motion)
    judge.conclude(silent)


def check_pair(
    kind: PointLandmark | LineLandmark, calibration: Calibration, *, silent: bool = False, seed: int = 0
) -> bool:
    """Check a parametrization with a sensor on a robot: initialize, observe again, update. As check_landmark.

    False if the pair does not exist: a parametrization of points refuses every point that the sensor measures, only
    one of them is of the plane, or the sensor has no images of lines.
    """
    judge = Judge(f"{kind.name} seen by {calibration.sensor.name}", seed)
    if isinstance(kind, LineLandmark):
        line_pair_properties(judge, kind, calibration)
    else:
        pair_properties(judge, kind, calibration)
    judge.conclude(silent)
    return DEFINED in judge.places
