"""The algebra of one correction: from innovations and Jacobians to a step and the rows that P loses."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from slamlib import linalg
from slamlib.errors import SlamlibError, UnknownNameError
from slamlib.spaces import Array


@dataclass(frozen=True)
class Observation:
    """What one measurement says: Jacobians (m, dof) by each block it depends on, innovation (m,), noise (m, m)."""

    blocks: Sequence[Any]
    jacobians: Sequence[Array]
    innovation: Array
    noise: Array


@dataclass(frozen=True)
class Correction:
    """What a correction found: the innovation z, its covariance Z, and nis = z' Z^-1 z."""

    innovation: Array
    covariance: Array
    nis: float


def stack(observations: Sequence[Observation]) -> tuple[Array, Array]:
    """All innovations in one vector, all noises in one block-diagonal matrix."""
    if not observations:
        raise SlamlibError("correct_all: no observation given; leave the call out when nothing was seen")
    z, sizes = [], []
    for i, observation in enumerate(observations):
        m = np.asarray(observation.innovation).size
        z.append(linalg.finite(observation.innovation, (m,), "correct", f"innovation {i}"))
        sizes.append(m)
    R, row = np.zeros((sum(sizes),) * 2), 0
    for i, (observation, m) in enumerate(zip(observations, sizes, strict=True)):
        R[row : row + m, row : row + m] = linalg.covariance(observation.noise, m, "correct", f"R {i}")
        row += m
    return np.concatenate(z), R


def _batch(HP: Array, H: Array, touched: Array, S: Array, R: Array, z: Array) -> tuple[Array, Array, float]:
    """Step, rows W with P - W'W the corrected covariance, and nis; from one Cholesky factor of S."""
    factor = linalg.cholesky(S, "correct", "the innovation covariance")
    W = linalg.solve_lower(factor, HP)
    white = linalg.solve_lower(factor, z)
    return white @ W, W, float(white @ white)


def _scalar(HP: Array, H: Array, touched: Array, S: Array, R: Array, z: Array) -> tuple[Array, Array, float]:
    """The same, one number after another, after whitening by the factor of R."""
    factor = linalg.cholesky(R, "correct", "R (which method='scalar' whitens by)")
    H, HP, z = (linalg.solve_lower(factor, a) for a in (H, HP, z))
    step, rows, nis = np.zeros(HP.shape[1]), np.zeros_like(HP), 0.0
    for j, h in enumerate(H):
        running = HP[j] - (h @ rows[:j, touched].T) @ rows[:j]  # h P, with the covariance of this moment
        variance = running[touched] @ h + 1.0
        left = z[j] - h @ step[touched]  # the innovation of this moment
        rows[j] = running / np.sqrt(variance)
        step += running * (left / variance)
        nis += left * left / variance
    return step, rows, float(nis)


_METHODS: dict[str, Callable[..., tuple[Array, Array, float]]] = {"batch": _batch, "scalar": _scalar}


def method_named(name: str) -> Callable[..., tuple[Array, Array, float]]:
    """The way of solving that has this name: "batch" or "scalar"."""
    if name not in _METHODS:
        raise UnknownNameError.of("method", name, _METHODS)
    return _METHODS[name]
