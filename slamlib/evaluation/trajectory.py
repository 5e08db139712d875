"""Trajectories: times and poses, the files that other tools read, and association by time.

Alignment with a reference, and the remaining errors, are in slamlib.evaluation.alignment.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from slamlib.errors import ShapeError, SlamlibError
from slamlib.geometry.pose import Pose, compose
from slamlib.geometry.quaternion import best_pivot, from_rotation
from slamlib.manifolds import Array, Indices, Mask, finite, read_only_copy
from slamlib.plain_data.files import write_whole

Rows = slice | Sequence[int] | Indices | Mask  # some of the poses


@dataclass(frozen=True, eq=False)
class Trajectory:
    """times (n,) [s], increasing, and the poses (n, 7) of one frame, such as a camera's, in the world; n at least 1.

    Quaternions are normalized. covariances (n, 6, 6), or None where they are not known: of the position [m] along the
    world's axes and the rotation vector [rad] in the moving frame. Raises SlamlibError for anything else.
    """

    times: Array
    poses: Array
    covariances: Array | None = None

    def __post_init__(self) -> None:
        times = finite(self.times, (None,), "Trajectory", "times")
        poses = finite(self.poses, (len(times), 7), "Trajectory", "poses")
        if not len(times):
            raise ShapeError("Trajectory: there is no pose in it")
        if not (np.diff(times) > 0).all():
            place = int(np.argmin(np.diff(times) > 0))
            raise SlamlibError(f"Trajectory: times must grow, got {times[place]} and then {times[place + 1]}")
        length = np.linalg.norm(poses[:, 3:], axis=1, keepdims=True)
        if (np.abs(length - 1) > 0.01).any():
            raise SlamlibError("Trajectory: poses are (x, y, z, w, x, y, z), their last four numbers of length one")
        object.__setattr__(self, "times", read_only_copy(times))
        object.__setattr__(self, "poses", read_only_copy(np.concatenate([poses[:, :3], poses[:, 3:] / length], axis=1)))
        if self.covariances is not None:
            known = finite(self.covariances, (len(times), 6, 6), "Trajectory", "covariances")
            object.__setattr__(self, "covariances", read_only_copy(known))

    def __len__(self) -> int:
        return len(self.times)

    def __getitem__(self, rows: Rows) -> "Trajectory":
        """Select poses, in the order of their times."""
        return Trajectory(
            self.times[rows], self.poses[rows], None if self.covariances is None else self.covariances[rows]
        )

    @property
    def positions(self) -> Array:
        """Positions (n, 3) [m]."""
        return self.poses[:, :3]

    @property
    def distances(self) -> Array:
        """Length of the path (n,) [m] up to each pose; the last number is the total."""
        steps = np.linalg.norm(np.diff(self.positions, axis=0), axis=1)
        return np.concatenate([[0.0], np.cumsum(steps)])

    def moved(self, poses: Array, J: Array) -> "Trajectory":
        """Other poses (n, 7) at the same times, with their Jacobians ((n,) 6, 6) w.r.t. the present ones."""
        known = None if self.covariances is None else J @ self.covariances @ J.swapaxes(-1, -2)
        return Trajectory(self.times, poses, known)

    def considering(self, other: "Trajectory") -> "Trajectory":
        """The same poses; the difference to `other`, of a parameter one standard deviation off, joins the covariances.

        P + d d', d = other - self: eq. (se-considered), for a path with covariances, and poses at the same times.
        """
        d = Pose.minus(other.poses, self.poses)
        return Trajectory(self.times, self.poses, np.asarray(self.covariances) + d[:, :, None] * d[:, None, :])

    def sensor_trajectory(self, extrinsics: Array) -> "Trajectory":
        """The trajectory of a sensor at `extrinsics` (7,) in the moving frame, such as a robot's camera."""
        poses, J = compose.jac(self.poses, extrinsics)
        return self.moved(poses, J[0])


def write_tum(path: str | Path, trajectory: Trajectory) -> None:
    """Write rows of "time x y z qx qy qz qw", TUM RGB-D's format, which evo reads; atomically.

    Covariances go into a second file beside it, which ends in .cov: rows of the time and the upper triangle.
    """
    poses = trajectory.poses[:, [0, 1, 2, 4, 5, 6, 3]]
    if trajectory.covariances is not None:
        upper = trajectory.covariances[:, *_UPPER]
        _write_rows(beside(path), _COVARIANCES, trajectory.times, upper)
    _write_rows(path, "time[s] x y z qx qy qz qw", trajectory.times, poses)


_COVARIANCES = "time[s], 21 numbers: P11 P12 .. P16 P22 .. P66 of x y z [m] in the world, rotation [rad] in the frame"
_UPPER = np.triu_indices(6)


def beside(path: str | Path) -> Path:
    """The file of the covariances of a trajectory's file."""
    return Path(path).with_suffix(".cov")


def _write_rows(path: str | Path, head: str, times: Array, values: Array) -> None:
    rows = (" ".join([f"{t:.9f}", *(f"{value:.12g}" for value in row)]) for t, row in zip(times, values, strict=True))
    write_whole(path, f"# {head}\n" + "\n".join(rows) + "\n")


def read_trajectory(path: str | Path, times: Array | None = None) -> Trajectory:
    """Read a trajectory: TUM rows of 8 numbers, KITTI rows of 12 (3 x 4, no times), EuRoC rows with commas (ns).

    times (n,) [s]: of the rows of KITTI's format, which has none; the others have their own. Covariances are those of
    the file that `write_tum` writes beside one, if it is there. Raises SlamlibError.
    """
    rows, with_commas = read_rows(path)
    width = rows.shape[1]
    if with_commas and width >= 8:
        times, poses = 1e-9 * rows[:, 0], rows[:, 1:8]
    elif width == 8:
        times, poses = rows[:, 0], rows[:, [1, 2, 3, 7, 4, 5, 6]]
    elif width == 12:
        turns = rows.reshape(-1, 3, 4)[..., :3]
        poses = np.concatenate([rows[:, 3::4], from_rotation(turns, best_pivot(turns))], axis=1)
    else:
        raise SlamlibError(f"{path} is no trajectory: rows of 8 (TUM) or 12 numbers (KITTI), or EuRoC's, are wanted")
    if times is None or len(times) != len(poses):
        why = "give them (times=..., --times FILE)" if times is None else f"{len(times)} are given: as many are wanted"
        raise SlamlibError(f"{path} has {len(poses)} poses, but no times (KITTI's form): {why}")
    covariances = None
    if beside(path).is_file() and beside(path) != Path(path):
        known, _ = read_rows(beside(path))
        if known.shape != (len(times), 22) or (np.abs(known[:, 0] - times) > 1e-6).any():
            raise SlamlibError(f"{beside(path)} does not have the covariances of the poses in {path}: move it away")
        covariances = np.empty((len(times), 6, 6))
        covariances[:, *_UPPER] = covariances[:, *_UPPER[::-1]] = known[:, 1:]
    try:
        return Trajectory(times, poses, covariances)
    except SlamlibError as error:
        raise SlamlibError(f"{path}: {error}") from None


def read_rows(path: str | Path) -> tuple[Array, bool]:
    """The rows of numbers (n, k) in a file, without comments, and whether commas separate them. Raises SlamlibError."""
    try:
        text = Path(path).read_text("utf-8")
    except (OSError, ValueError) as error:
        raise SlamlibError(f"{path} cannot be read: {error}") from None
    lines = [line for line in text.splitlines() if line.strip() and not line.lstrip().startswith("#")]
    if not lines:
        raise SlamlibError(f"{path} is no trajectory: there is no row in it")
    try:
        rows = np.array([[float(w) for w in line.replace(",", " ").split()] for line in lines])
    except ValueError as error:
        raise SlamlibError(f"{path} is no trajectory: its rows are not numbers, as many in each: {error}") from None
    if len(bad := np.argwhere(~np.isfinite(rows))):
        raise SlamlibError(f"{path} is no trajectory: nan or infinity in its row {bad[0, 0]}")
    return rows, "," in lines[0]


def associate(one: Trajectory, other: Trajectory, tolerance: float = 0.02) -> tuple[Indices, Indices]:
    """Matching rows of two trajectories: nearest in time, at most `tolerance` [s] apart, none used twice.

    Raises SlamlibError if there is no pair.
    """
    i, j = matched_times(one.times, other.times, tolerance)
    if not len(i):
        raise SlamlibError(
            f"no two times are within {tolerance} s: one trajectory is of {one.times[0]:.3f} to {one.times[-1]:.3f} s, "
            f"the other of {other.times[0]:.3f} to {other.times[-1]:.3f} s"
        )
    return i, j


def matched_times(one: Array, other: Array, tolerance: float) -> tuple[Indices, Indices]:
    """Matching rows (k,) of two lists of increasing times [s]; see `associate`."""
    after = np.searchsorted(other, one).clip(1, max(len(other) - 1, 1))
    near = np.stack([after - 1, after.clip(max=len(other) - 1)])
    gaps = np.abs(other[near] - one)
    j, gap = near[gaps.argmin(0), np.arange(len(one))], gaps.min(0)
    order = np.lexsort((gap, j))  # of those that want the same row, the nearest comes first
    first = np.ones(len(j), dtype=bool)
    first[1:] = np.diff(j[order]) > 0
    rows = np.sort(order[first & (gap[order] <= tolerance)])
    return rows, j[rows]


def angles(quaternions: Array) -> Array:
    """Angles (...) [rad], 0 to pi, of rotations (..., 4)."""
    return 2 * np.arctan2(np.linalg.norm(quaternions[..., 1:], axis=-1), np.abs(quaternions[..., 0]))
