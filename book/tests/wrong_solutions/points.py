"""Wrong solutions of chapter points."""

import numpy as np

from book.tests.wrong_solutions import wrong


@wrong("points.1", "forgets that both pixels are noisy")
def one_pixel(f, b, sigma, index):
    return index * f * b / (4 * sigma)


@wrong("points.1", "forgets the four of the index")
def relative_error(f, b, sigma, index):
    return index * f * b / (np.sqrt(2) * sigma)


@wrong("points.1", "takes one standard deviation to either side, where the index takes two")
def one_sigma(f, b, sigma, index):
    return index * f * b / (2 * np.sqrt(2) * sigma)


@wrong("points.1", "lets the variances of the pixels be standard deviations")
def variances(f, b, sigma, index):
    return index * f * b / (4 * 2 * sigma)


@wrong("points.1", "asks for an absolute error in place of a relative one")
def absolute(f, b, sigma, index):
    return np.sqrt(index * f * b / (4 * np.sqrt(2) * sigma))


@wrong("points.1", "leaves out the focal length, as if the noise were of ideal images")
def without_focal_length(f, b, sigma, index):
    return index * b / (4 * np.sqrt(2) * sigma)


@wrong("points.2", "the distance is the inverse of rho whatever the length of m, as in a test with unit directions")
def unit_direction(landmark, P):
    anchor, m, rho = landmark[:3], landmark[3:6], landmark[6]
    m = m / np.linalg.norm(m)
    J = np.c_[np.eye(3), np.eye(3) / rho, -m / rho**2]
    return anchor + m / rho, J @ P @ J.T


@wrong("points.2", "only the inverse distance is uncertain, as in the toolbox's test")
def rho_alone(landmark, P):
    anchor, m, rho = landmark[:3], landmark[3:6], landmark[6]
    return anchor + m / rho, np.outer(m, m) * P[6, 6] / rho**4


@wrong("points.2", "the variance of 1 / rho is taken for that of rho")
def variance_of_inverse(landmark, P):
    anchor, m, rho = landmark[:3], landmark[3:6], landmark[6]
    J = np.c_[np.eye(3), np.eye(3) / rho, -m / rho]
    return anchor + m / rho, J @ P @ J.T


@wrong("points.2", "the blocks of the covariance are taken for independent")
def independent(landmark, P):
    anchor, m, rho = landmark[:3], landmark[3:6], landmark[6]
    own = P[:3, :3] + P[3:6, 3:6] / rho**2 + np.outer(m, m) * P[6, 6] / rho**4
    return anchor + m / rho, own


@wrong("points.2", "the inverse of the squared distance, as published in p2idp")
def squared(landmark, P):
    anchor, m, rho = landmark[:3], landmark[3:6], landmark[6]
    d = 1 / np.sqrt(rho)
    J = np.c_[np.eye(3), np.eye(3) * d, -m * d**3 / 2]
    return anchor + m * d, J @ P @ J.T


@wrong("points.2", "takes rho for the distance")
def rho_is_distance(landmark, P):
    anchor, m, rho = landmark[:3], landmark[3:6], landmark[6]
    J = np.c_[np.eye(3), rho * np.eye(3), m]
    return anchor + m * rho, J @ P @ J.T


@wrong("points.2", "forgets the anchor in the point")
def without_anchor(landmark, P):
    m, rho = landmark[3:6], landmark[6]
    J = np.c_[np.zeros((3, 3)), np.eye(3) / rho, -m / rho**2]
    return m / rho, J @ P @ J.T


@wrong("points.2", "a greater rho moves the point away: seen by its correlations alone")
def away_with_rho(landmark, P):
    anchor, m, rho = landmark[:3], landmark[3:6], landmark[6]
    J = np.c_[np.eye(3), np.eye(3) / rho, m / rho**2]
    return anchor + m / rho, J @ P @ J.T


@wrong("points.2", "the direction is taken for known")
def known_direction(landmark, P):
    anchor, m, rho = landmark[:3], landmark[3:6], landmark[6]
    J = np.c_[np.eye(3), np.zeros((3, 3)), -m / rho**2]
    return anchor + m / rho, J @ P @ J.T


@wrong("points.3", "the inverse depth on a unit ray, as published")
def depth_on_unit_ray(ideal, depth):
    ray = np.array([*ideal, 1.0])
    return np.array([*(ray / np.linalg.norm(ray)), 1 / depth])


@wrong("points.3", "the right point with a ray that is not of unit length")
def long_ray(ideal, depth):
    return np.array([*ideal, 1.0, 1 / depth])


@wrong("points.3", "multiplies by the cosine where it should divide")
def upside_down(ideal, depth):
    ray = np.array([*ideal, 1.0])
    length = np.linalg.norm(ray)
    return np.array([*(ray / length), length / depth])


@wrong("points.3", "w is the distance, not its inverse")
def distance_itself(ideal, depth):
    ray = np.array([*ideal, 1.0])
    length = np.linalg.norm(ray)
    return np.array([*(ray / length), depth * length])


@wrong("points.3", "the camera looks along -z")
def looks_back(ideal, depth):
    ray = np.array([*ideal, -1.0])
    length = np.linalg.norm(ray)
    return np.array([*(ray / length), 1 / (depth * length)])


@wrong("points.3", "the point itself, with w = 1")
def the_point(ideal, depth):
    return np.array([*(np.array([*ideal, 1.0]) * depth), 1.0])


def _ray(landmark):
    ahead = np.array([np.cos(landmark[2]), np.sin(landmark[2])])
    return ahead, np.array([-ahead[1], ahead[0]]), landmark[3]


@wrong("points.5", "the azimuth moves the place by itself, not by its lever")
def no_lever(landmark, P):
    ahead, left, rho = _ray(landmark)
    J = np.c_[np.eye(2), left, -ahead / rho**2]
    return landmark[:2] + ahead / rho, J @ P @ J.T


@wrong("points.5", "the anchor is taken for known")
def known_anchor(landmark, P):
    ahead, left, rho = _ray(landmark)
    J = np.c_[left / rho, -ahead / rho**2]
    return landmark[:2] + ahead / rho, J @ P[2:, 2:] @ J.T


@wrong("points.5", "a greater inverse distance moves the place away, without a correlation nobody notices")
def other_sign(landmark, P):
    ahead, left, rho = _ray(landmark)
    J = np.c_[np.eye(2), left / rho, ahead / rho**2]
    return landmark[:2] + ahead / rho, J @ P @ J.T


@wrong("points.5", "the azimuth counted from the y axis, as a compass does")
def as_a_compass(landmark, P):
    ahead, left, rho = _ray(landmark)
    ahead, left = ahead[::-1], -left[::-1]
    J = np.c_[np.eye(2), left / rho, -ahead / rho**2]
    return landmark[:2] + ahead / rho, J @ P @ J.T


@wrong("points.5", "takes rho for the distance")
def distance_on_the_floor(landmark, P):
    ahead, left, rho = _ray(landmark)
    J = np.c_[np.eye(2), rho * left, ahead]
    return landmark[:2] + ahead * rho, J @ P @ J.T


@wrong("points.5", "the derivative of 1 / rho without its square")
def without_square(landmark, P):
    ahead, left, rho = _ray(landmark)
    J = np.c_[np.eye(2), left / rho, -ahead / rho]
    return landmark[:2] + ahead / rho, J @ P @ J.T


@wrong("points.5", "only the diagonal of P")
def diagonal(landmark, P):
    ahead, left, rho = _ray(landmark)
    J = np.c_[np.eye(2), left / rho, -ahead / rho**2]
    return landmark[:2] + ahead / rho, J @ np.diag(np.diag(P)) @ J.T


@wrong("points.5", "the azimuth turns the place to the right")
def to_the_right(landmark, P):
    ahead, left, rho = _ray(landmark)
    J = np.c_[np.eye(2), -left / rho, -ahead / rho**2]
    return landmark[:2] + ahead / rho, J @ P @ J.T
