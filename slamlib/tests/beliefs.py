"""What the belief's tests share: random covariances, a small manifold, and a belief's state to compare."""

import numpy as np

from slamlib.errors import UnitError


def random_covariance(rng, n):
    """A well-conditioned covariance."""
    A = rng.standard_normal((n, n))
    return A @ A.T + 0.1 * np.eye(n)


class Circle:
    """Directions in the plane, stored as unit vectors: two numbers, one degree of freedom."""

    size, dof = 2, 1

    def plus(self, point, step):
        angle = np.arctan2(point[1], point[0]) + step[0]
        return np.array([np.cos(angle), np.sin(angle)])

    def minus(self, point, origin):
        turn = complex(*point) / complex(*origin)
        return np.array([np.angle(turn)])

    def check(self, point, what):
        if abs(np.hypot(*point) - 1) > 1e-6:
            raise UnitError(f"{what} is no unit vector")


def grown(belief, rng, *sizes):
    """Vectors of these sizes, all correlated."""
    blocks = []
    for n in sizes:
        gains = [rng.standard_normal((n, b.dof)) for b in blocks]
        mean, noise = rng.standard_normal(n), random_covariance(rng, n)
        blocks.append(belief.add(n, mean, noise, given=blocks, jacobians=gains))
    return blocks


def state(belief):
    """All of a belief, for comparison bit by bit."""
    parts = [(id(b), b.manifold, b.start, b.mean.tobytes()) for b in belief.blocks]
    return parts, belief.matrix.tobytes(), belief.matrix.shape
