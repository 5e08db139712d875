"""An estimated trajectory against its reference: alignment, and the absolute errors after it (ATE)."""

from dataclasses import dataclass

import numpy as np

from slamlib.errors import ShapeError, SlamlibError
from slamlib.evaluation.trajectory import Trajectory, angles
from slamlib.geometry.quaternion import best_pivot, from_rotation, product, rotation
from slamlib.manifolds import Array, finite

STRAIGHT_PATH = 0.05  # a path narrower than this share of its length hardly determines the rotation about itself


@dataclass(frozen=True, eq=False)
class Similarity:
    """x -> scale R x + translation: rotation R (3, 3), translation (3,) [m]."""

    scale: float
    rotation: Array
    translation: Array

    def __call__(self, points: Array) -> Array:
        """Transform points (..., 3)."""
        return self.scale * points @ self.rotation.T + self.translation

    def moved(self, trajectory: Trajectory) -> Trajectory:
        """Transform a trajectory: orientations turn, positions are also scaled, both with their covariances."""
        turn = from_rotation(self.rotation, best_pivot(self.rotation))
        turned = product(turn, trajectory.poses[:, 3:])
        J = np.eye(6)
        J[:3, :3] = self.scale * self.rotation
        return trajectory.moved(np.concatenate([self(trajectory.positions), turned], axis=1), J)


def align(points: Array, reference: Array, *, scale: bool = True, turn: Array | None = None) -> Similarity:
    """The similarity (scale=False: the rigid motion) that best aligns points (n, 3) with their references (n, 3).

    It minimizes sum |y_i - (s R x_i + t)|^2 in closed form (Horn, 1987; here by singular values as in Umeyama, 1991,
    eqs. 34 to 43). For any s and R the best t takes centroid to centroid, which leaves centred x_i, y_i, and
    sum |y_i|^2 - 2 s tr(R' M) + s^2 sum |x_i|^2, with M = sum y_i x_i'. So R is the rotation with the largest tr(R' M).
    Of M = U D V' this is the sum of D_k times the diagonal of the orthogonal matrix V' R' U, whose entries are at most
    one: R = U S V', where S = diag(1, 1, det U det V) keeps R from being a reflection. And s = tr(R' M) / sum |x_i|^2.

    turn (3, 3): the rotation, where it is known. The scale is then 0 where the points move against their references: no
    similarity makes them fit better than a single point would.

    Raises SlamlibError where the points do not determine it: fewer than three, or collinear, so that every rotation
    about their line fits equally well; there use `align_trajectory`, which takes the rotation from the orientations.
    """
    x = finite(points, (None, 3), "align", "points")
    y = finite(reference, x.shape, "align", "reference")
    mean_x, mean_y = x.mean(0), y.mean(0)
    x, y = x - mean_x, y - mean_y
    if turn is None:
        M = y.T @ x
        size = np.linalg.svd(M, compute_uv=False)
        if size[1] <= 1e-10 * size[0] or not size[0] > 0:
            raise SlamlibError(
                "align: the points lie on one line (or in one place): any turn around it fits as well as any other, "
                "and the orientations have to say which: align_trajectory(..., rotation_from='orientations')"
            )
        turn = _nearest_rotation(M)
    spread = (x * x).sum()
    if scale and not spread > 0:
        raise SlamlibError("align: the estimate does not move, so that it has no scale: align with scale=False")
    s = max(float((y * (x @ turn.T)).sum() / spread), 0.0) if scale else 1.0
    return Similarity(s, turn, mean_y - s * turn @ mean_x)


def _nearest_rotation(M: Array) -> Array:
    """The rotation R with the largest tr(R' M)."""
    U, _, Vt = np.linalg.svd(M)
    sign = np.linalg.det(U) * np.linalg.det(Vt)
    return U @ np.diag([1.0, 1.0, sign]) @ Vt


def straightness(points: Array) -> float:
    """Width of points (n, 3) across their main direction relative to their length: second by first singular value."""
    size = np.linalg.svd(points - points.mean(0), compute_uv=False)
    return float(size[1] / size[0]) if size[0] > 0 else 0.0


@dataclass(frozen=True, eq=False)
class AlignedTrajectory:
    """An estimate aligned with its reference, pair by pair, and the remaining errors.

    position (n,): distances in the reference's unit; orientation (n,) [rad]; path: the reference's length;
    rotation_from: the source of the rotation; straightness: of the reference.
    """

    similarity: Similarity
    estimate: Trajectory
    position: Array
    orientation: Array
    path: float
    rotation_from: str
    straightness: float

    @property
    def ate(self) -> float:
        """Absolute trajectory error: root mean square of the distances (Sturm and others, 2012)."""
        return float(np.sqrt((self.position**2).mean()))

    @property
    def relative_ate(self) -> float:
        """ATE relative to the length of the path (0.01 is 1 %)."""
        return self.ate / self.path if self.path > 0 else np.nan


def align_trajectory(
    estimate: Trajectory, reference: Trajectory, *, scale: bool = True, rotation_from: str | None = None
) -> AlignedTrajectory:
    """Align an estimate with its reference (pairs, row by row) and compute the remaining errors.

    rotation_from: whether the "positions" or the "orientations" determine the rotation; None: the positions, but for a
    nearly straight path (STRAIGHT_PATH) the orientations, since positions hardly determine the rotation about it; both
    trajectories must then be of the same body frame (two of one camera, say). Raises SlamlibError.
    """
    if rotation_from not in (None, "positions", "orientations"):
        raise SlamlibError(f"align_trajectory: rotation_from is positions, orientations or None, got {rotation_from!r}")
    check_pairs(estimate, reference)
    narrow = straightness(reference.positions)
    chosen = rotation_from or ("positions" if narrow > STRAIGHT_PATH else "orientations")
    turn = None
    if chosen == "orientations":  # as in `align`, with M = sum Q_i P_i': sum |Q_i - R P_i|^2 is least
        Q, P = rotation(reference.poses[:, 3:]), rotation(estimate.poses[:, 3:])
        turn = _nearest_rotation((Q @ P.swapaxes(-1, -2)).sum(0))
    similarity = align(estimate.positions, reference.positions, scale=scale, turn=turn)
    moved = similarity.moved(estimate)
    distance = np.linalg.norm(moved.positions - reference.positions, axis=1)
    error = product(reference.poses[:, 3:] * [1, -1, -1, -1], moved.poses[:, 3:])
    return AlignedTrajectory(similarity, moved, distance, angles(error), float(reference.distances[-1]), chosen, narrow)


def check_pairs(estimate: Trajectory, reference: Trajectory) -> None:
    """Raise ShapeError unless the trajectories have as many poses."""
    if len(estimate) != len(reference):
        raise ShapeError(f"{len(estimate)} poses against {len(reference)}: pick pairs with associate first")
