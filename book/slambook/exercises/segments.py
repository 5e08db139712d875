"""Checks of the chapter: segments."""

import numpy as np

from slambook.exercises.kit import Candidate, Rng, array_of, cases, exercise, holds, same
from slamlib.geometry import plucker, quaternion
from slamlib.geometry.pose import from_frame
from slamlib.landmarks.segments import frustum
from slamlib.manifolds import Array

KINDS = (
    "an endpoint in the image, both in front",
    "both endpoints outside the image, in front",
    "one endpoint behind the camera",
    "both endpoints behind the camera",
)


@exercise("segments.1", "the bow of a straight line", seed=124)
def bow(candidate: Candidate, rng: Rng) -> None:
    """Three points through the lens say how far the middle is from the chord; none is, at the height of the centre."""
    lenses = map(tuple, rng.uniform(-0.5, 0.5, (20, 3)) * [1, 1, 2])
    told = "k1 = {:.3g}, height = {:.3g}, length = {:.3g}"
    for k1, height, length in cases([(-0.3, 0.0, 1.2)], told):
        same(candidate(k1, height, length), 0, "a segment through the centre stays straight")
    for k1, height, length in cases([(-0.3, -0.6, 1.0), *((k, h, abs(s)) for k, h, s in lenses)], told):
        ideal = np.array([[-length / 2, height], [0, height], [length / 2, height]])
        start, middle, end = ideal * (1 + k1 * (ideal * ideal).sum(-1, keepdims=True))
        away = round(middle[1] - (start[1] + end[1]) / 2, 12)
        same(candidate(k1, height, length), away, "it leads from the chord to the middle's image")


@exercise("segments.2", "abscissas in another world", seed=125)
def moved_abscissas(candidate: Candidate, rng: Rng) -> None:
    """The points at the new abscissas are the old ones: a new origin that is turned, sideways, along v, or anywhere."""
    s, turn = np.array([-1.0, 2.0]), quaternion.exponential(np.array([0.3, -0.5, 0.9]))
    for what, moved, q, size in (
        ("an origin that is only turned changes nothing", np.zeros(3), turn, 1.0),
        ("an origin moved sideways changes nothing", np.array([0, 2.0, 0]), np.array([1.0, 0, 0, 0]), 1.0),
        ("an origin moved along the line shifts the count", np.array([3.0, 0, 0]), np.array([1.0, 0, 0, 0]), 1.0),
        ("it counts metres, however long v is", np.array([3.0, 0, 0]), np.array([1.0, 0, 0, 0]), 0.5),
    ):
        v = np.array([size, 0, 0])
        line, pose = np.concatenate([np.cross([0, 1.0, 4], v), v]), np.concatenate([moved, q])
        for _ in cases([(v, moved, q, s)], "v = {}, t = {}, q = {}, abscissas {}"):
            same(candidate(line, s, pose), _same_points(line, s, pose), what)
    for length in cases((1.0, 0.1, 4.0), "|v| = {:g}"):
        v, q, s = rng.standard_normal(3), rng.standard_normal(4), 3 * rng.standard_normal(2)
        v *= length / np.linalg.norm(v)
        line = np.concatenate([np.cross(rng.standard_normal(3), v), v])
        pose = np.concatenate([rng.standard_normal(3), q / np.linalg.norm(q)])
        for _ in cases([(line, s, pose)], "the line {}, abscissas {}, the pose {}"):
            found = array_of(candidate(line, s, pose), (2,), "the new abscissas")
            same(found, _same_points(line, s, pose), "the endpoints stay where they are, for any line and pose")


def _same_points(line: Array, abscissas: Array, pose: Array) -> Array:
    """Abscissas of the same points on the line in the new frame, found between its points at 0 and at 1."""
    h = plucker.point_at(line, abscissas)
    marks = plucker.point_at(plucker.to_frame(pose, line), np.array([0.0, 1.0]))
    zero, one = from_frame(pose, marks[:, :3] / marks[:, 3:])
    return np.asarray((h[:, :3] / h[:, 3:] - zero) @ (one - zero))


@exercise("segments.3", "which segments are in view", seed=126)
def is_visible(candidate: Candidate, rng: Rng) -> None:
    """A thousand points of a segment say whether some part is in the image; close calls are left out.

    Then segments so long that samples miss the part in view: they are laid through a point that is in the image.
    """
    k, image, share = np.array([250.0, 290, 300, 400]), (640, 480), np.linspace(0, 1, 1001)[:, None]
    hard = np.array([[[-200, 0, 1], [200, 0, 1]], [[-1, 0, 0.05], [1, 0, 0.05]]])  # a short part in view; very near
    kinds: dict[str, list[Array]] = {kind: [] for kind in KINDS}
    for ends in [*3 * rng.standard_normal((400, 2, 3)), *hard]:
        behind, outside = (ends[:, 2] < 0).sum(), not (ends @ frustum(k, image).T > 0).all(-1).any()
        kinds[KINDS[1 + behind if behind else int(outside)]].append(ends)
    for kind, those in kinds.items():
        for first, second in cases(those, "the segment {}"):
            points = (1 - share) * first + share * second
            sure, possible = (((points @ frustum(k, image, m).T) > 0).all(-1).any() for m in (4, -4))
            if sure == possible:
                seen = bool(candidate(first, second, k, image))
                holds(seen == sure, f"visible or not, {kind}", f"your function says {seen}")
    for first, second in cases(_long_segments(rng, k, image), "the segment {}"):
        seen = bool(candidate(first, second, k, image))
        holds(seen, "visible: a short part of a long segment", f"your function says {seen}")


def _long_segments(rng: Rng, k: Array, image: tuple[int, int]) -> Array:
    """Segments (60, 2, 3) of 2 km and much more through points well inside the image, half of them at one depth."""
    pixels = rng.uniform(0.2, 0.8, (60, 2)) * image
    points = rng.uniform(1, 5, (60, 1)) * np.column_stack([(pixels - k[:2]) / k[2:], np.ones(60)])
    along = rng.standard_normal((60, 3))
    along[:30, 2] = 0
    along /= np.linalg.norm(along, axis=-1, keepdims=True)
    reach = 10 ** rng.uniform(3, 7, (60, 2, 1)) * [[-1], [1]]
    return np.asarray(points[:, None] + reach * along[:, None])
