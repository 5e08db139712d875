"""Minimal SLAM in the plane: a pose x, y, heading; odometry; range and bearing of points, known data association.

The formulas take leading axes: one robot, or as many particles as there are. Angles in radians, lengths in metres.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from slambook.report.angles import wrapped
from slamlib.manifolds import Array, Indices


def moved(pose: Array, u: Array) -> Array:
    """Poses (..., 3) after the motion u (..., 3) = (ahead, left, turn), given in the robot's own axes."""
    c, s = np.cos(pose[..., 2]), np.sin(pose[..., 2])
    ahead, left, turn = np.moveaxis(u, -1, 0)
    x, y, heading = np.moveaxis(pose, -1, 0)
    return np.stack([x + c * ahead - s * left, y + s * ahead + c * left, heading + turn], -1)


def moved_by(pose: Array, u: Array) -> tuple[Array, Array]:
    """Derivatives (3, 3) of `moved` w.r.t. one pose (3,) and its motion (3,)."""
    c, s = np.cos(pose[2]), np.sin(pose[2])
    F = np.array([[1, 0, -s * u[0] - c * u[1]], [0, 1, c * u[0] - s * u[1]], [0, 0, 1]])
    return F, np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def seen(pose: Array, points: Array) -> Array:
    """Range and bearing (..., m, 2) of points (..., m, 2) from poses (..., 3)."""
    dx, dy = np.moveaxis(points - pose[..., None, :2], -1, 0)
    return np.stack([np.hypot(dx, dy), wrapped(np.arctan2(dy, dx) - pose[..., None, 2])], -1)


def seen_by_point(pose: Array, points: Array) -> Array:
    """Derivative (..., m, 2, 2) of `seen` w.r.t. the points; w.r.t. the position its sign is opposite."""
    dx, dy = np.moveaxis(points - pose[..., None, :2], -1, 0)
    r = np.hypot(dx, dy)
    rows = (dx / r, dy / r), (-dy / r**2, dx / r**2)
    return np.stack([np.stack(row, -1) for row in rows], -2)


def placed(pose: Array, z: Array) -> Array:
    """Points (..., m, 2) at range and bearing z (m, 2) from poses (..., 3)."""
    angle = pose[..., None, 2] + z[:, 1]
    return pose[..., None, :2] + z[:, :1] * np.stack([np.cos(angle), np.sin(angle)], -1)


@dataclass(frozen=True)
class PlanarScan:
    """Measurements of a step: numbers of the points (m,), and range and bearing of each (m, 2)."""

    names: Indices
    z: Array


@dataclass(frozen=True, eq=False)
class Data:
    """One path through a world: the truth and the measurements.

    points (L, 2); truth (n + 1, 3); odometry (n, 3) with standard deviations motion_std (3,); scans: n + 1, the
    first from the start, with standard deviations look_std (2,).
    """

    points: Array
    truth: Array
    odometry: Array
    scans: list[PlanarScan]
    motion_std: Array
    look_std: Array


MOTION = np.array([0.05, 0.02, np.radians(1.0)])  # [m, m, rad] in a step of 0.8 m
LOOK = np.array([0.1, np.radians(1.5)])  # [m, rad]
LAP = 60  # steps
SCANNERS: dict[str, dict[str, Any]] = {  # what `drive` takes; the coarse one is a sonar's, on wheels that slip
    "usual scanner": {},
    "precise scanner": {"scan_std": LOOK / 10},
    "coarse scanner": {"scan_std": LOOK * [1, 6], "motion_std": MOTION * [2, 2, 5], "reach": 4.0},
}


def drive(
    rng: np.random.Generator,
    steps: int = 120,
    landmarks: int = 20,
    reach: float = 6.0,
    motion_std: Array = MOTION,
    scan_std: Array = LOOK,
) -> Data:
    """Round and round in a ring of points: 60 steps of 0.8 m a lap. The world is the same for all; the noise is not."""
    angle = 2 * np.pi * np.arange(landmarks) / landmarks
    radius = 48 / (2 * np.pi) + np.where(np.arange(landmarks) % 2, 2.5, -2.0)
    points = radius[:, None] * np.stack([np.cos(angle), np.sin(angle)], -1)
    u, truth = np.array([0.8, 0, 2 * np.pi / LAP]), [np.array([48 / (2 * np.pi), 0, np.pi / 2])]
    for _ in range(steps):
        truth.append(moved(truth[-1], u))
    scans = []
    for pose in truth:
        z = seen(pose, points)
        names = np.flatnonzero(z[:, 0] < reach)
        scans.append(PlanarScan(names, z[names] + scan_std * rng.standard_normal((len(names), 2))))
    return Data(points, np.array(truth), u + motion_std * rng.standard_normal((steps, 3)), scans, motion_std, scan_std)
