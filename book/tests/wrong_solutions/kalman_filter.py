"""Wrong solutions of chapter kalman_filter."""

import numpy as np

from book.tests.wrong_solutions import wrong


@wrong("kalman_filter.1", "the plain average")
def average(z1, v1, z2, v2, c):
    return (z1 + z2) / 2, (v1 + v2) / 4


@wrong("kalman_filter.1", "weights by the variances instead of their inverses")
def weights_upside_down(z1, v1, z2, v2, c):
    return (v1 * z1 + v2 * z2) / (v1 + v2), v1 * v2 / (v1 + v2)


@wrong("kalman_filter.1", "weights by inverse standard deviations")
def by_deviations(z1, v1, z2, v2, c):
    s1, s2 = np.sqrt(v1), np.sqrt(v2)
    return (s2 * z1 + s1 * z2) / (s1 + s2), v1 * v2 / (v1 + v2)


@wrong("kalman_filter.1", "the right mean, with the average of the variances")
def averaged_variance(z1, v1, z2, v2, c):
    return (v2 * z1 + v1 * z2) / (v1 + v2), (v1 + v2) / 2


@wrong("kalman_filter.1", "the right mean, with the variance of a sum")
def variance_of_a_sum(z1, v1, z2, v2, c):
    return (v2 * z1 + v1 * z2) / (v1 + v2), v1 + v2


@wrong("kalman_filter.1", "a variance of zero means no reading, in the first thermometer only")
def first_of_zero(z1, v1, z2, v2, c):
    if v1 == 0:
        return z2, v2
    whole = v1 + v2 - 2 * c
    return z1 + (v1 - c) / whole * (z2 - z1), (v1 * v2 - c**2) / whole


@wrong("kalman_filter.1", "takes correlated readings for independent ones")
def neglects_the_covariance(z1, v1, z2, v2, c):
    return (v2 * z1 + v1 * z2) / (v1 + v2), v1 * v2 / (v1 + v2)


@wrong("kalman_filter.1", "the weights of independent readings, with their true variance")
def weights_of_independent_ones(z1, v1, z2, v2, c):
    share = v1 / (v1 + v2)
    variance = (1 - share) ** 2 * v1 + share**2 * v2 + 2 * share * (1 - share) * c
    return z1 + share * (z2 - z1), variance


@wrong("kalman_filter.1", "the best weights, with the variance of independent readings")
def variance_of_independent_ones(z1, v1, z2, v2, c):
    return z1 + (v1 - c) / (v1 + v2 - 2 * c) * (z2 - z1), v1 * v2 / (v1 + v2)


@wrong("kalman_filter.1", "the covariance with the other sign")
def covariance_added(z1, v1, z2, v2, c):
    whole = v1 + v2 + 2 * c
    return z1 + (v1 + c) / whole * (z2 - z1), (v1 * v2 - c**2) / whole


@wrong("kalman_filter.1", "a share that is kept between 0 and 1")
def clipped(z1, v1, z2, v2, c):
    share = np.clip((v1 - c) / (v1 + v2 - 2 * c), 0, 1)
    variance = (1 - share) ** 2 * v1 + share**2 * v2 + 2 * share * (1 - share) * c
    return z1 + share * (z2 - z1), variance


@wrong("kalman_filter.1", "the covariance taken away once in the denominator, not twice")
def covariance_taken_once(z1, v1, z2, v2, c):
    whole = v1 + v2 - c
    return z1 + (v1 - c) / whole * (z2 - z1), (v1 * v2 - c**2) / whole


@wrong("kalman_filter.1", "takes c for a correlation")
def correlation(z1, v1, z2, v2, c):
    c = c * np.sqrt(v1 * v2)
    whole = v1 + v2 - 2 * c
    return z1 + (v1 - c) / whole * (z2 - z1), (v1 * v2 - c**2) / whole


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


@wrong("kalman_filter.2", "whitens the measurement, and forgets its Jacobian")
def half_whitened(x, P, z, H, R):
    z = np.linalg.solve(np.linalg.cholesky(R), z)
    nis = []
    for value, h in zip(z, H, strict=True):
        S, nu = h @ P @ h + 1, value - h @ x
        K = P @ h / S
        x, P = x + K * nu, P - S * np.outer(K, K)
        nis.append(nu**2 / S)
    return x, P, np.array(nis)


@wrong("kalman_filter.2", "whitens with the transposed Cholesky factor")
def transposed_factor(x, P, z, H, R):
    L = np.linalg.cholesky(R).T
    z, H = np.linalg.solve(L, z), np.linalg.solve(L, H)
    nis = []
    for value, h in zip(z, H, strict=True):
        S, nu = h @ P @ h + 1, value - h @ x
        K = P @ h / S
        x, P = x + K * nu, P - S * np.outer(K, K)
        nis.append(nu**2 / S)
    return x, P, np.array(nis)


@wrong("kalman_filter.2", "whitens with eigenvectors, which mix the later numbers into the first")
def by_eigenvectors(x, P, z, H, R):
    values, vectors = np.linalg.eigh(R)
    whiten = (vectors / np.sqrt(values)).T
    nis = []
    for value, h in zip(whiten @ z, whiten @ H, strict=True):
        S, nu = h @ P @ h + 1, value - h @ x
        K = P @ h / S
        x, P = x + K * nu, P - S * np.outer(K, K)
        nis.append(nu**2 / S)
    return x, P, np.array(nis)


@wrong("kalman_filter.2", "NIS from what is left of the innovation after the update")
def after_the_update(x, P, z, H, R):
    L = np.linalg.cholesky(R)
    z, H = np.linalg.solve(L, z), np.linalg.solve(L, H)
    nis = []
    for value, h in zip(z, H, strict=True):
        S = h @ P @ h + 1
        K = P @ h / S
        x, P = x + K * (value - h @ x), P - S * np.outer(K, K)
        nis.append((value - h @ x) ** 2 / S)
    return x, P, np.array(nis)


@wrong("kalman_filter.2", "NIS with the noise alone")
def without_the_state(x, P, z, H, R):
    L = np.linalg.cholesky(R)
    z, H = np.linalg.solve(L, z), np.linalg.solve(L, H)
    nis = []
    for value, h in zip(z, H, strict=True):
        S, nu = h @ P @ h + 1, value - h @ x
        K = P @ h / S
        x, P = x + K * nu, P - S * np.outer(K, K)
        nis.append(nu**2)
    return x, P, np.array(nis)


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


@wrong("kalman_filter.3", "the first handed in, as it stands: Q in place of R")
def as_handed_in(P, Q, R):
    return P / (P + Q)


@wrong("kalman_filter.3", "adds Q twice, in the prediction and again in the gain")
def twice(P, Q, R):
    return (P + 2 * Q) / (P + 2 * Q + R)


@wrong("kalman_filter.3", "the gain of standard deviations")
def of_deviations(P, Q, R):
    return np.sqrt(P + Q) / (np.sqrt(P + Q) + np.sqrt(R))


@wrong("kalman_filter.3", "brackets forgotten")
def brackets(P, Q, R):
    return P + Q / (P + Q + R)


@wrong("kalman_filter.3", "the weight of the prediction")
def weight_of_the_prediction(P, Q, R):
    return R / (P + Q + R)


@wrong("kalman_filter.3", "the steady gain, whatever P is")
def of_the_steady_state(P, Q, R):
    predicted = (Q + np.sqrt(Q**2 + 4 * Q * R)) / 2
    return predicted / (predicted + R)


@wrong("kalman_filter.3", "updates first, and returns the gain of the next cycle")
def next_cycle(P, Q, R):
    P = P * R / (P + R) + Q
    return P / (P + R)


def _levels(flow, Q, R, level, P):
    """A right one, for arrays."""
    found = []
    for z, q, r in zip(flow, Q, R, strict=True):
        P = P + q
        K = P / (P + r)
        level, P = level + K * (z - level), K * r
        found.append(level)
    return np.array(found)


@wrong("kalman_filter.5", "the covariances of the first year in all, as in pykalman before its pull request 166")
def first_year(flow, Q, R, level, P):
    found = []
    for k, z in enumerate(flow):
        Q, R = (v[k] if np.ndim(v) else v for v in (Q, R))
        P = P + Q
        K = P / (P + R)
        level, P = level + K * (z - level), K * R
        found.append(level)
    return np.array(found)


@wrong("kalman_filter.5", "the first year's Q in all, the others' R")
def first_q(flow, Q, R, level, P):
    Q, R = (np.broadcast_to(v, len(flow)) for v in (Q, R))
    return _levels(flow, np.full(len(flow), Q[0]), R, level, P)


@wrong("kalman_filter.5", "the mean of the variances for all years")
def mean_variances(flow, Q, R, level, P):
    return _levels(flow, np.full(len(flow), np.mean(Q)), np.full(len(flow), np.mean(R)), level, P)


@wrong("kalman_filter.5", "predicts after the update: each Q comes a year late")
def late(flow, Q, R, level, P):
    Q, R = (np.broadcast_to(v, len(flow)) for v in (Q, R))
    return _levels(flow, np.append(0.0, Q[:-1]), R, level, P)


@wrong("kalman_filter.5", "starts from the first flow, and so forgets the level before it")
def from_the_first_flow(flow, Q, R, level, P):
    Q, R = (np.broadcast_to(v, len(flow)) for v in (Q, R))
    return np.append(flow[0], _levels(flow[1:], Q[1:], R[1:], flow[0], R[0]))


@wrong("kalman_filter.5", "the Q of the next year")
def early(flow, Q, R, level, P):
    Q, R = (np.broadcast_to(v, len(flow)) for v in (Q, R))
    return _levels(flow, np.append(Q[1:], Q[-1]), R, level, P)


@wrong("kalman_filter.5", "arrays only if both are")
def both_or_none(flow, Q, R, level, P):
    if np.ndim(Q) and np.ndim(R):
        return _levels(flow, Q, R, level, P)
    return _levels(flow, *(np.full(len(flow), np.ravel(v)[0]) for v in (Q, 2 * np.mean(R))), level, P)


@wrong("kalman_filter.5", "smooths: later flows count, too")
def smoothed(flow, Q, R, level, P):
    Q, R = (np.broadcast_to(v, len(flow)) for v in (Q, R))
    wandered = P + np.cumsum(Q)
    prior = np.minimum.outer(wandered, wandered)
    return level + prior @ np.linalg.solve(prior + np.diag(R), flow - level)


@wrong("kalman_filter.5", "the variance after an update is that before it")
def never_narrows(flow, Q, R, level, P):
    Q, R = (np.broadcast_to(v, len(flow)) for v in (Q, R))
    found = []
    for z, q, r in zip(flow, Q, R, strict=True):
        P = P + q
        level = level + P / (P + r) * (z - level)
        found.append(level)
    return np.array(found)
