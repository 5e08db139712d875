"""Long chains of small numbers (section 9.2): what many steps lose in single and in double precision.

A robot on a line, with a velocity, measures its distance to one landmark repeatedly: three numbers, of which two are
known relative to each other to millimetres, and together only as well as the start was known.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from slamlib.manifolds import Array

TURN = np.array([0.01, 0.02, -0.005])  # rad, of each step
F = np.array([[1, 0.1, 0], [0, 1, 0], [0, 0, 1.0]])
Q, H, NOISE = np.diag([1e-6, 1e-4, 0]), np.array([1.0, 0, -1]), 1e-4


def norm_after(steps: int, kind: type) -> float:
    """Distance from 1 of a quaternion's norm after so many products without normalisation."""
    half = TURN / 2
    w, (a, b, c) = np.sqrt(1 - half @ half), half
    turn: Array = np.array([[w, -a, -b, -c], [a, w, c, -b], [b, -c, w, a], [c, b, -a, w]]).astype(kind)
    q: Array = np.array([1, 0, 0, 0], kind)
    for _ in range(steps):
        q = turn @ q
    return abs(float(np.linalg.norm(q.astype(float))) - 1)


FORMS: dict[str, Callable[[Array, Array, Array], Array]] = {  # of P, h = P H' and S: (5.32), (3.14)
    "P - S K K'": lambda P, h, S: P - np.multiply.outer(h, h) / S,
    "(I - K H) P": lambda P, h, S: (np.eye(3, dtype=P.dtype) - np.multiply.outer(h / S, H.astype(P.dtype))) @ P,
}


@dataclass(frozen=True)
class Chain:
    """After the last step. asymmetry, least (eigenvalue): over the largest entry of P; apart: the variance [m^2] by P
    of the distance of robot and landmark; steps: done, fewer than asked for if S = H P H' + R was negative."""

    asymmetry: float
    least: float
    apart: float
    steps: int


def covariance_after(steps: int, kind: type, start: float, form: str) -> Chain:
    """Predictions and updates; start: standard deviation [m] of both positions together."""
    P: Array = np.diag([start**2, 1, start**2]).astype(kind)
    f: Array = F.astype(kind)
    q: Array = Q.astype(kind)
    h: Array = H.astype(kind)
    r = kind(NOISE)
    P[0, 2] = P[2, 0] = kind(start**2)
    done = 0
    while done < steps:
        P = f @ P @ f.T + q
        S = h @ (P @ h) + r
        if not S > 0:  # what follows would mean nothing
            break
        P, done = FORMS[form](P, P @ h, S), done + 1
    C = P.astype(float)
    size = float(np.abs(C).max())
    least = float(np.linalg.eigvalsh((C + C.T) / 2)[0])
    return Chain(float(np.abs(C - C.T).max()) / size, least / size, float(H @ C @ H), done)
