"""A third family of landmarks, planes, as a reader would write it: test_architecture.py puts it into a scratch copy.

A plane is held and measured as the foot of the perpendicular, from the world's origin and from the sensor [m]. Sensors
that measure three coordinates measure it with the noise that they have for points.
"""

from dataclasses import dataclass
from types import SimpleNamespace

import numpy as np

from slamlib.geometry.pose import Pose, compose
from slamlib.geometry.quaternion import rotation
from slamlib.manifolds import Manifold, as_manifold
from slamlib.models import Model, model
from slamlib.observation.family import Family


@dataclass(frozen=True)
class PlaneLandmark:
    """A way to hold a plane: to_frame(pose, landmark) and from_frame(pose, foot) give feet of perpendiculars (3,).

    moved(motion, landmark): after a motion of the world, which is from_frame.
    """

    name: str
    manifold: Manifold
    to_frame: Model
    from_frame: Model
    moved: Model


@model(pose=Pose, landmark=3)
def to_frame(pose, landmark):
    """Foot of the perpendicular from the frame's origin, in the frame [m]."""
    return rotation(pose[3:]).T @ landmark * (1 - landmark @ pose[:3] / (landmark @ landmark))


@model(pose=Pose, foot=3)
def from_frame(pose, foot):
    """Foot of the perpendicular from the world's origin [m]."""
    turned = rotation(pose[3:]) @ foot
    return turned * (1 + turned @ pose[:3] / (turned @ turned))


FOOT_PLANE = PlaneLandmark("footPln", as_manifold(3), to_frame, from_frame, from_frame)


class PlaneFamily(Family):
    """Planes, for sensors that measure three coordinates."""

    name = "planes"
    kinds = PlaneLandmark
    parametrizations = {"footPln": FOOT_PLANE}  # noqa: RUF012
    exact = FOOT_PLANE

    def supports(self, sensor):
        """Whether it measures three coordinates."""
        return sensor.calibration.sensor.size == 3 and not sensor.calibration.sensor.pixels

    def observe(self, kind, calibration, camera, means):
        """A plane has no border: each is in view."""
        value, J = kind.to_frame.jac(camera, means)
        return value, np.ones(value.shape[:-1], dtype=bool), SimpleNamespace(camera=J.pose, landmark=J.landmark)

    def initialize(self, sensor, kind, value, options):
        """All of it is measured."""
        camera, by = compose.jac(sensor.robot.pose, sensor.extrinsics)
        x, J = kind.from_frame.jac(camera, value)
        return x, J.foot @ sensor.calibration.noise @ J.foot.T, [J.pose @ by.outer, J.pose @ by.inner]

    def geometry(self, belief, landmarks):
        """The feet and their covariances."""
        feet = np.array([lm.block.mean for lm in landmarks]).reshape(-1, 3)
        covariance = np.array([belief.covariance(lm.block) for lm in landmarks]).reshape(-1, 3, 3)
        return feet, covariance, np.ones(len(landmarks), dtype=bool)


PLANES = PlaneFamily()
