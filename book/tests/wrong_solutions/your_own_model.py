"""Wrong solutions of chapter your_own_model."""

from dataclasses import replace

import numpy as np

from book.tests.wrong_solutions import wrong
from slamlib.analytic import sqrt
from slamlib.geometry.pose import Pose
from slamlib.geometry.quaternion import rotation
from slamlib.landmarks import POINTS, PointLandmark
from slamlib.manifolds import as_manifold
from slamlib.models import model


@wrong("your_own_model.1", "keeps the standard deviation, as if the angle were the inverse distance")
def same_spread(rho, sigma):
    return np.arctan(rho), sigma


@wrong("your_own_model.1", "takes the spread from one side only")
def one_side(rho, sigma):
    return np.arctan(rho), np.arctan(rho + sigma) - np.arctan(rho)


@wrong("your_own_model.1", "confuses the cosine with its square")
def cosine(rho, sigma):
    return np.arctan(rho), sigma / np.sqrt(1 + rho**2)


@wrong("your_own_model.1", "gives the variance")
def variance(rho, sigma):
    return np.arctan(rho), (sigma / (1 + rho**2)) ** 2


@wrong("your_own_model.1", "the complement: the angle at the point, not beside the anchor")
def complement(rho, sigma):
    return np.arctan2(1, rho), sigma / (1 + rho**2)


@wrong("your_own_model.1", "the fraction upside down, which also divides by zero at infinity")
def upside_down(rho, sigma):
    return np.arctan(1 / rho), sigma / (1 + rho**2)


@wrong("your_own_model.1", "half of what lies between both sides, not the slope")
def both_sides(rho, sigma):
    return np.arctan(rho), (np.arctan(rho + sigma) - np.arctan(rho - sigma)) / 2


@wrong("your_own_model.1", "gives degrees")
def in_degrees(rho, sigma):
    return np.degrees(np.arctan(rho)), np.degrees(sigma / (1 + rho**2))


@wrong("your_own_model.1", "keeps the sign of a slope that falls")
def negative(rho, sigma):
    return np.arctan(rho), -sigma / (1 + rho**2)


@model(pose=Pose, landmark=7)
def to_frame(pose, landmark):
    """Right: homogeneous, from anchor, direction and distance."""
    offset = landmark[6] * landmark[3:6] + landmark[:3] - pose[:3]
    return np.array([*(rotation(pose[3:]).T @ offset), 1])


@model(pose=Pose, landmark=7)
def as_inverse(pose, landmark):
    """The formula of the inverse distance, with the distance in it."""
    offset = landmark[3:6] + landmark[6] * (landmark[:3] - pose[:3])
    return np.array([*(rotation(pose[3:]).T @ offset), 1])


@model(pose=Pose, point=4)
def from_frame(pose, point):
    """Right."""
    length = sqrt(point[:3] @ point[:3])
    return np.array([*pose[:3], *(rotation(pose[3:]) @ point[:3] / length), length / point[3]])


@model(pose=Pose, point=4)
def turned_back(pose, point):
    """The rotation transposed: right as long as the camera is not turned."""
    length = sqrt(point[:3] @ point[:3])
    return np.array([*pose[:3], *(rotation(pose[3:]).T @ point[:3] / length), length / point[3]])


@model(pose=Pose, point=4)
def with_depth(pose, point):
    """The depth along the axis for the distance along the ray."""
    length = sqrt(point[:3] @ point[:3])
    return np.array([*pose[:3], *(rotation(pose[3:]) @ point[:3] / length), point[2] / point[3]])


@model(landmark=7)
def to_point(landmark):
    """Right."""
    return landmark[:3] + landmark[6] * landmark[3:6]


@model(pose=Pose, landmark=7)
def mirrored(pose, landmark):
    """The anchor subtracted, and the frame's origin added."""
    offset = landmark[6] * landmark[3:6] - landmark[:3] + pose[:3]
    return np.array([*(rotation(pose[3:]).T @ offset), 1])


@model(landmark=7)
def without_anchor(landmark):
    """The point as if the anchor were the origin."""
    return landmark[6] * landmark[3:6]


def _point(*models):
    return PointLandmark("dstPnt", as_manifold(7), *models)


@wrong("your_own_model.2", "the rotation of from_frame is transposed")
def transposed():
    return _point(to_frame, turned_back, to_point)


@wrong("your_own_model.2", "the depth along the axis instead of the distance along the ray")
def depth():
    return _point(to_frame, with_depth, to_point)


@wrong("your_own_model.2", "the formula for inverse distances, with a distance")
def mixed():
    return _point(as_inverse, from_frame, to_point)


@wrong("your_own_model.2", "the signs of anchor and origin are exchanged: right at the anchor")
def exchanged():
    return _point(mirrored, from_frame, to_point)


@wrong("your_own_model.2", "to_point forgets the anchor")
def at_the_origin():
    return _point(to_frame, from_frame, without_anchor)


@model(pose=Pose, point=4)
def unscaled_direction(pose, point):
    """The direction keeps the length of h: right for unit rays alone."""
    return np.array([*pose[:3], *rotation(pose[3:]) @ point[:3], 1 / point[3]])


@wrong("your_own_model.2", "takes 1 / w for the distance, right if h is a unit ray")
def unscaled_ray():
    return _point(to_frame, unscaled_direction, to_point)


@wrong("your_own_model.2", "has another name")
def misnamed():
    return replace(_point(to_frame, from_frame, to_point), name="newPnt")


@wrong("your_own_model.2", "is the anchored homogeneous point: it holds the inverse distance")
def inverse():
    return replace(POINTS["ahmPnt"], name="dstPnt")


@wrong("your_own_model.3", "the speed of the robot, whatever the direction, as published")
def speed(point, velocity):
    return np.linalg.norm(velocity)


@wrong("your_own_model.3", "positive when the range grows, as many radars have it")
def range_rate(point, velocity):
    return -point @ velocity / np.linalg.norm(point)


@wrong("your_own_model.3", "forgets to divide by the distance")
def unscaled(point, velocity):
    return point @ velocity


@wrong("your_own_model.3", "the forward speed alone")
def forward(point, velocity):
    return velocity[0]


@wrong("your_own_model.3", "in the plane only: right for points at the sensor's level")
def level(point, velocity):
    return point[:2] @ velocity[:2] / np.linalg.norm(point[:2])


@wrong("your_own_model.3", "the speed times the cosine of the azimuth: right for travel straight ahead")
def by_azimuth(point, velocity):
    return np.linalg.norm(velocity) * point[0] / np.linalg.norm(point)


@wrong("your_own_model.3", "makes the velocity a unit vector, not the line of sight")
def unit_velocity(point, velocity):
    return point @ velocity / np.linalg.norm(velocity)
