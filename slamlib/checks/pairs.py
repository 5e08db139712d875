"""Properties that every pair of a parametrization and a sensor must have, on a robot: initialize, observe, update."""

import numpy as np

from slamlib.belief import Belief
from slamlib.checks.judge import Case, Judge
from slamlib.checks.landmarks import pose_for
from slamlib.checks.sensors import unmeasured, visible_points
from slamlib.errors import SingularPointError
from slamlib.geometry.pose import Pose
from slamlib.landmarks.parametrization import LineLandmark, PointLandmark
from slamlib.manifolds import Array
from slamlib.observation.points import NamedJacobians, initialize, observe
from slamlib.sensors.sensor import Calibration

DEFINED = "a measurement makes a landmark"
REFUSED = "a measurement that it cannot represent is refused, not reversed"
AGAIN = "a landmark just initialized is predicted where it was measured"
VISIBLE = "a landmark just initialized is visible"
DERIVATIVES = (
    "that holds whatever the robot, the extrinsics and the parameters are: H G_y = 1, H_x + H G_x = 0, H G_u = 0"
)
POSITIVE = "initialize and update keep the covariance symmetric and positive"


def pair_properties(judge: Judge, kind: PointLandmark, calibration: Calibration) -> None:
    """From random robots and extrinsics, points in every direction that the sensor sees; it may refuse all of them."""
    rng, sensor = judge.rng, calibration.sensor
    if kind.plane != sensor.plane:
        return  # one knows of heights of which the other does not
    for point in visible_points(calibration, rng, 12):
        robot, extrinsics, hidden = pose_for(kind, rng), pose_for(kind, rng), unmeasured(calibration, rng)
        y = calibration.project(point)
        case = judge.at(f"{kind.name} x {sensor.name}", robot=robot, extrinsics=extrinsics, measurement=y)
        try:
            landmark, G = initialize(kind, calibration, robot, extrinsics, y, *hidden)
            seen = observe(kind, calibration, robot, extrinsics, landmark)
        except SingularPointError:
            case.hold(REFUSED)
            continue
        case.hold(DEFINED)
        if not case.require(VISIBLE, seen.visible, "it is not: its position is wrong"):
            continue
        if not case.compare(AGAIN, y + sensor.manifold.minus(seen.value, y), y, tolerance=1e-7):
            continue
        H, R = seen.jacobians, calibration.noise
        follows(case, DERIVATIVES, H, G, np.eye(len(y)))
        corrected(case, kind, landmark, G, G.measurement @ R @ G.measurement.T, [H.robot, H.landmark], R)


def follows(case: Case, what: str, H: NamedJacobians, G: NamedJacobians, wanted: Array) -> None:
    """Check that a new landmark, observed again, moves with its measurement, as `wanted`, and with nothing else.

    H: Jacobians of the predicted measurement; G: those of the new landmark, of which the arguments that H lacks are not
    judged, but for the measurement and what it leaves open.
    """
    for argument, by in vars(G).items():
        own = getattr(H, argument, 0.0 if argument in ("measurement", "unmeasured") else None)
        if own is not None:
            found = H.landmark @ by + own
            case.compare(what, found, wanted if argument == "measurement" else np.zeros_like(found), argument, 1e-6)


def corrected(
    case: Case,
    kind: PointLandmark | LineLandmark,
    landmark: Array,
    G: NamedJacobians,
    own: Array,
    H: list[Array],
    R: Array,
) -> None:
    """Add a landmark to a belief with the robot, known to about a centimetre, and do one measurement update.

    own: the landmark's covariance by its measurement. The joint covariance is symmetric and has no negative eigenvalue,
    beside its largest entry.
    """
    rng = case.judge.rng
    belief, root = Belief(), 0.01 * rng.standard_normal((6, 6))
    robot = belief.add(Pose, case.where["robot"], root @ root.T + 1e-6 * np.eye(6))
    if hasattr(G, "unmeasured"):
        own = own + 0.04 * G.unmeasured @ G.unmeasured.T
    block = belief.add(kind.manifold, landmark, (own + own.T) / 2, given=[robot], jacobians=[G.robot])
    belief.update([robot, block], H, np.linalg.cholesky(R) @ rng.standard_normal(len(R)), R)
    P = belief.matrix
    scale, least = np.abs(P).max(), np.linalg.eigvalsh(P)[0]
    symmetric = np.abs(P - P.T).max() <= 1e-12 * scale
    how = f"the smallest eigenvalue is {least:.3g} of {scale:.3g}, symmetric: {symmetric}"
    case.require(POSITIVE, symmetric and least >= -1e-12 * scale, how)
