"""The reference of a run's path, read, and the comparison with it, told."""

from typing import Any

import numpy as np

from slamlib.errors import SlamlibError
from slamlib.evaluation.trajectory import Trajectory, read_trajectory
from slamlib.vision.sequence_run import SequenceRun

KITTI_ROW = 12  # numbers


def read_reference(path: str | None, run: SequenceRun) -> Trajectory | None:
    """The path of a file, or None for none; KITTI's form has no times, but a row for each of the whole's pictures."""
    if path is None:
        return None
    times = run.source.times
    rows = _kitti_rows(path)
    if rows and rows != len(times):
        raise SlamlibError(
            f"{path} has {rows} poses and no times (KITTI's form), and {run.source.where} has {len(times)} pictures: "
            "as many are wanted, or a reference with times"
        )
    return read_trajectory(path, np.array(times)) if rows else read_trajectory(path)


def _kitti_rows(path: str) -> int:
    """How many rows of KITTI's form a file has; 0 if it is another one."""
    try:
        with open(path, encoding="utf-8") as file:
            rows = [line for line in file if line.strip() and not line.lstrip().startswith("#")]
    except (OSError, ValueError):
        return 0  # said by read_trajectory
    return len(rows) if rows and len(rows[0].split()) == KITTI_ROW else 0


def reference_rows(s: dict[str, Any] | None) -> list[tuple[str, str]]:
    """The rows of a comparison (slamlib.vision.results.compared) for people; none of None."""
    if s is None:
        return []
    rows = [
        (
            "aligned with reference",
            f"{s['poses']} poses, scale {s['scale']:.4g}, rotation from the {s['rotation_from']}",
        ),
        (
            "absolute trajectory error",
            f"{s['ate']:.4g} RMSE, {s['relative_ate']:.2%} of the path of {s['path_length']:.4g}",
        ),
        ("orientation error", f"{s['orientation_rms']:.2f} degrees rms"),
    ]
    p = s.get("parts")
    if p is not None:
        means = f"{p['translation_mean']:.3%} of the length, {p['rotation_mean']:.4f} degrees a metre (KITTI's measure)"
        rows.append((f"error over parts of {p['lengths'][0]:g} to {p['lengths'][-1]:g} m", means))
    return rows
