"""Properties that every parametrization of lines must have."""

import numpy as np

from slamlib.errors import SingularPointError
from slamlib.geometry import pose as frames
from slamlib.geometry.pose import Pose
from slamlib.landmarks.line import LineLandmark
from slamlib.manifolds import Array
from slamlib.testing.judge import Judge
from slamlib.testing.models import DEFINED, model_properties
from slamlib.testing.points import FORWARDS, IDENTITY, INTERFACE, interface

CONSTRAINT = "the line in the frame is a line: n . v = 0"
SEEN = "from_frame, then to_frame: the line is seen along both rays"
INCIDENT = "point_at gives points on the line, seen from anywhere"
DISTINCT = "the endpoints are two points"


def line_properties(judge: Judge, kind: LineLandmark) -> None:
    """Interface first; then the models one by one; then how they fit together."""
    shapes = {
        "to_frame": [("pose", Pose.size), ("landmark", kind.space.size)],
        "from_frame": [("pose", Pose.size), ("rays", 6), ("prior", 2)],
        "point_at": [("landmark", kind.space.size), ("abscissa", 1)],
    }
    if not interface(judge, kind, shapes):
        return
    rng = judge.rng
    poses = [FORWARDS, *(Pose.random(rng) for _ in range(7))]
    made = [(pose, _rays(rng), rng.uniform(0.1, 0.5, 2)) for pose in poses]
    nasty = [(pose, rays, np.array(p)) for pose, rays, _ in made for p in ([0.0, 0], [0.1, 0], [-0.1, 0.2])]
    through_axis = np.array([0, 0, 1, *_rays(rng)[3:]])
    nasty += [(pose, through_axis, np.array([0.1, 0.2])) for pose in (IDENTITY, *poses[:2])]
    model_properties(judge, kind.from_frame, f"{kind.name}.from_frame", made, nasty)
    if _undefined(judge):
        return
    landmarks = [kind.from_frame(*place) for place in made]
    seen = [(Pose.random(rng), x) for x in landmarks]
    awkward = [(_onto(kind, x), x) for x in landmarks] + [(IDENTITY, x) for x in _odd(kind, nasty)]
    model_properties(judge, kind.to_frame, f"{kind.name}.to_frame", seen, awkward)
    ends = [(x, np.array(float(s))) for x in landmarks for s in (*kind.abscissas, 0.3)]
    model_properties(judge, kind.point_at, f"{kind.name}.point_at", ends)
    if not _undefined(judge):
        _seen_along_rays(judge, kind, [*made, *nasty])
        _points_on_line(judge, kind, seen)


def _undefined(judge: Judge) -> bool:
    return any(what in (DEFINED, INTERFACE) for what, *_ in judge.findings)


def _rays(rng: np.random.Generator) -> Array:
    """Two unit rays in front, more than ten degrees apart."""
    while True:
        rays = np.column_stack([rng.uniform(-1, 1, (2, 2)), np.ones(2)])
        rays /= np.linalg.norm(rays, axis=1, keepdims=True)
        if rays[0] @ rays[1] < np.cos(0.2):
            return rays.ravel()


def _odd(kind: LineLandmark, nasty: list[tuple[Array, Array, Array]]) -> list[Array]:
    found = []
    for place in nasty:
        try:
            found.append(kind.from_frame(*place))
        except SingularPointError:
            continue
    return found


def _onto(kind: LineLandmark, landmark: Array) -> Array:
    """A pose whose origin lies on the line: the line goes through the optical centre."""
    point = kind.point_at(landmark, 0.3)
    return np.array([*point[:3] / point[3], *FORWARDS[3:]])


def _seen_along_rays(judge: Judge, kind: LineLandmark, made: list[tuple[Array, Array, Array]]) -> None:
    for pose, rays, prior in made:
        where = {"pose": pose, "rays": rays, "prior": prior}
        try:
            line = kind.to_frame(pose, kind.from_frame(pose, rays, prior))
        except SingularPointError:
            continue  # a nasty place that the models refuse
        n, v = line[:3] / np.linalg.norm(line[:3]), line[3:] / max(float(np.linalg.norm(line[3:])), 1e-300)
        judge.compare(CONSTRAINT, f"{kind.name}.to_frame", n @ v, 0.0, where, argument="landmark")
        off = [n @ rays[:3], n @ rays[3:]]
        judge.compare(SEEN, f"{kind.name}.from_frame", off, np.zeros(2), where, argument="rays")


def _points_on_line(judge: Judge, kind: LineLandmark, seen: list[tuple[Array, Array]]) -> None:
    for pose, landmark in seen:
        line = kind.to_frame(pose, landmark)
        n, v = line[:3], line[3:]
        places = []
        for s in (*kind.abscissas, 0.3):
            point = kind.point_at(landmark, s)
            here = frames.to_frame(pose, point[:3] / point[3])
            places.append(here)
            where = {"pose": pose, "landmark": landmark, "abscissa": np.array(s)}
            scale = np.linalg.norm(here) * np.linalg.norm(v)
            off = (np.cross(here, v) - n) / max(float(scale), 1e-300)
            judge.compare(INCIDENT, f"{kind.name}.point_at", off, np.zeros(3), where, argument="landmark")
        apart = np.linalg.norm(places[0] - places[1])
        judge.require(DISTINCT, f"{kind.name}.abscissas", apart > 1e-9, "they are the same point", {})
