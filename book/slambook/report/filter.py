"""The filter of the report's chapter 5: prediction, update component by component, new landmarks, deletion.

`BatchUpdateFilter` is the same filter without the errors, with one update by all measurements of a picture: the same
result in less time.
"""

from dataclasses import dataclass, field

import numpy as np

from slambook.report.angles import rotation, wrapped
from slambook.report.motion import by_angles
from slambook.report.observation import batch, by_pose, by_vectors, placed, placed_by_pose
from slambook.report.switches import Equations, equations
from slamlib.manifolds import Array


@dataclass
class Memory:
    """State and covariance of runs side by side: x (runs, 6 + 3L), P (runs, 6 + 3L, 6 + 3L); landmark numbers."""

    x: Array
    P: Array
    names: list[int] = field(default_factory=list)
    use: Equations = field(default_factory=equations)
    step: int = 0

    def __post_init__(self) -> None:
        self._old = self.x[..., :6].copy()

    def predict(self, answer: Array, U: Array) -> None:
        """(5.8) to (5.23): by PnP's answer (runs, 6), with the control's covariance U (..., 6, 6)."""
        use, old, u = self.use, self.x[..., :6].copy(), self.use.control(answer)
        before = rotation(old[..., 3:])
        new = np.concatenate([
            old[..., :3] + (before @ u[..., :3, None])[..., 0],
            use.turn(old[..., 3:], u[..., 3:], use.extract),
        ], -1)  # fmt: skip
        at = use.motion_at(old, new)
        F, G = np.zeros((*u.shape, 6)), np.zeros((*u.shape, 6))
        F[..., :3, :3], F[..., :3, 3:], F[..., 3:, 3:] = np.eye(3), by_angles(at[..., 3:], u[..., :3]), use.rows(at, u)
        G[..., :3, :3], G[..., 3:, 3:] = rotation(at[..., 3:]), use.noise_rows(at, u)  # (5.21)
        Q = use.noise_place(G @ U @ G.swapaxes(-1, -2), self.x.shape[-1])  # (5.22)
        rows = F @ self.P[..., :6, :]
        self.P[..., :6, :], self.P[..., :, :6] = rows, rows.swapaxes(-1, -2)
        self.P[..., :6, :6] = use.pose_block(rows[..., :6] @ F.swapaxes(-1, -2), Q)  # (5.23)
        self._old, self.x[..., :6] = old, new

    def update(self, seen: Array, names: list[int], R: Array) -> None:
        """(5.24) to (5.32): points (runs, m, 3) relative to the robot, their landmarks, and R (..., m, 3, 3)."""
        use, x0, P0 = self.use, self.x.copy(), self.P.copy()
        places = [self.names.index(name) for name in names]
        points = self.points[..., places, :]
        at = use.observation_at(self._old, x0[..., :6])
        difference = seen - use.relative(x0[..., :6], points)  # (3.10)
        Hx, Hm = by_pose(at, points), np.broadcast_to(self._by_point(at), (*seen.shape, 3))
        noise, Hx, Hm, column = use.white(np.broadcast_to(R, (*seen.shape, 3)), Hx, Hm, difference[..., None])
        difference = column[..., 0]
        for i, place in enumerate(places):
            start = 6 + 3 * use.columns(i, place)
            touched = [*range(6), *range(start, start + 3)]
            for j in range(3):  # "for each dimension of each observed landmark"
                h = Hx[..., i, j, :], Hm[..., i, j, :]
                self.one_number(x0, P0, touched, *h, difference[..., i, j], noise[..., i, j])
        self.x[..., 3:6] = wrapped(self.x[..., 3:6])

    def _by_point(self, at: Array) -> Array:
        return rotation(at[..., 3:]).swapaxes(-1, -2)[..., None, :, :]

    def one_number(
        self, x0: Array, P0: Array, at: list[int], hx: Array, hm: Array, difference: Array, R: Array
    ) -> None:
        """(5.27), (5.30) to (5.32) for one component, from x0 and P0, predicted; at: its nine columns."""
        P, m = self.use.prior(self.P, P0), slice(at[6], at[6] + 3)
        S = self.use.variance(hx, hm, P[..., :6, :6], P[..., m, :6], P[..., m, m]) + R  # (5.27)
        h = np.concatenate([hx, hm], -1)
        K = (P[..., :6] @ hx[..., None] + P[..., m] @ hm[..., None])[..., 0] / S[..., None]  # (5.30)
        innovation = self.use.innovation(difference, h, self.x[..., at] - x0[..., at])
        self.x += K * innovation[..., None]  # (5.31)
        self.P -= (S[..., None] * K)[..., :, None] * K[..., None, :]  # (5.32)

    def initialize(self, seen: Array, names: list[int], R: Array, first: bool = False) -> None:
        """(5.33) to (5.35): new landmarks from points (runs, m, 3) relative to the robot; first: at k = 0."""
        pose, m, n = self.x[..., :6], len(names), self.x.shape[-1]
        J, Jz = placed_by_pose(pose, seen).reshape(*seen.shape[:-2], 3 * m, 6), rotation(pose[..., 3:])[..., None, :, :]
        own = Jz @ np.broadcast_to(R, (*seen.shape, 3)) @ Jz.swapaxes(-1, -2)  # the last term of (5.35)
        if first:
            own = self.use.start(own)
        rows = self.use.new_row(J, self.P)
        P = np.zeros((*self.P.shape[:-2], n + 3 * m, n + 3 * m))
        P[..., :n, :n], P[..., n:, :n], P[..., :n, n:] = self.P, rows, rows.swapaxes(-1, -2)
        P[..., n:, n:] = self.use.new_corner(J @ self.P[..., :6, :6] @ J.swapaxes(-1, -2))  # (5.35)
        for i in range(m):
            at = slice(n + 3 * i, n + 3 * i + 3)
            P[..., at, at] += own[..., i, :, :]
        self.x = np.concatenate([self.x, placed(pose, seen).reshape(*seen.shape[:-2], 3 * m)], -1)
        self.P, self.names = P, [*self.names, *names]

    def prune(self) -> None:
        """Section 5.4: what is left of map and covariance before the next picture."""
        self.x, self.P, self.names = self.use.memory(self.x, self.P, self.names)

    @property
    def points(self) -> Array:
        """The landmarks (runs, L, 3)."""
        return self.x[..., 6:].reshape(*self.x.shape[:-1], -1, 3)


# What of the equations an update uses: with an error there, only a Memory has it.
OF_THE_UPDATE = frozenset({"relative", "observation_at", "variance", "columns", "white", "innovation", "prior"})


@dataclass
class BatchUpdateFilter(Memory):
    """A Memory whose `update` is (3.10) to (3.14): equal to component by component but for rounding (E25).

    Its update has the corrected equations, whatever else is turned on. Many runs side by side are ten times as
    fast with it, because the covariance is touched once a picture.
    """

    def update(self, seen: Array, names: list[int], R: Array) -> None:
        """As Memory.update."""
        if not names:
            return
        places, m = [self.names.index(name) for name in names], len(names)
        points = self.points[..., places, :]
        difference = (seen - by_vectors(self.x[..., :6], points)).reshape(*seen.shape[:-2], 3 * m)
        H, noise = np.zeros((*self.x.shape[:-1], 3 * m, self.x.shape[-1])), np.zeros((*seen.shape[:-2], 3 * m, 3 * m))
        H[..., :6] = by_pose(self.x[..., :6], points).reshape(*self.x.shape[:-1], 3 * m, 6)  # (3.15), dense
        turned = rotation(self.x[..., 3:6]).swapaxes(-1, -2)
        for i, place in enumerate(places):
            at, columns = slice(3 * i, 3 * i + 3), slice(6 + 3 * place, 9 + 3 * place)
            H[..., at, columns] = turned
            noise[..., at, at] = np.broadcast_to(R, (*seen.shape, 3))[..., i, :, :]
        self.x, self.P = batch(self.x, self.P, difference, H, noise)
        self.P = (self.P + self.P.swapaxes(-1, -2)) / 2
        self.x[..., 3:6] = wrapped(self.x[..., 3:6])
