"""Properties that every parametrization must have: of points, and of lines."""

from collections.abc import Callable, Sequence
from functools import partial

import numpy as np

from slamlib.checks.judge import Judge
from slamlib.checks.models import DEFINED, interface, model_properties, moved_derivatives
from slamlib.errors import SingularPointError
from slamlib.geometry import pose as frames
from slamlib.geometry.pose import ORIGIN, Pose
from slamlib.geometry.pose2 import from_space, in_space
from slamlib.landmarks.parametrization import LineLandmark, PointLandmark
from slamlib.manifolds import Array

ROUND_TRIP = "from_frame, then to_frame gives the point back, as a ratio"
FORWARD = "a point in front stays in front"
EUCLIDEAN = "to_frame is the Euclidean route through to_point"
ANCHORED = "from_frame puts the point where it is in the world"
INFINITE = "a point at infinity is a direction, the same from everywhere"
REFUSED = "to_point refuses a point at infinity"
LIMITED = "has no place for points at infinity, and says so"
CONSTRAINT = "the line in the frame is a line: n . v = 0"
SEEN = "from_frame, then to_frame: the line is seen along both rays"
INCIDENT = "point_at gives points on the line, seen from anywhere"
DISTINCT = "the endpoints are two points"
UNNOTICED = "a motion of the world is not noticed from a pose that moves along"
INHERITED = "a new landmark moves along with the pose that it is seen from"

AXIS = np.array([0, 0, 1, 0.3])  # a point on the optical axis
FORWARDS = np.array([1.0, 2, 3, 0.5, -0.5, 0.5, -0.5])  # a camera with its optical axis along the world's x axis


def point_properties(judge: Judge, kind: PointLandmark) -> None:
    """Interface first; then the models one by one; then how they fit together."""
    place, own = {"pose": Pose.size}, {"landmark": kind.manifold.size}
    if not interface(judge, kind, {"to_frame": place | own, "from_frame": place | {"point": 4}, "to_point": own}):
        return
    rng = judge.rng
    poses = [ORIGIN, upright(FORWARDS) if kind.plane else FORWARDS, *(pose_for(kind, rng) for _ in range(6))]
    points = [_homogeneous(rng) for _ in poses]
    made = [*zip(poses, points, strict=True), (poses[2], AXIS), (poses[3], AXIS)]
    nasty = [(pose, point) for pose in poses[:4] for point in _nasty_points(rng)]
    if kind.plane:
        made, nasty = _on_the_floor(made), _on_the_floor(nasty)
    model_properties(judge, kind.from_frame, f"{kind.name}.from_frame", made, nasty)
    if judge.lacks(DEFINED):
        return
    landmarks = [kind.from_frame(*place) for place in made]
    moved = [kind.manifold.plus(x, 0.02 * rng.standard_normal(kind.manifold.dof)) for x in landmarks]
    odd = [x for place in nasty if (x := _value(kind.from_frame, *place)) is not None]
    seen = [(Pose.random(rng), x) for x in moved]
    awkward = [*zip(poses, landmarks, strict=False), *((Pose.random(rng), x) for x in odd)]
    model_properties(judge, kind.to_frame, f"{kind.name}.to_frame", seen, awkward)
    model_properties(judge, kind.to_point, f"{kind.name}.to_point", [(x,) for x in moved], [(x,) for x in odd])
    if not judge.lacks(DEFINED):
        _round_trip(judge, kind, made)
        for pose, landmark in seen:
            case = judge.at(f"{kind.name}.to_frame", pose=pose, landmark=landmark)
            with np.errstate(all="ignore"):
                h = kind.to_frame(pose, landmark)
                case.compare(EUCLIDEAN, h[:3] / h[3], frames.to_frame(pose, kind.to_point(landmark)))
        _infinity(judge, kind, poses)
        _moved(judge, kind, made, seen, partial(pose_for, kind))


def pose_for(kind: PointLandmark, rng: np.random.Generator) -> Array:
    """A random pose (7,) from which a landmark may be initialized, or motion: in the plane upright, on the floor."""
    pose = Pose.random(rng)
    return upright(pose) if kind.plane else pose


def upright(pose: Array) -> Array:
    """The pose on the floor that is nearest to a pose (7,)."""
    return in_space(from_space(pose))


def _on_the_floor(places: list[tuple[Array, Array]]) -> list[tuple[Array, Array]]:
    """The poses, with homogeneous points at their height: a camera's axes right and front become left and front."""
    found = []
    for pose, (x, _, z, w) in places:
        length = np.hypot(x, z)
        if length > 0:
            found.append((pose, np.array([z / length, 0.0 - x / length, 0, w])))
    return found


def _moved(
    judge: Judge,
    kind: PointLandmark | LineLandmark,
    made: Sequence[tuple[Array, ...]],
    seen: list[tuple[Array, Array]],
    draw: Callable[[np.random.Generator], Array] = Pose.random,
) -> None:
    """Check the motion of the world, for a parametrization that says it; made: arguments of from_frame.

    draw: draws a motion of the world.
    """
    if kind.moved is None:
        return
    for pose, landmark in seen:
        case, motion = judge.at(f"{kind.name}.moved", landmark=landmark, pose=pose), draw(judge.rng)
        from_there = kind.to_frame(frames.compose(motion, pose), kind.moved(motion, landmark))
        case.compare(UNNOTICED, from_there, kind.to_frame(pose, landmark), "motion")
        moved_derivatives(case, kind.moved, kind.manifold, motion, landmark)
    for place in made:
        landmark, J = kind.from_frame.jac(*place)
        along = J.pose @ frames.compose.jac(ORIGIN, place[0])[1].outer
        case = judge.at(f"{kind.name}.moved", landmark=landmark, pose=place[0])
        case.compare(INHERITED, kind.moved.jac_where(ORIGIN, landmark), along, "landmark")


def _homogeneous(rng: np.random.Generator) -> Array:
    """A point up to 60 degrees off the axis, 1 to 20 m away: unit ray and inverse distance."""
    ray = np.array([*rng.uniform(-1.2, 1.2, 2), 1])
    return np.array([*ray / np.linalg.norm(ray), rng.uniform(0.05, 1)])


def _nasty_points(rng: np.random.Generator) -> list[Array]:
    """On the axis exactly, behind, to the side, at infinity, near it and beyond, not of unit length."""
    x, y, z, w = _homogeneous(rng)
    rays = [[0, 0, 1, w], [0, 0, -1, w], [1, 0, 0, w], [0, 1, 0, w], [x, y, -z, w], [x, y, 1e-9, w]]
    return [np.array(p, dtype=float) for p in [*rays, [x, y, z, 0], [0, 0, 1, 0], [x, y, z, 1e-9], [x, y, z, -0.01]]]


def _value(model: Callable[..., Array], *place: Array) -> Array | None:
    """The model's value, or None where it refuses the place."""
    try:
        return model(*place)
    except SingularPointError:
        return None


def _unit(point: Array) -> Array:
    """A homogeneous point scaled to length one: the ratio of its coordinates, with their sign."""
    return point / np.linalg.norm(point)


def _round_trip(judge: Judge, kind: PointLandmark, made: list[tuple[Array, Array]]) -> None:
    for pose, point in [*made, *((pose, 3 * point) for pose, point in made[:2])]:
        there, back = (judge.at(f"{kind.name}.{name}", pose=pose, point=point) for name in ("from_frame", "to_frame"))
        landmark = kind.from_frame(pose, point)
        again, wanted = _unit(kind.to_frame(pose, landmark)), _unit(point)
        sign = 1 if again @ wanted >= 0 else -1
        there.compare(ROUND_TRIP, sign * again, wanted, "point")
        back.require(FORWARD, sign > 0, "the sign of the homogeneous point is turned: the sensor would see it behind")
        there.compare(ANCHORED, kind.to_point(landmark), frames.from_frame(pose, point[:3] / point[3]), "pose")


def _infinity(judge: Judge, kind: PointLandmark, poses: list[Array]) -> None:
    """Check inverse distance zero: kept as a direction, or refused; never nan."""
    for pose in poses[2:]:
        point = _homogeneous(judge.rng)
        point[3] = 0
        if kind.plane:
            ((_, point),) = _on_the_floor([(pose, point)])
        case, position = (judge.at(f"{kind.name}.{n}", pose=pose, point=point) for n in ("to_frame", "to_point"))
        landmark = _value(kind.from_frame, pose, point)
        if landmark is None:
            case.hold(LIMITED)
            continue
        other = Pose.random(judge.rng)
        world = frames.from_frame(pose, point[:3]) - pose[:3]
        wanted = np.append(frames.to_frame(other, world) - frames.to_frame(other, np.zeros(3)), 0)
        try:
            found, _ = kind.to_frame.jac(other, landmark)
        except SingularPointError as error:
            case.fail(INFINITE, str(error).split(", at")[0], "landmark")
            continue
        case.compare(INFINITE, _unit(found), _unit(wanted), "landmark")
        is_refused = _value(kind.to_point, landmark) is None
        position.require(REFUSED, is_refused, "a point at infinity has no Euclidean coordinates")


def line_properties(judge: Judge, kind: LineLandmark) -> None:
    """Interface first; then the models one by one; then how they fit together."""
    place, own = {"pose": Pose.size}, {"landmark": kind.manifold.size}
    takes = {"to_frame": place | own, "from_frame": place | {"rays": 6, "prior": 2}, "point_at": own | {"abscissa": 1}}
    if not interface(judge, kind, takes):
        return
    rng = judge.rng
    poses = [FORWARDS, *(Pose.random(rng) for _ in range(7))]
    made = [(pose, _rays(rng), rng.uniform(0.1, 0.5, 2)) for pose in poses]
    nasty = [(pose, rays, np.array(p)) for pose, rays, _ in made for p in ([0.0, 0], [0.1, 0], [-0.1, 0.2])]
    through_axis = np.array([0, 0, 1, *_rays(rng)[3:]])
    nasty += [(pose, through_axis, np.array([0.1, 0.2])) for pose in (ORIGIN, *poses[:2])]
    model_properties(judge, kind.from_frame, f"{kind.name}.from_frame", made, nasty)
    if judge.lacks(DEFINED):
        return
    landmarks = [kind.from_frame(*place) for place in made]
    seen = [(Pose.random(rng), x) for x in landmarks]
    on_line = [(point[:3] / point[3], x) for x in landmarks for point in [kind.point_at(x, 0.3)]]
    awkward = [(np.array([*point, *FORWARDS[3:]]), x) for point, x in on_line]  # lines through the optical centre
    awkward += [(ORIGIN, x) for place in nasty if (x := _value(kind.from_frame, *place)) is not None]
    model_properties(judge, kind.to_frame, f"{kind.name}.to_frame", seen, awkward)
    ends = [(x, np.array(float(s))) for x in landmarks for s in (*kind.abscissas, 0.3)]
    model_properties(judge, kind.point_at, f"{kind.name}.point_at", ends)
    if not judge.lacks(DEFINED):
        _seen_along_rays(judge, kind, [*made, *nasty])
        _points_on_line(judge, kind, seen)
        _moved(judge, kind, made, seen)


def _rays(rng: np.random.Generator) -> Array:
    """Two unit rays in front, more than ten degrees apart."""
    while True:
        rays = np.column_stack([rng.uniform(-1, 1, (2, 2)), np.ones(2)])
        rays /= np.linalg.norm(rays, axis=1, keepdims=True)
        if rays[0] @ rays[1] < np.cos(0.2):
            return rays.ravel()


def _seen_along_rays(judge: Judge, kind: LineLandmark, made: list[tuple[Array, Array, Array]]) -> None:
    for pose, rays, prior in made:
        try:
            line = kind.to_frame(pose, kind.from_frame(pose, rays, prior))
        except SingularPointError:
            continue  # a degenerate case that the models refuse
        there, back = (
            judge.at(f"{kind.name}.{n}", pose=pose, rays=rays, prior=prior) for n in ("from_frame", "to_frame")
        )
        n, v = line[:3] / np.linalg.norm(line[:3]), line[3:] / max(float(np.linalg.norm(line[3:])), 1e-300)
        back.compare(CONSTRAINT, n @ v, 0.0, "landmark")
        there.compare(SEEN, [n @ rays[:3], n @ rays[3:]], np.zeros(2), "rays")


def _points_on_line(judge: Judge, kind: LineLandmark, seen: list[tuple[Array, Array]]) -> None:
    for pose, landmark in seen:
        line = kind.to_frame(pose, landmark)
        n, v = line[:3], line[3:]
        places = []
        for s in (*kind.abscissas, 0.3):
            point = kind.point_at(landmark, s)
            here = frames.to_frame(pose, point[:3] / point[3])
            places.append(here)
            case = judge.at(f"{kind.name}.point_at", pose=pose, landmark=landmark, abscissa=np.array(s))
            scale = max(float(np.linalg.norm(here) * np.linalg.norm(v)), 1e-300)
            case.compare(INCIDENT, (np.cross(here, v) - n) / scale, np.zeros(3), "landmark")
        apart = np.linalg.norm(places[0] - places[1])
        judge.at(f"{kind.name}.abscissas").require(DISTINCT, apart > 1e-9, "they are the same point")
