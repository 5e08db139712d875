"""Wrong solutions of chapter monocular."""

import numpy as np

from book.tests.wrong_solutions import wrong


@wrong("monocular.1", "forgets the prior")
def without_prior(u, b, f, sigma_u, rho_0, sigma_0):
    information = f**2 * (b**2).sum() / sigma_u**2
    return f * (b * u).sum() / sigma_u**2 / information, information**-0.5


@wrong("monocular.1", "takes the last look alone")
def last_alone(u, b, f, sigma_u, rho_0, sigma_0):
    information = 1 / sigma_0**2 + f**2 * b[-1] ** 2 / sigma_u**2
    return (rho_0 / sigma_0**2 + f * b[-1] * u[-1] / sigma_u**2) / information, information**-0.5


@wrong("monocular.1", "averages the single inverse distances, as if all bases were worth the same")
def averaged(u, b, f, sigma_u, rho_0, sigma_0):
    information = 1 / sigma_0**2 + f**2 * (b**2).sum() / sigma_u**2
    weight = 1 / sigma_0**2 / information
    return weight * rho_0 + (1 - weight) * np.mean(u / (f * b)), information**-0.5


@wrong("monocular.1", "returns the variance")
def variance(u, b, f, sigma_u, rho_0, sigma_0):
    information = 1 / sigma_0**2 + f**2 * (b**2).sum() / sigma_u**2
    return (rho_0 / sigma_0**2 + f * (b * u).sum() / sigma_u**2) / information, 1 / information


def _parts(x, y):
    x_mean, y_mean = x.mean(0), y.mean(0)
    U, D, Vt = np.linalg.svd((y - y_mean).T @ (x - x_mean))
    return x_mean, y_mean, U, D, Vt, np.array([1, 1, np.linalg.det(U) * np.linalg.det(Vt)])


@wrong("monocular.2", "lets the rotation be a mirror where that fits better")
def mirror(x, y):
    x_mean, y_mean, U, D, Vt, _ = _parts(x, y)
    R = U @ Vt
    s = D.sum() / ((x - x_mean) ** 2).sum()
    return s, R, y_mean - s * R @ x_mean


@wrong("monocular.2", "the ratio of the sizes as scale, which is not the least-squares one when there is noise")
def ratio(x, y):
    x_mean, y_mean, U, _, Vt, signs = _parts(x, y)
    R = U * signs @ Vt
    s = np.sqrt(((y - y_mean) ** 2).sum() / ((x - x_mean) ** 2).sum())
    return s, R, y_mean - s * R @ x_mean


@wrong(
    "monocular.2", "mean squares in the one place, sums in the other: n times too small a scale (trueform, issue 21)"
)
def times_n(x, y):
    x_mean, y_mean, U, D, Vt, signs = _parts(x, y)
    R = U * signs @ Vt
    s = (D * signs).sum() / len(x) / ((x - x_mean) ** 2).sum()
    return s, R, y_mean - s * R @ x_mean


@wrong("monocular.2", "lays the reference over the path (IncEventGS, issue 13)")
def swapped(x, y):
    x_mean, y_mean, U, D, Vt, signs = _parts(y, x)
    R = U * signs @ Vt
    s = (D * signs).sum() / ((y - x_mean) ** 2).sum()
    return s, R, y_mean - s * R @ x_mean


@wrong("monocular.2", "forgets to turn and scale the centroid before it shifts")
def shifted(x, y):
    x_mean, y_mean, U, D, Vt, signs = _parts(x, y)
    return (D * signs).sum() / ((x - x_mean) ** 2).sum(), U * signs @ Vt, y_mean - x_mean


POWER, OF_POINTS = np.repeat([1, 0, 1, 0], (3, 4, 3, 3)), np.repeat([1, 0, -1], (3, 3, 1))


@wrong("monocular.3", "multiplies the inverse distance")
def farther(state, points, k):
    return state * float(k) ** POWER, points * float(k) ** np.repeat([1, 0, 1], (3, 3, 1))


@wrong("monocular.3", "forgets the anchors")
def anchored(state, points, k):
    return state * float(k) ** POWER, points * float(k) ** np.repeat([0, 0, -1], (3, 3, 1))


@wrong("monocular.3", "scales the angular velocity, too")
def spun(state, points, k):
    return state * float(k) ** np.repeat([1, 0, 1], (3, 4, 6)), points * float(k) ** OF_POINTS


@wrong("monocular.3", "leaves the velocity as it is")
def slow(state, points, k):
    return state * float(k) ** np.repeat([1, 0], (3, 10)), points * float(k) ** OF_POINTS


@wrong("monocular.3", "makes the state larger and leaves the points where they are")
def points_stay(state, points, k):
    return state * float(k) ** POWER, points.copy()
