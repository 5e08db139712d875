"""Checks of the chapter: segments."""

import numpy as np

from slambook.exercises.kit import Candidate, Rng, array_of, cases, exercise, holds, same
from slamlib.geometry import plucker
from slamlib.geometry.pose import from_frame
from slamlib.landmarks.segments import frustum


@exercise("segments.1", "the bow of a straight line", seed=124)
def bow(candidate: Candidate, rng: Rng) -> None:
    """Three points through the lens say how far the middle is from the chord."""
    lenses = map(tuple, rng.uniform(-0.5, 0.5, (20, 3)))
    for k1, height, length in cases(lenses, "k1, height, length = {:.3g} {:.3g} {:.3g}"):
        ideal = np.array([[-length / 2, height], [0, height], [length / 2, height]])
        start, middle, end = ideal * (1 + k1 * (ideal * ideal).sum(-1, keepdims=True))
        away = middle[1] - (start[1] + end[1]) / 2
        same(candidate(k1, height, length), away, "it is the distance between the images of middle and chord")


@exercise("segments.2", "abscissas in another world", seed=125)
def moved_abscissas(candidate: Candidate, rng: Rng) -> None:
    """The points at the new abscissas are the old points, seen from the new frame."""
    for length in cases((1.0, 0.1, 4.0), "|v| = {:g}"):
        v, q, s = rng.standard_normal(3), rng.standard_normal(4), 3 * rng.standard_normal(2)
        v *= length / np.linalg.norm(v)
        line = np.concatenate([np.cross(rng.standard_normal(3), v), v])
        pose = np.concatenate([rng.standard_normal(3), q / np.linalg.norm(q)])
        found = array_of(candidate(line, s, pose), (2,), "the new abscissas")
        old, new = (plucker.point_at(x, a) for x, a in ((line, s), (plucker.to_frame(pose, line), found)))
        same(from_frame(pose, new[:, :3] / new[:, 3:]), old[:, :3] / old[:, 3:], "the endpoints stay where they are")


@exercise("segments.3", "which segments are in view", seed=126)
def is_visible(candidate: Candidate, rng: Rng) -> None:
    """A thousand points of the segment say whether some part is in the image; close calls are left out."""
    k, image, share = np.array([250.0, 290, 300, 400]), (640, 480), np.linspace(0, 1, 1001)[:, None]
    hard = np.array([[[-200, 0, 1], [200, 0, 1]], [[-1, 0, 0.05], [1, 0, 0.05]]])  # a short part in view; very near
    for first, second in cases([*3 * rng.standard_normal((400, 2, 3)), *hard], "the segment {}"):
        points = (1 - share) * first + share * second
        sure, possible = (((points @ frustum(k, image, m).T) > 0).all(-1).any() for m in (4, -4))
        if sure == possible:
            what = "what is in view is told from what is not, also with endpoints behind the camera"
            holds(bool(candidate(first, second, k, image)) == sure, what, f"your function says {not sure}")
