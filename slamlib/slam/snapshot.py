"""A snapshot of the filter: copies of what it believes, and of what its sensors looked at in the last frame."""

from dataclasses import replace
from typing import Any

import numpy as np

from slamlib.data.snapshots import Looks, MapView, RobotView, SensorView, Snapshot
from slamlib.observation import Family
from slamlib.slam.entities import POSE, MountedSensor
from slamlib.slam.line_endpoints import ends_in_image
from slamlib.slam.measurement_update import looks_of


def snapshot_of(slam: Any) -> Snapshot:
    """Everything that may be shown of a filter, after the frame that it saw last."""
    robots = tuple(RobotView(r.name, r.block.mean.copy(), slam.belief.covariance(r.block)) for r in slam.robots)
    sensors = tuple(_sensor_view(slam, i, sensor) for i, sensor in enumerate(slam.sensors))
    landmarks = {family.name: _map_view(slam, family) for family in slam.families.values()}
    return Snapshot(slam.number, slam.time, robots, sensors, landmarks, slam.belief.size)


def _sensor_view(slam: Any, i: int, sensor: MountedSensor) -> SensorView:
    covariance = np.zeros((POSE, POSE)) if sensor.block is None else slam.belief.covariance(sensor.block)
    looks = {f.name: _looks(slam, i, f.name, f.size(sensor.calibration)) for f in slam.families.values()}
    robot = slam.robots.index(sensor.robot)
    image = sensor.calibration.image
    return SensorView(sensor.name, robot, sensor.mount.copy(), covariance, image, slam.scans[i], looks)


def _looks(slam: Any, i: int, family: str, size: int) -> Looks:
    own = [look.landmark for look in slam.looks[i] if look.family.name == family]
    ends, spreads = ends_in_image(slam.belief, slam.sensors[i], own)
    return replace(looks_of(slam.looks[i], family, size), ends=ends, spreads=spreads)


def _map_view(slam: Any, family: Family) -> MapView:
    own = [lm for lm in slam.landmarks if isinstance(lm.kind, family.kinds)]
    kinds = tuple(landmark.kind.name for landmark in own)
    return MapView(np.array([lm.id for lm in own], dtype=int), kinds, *family.geometry(slam.belief, own))
