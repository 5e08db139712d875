"""Wrong solutions of chapter 2."""

import numpy as np

from slamlib.tests.wrong_solutions import wrong


@wrong("2.2", "the innovations of the prediction throughout (E16)")
def stale(x, P, z, H, R):
    innovations = z - H @ x
    for j, h in enumerate(H):
        K = P @ h / (h @ P @ h + R[j, j])
        x, P = x + K * innovations[j], P - np.outer(K, h @ P)
    return x, P


@wrong("2.2", "the diagonal of R only (E17)")
def diagonal_only(x, P, z, H, R):
    for j, h in enumerate(H):
        K = P @ h / (h @ P @ h + R[j, j])
        x, P = x + K * (z[j] - h @ x), P - np.outer(K, h @ P)
    return x, P


@wrong("2.2", "every gain from the predicted covariance")
def stale_covariance(x, P, z, H, R):
    new = P
    for j, h in enumerate(H):
        K = P @ h / (h @ P @ h + R[j, j])
        x, new = x + K * (z[j] - h @ x), new - np.outer(K, h @ P)
    return x, new


@wrong("2.3", "Q and R swapped, as by whoever takes the letters of kalmanjs for the common ones (its issue 22)")
def swapped(P, Q, R):
    return (P + R) / (P + R + Q)


@wrong("2.3", "the prediction leaves out Q, as in itamarwe/kalman, issue 5")
def without_prediction(P, Q, R):
    return P / (P + R)


@wrong("2.3", "counts Q as measurement noise")
def q_in_the_denominator(P, Q, R):
    return P / (P + Q + R)
