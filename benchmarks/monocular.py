"""Monocular SLAM in the rendered room: how well, with wrong matches on purpose, and how quick.

Each case is run with several seeds (noise of the images, choice of the cells). Printed: the error of the path after a
similarity, relative to its length; the scale, which one camera cannot know; the share found of what was searched
for; NIS per degree of freedom of all inliers, and the share of the frames whose sum of NIS over the seeds
lies in its 95 % band; frames per second of the filter (one BLAS thread, without rendering), and where the time goes.
"""

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # read when NumPy loads

import argparse
import cProfile
import pstats
import time
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from slambook import rendering
from slambook.smoothing import Smoother

from slamlib.data.records import Frame
from slamlib.evaluation.alignment import align_trajectory
from slamlib.evaluation.trajectory import Trajectory
from slamlib.kalman.chi_square import chi2_quantile
from slamlib.manifolds import Array, Mask
from slamlib.slam import Options, Slam
from slamlib.slam.data_association.consensus import OUTLIER_REJECTIONS
from slamlib.slam.data_association.front_end import FrontEndInput
from slamlib.vision.active_search import ActiveSearch

DT, STD = 1 / 30, 0.035  # [s] between frames; [px] of a match: what the image's noise and the warp leave
OPTIONS = Options(updates=12, max_new_first=12, max_new=3, min_matched_ratio=0.5, inverse_distance=(0.4, 0.4))


class WithWrongMatches(ActiveSearch):
    """Active search that now and then reports another position in its region, as with a repeated pattern."""

    share, least = 0.2, 4.0  # of the matches; [px] half the side of the smallest region

    def match(self, inputs: FrontEndInput, family: str, predictions: list[Any]) -> tuple[Array, Mask]:
        """As active search, but for a share of the matches."""
        measured, found = super().match(inputs, family, predictions)
        for i in np.flatnonzero(found & (self.rng.random(len(predictions)) < self.share)):
            reach = np.maximum(3 * np.sqrt(np.diag(predictions[i].S)), self.least)
            measured[i] = predictions[i].value + reach * self.rng.uniform(-1, 1, 2)
        return measured, found


@dataclass(frozen=True, eq=False)
class Outcome:
    """One run: relative error and scale of its path, error by all data at once; per frame (n,): searched, matched, NIS
    and its dof; seconds."""

    relative_ate: float
    scale: float
    at_once: float
    searched: Array
    matched: Mask
    nis: Array
    dof: Array
    seconds: dict[str, float]


def frames_of(texture: str, path: str, frames: int, seed: int) -> tuple[Any, list[Frame], Array]:
    """The rig of a film, its frames, and the true poses (n, 7), which are the camera's but for fixed extrinsics."""
    way = rendering.path(path)
    rig = rendering.rig_along_path(way, std=(STD,))
    film = rendering.film(
        rendering.default_room(texture), rig, way, frames=frames, dt=DT, rng=np.random.default_rng(seed)
    )
    steps = list(film)
    return rig, [frame for frame, _ in steps], np.array([truth.robots[0][:7] for _, truth in steps])


def run(
    rig: Any,
    frames: list[Frame],
    truth: Array,
    seed: int,
    options: Options,
    kind: type[ActiveSearch],
    at_once: bool = False,
) -> Outcome:
    """One run of the filter over frames that are there; and, at_once, by all its data, too."""
    front_end = kind(rig.sensors[0].calibration, np.random.default_rng([seed, 1]))
    slam, rows, poses = Slam(rig, options, front_ends=[front_end]), [], []
    smoother = Smoother(slam) if at_once else None
    began = time.perf_counter()
    for frame in frames:
        slam.step(frame)
        if smoother is not None:
            smoother.record(frame)
        predictions = slam.predictions[0]
        inliers = [prediction for prediction in predictions if prediction.inlier]
        counts = (
            sum(prediction.chosen for prediction in predictions),
            sum(prediction.matched for prediction in predictions),
        )
        rows.append([*counts, sum(prediction.nis for prediction in inliers), 2 * len(inliers)])
        poses.append(slam.robots[0].pose.copy())
    spent = time.perf_counter() - began
    times = DT * np.arange(len(frames), dtype=float)
    reference = Trajectory(times, truth)
    found = align_trajectory(Trajectory(times, np.array(poses)), reference)
    best = np.nan
    if smoother is not None:
        best = align_trajectory(Trajectory(times, smoother.solve().poses[:, 0]), reference).relative_ate
    searched, matched, nis, dof = np.array(rows, dtype=float).T
    seconds = {"all": spent, **front_end.seconds}
    return Outcome(found.relative_ate, found.similarity.scale, best, searched, matched, nis, dof, seconds)


def inside(outcomes: list[Outcome]) -> float:
    """Share of the frames whose NIS, summed over the runs, lies in the 95 % band of its degrees of freedom."""
    nis, dof = (sum(getattr(o, name) for o in outcomes) for name in ("nis", "dof"))
    seen = [(n, int(d)) for n, d in zip(nis, dof, strict=True) if d]
    return float(np.mean([chi2_quantile(0.025, d) <= n <= chi2_quantile(0.975, d) for n, d in seen]))


def report(name: str, outcomes: list[Outcome]) -> None:
    """One line of the printed table."""
    errors = [100 * o.relative_ate for o in outcomes]
    scales = " ".join(f"{o.scale:.2f}" for o in outcomes)
    matched = sum(o.matched.sum() for o in outcomes) / sum(o.searched.sum() for o in outcomes)
    nis = sum(o.nis.sum() for o in outcomes) / sum(o.dof.sum() for o in outcomes)
    count = sum(len(o.nis) for o in outcomes)
    spent = {part: sum(o.seconds[part] for o in outcomes) for part in ("all", "search", "detection")}
    print(
        f"{name:36s} error {np.mean(errors):.2f} % (worst {max(errors):.2f} %)  scale {scales}  matched {matched:.1%}  "
        f"NIS/dof {nis:.2f}, {inside(outcomes):.0%} of the frames inside  {count / spent['all']:.0f} fps "
        f"(search {spent['search'] / spent['all']:.0%}, detection {spent['detection'] / spent['all']:.0%})",
        flush=True,
    )


def profile(texture: str, frames: int) -> None:
    """Where the time of one run goes."""
    rig, seen, truth = frames_of(texture, "sideways", frames, 1)
    profiler = cProfile.Profile()
    profiler.runcall(run, rig, seen, truth, 1, OPTIONS, ActiveSearch)
    pstats.Stats(profiler).sort_stats("tottime").print_stats(25)


def main() -> None:
    """Print the figures."""
    parser = argparse.ArgumentParser(description="Monocular SLAM in the rendered room.")
    parser.add_argument("--frames", type=int, default=300)
    parser.add_argument("--seeds", type=int, default=5)
    parser.add_argument("--texture", default="drawn", choices=("drawn", "photographs"))
    parser.add_argument("--path", default="sideways", choices=sorted(rendering.PATHS))
    parser.add_argument("--wrong", action="store_true", help="also with a fifth of all matches wrong")
    parser.add_argument("--profile", action="store_true", help="one run, by function")
    given = parser.parse_args()
    if given.profile:
        profile(given.texture, given.frames)
        return
    films = {s: frames_of(given.texture, given.path, given.frames, s) for s in range(1, given.seeds + 1)}
    name = f"{given.texture}, {given.path}"
    report(name, [run(*film, s, OPTIONS, ActiveSearch) for s, film in films.items()])
    for outlier_rejection in OUTLIER_REJECTIONS if given.wrong else ():
        chosen = replace(OPTIONS, outlier_rejection=outlier_rejection)
        report(
            f"  a fifth wrong, {outlier_rejection}", [run(*f, s, chosen, WithWrongMatches) for s, f in films.items()]
        )


if __name__ == "__main__":
    main()
