"""Properties that every pair of a parametrization of lines and a camera must have, on a robot."""

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np

from slamlib.errors import SingularPointError, SlamlibError
from slamlib.geometry.pose import Pose, compose
from slamlib.landmarks.line_innovation import distances
from slamlib.landmarks.parametrization import LineLandmark
from slamlib.manifolds import Array
from slamlib.model import Argument
from slamlib.observation.lines import ideal_parameters, initialize_line, observe_line, without_distortion
from slamlib.sensors.sensor import Calibration
from slamlib.testing.judge import Case, Judge
from slamlib.testing.landmarks import IDENTITY
from slamlib.testing.models import derivatives, model_properties, named
from slamlib.testing.pairs import DEFINED, corrected
from slamlib.testing.sensors import visible_points

NO_LINES = "a sensor that sees no lines says so"
THROUGH = "a line just initialized goes through both endpoints of its segment"
FINITE = "in degenerate cases all numbers are finite, or it is refused"

FRAMES = [Argument("robot", Pose), Argument("extrinsics", Pose)]
Place = list[Array]


class _Chain:
    """observe_line or initialize_line as a model of all that they give a Jacobian w.r.t., the camera's parameters last.

    `jac` takes the parameters from the calibration; what it is called with is a place to differentiate at.
    """

    result = None
    definition: Callable[..., Array]

    def __init__(
        self, run: Callable[..., Any], own: list[Argument], calibration: Calibration, names: list[str]
    ) -> None:
        self.run, self.calibration, self.names, self.own = run, calibration, names, len(own)
        self.given = [calibration.given[n] for n in names]
        self.arguments = [*own, *(Argument(n, len(g)) for n, g in zip(names, self.given, strict=True))]
        self.parameters = [a.name for a in self.arguments]

    def __call__(self, *place: Array) -> Array:
        c = self.calibration
        given = {**c.given, **dict(zip(self.names, place[self.own :], strict=True))}
        other = Calibration(c.sensor, c.noise, image=c.image, limits=c.limits, **given)
        return self.run(other, *place[: self.own])[0]

    def jac(self, *place: Array) -> tuple[Array, Any]:
        return self.run(self.calibration, *place[: self.own])


def line_pair_properties(judge: Judge, kind: LineLandmark, calibration: Calibration) -> None:
    """From random robots and extrinsics, segments everywhere in the image; a sensor without lines must refuse."""
    name, rng = f"{kind.name} x {calibration.sensor.name}", judge.rng
    if calibration.sensor.project_line is None:
        _refused(judge.at(name), kind, calibration)
        return
    initialized, observed = _initialized(kind, calibration), _observed(kind, calibration)
    made, seen = [], []
    segments = _segments(calibration, rng, 8)
    if not segments:
        judge.at(name).fail(DEFINED, "it sees too few directions for a segment")
    for segment in segments:
        place = [Pose.random(rng), Pose.random(rng), segment, rng.uniform(0.1, 0.5, 2), *initialized.given]
        case = judge.at(name, **named(initialized, place))
        try:
            landmark, G = initialized.jac(*place)
        except SingularPointError as error:
            case.fail(DEFINED, str(error).split(", at")[0])
            continue
        case.hold(DEFINED)
        made.append(place)
        seen.append([*place[:2], landmark, *observed.given])
        _seen_again(case, kind, calibration, landmark, G)
    if made:
        elsewhere = [[Pose.random(rng), Pose.random(rng), *place[2:]] for place in seen]
        model_properties(judge, initialized, name, made, chain=True)
        model_properties(judge, observed, name, elsewhere, seen, chain=True)
        _nasty(judge, kind, initialized, observed, made[0], name)


def _initialized(kind: LineLandmark, calibration: Calibration) -> _Chain:
    own = [*FRAMES, Argument("measurement", 4), Argument("unmeasured", 2)]
    names = [n for n, g in calibration.given.items() if len(g)]
    return _Chain(partial(initialize_line, kind), own, calibration, names)


def _observed(kind: LineLandmark, calibration: Calibration) -> _Chain:
    """Against the same chain of the written formulas, whose derivatives are exact."""
    project: Any = calibration.sensor.project_line
    given_ones = ideal_parameters(calibration)
    names = [n for n, g in given_ones.items() if len(g)]

    def run(camera: Calibration, *place: Array) -> Any:
        seen = observe_line(kind, camera, *place)
        return seen.value, seen.jacobians

    def definition(robot: Array, extrinsics: Array, landmark: Array, *given: Array) -> Array:
        line = kind.to_frame.definition(compose.definition(robot, extrinsics), landmark)
        return project.definition(line, *(given_ones | dict(zip(names, given, strict=True))).values())

    chain = _Chain(run, [*FRAMES, Argument("landmark", kind.manifold)], calibration, names)
    chain.definition = definition
    return chain


def _refused(case: Case, kind: LineLandmark, calibration: Calibration) -> None:
    try:
        observe_line(kind, calibration, IDENTITY, IDENTITY, kind.manifold.random(case.judge.rng))
    except SlamlibError as error:
        told = kind.name in str(error) and calibration.sensor.name in str(error)
        case.require(NO_LINES, told, f"the error does not name both: {error}")
    else:
        case.fail(NO_LINES, "observe_line gives a line")


def _segments(calibration: Calibration, rng: np.random.Generator, count: int) -> list[Array]:
    """Pairs of pixels (4,), each the first of ten that the camera sees and the one farthest from it."""
    found = []
    for points in np.array_split(visible_points(calibration, rng, 10 * count), count):
        if len(points) > 1:
            rays = points[:, :3] / np.linalg.norm(points[:, :3], axis=1, keepdims=True)
            far = points[[0, int(np.argmin(rays @ rays[0]))]]
            found.append(calibration.project(far)[:, :2].ravel())
    return found


def _seen_again(case: Case, kind: LineLandmark, calibration: Calibration, landmark: Array, G: Any) -> None:
    """The line where it was measured; then in a belief with the robot, updated by the distances of both endpoints."""
    seen = observe_line(kind, calibration, case.where["robot"], case.where["extrinsics"], landmark)
    points, _ = calibration.back_project_jac(case.where["measurement"].reshape(2, 2), np.ones((2, 1)))
    endpoints = calibration.sensor.project(points, **without_distortion(calibration))[:, :2].ravel()
    off, D = distances.jac(seen.value, endpoints)
    if case.compare(THROUGH, off, np.zeros(2), "measurement", 1e-7):
        H = [-D.line @ J for J in (seen.jacobians.robot, seen.jacobians.landmark)]
        corrected(case, kind, landmark, G, G.measurement @ G.measurement.T, H, np.eye(2))


def _nasty(judge: Judge, kind: LineLandmark, initialized: _Chain, observed: _Chain, ordinary: Place, name: str) -> None:
    """Lines at infinity, behind the camera and through its centre; segments without a length."""
    robot, extrinsics, segment, _, *given = ordinary
    priors = [np.array(p) for p in ([0.0, 0.0], [0.1, 0.0], [0.0, 0.1], [-0.1, 0.2], [-0.2, -0.1], [1e-9, 1e-9])]
    turned, point = np.roll(segment, 2), np.tile(segment[:2], 2)
    for s, p in [*((segment, p) for p in priors), (point, np.array([0.1, 0.2])), (turned, priors[1])]:
        made = _finite(judge, initialized, name, [robot, extrinsics, s, p, *given])
        if made is None:
            continue
        for camera in _cameras(kind, made[0], robot, extrinsics):
            place = [camera, IDENTITY, made[0], *observed.given]
            if seen := _finite(judge, observed, name, place):
                derivatives(judge.at(name, **named(observed, place)), observed, place, *seen, chain=True)


def _cameras(kind: LineLandmark, landmark: Array, robot: Array, extrinsics: Array) -> list[Array]:
    """Where it was measured, the same facing backwards, from a point of the line, and from the world's origin."""
    here = compose(robot, extrinsics)
    w, x, y, z = here[3:]
    behind = np.array([*here[:3], -y, -z, w, x])  # half a turn about its own axis that points down
    point = kind.point_at.definition(landmark, 0.3)
    finite = np.abs(point[3]) > 1e-6 * np.abs(point[:3]).max()
    return [here, behind, *([np.array([*point[:3] / point[3], *here[3:]])] if finite else []), IDENTITY]


def _finite(judge: Judge, chain: _Chain, name: str, place: Place) -> tuple[Array, Any] | None:
    """The value and its Jacobians, all of whose numbers must be finite; None where refused, or not finite."""
    case = judge.at(name, **named(chain, place))
    try:
        value, jacobians = chain.jac(*place)
    except SingularPointError:
        case.hold(FINITE)
        return None
    parts = zip(("value", *jacobians._fields), (value, *jacobians), strict=True)
    wrong = [n for n, part in parts if not np.isfinite(part).all()]
    case.require(FINITE, not wrong, "not finite, and not refused", ", ".join(wrong))
    return None if wrong else (value, jacobians)
