"""A trajectory compared with a reference, as plain data: what `slamlib evaluate` and runs on images report.

ATE and RPE are those of evo (Grupp, github.com/MichaelGrupp/evo) and of Sturm and others (2012): the distances and
angles that remain after an alignment, and those of the motions from each pose to the next, or over another delta.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from slamlib.errors import SlamlibError, entry
from slamlib.evaluation.alignment import AlignedTrajectory, align_trajectory, check_pairs, moves, nearest_rotation
from slamlib.evaluation.clocks import LEAST_TOLERANCE, denser, in_one_unit, time_offset
from slamlib.evaluation.consistency import band, share_inside
from slamlib.evaluation.motion_pairs import motion_pairs
from slamlib.evaluation.pose_errors import ERRORS, pose_nees
from slamlib.evaluation.trajectory import Rows, Trajectory, angles, matched_times, of_table
from slamlib.evaluation.trajectory_files import PoseTable, read_poses, read_times
from slamlib.geometry.pose import Pose, compose, inverse, relative
from slamlib.geometry.quaternion import best_pivot, from_rotation, product, rotation
from slamlib.manifolds import Array, Indices, finite

DOF = 6  # of a pose
PLACED = 1.0  # [s] at the beginning, whose poses place the reference where a filter's covariances are judged
KITTI_LENGTHS = tuple(map(float, range(100, 900, 100)))  # [m]
LEAST_PAIRS, LEAST_SHARE, FEW = 3, 0.05, 10  # fewer pairs than FEW are too few unless they are a share of the poses
LEAST_TURN = np.radians(1)  # of a reference that turns, and does not stand still
OTHER_FRAME = np.radians(20)  # of larger turns that all poses have in common a note is made
BESIDE = "nees_linear"  # NEES of the linear error, where the covariances are of another one
UNEXPLAINED = 0.7  # share of the reference's spread: of a larger ATE with a free scale a note is made


@dataclass(frozen=True)
class ComparisonOptions:
    """How two trajectories are paired and aligned, and of which motions relative errors are; see `evaluate`."""

    align: str = "all"
    align_first: int | None = None
    tolerance: float | None = None
    offset: float | str = 0.0
    delta: float = 1
    delta_unit: str = "frames"
    all_pairs: bool = False
    covariance_error: str = "linear"

    def __post_init__(self) -> None:
        entry("covariance error", self.covariance_error, ERRORS)
        if self.tolerance is not None and not self.tolerance >= 0:
            raise SlamlibError(f"tolerance, the largest distance in time, is zero or more, got {self.tolerance}")
        if self.align_first is not None and self.align_first < 1:
            raise SlamlibError(f"align-first is a number of poses, one or more, got {self.align_first}")
        if self.offset != "auto" and not (isinstance(self.offset, float | int) and np.isfinite(self.offset)):
            raise SlamlibError(f"offset is a number of seconds, or auto, got {self.offset!r}")


DEFAULT = ComparisonOptions()


@dataclass(frozen=True, eq=False)
class Evaluation:
    """Errors of a path against its reference.

    summary: plain data, lengths in the reference's unit and angles in degrees, and notes, sentences on what was mended
    or is doubtful; series: the errors of each pose (n,), by name, for a plot. See `compared`.
    """

    summary: dict[str, Any]
    series: dict[str, Array]

    def __repr__(self) -> str:
        """The summary as lines of text."""
        found = [*rows(self.summary), *(("note", note) for note in self.summary["notes"])]
        width = max(len(name) for name, _ in found)
        return "\n".join(f"{name:{width}}  {value}" for name, value in found)


def evaluate(
    estimate: Trajectory | str | Path | ArrayLike,
    reference: Trajectory | str | Path | ArrayLike,
    *,
    scale: bool = False,
    times: str | Path | ArrayLike | None = None,
    reference_std: Sequence[float] = (0, 0),
    format: str | None = None,
    reference_format: str | None = None,
    align: str = "all",
    align_first: int | None = None,
    tolerance: float | None = None,
    offset: float | str = 0.0,
    delta: float = 1,
    delta_unit: str = "frames",
    all_pairs: bool = False,
    covariance_error: str = "linear",
) -> Evaluation:
    """Compare a path with a reference of the same moving frame: ATE and RPE after an alignment, KITTI's metric, NEES.

    Both are trajectories, files (a header's columns, or TUM, EuRoC, KITTI, TartanAir; format, reference_format: "tum",
    "euroc", "kitti" or "tartanair", where a file does not tell it), or poses (n, 7). times (n,) [s], or a file whose
    rows begin with them: of poses and of files that have none. Without them poses are a second apart, and two files are
    paired row by row. reference_std: the reference's own standard deviations, position [m] and orientation [deg].

    Poses are paired with the nearest in time, at most tolerance [s] apart; None: half of the interval of the denser
    trajectory, or 0.02 s. offset [s]: added to the path's times; "auto": where speeds or angular rates correlate most.

    align: "all", by the motion that fits best; "origin", the first pose with the first; "scale" alone; "none".
    align_first: only so many poses determine it. scale: align the scale, too: the path of one camera has none.

    delta, delta_unit: of the motions whose errors are the RPE, "frames", "s", "m", "deg" or "rad" along the path;
    all_pairs: from every pose, not one after another.

    covariance_error: what the path's covariances are of, and so of which error NEES is: "linear", or "invariant", as in
    a filter with error="world". The files do not tell it, and for small errors it is the same.

    Raises SlamlibError.

        >>> import numpy as np
        >>> import slamlib as sl
        >>> truth = np.array([[x, y, 0, 1, 0, 0, 0] for x, y in [(0, 0), (1, 0), (1, 1), (0, 1)]])
        >>> found = sl.evaluate(truth + [0, 0, 0.3, 0, 0, 0, 0], truth)  # another place of the whole path is no error
        >>> found.summary["poses"], round(found.summary["ate"], 6)
        (4, 0.0)
    """
    how = ComparisonOptions(align, align_first, tolerance, offset, delta, delta_unit, all_pairs, covariance_error)
    own, other = (
        read_poses(source, form) if isinstance(source, str | Path) else source
        for source, form in ((estimate, format), (reference, reference_format))
    )
    given, notes = _times(times, own, other)
    path, truth = _trajectory(own, given, covariances=True), _trajectory(other, given, covariances=False)
    summary, series = compared(path, truth, not scale, reference_std, how)
    return Evaluation(summary | {"notes": [*notes, *summary["notes"]]}, series)


Source = Trajectory | PoseTable | ArrayLike


def _times(times: str | Path | ArrayLike | None, own: Source, other: Source) -> tuple[Array | None, Sequence[str]]:
    """The times (n,) [s] of rows without any, and notes: as they are given; of two files without, numbers of rows."""
    if isinstance(times, str | Path):
        return read_times(times)
    if times is not None:
        return finite(times, (None,), "evaluate", "times"), ()
    if not (isinstance(own, PoseTable) and isinstance(other, PoseTable) and own.times is None and other.times is None):
        return None, ()
    if len(own.poses) != len(other.poses):
        raise SlamlibError(
            f"{own.path} has {len(own.poses)} poses, {other.path} {len(other.poses)}, and neither has times: only as "
            "many can be paired row by row"
        )
    return np.arange(float(len(own.poses))), ["neither file has times: paired row by row, a second apart"]


def _trajectory(source: Source, times: Array | None, covariances: bool) -> Trajectory:
    if isinstance(source, Trajectory):
        return source
    if isinstance(source, PoseTable):
        return of_table(source, times, covariances)
    poses = finite(source, (None, 7), "evaluate", "poses")
    return Trajectory(np.arange(float(len(poses))) if times is None else times, poses)


def compared(
    path: Trajectory,
    reference: Trajectory,
    metric: bool,
    noise: Sequence[float] = (0, 0),
    how: ComparisonOptions = DEFAULT,
) -> tuple[dict[str, Any], dict[str, Array]]:
    """Errors of the trajectory against a reference of the same moving frame; a free scale is aligned.

    A reference that only turns has no scale, and no motion in any unit: then errors are in the path's own.

    metric: whether the scale is known; noise: the reference's own standard deviations, position and orientation.
    Lengths in the reference's unit, angles in degrees. NEES needs a path with covariances; a free scale is then that of
    the best alignment, too. It is of the error that these are said to be of, and nees_linear of the linear one where
    that is another. Second the errors of each pose, arrays (n,) by name, for a plot: after the alignment, or by
    the first poses alone where NEES is known. Raises SlamlibError.
    """
    path, reference, offset, notes = _by_one_clock(path, reference, how.offset)
    tolerance = how.tolerance if how.tolerance is not None else max(LEAST_TOLERANCE, 0.5 * denser(path, reference))
    i, j = _paired(path, reference, tolerance)
    estimate, other = path[i], reference[j]
    if not metric and _only_turns(other):
        metric = True
        notes.append("the reference only turns: it has no scale, and the path keeps its own")
    found = align_trajectory(estimate, other, scale=not metric, align=how.align, first=how.align_first)
    notes += _doubts(found, other, metric)
    orientation = np.degrees(found.orientation)
    turned = statistics(orientation)
    series = {"times": other.times, "position": found.position, "orientation": orientation}
    uncertain = estimate.covariances is not None
    series |= _nees(found.estimate, other, noise, how.covariance_error) if uncertain else {}
    notes += _ranks(series) if uncertain else []
    steps = _motion_errors(
        found.estimate, other, *motion_pairs(found.estimate, how.delta, how.delta_unit, how.all_pairs)
    )
    summary = {
        "poses": len(estimate),
        "pairs": {
            "of": len(path), "largest": float(np.abs(estimate.times - other.times).max()), "tolerance": tolerance,
            "offset": offset,
        },
        "path_length": found.path,
        "scale": found.similarity.scale,
        "align": how.align,
        "rotation_from": found.rotation_from,
        "ate": found.ate,
        "relative_ate": found.relative_ate if found.path > 0 else None,
        "orientation_rms": turned["rmse"],
        "position": statistics(found.position),
        "orientation": turned,
        "rpe": {
            **dict(zip(("position", "orientation"), map(statistics, steps), strict=True)),
            "delta": how.delta, "delta_unit": how.delta_unit, "all_pairs": how.all_pairs, "motions": len(steps[0]),
        },
        "parts": parts(estimate, other) if metric and how.align != "scale" else None,
        "nees": _consistency(series, how.covariance_error) if uncertain else None,
        "nees_linear": _consistency(series, "linear", BESIDE) if BESIDE in series else None,
        "notes": notes,
    }  # fmt: skip
    return summary, series


def _by_one_clock(
    path: Trajectory, reference: Trajectory, offset: float | str
) -> tuple[Trajectory, Trajectory, float, list[str]]:
    """The two with times in one unit, the path's moved by an offset [s], or by the one that is found; it, and notes."""
    notes = [*path.notes, *(note for note in reference.notes if note not in path.notes)]
    path, reference, changed = in_one_unit(path, reference)
    notes += changed
    if isinstance(offset, str):
        found = time_offset(path, reference)
        offset = found.seconds
        notes.append(
            f"time offset {offset:.4f} s, added to the path's times: found from the {found.source}, which correlate by "
            f"{found.correlation:.3f} there"
        )
    return replace(path, times=path.times + offset) if offset else path, reference, offset, notes


def _paired(path: Trajectory, reference: Trajectory, tolerance: float) -> tuple[Indices, Indices]:
    """Matching rows (k,), see `associate`. Raises SlamlibError where they are too few to be compared."""
    i, j = matched_times(path.times, reference.times, tolerance)
    least = min(len(path), len(reference))
    if len(i) >= LEAST_PAIRS and (len(i) >= FEW or len(i) >= LEAST_SHARE * least):
        return i, j
    spans = [(t.times[0], t.times[-1]) for t in (path, reference)]
    first, last = max(spans[0][0], spans[1][0]), min(spans[0][1], spans[1][1])
    common = f"in common are {first:.3f} to {last:.3f} s" if first <= last else "no time is in common"
    of = " and ".join(f"{start:.3f} to {end:.3f} s" for start, end in spans)
    raise SlamlibError(
        f"only {len(i)} of {len(path)} poses have one of the reference's {len(reference)} within {tolerance:.4g} s. "
        f"Path and reference are of {of}, {common}: are both in seconds, and by one clock? `slamlib evaluate` "
        "takes an offset and a tolerance"
    )


def _only_turns(reference: Trajectory) -> bool:
    """Whether a body turns in one place; one that stands still does neither."""
    turned = product(reference.poses[0, 3:] * [1, -1, -1, -1], reference.poses[:, 3:])
    return not moves(reference.positions) and float(angles(turned).max()) > LEAST_TURN


def _doubts(found: AlignedTrajectory, reference: Trajectory, metric: bool) -> list[str]:
    """Notes on an alignment that positions do not determine, and on orientations that are of another body frame."""
    notes, spread = [], float(np.sqrt(reference.positions.var(0).sum()))
    if found.rotation_from == "orientations":
        notes.append("path or reference does not move: they are aligned by their orientations alone")
    elif not metric and found.ate > UNEXPLAINED * spread:
        notes.append(f"with the scale that fits best errors are still as large as the reference's spread, {spread:.3g}")
    errors = rotation(product(reference.poses[:, 3:] * [1, -1, -1, -1], found.estimate.poses[:, 3:]))
    common = from_rotation(turn := nearest_rotation(errors.sum(0)), best_pivot(turn))
    left = product(common * [1, -1, -1, -1], from_rotation(errors, best_pivot(errors)))
    constant, rest = float(angles(common)), float(np.sqrt((angles(left) ** 2).mean()))
    if found.rotation_from != "none" and constant > max(OTHER_FRAME, 3 * rest):
        notes.append(
            f"orientations differ by one turn of {np.degrees(constant):.0f} degrees at all poses: path and reference "
            "are of two frames of the moving body, and relative errors need one"
        )
    return notes


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


def _nees(estimate: Trajectory, reference: Trajectory, noise: Sequence[float], error: str) -> dict[str, Array]:
    """NEES (n,) of the poses and its dof, their errors and deviations, by the motion that fits the first poses best.

    A filter's covariance is of its pose relative to where it started, not to where a best alignment of all puts it. But
    one pose of a reference may be wrong by more than the filter is (0.5 degrees are 0.5 m after 60 m): the first second
    counts, or a tenth of a shorter path. Its own NEES, which are too small, are nan. noise: of each of its poses;
    error: of which NEES is, among ERRORS; where that is not the linear one, BESIDE is of the linear one.
    """
    spans = estimate.times - estimate.times[0]
    first = np.flatnonzero(spans <= min(PLACED, spans[-1] / 10))
    placed = align_trajectory(estimate[first], reference[first], scale=False, rotation_from="orientations")
    moved = placed.similarity.moved(estimate)
    covariances = np.asarray(moved.covariances) + np.diag(np.repeat([noise[0], np.radians(noise[1])], 3) ** 2)
    errors = np.array(list(map(Pose.minus, reference.poses, moved.poses)))
    sigmas = np.sqrt(np.diagonal(covariances, axis1=1, axis2=2))
    columns = {"nees": error} if error == "linear" else {"nees": error, BESIDE: "linear"}
    found: dict[str, Array] = {}
    for name, own in columns.items():
        judged = map(pose_nees, map(ERRORS[own], reference.poses, moved.poses), covariances)
        nees, rank = map(np.array, zip(*judged, strict=True))
        if len(first) > 1:
            nees[first] = np.nan
        dof = rank.max()  # where more is known exactly than elsewhere, as at a start, is none that could be compared
        nees[rank < dof] = np.nan
        found |= {name: nees, "nees_dof": np.full(len(nees), dof)}
    return {**found, **magnitudes(errors, sigmas)}


def _ranks(series: dict[str, Array]) -> list[str]:
    """A note of covariances that claim to know something exactly, or of none that is a covariance."""
    dof = int(series["nees_dof"][0])
    if dof == 0:
        return ["no pose has a covariance above zero: there is no NEES"]
    if dof < DOF:
        return [f"{DOF - dof} of {DOF} directions are known exactly by the covariances: NEES is of the others"]
    return []


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


def _consistency(series: dict[str, Array], error: str, column: str = "nees") -> dict[str, Any] | None:
    known = series[column][np.isfinite(series[column])]
    if not len(known):
        return None
    dof = int(series["nees_dof"][0])
    limits = band(dof)
    return {
        "error": error, "dof": dof, "median": float(np.median(known)), "last": float(known[-1]), "band": list(limits),
        "inside": share_inside(known, limits),
        "at_end": {n: float(series[n][-1]) for n in series if n.startswith(("position", "orientation"))},
    }  # fmt: skip


def rows(r: dict[str, Any]) -> list[tuple[str, str]]:
    """The rows of a comparison as texts (name, value)."""
    p, o, step, part = r["position"], r["orientation"], r["rpe"], r["parts"]
    still = r["relative_ate"] is None
    share = "of no path" if still else f"{r['relative_ate']:.2%} of the path of {r['path_length']:.4g}"
    pairs, offset = r["pairs"], r["pairs"]["offset"]
    moved = f"; {offset:.4f} s added to the path's times" if offset else ""
    apart = f"at most {pairs['largest']:.2g} s apart ({pairs['tolerance']:.2g} s are allowed){moved}"
    found = [
        ("aligned with reference", f"{r['poses']} poses, scale {r['scale']:.4g}, {_aligned(r)}"),
        ("pairs in time", f"{r['poses']} of {pairs['of']} poses, {apart}"),
        ("absolute error (ATE)", f"{r['ate']:.4g} RMSE, {share}; median {p['median']:.4g}, max {p['max']:.4g}"),
        ("orientation error", f"{r['orientation_rms']:.2f} degrees rms; median {o['median']:.2f}, max {o['max']:.2f}"),
    ]  # fmt: skip
    is_next = step["delta"] == 1 and step["delta_unit"] == "frames"
    over = f"over {step['delta']:g} {step['delta_unit']}, {step['motions']} motions"
    errors = f"{step['position']['rmse']:.4g} and {step['orientation']['rmse']:.3g} degrees RMSE"
    found.append(("relative error (RPE)", f"{errors}, {'from each pose to the next' if is_next else over}"))
    if part:
        means = f"{part['translation_mean']:.3%} of the length, {part['rotation_mean']:.4f} degrees per metre"
        lengths = f"{part['lengths'][0]:g} to {part['lengths'][-1]:g} m"
        found.append((f"error over parts of {lengths}", f"{means} (KITTI's metric)"))
    for nees in filter(None, (r["nees"], r["nees_linear"])):
        low, high = nees["band"]
        inside = f"{nees['inside']:.0%} of the poses inside [{low:.2f}, {high:.2f}] (1 run, 95 %)"
        name = f"NEES, {nees['dof']} dof, {nees['error']} error"
        found.append((name, f"median {nees['median']:.3g}, last {nees['last']:.3g}; {inside}"))
    if r["nees"]:
        e = r["nees"]["at_end"]
        off = f"off by {e['position']:.3g} (sigma {e['position_sigma']:.2g})"
        turned = f"{e['orientation']:.2g} degrees (sigma {e['orientation_sigma']:.2g})"
        found.append(("at the end, from the start", f"{off}, {turned}"))
    return found


def _aligned(r: dict[str, Any]) -> str:
    """What was aligned, in words."""
    names = {"scale": "which alone is aligned", "none": "not aligned"}
    return names.get(r["align"], f"rotation from the {r['rotation_from']}")


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
        "translation_mean": float(shares @ np.nan_to_num(translation)),
        "rotation_mean": float(shares @ np.nan_to_num(turn)),
    }


def lengths_of(path: float) -> tuple[float, ...]:
    """KITTI's eight lengths [m], or the same divided by a round factor, so that a trajectory has parts of all."""
    units = [unit * 10.0**power for power in range(-3, 2) for unit in (1, 2, 5)] + [100.0]
    unit = max((u for u in units if 9 * u <= path), default=0.0)
    return tuple(length * unit / KITTI_LENGTHS[0] for length in KITTI_LENGTHS) if unit else ()
