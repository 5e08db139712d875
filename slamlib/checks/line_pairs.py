"""Properties that every pair of a parametrization of lines and a camera must have, on a robot."""

import numpy as np

from slamlib.checks.judge import Case, Judge
from slamlib.checks.pairs import DEFINED, corrected, follows
from slamlib.checks.sensors import visible_points
from slamlib.errors import SingularPointError, SlamlibError
from slamlib.geometry.pose import ORIGIN, Pose
from slamlib.landmarks.line_innovation import distances
from slamlib.landmarks.parametrization import LineLandmark
from slamlib.manifolds import Array
from slamlib.observation.lines import initialize_line, observe_line, undistort_segments
from slamlib.observation.points import NamedJacobians
from slamlib.sensors.sensor import Calibration

NO_LINES = "a sensor that sees no lines says so"
THROUGH = "a line just initialized goes through both endpoints of its segment"
FOLLOWS = "and follows them, whatever robot, extrinsics and prior are: H G_y = Z_y, H_x + H G_x = 0, H G_u = 0"


def line_pair_properties(judge: Judge, kind: LineLandmark, calibration: Calibration) -> None:
    """From random robots and extrinsics, segments everywhere in the image; a sensor without lines must refuse."""
    name, rng = f"{kind.name} x {calibration.sensor.name}", judge.rng
    if calibration.sensor.project_line is None:
        _refused(judge.at(name), kind, calibration)
        return
    segments = visible_segments(calibration, rng, 8)
    if not segments:
        judge.at(name).fail(DEFINED, "it sees too few directions for a segment")
    for segment in segments:
        robot, extrinsics, prior = Pose.random(rng), Pose.random(rng), rng.uniform(0.1, 0.5, 2)
        case = judge.at(name, robot=robot, extrinsics=extrinsics, measurement=segment, unmeasured=prior)
        try:
            landmark, G = initialize_line(kind, calibration, robot, extrinsics, segment, prior)
        except SingularPointError as error:
            case.fail(DEFINED, str(error).split(", at")[0])
            continue
        case.hold(DEFINED)
        seen = observe_line(kind, calibration, robot, extrinsics, landmark)
        endpoints, by_segment = undistort_segments(calibration, segment)
        off, Z = distances.jac(seen.value, endpoints)
        if case.compare(THROUGH, off, np.zeros(2), "measurement", 1e-7):
            arguments = ("robot", "extrinsics", "landmark")
            H = NamedJacobians(**{name: -Z.line @ getattr(seen.jacobians, name) for name in arguments})
            follows(case, FOLLOWS, H, G, Z.segment @ by_segment)
            corrected(case, kind, landmark, G, G.measurement @ G.measurement.T, [H.robot, H.landmark], np.eye(2))


def _refused(case: Case, kind: LineLandmark, calibration: Calibration) -> None:
    try:
        observe_line(kind, calibration, ORIGIN, ORIGIN, kind.manifold.random(case.judge.rng))
    except SlamlibError as error:
        told = kind.name in str(error) and calibration.sensor.name in str(error)
        case.require(NO_LINES, told, f"the error does not name both: {error}")
    else:
        case.fail(NO_LINES, "observe_line gives a line")


def visible_segments(calibration: Calibration, rng: np.random.Generator, count: int) -> list[Array]:
    """Pairs of pixels (4,), each the first of ten that the camera sees and the one farthest from it."""
    found = []
    for points in np.array_split(visible_points(calibration, rng, 10 * count), count):
        if len(points) > 1:
            rays = points[:, :3] / np.linalg.norm(points[:, :3], axis=1, keepdims=True)
            far = points[[0, int(np.argmin(rays @ rays[0]))]]
            found.append(calibration.project(far)[:, :2].ravel())
    return found
