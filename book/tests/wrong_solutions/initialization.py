"""Wrong solutions of chapter initialization."""

import numpy as np

from book.tests.wrong_solutions import wrong


def _two(p, q, s, v, both, before=None):
    before = p + s if before is None else before
    return np.array(
        [
            [p + q, 0, p, p + q],
            [0, s, s, s],
            [p, s, p + s + v, before],
            [p + q, s, before, p + q + s + v + both],
        ]
    )


@wrong("initialization.1", "the landmarks share the robot, and the extrinsics are forgotten between them")
def no_shared_extrinsics(p, q, s, v):
    return _two(p, q, s, v, 0.0, p)


@wrong("initialization.1", "extrinsics of which nobody speaks: constant, so they cannot be an error")
def mount_known(p, q, s, v):
    return np.diag([0.0, s, 0, 0]) + _two(p, q, 0.0, v, 0.0)


@wrong("initialization.1", "the extrinsics are a new error in each picture")
def new_mount_each_time(p, q, s, v):
    return _two(p, q, s, v, s, p + s)


@wrong("initialization.1", "landmark 1 inherits the robot as it is now")
def robot_now(p, q, s, v):
    P = _two(p, q, s, v, 0.0, p + q + s)
    P[2, 2] = p + q + s + v
    P[0, 2] = P[2, 0] = p + q
    return P


def _joined(P, cross, corner):
    return np.block([[P, cross.T], [cross, corner]])


@wrong("initialization.2", "as (5.34) prints it: no covariance with the landmarks that are there already")
def robot_only(P, at, G, noise):
    cross = np.zeros((len(G), len(P)))
    cross[:, at] = G @ P[np.ix_(at, at)]
    return _joined(P, cross, G @ P[np.ix_(at, at)] @ G.T + noise)


@wrong("initialization.2", "the landmark's own covariance is right; the rest will come with time")
def no_cross(P, at, G, noise):
    return _joined(P, np.zeros((len(G), len(P))), G @ P[np.ix_(at, at)] @ G.T + noise)


@wrong("initialization.2", "takes the rows for neighbours, as those of one robot are")
def contiguous(P, at, G, noise):
    rows = slice(at[0], at[0] + len(at))
    cross = G[:, : len(P[rows])] @ P[rows]
    return _joined(P, cross, G @ P[np.ix_(at, at)] @ G.T + noise)


@wrong("initialization.2", "forgets what the measurement adds")
def no_noise(P, at, G, noise):
    return _joined(P, G @ P[at], G @ P[np.ix_(at, at)] @ G.T)


@wrong("initialization.3", "the sign of G_r")
def sign(H_r, H_l, P, R):
    back = np.linalg.inv(H_l)
    G = back @ H_r
    return G @ P @ G.T + back @ R @ back.T, G @ P


@wrong(
    "initialization.3", "the landmark's error is the measurement's: the robot is where it is, as in a particle filter"
)
def particle(H_r, H_l, P, R):
    back = np.linalg.inv(H_l)
    return back @ R @ back.T, np.zeros((len(H_l), len(P)))


@wrong("initialization.3", "forward Jacobian where the inverse belongs")
def forward(H_r, H_l, P, R):
    G = -H_l @ H_r
    return G @ P @ G.T + H_l @ R @ H_l.T, G @ P


@wrong("initialization.3", "one of the two factors transposed")
def transposed(H_r, H_l, P, R):
    back = np.linalg.inv(H_l)
    G = -back @ H_r
    return G @ P @ G.T + back.T @ R @ back, G @ P
