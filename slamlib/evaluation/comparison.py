"""A trajectory compared with a reference, as plain data: what `slamlib evaluate` and runs on images report.

ATE and RPE are those of evo (Grupp, github.com/MichaelGrupp/evo) and of Sturm and others (2012): the distances and
angles that remain after an alignment, and those of the motions from each pose to the next.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from slamlib.errors import SlamlibError
from slamlib.evaluation.alignment import align_trajectory, check_pairs
from slamlib.evaluation.consistency import band, nees_where_uncertain, share_inside
from slamlib.evaluation.trajectory import Rows, Trajectory, angles, associate, read_trajectory
from slamlib.geometry.pose import Pose, compose, inverse, relative
from slamlib.manifolds import Array, finite

DOF = 6
PLACED = 1.0  # [s] at the beginning, whose poses place the reference where a filter's covariances are judged
KITTI_LENGTHS = tuple(map(float, range(100, 900, 100)))  # [m]


@dataclass(frozen=True, eq=False)
class Evaluation:
    """Errors of a path against its reference.

    summary: plain data, lengths in the reference's unit and angles in degrees; series: the errors of each pose (n,), by
    name, for a plot. See `compared`.
    """

    summary: dict[str, Any]
    series: dict[str, Array]

    def __repr__(self) -> str:
        """The summary as lines of text."""
        found = rows(self.summary)
        width = max(len(name) for name, _ in found)
        return "\n".join(f"{name:{width}}  {value}" for name, value in found)


def evaluate(
    estimate: Trajectory | str | Path | ArrayLike,
    reference: Trajectory | str | Path | ArrayLike,
    *,
    scale: bool = False,
    times: ArrayLike | None = None,
    reference_std: Sequence[float] = (0, 0),
) -> Evaluation:
    """Compare a path with a reference of the same moving frame: ATE and RPE after an alignment, KITTI's metric, NEES.

    Both are trajectories, files (TUM, EuRoC, KITTI), or poses (n, 7). scale: align the scale, too: the path of one
    camera has none. times (n,) [s]: of poses and of files in KITTI's format, which have none; without them poses are a
    second apart. reference_std: the reference's own standard deviations, position [m] and orientation [deg]. Raises
    SlamlibError.

        >>> import numpy as np
        >>> import slamlib as sl
        >>> truth = np.array([[x, y, 0, 1, 0, 0, 0] for x, y in [(0, 0), (1, 0), (1, 1), (0, 1)]])
        >>> found = sl.evaluate(truth + [0, 0, 0.3, 0, 0, 0, 0], truth)  # another place of the whole path is no error
        >>> found.summary["poses"], round(found.summary["ate"], 6)
        (4, 0.0)
    """
    given = None if times is None else finite(times, (None,), "evaluate", "times")
    path, other = (_trajectory(source, given) for source in (estimate, reference))
    interval = float(np.median(np.diff(path.times))) if len(path) > 1 else 0.0
    return Evaluation(*compared(path, other, interval, metric=not scale, noise=reference_std))


def _trajectory(source: Trajectory | str | Path | ArrayLike, times: Array | None) -> Trajectory:
    if isinstance(source, Trajectory):
        return source
    if isinstance(source, str | Path):
        return read_trajectory(source, times)
    poses = finite(source, (None, 7), "evaluate", "poses")
    return Trajectory(np.arange(float(len(poses))) if times is None else times, poses)


def compared(
    path: Trajectory, reference: Trajectory, interval: float, metric: bool, noise: Sequence[float] = (0, 0)
) -> tuple[dict[str, Any], dict[str, Array]]:
    """Errors of the trajectory against a reference of the same moving frame; a free scale is aligned.

    interval [s]: between two poses; metric: whether the scale is known; noise: the reference's own standard deviations,
    position and orientation. Lengths in the reference's unit, angles in degrees. NEES needs a path with covariances; a
    free scale is then that of the best alignment, too. Second the errors of each pose, arrays (n,) by name, for a plot:
    after the alignment, or by the first poses alone where NEES is known. Raises SlamlibError.
    """
    i, j = associate(path, reference, max(0.02, 0.5 * interval))
    estimate, other = path[i], reference[j]
    found = align_trajectory(estimate, other, scale=not metric)
    orientation = np.degrees(found.orientation)
    turned = statistics(orientation)
    series = {"times": other.times, "position": found.position, "orientation": orientation}
    uncertain = estimate.covariances is not None
    series |= _nees(found.estimate, other, noise) if uncertain else {}
    steps = _motion_errors(found.estimate, other, slice(None, -1), slice(1, None))
    summary = {
        "poses": len(estimate),
        "path_length": found.path,
        "scale": found.similarity.scale,
        "rotation_from": found.rotation_from,
        "ate": found.ate,
        "relative_ate": found.relative_ate,
        "orientation_rms": turned["rmse"],
        "position": statistics(found.position),
        "orientation": turned,
        "rpe": dict(zip(("position", "orientation"), map(statistics, steps), strict=True)) if len(steps[0]) else None,
        "parts": parts(estimate, other) if metric else None,
        "nees": _consistency(series) if uncertain else None,
    }
    return summary, series


def statistics(values: Array) -> dict[str, float]:
    """The six numbers by which evo describes errors (n,)."""
    found = {
        "rmse": np.sqrt((values**2).mean()), "mean": values.mean(), "median": np.median(values), "std": values.std(),
        "min": values.min(), "max": values.max(),
    }  # fmt: skip
    return {name: float(value) for name, value in found.items()}


def _motion_errors(estimate: Trajectory, reference: Trajectory, i: Rows, j: Rows) -> tuple[Array, Array]:
    """Lengths and angles [degrees] (n,) of the errors of the motions from the poses i to the poses j."""
    motions = [relative(path.poses[i], path.poses[j]) for path in (reference, estimate)]
    error = compose(inverse(motions[0]), motions[1])
    return np.linalg.norm(error[:, :3], axis=1), np.degrees(angles(error[:, 3:]))


def _nees(estimate: Trajectory, reference: Trajectory, noise: Sequence[float]) -> dict[str, Array]:
    """NEES (n,) of the poses and its dof, their errors and deviations, by the motion that fits the first poses best.

    A filter's covariance is of its pose relative to where it started, not to where a best alignment of all puts it. But
    one pose of a reference may be wrong by more than the filter is (0.5 degrees are 0.5 m after 60 m): the first second
    counts, or a tenth of a shorter path. Its own NEES, which are too small, are nan. noise: of each of its poses.
    """
    spans = estimate.times - estimate.times[0]
    first = np.flatnonzero(spans <= min(PLACED, spans[-1] / 10))
    placed = align_trajectory(estimate[first], reference[first], scale=False, rotation_from="orientations")
    moved = placed.similarity.moved(estimate)
    covariances = np.asarray(moved.covariances) + np.diag(np.repeat([noise[0], np.radians(noise[1])], 3) ** 2)
    found = map(pose_error, reference.poses, moved.poses, covariances)
    errors, sigmas, nees = map(np.array, zip(*found, strict=True))
    if len(first) > 1:
        nees[first] = np.nan
    return {"nees": nees, "nees_dof": np.full(len(nees), DOF), **magnitudes(errors, sigmas)}


def pose_error(
    true: Array, estimate: Array, covariance: Array, free: Array | None = None
) -> tuple[Array, Array, float]:
    """Error (6,) of a pose (7,), true minus estimate in the tangent space, its standard deviations (6,), its NEES.

    free (6, f): the directions in which the pose can be, of which the NEES is; None: all.
    """
    error, sigma = Pose.minus(true, estimate), np.sqrt(covariance.diagonal())
    if free is not None:
        return error, sigma, nees_where_uncertain(free.T @ error, free.T @ covariance @ free)
    return error, sigma, nees_where_uncertain(error, covariance)


def magnitudes(errors: Array, sigmas: Array) -> dict[str, Array]:
    """Lengths (...) [m] and angles (...) [degrees] of errors (..., 6) of a pose, and of their standard deviations."""
    return {
        "position": np.linalg.norm(errors[..., :3], axis=-1),
        "position_sigma": np.linalg.norm(sigmas[..., :3], axis=-1),
        "orientation": np.degrees(np.linalg.norm(errors[..., 3:], axis=-1)),
        "orientation_sigma": np.degrees(np.linalg.norm(sigmas[..., 3:], axis=-1)),
    }


def sigmas_at_end(path: Trajectory) -> dict[str, float]:
    """Lengths of the standard deviations at the end of a path with covariances: position, orientation [degrees]."""
    sigmas = np.sqrt(np.asarray(path.covariances)[-1].diagonal())
    found = magnitudes(np.zeros(6), sigmas)
    return {name: float(value) for name, value in found.items() if name.endswith("sigma")}


def _consistency(series: dict[str, Array]) -> dict[str, Any] | None:
    known = series["nees"][np.isfinite(series["nees"])]
    if not len(known):
        return None
    limits = band(DOF)
    return {
        "dof": DOF, "median": float(np.median(known)), "last": float(known[-1]), "band": list(limits),
        "inside": share_inside(known, limits),
        "at_end": {n: float(series[n][-1]) for n in series if n.startswith(("position", "orientation"))},
    }  # fmt: skip


def rows(r: dict[str, Any]) -> list[tuple[str, str]]:
    """The rows of a comparison as texts (name, value)."""
    p, o, step, part, nees = r["position"], r["orientation"], r["rpe"], r["parts"], r["nees"]
    turned = f"rotation from the {r['rotation_from']}"
    found = [
        ("aligned with reference", f"{r['poses']} poses, scale {r['scale']:.4g}, {turned}"),
        ("absolute error (ATE)", f"{r['ate']:.4g} RMSE, {r['relative_ate']:.2%} of the path of "
         f"{r['path_length']:.4g}; median {p['median']:.4g}, max {p['max']:.4g}"),
        ("orientation error", f"{r['orientation_rms']:.2f} degrees rms; median {o['median']:.2f}, max {o['max']:.2f}"),
    ]  # fmt: skip
    if step:
        moved, turn = step["position"]["rmse"], step["orientation"]["rmse"]
        found.append(("relative error (RPE)", f"{moved:.4g} and {turn:.3g} degrees RMSE, from each pose to the next"))
    if part:
        means = f"{part['translation_mean']:.3%} of the length, {part['rotation_mean']:.4f} degrees per metre"
        lengths = f"{part['lengths'][0]:g} to {part['lengths'][-1]:g} m"
        found.append((f"error over parts of {lengths}", f"{means} (KITTI's metric)"))
    if nees:
        (low, high), e = nees["band"], nees["at_end"]
        inside = f"{nees['inside']:.0%} of the poses inside [{low:.2f}, {high:.2f}] (1 run, 95 %)"
        found += [
            (f"NEES, {DOF} dof", f"median {nees['median']:.3g}, last {nees['last']:.3g}; {inside}"),
            ("at the end, from the start", f"off by {e['position']:.3g} (sigma {e['position_sigma']:.2g}), "
             f"{e['orientation']:.2g} degrees (sigma {e['orientation_sigma']:.2g})"),
        ]  # fmt: skip
    return found


def parts(
    estimate: Trajectory, reference: Trajectory, lengths: tuple[float, ...] = (), step: int = 0
) -> dict[str, Any] | None:
    """KITTI's relative pose error: the motion over each segment of a given length [m], against the true one.

    The two are pairs, row by row, of the same body (one camera, say), and in one unit; no alignment is needed. Segments
    start at each step-th pose, and end at the first pose that is a length further along the reference. For each length
    the number of segments, the error of translation per length (0.01 is 1 %) and that of rotation [degrees/m], nan
    where no segment is so long; and the means over all segments. None if no lengths are given and the path is too short
    for those of `lengths_of`. Raises SlamlibError if it is shorter than all that are given.
    """
    check_pairs(estimate, reference)
    along, every = reference.distances, step or min(10, max(1, len(reference) // 100))
    chosen, starts = lengths or lengths_of(float(along[-1])), np.arange(0, len(along), every)
    if not chosen:
        return None
    if not along[-1] > min(chosen):
        raise SlamlibError(f"the path is {along[-1]:.4g} long, shorter than all of {chosen}: give shorter lengths")
    counts, translation, turn = np.zeros(len(chosen), dtype=int), *np.full((2, len(chosen)), np.nan)
    for row, length in enumerate(chosen):
        stops = np.searchsorted(along, along[starts] + length, side="right")
        i, j = starts[stops < len(along)], stops[stops < len(along)]
        if len(i):
            off, turned = _motion_errors(estimate, reference, i, j)
            counts[row], translation[row], turn[row] = len(i), off.mean() / length, turned.mean() / length
    shares = counts / counts.sum()
    return {
        "lengths": list(chosen),
        "counts": counts.tolist(),
        "translation": translation.tolist(),
        "rotation": turn.tolist(),
        "translation_mean": float(shares @ translation),
        "rotation_mean": float(shares @ turn),
    }


def lengths_of(path: float) -> tuple[float, ...]:
    """KITTI's eight lengths [m], or the same divided by a round factor, so that a trajectory has parts of all."""
    units = [unit * 10.0**power for power in range(-3, 2) for unit in (1, 2, 5)] + [100.0]
    unit = max((u for u in units if 9 * u <= path), default=0.0)
    return tuple(length * unit / KITTI_LENGTHS[0] for length in KITTI_LENGTHS) if unit else ()
