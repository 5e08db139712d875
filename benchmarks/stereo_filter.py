"""The stereo filter on films: errors, consistency, and where its time goes; for benchmarks/stereo.py."""

import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from slambook import rendering
from slambook.rendering import stereo_frame, stereo_rig
from slambook.stereo_films import stereo_film

from book.experiments.stereo_room import advance, moved_by
from slamlib.evaluation.consistency import nees
from slamlib.geometry.pose import Pose
from slamlib.kalman.chi_square import chi2_quantile
from slamlib.manifolds import Array
from slamlib.records.inputs import Frame
from slamlib.rigs.setup import Rig
from slamlib.slam import Options, Slam
from slamlib.vision.stereo import MOTION_SOURCES, StereoSettings


@dataclass(frozen=True)
class Case:
    """What is run: a name of MOTION_SOURCES, standard deviations of (u, v, d) [px], settings and options."""

    motion_source: str
    std: tuple[float, float, float]
    settings: StereoSettings
    options: Options


@dataclass
class Run:
    """Of one run, by frames after the first: errors (n, 6), NEES (n,), inliers; NIS of all; seconds."""

    errors: Array
    nees: Array
    inliers: float
    nis: float
    landmarks: int
    seconds: float


def filtered(case: Case, rig: Rig, frames: list[tuple[Frame, Array]]) -> Run:
    """The filter through frames with the true poses (7,) beside them, started at the first of these."""
    slam, motion_source = started(case, rig, frames[0][1])
    errors, squares, nis, spent = [], [], list[list[float]](), dict[str, float]()
    for i, (frame, true) in enumerate(frames):
        step(slam, motion_source, frame, frame.dt if i else 0.0, spent)
        errors.append(Pose.minus(true, slam.robots[0].pose))
        squares.append(float(nees(errors[-1], slam.robot.pose_covariance)) if i else np.nan)
        nis.append([prediction.nis for prediction in slam.predictions[0] if prediction.inlier])
    inliers, every = np.mean([len(n) for n in nis]), np.concatenate([np.array(n) for n in nis])
    return Run(np.array(errors)[1:], np.array(squares)[1:], float(inliers), float(every.mean() / 3),
               len(slam.landmarks), sum(spent.values()) / len(frames))  # fmt: skip


def in_the_room(case: Case, path: str, frames: int, seed: int) -> tuple[Run, float]:
    """Through the room of that seed; and the length of the path [m]."""
    rig, film, _ = stereo_film(frames, path, seed, case.std)
    run = filtered(case, rig, [(frame, truth.poses[0]) for frame, truth in film])
    true = np.array([truth.robots[0][:3] for _, truth in film])
    return run, float(np.linalg.norm(np.diff(true, axis=0), axis=1).sum())


def room(case: Case, path: str, frames: int, seeds: int) -> Iterator[str]:
    """A row for each seed (textures and noise differ), and NEES over all of them, by quarters of the path."""
    s, o = case.settings, case.options
    yield (
        f"path {path}, {frames} frames, {case.motion_source}, std {case.std} px, "
        f"interval {s.update_interval}, window {o.window}:"
    )
    yield "seed  path    rms error  end error  turn     NIS/3  inliers   map   ms/frame  NEES/6 by quarters"
    runs = []
    for seed in range(1, seeds + 1):
        r, length = in_the_room(case, path, frames, seed)
        away, quarters = np.linalg.norm(r.errors[:, :3], axis=1), np.array_split(r.nees / 6, 4)
        runs.append(r.nees)
        yield (
            f"{seed:4} {length:5.2f} m {np.sqrt((away**2).mean()) / length:10.2%} {away[-1] / length:10.2%} "
            f"{np.degrees(np.linalg.norm(r.errors[-1, 3:])):6.2f} deg {r.nis:5.2f} {r.inliers:8.0f} "
            f"{r.landmarks:5d} {1e3 * r.seconds:9.0f}  " + " ".join(f"{q.mean():.2f}" for q in quarters)
        )
    yield from consistency(np.mean(runs, axis=0) / 6, seeds)


def consistency(mean: Array, runs: int) -> Iterator[str]:
    """Averages of NEES / 6 over independent runs (steps,) beside the band of one step."""
    low, high = (chi2_quantile(p, 6 * runs) / (6 * runs) for p in (0.025, 0.975))
    shares = [f"{q.mean():.2f} ({np.mean((q > low) & (q < high)):.0%})" for q in np.array_split(mean, 4)]
    first = mean[: len(mean) // 2]
    yield (
        f"NEES/6 over {runs} runs by quarters (share of steps in the band [{low:.2f}, {high:.2f}]): "
        f"{', '.join(shares)}; first half {np.mean((first > low) & (first < high)):.0%}"
    )


def speed(case: Case, frames: int, full: int) -> Iterator[str]:
    """640 x 480 pixels, 150 features: processor's milliseconds by part, when the map has its `full` landmarks."""
    way, lens = rendering.path("sideways"), {"intrinsics": (319.5, 239.5, 520.0, 520.0), "distortion": (0.0,)}
    rig = rendering.rig_along_path(way, baseline=0.12, image=(640.0, 480.0), parameters=lens)
    dt = way.duration / frames
    film = rendering.film(rendering.default_room(), rig, way, frames=frames, dt=dt, rng=np.random.default_rng(1))
    settings = replace(case.settings, cells=(12, 9), per_cell=4, max_in_view=100)
    options = replace(case.options, updates=100, max_new_first=100, max_new=20, capacity=full, pruning="least-reliable")
    slam, motion_source = started(replace(case, settings=settings, options=options), stereo_rig(rig, case.std))
    spent, counts, clock = split(motion_source), [], 0.0
    for frame, _ in film:
        image, is_full = stereo_frame(frame), len(slam.landmarks) == full
        if not is_full:
            spent.clear()
        at = time.perf_counter()
        step(slam, motion_source, image, dt, spent)
        if is_full:
            clock += time.perf_counter() - at
            predictions = slam.predictions[0]
            counts.append(
                (
                    len(motion_source.front_end.extractor.last),
                    len(predictions),
                    sum(prediction.inlier for prediction in predictions),
                )
            )
    if not counts:
        yield f"the map has {len(slam.landmarks)} landmarks only: give more frames"
        return
    n, (features, predictions, inliers) = len(counts), np.mean(counts, axis=0)
    yield (
        f"{case.motion_source}, interval {settings.update_interval}, {n} frames with {full} landmarks: "
        f"{features:.0f} features, "
        f"{predictions:.0f} landmarks predicted, {inliers:.0f} inliers"
    )
    yield from (f"  {what:15} {1e3 * s / n:6.1f} ms" for what, s in spent.items())
    total = sum(spent.values())
    yield f"  {'together':15} {1e3 * total / n:6.1f} ms = {n / total:.1f} frames/s ({n / clock:.1f} by the clock)"


def started(case: Case, rig: Rig, pose: Array | None = None) -> tuple[Slam, Any]:
    """A filter of the rig, and its motion source."""
    sensor = rig.sensors[0]
    motion_source = MOTION_SOURCES[case.motion_source](sensor.calibration, sensor.extrinsics, case.settings)
    return moved_by(motion_source, rig, case.options, pose), motion_source


def step(slam: Slam, motion_source: Any, frame: Frame, dt: float, spent: dict[str, float]) -> None:
    """One pair; adds time not counted elsewhere to the "filter"."""
    timed(advance, "filter", spent)(slam, motion_source, frame, dt)


def split(motion_source: Any) -> dict[str, float]:
    """From now on the parts of the front end add their processor's seconds up here."""
    spent: dict[str, float] = {}
    end = motion_source.front_end
    parts = [(end.extractor, "extract", "features"), (end, "match", "search"), (end, "detect", "new landmarks")]
    for owner, name, what in [*parts, (motion_source, "control", "control")]:
        setattr(owner, name, timed(getattr(owner, name), what, spent))
    return spent


def timed(call: Callable[..., Any], what: str, spent: dict[str, float]) -> Callable[..., Any]:
    """The function, whose processor time is added up, without what is timed inside of it."""

    def inner(*args: Any, **kwargs: Any) -> Any:
        began, before = time.process_time(), sum(spent.values())
        result = call(*args, **kwargs)
        spent[what] = spent.get(what, 0.0) + time.process_time() - began - (sum(spent.values()) - before)
        return result

    return inner
