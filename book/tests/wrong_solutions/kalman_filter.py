"""Wrong solutions of chapter kalman_filter."""

import numpy as np

from book.tests.wrong_solutions import wrong


@wrong("kalman_filter.1", "the plain average")
def average(z1, v1, z2, v2):
    return (z1 + z2) / 2, (v1 + v2) / 4


@wrong("kalman_filter.1", "weights by the variances instead of their inverses")
def weights_upside_down(z1, v1, z2, v2):
    return (v1 * z1 + v2 * z2) / (v1 + v2), v1 * v2 / (v1 + v2)


@wrong("kalman_filter.1", "weights by inverse standard deviations")
def by_deviations(z1, v1, z2, v2):
    s1, s2 = np.sqrt(v1), np.sqrt(v2)
    return (s2 * z1 + s1 * z2) / (s1 + s2), v1 * v2 / (v1 + v2)


@wrong("kalman_filter.1", "the right mean, with the average of the variances")
def averaged_variance(z1, v1, z2, v2):
    return (v2 * z1 + v1 * z2) / (v1 + v2), (v1 + v2) / 2


@wrong("kalman_filter.1", "the right mean, with the variance of a sum")
def variance_of_a_sum(z1, v1, z2, v2):
    return (v2 * z1 + v1 * z2) / (v1 + v2), v1 + v2


@wrong("kalman_filter.1", "a variance of zero means no reading, in the first thermometer only")
def first_of_zero(z1, v1, z2, v2):
    if v1 == 0:
        return z2, v2
    return (v2 * z1 + v1 * z2) / (v1 + v2), v1 * v2 / (v1 + v2)


@wrong("kalman_filter.2", "the innovations of the prediction throughout (E16)")
def stale(x, P, z, H, R):
    innovations, nis = z - H @ x, []
    for j, h in enumerate(H):
        S = h @ P @ h + R[j, j]
        K = P @ h / S
        x, P = x + K * innovations[j], P - np.outer(K, h @ P)
        nis.append(innovations[j] ** 2 / S)
    return x, P, np.array(nis)


@wrong("kalman_filter.2", "the diagonal of R only (E17)")
def diagonal_only(x, P, z, H, R):
    nis = []
    for j, h in enumerate(H):
        S, nu = h @ P @ h + R[j, j], z[j] - h @ x
        x, P = x + P @ h / S * nu, P - np.outer(P @ h, P @ h) / S
        nis.append(nu**2 / S)
    return x, P, np.array(nis)


@wrong("kalman_filter.2", "every gain from the predicted covariance")
def stale_covariance(x, P, z, H, R):
    new, nis = P, []
    for j, h in enumerate(H):
        S, nu = h @ P @ h + R[j, j], z[j] - h @ x
        x, new = x + P @ h / S * nu, new - np.outer(P @ h, P @ h) / S
        nis.append(nu**2 / S)
    return x, new, np.array(nis)


def batch(x, P, z, H, R):
    """All numbers at once: state, covariance, innovation and its covariance."""
    nu, S = z - H @ x, H @ P @ H.T + R
    K = np.linalg.solve(S, H @ P).T
    return x + K @ nu, P - K @ H @ P, nu, S


@wrong("kalman_filter.2", "the batch formula, with each number compared with the prediction")
def not_one_by_one(x, P, z, H, R):
    x, P, nu, S = batch(x, P, z, H, R)
    return x, P, nu**2 / np.diag(S)


@wrong("kalman_filter.2", "the batch formula, with the NIS of the whole shared out evenly")
def shared_out(x, P, z, H, R):
    x, P, nu, S = batch(x, P, z, H, R)
    return x, P, np.full(len(z), nu @ np.linalg.solve(S, nu) / len(z))


@wrong(
    "kalman_filter.3", "Q and R swapped, as by whoever takes the letters of kalmanjs for the common ones (its issue 22)"
)
def swapped(P, Q, R):
    return (P + R) / (P + R + Q)


@wrong("kalman_filter.3", "the prediction leaves out Q, as in itamarwe/kalman, issue 5")
def without_prediction(P, Q, R):
    return P / (P + R)


@wrong("kalman_filter.3", "counts Q as measurement noise")
def q_in_the_denominator(P, Q, R):
    return P / (P + Q + R)
