"""Properties that every pair of a parametrization of lines and a camera must have, on a robot."""

from collections.abc import Callable
from typing import Any

import numpy as np

from slamlib.errors import SingularPointError, SlamlibError
from slamlib.geometry.pose import Pose, compose
from slamlib.landmarks.line_innovation import distances
from slamlib.landmarks.parametrization import LineLandmark
from slamlib.manifolds import Array
from slamlib.model import Argument
from slamlib.modeling.numerical import central_difference, complex_step
from slamlib.observation.lines import initialize_line, observe_line, undistort_segments
from slamlib.sensors.sensor import Calibration
from slamlib.testing.judge import Judge
from slamlib.testing.landmarks import IDENTITY
from slamlib.testing.models import BATCH, DIFFERENCE, JACOBIAN, VALUE, named
from slamlib.testing.pairs import stays_positive
from slamlib.testing.sensors import visible_points

DEFINED = "a segment makes a line"
NO_LINES = "a sensor that sees no lines says so"
THROUGH = "a line just initialized goes through both ends of its segment"
FINITE = "at nasty places all numbers are finite, or it is refused"

FRAMES = [Argument("robot", Pose), Argument("extrinsics", Pose)]
Place = list[Array]


class _Chain:
    """observe_line or initialize_line as a model of all that they give a Jacobian by, the camera's parameters last."""

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


def line_pair_properties(judge: Judge, kind: LineLandmark, calibration: Calibration) -> None:
    """From random robots and mounts, segments everywhere in the image; a sensor without lines must refuse."""
    name, rng = f"{kind.name} x {calibration.sensor.name}", judge.rng
    if calibration.sensor.project_line is None:
        _refused(judge, kind, calibration, name)
        return
    initialized, observed = _initialized(kind, calibration), _observed(kind, calibration)
    made, seen = [], []
    segments = _segments(calibration, rng, 8)
    if not segments:
        judge.fail(DEFINED, name, "it sees too few directions for a segment", {})
    for segment in segments:
        place = [Pose.random(rng), Pose.random(rng), segment, rng.uniform(0.1, 0.5, 2)]
        try:
            landmark, G = initialize_line(kind, calibration, *place)
        except SingularPointError as error:
            judge.fail(
                DEFINED, name, str(error).split(", at")[0], dict(zip(initialized.parameters, place, strict=False))
            )
            continue
        judge.hold(DEFINED)
        made.append(place)
        seen.append([*place[:2], landmark])
        _seen_again(judge, kind, calibration, place, landmark, G, name)
    if not made:
        return
    elsewhere = [[Pose.random(rng), Pose.random(rng), landmark] for *_, landmark in seen]
    for chain, places, ordinary in ((initialized, made, made), (observed, [*seen, *elsewhere], elsewhere)):
        for place in places:
            _derivatives(judge, chain, place, name)
        _batch(judge, chain, ordinary, name)
    _nasty(judge, kind, observed, made[0], name)


def _initialized(kind: LineLandmark, calibration: Calibration) -> _Chain:
    def run(camera: Calibration, *place: Array) -> Any:
        return initialize_line(kind, camera, *place)

    own = [*FRAMES, Argument("measurement", 4), Argument("unmeasured", 2)]
    return _Chain(run, own, calibration, [n for n, g in calibration.given.items() if len(g)])


def _observed(kind: LineLandmark, calibration: Calibration) -> _Chain:
    """With the same chain of the formulas as they are written, so that the derivatives can be had exactly."""
    project: Any = calibration.sensor.project_line
    padded = {n: calibration.padded[n] for n in project.parameters if n in calibration.given}
    names = [n for n in padded if len(calibration.given[n])]

    def run(camera: Calibration, *place: Array) -> Any:
        seen = observe_line(kind, camera, *place)
        return seen.value, seen.jacobians

    def definition(robot: Array, extrinsics: Array, landmark: Array, *given: Array) -> Array:
        line = kind.to_frame.definition(compose.definition(robot, extrinsics), landmark)
        own = {n: np.append(g, padded[n][len(g) :]) for n, g in zip(names, given, strict=True)}
        return project.definition(line, *(padded | own).values())

    chain = _Chain(run, [*FRAMES, Argument("landmark", kind.manifold)], calibration, names)
    chain.definition = definition
    return chain


def _refused(judge: Judge, kind: LineLandmark, calibration: Calibration, name: str) -> None:
    try:
        observe_line(kind, calibration, IDENTITY, IDENTITY, kind.manifold.random(judge.rng))
    except SlamlibError as error:
        told = kind.name in str(error) and calibration.sensor.name in str(error)
        judge.require(NO_LINES, name, told, f"the error does not name both: {error}", {})
    else:
        judge.fail(NO_LINES, name, "observe_line gives a line", {})


def _segments(calibration: Calibration, rng: np.random.Generator, count: int) -> list[Array]:
    """Pairs of pixels (4,), each the first of ten that the camera sees and the one farthest from it."""
    found = []
    for points in np.array_split(visible_points(calibration, rng, 10 * count), count):
        if len(points) > 1:
            rays = points[:, :3] / np.linalg.norm(points[:, :3], axis=1, keepdims=True)
            far = points[[0, int(np.argmin(rays @ rays[0]))]]
            found.append(calibration.project(far)[:, :2].ravel())
    return found


def _seen_again(
    judge: Judge, kind: LineLandmark, calibration: Calibration, place: Place, landmark: Array, G: Any, name: str
) -> None:
    """The line where it was measured; then in a belief beside the robot, corrected by the distances of both ends."""
    robot, extrinsics, segment, _ = place
    where = {"robot": robot, "extrinsics": extrinsics, "measurement": segment}
    seen = observe_line(kind, calibration, robot, extrinsics, landmark)
    off, D = distances.jac(seen.value, undistort_segments(calibration, segment)[0])
    if not judge.compare(THROUGH, name, off, np.zeros(2), where, argument="measurement", tolerance=1e-7):
        return
    H = [-D.line @ J for J in (seen.jacobians.robot, seen.jacobians.landmark)]
    stays_positive(judge, kind, landmark, G, H, (np.eye(4), np.eye(2)), name, where)


def _derivatives(judge: Judge, chain: _Chain, place: Place, name: str) -> None:
    """By each argument, relative to the largest entry, since a derivative by a pixel is small."""
    value, jacobians = chain.run(chain.calibration, *place)
    full = [*place, *chain.given]
    where = named(chain, full)
    exact = hasattr(chain, "definition")
    if exact:
        judge.compare(VALUE, name, value, chain.definition(*full), where)
    for i, argument in enumerate(chain.arguments):
        step = 1e-6 * max(1.0, float(np.abs(full[i]).max()))
        numerical = complex_step(chain, full, i) if exact else central_difference(chain, full, i, step)
        size = s if (s := np.abs(numerical).max()) > 1e-9 else 1.0
        what, tolerance = (JACOBIAN, 1e-9) if exact else (DIFFERENCE, 1e-5)
        found = getattr(jacobians, argument.name) / size
        judge.compare(what, name, found, numerical / size, where, argument=argument.name, tolerance=tolerance)


def _batch(judge: Judge, chain: _Chain, places: list[Place], name: str) -> None:
    """All places at once, in two rows."""
    places = places[: len(places) // 2 * 2]
    value, jacobians = chain.run(
        chain.calibration, *(np.reshape(c, (2, -1, len(c[0]))) for c in zip(*places, strict=True))
    )
    single = [chain.run(chain.calibration, *place) for place in places]
    for k, argument in enumerate(("", *jacobians._fields)):
        wanted = np.stack([[v, *J][k] for v, J in single])
        wanted = wanted.reshape(2, len(places) // 2, *wanted.shape[1:])
        judge.compare(BATCH, name, [value, *jacobians][k], wanted, {}, argument=argument)


def _nasty(judge: Judge, kind: LineLandmark, observed: _Chain, ordinary: Place, name: str) -> None:
    """Lines at infinity, behind the camera and through its centre; segments without a length."""
    robot, extrinsics, segment, _ = ordinary
    calibration = observed.calibration
    endpoints = segment.reshape(2, 2)
    point = np.tile(endpoints[0], 2)
    priors = [np.array(p) for p in ([0.0, 0.0], [0.1, 0.0], [0.0, 0.1], [-0.1, 0.2], [-0.2, -0.1], [1e-9, 1e-9])]
    for s, p in [*((segment, p) for p in priors), (point, np.array([0.1, 0.2])), (endpoints[::-1].ravel(), priors[1])]:
        where = {"robot": robot, "extrinsics": extrinsics, "measurement": s, "unmeasured": p}
        landmark = _finite(judge, name, where, initialize_line, kind, calibration, robot, extrinsics, s, p)
        if landmark is None:
            continue
        for camera in _cameras(kind, landmark, robot, extrinsics):
            place = [camera, IDENTITY, landmark]
            where = dict(zip(observed.parameters, place, strict=False))
            if _finite(judge, name, where, observed.run, calibration, *place) is not None:
                _derivatives(judge, observed, place, name)


def _cameras(kind: LineLandmark, landmark: Array, robot: Array, extrinsics: Array) -> list[Array]:
    """Where it was measured, the same looking back, from a point of the line itself, and from the world's origin."""
    here = compose(robot, extrinsics)
    w, x, y, z = here[3:]
    behind = np.array([*here[:3], -y, -z, w, x])  # half a turn about its own axis that points down
    point = kind.point_at.definition(landmark, 0.3)
    if not np.abs(point[3]) > 1e-6 * np.abs(point[:3]).max():
        return [here, behind, IDENTITY]
    return [here, behind, np.array([*point[:3] / point[3], *here[3:]]), IDENTITY]


def _finite(judge: Judge, name: str, where: dict[str, Array], run: Callable[..., Any], *arguments: Any) -> Array | None:
    """The value, or None where it is refused; all of its numbers and of its Jacobians' must be finite."""
    try:
        value, jacobians = run(*arguments)
    except SingularPointError:
        judge.hold(FINITE)
        return None
    wrong = [
        n for n, J in zip(("value", *jacobians._fields), (value, *jacobians), strict=True) if not np.isfinite(J).all()
    ]
    judge.require(FINITE, name, not wrong, "not finite, and not refused", where, argument=", ".join(wrong))
    return None if wrong else value
