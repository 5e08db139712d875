"""An estimated trajectory against its reference: alignment, and the absolute errors after it (ATE)."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from slamlib.errors import ShapeError, SlamlibError, entry
from slamlib.evaluation.trajectory import Trajectory, angles
from slamlib.geometry.quaternion import best_pivot, exponential, from_rotation, product, rotation
from slamlib.manifolds import Array, finite

STRAIGHT_PATH = 0.05  # a path narrower than this share of its length may leave the rotation about itself open
FITS_ACROSS = 0.2  # share of a straight path's width; positions that fit better across it do determine that rotation
ONE_FRAME = np.radians(10)  # largest angle between a line by positions and by orientations that are of one frame
ROUNDING = 1e-10


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
        if size[1] <= ROUNDING * size[0] or not size[0] > 0:
            raise SlamlibError(
                "align: the points lie on one line (or in one place): any turn around it fits as well as any other, "
                "and the orientations have to say which: see align_trajectory"
            )
        turn = nearest_rotation(M)
    if scale:
        for who, places in (("estimate", points), ("reference", reference)):
            if not moves(places):
                raise SlamlibError(
                    f"the {who} does not move, so that it has no scale: compare it without aligning scale"
                )
    s = max(float((y * (x @ turn.T)).sum() / (x * x).sum()), 0.0) if scale else 1.0
    return Similarity(s, turn, mean_y - s * turn @ mean_x)


def moves(points: Array) -> bool:
    """Whether points (n, 3) are more than one, beyond the digits in which they are known."""
    return bool(np.ptp(points, axis=0).max() > ROUNDING * np.abs(points).max())


def nearest_rotation(M: Array) -> Array:
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
    estimate: Trajectory,
    reference: Trajectory,
    *,
    scale: bool = True,
    rotation_from: str | None = None,
    align: str = "all",
    first: int | None = None,
) -> AlignedTrajectory:
    """Align an estimate with its reference (pairs, row by row) and compute the remaining errors.

    align: "all" poses by the motion that fits best; "origin", the first pose with the first; "scale" alone; "none", the
    estimate stays as it is. scale: also the scale, of all but the last. first: only so many poses are aligned with
    theirs; the errors are of all.

    rotation_from: whether the "positions" or the "orientations" determine the rotation of the best motion, or None.
    Then the positions do, as far as they can, and the orientations what is left. For tr(R' M) of `align` is largest at
    R = U S V', and falls by (D_i + D_j) (1 - cos a) if that is turned further by an angle a about the axis u_k, the
    other columns of U being u_i and u_j. D_1 is in two of the three sums: a straight path still fixes two of the
    angles, and only the turn about itself, u_1, hangs on D_2 + D_3, on what there is of the path across its line. Where
    the path is narrow (STRAIGHT_PATH) and the estimate fits no better across the line than FITS_ACROSS of its width,
    that turn is taken from the orientations: of all R = exp([a u_1]) U S V' the one with the largest tr(R' N), where
    N = sum Q_i P_i'. With K = N (U S V')' that is c cos a + s sin a and a constant, c = tr K - u_1' K u_1 and
    s = u_1 . (K_32 - K_23, K_13 - K_31, K_21 - K_12); so a = atan2(s, c). This needs one body frame: where the
    orientations put the line elsewhere (by more than ONE_FRAME), it is done only if the line is exactly straight, and
    any turn fits its positions. In one place positions determine nothing, and orientations all: the rotation makes
    sum |Q_i - R P_i|^2 least.

    Raises SlamlibError.
    """
    if rotation_from not in (None, "positions", "orientations"):
        raise SlamlibError(f"align_trajectory: rotation_from is positions, orientations or None, got {rotation_from!r}")
    check_pairs(estimate, reference)
    rows = slice(None, first)
    found = entry("alignment", align, ALIGNMENTS)(estimate[rows], reference[rows], scale, rotation_from)
    similarity, source = found
    moved = similarity.moved(estimate)
    distance = np.linalg.norm(moved.positions - reference.positions, axis=1)
    error = product(reference.poses[:, 3:] * [1, -1, -1, -1], moved.poses[:, 3:])
    narrow = straightness(reference.positions)
    return AlignedTrajectory(similarity, moved, distance, angles(error), float(reference.distances[-1]), source, narrow)


def _best(estimate: Trajectory, reference: Trajectory, scale: bool, source: str | None) -> tuple[Similarity, str]:
    """The best motion, and what its rotation is from; see `align_trajectory`."""
    x, y = estimate.positions, reference.positions
    if source == "positions":
        return align(x, y, scale=scale), source
    Q, P = rotation(reference.poses[:, 3:]), rotation(estimate.poses[:, 3:])
    N = (Q @ P.swapaxes(-1, -2)).sum(0)
    if source == "orientations" or not (moves(x) and moves(y)):
        return align(x, y, scale=scale, turn=nearest_rotation(N)), "orientations"
    M = (y - y.mean(0)).T @ (x - x.mean(0))
    U, size, _ = np.linalg.svd(M)
    R, line = nearest_rotation(M), U[:, 0]
    found = align(x, y, scale=scale, turn=R)
    if straightness(y) > STRAIGHT_PATH or _fits_across(found(x) - y, y - y.mean(0), line):
        return found, "positions"
    of_one_frame = np.arccos(np.clip(line @ nearest_rotation(N) @ R.T @ line, -1, 1)) < ONE_FRAME
    if not of_one_frame and size[1] > ROUNDING * size[0]:
        return found, "positions"
    K = N @ R.T
    axial = np.array([K[2, 1] - K[1, 2], K[0, 2] - K[2, 0], K[1, 0] - K[0, 1]])
    turn = exponential(np.arctan2(line @ axial, np.trace(K) - line @ K @ line) * line)
    return align(x, y, scale=scale, turn=rotation(turn) @ R), "positions and orientations"


def _fits_across(error: Array, y: Array, line: Array) -> bool:
    """Whether errors (n, 3) across a line are small beside what points y (n, 3), centred, are across it."""
    across = np.eye(3) - np.outer(line, line)
    return bool(np.linalg.norm(error @ across) < FITS_ACROSS * np.linalg.norm(y @ across))


def _origin(estimate: Trajectory, reference: Trajectory, scale: bool, source: str | None) -> tuple[Similarity, str]:
    """The motion that takes the first pose to the first, of the estimate in the scale of the best motion."""
    s = _best(estimate, reference, True, source)[0].scale if scale else 1.0
    Q, P = rotation(reference.poses[0, 3:]), rotation(estimate.poses[0, 3:])
    turn = Q @ P.T
    return Similarity(s, turn, reference.positions[0] - s * turn @ estimate.positions[0]), "first pose"


def _scale(estimate: Trajectory, reference: Trajectory, scale: bool, source: str | None) -> tuple[Similarity, str]:
    """The scale of the best motion, about the estimate's zero."""
    return Similarity(_best(estimate, reference, True, source)[0].scale, np.eye(3), np.zeros(3)), "none"


def _none(estimate: Trajectory, reference: Trajectory, scale: bool, source: str | None) -> tuple[Similarity, str]:
    if scale:
        raise SlamlibError("align none leaves the estimate as it is: to align its scale alone, choose align scale")
    return Similarity(1.0, np.eye(3), np.zeros(3)), "none"


Alignment = Callable[[Trajectory, Trajectory, bool, str | None], tuple[Similarity, str]]
ALIGNMENTS: dict[str, Alignment] = {"all": _best, "origin": _origin, "scale": _scale, "none": _none}


def check_pairs(estimate: Trajectory, reference: Trajectory) -> None:
    """Raise ShapeError unless the trajectories have as many poses."""
    if len(estimate) != len(reference):
        raise ShapeError(f"{len(estimate)} poses against {len(reference)}: pick pairs with associate first")
