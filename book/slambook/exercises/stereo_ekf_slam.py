"""Checks of the chapter: stereo EKF-SLAM on pictures."""

import numpy as np

from slambook.exercises import Candidate, Rng, exercise
from slambook.exercises.kit import cases, holds, parts, random_covariance, same

VARIANCES = {"the claimed variance": (), "the true variance": ()}


@exercise("stereo_ekf_slam.1", "an error that persists")
def persistent(candidate: Candidate) -> None:
    """Both variances are those of a filter that is run step by step, with the error beside it in the state."""
    for n, p, r, b in cases(
        [(1, 2.0, 1.0, 0.5), (7, 1.0, 0.3, 0.7), (150, 1e3, 0.1, 2.0)], "n, p, r, b = {}, {}, {}, {}"
    ):
        P, joint = p, np.diag([p, b])  # what the filter claims; true, of its error and of the persistent one
        for _ in range(n):
            K = P / (P + r + b)
            step = np.array([[1 - K, K], [0, 1]])
            P, joint = (1 - K) * P, step @ joint @ step.T + np.diag([K**2 * r, 0])
        claimed, true = parts(candidate(n, p, r, b), VARIANCES)
        same(claimed, P, "the claim is that of a Kalman filter after n updates")
        same(true, joint[0, 0], "the true variance is that of the error which this filter makes")


@exercise("stereo_ekf_slam.2", "covariance intersection", seed=222)
def intersection(candidate: Candidate, rng: Rng) -> None:
    """Linear in the information, unbiased, one copy of one estimate, and a bound whatever the correlation is."""
    for n, w in cases([(1, 0.5), (2, 0.2), (3, 0.7)], "{} numbers, weight {}"):
        x, y, shift = rng.standard_normal((3, n))
        joint = random_covariance(rng, 2 * n, 0.1)
        A, B = joint[:n, :n], joint[n:, n:]
        shapes = {"the mean": (n,), "the covariance": (n, n)}
        mean, P = parts(candidate(x, A, y, B, w), shapes)
        same(parts(candidate(x, A, x, A, w), shapes)[1], A, "two copies of one estimate are worth one")
        information = w * np.linalg.inv(A) + (1 - w) * np.linalg.inv(B)
        same(np.linalg.inv(P), information, "it has a share w of A's information, and 1 - w of B's")
        same(candidate(x + shift, A, y + shift, B, w)[0], mean + shift, "the origin is free")
        gains = [np.stack([candidate(e, A, 0 * e, B, w)[0] for e in np.eye(n)], 1)]
        gains.append(np.stack([candidate(0 * e, A, e, B, w)[0] for e in np.eye(n)], 1))
        true = np.hstack(gains) @ joint @ np.hstack(gains).T
        least = np.linalg.eigvalsh(P - true)[0]
        holds(least > -1e-9, "P bounds the true covariance", f"the least eigenvalue of the difference is {least:.3g}")


@exercise("stereo_ekf_slam.3", "RANSAC selects only a number of all the matches")
def selected(candidate: Candidate) -> None:
    """Variances of an average with the weights that the filter gives to each match."""
    for s, n in cases([(12, 12), (6, 12), (3, 40), (1, 2)], "{} of {} matches"):
        K = n / (s + n)  # gain of the update: the prediction has the variance 1/s, the measurement 1/n
        weights = K / n + (1 - K) / s * (np.arange(n) < s)
        claimed, true = parts(candidate(s, n), VARIANCES)
        same(claimed, (1 - K) / s, "the claim is that of independent averages")
        same(true, weights @ weights, "the true variance is that of the sum of all matches, with their weights")
