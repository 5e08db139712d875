"""Nonlinear least squares over many variables, each tied to few others: sparse, on manifolds, by Levenberg-Marquardt.

The cost is a sum over factors, functions of the values of all variables. Each step solves the sparse normal equations
in the directions in which the variables may move; a step that does not lower the cost is tried again, more cautiously
(Marquardt 1963). The columns of the matrix's inverse that are asked for are covariances. CHOLMOD factors it where
scikit-sparse is installed (0.5 or newer), in less than half of the time; SciPy otherwise.
"""

import warnings
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from slamlib.errors import SingularPointError, SlamlibError, optional
from slamlib.geometry.pose import ORIGIN
from slamlib.manifolds import Array, Indices, Manifold

EXACT = 1e-6  # [m, rad, ...] standard deviation of what is exactly known, or never moves
CONVERGED = 1e-10  # of the cost: what the last step has to gain
DAMPING = (1e-4, 1e8)  # the first that is tried, and where it is given up
Values = list[Array]  # of each variable, (count, size)


@dataclass(frozen=True, eq=False)
class Variable:
    """Points of one manifold: a robot's states, extrinsics, or landmarks of one kind; columns begin at `start`."""

    manifold: Manifold
    index: int
    start: int
    kind: Any = None  # of landmarks

    @property
    def is_line(self) -> bool:
        """Whether these are lines, along which abscissas are counted."""
        return hasattr(self.kind, "abscissas")

    @property
    def is_level(self) -> bool:
        """Whether these are points of the floor, whose homogeneous numbers in the world have a zero for the height."""
        return bool(getattr(self.kind, "plane", False))

    @property
    def width(self) -> int:
        """Number of directions, and of columns, of each, however many numbers hold it: a point has 3, a line 4."""
        own = 4 if self.is_line else 3 - self.is_level
        return self.manifold.dof if self.kind is None else min(self.manifold.dof, own)

    def columns(self, items: Indices) -> Indices:
        """Columns (k, width) of items (k,)."""
        return self.start + self.width * items[:, None] + np.arange(self.width)

    def basis(self, values: Array) -> Array:
        """Directions (count, dof, width) that change more than the scale of a landmark's homogeneous numbers."""
        if self.width == self.manifold.dof:
            return np.broadcast_to(np.eye(self.width), (len(values), self.width, self.width))
        y, J = self.kind.to_frame.jac(ORIGIN, values)
        by_landmark = J.landmark
        if self.is_level:
            y, by_landmark = np.delete(y, 2, axis=-1), np.delete(by_landmark, 2, axis=-2)
        # A line's numbers (n, v) also stay on n . v = 0, whose gradient is (v, n).
        fixed = np.stack([y, np.roll(y, 3, axis=-1)][: 1 + self.is_line], axis=-1)
        gradients = np.linalg.qr(fixed, mode="complete")[0][..., fixed.shape[-1] :]
        held = fixed[..., 1:] if getattr(self.kind, "constrain", None) else fixed[..., :0]
        rows = by_landmark.swapaxes(-1, -2) @ np.concatenate([held, gradients], axis=-1)
        return np.linalg.qr(rows)[0][..., held.shape[-1] :]

    def moved(self, values: Array, step: Array) -> Array:
        """Values after a step (all columns,); lines are put back on their constraint."""
        own = step[self.columns(np.arange(len(values)))]
        moved: Array = self.manifold.plus(values, (self.basis(values) @ own[..., None])[..., 0])
        constrain = getattr(self.kind, "constrain", None)
        return moved if constrain is None else np.asarray(constrain(moved, np.zeros(3)))


class Terms(NamedTuple):
    """Cost, whitened residuals (n, m), and their Jacobians (n, m, dof) w.r.t. items (n,) of variables."""

    cost: float
    residual: Array
    parts: list[tuple[Variable, Indices, Array]]


Factor = Callable[[Values], Terms]
Solve = Callable[[Array], Array]


def by_cholmod(H: Any) -> Solve | None:
    """What solves with a sparse H; None if H is not positive definite. Raises ImportError without scikit-sparse."""
    from sksparse.cholmod import CholmodNotPositiveDefiniteError, CholmodWarning, cho_factor  # of 0.5 or newer

    try:
        found = cho_factor(H)
    except CholmodNotPositiveDefiniteError:
        return None

    def solve(b: Array) -> Array:
        with warnings.catch_warnings():  # the diagonal is as uneven as the units and the noise of the unknowns
            warnings.simplefilter("ignore", CholmodWarning)
            solved: Array = found.solve(b)
        return solved

    return solve


def by_superlu(H: Any) -> Solve | None:
    """The same by SciPy. Raises SlamlibError without it."""
    linalg = optional("scipy.sparse.linalg", "to smooth", "fast")
    try:
        found = linalg.splu(H, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True})
    except RuntimeError:  # exactly singular
        return None
    return found.solve if (found.U.diagonal() > 0).all() else None


class NormalEquations(NamedTuple):
    """H step = g (size,) of all factors at one point, sparse; their cost, and their number of residuals."""

    cost: float
    rows: int
    H: Any
    g: Any

    @classmethod
    def of(cls, factors: Sequence[Factor], variables: Sequence[Variable], values: Values) -> "NormalEquations | None":
        """H = J'J and g = -J'r; None where the cost is infinite, or a model is not defined."""
        sparse = optional("scipy.sparse", "to smooth", "fast")
        try:
            terms = [factor(values) for factor in factors]
        except SingularPointError:
            return None
        cost, start, blocks = sum(found.cost for found in terms), 0, []
        if not np.isfinite(cost):
            return None
        bases = [variable.basis(value) for variable, value in zip(variables, values, strict=True)]
        for found in terms:
            rows = start + np.arange(found.residual.size).reshape(*found.residual.shape, 1)
            start += found.residual.size
            for variable, items, J in found.parts:
                by = J @ bases[variable.index][items]
                blocks.append([a.ravel() for a in np.broadcast_arrays(by, rows, variable.columns(items)[:, None])])
        numbers, row, column = (np.concatenate(arrays) for arrays in zip(*blocks, strict=True))
        size = sum(variable.width * len(value) for variable, value in zip(variables, values, strict=True))
        J = sparse.csr_matrix((numbers, (row, column)), shape=(start, size))
        H, g = J.T @ J, -(J.T @ np.concatenate([found.residual.ravel() for found in terms]))
        silent = H.diagonal() == 0  # nothing tells anything about this direction: it stays as it is
        return cls(cost, start, (H + sparse.diags(silent / EXACT**2)).tocsc(), g)

    def factor(self, damping: float) -> Solve | None:
        """What solves with H + damping * diag(H); None if that is not positive definite."""
        sparse = optional("scipy.sparse", "to smooth", "fast")
        H = (self.H + sparse.diags(damping * self.H.diagonal())).tocsc()
        try:
            return by_cholmod(H)
        except ImportError:
            return by_superlu(H)


@dataclass(frozen=True, eq=False)
class Minimum:
    """Where the steps ended: values, the costs before the first and after each accepted step, what solves with H there.

    steps: tried; converged: whether another one would gain next to nothing; rows: number of residuals.
    """

    variables: list[Variable]
    values: Values
    costs: tuple[float, ...]
    steps: int
    converged: bool
    rows: int
    solve: Solve

    @property
    def size(self) -> int:
        """Number of unknown numbers."""
        return sum(variable.width * len(value) for variable, value in zip(self.variables, self.values, strict=True))

    def marginals(self, variable: Variable, items: Indices) -> Array:
        """Covariances (k, width, width) of items: columns of the inverse of H, those of 64 items at a time."""
        found = [np.zeros((0, variable.width, variable.width))]
        for some in np.array_split(variable.columns(items), len(items) // 64 + 1):
            unit = np.zeros((self.size, some.size))
            unit[some.ravel(), np.arange(some.size)] = 1
            solved = self.solve(unit).reshape(self.size, *some.shape)
            own = solved[some[:, :, None], np.arange(len(some))[:, None, None], np.arange(variable.width)]
            found.append((own + own.swapaxes(-1, -2)) / 2)
        return np.concatenate(found)


def minimize(factors: Sequence[Factor], variables: list[Variable], values: Values, steps: int) -> Minimum:
    """Try at most this many steps from these values; the cost never rises. Raises SlamlibError."""
    now = NormalEquations.of(factors, variables, values)
    if now is None:
        raise SlamlibError("solve: the filter's means are no place to start from: the models are not defined there")
    costs, damping, tried, converged = [now.cost], 0.0, 0, False
    while not converged and damping < DAMPING[1] and tried < steps:
        tried += 1
        solve, following = now.factor(damping), None
        if solve is not None:
            step = solve(now.g)
            trial = [v.moved(value, step) for v, value in zip(variables, values, strict=True)]
            following = NormalEquations.of(factors, variables, trial)
            converged = bool(damping < DAMPING[0] and now.g @ step < CONVERGED)
        if following is not None and following.cost <= now.cost:
            values, now, damping = trial, following, damping / 10 if damping > DAMPING[0] else 0.0
            costs.append(now.cost)
        else:
            damping = max(10 * damping, DAMPING[0])
    solve = now.factor(0.0)
    if solve is None:
        raise SlamlibError("solve: the measurements do not determine all poses and landmarks; record more frames")
    return Minimum(variables, values, tuple(costs), tried, converged, now.rows, solve)
