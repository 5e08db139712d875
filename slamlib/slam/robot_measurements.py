"""Measurements of a robot's own pose that belong to no landmark: a position by GPS, a heading by a compass."""

from dataclasses import dataclass

import numpy as np

from slamlib.belief import Belief
from slamlib.data.records import RobotMeasurement
from slamlib.manifolds import Array, Euclidean
from slamlib.slam.data_association.gates import gate
from slamlib.slam.entities import POSE, Robot
from slamlib.slam.linearization import Linearization
from slamlib.slam.options import Options


@dataclass(frozen=True, eq=False)
class RobotUpdate:
    """What became of one: innovation z (m,), its covariance S (m, m), nis = z' S^-1 z; whether it passed the gate."""

    name: str
    innovation: Array
    covariance: Array
    nis: float
    inlier: bool


def update_by_robot(
    belief: Belief,
    robot: Robot,
    measurement: RobotMeasurement,
    options: Options,
    linearization: Linearization | None = None,
) -> RobotUpdate:
    """Gate a measurement of the robot's pose, and correct all blocks by it if it passes. Raises ShapeError."""
    value, J = measurement.model.jac(robot.pose)
    if linearization is not None:
        J = measurement.model.jac(linearization.at(robot.block)[:7])[1]
    result = measurement.model.result
    manifold = (result.manifold if result else None) or Euclidean(len(value))
    z = manifold.minus(measurement.value, value)
    H = np.pad(J[0], ((0, 0), (0, robot.block.dof - POSE)))
    S = belief.innovation_covariance([robot.block], [H], measurement.covariance)
    nis = float(z @ np.linalg.solve(S, z))
    inlier = nis < gate(options.gate, len(z))
    if inlier:
        belief.update([robot.block], [H], z, measurement.covariance)
    return RobotUpdate(measurement.name, z, S, nis, inlier)
