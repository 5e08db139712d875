"""Checks of the chapter: points."""

from collections.abc import Mapping

import numpy as np

from slambook.exercises import Candidate, Rng, exercise
from slambook.exercises.kit import array_of, cases, covariance, holds, number, parts, same
from slamlib.geometry.pose import ORIGIN
from slamlib.landmarks.fhm_point import FHM_POINT
from slamlib.landmarks.linearity import euclidean_index
from slamlib.manifolds import Array
from slamlib.models.numerical import differences


@exercise("points.1", "how far a stereo head sees")
def farthest(candidate: Candidate) -> None:
    """The index of the point that least squares finds in two pictures, by the package's own models."""
    heads = (320.0, 0.5, 1.0, 0.1), (450.0, 0.11, 0.3, 0.4), (1000.0, 0.2, 2.0, 0.05)
    for f, b, sigma, index in cases(heads, "f = {:g}, b = {:g}, sigma = {:g}, index = {:g}"):
        depth = number(candidate(f, b, sigma, index), "the depth")
        holds(depth > 0, "the depth is positive", f"found {depth:.4g}")
        landmark, information = np.array([*ORIGIN, 0, 0, 1 / depth]), np.zeros((3, 3))
        for x in (0.0, b):
            point, J = FHM_POINT.to_frame.jac(np.array([x, *ORIGIN[1:]]), landmark)
            u, v, z = point[:3]
            rows = f / z * np.array([[1, 0, -u / z], [0, 1, -v / z]]) @ J.landmark[:3, 6:]
            information += rows.T @ rows / sigma**2
        P = np.zeros((9, 9))
        P[6:, 6:] = np.linalg.inv(information)
        found = float(euclidean_index(FHM_POINT, landmark, P, ORIGIN))
        what = "a point at that depth, found by least squares, has that index"
        holds(abs(found / index - 1) < 1e-9, what, f"found {found:.4g}, {found / index:.4g} times what is asked for")


@exercise("points.2", "an anchored point becomes Euclidean", seed=112)
def convert(candidate: Candidate, rng: Rng) -> None:
    """All points, at all lengths, lie on the ray at their distance; then covariances, against their differences."""
    landmarks = {}
    for length in cases((1.0, 2.5, 0.4), "a direction of length {:g}"):
        m = rng.standard_normal(3)
        landmark = np.array([*rng.standard_normal(3), *(length * m / np.linalg.norm(m)), rng.uniform(0.1, 1)])
        landmarks[length] = landmark
        point, _ = parts(candidate(landmark, np.eye(7)), {"the point": (3,), "the covariance": (3, 3)})
        ray = point - landmark[:3]
        same(np.cross(ray, landmark[3:6]), np.zeros(3), "the point lies on the line through the anchor along m")
        same(ray * landmark[6], landmark[3:6], "rho times the way from the anchor to the point is m")
    for _, landmark in cases(tuple(landmarks.items()), "a direction of length {:g}, landmark {}"):
        root = rng.standard_normal((7, 7)) / 10
        blocks = {"the anchor's": slice(3), "the direction's": slice(3, 6), "rho's": slice(6, 7)}
        _moves_its_error(candidate, landmark, root @ root.T, blocks)


@exercise("points.3", "depth and distance")
def depth_or_distance(candidate: Candidate) -> None:
    """The homogeneous point has a unit ray, goes through the image, and lies at the depth."""
    images = (0.0, 0.0, 4.0), (0.8, -0.6, 5.0), (-1.5, 2.0, 0.5), (0.1, 0.0, 100.0)
    for u, v, depth in cases(images, "({:g}, {:g}) at depth {:g}"):
        point = array_of(candidate(np.array([u, v]), depth), (4,), "the homogeneous point")
        same(np.linalg.norm(point[:3]), 1, "h has unit length")
        holds(point[2] > 0, "the ray points ahead", f"found h = {point[:3].round(4)}")
        same(point[:2] / point[2], [u, v], "h goes through the image of the point")
        holds(point[3] > 0, "w is positive", f"found w = {point[3]:.4g}")
        same(point[2] / point[3], depth, "h / w lies at the depth")


@exercise("points.5", "a bearing-only point becomes a place on the floor", seed=115)
def to_plane(candidate: Candidate, rng: Rng) -> None:
    """All places lie on the ray at their distance; then covariances, against differences of the candidate's places."""
    landmarks = {}
    for azimuth in cases((0.0, 0.7, 2.5, -1.9), "an azimuth of {:g} rad"):
        landmark = np.array([*rng.uniform(-3, 3, 2), azimuth, rng.uniform(0.1, 0.6)])
        landmarks[azimuth] = landmark
        place, _ = parts(candidate(landmark, np.eye(4)), {"the place": (2,), "the covariance": (2, 2)})
        away = place - landmark[:2]
        same(np.linalg.norm(away) * landmark[3], 1, "rho is the inverse of its distance from the anchor")
        same(away * landmark[3], [np.cos(azimuth), np.sin(azimuth)], "it lies in the direction of the azimuth")
    for _, landmark in cases(tuple(landmarks.items()), "an azimuth of {:g} rad, landmark {}"):
        root = rng.standard_normal((4, 4)) / 10
        blocks = {"the anchor's": slice(2), "the azimuth's": slice(2, 3), "rho's": slice(3, 4)}
        _moves_its_error(candidate, landmark, root @ root.T, blocks)


def _moves_its_error(candidate: Candidate, landmark: Array, P: Array, blocks: Mapping[str, slice]) -> None:
    """The covariance returned is J P J', by differences of the mean returned: for each block's error, then for all."""
    J = differences(lambda x: candidate(x, np.eye(len(x)))[0], landmark)
    covariance(candidate(landmark, P)[1], len(J))
    for what, block in blocks.items():
        alone = np.zeros_like(P)
        alone[block, block] = P[block, block]
        one = candidate(landmark, alone)[1]
        same(one, J @ alone @ J.T, f"{what} error alone gives its share of the covariance", tolerance=1e-6)
    what = "so do all errors together, with their correlations"
    same(candidate(landmark, P)[1], J @ P @ J.T, what, tolerance=1e-6)
