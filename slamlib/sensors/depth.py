"""Depth camera (RGB-D): a pixel and the depth along the optical axis, (u, v, z) [px, px, m]."""

import numpy as np

from slamlib.analytic import sqrt
from slamlib.models import AtMost, model
from slamlib.sensors import pinhole
from slamlib.sensors.sensor import Calibration, Sensor
from slamlib.sensors.stages import BackProjection


@model(point=4, intrinsics=4, distortion=AtMost(8))
def project(point, intrinsics, distortion):
    """Pixel and depth of a homogeneous point; no depth at infinity. Chapter depth_stereo_range, eq. (dp-depth)."""
    return np.concatenate([pinhole.project(point, intrinsics, distortion), point[2:3] / point[3]])


@model(ideal=2, depth=1)
def lift(ideal, depth):
    """Unit ray and inverse distance [1/m] of an ideal point and a depth [m]. Eq. (dp-lift)."""
    ray = np.array([*ideal, 1])
    return np.array([*ray, 1 / depth[0]]) / sqrt(ray @ ray)


def visible(point, calibration):
    """Mask of the points in the pin-hole's view, at a finite depth between the limits `near` and `far` [m]."""
    z, w = point[..., 2], point[..., 3]
    near, far = calibration.limits.get("near", 0), calibration.limits.get("far", np.inf)
    within = (w > 0) & (z >= near * w) & (z <= far * np.where(w > 0, w, 1))
    return within & pinhole.visible(point, calibration)


def check(calibration):
    """Raise SlamlibError unless it is a valid pin-hole camera."""
    radius = {n: v for n, v in calibration.limits.items() if n == "radius"}
    Calibration(pinhole.PINHOLE, calibration.noise[:2, :2], image=calibration.image, limits=radius, **calibration.given)


back_project = BackProjection(pinhole.ideal_point, lift, size=3)
PARAMETERS = ("intrinsics", "distortion")
LIMITS = ("near", "far", "radius")
PINHOLE_DEPTH = Sensor("pinHoleDepth", project, back_project, PARAMETERS, visible, check, limits=LIMITS, pixels=True)
