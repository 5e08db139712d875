"""Random numbers of a simulation: a separate stream for each thing that is drawn, and Gaussians on manifolds."""

import numpy as np

from slamlib.errors import SlamlibError
from slamlib.manifolds import Array, Manifold
from slamlib.observation import FAMILIES

KINDS = ("start", "control", "extrinsics", "points", "segments", "faults")  # other families come after these

Streams = dict[str, np.random.Generator]


def streams(rng: np.random.Generator, count: int) -> list[Streams]:
    """A generator of every kind for each of `count` robots or sensors; they depend on the state of `rng` alone.

    The streams are independent: another sensor, another fault, or a filter that draws from `rng` leaves all other
    numbers as they were. Raises SlamlibError.
    """
    if not isinstance(rng, np.random.Generator):
        raise SlamlibError(f"simulate: rng is a generator, such as np.random.default_rng(1), not {rng!r}")
    seed = rng.integers(2**32, size=4).tolist()
    kinds = (*KINDS, *sorted(set(FAMILIES) - set(KINDS)))
    return [
        {kind: np.random.default_rng(np.random.SeedSequence(seed, spawn_key=(i, k))) for k, kind in enumerate(kinds)}
        for i in range(count)
    ]


def drawn(manifold: Manifold, mean: Array, covariance: Array, rng: np.random.Generator) -> Array:
    """Draw a point (size,) from a Gaussian in the tangent space: mean (size,), covariance (dof, dof)."""
    return manifold.plus(mean, root(covariance) @ rng.standard_normal(manifold.dof))


def root(covariance: Array) -> Array:
    """The symmetric square root of a covariance, which may be singular."""
    values, vectors = np.linalg.eigh(covariance)
    return (vectors * np.sqrt(np.maximum(values, 0))) @ vectors.T
