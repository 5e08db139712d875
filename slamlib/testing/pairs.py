"""Properties that every pair of a parametrization and a sensor must have, on a robot: initialize, observe, correct."""

from typing import Any

import numpy as np

from slamlib.belief import Belief
from slamlib.errors import SingularPointError
from slamlib.geometry.pose import Pose
from slamlib.landmarks.parametrization import PointLandmark
from slamlib.manifolds import Array
from slamlib.observation.points import initialize, observe
from slamlib.sensors.sensor import Calibration
from slamlib.testing.judge import Judge
from slamlib.testing.sensors import difference, unmeasured, visible_points

DEFINED = "a measurement makes a landmark"
REFUSED = "a measurement that it cannot hold is refused, not turned round"
AGAIN = "a landmark just initialized is seen again where it was measured"
VISIBLE = "a landmark just initialized is visible"
DERIVATIVES = (
    "that holds whatever the robot, the extrinsics and the parameters are: H G_y = 1, H_x + H G_x = 0, H G_u = 0"
)
POSITIVE = "initialize and update keep the covariance symmetric and positive"


def pair_properties(judge: Judge, kind: PointLandmark, calibration: Calibration) -> None:
    """From random robots and mounts, points in every direction that the sensor sees; refusing all is allowed, too."""
    rng, sensor = judge.rng, calibration.sensor
    name = f"{kind.name} x {sensor.name}"
    for point in visible_points(calibration, rng, 12):
        robot, extrinsics, hidden = Pose.random(rng), Pose.random(rng), unmeasured(calibration, rng)
        y = calibration.project(point)
        where = {"robot": robot, "extrinsics": extrinsics, "measurement": y}
        try:
            landmark, G = initialize(kind, calibration, robot, extrinsics, y, *hidden)
            seen = observe(kind, calibration, robot, extrinsics, landmark)
        except SingularPointError:
            judge.hold(REFUSED)
            continue
        judge.hold(DEFINED)
        if not judge.require(VISIBLE, name, seen.visible, "it is not: it stands somewhere else", where):
            continue
        again = y + difference(sensor, seen.value, y)
        if not judge.compare(AGAIN, name, again, y, where, tolerance=1e-7):
            continue
        H = seen.jacobians
        for argument in G._fields:
            found = H.landmark @ getattr(G, argument) + (getattr(H, argument) if argument in H._fields else 0)
            wanted = np.eye(len(y)) if argument == "measurement" else np.zeros_like(found)
            judge.compare(DERIVATIVES, name, found, wanted, where, argument=argument, tolerance=1e-6)
        R = calibration.noise
        stays_positive(judge, kind, landmark, G, [H.robot, H.landmark], (R, R), name, {"robot": robot})


def stays_positive(
    judge: Judge,
    kind: Any,
    landmark: Array,
    G: Any,
    H: list[Array],
    noises: tuple[Array, Array],
    name: str,
    where: dict[str, Array],
) -> None:
    """A landmark into a belief beside the robot, which is known to a centimetre or so, and one update by robot and
    landmark: the covariance is symmetric and has no negative eigenvalue, beside its largest entry.

    noises: of the measurement that it is made of, and of the one that corrects it.
    """
    belief, root, (noise, R) = Belief(), 0.01 * judge.rng.standard_normal((6, 6)), noises
    robot = belief.add(Pose, where["robot"], root @ root.T + 1e-6 * np.eye(6))
    own = G.measurement @ noise @ G.measurement.T
    if hasattr(G, "unmeasured"):
        own = own + 0.04 * G.unmeasured @ G.unmeasured.T
    block = belief.add(kind.manifold, landmark, (own + own.T) / 2, given=[robot], jacobians=[G.robot])
    belief.update([robot, block], H, np.linalg.cholesky(R) @ judge.rng.standard_normal(len(R)), R)
    P = belief.matrix
    scale, least = np.abs(P).max(), np.linalg.eigvalsh(P)[0]
    symmetric = np.abs(P - P.T).max() <= 1e-12 * scale
    how = f"the smallest eigenvalue is {least:.3g} of {scale:.3g}, symmetric: {symmetric}"
    judge.require(POSITIVE, name, symmetric and least >= -1e-12 * scale, how, where)
