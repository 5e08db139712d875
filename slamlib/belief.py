"""A Gaussian belief over blocks: each block has a mean on its own manifold, all share one dense covariance.

The covariance is over tangent vectors, so a pose takes six rows and the matrix is never singular by construction. Every
change is checked first and made completely or not at all. The same few functions serve a linear Kalman filter, an
extended one, and SLAM. Derived in chapters kalman_filter and extended_kalman_filter (predict, update) and
stochastic_map (blocks: add, replace, remove; what each costs).

The matrix has exactly the size of the state: adding, replacing and removing blocks build it anew. That costs an eighth
of one update; and what every update touches is contiguous, a third quicker than a view of a larger array.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager

import numpy as np
from numpy.typing import ArrayLike

from slamlib.errors import ShapeError, SlamlibError
from slamlib.kalman import linalg
from slamlib.kalman.state import BeliefSnapshot, Block, Retraction, StateLayout, checked_mean
from slamlib.kalman.update import LinearizedMeasurement, SequentialUpdate, StackedMeasurements, UpdateResult
from slamlib.manifolds import Array, Indices, Manifold, as_manifold, finite, numbers, read_only_copy

__all__ = ["Belief", "BeliefSnapshot", "Block", "LinearizedMeasurement", "UpdateResult"]


class Belief:
    """Means of blocks and their joint covariance.

    retraction: how a step moves all means together; None: each block by its own plus. transport: called once the means
    have been updated, it says in what coordinates errors are then, (rows (k,), C (size, k)): e becomes e + C e[rows];
    None: they stay. Both may be assigned at any time.

        >>> import numpy as np
        >>> import slamlib as sl
        >>> belief = sl.Belief()
        >>> place = belief.add(2, mean=[0, 0], covariance=np.diag([4, 1]))
        >>> _ = belief.update([place], [np.array([[1, 0]])], innovation=[1], R=[[1]])  # the first number: 1 more, +-1
        >>> place.mean.round(3).tolist(), belief.covariance(place).round(3).tolist()
        ([0.8, 0.0], [[0.8, 0.0], [0.0, 1.0]])
    """

    def __init__(self, retraction: Retraction | None = None) -> None:
        self.retraction = retraction
        self.transport: Callable[[], linalg.Carry | None] | None = None
        self._set([], np.zeros((0, 0)))

    def __repr__(self) -> str:
        """How much it estimates."""
        return f"Belief: {self.size} degrees of freedom in {len(self._blocks)} block{'s' * (len(self._blocks) != 1)}"

    @property
    def blocks(self) -> tuple[Block, ...]:
        """The blocks, in the order of their rows."""
        return tuple(self._blocks)

    @property
    def size(self) -> int:
        """Number of estimated degrees of freedom."""
        return len(self._P)

    @property
    def matrix(self) -> Array:
        """The joint covariance (size, size), as a read-only view: copy it to keep it."""
        view = self._P.view()
        view.flags.writeable = False
        return view

    def covariance(self, a: Block, b: Block | None = None) -> Array:
        """Covariance (dof, dof) of one block, or cross-covariance of two, as a copy."""
        b = a if b is None else b
        self._own([a, b])
        return self._P[a.slice, b.slice].copy()

    def snapshot(self) -> BeliefSnapshot:
        """A copy of the present means and covariance."""
        blocks = self.blocks
        means, slices = tuple(b.mean for b in blocks), tuple(b.slice for b in blocks)
        return BeliefSnapshot(means, slices, read_only_copy(self._P), tuple(b.manifold for b in blocks), blocks, self)

    def restore(self, snapshot: BeliefSnapshot) -> None:
        """Return to a snapshot: blocks removed since then are back, blocks added since then are gone."""
        if snapshot.belief is not self:
            raise SlamlibError("restore: the snapshot was taken from another belief, whose blocks are not of this one")
        self._set(snapshot.blocks, snapshot.covariance.copy(), zip(snapshot.manifolds, snapshot.means, strict=True))

    def overwrite(self, blocks: Mapping[int, Block], means: Mapping[int, Array], covariance: Array) -> None:
        """Set means and covariance to saved values, bit for bit; blocks by their index among the rows.

        Raises ShapeError, NonFiniteError, CovarianceError; SlamlibError unless the blocks are exactly those of this
        belief.
        """
        if sorted(map(id, blocks.values())) != sorted(map(id, self._blocks)) or sorted(blocks) != sorted(means):
            raise SlamlibError("overwrite: give every block of the belief once, with its mean")
        P = finite(covariance, (self.size, self.size), "overwrite", "covariance")
        linalg.check_variances(P, "overwrite", "covariance")
        ordered = [blocks[i] for i in sorted(blocks)]
        points = [(blocks[i].manifold, checked_mean(blocks[i].manifold, means[i], "overwrite")) for i in sorted(blocks)]
        self._set(ordered, P.copy(), points)

    @linalg.quiet_floats
    def add(
        self,
        manifold: int | Manifold,
        mean: ArrayLike,
        covariance: ArrayLike,
        *,
        given: Sequence[Block] = (),
        jacobians: Sequence[ArrayLike] = (),
    ) -> Block:
        """Add a block: independent, or a function of the blocks `given` plus noise of this covariance (dof, dof).

        jacobians: of the new block w.r.t. each given block, (dof, dof of the given block). The new rows are then
        sum G_i P_i and the new corner sum G_i P_ij G_j' + covariance (Report eq. 5.34-5.35, corrected).
        Raises ShapeError, NonFiniteError, CovarianceError; UnitError where the mean is no point of the manifold.
        """
        manifold = as_manifold(manifold)
        mean = checked_mean(manifold, mean, "add")
        corner = linalg.covariance(covariance, manifold.dof, "add", "covariance")
        self._own(given)
        rows, gains = np.zeros((manifold.dof, self.size)), []
        if given or jacobians:
            gains = LinearizedMeasurement(given, jacobians, mean, corner).checked_jacobians(manifold.dof, "add")
        for block, G in zip(given, gains, strict=True):
            rows += G @ self._P[block.slice]
        for block, G in zip(given, gains, strict=True):
            corner = corner + rows[:, block.slice] @ G.T
        linalg.check_overflow("add", rows, corner)
        block = Block(manifold, mean, self.size)
        self._append(block, linalg.replace_rows(self._P, slice(self.size, self.size), rows, corner))
        return block

    def remove(self, block: Block) -> None:
        """Delete a block: its rows and columns go, exactly the marginal of the others remains. Its handle is void."""
        self._own([block])
        P = linalg.replace_rows(self._P, block.slice, np.zeros((0, self.size)), np.zeros((0, 0)))
        self._set([b for b in self._blocks if b is not block], P)

    @linalg.quiet_floats
    def replace(
        self,
        block: Block,
        manifold: int | Manifold,
        mean: Array,
        jacobian: Array,
        *,
        given: Sequence[Block] = (),
        jacobians: Sequence[Array] = (),
    ) -> Block:
        """Change a block's parametrization: its rows become J P, J (new dof, old dof). Every handle stays valid.

        given, jacobians: of a change that depends on other blocks, too, those with (new dof, dof of the other block).
        """
        manifold = as_manifold(manifold)
        mean = checked_mean(manifold, mean, "replace")
        self._own([block, *given])
        J = finite(jacobian, (manifold.dof, block.dof), "replace", "jacobian")
        pairs = zip(given, jacobians, strict=True)
        others = [(other, finite(G, (manifold.dof, other.dof), "replace", "jacobians")) for other, G in pairs]
        rows = J @ self._P[block.slice]
        for other, G in others:
            rows += G @ self._P[other.slice]
        corner = rows[:, block.slice] @ J.T
        for other, G in others:
            corner = corner + rows[:, other.slice] @ G.T
        linalg.check_overflow("replace", rows, corner)
        P = linalg.replace_rows(self._P, block.slice, rows, corner)
        block.set_mean(manifold, mean)
        self._set(self.blocks, P)
        return block

    @linalg.quiet_floats
    def predict(self, block: Block, mean: ArrayLike, F: ArrayLike, Q: ArrayLike) -> None:
        """Predict a block: its mean becomes `mean`, its rows F P, its corner F P F' + Q (Report eq. 5.23, with Q).

        mean (size of the manifold,), F (dof, dof) at the mean before the motion, Q (dof, dof) semi-definite.
        """
        self._own([block])
        mean, n = checked_mean(block.manifold, mean, "predict"), block.dof
        F, Q = finite(F, (n, n), "predict", "F"), linalg.covariance(Q, n, "predict", "Q")
        self.predict_modelled(block, mean, F, Q)

    @linalg.quiet_floats
    def predict_modelled(self, block: Block, mean: Array, F: Array, Q: Array) -> None:
        """As `predict`, for a block of this belief: numbers that models gave, and noise made of one checked before."""
        P, at = self._P, block.slice
        rows = F @ P[at]
        corner = rows[:, at] @ F.T + (Q / 2 + Q.T / 2)
        linalg.check_overflow("predict", rows, corner)
        P[at], P[:, at] = rows, rows.T
        P[at, at] = corner / 2 + corner.T / 2
        block.mean = read_only_copy(mean)

    @linalg.quiet_floats
    def innovation_covariance(self, blocks: Sequence[Block], jacobians: Sequence[Array], R: Array) -> Array:
        """S = H P H' + R, (m, m), for the blocks that a measurement depends on: what a gate needs before the update."""
        rows = np.shape(jacobians[0])[:1] if len(jacobians) else ()
        measurement = LinearizedMeasurement(blocks, jacobians, np.zeros(rows or 1), R)
        stacked = StackedMeasurements.of([measurement], "innovation_covariance", self._own)
        S = stacked.innovation_covariance(stacked.H @ self._P[stacked.touched])
        linalg.check_overflow("innovation_covariance", S)
        return S

    def update(
        self, blocks: Sequence[Block], jacobians: Sequence[Array], innovation: Array, R: Array, *, method: str = "batch"
    ) -> UpdateResult:
        """Update all blocks by one measurement: innovation z = y - e (m,), Jacobians of e, noise R (m, m)."""
        return self.update_all([LinearizedMeasurement(blocks, jacobians, innovation, R)], method=method)

    @linalg.quiet_floats
    def update_all(self, measurements: Sequence[LinearizedMeasurement], *, method: str = "batch") -> UpdateResult:
        """Update all blocks by several measurements in one batch; Jacobians and innovations at the present means.

        method: "batch" (one factorization), or "scalar": whitened by R and then one number after another, the
        innovation updated along with the state. Both give the same result but for rounding; "scalar"
        needs R > 0, "batch" takes a semi-definite R (a number without noise) as long as H P H' + R is positive
        definite. One landmark after another is a loop over `update`, with Jacobians and innovations anew at the current
        means.

        The covariance stays that of the tangent space before the update. Re-centring it would multiply a rotation's
        rows by G = I - [dtheta/2]x (Sola 2017, section 6.3), a change of P of at most the update's angle, relative to
        P: of the same order as taking H at the updated mean, which this first-order filter leaves out too. Where an
        update turns far, apply it: belief.predict(block, block.mean, G, np.zeros_like(G)).

        Rounding in P - W'W is 1e-16 of the variance *before*. Where a prior is so much larger than R that of the
        posterior less than two digits would remain (1e14), the update is refused. Raises ShapeError, NonFiniteError,
        CovarianceError; then nothing is changed.
        """
        return self.update_stacked(StackedMeasurements.of(list(measurements), "update", self._own), method=method)

    @linalg.quiet_floats
    def update_stacked(self, stacked: StackedMeasurements, *, method: str = "batch") -> UpdateResult:
        """As `update_all`, for measurements stacked already: numbers that models gave, and noises checked before."""
        HP = stacked.H @ self._P.take(stacked.touched, axis=0)
        S = stacked.innovation_covariance(HP)
        step, rows, nis = stacked.solve(method, HP, S)
        stacked.check_digits(self._P, S, rows)
        flat, points = self._layout.retract(step, self.retraction)
        finite(flat, flat.shape, "update", "the updated means")
        for block, mean in zip(self._layout.points, points, strict=True):
            finite(mean, (block.manifold.size,), "update", f"the updated mean of {block!r}")
        self._layout.assign(flat, points)
        linalg.subtract_square(self._P, rows, self.transport and self.transport())
        return UpdateResult(stacked.z, S, nis)

    @linalg.quiet_floats
    def update_rows(self, columns: Indices, H: Array, innovation: Array, R: Array) -> UpdateResult:
        """As `update`, for a Jacobian H (m, k) w.r.t. the rows `columns` (k,) of the covariance: no block is looked up.

        The rows are those of `block.slice`; none may appear twice.
        """
        z = numbers(innovation, "update_rows", "innovation")
        columns = self._rows(columns)
        m, k = z.size, len(columns)
        z, H = finite(z, (m,), "update_rows", "innovation"), finite(H, (m, k), "update_rows", "H")
        R = linalg.covariance(R, m, "update_rows", "R")
        return self.update_stacked(StackedMeasurements(z, H, R, columns))

    @contextmanager
    def sequential_update(self) -> Iterator[SequentialUpdate]:
        """Updates one after another, each at the means that the one before left.

        with belief.sequential_update() as sequence: sequence.update(...), any number of times. Means follow
        immediately, the covariance at the end, also where an error ends it. Until then nothing else may be done with
        the belief.
        """
        sequence = SequentialUpdate(self._P, self._layout, self.retraction, self.transport)
        try:
            with np.errstate(over="ignore", invalid="ignore"):  # one for all of them
                yield sequence
        finally:
            sequence.finish()

    def _rows(self, columns: Indices) -> Indices:
        """The rows (k,) of the covariance that a measurement depends on, checked. Raises ShapeError, SlamlibError."""
        rows = np.asarray(columns)
        if rows.ndim != 1 or rows.dtype.kind not in "iu":
            raise ShapeError(f"update_rows: columns are whole numbers (k,), got {rows.dtype} of shape {rows.shape}")
        if len(rows) and not (rows.min() >= 0 and rows.max() < self.size):
            raise SlamlibError(f"update_rows: columns are from 0 to {self.size - 1}, got {rows.min()} to {rows.max()}")
        if (np.bincount(rows, minlength=1) > 1).any():
            raise SlamlibError(f"update_rows: row {int(np.bincount(rows).argmax())} appears twice among the columns")
        return rows

    def _own(self, blocks: Sequence[Block]) -> None:
        if isinstance(blocks, Block):
            raise SlamlibError(f"give a list of blocks and a list of as many Jacobians: [{blocks!r}], [H]")
        for block in blocks:
            if not isinstance(block, Block) or block not in self._blocks:
                raise SlamlibError(f"{block!r} is no block of this belief (was it removed?)")

    def _set(self, blocks: Sequence[Block], P: Array, points: Iterable[tuple[Manifold, Array]] = ()) -> None:
        """Set blocks, in this order, and their covariance; points: their new means, where these change too."""
        for block, point in zip(blocks, points, strict=False):
            block.set_mean(*point)
        self._blocks, self._P = dict.fromkeys(blocks), P
        start = 0
        for block in blocks:
            block.start = start
            start += block.dof
        self._layout = StateLayout(self._blocks)

    def _append(self, block: Block, P: Array) -> None:
        """Set one more block, the last one, and the covariance with its rows."""
        self._blocks[block], self._P = None, P
        self._layout.append(block)
