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
from dataclasses import replace
from typing import Any

import numpy as np
from slambook import rendering

from book.experiments.monocular import OPTIONS, Outcome, frames_of, run
from slamlib.kalman.chi_square import chi2_quantile
from slamlib.manifolds import Array, Mask
from slamlib.slam.data_association.consensus import OUTLIER_REJECTIONS
from slamlib.slam.data_association.front_end import FrontEndInput
from slamlib.vision.active_search import ActiveSearch


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
