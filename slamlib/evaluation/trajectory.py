"""Trajectories: times and poses, their files, and association by time.

What other tools write is in slamlib.evaluation.trajectory_files; alignment with a reference, and the remaining errors,
are in slamlib.evaluation.alignment.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from slamlib.errors import ShapeError, SlamlibError
from slamlib.evaluation.trajectory_files import PoseTable, read_poses, text_rows
from slamlib.geometry.pose import Pose, compose
from slamlib.kalman import linalg
from slamlib.manifolds import Array, Indices, Mask, finite, read_only_copy
from slamlib.plain_data.files import write_whole

Rows = slice | Sequence[int] | Indices | Mask  # some of the poses


@dataclass(frozen=True, eq=False)
class Trajectory:
    """times (n,) [s], increasing, and the poses (n, 7) of one frame, such as a camera's, in the world; n at least 1.

    Quaternions are normalized. covariances (n, 6, 6), or None where they are not known: of the position [m] along the
    world's axes and the rotation vector [rad] in the moving frame. notes: what was mended when its file was read, in
    sentences. Raises SlamlibError for anything else.
    """

    times: Array
    poses: Array
    covariances: Array | None = None
    notes: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        times = finite(self.times, (None,), "Trajectory", "times")
        poses = finite(self.poses, (len(times), 7), "Trajectory", "poses")
        if not len(times):
            raise ShapeError("Trajectory: there is no pose in it")
        if not (np.diff(times) > 0).all():
            place = int(np.argmin(np.diff(times) > 0))
            raise SlamlibError(f"Trajectory: times must grow, got {times[place]} and then {times[place + 1]}")
        length = np.linalg.norm(poses[:, 3:], axis=1, keepdims=True)
        if len(bad := np.flatnonzero(np.abs(length - 1) > 0.01)):
            raise SlamlibError(
                "Trajectory: poses are (x, y, z, qw, qx, qy, qz), the last four numbers of length one, and those at "
                f"index {bad[0]} of length {length[bad[0], 0]:.4g}"
            )
        object.__setattr__(self, "times", read_only_copy(times))
        object.__setattr__(self, "poses", read_only_copy(np.concatenate([poses[:, :3], poses[:, 3:] / length], axis=1)))
        if self.covariances is not None:
            known = finite(self.covariances, (len(times), 6, 6), "Trajectory", "covariances")
            linalg.check_covariances(known, "Trajectory", "covariances")
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

    Covariances go into a second file beside it, named as it is and .cov: rows of the time and the upper triangle. One
    that belonged to what `path` was before is removed.
    """
    poses = trajectory.poses[:, [0, 1, 2, 4, 5, 6, 3]]
    if trajectory.covariances is not None:
        upper = trajectory.covariances[:, *_UPPER]
        _write_rows(beside(path), _COVARIANCES, trajectory.times, upper, digits=17)  # or a singular one is none
    _write_rows(path, "time[s] x y z qx qy qz qw", trajectory.times, poses)
    if trajectory.covariances is None:
        beside(path).unlink(missing_ok=True)


_COVARIANCES = "time[s], 21 numbers: P11 P12 .. P16 P22 .. P66 of x y z [m] in the world, rotation [rad] in the frame"
_UPPER = np.triu_indices(6)


def beside(path: str | Path) -> Path:
    """The file of the covariances of a trajectory's file: its whole name and .cov, for path_0.5 path_0.5.cov."""
    return Path(f"{path}.cov").expanduser()


def _write_rows(path: str | Path, head: str, times: Array, values: Array, digits: int = 12) -> None:
    rows = (
        " ".join([f"{t:.9f}", *(f"{value:.{digits}g}" for value in row)]) for t, row in zip(times, values, strict=True)
    )
    write_whole(path, f"# {head}\n" + "\n".join(rows) + "\n")


def read_trajectory(
    path: str | Path, times: Array | None = None, *, form: str | None = None, covariances: bool = True
) -> Trajectory:
    """Read a trajectory: a header's columns, or those of TUM, EuRoC, KITTI or TartanAir (`trajectory_files`).

    times (n,) [s]: of rows that have none (KITTI, TartanAir); the others keep their own. form: the format, where the
    file does not tell it. covariances: also those of the file that `write_tum` writes beside one, if it is there;
    False: of a reference. Raises SlamlibError.
    """
    return of_table(read_poses(path, form), times, covariances)


def of_table(table: PoseTable, times: Array | None, covariances: bool) -> Trajectory:
    """The trajectory of a file's rows; see `read_trajectory`."""
    when, poses, notes = table.timed(times)
    known = _covariances(table.path, when) if covariances and beside(table.path).is_file() else None
    try:
        return Trajectory(when, poses, known, notes)
    except SlamlibError as error:
        raise SlamlibError(f"{table.path}: {error}") from None


def _covariances(path: str | Path, times: Array) -> Array:
    """The covariances (n, 6, 6) beside a file whose poses have these times."""
    rows = text_rows(beside(path))
    known = rows.numbers(range(len(rows.words[0])))
    if known.shape != (len(times), 22) or not (np.abs(known[:, 0] - times) <= 1e-6).all():
        raise SlamlibError(f"{beside(path)} does not have the covariances of the poses in {path}: move it away")
    found = np.empty((len(times), 6, 6))
    found[:, *_UPPER] = found[:, *_UPPER[::-1]] = known[:, 1:]
    return found


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
