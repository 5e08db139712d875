"""Cost of outlier rejection: its time relative to the filter's step, nodes of the search tree, and exactness.

The filter runs the preset `points` with a robot that turns ten times as unpredictably, 12 and 20 matches a frame, and a
share of wrong matches inside the ellipses. CPU times of one run with one BLAS thread.
"""

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # read when NumPy loads

import argparse
import time
from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from slamlib.experiments.presets import Preset, preset
from slamlib.manifolds import Array, Mask
from slamlib.slam import Slam
from slamlib.slam.data_association.consensus import OUTLIER_REJECTIONS, OutlierRejection
from slamlib.slam.data_association.front_end import KnownAssociation
from slamlib.slam.data_association.gates import gate
from slamlib.slam.data_association.jcbb import jcbb

TURNS = 10.0  # times the standard deviation of the preset's turns


class Wrong(KnownAssociation):
    """A front end of which a share of the matches is uniform in the ellipse of three standard deviations."""

    def __init__(self, rate: float, rng: np.random.Generator) -> None:
        self.rate, self.rng = rate, rng

    def match(self, inputs: Any, family: str, predictions: list[Any]) -> tuple[Array, Mask]:
        """As KnownAssociation.match, then make a share wrong."""
        measured, found = super().match(inputs, family, predictions)
        measured = measured.copy()
        for i in np.flatnonzero(found & (self.rng.random(len(predictions)) < self.rate)):
            radius, angle = 3 * np.sqrt(self.rng.random()), 2 * np.pi * self.rng.random()
            circle = radius * np.array([np.cos(angle), np.sin(angle)])
            measured[i] = predictions[i].value + np.linalg.cholesky(predictions[i].S) @ circle
        return measured, found


def experiment(name: str, updates: int, frames: int) -> Preset:
    """The preset with a robot that turns more than it should."""
    p = preset("points")
    robot = p.rig.robots[0]
    std = tuple((np.repeat([1, TURNS], 3) * robot.control_std).tolist())
    rig = replace(p.rig, robots=(replace(robot, control_std=std),))
    options = replace(p.options, outlier_rejection=name, updates=updates, max_new_first=updates)
    return replace(p, rig=rig, frames=frames, options=options)


class Timed:
    """Outlier rejection that records its own time [s], without the updates between its groups."""

    def __init__(self, outlier_rejection: OutlierRejection) -> None:
        self.outlier_rejection, self.seconds = outlier_rejection, 0.0

    def __call__(self, *arguments: Any) -> Iterator[Any]:
        """The groups of inliers."""
        groups = self.outlier_rejection(*arguments)
        while True:
            start = time.process_time()
            group = next(groups, None)
            self.seconds += time.process_time() - start
            if group is None:
                return
            yield group


def cost(name: str, updates: int, rate: float, frames: int) -> str:
    """Times of the outlier rejection and of the step, and their ratio."""
    p, own = experiment(name, updates, frames), OUTLIER_REJECTIONS[name]
    slam = Slam(p.rig, options=p.options, front_ends=[Wrong(rate, np.random.default_rng(1))])
    rows, timed = [], Timed(own)
    OUTLIER_REJECTIONS[name] = timed
    try:
        for frame, _ in p.simulate():
            timed.seconds, start = 0.0, time.process_time()
            slam.step(frame)
            if sum(prediction.matched for prediction in slam.predictions[0]) >= 0.8 * updates:
                rows.append((timed.seconds, time.process_time() - start))
    finally:
        OUTLIER_REJECTIONS[name] = own
    ours, step = np.array(rows).T
    ratio = np.median(ours / (step - ours))
    middle, max_nodes = 1e3 * np.quantile(ours, [0.5, 0.9])
    return (
        f"{name:10s} {updates:3d} matches, {rate:4.0%} wrong: {middle:6.3f} ms (90 %: {max_nodes:6.3f}), "
        f"step without it {1e3 * np.median(step - ours):6.3f} ms, ratio {ratio:5.2f}"
    )


def exactness(count: int, wrong: int, draws: int) -> str:
    """How often the capped search finds the set of a far longer one."""
    rng, limit, dof = np.random.default_rng(count + wrong), partial(gate, 0.99), np.full(count, 2)
    same, seconds = [], []
    for _ in range(draws):
        H = 5 * rng.standard_normal((2 * count, 6))
        S = H @ H.T + np.diag(rng.uniform(1, 3, 2 * count))
        z = rng.multivariate_normal(np.zeros(2 * count), S).reshape(count, 2)
        z[:wrong] += 10 * rng.standard_normal((wrong, 2))
        arguments = (z, S.reshape(count, 2, count, 2), dof, limit)
        start = time.process_time()
        found = jcbb(*arguments)
        seconds.append(time.process_time() - start)
        long = jcbb(*arguments, max_nodes=2000)
        same.append(
            (found.sum() == long.sum(), (found == long).all(), jcbb(*arguments, max_nodes=0).sum() == long.sum())
        )
    size, rows, greedy = np.mean(same, axis=0)
    middle, max_nodes = 1e3 * np.quantile(seconds, [0.5, 0.9])
    return (
        f"{count:2d} innovations, {wrong} wrong: as many as by 2000 nodes in {size:.0%}, the same set in {rows:.0%}; "
        f"greedy alone as many in {greedy:.0%}; {middle:.2f} ms (90 %: {max_nodes:.2f})"
    )


def main() -> None:
    """Print the tables."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--frames", type=int, default=100, help="frames of each run (default 100)")
    parser.add_argument("--draws", type=int, default=100, help="draws of each size of the search (default 100)")
    options = parser.parse_args()
    for updates in (12, 20):
        for rate in (0.0, 0.2):
            for name in OUTLIER_REJECTIONS:
                print(cost(name, updates, rate, options.frames), flush=True)
    print()
    for count, wrong in ((10, 2), (12, 3), (20, 4), (20, 6)):
        print(exactness(count, wrong, options.draws), flush=True)


if __name__ == "__main__":
    main()
