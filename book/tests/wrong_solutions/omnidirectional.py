"""Wrong solutions of chapter omnidirectional."""

import numpy as np

from book.tests.wrong_solutions import wrong


@wrong("omnidirectional.1", "divides by the distance from the axis, which is zero on it")
def on_the_axis(point, f):
    x, y, z = point
    n, d = np.hypot(x, y), np.linalg.norm(point)
    return 2 * f * (d - z) / n * point[:2] / n if n else np.array([np.nan, np.nan])


@wrong("omnidirectional.1", "takes z for the length of the point: the pin-hole of twice the focal length, halved")
def pinhole(point, f):
    return f * point[:2] / point[2]


@wrong("omnidirectional.1", "the angle by the arctangent of a quotient: right in front only")
def quotient(point, f):
    n = np.hypot(*point[:2])
    return 2 * f * np.tan(np.arctan(n / point[2]) / 2) * point[:2] / n if n else np.zeros(2)


@wrong("omnidirectional.1", "forgets that the point may be far: no length in it")
def unit_only(point, f):
    return 2 * f * point[:2] / (1 + point[2])


@wrong("omnidirectional.2", "Newton's method alone")
def newton(radius, b):
    angle = radius / b[0]
    for _ in range(50):
        slope = b[0] + 3 * b[1] * angle**2 + 5 * b[2] * angle**4
        angle -= (b[0] * angle + b[1] * angle**3 + b[2] * angle**5 - radius) / slope
    return angle


@wrong("omnidirectional.2", "Newton's method alone, from half a radian")
def newton_from_half(radius, b):
    angle = 0.5
    for _ in range(50):
        slope = b[0] + 3 * b[1] * angle**2 + 5 * b[2] * angle**4
        angle -= (b[0] * angle + b[1] * angle**3 + b[2] * angle**5 - radius) / slope
    return angle


@wrong("omnidirectional.2", "one step of the series instead of the root")
def series(radius, b):
    a = radius / b[0]
    return a - b[1] / b[0] * a**3


@wrong("omnidirectional.2", "halves an interval up to pi, whatever the lens does in it")
def halving(radius, b):
    low, high = 0.0, np.pi
    for _ in range(60):
        a = (low + high) / 2
        low, high = (a, high) if b[0] * a + b[1] * a**3 + b[2] * a**5 < radius else (low, a)
    return low


def _bent(theta, k):
    return theta * (1 + k @ theta ** np.array([2, 4, 6, 8]))


@wrong("omnidirectional.3", "as published: divides by z, and the angle is the arctangent of r")
def published(point, f, k):
    if point[2] == 0:
        return np.full(2, np.nan)
    a = point[:2] / point[2]
    r = np.hypot(*a)
    return f * _bent(np.arctan(r), k) * a / r if r else np.zeros(2)


@wrong("omnidirectional.3", "adds pi to the angle behind, as the issue proposes")
def as_proposed(point, f, k):
    z = point[2] if point[2] else 1e-300
    a = point[:2] / z
    r = np.hypot(*a)
    theta = np.arctan(r) + (np.pi if z < 0 else 0)
    return f * _bent(theta, k) * a / r if r else np.zeros(2)


@wrong("omnidirectional.3", "the right angle behind, but the azimuth is still the turned one")
def half_repaired(point, f, k):
    z = point[2] if point[2] else 1e-300
    a = point[:2] / z
    r = np.hypot(*a)
    theta = np.arctan(r) if z > 0 else np.pi - np.arctan(r)
    return f * _bent(theta, k) * a / r if r else np.zeros(2)


@wrong("omnidirectional.3", "right everywhere but on the axis")
def no_axis(point, f, k):
    n = np.hypot(*point[:2])
    with np.errstate(all="ignore"):
        return f * _bent(np.arctan2(n, point[2]), k) * point[:2] / n


@wrong("omnidirectional.3", "stops at 90 degrees")
def clipped(point, f, k):
    n = np.hypot(*point[:2])
    return f * _bent(min(np.arctan2(n, point[2]), np.pi / 2), k) * point[:2] / n if n else np.zeros(2)


@wrong("omnidirectional.3", "shifts the angle by pi behind and keeps the azimuth: a mirror image")
def shifted(point, f, k):
    n = np.hypot(*point[:2])
    theta = np.arctan(n / point[2]) if point[2] else np.pi / 2
    return f * _bent(abs(theta), k) * point[:2] / n if n else np.zeros(2)


def _angle(radius, k, start=None):
    theta = radius if start is None else start
    for _ in range(50):
        slope = 1 + (k * [3, 5, 7, 9]) @ theta ** np.array([2, 4, 6, 8])
        theta -= (_bent(theta, k) - radius) / slope
    return theta


@wrong("omnidirectional.5", "as published: limits the radius")
def limits_the_radius(q, k):
    radius = min(np.hypot(*q), np.pi / 2)
    return np.tan(_angle(radius, k)) / radius * q if radius else np.zeros(2)


@wrong("omnidirectional.5", "limits nothing: mirrored beyond 90 degrees")
def limits_nothing(q, k):
    radius = np.hypot(*q)
    return np.tan(_angle(radius, k)) / radius * q if radius else np.zeros(2)


@wrong("omnidirectional.5", "cuts the angle at 90 degrees instead of refusing what lies beyond")
def cuts_the_angle(q, k):
    radius = np.hypot(*q)
    return np.tan(min(_angle(radius, k), np.pi / 2)) / radius * q if radius else np.zeros(2)


@wrong("omnidirectional.5", "refuses every radius beyond a quarter turn")
def refuses_by_the_radius(q, k):
    radius = np.hypot(*q)
    if radius >= np.pi / 2:
        return np.full(2, np.nan)
    return np.tan(_angle(radius, k)) / radius * q if radius else np.zeros(2)


@wrong("omnidirectional.5", "returns the angle vector instead of the point")
def angle_vector(q, k):
    radius = np.hypot(*q)
    if radius >= _bent(np.pi / 2, k):
        return np.full(2, np.nan)
    return _angle(radius, k) / radius * q if radius else np.zeros(2)


@wrong("omnidirectional.5", "divides by the radius at the centre")
def no_centre(q, k):
    radius = np.hypot(*q)
    if radius >= _bent(np.pi / 2, k):
        return np.full(2, np.nan)
    with np.errstate(all="ignore"):
        return np.tan(_angle(radius, k)) / radius * q


@wrong("omnidirectional.5", "refuses by the angle found, which Newton's method may find on the other side")
def other_root(q, k):
    radius = np.hypot(*q)
    theta = _angle(radius, k)
    if theta > np.pi / 2:
        return np.full(2, np.nan)
    return np.tan(theta) / radius * q if radius else np.zeros(2)
