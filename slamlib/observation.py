"""A sensor on a robot looks at landmarks: the chain rule, once, for every pair of a sensor and a parametrization.

landmark --to_frame--> homogeneous point in the sensor's frame --project--> measurement, and back.
"""

from collections import namedtuple
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np

from slamlib.errors import SingularPointError, SlamlibError
from slamlib.geometry.pose import compose
from slamlib.landmarks.point import PointLandmark
from slamlib.sensors.sensor import Calibration
from slamlib.spaces import Array

AHEAD = np.array([0.25, 0.5, 1, 1])  # stands in for points that cannot be measured, so that their rows are finite


@dataclass(frozen=True)
class Observation:
    """What a sensor should measure of landmarks: values (..., m), the mask of those it sees, and Jacobians.

    jacobians.robot (..., m, 6), .mount (..., m, 6), .landmark (..., m, dof), and one for each parameter of the sensor.
    The rows of landmarks that are not seen hold numbers without a meaning.
    """

    value: Array
    visible: Array
    jacobians: Any


def observe(kind: PointLandmark, calibration: Calibration, robot: Array, mount: Array, landmarks: Array) -> Observation:
    """Expected measurements of landmarks (..., size) from a robot's pose (7,) with the sensor mounted at `mount` (7,).

    Raises SlamlibError for what is no point. Chapter 8, eq. (ph-observe).
    """
    _check_point(kind, calibration, "observe")
    camera, by_camera = compose.jac(robot, mount)
    point, by_frame = kind.to_frame.jac(camera, landmarks)
    seen = calibration.visible(point)
    value, by_sensor = calibration.project_jac(np.where(seen[..., None], point, AHEAD))
    to_camera = by_sensor.point @ by_frame.pose
    parts = {
        "robot": to_camera @ by_camera.outer,
        "mount": to_camera @ by_camera.inner,
        "landmark": by_sensor.point @ by_frame[1],
        **{n: getattr(by_sensor, n) for n in calibration.given},
    }
    return Observation(value, seen & calibration.inside(value), named(parts))


def initialize(
    kind: PointLandmark, calibration: Calibration, robot: Array, mount: Array, measurement: Array, *unmeasured: Array
) -> tuple[Array, Any]:
    """The landmark of a measurement (..., m) and of what it does not tell (..., u), and Jacobians.

    jacobians.robot (..., dof, 6), .mount (..., dof, 6), .measurement (..., dof, m), .unmeasured (..., dof, u) if the
    sensor leaves something open, and one for each parameter of the sensor. Raises SlamlibError for what is no point,
    and for an `unmeasured` that is missing, not wanted, or a negative inverse distance.
    """
    _check_point(kind, calibration, "initialize")
    _check_open(calibration, unmeasured)
    camera, by_camera = compose.jac(robot, mount)
    point, by_sensor = calibration.back_project_jac(measurement, *unmeasured)
    if unmeasured and (point[..., 3] < 0).any():
        raise SlamlibError("initialize: the prior puts a point beyond infinity: its inverse distance is negative")
    landmark, by_frame = kind.from_frame.jac(camera, point)
    _seen_again(kind, camera, point, landmark)
    parts = {
        "robot": by_frame.pose @ by_camera.outer,
        "mount": by_frame.pose @ by_camera.inner,
        "measurement": by_frame.point @ by_sensor[0],
        **({"unmeasured": by_frame.point @ by_sensor[1]} if unmeasured else {}),
        **{n: by_frame.point @ getattr(by_sensor, n) for n in calibration.given},
    }
    return landmark, named(parts)


def _check_point(kind: Any, calibration: Any, function: str) -> None:
    if not isinstance(calibration, Calibration):
        raise SlamlibError(f"{function}: the second argument is a Calibration, not {type(calibration).__name__}")
    if not isinstance(kind, PointLandmark):
        raise SlamlibError(
            f"{function}: a {calibration.sensor.name} is asked for {getattr(kind, 'name', kind)!r}, which is no point; "
            f"points are in slamlib.landmarks.POINTS, lines are for slamlib.line_observation.{function}_line"
        )


def _check_open(calibration: Calibration, unmeasured: tuple[Array, ...]) -> None:
    model = calibration.sensor.back_project
    wanted = len(model.arguments) - 1 - len(calibration.sensor.parameters)
    if len(unmeasured) != wanted:
        what = "a prior of what it does not measure" if wanted else "no prior, since it measures all three coordinates"
        raise SlamlibError(f"initialize: a {calibration.sensor.name} needs {what}; got {len(unmeasured)} arrays")


def _seen_again(kind: PointLandmark, camera: Array, point: Array, landmark: Array) -> None:
    """Raise SingularPointError if a landmark is not where it was measured: not every type can hold every point."""
    turned = (kind.to_frame(camera, landmark)[..., :3] * point[..., :3]).sum(-1) <= 0
    if turned.any():
        example = np.broadcast_to(point, (*turned.shape, 4))[turned][0]
        raise SingularPointError(
            f"{kind.name} cannot hold the point {example.tolist()} (h, w) of the sensor's frame: mask such "
            "measurements, or hold them as another type"
        )


def named(parts: dict[str, Array]) -> Any:
    """Jacobians by the names of what they are taken by."""
    return _fields(tuple(parts))(*parts.values())


@lru_cache
def _fields(names: tuple[str, ...]) -> Any:
    return namedtuple("Jacobians", names)
