"""A run's path against a reference of the same camera: the whole of it, and parts of given lengths."""

from typing import Any

import numpy as np

from slamlib.errors import SlamlibError
from slamlib.evaluation.alignment import KITTI_LENGTHS, aligned, relative_errors
from slamlib.evaluation.trajectory import Trajectory, associate, read_trajectory
from slamlib.vision.sequence_run import Stepping

KITTI_ROW = 12  # numbers


def read_reference(path: str | None, run: Stepping) -> Trajectory | None:
    """The path of a file, or None for none; KITTI's form has no times, but a row for each of the whole's pictures."""
    if path is None:
        return None
    times = run.source.whole.times
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


def compared(run: Stepping, reference: Trajectory) -> dict[str, Any]:
    """The path against a reference of the same camera, as plain data; with a free scale after a similarity."""
    estimate, other = pairs(run, reference)
    found = aligned(estimate, other, scale=not run.metric)
    return {
        "poses": len(estimate),
        "path_length": found.path,
        "scale": found.similarity.scale,
        "turn_from": found.by,
        "position_rmse": found.rmse,
        "position_relative": found.relative,
        "attitude_rms": float(np.degrees(np.sqrt((found.attitude**2).mean()))),
    }


def pairs(run: Stepping, reference: Trajectory) -> tuple[Trajectory, Trajectory]:
    """Poses of both at the same times."""
    estimate = run.trajectory()
    i, j = associate(estimate, reference, max(0.02, 0.5 * run.source.interval))
    return estimate[i], reference[j]


def parts(run: Stepping, reference: Trajectory) -> dict[str, Any] | None:
    """KITTI's measure of a path with true lengths, as plain data; None for a path too short to be divided."""
    estimate, other = pairs(run, reference)
    lengths = lengths_of(float(other.distances[-1]))
    if not lengths:
        return None
    found = relative_errors(estimate, other, lengths, step=min(10, max(1, len(other) // 100)))
    degrees, shares = np.degrees(found.rotation), found.counts / found.counts.sum()
    return {
        "lengths": list(lengths),
        "counts": found.counts.tolist(),
        "translation": found.translation.tolist(),
        "rotation": degrees.tolist(),
        "translation_mean": float(shares @ found.translation),
        "rotation_mean": float(shares @ degrees),
    }


def lengths_of(path: float) -> tuple[float, ...]:
    """KITTI's eight lengths [m], or the same made shorter by a round factor, so that a path has parts of all."""
    units = [unit * 10.0**power for power in range(-3, 2) for unit in (1, 2, 5)] + [100.0]
    unit = max((u for u in units if 9 * u <= path), default=0.0)
    return tuple(length * unit / KITTI_LENGTHS[0] for length in KITTI_LENGTHS) if unit else ()


def table(s: dict[str, Any] | None) -> list[tuple[str, str]]:
    """The rows of a comparison for people."""
    if s is None:
        return []
    how = f"{s['poses']} poses, scale {s['scale']:.4g}, turn from the {s['turn_from']}"
    error = f"{s['position_rmse']:.4g} rms, {s['position_relative']:.2%} of the path of {s['path_length']:.4g}"
    rows = [
        ("aligned with reference", how),
        ("error of the place", error),
        ("error of the attitude", f"{s['attitude_rms']:.2f} degrees rms"),
    ]
    return rows + _rows_of_parts(s.get("parts"))


def _rows_of_parts(s: dict[str, Any] | None) -> list[tuple[str, str]]:
    if s is None:
        return []
    means = f"{s['translation_mean']:.3%} of the length, {s['rotation_mean']:.4f} degrees a metre"
    return [(f"error over parts of {s['lengths'][0]:g} to {s['lengths'][-1]:g} m", f"{means} (KITTI's measure)")]
