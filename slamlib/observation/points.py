"""A sensor on a robot looks at landmarks: the chain rule, once, for every pair of a sensor and a parametrization.

landmark --to_frame--> homogeneous point in the sensor's frame --project--> measurement, and back.
"""

import math
from collections import namedtuple
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np

from slamlib.errors import SingularPointError, SlamlibError
from slamlib.geometry.pose import compose
from slamlib.landmarks.point import PointLandmark
from slamlib.manifolds import Array, Mask
from slamlib.sensors.sensor import Calibration

AHEAD = np.array([0.25, 0.5, 1, 1])  # stands in for points that cannot be measured, so that their rows are finite


@dataclass(frozen=True)
class Observation:
    """What a sensor should measure of landmarks: values (..., m), the mask of those it sees, and Jacobians.

    jacobians.robot (..., m, 6), .mount (..., m, 6), .landmark (..., m, dof), and one for each parameter of the sensor.
    The rows of landmarks that are not seen hold numbers without a meaning.
    """

    value: Array
    visible: Mask
    jacobians: Any


def observe(kind: PointLandmark, calibration: Calibration, robot: Array, mount: Array, landmarks: Array) -> Observation:
    """Expected measurements of landmarks (..., size) from a robot's pose (7,) with the sensor mounted at `mount` (7,).

    Raises SlamlibError for what is no point. Chapter 8, the chain rule of (ph-chain).
    """
    camera, by_camera = compose.jac(robot, mount)
    found = observe_from(kind, calibration, camera, landmarks)
    by_pose, *others = found.jacobians
    parts = {**_through(by_camera, by_pose), **dict(zip(found.jacobians._fields[1:], others, strict=True))}
    return Observation(found.value, found.visible, named(parts))


def observe_from(kind: PointLandmark, calibration: Calibration, camera: Array, landmarks: Array) -> Observation:
    """The same from the sensor's own pose (7,) in the world: jacobians.camera (..., m, 6) is by that one."""
    _check_point(kind, calibration, "observe")
    point, by_frame = kind.to_frame.jac(camera, landmarks)
    seen = calibration.visible(point)
    value, by_sensor = calibration.project_jac(point if seen.all() else np.where(seen[..., None], point, AHEAD))
    parts = {
        "camera": product(by_sensor.point, by_frame.pose),
        "landmark": product(by_sensor.point, by_frame[1]),
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
        **_through(by_camera, by_frame.pose),
        "measurement": product(by_frame.point, by_sensor[0]),
        **({"unmeasured": product(by_frame.point, by_sensor[1])} if unmeasured else {}),
        **{n: product(by_frame.point, getattr(by_sensor, n)) for n in calibration.given},
    }
    return landmark, named(parts)


def _check_point(kind: Any, calibration: Any, function: str) -> None:
    if not isinstance(calibration, Calibration):
        raise SlamlibError(f"{function}: the second argument is a Calibration, not {type(calibration).__name__}")
    if not isinstance(kind, PointLandmark):
        raise SlamlibError(
            f"{function}: a {calibration.sensor.name} is asked for {getattr(kind, 'name', kind)!r}, which is no point; "
            f"points are in slamlib.landmarks.POINTS, lines are for slamlib.observation.lines.{function}_line"
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


def product(left: Array, right: Array) -> Array:
    """left @ right for Jacobians (..., m, k), (..., k, n): quick where each entry lies in memory over all items."""
    lead = left.ndim - 2
    if left.ndim == right.ndim == 2:
        return left @ right
    if right.ndim == 2:  # one matrix for all items: (n, k) @ (m, k, items), a product of large matrices
        entries = left.transpose(lead, lead + 1, *range(lead))
        whole = right.T @ entries.reshape(*entries.shape[:2], math.prod(left.shape[:-2]))
        return whole.reshape(len(entries), right.shape[1], *left.shape[:-2]).transpose(*range(2, lead + 2), 0, 1)
    return np.einsum("...ij,...jk->...ik", left, right)


def _through(by_camera: Any, by_pose: Array) -> dict[str, Array]:
    """Jacobians by the robot and by the mount of something, from its Jacobian by the camera's pose."""
    both = product(by_pose, np.concatenate([by_camera.outer, by_camera.inner], axis=-1))
    return {"robot": both[..., :6], "mount": both[..., 6:]}


def named(parts: dict[str, Array]) -> Any:
    """Jacobians by the names of what they are taken by."""
    return _fields(tuple(parts))(*parts.values())


@lru_cache
def _fields(names: tuple[str, ...]) -> Any:
    return namedtuple("Jacobians", names)
