"""Properties that every sensor must have."""

import itertools

import numpy as np

from slamlib.checks.judge import Judge
from slamlib.checks.models import DEFINED, interface, model_properties, named
from slamlib.errors import SingularPointError
from slamlib.manifolds import Array
from slamlib.observation.lines import image_line, without_distortion
from slamlib.sensors.sensor import Calibration

SEES = "sees points in some direction"
MEASURABLE = "what is visible can be measured"
MASK = "visible is a mask of any batch, whatever the point"
RATIO = "only the ratio of the homogeneous point matters"
ROUND_TRIP = "back_project, then project gives the measurement back"
UNIT = "a measured ray has length one, so that w is the inverse distance"
INVERSE = "the Jacobians of the two models undo each other"
COMPLETE = "the measurement and the unmeasured coordinate determine a point"
LINE = "points of a line are seen on the line's image"
SOUGHT = (4000, 16000, 64000, 256000)  # directions, until one is seen
NARROWEST = 1e-6  # radians


def sensor_properties(judge: Judge, calibration: Calibration) -> None:
    """Interface; visibility; the two models one by one; then how they undo each other."""
    sensor, rng = calibration.sensor, judge.rng
    given, hidden = dict.fromkeys(sensor.parameters), {"unmeasured": None} if sensor.unmeasured else {}
    takes = {"project": {"point": 4, **given}, "back_project": {"measurement": None, **hidden, **given}}
    if not interface(judge, sensor, takes):
        return
    points = visible_points(calibration, rng, 10)
    how = f"of {sum(SOUGHT)} directions all around none is visible and inside the image"
    if not judge.at(f"{sensor.name}.visible").require(SEES, len(points) >= 10, how):
        return
    _mask(judge, calibration)
    sizes = {a.name: a.size for a in sensor.project.arguments}  # of as many coefficients as the models can have
    parameters = [np.pad(v, (0, sizes[n] - len(v))) for n, v in calibration.given.items()]
    axes = [np.array([*sign * e, w]) for e in np.eye(3) for sign in (1, -1) for w in (0.3, 0.0)]
    far = [np.array([*p[:3], 0.0]) for p in points]
    nasty = [p for p in [*axes, *far] if calibration.visible(p)]
    ordinary = [(p, *parameters) for p in points]
    model_properties(judge, sensor.project, f"{sensor.name}.project", ordinary, [(p, *parameters) for p in nasty])
    for p in [*points, *nasty]:
        visible, project = (judge.at(f"{sensor.name}.{name}", point=p) for name in ("visible", "project"))
        try:
            value, scaled = calibration.project(p), calibration.project(3 * p)
        except SingularPointError as error:
            visible.fail(MEASURABLE, f"project refuses a visible point: {str(error).split(', at')[0]}")
            continue
        visible.hold(MEASURABLE)
        project.compare(RATIO, scaled, value, "point")
    if judge.lacks(DEFINED):
        return
    measured = [(sensor.project(*place), *unmeasured(calibration, rng), *parameters) for place in ordinary]
    model_properties(judge, sensor.back_project, f"{sensor.name}.back_project", measured)
    if not judge.lacks(DEFINED):
        _undo(judge, calibration, measured)
    if sensor.project_line is not None:
        _lines(judge, calibration, points)


def visible_points(calibration: Calibration, rng: np.random.Generator, count: int) -> Array:
    """Homogeneous points (count, 4) that the sensor can measure, from all its directions, 1 to 20 m away.

    A narrow view contains few random directions: then more are drawn, ever closer to those found.
    None if there are none.
    """
    found = _seen(calibration, rng.standard_normal((SOUGHT[0], 3)), rng)
    for number in SOUGHT[1:]:
        if len(found):
            break
        # Narrow lenses see around an axis, which random directions miss.
        rays = np.concatenate([np.eye(3), -np.eye(3), rng.standard_normal((number, 3))])
        found = _seen(calibration, rays, rng)
    spread = 1.0
    while 0 < len(found) < count and spread > NARROWEST:
        spread /= 2
        rays = found[rng.integers(len(found), size=SOUGHT[0]), :3] + spread * rng.standard_normal((SOUGHT[0], 3))
        found = np.concatenate([found, _seen(calibration, rays, rng)])
    return found[:count]


def _seen(calibration: Calibration, rays: Array, rng: np.random.Generator) -> Array:
    """Points (n, 4) along those of the directions (k, 3) that the sensor can measure."""
    rays = rays / np.linalg.norm(rays, axis=1, keepdims=True)
    points = np.column_stack([rays, rng.uniform(0.05, 1, len(rays))])
    points = points[calibration.visible(points)]
    return points[calibration.inside(calibration.project(points))] if len(points) else points


def unmeasured(calibration: Calibration, rng: np.random.Generator) -> tuple[Array, ...]:
    """A value of the unmeasured coordinate: an argument of back_project, or nothing."""
    hidden = [a for a in calibration.sensor.back_project.arguments if a.name == "unmeasured"]
    return tuple(rng.uniform(0.05, 0.5, a.size) for a in hidden)


def _mask(judge: Judge, calibration: Calibration) -> None:
    case = judge.at(f"{calibration.sensor.name}.visible")
    points = judge.rng.standard_normal((3, 5, 4))
    points[0, :, 3], points[1, 0], points[1, 1, :3], points[2, :, :2] = 0, 0, 0, 0
    with np.errstate(all="raise"):
        try:
            found = np.asarray(calibration.visible(points))
            single = np.array([[bool(calibration.visible(p)) for p in row] for row in points])
        except (FloatingPointError, ValueError, TypeError) as error:
            case.fail(MASK, f"raised {type(error).__name__}: {error}", "point")
            return
    if case.require(MASK, found.dtype == bool, f"has dtype {found.dtype}, should have bool"):
        case.compare(MASK, found.astype(int), single.astype(int), "point")


def _undo(judge: Judge, calibration: Calibration, measured: list[tuple[Array, ...]]) -> None:
    """project(back_project(y, u, k), k) = y: its value, and its derivatives w.r.t. y, u and every parameter k."""
    sensor = calibration.sensor
    name, hidden = f"{sensor.name}.back_project", len(measured[0]) - 1 - len(sensor.parameters)
    points = [sensor.back_project(*place) for place in measured]
    pairs = list(zip(points, measured, strict=True))
    open_ray = hidden and all(np.allclose(point[3], place[1], rtol=1e-12, atol=0) for point, place in pairs)
    for point, place in pairs:
        case = judge.at(name, **named(sensor.back_project, place))
        y, parameters = place[0], place[1 + hidden :]
        again, H = sensor.project.jac(point, *parameters)
        _, G = sensor.back_project.jac(*place)
        case.compare(ROUND_TRIP, y + sensor.manifold.minus(again, y), y, "measurement", 1e-8)
        if open_ray:
            case.compare(UNIT, np.linalg.norm(point[:3]), 1.0)
        for i, argument in enumerate(sensor.back_project.parameters):
            found = H[0] @ G[i] + (H[i - hidden] if i > hidden else 0)
            wanted = np.eye(len(y)) if i == 0 else np.zeros_like(found)
            case.compare(INVERSE, found, wanted, argument, 1e-6)
        columns = np.column_stack([*(np.asarray(g) / _size(g) for g in tuple(G)[: 1 + hidden]), point])
        least = np.linalg.svd(columns, compute_uv=False)
        reached = int((least > 1e-8 * least[0]).sum()) - 1
        whole, where = (2, "the plane") if sensor.plane else (3, "space")
        case.require(COMPLETE, reached == whole, f"they reach {reached} of the {whole} dimensions of {where}")


def _size(matrix: Array) -> Array:
    """Lengths of the columns, so that pixels, metres and radians weigh the same."""
    lengths = np.linalg.norm(matrix, axis=0)
    return np.where(lengths > 0, lengths, 1)


def _lines(judge: Judge, calibration: Calibration, points: Array) -> None:
    """Two points and their line."""
    parameters = without_distortion(calibration)
    for p, q in itertools.pairwise(points):
        line = np.concatenate([np.cross(p[:3], q[:3]), p[3] * q[:3] - q[3] * p[:3]])
        image = image_line(calibration, line)[0]
        image = image / np.linalg.norm(image[:2])
        off = [image @ [*calibration.sensor.project(end, **parameters)[:2], 1] for end in (p, q)]
        case = judge.at(f"{calibration.sensor.name}.project_line", first=p, second=q)
        case.compare(LINE, off, np.zeros(2), "line", 1e-7)
