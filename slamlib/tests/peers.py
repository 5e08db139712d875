"""What the tests beside other people's programs share: singular and random inputs, and the matrices of poses."""

import numpy as np
from hypothesis import strategies as st

HALF = np.pi
LENGTHS = [0.0, 1e-200, 1e-12, 1e-8, 1e-4, HALF / 2, HALF - 1e-9, HALF, HALF + 1e-9, 2 * HALF - 1e-9, 2 * HALF, 9.0]
NUMBERS = st.floats(-3, 3, allow_subnormal=False)
TINY = st.sampled_from([0.0, 1.0, -1.0, 1e-200, -1e-12, 1e-8, 1e-4])


def several(numbers, count):
    """Arrays (count,)."""
    return st.lists(numbers, min_size=count, max_size=count).map(np.array)


def units(size):
    """Unit vectors (size,), among them those along an axis and those that hardly leave it."""
    long = several(st.one_of(TINY, st.floats(-1, 1)), size).filter(lambda v: np.linalg.norm(v) > 0.1)
    return long.map(lambda v: v / np.linalg.norm(v))


def turns(longest=np.inf):
    """Rotation vectors (3,) [rad]: none, hardly any, half a turn, a whole one, and others up to three turns."""
    lengths = st.one_of(st.sampled_from([a for a in LENGTHS if a <= longest]), st.floats(0, min(9.0, longest)))
    return st.tuples(lengths, units(3)).map(lambda pair: pair[0] * pair[1])


QUATERNIONS = units(4)  # of either sign, half turns among them
POSES = st.tuples(several(NUMBERS, 3), QUATERNIONS).map(np.concatenate)
PLANAR = st.tuples(NUMBERS, NUMBERS, st.one_of(st.sampled_from(LENGTHS), st.floats(-9, 9))).map(np.array)
SEEDS = st.integers(0, 2**32 - 1)


def with_jacobians(model, *arguments):
    """Value and Jacobians of a model, whose code without Jacobians has to give the same value."""
    value, J = model.jac(*arguments)
    np.testing.assert_allclose(model(*arguments), value, rtol=1e-14, atol=1e-14)
    return value, J


def skew(v):
    """The matrix (3, 3) of v x."""
    x, y, z = v
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def rigid(turn, shift):
    """The square matrix of a motion: its product with (point, 1) is (turn point + shift, 1)."""
    n = len(shift)
    matrix = np.eye(n + 1)
    matrix[:n, :n], matrix[:n, n] = turn, shift
    return matrix


def twisted(twist):
    """The matrix whose expm is the motion by a twist: (x, y, turn), or in space (x, y, z, rotation vector)."""
    n = 2 if len(twist) == 3 else 3
    matrix = np.zeros((n + 1, n + 1))
    matrix[:n, :n] = skew([0, 0, twist[2]])[:2, :2] if n == 2 else skew(twist[3:])
    matrix[:n, n] = twist[:n]
    return matrix


def directions(matrix):
    """Derivatives of the matrix of a pose along each direction of a step: along the world's axes, about its own."""
    n = len(matrix) - 1
    found = np.zeros((n, n + 1, n + 1))
    found[np.arange(n), np.arange(n), n] = 1.0
    about = [skew([0, 0, 1])[:2, :2]] if n == 2 else [skew(axis) for axis in np.eye(3)]
    turned = np.zeros((len(about), n + 1, n + 1))
    turned[:, :n, :n] = matrix[:n, :n] @ np.array(about)
    return np.concatenate([found, turned])


def step_of(matrix, rates):
    """The steps (dof, k) of the pose with this matrix that belong to derivatives (k, n + 1, n + 1) of it."""
    n = len(matrix) - 1
    about = matrix[:n, :n].T @ rates[:, :n, :n]
    turn = [about[:, 1, 0]] if n == 2 else [about[:, 2, 1], about[:, 0, 2], about[:, 1, 0]]
    return np.concatenate([rates[:, :n, n].T, np.array(turn)])


def covariance(rng, n, spread=0.0, rank=None):
    """A covariance (n, n) of any rank, with rows of units that differ by up to 10^spread."""
    A = rng.standard_normal((n, rng.integers(0, n + 1) if rank is None else rank))
    units = 10.0 ** rng.uniform(-spread / 2, spread / 2, n)
    return units[:, None] * (A @ A.T) * units
