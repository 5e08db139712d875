"""Wrong solutions of chapter stereo_ekf_slam."""

import numpy as np

from book.tests.wrong_solutions import wrong


@wrong("stereo_ekf_slam.1", "adds the persistent error to the claim: the prior has its share of the estimate, too")
def added(n, p, r, b):
    claimed = 1 / (1 / p + n / (r + b))
    return claimed, claimed + b


@wrong("stereo_ekf_slam.1", "the variance of the mean of the measurements: no prior")
def without_a_prior(n, p, r, b):
    return (r + b) / n, b + r / n


@wrong("stereo_ekf_slam.1", "the filter that takes only the new errors for noise")
def another_filter(n, p, r, b):
    claimed = 1 / (1 / p + n / r)
    weight = n * claimed / r
    return claimed, (1 - weight) ** 2 * p + weight**2 * (b + r / n)


@wrong("stereo_ekf_slam.1", "the persistent error averages out as the new ones do")
def averaged_out(n, p, r, b):
    claimed = 1 / (1 / p + n / (r + b))
    return claimed, claimed


def _fused(x, A, y, B, first, second):
    A, B = first * np.linalg.inv(A), second * np.linalg.inv(B)
    P = np.linalg.inv(A + B)
    return P @ (A @ x + B @ y), P


@wrong("stereo_ekf_slam.2", "takes the two for independent")
def independent(x, A, y, B, weight):
    return _fused(x, A, y, B, 1, 1)


@wrong("stereo_ekf_slam.2", "doubles both covariances whatever the weight is")
def doubled(x, A, y, B, weight):
    return _fused(x, A, y, B, 0.5, 0.5)


@wrong("stereo_ekf_slam.2", "averages estimates and covariances, and not information")
def averaged(x, A, y, B, weight):
    return weight * x + (1 - weight) * y, weight * A + (1 - weight) * B


@wrong("stereo_ekf_slam.2", "multiplies the covariances by the weights, in place of dividing")
def multiplied(x, A, y, B, weight):
    return _fused(x, A, y, B, 1 / weight, 1 / (1 - weight))


@wrong("stereo_ekf_slam.3", "as the report argues: the selected matches are independent of the rest")
def as_the_report_argues(s, n):
    return 1 / (s + n), 1 / (s + n)


@wrong("stereo_ekf_slam.3", "the matches are used twice, so the estimate is that of using them once")
def used_once(s, n):
    return 1 / (s + n), 1 / n


@wrong("stereo_ekf_slam.3", "both parts of the error, without their covariance")
def without_the_covariance(s, n):
    K = n / (s + n)
    return 1 / (s + n), (1 - K) ** 2 / s + K**2 / n


@wrong("stereo_ekf_slam.3", "the covariance of the two parts counted once")
def covariance_once(s, n):
    K = n / (s + n)
    return 1 / (s + n), (1 - K) ** 2 / s + K**2 / n + K * (1 - K) / n
