"""The measurement update: from innovations and Jacobians to the step and the rows W of P - W'W; batch or sequential.

A sequential update takes each measurement at the means that the one before left, but multiplies the covariance once.
After some of them the covariance is P - W'W, where W holds the rows of each of them (chapter kalman_filter). The next
one needs a few rows of that, computed quickly from P and W; the whole of it is needed only at the end, and one
product of many rows costs far less than many products of two rows.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from slamlib.errors import CovarianceError, NonFiniteError, ShapeError, SlamlibError, entry
from slamlib.kalman import linalg
from slamlib.kalman.state import Block, Retraction, StateLayout
from slamlib.manifolds import Array, Indices, all_finite, finite, numbers, ranges, whole_rows


@dataclass(frozen=True)
class LinearizedMeasurement:
    """A linearized measurement: Jacobians (m, dof) w.r.t. each block it depends on, innovation (m,), noise (m, m)."""

    blocks: Sequence[Block]
    jacobians: Sequence[ArrayLike]
    innovation: Array
    noise: Array

    def unmasked(self) -> "LinearizedMeasurement | None":
        """Itself without the masked numbers of its innovation, their Jacobians and noises; None if all are masked."""
        keep = whole_rows(self.innovation) if np.ndim(self.innovation) == 1 else None
        if keep is None:
            return self
        if not keep.any():
            return None
        noise = np.ma.getdata(self.noise)
        noise = noise[np.ix_(keep, keep)] if noise.ndim == 2 else noise[keep] if noise.ndim == 1 else noise
        jacobians = [np.asarray(J)[keep] for J in self.jacobians]
        return LinearizedMeasurement(self.blocks, jacobians, np.ma.getdata(self.innovation)[keep], noise)

    def checked_innovation(self, function: str, what: str) -> Array:
        """Return the innovation, checked to be one or more finite numbers; errors call it `what`."""
        z = numbers(self.innovation, function, what)
        if z.ndim != 1 or not z.size:
            raise ShapeError(f"{function}: {what} should have shape (m,), m at least 1, but has shape {z.shape}")
        return finite(z, z.shape, function, what)

    def checked_jacobians(self, rows: int, function: str, name: str = "") -> list[Array]:
        """Return the Jacobians, one a block, each checked to be (rows, dof of its block) and finite."""
        blocks, jacobians = self.blocks, self.jacobians
        if not len(blocks) or len(blocks) != len(jacobians):
            counts = f"{len(blocks)} blocks but {len(jacobians)} Jacobians{name}"
            raise SlamlibError(f"{function}: {counts}; give one Jacobian for each block")
        pairs = enumerate(zip(blocks, jacobians, strict=True))
        return [finite(J, (rows, b.dof), function, f"Jacobian {i}{name}") for i, (b, J) in pairs]


@dataclass(frozen=True)
class UpdateResult:
    """Result of an update: the innovation z, its covariance S, and nis = z' S^-1 z."""

    innovation: Array
    covariance: Array
    nis: float


@dataclass(frozen=True)
class Proposal(UpdateResult):
    """An update that may still be refused: the whitened innovation (d,), and the rows W (d, n) of P - W'W."""

    white: Array
    rows: Array


@dataclass(frozen=True)
class StackedMeasurements:
    """Several measurements as one: z (m,), R (m, m), and H (m, k) w.r.t. the k touched degrees of freedom alone.

    given: the measurements it was stacked from, where they are known.
    """

    z: Array
    H: Array
    R: Array
    touched: Indices
    given: Sequence[LinearizedMeasurement] = ()

    @classmethod
    def of(
        cls, measurements: Sequence[LinearizedMeasurement], function: str, own: Callable[..., None]
    ) -> "StackedMeasurements":
        """Stack all innovations in one vector, all Jacobians in one matrix, all noises in one block-diagonal matrix.

        own: raises where a block is not one of the belief.
        """
        given = [measurement.unmasked() for measurement in measurements]
        measurements = [kept for kept in given if kept is not None]
        if not measurements:
            none = "all that is given is masked" if given else "no measurement given"
            raise SlamlibError(f"{function}: {none}; leave the call out when nothing was seen")
        noises: dict[tuple[int, int], Array] = {}  # landmarks mostly share one R, which is checked once
        innovations, jacobians = [], []
        for i, measurement in enumerate(measurements):
            own(measurement.blocks)
            name = f" of measurement {i}" if len(measurements) > 1 else ""
            z = measurement.checked_innovation(function, f"innovation{name}")
            key = (id(measurement.noise), len(z))
            if key not in noises:
                noises[key] = linalg.covariance(measurement.noise, len(z), function, f"R{name}")
            innovations.append(z)
            jacobians.append(measurement.checked_jacobians(len(z), function, name))
        blocks = list(dict.fromkeys(block for measurement in measurements for block in measurement.blocks))
        columns = dict(zip(blocks, ranges(block.dof for block in blocks), strict=True))  # of the stacked Jacobian
        touched = np.concatenate([np.arange(block.start, block.start + block.dof) for block in blocks])
        z = np.concatenate(innovations)
        H, R = np.zeros((len(z), len(touched))), np.zeros((len(z), len(z)))
        for measurement, each, rows in zip(measurements, jacobians, ranges(map(len, innovations)), strict=True):
            R[rows, rows] = noises[id(measurement.noise), rows.stop - rows.start]
            for block, J in zip(measurement.blocks, each, strict=True):
                H[rows, columns[block]] += J
        return cls(z, H, R, touched, measurements)

    def innovation_covariance(self, HP: Array) -> Array:
        """S = H P H' + R, exactly symmetric, from H P over all columns."""
        half = HP.take(self.touched, axis=1) @ self.H.T / 2
        return half + half.T + self.R

    def solve(self, method: str, HP: Array, S: Array) -> tuple[Array, Array, float]:
        """Step, rows W and nis by the method of this name: "batch" or "scalar"."""
        function = entry("method", method, _METHODS)
        linalg.check_overflow("update", S)
        try:
            return function(self, HP, S)
        except CovarianceError as error:
            which = self._certain(self.R if method == "scalar" else S)
            raise CovarianceError(
                f"{error}: {which} is claimed to be known exactly; nothing was changed. Give R > 0."
            ) from None

    def check_digits(self, P: Array, S: Array, W: Array) -> None:
        """Raise CovarianceError where P - W'W, P (n, n), keeps too few digits; see `check_digits`."""
        if weak_prior(S, self.R):
            touched = self.touched
            check_digits(P[np.ix_(touched, touched)], self.H, S, self.R, W[:, touched])

    def _certain(self, S: Array) -> str:
        """Describe the number that prediction and measurement both claim to know exactly."""
        if not self.given:
            return "a measurement"
        row = int(np.argmax(np.abs(np.linalg.eigh(S)[1][:, 0])))
        stops = np.cumsum([len(measurement.innovation) for measurement in self.given])
        i = int(np.searchsorted(stops, row, side="right"))
        number = row - int(stops[i]) + len(self.given[i].innovation)
        return f"number {number} of measurement {i} (of {', '.join(map(repr, self.given[i].blocks))})"


def _batch(stacked: StackedMeasurements, HP: Array, S: Array) -> tuple[Array, Array, float]:
    """Step, rows W with P - W'W the updated covariance, and nis; from one Cholesky factor of S."""
    factor = linalg.cholesky(S, "update", "the innovation covariance")
    W = linalg.solve_lower(factor, HP)
    white = linalg.solve_lower(factor, stacked.z)
    return white @ W, W, float(white @ white)


def _scalar(stacked: StackedMeasurements, HP: Array, S: Array) -> tuple[Array, Array, float]:
    """The same, one number after another, after whitening by the factor of R."""
    touched, factor = stacked.touched, linalg.cholesky(stacked.R, "update", "R (which method='scalar' whitens by)")
    H, HP, z = (linalg.solve_lower(factor, a) for a in (stacked.H, HP, stacked.z))
    step, rows, nis = np.zeros(HP.shape[1]), np.zeros_like(HP), 0.0
    for j, h in enumerate(H):
        running = HP[j] - (h @ rows[:j, touched].T) @ rows[:j]  # h P, with the covariance at this point
        variance = running[touched] @ h + 1.0
        left = z[j] - h @ step[touched]  # the innovation at this point
        rows[j] = running / np.sqrt(variance)
        step += running * (left / variance)
        nis += left * left / variance
    return step, rows, float(nis)


_WEAK, _LOST = 1e12, 0.01  # of the noise: a prior's variance, from which on digits are counted; an error of the result


def weak_prior(S: Array, R: Array) -> bool:
    """Whether the prior variance of a measured number is so large beside its noise that P - W'W may lose its digits."""
    noise = R.diagonal()
    return bool((S.diagonal() > _WEAK * noise)[noise > 0].any())


def check_digits(P: Array, H: Array, S: Array, R: Array, W: Array) -> None:
    """Raise CovarianceError where rounding has changed the updated H P H' by more than a hundredth of R.

    It is R - R S^-1 R, chapter kalman_filter, eq. (kf-left). P (k, k): before the update, H (m, k), W (m, k). What
    is measured without noise is known exactly, up to rounding, and not judged.
    """
    found = H @ (P - W.T @ W) @ H.T
    half = linalg.solve_lower(linalg.cholesky(S, "update", "the innovation covariance"), R)
    off = np.abs(found - (R - half.T @ half)).diagonal()
    noise = R.diagonal()
    lost = off > np.where(noise > 0, _LOST * noise, np.inf)
    if lost.any():
        i = int(np.argmax(lost))
        raise CovarianceError(
            f"update: the predicted variance of number {i} of the measurement is {S[i, i] / noise[i]:.1e} times "
            "its noise, and of the 16 digits of a double fewer than two are left for the result. Start with a "
            f"covariance of at most {_WEAK:.0e} R, or from the first measurement itself; what holds exactly has R = 0. "
            "Nothing was changed."
        )


_METHODS: dict[str, Callable[..., tuple[Array, Array, float]]] = {"batch": _batch, "scalar": _scalar}


_ROWS = 32  # initial capacity for rows of W


class SequentialUpdate:
    """Updates in progress; made by Belief.sequential_update."""

    def __init__(
        self,
        covariance: Array,
        layout: StateLayout,
        retraction: Retraction | None = None,
        transport: Callable[[], linalg.Carry | None] | None = None,
    ) -> None:
        """covariance (n, n): updated in place by `finish`."""
        self._P, self._layout, self._retraction, self._transport = covariance, layout, retraction, transport
        self._store, self._count = np.empty((_ROWS, len(covariance))), 0  # W is its first rows
        self._noises: dict[int, Array] = {}  # those that were checked: most measurements share one

    def propose(self, columns: Indices, H: Array, innovation: Array, R: Array) -> Proposal:
        """What a measurement would do at the present means; nothing is changed until it is applied.

        columns (k,), H (d, k), innovation (d,), R (d, d). Raises CovarianceError, and SlamlibError where it is masked.
        """
        if isinstance(innovation, np.ma.MaskedArray):
            innovation = numbers(innovation, "update", "innovation")
        if self._noises.get(id(R)) is not R:
            linalg.covariance(R, len(innovation), "update", "R")
            self._noises[id(R)] = R
        taken = self._store[: self._count]
        HP = H @ self._P.take(columns, axis=0)
        if self._count:
            HP -= (H @ taken.take(columns, axis=1).T) @ taken
        half = HP.take(columns, axis=1) @ H.T / 2
        S = half + half.T + R
        factor = linalg.cholesky(S, "update", "the innovation covariance")
        white = linalg.solve_lower(factor, np.concatenate([HP, innovation[:, None]], axis=1))
        W, z = white[:, :-1], white[:, -1]
        if weak_prior(S, R):
            P = self._P[np.ix_(columns, columns)] - taken[:, columns].T @ taken[:, columns]
            check_digits(P, H, S, R, W[:, columns])
        return Proposal(innovation, S, float(z @ z), z, W)

    def apply(self, proposed: Proposal) -> None:
        """Update by the last measurement proposed. Raises NonFiniteError."""
        step = proposed.white @ proposed.rows
        if not all_finite(step):
            raise NonFiniteError("update: the step overflows; choose units in which the numbers are smaller")
        self._layout.assign(*self._layout.retract(step, self._retraction))
        self._keep(proposed.rows)

    def update(self, columns: Indices, H: Array, innovation: Array, R: Array, gate: float = np.inf) -> UpdateResult:
        """As Belief.update_rows, at the present means; changes nothing unless its nis is below the gate."""
        proposed = self.propose(columns, H, innovation, R)
        if proposed.nis < gate:
            self.apply(proposed)
        return proposed

    def _keep(self, rows: Array) -> None:
        """Append rows to W, in a store that doubles when it is full."""
        end = self._count + len(rows)
        while end > len(self._store):
            self._store = np.concatenate([self._store, np.empty_like(self._store)])
        self._store[self._count : end], self._count = rows, end

    def finish(self) -> None:
        """Set the covariance to that of the present means, which stay as they are."""
        if self._count:
            linalg.subtract_square(self._P, self._store[: self._count], self._transport and self._transport())
            self._count = 0
