"""Beside OpenCV, on random and singular inputs: rotation vectors, poses, lenses, with the Jacobians that OpenCV has.

OpenCV's extrinsics (rotation vector, translation) take points of the world into the camera: our `pose.from_frame` of
the world's pose in the camera.
"""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from slamlib.geometry import plucker, pose, quaternion
from slamlib.sensors import brown, fisheye, pinhole
from slamlib.sensors.sensor import Calibration
from slamlib.tests.peers import NUMBERS, several, turns, with_jacobians

cv2 = pytest.importorskip("cv2", reason="OpenCV is compared with")
many = settings(max_examples=100, deadline=None)
FOCAL, CENTRE = st.floats(50, 900), st.floats(-100, 900)
INTRINSICS = st.tuples(CENTRE, CENTRE, FOCAL, FOCAL).map(np.array)
RADIAL = several(st.floats(-0.3, 0.3).map(lambda k: round(k, 6)), 3)  # 1e-261 would fold at a radius of 1e86
EQUIDISTANT = several(st.floats(-0.02, 0.02).map(lambda k: round(k, 6)), 4)


def close(found, wanted, tolerance=1e-12):
    """To so many digits of the largest of the numbers."""
    size = max(1.0, np.abs(wanted).max(initial=0))
    np.testing.assert_allclose(found, wanted, rtol=0, atol=tolerance * size)


def rounding(v):
    """What OpenCV's derivative by a short rotation vector is off: in it (1 - cos) / length is all rounding at 1e-8."""
    length = np.linalg.norm(v)
    return 1e-12 + min(length, 2e-16 / max(length, 1e-200))


def padded(d):
    return np.pad(d, (0, 8 - len(d)))


def opencvs(d):
    """(k1, k2, p1, p2, k3): the tangential two stand between the second and the third of ours."""
    return np.insert(d, 2, [0, 0])


def matrix_of(k):
    return np.array([[k[2], 0, k[0]], [0, k[3], k[1]], [0, 0, 1.0]])


@many
@given(v=turns())
def test_rodrigues_and_its_derivatives(v):
    wanted, by_vector = cv2.Rodrigues(v)
    q, J = quaternion.exponential.jac(v)
    value, stored = quaternion.rotation.storage_jac(q)
    close(value, wanted)
    close((stored.q @ J.vector).reshape(9, 3), by_vector.T, rounding(v))


POINTS = st.tuples(
    several(st.one_of(NUMBERS, st.sampled_from([0.0, 1e-200, 1e-12, 1e-8])), 2), st.floats(0.3, 9.0)
).map(lambda pair: np.append(*pair))


def moved_into(v, t, point):
    """The world's point in the camera, and its Jacobian (3, 6) w.r.t. rotation vector and translation."""
    q, J = quaternion.exponential.jac(v)
    there = pose.from_frame(np.append(t, q), point)
    _, stored = pose.from_frame.storage_jac(np.append(t, q), point)
    return there, np.hstack([stored.pose[:, 3:] @ J.vector, stored.pose[:, :3]])


def world_of(v, t, point):
    """Where a point of the camera (3,) is in the world."""
    return pose.to_frame(np.append(t, quaternion.exponential(v)), point)


@many
@given(v=turns(), t=several(NUMBERS, 3), v2=turns(), t2=several(NUMBERS, 3))
def test_compositions_of_poses(v, t, v2, t2):
    """OpenCV's logarithm has half the digits near a half turn, and is zero below 1e-5 rad."""
    outer, inner = (np.append(shift, quaternion.exponential(turn)) for turn, shift in ((v2, t2), (v, t)))
    r3, t3 = cv2.composeRT(v, t, v2, t2)[:2]
    found = pose.compose(outer, inner)
    close(found[:3], t3.ravel())
    length = np.linalg.norm(quaternion.logarithm(found[3:]))
    tolerance = 2e-5 if length < 2e-5 else 1e-6 if length > np.pi - 1e-3 else 1e-9
    close(quaternion.rotation(found[3:]), cv2.Rodrigues(r3)[0], tolerance)


@many
@given(v=turns(), t=several(NUMBERS, 3), point=POINTS, k=INTRINSICS, d=RADIAL)
def test_pin_hole_projections_with_every_jacobian(v, t, point, k, d):
    """OpenCV's columns: rotation vector, translation, focal lengths, centre, (k1, k2, p1, p2, k3)."""
    there, by_pose = moved_into(v, t, world_of(v, t, point))
    wanted, theirs = cv2.projectPoints(world_of(v, t, point)[None], v, t, matrix_of(k), opencvs(d))
    value, J = with_jacobians(pinhole.project, np.append(there, 1.0), k, padded(d))
    close(value, wanted.ravel(), 1e-11)
    close(J.point[:, :3] @ by_pose, theirs[:, :6], max(1e-9, 20 * rounding(v)))
    close(J.intrinsics, theirs[:, [8, 9, 6, 7]], 1e-11)
    close(J.distortion[:, :3], theirs[:, [10, 11, 14]], 1e-11)
    camera = Calibration(pinhole.PINHOLE, np.eye(2), intrinsics=k, distortion=d, limits={"radius": 100.0})
    short, J_short = camera.project_jac(np.append(there, 1.0))
    close(short, value)
    close(J_short.point, J.point)
    close(J_short.distortion, J.distortion[:, :3])


BROWN = st.tuples(several(st.floats(-0.1, 0.1), 5), several(st.floats(0, 0.1), 3)).map(np.concatenate)


@many
@given(v=turns(), t=several(NUMBERS, 3), point=POINTS, k=INTRINSICS, d=BROWN)
def test_lenses_that_are_not_centred_with_every_jacobian(v, t, point, k, d):
    """OpenCV's columns: rotation vector, translation, focal lengths, centre, and ours.

    It divides by 1 + k4 r^2 + ..., which is above one here.
    """
    there, by_pose = moved_into(v, t, world_of(v, t, point))
    wanted, theirs = cv2.projectPoints(world_of(v, t, point)[None], v, t, matrix_of(k), d)
    value, J = with_jacobians(brown.project, np.append(there, 1.0), k, d)
    close(value, wanted.ravel(), 1e-11)
    close(J.point[:, :3] @ by_pose, theirs[:, :6], max(1e-9, 20 * rounding(v)))
    close(J.intrinsics, theirs[:, [8, 9, 6, 7]], 1e-11)
    close(J.distortion, theirs[:, 10:18], 1e-11)


@many
@given(ideal=several(NUMBERS, 2), d=RADIAL)
def test_the_distortion_alone(ideal, d):
    """At the axis and a depth of one the Jacobians by x and y are those by OpenCV's translation."""
    none, unit = np.zeros(3), np.array([0.0, 0, 1, 1])
    wanted, theirs = cv2.projectPoints(np.append(ideal, 1)[None], none, none, np.eye(3), opencvs(d))
    for value, J in (pinhole.distort.jac(ideal, padded(d)), pinhole.pixel.jac(ideal, unit, padded(d))):
        close(value, wanted.ravel())
        close(J.ideal, theirs[:, 3:5])
        close(J.distortion[:, :3], theirs[:, [10, 11, 14]])
    close(pinhole.distort(ideal, padded(d)), wanted.ravel())
    close(pinhole.pixel(ideal, unit, padded(d)), wanted.ravel())


@many
@given(p=POINTS, q=POINTS, k=INTRINSICS)
def test_the_image_of_a_line_goes_through_those_of_its_points(p, q, k):
    line = pinhole.project_line(plucker.join(np.append(p, 1.0), np.append(q, 1.0)), k)
    seen = cv2.projectPoints(np.array([p, q]), np.zeros(3), np.zeros(3), matrix_of(k), None)[0][:, 0]
    for pixel in seen:
        terms = line * [*pixel, 1]
        close(terms.sum() / max(np.abs(terms).max(), 1e-3), 0.0, 1e-9)


@many
@given(v=turns(), t=several(NUMBERS, 3), point=POINTS, k=INTRINSICS, d=EQUIDISTANT, flat=st.booleans())
def test_fisheye_projections_with_every_jacobian(v, t, point, k, d, flat):
    """OpenCV's columns: focal lengths, centre, coefficients, rotation vector, translation.

    It divides by the depth, which at 90 degrees from the axis costs its derivatives digits; behind, it mirrors.
    """
    point = point * [1, 1, 1e-9 if flat and np.abs(point[:2]).max() > 1e-3 else 1]  # at 90 degrees from the axis
    camera = Calibration(fisheye.FISHEYE, np.eye(2), intrinsics=k, distortion=d)
    there, by_pose = moved_into(v, t, world_of(v, t, point))
    wanted, theirs = cv2.fisheye.projectPoints(world_of(v, t, point)[None, None], v, t, matrix_of(k), d)
    value, J = camera.project_jac(np.append(there, 1.0))
    close(value, wanted.ravel(), 1e-11)
    divided = 1e-14 * np.linalg.norm(point[:2]) / point[2]
    close(J.point[:, :3] @ by_pose, theirs[:, 8:14], max(1e-9, 20 * rounding(v), divided))
    close(J.intrinsics, theirs[:, [2, 3, 0, 1]], 1e-11)
    close(J.distortion, theirs[:, 4:8], 1e-11)
    close(fisheye.project(np.append(there, 1.0), k, padded(d)), value)
    whole, J_whole = fisheye.project.jac(np.append(there, 1.0), k, padded(d))
    close(whole, value)
    close(J_whole.point, J.point)
    close(J_whole.distortion[:, :4], J.distortion)


def through(ray, G):
    """Ideal point (x, y) of a ray, and its derivatives, from those of the ray."""
    ideal = ray[:2] / ray[2]
    return ideal, [(part[:2] - np.multiply.outer(ideal, part[2])) / ray[2] for part in G]


@many
@given(share=st.floats(0, 0.9), about=st.floats(-np.pi, np.pi), k=INTRINSICS, d=RADIAL)
def test_pin_hole_rays(share, about, k, d):
    """Below the fold, and where OpenCV's iteration comes to rest: it steps by the distortion, we by its slope.

    The derivatives of the ray are those of an implicit function of OpenCV's projection.
    """
    d = d / 5
    angle = share * min(1.0, np.arctan(pinhole.fold_radius(d)))  # of the fold, where a ray has no derivative
    point = np.append(np.tan(angle) * np.array([np.cos(about), np.sin(about)]), 1.0)
    camera = Calibration(pinhole.PINHOLE, np.eye(2), intrinsics=k, distortion=d)
    pixel, theirs = cv2.projectPoints(point[None], np.zeros(3), np.zeros(3), matrix_of(k), opencvs(d))
    criteria = (cv2.TERM_CRITERIA_COUNT | cv2.TERM_CRITERIA_EPS, 3000, 1e-14)
    patient = getattr(cv2, "undistortPointsIter", cv2.undistortPoints)  # one name since OpenCV 5
    undistorted = patient(pixel, matrix_of(k), opencvs(d), R=None, P=None, criteria=criteria).ravel()
    ray, G = camera.back_project_jac(pixel.ravel(), [0.3])
    close(ray, np.append(point * np.cos(angle), 0.3), 1e-10)
    ideal, (by_pixel, by_unmeasured, by_intrinsics, by_distortion) = through(ray, G)
    close(ideal, undistorted, 1e-10)
    back = np.linalg.inv(theirs[:, 3:5])
    close(by_pixel, back, 1e-10)
    close(by_intrinsics, -back @ theirs[:, [8, 9, 6, 7]], 1e-10)
    close(by_distortion, -back @ theirs[:, [10, 11, 14]], 1e-10)
    close(by_unmeasured, np.zeros((2, 1)))
    close(G.unmeasured.ravel(), [0, 0, 0, 1])
    close(ray[:3] @ G.measurement[:3], np.zeros(2))  # it stays of unit length
    close(pinhole.back_project(pixel.ravel(), np.array([0.3]), k, padded(d)), ray, 1e-10)


@many
@given(share=st.floats(0, 0.9), about=st.floats(-np.pi, np.pi), k=INTRINSICS, d=EQUIDISTANT)
def test_fisheye_rays(share, about, k, d):
    """OpenCV's iteration rests at 1e-8, and no further out than 90 degrees in the image; ours has all digits."""
    camera = Calibration(fisheye.FISHEYE, np.eye(2), intrinsics=k, distortion=d)
    angle = share * min(1.6, camera.limits["angle"])  # of the fold, where a ray has no derivative
    point = np.array([np.sin(angle) * np.cos(about), np.sin(angle) * np.sin(about), np.cos(angle)])
    pixel, theirs = cv2.fisheye.projectPoints(point[None, None], np.zeros(3), np.zeros(3), matrix_of(k), d)
    ray, G = camera.back_project_jac(pixel.ravel(), [0.3])
    close(ray, np.append(point, 0.3), 1e-10)
    back = np.linalg.inv(theirs[:, 11:13] * point[2])
    for found, wanted in zip(
        through(ray, G)[1], (back, None, -back @ theirs[:, [2, 3, 0, 1]], -back @ theirs[:, 4:8]), strict=True
    ):
        close(found, np.zeros((2, 1)) if wanted is None else wanted, 1e-9)
    if np.linalg.norm((pixel.ravel() - k[:2]) / k[2:]) < np.pi / 2:
        undistorted = cv2.fisheye.undistortPoints(pixel, matrix_of(k), d).ravel()
        close(np.arctan(np.linalg.norm(ray[:2] / ray[2])), np.arctan(np.linalg.norm(undistorted)), 1e-7)
