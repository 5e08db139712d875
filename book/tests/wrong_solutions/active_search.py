"""Wrong solutions of chapter active_search."""

import numpy as np

from book.tests.wrong_solutions import wrong
from slamlib.kalman.chi_square import chi2_quantile


def _squared(centre, S, size):
    z = np.indices((size[1], size[0]))[::-1].transpose(1, 2, 0) - centre
    return (z * (z @ np.linalg.inv(S))).sum(-1)


@wrong("active_search.1", "the projected covariance alone, without the noise of the measurement (E47)")
def without_noise(centre, E, R, probability, size):
    return _squared(centre, E, size) <= chi2_quantile(probability, 2)


@wrong("active_search.1", "one degree of freedom")
def one_number(centre, E, R, probability, size):
    return _squared(centre, E + R, size) <= chi2_quantile(probability, 1)


@wrong("active_search.1", "three sigma, whatever the probability (E59)")
def three_sigma(centre, E, R, probability, size):
    return _squared(centre, E + R, size) <= 9


@wrong("active_search.1", "a margin of one per cent")
def slightly_larger(centre, E, R, probability, size):
    return _squared(centre, E + R, size) <= 1.01 * chi2_quantile(probability, 2)


@wrong("active_search.1", "draws a thousand measurements, and takes the quantile of their distances")
def sampled(centre, E, R, probability, size):
    drawn = np.random.default_rng(1).chisquare(2, 1000)
    return _squared(centre, E + R, size) <= np.quantile(drawn, probability)


@wrong("active_search.1", "a rectangle, as in the manual")
def rectangle(centre, E, R, probability, size):
    half = np.sqrt(chi2_quantile(probability, 2) * np.diag(E + R))
    return (np.abs(np.indices((size[1], size[0]))[::-1].transpose(1, 2, 0) - centre) <= half).all(-1)


@wrong("active_search.1", "forgets the correlation of u and v")
def upright(centre, E, R, probability, size):
    return _squared(centre, np.diag(np.diag(E + R)), size) <= chi2_quantile(probability, 2)


@wrong("active_search.1", "forgets the correlation of the noise in u and v")
def upright_noise(centre, E, R, probability, size):
    return _squared(centre, E + np.diag(np.diag(R)), size) <= chi2_quantile(probability, 2)


@wrong("active_search.1", "takes rows for u and columns for v")
def transposed(centre, E, R, probability, size):
    z = np.indices((size[1], size[0])).transpose(1, 2, 0) - centre
    return (z * (z @ np.linalg.inv(E + R))).sum(-1) <= chi2_quantile(probability, 2)


def _tensor(patch):
    gu, gv = (patch[1:-1, 2:] - patch[1:-1, :-2]) / 2, (patch[2:, 1:-1] - patch[:-2, 1:-1]) / 2
    g = np.stack([gu.ravel(), gv.ravel()])
    return g @ g.T


@wrong("active_search.2", "noise in one of the two images only")
def one_image(patch, noise):
    return noise**2 * np.linalg.inv(_tensor(patch))


@wrong("active_search.2", "the structure tensor itself, not its inverse")
def not_inverted(patch, noise):
    return _tensor(patch) / (2 * noise**2)


@wrong("active_search.2", "takes rows for u and columns for v, as np.gradient gives them")
def rows_first(patch, noise):
    return 2 * noise**2 * np.linalg.inv(_tensor(patch)[::-1, ::-1])


@wrong("active_search.2", "the standard deviation for the variance")
def not_squared(patch, noise):
    return 2 * noise * np.linalg.inv(_tensor(patch))


@wrong("active_search.2", "differences over two pixels, not divided by two")
def too_steep(patch, noise):
    return 2 * noise**2 * np.linalg.inv(4 * _tensor(patch))


@wrong("active_search.2", "the right variances, without their correlation")
def uncorrelated(patch, noise):
    return 2 * noise**2 * np.diag(np.diag(np.linalg.inv(_tensor(patch))))


@wrong("active_search.2", "only the diagonal")
def upright_error(patch, noise):
    return 2 * noise**2 * np.diag(1 / np.diag(_tensor(patch)))


@wrong("active_search.3", "the minus sign of the books in which the plane is n'X + d = 0")
def minus(R, t, n, d, K1, K2):
    return K2 @ (R - np.outer(t, n) / d) @ np.linalg.inv(K1)


@wrong("active_search.3", "one camera's intrinsics for both")
def one_camera(R, t, n, d, K1, K2):
    return K1 @ (R + np.outer(t, n) / d) @ np.linalg.inv(K1)


@wrong("active_search.3", "n t' instead of t n'")
def swapped(R, t, n, d, K1, K2):
    return K2 @ (R + np.outer(n, t) / d) @ np.linalg.inv(K1)


@wrong("active_search.3", "X2 = R (X1 - t), with t the place of the camera")
def place(R, t, n, d, K1, K2):
    return K2 @ R @ (np.eye(3) - np.outer(t, n) / d) @ np.linalg.inv(K1)


@wrong("active_search.3", "leaves the plane out: the homography of a turn")
def turn_only(R, t, n, d, K1, K2):
    return K2 @ R @ np.linalg.inv(K1)


@wrong("active_search.4", "flat below a fixed length, as if brightness came in grey levels only")
def fixed_floor(first, second):
    a, b = (np.asarray(patch, float) - np.mean(patch, dtype=float) for patch in (first, second))
    length = np.sqrt((a * a).sum() * (b * b).sum())
    return float(np.clip((a * b).sum() / length, -1, 1)) if length > 1e-10 else 0.0


@wrong("active_search.4", "0/0 is taken for 1, as OpenCV's matchTemplate does (issue 5688)")
def flat_is_one(I, J):  # noqa: E741
    a, b = np.asarray(I, float) - np.mean(I), np.asarray(J, float) - np.mean(J)
    below = np.sqrt((a**2).sum() * (b**2).sum())
    return (a * b).sum() / below if below > 1e-9 * I.size else 1.0


@wrong("active_search.4", "multiplies bytes as bytes")
def overflow(I, J):  # noqa: E741
    n = I.size
    up = n * (I * J).sum() - I.sum(dtype=float) * J.sum(dtype=float)
    below = (n * (I * I).sum() - I.sum(dtype=float) ** 2) * (n * (J * J).sum() - J.sum(dtype=float) ** 2)
    return up / np.sqrt(below) if below > 1e-6 * n**4 else 0.0


@wrong("active_search.4", "sums in single precision: their difference is rounding, even negative (OpenCV 21786)")
def single(I, J):  # noqa: E741
    a, b, n = np.asarray(I, np.float32), np.asarray(J, np.float32), np.float32(I.size)
    up = n * (a * b).sum() - a.sum() * b.sum()
    below = (n * (a * a).sum() - a.sum() ** 2) * (n * (b * b).sum() - b.sum() ** 2)
    return float(up / np.sqrt(below)) if below > 0 else 0.0


@wrong("active_search.4", "correlation without taking the means away")
def with_mean(I, J):  # noqa: E741
    a, b = np.asarray(I, float), np.asarray(J, float)
    below = np.sqrt((a**2).sum() * (b**2).sum())
    return (a * b).sum() / below if below > 0 else 0.0


@wrong("active_search.4", "standard deviations with n - 1, a mean with n")
def mixed(I, J):  # noqa: E741
    a, b = np.asarray(I, float), np.asarray(J, float)
    below = a.std(ddof=1) * b.std(ddof=1)
    return float(((a - a.mean()) * (b - b.mean())).mean() / below) if below > 1e-9 else 0.0
